\set ECHO none
\ir shared/truths.sql
-- BD TOPO roads of version 2 and 3 to axes.  Each SELECT is one truth: (name, holds).
DO $$ BEGIN
  PERFORM streetgen.create_model('import_v2', 32631);
  PERFORM streetgen.create_model('import_v3', 32631, 3);
END $$;
CREATE TABLE import_bdtopo2 (id text, nature text, nom_rue_g text, importance text, fictif text, largeur float8, nb_voies smallint, pos_sol smallint, sens text, geom geometry(MultiLineStringZM, 32631));
INSERT INTO import_bdtopo2 VALUES
  ('A', 'Route à 1 chaussée', 'R DE LA GARE', '4', 'Non', 6, 2, 0, 'Double', 'SRID=32631;MULTILINESTRING ZM((0 0 -2e38 0, 100 0 5 0))'),
  ('B', 'Bretelle', 'NR', '3', 'Non', 0, 1, 1, 'Inverse', 'SRID=32631;MULTILINESTRING ZM((0 100 5 0, 100 100 5 0))'),
  ('C', 'Autoroute', NULL, 'NC', 'Non', 20, 2, -1, 'Direct', 'SRID=32631;MULTILINESTRING ZM((0 200 5 0, 100 200 5 0))'),
  ('D', 'Route à 1 chaussée', NULL, '5', 'Oui', 4, 1, 0, 'Double', 'SRID=32631;MULTILINESTRING ZM((0 300 5 0, 100 300 5 0))'),
  ('E', 'Sentier', NULL, '5', 'Non', 2, 1, 0, 'Double', 'SRID=32631;MULTILINESTRING ZM((0 400 5 0, 100 400 5 0))');
CREATE TABLE import_report AS SELECT * FROM streetgen.import_bdtopo('import_v2', 'import_bdtopo2');
SELECT 'version 2: taken are roads that are not fictitious' AS name, (SELECT string_agg(source_ref, ',' ORDER BY source_ref) = 'A,B,C' FROM import_v2.axis) AS holds;
SELECT 'version 2: directions', (SELECT string_agg(direction, ',' ORDER BY source_ref) = 'both,reverse,direct' FROM import_v2.axis);
SELECT 'version 2: levels', (SELECT string_agg(level::text, ',' ORDER BY source_ref) = '0,1,-1' FROM import_v2.axis);
SELECT 'version 2: importance, where it is a number', (SELECT array_agg(importance ORDER BY source_ref) = '{4,3,NULL}' FROM import_v2.axis);
SELECT 'version 2: width, lanes and name', (SELECT width = 6 AND lane_count = 2 AND name = 'R DE LA GARE' FROM import_v2.axis WHERE source_ref = 'A');
SELECT 'version 2: a name that is not known is none', (SELECT name IS NULL FROM import_v2.axis WHERE source_ref = 'B');
SELECT 'version 2: a width of zero and one beyond the lanes are named',
       (SELECT source_refs = '{B}' FROM import_report WHERE what LIKE 'width of zero%') AND (SELECT source_refs = '{C}' FROM import_report WHERE what = 'width not believed');

CREATE TABLE import_bdtopo3 (cleabs text, nature text, nom_voie_ban_gauche text, importance text, fictif boolean, largeur_de_chaussee numeric(5,1), nombre_de_voies integer,
  position_par_rapport_au_sol text, sens_de_circulation text, vitesse_moyenne_vl integer, geometrie geometry(LineStringZ, 32631));
