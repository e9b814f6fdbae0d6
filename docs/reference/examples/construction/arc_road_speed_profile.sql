-- argument friction: static friction of tyre and road
-- argument superelevation: rise / run across the road, positive where it leans into each bend
-- argument safety: share of the speed that is allowed
-- see arc_road_speed_limit, arc_road_arcs
SELECT round(start_abscissa::numeric, 2) AS start_abscissa, round(end_abscissa::numeric, 2) AS end_abscissa, radius, round(speed_limit::numeric, 1) AS speed_limit
FROM streetgen.arc_road_speed_profile(streetgen.arc_road('LINESTRING(0 0, 100 0, 100 60)', 20));
