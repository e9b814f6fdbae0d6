\set ECHO none
\ir shared/truths.sql
-- Who may drive: column access, the lanes, paths and files that follow it, and what sources say of it.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction}', driving_side => 'right'), streetgen.create_model('left_town', 2154, subjects => '{junction}', driving_side => 'left');
END $$;
CREATE VIEW street AS SELECT * FROM (VALUES
    (1, ST_GeomFromText('LINESTRING(650000 6860000,650100 6860000)', 2154), NULL), (2, ST_GeomFromText('LINESTRING(650100 6860000,650200 6860000)', 2154), NULL),
    (3, ST_GeomFromText('LINESTRING(650100 6860000,650100 6860100)', 2154), 'bus'), (4, ST_GeomFromText('LINESTRING(650100 6860000,650100 6859900)', 2154), 'cycle'),
    (5, ST_GeomFromText('LINESTRING(650200 6860000,650300 6860000)', 2154), 'no'), (6, ST_GeomFromText('LINESTRING(650200 6860000,650200 6860100)', 2154), 'private'),
    (7, ST_GeomFromText('LINESTRING(650200 6860000,650200 6859900)', 2154), '|bus')) v(axis_id, geom, access);
INSERT INTO town.axis (axis_id, geom, width, lane_count, access) SELECT axis_id, geom, 7, 2, access FROM street;
-- The same, driven on the left and drawn the other way.
INSERT INTO left_town.axis (axis_id, geom, width, lane_count, access) SELECT axis_id, ST_Reverse(geom), 7, 2, CASE access WHEN '|bus' THEN 'bus|' ELSE access END FROM street;
CREATE FUNCTION pg_temp.kinds(model name) RETURNS text LANGUAGE plpgsql AS $$ BEGIN
  PERFORM set_config('search_path', quote_ident(model) || ', pg_temp, public', true);
  RETURN (SELECT string_agg(axis_id || ' ' || kinds, ', ' ORDER BY axis_id) FROM (SELECT e.axis_id, string_agg(DISTINCT l.kind, '+' ORDER BY l.kind) AS kinds FROM lane l JOIN edge e USING (edge_id) GROUP BY e.axis_id) k); END $$;
CREATE FUNCTION pg_temp.ways(model name, a bigint, b bigint) RETURNS text LANGUAGE plpgsql AS $$ BEGIN
  PERFORM set_config('search_path', quote_ident(model) || ', pg_temp, public', true);
  RETURN (SELECT string_agg(DISTINCT coalesce(m.traffic, 'all'), ' ') FROM movement m JOIN lane i ON i.lane_id = m.lane_in JOIN edge e ON e.edge_id = i.edge_id JOIN lane o ON o.lane_id = m.lane_out JOIN edge f ON f.edge_id = o.edge_id
    WHERE m.connecting AND (e.axis_id, f.axis_id) = (a, b)); END $$;