INSERT INTO import_bdtopo3 VALUES
  ('A', 'Route à 1 chaussée', 'Rue Haute', '4', false, 5.5, 2, '0', 'Double sens', 30, 'SRID=32631;LINESTRING Z(0 0 10, 50 20 -1000, 100 0 20)'),
  ('B', 'Rond-point', NULL, '5', false, NULL, NULL, '-1', 'Sens direct', 0, 'SRID=32631;LINESTRING Z(0 100 -1000, 100 100 -1000)'),
  ('C', 'Bretelle', NULL, '3', false, 4, 1, 'Gué ou radier', 'Sens inverse', 70, 'SRID=32631;LINESTRING Z(0 200 5, 100 200 NaN)'),
  ('D', 'Bretelle', NULL, '3', true, 4, 1, '0', 'Sens inverse', 70, 'SRID=32631;LINESTRING Z(0 300 5, 100 300 5)');
ALTER TABLE import_bdtopo3 ADD cpx_numero text;
UPDATE import_bdtopo3 SET cpx_numero = CASE cleabs WHEN 'A' THEN 'D2' WHEN 'B' THEN 'NC' END;
DROP TABLE import_report;
CREATE TABLE import_report AS SELECT * FROM streetgen.import_bdtopo('import_v3', 'import_bdtopo3');
SELECT 'version 3: the number of a route', (SELECT array_agg(ref ORDER BY source_ref) = '{D2,NULL,NULL}' FROM import_v3.axis);
SELECT 'version 3: the nature of a roundabout is its tag, and the direction stays', (SELECT (direction, roundabout_tag) = ('direct', 'Rond-point') FROM import_v3.axis WHERE source_ref = 'B');
SELECT 'version 3: taken are roads that are not fictitious', (SELECT string_agg(source_ref, ',' ORDER BY source_ref) = 'A,B,C' FROM import_v3.axis);
SELECT 'version 3: directions', (SELECT string_agg(direction, ',' ORDER BY source_ref) = 'both,direct,reverse' FROM import_v3.axis);
SELECT 'version 3: levels', (SELECT string_agg(level::text, ',' ORDER BY source_ref) = '0,-1,0' FROM import_v3.axis);
SELECT 'version 3: a speed of zero is unknown', (SELECT array_agg(speed ORDER BY source_ref) = '{30,NULL,70}' FROM import_v3.axis);
SELECT 'version 3: heights without data come from the same line, or are 0',
       (SELECT array_agg(ST_Z(ST_EndPoint(geom)) ORDER BY source_ref) = '{20,0,5}' FROM import_v3.axis)
   AND (SELECT ST_Z(ST_PointN(source_geom, 2)) = 15 FROM import_v3.axis WHERE source_ref = 'A');
SELECT 'version 3: lines with such heights are named', (SELECT source_refs = '{A,B,C}' FROM import_report WHERE what LIKE 'height without data%');
ALTER TABLE import_bdtopo3 ADD reserve_aux_bus text, ADD bande_cyclable text;
UPDATE import_bdtopo3 SET reserve_aux_bus = CASE cleabs WHEN 'B' THEN 'Sens inverse' END, nombre_de_voies = 3, bande_cyclable = CASE cleabs WHEN 'A' THEN 'Deux sens' WHEN 'C' THEN 'Sens inverse' END;
DO $$ BEGIN PERFORM streetgen.import_bdtopo('import_v3', 'import_bdtopo3'); END $$;
SELECT 'version 3: bus and cycle lanes', (SELECT array_agg(concat_ws(' ', kind_forward, '/', kind_backward, lanes_both) ORDER BY source_ref) = '{general|cycle / general|cycle 1,/ bus,/ general|general|general|cycle}' FROM import_v3.axis);
SELECT 'version 3: a bus lane against the traffic is one of the lanes', (SELECT (u.lanes_forward, u.lanes_backward) = (2, 1) FROM import_v3.axis_used u JOIN import_v3.axis a USING (axis_id) WHERE source_ref = 'B');
UPDATE import_bdtopo3 SET nombre_de_voies = 1, reserve_aux_bus = NULL WHERE cleabs = 'A';
DO $$ BEGIN PERFORM streetgen.import_bdtopo('import_v3', 'import_bdtopo3'); END $$;
SELECT 'version 3: one lane is of both directions, between cycle lanes', (SELECT (a.kind_forward, a.kind_backward) = ('cycle', 'cycle') AND (u.lane_count, u.lanes_both, u.width) = (1, 1, 5.5) FROM import_v3.axis_used u JOIN import_v3.axis a USING (axis_id) WHERE source_ref = 'A');
UPDATE import_bdtopo3 SET sens_de_circulation = CASE cleabs WHEN 'A' THEN 'Sans objet' WHEN 'B' THEN 'Quelconque' WHEN 'C' THEN '' END;
SELECT 'version 3: a direction that is none is named, one that is not known is not', (SELECT source_refs = '{B}' FROM streetgen.import_bdtopo('import_v3', 'import_bdtopo3') WHERE what LIKE 'direction not understood%');
SELECT 'version 3: both count as both', (SELECT bool_and(direction = 'both') FROM import_v3.axis);
SELECT 'a table that is no BD TOPO is 22023, and its columns and the way out are told', r.state = '22023' AND r.detail LIKE 'It has what, class, %' AND r.hint LIKE '%--mapping%' FROM test.refusal($$SELECT streetgen.import_bdtopo('import_v3', 'import_report')$$) r;
DROP TABLE import_bdtopo2, import_bdtopo3, import_report;
DO $$ BEGIN
  PERFORM streetgen.drop_model('import_v2');
  PERFORM streetgen.drop_model('import_v3');
