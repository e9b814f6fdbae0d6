-- Rules of check_model for surfaces.

CREATE OR REPLACE FUNCTION streetgen._corner_overrides_not_followed(model name)
    RETURNS TABLE(corner_override_id bigint, cause text, radius float8, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    tolerance constant float8 := streetgen._tolerance(model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH near AS (
        SELECT o.corner_override_id, o.radius AS wanted, o.geom AS place, c.corner_id, c.radius, c.radius_wanted,
            c.method, n.geom AS node, a.geom AS line_a, c.end_a, b.geom AS line_b, c.end_b,
            rank() OVER (PARTITION BY o.corner_override_id ORDER BY ST_Distance(n.geom, o.geom), n.node_id) AS nth,
            count(*) OVER (PARTITION BY o.corner_override_id, n.node_id) > 1 AS twin
        FROM corner_override o JOIN node n ON ST_DWithin(n.geom, o.geom, 3 * tolerance) JOIN corner c USING (node_id)
            JOIN edge a ON a.edge_id = c.edge_a JOIN edge b ON b.edge_id = c.edge_b
        WHERE (a.axis_id, b.axis_id) = (o.axis_a, o.axis_b)),
    meant AS (
        SELECT *, max(corner_override_id) OVER (PARTITION BY corner_id) = corner_override_id AS holds,
            abs(radius - wanted) <= 1e-6 AS followed
        FROM near WHERE nth = 1 AND (NOT twin OR streetgen._on_side(place, node,
            streetgen._direction_from(line_a, end_a), streetgen._direction_from(line_b, end_b)))),
    -- One that speaks of two corners is told by the one that does not follow it.
    told AS (SELECT DISTINCT ON (corner_override_id) * FROM meant ORDER BY corner_override_id, holds DESC, followed)
    SELECT o.corner_override_id, CASE WHEN t.corner_id IS NULL THEN 'no_corner' WHEN NOT t.holds THEN 'younger'
            WHEN abs(t.radius_wanted - t.wanted) > 1e-6 THEN 'not_computed' ELSE t.method END,
        coalesce(t.radius, o.radius), o.geom
    FROM corner_override o LEFT JOIN told t USING (corner_override_id)
    WHERE t.corner_id IS NULL OR NOT (t.holds AND t.followed);
END $$;
COMMENT ON FUNCTION streetgen._corner_overrides_not_followed(name) IS
    'The corner overrides of a model whose radius no street has, with the cause: no_corner, younger, not_computed or '
    'the method of the corner; and the radius (metres) that the street has, of the override where it has no corner.';

CREATE OR REPLACE FUNCTION streetgen._check_surface(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    WITH degree AS MATERIALIZED (SELECT * FROM streetgen._node_degrees(model)),
    not_made AS MATERIALIZED (
        SELECT geom, greatest(width, width_end) / 2 + abs(roadway_offset) AS half FROM axis_used u
            WHERE NOT EXISTS (SELECT FROM edge e WHERE e.axis_id = u.axis_id)),
    invalid AS MATERIALIZED (
        SELECT 'section' AS relation, edge_id AS id, surface FROM section
            WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
        UNION ALL SELECT 'intersection', node_id, surface FROM intersection
            WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)),
    -- By lists, so that each is left out before its surface meets another.
    valid_section AS NOT MATERIALIZED (SELECT * FROM section
        WHERE edge_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'section'))),
    valid_intersection AS NOT MATERIALIZED (SELECT * FROM intersection
        WHERE node_id <> ALL (ARRAY(SELECT id FROM invalid WHERE relation = 'intersection'))),
    -- Neighbours share their border vertex for vertex, so that a relation without a grid would stumble over rounding.
    -- A grid costs as much again, so that only pairs that share ground without one are looked at.
    -- Levels are compared by difference, since a hash join of a whole level would pass over the spatial index.
    overlap AS MATERIALIZED (
        SELECT relation, id, ST_CollectionExtract(ST_Intersection(a, b, 1e-5), 3) AS shared FROM (
            SELECT 'section' AS relation, a.edge_id AS id, a.surface AS a, b.surface AS b
            FROM valid_section a JOIN valid_section b ON a.surface && b.surface AND a.level - b.level = 0
                AND a.edge_id < b.edge_id
            UNION ALL SELECT 'section', a.edge_id, a.surface, b.surface
            FROM valid_section a JOIN valid_intersection b ON a.surface && b.surface AND a.level - b.level = 0
            UNION ALL SELECT 'intersection', a.node_id, a.surface, b.surface
            FROM valid_intersection a JOIN valid_intersection b ON a.surface && b.surface AND a.level - b.level = 0
                AND a.node_id < b.node_id) pair
        WHERE streetgen._share_ground(a::bytea, b::bytea) AND ST_Area(ST_Intersection(a, b)) > 1e-6),
    -- A part of an edge on neither its section nor its nodes' intersections, nor, where ground was contested, on other
    -- roadway. Borders may run along the edge, so that a piece is bare only where its middle is off all of them;
    -- contested ground is shared out on a grid of 10 micrometres. An axis beside the middle of its roadway leaves it
    -- where kerbs round a bend.
    bare AS MATERIALIZED (
        SELECT edge_id, piece.geom, ST_Length(piece.geom) AS length
        FROM (SELECT e.edge_id, e.roadway_offset, from_node, to_node, s.contested_area + coalesce(a.contested_area,
            0) + coalesce(b.contested_area, 0) > 0 AS contested,
                     ST_Difference(ST_Difference(ST_Difference(ST_Force2D(e.geom), s.surface),
                         coalesce(a.surface, s.surface)), coalesce(b.surface, s.surface)) AS rest
              FROM edge e JOIN valid_section s USING (edge_id)
              LEFT JOIN intersection a ON a.node_id = from_node LEFT JOIN intersection b ON b.node_id = to_node
              WHERE NOT ARRAY[from_node, to_node] && ARRAY(SELECT id FROM invalid WHERE relation = 'intersection')
                AND NOT streetgen._lies_on(
                    e.geom::bytea, s.surface::bytea, coalesce(a.surface, s.surface)::bytea,
                        coalesce(b.surface, s.surface)::bytea)
              OFFSET 0) e, ST_Dump(rest) piece,
             LATERAL (SELECT ST_LineInterpolatePoint(piece.geom, 0.5) AS middle, abs(roadway_offset)
                 + CASE WHEN contested THEN 1e-5 ELSE 1e-6 END AS off) p
        WHERE ST_Length(piece.geom) > 1e-6
          AND NOT EXISTS (SELECT FROM section r WHERE ST_DWithin(surface, middle, off)
              AND (contested OR r.edge_id = e.edge_id))
          AND NOT EXISTS (SELECT FROM intersection r WHERE ST_DWithin(surface, middle, off)
              AND (contested OR node_id IN (from_node, to_node)))
          -- Ground may wait for a street that is not made yet.
          AND NOT (contested AND EXISTS (SELECT FROM not_made WHERE ST_DWithin(not_made.geom, middle, half))))
    SELECT 'error', 'invalid surface', relation, id, ST_Area(surface), surface FROM invalid
    UNION ALL
    SELECT 'error', 'overlap on one level, m2', relation, id, ST_Area(shared), shared FROM overlap
        WHERE ST_Area(shared) > 0.001
    UNION ALL
    SELECT 'error', 'node of degree three and more without an intersection', 'node', n.node_id, d.degree, n.geom
        FROM node n JOIN degree d USING (node_id) LEFT JOIN intersection i USING (node_id) WHERE d.degree >= 3
            AND (i.node_id IS NULL OR ST_IsEmpty(i.surface) AND i.contested_area = 0)
    UNION ALL
    SELECT 'error', 'edge without its two limits', 'edge', e.edge_id, count(l.edge_id), e.geom FROM edge e
        LEFT JOIN section_limit l USING (edge_id) GROUP BY e.edge_id HAVING count(l.edge_id) <> 2
    UNION ALL
    SELECT 'error', 'edge without a section', 'edge', e.edge_id, 0, e.geom FROM edge e
        WHERE NOT EXISTS (SELECT FROM section s WHERE s.edge_id = e.edge_id)
    UNION ALL
    SELECT 'error', 'edge outside the roadway, m', 'edge', edge_id, length, geom FROM bare
    UNION ALL
    SELECT 'error', 'limits out of order', 'edge', a.edge_id, a.abscissa - b.abscissa, a.geom
        FROM section_limit a JOIN section_limit b USING (edge_id) WHERE a.which = 'start' AND b.which = 'end'
            AND a.abscissa > b.abscissa + 1e-6
    UNION ALL
    SELECT 'notice', 'contested, m2', 'section', edge_id, contested_area, surface FROM section
        WHERE contested_area > 1 AND method <> 'crowded'
    UNION ALL
    SELECT 'notice', 'contested, m2', 'intersection', node_id, contested_area, surface FROM intersection
        WHERE contested_area > 1 AND method <> 'crowded'
    UNION ALL
    SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'section', edge_id,
        contested_area, geom
        FROM section JOIN edge USING (edge_id) WHERE method = 'crowded'
    UNION ALL
    SELECT 'warning', 'ground shared out by rank, surfaces over overlaps_maximal, m2 lost', 'intersection',
        node_id, contested_area, geom
        FROM intersection JOIN node USING (node_id) WHERE method = 'crowded'
    UNION ALL
    SELECT 'warning', 'transition_override finds no change of width', 'transition_override',
        o.transition_override_id, 0, u.geom
        FROM transition_override o LEFT JOIN axis u USING (axis_id) WHERE NOT EXISTS (
            SELECT FROM edge e JOIN intersection i ON i.node_id = CASE o.which WHEN 'start' THEN e.from_node
                ELSE e.to_node END JOIN degree d USING (node_id)
            WHERE e.axis_id = o.axis_id AND d.degree = 2 AND i.method IN ('transition', 'contested', 'crowded')
                AND NOT EXISTS (SELECT FROM edge f WHERE f.axis_id = e.axis_id AND CASE o.which WHEN 'start'
                    THEN f.start_abscissa < e.start_abscissa ELSE f.end_abscissa > e.end_abscissa END))
    UNION ALL
    SELECT 'warning', CASE cause WHEN 'no_corner' THEN 'corner override without its corner'
            WHEN 'younger' THEN 'corner override with a younger one of its corner, m'
            WHEN 'not_computed' THEN 'corner override not computed yet, m'
            WHEN 'transition' THEN 'corner override where the width changes, not followed'
            WHEN 'no_arc' THEN 'corner override for which no arc fits'
            WHEN 'covered' THEN 'corner override with roadway behind its arc'
            WHEN 'radius_minimal' THEN 'corner override with its centre beyond max_arc_distance, m'
            ELSE 'corner override greater than the radius that fits, m' END,
        'corner_override', corner_override_id, radius, geom FROM streetgen._corner_overrides_not_followed(model)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_surface(name) IS
    'The rows of streetgen.check_model for sections, intersections and corners.';

