\set ECHO none
\ir shared/truths.sql
\ir shared/delivery.sql
-- A new delivery of a source, and what was edited by hand in between.  Each SELECT is one truth: (name, holds).
SET streetgen.live = off;
SELECT setseed(0.42) \g /dev/null

-- Two sources of 150 streets each, that lie apart and bend by more than cleaning takes.
CREATE FUNCTION test.street(i integer) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ARRAY[ST_Point(x, y), ST_Point(x + 40, y + 9), ST_Point(x + 80, y - 7), ST_Point(x + 120, y)]), 2154) FROM (SELECT 650000 + 200 * (i % 12) AS x, 6860000 + 90 * (i / 12) AS y) p $$;
CREATE TABLE town_line (way_id bigint, class text, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text, junction text, layer text, bridge text, tunnel text, maxspeed text, sidewalk text,
  sidewalk_left_width text, turn_lanes text, cycleway text, geom geometry(LineString, 2154));
INSERT INTO town_line (way_id, class, name, lanes, width, oneway, maxspeed, turn_lanes, cycleway, sidewalk, geom)
SELECT i, (ARRAY['residential', 'secondary'])[1 + i % 2], CASE WHEN i % 3 > 0 THEN 'street ' || i END, CASE WHEN i % 4 > 0 THEN 1 + i % 3 END, CASE WHEN i % 5 > 1 THEN 5 + i % 5 END, CASE WHEN i % 6 = 0 THEN 'yes' END,
  CASE WHEN i % 7 > 2 THEN 30 END, CASE WHEN i % 18 = 0 THEN 'left|through' END, CASE WHEN i % 8 = 0 THEN 'lane' END, CASE WHEN i % 9 = 0 THEN 'left' END, test.street(i) FROM generate_series(1, 150) i;
CREATE TABLE troncon (cleabs text, nature text, nom_voie_ban_gauche text, importance text, fictif boolean, largeur_de_chaussee numeric(5,1), nombre_de_voies integer, position_par_rapport_au_sol text,
  sens_de_circulation text, vitesse_moyenne_vl integer, reserve_aux_bus text, geometrie geometry(LineString, 2154));
INSERT INTO troncon SELECT 'T' || i, 'Route à 1 chaussée', CASE WHEN i % 3 > 0 THEN 'rue ' || i END, 2 + i % 4, false, CASE WHEN i % 5 > 0 THEN 5 + i % 5 END, CASE WHEN i % 4 > 0 THEN 1 + i % 3 END, '0',
  (ARRAY['Double sens', 'Sens direct'])[1 + i % 2], 30 + 10 * (i % 3), CASE WHEN i % 10 = 0 THEN 'Sens direct' END, test.street(i) FROM generate_series(1, 150) i;

