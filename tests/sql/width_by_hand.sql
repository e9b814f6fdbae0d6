\set ECHO none
\ir shared/truths.sql
-- Which widths are believed, and what importers leave alone.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 2154) \g /dev/null
CREATE TABLE source (id text, width float8, width_end float8, lanes integer, geom geometry(LineString, 2154));
INSERT INTO source SELECT 'r' || i, 5, NULL, 1, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000, 6860000 + 50 * i), ST_MakePoint(650100, 6860000 + 50 * i)), 2154) FROM generate_series(1, 4) i;
\set import 'SELECT * FROM streetgen.import_axes(''town'', ''source'', ''{"source_ref": "id", "width": "width", "width_end": "width_end", "lane_count": "lanes"}'')'
:import \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
CREATE FUNCTION pg_temp.widths(known text) RETURNS text LANGUAGE sql AS $$ SELECT concat(a.width, ' ', a.width_end, ' ', a.width_by_hand, ' ', a.source_width, ' used ', e.width, ' ', e.width_end)
    FROM town.axis a JOIN town.edge e USING (axis_id) WHERE source_ref = known $$;
SELECT 'imported, it is the source''s', pg_temp.widths('r1') = '5  f  used 5 5';

-- Typing a width that the lane of the source would not allow.
UPDATE town.axis_editing SET width = 12 WHERE axis_id = (SELECT axis_id FROM town.axis WHERE source_ref = 'r1');
SELECT 'a width typed is believed', pg_temp.widths('r1') = '12  t 5 used 12 12' AND (SELECT NOT 'width' = ANY (estimated) FROM town.axis_used JOIN town.axis USING (axis_id) WHERE source_ref = 'r1');
UPDATE town.axis SET width_end = 14 WHERE source_ref = 'r2';
SELECT 'so is one of the end', pg_temp.widths('r2') = '5 14 t 5 used 5 14';
UPDATE town.axis SET name = 'high street', geom = ST_Translate(geom, 0, 1) WHERE source_ref = 'r3';
SELECT 'what leaves the width alone does not make it by hand', pg_temp.widths('r3') = '5  f  used 5 5';
SELECT 'check_model has nothing to say of them', count(*) = 0 FROM streetgen.check_model('town') WHERE rule LIKE 'width%';

-- Importing again.
CREATE TABLE report AS :import;
SELECT 'importing again keeps them and reports that they are by hand', source_refs = '{r1,r2,r3}' FROM report WHERE what = 'by hand, kept';
SELECT 'they are as they were', pg_temp.widths('r1') = '12  t 5 used 12 12' AND pg_temp.widths('r2') = '5 14 t 5 used 5 14';
UPDATE source SET width = 5.25, geom = ST_Translate(geom, 1, 0);
DROP TABLE report; CREATE TABLE report AS :import;
SELECT streetgen.generate('town') \g /dev/null
SELECT 'so does one of rows that changed', source_refs @> '{r1,r2}' FROM report WHERE what = 'in conflict';
SELECT 'which takes all but the width', pg_temp.widths('r1') = '12  t 5.25 used 12 12' AND (SELECT ST_Equals(geom, (SELECT geom FROM source WHERE id = 'r1')) FROM town.axis WHERE source_ref = 'r1');
SELECT 'and the width of an axis that has none by hand', pg_temp.widths('r3') = '5.25  f  used 5.25 5.25';
UPDATE town.axis_editing SET width = NULL WHERE axis_id = (SELECT axis_id FROM town.axis WHERE source_ref = 'r1');
SELECT 'an empty width is the source''s', pg_temp.widths('r1') = '5.25  f  used 5.25 5.25';
UPDATE town.axis SET width_by_hand = false WHERE source_ref = 'r2';
SELECT 'so it is where width_by_hand is set to false', pg_temp.widths('r2') = '5.25  f  used 5.25 5.25';
UPDATE town.axis SET width = NULL WHERE source_ref = 'r1';
SELECT 'emptied once more it is estimated', pg_temp.widths('r1') = '  f  used 3.5 3.5';
DROP TABLE report; CREATE TABLE report AS :import;
SELECT 'then none is by hand any more', NOT bool_or(source_refs && '{r1,r2}') FROM report WHERE what IN ('by hand, kept', 'in conflict');

