\set ECHO none
\ir shared/truths.sql
-- Tables as municipalities and national surveys keep them, by a mapping: texts, units, lists of values, names of columns.  Each SELECT is one truth: (name, holds).
SELECT streetgen.create_model('town', 32631) \g /dev/null
CREATE FUNCTION pg_temp.lines(n integer) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * n), ST_MakePoint(100, 50 * n)), 32631) $$;
CREATE TABLE register (id text, w text, lanes text, speed text, dir text, lvl text, kinds text, widths text, geom geometry);
INSERT INTO register SELECT v.*, pg_temp.lines(row_number() OVER ()::integer) FROM (VALUES
  ('a', '7.5', '3', '50', 'both', '0', 'general|bus', '3,5|3 m'), ('b', '7,5', '2.0', '30 mph', 'DIRECT', '+1', NULL, NULL), ('c', ' 24 ft ', '2', '50 km/h', '-1', '-1.0', '', ' '),
  ('d', '', '', '', '', '', '', ''), ('e', 'unknown', 'two', 'none', 'FT', 'bridge', 'tram', 'wide'), ('f', '900', '2.5', '-30', 'oneway', '99', 'general||', '3|-3'), ('g', 'NaN', '31', '500', '2', '1e9', NULL, NULL)) v;
\set all_columns '{"source_ref": "id", "width": "w", "lane_count": "lanes", "speed": "speed", "direction": "dir", "level": "lvl", "kind_forward": "kinds", "lane_width_forward": "widths"}'
CREATE TEMPORARY TABLE told AS SELECT * FROM streetgen.import_axes('town', 'register', :'all_columns');
SELECT 'texts are read' AS name, array_agg(ROW(source_ref, round(width::numeric, 4), lane_count, round(speed::numeric, 2), direction, level, kind_forward, lane_width_forward)::text ORDER BY source_ref)
  = '{"(a,7.5000,3,50.00,both,0,general|bus,3.5|3)","(b,7.5000,2,48.28,direct,1,,)","(c,7.3152,2,50.00,reverse,-1,,)"}' AS holds FROM town.axis WHERE source_ref < 'd';
SELECT 'what is empty or means nothing is unknown', count(*) = 4 AND bool_and(num_nulls(width, lane_count, speed, kind_forward, lane_width_forward) = 5 AND direction = 'both' AND level = 0) FROM town.axis WHERE source_ref >= 'd';
SELECT 'each such value is named by its row, and nothing else', array_agg(what || ' ' || array_to_string(source_refs, ',') ORDER BY what) = ARRAY['direction "2" not understood, taken as unknown g', 'direction "FT" not understood, taken as unknown e', 'direction "oneway" not understood, taken as unknown f', 'kind_forward not understood, taken as unknown e,f',
  'lane_count not understood, taken as unknown e,f,g', 'lane_width_forward not understood, taken as unknown e,f', 'level not understood, taken as unknown e,f,g',
  'speed not understood, taken as unknown e,f,g', 'width not understood, taken as unknown e,f,g'] FROM told WHERE what NOT IN ('taken', 'new or changed', 'generate is due') AND what NOT LIKE 'neither width nor lanes stated%';
SELECT streetgen.create_model('nameless', 32631) \g /dev/null
SELECT 'a row without a source_ref is named by its place', array_agg(source_refs::text) = '{"{\"number 5\",\"number 6\",\"number 7\"}"}' FROM streetgen.import_axes('nameless', 'register', '{"width": "w"}') WHERE what LIKE 'width not%';
TRUNCATE town.axis;

-- Units.
CREATE TABLE feet (id integer, st_width integer, pace integer, offset_us float8, widths text, geom geometry);
INSERT INTO feet VALUES (1, 34, 25, 3937, '10|11', pg_temp.lines(1)), (2, NULL, NULL, -39.37, NULL, pg_temp.lines(2));
SELECT count(*) FROM streetgen.import_axes('town', 'feet', '{"source_ref": "id", "width": {"column": "st_width", "unit": "ft"}, "speed": {"column": "pace", "unit": "mph"},
  "roadway_offset": {"column": "offset_us", "unit": "us-ft"}, "lane_width_forward": {"column": "widths", "unit": "ft"}, "radius": {"value": 10, "unit": "ft"}}') \g /dev/null
