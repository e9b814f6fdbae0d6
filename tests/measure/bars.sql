-- What a road engineer asks of ground, paths and rings of the model of variable model, a row a figure with its bar.
-- Run as psql -v model=NAME -f tests/measure/bars.sql. Subjects interconnection, junction and roundabout are on.
-- A row has what was found, of how many, and the bar. Table `place` has the places afterwards, by figure.
-- junction_ground.sql and turns.sql have the figures that are not here; lanes/one_way that of lanes guessed again.
\set ON_ERROR_STOP on
SET client_min_messages = warning;
CREATE TEMPORARY TABLE place (figure text, id bigint, value float8, geom geometry);
CREATE TEMPORARY TABLE street AS
SELECT edge_id, from_node, to_node, e.level, ST_Force2D(e.geom) AS geom, e.width, e.width_end,
    a.name, a.kind, a.roundabout_tag,
    greatest(e.width, e.width_end) / 2 + abs(e.roadway_offset) AS half,
    CASE WHEN e.lanes_both > 0 OR e.lanes_forward > 0 AND e.lanes_backward > 0 THEN 0
        WHEN e.lanes_forward > 0 THEN 1 WHEN e.lanes_backward > 0 THEN -1 ELSE 0 END AS way
FROM :"model".edge e JOIN :"model".axis a USING (axis_id);
CREATE INDEX ON street USING gist (geom);
CREATE INDEX ON street (edge_id);
CREATE TEMPORARY TABLE at_node AS
SELECT node_id, edge_id, level, starts,
    ST_Azimuth(ST_StartPoint(away), ST_LineInterpolatePoint(away, least(1, 10 / ST_Length(away)))) AS azimuth
FROM street, LATERAL (VALUES (from_node, true, geom), (to_node, false, ST_Reverse(geom))) n(node_id, starts, away);
CREATE INDEX ON at_node (node_id);
CREATE TEMPORARY TABLE junction AS SELECT node_id FROM at_node GROUP BY node_id HAVING count(*) > 2;
CREATE TEMPORARY TABLE surface AS
SELECT level, surface, edge_id, NULL::bigint AS node_id FROM :"model".section WHERE NOT ST_IsEmpty(surface)
UNION ALL SELECT level, surface, NULL, node_id FROM :"model".intersection WHERE NOT ST_IsEmpty(surface);
CREATE INDEX ON surface USING gist (surface);
CREATE INDEX ON surface (node_id);
CREATE INDEX ON surface (edge_id);
ANALYZE street, at_node, junction, surface;
CREATE FUNCTION pg_temp.paved(ground geometry, on_level integer) RETURNS float8 LANGUAGE sql AS $$
    SELECT coalesce(ST_Area(ST_Intersection(ground, ST_Union(s.surface, 1e-5))), 0)
    FROM surface s WHERE s.level = on_level AND s.surface && ground $$;

CREATE TEMPORARY TABLE face AS
SELECT row_number() OVER () AS face_id, level, geom
FROM (SELECT level, (ST_Dump(ST_Polygonize(geom))).geom FROM street GROUP BY level) f;

-- The middle of two carriageways that cross two others is roadway: a face of four edges of two streets, round which
-- traffic runs.
CREATE TEMPORARY TABLE side AS
SELECT face_id, s.name, s.roundabout_tag IS NOT NULL AS on_ring, s.way * sign(mod((
    ST_LineLocatePoint(rim, ST_LineInterpolatePoint(s.geom, 0.55))
    - ST_LineLocatePoint(rim, ST_LineInterpolatePoint(s.geom, 0.45)) + 1.5)::numeric, 1) - 0.5) AS round
FROM face f, LATERAL (SELECT ST_ExteriorRing(ST_ForcePolygonCCW(geom)) AS rim) r
    JOIN street s ON s.geom && rim AND ST_CoveredBy(s.geom, ST_Buffer(rim, 0.01))
WHERE s.level = f.level AND ST_Area(f.geom) BETWEEN 20 AND 900;
CREATE TEMPORARY TABLE middle AS
SELECT f.* FROM face f JOIN (
    SELECT face_id FROM (SELECT *, count(*) OVER (PARTITION BY face_id, name) AS of_name FROM side) s GROUP BY face_id
    HAVING count(name) = 4 AND abs(sum(round)) = 4 AND bool_and(of_name = 2) AND NOT bool_or(on_ring)) m
    USING (face_id);
INSERT INTO place SELECT 'middles of crossing carriageways with an island', face_id, rest, geom
FROM (SELECT *, ST_Area(geom) - pg_temp.paved(geom, level) AS rest FROM middle) m WHERE rest > 2;

