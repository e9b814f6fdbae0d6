-- Figure 22: a crossing between two kerbs at 60 degrees, on a bend.
-- drawing
WITH street AS (SELECT streetgen.offset_line(axis, 4) AS kerb_left, streetgen.offset_line(axis, -4) AS kerb_right, axis FROM (
    SELECT 'SRID=32631;LINESTRING(0 0, 8 4, 17 6.5, 26 7.5, 36 7)'::geometry AS axis) a)
SELECT ST_MakePolygon(ST_AddPoint(ST_MakeLine(kerb_left, ST_Reverse(kerb_right)), ST_StartPoint(kerb_left))), 'section', NULL FROM street
UNION ALL SELECT axis, 'axis', NULL FROM street
UNION ALL SELECT streetgen.crossing_surface(axis, kerb_left, kerb_right, 12, 4, 60), 'result', NULL FROM street
UNION ALL SELECT streetgen.crossing_surface(axis, kerb_left, kerb_right, 27, 4), 'result', NULL FROM street
UNION ALL SELECT kerb_left, 'kerb', NULL FROM street UNION ALL SELECT kerb_right, 'kerb', NULL FROM street
UNION ALL SELECT ST_LineInterpolatePoint(axis, (12 + d) / ST_Length(axis)), 'point', NULL FROM street, unnest('{-2,2}'::float8[]) d
