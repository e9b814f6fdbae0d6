-- see corner_arc, turning_radius
SELECT length, round(streetgen.max_corner_radius(ST_MakeLine('POINT(0 0)', ST_MakePoint(length, 0)), 'LINESTRING(0 0, 0 60)', 8, 6)::numeric, 2) AS radius
FROM unnest(ARRAY[2, 10, 20]) length;
