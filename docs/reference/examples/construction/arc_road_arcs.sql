-- argument line: LINESTRING, metres
-- argument cap: greatest radius, metres
-- argument shift: how far the road may leave a point of the line, metres; NULL: as far as it likes
-- argument radii: a radius for each point of the line, metres, or NULL; comes before cap and shift; NULL: none
-- see arc_road
SELECT vertex, ST_AsText(centre, 2) AS centre, round(radius::numeric, 2) AS radius, round(angle::numeric, 2) AS angle,
    round(start_abscissa::numeric, 2) AS start_abscissa, round(end_abscissa::numeric, 2) AS end_abscissa, orientation
FROM streetgen.arc_road_arcs('LINESTRING(0 0, 60 0, 80 40, 140 40)', 30);
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 60 0, 80 40, 140 40)'::geometry AS line), arc AS (SELECT a.* FROM given, streetgen.arc_road_arcs(line, 30) a)
SELECT streetgen.arc_road(line, 30), 'result', NULL FROM given
UNION ALL SELECT ST_MakeLine(centre, ST_Translate(centre, radius * start_direction[1], radius * start_direction[2])), 'helper', 'radius' FROM arc
UNION ALL SELECT centre, 'point', 'centre' FROM arc
