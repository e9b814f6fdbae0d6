-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{sidewalk_rows
SELECT w.number, k.edge_id, k.node_id, k.side, k.part, w.width, {surface} AS surface, w.method, {strip} AS strip
FROM (SELECT array_agg(geom::bytea ORDER BY number) AS kerbs, array_agg(level ORDER BY number) AS levels,
        array_agg(width ORDER BY number) AS widths, array_agg(ends ORDER BY number) AS ends,
        array_agg(across ORDER BY number) AS across,
        array_agg(by_hand ORDER BY number) AS by_hand, array_agg(wanted ORDER BY number) AS wanted
    FROM sidewalk_kerb) g, ({sidewalk_course}) c,
    streetgen._sidewalks(kerbs, levels, widths, across, ends, by_hand, g.wanted, c.course_kerbs, c.shares,
        c.course_widths, (SELECT value::float8 FROM {model}.setting WHERE name = 'sidewalk_transition'), {srid}) w
    JOIN sidewalk_kerb k ON k.number = w.number{holes}

--{sidewalk_holes

    LEFT JOIN LATERAL (SELECT streetgen._strip_without(w.surface, array_agg(b.surface ORDER BY b.surface::bytea)) AS cut
        FROM ({takers}) b WHERE ST_Intersects(w.surface, b.surface)) b ON true

--{sidewalk_bays
SELECT b.surface FROM {of_model}parking_bay b, LATERAL (SELECT axis_id FROM {of_model}street_object o
                WHERE o.street_object_id = b.street_object_id AND (o.side IS NULL OR o.axis_offset > 0.01) OFFSET 0) o,
            LATERAL (SELECT level FROM {of_model}axis a WHERE a.axis_id = o.axis_id OFFSET 0) a
        WHERE {cut_anew}b.surface && w.surface AND a.level = k.level

--{sidewalk_tracks
SELECT t.surface FROM (SELECT t.surface FROM {of_model}track_strip t
            WHERE {cut_anew}t.geom && ST_Expand(w.surface, 8) AND t.level = k.level
                AND ST_DWithin(t.geom, w.surface, t.width / 2) OFFSET 0) t

--{sidewalk_cycle_tracks
SELECT t.surface FROM (SELECT ST_Buffer(ST_Force2D(f.geom), x.width / 2, 'endcap=flat quad_segs=4') AS surface
            FROM {of_model}footway f, LATERAL (SELECT coalesce(f.width, (SELECT width FROM {of_model}axis_class
                    WHERE class = f.kind), (SELECT value::float8 FROM {of_model}setting
                    WHERE name = 'mapped_sidewalk_minimal')) AS width OFFSET 0) x
            WHERE {cut_anew}f.geom && ST_Expand(w.surface, 25) AND f.level = k.level
                -- Most footways are no tracks, and none of these is looked at twice.
                AND f.kind = ANY (ARRAY(SELECT class FROM {of_model}axis_class WHERE use = 'cycle'))
                AND ST_DWithin(f.geom, w.surface, x.width / 2) OFFSET 0) t

--{sidewalk_stands

    -- Sidewalks of bays and tracks that changed are cut after this statement.
    LEFT JOIN LATERAL (SELECT s.surface, s.strip FROM {of_model}sidewalk s
        WHERE (s.edge_id, s.side, s.part) = (k.edge_id, k.side, k.part) AND coalesce(s.strip, s.surface) = w.surface
            {stays}OFFSET 0) s ON true

--{sidewalk_stays
AND k.edge_id NOT IN (SELECT edge_id FROM new_edge WHERE axis_id IN (SELECT unnest($3)))

--{cut_sidewalks
#variable_conflict use_column
BEGIN
    IF to_regclass('sidewalk') IS NULL OR cardinality(sidewalks) = 0 THEN
        RETURN;
    END IF;
    UPDATE sidewalk s SET surface = n.surface, strip = n.strip
    FROM (SELECT w.sidewalk_id, {surface} AS surface, {strip} AS strip
        FROM (SELECT sidewalk_id, edge_id, side, part, coalesce(strip, surface) AS surface, strip FROM sidewalk
                WHERE sidewalks IS NULL OR sidewalk_id = ANY (sidewalks)) w
            JOIN kerb k USING (edge_id, side, part){holes}
        WHERE b.cut IS NOT NULL OR w.strip IS NOT NULL) n
    WHERE s.sidewalk_id = n.sidewalk_id AND (s.surface, s.strip) IS DISTINCT FROM (n.surface, n.strip);
END

--{sidewalks_on
BEGIN
    IF to_regclass('sidewalk') IS NULL OR ground IS NULL THEN
        RETURN NULL;
    END IF;
    RETURN ARRAY(
        -- Bays lie side by side: those of a place are looked up together.
        SELECT DISTINCT near.sidewalk_id FROM (SELECT ST_SetSRID(ST_Extent(g)::geometry, min(ST_SRID(g))) AS box
            FROM unnest(ground) g GROUP BY floor(ST_XMin(g) / 20), floor(ST_YMin(g) / 20)) g, LATERAL (
            SELECT s.sidewalk_id, s.surface FROM sidewalk s WHERE s.surface && g.box
            UNION SELECT s.sidewalk_id, s.strip FROM sidewalk s WHERE s.strip && g.box OFFSET 0) near
        WHERE EXISTS (SELECT FROM unnest(ground) g WHERE g && near.surface));
END

--{sidewalk_kerbs_of_part
sidewalk_edge AS MATERIALIZED (
    SELECT edge_id, axis_id, geom, from_node, to_node, start_abscissa, end_abscissa, sidewalk_left, sidewalk_right,
        estimated
    FROM new_edge),
-- Kerbs that moved or went, as they were.
former_kerb AS MATERIALIZED (
    SELECT k.*
    FROM (SELECT kerb_id FROM new_kerb WHERE changed AND NOT fresh UNION ALL SELECT kerb_id FROM gone_kerb) c,
        LATERAL (SELECT * FROM {model}.kerb k WHERE k.kerb_id = c.kerb_id OFFSET 0) k
    -- Kerbs of a node and of an edge that go. The kerb of another corner may take the row.
    UNION ALL SELECT k.* FROM left_node n, LATERAL (SELECT * FROM {model}.kerb k WHERE k.node_id = n.node_id OFFSET 0) k
    UNION ALL SELECT k.* FROM old_edge e, LATERAL (SELECT * FROM {model}.kerb k WHERE k.edge_id = e.edge_id OFFSET 0) k
    WHERE e.written AND e.edge_id NOT IN (SELECT edge_id FROM new_edge)),
-- Two sidewalks side by side: a strip lies within 1.25 widths of its kerb.
sidewalk_reach AS MATERIALIZED (
    SELECT 0.01 + 2.5 * greatest((SELECT max(width) FROM {model}.sidewalk), (SELECT max(width)
            FROM {model}.sidewalk_override), max(sidewalk_left), max(sidewalk_right){widest_course}, 0) AS metres
    FROM sidewalk_edge),
-- A kerb that came, went or moved, or whose width is another.
moved_kerb AS MATERIALIZED (
    SELECT geom FROM new_kerb WHERE changed OR edge_id IN (SELECT edge_id FROM new_edge
        WHERE axis_id IN (SELECT unnest($3)))
    UNION ALL SELECT geom FROM former_kerb
    UNION ALL SELECT k.geom FROM new_edge e, LATERAL (SELECT * FROM {model}.kerb k
        WHERE k.edge_id = e.edge_id AND k.node_id IS NULL OFFSET 0) k
    WHERE NOT e.kerbs_affected AND e.axis_id IN (SELECT unnest($3))),
-- Strips behind near kerbs may change, and with them what rivals of these kerbs get of shared ground.

--{standing_kerb
,
standing_kerb AS MATERIALIZED (
    SELECT edge_id, node_id, level, side, part, geom, method, beside, true AS wanted FROM new_kerb WHERE changed
    UNION ALL SELECT edge_id, node_id, level, side, part, geom, method, beside, true
    FROM (TABLE near_kerb_row UNION ALL TABLE rival_kerb_row) k
    UNION ALL SELECT edge_id, node_id, level, side, part, geom, method, beside, false
    FROM (TABLE beside_kerb_row UNION ALL TABLE outer_kerb_row) k),
sidewalk_kerb AS MATERIALIZED (

--{standing_edges
TABLE sidewalk_edge
UNION ALL SELECT e.edge_id, e.axis_id, e.geom, e.from_node, e.to_node, e.start_abscissa, e.end_abscissa,
    e.sidewalk_left, e.sidewalk_right, e.estimated
FROM (SELECT DISTINCT edge_id FROM standing_kerb) n, LATERAL (SELECT * FROM {model}.edge e
    WHERE e.edge_id = n.edge_id OFFSET 0) e WHERE e.edge_id NOT IN (SELECT edge_id FROM sidewalk_edge)

--{sidewalk_kerbs
SELECT row_number() OVER (ORDER BY k.edge_id, k.side, k.part) AS number, k.edge_id, k.node_id, k.side, k.part,
    k.level, k.geom, e.geom AS line, k.wanted, k.method = 'level_change' AS ends,
    -- Nor does a sidewalk lead from the city on to a median, a splitter or an island.
    k.side IN ('start', 'end') OR k.beside <> 'outer' AS across, o.width IS NOT NULL AS by_hand,
    -- None is estimated along the part of a side where a median lies.
    CASE WHEN k.side IN ('left', 'right') THEN coalesce(o.width, CASE
        WHEN k.beside <> 'outer' AND 'sidewalk_' || k.side = ANY (e.estimated) THEN 0
        WHEN k.side = 'left' THEN e.sidewalk_left ELSE e.sidewalk_right END) END AS width
FROM ({kerbs}) k JOIN ({edges}) e USING (edge_id) LEFT JOIN LATERAL (
    SELECT width FROM {model}.sidewalk_override o WHERE o.axis_id = e.axis_id AND o.side = k.side
        AND k.node_id IS NULL AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
    ORDER BY sidewalk_override_id DESC LIMIT 1) o ON true

--{kerbs_near
{name} AS MATERIALIZED (
    WITH RECURSIVE known AS MATERIALIZED (SELECT {known} AS kerbs),
    reached AS (
        SELECT k.kerb_id, k.leads FROM ({places}) p, sidewalk_reach r, LATERAL (
            SELECT kerb_id, side NOT IN ('left', 'right') AS leads FROM {model}.kerb k
            WHERE k.geom && ST_Expand(p.geom, r.metres) AND ST_DWithin(k.geom, p.geom, r.metres) OFFSET 0) k
        WHERE k.kerb_id NOT IN (SELECT unnest(kerbs) FROM known)
        UNION SELECT k.kerb_id, k.leads FROM reached n, LATERAL (
            SELECT geom FROM {model}.kerb k WHERE k.kerb_id = n.kerb_id OFFSET 0) p, LATERAL (
            SELECT kerb_id, side NOT IN ('left', 'right') AS leads FROM {model}.kerb k
            WHERE k.geom && ST_Expand(p.geom, 2e-6) AND ST_DWithin(k.geom, p.geom, 2e-6) OFFSET 0) k
        WHERE n.leads AND k.kerb_id NOT IN (SELECT unnest(kerbs) FROM known))
    SELECT r.kerbs, known.kerbs || r.kerbs AS known
    FROM known, (SELECT ARRAY(SELECT kerb_id FROM reached) AS kerbs) r),
{name}_row AS MATERIALIZED (
    SELECT k.* FROM {name} n, unnest(n.kerbs) u(kerb_id), LATERAL (
        SELECT * FROM {model}.kerb k WHERE k.kerb_id = u.kerb_id OFFSET 0) k)

--{sidewalks_by_hand
CROSS JOIN LATERAL (
    SELECT (array_agg(width ORDER BY id DESC) FILTER (WHERE side = 'left'))[1] AS sidewalk_left_by_hand,
        (array_agg(width ORDER BY id DESC) FILTER (WHERE side = 'right'))[1] AS sidewalk_right_by_hand
    FROM (SELECT sidewalk_override_id AS id, side, width FROM {model}.sidewalk_override o
        WHERE o.axis_id = e.axis_id AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa) o) h

--{crossover
CREATE OR REPLACE VIEW crossover WITH (security_invoker = true) AS
SELECT 2 * d.edge_id + (b.end_b = 'end')::integer AS crossover_id, d.edge_id, n.node_id, d.level,
    'lowered' AS kerb, ST_MakeLine(m.before, m.behind) AS kerb_line,
    least(w.before, w.behind) AS width, n.geom AS place, ST_Multi(g.surface)::geometry(MultiPolygon, {srid}) AS surface
-- Counter-clockwise about the node: the street before the mouth, the drive, the street behind it.
FROM node n JOIN corner b ON b.node_id = n.node_id JOIN corner c ON (c.node_id, c.edge_a, c.end_a)
        = (n.node_id, b.edge_b, b.end_b)
    JOIN edge d ON d.edge_id = b.edge_b JOIN axis a ON a.axis_id = d.axis_id
    JOIN axis_class k ON k.class = a.kind AND k.walked_along AND NOT k.crossed_on_foot
    JOIN edge x ON x.edge_id = b.edge_a JOIN edge y ON y.edge_id = c.edge_b
    JOIN intersection i ON i.node_id = n.node_id JOIN section s ON s.edge_id = d.edge_id
    CROSS JOIN LATERAL (SELECT CASE b.end_a WHEN 'start' THEN x.sidewalk_left ELSE x.sidewalk_right END AS before,
        CASE c.end_b WHEN 'start' THEN y.sidewalk_right ELSE y.sidewalk_left END AS behind) w
    CROSS JOIN LATERAL (SELECT ST_StartPoint(b.arc) AS before, ST_EndPoint(c.arc) AS behind) m
    -- Away from the street.
    CROSS JOIN LATERAL (SELECT ST_Azimuth(m.before, m.behind) AS along, ST_Distance(m.before, m.behind) AS mouth) t
    CROSS JOIN LATERAL (SELECT sin(along + pi() / 2) AS east, cos(along + pi() / 2) AS north) o
    CROSS JOIN LATERAL (SELECT ST_MakePolygon(ST_MakeLine(ARRAY[m.before, m.behind, ST_Translate(m.behind,
        east * w.behind, north * w.behind), ST_Translate(m.before, east * w.before, north * w.before), m.before]))
        AS strip) p
    CROSS JOIN LATERAL (SELECT ST_CollectionExtract(ST_Intersection(p.strip, ST_Union(i.surface, s.surface)), 3)
        AS surface) g
WHERE b.arc IS NOT NULL AND c.arc IS NOT NULL AND w.before > 0 AND w.behind > 0 AND t.mouth BETWEEN 0.5 AND 30
    AND NOT EXISTS (SELECT FROM axis JOIN axis_class ON class = kind WHERE axis_id IN (x.axis_id, y.axis_id)
        AND NOT crossed_on_foot)
    -- Where another street meets it, who drives there comes to a junction.
    AND NOT EXISTS (SELECT FROM edge e JOIN axis USING (axis_id) LEFT JOIN axis_class ON class = kind
        WHERE (e.from_node = n.node_id OR e.to_node = n.node_id) AND e.edge_id NOT IN (x.edge_id, y.edge_id)
            AND crossed_on_foot IS NOT FALSE)
    AND ST_Area(g.surface) > 0.5

--{side_strip
CREATE OR REPLACE VIEW side_strip WITH (security_invoker = true) AS
SELECT 10 * w.sidewalk_id + t."order" AS side_strip_id, w.sidewalk_id, w.edge_id, k.side, t."order", t.kind, k.level,
    CASE t.kind WHEN 'cycle_track' THEN v.paved END AS paved,
    ST_Multi(c.surface)::geometry(MultiPolygon, {srid}) AS surface
FROM axis a CROSS JOIN LATERAL (VALUES
        ('left', a.strips_left, a.parking_left, a.cycle_paved_left),
        ('right', a.strips_right, a.parking_right, a.cycle_paved_right)) v(side, said, parking, paved)
    JOIN edge e USING (axis_id) JOIN sidewalk w ON w.edge_id = e.edge_id AND w.side = v.side
    JOIN kerb k ON (k.edge_id, k.side, k.part) = (w.edge_id, w.side, w.part)
    CROSS JOIN setting_used u
    -- Stones and bays lie before the strips.
    CROSS JOIN LATERAL (SELECT (u.settings ->> 'kerb_stone_width')::float8 + CASE WHEN v.parking LIKE 'street\_side%'
        AND {bays} THEN streetgen._parking_depth(v.parking, u.settings) ELSE 0 END AS before) b
    CROSS JOIN LATERAL streetgen._side_strips(v.said, u.settings) t
    CROSS JOIN LATERAL (SELECT ST_CollectionExtract(ST_Intersection(w.surface, ST_Difference(
        ST_Buffer(ST_Force2D(k.geom), b.before + t.far, 'endcap=flat join=mitre mitre_limit=2'),
        ST_Buffer(ST_Force2D(k.geom), b.before + t.near, 'endcap=flat join=mitre mitre_limit=2'))), 3) AS surface) c
WHERE v.said IS NOT NULL AND k.node_id IS NULL AND NOT ST_IsEmpty(c.surface)
