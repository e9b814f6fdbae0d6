-- argument metres: metres along the road; clamped to it
-- argument wheelbase: distance of the axles of the car that steers, metres
-- see arc_road_locate
SELECT metres, ST_AsText(geom, 2) AS geom, round(heading::numeric, 2) AS heading, round(curvature::numeric, 5) AS curvature, round(steering_angle::numeric, 2) AS steering_angle
FROM streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)') road, generate_series(0, 120, 40) metres, streetgen.arc_road_point(road, metres);
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 80 40, 140 40)', 30) AS road), car AS (SELECT p.* FROM given, generate_series(20, 120, 20) m, streetgen.arc_road_point(road, m) p)
SELECT road, 'axis', NULL FROM given
UNION ALL SELECT ST_MakeLine(geom, ST_Translate(geom, 10 * forward[1], 10 * forward[2])), 'result', NULL FROM car
UNION ALL SELECT geom, 'point', NULL FROM car
