\set ECHO none
\ir shared/truths.sql
-- Files of OpenSidewalks, by the rules of its schema 0.2: identities, words, ranges, kerbs, and the graph.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{footway,object}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, radius, importance, sidewalk_left, sidewalk_right, kind, name) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 5, 4, 2, 2, 'tertiary', 'high street'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 5, 4, 2, 2, 'tertiary', NULL),
    (3, pg_temp.line('LINESTRING(100 0,100 90)'), 6, 5, 4, 2, 2, 'residential', NULL), (4, pg_temp.line('LINESTRING(200 0,200 60)'), 4, 3, 6, 0, 0, 'primary_link', '"mill" lane');
  INSERT INTO town.pedestrian_crossing_editing (geom, marking, kerb) VALUES (pg_temp.line('POINT(50 0)'), 'zebra', 'lowered'), (pg_temp.line('POINT(150 0)'), 'lines', 'no');
  INSERT INTO town.footway (geom, kind, role, width, surface, incline, climb, tactile_paving, wheelchair, foot, name) VALUES
    (pg_temp.line('LINESTRING(60 5,60 40)'), 'footway', NULL, 1.5, 'sett', -4, NULL, NULL, NULL, 'permissive', 'the walk'), (pg_temp.line('LINESTRING(60 40,40 40)'), 'steps', NULL, NULL, 'wood', NULL, 'up', NULL, NULL, NULL, NULL),
    (pg_temp.line('LINESTRING(88 -6,88 6)'), 'footway', 'crossing', NULL, 'lava', NULL, NULL, 'yes', NULL, NULL, NULL);
END $$;
CREATE TABLE test.file AS SELECT string_agg(line, E'\n' ORDER BY ordinality)::jsonb AS f FROM streetgen.export_opensidewalks('town');
CREATE TABLE test.feature AS SELECT row_number() OVER () AS n, t -> 'properties' AS p, t -> 'geometry' ->> 'type' AS type, ST_GeomFromGeoJSON(t ->> 'geometry') AS geom FROM test.file, jsonb_array_elements(f -> 'features') t;
CREATE VIEW test.node AS SELECT * FROM test.feature WHERE type = 'Point';
CREATE VIEW test.edge AS SELECT * FROM test.feature WHERE type = 'LineString';
SELECT 'it names its schema', f ->> 'type' = 'FeatureCollection' AND f ->> '$schema' = 'https://sidewalks.washington.edu/opensidewalks/0.2/schema.json' FROM test.file;
SELECT 'all are nodes or edges, in WGS 84', bool_and(type IN ('Point', 'LineString') AND ST_X(ST_StartPoint(ST_MakeLine(geom, geom))) BETWEEN -180 AND 180) AND (SELECT count(*) > 15 FROM test.node) AND (SELECT count(*) > 20 FROM test.edge) FROM test.feature;
SELECT 'identities are texts and unique', count(*) = count(DISTINCT p ->> '_id') AND bool_and(jsonb_typeof(p -> '_id') = 'string') FROM test.feature;
SELECT 'an edge starts at one node and ends at another', bool_and(u.geom IS NOT NULL AND v.geom IS NOT NULL AND ST_Equals(u.geom, ST_StartPoint(e.geom)) AND ST_Equals(v.geom, ST_EndPoint(e.geom)))
  FROM test.edge e LEFT JOIN test.node u ON u.p ->> '_id' = e.p ->> '_u_id' LEFT JOIN test.node v ON v.p ->> '_id' = e.p ->> '_v_id';
SELECT 'each node is that of an edge', NOT EXISTS (SELECT FROM test.node n WHERE NOT EXISTS (SELECT FROM test.edge e WHERE n.p ->> '_id' IN (e.p ->> '_u_id', e.p ->> '_v_id')));
SELECT 'fields are those of the schema', bool_and(key = ANY (CASE type WHEN 'Point' THEN '{_id,barrier,kerb,tactile_paving}'::text[] ELSE '{_id,_u_id,_v_id,highway,footway,crossing:markings,climb,width,incline,length,surface,name}' END) OR key LIKE 'ext:%') FROM test.feature, jsonb_object_keys(p) key;
SELECT 'words are those of the schema', bool_and(coalesce(p ->> 'highway' IN ('footway', 'steps', 'primary', 'secondary', 'tertiary', 'residential', 'service', 'unclassified', 'trunk', 'living_street'), type = 'Point') AND (NOT p ? 'footway' OR p ->> 'footway' IN ('sidewalk', 'crossing') AND p ->> 'highway' = 'footway')
  AND (NOT p ? 'crossing:markings' OR p ->> 'crossing:markings' IN ('dashes', 'dots', 'ladder', 'lines', 'no', 'surface', 'yes', 'zebra') AND p ->> 'footway' = 'crossing') AND coalesce(p ->> 'surface' IN ('asphalt', 'concrete', 'gravel', 'grass', 'paved', 'paving_stones', 'unpaved', 'dirt', 'grass_paver'), true)
  AND (NOT p ? 'climb' OR p ->> 'climb' IN ('up', 'down') AND p ->> 'highway' = 'steps') AND (NOT p ? 'kerb' OR p ->> 'kerb' IN ('raised', 'lowered', 'rolled', 'flush') AND p ->> 'barrier' = 'kerb') AND coalesce(p ->> 'barrier' = 'kerb', true) AND (NOT p ? 'tactile_paving' OR p ->> 'tactile_paving' IN ('yes', 'no', 'contrasted', 'primitive') AND p ->> 'barrier' = 'kerb')) FROM test.feature;
