-- Paths across junctions of several nodes.

CREATE OR REPLACE FUNCTION streetgen._junction_movements(grounds streetgen.junction_ground[],
    legs streetgen.junction_leg[], lanes streetgen.junction_lane[], inner_edges streetgen.junction_inner_edge[],
    steps streetgen.junction_step[], restrictions streetgen.junction_restriction[],
    way_restrictions streetgen.junction_way_restriction[], srid integer, u_turn boolean, arcs boolean,
    tolerance float8, node_tolerance float8, most integer, drives_left boolean)
    RETURNS TABLE(junction_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean, turn text,
        angle float8, plausible boolean, reason text, traffic text, interconnections bigint[], geom bytea)
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000 ROWS 500 AS 'MODULE_PATHNAME', 'streetgen_junction_movements';
COMMENT ON FUNCTION streetgen._junction_movements(streetgen.junction_ground[], streetgen.junction_leg[],
    streetgen.junction_lane[], streetgen.junction_inner_edge[], streetgen.junction_step[],
    streetgen.junction_restriction[], streetgen.junction_way_restriction[], integer, boolean, boolean, float8, float8,
    integer, boolean)
    IS 'The paths across junctions of several nodes, lane to lane, with the chain of paths at single nodes that lead '
        'the same way. u_turn: also back by the edge that one came by; arcs: by rule arcs, else bezier; tolerances in '
        'm; most: pairs of lanes above which a junction gets none; drives_left: one drives on the left. geom: '
        'LINESTRING, EWKB. Bad geometry, a number out of its range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._via_edges(model name, axes bigint[], places geometry)
    RETURNS TABLE(i bigint, edge_id bigint)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 3 SET search_path = pg_catalog, public
    AS $$
    SELECT u.i, streetgen._edge_at(model, u.axis_id, ST_GeometryN(places, u.i::integer))
    FROM unnest(axes) WITH ORDINALITY u(axis_id, i) $$;
COMMENT ON FUNCTION streetgen._via_edges(name, bigint[], geometry) IS
    'The edges by which a turn restriction leads, by its via_axes and via_geom: NULL where an axis has none.';