-- What the next delivery changes: of two streets in three one thing.
CREATE FUNCTION pg_temp.deliver() RETURNS void LANGUAGE sql AS $$
  UPDATE town_line SET maxspeed = 50 WHERE way_id % 12 = 1; UPDATE town_line SET name = 'new ' || way_id WHERE way_id % 12 = 4; UPDATE town_line SET lanes = '4', width = '12' WHERE way_id % 12 = 7;
  UPDATE town_line SET geom = ST_Translate(geom, 3, 5) WHERE way_id % 12 = 10; UPDATE town_line SET oneway = '-1' WHERE way_id % 12 = 2; UPDATE town_line SET name = NULL, sidewalk = 'right', sidewalk_left_width = '2' WHERE way_id % 12 = 5;
  UPDATE town_line SET class = 'tertiary', geom = ST_Translate(geom, 3, 5) WHERE way_id % 12 = 8; DELETE FROM town_line WHERE way_id % 12 = 11;
  INSERT INTO town_line (way_id, class, geom) SELECT i, 'residential', test.street(i) FROM generate_series(200, 210) i;
  UPDATE troncon SET vitesse_moyenne_vl = 70 WHERE substr(cleabs, 2)::integer % 12 = 1; UPDATE troncon SET nom_voie_ban_gauche = 'new' WHERE substr(cleabs, 2)::integer % 12 = 4;
  UPDATE troncon SET nombre_de_voies = 4, largeur_de_chaussee = 12 WHERE substr(cleabs, 2)::integer % 12 = 7; UPDATE troncon SET geometrie = ST_Translate(geometrie, 3, 5) WHERE substr(cleabs, 2)::integer % 12 = 10;
  UPDATE troncon SET sens_de_circulation = 'Sens inverse', reserve_aux_bus = NULL WHERE substr(cleabs, 2)::integer % 12 = 2; UPDATE troncon SET importance = '1', position_par_rapport_au_sol = '1' WHERE substr(cleabs, 2)::integer % 12 = 5;
  UPDATE troncon SET nature = 'Rond-point', geometrie = ST_Translate(geometrie, 3, 5) WHERE substr(cleabs, 2)::integer % 12 = 8; DELETE FROM troncon WHERE substr(cleabs, 2)::integer % 12 = 11;
  INSERT INTO troncon (cleabs, nature, largeur_de_chaussee, geometrie) SELECT 'T' || i, 'Chemin', 3, test.street(i) FROM generate_series(200, 210) i $$;

\set osm 'streetgen.import_osm(:m, ''town'')'
\set bdtopo 'streetgen.import_bdtopo(:m, ''troncon'')'
SELECT streetgen.create_model(m, 2154, driving_side => 'right') FROM unnest('{osm_hand,osm_source,osm_fresh,bd_hand,bd_source,bd_fresh}'::name[]) m \g /dev/null
SELECT streetgen.set(m, 'delivery_wins', 'source') FROM unnest('{osm_source,bd_source}'::name[]) m \g /dev/null
SELECT count(*) FROM unnest('{osm_hand,osm_source}'::name[]) m, streetgen.import_osm(m, 'town') \g /dev/null
SELECT count(*) FROM unnest('{bd_hand,bd_source}'::name[]) m, streetgen.import_bdtopo(m, 'troncon') \g /dev/null
CREATE TABLE osm_was AS SELECT * FROM test.axes('osm_hand');
CREATE TABLE bd_was AS SELECT * FROM test.axes('bd_hand');

-- The same edits in both, 400 each.
SELECT setseed(0.4), test.edit_by_hand('osm_hand', 400), setseed(0.4), test.edit_by_hand('osm_source', 400), setseed(0.6), test.edit_by_hand('bd_hand', 400), setseed(0.6), test.edit_by_hand('bd_source', 400) \g /dev/null
CREATE TABLE osm_edited AS SELECT * FROM test.axes('osm_hand');
CREATE TABLE bd_edited AS SELECT * FROM test.axes('bd_hand');
SELECT 'every column was edited: ' || prefix, changed = 41 FROM (SELECT 'osm' AS prefix, count(DISTINCT k) AS changed FROM osm_was w JOIN osm_edited e USING (axis_id), jsonb_object_keys(w.said) k WHERE w.said -> k <> e.said -> k
  UNION ALL SELECT 'bd', count(DISTINCT k) FROM bd_was w JOIN bd_edited e USING (axis_id), jsonb_object_keys(w.said) k WHERE w.said -> k <> e.said -> k) c;

-- The same delivery as before leaves all.
CREATE TABLE told AS SELECT 'osm_hand' AS model, r.* FROM streetgen.import_osm('osm_hand', 'town') r UNION ALL SELECT 'bd_hand', r.* FROM streetgen.import_bdtopo('bd_hand', 'troncon') r;
SELECT 'the same delivery again leaves what is by hand: ' || prefix, amiss = 0 FROM (SELECT 'osm' AS prefix, count(*) AS amiss FROM osm_edited e FULL JOIN test.axes('osm_hand') a USING (axis_id) WHERE e.said IS DISTINCT FROM a.said
  UNION ALL SELECT 'bd', count(*) FROM bd_edited e FULL JOIN test.axes('bd_hand') a USING (axis_id) WHERE e.said IS DISTINCT FROM a.said) c;
