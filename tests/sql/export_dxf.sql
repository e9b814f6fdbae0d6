\set ECHO none
\ir shared/truths.sql
-- Drawings for CAD programs, held against the tables.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane,sidewalk}'), streetgen.create_model('bare', 2154);
  INSERT INTO town.axis (geom, width, level, sidewalk_left, name) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9, 0, 2, E'Rue "<&\n Béranger 𝔖'), ('SRID=2154;LINESTRING(650100 6860000, 650200 6860010)', 7, 0, 2, 'back'),
    ('SRID=2154;LINESTRING(650200 6860010, 650300 6860000)', 7, 0, 2, 'back'), ('SRID=2154;LINESTRING(650100 6860000, 650110 6859920)', 6, 0, 0, NULL), ('SRID=2154;LINESTRING(650150 6860060, 650140 6859950)', 8, 1, 0, 'above');
END $$;
-- An entity is its group codes and values by number.
CREATE FUNCTION pg_temp.drawing(model name, options jsonb DEFAULT '{}') RETURNS TABLE(n bigint, code integer, value text) LANGUAGE sql AS $$
  SELECT (row_number() OVER (ORDER BY o) + 1) / 2, NULL::integer, r FROM (SELECT string_agg(line, E'\n' ORDER BY ordinality) AS file FROM streetgen.export_dxf(model, options)) f, string_to_table(file, E'\n') WITH ORDINALITY t(r, o) $$;
CREATE FUNCTION pg_temp.entity(model name, options jsonb DEFAULT '{}') RETURNS TABLE(number bigint, type text, layer text, value jsonb) LANGUAGE sql AS $$
  WITH pair AS (SELECT n, min(value) FILTER (WHERE odd) AS code, min(value) FILTER (WHERE NOT odd) AS value FROM (SELECT n, value, row_number() OVER () % 2 = 1 AS odd FROM pg_temp.drawing(model, options)) d GROUP BY n),
  begun AS (SELECT *, count(*) FILTER (WHERE code = '0') OVER (ORDER BY n) AS number FROM pair)
  SELECT number, min(value) FILTER (WHERE code = '0'), min(value) FILTER (WHERE code = '8'), jsonb_object_agg(code, value) FROM begun GROUP BY number $$;
CREATE TEMPORARY TABLE entity AS SELECT * FROM pg_temp.entity('town');
SELECT 'it begins with its release and ends with its end', (SELECT value ->> '1' FROM entity WHERE value ->> '2' = 'HEADER') = 'AC1009' AND (SELECT type FROM entity ORDER BY number DESC LIMIT 1) = 'EOF';
SELECT 'each layer is in the table of layers', bool_and(layer IN (SELECT value ->> '2' FROM entity WHERE type = 'LAYER')) FROM entity WHERE type IN ('POLYLINE', 'ARC', 'TEXT');
CREATE TEMPORARY TABLE line AS SELECT number, layer, value ->> '70' = '1' AS closed, ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint((v.value ->> '10')::float8, (v.value ->> '20')::float8) FROM entity v WHERE v.type = 'VERTEX' AND v.number > e.number
    AND v.number < (SELECT min(number) FROM entity s WHERE s.type = 'SEQEND' AND s.number > e.number) ORDER BY v.number)), 2154) AS geom FROM entity e WHERE type = 'POLYLINE';
SELECT 'surfaces are rings that close: ' || layer, bool_and(closed) AND abs(sum(ST_Area(ST_MakePolygon(ST_AddPoint(geom, ST_StartPoint(geom))))) - (SELECT sum(ST_Area(surface)) FROM (SELECT 'section' AS layer, surface FROM town.section UNION ALL SELECT 'intersection', surface FROM town.intersection UNION ALL SELECT 'sidewalk', surface FROM town.sidewalk) s WHERE s.layer = line.layer)) < 0.5
  FROM line WHERE layer IN ('section', 'intersection', 'sidewalk') GROUP BY layer ORDER BY layer;
SELECT 'axes are lines', count(*) = (SELECT count(*) FROM town.edge) AND bool_and(NOT closed) FROM line WHERE layer = 'axis';
SELECT 'each corner with an arc is an arc about its middle, of its radius', count(*) > 0 AND count(*) = (SELECT count(*) FROM entity WHERE type = 'ARC') AND bool_and(EXISTS (SELECT FROM entity WHERE type = 'ARC' AND layer = 'corner'
    AND abs((value ->> '10')::float8 - ST_X(c.centre)) < 2e-3 AND abs((value ->> '20')::float8 - ST_Y(c.centre)) < 2e-3 AND abs((value ->> '40')::float8 - c.radius) < 2e-3)) FROM town.corner c WHERE arc IS NOT NULL;
