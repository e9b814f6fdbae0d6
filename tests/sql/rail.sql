\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Tracks in streets and beside them, live, against scratch and of several rights.  (name, holds)
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
-- A double track in an avenue, a single one at the side, one that leaves through grass, a curve through a junction, and a loop.
CREATE PROCEDURE pg_temp.draw(model name, subjects text[], mirrored boolean DEFAULT false) LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2154, subjects => subjects, driving_side => CASE WHEN mirrored THEN 'left' ELSE 'right' END);
  EXECUTE format($q$INSERT INTO %1$I.axis (axis_id, geom, width, radius, importance, lane_count, sidewalk_left, sidewalk_right) VALUES
    (1, pg_temp.line('LINESTRING(0 0,120 0)'), 14, 8, 3, 4, 3, 3), (2, pg_temp.line('LINESTRING(120 0,240 0)'), 14, 8, 3, 4, 3, 3),
    (3, pg_temp.line('LINESTRING(120 0,120 100)'), 8, 6, 4, 2, 3, 3), (4, pg_temp.line('LINESTRING(120 0,120 -80)'), 7, 6, 5, 2, 3, 3);
    INSERT INTO %1$I.rail_track (rail_track_id, geom, kind, gauge) VALUES (1, pg_temp.line('LINESTRING(0 1.6,240 1.6)'), 'tram', NULL), (2, pg_temp.line('LINESTRING(0 -1.6,240 -1.6)'), 'tram', 1000),
    (3, pg_temp.line('LINESTRING(95 1.6,100 1.6,105 2.1,110 4,114 7.2,116.5 12,117.5 18,117.5 60,112 66,60 84,20 84)'), 'tram', NULL),
    (4, pg_temp.line('LINESTRING(240 5.6,150 5.6)'), 'tram', NULL),
    (5, pg_temp.line('LINESTRING(20 84,10 82,4 76,2 68,4 60,10 54,20 52,28 56,31 64,30 74,26 81,20 84)'), 'light_rail', NULL)$q$, model);
  IF mirrored THEN EXECUTE format('UPDATE %1$I.axis SET geom = ST_Affine(geom, 1, 0, 0, -1, 0, 2 * 6860000); UPDATE %1$I.rail_track SET geom = ST_Affine(geom, 1, 0, 0, -1, 0, 2 * 6860000)', model); END IF;
