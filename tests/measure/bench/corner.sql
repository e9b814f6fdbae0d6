-- 2,000 pairs of streets, and the centre of their arc as the papers' query finds it: where the borders of two buffers meet.
CREATE TABLE bench.pair AS
SELECT ST_MakeLine(ARRAY[ST_Point(0, 0), ST_Point(40, i % 7), ST_Point(80, i % 5)]) AS a,
       ST_MakeLine(ARRAY[ST_Point(0, 0), ST_Point(i % 30, 40), ST_Point(i % 20, 80)]) AS b, 6 + i % 5 AS width_a, 6 + i % 3 AS width_b, 3 + i % 4 AS radius
FROM generate_series(1, 2000) i;

CREATE FUNCTION bench.centre_by_buffers(a geometry, b geometry, width_a float8, width_b float8, radius float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS $$
    SELECT d.geom FROM ST_Dump(ST_Intersection(ST_Boundary(ST_Buffer(a, width_a / 2.0 + radius, 16)), ST_Boundary(ST_Buffer(b, width_b / 2.0 + radius, 16)))) d
    ORDER BY ST_Distance(d.geom, ST_Point(10, 10)) LIMIT 1
$$;
