\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Pedestrian crossings that footways make where they lead over streets: of lines drawn and imported, live, by hand.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,footway,object}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, kind, roadway_offset) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4, 'residential', NULL), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 4, 'residential', NULL),
    (3, pg_temp.line('LINESTRING(50 0,50 80)'), 6, 5, 'service', NULL), (4, pg_temp.line('LINESTRING(0 200,100 200)'), 8, 1, 'motorway', NULL), (5, pg_temp.line('LINESTRING(0 300,100 300)'), 8, 4, 'residential', 4), (6, pg_temp.line('LINESTRING(0 400,100 400)'), 8, 4, 'residential', NULL);
END $$;
CREATE VIEW crossing AS SELECT c.*, o.axis_id, o.abscissa, o.geom, o.placed_by, o.rule_id FROM town.pedestrian_crossing c JOIN town.street_object o USING (street_object_id);
CREATE FUNCTION at(axis bigint, near float8) RETURNS crossing LANGUAGE sql AS $$ SELECT c FROM crossing c WHERE axis_id = axis AND abs(abscissa - near) < 2 $$;
SELECT 'without footways there is no crossing', NOT EXISTS (SELECT FROM crossing);
INSERT INTO town.footway (footway_id, geom, kind, role, marking, width, level) VALUES (1, pg_temp.line('LINESTRING(20 -8,20 8)'), 'footway', 'crossing', 'ladder', 3, 0), (2, pg_temp.line('LINESTRING(70 -20,80 20)'), 'path', NULL, NULL, NULL, 0), (3, pg_temp.line('LINESTRING(130 20,130 0)'), 'footway', NULL, NULL, NULL, 0),
  (4, pg_temp.line('LINESTRING(160 20,160 0)'), 'footway', NULL, NULL, NULL, 0), (5, pg_temp.line('LINESTRING(160 0,160 -20)'), 'footway', NULL, NULL, NULL, 0), (6, pg_temp.line('LINESTRING(180 20,180 -20)'), 'footway', 'crossing', 'zebra', NULL, 1), (7, pg_temp.line('LINESTRING(100 15,100 -15)'), 'footway', 'crossing', NULL, NULL, 0),
  (8, pg_temp.line('LINESTRING(40 40,60 40)'), 'footway', 'sidewalk', NULL, NULL, 0), (9, pg_temp.line('LINESTRING(50 190,50 210)'), 'footway', NULL, NULL, NULL, 0), (10, pg_temp.line('LINESTRING(50 320,50 290)'), 'cycleway', 'crossing', 'dots', NULL, 0), (11, pg_temp.line('LINESTRING(40 60,60 60)'), 'footway', 'crossing', NULL, NULL, 0),
  (12, pg_temp.line('LINESTRING(0 401,20 399,40 401,60 399,80 401,100 399)'), 'footway', NULL, NULL, NULL, 0), (13, pg_temp.line('LINESTRING(21.2 -8,21.2 8)'), 'cycleway', NULL, NULL, 2, 0), (14, pg_temp.line('LINESTRING(90 390,90 401,92 401,92 390)'), 'footway', NULL, NULL, NULL, 0);
SELECT 'a footway over a street is its crossing, as wide as it says', (c).footway_id = 1 AND (c).width = 3 AND (c).angle = 90 AND (c).painted_as = 'ladder' AND abs(ST_Area((c).surface) - 24) < 1e-6 AND (c).rule_id = -1 FROM at(1, 20) c;
SELECT 'one that lies on it by half makes none', NOT EXISTS (SELECT FROM crossing WHERE footway_id = 13);
SELECT 'it lies as the footway does, and where nobody says that people cross nothing is painted', abs((c).angle - degrees(atan(4))) < 1e-5 AND (c).painted_as = 'no' AND (c).stripes IS NULL AND ST_Area((c).surface) > 32 FROM at(1, 75) c;
SELECT 'one that ends on a street leads nowhere', (at(2, 30)).street_object_id IS NULL;
SELECT 'two that go on from each other lead over it', (at(2, 60)).footway_id = 4;
SELECT 'on another level none does', (at(2, 80)).street_object_id IS NULL;
SELECT 'where a street goes on in another one there is one', count(*) = 1 AND min(painted_as) = 'zebra' FROM crossing WHERE footway_id = 7;
SELECT 'over a drive nothing is painted, unless it is tagged', (at(3, 40)).painted_as = 'no' AND (at(3, 60)).painted_as = 'no';
SELECT 'nobody walks over a motorway', (at(4, 50)).street_object_id IS NULL;
SELECT 'the axis may run along a kerb, and a cycle track is as wide as its class', (c).painted_as = 'dots' AND abs(ST_Area((c).surface) - 16) < 1e-6 FROM at(5, 50) c;
SELECT 'a footway along the middle of a street, or one that turns back on it, leads over none', NOT EXISTS (SELECT FROM crossing WHERE axis_id = 6);
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');

