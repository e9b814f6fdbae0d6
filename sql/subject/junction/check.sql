-- Rules of check_model for junctions.

CREATE OR REPLACE FUNCTION streetgen._silent_control_points(model name)
    RETURNS TABLE(control_point_id bigint, kind text, at_end boolean, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH spoken AS MATERIALIZED (
        SELECT m.control FROM _junction_members(NULL) g, unnest(g.members) m WHERE m.control IS NOT NULL),
    -- In the order of the list that speaks of them.
    placed AS MATERIALIZED (
        SELECT p.control_point_id, row_number() OVER (ORDER BY p.control_point_id) AS place FROM control_point p
        WHERE p.axis_id IN (SELECT e.axis_id FROM edge e))
    SELECT p.control_point_id, p.kind, EXISTS (
            SELECT FROM edge e CROSS JOIN LATERAL (
                VALUES (e.from_node, e.start_abscissa), (e.to_node, e.end_abscissa)) v(node_id, place)
            WHERE e.axis_id = p.axis_id AND abs(p.abscissa - v.place) < 5 AND NOT EXISTS (
                SELECT FROM edge o WHERE v.node_id IN (o.from_node, o.to_node) AND o.edge_id <> e.edge_id)), p.geom
    FROM control_point p LEFT JOIN placed USING (control_point_id)
    WHERE p.kind IN ('signals', 'stop', 'yield') AND p.axis_id IN (SELECT a.axis_id FROM axis a)
        AND (placed.place IS NULL OR placed.place NOT IN (TABLE spoken));
END $$;
COMMENT ON FUNCTION streetgen._silent_control_points(name) IS
    'The signals, stop and yield signs on axes that speak to nobody, and whether they stand at a dead end.';

CREATE OR REPLACE FUNCTION streetgen._check_junction(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model)),
    member AS MATERIALIZED (SELECT m.* FROM _junction_members(NULL) g, unnest(g.members) m)
    SELECT 'error', 'node of degree three and more without a junction', 'node', d.node_id, d.degree, n.geom
        FROM degree d JOIN node n USING (node_id) WHERE d.degree >= 3
            AND NOT EXISTS (SELECT FROM junction_node j WHERE j.node_id = d.node_id)
    UNION ALL
    SELECT 'warning', 'stale: the junction of a node changed since', 'node', m.node_id, m.junction_id, n.geom
        FROM member m JOIN junction_node j USING (node_id)
            JOIN node n USING (node_id) WHERE j.junction_id <> m.junction_id
    UNION ALL
    SELECT 'notice', 'edge that junction_extent keeps out of a junction', 'edge', m.edge_id, e.end_abscissa
        - e.start_abscissa, e.geom FROM member m JOIN edge e USING (edge_id)
        WHERE m.parted
    UNION ALL
    SELECT 'notice', 'junction wider than junction_extent, m', 'junction', j.junction_id, c.width, j.geom
        FROM junction j JOIN (SELECT n.junction_id, ST_MaxDistance(ST_Collect(p.geom), ST_Collect(p.geom)) AS width
            FROM junction_node n JOIN node p USING (node_id) GROUP BY n.junction_id HAVING count(*) > 1) c
            USING (junction_id)
        WHERE c.width > (SELECT value::float8 FROM setting WHERE name = 'junction_extent')
    UNION ALL
    SELECT 'notice', 'turn restriction via axes outside a junction, not obeyed', 'turn_restriction',
        r.turn_restriction_id, cardinality(r.via_axes), r.geom FROM turn_restriction r
        WHERE r.via_axes IS NOT NULL AND 1 <> (SELECT count(DISTINCT coalesce(j.junction_id, -1))
                + count(*) FILTER (WHERE j.junction_id IS NULL)
            FROM streetgen._via_edges(model, r.via_axes, r.via_geom) e
                LEFT JOIN junction_edge j USING (edge_id))
    UNION ALL
    SELECT 'notice', CASE WHEN p.at_end THEN 'control point at a dead end'
        ELSE 'control point without a junction' END, 'control_point', p.control_point_id, 0, p.geom
        FROM streetgen._silent_control_points(model) p
    UNION ALL
    SELECT 'warning', 'junction override without its axis', 'junction_override', o.junction_override_id, 0, o.geom
        FROM junction_override o WHERE NOT EXISTS (SELECT FROM edge e JOIN axis a USING (axis_id)
            WHERE e.axis_id = o.axis_id AND streetgen._metres_beyond(ST_Force2D(a.geom), o.geom) <= 3 * tolerance)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_junction(name) IS
    'The rows of streetgen.check_model for junctions.';

CREATE OR REPLACE FUNCTION streetgen._junction_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (40, 'junction', $part$
    (SELECT 'junctions, ' || kind, count(*), NULL FROM %1$I.junction GROUP BY kind ORDER BY kind)$part$),
    (41, 'junction', $part$
    SELECT 'junctions of several nodes', count(*), NULL FROM %1$I.junction WHERE method = 'grouped'$part$),
    (42, 'junction', $part$
    (SELECT 'edges in junctions, ' || role, count(*), NULL FROM %1$I.junction_edge GROUP BY role ORDER BY role)$part$),
    (43, 'junction', $part$
    SELECT 'paths across junctions, plausible', count(*), NULL FROM %1$I.junction_movement WHERE plausible$part$),
    (44, 'junction', $part$
    (SELECT 'control points without a junction, ' || kind, count(*), NULL
        FROM streetgen._silent_control_points(%1$L) GROUP BY kind ORDER BY kind)$part$) $$;
COMMENT ON FUNCTION streetgen._junction_summary() IS 'What streetgen.summary counts of junctions.';

CREATE OR REPLACE FUNCTION streetgen._junction_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('junction'::name, 'e.from_node = ($1).junction_id OR e.to_node = ($1).junction_id'),
    ('junction_node', 'e.from_node = ($1).node_id OR e.to_node = ($1).node_id'),
    ('junction_movement', 'e.from_node = ($1).junction_id OR e.to_node = ($1).junction_id') $$;
COMMENT ON FUNCTION streetgen._junction_marked_by_hand() IS
    'The edges that a change of junctions by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('control point without a junction',
        'no junction lies ahead within `control_distance`, or nobody waits there for others',
        'move the point to its junction, give it a direction, or delete it'),
    ('control point at a dead end', 'the source ends where the junction would be', 'draw the streets that meet there'),
    ('turn restriction via axes outside a junction, not obeyed',
        'the edges that it leads via do not lie in one junction',
        'put them inside one by `junction_edge_editing`, or delete the restriction'),
    ('node of degree three and more without a junction', 'rows of `junction` are missing',
        '`SELECT * FROM streetgen.generate(…)`'),
    ('stale: the junction of a node changed since', 'edges about it changed while nobody followed',
        '`SELECT * FROM streetgen.generate(…, wait => true)`'),
    ('edge that junction_extent keeps out of a junction',
        'the rules would join its nodes to a junction wider than `junction_extent`',
        'merge it by hand in `junction_override`, or raise the setting'),
    ('junction wider than junction_extent, m', 'its limits cross one after another, or it was merged by hand',
        'look whether widths are too great, or leave it'),
    ('junction override without its axis', 'the axis is gone, or ends before the place',
        'delete the override, or draw the axis');