CREATE OR REPLACE FUNCTION streetgen._surface_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (6, 'surface', $part$
    (SELECT 'sections, ' || method, count(*), NULL FROM %1$I.section GROUP BY method ORDER BY method)$part$),
    (7, 'surface', $part$
    (SELECT 'intersections, ' || method, count(*), NULL FROM %1$I.intersection GROUP BY method ORDER BY method)$part$),
    (8, 'surface', $part$
    (SELECT 'corners, ' || method, count(*), NULL FROM %1$I.corner GROUP BY method ORDER BY method)$part$),
    (15, 'surface', $part$
    SELECT 'roadway', round((coalesce((SELECT sum(ST_Area(surface)) FROM %1$I.section), 0)
    + coalesce((SELECT sum(ST_Area(surface)) FROM %1$I.intersection), 0))::numeric, 1), 'm2'$part$),
    (16, 'surface', $part$
    SELECT 'contested', round((coalesce((SELECT sum(contested_area) FROM %1$I.section), 0)
    + coalesce((SELECT sum(contested_area) FROM %1$I.intersection), 0))::numeric, 1), 'm2'$part$) $$;
COMMENT ON FUNCTION streetgen._surface_summary() IS 'What streetgen.summary counts of the roadway.';

CREATE OR REPLACE FUNCTION streetgen._surface_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('corner'::name, 'e.edge_id IN (($1).edge_a, ($1).edge_b)'),
    ('intersection', 'e.from_node = ($1).node_id OR e.to_node = ($1).node_id') $$;
