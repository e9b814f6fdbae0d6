-- argument kerb: LINESTRING, CIRCULARSTRING or COMPOUNDCURVE, metres, with the roadway on its right
-- argument width_start: width at the start of the kerb, metres
-- argument width_end: width at the end of the kerb, metres
-- see crossing_surface, offset_line
SELECT round(ST_Area(streetgen.offset_strip('LINESTRING(0 0, 10 0)', 2, 3))::numeric, 2) AS m2;
-- drawing
WITH given AS (SELECT 'COMPOUNDCURVE((0 0, 20 0), CIRCULARSTRING(20 0, 27.071 -2.929, 30 -10))'::geometry AS kerb)
SELECT streetgen.offset_strip(kerb, 2, 5), 'result', NULL FROM given
UNION ALL SELECT ST_CurveToLine(kerb), 'kerb', 'kerb' FROM given