SELECT 'lanes are those of who may drive', pg_temp.kinds('town') = '1 general, 2 general, 3 bus, 4 cycle, 5 closed, 6 general, 7 bus+general';
SELECT 'driven on the left and drawn the other way too', pg_temp.kinds('left_town') = pg_temp.kinds('town');
SELECT 'both lanes share the roadway, whoever they are for', bool_and(width = 3.5) FROM town.lane;
SELECT m || ': cars go round streets that are not theirs', pg_temp.ways(m, 1, 2) = 'all' AND pg_temp.ways(m, 2, 1) = 'all' AND pg_temp.ways(m, 2, 6) = 'all' FROM unnest('{town,left_town}'::name[]) m;
SELECT m || ': buses come upon their street from every lane for all, and leave it', pg_temp.ways(m, 1, 3) = 'bus' AND pg_temp.ways(m, 2, 3) = 'bus' AND pg_temp.ways(m, 3, 1) = 'bus' AND pg_temp.ways(m, 3, 2) = 'bus' FROM unnest('{town,left_town}'::name[]) m;
SELECT m || ': so do bicycles', pg_temp.ways(m, 1, 4) = 'cycle' AND pg_temp.ways(m, 2, 4) = 'cycle' AND pg_temp.ways(m, 4, 2) = 'cycle' FROM unnest('{town,left_town}'::name[]) m;
SELECT m || ': nobody drives on a closed street', pg_temp.ways(m, 2, 5) IS NULL AND pg_temp.ways(m, 5, 2) IS NULL FROM unnest('{town,left_town}'::name[]) m;
SELECT m || ': a word for one direction leaves the other', pg_temp.ways(m, 2, 7) = 'all' AND pg_temp.ways(m, 7, 2) = 'bus' FROM unnest('{town,left_town}'::name[]) m;
SELECT 'a model without findings of lanes', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule LIKE 'lane%way%');
-- An edit.
UPDATE town.axis SET access = 'bus' WHERE axis_id IN (2, 6);
SELECT 'lanes follow an edit', pg_temp.kinds('town') LIKE '%2 bus, %6 bus%';
UPDATE town.axis SET access = 'bus' WHERE axis_id = 4;
SELECT 'cars that can only come upon streets of others are named', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'lane for cars that leads only where they may not drive');
UPDATE town.axis SET access = s.access FROM street s WHERE s.axis_id = axis.axis_id;
SELECT 'and back', pg_temp.kinds('town') = pg_temp.kinds('left_town');
SELECT 'other words are refused', bool_and(test.state(format('UPDATE town.axis SET access = %L WHERE axis_id = 1', word)) = '23514') FROM unnest('{yes,"",|,no|bus|,bus;cycle}'::text[]) word;
-- Files.
CREATE FUNCTION pg_temp.found(path text, lines text[]) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, xmlparse(document array_to_string(lines, E'\n')))) $$;
CREATE TABLE written AS SELECT (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_opendrive('town')) AS opendrive, (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_sumo('town', 'edges')) AS edges,
  (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_sumo('town', 'connections')) AS connections, (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_lanelet2('town')) AS lanelet2, (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_symuvia('town')) AS symuvia;
SELECT 'OpenDRIVE has restricted lanes, those of buses and bicycles, and no way through', pg_temp.found('//road[@junction="-1"]//lane[@type="restricted"]', opendrive) = 2 AND pg_temp.found('//road[@junction="-1"]//lane[@type="bus"]', opendrive) = 3 AND pg_temp.found('//road[@junction="-1"]//lane[@type="biking"]', opendrive) = 2
  AND pg_temp.found('//lane/access[@rule="deny" and @restriction="throughTraffic"]', opendrive) = 2 AND pg_temp.found('//road[@junction!="-1"]//lane[@type="bus"]', opendrive) > 4 FROM written;
SELECT 'SUMO lets nobody in, buses, bicycles, or residents', pg_temp.found('//lane[@disallow="all"]', edges) = 2 AND pg_temp.found('//lane[starts-with(@allow, "bus")]', edges) = 3 AND pg_temp.found('//lane[@allow="bicycle"]', edges) = 2 AND pg_temp.found('//lane[starts-with(@allow, "private")]', edges) = 2
  AND pg_temp.found('//connection[starts-with(@allow, "bus")]', connections) >= 2 AND pg_temp.found('//connection[@allow="bicycle"]', connections) >= 2 FROM written;