END $$;
-- The names of version 3 as a shapefile has them.
CREATE TABLE import_shape (id text, nature text, nom_coll_g text, largeur float8, nb_voies integer, pos_sol text, sens text, vit_moy_vl integer, cyclable text, bus text, fictif text, geom geometry(MultiLineString, 32631));
INSERT INTO import_shape VALUES ('E', 'Route à 1 chaussée', 'R DE LA PAIX', 9, 3, '1', 'Sens direct', 30, 'Sens direct', 'Sens inverse', 'Non', 'SRID=32631;MULTILINESTRING((0 0, 100 0))'),
  ('F', 'Route à 1 chaussée', 'R HAUTE', 5, 2, '0', 'Double sens', 20, NULL, NULL, 'Non', 'SRID=32631;MULTILINESTRING((0 50, 100 50))');
SELECT streetgen.create_model('import_shp', 32631) \g /dev/null
DO $$ BEGIN PERFORM streetgen.import_bdtopo('import_shp', 'import_shape'); END $$;
SELECT 'version 3, shapefile: name, speed, level, bus and cycle lanes', array_agg((name, speed, level, kind_forward, kind_backward)::text ORDER BY source_ref) = ARRAY['("R DE LA PAIX",30,1,general|general|cycle,bus)', '("R HAUTE",20,0,,)'] FROM import_shp.axis;
DROP TABLE import_shape;
-- The columns of 2024.
CREATE TABLE import_2024 (cleabs text, nature text, largeur_de_chaussee float8, nombre_de_voies integer, sens_de_circulation text, position_par_rapport_au_sol text, fictif boolean, reserve_aux_bus text,
  amenagement_cyclable_droit text, sens_amenagement_cyclable_droit text, amenagement_cyclable_gauche text, sens_amenagement_cyclable_gauche text, geometrie geometry(LineString, 32631));
INSERT INTO import_2024 SELECT r[1], 'Route à 1 chaussée', NULL, r[2]::integer, r[3], '0', false, r[4], r[5], r[6], r[7], r[8], ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * n), ST_MakePoint(100, 50 * n)), 32631)
FROM (VALUES (1, ARRAY['A', '1', 'Sens direct', 'Voie bus', NULL, NULL, NULL, NULL]), (2, ARRAY['B', '2', 'Double sens', NULL, 'Bande cyclable', 'Sens direct', 'Bande cyclable', 'Sens inverse']),
  (3, ARRAY['C', '2', 'Sens direct', 'Voie bus', 'Bande cyclable', NULL, NULL, NULL]), (4, ARRAY['D', '1', 'Sens direct', NULL, NULL, NULL, 'Bande cyclable', 'Sens inverse']),
  (5, ARRAY['E', '2', 'Double sens', NULL, 'Piste cyclable', 'Sens direct', 'Bande cyclable', NULL]), (6, ARRAY['F', '2', 'Sens inverse', 'Sens direct', NULL, NULL, NULL, NULL])) v(n, r);
