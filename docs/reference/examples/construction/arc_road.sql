-- argument line: LINESTRING, metres
-- argument cap: greatest radius, metres
-- argument shift: how far the road may leave a point of the line, metres; NULL: as far as it likes
-- argument radii: a radius for each point of the line, metres, or NULL; comes before cap and shift; NULL: none
-- see arc_road_arcs, arc_road_line, arc_road_offset
SELECT ST_AsText(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'), 3);
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 60 0, 80 40, 140 40)'::geometry AS line)
SELECT line, 'axis', 'line' FROM given
UNION ALL SELECT streetgen.arc_road(line), 'result', 'road' FROM given
UNION ALL SELECT streetgen.arc_road(line, shift => 2), 'helper', NULL FROM given
