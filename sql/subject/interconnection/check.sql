-- Rules of check_model for paths across nodes.

CREATE OR REPLACE FUNCTION streetgen._check_interconnection(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model)),
    lane_node AS MATERIALIZED (
        -- A merging lane ends, or begins, between two nodes.
        SELECT l.lane_id, l.geom, v.along, v.leaves, v.enters FROM lane l JOIN edge e USING (edge_id)
        JOIN LATERAL (VALUES (true, CASE WHEN l.start_abscissa IS NULL THEN e.from_node END,
                CASE WHEN l.end_abscissa IS NULL THEN e.to_node END),
            (false, CASE WHEN l.end_abscissa IS NULL THEN e.to_node END,
                CASE WHEN l.start_abscissa IS NULL THEN e.from_node END)) v(along, leaves, enters)
            ON l.both_ways OR l.along_axis = v.along
        WHERE l.kind NOT IN ('parking', 'closed')),
    -- Nobody need turn off from a lane in the middle, and one comes to it from the lanes beside.
    middle AS MATERIALIZED (SELECT lane_id FROM streetgen._lanes_in_middle(model)),
    decided AS MATERIALIZED (
        SELECT DISTINCT ON (c.interconnection_id) d.*, c.interconnection_id, c.connecting AS was_connecting,
            c.plausible, c.control AS was_control, c.method AS was_method
        FROM interconnection_override d JOIN edge a ON a.axis_id = d.axis_in
            JOIN lane i ON (i.edge_id, i.ordinality) = (a.edge_id, d.lane_in)
        JOIN edge b ON b.axis_id = d.axis_out JOIN lane o ON (o.edge_id, o.ordinality) = (b.edge_id, d.lane_out)
        JOIN interconnection c ON (c.lane_in, c.lane_out) = (i.lane_id, o.lane_id) JOIN node n USING (node_id)
       
        WHERE (d.along_in = c.along_in) IS NOT FALSE AND (d.along_out = c.along_out) IS NOT FALSE
            AND ST_DWithin(d.geom, n.geom, 3 * tolerance)
        ORDER BY c.interconnection_id, d.interconnection_override_id DESC),
    -- Nodes of more pairs of lanes than are made.
    busy_node AS MATERIALIZED (
        SELECT node_id, sum(comes) * sum(goes) - CASE WHEN u_turn THEN 0 ELSE sum(comes * goes) END AS pairs
        FROM (SELECT node_id, edge_id, count(*) FILTER (WHERE comes) AS comes, count(*) FILTER (WHERE NOT comes) AS goes
              FROM lane_node l JOIN lane USING (lane_id),
                  LATERAL (VALUES (l.enters, true), (l.leaves, false)) v(node_id, comes)
              GROUP BY node_id, edge_id) e,
             (SELECT max(value) FILTER (WHERE name = 'interconnections_maximal') AS most, max(value)
                 FILTER (WHERE name = 'u_turn') = 'true' AS u_turn FROM setting) s
        GROUP BY node_id, u_turn, most HAVING sum(comes) * sum(goes) - CASE WHEN u_turn THEN 0 ELSE sum(comes * goes)
            END > most::float8)
    SELECT 'error', 'interconnection off its lanes, m', 'interconnection', interconnection_id, off, geom FROM (
        SELECT c.interconnection_id, c.geom,
            greatest(ST_Distance(ST_StartPoint(c.geom),
                    CASE WHEN c.along_in THEN ST_EndPoint(i.geom) ELSE ST_StartPoint(i.geom) END),
                ST_Distance(ST_EndPoint(c.geom),
                    CASE WHEN c.along_out THEN ST_StartPoint(o.geom) ELSE ST_EndPoint(o.geom) END)) AS off
        FROM interconnection c JOIN lane i ON i.lane_id = c.lane_in JOIN lane o ON o.lane_id = c.lane_out) p
            WHERE off > 0.001
    UNION ALL
    SELECT 'notice', 'lane without a plausible way on', 'lane', l.lane_id, d.degree, l.geom FROM lane_node l
        JOIN degree d ON d.node_id = l.enters
        WHERE d.degree > 1 AND NOT EXISTS (SELECT FROM interconnection c
            WHERE (c.lane_in, c.along_in) = (l.lane_id, l.along) AND c.plausible)
            AND l.lane_id NOT IN (SELECT lane_id FROM middle) AND d.node_id NOT IN (SELECT node_id FROM busy_node)
    UNION ALL
    SELECT 'notice', 'lane for cars that leads only where they may not drive', 'lane', l.lane_id, d.degree, l.geom
        FROM lane_node l JOIN degree d ON d.node_id = l.enters JOIN lane k USING (lane_id)
        WHERE k.kind IN ('general', 'merging') AND (SELECT bool_and(c.traffic IS NOT NULL) FROM interconnection c
            WHERE (c.lane_in, c.along_in) = (l.lane_id, l.along) AND c.plausible)
    UNION ALL
    SELECT 'notice', 'lane that no plausible way reaches', 'lane', l.lane_id, d.degree, l.geom FROM lane_node l
        JOIN degree d ON d.node_id = l.leaves
        WHERE d.degree > 1 AND NOT EXISTS (SELECT FROM interconnection c
            WHERE (c.lane_out, c.along_out) = (l.lane_id, l.along) AND c.plausible)
            AND l.lane_id NOT IN (SELECT lane_id FROM middle) AND d.node_id NOT IN (SELECT node_id FROM busy_node)
    UNION ALL
    -- A mark that the street farther on repeats, or replaces by its own, is answered there.
    SELECT 'notice', 'lane marked for a turn that no way answers', 'lane', l.lane_id, count(*), l.geom
        FROM lane_node l JOIN lane k USING (lane_id) JOIN degree d ON d.node_id = l.enters
            CROSS JOIN LATERAL unnest(string_to_array(k.turn, ';')) word
            JOIN LATERAL (SELECT regexp_replace(word, '^(slight|sharp)_', '') AS meant) s
                ON meant IN ('left', 'through', 'right')
        WHERE d.degree > 1 AND (SELECT bool_or(c.plausible) AND bool_and(NOT coalesce(
                c.reason NOT IN ('restriction', 'u_turn') AND (c.turn = meant OR c.turn <> 'u_turn'
                    AND abs(c.angle) < 50 AND word IN ('through', 'slight_left', 'slight_right'))
                OR c.plausible AND (word = ANY (string_to_array(o.turn, ';'))
                    OR CASE WHEN c.along_out THEN a.turn_forward ELSE a.turn_backward END IS NOT NULL), false))
            FROM interconnection c JOIN lane o ON o.lane_id = c.lane_out JOIN edge e USING (edge_id)
                JOIN axis a USING (axis_id)
            WHERE (c.lane_in, c.along_in) = (l.lane_id, l.along))
        GROUP BY l.lane_id, l.geom
    UNION ALL
    SELECT 'warning', 'pairs of lanes over interconnections_maximal, none made', 'node', node_id, pairs, n.geom
        FROM busy_node JOIN node n USING (node_id)
    UNION ALL
    SELECT 'warning', 'interconnection override without a place', 'interconnection_override',
        d.interconnection_override_id, 0, d.geom FROM interconnection_override d
        WHERE NOT EXISTS (SELECT FROM edge a JOIN lane i USING (edge_id)
            JOIN interconnection c ON c.lane_in = i.lane_id JOIN lane o ON o.lane_id = c.lane_out
            JOIN edge b ON b.edge_id = o.edge_id JOIN node n ON n.node_id = c.node_id
            WHERE (a.axis_id, i.ordinality, b.axis_id, o.ordinality) = (d.axis_in, d.lane_in, d.axis_out, d.lane_out)
                AND (d.along_in = c.along_in) IS NOT FALSE
                AND (d.along_out = c.along_out) IS NOT FALSE AND ST_DWithin(d.geom, n.geom, 3 * tolerance))
    UNION ALL
    SELECT 'warning', 'stale: an interconnection override changed since', 'interconnection_override',
        interconnection_override_id, 0, geom FROM decided
        WHERE was_method <> 'by_hand' OR was_connecting <> coalesce(connecting, plausible) OR control IS NOT NULL
            AND control::bytea IS DISTINCT FROM was_control::bytea
    UNION ALL
    SELECT 'notice', 'path with a corner that no car drives, the only way', 'interconnection', interconnection_id,
        angle, geom FROM interconnection WHERE plausible AND reason = 'not_drivable'
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_interconnection(name) IS
    'The rows of streetgen.check_model for paths across nodes.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (17, 'interconnection', $part$
    (SELECT 'interconnections, ' || CASE WHEN plausible THEN 'plausible by ' ELSE 'not plausible by ' END || reason,
    count(*), NULL FROM %1$I.interconnection GROUP BY plausible, reason ORDER BY plausible DESC, reason)$part$) $$;
