\set ECHO none
\ir shared/truths.sql
-- One styled picture.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('drawn', 2154) \g /dev/null
INSERT INTO drawn.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7);
DO $$ BEGIN PERFORM streetgen.generate('drawn'); END $$;
SELECT 'svg draws', streetgen.svg('drawn') LIKE '<svg%</svg>' || E'\n';
SELECT 'a map of a town shows the roadway alone', svg LIKE '%class="section%' AND svg NOT LIKE '%class="axis%' AND svg NOT LIKE '%class="limit%' FROM streetgen.svg('drawn', ST_MakeEnvelope(648000, 6859000, 652000, 6861000, 2154)) svg;
SELECT 'an extent in another reference is refused', state = '22023' AND said = 'the extent has SRID 4326, the model 2154' AND hint <> '' FROM test.refusal($$SELECT streetgen.svg('drawn', ST_MakeEnvelope(2, 48, 3, 49, 4326))$$);
SELECT 'one without a reference is the model''s', streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859950, 650100, 6860050)) = streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859950, 650100, 6860050, 2154));
SELECT 'a street shows its axis', svg LIKE '%class="axis%' FROM streetgen.svg('drawn') svg;
SELECT 'and over it the line in its middle', strpos(svg, 'class="axis') BETWEEN 1 AND strpos(svg, 'class="paint') FROM streetgen.svg('drawn') svg;
-- Two streets that leave a short one on its two sides: its limits cross.
INSERT INTO drawn.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650100 6860000,650106 6860000)', 7), ('SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 14), ('SRID=2154;LINESTRING(650106 6860000,650106 6859900)', 14);
SELECT 'lanes between crossed limits are drawn as paths', (SELECT count(*) > 0 FROM drawn.lane WHERE method = 'crossed_limits')
    AND (SELECT count(*) FROM regexp_matches(svg, 'class="path (implausible )?line"', 'g')) = (SELECT count(*) FROM drawn.interconnection) + (SELECT count(*) FROM drawn.lane WHERE method = 'crossed_limits') FROM streetgen.svg('drawn') svg;
CREATE FUNCTION pg_temp.styles(svg text) RETURNS text[] LANGUAGE sql AS $$ SELECT array_agg(DISTINCT regexp_replace(m[1], ' line$', '')) FROM regexp_matches(svg, 'class="([^"]*)"', 'g') m $$;
SELECT 'a legend says each style that is drawn, once', pg_temp.styles(map) = pg_temp.styles(beside) AND cardinality(pg_temp.styles(map)) = (SELECT count(*) FROM regexp_matches(beside, '<text x="44"', 'g'))
FROM (SELECT split_part(svg, '<svg x=', 1) AS map, split_part(svg, '<svg x=', 2) AS beside FROM streetgen.svg('drawn', legend => true) svg) s;
SELECT 'the map beside it is the same', strpos(with_legend, regexp_replace(without, '^<svg xmlns="[^"]*"', '<svg')) > 0 FROM streetgen.svg('drawn') without, streetgen.svg('drawn', legend => true) with_legend;
SELECT 'a picture with a legend is XML, and as much wider as the legend is', xml_is_well_formed_document(svg) AND svg LIKE '<svg xmlns="http://www.w3.org/2000/svg" width="750" %' FROM streetgen.svg('drawn', width => 600, legend => true) svg;
SELECT 'a map of a town has the roadway alone in its legend', svg LIKE '%>roadway<%' AND (SELECT count(*) = 1 FROM regexp_matches(svg, '<text x="44"', 'g')) FROM streetgen.svg('drawn', ST_MakeEnvelope(648000, 6859000, 652000, 6861000, 2154), legend => true) svg;
SELECT 'the bar of the scale is as long as it says', abs(bar[1]::float8 * 200 / 1200 - bar[2]::float8) < 0.01 AND bar[2]::float8 IN (10, 20) FROM regexp_match(streetgen.svg('drawn', ST_MakeEnvelope(650000, 6859900, 650200, 6860000), legend => true), 'M0 0v8h([\d.]+)v-8.*>(\d+) m</text>') bar;
SELECT streetgen.create_model('bare', 2154) \g /dev/null
SELECT 'a model without axes has a picture and a legend', xml_is_well_formed_document(streetgen.svg('bare')) AND xml_is_well_formed_document(streetgen.svg('bare', legend => true));