SELECT 'and tells of it: ' || model, count = wanted AND source_refs @> '{}' FROM told JOIN (
  SELECT 'osm_hand' AS model, count(*) AS wanted FROM osm_was w LEFT JOIN osm_edited e USING (axis_id) WHERE e.said IS DISTINCT FROM w.said OR e.by_hand
  UNION ALL SELECT 'bd_hand', count(*) FROM bd_was w LEFT JOIN bd_edited e USING (axis_id) WHERE e.said IS DISTINCT FROM w.said OR e.by_hand) w USING (model) WHERE what = 'by hand, kept';
SELECT 'nothing is in conflict, nothing has vanished', count(*) = 0 FROM told WHERE what = 'in conflict' OR what LIKE 'vanished%';

-- A dry run is a delivery that is rolled back.
SELECT pg_temp.deliver() \g /dev/null
TRUNCATE told;
INSERT INTO told SELECT m, r.* FROM unnest('{osm_hand,osm_source,osm_fresh}'::name[]) m, streetgen.import_osm(m, 'town') r UNION ALL SELECT m, r.* FROM unnest('{bd_hand,bd_source,bd_fresh}'::name[]) m, streetgen.import_bdtopo(m, 'troncon') r;
CREATE TABLE osm_will AS SELECT * FROM test.axes('osm_fresh');
CREATE TABLE bd_will AS SELECT * FROM test.axes('bd_fresh');
CREATE TABLE osm_hand_right AS SELECT * FROM test.expected('osm_was', 'osm_edited', 'osm_will', 'hand');
CREATE TABLE osm_source_right AS SELECT * FROM test.expected('osm_was', 'osm_edited', 'osm_will', 'source');
CREATE TABLE bd_hand_right AS SELECT * FROM test.expected('bd_was', 'bd_edited', 'bd_will', 'hand');
CREATE TABLE bd_source_right AS SELECT * FROM test.expected('bd_was', 'bd_edited', 'bd_will', 'source');
SELECT format('%s: each column is as it must be, and nothing is lost untold%s', model, (SELECT ': ' || string_agg(a, '; ') FROM (SELECT a FROM test.amiss(model, (model || '_right')::regclass) a LIMIT 5) s)), NOT EXISTS (SELECT FROM test.amiss(model, (model || '_right')::regclass))
FROM unnest('{osm_hand,osm_source,bd_hand,bd_source}'::name[]) model;
SELECT 'the conflicts are of every kind', array_agg(DISTINCT c) @> '{*,geom,kind,width}' FROM (TABLE osm_hand_right UNION ALL TABLE bd_hand_right) r, unnest(conflicts) c;
SELECT format('%s: the report has them', model), count = wanted AND cardinality(source_refs) = wanted FROM told JOIN (SELECT 'osm_hand' AS model, count(DISTINCT source_ref) AS wanted FROM osm_hand.import_conflict
  UNION ALL SELECT 'bd_source', count(DISTINCT source_ref) FROM bd_source.import_conflict) w USING (model) WHERE what = 'in conflict';
CREATE TABLE stood AS SELECT 'osm' AS prefix, ctid AS place, axis_id FROM osm_hand.axis UNION ALL SELECT 'bd', ctid, axis_id FROM bd_hand.axis;
CREATE TABLE open AS SELECT 'osm' AS prefix, c.* FROM osm_hand.import_conflict c UNION ALL SELECT 'bd', c.* FROM bd_hand.import_conflict c;
SELECT count(*) FROM streetgen.import_osm('osm_hand', 'town'), streetgen.import_bdtopo('bd_hand', 'troncon') \g /dev/null
SELECT 'the same once more touches no row and no conflict', NOT EXISTS (TABLE stood EXCEPT (SELECT 'osm', ctid, axis_id FROM osm_hand.axis UNION ALL SELECT 'bd', ctid, axis_id FROM bd_hand.axis))
  AND NOT EXISTS (TABLE open EXCEPT (SELECT 'osm', c.* FROM osm_hand.import_conflict c UNION ALL SELECT 'bd', c.* FROM bd_hand.import_conflict c));

