-- argument lane_in: lane that comes in: LINESTRING, metres, in its driving direction
-- argument lane_out: lane that goes out: LINESTRING, metres, in its driving direction
-- argument centre: POINT of the intersection; of rule control the control point
-- argument rule: bezier, arcs or control
-- argument tolerance: chords leave the curve by at most this, metres, 0.001 to 10
-- see lanes
SELECT ST_AsText(ST_SnapToGrid(streetgen.interconnection('LINESTRING(-40 -2, -10 -2)', 'LINESTRING(2 10, 2 40)', 'POINT(0 0)', tolerance => 0.5), 0.01));
-- drawing
WITH given AS (SELECT 'LINESTRING(-30 -2, -10 -2)'::geometry AS lane_in, 'LINESTRING(8 16, 14 30)'::geometry AS lane_out)
SELECT lane_in, 'axis', 'lane_in' FROM given UNION ALL SELECT lane_out, 'axis', 'lane_out' FROM given
UNION ALL SELECT 'POINT(0 0)', 'point', 'centre'
UNION ALL SELECT streetgen.interconnection(lane_in, lane_out, 'POINT(0 0)', 'arcs'), 'helper', NULL FROM given
UNION ALL SELECT streetgen.interconnection(lane_in, lane_out, 'POINT(0 0)'), 'result', 'bezier' FROM given
