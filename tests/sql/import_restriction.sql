\set ECHO none
\ir shared/truths.sql
-- Turn restrictions as osm2pgsql writes them.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('restricted', 2154);
END $$;
CREATE TABLE town_line (way_id bigint, class text NOT NULL, geom geometry(LineString, 2154));
ALTER TABLE town_line ADD COLUMN name text, ADD lanes text, ADD lanes_forward text, ADD lanes_backward text, ADD width text, ADD oneway text,
  ADD junction text, ADD layer text, ADD bridge text, ADD tunnel text, ADD maxspeed text, ADD area text;
INSERT INTO town_line (way_id, class, geom) VALUES
  (1, 'residential', 'SRID=2154;LINESTRING(649900 6860000,650000 6860000)'), (2, 'residential', 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)'),
  (3, 'residential', 'SRID=2154;LINESTRING(650000 6860000,650000 6860100)'), (5, 'residential', 'SRID=2154;LINESTRING(650000 6860100,650100 6860100)'), (6, 'residential', 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)'), (4, 'footway', 'SRID=2154;LINESTRING(650000 6860000,650000 6859900)');
CREATE TABLE import_report AS SELECT * FROM streetgen.import_osm('restricted', 'town');
SELECT 'without a table of restrictions it is said' AS name, (SELECT count(*) = 1 FROM import_report WHERE what LIKE 'no table of turn restrictions%') AS holds;

CREATE TABLE town_restriction (relation_id bigint, restriction text, from_way bigint, to_way bigint, via_ways text, geom geometry);
INSERT INTO town_restriction SELECT id, restriction, from_way, to_way, via_ways, ST_GeomFromText(CASE WHEN via_ways IS NOT NULL THEN 'GEOMETRYCOLLECTION(LINESTRING(0 0,1 1))' ELSE 'GEOMETRYCOLLECTION(LINESTRING(649900 6860000,650000 6860000),POINT(650000 6860000))' END, 2154)
FROM (VALUES (10, 'no_left_turn', 1, 3, NULL), (10, 'no_left_turn', 1, 3, NULL), (11, 'only_straight_on', 1, 2, NULL), (12, 'no_u_turn', 1, 1, NULL), (13, 'no_entry', 3, 2, NULL),
             (14, NULL, 1, 2, NULL), (15, 'no_dancing', 1, 2, NULL), (16, 'no_left_turn', 1, 2, '4'), (17, 'no_left_turn', 1, 4, NULL), (18, 'no_left_turn', NULL, 3, NULL), (19, 'only_left_turn', 1, NULL, NULL),
             (20, 'no_u_turn', 1, 2, '3,5,6'), (21, 'only_straight_on', 2, 1, '3,5,6'), (22, 'no_u_turn', 1, 2, '5')) v(id, restriction, from_way, to_way, via_ways);
ALTER TABLE town_restriction RENAME via_ways TO kept;
ALTER TABLE town_restriction ADD via_way boolean;
UPDATE town_restriction SET via_way = kept IS NOT NULL;
DROP TABLE import_report;
CREATE TABLE import_report AS SELECT * FROM streetgen.import_osm('restricted', 'town');
SELECT 'a table of an older flex file is to be imported anew', (SELECT array_agg(ref ORDER BY ref) = '{16,20,21,22}' FROM import_report, unnest(source_refs) ref WHERE what = 'turn restriction via ways that its table does not name (import the table anew), left out');
ALTER TABLE town_restriction DROP via_way;
ALTER TABLE town_restriction RENAME kept TO via_ways;
DROP TABLE import_report;
CREATE TABLE import_report AS SELECT * FROM streetgen.import_osm('restricted', 'town');
SELECT 'restrictions name axes, kind and turn', (SELECT array_agg(concat_ws(' ', split_part(r.source_ref, '/', 1), a.source_ref, b.source_ref, r.kind, r.turn) ORDER BY r.source_ref)
    = '{10 1 3 no left,11 1 2 only through,12 1 1 no u_turn,13 3 2 no}' FROM restricted.turn_restriction r JOIN restricted.axis a ON a.axis_id = from_axis JOIN restricted.axis b ON b.axis_id = to_axis WHERE via_axes IS NULL);