END $$;
CREATE FUNCTION pg_temp.street(model name) RETURNS text LANGUAGE plpgsql AS $$ DECLARE said text; BEGIN
  EXECUTE format('SELECT string_agg(concat_ws('' '', ''axis'', axis_id, ''track'', rail_track_id, round(t.start_abscissa::numeric) || ''-'' || round(t.end_abscissa::numeric)), '', '' ORDER BY axis_id, rail_track_id, part)
    FROM %I.street_track t JOIN %1$I.edge USING (edge_id)', model) INTO said; RETURN said; END $$;
CALL pg_temp.draw('bare', '{lane,interconnection,kerb,sidewalk,footway}');
CALL pg_temp.draw('town', '{lane,interconnection,junction,footway,object,block,rail}');
SELECT 'the roadway and its lanes are what they are without rails', NOT EXISTS (
  (SELECT c FROM test.content('bare') c WHERE c !~ '^(sidewalk|track)' EXCEPT ALL SELECT c FROM test.content('town') c) UNION ALL (SELECT c FROM test.content('town') c WHERE c !~ '^(sidewalk|track|block|junction|object)' EXCEPT ALL SELECT c FROM test.content('bare') c));
SELECT 'without the subject there are no tables, and sidewalks are whole', 'rail' = ANY (streetgen._subjects('bare')) OR to_regclass('bare.street_track') IS NULL AND to_regclass('bare.track_bed') IS NULL AND (SELECT bool_and(strip IS NULL) FROM bare.sidewalk);
SELECT 'tracks lie along the streets in whose roadway they run', pg_temp.street('town') ~ '^axis 1 track 1 0-1\d\d, axis 1 track 2 0-1\d\d, axis 1 track 3 95-1\d\d, axis 2 track 1 \d+-120, axis 2 track 2 \d+-120, axis 2 track 4 30-120, axis 3 track 3 \d+-6\d$';
SELECT 'as wide as the setting, beside the middle', bool_and(abs(borders[2] - (1.6 + 1.325)) < 1e-6 AND abs(borders[3] - (1.325 - 1.6)) < 1e-6) FROM town.street_track JOIN town.edge USING (edge_id) WHERE rail_track_id = 1;
SELECT 'a bed is parted between street and ground of its own', bool_and(abs(ST_Area(surface) + coalesce(ST_Area(in_street), 0) - ST_Length(geom) * 2.65) < 2) FROM town.track_bed WHERE rail_track_id IN (1, 2, 4);
SELECT 'all of the avenue''s tracks lies in the street, and the loop on ground of its own', (SELECT bool_and(ST_Area(surface) < 0.01) FROM town.track_bed WHERE rail_track_id IN (1, 2, 4)) AND (SELECT ST_Area(coalesce(in_street, 'POLYGON EMPTY')) = 0 AND ST_Area(surface) > 200 FROM town.track_bed WHERE rail_track_id = 5);
SELECT 'the roadway has all that lies in the street', bool_and(ST_Area(ST_Difference(b.in_street, r.surface)) < 0.01) FROM town.track_bed b, (SELECT ST_Union(surface) AS surface FROM (SELECT surface FROM town.section UNION ALL SELECT surface FROM town.intersection) s) r WHERE NOT ST_IsEmpty(in_street);
CREATE FUNCTION pg_temp.overlap(model name) RETURNS float8 LANGUAGE plpgsql AS $$ DECLARE metres float8; BEGIN
  EXECUTE format('SELECT coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) FROM (SELECT rail_track_id AS id, surface::geometry FROM %I.track_bed WHERE level = 0) a JOIN (SELECT rail_track_id AS id, surface::geometry FROM %1$I.track_bed WHERE level = 0
    UNION ALL SELECT -sidewalk_id, surface FROM %1$I.sidewalk UNION ALL SELECT -footway_id - 100000, surface FROM %1$I.footway_surface UNION ALL SELECT -edge_id - 200000, surface FROM %1$I.section UNION ALL SELECT -node_id - 300000, surface FROM %1$I.intersection) b
    ON a.id <> b.id AND a.surface && b.surface', model) INTO metres; RETURN metres; END $$;
SELECT 'no ground is that of two', pg_temp.overlap('town') < 0.05;
SELECT 'the sidewalk is cut where a track leaves the street', (SELECT count(*) >= 1 AND bool_and(ST_Area(strip) - ST_Area(surface) > 5) FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 3 AND side = 'left' AND strip IS NOT NULL);
SELECT 'and people cross the track there, without signals', count(*) >= 1 FROM town.rail_crossing c JOIN town.sidewalk USING (sidewalk_id) WHERE rail_track_id = 3 AND use = 'walk' AND footway_id IS NULL;
SELECT 'rails lie at the gauge', (SELECT abs(ST_Distance(ST_GeometryN(rails, 1), ST_GeometryN(rails, 2)) - 1.435) < 1e-6 FROM town.rail WHERE rail_track_id = 1) AND (SELECT gauge = 1000 AND abs(ST_Distance(ST_GeometryN(rails, 1), ST_GeometryN(rails, 2)) - 1) < 1e-6 FROM town.rail WHERE rail_track_id = 2);
SELECT 'each track shares its lanes', (SELECT string_agg(concat_ws(':', axis_id, rail_track_id, lane_position), ' ' ORDER BY axis_id, rail_track_id, lane_position) FROM (SELECT DISTINCT axis_id, rail_track_id, lane_position FROM town.lane_track JOIN town.lane USING (lane_id) JOIN town.edge e ON e.edge_id = lane.edge_id WHERE axis_id = 2) l) IN ('2:1:2 2:2:3 2:4:1', '2:1:3 2:2:2 2:4:4');
SELECT 'pieces of a cut lie side by side, and tracks are pieces of their lanes', (SELECT string_agg(concat_ws(' ', kind, round(offset_from::numeric, 3)), ', ' ORDER BY "order") = 'general 0.000, rail 0.275, general 2.925, general 3.500, rail 4.275, general 6.925, kerb 7.000, furnishing 7.300, sidewalk 8.300, outer 10.000' FROM streetgen.cross_section('town', 2, 80) WHERE side = 'left')
  AND NOT EXISTS (SELECT FROM (SELECT offset_to, lead(offset_from) OVER (PARTITION BY side ORDER BY "order") AS next FROM streetgen.cross_section('town', 2, 80)) c WHERE next <> offset_to);
SELECT 'a lane is as wide as its pieces', NOT EXISTS (SELECT FROM (SELECT c.lane_id, sum(offset_to - offset_from) AS metres FROM town.cross_section c WHERE lane_id IS NOT NULL GROUP BY c.lane_id, edge_id, start_abscissa) c JOIN town.lane l USING (lane_id) WHERE l.borders IS NULL AND abs(metres - l.width) > 1e-6);
SELECT 'and the drawing of a cut shows the tracks', streetgen.cross_section_svg('town', 2, 80) ~ 'track';
SELECT 'theme street draws rails and beds', streetgen.svg('town', scale => 500) ~ 'class="rail|rails|#23272d';

-- Live: each edit against a run over all.
CREATE FUNCTION pg_temp.as_from_scratch(model name) RETURNS boolean LANGUAGE plpgsql AS $$ BEGIN
  CREATE TEMPORARY TABLE was AS SELECT * FROM test.content(model);
  EXECUTE format('UPDATE %I.edge SET input_hash = 0', model); PERFORM FROM streetgen.generate(model, wait => true);
  RETURN NOT EXISTS ((TABLE was EXCEPT ALL SELECT * FROM test.content(model)) UNION ALL (SELECT * FROM test.content(model) EXCEPT ALL TABLE was)); END $$;
CREATE FUNCTION pg_temp.stands() RETURNS boolean LANGUAGE plpgsql AS $$ DECLARE holds boolean; BEGIN holds := pg_temp.as_from_scratch('town'); DROP TABLE was; RETURN holds AND pg_temp.overlap('town') < 0.05; END $$;
SELECT 'as from scratch', pg_temp.stands();
UPDATE town.rail_track SET geom = ST_Translate(geom, 0, 0.5) WHERE rail_track_id = 1;
SELECT 'a track that moves is moved along its streets', (SELECT bool_and(abs(borders[2] - (2.1 + 1.325)) < 1e-6) FROM town.street_track WHERE rail_track_id = 1) AND pg_temp.stands();
UPDATE town.rail_track SET geom = ST_Translate(geom, 0, 2.9) WHERE rail_track_id = 4;
SELECT 'on a sidewalk it takes its ground', (SELECT count(*) = 0 FROM town.street_track WHERE rail_track_id = 4) AND (SELECT ST_Area(strip) - ST_Area(surface) > 100 FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 2 AND side = 'left') AND pg_temp.stands();
SELECT 'and is no crossing of it', NOT EXISTS (SELECT FROM town.rail_crossing WHERE rail_track_id = 4);
UPDATE town.axis SET width = 30 WHERE axis_id = 2;
SELECT 'the street that grows takes it in', (SELECT count(*) = 1 FROM town.street_track WHERE rail_track_id = 4) AND pg_temp.stands();
UPDATE town.rail_track SET level = 1 WHERE rail_track_id = 4;
SELECT 'a track of another level is in no street of this', NOT EXISTS (SELECT FROM town.street_track WHERE rail_track_id = 4) AND pg_temp.stands();
DELETE FROM town.rail_track WHERE rail_track_id = 3;
SELECT 'one that is gone leaves its ground', NOT EXISTS (SELECT FROM town.street_track WHERE rail_track_id = 3) AND (SELECT bool_and(strip IS NULL) FROM town.sidewalk JOIN town.edge USING (edge_id) WHERE axis_id = 3) AND pg_temp.stands();
INSERT INTO town.footway (footway_id, geom, kind) VALUES (1, pg_temp.line('LINESTRING(20 40,20 100)'), 'footway'), (2, pg_temp.line('LINESTRING(130 1.6,200 1.6)'), 'footway'), (3, pg_temp.line('LINESTRING(40 52,-20 53)'), 'cycleway');
SELECT 'a walk over a track is cut, and crosses it', (SELECT ST_NumGeometries(surface) = 3 FROM town.footway_surface WHERE footway_id = 1) AND (SELECT count(*) >= 1 AND bool_and(ST_Area(surface) BETWEEN 4 AND 14) FROM town.rail_crossing WHERE footway_id = 1) AND pg_temp.stands();
INSERT INTO town.rail_track (rail_track_id, geom, tracks) VALUES (6, pg_temp.line('LINESTRING(0 -40,100 -40)'), 2), (7, pg_temp.line('LINESTRING(0 -37,100 -37)'), 1);
SELECT 'one line stands for two tracks', (SELECT ST_NumGeometries(rails) = 4 FROM town.rail WHERE rail_track_id = 6) AND (SELECT width = 5.3 FROM town.track_bed WHERE rail_track_id = 6);
SELECT 'tracks too near to each other, and a footway on one, are told', (SELECT string_agg(concat_ws(' ', rule, id), ', ' ORDER BY rule) = 'footway along a track, m 2, tracks nearer than their width, m 6' FROM streetgen.check_model('town') WHERE rule ~ 'track');
SELECT 'counts of the summary', string_agg(subject || ' ' || (amount > 0), ', ' ORDER BY subject) = 'tracks true, tracks in streets true' FROM streetgen.summary('town') WHERE subject IN ('tracks', 'tracks in streets');
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'a street that turns round has it on its other side', (SELECT bool_and(abs(borders[3] - (2.1 + 1.325)) < 1e-6) FROM town.street_track JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND rail_track_id = 1) AND pg_temp.stands();
DELETE FROM town.axis WHERE axis_id = 4;
SELECT 'streets come and go', pg_temp.stands();
-- The round end that one track gets of another reaches a sidewalk that the other does not.
SELECT streetgen.create_model('meeting', 2154, subjects => '{lane,interconnection,footway,rail}', driving_side => 'right') \g /dev/null
INSERT INTO meeting.axis (axis_id, geom, width, lane_count, sidewalk_left, sidewalk_right) VALUES (1, pg_temp.line('LINESTRING(0 0,100 0)'), 10, 2, 3, 3);
INSERT INTO meeting.rail_track (rail_track_id, geom, tracks) VALUES (1, pg_temp.line('LINESTRING(50 60,50 10)'), 2), (2, pg_temp.line('LINESTRING(20 13,20 10)'), 2);
INSERT INTO meeting.rail_track (rail_track_id, geom) VALUES (3, pg_temp.line('LINESTRING(50 10.04,70 30)'));
SELECT 'a track that meets another gives it a round end, which cuts the sidewalk', (SELECT count(*) = 1 AND bool_and(ST_Area(strip) - ST_Area(surface) > 0.5) FROM meeting.sidewalk WHERE strip IS NOT NULL) AND pg_temp.as_from_scratch('meeting');
DROP TABLE was;
UPDATE meeting.rail_track SET geom = ST_Translate(geom, 0, 30) WHERE rail_track_id = 3;
SELECT 'and takes it away', (SELECT bool_and(strip IS NULL) FROM meeting.sidewalk) AND pg_temp.as_from_scratch('meeting');
DROP TABLE was;
BEGIN;
SELECT streetgen.live('town', false) \g /dev/null
UPDATE town.rail_track SET geom = ST_Translate(geom, 0, -0.5) WHERE rail_track_id = 1;
SELECT 'what is not followed is due', streetgen._stale_axes('town') > 0;
SELECT count(*) FROM streetgen.generate('town') \g /dev/null
SELECT 'and is as if followed', (SELECT bool_and(abs(greatest(borders[2], borders[3]) - (1.6 + 1.325)) < 1e-6) FROM town.street_track WHERE rail_track_id = 1);
ROLLBACK;
SELECT streetgen.set('town', 'track_width', '3') \g /dev/null
SELECT count(*) FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'as wide as the setting', (SELECT bool_and(abs(borders[2] + borders[3] - 3) < 1e-6) FROM town.street_track WHERE rail_track_id IN (1, 2)) AND pg_temp.stands();
SELECT count(*) FROM streetgen.switch_subject('town', 'rail', false) \g /dev/null
SELECT 'switched off, sidewalks and footways are whole again', to_regclass('town.track_bed') IS NULL AND (SELECT bool_and(strip IS NULL) FROM town.sidewalk) AND (SELECT ST_NumGeometries(surface) = 2 FROM town.footway_surface WHERE footway_id = 1) AND (SELECT bool_and(kind <> 'rail') FROM town.cross_section);
SELECT count(*) FROM streetgen.switch_subject('town', 'rail', true) \g /dev/null
SELECT 'switched on, they are cut', (SELECT ST_NumGeometries(surface) = 3 FROM town.footway_surface WHERE footway_id = 1) AND pg_temp.stands();
INSERT INTO town.street_object_editing (type, geom) VALUES ('tree', pg_temp.line('POINT(50 -37)')), ('tree', pg_temp.line('POINT(50 -47)'));
SELECT 'a tree on a track is told', (SELECT count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'object on a track');
SELECT 'a format that has no tracks has the streets', (SELECT count(*) > 0 FROM streetgen.export_cityjson('town'));
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT count(*) FROM streetgen.switch_subject('town', 'object', false) \g /dev/null
SELECT 'the others may go', (SELECT count(*) > 0 FROM town.track_bed) AND pg_temp.as_from_scratch('town');
DROP TABLE was;
CALL pg_temp.draw('left_hand', '{lane,interconnection,junction,footway,object,block,rail}', mirrored => true);
CALL pg_temp.draw('right_hand', '{lane,interconnection,junction,footway,object,block,rail}');
SELECT 'left-hand traffic has the mirrored tracks', (SELECT bool_and(abs(a.metres - b.metres) < 0.01) AND count(*) = 4 FROM (SELECT rail_track_id, sum(end_abscissa - start_abscissa) AS metres FROM left_hand.street_track GROUP BY 1) a FULL JOIN (SELECT rail_track_id, sum(end_abscissa - start_abscissa) AS metres FROM right_hand.street_track GROUP BY 1) b USING (rail_track_id))
  AND (SELECT abs(sum(ST_Area(surface)) - (SELECT sum(ST_Area(surface)) FROM right_hand.track_bed)) < 0.5 FROM left_hand.track_bed);
-- Tracks that turn off their street at several angles, to either side and either way.
SELECT streetgen.create_model('turning', 2154, subjects => '{lane,sidewalk,rail}', driving_side => 'right') \g /dev/null
INSERT INTO turning.axis (axis_id, geom, width, lane_count) SELECT n, ST_Translate(pg_temp.line('LINESTRING(0 0,100 0)'), 0, n * 200), 10, 2 FROM generate_series(1, 10) n;
INSERT INTO turning.rail_track (rail_track_id, geom) SELECT n, ST_Translate(CASE WHEN n % 2 = 1 THEN ST_Reverse(geom) ELSE geom END, 0, n * 200) FROM unnest('{31,45,63,90,117,-31,-45,-63,-90,-117}'::float8[]) WITH ORDINALITY a(turned, n),
  LATERAL (SELECT pg_temp.line(format('LINESTRING(0 0,60 0,%s %s)', 60 + 20 * cosd(turned), 20 * sind(turned))) AS geom) g;
SELECT 'a track that turns off its street has its sides along it, up to there', count(*) = 10 AND bool_and(abs(t.end_abscissa - CASE WHEN axis_id IN (1, 6) THEN 60 + 5 / tand(31) ELSE 60 END) < 0.05 AND t.start_abscissa < 0.01 AND abs(borders[2] - 1.325) < 0.01 AND abs(borders[3] - 1.325) < 0.01)
  FROM turning.street_track t JOIN turning.edge USING (edge_id) WHERE borders IS NOT NULL;
SELECT 'and leads across from there', count(*) = 8 AND bool_and(abs(greatest(start_abscissa - 60, 60 - end_abscissa)) < 0.05) FROM turning.street_track WHERE borders IS NULL;
SELECT 'shares its lanes up to there, and is a piece of a cut', (SELECT count(*) = 20 AND bool_and(start_abscissa < 0.01 AND end_abscissa BETWEEN 58 AND 69) FROM turning.lane_track) AND (SELECT count(DISTINCT edge_id) = 10 FROM turning.cross_section WHERE kind = 'rail' AND start_abscissa <= 30 AND end_abscissa >= 30);
INSERT INTO turning.rail_track (rail_track_id, geom) VALUES (11, ST_Translate(pg_temp.line('LINESTRING(20 30,20 2,50 2,50 -2,20 -2)'), 0, 200));
SELECT 'one that turns about in the street lies along it twice', array_agg(concat_ws(' ', round(start_abscissa), round(end_abscissa), borders IS NULL) ORDER BY part) = '{20 50 f,20 20 t,20 50 f,50 50 t}' FROM turning.street_track WHERE rail_track_id = 11;
-- Bad input is refused with a way out, or has a result.
SELECT 'a gauge of metres is refused', state = '23514' AND hint <> '' FROM test.refusal('INSERT INTO town.rail_track (geom, gauge) VALUES (pg_temp.line(''LINESTRING(0 0,1 1)''), 1)');
SELECT 'so are nine tracks, and a line without length', (test.refusal('UPDATE town.rail_track SET tracks = 9')).state = '23514' AND (test.refusal('INSERT INTO town.rail_track (geom) VALUES (''SRID=2154;LINESTRING EMPTY'')')).state = '23514';
INSERT INTO town.rail_track (rail_track_id, geom) VALUES (8, pg_temp.line('LINESTRING(30 0,50 0,30 0,45 1,45 -9,46 9,30 30)')), (9, pg_temp.line('LINESTRING(120 -60,120 90)')), (10, pg_temp.line('LINESTRING(60 -30,60 30)'));
SELECT 'zigzags have a result, and one that leads across is told as such', (SELECT count(*) > 0 FROM town.street_track WHERE rail_track_id = 8) AND (SELECT borders IS NULL FROM town.street_track WHERE rail_track_id = 10) AND pg_temp.as_from_scratch('town');
-- An editor draws tracks, a reader does not.
CREATE ROLE rail_editor ROLE CURRENT_USER; CREATE ROLE rail_reader ROLE CURRENT_USER;
SELECT streetgen.grant('town', 'rail_editor', 'editor'), streetgen.grant('town', 'rail_reader', 'reader') \g /dev/null
SET ROLE rail_editor;
UPDATE town.rail_track SET geom = ST_Translate(geom, 0, -0.2) WHERE rail_track_id = 2;
SELECT 'an editor moves a track, and the streets follow', bool_and(abs(borders[2] - borders[3] + 3.6) < 1e-6) FROM town.street_track JOIN town.edge USING (edge_id) WHERE rail_track_id = 2 AND axis_id = 2;
SET ROLE rail_reader;
SELECT 'a reader sees the beds and the rails, and draws none', (SELECT count(*) > 5 FROM town.track_bed JOIN town.rail USING (rail_track_id)) AND (SELECT count(*) >= 0 FROM town.rail_crossing) AND test.state('DELETE FROM town.rail_track') = '42501';
RESET ROLE;
SELECT streetgen.revoke('town', 'rail_editor'), streetgen.revoke('town', 'rail_reader') \g /dev/null
DROP ROLE rail_editor; DROP ROLE rail_reader;
-- Tracks of OpenStreetMap, and what a later delivery says.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry);
INSERT INTO osm_line VALUES (1, 'residential', 'high street', NULL, '{"embedded_rails": "tram"}', 2, pg_temp.line('LINESTRING(0 0,100 0)')), (2, 'tram', NULL, NULL, '{"gauge": "1000;1435", "tracks": "2"}', 2, pg_temp.line('LINESTRING(0 2,100 2)')),
  (3, 'residential', 'mill lane', NULL, '{"embedded_rails": "tram"}', 2, pg_temp.line('LINESTRING(0 100,100 100)')), (4, 'residential', 'ring', NULL, '{"railway": "tram", "gauge": "wide"}', 2, pg_temp.line('LINESTRING(0 200,100 200)')),
  (5, 'light_rail', NULL, NULL, '{"layer": "-1", "tunnel": "yes"}', 2, pg_temp.line('LINESTRING(0 300,100 300)')), (6, 'tram', NULL, NULL, '{"location": "underground"}', 2, pg_temp.line('LINESTRING(0 400,100 400)')), (7, 'rail', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(0 500,100 500)'));
SELECT streetgen.create_model('source', 2154, subjects => '{lane,sidewalk,rail}', driving_side => 'right') \g /dev/null
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('source');
SELECT 'tracks, and streets with rails that nobody maps apart, are tracks', array_agg(concat_ws(' ', source_ref, kind, gauge, tracks, level) ORDER BY source_ref) = '{2 tram 1000 2 0,3 tram 1 0,4 tram 1 0,5 light_rail 1 -1}' FROM source.rail_track;
SELECT 'streets with rails are streets', array_agg(source_ref ORDER BY source_ref) = '{1,3,4}' FROM source.axis;
SELECT 'what is taken, left out or not understood is told', (SELECT sum(count) = 2 FROM told WHERE what = 'taken as track') AND (SELECT count = 4 FROM told WHERE what = 'tracks, new or changed') AND (SELECT count = 1 FROM told WHERE what LIKE 'within a building%') AND (SELECT count = 1 FROM told WHERE class = 'rail' AND what LIKE 'not taken%')
  AND (SELECT source_refs = '{4}' FROM told WHERE what LIKE 'gauge not understood%');
SELECT count(*) FROM streetgen.generate('source', wait => true) \g /dev/null
SELECT 'they lie in their streets', array_agg(DISTINCT t.source_ref ORDER BY t.source_ref) = '{2,3,4}' FROM source.street_track JOIN source.rail_track t USING (rail_track_id);
UPDATE source.rail_track SET gauge = 1435 WHERE source_ref = '2';
UPDATE osm_line SET tags = '{"gauge": "1067", "tracks": "2"}' WHERE way_id = 2; DELETE FROM osm_line WHERE way_id = 5; UPDATE osm_line SET tags = '{}' WHERE way_id = 4; UPDATE osm_line SET geom = ST_Translate(geom, 0, 1) WHERE way_id = 3;
TRUNCATE told; INSERT INTO told SELECT * FROM streetgen.import_osm('source');
SELECT 'what is by hand stays, and is in conflict', (SELECT gauge = 1435 FROM source.rail_track WHERE source_ref = '2') AND (SELECT (column_name, by_hand, source_new) = ('gauge', '1435', '1067') FROM source.import_conflict WHERE relation = 'rail_track');
SELECT 'what the source deleted is gone', array_agg(source_ref ORDER BY source_ref) = '{2,3}' FROM source.rail_track;
SELECT count(*) FROM streetgen.generate('source', wait => true) \g /dev/null
TRUNCATE told; INSERT INTO told SELECT * FROM streetgen.import_osm('source');
SELECT 'the same again changes nothing', NOT EXISTS (SELECT FROM told WHERE what IN ('generate is due') OR what LIKE '%vanished%') AND (SELECT count(*) = 2 FROM source.rail_track);
INSERT INTO osm_line VALUES (8, 'residential', 'half', NULL, '{"embedded_rails": "tram"}', 2, pg_temp.line('LINESTRING(0 600,100 600)')), (9, 'tram', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(-60 598.4,24 598.4)')), (10, 'tram', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(-60 601.6,24 601.6)')),
  (11, 'residential', 'whole', NULL, '{"embedded_rails": "tram"}', 2, pg_temp.line('LINESTRING(0 700,100 700)')), (12, 'tram', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(-60 698.4,24 698.4)')), (13, 'tram', NULL, NULL, '{}', 2, pg_temp.line('LINESTRING(70 701.6,160 701.6)'));
SELECT count(*) FROM streetgen.import_osm('source') \g /dev/null
SELECT 'two tracks beside the same part of a street are beside it once', array_agg(source_ref ORDER BY source_ref::integer) = '{8,9,10,12,13}' FROM source.rail_track WHERE source_ref::integer > 7;
