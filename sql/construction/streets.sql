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
    leaving streetgen.street_leaving[] DEFAULT NULL, marked_before streetgen.street_marked[] DEFAULT NULL)
    RETURNS bigint
    LANGUAGE c VOLATILE PARALLEL UNSAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_streets';
COMMENT ON FUNCTION streetgen._streets(integer, jsonb, streetgen.street_axis[], streetgen.street_transition[],
    streetgen.street_limit[], streetgen.street_corner[],
    streetgen.street_lane[], streetgen.street_restriction[], streetgen.former_edge[], streetgen.former_node[], boolean,
        text[], streetgen.street_neighbour[], streetgen.street_control[], streetgen.street_overpass[],
        streetgen.street_bend[], streetgen.street_circulation[], streetgen.street_ramp_axis[],
        streetgen.street_ramp[], streetgen.street_junction[], streetgen.street_lane_change[],
        streetgen.street_leaving[], streetgen.street_marked[])
    IS 'Computes the streets of a set of axes, as far as those that changed can change them, and keeps them until '
        'the statement ends: gives their number, by which streetgen._computed_node and the like read them. settings: '
        'names and values as words, of all in streetgen._default_setting() that the core reads. may_spread: also where '
        'the change goes on beyond axes that are not outer ones; else that is SG001, with axes for which a run is '
        'due too as its hint, an array. subjects: what is computed besides network and surfaces; words of SQL alone '
        'are passed over. neighbours: for kerbs, all surfaces near that stay; NULL: unknown. ramp_axes: those that may '
        'be part of a ramp; without any there are no ramps. junctions, changes, leaving: what is known of paint. '
        'marked_before: axes on whose lanes lay turn marks of others. No '
        'axes (NULL) or no subjects (NULL): NULL; any other list may be NULL. A value of a row that is missing: '
        '22004; a setting that is missing, a value out of range or unknown, a geometry that is none: 22023.';

CREATE OR REPLACE FUNCTION streetgen._network(srid integer, settings jsonb, axes streetgen.street_axis[])
    RETURNS bigint
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 100000 AS 'MODULE_PATHNAME', 'streetgen_network';
COMMENT ON FUNCTION streetgen._network(integer, jsonb, streetgen.street_axis[]) IS
    'Computes the network of a set of axes, and keeps it as streetgen._streets does its streets: of those only '
    'streetgen._computed_report, _computed_node and _computed_edge have rows. Errors are those of _streets.';

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
