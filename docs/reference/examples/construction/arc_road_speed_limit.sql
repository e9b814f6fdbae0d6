-- argument radius: radius of the arc, metres
-- argument friction: static friction of tyre and road
-- argument superelevation: rise / run across the road, positive where it leans into the bend
-- argument safety: share of the speed that is allowed
-- see arc_road_speed_profile
SELECT radius, round(streetgen.arc_road_speed_limit(radius)::numeric, 1) AS level, round(streetgen.arc_road_speed_limit(radius, 0.7, 0.06, 0.8)::numeric, 1) AS banked
FROM unnest(ARRAY[5, 30, 100]) radius;