SELECT 'numbers are numbers within their ranges', bool_and(coalesce((p -> 'width')::float8 BETWEEN 0 AND 500, true) AND coalesce((p -> 'incline')::float8 BETWEEN -1 AND 1, true) AND (p -> 'length')::float8 BETWEEN 0 AND 5000) FROM test.edge;
SELECT 'lengths are those of the lines', bool_and(abs((p -> 'length')::float8 - ST_Length(geom::geography)) < 0.02 + 0.002 * ST_Length(geom::geography)) FROM test.edge;
SELECT 'a crossing goes from kerb to kerb', count(*) >= 4 AND bool_and(u.p ->> 'barrier' = 'kerb' AND v.p ->> 'barrier' = 'kerb' AND (e.p -> 'length')::float8 BETWEEN 5.5 AND 8.5) FROM test.edge e JOIN test.node u ON u.p ->> '_id' = e.p ->> '_u_id' JOIN test.node v ON v.p ->> '_id' = e.p ->> '_v_id' WHERE e.p ->> 'footway' = 'crossing' AND NOT EXISTS (SELECT FROM town.edge s WHERE axis_id = 4 AND ST_DWithin(ST_Transform(e.geom, 2154), s.geom, 3));
SELECT 'kerbs and paint are as they are known', (SELECT count(*) = 2 FROM test.node WHERE p ->> 'kerb' = 'lowered') AND (SELECT count(*) = 2 FROM test.node WHERE p ->> 'kerb' = 'flush') AND (SELECT count(*) = 2 FROM test.node WHERE p ->> 'tactile_paving' = 'yes') AND (SELECT array_agg(p ->> 'crossing:markings' ORDER BY 1) @> '{lines,zebra}' FROM test.edge WHERE p ? 'crossing:markings');
SELECT 'a footway, steps and a street say what is known of them', (SELECT (p ->> 'surface', p -> 'incline', p ->> 'name', p ->> 'ext:foot', p -> 'width') = ('paving_stones', '-0.04', 'the walk', 'permissive', '1.5') FROM test.edge WHERE p ->> 'name' = 'the walk') AND (SELECT (p ->> 'surface', p ->> 'climb', p ->> 'ext:wheelchair') = ('paved', 'up', 'no') FROM test.edge WHERE p ->> 'highway' = 'steps')
  AND (SELECT p ->> 'name' = '"mill" lane' FROM test.edge WHERE p ->> 'highway' = 'primary');
SELECT 'a surface that the schema does not know is left out', count(*) = 3 AND bool_or(p ? 'surface') IS FALSE FROM test.edge WHERE p ->> '_id' LIKE (SELECT walk_link_id || '%' FROM town.walk_link WHERE footway_id = (SELECT max(footway_id) FROM town.footway));
SELECT 'an extent is a part of it', count(*) BETWEEN 3 AND 60 FROM streetgen.export_opensidewalks('town', '{"extent": [650040, 6859990, 650060, 6860010]}');
CREATE FUNCTION pg_temp.refused(statement text) RETURNS text LANGUAGE plpgsql AS $$ BEGIN EXECUTE statement; RETURN 'taken'; EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;
SELECT 'an option that it has not is refused', pg_temp.refused($$SELECT count(*) FROM streetgen.export_opensidewalks('town', '{"precision": 3}')$$) = '22023' AND pg_temp.refused($$SELECT count(*) FROM streetgen.export_opensidewalks('town', '{"extent": [0, 0, 1, 1]}')$$) = '22023';
SET streetgen_test.subjects = 'asked';
DO $$ BEGIN PERFORM streetgen.create_model('bare', 2154, subjects => '{sidewalk}'); END $$;
SELECT 'a model without the subject has none', pg_temp.refused($$SELECT count(*) FROM streetgen.export_opensidewalks('bare')$$) = '55000';