SELECT streetgen.create_model('import_new', 32631) \gset
SELECT streetgen.import_bdtopo('import_new', 'import_2024') \g /dev/null
SELECT 'version of 2024: ' || source_ref, concat(kind_forward, ' / ', kind_backward) = wanted FROM import_new.axis JOIN (VALUES ('A', 'bus / '), ('B', 'general|cycle / general|cycle'), ('C', 'general|bus|cycle / '), ('D', ' / cycle'),
  ('E', ' / general|cycle'), ('F', 'bus / ')) v(source_ref, wanted) USING (source_ref) ORDER BY source_ref;
-- Bus lanes are among the lanes that are counted, where those of a direction have room for no other.
CREATE TABLE import_bus (cleabs text, nature text, largeur_de_chaussee float8, nombre_de_voies integer, sens_de_circulation text, reserve_aux_bus text, acces_vehicule_leger text, geometrie geometry(LineString, 32631));
INSERT INTO import_bus SELECT ref, 'Route à 1 chaussée', width, lanes, sens, bus, access, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * n), ST_MakePoint(100, 50 * n)), 32631)
FROM (VALUES (1, 'A', 7, 2, 'Double sens', 'Double sens', 'Physiquement impossible'), (2, 'B', 7, 2, 'Double sens', 'Double sens', 'Libre'), (3, 'C', 14, 2, 'Double sens', 'Double sens', 'Libre'),
  (4, 'D', 3.5, 1, 'Sens direct', 'Sens direct', 'Restreint aux ayants droit'), (5, 'E', 7, 2, 'Double sens', 'Sens direct', 'Libre'), (6, 'F', 14, 4, 'Double sens', 'Double sens', 'Libre')) v(n, ref, width, lanes, sens, bus, access);
SELECT streetgen.create_model('import_buses', 32631) \gset
SELECT streetgen.import_bdtopo('import_buses', 'import_bus') \g /dev/null
SELECT 'bus lanes and the room for others: ' || source_ref, concat(kind_forward, ' / ', kind_backward) = wanted FROM import_buses.axis JOIN (VALUES ('A', 'bus / bus'), ('B', 'bus / bus'), ('C', 'general|bus / general|bus'), ('D', 'bus / '), ('E', 'bus / '),
  ('F', 'general|bus / general|bus')) v(source_ref, wanted) USING (source_ref) ORDER BY source_ref;
SELECT streetgen.set('import_buses', 'lane_width', '4.8') \g /dev/null
SELECT streetgen.import_bdtopo('import_buses', 'import_bus') \g /dev/null
SELECT 'a bus lane has room where each lane has three quarters of lane_width', concat(kind_forward, ' / ', kind_backward) = wanted FROM import_buses.axis
  JOIN (VALUES ('C', 'bus / bus'), ('F', 'general|bus / general|bus')) v(source_ref, wanted) USING (source_ref) ORDER BY source_ref;
-- Each column that is read, with a word that means nothing, and with words of the data.
CREATE TABLE import_word (cleabs text, nature text DEFAULT 'Route à 1 chaussée', largeur text DEFAULT '7', nb_voies text DEFAULT '2', sens text DEFAULT 'Double sens', vit_moy_vl text DEFAULT '30', importance text DEFAULT '4', pos_sol text DEFAULT '0', fictif text DEFAULT 'Non',
  bus text, cyclable text, amgt_cy_d text DEFAULT 'Bande cyclable', sens_cy_d text DEFAULT 'Sens direct', amgt_cy_g text DEFAULT 'Piste cyclable', sens_cy_g text DEFAULT 'Sens inverse', acces_vl text DEFAULT 'Libre', restr_h text, geom geometry(LineString, 32631));
