\set ECHO none
\ir shared/truths.sql
-- One styled picture.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('drawn', 2154) \g /dev/null
INSERT INTO drawn.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7);
DO $$ BEGIN PERFORM streetgen.generate('drawn'); END $$;
SELECT 'svg draws', streetgen.svg('drawn') LIKE '<svg%</svg>' || E'\n';
SELECT 'a map of a town shows the roadway alone', svg LIKE '%class="section"%' AND svg NOT LIKE '%class="axis"%' AND svg NOT LIKE '%class="limit"%' FROM streetgen.svg('drawn', ST_MakeEnvelope(648000, 6859000, 652000, 6861000, 2154), theme => 'construction') svg;
SELECT 'as a street is seen it has no axis and no limit', svg LIKE '%class="section"%' AND svg LIKE '%class="lane_separator"%' AND svg !~ 'class="(axis|limit|arc|path)"' FROM streetgen.svg('drawn') svg;
SELECT 'beyond 1:1,500 there is no paint', svg LIKE '%class="section"%' AND svg NOT LIKE '%class="lane_separator"%' FROM streetgen.svg('drawn', scale => 1501) svg;
SELECT 'beyond 1:5,000 streets go by importance, beyond 1:15,000 they are lines', near LIKE '%class="roadway"%' AND near NOT LIKE '%class="section"%' AND far LIKE '%class="street"%' AND far NOT LIKE '%class="roadway"%'
  FROM streetgen.svg('drawn', scale => 5001, width => 400) near, streetgen.svg('drawn', scale => 15001, width => 400) far;
