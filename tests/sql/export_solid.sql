\set ECHO none
\ir shared/truths.sql
-- Files in three dimensions, CityJSON and glTF, held against the tables.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, 3, subjects => '{lane,sidewalk}'), streetgen.create_model('flat', 2154, subjects => '{surface}'), streetgen.create_model('bare', 2154), streetgen.create_model('painted', 2154), streetgen.create_model('high', 2154, 3), streetgen.create_model('wide', 2154, subjects => '{surface}');
  INSERT INTO painted.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9);
  INSERT INTO high.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000 50, 650100 6860000 50)', 9);
  INSERT INTO town.axis (geom, width, level, sidewalk_left, sidewalk_right, name) VALUES
    ('SRID=2154;LINESTRING(650000 6860000 100, 650100 6860000 106)', 9, 0, 2, 3, 'a "<&'), ('SRID=2154;LINESTRING(650100 6860000 106, 650140 6860000 110, 650180 6860000 109, 650240 6860020 101)', 7, 0, 2, 2, NULL),
    ('SRID=2154;LINESTRING(650100 6860000 106, 650110 6859960 103, 650110 6859920 103)', 6, 0, 1.5, 0, NULL), ('SRID=2154;LINESTRING(650160 6859950 120, 650160 6860050 118)', 8, 1, 0, 0, NULL),
    ('SRID=2154;LINESTRING(650700 6860300 90, 650790 6860310 95)', 8, 0, 2, 2, 'far away');
  INSERT INTO wide.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + x, 6860000 + y), ST_MakePoint(650040 + x, 6860000 + y)), 2154), 6 FROM generate_series(0, 19000, 1000) x, generate_series(0, 12000, 1000) y;
  INSERT INTO flat.axis (geom, width) SELECT geom, width FROM (SELECT ST_Force2D(geom) AS geom, width FROM town.axis) a;
END $$;
CREATE FUNCTION pg_temp.city(model name, options jsonb DEFAULT '{}') RETURNS jsonb LANGUAGE sql AS $$ SELECT string_agg(line, E'\n' ORDER BY ordinality)::jsonb FROM streetgen.export_cityjson(model, options) $$;
CREATE FUNCTION pg_temp.file(model name, options jsonb DEFAULT '{}') RETURNS bytea LANGUAGE sql AS $$ SELECT string_agg(part, '' ORDER BY ordinality) FROM streetgen.export_gltf(model, options) $$;