-- Each of two models, settled the other way, is as the other one was.
SELECT streetgen.settle_conflict('osm_hand', c.axis_id, column_name, 'source') FROM osm_hand.import_conflict c LEFT JOIN osm_hand_right r USING (axis_id) WHERE column_name <> ALL (coalesce(kept, '{}')) \g /dev/null
SELECT streetgen.settle_conflict('bd_hand', c.axis_id, column_name, 'source') FROM bd_hand.import_conflict c LEFT JOIN bd_hand_right r USING (axis_id) WHERE column_name <> ALL (coalesce(kept, '{}')) \g /dev/null
SELECT streetgen.settle_conflict('osm_source', c.axis_id, column_name, 'hand') FROM osm_source.import_conflict c LEFT JOIN osm_source_right r USING (axis_id) WHERE column_name <> ALL (coalesce(kept, '{}')) \g /dev/null
SELECT streetgen.settle_conflict('bd_source', c.axis_id, column_name, 'hand') FROM bd_source.import_conflict c LEFT JOIN bd_source_right r USING (axis_id) WHERE column_name <> ALL (coalesce(kept, '{}')) \g /dev/null
SELECT 'the line of a source is refused to one of several pieces', count(*) > 0 AND bool_and(test.state(format('SELECT streetgen.settle_conflict(''osm_hand'', %s, %L, ''source'')', r.axis_id, k)) = '22023') FROM osm_hand_right r, unnest(kept) k
  -- One that stands alone may have it.
  WHERE EXISTS (SELECT FROM osm_hand_right o WHERE o.said IS NOT NULL AND o.axis_id <> r.axis_id AND split_part(o.ref, '_', 1) = split_part(r.ref, '_', 1));
UPDATE osm_hand_right SET conflicts = kept; UPDATE osm_source_right SET conflicts = kept; UPDATE bd_hand_right SET conflicts = kept; UPDATE bd_source_right SET conflicts = kept;
SELECT format('%s: settled as %s%s', model, other, (SELECT ': ' || string_agg(a, '; ') FROM (SELECT a FROM test.amiss(model, other) a LIMIT 5) s)), NOT EXISTS (SELECT FROM test.amiss(model, other))
FROM (VALUES ('osm_hand'::name, 'osm_source_right'::regclass), ('bd_hand', 'bd_source_right'), ('osm_source', 'osm_hand_right'), ('bd_source', 'bd_hand_right')) m(model, other);