SELECT 'a scale gives the width, a pixel for 0.28 mm', svg LIKE format('%%width="%s" %%', round(120 / 500.0 / 0.00028)) FROM streetgen.svg('drawn', scale => 500) svg;
SELECT 'half a pixel is not drawn', svg NOT LIKE '%<path%' FROM streetgen.svg('drawn', ST_MakeEnvelope(550000, 6760000, 750000, 6960000, 2154), width => 300) svg;
SELECT call || ' is refused', state = '22023' AND hint <> '' FROM unnest('{theme => ''night'',scale => 0,scale => ''NaN'',scale => 1e9,width => 15,width => 20001}'::text[]) call, test.refusal('SELECT streetgen.svg(''drawn'', ' || call || ')');
SELECT 'a theme has colours of its rules alone', count(*) > 3 AND bool_and(EXISTS (SELECT FROM streetgen.symbol_rule r WHERE r.theme = t.theme AND colour IN (r.fill, r.line))) FROM (VALUES ('street'), ('dark'), ('construction')) t(theme), streetgen.svg('drawn', legend => true, theme => t.theme) svg, regexp_matches(svg, '#[0-9a-fA-F]{3,8}', 'g') m, LATERAL (SELECT m[1] AS colour) c;
SELECT 'a rule is of a layer that a room draws', count(*) > 20 AND bool_and(EXISTS (SELECT FROM pg_proc WHERE proname ~ '(_drawn|_svg|_drawing)$' AND prosrc ~ format('''%s[ '']', layer))) FROM (SELECT DISTINCT layer FROM streetgen.symbol_rule WHERE layer NOT IN ('ground', 'paper', 'ink', 'name', 'handle')) l;
SELECT 'and each layer that a room draws has a rule', count(*) > 20 AND bool_and(EXISTS (SELECT FROM streetgen.symbol_rule r WHERE r.layer = m[1])) FROM pg_proc, regexp_matches(prosrc, '''(\w+)'' = ANY \(layers\)', 'g') m WHERE proname ~ '^_\w+_drawn$';
SELECT 'a colour that is none is refused: ' || colour, test.state(format('INSERT INTO drawn.symbol_rule (theme, layer, place, fill) VALUES (''street'', ''mud'', 0, %L)', colour)) = '23514' FROM unnest('{red,#fff,#GGGGGG,"#12345678 "}'::text[]) colour;
SELECT 'so is a rule that is drawn at no scale', test.state('INSERT INTO drawn.symbol_rule (theme, layer, place, from_scale, to_scale) VALUES (''street'', ''mud'', 0, 10, 10)') = '23514';
SELECT 'plans are drawn by rules of theme construction', styles ->> 'signal_plan red' = format('fill:%s;fill-rule:evenodd', fill) AND styles ->> 'mud' IS NULL FROM streetgen.symbol_rule, streetgen._plan_styles('drawn', 1) styles WHERE (theme, layer, kind) = ('construction', 'signal_plan', 'red');
SELECT 'an extent in another reference is refused', state = '22023' AND said = 'the extent has SRID 4326, the model 2154' AND hint <> '' FROM test.refusal($$SELECT streetgen.svg('drawn', ST_MakeEnvelope(2, 48, 3, 49, 4326))$$);
SELECT 'one without a reference is the model''s', streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859950, 650100, 6860050)) = streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859950, 650100, 6860050, 2154));
SELECT 'a street under construction shows its axis', svg LIKE '%class="axis"%' FROM streetgen.svg('drawn', theme => 'construction') svg;
SELECT 'and over it the line in its middle', strpos(svg, 'class="axis') BETWEEN 1 AND strpos(svg, 'class="lane_separator') FROM streetgen.svg('drawn', theme => 'construction') svg;
CREATE FUNCTION pg_temp.drawn(svg text, class text) RETURNS bigint LANGUAGE sql AS $$ SELECT coalesce(sum(regexp_count(m[1], '<path')), 0) FROM regexp_matches(svg, format('<g class="%s"[^>]*>((?:\s*<path [^>]*>)*)', class), 'g') m $$;
-- Two streets that leave a short one on its two sides: its limits cross.
INSERT INTO drawn.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650100 6860000,650106 6860000)', 7), ('SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 14), ('SRID=2154;LINESTRING(650106 6860000,650106 6859900)', 14);
SELECT 'lanes between crossed limits are drawn as paths', (SELECT count(*) > 0 FROM drawn.lane WHERE method = 'crossed_limits')
    AND pg_temp.drawn(svg, 'path(?: implausible)?') = (SELECT count(*) FROM drawn.interconnection) AND pg_temp.drawn(svg, 'lane_path') = (SELECT count(*) FROM drawn.lane WHERE method = 'crossed_limits') FROM streetgen.svg('drawn', theme => 'construction') svg;
