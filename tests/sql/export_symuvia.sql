\set ECHO none
\ir shared/truths.sql
-- Files of SymuVia: a troncon for each lane group, a movement for each pair of lanes that connects.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('left_town', 2154, driving_side => 'left');
  INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward, importance, name) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650050 6860005,650100 6860000)', 14, 'both', 'general|bus', 2, 'a < b'),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 14, 'both', NULL, 2, NULL),
    (3, 'SRID=2154;LINESTRING(650100 6860100,650100 6860000)', 9, 'direct', 'general|cycle|parking', 6, NULL),
    (4, 'SRID=2154;LINESTRING(650200 6860000,650300 6860050)', 7, 'both', NULL, 2, NULL);
  INSERT INTO left_town.axis SELECT * FROM town.axis;
END $$;
CREATE FUNCTION pg_temp.file(model name, options jsonb DEFAULT '{}') RETURNS xml LANGUAGE sql AS $$
  SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_symuvia(model, options) $$;
CREATE FUNCTION pg_temp.found(path text, file xml) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, file)) $$;
CREATE FUNCTION pg_temp.texts(path text, file xml) RETURNS text[] LANGUAGE sql AS $$ SELECT array_agg(x::text ORDER BY x::text COLLATE "C") FROM unnest(xpath(path, file)) x $$;
SELECT 'there is a troncon for each lane group', pg_temp.found('//TRONCON', pg_temp.file('town')) = (SELECT count(*) FROM town.lane_group);
SELECT 'with as many lanes', (SELECT sum(n::integer) FROM unnest(pg_temp.texts('//TRONCON/@nb_voie', pg_temp.file('town'))) n) = (SELECT count(*) FROM town.lane_driving);
SELECT 'there is a movement for each pair that connects', pg_temp.found('//MOUVEMENT_SORTIE', pg_temp.file('town')) = (SELECT count(*) FROM town.interconnection WHERE connecting);
SELECT 'troncons end at what is there', (SELECT bool_and(pg_temp.found('//CONNEXIONS/*/*[@id="' || e || '"]', f) = 1) FROM pg_temp.file('town') f, unnest(pg_temp.texts('//TRONCON/@id_eltamont | //TRONCON/@id_eltaval', f)) e);
SELECT 'two edges meet at a repartiteur, three at a carrefour', pg_temp.texts('//REPARTITEUR/@id', pg_temp.file('town')) = ARRAY(SELECT 'R_' || node_id FROM town.node WHERE ST_DWithin(geom, 'SRID=2154;POINT(650200 6860000)', 1))
  AND pg_temp.texts('//CARREFOURAFEUX/@id', pg_temp.file('town')) = ARRAY(SELECT 'C_' || node_id FROM town.node WHERE ST_DWithin(geom, 'SRID=2154;POINT(650100 6860000)', 1));
SELECT 'traffic comes in and leaves at extremites', pg_temp.texts('//EXTREMITE/@id', pg_temp.file('town')) = '{E_-4,E_1,E_3,S_-1,S_4}';
SELECT 'lines that yield say so', pg_temp.texts('//ENTREE_CAF[@priorite != "defaut"]/@id_troncon_amont', pg_temp.file('town')) = (SELECT array_agg('3'::text) FROM town.marking WHERE kind IN ('yield', 'stop'));
SELECT 'lanes of buses and bicycles are reserved', pg_temp.texts('//VOIE_RESERVEE/@id_typesvehicules', pg_temp.file('town')) = '{BUS,VELO}';
SELECT 'nobody drives on a parking lane', pg_temp.texts('//TRONCON[@id="3"]//VOIE_INTERDITE/@num_voie', pg_temp.file('town')) = '{1}';
SELECT 'lane 1 is at the right also where one drives on the left', pg_temp.texts('//TRONCON[@id="1"]//VOIE_RESERVEE/@num_voie', pg_temp.file('town')) = '{1}' AND pg_temp.texts('//TRONCON[@id="1"]//VOIE_RESERVEE/@num_voie', pg_temp.file('left_town')) = '{1}';
-- From the whole metres at the lower left of what is written.
SELECT 'ends are the means of those of the lanes', (SELECT bool_and(abs(split_part(t, ' ', 1)::float8 + floor(x) - ST_X(ends)) <= 0.005 AND abs(split_part(t, ' ', 2)::float8 + floor(y) - ST_Y(ends)) <= 0.005)
  FROM (SELECT streetgen._lane_group_text(edge_id, along_axis, number) AS name, ST_StartPoint(geom) AS ends FROM town.lane_group) g, pg_temp.file('town') f,
    LATERAL (SELECT (xpath('string(//TRONCON[@id="' || name || '"]/@extremite_amont)', f))[1]::text AS t) u, (SELECT min(ST_XMin(geom)) AS x, min(ST_YMin(geom)) AS y FROM town.edge) o);
