\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- A ring of few points that its source calls a roundabout is a circle.  (name, holds)
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('anew', 2154, driving_side => 'right'); END $$;
-- A corner of a regular polygon about a place near (650000, 6860000).
CREATE FUNCTION corner(n integer, corners integer, x float8 DEFAULT 0, radius float8 DEFAULT 20) RETURNS geometry LANGUAGE sql AS
  $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x + radius * cos(2 * pi() * n / corners), 6860000 + radius * sin(2 * pi() * n / corners)), 2154) $$;
INSERT INTO town.axis (axis_id, geom, width, lane_count, importance, direction, roundabout_tag) OVERRIDING SYSTEM VALUE
  SELECT 1, ST_MakeLine(corner(n, 10) ORDER BY n), 7, 1, 4, 'direct', 'roundabout' FROM generate_series(0, 10) n
  UNION ALL SELECT 2 + a, ST_MakeLine(corner(5 * a, 10), corner(5 * a, 10, radius => 90)), 6, 2, 4, 'both', NULL FROM generate_series(0, 1) a
  -- Ten corners, of which one lies 4 m within the circle; and a ring that nobody calls a roundabout.
  UNION ALL SELECT 11, ST_MakeLine(corner(n, 10, 200, CASE n WHEN 4 THEN 16 ELSE 20 END) ORDER BY n), 7, 1, 4, 'direct', 'roundabout' FROM generate_series(0, 10) n
  UNION ALL SELECT 12, ST_MakeLine(corner(n, 10, 400) ORDER BY n), 7, 1, 4, 'direct', NULL FROM generate_series(0, 10) n;
-- How far the lines of an axis leave a circle of 20 m at most.
CREATE FUNCTION off_circle(axis bigint) RETURNS float8 LANGUAGE sql AS
  $$ SELECT max(abs(ST_Distance(ST_LineInterpolatePoint(geom, share / 100.0), ST_SetSRID(ST_MakePoint(650000 + 200 * (axis / 11) * (axis - 10), 6860000), 2154)) - 20)) FROM town.edge, generate_series(0, 100) share WHERE axis_id = axis $$;
SELECT 'the edges of a tagged ring lie on its circle' AS name, off_circle(1) < 0.03 AS holds;
-- An oval of sixteen points, and how far it turns at most where two segments of its edges meet, degrees.
INSERT INTO town.axis (axis_id, geom, width, lane_count, importance, direction, roundabout_tag) OVERRIDING SYSTEM VALUE
  SELECT 13, ST_MakeLine(ST_SetSRID(ST_MakePoint(650600 + 30 * cos(n * pi() / 8), 6860000 + 18 * sin(n * pi() / 8)), 2154) ORDER BY n), 7, 1, 4, 'direct', 'roundabout' FROM generate_series(0, 16) n
  UNION ALL SELECT 14, ST_MakeLine(ST_SetSRID(ST_MakePoint(650600, 6860018), 2154), ST_SetSRID(ST_MakePoint(650600, 6860090), 2154)), 6, 2, 4, 'both', NULL
  UNION ALL SELECT 15, ST_MakeLine(ST_SetSRID(ST_MakePoint(650600, 6859982), 2154), ST_SetSRID(ST_MakePoint(650600, 6859910), 2154)), 6, 2, 4, 'both', NULL;
CREATE FUNCTION sharpest(axis bigint) RETURNS float8 LANGUAGE sql AS $$
  WITH place AS (SELECT edge_id, p.path[1] AS nth, p.geom FROM town.edge, ST_DumpPoints(geom) p WHERE axis_id = axis)
  SELECT max(abs(180 - degrees(ST_Angle(a.geom, b.geom, c.geom)))) FROM place a JOIN place b ON (b.edge_id, b.nth) = (a.edge_id, a.nth + 1) JOIN place c ON (c.edge_id, c.nth) = (a.edge_id, a.nth + 2) $$;