CREATE FUNCTION pg_temp.say(column_name text, word text) RETURNS void LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format('INSERT INTO import_word (cleabs, %I, geom) SELECT %L, %L, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * n), ST_MakePoint(100, 50 * n)), 32631) FROM (SELECT count(*) AS n FROM import_word) w', column_name, column_name || ' ' || word, word);
END $$;
SELECT pg_temp.say(columns[cardinality(columns)], word) FROM streetgen._bdtopo_column(), unnest('{Chevaux,Pont,de jour}'::text[]) word WHERE name NOT IN ('id', 'name', 'ref') \g /dev/null
SELECT pg_temp.say(column_name, word) FROM (VALUES ('pos_sol', 'Gué ou radier'), ('pos_sol', 'NC'), ('pos_sol', '-1'), ('importance', 'NC'), ('fictif', 'f'), ('acces_vl', 'A péage'), ('acces_vl', 'Physiquement impossible'), ('acces_vl', 'NC'), ('restr_h', '3.5'), ('sens', 'Sans objet'), ('bus', 'Sans objet'), ('cyclable', 'Double sens'), ('cyclable', 'Non'),
  ('amgt_cy_d', 'Bande cyclable'), ('amgt_cy_g', 'Voie verte'), ('sens_cy_d', 'Sens direct')) v(column_name, word) \g /dev/null
CREATE TABLE import_told AS SELECT * FROM streetgen.import_bdtopo('import_buses', 'import_word');
CREATE VIEW import_named AS SELECT unnest(source_refs) AS ref FROM import_told WHERE what ~ 'not understood, taken as unknown|unknown class' UNION SELECT source_ref FROM import_buses.unread_tag;
SELECT 'a word that means nothing is told: ' || cleabs, EXISTS (SELECT FROM import_named WHERE ref = cleabs) FROM import_word WHERE cleabs ~ 'Chevaux|Pont|de jour' ORDER BY 2, 1;
SELECT 'what data say is not', NOT EXISTS (SELECT FROM import_named WHERE ref !~ 'Chevaux|Pont|de jour');
SELECT 'a restriction of height is a limit', string_agg(source_ref || ': ' || height_limit, ', ') = 'restr_h 3.5: 3.5' FROM import_buses.axis;
SELECT 'a word that means nothing makes no lane', bool_and(coalesce(kind_forward, '') !~ 'bus' AND coalesce(kind_forward, '') ~ CASE WHEN source_ref LIKE 'amgt_cy_d%' THEN '^$' ELSE '^general.cycle$' END) FROM import_buses.axis WHERE source = 'import_word' AND source_ref ~ 'Chevaux' AND source_ref !~ '^(sens|nb_voies)';
DROP TABLE import_told CASCADE;
-- Kerbs of the drawing, traffic along it and against it, and what is no lane of the roadway.
CREATE TABLE import_kerb (LIKE import_2024);
INSERT INTO import_kerb SELECT r[1], 'Route à 1 chaussée', NULL, r[2]::integer, r[3], '0', false, r[4], r[5], r[6], r[7], r[8], ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 50 * n), ST_MakePoint(100, 50 * n)), 32631)
FROM unnest(ARRAY['A 1 Sens direct,,,,Bande cyclable,Sens direct', 'B 1 Sens inverse,,Bande cyclable,Sens inverse,,', 'C 1 Sens inverse,,,,Bande cyclable,Sens inverse', 'D 1 Sens inverse,,Bande cyclable,Sens direct,,',
  'E 1 Sens direct,,Bande cyclable,Sens inverse,,', 'F 1 Sens inverse,,,,Bande cyclable,Sens direct', 'G 1 Sens direct,,,,Bande cyclable,Double sens', 'H 1 Sens direct,,Bande cyclable,Double sens,,', 'I 2 Double sens,,Bande cyclable,Double sens,,',
  'J 2 Double sens,,Bande cyclable,,,', 'K 2 Double sens,,,,Bande cyclable,', 'L 1 Sens direct,Voie bus,,,Bande cyclable,Sens direct', 'M 2 Double sens,,Piste cyclable,Sens direct,Voie verte,', 'N 2 Double sens,,Aménagement mixte hors voie verte,,Goulotte ou rampe,',
  'O 2 Double sens,,Chaussée à voie centrale banalisée,,Couloir bus + vélo,', 'P 1 Sens direct,,,,Double sens cyclable bande,', 'Q 1 Sens direct,,Double sens cyclable non matérialisé,,Bande cyclable,de jour', 'R 2 Double sens,Tramway,,,,', 'S 1 Sens inverse,,Bande cyclable,,,']) WITH ORDINALITY t(line, n),
  LATERAL (SELECT ARRAY[left(line, 1), substr(line, 3, 1)] || string_to_array(substr(line, 5), ',', '') AS r) f;