SELECT 'opposed troncons name each other', pg_temp.texts('//TRONCON[@id="1"]/@id_troncon_oppose', pg_temp.file('town')) = '{-1}' AND pg_temp.found('//TRONCON[@id="3"]/@id_troncon_oppose', pg_temp.file('town')) = 0;
SELECT 'a bend has internal points, as far as the tolerance asks', pg_temp.found('//TRONCON[@id="1"]//POINT_INTERNE', pg_temp.file('town')) > 0 AND pg_temp.found('//TRONCON[@id="1"]//POINT_INTERNE', pg_temp.file('town', '{"tolerance": 10}')) = 0;
SELECT 'a part of the town ends where its edges end', pg_temp.texts('//EXTREMITE/@id', pg_temp.file('town', '{"extent": [650240, 6860000, 650300, 6860050]}')) = '{E_-4,E_4,S_-4,S_4}';
SELECT 'the same bytes again', (SELECT md5(string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_symuvia('town')) = (SELECT md5(string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_symuvia('town'));
-- Buses may do what others are forbidden.
BEGIN;
INSERT INTO town.turn_restriction (from_axis, to_axis, geom, kind, except_kinds) VALUES (3, 2, 'SRID=2154;POINT(650100 6860000)', 'no', 'bus');
SELECT 'a movement of buses bars all others', pg_temp.texts('//MOUVEMENT_AUTORISE[@id_troncon_amont="3"]//MOUVEMENT_SORTIE[@id_troncon_aval="2"]/@exclusion_types_vehicules', pg_temp.file('town')) = '{"VL COVOITURAGE VELO"}';
SELECT 'and no other movement bars anybody', pg_temp.found('//MOUVEMENT_SORTIE[@exclusion_types_vehicules]', pg_temp.file('town')) = 1;
ROLLBACK;
SELECT 'an unknown option is refused', test.state($$SELECT FROM streetgen.export_symuvia('town', '{"colour": 1}')$$) = '22023';
-- Rings and signals.
CREATE FUNCTION pg_temp.round(driven text) RETURNS void LANGUAGE sql AS $$
  SELECT FROM streetgen.create_model(driven, 2154, subjects => '{interconnection,roundabout,signal}', driving_side => driven) $$;
DO $$
DECLARE side text;
BEGIN
  FOREACH side IN ARRAY '{right,left}'::text[] LOOP
    PERFORM pg_temp.round(side);
    EXECUTE format($i$INSERT INTO %I.axis (axis_id, geom, width, lane_count, importance)
      SELECT 1, ST_SetSRID(ST_Reverse(ST_ExteriorRing(ST_ForceRHR(ST_Buffer(ST_MakePoint(650000, 6860000), 18, 6)))), 2154), 7, 2, 3
      UNION ALL SELECT 2 + a, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 18 * cos(radians(90 * a)), 6860000 + 18 * sin(radians(90 * a))),
        ST_MakePoint(650000 + 118 * cos(radians(90 * a)), 6860000 + 118 * sin(radians(90 * a)))), 2154), 6, 2, 4 FROM generate_series(0, 3) a
      UNION ALL SELECT 7 + a, ST_SetSRID(ST_MakeLine(ST_MakePoint(650118, 6860000), ST_MakePoint(650118 + 80 * cos(radians(90 * a)), 6860000 + 80 * sin(radians(90 * a)))), 2154), 6, 2, 4
        FROM generate_series(-1, 1) a$i$, side);
    EXECUTE format('INSERT INTO %I.control_point (geom, kind) VALUES (%L, %L)', side, 'SRID=2154;POINT(650118 6860000)', 'signals');
    PERFORM streetgen.generate(side);
  END LOOP;
