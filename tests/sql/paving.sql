\set ECHO none
\ir shared/truths.sql
-- What the strips of a street are paved with: by hand, by footways, by tags; and how it is shown.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{lane,footway}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, importance, kind_forward, paved, sidewalk_paved_left, sidewalk_paved_right, cycle_paved_right) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 10, 4, 'general|cycle', 'sett', 'paving_stones', 'paving_stones', 'asphalt'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 4, NULL, 'cobblestone', NULL, NULL, NULL),
    (3, pg_temp.line('LINESTRING(0 200,100 200)'), 8, 4, NULL, NULL, NULL, NULL, NULL), (4, pg_temp.line('LINESTRING(0 300,100 300)'), 8, 4, NULL, 'gravel', 'gravel', NULL, NULL);
END $$;
CREATE FUNCTION pg_temp.paved(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT string_agg(DISTINCT concat_ws(' ', side, kind, paved), ', ' ORDER BY concat_ws(' ', side, kind, paved)) FROM town.cross_section WHERE axis_id = axis AND paved IS NOT NULL $$;
SELECT 'strips have the surfaces of their axis', pg_temp.paved(1) = 'left general sett, left sidewalk paving_stones, right cycle asphalt, right general sett, right sidewalk paving_stones';
SELECT 'nothing is known of one that says nothing', pg_temp.paved(3) IS NULL;
SELECT 'kerbs and what lies behind have none', NOT EXISTS (SELECT FROM town.cross_section WHERE paved IS NOT NULL AND (kind IN ('kerb', 'outer', 'median', 'island', 'splitter') OR offset_to IS NULL));
INSERT INTO town.footway (footway_id, geom, role, surface) VALUES (1, pg_temp.line('LINESTRING(0 6.5,70 6.5)'), 'sidewalk', 'concrete'), (2, pg_temp.line('LINESTRING(70 6.5,100 6.5)'), 'sidewalk', 'asphalt'), (3, pg_temp.line('LINESTRING(0 -6.5,100 -6.5)'), 'sidewalk', NULL);
SELECT 'a footway that maps a sidewalk says its surface, the longest of several', (p.sidewalk_left, p.sidewalk_right) = ('concrete', 'paving_stones') FROM town.paving p JOIN town.edge USING (edge_id) WHERE axis_id = 1;
UPDATE town.footway SET surface = 'sett' WHERE footway_id = 1;
SELECT 'live', p.sidewalk_left = 'sett' FROM town.paving p JOIN town.edge USING (edge_id) WHERE axis_id = 1;
UPDATE town.axis SET paved = 'asphalt' WHERE axis_id = 2;
SELECT 'an axis too', roadway = 'asphalt' AND cycle_left = 'asphalt' FROM town.paving p JOIN town.edge USING (edge_id) WHERE axis_id = 2;
SELECT 'kinds of looks', array_agg(streetgen._paving_kind(p) ORDER BY n) = '{stone,stone,stone,unpaved,unpaved,"","",""}' FROM unnest(ARRAY['sett', 'paving_stones:30', 'unhewn_cobblestone', 'gravel', 'grass', 'asphalt', 'concrete', NULL]) WITH ORDINALITY u(p, n);
CREATE TEMP TABLE drawn AS SELECT * FROM streetgen._surface_drawn('town', (SELECT ST_Expand(ST_Extent(geom)::geometry, 50) FROM town.axis), '{section,intersection}') UNION ALL SELECT * FROM streetgen._sidewalk_drawn('town', (SELECT ST_Expand(ST_Extent(geom)::geometry, 50) FROM town.axis), '{sidewalk}');
SELECT 'sections and sidewalks are drawn by it', (SELECT array_agg(DISTINCT kind ORDER BY kind) FROM drawn d WHERE d.layer = 'section') = '{"",stone,unpaved}' AND (SELECT array_agg(DISTINCT kind ORDER BY kind) FROM drawn d WHERE d.layer = 'sidewalk') @> '{stone,unpaved}';
INSERT INTO town.axis (axis_id, geom, width, paved) VALUES (21, pg_temp.line('LINESTRING(500 0,600 0)'), 8, 'sett'), (22, pg_temp.line('LINESTRING(600 0,700 0)'), 8, 'cobblestone'), (23, pg_temp.line('LINESTRING(600 0,600 90)'), 8, 'sett');
CREATE FUNCTION pg_temp.junction() RETURNS text LANGUAGE sql AS $$ SELECT kind FROM streetgen._surface_drawn('town', ST_Expand(pg_temp.line('POINT(600 0)'), 5), '{intersection}') $$;
SELECT 'a junction looks as its streets do, where these are paved alike', pg_temp.junction() = 'stone';
UPDATE town.axis SET paved = 'asphalt' WHERE axis_id = 23;
SELECT 'else as any other', pg_temp.junction() = '';
SELECT 'a picture has the colour of stones', streetgen.svg('town') ~ '#8b8079';
SELECT 'CityJSON says the material', count(*) FILTER (WHERE line ~ '"surfaceMaterial":"sett"') = 2 AND count(*) FILTER (WHERE line ~ '"surfaceMaterial":"paving_stones"') = 0 FROM streetgen.export_cityjson('town');
-- Files ask from any search path.
CREATE FUNCTION pg_temp.exported(layer text) RETURNS jsonb LANGUAGE plpgsql SET search_path = public AS $$
DECLARE rows jsonb; BEGIN
  EXECUTE format('SELECT coalesce(jsonb_agg(to_jsonb(l)), ''[]'') FROM (%s) l', (SELECT query FROM streetgen.export_layer('town') e WHERE e.layer = $1)) INTO rows;
  RETURN rows;
END $$;
SELECT 'every layer of files can be asked for', bool_and(jsonb_typeof(pg_temp.exported(layer)) = 'array') FROM streetgen.export_layer('town');
SELECT 'roads and sidewalks say what they are paved with', pg_temp.exported('roads') @? '$[*] ? (@.paved == "sett")' AND pg_temp.exported('sidewalks') @? '$[*] ? (@.paved == "paving_stones")';
-- Tags of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line SELECT n, 'residential', 'street ' || n, NULL, tags::jsonb, 2, pg_temp.line(format('LINESTRING(0 %s,100 %1$s)', 1000 + 100 * n)) FROM (VALUES (1, '{"surface": "asphalt", "sidewalk": "both", "sidewalk:both:surface": "paving_stones"}'),
  (2, '{"surface": "sett", "sidewalk:left:surface": "concrete", "cycleway:right": "lane", "cycleway:right:surface": "asphalt"}'), (3, '{"sidewalk:width": "2.5", "sidewalk:right:width": "4", "sidewalk:surface": "sett", "sidewalk:right:surface": "gravel", "cycleway:surface": "paving_stones"}'), (4, '{}')) v(n, tags);
CREATE TABLE told AS SELECT * FROM streetgen.import_osm('town');
SELECT 'tags of surfaces are columns', array_agg(concat_ws(' ', source_ref, paved, '|', sidewalk_paved_left, sidewalk_paved_right, '|', cycle_paved_left, cycle_paved_right) ORDER BY source_ref)
  = '{"1 asphalt | paving_stones paving_stones |","2 sett | concrete | asphalt","3 | sett gravel | paving_stones paving_stones","4 | |"}' FROM town.axis WHERE source IS NOT NULL;
SELECT 'a width of sidewalks that names no side is that of both', (sidewalk_left, sidewalk_right) = (2.5, 4) FROM town.axis WHERE source_ref = '3';
SELECT 'none is named as unread', NOT EXISTS (SELECT FROM told WHERE what ~ 'surface|understood') AND NOT EXISTS (SELECT FROM town.unread_tag WHERE tag ~ 'surface');
UPDATE osm_line SET tags = tags || '{"surface": "concrete"}' WHERE way_id = 4;
SELECT FROM streetgen.import_osm('town') \g /dev/null
SELECT 'a source that says another brings it', paved = 'concrete' FROM town.axis WHERE source_ref = '4';
CREATE TABLE own AS SELECT 'x' || n AS id, pg_temp.line(format('LINESTRING(1000 %s,1100 %1$s)', 100 * n)) AS geom, 'sett'::text AS belag FROM generate_series(1, 3) n;
SELECT FROM streetgen.import_axes('town', 'own', '{"source_ref": "id", "paved": "belag"}') \g /dev/null
SELECT 'a mapping names the column', count(*) = 3 FROM town.axis WHERE source_ref LIKE 'x%' AND paved = 'sett';
SELECT count(*) FROM streetgen.switch_subject('town', 'footway', false) \g /dev/null
SELECT 'without footways the axis says it', p.sidewalk_left = 'paving_stones' FROM town.paving p JOIN town.edge USING (edge_id) WHERE axis_id = 1;
SELECT 'nothing is wrong', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