SELECT 'units of columns and values hold', ROW(width, round(speed::numeric, 4), lane_width_forward, radius)::text = '(10.3632,40.2336,3.048|3.353,3.048)' FROM town.axis WHERE source_ref = '1';
SELECT 'also below zero', abs(roadway_offset + 12) < 1e-9 FROM town.axis WHERE source_ref = '2';
SELECT 'and beyond the bounds they are named', source_refs = '{1}' FROM streetgen.import_axes('town', 'feet', '{"source_ref": "id", "roadway_offset": {"column": "offset_us", "unit": "us-ft"}}') WHERE what LIKE 'roadway_offset not%';
TRUNCATE town.axis;

-- Lists of values.
CREATE TABLE arc (id integer, "ONEWAY" char(4), fclass text, lanes text, geom geometry);
INSERT INTO arc SELECT i, o, f, l, pg_temp.lines(i) FROM (VALUES (1, 'FT', 'S1100', 'one'), (2, 'TF', 'S1400', 'two'), (3, 'B', 'S1400', NULL), (4, 'N', 'S9999', 'many'), (5, '', NULL, '?'), (6, 'N', 'S1100', '?')) v(i, o, f, l);
CREATE TEMPORARY TABLE listed AS SELECT * FROM streetgen.import_axes('town', 'arc', '{"source_ref": "id", "direction": {"column": "ONEWAY", "values": {"FT": 1, "TF": -1, "B": 0}},
  "kind": {"column": "fclass", "values": {"S1100": "primary", "S1400": "residential"}}, "lane_count": {"column": "lanes", "values": {"one": 1, "two": 2, "?": null}}}');
SELECT 'a list of values is followed', array_agg(ROW(source_ref, direction, kind, lane_count)::text ORDER BY source_ref)
  = '{"(1,direct,primary,1)","(2,reverse,residential,2)","(3,both,residential,)","(4,both,,)","(5,both,,)","(6,both,primary,)"}' FROM town.axis;
SELECT 'values that a list lacks are named with their rows, null is a value', array_agg(what || ' ' || array_to_string(source_refs, ',') ORDER BY what) = ARRAY['direction "N" not understood, taken as unknown 4,6',
  'kind "S9999" not understood, taken as unknown 4', 'lane_count "many" not understood, taken as unknown 4'] FROM listed WHERE what LIKE '%not understood%';
TRUNCATE town.axis;

-- Names of columns.
CREATE TABLE shouted ("ID" integer, "Width" float8, "NAME" text, "name" text, "GEOM" geometry);
INSERT INTO shouted VALUES (1, 6, 'loud', 'low', pg_temp.lines(1));
SELECT count(*) FROM streetgen.import_axes('town', 'shouted', '{"source_ref": "id", "width": "WIDTH", "name": "name", "geom": "geom"}') \g /dev/null
SELECT 'a column is found whatever its case, and an exact name wins', ROW(source_ref, width, name)::text = '(1,6,low)' FROM town.axis;
SELECT 'column geom too, where the mapping does not mention it', count(*) = 1 FROM streetgen.import_axes('town', 'shouted', '{"source_ref": "id", "width": "Width"}') WHERE what = 'taken';
SELECT 'one of several is refused, and they are named', (r.state, r.hint)::text = '(22023,"Name one of them as it is written: NAME, name.")' FROM test.refusal($$SELECT streetgen.import_axes('town', 'shouted', '{"name": "Name"}')$$) r;
TRUNCATE town.axis;
SELECT count(*) FROM streetgen.follow('town', 'shouted', '{"source_ref": "id", "width": {"column": "width", "unit": "ft"}, "name": "NAME"}') \g /dev/null
UPDATE shouted SET "Width" = 10;
SELECT 'a table is followed by such names and units', round(width::numeric, 3) = 3.048 AND name = 'loud' FROM town.axis;
UPDATE shouted SET "Width" = 10000;
SELECT 'and a value out of range is unknown', width IS NULL FROM town.axis;
SELECT 'what is followed so comes back', streetgen.adopt_model('town') IS NOT NULL;
UPDATE shouted SET "Width" = 20;
SELECT 'and goes on', round(width::numeric, 3) = 6.096 FROM town.axis;