COMMENT ON FUNCTION streetgen._surface_marked_by_hand() IS
    'The edges that a change of corners and intersections by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('invalid surface', 'ST_IsValid refuses the surface',
        '`generate`; if the row stays, please report the axes around it'),
    ('overlap on one level, m2', 'two surfaces of one level cover the same ground', '`generate` over all'),
    ('node of degree three and more without an intersection', 'a junction has no roadway', '`generate`'),
    ('edge without its two limits', 'an edge needs a limit at both ends', '`generate`'),
    ('edge without a section', 'an edge needs a section, be it empty', '`generate`'),
    ('edge outside the roadway, m', 'so much of the edge lies on no surface of its own',
        'look at the widths around the edge'),
    ('limits out of order', 'the start limit lies behind the end limit', '`generate`'),
    ('contested, m2', 'so much ground went to other surfaces', 'the widths of neighbouring axes contradict each other'),
    ('ground shared out by rank, surfaces over overlaps_maximal, m2 lost',
        'so much ground went to surfaces of higher rank, since very many lie upon each other',
        'correct axes that lie upon each other, or raise the setting'),
    ('transition_override finds no change of width', 'the decision has nothing to act on', 'delete the override'),
    ('corner override without its corner', 'no such corner is near it', 'move or delete the override'),
    ('corner override with a younger one of its corner, m', 'of two for one corner the younger holds',
        'delete one of them'),
    ('corner override not computed yet, m', 'streets did not follow when it was written', 'run generate'),
    ('corner override where the width changes, not followed',
        'two streets of different widths meet; the change of width has no arc',
        'give both streets one width there, or delete the override'),
    ('corner override for which no arc fits', 'the streets are too short, or leave in nearly one line',
        'make room by their axes, or delete the override'),
    ('corner override with roadway behind its arc', 'other streets cover the ground there, and no kerb runs along it',
        'correct axes that lie too close, or delete the override'),
    ('corner override with its centre beyond max_arc_distance, m',
        'the angle is so acute that the centre of each arc lies farther off than the setting allows',
        'raise max_arc_distance, or delete the override'),
    ('corner override greater than the radius that fits, m',
        'one of the streets is too short for it, or its centre would lie beyond max_arc_distance; the measure is '
            'the radius that it has',
        'type at most that, make the street longer, or raise max_arc_distance');