CREATE OR REPLACE FUNCTION streetgen._make_found_movements(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _found_movements(junctions bigint[])
        RETURNS TABLE(junction_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
            turn text, angle float8, plausible boolean, reason text, traffic text, interconnections bigint[],
            geom bytea)
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = current_schema());
        rings constant bigint[] := streetgen._edges_on_rings(current_schema(),
            ARRAY(SELECT e.edge_id FROM junction_node j JOIN edge e ON j.node_id IN (e.from_node, e.to_node)
                WHERE j.junction_id = ANY (junctions)));
        rules record;
    BEGIN
        SELECT max(value) FILTER (WHERE name = 'u_turn') = 'true' AS u_turn,
            max(value) FILTER (WHERE name = 'trajectory') = 'arcs' AS arcs,
            (max(value) FILTER (WHERE name = 'trajectory_tolerance'))::float8 AS chords,
            (max(value) FILTER (WHERE name = 'tolerance'))::float8 AS tolerance,
            (max(value) FILTER (WHERE name = 'interconnections_maximal'))::float8::integer AS most,
            max(value) FILTER (WHERE name = 'driving_side') = 'left' AS drives_left INTO rules
            FROM setting;
        RETURN QUERY
        WITH member AS MATERIALIZED (
            SELECT j.junction_id, j.node_id FROM junction_node j WHERE j.junction_id = ANY (junctions)),
        ending AS MATERIALIZED (
            SELECT m.junction_id, m.node_id, e.*, at_start, l.border_line
            FROM member m CROSS JOIN (VALUES (true, 'start'), (false, 'end')) w(at_start, which)
                JOIN LATERAL (SELECT e.* FROM edge e WHERE at_start AND e.from_node = m.node_id
                    UNION ALL SELECT e.* FROM edge e WHERE NOT at_start AND e.to_node = m.node_id) e ON true
                JOIN section_limit l ON (l.edge_id, l.which) = (e.edge_id, w.which)),
        leg AS MATERIALIZED (
            SELECT * FROM ending e WHERE NOT EXISTS (SELECT FROM junction_edge j WHERE j.edge_id = e.edge_id)),
        way AS MATERIALIZED (
            SELECT g.junction_id, g.edge_id, g.at_start, l.lane_id, l.along_axis AS along,
                CASE l.kind WHEN 'merging' THEN 'general' ELSE l.kind END AS kind, l.turn, l.lane_position,
                v.along AS driven_along, v.along <> g.at_start AS comes_in, l.geom
            FROM leg g JOIN lane l USING (edge_id) JOIN (VALUES (true), (false)) v(along)
                ON l.both_ways OR l.along_axis = v.along
            -- A merging lane comes to one end of its edge only.
            WHERE l.kind NOT IN ('parking', 'closed')
                AND CASE WHEN g.at_start THEN l.start_abscissa ELSE l.end_abscissa END IS NULL)
        SELECT * FROM streetgen._junction_movements(
            ARRAY(SELECT ROW (j.junction_id, j.surface::bytea)::streetgen.junction_ground FROM junction j
                WHERE j.junction_id = ANY (junctions) ORDER BY j.junction_id),
            ARRAY(SELECT ROW (junction_id, edge_id, at_start, axis_id, node_id, e.importance, e.speed,
                    e.edge_id IN (SELECT unnest(rings)),
                border_line::bytea)::streetgen.junction_leg FROM leg e
                ORDER BY junction_id, axis_id, start_abscissa, at_start),
            -- From left to right in their driving direction; positions run from the left of the axis.
            ARRAY(SELECT ROW (junction_id, edge_id, at_start, lane_id, comes_in, driven_along, kind, turn,
                    CASE WHEN driven_along THEN geom ELSE ST_Reverse(geom) END::bytea)::streetgen.junction_lane
                FROM way ORDER BY junction_id, edge_id, at_start, comes_in,
                    CASE WHEN driven_along THEN lane_position ELSE -lane_position END),
            ARRAY(SELECT ROW (j.junction_id, e.edge_id, e.axis_id, e.from_node, e.to_node,
                    o.kinds_along, o.kinds_against, coalesce(o.along, 0), coalesce(o.against, 0),
                    ST_Force2D(e.geom)::bytea)::streetgen.junction_inner_edge
                FROM junction_edge j JOIN edge e USING (edge_id) LEFT JOIN LATERAL (
                    SELECT avg(l.axis_offset) FILTER (WHERE l.along_axis) AS along,
                        avg(l.axis_offset) FILTER (WHERE NOT l.along_axis OR l.both_ways) AS against,
                        string_agg(DISTINCT l.kind, '|') FILTER (WHERE l.along_axis) AS kinds_along,
                        string_agg(DISTINCT l.kind, '|') FILTER (WHERE NOT l.along_axis OR l.both_ways)
                            AS kinds_against
                    FROM lane l WHERE l.edge_id = e.edge_id AND l.kind NOT IN ('parking', 'closed', 'merging')) o
                    ON true
                WHERE j.junction_id = ANY (junctions) ORDER BY j.junction_id, e.axis_id, e.start_abscissa),
            -- By place: of chains as short as each other the first holds, whatever their keys.
            ARRAY(SELECT ROW (m.junction_id, i.interconnection_id, i.lane_in, i.lane_out, i.along_in, i.along_out,
                    i.plausible)::streetgen.junction_step
                FROM member m JOIN interconnection i USING (node_id)
                    JOIN lane l ON l.lane_id = i.lane_in JOIN edge a ON a.edge_id = l.edge_id
                    JOIN lane r ON r.lane_id = i.lane_out JOIN edge b ON b.edge_id = r.edge_id
                ORDER BY m.junction_id, a.axis_id, a.start_abscissa, l.ordinality, i.along_in, b.axis_id,
                    b.start_abscissa, r.ordinality, i.along_out),
            ARRAY(SELECT ROW (m.junction_id, r.from_axis, r.to_axis, ST_X(n.geom), ST_Y(n.geom), r.kind, r.turn,
                    r.except_kinds)::streetgen.junction_restriction
                FROM member m JOIN node n USING (node_id)
                    JOIN turn_restriction r ON ST_DWithin(r.geom, n.geom, 3 * rules.tolerance)
                WHERE r.via_axes IS NULL ORDER BY m.junction_id, r.turn_restriction_id),
            -- Restrictions via axes hold here where the edges of these axes all lie in one junction.
            ARRAY(SELECT ROW (junction_id, turn_restriction_id, from_axis, to_axis, edge_id, kind,
                    except_kinds)::streetgen.junction_way_restriction
                FROM (SELECT DISTINCT m.junction_id, r.turn_restriction_id, r.from_axis, r.to_axis, v.edge_id, r.kind,
                        r.except_kinds, v.i, bool_and(coalesce(j.junction_id = m.junction_id, false))
                        OVER (PARTITION BY m.junction_id, r.turn_restriction_id) AS inside
                    FROM member m JOIN node n USING (node_id)
                        JOIN turn_restriction r ON ST_DWithin(r.geom, n.geom, 3 * rules.tolerance)
                        CROSS JOIN LATERAL streetgen._via_edges(current_schema(), r.via_axes, r.via_geom) v
                        LEFT JOIN junction_edge j USING (edge_id)
                    WHERE r.via_axes IS NOT NULL) w
                WHERE inside ORDER BY junction_id, turn_restriction_id, i),
            srid, rules.u_turn, rules.arcs, rules.chords, rules.tolerance, rules.most, rules.drives_left);
    END $body$;
    PERFORM streetgen._own_function(model, '_found_movements(bigint[])', 'The paths across junctions of several nodes');
END $$;
COMMENT ON FUNCTION streetgen._make_found_movements(name) IS
    'Makes the function of a model that computes the paths across junctions.';