SELECT 'a legend says each thing that is drawn, once: ' || theme, (SELECT array_agg(DISTINCT meaning ORDER BY meaning) FROM regexp_matches(map, 'class="(\w+) ?(\w*)"', 'g') m JOIN streetgen.symbol_rule r ON (r.layer, r.kind, r.theme) = (m[1], m[2], t.theme) AND from_scale < 300 AND to_scale >= 300 WHERE meaning IS NOT NULL) = (SELECT array_agg(m[1] ORDER BY m[1]) FROM regexp_matches(beside, '<text x="44"[^>]*>([^<]*)<', 'g') m)
FROM unnest('{street,construction}'::text[]) t(theme), LATERAL (SELECT split_part(svg, '<svg x=', 1) AS map, split_part(svg, '<svg x=', 2) AS beside FROM streetgen.svg('drawn', legend => true, theme => t.theme, scale => 300) svg) s;
SELECT 'the map beside it is the same', strpos(with_legend, regexp_replace(without, '^<svg xmlns="[^"]*"', '<svg')) > 0 FROM streetgen.svg('drawn') without, streetgen.svg('drawn', legend => true) with_legend;
SELECT 'a picture with a legend is XML, and as much wider as the legend is', xml_is_well_formed_document(svg) AND svg LIKE '<svg xmlns="http://www.w3.org/2000/svg" width="750" %' FROM streetgen.svg('drawn', width => 600, legend => true) svg;
SELECT 'a map of a town has the roadway alone in its legend', svg LIKE '%>roadway<%' AND (SELECT count(*) = 1 FROM regexp_matches(svg, '<text x="44"', 'g')) FROM streetgen.svg('drawn', ST_MakeEnvelope(648000, 6859000, 652000, 6861000, 2154), legend => true, theme => 'construction') svg;
SELECT 'the bar of the scale is as long as it says', abs(bar[1]::float8 * 200 / 1200 - bar[2]::float8) < 0.01 AND bar[2]::float8 IN (10, 20) FROM regexp_match(streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859900, 650200, 6860000), legend => true), 'M0 0v8h([\d.]+)v-8.*>(\d+) m</text>') bar;
-- The model's own rules.
CREATE TEMPORARY TABLE before AS SELECT streetgen.svg('drawn', scale => 300) AS svg;
INSERT INTO drawn.symbol_rule SELECT theme, layer, kind, from_scale, to_scale, place, '#123456', line, width, unit, dash, marker, meaning FROM streetgen.symbol_rule WHERE (theme, layer, kind) = ('street', 'section', '');
SELECT 'a rule of the model stands for the one that it has the key of', picture LIKE '%fill:#123456;%' AND b.svg NOT LIKE '%#123456%' AND length(picture) = length(b.svg) FROM before b, LATERAL (SELECT streetgen.svg('drawn', scale => 300) AS picture) p;
SELECT 'and another model has that of all', streetgen.svg('drawn', theme => 'dark') NOT LIKE '%#123456%';
UPDATE drawn.symbol_rule SET fill = NULL, line = NULL;
SELECT 'one without a colour draws nothing', svg NOT LIKE '%class="section"%' AND svg LIKE '%class="intersection"%' FROM streetgen.svg('drawn', scale => 300) svg;
INSERT INTO drawn.symbol_rule (theme, layer, kind, place, line, width, unit) VALUES ('street', 'axis', '', 9, '#ff0000', 1, 'pixel');
SELECT 'a layer that the theme leaves out can be added', svg LIKE '%class="axis"%' AND svg LIKE '%stroke:#ff0000%' FROM streetgen.svg('drawn', scale => 300) svg;
INSERT INTO drawn.symbol_rule (theme, layer, place, fill) VALUES ('dark', 'mud', 0, '#ff0000');
SELECT 'a layer that is none is refused with its rule', state = '22023' AND said LIKE '%drawn.symbol_rule%"mud"%' AND detail LIKE '%dark%' FROM test.refusal($$SELECT streetgen.svg('drawn')$$);
DELETE FROM drawn.symbol_rule;
INSERT INTO drawn.symbol_rule (theme, layer, kind, place, fill) VALUES ('street', 'lane', 'bycicle', 3, '#ff0000'), ('street', 'lane', 'bus', 3, NULL), ('street', 'lane_separator', 'centre', 4, '#ff0000'), ('street', 'section', '', 1, '#ff0000');
\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=notice'
\! told=$(psql -qXAt -c "SELECT streetgen.svg('drawn', scale => 300)" 2>&1 >/dev/null); test "$(echo "$told" | grep -cE "NOTICE|\"bycicle\" of layer lane draws nothing")$(echo "$told" | grep -c "HINT.*'bus', 'cycle'")" = 11 && holds=t || holds=f; printf 'a kind that is none is told, with the kinds that there are\t%s\n' $holds
\! test -z "$(psql -qXAt -c "SELECT streetgen.svg('drawn', theme => 'dark')" 2>&1 >/dev/null)" && holds=t || holds=f; printf 'another theme tells nothing of it\t%s\n' $holds
\setenv PGOPTIONS
DELETE FROM drawn.symbol_rule;
SELECT 'without them it is drawn as before', before.svg = streetgen.svg('drawn', scale => 300) FROM before;
CREATE ROLE streetgen_test_drawer ROLE CURRENT_USER;
DO $$ BEGIN PERFORM streetgen.grant('drawn', 'streetgen_test_drawer', 'editor'); END $$;
SELECT 'an editor reads rules and writes none', has_table_privilege('streetgen_test_drawer', 'drawn.symbol_rule', 'SELECT') AND NOT has_table_privilege('streetgen_test_drawer', 'drawn.symbol_rule', 'INSERT') AND NOT has_table_privilege('streetgen_test_drawer', 'streetgen.symbol_rule', 'INSERT');
REVOKE SELECT ON drawn.symbol_rule FROM streetgen_test_drawer;
SET ROLE streetgen_test_drawer;
SELECT 'who may not read the rules is told what to ask for', state = '42501' AND said LIKE '%streetgen_test_drawer%drawn%' AND hint LIKE 'GRANT SELECT ON drawn.symbol_rule TO streetgen_test_drawer %' FROM test.refusal($$SELECT streetgen.svg('drawn')$$);
RESET ROLE;
DROP OWNED BY streetgen_test_drawer; DROP ROLE streetgen_test_drawer;
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'a model without axes has a picture and a legend', xml_is_well_formed_document(streetgen.svg('bare')) AND xml_is_well_formed_document(streetgen.svg('bare', legend => true));

