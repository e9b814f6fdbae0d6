\set ECHO none
\ir shared/truths.sql
-- Paint by evidence: streets without lane markings, and arrows where something says so.  (name, holds)
-- A signalled crossing of streets of two lanes each way, and a stem of two lanes that comes to a street at signals and to another without.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154);
  INSERT INTO town.axis (axis_id, geom, width, lanes_forward, lanes_backward, importance) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650150 6860000)', 14, 2, 2, 5), (2, 'SRID=2154;LINESTRING(650150 6860000,650300 6860000)', 14, 2, 2, 5),
    (3, 'SRID=2154;LINESTRING(650150 6860120,650150 6860000)', 14, 2, 2, 5), (4, 'SRID=2154;LINESTRING(650150 6860120,650000 6860120)', 7, 1, 1, 5),
    (5, 'SRID=2154;LINESTRING(650150 6860120,650300 6860120)', 7, 1, 1, 5);
  INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(650150 6860000)', 'signals');
END $$;
CREATE VIEW arrow AS SELECT axis_id, m.along_axis, m.lane_position, l.turn, ST_NPoints(m.surface) AS points FROM town.marking m JOIN town.lane l USING (edge_id, lane_position) JOIN town.edge e USING (edge_id) WHERE m.kind = 'arrow';
CREATE VIEW paint AS SELECT axis_id, 'separator' AS kind, s.surface, s.geom FROM town.lane_separator s JOIN town.edge e USING (edge_id) UNION ALL SELECT axis_id, m.kind, m.surface, m.geom FROM town.marking m JOIN town.edge e USING (edge_id);
SELECT 'at signals arrows stand on the arm whose lanes lead to different arms, and no other street has any' AS name, array_agg(format('%s %s', axis_id, along_axis) ORDER BY axis_id, lane_position) = '{"3 t","3 t"}' AS holds FROM arrow;
UPDATE town.axis SET turn_forward = 'left|right' WHERE axis_id = 1;
SELECT 'a turn by hand has its arrow', count(*) = 2 FROM arrow WHERE axis_id = 1 AND turn IS NOT NULL;
DELETE FROM town.control_point;
SELECT 'without signals the marked lanes keep theirs alone', array_agg(DISTINCT axis_id) = '{1}' FROM arrow;
SELECT 'live as from scratch', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
INSERT INTO town.control_point (geom, kind) VALUES ('SRID=2154;POINT(650150 6860000)', 'signals');
SELECT 'and back with the signals', count(*) = 4 FROM arrow;

SELECT 'all streets are painted', (SELECT count(*) FROM paint WHERE axis_id = 1 AND ST_Area(surface) > 0) = 7;
CREATE TABLE stop_line AS SELECT m.geom FROM town.marking m JOIN town.edge e USING (edge_id) WHERE axis_id = 1 AND m.kind = 'stop';
UPDATE town.axis_editing SET lane_markings = 'no' WHERE axis_id = 1;
SELECT 'without lane markings nothing is painted on its lanes', count(*) = 5 AND coalesce(sum(ST_Area(surface)), 0) = 0 FROM paint WHERE axis_id = 1;
SELECT 'it is known where traffic waits all the same', count(*) = 2 FROM stop_line s JOIN paint p ON p.axis_id = 1 AND p.kind = 'stop' AND p.geom::bytea = s.geom::bytea;
SELECT 'others keep their paint', count(*) > 5 FROM paint WHERE axis_id <> 1 AND ST_Area(surface) > 0;
SELECT 'live as from scratch', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
CREATE FUNCTION marks(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(DISTINCT word::text, ' ') FROM (SELECT string_agg(line, '' ORDER BY ordinality)::xml AS file FROM streetgen.export_opendrive('town')) f,
  unnest(xpath('//road[userData[@code="edge" and @value="' || (SELECT edge_id FROM town.edge WHERE axis_id = axis) || '"]]//lane[@type="driving" or @id="0"]/roadMark/@type', file)) word $$;
SELECT 'OpenDRIVE has no mark between its lanes', marks(1) = 'none' AND marks(2) LIKE '%broken%';
SELECT 'Lanelet2 has virtual lines there', count(*) = 3 FROM streetgen._lines_between('town') JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND paint IS NULL;
UPDATE town.axis SET lane_markings = 'yes' WHERE axis_id = 1;
SELECT 'painted anew', (SELECT count(*) FROM paint WHERE axis_id = 1 AND ST_Area(surface) > 0) = 7;
SELECT 'other words are refused', test.state($$UPDATE town.axis SET lane_markings = 'some' WHERE axis_id = 1$$) = '23514';

-- Of sources.
CREATE TABLE layer (id integer, marked text, geom geometry(LineString, 2154));
INSERT INTO layer VALUES (1, 'false', 'SRID=2154;LINESTRING(650000 6860000, 650090 6860000)'), (2, 'Yes', 'SRID=2154;LINESTRING(650000 6860050, 650090 6860050)'), (3, 'perhaps', 'SRID=2154;LINESTRING(650000 6860100, 650090 6860100)'), (4, NULL, 'SRID=2154;LINESTRING(650000 6860150, 650090 6860150)');
SELECT streetgen.create_model('mapped', 2154) \gset
CREATE TABLE told AS SELECT * FROM streetgen.import_axes('mapped', 'layer', '{"source_ref": "id", "lane_markings": "marked"}');
SELECT 'a mapping takes it', array_agg(coalesce(lane_markings, '-') ORDER BY source_ref) = '{no,yes,-,-}' FROM mapped.axis;
SELECT 'what is no word of it is told', source_refs = '{3}' FROM told WHERE what = 'lane_markings not understood, taken as unknown';
UPDATE mapped.axis SET lane_markings = 'no' WHERE source_ref = '2';
SELECT streetgen.import_axes('mapped', 'layer', '{"source_ref": "id", "lane_markings": "marked"}') \g /dev/null
SELECT 'what is by hand stays', lane_markings = 'no' FROM mapped.axis WHERE source_ref = '2';
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line SELECT id, 'residential', NULL, NULL, jsonb_strip_nulls(jsonb_build_object('lane_markings', CASE marked WHEN 'false' THEN 'no' ELSE lower(marked) END)), 2, geom FROM layer;
SELECT streetgen.create_model('tagged', 2154) \gset
TRUNCATE told;
INSERT INTO told SELECT * FROM streetgen.import_osm('tagged', 'osm');
SELECT 'a tag says it', array_agg(coalesce(lane_markings, '-') ORDER BY source_ref) = '{no,yes,-,-}' FROM tagged.axis;
SELECT 'another value of the tag is told', source_refs = '{3}' FROM told WHERE what LIKE 'lane_markings not understood%';