-- Control points and widths of sidewalks go the same way.
CREATE TABLE sign AS SELECT i AS id, 'stop' AS what, 'direct' AS way, ST_StartPoint(test.street(i)) AS geom FROM generate_series(1, 5) i;
\set signs 'SELECT count(*) FROM streetgen.import_control_points(''bd_fresh'', ''sign'', ''{"source_ref": "id", "kind": "what", "direction": "way"}'')'
:signs \g /dev/null
UPDATE bd_fresh.control_point SET kind = 'yield' WHERE source_ref = '1';
UPDATE bd_fresh.control_point SET direction = 'reverse' WHERE source_ref = '2';
DELETE FROM bd_fresh.control_point WHERE source_ref = '3';
UPDATE sign SET way = 'both' WHERE id IN (1, 2);
DELETE FROM sign WHERE id = 4;
:signs \g /dev/null
SELECT 'control points by hand stay', array_agg(concat_ws(' ', source_ref, kind, direction) ORDER BY source_ref) = '{1 yield both,2 stop reverse,5 stop direct}' FROM bd_fresh.control_point;
SELECT 'and what both changed is in conflict', array_agg(concat_ws(' ', relation, source_ref, column_name, by_hand, source_old, source_new)) = '{control_point 2 direction reverse direct both}' FROM bd_fresh.import_conflict;
CREATE TABLE walk AS SELECT 'T' || i AS id, 2.0 AS l FROM generate_series(1, 3) i;
\set walks 'SELECT count(*) FROM streetgen.import_sidewalk_widths(''bd_fresh'', ''walk'', ''{"source_ref": "id", "left": "l"}'')'
:walks \g /dev/null
UPDATE bd_fresh.axis SET sidewalk_left = 5 WHERE source_ref IN ('T1', 'T2');
UPDATE walk SET l = 3 WHERE id IN ('T2', 'T3');
:walks \g /dev/null
SELECT 'widths of sidewalks by hand stay', array_agg(sidewalk_left ORDER BY source_ref) = '{5,5,3}' FROM bd_fresh.axis WHERE source_ref IN ('T1', 'T2', 'T3');
SELECT 'and are in conflict where the table says another', array_agg(concat_ws(' ', source_ref, column_name, by_hand, source_old, source_new)) = '{T2 sidewalk_left 5 2 3}' FROM bd_fresh.import_conflict WHERE relation = 'axis';

UPDATE bd_fresh.axis SET sidewalk_left = NULL WHERE source_ref = 'T3';
:walks \g /dev/null
SELECT 'a width that was emptied by hand stays empty', (SELECT sidewalk_left IS NULL FROM bd_fresh.axis WHERE source_ref = 'T3');

-- Where the source wins: values typed since, keys given to others, columns that a delivery lacks.
SELECT streetgen.create_model('won', 2154, driving_side => 'right'), streetgen.set('won', 'delivery_wins', 'source') \g /dev/null
CREATE TABLE lane AS SELECT i AS id, 50 AS pace, 'lane ' || i AS label, 'yes' AS one_way, test.street(i) AS geom FROM generate_series(1, 4) i;
\set all_columns 'SELECT count(*) FROM streetgen.import_axes(''won'', ''lane'', ''{"source_ref": "id", "speed": "pace", "name": "label", "direction": "one_way"}'')'
\set without_direction 'SELECT count(*) FROM streetgen.import_axes(''won'', ''lane'', ''{"source_ref": "id", "speed": "pace", "name": "label"}'')'
UPDATE lane SET one_way = 'direct';
:all_columns \g /dev/null
UPDATE won.axis SET speed = 20 WHERE source_ref = '1';
DELETE FROM won.axis WHERE source_ref = '2';
INSERT INTO won.axis (axis_id, geom) SELECT row_id, 'SRID=2154;LINESTRING(655000 6865000, 655100 6865000)' FROM won.delivered WHERE source_ref = '2';
UPDATE lane SET pace = 30 WHERE id IN (1, 2);
:all_columns \g /dev/null
SELECT 'the source wins', speed = 30 FROM won.axis WHERE source_ref = '1';
UPDATE won.axis SET speed = 25 WHERE source_ref = '1';
SELECT 'a value typed since is by hand, and stands', (by_hand, source_new, stands) = ('25', '30', 'hand') FROM won.import_conflict WHERE column_name = 'speed';
SELECT streetgen.settle_conflict('won', axis_id, 'speed', 'hand') FROM won.import_conflict WHERE column_name = 'speed' \g /dev/null
SELECT 'and stays where it is settled so', speed = 25 FROM won.axis WHERE source_ref = '1';
SELECT 'a row that comes back leaves its key to whoever has it', count(*) = 2 AND count(*) FILTER (WHERE source_ref = '2' AND speed = 30) = 1 FROM won.axis WHERE source_ref = '2' OR source IS NULL;
SELECT streetgen.settle_conflict('won', axis_id, '*', 'hand') FROM won.import_conflict WHERE column_name = '*' \g /dev/null
SELECT 'and it alone goes again', array_agg(source) = '{NULL}' FROM won.axis WHERE source_ref = '2' OR source IS NULL;
UPDATE lane SET label = 'other' WHERE id = 3;
:without_direction \g /dev/null
UPDATE lane SET one_way = 'both' WHERE id = 3;
:all_columns \g /dev/null
SELECT 'what a delivery did not say is asked again', (name, direction) = ('other', 'both') FROM won.axis WHERE source_ref = '3';

