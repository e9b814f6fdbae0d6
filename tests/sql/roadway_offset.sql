\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- axis.roadway_offset: a roadway beside its axis is the one along its middle.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154, subjects => '{sidewalk,interconnection}') FROM unnest('{beside,middle,once}'::name[]) m;
END $$;

-- Seeded crosses: two streets that cross at an angle of 35 to 145 degrees, each 160 m long, the second one of two parts of which one runs the other way.  Their middles are lines
-- of their own that cross elsewhere, and are cut there.
DO $$
DECLARE
  n integer;
  at geometry; u float8; v float8; angle float8; turn float8; a float8; b float8; p float8; q float8; w float8; x float8;
  one geometry; two geometry; one_middle geometry; two_middle geometry; other geometry;
BEGIN
  PERFORM setseed(0.28);
  FOR n IN 1 .. 12 LOOP
    turn := random() * 2 * pi();
    angle := radians(35 + 110 * random());
    w := 5 + 9 * random(); x := 5 + 9 * random();
    p := (random() - 0.5) * w; q := (random() - 0.5) * x;
    at := ST_SetSRID(ST_Point(650000 + 400 * n, 6860000), 2154);
    u := turn; v := turn + angle;
    one := ST_SetSRID(ST_MakeLine(ST_Translate(at, -80 * cos(u), -80 * sin(u)), ST_Translate(at, 80 * cos(u), 80 * sin(u))), 2154);
    two := ST_SetSRID(ST_MakeLine(ST_Translate(at, -80 * cos(v), -80 * sin(v)), ST_Translate(at, 80 * cos(v), 80 * sin(v))), 2154);
    one_middle := ST_Translate(one, -p * sin(u), p * cos(u));
    two_middle := ST_Translate(two, -q * sin(v), q * cos(v));
    other := ST_Intersection(one_middle, two_middle);
    INSERT INTO beside.axis (axis_id, geom, width, roadway_offset, lane_count, speed, radius, importance) VALUES
      (10 * n, ST_MakeLine(ST_StartPoint(one), at), w, p, 2, 50, 6, 4), (10 * n + 1, ST_MakeLine(at, ST_EndPoint(one)), w, p, 2, 50, 6, 4),
      (10 * n + 2, ST_MakeLine(ST_StartPoint(two), at), x, q, 2, 50, 6, 4), (10 * n + 3, ST_MakeLine(ST_EndPoint(two), at), x, -q, 2, 50, 6, 4);
    INSERT INTO middle.axis (axis_id, geom, width, lane_count, speed, radius, importance) VALUES
      (10 * n, ST_MakeLine(ST_StartPoint(one_middle), other), w, 2, 50, 6, 4), (10 * n + 1, ST_MakeLine(other, ST_EndPoint(one_middle)), w, 2, 50, 6, 4),
      (10 * n + 2, ST_MakeLine(ST_StartPoint(two_middle), other), x, 2, 50, 6, 4), (10 * n + 3, ST_MakeLine(ST_EndPoint(two_middle), other), x, 2, 50, 6, 4);
  END LOOP;
  -- A street that widens, and one with a bend of 8 degrees.
  INSERT INTO beside.axis (axis_id, geom, width, width_end, roadway_offset, lane_count, importance) VALUES (1, pg_temp.line('LINESTRING(0 500,90 500)'), 7, 10, 2.5, 2, 4);
  INSERT INTO middle.axis (axis_id, geom, width, width_end, lane_count, importance) VALUES (1, pg_temp.line('LINESTRING(0 502.5,90 502.5)'), 7, 10, 2, 4);
  INSERT INTO beside.axis (axis_id, geom, width, roadway_offset, lane_count, importance)
    SELECT 2, line, 8, -3, 2, 4 FROM (SELECT pg_temp.line('LINESTRING(0 600,60 600)') AS one, ST_MakeLine(ARRAY[pg_temp.line('POINT(0 600)'), pg_temp.line('POINT(60 600)'),
      pg_temp.line(format('POINT(%s %s)', 60 + 60 * cosd(8), 600 + 60 * sind(8)))]) AS line) l;
  INSERT INTO middle.axis (axis_id, geom, width, lane_count, importance)
    SELECT 2, ST_MakeLine(ARRAY[pg_temp.line('POINT(0 597)'), pg_temp.line(format('POINT(%s 597)', 60 + 3 * tand(4))),
      pg_temp.line(format('POINT(%s %s)', 60 + 60 * cosd(8) + 3 * sind(8), 600 + 60 * sind(8) - 3 * cosd(8)))]), 8, 2, 4;