-- Rules of any kind leave a picture.
INSERT INTO drawn.symbol_rule (theme, layer, place, fill) VALUES ('street', 'ground', 0, NULL), ('street', 'paper', 0, NULL), ('street', 'ink', 0, NULL);
SELECT 'without ground, paper and ink the streets are drawn', svg LIKE '%class="section"%' AND svg NOT LIKE '%#f1ebdf%' AND xml_is_well_formed_document(svg) FROM streetgen.svg('drawn', scale => 300, legend => true) svg;
UPDATE drawn.symbol_rule SET place = 1, fill = '#abcdef' WHERE layer = 'ground';
SELECT 'a second ground lies over the first', strpos(svg, '#abcdef') > strpos(svg, '#f1ebdf') AND strpos(svg, '#f1ebdf') > 0 FROM streetgen.svg('drawn', scale => 300) svg;
DELETE FROM drawn.symbol_rule;
SELECT 'a box without streets has its ground', svg LIKE '%<rect %fill="#f1ebdf"%' FROM streetgen.svg('drawn', ST_MakeEnvelope(660000, 6860000, 660100, 6860100)) svg;
INSERT INTO drawn.symbol_rule (theme, layer, place, fill, meaning) VALUES ('street', 'section', 2, '#ff0000', '<script>"R&D"</script>'), ('street', 'section', 3, '#ff0001', NULL);
SELECT 'words of a rule are no markup', svg LIKE '%>&lt;script>&quot;R&amp;D&quot;&lt;/script><%' AND xml_is_well_formed_document(svg) FROM streetgen.svg('drawn', scale => 300, legend => true) svg;
ALTER TABLE drawn.symbol_rule ADD own integer;
SELECT 'a column of the user is borne', streetgen.svg('drawn', scale => 300) LIKE '%#ff0000%';
ALTER TABLE drawn.symbol_rule DROP own;
DELETE FROM drawn.symbol_rule;
SELECT 'a number that is none is refused: ' || attribute, test.state(format('INSERT INTO drawn.symbol_rule (theme, layer, place, fill, unit, width) SELECT ''street'', ''section'', 5, ''#ffffff'', ''metre'', 1 UNION ALL SELECT ''street'', ''section'', %s, ''#ffffff'', ''metre'', %s', place, width)) = '23514' FROM (VALUES ('''NaN''::float8', '1', 'place'), ('6', '''NaN''::float8', 'width NaN'), ('6', '''Infinity''::float8', 'width')) v(place, width, attribute);
SELECT 'paint keeps the four corners of its stripes', count(*) > 0 AND bool_and(regexp_count(streetgen._shape_as_svg(surface, 650000, 6860000, 0.42), '-?[0-9.]+') >= 8 * ST_NumGeometries(surface)) FROM drawn.lane_separator WHERE NOT ST_IsEmpty(surface);
SELECT streetgen.create_model('unlaned', 2154, subjects => '{bridge}') \g /dev/null
CREATE TABLE public.lane_separator (edge_id text);
SELECT 'a table of another schema is not drawn', streetgen.svg('unlaned') LIKE '<svg%';
DROP TABLE public.lane_separator;

-- Names along streets.
SELECT streetgen.create_model('named', 2154) \g /dev/null
INSERT INTO named.axis (geom, width, name) VALUES ('SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 7, 'Rue de l’Étoile'), ('SRID=2154;LINESTRING(650200 6860000,650200 6859800)', 7, '<img onerror="x">&'), ('SRID=2154;LINESTRING(650200 6860000,650380 6860080)', 7, repeat('long ', 60)),
  ('SRID=2154;LINESTRING(650000 6860000,650000 6860200)', 7, 'شارع الملك'), ('SRID=2154;LINESTRING(650000 6860200,650200 6860200)', 7, '🚲 Straße'), ('SRID=2154;LINESTRING(650200 6860200,650260 6860200)', 7, 'Avenue of the long and winding Street'), ('SRID=2154;LINESTRING(650260 6860200,650260 6860215)', 7, 'Too long for it');
DO $$ BEGIN PERFORM streetgen.generate('named'); END $$;
CREATE FUNCTION pg_temp.named(svg text) RETURNS TABLE(words text, turns float8[]) LANGUAGE sql AS $$ SELECT string_agg(t[2], '' ORDER BY k), array_agg(t[1]::float8 ORDER BY k) FROM regexp_matches(svg, '<g class="name"[^>]*>((?:<text [^>]*>[^<]*</text>)*)</g>', 'g') WITH ORDINALITY m(piece, n), regexp_matches(piece[1], 'rotate\(([-\d.]+)\)">([^<]*)<', 'g') WITH ORDINALITY r(t, k) GROUP BY n $$;
CREATE TEMPORARY TABLE written AS SELECT * FROM pg_temp.named(streetgen.svg('named', scale => 1000));
SELECT 'a name stands along its street, letter by letter', count(*) = 1 AND bool_and(cardinality(turns) = 13 AND -0.1 < ALL (turns) AND 0.1 > ALL (turns)) FROM written WHERE words = 'Ruedel’Étoile';
SELECT 'each is upright', count(*) >= 4 AND bool_and(-90 <= ALL (turns) AND 90 >= ALL (turns)) FROM written;
SELECT 'what is no letter of XML is written as it is', xml_is_well_formed_document(streetgen.svg('named', scale => 1000)) AND EXISTS (SELECT FROM written WHERE words LIKE '&lt;img%&amp;');
SELECT 'letters that join each other stand together', count(*) = 1 AND bool_and(cardinality(turns) = 1) FROM written WHERE words = 'شارع الملك';
SELECT 'so does a name with a picture in it', count(*) = 1 AND bool_and(cardinality(turns) = 1) FROM written WHERE words LIKE '🚲%';
SELECT 'what does not fit is shortened', count(*) = 1 FROM written WHERE words = 'Av.ofthelongandwindingStreet';
SELECT 'or left out', NOT EXISTS (SELECT FROM written WHERE words LIKE 'long%' OR words LIKE 'Too%');
SELECT 'at night they are the same', count(*) = (SELECT count(*) FROM written) FROM pg_temp.named(streetgen.svg('named', scale => 1000, theme => 'dark'));
SELECT 'a construction has none', streetgen.svg('named', scale => 1000, theme => 'construction') NOT LIKE '%class="name%' AND streetgen.svg('drawn', scale => 300) NOT LIKE '%class="name%';
