-- argument a: POINT by the road from which to go
-- argument b: POINT by the road to which to go
-- see arc_road_locate, arc_road_length
SELECT round(streetgen.arc_road_distance(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)'), 'POINT(20 5)', 'POINT(98 60)')::numeric, 3) AS metres;