-- A source is judged, at both ends; who has no source is not.
UPDATE source SET width = 12, width_end = NULL WHERE id = 'r1';
UPDATE source SET width = 5, width_end = 12 WHERE id = 'r2';
DROP TABLE report; CREATE TABLE report AS :import;
SELECT streetgen.generate('town') \g /dev/null
SELECT 'a width of a source is not believed', pg_temp.widths('r1') = '12  f  used 3.5 3.5';
SELECT 'nor is one of the end', pg_temp.widths('r2') = '5 12 f  used 5 5';
SELECT 'the import reports both', array_agg(concat(what, source_refs) ORDER BY what) = ARRAY['width not believed{r1}', 'width_end not believed{r2}'] FROM report WHERE what LIKE '%not believed';
SELECT 'and check_model', array_agg(concat(rule, measure) ORDER BY rule) = ARRAY['width not believed, m12', 'width_end not believed, m12'] FROM streetgen.check_model('town') WHERE rule LIKE 'width%';
UPDATE town.axis SET width_by_hand = true WHERE source_ref = 'r1';
SELECT 'unless who knows better says so', pg_temp.widths('r1') = '12  t 12 used 12 12';
INSERT INTO town.axis_editing (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(651000 6860000,651100 6860000)', 12, 1);
SELECT 'an axis without a source is believed', (e.width, e.width_end) = (12, 12) FROM town.edge e JOIN town.axis a USING (axis_id) WHERE source IS NULL;
UPDATE town.axis SET width = NULL WHERE source IS NULL;
SELECT 'and estimated where its width is emptied', (a.width, a.width_by_hand, e.width) IS NOT DISTINCT FROM (NULL, false, 3.5) FROM town.edge e JOIN town.axis a USING (axis_id) WHERE source IS NULL;
SELECT 'an edit changes what a run from scratch would', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');

-- A table that is followed: its rows are a source, and its changes no edits by hand.
SELECT streetgen.follow('town', 'source', '{"source_ref": "id", "width": "width", "width_end": "width_end", "lane_count": "lanes"}') \g /dev/null
SELECT streetgen.generate('town') \g /dev/null
UPDATE source SET width = 4 WHERE id IN ('r3', 'r4');
SELECT 'what a followed table says is the source''s', pg_temp.widths('r3') = '4  f  used 4 4';
UPDATE town.axis SET width = 9 WHERE source_ref = 'r3';
UPDATE source SET width = 4.5 WHERE id IN ('r3', 'r4');
SELECT 'a width by hand outlives it', pg_temp.widths('r3') = '9  t 4.5 used 9 9' AND pg_temp.widths('r4') = '4.5  f  used 4.5 4.5';

-- Models of builds before have no such columns.
SELECT streetgen.create_model('older', 2154) \g /dev/null
ALTER TABLE older.axis DROP source_width, DROP source_width_end, DROP width_by_hand CASCADE;
SELECT streetgen.adopt_model('older') \g /dev/null
INSERT INTO older.axis (geom, width, lane_count, source, source_ref) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 5, 1, 's', 'a');
UPDATE older.axis SET width = 12;
SELECT 'a model of a build before gets them', (width_by_hand, source_width) = (true, 5) FROM older.axis;

-- A width that leaves a car no room.
CREATE TABLE small AS SELECT i AS id, w AS width, w2 AS width_end, n AS lanes, k AS class, ST_SetSRID(ST_MakeLine(ST_MakePoint(670000, 6860000 + 50 * i), ST_MakePoint(670100, 6860000 + 50 * i)), 2154) AS geom
  FROM (VALUES (1, 1::float8, NULL::float8, 2, 'primary'), (2, 1.5, NULL, NULL, 'residential'), (3, 3.9, 6, 2, 'service'), (4, 4, 3, 2, 'service'), (5, 1, NULL, 2, 'cycleway'), (6, 7, NULL, 12, 'primary')) v(i, w, w2, n, k);