-- Nothing is another word than 0, and a piece that stands alone may have the whole line.
CREATE TABLE verge AS SELECT i AS id, 0 AS nought, 'verge ' || i AS label, test.street(i) AS geom FROM generate_series(1, 7) i;
\set verges 'FROM streetgen.import_axes(''won'', ''verge'', ''{"source_ref": "id", "name": "label", "radius": "nought", "sidewalk_left": "nought", "sidewalk_right": "nought", "roadway_offset": "nought", "lanes_both": "nought"}'')'
SELECT count(*) :verges \g /dev/null
UPDATE won.axis SET radius = NULL WHERE source = 'verge' AND source_ref = '1';
UPDATE won.axis SET sidewalk_left = NULL WHERE source = 'verge' AND source_ref = '2';
UPDATE won.axis SET sidewalk_right = NULL WHERE source = 'verge' AND source_ref = '3';
UPDATE won.axis SET roadway_offset = NULL WHERE source = 'verge' AND source_ref = '4';
UPDATE won.axis SET lanes_both = NULL WHERE source = 'verge' AND source_ref = '5';
UPDATE won.axis SET sidewalk_left = NULL, sidewalk_right = NULL WHERE source = 'verge' AND source_ref = '6';
SELECT 'a 0 that was emptied by hand is told', source_refs = '{1,2,3,4,5,6}' :verges WHERE what = 'by hand, kept';
INSERT INTO won.axis (geom, source, source_ref, source_geom) SELECT ST_LineSubstring(geom, 0.4, 1), source, source_ref || '_1', source_geom FROM won.axis WHERE source = 'verge' AND source_ref = '7';
DELETE FROM won.axis WHERE source = 'verge' AND source_ref = '7';
UPDATE verge SET geom = ST_Translate(geom, 3, 5) WHERE id = 7;
SELECT count(*) :verges \g /dev/null
SELECT 'the line of a piece stays where the source wins', count(*) = 1 AND bool_and(ST_Length(geom) < 80) FROM won.axis WHERE source = 'verge' AND source_ref LIKE '7%';
SELECT streetgen.settle_conflict('won', row_id, 'geom', 'source') FROM won.open_conflict WHERE source = 'verge' AND column_name = 'geom' \g /dev/null
SELECT 'and is the whole where one says so of the last piece', count(*) = 1 AND bool_and(a.geom = v.geom) FROM won.axis a, verge v WHERE v.id = 7 AND a.source = 'verge' AND a.source_ref LIKE '7%';

