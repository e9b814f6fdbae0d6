-- The papers' method in plain SQL and PostGIS, as good as it gets without an extension: surfaces only, from the network of model `timed`.
-- Of two neighbours at a node the borders of their buffers meet in the centre of the arc; limits are the centre's feet on the axes;
-- a section is the buffer of an axis between its limits, an intersection what kerbs and border lines enclose around a node.
DROP SCHEMA IF EXISTS plain CASCADE;
CREATE SCHEMA plain;

-- The ends of edges at their nodes, counter-clockwise: the line outwards, as far as arcs may lie.
CREATE TABLE plain.arm AS
WITH edge AS MATERIALIZED (SELECT e.edge_id, e.from_node, e.to_node, e.geom, ST_Length(e.geom) AS total, e.width / 2 AS half, u.radius FROM timed.edge e JOIN timed.axis_used u USING (axis_id)),
line AS (
    SELECT edge_id, total, half, radius, from_node AS node_id, true AS is_start, CASE WHEN total > 70 THEN ST_LineSubstring(geom, 0, 70 / total) ELSE geom END AS line FROM edge
    UNION ALL SELECT edge_id, total, half, radius, to_node, false, ST_Reverse(CASE WHEN total > 70 THEN ST_LineSubstring(geom, 1 - 70 / total, 1) ELSE geom END) FROM edge)
SELECT *, row_number() OVER (PARTITION BY node_id ORDER BY azimuth DESC, edge_id) AS place, count(*) OVER (PARTITION BY node_id) AS degree
FROM (SELECT *, ST_Length(line) AS length, ST_Azimuth(ST_StartPoint(line), ST_LineInterpolatePoint(line, least(1, 1 / total))) AS azimuth FROM line) l;
ANALYZE plain.arm;

CREATE TABLE plain.corner AS
SELECT node_id, place, degree, edge_a, start_a, half_a, edge_b, start_b, half_b, centre, radius,
       ST_LineLocatePoint(line_a, centre) * length_a AS along_a, ST_LineLocatePoint(line_b, centre) * length_b AS along_b,
       ST_Azimuth(centre, ST_ClosestPoint(line_a, centre)) AS from_azimuth, ST_Azimuth(centre, ST_ClosestPoint(line_b, centre)) AS to_azimuth
FROM (
    SELECT a.node_id, a.place, a.degree, a.edge_id AS edge_a, a.is_start AS start_a, a.half AS half_a, a.line AS line_a, a.length AS length_a, a.azimuth AS azimuth_a,
           b.edge_id AS edge_b, b.is_start AS start_b, b.half AS half_b, b.line AS line_b, b.length AS length_b, least(a.radius, b.radius) AS radius,
           CASE WHEN a.azimuth > b.azimuth THEN a.azimuth - b.azimuth ELSE a.azimuth - b.azimuth + 2 * pi() END AS angle
    FROM plain.arm a JOIN plain.arm b ON b.node_id = a.node_id AND b.place = a.place % a.degree + 1) p
LEFT JOIN LATERAL (
    SELECT d.geom AS centre
    FROM ST_Dump(ST_Intersection(ST_Boundary(ST_Buffer(line_a, half_a + radius, 'endcap=flat')), ST_Boundary(ST_Buffer(line_b, half_b + radius, 'endcap=flat')))) d,
         ST_Azimuth(ST_StartPoint(line_a), d.geom) azimuth
    WHERE ST_Dimension(d.geom) = 0 AND ST_DWithin(d.geom, ST_StartPoint(line_a), 60) AND CASE WHEN azimuth_a > azimuth THEN azimuth_a - azimuth ELSE azimuth_a - azimuth + 2 * pi() END < angle
    ORDER BY ST_Distance(d.geom, ST_StartPoint(line_a)) LIMIT 1) c ON degree > 1 AND angle < radians(175);
ANALYZE plain.corner;

