-- The core's pipeline over a set of axes, and each table of what it computed.

CREATE OR REPLACE FUNCTION streetgen._streets(srid integer, settings jsonb, axes streetgen.street_axis[],
    transitions streetgen.street_transition[],
    limits streetgen.street_limit[], corners streetgen.street_corner[], lanes streetgen.street_lane[],
        restrictions streetgen.street_restriction[],
    former_edges streetgen.former_edge[], former_nodes streetgen.former_node[], may_spread boolean DEFAULT true,
    subjects text[] DEFAULT '{lane,interconnection}', neighbours streetgen.street_neighbour[] DEFAULT NULL,
    controls streetgen.street_control[] DEFAULT NULL, overpasses streetgen.street_overpass[] DEFAULT NULL,
    bends streetgen.street_bend[] DEFAULT NULL, circulations streetgen.street_circulation[] DEFAULT NULL,
    ramp_axes streetgen.street_ramp_axis[] DEFAULT NULL, ramps streetgen.street_ramp[] DEFAULT NULL,
    junctions streetgen.street_junction[] DEFAULT NULL, changes streetgen.street_lane_change[] DEFAULT NULL,
    leaving streetgen.street_leaving[] DEFAULT NULL)
    RETURNS bigint
    LANGUAGE c VOLATILE PARALLEL UNSAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_streets';
COMMENT ON FUNCTION streetgen._streets(integer, jsonb, streetgen.street_axis[], streetgen.street_transition[],
    streetgen.street_limit[], streetgen.street_corner[],
    streetgen.street_lane[], streetgen.street_restriction[], streetgen.former_edge[], streetgen.former_node[], boolean,
        text[], streetgen.street_neighbour[], streetgen.street_control[], streetgen.street_overpass[],
        streetgen.street_bend[], streetgen.street_circulation[], streetgen.street_ramp_axis[],
        streetgen.street_ramp[], streetgen.street_junction[], streetgen.street_lane_change[],
        streetgen.street_leaving[])
    IS 'Computes the streets of a set of axes, as far as those that changed can change them, and keeps them until '
        'the statement ends: gives their number, by which streetgen._computed_node and the like read them. settings: '
        'names and values as words, of all in streetgen._default_setting() that the core reads. may_spread: also where '
        'the change goes on beyond axes that are not outer ones; else that is SG001, with axes for which a run is '
        'due too as its hint, an array. subjects: what is computed besides network and surfaces: lane, '
        'interconnection, kerb, overpass; words of SQL alone are passed over. neighbours: for kerbs, all surfaces '
        'near that '
        'stay; NULL: unknown. ramp_axes: those that may be part of a ramp; without any there are no ramps. '
        'junctions, changes, leaving: what is known of paint. No axes '
        '(NULL) or no subjects (NULL): NULL; any other '
        'list may be NULL. A value of a row that is missing: 22004; a setting that is missing, a value out of range '
        'or unknown, a geometry that is none: 22023.';

CREATE OR REPLACE FUNCTION streetgen._ids_put(list internal, number integer, id bigint) RETURNS internal
    LANGUAGE c IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_ids_put';
COMMENT ON FUNCTION streetgen._ids_put(internal, integer, bigint) IS 'Step of streetgen._ids.';