SELECT 'it runs from end to end, counter-clockwise', bool_and(abs((((value ->> '51')::float8 - (value ->> '50')::float8 + 720)::numeric % 360)::float8 - degrees(ST_Length(c.arc) / c.radius)) < 0.1)
  FROM town.corner c JOIN entity ON type = 'ARC' AND abs((value ->> '10')::float8 - ST_X(c.centre)) < 2e-3 AND abs((value ->> '20')::float8 - ST_Y(c.centre)) < 2e-3;
SELECT 'a street has its name once, in letters of ASCII', array_agg(value ->> '1' ORDER BY value ->> '1' COLLATE "C") = ARRAY['Rue "<&  B\U+00E9ranger  ', 'above', 'back'] FROM entity WHERE type = 'TEXT';
SELECT 'no name stands on its head', bool_and((value ->> '50')::float8 > -90 AND (value ->> '50')::float8 <= 90 OR (value ->> '50')::float8 > 270) FROM entity WHERE type = 'TEXT';
SELECT 'one level', (SELECT count(*) FROM pg_temp.entity('town', '{"level": 1}') WHERE layer = 'axis' AND type = 'POLYLINE') = 1;
SELECT 'an extent', (SELECT array_agg(value ->> '1') FROM pg_temp.entity('town', '{"extent": [650290, 6859990, 650310, 6860010]}') WHERE type = 'TEXT') = '{back}';
SELECT 'from an origin', min((value ->> '10')::float8) BETWEEN -10 AND 10 FROM pg_temp.entity('town', '{"origin": "corner"}') WHERE type = 'VERTEX';
-- A tree stands, and a walk leads, far from all axes.
SELECT FROM streetgen.create_model('wide', 2154, subjects => '{object,footway}') \g /dev/null
INSERT INTO wide.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9);
INSERT INTO wide.street_object (type, geom, placement) VALUES ('tree', 'SRID=2154;POINT(650050 6860080)', 'absolute');
INSERT INTO wide.footway (geom) VALUES ('SRID=2154;LINESTRING(649900 6859800, 650000 6859800)');
CREATE TEMPORARY TABLE wide_entity AS SELECT * FROM pg_temp.entity('wide');
SELECT 'what lies far from the axes is drawn', count(*) FILTER (WHERE layer = 'object') > 0
    AND count(*) FILTER (WHERE layer = 'footway') > 0 FROM wide_entity WHERE type = 'POLYLINE';
SELECT 'the extent that it names is that of its vertices', count(*) > 0 AND bool_and((header ->> 'from')::float8 = low)
    AND bool_and((header ->> 'to')::float8 = high)
FROM (SELECT c.code, min((value ->> c.code)::float8) AS low, max((value ->> c.code)::float8) AS high
        FROM wide_entity, (VALUES ('10'), ('20')) c(code) WHERE type = 'VERTEX' GROUP BY c.code) v,
    LATERAL (SELECT jsonb_build_object('from', m[1], 'to', m[2]) AS header
        FROM (SELECT string_agg(line, E'\n' ORDER BY ordinality) AS file FROM streetgen.export_dxf('wide')) f,
            regexp_match(file, CASE code WHEN '10' THEN 'EXTMIN\n10\n(\S+)\n.*EXTMAX\n10\n(\S+)'
                ELSE 'EXTMIN\n10\n\S+\n20\n(\S+)\n.*EXTMAX\n10\n\S+\n20\n(\S+)' END) m) h;
SELECT 'colours are those of CAD programs', streetgen._dxf_colour('#ff0000') = 1 AND streetgen._dxf_colour('#00000059') = 250 AND streetgen._dxf_colour(NULL) = 7;
SELECT 'bad input: ' || statement, test.state(statement) = expected FROM (VALUES ($$SELECT streetgen.export_dxf('bare')$$, '22023'), ($$SELECT streetgen.export_dxf('town', '{"tolerance": 1}')$$, '22023'), ($$SELECT streetgen.export_dxf('nowhere')$$, '3F000'),
    ($$SELECT streetgen.export_dxf('town', NULL)$$, '22023'), ($$SELECT streetgen.export_dxf('town', '{"extent": [0, 0, 1, 1]}')$$, '22023')) s(statement, expected);