SELECT 'their place is the via node', (SELECT bool_and(ST_Equals(geom, 'SRID=2154;POINT(650000 6860000)')) FROM restricted.turn_restriction WHERE via_axes IS NULL);
SELECT 'what is left out is said: ' || what, (SELECT source_refs = ARRAY[ref] FROM import_report r WHERE r.what = 'turn restriction ' || e.what || ', left out')
    FROM (VALUES ('not for all traffic', '14'), ('not understood', '15'), ('via ways that do not follow each other', '22')) e(what, ref);
SELECT 'and one of ways, or via ways, that are no axes', (SELECT array_agg(ref ORDER BY ref) = '{16,17}' FROM import_report, unnest(source_refs) ref WHERE what = 'turn restriction of ways that are no axes, left out');
SELECT 'one via ways names them in the order in which they are driven', (SELECT array_agg(concat_ws(' ', r.source_ref, (SELECT string_agg(a.source_ref, ',' ORDER BY i) FROM unnest(via_axes) WITH ORDINALITY u(axis_id, i) JOIN restricted.axis a USING (axis_id))) ORDER BY r.source_ref)
    = '{"20/1/2 3,5,6","21/2/1 6,5,3"}' FROM restricted.turn_restriction r WHERE via_axes IS NOT NULL);
SELECT 'with the places where it begins, passes and ends', (SELECT ST_AsText(geom) = 'POINT(650000 6860000)' AND ST_AsText(via_geom) LIKE 'MULTIPOINT(%650000 6860050%,%650050 6860100%,%650100 6860050%)' AND ST_AsText(to_geom) = 'POINT(650100 6860000)' FROM restricted.turn_restriction WHERE source_ref LIKE '20/%');
SELECT 'and is counted', (SELECT sum(count) = 2 FROM import_report WHERE what LIKE 'turn restrictions via ways%');
ALTER TABLE town_restriction ADD held_for text DEFAULT '';
UPDATE town_restriction SET held_for = CASE relation_id WHEN 11 THEN 'hgv' WHEN 12 THEN 'conditional' WHEN 13 THEN 'hours' ELSE '' END;
CREATE TABLE limited AS SELECT * FROM streetgen.import_osm('restricted', 'town') WHERE what LIKE 'turn restriction %';
SELECT 'a limited restriction is told: ' || what, (SELECT array_agg(ref) = ARRAY[e.ref] FROM limited l, unnest(source_refs) ref WHERE l.what LIKE 'turn restriction ' || e.what || ',%')
    FROM (VALUES ('not for all traffic', '11'), ('at times only', '12'), ('without a word on its turn', '14'), ('at hours of a day', '13')) e(what, ref);
SELECT 'and holds at all times, or not at all', (SELECT array_agg(DISTINCT split_part(source_ref, '/', 1)) && '{13}' AND NOT array_agg(split_part(source_ref, '/', 1)) && '{11,12}' FROM restricted.turn_restriction);
UPDATE town_restriction SET held_for = CASE relation_id WHEN 10 THEN ',conditional,hgv' WHEN 11 THEN 'conditional,hgv' ELSE '' END;
CREATE TABLE further AS SELECT * FROM streetgen.import_osm('restricted', 'town') WHERE what LIKE 'turn restriction %';
SELECT 'of several keys each is told: ' || what, (SELECT array_agg(ref ORDER BY ref) = refs FROM further f, unnest(source_refs) ref WHERE f.what = 'turn restriction ' || e.what || ', left out')
    FROM (VALUES ('not for all traffic', '{10,11}'::text[]), ('at times only', '{10,11}')) e(what, refs);
