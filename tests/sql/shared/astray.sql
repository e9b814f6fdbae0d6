-- Where the objects of model town are to stand, in plain SQL.

-- How far an object is from the place that arc length and normal give; where its abscissa is that of a bend, nobody says which normal.
CREATE FUNCTION test.astray() RETURNS TABLE (street_object_id bigint, metres float8) LANGUAGE sql AS $$
  WITH piece AS (SELECT axis_id, s.path[1] AS n, ST_StartPoint(s.geom) AS a, ST_EndPoint(s.geom) AS b, ST_Length(s.geom) AS size FROM town.axis, ST_DumpSegments(geom) s),
  placed AS (SELECT *, sum(size) OVER (PARTITION BY axis_id ORDER BY n) - size AS start FROM piece)
  SELECT o.street_object_id, ST_Distance(o.geom, ST_SetSRID(ST_MakePoint(ST_X(a) + dx * (o.abscissa - start) - dy * off, ST_Y(a) + dy * (o.abscissa - start) + dx * off), 2154))
  FROM town.street_object o JOIN placed p ON p.axis_id = o.axis_id AND o.abscissa > p.start + 1e-6 AND o.abscissa < p.start + p.size - 1e-6 JOIN town.axis x ON x.axis_id = o.axis_id
    CROSS JOIN LATERAL (SELECT (ST_X(b) - ST_X(a)) / size AS dx, (ST_Y(b) - ST_Y(a)) / size AS dy, CASE o.side WHEN 'left' THEN o.axis_offset + x.width / 2 WHEN 'right' THEN -o.axis_offset - x.width / 2 ELSE o.axis_offset END AS off) d
  WHERE o.method = 'relative' $$;
