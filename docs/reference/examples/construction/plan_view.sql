-- argument line: LINESTRING in metres, such as an axis
-- argument tolerance: metres by which the chain may leave the line
-- see arc_road, export_opendrive
SELECT round(s::numeric, 2) AS s, round(heading::numeric, 3) AS heading, round(length::numeric, 2) AS length, round(curvature::numeric, 3) AS curvature
FROM streetgen.plan_view('LINESTRING(0 0, 30 0, 60 30)', 1);