-- Blocks: faces of streets, but those middles, where a disc has room that is 2 m wider than they are. Its middle is
-- no roadway.
CREATE TEMPORARY TABLE block AS
SELECT face_id, level, geom, disc.center AS middle
FROM face f, LATERAL (SELECT (ST_MaximumInscribedCircle(geom)).*) disc,
    LATERAL (SELECT max(half) AS half FROM street s
        WHERE s.level = f.level AND s.geom && f.geom AND ST_DWithin(s.geom, f.geom, 0.01)) w
WHERE ST_Area(geom) BETWEEN 100 AND 100000 AND disc.radius > half + 2
    AND face_id NOT IN (SELECT face_id FROM middle);
INSERT INTO place SELECT 'blocks paved', face_id, ST_Area(geom), middle FROM block b
WHERE EXISTS (SELECT FROM surface s WHERE s.level = b.level AND ST_Intersects(s.surface, middle))
    AND NOT EXISTS (SELECT FROM street s
        WHERE s.level = b.level AND s.geom && ST_Expand(middle, 30) AND ST_DWithin(s.geom, middle, s.half + 1.5));

-- Islands: ground of faces under 1,000 m2, but those middles, that flat buffers of the streets leave.
CREATE TEMPORARY TABLE island AS
SELECT face_id, level, ground
FROM face f, LATERAL (SELECT (ST_Dump(ST_Difference(geom, (
    SELECT ST_Union(ST_Buffer(s.geom, half + 0.01, 'endcap=flat')) FROM street s
    WHERE s.level = f.level AND s.geom && ST_Expand(f.geom, 30) AND ST_DWithin(s.geom, f.geom, half))))).geom
    AS ground) g
WHERE ST_Area(geom) BETWEEN 4 AND 1000 AND ST_Area(ground) >= 4 AND (ST_MaximumInscribedCircle(ground)).radius >= 0.75
    AND face_id NOT IN (SELECT face_id FROM middle);
INSERT INTO place SELECT 'islands under 85 % of their ground', face_id, 1 - share, ground
FROM (SELECT *, 1 - pg_temp.paved(ground, level) / ST_Area(ground) AS share FROM island) i WHERE share < 0.85;
INSERT INTO place SELECT 'islands under half of it', id, value, geom FROM place
WHERE figure = 'islands under 85 % of their ground' AND value > 0.5;

-- Limits, along their street from the node.
INSERT INTO place SELECT 'nodes with a limit over 30 m away', node_id, max(away), ST_Collect(place)
FROM (SELECT n.node_id, ST_LineInterpolatePoint(s.geom, greatest(0, least(1, wanted_abscissa / size))) AS place,
        CASE which WHEN 'start' THEN wanted_abscissa ELSE size - wanted_abscissa END AS away
    FROM :"model".section_limit l JOIN street s USING (edge_id), LATERAL (SELECT ST_Length(s.geom) AS size) z,
        LATERAL (SELECT CASE which WHEN 'start' THEN from_node ELSE to_node END AS node_id) n) l
JOIN junction USING (node_id) WHERE away > 30 GROUP BY node_id;

-- Arcs over half a metre of which less than half lies on the outline of the roadway.
CREATE TEMPORARY TABLE arc AS
SELECT corner_id, level, ST_CurveToLine(arc) AS geom FROM :"model".corner JOIN :"model".intersection USING (node_id)
WHERE arc IS NOT NULL AND ST_Length(arc) > 0.5;
CREATE TEMPORARY TABLE outline_part AS
SELECT level, ST_Subdivide(ST_Boundary(ST_Union(surface, 1e-5)), 100) AS geom FROM surface GROUP BY level;
CREATE INDEX ON outline_part USING gist (geom);
ANALYZE outline_part;
INSERT INTO place SELECT 'arcs off kerb', corner_id, 1 - share, geom
FROM arc a, LATERAL (SELECT coalesce(ST_Length(ST_Intersection(a.geom, (SELECT ST_Buffer(ST_Collect(o.geom), 0.1)
    FROM outline_part o WHERE o.level = a.level AND o.geom && ST_Expand(a.geom, 0.2)))), 0)
    / ST_Length(a.geom) AS share) s
WHERE share < 0.5;

-- Paths: the least radius of circles through three of five places that part a path in four.
CREATE TEMPORARY TABLE path AS
SELECT interconnection_id, c.node_id, c.turn, ST_Force2D(c.geom) AS geom, ST_Length(c.geom) AS size,
    i.edge_id AS edge_in, o.edge_id AS edge_out,
    a.kind ~ 'service' OR b.kind ~ 'service' OR a.half < 2 AND b.half < 2 AS apart