-- Limits: the farther of the feet at both sides. Where those of an edge cross, it has no section and intersections overlap.
CREATE TABLE plain.section_limit AS
WITH wanted AS (
    SELECT edge_id, is_start, max(along) AS abscissa FROM (SELECT edge_a AS edge_id, start_a AS is_start, along_a AS along FROM plain.corner UNION ALL SELECT edge_b, start_b, along_b FROM plain.corner) e
    GROUP BY edge_id, is_start)
SELECT node_id, place, edge_id, is_start, line, length, half, total, abscissa, ST_Point(x - half * cos(ahead), y + half * sin(ahead), ST_SRID(line)) AS left_end, ST_Point(x + half * cos(ahead), y - half * sin(ahead), ST_SRID(line)) AS right_end
FROM (SELECT a.*, least(coalesce(w.abscissa, 0), a.length) AS abscissa FROM plain.arm a LEFT JOIN wanted w USING (edge_id, is_start)) u,
    LATERAL (SELECT ST_LineInterpolatePoint(line, abscissa / length) AS point, ST_Azimuth(ST_LineInterpolatePoint(line, greatest(0, abscissa - 0.1) / length), ST_LineInterpolatePoint(line, least(length, abscissa + 0.1) / length)) AS ahead) p,
    LATERAL (SELECT ST_X(point) AS x, ST_Y(point) AS y) c;
ANALYZE plain.section_limit;

CREATE TABLE plain.section AS
SELECT e.edge_id, ST_Buffer(ST_LineSubstring(e.geom, s.abscissa / s.total, 1 - t.abscissa / t.total), s.half, 'endcap=flat') AS surface
FROM timed.edge e JOIN plain.section_limit s ON s.edge_id = e.edge_id AND s.is_start JOIN plain.section_limit t ON t.edge_id = e.edge_id AND NOT t.is_start
WHERE s.abscissa + t.abscissa < s.total - 0.01;

-- From the left end of a border line along the kerb, the arc and the kerb to the right end of the next one.
CREATE TABLE plain.intersection AS
WITH kerb AS (
    SELECT a.node_id, a.left_end, a.right_end,
           CASE WHEN centre IS NULL THEN ST_MakeLine(a.left_end, b.right_end)
                ELSE ST_MakeLine(ARRAY[a.left_end, CASE WHEN ST_NPoints(piece_a) > 2 THEN ST_Reverse(ST_OffsetCurve(piece_a, half_a)) END, arc, CASE WHEN ST_NPoints(piece_b) > 2 THEN ST_OffsetCurve(piece_b, -half_b) END, b.right_end]) END AS kerb
    FROM plain.corner c JOIN plain.section_limit a ON (a.edge_id, a.is_start) = (c.edge_a, c.start_a) JOIN plain.section_limit b ON (b.edge_id, b.is_start) = (c.edge_b, c.start_b),
        LATERAL (SELECT CASE WHEN a.abscissa > along_a THEN ST_LineSubstring(a.line, along_a / a.length, a.abscissa / a.length) END AS piece_a,
                        CASE WHEN b.abscissa > along_b THEN ST_LineSubstring(b.line, along_b / b.length, b.abscissa / b.length) END AS piece_b,
                        ST_X(centre) AS x, ST_Y(centre) AS y, CASE WHEN to_azimuth - from_azimuth > pi() THEN to_azimuth - from_azimuth - 2 * pi() WHEN to_azimuth - from_azimuth < -pi() THEN to_azimuth - from_azimuth + 2 * pi() ELSE to_azimuth - from_azimuth END AS turn) l,
        LATERAL (SELECT ST_MakeLine(ARRAY(SELECT ST_Point(x + radius * sin(from_azimuth + turn * i / 8), y + radius * cos(from_azimuth + turn * i / 8), ST_SRID(a.line)) FROM generate_series(0, 8) i)) AS arc) k
    WHERE degree > 1)
SELECT node_id, ST_BuildArea(ST_UnaryUnion(ST_Collect(ARRAY[ST_Collect(kerb), ST_Collect(ST_MakeLine(left_end, right_end))]))) AS surface FROM kerb GROUP BY node_id;
SELECT count(*) AS rows FROM plain.intersection \gset