CREATE FUNCTION pg_temp.kerbs(driving_side text) RETURNS TABLE (source_ref text, kinds text, named text) LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.drop_model(m.name) FROM streetgen.model m WHERE m.name = 'import_kerbs';
  PERFORM streetgen.create_model('import_kerbs', 32631, driving_side => kerbs.driving_side);
  PERFORM streetgen.import_bdtopo('import_kerbs', 'import_kerb');
  RETURN QUERY SELECT a.source_ref, concat(kind_forward, ' / ', kind_backward), (SELECT string_agg(u.tag || ': ' || u.value || ', ' || u.reason, '; ') FROM import_kerbs.unread_tag u WHERE u.source_ref = a.source_ref) FROM import_kerbs.axis a;
END $$;
CREATE TABLE import_told AS SELECT * FROM pg_temp.kerbs('right');
SELECT 'a kerb of the drawing: ' || source_ref, (kinds, named) IS NOT DISTINCT FROM (wanted, reason) FROM import_told FULL JOIN (VALUES ('A', 'cycle|general / ', NULL), ('B', ' / cycle|general', NULL), ('C', ' / general|cycle', NULL), ('D', 'cycle / ', NULL),
  ('E', ' / ', 'amenagement_cyclable_droit: Bande cyclable, a cycle lane at this kerb runs in the direction of the lanes beside it'), ('F', ' / ', 'amenagement_cyclable_gauche: Bande cyclable, a cycle lane at this kerb runs in the direction of the lanes beside it'),
  ('G', 'cycle|general / cycle', NULL), ('H', 'general|cycle / ', 'amenagement_cyclable_droit: Bande cyclable, a cycle lane at this kerb runs in the direction of the lanes beside it'),
  ('I', 'general|cycle / ', 'amenagement_cyclable_droit: Bande cyclable, a cycle lane at this kerb runs in the direction of the lanes beside it'), ('J', 'general|cycle / ', NULL), ('K', ' / general|cycle', NULL), ('L', 'cycle|bus / ', NULL), ('M', ' / ', NULL), ('N', ' / ', NULL),
  ('O', ' / ', 'amenagement_cyclable_droit: Chaussée à voie centrale banalisée, it says no lane of the roadway; amenagement_cyclable_gauche: Couloir bus + vélo, it says no lane of the roadway'), ('P', ' / cycle', NULL),
  ('Q', 'cycle|general / ', 'sens_amenagement_cyclable_gauche: de jour, it says no direction'), ('R', ' / ', 'reserve_aux_bus: Tramway, it says no lane of buses'), ('S', ' / cycle|general', NULL)) v(source_ref, wanted, reason) USING (source_ref) ORDER BY source_ref;
