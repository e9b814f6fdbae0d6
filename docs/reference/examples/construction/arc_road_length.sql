-- see arc_road_point, arc_road_distance
SELECT round(streetgen.arc_road_length(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'))::numeric, 6) AS length;