END $$;
CREATE FUNCTION pg_temp.apart(a geometry, b geometry) RETURNS float8 LANGUAGE sql AS $$ SELECT CASE WHEN ST_IsEmpty(a) AND ST_IsEmpty(b) THEN 0
  ELSE greatest(ST_HausdorffDistance(a, b), 0) END $$;
SELECT 'sections are those along the middle', count(*) = 49 AND max(pg_temp.apart(s.surface, t.surface)) < 1e-3
  FROM beside.section s JOIN beside.edge e USING (edge_id) JOIN middle.edge f USING (axis_id) JOIN middle.section t ON t.edge_id = f.edge_id WHERE axis_id <> 2;
SELECT 'and in a bend, but for its rounding', max(pg_temp.apart(s.surface, t.surface)) < 7 * (1 - cosd(4)) + 3 / cosd(4) - 3
  FROM beside.section s JOIN beside.edge e USING (edge_id) JOIN middle.edge f USING (axis_id) JOIN middle.section t ON t.edge_id = f.edge_id WHERE axis_id = 2;
SELECT 'so are intersections', count(*) = 12 AND max((SELECT min(pg_temp.apart(i.surface, j.surface)) FROM middle.intersection j)) < 1e-3 FROM beside.intersection i;
SELECT 'corners', count(*) = 48 AND max((SELECT min(ST_Distance(c.centre, d.centre) + abs(c.radius - d.radius) + ST_HausdorffDistance(c.arc, d.arc)) FROM middle.corner d)) < 1e-3
  FROM beside.corner c WHERE arc IS NOT NULL;
SELECT 'kerbs', abs(sum(ST_Length(k.geom)) - (SELECT sum(ST_Length(geom)) FROM middle.kerb)) < 0.05 FROM beside.kerb k;
SELECT 'sidewalks', abs(sum(ST_Area(surface)) - (SELECT sum(ST_Area(surface)) FROM middle.sidewalk)) < 0.1 FROM beside.sidewalk;
SELECT 'and lanes', count(*) = 96 AND max(ST_HausdorffDistance(l.geom, m.geom)) < 1e-3 AND max(abs(l.width - m.width)) < 1e-6
  FROM beside.lane l JOIN beside.edge e USING (edge_id) JOIN middle.edge f USING (axis_id) JOIN middle.lane m ON m.edge_id = f.edge_id AND m.ordinality = l.ordinality WHERE axis_id NOT IN (1, 2);
SELECT 'a lane says how far it is from the axis', max(abs(l.axis_offset - m.axis_offset - e.roadway_offset)) < 1e-6
  FROM beside.lane l JOIN beside.edge e USING (edge_id) JOIN middle.edge f USING (axis_id) JOIN middle.lane m ON m.edge_id = f.edge_id AND m.ordinality = l.ordinality;
SELECT 'edges have it', bool_and(e.roadway_offset = a.roadway_offset) FROM beside.edge e JOIN beside.axis a USING (axis_id);

-- Live.
SELECT 'a second run changes no row', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('beside', wait => true);
UPDATE beside.axis SET roadway_offset = -roadway_offset WHERE axis_id IN (10, 41);
SELECT 'it is followed', test.difference('beside', 'once') IS NULL;
UPDATE beside.axis SET geom = ST_Reverse(geom), roadway_offset = -roadway_offset WHERE axis_id IN (20, 62);
SELECT 'also when an axis is reversed', test.difference('beside', 'once') IS NULL;
UPDATE beside.axis SET roadway_offset = NULL WHERE axis_id % 3 = 0;
SELECT 'and taken away', test.difference('beside', 'once') IS NULL AND (SELECT bool_and(roadway_offset = 0) FROM beside.edge WHERE axis_id % 3 = 0);
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('beside') WHERE severity = 'error');