SELECT 'an oval is a smooth curve', sharpest(13) BETWEEN 1 AND 8;
SELECT 'through its points', (SELECT bool_and(EXISTS (SELECT FROM town.edge e WHERE e.axis_id = 13 AND ST_DWithin(e.geom, p.geom, 1e-6))) FROM town.axis, ST_DumpPoints(geom) p WHERE axis_id = 13);
SELECT 'also at its nodes, where a smooth kerb goes on', (SELECT abs(180 - degrees(ST_Angle(ST_LineInterpolatePoint(a.geom, 1 - 0.3 / ST_Length(a.geom)), ST_EndPoint(a.geom), ST_LineInterpolatePoint(b.geom, 0.3 / ST_Length(b.geom))))) < 8
  FROM town.edge a JOIN town.edge b ON b.axis_id = a.axis_id AND ST_DWithin(ST_EndPoint(a.geom), ST_StartPoint(b.geom), 1e-6) WHERE a.axis_id = 13 AND ST_DWithin(ST_EndPoint(a.geom), 'SRID=2154;POINT(650600 6860018)', 1e-6));
SELECT 'its roadway has one width all round', (SELECT max(ST_Distance(p.geom, 'SRID=2154;POINT(650000 6860000)')) < 16.55 AND min(ST_Distance(p.geom, 'SRID=2154;POINT(650000 6860000)')) > 16.45
  FROM (SELECT ST_Union(surface) AS ground FROM (SELECT surface FROM town.section JOIN town.edge USING (edge_id) WHERE axis_id <= 3 UNION ALL SELECT surface FROM town.intersection JOIN town.node USING (node_id) WHERE ST_X(geom) < 650100) s) u,
    LATERAL ST_DumpPoints(ST_InteriorRingN(ST_GeometryN(ground, 1), 1)) p);
SELECT 'its nodes stay', (SELECT bool_and(EXISTS (SELECT FROM town.node n WHERE ST_DWithin(n.geom, corner(k, 10), 1e-6))) FROM unnest('{0,5}'::integer[]) k);
SELECT 'one with a corner that no curve within a metre goes round keeps its points', (SELECT sum(ST_NPoints(geom)) = 11 FROM town.edge WHERE axis_id = 11);
SELECT 'and so does a ring without the word of its source', (SELECT sum(ST_NPoints(geom)) = 11 FROM town.edge WHERE axis_id = 12);
SELECT 'check_model has no error', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
UPDATE town.axis SET geom = ST_Reverse(geom), direction = 'reverse' WHERE axis_id = 1;
SELECT 'drawn backward it is the same circle', off_circle(1) < 0.03;
UPDATE town.axis SET geom = ST_SetPoint(geom, 3, ST_Translate(ST_PointN(geom, 4), 0.6, 0.3)) WHERE axis_id = 1;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, corner(0, 10, radius => 60)) WHERE axis_id = 2;
UPDATE town.axis SET geom = ST_SetPoint(geom, 6, ST_Translate(ST_PointN(geom, 7), 0.5, 0.2)) WHERE axis_id = 13;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, ST_Translate(ST_PointN(geom, 2), 3, 0)) WHERE axis_id = 14;
SELECT 'edits of rings and of arms are as from scratch', test.followed('town', 'anew');
SELECT 'a point that is off by less than a metre stays near', off_circle(1) < 1 AND (SELECT bool_or(ST_NPoints(geom) > 12) FROM town.edge WHERE axis_id = 1);
UPDATE town.axis SET roundabout_tag = NULL WHERE axis_id = 1;
SELECT 'without the word it has the points of its axis', (SELECT sum(ST_NPoints(geom)) = 12 FROM town.edge WHERE axis_id = 1);
UPDATE town.axis SET roundabout_tag = 'circular' WHERE axis_id = 1;
SELECT streetgen.set('town', 'ring_shift', '0') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'and with a shift of 0', (SELECT sum(ST_NPoints(geom)) = 12 FROM town.edge WHERE axis_id = 1);
