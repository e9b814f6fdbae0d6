\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Rings whose axes lie in several clusters, and edits of them: as one run makes them.  (name, holds)
CREATE FUNCTION place(x float8, y float8) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
CREATE FUNCTION way(x float8, y float8, radius float8, start float8, stop float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(place(x + round((radius * cos(radians(a)))::numeric, 6)::float8, y + round((radius * sin(radians(a)))::numeric, 6)::float8) ORDER BY i) FROM generate_series(0, 8) i, LATERAL (SELECT start + (stop - start) * i / 8 AS a) p $$;
-- Rings of four axes in rows, streets between them; those of even places are joined to double ones by streets as short as a chord.
CREATE TABLE source AS SELECT row_number() OVER (ORDER BY ST_XMin(geom), ST_YMin(geom), ST_AsText(geom)) AS axis_id, geom, 6 + (row_number() OVER ())::integer % 3 AS width FROM (
  SELECT way(100 * i, 100 * j, 12 + (i + j) % 4, 90 * q, 90 * q + 90) AS geom FROM generate_series(0, 3) i, generate_series(0, 3) j, generate_series(0, 3) q
  UNION ALL SELECT ST_MakeLine(place(100 * i + 12 + (i + j) % 4, 100 * j), place(100 * i + 100 - 12 - (i + j + 1) % 4, 100 * j)) FROM generate_series(0, 2) i, generate_series(0, 3) j
  UNION ALL SELECT ST_MakeLine(place(100 * i, 100 * j + 12 + (i + j) % 4), place(100 * i, 100 * j + 100 - 12 - (i + j + 1) % 4)) FROM generate_series(0, 3) i, generate_series(0, 2) j
  -- Two double roundabouts west of these, each on a street.
  UNION ALL SELECT way(-100, y, 14, 30, 180) FROM unnest(ARRAY[0, 200]) y UNION ALL SELECT way(-100, y, 14, 180, 330) FROM unnest(ARRAY[0, 200]) y
  UNION ALL SELECT way(-100 + 28 * cos(radians(30)), y, 14, -150, 0) FROM unnest(ARRAY[0, 200]) y UNION ALL SELECT way(-100 + 28 * cos(radians(30)), y, 14, 0, 150) FROM unnest(ARRAY[0, 200]) y
  UNION ALL SELECT ST_MakeLine(ST_StartPoint(way(-100, y, 14, 30, 60)), ST_EndPoint(way(-100, y, 14, 300, 330))) FROM unnest(ARRAY[0, 200]) y
  UNION ALL SELECT ST_MakeLine(place(-190, y), place(-114, y)) FROM unnest(ARRAY[0, 200]) y
  UNION ALL SELECT ST_MakeLine(ST_EndPoint(way(-100 + 28 * cos(radians(30)), y, 14, -150, 0)), place(-12 - (2 * y / 200) % 4, y)) FROM unnest(ARRAY[0, 200]) y) g;
\o /dev/null
SELECT streetgen.create_model(m, 2154, subjects => '{interconnection,roundabout}', driving_side => 'right') FROM unnest(ARRAY['whole', 'parts', 'edited']) m;
SET streetgen.live = off;
INSERT INTO whole.axis (axis_id, geom, width) SELECT * FROM source;
INSERT INTO parts.axis (axis_id, geom, width) SELECT * FROM source;
RESET streetgen.live;
SELECT streetgen.generate('whole');
SELECT streetgen.plan_clusters('parts', 7);
\o
SELECT 'rings and double ones are there, accepted', (SELECT count(*) = 16 FROM whole.roundabout WHERE accepted AND kind = 'ring') AND (SELECT count(*) = 2 FROM whole.roundabout WHERE accepted AND kind = 'double');
SELECT 'rings lie over clusters', count(*) > 4 FROM (SELECT roundabout_id FROM whole.roundabout_edge JOIN whole.edge USING (edge_id) JOIN parts.cluster c ON axis_id = ANY (axes) GROUP BY 1 HAVING count(DISTINCT cluster_id) > 1) r;
SELECT streetgen.generate_cluster('parts', 4) \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT 'no cluster is left', ended = clusters FROM streetgen.progress('parts');
SELECT 'clusters make the rings that one run makes', test.same('parts', 'whole');
SELECT 'and a run over all finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('parts');
-- The same drawn axis by axis, and edited.
INSERT INTO edited.axis (axis_id, geom, width) SELECT * FROM source WHERE axis_id % 3 = 0 ORDER BY axis_id DESC;
INSERT INTO edited.axis (axis_id, geom, width) SELECT * FROM source WHERE axis_id % 3 > 0;
SELECT 'edits make them too', test.same('edited', 'whole');
DO $$ BEGIN
  FOR i IN 1 .. 12 LOOP
    DELETE FROM edited.axis WHERE axis_id = 1 + 8 * i;
    UPDATE edited.axis SET width = 7 + i % 2 WHERE axis_id = 3 + 8 * i;
    UPDATE edited.axis SET direction = CASE i % 3 WHEN 0 THEN 'reverse' ELSE 'direct' END WHERE axis_id = 5 + 8 * i;
  END LOOP;
END $$;
SELECT streetgen.live('whole', false) \g /dev/null
DELETE FROM whole.axis;
INSERT INTO whole.axis SELECT * FROM edited.axis;
SELECT streetgen.generate('whole') \g /dev/null
SELECT 'edits of pieces leave what one run makes', test.same('edited', 'whole') AND (SELECT count(*) > 4 FROM edited.roundabout);