END $$;
CREATE TEMPORARY VIEW made AS SELECT side, pg_temp.file(side) AS file FROM unnest('{right,left}'::name[]) side;
SELECT side || ': the ring is one giratoire, without carrefours at its nodes', pg_temp.found('//GIRATOIRE', file) = 1 AND pg_temp.found('//CARREFOURAFEUX', file) = 1 AND pg_temp.found('//REPARTITEUR', file) = 0 FROM made ORDER BY side;
SELECT side || ': troncons are the lane groups, those of the ring within it', pg_temp.found('//TRONCON_INTERNE', file) = 4
    AND pg_temp.found('//TRONCON_INTERNE', file) + pg_temp.found('//TRONCON', file) = CASE side WHEN 'right' THEN (SELECT count(*) FROM "right".lane_group) ELSE (SELECT count(*) FROM "left".lane_group) END FROM made ORDER BY side;
-- Axis 2 is east of the ring, 3 north, 4 west, 5 south; what leaves stands before what enters.
SELECT side || ': its troncons stand as traffic meets them', position(CASE side WHEN 'right' THEN (SELECT string_agg(edge_id || ' -' || edge_id, ' ' ORDER BY axis_id) FROM "right".edge WHERE axis_id BETWEEN 2 AND 5)
    ELSE (SELECT string_agg(edge_id || ' -' || edge_id, ' ' ORDER BY axis_id DESC) FROM "left".edge WHERE axis_id BETWEEN 2 AND 5) END IN t || ' ' || t) > 0
  FROM made, LATERAL (SELECT (pg_temp.texts('//GIRATOIRE/@troncons', file))[1] AS t) g ORDER BY side;
SELECT side || ': pieces lead from who enters to who leaves next', (SELECT bool_and(position((xpath('string(/*/@troncon_amont)', i))[1]::text || ' ' || (xpath('string(/*/@troncon_aval)', i))[1]::text IN t || ' ' || t) > 0)
    FROM unnest(xpath('//TRONCON_INTERNE', file)) i) FROM made, LATERAL (SELECT (pg_temp.texts('//GIRATOIRE/@troncons', file))[1] AS t) g ORDER BY side;
SELECT side || ': who enters from an arm can leave by each', (SELECT count(DISTINCT (a, b)) >= 12 FROM unnest(xpath('//GIRATOIRE//MOUVEMENT_AUTORISE', file)) m,
    LATERAL (SELECT (xpath('string(/*/@id_troncon_amont)', m))[1]::text AS a) n, unnest(pg_temp.texts('//MOUVEMENT_SORTIE/@id_troncon_aval', m)) b WHERE '-' || b <> a) FROM made ORDER BY side;