-- Live: each edit as a run over all.
CREATE FUNCTION stand() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(concat_ws(' ', axis_id, abscissa::numeric(12, 4), angle::numeric(12, 4), width, painted_as, footway_id, placed_by, md5(surface::text), md5(stripes::text)), '; ' ORDER BY axis_id, abscissa) FROM crossing $$;
CREATE FUNCTION as_run() RETURNS boolean LANGUAGE plpgsql SET streetgen.computes = 'on' AS $$ DECLARE before constant text := stand(); BEGIN
  UPDATE town.edge SET input_hash = 0; PERFORM FROM streetgen.generate('town', wait => true); RETURN before = stand(); END $$;
SELECT 'as a run over all', as_run();
UPDATE town.footway SET geom = ST_Translate(geom, 5, 0) WHERE footway_id = 1;
SELECT 'a crossing follows its footway', (at(1, 25)).footway_id = 1 AND (at(1, 21)).footway_id = 13 AND as_run();
UPDATE town.footway SET marking = 'lines' WHERE footway_id = 1;
SELECT 'and its paint', (at(1, 25)).painted_as = 'lines' AND as_run();
UPDATE town.axis SET width = 10 WHERE axis_id = 1;
SELECT 'and its street', abs(ST_Area((at(1, 25)).surface) - 30) < 1e-6 AND as_run();
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 2;
SELECT 'one that turns round keeps it', (at(2, 40)).footway_id = 4 AND as_run();
UPDATE town.footway SET level = 1 WHERE footway_id = 2;
SELECT 'one that is lifted leaves none', (at(1, 75)).street_object_id IS NULL AND as_run();
DELETE FROM town.footway WHERE footway_id = 5;
SELECT 'nor one whose other half is gone', (at(2, 40)).street_object_id IS NULL AND as_run();
INSERT INTO town.control_point (control_point_id, kind, geom, axis_id, marking) VALUES (1, 'pedestrian_crossing', ST_SetSRID(ST_MakePoint(650050, 6860040), 2154), 3, 'dots');
SELECT 'a node on it tells what the footway does not', (at(3, 40)).painted_as = 'dots' AND as_run();
UPDATE town.footway SET role = 'crossing', marking = 'zebra' WHERE footway_id = 8;
SELECT 'the word of the footway comes first', (at(3, 40)).painted_as = 'zebra' AND as_run();
DELETE FROM town.control_point;
UPDATE town.footway SET marking = 'yes' WHERE footway_id = 8;
SELECT 'yes is as is usual', (at(3, 40)).painted_as = 'zebra' AND as_run();