CREATE TEMPORARY TABLE city AS SELECT pg_temp.city('town') AS city;
CREATE TEMPORARY TABLE vertex AS SELECT n - 1 AS vertex, 650000 + (v ->> 0)::float8 / 1000 AS x, (city #>> '{transform,translate,1}')::float8 + (v ->> 1)::float8 / 1000 AS y, (v ->> 2)::float8 / 1000 AS z FROM city, jsonb_array_elements(city -> 'vertices') WITH ORDINALITY e(v, n);
CREATE TEMPORARY TABLE face AS
SELECT o.key AS road, t.n AS triangle, ARRAY[(t.b #>> '{0,0}')::bigint, (t.b #>> '{0,1}')::bigint, (t.b #>> '{0,2}')::bigint] AS corner, s ->> 'type' AS type, s ->> 'function' AS function
FROM city, jsonb_each(city -> 'CityObjects') o, LATERAL (SELECT o.value #> '{geometry,0}' AS g) g, jsonb_array_elements(g -> 'boundaries') WITH ORDINALITY t(b, n),
    LATERAL (SELECT g #> ARRAY['semantics', 'surfaces', (g #>> ARRAY['semantics', 'values', (t.n - 1)::text])] AS s) s;
CREATE TEMPORARY TABLE area AS
SELECT f.*, ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2 AS plan, sqrt(((b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z)) ^ 2 + ((b.z - a.z) * (c.x - a.x) - (c.z - a.z) * (b.x - a.x)) ^ 2
    + ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) ^ 2) / 2 AS full_area
FROM face f JOIN vertex a ON a.vertex = corner[1] JOIN vertex b ON b.vertex = corner[2] JOIN vertex c ON c.vertex = corner[3];
CREATE TEMPORARY TABLE side AS SELECT function, corner[k] AS a, corner[k % 3 + 1] AS b FROM face, generate_series(1, 3) k;

SELECT 'CityJSON 2.0, with its reference', city ->> 'type' = 'CityJSON' AND city ->> 'version' = '2.0' AND city #>> '{metadata,referenceSystem}' = 'https://www.opengis.net/def/crs/EPSG/0/2154' FROM city;
SELECT 'coordinates are counted from whole metres', city #> '{transform,translate}' = '[650000, 6859915, 0]' OR (SELECT floor(min(ST_YMin(geom))) FROM town.edge) = (city #>> '{transform,translate,1}')::float8 FROM city;
SELECT 'a road for each edge and each node with a surface', (SELECT array_agg(DISTINCT road ORDER BY road) FROM face) = (SELECT array_agg(DISTINCT r ORDER BY r) FROM (SELECT 'edge_' || edge_id AS r FROM town.section WHERE NOT ST_IsEmpty(surface)
    UNION ALL SELECT 'node_' || node_id FROM town.intersection WHERE NOT ST_IsEmpty(surface) UNION ALL SELECT coalesce('node_' || node_id, 'edge_' || edge_id) FROM town.sidewalk) s);
SELECT 'names come as they are', city #>> '{CityObjects,edge_1,attributes,name}' = 'a "<&' FROM city;
SELECT 'what a surface is: ' || function, type = CASE function WHEN 'kerbstone' THEN 'AuxiliaryTrafficArea' WHEN 'lane line' THEN 'TransportationMarking' ELSE 'TrafficArea' END FROM (SELECT DISTINCT function, type FROM face) f ORDER BY function;
SELECT 'the roadway has the area of the tables, by 0.1 %', abs(sum(plan) / (SELECT sum(ST_Area(surface)) FROM town.roadway) - 1) < 1e-3 AND bool_and(plan > -1e-6) FROM area WHERE function = 'roadway';
SELECT 'so have the sidewalks', abs(sum(plan) / (SELECT sum(ST_Area(surface)) FROM town.sidewalk) - 1) < 1e-3 AND bool_and(plan > -1e-6) FROM area WHERE function = 'footpath';
-- Border shared by a sidewalk and the roadway of its level, 0.15 m high; a centimetre is what two ends of a border are apart at most.
SELECT 'kerbs are upright, 0.15 m high along what sidewalks share with the roadway', max(abs(plan)) < 2e-3 AND sum(full_area) > 0.15 * 300 AND abs(sum(full_area) / 0.15 / (SELECT sum(ST_Length(ST_Intersection(ST_Boundary(s.surface), ST_Buffer(ST_Boundary(r.surface), 1e-4))))
    FROM town.sidewalk s JOIN town.roadway r ON ST_DWithin(s.surface, r.surface, 1e-3)) - 1) < 0.01 FROM area WHERE function = 'kerbstone';
SELECT 'every level side of a kerb has the roadway below and the sidewalk above, the other way round', count(*) > 100 AND bool_and(EXISTS (SELECT FROM side o WHERE (o.a, o.b) = (s.b, s.a) AND o.function IN ('roadway', 'footpath')))
    FROM side s JOIN vertex a ON a.vertex = s.a JOIN vertex b ON b.vertex = s.b WHERE function = 'kerbstone' AND NOT EXISTS (SELECT FROM side o WHERE (o.a, o.b) = (s.b, s.a) AND o.function = 'kerbstone') AND (a.x, a.y) <> (b.x, b.y);
SELECT 'no side has two triangles of one way', max(n) = 1 FROM (SELECT count(*) AS n FROM side GROUP BY a, b) u;
SELECT 'no place has two vertices, and each is used', (SELECT count(*) = count(DISTINCT (x, y, z)) FROM vertex) AND (SELECT count(DISTINCT a) FROM side) = (SELECT count(*) FROM vertex);
-- The sidewalk of a corner has the level of its node, whatever the level of its edge.
DO $$ BEGIN
  PERFORM streetgen.create_model('ramp', 2154, subjects => '{lane,sidewalk}');
  INSERT INTO ramp.axis (geom, width, level, sidewalk_left, sidewalk_right) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650030 6860000)', 8, 1, 2, 2),
    ('SRID=2154;LINESTRING(650000 6860009, 650024 6860009)', 8, 1, 2, 2), ('SRID=2154;LINESTRING(650024 6860009, 650100 6860040)', 8, 0, 2, 2);
END $$;
SELECT 'a corner at a node of another level than its edge', count(*) > 0 FROM ramp.sidewalk s JOIN ramp.kerb k USING (edge_id, side, part) JOIN ramp.edge e USING (edge_id) WHERE k.level <> e.level;
SELECT 'no side of the ground has two triangles of one way there', max(n) = 1 FROM (SELECT count(*) AS n FROM (SELECT (t.b #>> '{0,0}')::bigint AS a, (t.b #>> '{0,1}')::bigint AS b, (t.b #>> '{0,2}')::bigint AS c
    FROM pg_temp.city('ramp') city, jsonb_each(city -> 'CityObjects') o, LATERAL (SELECT o.value #> '{geometry,0}' AS g) g, jsonb_array_elements(g -> 'boundaries') WITH ORDINALITY t(b, n)
    WHERE g #>> ARRAY['semantics', 'surfaces', g #>> ARRAY['semantics', 'values', (t.n - 1)::text], 'function'] <> 'kerbstone') f, LATERAL (VALUES (a, b), (b, c), (c, a)) v(p, q) GROUP BY p, q) u;
SELECT 'heights are those of the axes, and sidewalks lie above', min(z) BETWEEN 89.9 AND 90.01 AND max(z) BETWEEN 119.9 AND 120.2 FROM vertex;
SELECT 'a model with surfaces alone has them alone', NOT EXISTS (SELECT FROM jsonb_each(c -> 'CityObjects') o WHERE o.value #> '{geometry,0,semantics,surfaces}' <> '[{"type": "TrafficArea", "function": "roadway"}]') FROM pg_temp.city('flat') c;
SELECT 'a level alone', (SELECT array_agg(DISTINCT level) FROM town.edge JOIN (SELECT substr(jsonb_object_keys(pg_temp.city('town', '{"level": 1}') -> 'CityObjects'), 6)::bigint AS edge_id) e USING (edge_id)) = '{1}';
SELECT 'an extent has whole edges, with vertices as in the whole', (SELECT count(*) FROM jsonb_object_keys(c -> 'CityObjects')) = 1 AND c #> '{CityObjects,edge_5,geometry,0,boundaries,0}' IS NOT NULL FROM pg_temp.city('town', '{"extent": [650750, 6860300, 650760, 6860310]}') c;
SELECT 'digits of a coordinate', (pg_temp.city('flat', '{"precision": 5}') #>> '{transform,scale,0}')::float8 = 1e-5;

-- glTF: header, chunk of JSON, chunk of data.
CREATE FUNCTION pg_temp.word(file bytea, place integer) RETURNS bigint LANGUAGE sql AS $$ SELECT sum(get_byte(file, place + i)::bigint << 8 * i) FROM generate_series(0, 3) i $$;
CREATE FUNCTION pg_temp.told(file bytea) RETURNS jsonb LANGUAGE sql AS $$ SELECT convert_from(substring(file FROM 21 FOR pg_temp.word(file, 12)::integer), 'UTF8')::jsonb $$;
CREATE TEMPORARY TABLE solid AS SELECT file, pg_temp.told(file) AS told FROM pg_temp.file('town') file;
SELECT 'a binary file of glTF 2.0 as long as it says', substring(file FOR 4) = 'glTF' AND pg_temp.word(file, 4) = 2 AND pg_temp.word(file, 8) = length(file) AND told #>> '{asset,version}' = '2.0' FROM solid;
SELECT 'its data is as long as it says, to whole words', pg_temp.word(file, 20 + json::integer) = (told #>> '{buffers,0,byteLength}')::bigint AND length(file) = 28 + json + (told #>> '{buffers,0,byteLength}')::bigint AND length(file) % 4 = 0
    FROM solid, pg_temp.word(file, 12) json;
SELECT 'extras say reference and origin', told #> '{asset,extras,srid}' = '2154' AND told #> '{asset,extras,origin,0}' = '650000' FROM solid;
SELECT 'each in the colour in which it is drawn, as light', abs(256 * (told #>> '{materials,0,pbrMetallicRoughness,baseColorFactor,0}')::float8 - 256 * (((get_byte(decode(substr(fill, 2), 'hex'), 0) / 255.0) + 0.055) / 1.055) ^ 2.4) < 0.1 FROM solid, streetgen.symbol_rule WHERE (theme, layer, kind) = ('street', 'section', '');
SELECT 'a material for each layer that is there', (SELECT array_agg(m ->> 'name') FROM jsonb_array_elements(told -> 'materials') m) = '{intersection,kerb,lane_separator,section,sidewalk}' AND NOT EXISTS (SELECT FROM town.marking) FROM solid;
SELECT 'a node and a mesh for each square of 500 m that has streets', jsonb_array_length(told -> 'nodes') > 1 AND jsonb_array_length(told -> 'nodes') = (SELECT count(DISTINCT (floor(ST_X(p) / 500), floor(ST_Y(p) / 500))) FROM (SELECT ST_StartPoint(geom) AS p FROM town.edge UNION ALL SELECT geom FROM town.intersection JOIN town.node USING (node_id) WHERE NOT ST_IsEmpty(surface)) s) FROM solid;
CREATE TEMPORARY TABLE primitive AS
SELECT m.ordinality AS mesh, told #>> ARRAY['materials', p ->> 'material', 'name'] AS layer, told #> ARRAY['accessors', p #>> '{attributes,POSITION}'] AS position, told #> ARRAY['accessors', p ->> 'indices'] AS indices FROM solid, jsonb_array_elements(told -> 'meshes') WITH ORDINALITY m, jsonb_array_elements(m.value -> 'primitives') p;
SELECT 'as many triangles as the mesh has', sum((indices ->> 'count')::bigint) FILTER (WHERE layer <> 'lane_separator') / 3 = (SELECT sum(ST_NumGeometries(mesh)) FROM streetgen._street_mesh('town', '{"extent": null, "level": null, "tolerance": 0.05}')) FROM primitive;
SELECT 'kerbs stand on the roadway, and end where sidewalks lie', bool_and(abs((k.position #>> '{max,1}')::float8 - (s.position #>> '{max,1}')::float8) < 0.5) FROM primitive k JOIN primitive s USING (mesh) WHERE k.layer = 'kerb' AND s.layer = 'sidewalk';
SELECT 'paint lies above the roadway, by 5 mm and, where there are heights, twice the tolerance', count(*) > 0 AND bool_and(abs((p #>> '{min,1}')::float8 - z) < 1e-5 AND abs((p #>> '{max,1}')::float8 - z) < 1e-5)
    FROM (VALUES ('painted'::name, '{}'::jsonb, 0.005), ('high', '{}', 50.105), ('high', '{"tolerance": 0.01, "origin": [650000, 6860000, 40]}', 10.025)) v(model, options, z), LATERAL (SELECT pg_temp.told(pg_temp.file(model, options)) AS told) f,
        LATERAL (SELECT told #> ARRAY['accessors', m #>> '{attributes,POSITION}'] AS p FROM jsonb_array_elements(told #> '{meshes,0,primitives}') m WHERE told #>> ARRAY['materials', m ->> 'material', 'name'] = 'lane_separator') a;
SELECT 'a node for each street, with its id and name', (SELECT array_agg(n ->> 'name' ORDER BY n ->> 'name') FROM jsonb_array_elements(told -> 'nodes') n) = (SELECT array_agg(road ORDER BY road) FROM (SELECT DISTINCT road FROM face) f)
    AND (SELECT n #>> '{extras,name}' FROM jsonb_array_elements(told -> 'nodes') n WHERE n -> 'extras' -> 'edge_id' = '1') = 'a "<&' FROM (SELECT pg_temp.told(pg_temp.file('town', '{"nodes": "street"}')) AS told) f;

-- Objects: a mesh for each kind, a node for each object.
DO $$ BEGIN
  PERFORM streetgen.create_model('furnished', 2154, 3, subjects => '{object}');
  INSERT INTO furnished.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000 10, 650100 6860000 20)', 9);
  INSERT INTO furnished.street_object (type, geom) VALUES ('tree', 'SRID=2154;POINT(650020 6860008)'), ('tree', 'SRID=2154;POINT(650040 6860008)'), ('lamp', 'SRID=2154;POINT(650030 6859992)'), ('manhole', 'SRID=2154;POINT(650050 6860000)');
  INSERT INTO furnished.control_point (geom, kind) VALUES ('SRID=2154;POINT(650070 6860000)', 'stop');
END $$;
CREATE TEMPORARY TABLE stands AS SELECT n ->> 'name' AS name, told #>> ARRAY['meshes', n ->> 'mesh', 'name'] AS mesh, n, ordinality - 1 AS number FROM pg_temp.told(pg_temp.file('furnished', '{"origin": [650000, 6860000, 0]}')) told, jsonb_array_elements(told -> 'nodes') WITH ORDINALITY e(n, ordinality);
SELECT 'an object is a node with the mesh of its kind; none lies in the ground or is a control point', (SELECT array_agg(mesh || ' ' || name ORDER BY name) FROM stands WHERE n ? 'translation') = ARRAY(SELECT type || ' ' || type || '_' || street_object_id FROM furnished.street_object WHERE type IN ('lamp', 'tree') ORDER BY type || '_' || street_object_id);
SELECT 'it stands in its place, as high as its street', count(*) = 3 AND bool_and(abs((n #>> '{translation,0}')::float8 - (ST_X(o.geom) - 650000)) < 1e-3 AND abs((n #>> '{translation,2}')::float8 + (ST_Y(o.geom) - 6860000)) < 1e-3
    AND abs((n #>> '{translation,1}')::float8 - (10 + (ST_X(o.geom) - 650000) / 10)) < 0.01) FROM stands JOIN furnished.street_object o ON name = type || '_' || street_object_id;
-- A lamp of a bridge stands on it, though the street below is nearer.
DO $$ BEGIN
  PERFORM streetgen.create_model('bridge', 2154, 3, subjects => '{object}');
  INSERT INTO bridge.axis (axis_id, geom, width, level) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000 10, 650100 6860000 10)', 9, 0), (2, 'SRID=2154;LINESTRING(650050 6859950 20, 650050 6860050 20)', 9, 1);
  INSERT INTO bridge.street_object (type, geom, axis_id, abscissa, axis_offset) VALUES ('lamp', 'SRID=2154;POINT(650054 6860001)', 2, 51, -4);
END $$;
SELECT 'a lamp of a bridge stands on it', count(*) = 1 AND bool_and((n #>> '{translation,1}')::float8 = 20) FROM pg_temp.told(pg_temp.file('bridge')) told, jsonb_array_elements(told -> 'nodes') n WHERE n ? 'translation';
SELECT 'and looks where it does, clockwise from north', bool_and(abs(sind(o.angle / 2) + (n #>> '{rotation,1}')::float8) < 1e-5) FROM stands JOIN furnished.street_object o ON name = type || '_' || street_object_id;
SELECT 'all nodes are of the scene', (SELECT array_agg(r::integer ORDER BY r::integer) FROM jsonb_array_elements_text(told #> '{scenes,0,nodes}') r) = (SELECT array_agg(number::integer ORDER BY number) FROM stands) FROM pg_temp.told(pg_temp.file('furnished')) told;

-- Wavefront: vertices, texture coordinates, normals and faces.
CREATE FUNCTION pg_temp.object(model name, options jsonb DEFAULT '{}') RETURNS SETOF text[] LANGUAGE sql AS $$ SELECT string_to_array(r, ' ') FROM (SELECT line FROM streetgen.export_wavefront(model, 'objects', options) ORDER BY ordinality) l, regexp_split_to_table(line, E'\n') r $$;
CREATE TEMPORARY TABLE word AS SELECT row_number() OVER () AS n, w FROM pg_temp.object('town', '{"origin": "middle"}') w;
CREATE TEMPORARY TABLE told AS SELECT w[3]::float8 AS x, w[4]::float8 AS y, rtrim(w[5], ',')::float8 AS z FROM word WHERE w[1:2] = '{#,origin}';
SELECT 'the middle of what is written, in whole metres', (x, y, z) = (SELECT floor((ST_XMin(b) + ST_XMax(b)) / 2), floor((ST_YMin(b) + ST_YMax(b)) / 2), 0 FROM (SELECT ST_Extent(geom) AS b FROM town.edge) e) FROM told;
CREATE TEMPORARY TABLE place AS SELECT row_number() OVER (ORDER BY n) AS vertex, w[2]::float8 + told.x AS x, w[3]::float8 + told.y AS y, w[4]::float8 + told.z AS z FROM word, told WHERE w[1] = 'v';
CREATE TEMPORARY TABLE wing AS SELECT n, k, split_part(w[k], '/', 1)::bigint AS v, split_part(w[k], '/', 2)::bigint AS vt, split_part(w[k], '/', 3)::bigint AS vn FROM word, generate_series(2, 4) k WHERE w[1] = 'f';
SELECT 'an object for each road of the other files', (SELECT array_agg(w[2] ORDER BY w[2]) FROM word WHERE w[1] = 'o') = (SELECT array_agg(road ORDER BY road) FROM (SELECT DISTINCT road FROM face) f);
SELECT 'no place has two vertices, and each one is used', count(*) = count(DISTINCT (x, y, z)) AND count(*) = (SELECT count(DISTINCT v) FROM wing) FROM place;
SELECT 'the places are those of CityJSON', count(*) > 0 AND count(*) = count(v.vertex) FROM place p LEFT JOIN vertex v ON abs(v.x - p.x) < 5e-4 AND abs(v.y - p.y) < 5e-4 AND abs(v.z - p.z) < 5e-4;
SELECT 'texture coordinates and normals are there', bool_and(vt BETWEEN 1 AND (SELECT count(*) FROM word WHERE w[1] = 'vt') AND vn BETWEEN 1 AND (SELECT count(*) FROM word WHERE w[1] = 'vn')) FROM wing;
SELECT 'normals are of one metre', bool_and(abs(sqrt(w[2]::float8 ^ 2 + w[3]::float8 ^ 2 + w[4]::float8 ^ 2) - 1) < 2e-3) FROM word WHERE w[1] = 'vn';
SELECT 'each material has its colour', (SELECT array_agg(DISTINCT w[2] ORDER BY w[2]) FROM word WHERE w[1] = 'usemtl') = '{intersection,kerb,lane_separator,section,sidewalk}'
    AND (SELECT count(*) FROM streetgen.export_wavefront('town', 'materials') m WHERE split_part(m.line, E'\n', 1) IN (SELECT 'newmtl ' || w[2] FROM word WHERE w[1] = 'usemtl')) = 5;

INSERT INTO flat.symbol_rule (theme, layer, kind, place, fill) VALUES ('street', 'section', E'red brick\nf 1 2 3', 1, '#ff0000');
SELECT 'a kind with spaces is one word', (SELECT count(*) FROM streetgen.export_wavefront('flat', 'materials') m WHERE split_part(m.line, E'\n', 1) = 'newmtl section_red_brick_f_1_2_3') = 1 AND NOT EXISTS (SELECT FROM streetgen.export_wavefront('flat', 'materials') m WHERE m.line ~ '(?n)^f');

SELECT 'parts are of a megabyte at most, numbered from one', max(length(part)) <= 1048576 AND array_agg(ordinality ORDER BY ordinality) = array_agg(n ORDER BY n) FROM (SELECT *, row_number() OVER (ORDER BY ordinality) AS n FROM streetgen.export_gltf('town')) p;
-- Each square has four.
SELECT 'no part holds more than a thousand accessors', sum(n) = 4 * 20 * 13 AND max(n) <= 1000 AND sum(n) = (SELECT jsonb_array_length(pg_temp.told(pg_temp.file('wide')) -> 'accessors')) FROM (SELECT regexp_count(encode(part, 'escape'), '"bufferView"') AS n FROM streetgen.export_gltf('wide')) p;

-- 3D Tiles: a tree of squares on earth, each with its file of glTF.
CREATE TEMPORARY TABLE tileset AS SELECT convert_from(string_agg(part, '' ORDER BY ordinality), 'UTF8')::jsonb AS told FROM streetgen.export_tiles('town', '{"undulation": 44.5}') WHERE path = 'tileset.json';
CREATE TEMPORARY TABLE tile AS WITH RECURSIVE t AS (SELECT told -> 'root' AS tile, NULL::jsonb AS above FROM tileset UNION ALL SELECT c, tile FROM t, jsonb_array_elements(tile -> 'children') c) SELECT * FROM t;
SELECT 'version 1.1, whose root is drawn in parts', told #>> '{asset,version}' = '1.1' AND told #>> '{root,refine}' = 'ADD' FROM tileset;
SELECT 'a file for each square with streets, each named once', (SELECT array_agg(path ORDER BY path) FROM (SELECT DISTINCT path FROM streetgen.export_tiles('town') WHERE path <> 'tileset.json') f) = (SELECT array_agg(tile #>> '{content,uri}' ORDER BY tile #>> '{content,uri}') FROM tile WHERE tile ? 'content')
    AND (SELECT count(*) FROM tile WHERE tile ? 'content') = (SELECT jsonb_array_length(told -> 'nodes') FROM solid);
SELECT 'a tile lies in the one above, which is as wrong as it is large', count(*) > 0 AND bool_and((tile ->> 'geometricError')::float8 < (above ->> 'geometricError')::float8
    AND (SELECT bool_and(CASE WHEN n IN (1, 2, 5) THEN (o ->> 0)::float8 ELSE -(o ->> 0)::float8 END >= CASE WHEN n IN (1, 2, 5) THEN (a ->> 0)::float8 ELSE -(a ->> 0)::float8 END)
        FROM (SELECT n, jsonb_build_array(tile #> ARRAY['boundingVolume', 'region', (n - 1)::text]) AS o, jsonb_build_array(above #> ARRAY['boundingVolume', 'region', (n - 1)::text]) AS a FROM generate_series(1, 6) n) r)) FROM tile WHERE above IS NOT NULL;
SELECT 'its matrix puts what lies 400 m away on earth, by 0.05 m', bool_and(sqrt((SELECT sum((m[n] * dx + m[n + 4] * dy + m[n + 8] * dz + m[n + 12] - there[n]) ^ 2) FROM generate_series(1, 3) n)) < 0.05)
    FROM streetgen._tiles('town', '{"undulation": 44.5, "extent": null, "level": null}') t JOIN tile ON tile #>> '{content,uri}' = t.path, LATERAL (SELECT array_agg(v::float8 ORDER BY n) AS m FROM jsonb_array_elements_text(tile -> 'transform') WITH ORDINALITY e(v, n)) m,
        (VALUES (0, 0, 0), (400, 0, 10), (0, -400, 0), (-280, 280, 5)) v(dx, dy, dz), LATERAL (SELECT ST_Transform(ST_Translate(t.origin, dx, dy, dz + 44.5), 4978) AS p) p, LATERAL (SELECT ARRAY[ST_X(p), ST_Y(p), ST_Z(p)] AS there) w;
SELECT 'a tile holds the triangles of its square', (SELECT sum((pg_temp.told(file) #>> ARRAY['accessors', '3', 'count'])::bigint) > 0 FROM (SELECT string_agg(part, '' ORDER BY ordinality) AS file FROM streetgen.export_tiles('town') WHERE path <> 'tileset.json' GROUP BY path) f);

-- Squares on both sides of the origin of the SRID: the equator.
DO $$ BEGIN
  PERFORM streetgen.create_model('equator', 32631, subjects => '{surface}');
  INSERT INTO equator.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(500000, y), ST_MakePoint(500040, y)), 32631), 6 FROM unnest('{-700,-200,300}'::float8[]) y;
END $$;
SELECT 'squares with negative numbers are of the tree', (SELECT array_agg(u ORDER BY u) FROM jsonb_path_query(told, 'strict $.**.uri') u) = '{"\"1000_-1.glb\"","\"1000_-2.glb\"","\"1000_0.glb\""}' AND (told ->> 'geometricError')::float8 = 2000
  FROM (SELECT convert_from(string_agg(part, '' ORDER BY ordinality), 'UTF8')::jsonb AS told FROM streetgen.export_tiles('equator') WHERE path = 'tileset.json') t;

SELECT 'the same bytes again', pg_temp.file('town') = (SELECT file FROM solid) AND md5(pg_temp.city('town')::text) = (SELECT md5(city::text) FROM city);
SELECT 'bad input: ' || statement, test.state(statement) = expected FROM (VALUES
    ($$SELECT streetgen.export_cityjson('bare')$$, '22023'), ($$SELECT streetgen.export_gltf('bare')$$, '22023'), ($$SELECT streetgen.export_cityjson('town', '{"junctions": "node"}')$$, '22023'),
    ($$SELECT streetgen.export_gltf('town', '{"origin": "left"}')$$, '22023'), ($$SELECT streetgen.export_gltf('town', '{"origin": [1]}')$$, '22023'), ($$SELECT streetgen.export_gltf('town', '{"origin": [1, "2"]}')$$, '22023'), ($$SELECT streetgen.export_cityjson('town', '{"origin": [1, 1e30, 0]}')$$, '22023'),
    ($$SELECT streetgen.export_wavefront('town', 'nothing')$$, '22023'), ($$SELECT streetgen.export_tiles('town', '{"undulation": 200}')$$, '22023'), ($$SELECT streetgen.export_tiles('bare')$$, '22023'), ($$SELECT streetgen.export_wavefront('town', NULL)$$, '22004'), ($$SELECT streetgen.export_wavefront('bare', 'objects')$$, '22023'), ($$SELECT streetgen.export_gltf('town', '{"tolerance": 0}')$$, '22023'), ($$SELECT streetgen.export_gltf('town', '{"precision": 3}')$$, '22023'), ($$SELECT streetgen.export_cityjson('town', '{"precision": 9}')$$, '22023'),
    ($$SELECT streetgen.export_gltf('town', NULL)$$, '22023'), ($$SELECT streetgen.export_gltf('nowhere')$$, '3F000'), ($$SELECT streetgen.export_gltf('town', '{"extent": [0, 0, 1, 1]}')$$, '22023')) s(statement, expected);