SELECT side || ': where lights are nobody stops by a line', pg_temp.found('//CARREFOURAFEUX[@controleur_de_feux]//ENTREE_CAF', file) > 0 AND pg_temp.found('//CARREFOURAFEUX[@controleur_de_feux]//ENTREE_CAF[@priorite!="defaut"]', file) = 0 FROM made ORDER BY side;
SELECT side || ': the carrefour names its controller', pg_temp.texts('//CARREFOURAFEUX/@controleur_de_feux', file) = pg_temp.texts('//CONTROLEUR_DE_FEUX/@id', file) AND pg_temp.found('//CONTROLEUR_DE_FEUX', file) = 1 FROM made ORDER BY side;
SELECT 'sequences last as long as the cycle, in whole seconds', (SELECT sum(d::integer) FROM unnest(pg_temp.texts('//SEQUENCE/@duree_totale', pg_temp.file('right'))) d) = (SELECT round(cycle::numeric) FROM "right".controller);
SELECT 'there is one for each green', pg_temp.found('//SEQUENCE', pg_temp.file('right')) = (SELECT count(*) FROM "right".signal_state WHERE kind = 'green');
SELECT 'greens are those of the program, to a second', (SELECT bool_and(abs(shown - known) < 1) AND count(*) > 6 FROM (
    SELECT (xpath('string(/*/@troncon_entree)', a))[1]::text AS way_in, (xpath('string(/*/@troncon_sortie)', a))[1]::text AS way_out, sum((xpath('string(/*/@duree_vert)', a))[1]::text::integer) AS shown
    FROM unnest(xpath('//SIGNAL_ACTIF', pg_temp.file('right'))) a GROUP BY 1, 2) f
  FULL JOIN (SELECT g.name AS way_in, h.name AS way_out, sum(duration) AS known FROM "right".signal_movement m JOIN "right".signal_state USING (controller_id, ordinality)
    JOIN (SELECT unnest(lanes) AS lane, along_axis, streetgen._lane_group_text(edge_id, along_axis, number) AS name FROM "right".lane_group) g ON (g.lane, g.along_axis) = (lane_in, along_in)
    JOIN (SELECT unnest(lanes) AS lane, along_axis, streetgen._lane_group_text(edge_id, along_axis, number) AS name FROM "right".lane_group) h ON (h.lane, h.along_axis) = (lane_out, along_out) GROUP BY 1, 2) k USING (way_in, way_out));
UPDATE "right".controller_editing SET start_offset = 10;
SELECT 'an offset begins the plan a cycle before the simulation and so much later', (SELECT time '07:00' + (10 - cycle) * interval '1 second' FROM "right".controller) - (pg_temp.texts('//PLAN_DE_FEUX/@debut', pg_temp.file('right')))[1]::time BETWEEN interval '-0.5 seconds' AND interval '0.5 seconds';
-- A ring of which a part is written is none.
SELECT 'half a ring is no giratoire', pg_temp.found('//GIRATOIRE', f) = 0 AND pg_temp.found('//TRONCON', f) > 0 FROM pg_temp.file('right', '{"extent": [650010, 6860001, 650020, 6860012]}') f;
-- Middles go to the even digit, as PostGIS rounds.
SELECT 'internal points are as PostGIS writes them', bool_and(streetgen._symuvia_points(line, 0, 0, digits) = '<POINTS_INTERNES><POINT_INTERNE coordonnees="' || replace(substring(ST_AsText(line, digits) FROM '^LINESTRING\([^,]*,(.*),[^,]*\)$'), ',',
    '"/><POINT_INTERNE coordonnees="') || '"/></POINTS_INTERNES>') FROM generate_series(2, 5) digits, unnest(ARRAY['LINESTRING(0 0, -0.0001 0.00049, 0.0005 0.0015, 0.0025 -0.0035, 1.2345 100, -2.0015 12345.6785, 0.1255 5, 9.995 99.9995, 1 1)'::geometry,
    (SELECT ST_MakeLine(ST_MakePoint(650000 + round((sin(k) * 900)::numeric, 2 + k % 5)::float8, 6860000 + k / 16.0) ORDER BY k) FROM generate_series(1, 300) k)]) line;
SELECT 'two points have none between', streetgen._symuvia_points('LINESTRING(0 0, 1 1)', 0, 0, 3) IS NULL;
