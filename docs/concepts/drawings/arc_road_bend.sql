-- What defines the arc of a bend: figure 7 of Wilkie, Sewall and Lin.
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 100 0, 150 70)'::geometry AS line), arc AS (SELECT a.*, line, streetgen.arc_road(line, 60) AS road FROM given, streetgen.arc_road_arcs(line, 60) a),
ends AS (SELECT *, ST_Translate(centre, radius * start_direction[1], radius * start_direction[2]) AS first, ST_LineInterpolatePoint(streetgen.arc_road_line(road, 0.001), end_abscissa / streetgen.arc_road_length(road)) AS last FROM arc)
SELECT line, 'axis', NULL FROM given
UNION ALL SELECT ST_MakeLine(centre, first), 'helper', 'r, to s' FROM ends
UNION ALL SELECT ST_MakeLine(centre, last), 'helper', 'r' FROM ends
UNION ALL SELECT ST_MakeLine(centre, ST_PointN(line, 2)), 'helper', NULL FROM ends
UNION ALL SELECT road, 'result', NULL FROM arc
UNION ALL SELECT ST_MakeLine(ST_Point(8, 0), ST_Point(26, 0)), 'kerb', 'n₁' FROM given
UNION ALL SELECT ST_MakeLine(ST_PointN(line, 3), ST_Translate(ST_PointN(line, 3), -10.46, -14.65)), 'kerb', 'n₂' FROM given
UNION ALL SELECT ST_MakeLine(first, ST_PointN(line, 2)), 'helper', 'α' FROM ends
UNION ALL SELECT first, 'point', NULL FROM ends
UNION ALL SELECT last, 'point', NULL FROM ends
UNION ALL SELECT ST_PointN(line, 2), 'point', 'p' FROM given
UNION ALL SELECT centre, 'point', 'c, θ' FROM arc