CREATE OR REPLACE FUNCTION streetgen._ids_list(list internal) RETURNS bigint[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_ids_list';
COMMENT ON FUNCTION streetgen._ids_list(internal) IS 'End of streetgen._ids.';

CREATE OR REPLACE AGGREGATE streetgen._ids(number integer, id bigint) (SFUNC = streetgen._ids_put, STYPE = internal,
    FINALFUNC = streetgen._ids_list, PARALLEL = SAFE);
COMMENT ON AGGREGATE streetgen._ids(integer, bigint) IS
    'The ids of rows, each at its number from 1 on, 0 where no row has the number; of no rows NULL. A number below 1: '
    '22023.';

CREATE OR REPLACE FUNCTION streetgen._computed_node(streets bigint)
    RETURNS TABLE(number integer, affected boolean, kerbs_affected boolean, geom geometry, anchor_axis bigint[],
        anchor_abscissa float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_node';
COMMENT ON FUNCTION streetgen._computed_node(bigint) IS
    'The nodes of streets computed in this statement. number: by which other things computed name it, from 1 on, as '
    'in all these; affected: its intersection and lanes come out; kerbs_affected: the kerbs of its '
    'intersection do; axes that have a vertex there and its abscissa on '
    'each, m. Streets that are not kept: 55000, as in all these. Limits, surfaces, corners, lanes and what is painted '
    'are given once, so that what they took is free for their tables.';

CREATE OR REPLACE FUNCTION streetgen._computed_edge(streets bigint)
    RETURNS TABLE(number integer, affected boolean, lanes_affected boolean, kerbs_affected boolean,
        spreads_to boolean, axis_id bigint, from_node integer, to_node integer, level integer,
        start_abscissa float8, end_abscissa float8, geom geometry, curve geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_edge';
COMMENT ON FUNCTION streetgen._computed_edge(bigint) IS
    'The edges of streets computed in this statement: affected: its section comes out; lanes_affected: its lanes do; '
    'kerbs_affected: the kerbs of its section do; spreads_to: the change goes on beyond it, so that a run for its '
    'axis is due; abscissas along the axis, m; curve: the arc road of which geom is chords, NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._computed_section_limit(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, axis_id bigint, which text, wanted_abscissa float8, abscissa float8,
        geom geometry, border_line geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_section_limit';
COMMENT ON FUNCTION streetgen._computed_section_limit(bigint, bigint[]) IS
    'The section limits of streets computed in this statement; abscissas along the edge, m. edges: the ids of the '
    'edges by their numbers, 0 where one has none, as nodes and lanes below; what belongs to one without is left out. '
    'A list with a NULL: 22023.';

CREATE OR REPLACE FUNCTION streetgen._computed_section(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, level integer, surface geometry, method text, contested_area float8,
        borders float8[])
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_section';
COMMENT ON FUNCTION streetgen._computed_section(bigint, bigint[]) IS
    'The sections of streets computed in this statement: those of affected edges; borders in abscissas along the edge.';

CREATE OR REPLACE FUNCTION streetgen._computed_corner(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, node_id bigint, edge_a bigint, end_a text, edge_b bigint, end_b text,
        centre geometry, radius_wanted float8, radius float8, arc geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_corner';
COMMENT ON FUNCTION streetgen._computed_corner(bigint, bigint[], bigint[]) IS
    'The corners of streets computed in this statement; centre and arc are NULL where there is no arc; radii in m.';

CREATE OR REPLACE FUNCTION streetgen._computed_intersection(streets bigint, nodes bigint[])
    RETURNS TABLE(number integer, node_id bigint, level integer, surface geometry, method text, contested_area float8)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_intersection';
COMMENT ON FUNCTION streetgen._computed_intersection(bigint, bigint[]) IS
    'The intersections of streets computed in this statement: those of affected nodes where edges meet.';

CREATE OR REPLACE FUNCTION streetgen._computed_lane(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, axis_id bigint, ordinality integer, lane_position integer, side text,
        along_axis boolean, both_ways boolean, kind text,
        width float8, axis_offset float8, turn text, geom geometry, surface geometry, method text,
        start_abscissa float8, end_abscissa float8)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_lane';
COMMENT ON FUNCTION streetgen._computed_lane(bigint, bigint[]) IS 'The lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._computed_lane_separator(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, lane_position integer, kind text, dashed boolean,
        leftwards boolean, rightwards boolean, axis_offset float8, geom geometry, surface geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_lane_separator';
COMMENT ON FUNCTION streetgen._computed_lane_separator(bigint, bigint[]) IS
    'The lines between the lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._computed_marking(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, lane_position integer, along_axis boolean, node_id bigint, kind text,
        geom geometry, surface geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_marking';
COMMENT ON FUNCTION streetgen._computed_marking(bigint, bigint[], bigint[]) IS
    'What is painted across and on the lanes of streets computed in this statement.';

CREATE OR REPLACE FUNCTION streetgen._computed_interconnection(streets bigint, nodes bigint[], lanes bigint[])
    RETURNS TABLE(number integer, node_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
        turn text, angle float8,
        plausible boolean, reason text, control geometry, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_interconnection';
COMMENT ON FUNCTION streetgen._computed_interconnection(bigint, bigint[], bigint[]) IS
    'The pairs of lanes of streets computed in this statement, and the paths between them.';

CREATE OR REPLACE FUNCTION streetgen._computed_kerb(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, node_id bigint, level integer, side text, part integer, geom geometry,
        curve geometry, surface geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_kerb';
COMMENT ON FUNCTION streetgen._computed_kerb(bigint, bigint[], bigint[]) IS
    'The kerbs of streets computed in this statement: of sections, where node_id is NULL, and of intersections.';

CREATE OR REPLACE FUNCTION streetgen._computed_overpass(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_above bigint, abscissa_above float8, edge_below bigint, abscissa_below float8,
        geom geometry, clearance float8, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_overpass';
COMMENT ON FUNCTION streetgen._computed_overpass(bigint, bigint[]) IS
    'The overpasses of streets computed in this statement; abscissas along the edge, m.';

CREATE OR REPLACE FUNCTION streetgen._computed_ramp(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, node_id bigint, edge_id bigint, edge_before bigint, edge_after bigint, kind text,
        side text, lanes_before integer, lanes_ramp integer, lanes_after integer, lanes_missing integer,
        lanes_merging integer, length float8, taper float8, tangent float8, auxiliary boolean, cut boolean,
        short_link boolean, geom geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_computed_ramp';
COMMENT ON FUNCTION streetgen._computed_ramp(bigint, bigint[], bigint[]) IS
    'The ramps of streets computed in this statement; columns as of table ramp.';

CREATE OR REPLACE FUNCTION streetgen._computed_report(streets bigint)
    RETURNS TABLE(number integer, issue text, axis_a bigint, axis_b bigint, measure float8, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_report';
COMMENT ON FUNCTION streetgen._computed_report(bigint) IS
    'What the network step noticed while it computed streets in this statement.';