SELECT streetgen.create_model('alley', 2154) \g /dev/null
UPDATE alley.axis_class c SET width = w, taken = true, use = 'roadway', lanes_by_width = true FROM (VALUES ('cycleway', 2), ('primary', 8), ('residential', 6), ('service', 5)) v(class, w) WHERE c.class = v.class;
CREATE TABLE narrow AS SELECT * FROM streetgen.import_axes('alley', 'small', '{"source_ref": "id", "width": "width", "width_end": "width_end", "lane_count": "lanes", "kind": "class"}');
SELECT streetgen.generate('alley') \g /dev/null
SELECT 'a roadway has room for a car on each lane, and for one, but none beyond its class', string_agg(concat(source_ref, ': ', e.width, ' to ', e.width_end), ', ' ORDER BY source_ref)
  = '1: 4 to 4, 2: 2 to 2, 3: 4 to 6, 4: 4 to 4, 5: 1 to 1, 6: 8 to 8' FROM alley.edge e JOIN alley.axis USING (axis_id);
SELECT 'the import names the axes with what they say', string_agg(concat(what, source_refs), ', ' ORDER BY what) = 'width too small: 1 m, taken as 4 m{1}, width too small: 1.5 m, taken as 2 m{2}, width too small: 3.9 m, taken as 4 m{3}, '
  'width too small: 7 m, taken as 8 m{6}, width_end too small: 3 m, taken as 4 m{4}' FROM narrow WHERE what LIKE 'width%';
SELECT 'and check_model', string_agg(concat(rule, ' ', measure, ' ', source_ref), ', ' ORDER BY source_ref) = 'width too small, m 1 1, width too small, m 1.5 2, width too small, m 3.9 3, width_end too small, m 3 4, width too small, m 7 6'
  FROM streetgen.check_model('alley') JOIN alley.axis ON axis_id = id WHERE rule LIKE 'width%';
UPDATE alley.axis SET width_by_hand = true WHERE source_ref = '1';
SELECT 'a width by hand is taken', e.width = 1 FROM alley.edge e JOIN alley.axis USING (axis_id) WHERE source_ref = '1';
SELECT 'and told no more', count(*) = 4 FROM streetgen.check_model('alley') WHERE rule LIKE 'width%';
INSERT INTO alley.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(671000 6860000,671100 6860000)', 1, 2);
SELECT 'so is one of an axis without a source', e.width = 1 FROM alley.edge e JOIN alley.axis USING (axis_id) WHERE source IS NULL;

-- What is said in the statement that gives a width: psql shows it beside the rows.
\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=notice'
CREATE TABLE wide AS SELECT i AS id, 5 AS width, 1 AS lanes, ST_SetSRID(ST_MakeLine(ST_MakePoint(660000, 6860000 + 50 * i), ST_MakePoint(660100, 6860000 + 50 * i)), 2154) AS geom FROM generate_series(1, 40) i;
SELECT streetgen.create_model('told', 2154) \g /dev/null
SELECT count(*) FROM streetgen.follow('told', 'wide', '{"source_ref": "id", "width": "width", "lane_count": "lanes"}') \g /dev/null
SELECT streetgen.generate('told') \g /dev/null
\! psql -qXAt -c "UPDATE wide SET width = 12 WHERE id = 1" 2>&1 | grep -q 'width 12 m of axis 1 is not believed.*max_width_per_lane' && holds=t || holds=f; printf 'a width that is not believed is told with axis, width and setting\t%s\n' $holds
\! test "$(psql -qXAt -c 'UPDATE wide SET width = 13' 2>&1 | grep 'NOTICE' | sed 's/.*axis 1 .*nor are/nor are/')" = 'nor are 39 others' && holds=t || holds=f; printf 'many of them by one notice\t%s\n' $holds
\! test -z "$(psql -qXAt -c "UPDATE told.axis SET name = 'wide'" -c 'UPDATE told.axis SET width = 5.5' 2>&1)" && holds=t || holds=f; printf 'edits of something else, and usual widths by hand, by none\t%s\n' $holds
\! test -z "$(psql -qXAt -c "UPDATE told.axis SET width = 7, lane_count = 1, roundabout_tag = 'roundabout' WHERE axis_id = 1" 2>&1)" && holds=t || holds=f; printf 'nor is the width of a lane of a roundabout, which is believed\t%s\n' $holds