-- Mappings that are none.
SELECT format('%s is refused: %s', mapping, (r).said), (r).state = '22023' AND (r).hint <> ''
  FROM (SELECT mapping, test.refusal(format('SELECT streetgen.import_axes(''town'', ''arc'', %L)', mapping)) AS r FROM unnest(ARRAY['{"width": {"column": "lanes", "unit": "mph"}}', '{"width": {"column": "lanes", "unit": "parsec"}}',
  '{"speed": {"column": "lanes", "unit": "ft"}}', '{"lane_count": {"column": "lanes", "unit": "m"}}', '{"width": {"column": 5}}', '{"width": {"unit": "ft"}}', '{"width": {"column": "lanes", "units": "ft"}}',
  '{"width": {"column": "lanes", "value": 5}}', '{"width": {"value": 500}}', '{"width": {"value": 700, "unit": "ft"}}', '{"direction": {"column": "ONEWAY", "values": {"FT": "sideways"}}}', '{"direction": {"column": "ONEWAY", "values": []}}',
  '{"direction": {"column": "ONEWAY", "values": {}}}', '{"lane_count": {"column": "lanes", "values": {"one": 1.5}}}', '{"kind_forward": {"value": "tram"}}', '{"geom": {"value": 1}}', '{"geom": {"column": "geom", "unit": "m"}}',
  '{"source_ref": {"column": "id", "values": {"1": 2}}}', '{"width": {"value": 5, "values": {"1": 2}}}', '{"geom": "id"}', '{"speed": {"value": "fast"}}']) mapping) t;
SELECT 'a list of values is no SQL', count(*) = 4 FROM streetgen.import_axes('nameless', 'arc', $${"kind": {"column": "fclass", "values": {"'); DROP TABLE arc; --": "x'y"}}, "name": {"value": "');DROP TABLE arc;--"}}$$) WHERE what = 'taken' OR what LIKE 'kind%';
SELECT 'and the table is there', count(*) = 6 FROM arc;

-- Ten thousand rows of pieces of texts: none stops an import, and each value is read or its row is named.
SELECT setseed(0.35) \g /dev/null
CREATE TABLE nonsense AS SELECT i AS id, t[1] AS w, t[2] AS s, t[3] AS n, t[4] AS d, t[5] AS k, t[6] AS l, ST_Translate(pg_temp.lines(i / 100), 500000 + 200 * (i % 100), 0) AS geom
FROM (SELECT ARRAY['7', '3,5', '1.234,5', '-', ';', '|', '~', '''', '"', ' ', 'm', 'ft', 'mph', 'kn', 'walk', 'DE:', 'GB:', 'zone', 'urban', ':', 'nan', '1e', '+', '99999999999999999999', 'bus', 'general', 'é', E'\t', '%', '\', '1', '-1', 'both']) c(p),
  generate_series(1, 10000) i, LATERAL (SELECT array_agg(text) AS t FROM (SELECT (SELECT coalesce(string_agg(p[1 + floor(random() * cardinality(p))::integer + 0 * g], ''), '')
    FROM generate_series(1, floor(random() * 5 + 0 * (i + nth))::integer) g) AS text FROM generate_series(1, 6) nth) t) t;
SELECT streetgen.create_model('odd', 32631) \g /dev/null
CREATE TEMPORARY TABLE told_of_nonsense AS SELECT * FROM streetgen.import_axes('odd', 'nonsense', '{"source_ref": "id", "width": {"column": "w", "unit": "ft"}, "speed": {"column": "s", "unit": "mph"}, "lane_count": "n", "direction": "d", "kind_forward": "k", "lane_width_forward": "l"}');
SELECT 'nonsense stops no import', count(*) = 10000 FROM odd.axis;
SELECT format('each %s is read, empty, or named by its row', name), count(*) = 300 AND bool_and((value IS NULL OR name = 'direction') = (btrim(said) = '' OR named) OR name = 'direction') AND bool_or(named)
  FROM (SELECT v.name, v.value, v.said, EXISTS (SELECT FROM told_of_nonsense t WHERE t.what IN (v.name || ' not understood, taken as unknown', format('%s "%s" not understood, taken as unknown', v.name, btrim(v.said)), v.name || ' of zero, taken as unknown')
      AND n.id::text = ANY (t.source_refs)) AS named FROM nonsense n JOIN odd.axis a ON a.source_ref = n.id::text,
    LATERAL (VALUES ('width', a.width::text, n.w), ('speed', a.speed::text, n.s), ('lane_count', a.lane_count::text, n.n), ('direction', a.direction, n.d), ('kind_forward', a.kind_forward, n.k),
      ('lane_width_forward', a.lane_width_forward, n.l)) v(name, value, said) WHERE n.id <= 300) r GROUP BY name ORDER BY name;