FROM :"model".interconnection c JOIN :"model".lane i ON i.lane_id = lane_in JOIN :"model".lane o ON o.lane_id = lane_out
    JOIN street a ON a.edge_id = i.edge_id JOIN street b ON b.edge_id = o.edge_id
WHERE c.plausible AND c.turn <> 'u_turn' AND ST_Length(c.geom) > 0.3;
CREATE FUNCTION pg_temp.turned(before float8, after float8) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT abs(degrees(after - before) - 360 * round(degrees(after - before) / 360)) $$;
CREATE FUNCTION pg_temp.radius(a geometry, b geometry, c geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT ST_Distance(a, b) * ST_Distance(b, c) * ST_Distance(a, c)
        / nullif(4 * ST_Area(ST_MakePolygon(ST_MakeLine(ARRAY[a, b, c, a]))), 0) $$;
CREATE TEMPORARY TABLE turn AS
SELECT path.*, (SELECT min(pg_temp.radius(ST_LineInterpolatePoint(geom, k / 4.0),
        ST_LineInterpolatePoint(geom, (k + 1) / 4.0), ST_LineInterpolatePoint(geom, (k + 2) / 4.0)))
    FROM generate_series(0, 2) k) AS radius
FROM path, LATERAL (SELECT least(1, 0.5 / size) AS share) s
WHERE pg_temp.turned(ST_Azimuth(ST_StartPoint(geom), ST_LineInterpolatePoint(geom, share)),
    ST_Azimuth(ST_LineInterpolatePoint(geom, 1 - share), ST_EndPoint(geom))) > 20;
INSERT INTO place SELECT 'turns under 3 m', interconnection_id, radius, geom FROM turn WHERE radius < 3;
INSERT INTO place SELECT 'turns under 2 m, aisles and drives apart', interconnection_id, radius, geom
FROM turn WHERE radius < 2 AND NOT apart;
INSERT INTO place SELECT 'paths that cross themselves', interconnection_id, size, geom
FROM path WHERE NOT ST_IsSimple(geom);
INSERT INTO place SELECT 'paths that turn by over 45 degrees at a vertex', interconnection_id, max(turned),
    (array_agg(p ORDER BY turned DESC))[1]
FROM (SELECT interconnection_id, p,
        pg_temp.turned(ST_Azimuth(lag(p) OVER along, p), ST_Azimuth(p, lead(p) OVER along)) AS turned
    FROM (SELECT interconnection_id, (d).path[1] AS i, (d).geom AS p
        FROM path, LATERAL ST_DumpPoints(ST_RemoveRepeatedPoints(geom, 0.05)) d) v
    WINDOW along AS (PARTITION BY interconnection_id ORDER BY i)) t
WHERE turned > 45 GROUP BY interconnection_id;
CREATE TEMPORARY TABLE off_own AS
SELECT interconnection_id, ST_Length(rest) AS metres, rest
FROM path p, LATERAL (SELECT ST_Difference(p.geom, ST_Buffer(ST_Union(surface), 0.1)) AS rest
    FROM (SELECT surface FROM surface s WHERE s.node_id = p.node_id
        UNION ALL SELECT surface FROM surface s WHERE s.edge_id IN (p.edge_in, p.edge_out)) s) r;
INSERT INTO place SELECT 'metres of paths off their own surfaces', interconnection_id, metres, rest
FROM off_own WHERE metres > 0.01;

-- Junctions of several nodes: of two one-way arms side by side that lead in and out, both names are known and differ.
CREATE TEMPORARY TABLE compound AS
SELECT junction_id FROM :"model".junction JOIN :"model".junction_node USING (junction_id)
WHERE kind <> 'roundabout' GROUP BY junction_id HAVING count(*) > 1;
CREATE TEMPORARY TABLE arm AS
SELECT junction_id, n.node_id, edge_id, s.name, azimuth, (s.way = 1) = starts AS leaves
FROM compound JOIN :"model".junction_node n USING (junction_id) JOIN at_node USING (node_id)
    JOIN street s USING (edge_id)
WHERE s.way <> 0 AND NOT EXISTS (SELECT FROM :"model".junction_edge e WHERE e.edge_id = at_node.edge_id);
INSERT INTO place SELECT DISTINCT ON (junction_id) 'carriageways of one junction that bear two names', junction_id,
    pg_temp.turned(a.azimuth, b.azimuth), ST_Collect(p.geom, q.geom)
FROM arm a JOIN arm b USING (junction_id) JOIN street p ON p.edge_id = a.edge_id JOIN street q ON q.edge_id = b.edge_id
WHERE a.leaves AND NOT b.leaves AND a.node_id <> b.node_id AND a.name <> b.name
    AND pg_temp.turned(a.azimuth, b.azimuth) < 20
    -- No other pair of the junction is that of the one or the other street.
    AND NOT EXISTS (SELECT FROM arm c WHERE c.junction_id = a.junction_id AND c.edge_id NOT IN (a.edge_id, b.edge_id)
        AND (c.name = a.name AND NOT c.leaves AND pg_temp.turned(a.azimuth, c.azimuth) < 20
            OR c.name = b.name AND c.leaves AND pg_temp.turned(b.azimuth, c.azimuth) < 20))
ORDER BY junction_id;

-- Roundabouts: one width along a ring; who enters waits at a yield line beside it, unless signals say when.
CREATE TEMPORARY TABLE ring AS
SELECT roundabout_id, max(greatest(s.width, s.width_end)) - min(least(s.width, s.width_end)) AS off,
    ST_Collect(s.geom) AS geom
FROM :"model".roundabout r JOIN :"model".roundabout_edge e USING (roundabout_id) JOIN street s ON s.edge_id = e.edge_id
WHERE accepted GROUP BY roundabout_id;
INSERT INTO place SELECT 'rings whose width varies by over 0.1 m', roundabout_id, off, geom FROM ring WHERE off > 0.1;
CREATE TEMPORARY TABLE entry AS
SELECT DISTINCT roundabout_id, a.edge_id, a.node_id, s.geom
FROM :"model".roundabout_arm a JOIN ring USING (roundabout_id) JOIN street s ON s.edge_id = a.edge_id
    JOIN :"model".lane l ON l.edge_id = a.edge_id
WHERE l.kind = 'general' AND (l.both_ways OR l.along_axis = (s.to_node = a.node_id))
    AND NOT EXISTS (SELECT FROM :"model".marking m JOIN :"model".control_point c ON ST_DWithin(c.geom, m.geom, 30)
        WHERE (m.edge_id, m.node_id, m.kind, c.kind) = (a.edge_id, a.node_id, 'stop', 'signals'));
INSERT INTO place SELECT 'entries of rings without a yield line within 6 m', roundabout_id, edge_id, geom FROM entry e
WHERE NOT EXISTS (SELECT FROM :"model".marking m
    WHERE m.edge_id = e.edge_id AND m.node_id = e.node_id AND m.kind = 'yield'
    AND EXISTS (SELECT FROM :"model".roundabout_edge r JOIN street s ON s.edge_id = r.edge_id
        WHERE r.roundabout_id = e.roundabout_id AND ST_Distance(m.geom, s.geom) < s.half + 6));

SELECT :'model' AS model, figure, round(found::numeric, 1) AS found, round(of::numeric) AS of,
    round((100 * found / nullif(of, 0))::numeric, 3) AS "%", bar
FROM (VALUES (1, 'blocks paved', (SELECT count(*)::float8 FROM block), '0'),
    (2, 'islands under half of it', (SELECT count(*) FROM island), '0.1 of 100 junctions'),
    (3, 'islands under 85 % of their ground', (SELECT count(*) FROM island), '1 %'),
    (4, 'middles of crossing carriageways with an island', (SELECT count(*) FROM middle), '0'),
    (5, 'nodes with a limit over 30 m away', (SELECT count(*) FROM junction), '0.3 %'),
    (6, 'arcs off kerb', (SELECT count(*) FROM arc), '0'),
    (7, 'turns under 3 m', (SELECT count(*) FROM turn), '1 %'),
    (8, 'turns under 2 m, aisles and drives apart', (SELECT count(*) FROM turn), '0'),
    (9, 'paths that cross themselves', (SELECT count(*) FROM path), '0'),
    (10, 'paths that turn by over 45 degrees at a vertex', (SELECT count(*) FROM path), '0'),
    (11, 'metres of paths off their own surfaces', (SELECT sum(size) FROM path), '0.05 %'),
    (12, 'carriageways of one junction that bear two names', (SELECT count(*) FROM compound), '0'),
    (13, 'rings whose width varies by over 0.1 m', (SELECT count(*) FROM ring), '0'),
    (14, 'entries of rings without a yield line within 6 m', (SELECT count(*) FROM entry), '2 %')
    ) f(row, figure, of, bar),
    LATERAL (SELECT CASE WHEN f.figure ~ '^metres' THEN coalesce(sum(value), 0) ELSE count(*) END AS found
        FROM place p WHERE p.figure = f.figure) p
ORDER BY row;