-- By hand, and of a source: node and footway of one place are one crossing.
INSERT INTO town.street_object (type, placement, axis_id, abscissa, axis_offset, placed_by, source, source_ref) VALUES ('crossing', 'axis', 1, 26, 0, 'import', 'nodes', '7');
SELECT 'one that a source places is the crossing of the footway', count(*) = 1 AND min(placed_by) = 'import' AND min(footway_id) = 1 AND min(painted_as) = 'lines' FROM crossing WHERE axis_id = 1 AND abscissa BETWEEN 22 AND 30;
SELECT 'all as a run over all', as_run();
DELETE FROM town.street_object WHERE source_ref = '7';
SELECT 'gone, the footway makes one again', (at(1, 25)).placed_by = 'rule' AND as_run();
UPDATE town.pedestrian_crossing_editing SET marking = 'surface', width = 5 WHERE street_object_id = (at(1, 25)).street_object_id;
SELECT 'one that is edited is by hand, and alone', (at(1, 25)).placed_by = 'user' AND (at(1, 25)).painted_as = 'surface' AND (SELECT count(*) = 1 FROM crossing WHERE footway_id = 1) AND as_run();
DELETE FROM town.pedestrian_crossing_editing WHERE street_object_id = (at(3, 60)).street_object_id;
SELECT 'one that is deleted stays away', (at(3, 60)).street_object_id IS NULL AND as_run() AND (SELECT count(*) = 1 FROM town.free_place WHERE ST_DWithin(geom, pg_temp.line('LINESTRING(50 60,50 60.1)'), 0.2));
DELETE FROM town.free_place WHERE ST_DWithin(geom, pg_temp.line('LINESTRING(50 60,50 60.1)'), 0.2);
SELECT 'until its place is free no more', (at(3, 60)).footway_id = 11 AND as_run();
-- A walk of which nobody says that people cross there: a kerb that is typed, or a place, paints nothing.
INSERT INTO town.axis (axis_id, geom, width, importance, kind) VALUES (9, pg_temp.line('LINESTRING(0 600,200 600)'), 6, 5, 'residential');
INSERT INTO town.footway (footway_id, geom, kind) VALUES (21, pg_temp.line('LINESTRING(50 590,50 610)'), 'path'), (22, pg_temp.line('LINESTRING(90 590,90 610)'), 'path');
UPDATE town.pedestrian_crossing_editing SET kerb = 'lowered' WHERE street_object_id = (at(9, 50)).street_object_id;
UPDATE town.pedestrian_crossing_editing SET abscissa = 92 WHERE street_object_id = (at(9, 90)).street_object_id;
SELECT 'one that is edited keeps its paint', (at(9, 50)).placed_by = 'user' AND (at(9, 50)).painted_as = 'no' AND (at(9, 92)).placed_by = 'user' AND (at(9, 92)).painted_as = 'no' AND as_run();
UPDATE town.pedestrian_crossing_editing SET marking = 'zebra' WHERE street_object_id = (at(9, 50)).street_object_id;
SELECT 'until somebody says it', (at(9, 50)).painted_as = 'zebra' AND as_run();
DELETE FROM town.footway WHERE footway_id IN (21, 22);
DELETE FROM town.pedestrian_crossing_editing WHERE axis_id = 9;
DELETE FROM town.axis WHERE axis_id = 9;
INSERT INTO town.placement_rule (rule_id, type, along, distance_from_limit) VALUES (5, 'crossing', 'arm', 2.5);
INSERT INTO town.axis (axis_id, geom, width, importance, kind) VALUES (7, pg_temp.line('LINESTRING(100 0,100 90)'), 6, 5, 'residential');
INSERT INTO town.footway (footway_id, geom, kind, role) VALUES (20, pg_temp.line('LINESTRING(90 14,110 14)'), 'footway', 'crossing');
SELECT 'an arm that a footway leads over has none by rule', (SELECT array_agg(rule_id) = '{-1}' FROM crossing WHERE axis_id = 7) AND (SELECT count(*) > 0 FROM crossing WHERE rule_id = 5) AND as_run();
DELETE FROM town.footway WHERE footway_id = 20;
SELECT 'without the footway it has', (SELECT array_agg(rule_id) = '{5}' FROM crossing WHERE axis_id = 7) AND as_run();
DELETE FROM town.axis WHERE axis_id = 7;
DELETE FROM town.placement_rule;
SELECT 'a rule that goes leaves what footways make', (at(3, 60)).footway_id = 11 AND as_run();

-- By setting.
SELECT streetgen.set('town', 'footway_crossings', 'mapped') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'by setting only those that say that they are crossings', bool_and(role = 'crossing') AND count(*) > 3 FROM crossing JOIN town.footway USING (footway_id) WHERE rule_id = -1;
SELECT streetgen.set('town', 'footway_crossings', 'none') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'or none', NOT EXISTS (SELECT FROM crossing WHERE rule_id = -1) AND EXISTS (SELECT FROM crossing WHERE footway_id = 1);
SELECT streetgen.set('town', 'footway_crossings', 'all') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without footways theirs are gone', NOT EXISTS (SELECT FROM crossing WHERE rule_id = -1 OR footway_id IS NOT NULL);
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', true) \g /dev/null
SELECT 'and come again', (at(3, 60)).footway_id = 11 AND as_run();

