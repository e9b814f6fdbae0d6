-- A polyline and the road of straight pieces and tangent arcs: figure 6 of Wilkie, Sewall and Lin.
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 60 0, 84 40, 130 34, 168 62)'::geometry AS line), arc AS (SELECT a.* FROM given, streetgen.arc_road_arcs(line, 34) a)
SELECT ST_MakeLine(ARRAY[ST_Translate(centre, radius * start_direction[1], radius * start_direction[2]), centre,
    ST_LineInterpolatePoint(streetgen.arc_road_line(streetgen.arc_road(line, 34), 0.001), end_abscissa / streetgen.arc_road_length(streetgen.arc_road(line, 34)))]), 'helper', NULL FROM arc, given
UNION ALL SELECT line, 'axis', NULL FROM given
UNION ALL SELECT streetgen.arc_road(line, 34), 'result', NULL FROM given
UNION ALL SELECT centre, 'point', 'r ' || round(radius::numeric, 1) FROM arc
UNION ALL SELECT p.geom, 'point', 'p' || p.path[1] FROM given, ST_DumpPoints(line) p
