-- The one statement, what it reads: axes with what is decided by hand, and what changed axes met before the change.

CREATE OR REPLACE FUNCTION streetgen._upsert_input(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._filled($part$
setting AS MATERIALIZED (SELECT jsonb_object_agg(name, value) AS v FROM {model}.setting),
used AS MATERIALIZED (SELECT * FROM {model}.axis_used WHERE {whole} OR axis_id = ANY ($2)),
-- What the changed axes met and what lay beside their ground before the change.
former_node AS MATERIALIZED (
    SELECT DISTINCT node_id FROM {model}.edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id) WHERE NOT {first} AND e.axis_id = ANY ($3)),
followed AS MATERIALIZED (
    SELECT c.node_id FROM {model}.edge e, LATERAL (
        SELECT c.node_id FROM {model}.corner c WHERE c.edge_a = e.edge_id AND c.method = 'followed'
        UNION ALL SELECT c.node_id FROM {model}.corner c WHERE c.edge_b = e.edge_id AND c.method = 'followed' OFFSET 0) c
    WHERE NOT {whole} AND NOT {first} AND e.axis_id = ANY ($1)),
-- An edge that they cut, or meet no longer, gives up ground at its far node too: to those that had lost some.
line AS MATERIALIZED (
    SELECT geom FROM used WHERE NOT {first} AND axis_id = ANY ($3)
    UNION ALL SELECT geom FROM {model}.edge e WHERE NOT {first} AND e.axis_id = ANY ($3)),
-- OFFSET 0, here and below: each is looked up by its index, and not joined.
met_edge AS MATERIALIZED (
    SELECT DISTINCT e.edge_id, e.from_node, e.to_node FROM line l, LATERAL (
        SELECT * FROM {model}.edge e WHERE ST_DWithin(e.geom, l.geom, (SELECT 3 * (v ->> 'tolerance')::float8 FROM setting)) OFFSET 0) e),
ground AS MATERIALIZED (
    SELECT s.surface, e.own FROM (
        SELECT edge_id, true AS own FROM {model}.edge e WHERE NOT {first} AND e.axis_id = ANY ($3) UNION ALL SELECT edge_id, false FROM met_edge) e,
        LATERAL (SELECT surface FROM {model}.section s WHERE s.edge_id = e.edge_id OFFSET 0) s
    UNION ALL SELECT i.surface, n.own FROM (
        SELECT node_id, bool_or(own) AS own FROM (
            SELECT node_id, true AS own FROM former_node UNION ALL SELECT from_node, false FROM met_edge
            UNION ALL SELECT to_node, false FROM met_edge UNION ALL SELECT node_id, false FROM followed) n
        GROUP BY node_id) n,
        LATERAL (SELECT surface FROM {model}.intersection i WHERE i.node_id = n.node_id OFFSET 0) i),
beside AS MATERIALIZED (
    SELECT DISTINCT e.axis_id FROM (
        SELECT DISTINCT s.edge_id FROM ground g, LATERAL (
            SELECT edge_id FROM {model}.section s WHERE ST_DWithin(s.surface, g.surface, 1) AND (g.own OR s.contested_area > 0) OFFSET 0) s) s,
        LATERAL (SELECT axis_id FROM {model}.edge e WHERE e.edge_id = s.edge_id OFFSET 0) e),
former_place AS (
    SELECT n.geom, bool_or(p.met) AS met FROM (
        SELECT node_id, true AS met FROM followed
        UNION ALL SELECT i.node_id, false FROM ground g, LATERAL (
            SELECT node_id FROM {model}.intersection i WHERE ST_DWithin(i.surface, g.surface, 1) AND (g.own OR i.contested_area > 0) OFFSET 0) i) p,
        LATERAL (SELECT geom FROM {model}.node n WHERE n.node_id = p.node_id OFFSET 0) n
    GROUP BY p.node_id, n.geom),
former_edge AS (
    SELECT e.axis_id, ST_Force2D(e.geom)::bytea AS geom, s.wanted_abscissa AS wanted_start, s.abscissa AS start, t.wanted_abscissa AS wanted_end, t.abscissa AS "end"
    FROM {model}.edge e,
        LATERAL (SELECT * FROM {model}.section_limit s WHERE (s.edge_id, s.which) = (e.edge_id, 'start') OFFSET 0) s,
        LATERAL (SELECT * FROM {model}.section_limit t WHERE (t.edge_id, t.which) = (e.edge_id, 'end') OFFSET 0) t
    WHERE NOT {whole} AND e.axis_id = ANY ($1)),
computed AS MATERIALIZED (
    SELECT streetgen._streets({srid},
        settings => (
            -- A path by a function of the user is drawn below.
            SELECT v || jsonb_build_object('trajectory', CASE v ->> 'trajectory' WHEN 'arcs' THEN 'arcs' ELSE 'bezier' END) FROM setting),
        axes => (
            SELECT array_agg(ROW (
                axis_id, ST_Force2D(geom)::bytea, level, width, width_end, radius, importance, speed,
                lanes_forward, lanes_backward, kind_forward, kind_backward, lane_width_forward, lane_width_backward, turn_forward, turn_backward,
                {whole} OR axis_id = ANY ($3), NOT {whole} AND axis_id IN (SELECT axis_id FROM beside), NOT ({whole} OR axis_id = ANY ($1))
                )::streetgen.street_axis ORDER BY axis_id)
            FROM used),
        transitions => (
            SELECT array_agg(ROW (axis_id, which, coalesce(kind, v ->> 'transition_kind'),
                coalesce(length, (v ->> 'transition_length')::float8))::streetgen.street_transition)
            FROM (SELECT DISTINCT ON (axis_id, which) * FROM {model}.transition_override WHERE {whole} OR axis_id = ANY ($2)
                  ORDER BY axis_id, which, transition_override_id DESC) o, setting),
        limits => (
            SELECT array_agg(ROW (axis_id, abscissa, which)::streetgen.street_limit ORDER BY section_limit_override_id)
            FROM {model}.section_limit_override WHERE {whole} OR axis_id = ANY ($2)),
        corners => (
            SELECT array_agg(ROW (axis_a, axis_b, ST_X(geom), ST_Y(geom), radius)::streetgen.street_corner ORDER BY corner_override_id)
            FROM {model}.corner_override WHERE {whole} OR axis_a = ANY ($2)),
        lanes => (
            SELECT array_agg(ROW (axis_id, abscissa, ordinality, along_axis, width, line::bytea)::streetgen.street_lane ORDER BY lane_override_id)
            FROM {model}.lane_override WHERE {whole} OR axis_id = ANY ($2)),
        restrictions => (
            SELECT array_agg(ROW (from_axis, to_axis, ST_X(geom), ST_Y(geom), kind, turn)::streetgen.street_restriction ORDER BY turn_restriction_id)
            FROM {model}.turn_restriction WHERE {whole} OR from_axis = ANY ($2)),
        former_edges => (SELECT array_agg(ROW (axis_id, geom, wanted_start, start, wanted_end, "end")::streetgen.former_edge) FROM former_edge),
        former_places => (SELECT array_agg(ROW (ST_X(geom), ST_Y(geom), met)::streetgen.former_place) FROM former_place)) AS streets)$part$, places) $$;
COMMENT ON FUNCTION streetgen._upsert_input(jsonb) IS 'Part of the one statement: settings, the axes used, and the streets computed from them (computed.streets).';