-- A street whose roadway moves to the side: its kerbs taper there as where the width changes.
INSERT INTO beside.axis (axis_id, geom, width, roadway_offset, lane_count, importance, speed) VALUES
  (3, pg_temp.line('LINESTRING(0 700,100 700)'), 8, 0, 2, 4, 50), (4, pg_temp.line('LINESTRING(100 700,200 700)'), 8, 2, 2, 4, 50);
SELECT 'a roadway that moves aside has a transition', c.method = 'transition' FROM beside.corner c JOIN beside.node n USING (node_id) WHERE ST_DWithin(n.geom, pg_temp.line('POINT(100 700)'), 1);
SELECT 'both kerbs move by as much', count(*) = 2 AND bool_and(abs(ST_Length(k.geom) - sqrt(l.size ^ 2 + 4)) < 0.01) FROM beside.kerb k JOIN beside.node n USING (node_id),
  LATERAL (SELECT max(ST_X(p.geom)) - min(ST_X(p.geom)) AS size FROM ST_DumpPoints(k.geom) p) l WHERE ST_DWithin(n.geom, pg_temp.line('POINT(100 700)'), 1);
SELECT 'the surfaces tile', NOT EXISTS (SELECT FROM streetgen.check_model('beside') WHERE severity = 'error') AND test.difference('beside', 'once') IS NULL;

-- Beyond the width, and nonsense.
UPDATE beside.axis SET roadway_offset = 30 WHERE axis_id = 3;
SELECT 'the axis stays on the roadway', roadway_offset = 4 FROM beside.edge WHERE axis_id = 3;
SELECT 'and check_model says so', count(*) = 1 AND max(measure) = 30 FROM streetgen.check_model('beside') WHERE rule LIKE 'roadway_offset beyond%' AND id = 3;
SELECT 'a kerb may be the axis', abs(ST_Distance(s.surface, a.geom)) < 1e-6 AND abs(ST_Area(ST_Difference(s.surface, ST_Buffer(a.geom, 8.001, 'side=left'))))< 0.1 FROM beside.section s JOIN beside.edge USING (edge_id) JOIN beside.axis a USING (axis_id) WHERE axis_id = 3;
SELECT 'it is right there too', NOT EXISTS (SELECT FROM streetgen.check_model('beside') WHERE severity = 'error') AND test.difference('beside', 'once') IS NULL;
SELECT 'refused: ' || said, test.state(format('UPDATE beside.axis SET roadway_offset = %s WHERE axis_id = 3', said)) = '23514' FROM unnest('{''NaN'',-101,1e9,''Infinity''}'::text[]) said;
SELECT 'believed as far as the axis is on the roadway', streetgen.believed_roadway_offset(o, 6, e) = b FROM (VALUES (2.0, NULL, 2.0), (5, NULL, 3), (-5, 4, -2), (NULL, 4, 0), (-1, 9, -1)) v(o, e, b);

-- Import.
SELECT setval(pg_get_serial_sequence('beside.axis', 'axis_id'), 1000) \g /dev/null
CREATE TABLE source AS SELECT 's' || n AS id, ST_Translate(pg_temp.line('LINESTRING(0 900,80 900)'), 0, 60 * n) AS geom, CASE n WHEN 1 THEN 1.5 WHEN 2 THEN NULL ELSE -2 END AS shift FROM generate_series(1, 3) n;
SELECT streetgen.import_axes('beside', 'source', '{"geom": "geom", "source_ref": "id", "roadway_offset": "shift"}') \g /dev/null
SELECT 'import_axes maps it', array_agg(roadway_offset ORDER BY source_ref) = '{1.5,NULL,-2}' FROM beside.axis WHERE source = 'source';
UPDATE source SET shift = 0.5 WHERE id = 's3';
SELECT streetgen.import_axes('beside', 'source', '{"geom": "geom", "source_ref": "id", "roadway_offset": "shift"}') \g /dev/null
SELECT 'and follows it', roadway_offset = 0.5 FROM beside.axis WHERE source_ref = 's3';
