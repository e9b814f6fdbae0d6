\set ECHO none
\ir shared/truths.sql
-- Sheets of paper, and the theme for them.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('drawn', 2154, subjects => '{all}') \g /dev/null
INSERT INTO drawn.axis (geom, width, name, kind_forward, kind_backward) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 10, 'Grande <Rue>', 'general|bus', 'general|cycle'),
    ('SRID=2154;LINESTRING(650100 6860000,650180 6860060)', 6, NULL, NULL, NULL), ('SRID=2154;LINESTRING(650100 6860000,650110 6859920)', 6, NULL, NULL, NULL);
SELECT streetgen.set('drawn', 'attribution', 'A & B') \g /dev/null
CREATE FUNCTION pg_temp.sheet(scale float8 DEFAULT 500, paper text DEFAULT 'A3', upright boolean DEFAULT false, theme text DEFAULT 'street') RETURNS text
    LANGUAGE sql AS $$ SELECT svg FROM streetgen.sheet('drawn', scale, paper, ST_Point(650100, 6860000, 2154), theme, upright) $$;
SELECT 'a sheet is XML, of the size of its paper: ' || paper || CASE WHEN upright THEN ', upright' ELSE '' END, xml_is_well_formed_document(svg) AND svg LIKE format('%%width="%smm" height="%smm" viewBox="0 0 %1$s %2$s"%%', CASE WHEN upright THEN short ELSE long END, CASE WHEN upright THEN long ELSE short END)
FROM streetgen._paper(), (VALUES (false), (true)) u(upright), pg_temp.sheet(500, lower(paper), upright) svg;
SELECT 'its map is true to scale, 1:' || scale, abs(m[3]::float8 * 1000 / scale - m[1]::float8) < 0.001 AND abs(m[4]::float8 * 1000 / scale - m[2]::float8) < 0.001 FROM unnest('{200,500,1000,2500}'::float8[]) scale, pg_temp.sheet(scale) svg, regexp_match(svg, '<svg class="map" x="[\d.]+" y="[\d.]+" width="([\d.]+)" height="([\d.]+)" viewBox="0 0 ([\d.]+) ([\d.]+)">') m;
-- The axis of 100 m ends in the middle of the map: what is drawn of it is on paper where the scale says.
INSERT INTO drawn.symbol_rule (theme, layer, place, line, width, unit) VALUES ('print', 'axis', 990, '#123456', 1, 'pixel');
SELECT 'a length of 100 m is 200 mm at 1:500 and ends in the middle', abs(100 * map[1]::float8 / map[2]::float8 - 200) < 0.001 AND abs(axis[1]::float8 + 100 - map[2]::float8 / 2) < 0.02
FROM pg_temp.sheet(theme => 'print') svg, regexp_match(svg, '<svg class="map" x="[\d.]+" y="[\d.]+" width="([\d.]+)" height="[\d.]+" viewBox="0 0 ([\d.]+) ') map, regexp_match(svg, '#123456[^>]*>\s*<path d="M (-?[\d.]+) [\d.]+ l 100 ') axis;
DELETE FROM drawn.symbol_rule;
SELECT 'labels of the frame stand where their coordinates lie', count(*) >= 4 AND bool_and(abs(x - (map[1]::float8 + map[2]::float8 / 2 + (said - 650100) * 2)) < 0.002)
FROM pg_temp.sheet() svg, regexp_match(svg, '<svg class="map" x="([\d.]+)" y="[\d.]+" width="([\d.]+)"') map, regexp_matches(svg, '<text x="([\d.]+)" y="[\d.]+">(\d+) E</text>', 'g') l, LATERAL (SELECT l[1]::float8 AS x, l[2]::float8 AS said) v;
SELECT 'so it is to the north', count(*) >= 4 AND bool_and(abs(y - (map[1]::float8 + map[2]::float8 / 2 - (said - 6860000) * 2)) < 0.002)
FROM pg_temp.sheet() svg, regexp_match(svg, '<svg class="map" x="[\d.]+" y="([\d.]+)" width="[\d.]+" height="([\d.]+)"') map, regexp_matches(svg, 'translate\([\d.]+ ([\d.]+)\)rotate\(-90\)">(\d+) N</text>', 'g') l, LATERAL (SELECT l[1]::float8 AS y, l[2]::float8 AS said) v;
SELECT 'the bar of the scale is as long as it says', abs(sum(m[1]::float8) - said::float8 * 1000 / 500) < 0.01 FROM pg_temp.sheet() svg, regexp_match(svg, '<g class="bar".*?</g>') bar, regexp_matches(bar[1], 'd="M[\d.]+ 0h([\d.]+)', 'g') m, LATERAL (SELECT (regexp_match(svg, '>(\d+) m</text>'))[1] AS said) s GROUP BY said;
SELECT 'the legend says what is in the picture and nothing else: ' || theme, (SELECT array_agg(DISTINCT meaning ORDER BY meaning) FROM regexp_matches(split_part(svg, '<path class="grid"', 1), 'class="(\w+) ?(\w*)"', 'g') m JOIN streetgen.symbol_rule r ON (r.layer, r.kind, r.theme) = (m[1], m[2], t.theme) AND from_scale < 500 AND to_scale >= 500 WHERE meaning IS NOT NULL) = (SELECT array_agg(m[1] ORDER BY m[1]) FROM regexp_matches(split_part(split_part(svg, '<g class="legend">', 2), '<g class="north"', 1), '<text[^>]*>([^<]*)<', 'g') m)
FROM unnest('{street,dark,print,construction}'::text[]) t(theme), pg_temp.sheet(theme => t.theme) svg;
SELECT 'the title says model, theme, paper, day, reference and whose data it is', title LIKE '%>drawn<%>Theme street, paper A3<%>' || to_char(current_date, 'YYYY-MM-DD') || '<%>EPSG:2154, RGF93%<%>A &amp; B<%' FROM pg_temp.sheet() svg, split_part(split_part(svg, '<g class="title">', 2), '</g>', 1) title;
-- Several sheets.
SELECT 'a model that has no room on one has an index and several', count(*) > 3 AND max(number) = count(*) - 1 AND min(number) = 0 AND bool_and(xml_is_well_formed_document(svg)) AND sum(regexp_count(svg, '<rect x=')) FILTER (WHERE number = 0) = count(*) - 1 FROM streetgen.sheet('drawn', 200, 'A5');
SELECT 'each of them shows a street', bool_and(svg LIKE '%class="section"%' OR svg LIKE '%class="intersection"%') FROM streetgen.sheet('drawn', 200, 'A5') WHERE number > 0;
SELECT 'one that has room is a sheet alone', array_agg(number) = '{1}' AND bool_and(svg NOT LIKE '%Sheet%') FROM streetgen.sheet('drawn', 1000, 'A3');
INSERT INTO drawn.symbol_rule (theme, layer, kind, place, fill) VALUES ('street', 'lane', 'bycicle', 3, '#ff0000');
INSERT INTO drawn.object_type (type) VALUES ('fountain');
INSERT INTO drawn.street_object (type, placement, geom) SELECT 'fountain', 'absolute', ST_Translate(ST_Centroid(ST_Envelope(ST_Collect(geom))), 25, -40) FROM drawn.axis;
INSERT INTO drawn.symbol_rule (theme, layer, kind, place, fill) VALUES ('street', 'object', 'fountain', 952, '#ff0001');
\setenv PGDATABASE :DBNAME
\setenv PGOPTIONS '-c client_min_messages=notice'
\! told=$(psql -qXAt -c "SELECT count(*) > 3 AND count(*) FILTER (WHERE svg LIKE '%#ff0001%') BETWEEN 1 AND count(*) - 2 FROM streetgen.sheet('drawn', 200, 'A5')" 2>&1); test "$(echo "$told" | grep -c WARNING)$(echo "$told" | grep -c '"bycicle" of layer lane')$(echo "$told" | grep -cx t)" = 111 && holds=t || holds=f; printf 'a rule that draws on no sheet is told once, and one that draws on some is not\t%s\n' $holds
\setenv PGOPTIONS
DELETE FROM drawn.symbol_rule;
DELETE FROM drawn.street_object WHERE type = 'fountain';
-- The theme for paper.
SELECT 'a pattern is drawn where a shape names it', count(*) > 1 AND bool_and(strpos(svg, format('<pattern id="%s"', m[1])) > 0) FROM pg_temp.sheet(theme => 'print') svg, regexp_matches(svg, 'fill:url\(#(\w+)\)', 'g') m;
SELECT 'it is black, white or grey', count(*) > 30 AND bool_and(c ~ '^#(..)\1\1') FROM streetgen.symbol_rule, unnest(ARRAY[fill, line]) c WHERE theme = 'print' AND c IS NOT NULL;
SELECT 'no line is thinner than 0.13 mm', count(*) > 20 AND bool_and(CASE unit WHEN 'pixel' THEN 0.28 * width ELSE 1000 * width / to_scale END >= 0.13) FROM streetgen.symbol_rule WHERE theme = 'print' AND line IS NOT NULL;
SELECT 'paint and kerbs, which are narrow, have a line', count(*) = 5 AND bool_and(line = fill) FROM streetgen.symbol_rule WHERE theme = 'print' AND layer IN ('lane_separator', 'marking', 'rim_marking', 'deck_paint', 'kerb');
SELECT 'each layer that the street has, but shadows, is there', NOT EXISTS (SELECT layer, kind FROM streetgen.symbol_rule WHERE theme = 'street' AND marker IS NULL EXCEPT SELECT layer, kind FROM streetgen.symbol_rule WHERE theme = 'print');
-- Bad input.
SELECT call || ' is refused', state = '22023' AND hint <> '' FROM unnest('{scale => 0,scale => ''NaN'',scale => 9,scale => 2e6,paper => ''A9'',paper => '''',theme => ''night'',"centre => ST_Point(0, 0, 2154)","centre => ST_Point(2, 48, 4326)","centre => ST_Point(''Infinity'', 0)","centre => ''LINESTRING(0 0, 1 1)''","scale => 10, paper => ''A5''"}'::text[]) call, test.refusal('SELECT streetgen.sheet(''drawn'', ' || call || ')');
SELECT 'an empty centre is refused as such', state = '22023' AND said = 'the centre is empty' AND hint <> '' FROM test.refusal('SELECT streetgen.sheet(''drawn'', centre => ''POINT EMPTY'')');
SELECT 'a place outside is told where the model lies', state = '22023' AND hint LIKE 'The model lies in 649990,68%' FROM test.refusal('SELECT streetgen.sheet(''drawn'', centre => ST_Point(0, 0))');
SELECT call || ' is NULL', state = '22004' FROM unnest('{scale,paper,theme,upright}'::text[]) call, test.refusal('SELECT streetgen.sheet(''drawn'', ' || call || ' => NULL)');
SELECT streetgen.set('drawn', 'attribution', repeat('© of all ', 33)) \g /dev/null
SELECT 'a title of many lines stays in its part: ' || paper, count(*) > 8 AND bool_and(l[1]::float8 <= ST_YMax((streetgen._sheet_parts(CASE paper WHEN 'A5' THEN 210 ELSE 420 END, CASE paper WHEN 'A5' THEN 148 ELSE 297 END)).title)) FROM unnest('{A3,A5}'::text[]) paper, pg_temp.sheet(paper => paper) svg, regexp_matches(split_part(split_part(svg, '<g class="title">', 2), '</g>', 1), ' y="([\d.]+)"', 'g') l GROUP BY paper;
SELECT 'a long attribution is refused', test.state(format('SELECT streetgen.set(''drawn'', ''attribution'', %L)', repeat('x', 301))) = '22023';
SELECT 'a place without streets has a sheet that says so, and no legend', xml_is_well_formed_document(svg) AND svg LIKE '%>nothing here at 1:100<%' AND svg NOT LIKE '%class="section"%' AND split_part(split_part(svg, '<g class="legend">', 2), '</g>', 1) !~ '<text' FROM streetgen.sheet('drawn', 100, 'A5', ST_Point(650010, 6859930, 2154)) s;
SELECT 'so has one that only the box of a street reaches', svg NOT LIKE '%class="section"%' AND split_part(split_part(svg, '<g class="legend">', 2), '</g>', 1) !~ '<text' FROM streetgen.sheet('drawn', 50, 'A5', ST_Point(650105, 6860055, 2154)) s;
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'so has a model without axes', array_agg(number) = '{1}' AND bool_and(xml_is_well_formed_document(svg)) FROM streetgen.sheet('bare');
SELECT 'of which no place lies inside, as it has no axes', state = '22023' AND hint = 'The model has no axes yet.' FROM test.refusal('SELECT streetgen.sheet(''bare'', centre => ST_Point(650000, 6860000))');
