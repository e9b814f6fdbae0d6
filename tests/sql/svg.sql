-- One styled picture.  Each SELECT is one truth: (name, holds).
SET client_min_messages = warning;
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