SELECT 'no lanelet is closed', pg_temp.found('//tag[@v="lanelet"]', lanelet2) > 0 AND bool_and(pg_temp.found('//relation[@id="' || streetgen._file_id('lane', lane_id) || '"]', lanelet2) = (axis_id <> 5)::integer) FROM written, town.edge JOIN town.lane USING (edge_id) GROUP BY lanelet2;
SELECT 'closed and reserved lanes of SymuVia', pg_temp.found('//VOIE_INTERDITE', symuvia) = 2 AND pg_temp.found('//VOIE_RESERVEE', symuvia) = 5 FROM written;
-- Streets that nobody may drive through, word by word.
CREATE FUNCTION pg_temp.through(word text, OUT sumo text, OUT opendrive integer, OUT lanelet2 integer) LANGUAGE plpgsql AS $$ BEGIN
  UPDATE town.axis SET access = word WHERE axis_id = 6;
  sumo := (SELECT string_agg(DISTINCT allow::text, ', ') FROM town.edge e, unnest(xpath('//edge[@id="' || edge_id || '" or @id="-' || edge_id || '"]/lane/@allow', (SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo('town', 'edges')))) allow WHERE axis_id = 6 AND allow::text <> 'pedestrian');
  opendrive := pg_temp.found('//lane/access[@rule="deny" and @restriction="throughTraffic"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_opendrive('town')));
  lanelet2 := pg_temp.found('//tag[@k="location" and @v="private"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_lanelet2('town'))); END $$;
SELECT word || ': no car for all drives through', allow NOT LIKE '%passenger%' AND sumo = allow AND (opendrive, lanelet2) = (2, 2) FROM (VALUES ('private', 'private emergency authority delivery bicycle'), ('destination', 'private emergency authority delivery taxi bicycle'),
  ('customers', 'private emergency authority delivery taxi bicycle'), ('delivery', 'delivery emergency authority bicycle')) v(word, allow), LATERAL pg_temp.through(word);
-- Exceptions of restrictions, for whoever drives on a lane for all.
UPDATE town.axis SET access = NULL;
INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind, except_kinds) VALUES (1, 4, 'SRID=2154;POINT(650100 6860000)', 'no', 'bus'), (2, 1, 'SRID=2154;POINT(650100 6860000)', 'only', 'bus|cycle');
SELECT 'a ban with an exception leaves a path to those alone', pg_temp.ways('town', 1, 4) = 'bus' AND pg_temp.ways('town', 1, 2) = 'all';
SELECT 'so does an only way', pg_temp.ways('town', 2, 3) = 'bus|cycle' AND pg_temp.ways('town', 2, 1) = 'all';
SELECT 'a connection of SUMO says it', pg_temp.found('//connection[@allow="bus coach taxi emergency bicycle"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_sumo('town', 'connections'))) = 2;
SELECT 'and a way of OpenDRIVE', pg_temp.found('//road[@junction!="-1"]//lane[@type="bus"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_opendrive('town'))) = 3;
SELECT 'a movement of SymuVia says whom it bars', count(*) = 1 FROM town.edge e, town.edge f, LATERAL (SELECT array_agg(line ORDER BY ordinality) AS lines FROM streetgen.export_symuvia('town')) x
  WHERE (e.axis_id, f.axis_id) = (1, 4) AND pg_temp.found('//MOUVEMENT_AUTORISE[@id_troncon_amont="' || e.edge_id || '"]//MOUVEMENT_SORTIE[@id_troncon_aval="' || f.edge_id || '"][contains(@exclusion_types_vehicules, "VL")]', lines) > 0
    AND pg_temp.found('//MOUVEMENT_AUTORISE[@id_troncon_amont="' || e.edge_id || '"]//MOUVEMENT_SORTIE[@id_troncon_aval="' || f.edge_id || '"][not(@exclusion_types_vehicules)]', lines) = 0;
-- Tags of OpenStreetMap.
CREATE TABLE said (tags jsonb, class text, means text);
INSERT INTO said VALUES ('{}', 'residential', NULL), ('{"access": "yes"}', 'residential', NULL), ('{"access": "no", "bus": "yes"}', 'secondary', 'bus'), ('{"motor_vehicle": "no", "psv": "yes"}', 'unclassified', 'bus'), ('{}', 'busway', 'bus'), ('{"access": "private"}', 'service', 'private'),
  ('{"motor_vehicle": "no"}', 'residential', 'cycle'), ('{"access": "no", "bicycle": "yes"}', 'residential', 'cycle'), ('{"access": "no"}', 'service', 'no'), ('{"vehicle": "no"}', 'residential', 'no'), ('{"access": "no", "motor_vehicle": "yes"}', 'service', NULL), ('{"access": "no", "vehicle": "permissive"}', 'service', NULL),
  ('{"motorcar": "no"}', 'residential', 'bus'), ('{"access": "destination"}', 'residential', 'destination'), ('{"motor_vehicle": "agricultural;destination"}', 'track', 'destination'), ('{"motor_vehicle": "agricultural"}', 'track', 'cycle'), ('{"vehicle": "customers"}', 'service', 'customers'), ('{"access": "delivery"}', 'service', 'delivery'),
  ('{"access": "permit"}', 'service', 'private'), ('{"access": "hov"}', 'motorway_link', 'carpool'), ('{"motor_vehicle:backward": "no"}', 'residential', '|cycle'), ('{"motor_vehicle": "no", "bus:forward": "yes"}', 'residential', 'bus|cycle'), ('{"access": "nonsense"}', 'residential', NULL), ('{}', 'pedestrian', 'no'), ('{"motor_vehicle": "delivery"}', 'pedestrian', 'delivery'),
  ('{}', 'cycleway', 'cycle'), ('{"access": "no", "taxi": "yes"}', 'residential', 'bus'), ('{"access": "no", "bus": "no"}', 'residential', 'no'),
  ('{"access": "private", "bus": "yes"}', 'service', 'bus'), ('{"motor_vehicle": "permit", "psv": "designated"}', 'residential', 'bus'), ('{"access": "private", "psv:forward": "yes"}', 'service', 'bus|private'), ('{"access": "private", "bus": "no"}', 'service', 'private'), ('{"access": "private", "bicycle": "yes"}', 'service', 'private'),
  ('{"motor_vehicle": "destination", "bus": "yes"}', 'residential', 'destination'), ('{"hov": "designated"}', 'motorway', 'carpool'), ('{"hov": "designated", "hov:lanes": "designated||"}', 'motorway', NULL), ('{"hov:backward": "designated"}', 'primary', '|carpool'), ('{"hov": "yes"}', 'motorway', NULL), ('{"hov": "designated", "access": "private"}', 'service', 'private');
INSERT INTO said VALUES ('{"motor_vehicle": "no", "bus:lanes": "designated|designated", "oneway": "yes"}', 'residential', 'bus'), ('{"access": "no", "psv:lanes": "designated|designated", "lanes": "2"}', 'service', 'bus'), ('{"motor_vehicle": "no", "bus:lanes:forward": "designated", "lanes": "2"}', 'residential', 'bus|cycle'),
  ('{"access": "no", "lanes:psv": "2", "lanes": "2"}', 'residential', 'bus'), ('{"access": "no", "busway:left": "lane", "oneway": "yes"}', 'residential', 'bus'), ('{"access": "foot"}', 'residential', 'no'), ('{"vehicle": "dismount", "bus": "yes"}', 'residential', 'bus');
CREATE FUNCTION pg_temp.read_tags(tags jsonb, class text) RETURNS TABLE(access text, kinds text) LANGUAGE sql AS $$
  SELECT l.access, concat_ws('/', kind_forward, kind_backward) FROM (SELECT array_agg(key) AS keys, array_agg(value) AS words FROM jsonb_each_text(tags || jsonb_build_object('highway', class))) t,
    streetgen._osm_lanes(keys, words, 'right', 3.5, 1.5, 2, 0, 1, 4.5, 2.625, 4.5, 5) l $$;
SELECT concat_ws(' ', tags, class), access IS NOT DISTINCT FROM means FROM said, pg_temp.read_tags(tags, class);
SELECT 'lanes of a street for buses alone are those of buses', count(*) > 5 AND bool_and(kinds IN ('', 'bus', 'bus|bus', 'bus/bus')) FROM said, pg_temp.read_tags(tags, class) WHERE access = 'bus';
SELECT 'words mean the same of a lane, of a way and of a table', bool_and(CASE streetgen._access_word(word) WHEN 'no' THEN kinds = 'closed' WHEN 'private' THEN kinds = 'closed' WHEN 'bus' THEN kinds = 'bus' WHEN 'carpool' THEN kinds = 'carpool' WHEN 'cycle' THEN kinds = 'cycle' ELSE kinds = '' END
    AND coalesce(access, '') = streetgen._access_word(word)) FROM unnest('{foot,dismount,no,private,permit,psv,hov,bicycle,destination,yes,customers,delivery,agricultural}'::text[]) word, LATERAL (SELECT kinds FROM pg_temp.read_tags(jsonb_build_object('access:lanes', word, 'oneway', 'yes'), 'residential')) l,
    LATERAL (SELECT access FROM pg_temp.read_tags(jsonb_build_object('access', word, 'bicycle', 'no'), 'residential')) w;
-- A table of anybody's.
CREATE TABLE lines (id text, who text, geom geometry(LineString, 2154));
INSERT INTO lines SELECT axis_id::text, (ARRAY['Private', 'bus|no', 'anything', 'permissive', NULL, 'psv', 'forestry'])[axis_id], ST_Translate(geom, 0, 5000) FROM street;
CREATE TABLE report AS SELECT * FROM streetgen.import_axes('town', 'lines', '{"source_ref": "id", "access": "who"}');
SELECT 'a mapping takes words', (SELECT string_agg(coalesce(access, '-'), ' ' ORDER BY source_ref) = 'private bus|no - - - bus no' FROM town.axis WHERE source = 'lines');
SELECT 'one that means nothing is told by its row', (SELECT source_refs = '{3}' FROM report WHERE what = 'access not understood, taken as unknown');