SELECT 'the report names them', (SELECT count(*) FROM streetgen.import_bdtopo('import_kerbs', 'import_kerb') WHERE what LIKE 'lanes not understood%') = 4;
-- On the left the same place, drawn from its other end, has the mirror image of it.
UPDATE import_kerb SET geometrie = ST_Reverse(geometrie), sens_de_circulation = CASE sens_de_circulation WHEN 'Sens direct' THEN 'Sens inverse' WHEN 'Sens inverse' THEN 'Sens direct' ELSE sens_de_circulation END,
  sens_amenagement_cyclable_droit = CASE sens_amenagement_cyclable_droit WHEN 'Sens direct' THEN 'Sens inverse' WHEN 'Sens inverse' THEN 'Sens direct' ELSE sens_amenagement_cyclable_droit END,
  sens_amenagement_cyclable_gauche = CASE sens_amenagement_cyclable_gauche WHEN 'Sens direct' THEN 'Sens inverse' WHEN 'Sens inverse' THEN 'Sens direct' ELSE sens_amenagement_cyclable_gauche END;
CREATE FUNCTION pg_temp.mirrored(kinds text) RETURNS text LANGUAGE sql AS $$
  SELECT concat(array_to_string(ARRAY(SELECT k FROM unnest(string_to_array(split_part(kinds, ' / ', 2), '|')) WITH ORDINALITY u(k, i) ORDER BY i DESC), '|'), ' / ',
    array_to_string(ARRAY(SELECT k FROM unnest(string_to_array(split_part(kinds, ' / ', 1), '|')) WITH ORDINALITY u(k, i) ORDER BY i DESC), '|')) $$;
SELECT 'where one drives on the left, drawn backward: ' || source_ref, l.kinds = pg_temp.mirrored(r.kinds) FROM pg_temp.kerbs('left') l JOIN import_told r USING (source_ref) ORDER BY source_ref;
-- A shapefile of other hands has ten letters of each name; two columns may have the same ones.
CREATE TABLE import_ten AS SELECT cleabs AS "CLEABS", nature, 6.5::float8 AS largeur_de, 1 AS nombre_de_, 'Sens direct' AS sens_de_ci, 'Bande cyclable' AS amenagemen, geometrie AS geom FROM import_kerb WHERE cleabs = 'A';
CREATE TABLE import_ten_told AS SELECT * FROM streetgen.import_bdtopo('import_kerbs', 'import_ten');
SELECT 'shortened names are read', (width, lane_count, direction, source_ref) = (6.5, 1, 'direct', 'A') FROM import_kerbs.axis WHERE source = 'import_ten';
SELECT 'one that two columns have is told', array_agg(class) = '{amenagemen}' FROM import_ten_told WHERE what LIKE 'column with a shortened name%';
ALTER TABLE import_ten ADD largeur_de_chaussee float8 DEFAULT 6;
SELECT 'one of a column that is there too is not', array_agg(class) = '{amenagemen}' FROM streetgen.import_bdtopo('import_kerbs', 'import_ten') WHERE what LIKE 'column with a shortened name%';
-- A direction of a cycle lane that no kerb has.
UPDATE import_kerb SET amenagement_cyclable_droit = NULL, amenagement_cyclable_gauche = 'Sans objet', sens_amenagement_cyclable_droit = 'Sens direct', sens_amenagement_cyclable_gauche = 'Sans objet', reserve_aux_bus = NULL;
SELECT 'a direction without its lane is named', count(*) > 5 AND bool_and(kinds = ' / ' AND named = 'sens_amenagement_cyclable_droit: Sens direct, no cycle lane is said at this kerb') FROM pg_temp.kerbs('right');
DROP TABLE import_kerb, import_told, import_ten, import_ten_told;
SELECT streetgen.drop_model('import_kerbs') \g /dev/null