-- Of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2, pg_temp.line('LINESTRING(0 0,200 0)')), (2, 'footway', NULL, NULL, '{"footway": "crossing", "crossing:markings": "ladder"}', 2, pg_temp.line('LINESTRING(20 -8,20 8)')),
  (3, 'cycleway', NULL, NULL, '{"cycleway": "crossing", "crossing": "uncontrolled"}', 2, pg_temp.line('LINESTRING(40 -8,40 8)')), (4, 'path', NULL, NULL, '{"path": "crossing", "crossing": "unmarked"}', 2, pg_temp.line('LINESTRING(60 -8,60 8)')), (5, 'footway', NULL, NULL, '{"crossing": "zebra"}', 2, pg_temp.line('LINESTRING(80 -8,80 8)'));
DO $$ BEGIN PERFORM streetgen.create_model('mapped', 2154, subjects => '{footway,object}'); END $$;
SELECT streetgen.import_osm('mapped', 'osm') \g /dev/null
SELECT streetgen.generate('mapped') \g /dev/null
SELECT 'ways of crossings and what paints them', string_agg(concat_ws(':', f.source_ref, f.role, f.marking, c.painted_as), ' ' ORDER BY f.source_ref) = '2:crossing:ladder:ladder 3:crossing:yes:dashes 4:crossing:no:no 5:no' FROM mapped.footway f JOIN mapped.pedestrian_crossing c USING (footway_id);
CREATE TABLE osm_object (node_id bigint, class text, direction text, geom geometry(Point, 2154));
INSERT INTO osm_line VALUES (6, 'footway', NULL, NULL, '{"footway": "crossing"}', 2, pg_temp.line('LINESTRING(115 -8,125 8)'));
INSERT INTO osm_object VALUES (1, 'crossing', NULL, ST_SetSRID(ST_MakePoint(650120, 6860000), 2154)), (2, 'crossing', NULL, ST_SetSRID(ST_MakePoint(650150, 6860000), 2154));
SELECT streetgen.import_osm('mapped', 'osm') \g /dev/null
SELECT count(*) FROM streetgen.generate('mapped', wait => true) \g /dev/null
SELECT streetgen.import_osm_objects('mapped', 'osm') \g /dev/null
SELECT 'a node on a footway leads where that does, another one square across', string_agg(round(c.angle) || ' ' || coalesce(f.source_ref, '-'), ', ' ORDER BY o.source_ref) = '58 6, 90 -' AND bool_and(c.surface IS NOT NULL) FROM mapped.pedestrian_crossing c JOIN mapped.street_object o USING (street_object_id) LEFT JOIN mapped.footway f USING (footway_id) WHERE o.placed_by = 'import';
SELECT 'a marking that nobody knows is refused', test.state($$UPDATE mapped.footway SET marking = 'stars'$$) = '23514';

-- A crossing of a rule stands at the border of its street, and has the paint of the footway that comes there.
DO $$ BEGIN
  PERFORM streetgen.create_model('border', 2154, subjects => '{footway,object}', driving_side => 'right');
  INSERT INTO border.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 16);
  INSERT INTO border.placement_rule (type, along, side, every, axis_offset, orientation)
    VALUES ('crossing', 'border', 'both', 30, -1, 0);
END $$;
CREATE FUNCTION pg_temp.paint() RETURNS text LANGUAGE sql AS $$ SELECT string_agg(painted_as, ' '
    ORDER BY o.side, o.abscissa) FROM border.pedestrian_crossing c JOIN border.street_object o USING (street_object_id) $$;
SELECT 'such crossings are painted', pg_temp.paint() ~ 'zebra' AND pg_temp.paint() !~ 'no';
INSERT INTO border.footway (geom, kind, role, marking, level)
    VALUES (pg_temp.line('LINESTRING(0 7.2,100 7.2)'), 'footway', 'crossing', 'no', 0);
SELECT 'a footway there takes the paint away', pg_temp.paint() ~ 'no';
CREATE TABLE edited_paint AS SELECT pg_temp.paint() AS paint;
UPDATE border.axis SET level = level;
SELECT FROM streetgen.generate('border') \g /dev/null
SELECT 'as from scratch', paint = pg_temp.paint() FROM edited_paint;
