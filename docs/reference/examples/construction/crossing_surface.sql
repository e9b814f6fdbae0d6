-- argument kerb_left: kerb on the left of the axis: LINESTRING, CIRCULARSTRING or COMPOUNDCURVE, metres, in either direction
-- argument kerb_right: kerb on its right, likewise
-- argument abscissa: middle of the crossing, metres along the axis
-- argument width: width between the parallel borders of the crossing, metres
-- argument angle: degrees counter-clockwise from the direction of the axis to the way across; 90 is square
-- see offset_strip, border_line
SELECT round(ST_Area(streetgen.crossing_surface('LINESTRING(0 0, 40 0)', 'LINESTRING(0 4, 40 4)', 'LINESTRING(0 -4, 40 -4)', 20, 3, 30))::numeric, 2) AS m2;
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 40 0)'::geometry AS axis, 'COMPOUNDCURVE((0 4, 18 4), CIRCULARSTRING(18 4, 25.071 6.929, 28 14))'::geometry AS kerb_left,
    'LINESTRING(0 -4, 40 -4)'::geometry AS kerb_right)
SELECT streetgen.crossing_surface(axis, kerb_left, kerb_right, 16, 4, 60), 'result', NULL FROM given
UNION ALL SELECT axis, 'axis', 'axis' FROM given
UNION ALL SELECT ST_CurveToLine(kerb_left), 'kerb', 'kerb_left' FROM given
UNION ALL SELECT kerb_right, 'kerb', 'kerb_right' FROM given