COMMENT ON FUNCTION streetgen._interconnection_summary() IS 'What streetgen.summary counts of interconnections.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('interconnection'::name, 'e.from_node = ($1).node_id OR e.to_node = ($1).node_id') $$;
COMMENT ON FUNCTION streetgen._interconnection_marked_by_hand() IS
    'The edges that a change of interconnections by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('interconnection off its lanes, m', 'the path does not start or end where its lanes do', '`generate`'),
    ('lane for cars that leads only where they may not drive',
        'all ways on are for buses, carpools or bicycles alone', 'correct `access`, kinds of lanes or directions'),
    ('lane marked for a turn that no way answers',
        'no street lies in that direction at the node where the mark ends, or one may not turn there',
        'correct the marks, directions or turn restrictions'),
    ('lane without a plausible way on', 'traffic of the lane can go nowhere',
        'correct directions, lanes or turn restrictions'),
    ('lane that no plausible way reaches', 'no traffic comes to the lane',
        'correct directions, lanes or turn restrictions'),
    ('pairs of lanes over interconnections_maximal, none made',
        'so many pairs meet at the node that it has no interconnections',
        'correct the axes that meet there, or raise the setting'),
    ('interconnection override without a place', 'no pair of such lanes is near it', 'move or delete the override'),
    ('stale: an interconnection override changed since', 'the streets do not know the decision yet', '`generate`'),
    ('path with a corner that no car drives, the only way',
        'lane in or lane out would be without a way, and no path between them is clear of the kerbs and without a '
            'corner',
        'give the corner more room: limits, radius, or the axes');
