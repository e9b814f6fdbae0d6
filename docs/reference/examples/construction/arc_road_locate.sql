-- argument point: POINT, metres
-- see arc_road_point, arc_road_distance
SELECT metres, axis_offset, distance FROM streetgen.arc_road_locate(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'), 'POINT(20 5)');
