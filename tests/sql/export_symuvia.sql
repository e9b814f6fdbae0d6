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
SELECT 'an unknown option is refused', test.state($$SELECT FROM streetgen.export_symuvia('town', '{"colour": 1}')$$) = '22023';