SELECT 'and the one for all holds', (SELECT array_agg(split_part(source_ref, '/', 1)) @> '{10}' AND NOT array_agg(split_part(source_ref, '/', 1)) && '{11}' FROM restricted.turn_restriction);
ALTER TABLE town_restriction DROP held_for;
SELECT FROM streetgen.import_osm('restricted', 'town') \g /dev/null
SELECT 'also one that lacks a way', (SELECT array_agg(ref ORDER BY ref) = '{18,19}' FROM import_report, unnest(source_refs) ref WHERE what = 'turn restriction without the way that it leads from or to, left out');
ALTER TABLE town_restriction ADD COLUMN excepted text;
UPDATE town_restriction SET excepted = CASE relation_id WHEN 10 THEN 'no' WHEN 11 THEN 'psv; bicycle' WHEN 12 THEN 'bus;psv' WHEN 13 THEN 'taxi;Bicycle;xyzzy' END;
SELECT 'an exception for traffic without lanes is said, and so is a word that is none', (SELECT array_agg(source_refs ORDER BY class) = ARRAY['{13}'::text[]] FROM (SELECT source_refs, class FROM streetgen.import_osm('restricted', 'town') WHERE what = 'turn restriction with an exception for taxi, xyzzy, taken for these too') r);
SELECT 'one for traffic that has lanes is read, and no is none', (SELECT array_agg(concat(split_part(source_ref, '/', 1), ' ', except_kinds) ORDER BY source_ref) = '{"10 ","11 bus|cycle","12 bus","13 cycle"}' FROM restricted.turn_restriction WHERE via_axes IS NULL);
UPDATE town_restriction SET excepted = NULL WHERE relation_id = 12;
SELECT FROM streetgen.import_osm('restricted', 'town') \g /dev/null
SELECT 'one that goes goes', (SELECT except_kinds IS NULL FROM restricted.turn_restriction WHERE source_ref LIKE '12/%');
DELETE FROM town_restriction WHERE relation_id = 11;
CREATE TABLE before AS SELECT turn_restriction_id, xmin::text AS writer FROM restricted.turn_restriction;
DO $$ BEGIN
  INSERT INTO restricted.turn_restriction (from_axis, to_axis, geom, kind) VALUES (2, 3, 'SRID=2154;POINT(650000 6860000)', 'no');
  PERFORM streetgen.import_osm('restricted', 'town');
END $$;
SELECT 'importing again follows the table', NOT EXISTS (SELECT FROM restricted.turn_restriction WHERE source_ref LIKE '11/%');
SELECT 'and leaves the others untouched', (SELECT count(*) = 5 FROM restricted.turn_restriction r JOIN before USING (turn_restriction_id) WHERE r.xmin::text = writer);
SELECT 'one made by hand stays', (SELECT count(*) = 1 FROM restricted.turn_restriction WHERE source IS NULL);
SELECT 'a kind that is none is refused', test.state($q$INSERT INTO restricted.turn_restriction (from_axis, to_axis, geom, kind) VALUES (2, 3, 'SRID=2154;POINT(0 0)', 'maybe')$q$) = '23514';
-- By hand and by the source: each keeps its column, and one that both changed is told.
UPDATE restricted.turn_restriction SET except_kinds = 'bus|cycle' WHERE source_ref LIKE '10/%' OR source_ref LIKE '13/%';
DELETE FROM restricted.turn_restriction WHERE source_ref LIKE '12/%';
UPDATE town_restriction SET restriction = 'no_right_turn' WHERE relation_id = 10;
UPDATE town_restriction SET excepted = 'psv' WHERE relation_id IN (12, 13);
CREATE TABLE merged AS SELECT * FROM streetgen.import_osm('restricted', 'town') WHERE class = 'turn_restriction';
SELECT 'what is by hand stays beside what the source changed', turn = 'right' AND except_kinds = 'bus|cycle' FROM restricted.turn_restriction WHERE source_ref LIKE '10/%';
SELECT 'what both changed stays by hand, and is told', except_kinds = 'bus|cycle' AND source_new = 'bus' FROM restricted.turn_restriction JOIN restricted.import_conflict c ON row_id = turn_restriction_id AND column_name = 'except_kinds' WHERE turn_restriction.source_ref LIKE '13/%';
SELECT 'one deleted by hand stays away', count(*) = 0 FROM restricted.turn_restriction WHERE source_ref LIKE '12/%';
SELECT 'both are reported', array_agg(what || ' ' || count ORDER BY what) = '{"by hand, kept 1","in conflict 2"}' FROM merged;
SELECT streetgen.settle_conflict('restricted', row_id, column_name, 'source', 'turn_restriction') FROM restricted.import_conflict WHERE relation = 'turn_restriction' \g /dev/null
SELECT 'settled for the source', string_agg(split_part(source_ref, '/', 1) || ' ' || coalesce(except_kinds, ''), ',' ORDER BY source_ref) FILTER (WHERE source_ref ~ '^1[023]/') = '10 bus|cycle,12 bus,13 bus' FROM restricted.turn_restriction;
DROP TABLE town_line, town_restriction, import_report, before, merged;