-- A model of a plain role, its editor and its reader.
CREATE ROLE delivery_owner ROLE CURRENT_USER; CREATE ROLE delivery_editor ROLE CURRENT_USER; CREATE ROLE delivery_reader ROLE CURRENT_USER;
SELECT format('GRANT CREATE ON DATABASE %I TO delivery_owner', current_database()) \gexec
GRANT USAGE, CREATE ON SCHEMA public TO delivery_owner; GRANT USAGE ON SCHEMA test TO delivery_owner, delivery_editor, delivery_reader;
SET ROLE delivery_owner;
SELECT streetgen.create_model('plain', 2154, driving_side => 'right'), streetgen.grant('plain', 'delivery_editor', 'editor'), streetgen.grant('plain', 'delivery_reader', 'reader') \g /dev/null
CREATE TABLE road AS SELECT i AS id, 50 AS pace, test.street(i) AS geom FROM generate_series(1, 4) i;
\set follow 'SELECT count(*) FROM streetgen.import_axes(''plain'', ''public.road'', ''{"source_ref": "id", "speed": "pace"}'')'
:follow \g /dev/null
SET ROLE delivery_editor;
UPDATE plain.axis SET speed = 10, name = 'by hand'; UPDATE plain.axis SET speed = NULL WHERE source_ref = '4';
SET ROLE delivery_owner;
UPDATE road SET pace = 30;
:follow \g /dev/null
SET ROLE delivery_reader;
SELECT 'a reader sees conflicts', array_agg(concat_ws(' ', source_ref, column_name, by_hand, source_old, source_new) ORDER BY source_ref) = '{1 speed 10 50 30,2 speed 10 50 30,3 speed 10 50 30,4 speed 50 30}' FROM plain.import_conflict;
SELECT 'and settles none', test.state($$SELECT streetgen.settle_conflict('plain', 1, 'speed', 'hand')$$) = '42501';
SET ROLE delivery_editor;
SELECT 'an editor settles them', test.state($$SELECT streetgen.settle_conflict('plain', 1, 'speed', 'source')$$) = 'none' AND test.state($$SELECT streetgen.settle_conflict('plain', 2, 'speed', 'hand')$$) = 'none';
UPDATE plain.axis_editing SET speed = 30 WHERE axis_id = 3;
SELECT 'or types the other value', array_agg(axis_id) = '{4}' FROM plain.import_conflict;
UPDATE plain.axis_editing SET speed = 12 WHERE axis_id = 4;
SELECT 'another value keeps the conflict', (by_hand, source_new) = ('12', '30') FROM plain.import_conflict;
SELECT 'what holds is as it was settled', array_agg(speed ORDER BY axis_id) = '{30,10,30,12}' AND bool_and(name = 'by hand') FROM plain.axis;
SELECT 'an editor makes no conflict', test.state($$INSERT INTO plain.open_conflict VALUES ('axis', 1, 'speed', 'road', '1', '1', '2', '3', 'hand')$$) = '42501' AND test.state($$UPDATE plain.open_conflict SET by_hand = '1'$$) = '42501';
SELECT 'none that is not there is settled', test.state($$SELECT streetgen.settle_conflict('plain', 1, 'speed', 'hand')$$) = '22023' AND test.state($$SELECT streetgen.settle_conflict('plain', 4, 'speed', 'both')$$) = '22023'
  AND test.state($$SELECT streetgen.settle_conflict('plain', 4, NULL, 'hand')$$) = '22004' AND test.state($$SELECT streetgen.settle_conflict('nowhere', 4, 'speed', 'hand')$$) = '3F000';
SET ROLE delivery_owner;
UPDATE road SET pace = 50 WHERE id = 4;
:follow \g /dev/null
SELECT 'what the source takes back is no conflict', count(*) = 0 FROM plain.import_conflict;
SELECT 'a mapping that does not mention a column leaves it', (SELECT count(*) >= 0 FROM streetgen.import_axes('plain', 'public.road', '{"source_ref": "id"}')) AND (SELECT array_agg(speed ORDER BY axis_id) = '{30,10,30,12}' FROM plain.axis);
DELETE FROM road WHERE id = 4;
:follow \g /dev/null
INSERT INTO road SELECT 4, 70, test.street(4);
:follow \g /dev/null
SELECT 'a row that the source deleted and has again is merged', array_agg(column_name) = '{speed}' AND (SELECT speed = 12 FROM plain.axis WHERE source_ref = '4') FROM plain.import_conflict;
TRUNCATE plain.axis;
:follow \g /dev/null
SELECT 'TRUNCATE forgets what was delivered', count(*) = 4 AND bool_and(speed IN (30, 70)) AND NOT EXISTS (SELECT FROM plain.import_conflict) FROM plain.axis;
SELECT streetgen.drop_model('plain') \g /dev/null
RESET ROLE;
DROP TABLE road; DROP OWNED BY delivery_owner, delivery_editor, delivery_reader; DROP ROLE delivery_owner, delivery_editor, delivery_reader;
