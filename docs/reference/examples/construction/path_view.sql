-- argument path: LINESTRING in metres, such as interconnection.geom
-- argument heading_from: direction of the lane where the path begins, radians
-- argument heading_to: direction of the lane where it ends, radians
-- argument lane_width: metres; arcs are wider than half of it
-- argument tolerance: metres by which the curve may leave the path
-- see plan_view, export_opendrive
SELECT round(s::numeric, 1) AS s, round(length::numeric, 1) AS length,
    round(abs(1 / nullif(curvature, 0))::numeric) AS radius
FROM streetgen.path_view('LINESTRING(0 0, 3.83 0.76, 7.07 2.93, 9.24 6.17, 10 10, 10 14)', 0, pi() / 2);
