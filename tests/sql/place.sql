\set ECHO none
\ir shared/truths.sql
-- Nodes between which limits cross are one place in files for simulators: its ways, its signals, rings that pass it.  (name, holds)
CREATE FUNCTION pg_temp.sumo(model name, part text) RETURNS xml LANGUAGE sql AS $$
  SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo(model, part) $$;
CREATE FUNCTION pg_temp.symuvia(model name) RETURNS xml LANGUAGE sql AS $$ SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_symuvia(model) $$;
CREATE FUNCTION pg_temp.opendrive(model name) RETURNS xml LANGUAGE sql AS $$ SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_opendrive(model) $$;
CREATE FUNCTION pg_temp.found(path text, file xml) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, file)) $$;
CREATE FUNCTION pg_temp.ways(model name) RETURNS TABLE(way_id bigint, part integer, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean, turn text, traffic text, geom geometry, interconnections bigint[])
  LANGUAGE sql AS $$ SELECT way_id, part, lane_in, lane_out, along_in, along_out, turn, traffic, geom, interconnections
    FROM streetgen._begin_export(model, 'sumo', 'interconnection', '{}') options, streetgen._connecting_ways(model, options) $$;
-- A street crosses two carriageways 10 m apart, so that there is no room between their corners.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,junction}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, direction) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 'direct'), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 'direct'),
    (3, 'SRID=2154;LINESTRING(650200 6860010,650100 6860010)', 7, 'direct'), (4, 'SRID=2154;LINESTRING(650100 6860010,650000 6860010)', 7, 'direct'),
    (5, 'SRID=2154;LINESTRING(650100 6859900,650100 6860000)', 7, 'both'), (6, 'SRID=2154;LINESTRING(650100 6860000,650100 6860010)', 7, 'both'), (7, 'SRID=2154;LINESTRING(650100 6860010,650100 6860100)', 7, 'both');
END $$;
SELECT 'the limits of one edge cross', (SELECT array_agg(axis_id) FROM town.section JOIN town.edge USING (edge_id) WHERE method = 'crossed_limits') = '{6}';
SELECT 'its nodes are one node of SUMO, in the middle, and it is no edge', pg_temp.found('//node', n) = (SELECT count(*) - 1 FROM town.node) AND pg_temp.found('//edge[@id="6" or @id="-6"]', pg_temp.sumo('town', 'edges')) = 0
  AND pg_temp.found('//node[@x="100.00" and @y="105.00"]', n) = 1 FROM pg_temp.sumo('town', 'nodes') n;
-- What is reached by interconnections, over the lanes of that edge.
CREATE TEMPORARY VIEW reached AS WITH RECURSIVE inner_lane AS (SELECT lane_id FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 6),
  reached AS (SELECT lane_in, along_in, lane_out, along_out FROM town.interconnection WHERE connecting AND lane_in NOT IN (SELECT lane_id FROM inner_lane)
    UNION SELECT r.lane_in, r.along_in, i.lane_out, i.along_out FROM reached r JOIN town.interconnection i ON i.connecting AND (i.lane_in, i.along_in) = (r.lane_out, r.along_out) WHERE r.lane_out IN (SELECT lane_id FROM inner_lane))
  SELECT * FROM reached WHERE lane_out NOT IN (SELECT lane_id FROM inner_lane);
SELECT 'ways lead where interconnections do, each once', (SELECT array_agg((lane_in, along_in, lane_out, along_out) ORDER BY lane_in, along_in, lane_out, along_out) FROM pg_temp.ways('town'))
  = (SELECT array_agg((lane_in, along_in, lane_out, along_out) ORDER BY lane_in, along_in, lane_out, along_out) FROM reached) AND (SELECT count(*) FROM pg_temp.ways('town') WHERE cardinality(interconnections) = 2) >= 4;
SELECT 'no two have one id and part', count(*) = count(DISTINCT (way_id, part)) FROM pg_temp.ways('town');
SELECT 'each goes by its interconnections, from lane to lane', bool_and(a.lane_in = w.lane_in AND a.along_in = w.along_in AND b.lane_out = w.lane_out AND b.along_out = w.along_out AND (cardinality(w.interconnections) = 1 OR a.lane_out = b.lane_in))
  FROM pg_temp.ways('town') w JOIN town.interconnection a ON a.interconnection_id = w.interconnections[1] JOIN town.interconnection b ON b.interconnection_id = w.interconnections[cardinality(w.interconnections)];
SELECT 'its path is theirs, without a gap', bool_and(ST_Equals(ST_StartPoint(w.geom), ST_StartPoint(a.geom)) AND ST_Equals(ST_EndPoint(w.geom), ST_EndPoint(b.geom)) AND ST_Length(w.geom) BETWEEN ST_Length(a.geom) + ST_Length(b.geom) - 1e-6
    AND ST_Length(a.geom) + ST_Length(b.geom) + 0.05) FROM pg_temp.ways('town') w JOIN town.interconnection a ON a.interconnection_id = w.interconnections[1] JOIN town.interconnection b ON b.interconnection_id = w.interconnections[2];
SELECT 'who turns off beyond the first carriageway turns left, who goes on goes through', (SELECT array_agg(DISTINCT w.turn) FROM pg_temp.ways('town') w JOIN town.lane a ON a.lane_id = lane_in JOIN town.lane b ON b.lane_id = lane_out JOIN town.edge e ON e.edge_id = a.edge_id
    JOIN town.edge f ON f.edge_id = b.edge_id WHERE (e.axis_id, f.axis_id) IN ((5, 4), (7, 2))) = '{left}' AND (SELECT array_agg(DISTINCT w.turn) FROM pg_temp.ways('town') w JOIN town.lane a ON a.lane_id = lane_in JOIN town.lane b ON b.lane_id = lane_out
    JOIN town.edge e ON e.edge_id = a.edge_id JOIN town.edge f ON f.edge_id = b.edge_id WHERE (e.axis_id, f.axis_id) IN ((5, 7), (7, 5))) = '{through}';
SELECT 'connections of SUMO are the ways, and those back where a street ends', pg_temp.found('//connection', f) = (SELECT count(*) FROM reached) + 2 FROM pg_temp.sumo('town', 'connections') f;
SELECT 'one place of SymuVia, with its movements', pg_temp.found('//CARREFOURAFEUX', f) = 1 AND pg_temp.found('//MOUVEMENT_SORTIE', f) = (SELECT count(*) FROM reached) AND pg_temp.found('//TRONCON[@id="6" or @id="-6"]', f) = 0 FROM pg_temp.symuvia('town') f;
SELECT 'one junction of OpenDRIVE, with a connecting road each', pg_temp.found('//junction', f) = 1 AND pg_temp.found('//junction/connection', f) = (SELECT count(*) FROM reached) FROM pg_temp.opendrive('town') f;
SELECT 'they are the same where coordinates count about the origin', pg_temp.found('//junction/connection', xmlparse(document string_agg(line, E'\n' ORDER BY ordinality))) = (SELECT count(*) FROM reached)
  FROM streetgen.export_opendrive('town', '{"georeference": "local"}');
-- Only bicycles ride over the edge inside.
BEGIN;
UPDATE town.axis SET kind_forward = 'cycle', kind_backward = 'cycle' WHERE axis_id = 6;
SELECT 'a way over lanes of some traffic is for it alone', count(*) > 0 AND bool_and(traffic = 'cycle') FROM pg_temp.ways('town') WHERE cardinality(interconnections) = 2;
ROLLBACK;
INSERT INTO town.junction_override (axis_id, geom, kind) VALUES (6, 'SRID=2154;POINT(650100 6860000)', 'signals');
SELECT FROM streetgen.switch_subject('town', 'signal', true);
SELECT 'one node has its signals', pg_temp.found('//node[@type="traffic_light"]', pg_temp.sumo('town', 'nodes')) = 1;
SELECT 'each way is a link of its program once, and has green in some state', (SELECT count(*) = count(DISTINCT n::text) AND count(*) = (SELECT count(*) FROM reached) FROM unnest(xpath('//connection/@linkIndex', f)) n)
  AND (SELECT bool_and(green) FROM (SELECT bool_or(substr(state::text, i, 1) IN ('G', 'g')) AS green FROM unnest(xpath('//tlLogic/phase/@state', f)) state, generate_series(1, length(state::text)) i GROUP BY i) s) FROM pg_temp.sumo('town', 'tlLogics') f;
SELECT 'what crosses waits for it', (SELECT bool_or(substr(state::text, i, 1) = 'r') FROM unnest(xpath('//tlLogic/phase/@state', f)) state, generate_series(1, length(state::text)) i) FROM pg_temp.sumo('town', 'tlLogics') f;
-- A ring between two of whose arms limits cross.
DO $$ BEGIN
  PERFORM streetgen.create_model('ring', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right');
  INSERT INTO ring.axis (axis_id, geom, width, lane_count, importance) SELECT 1, ST_SetSRID(ST_Reverse(ST_ExteriorRing(ST_ForceRHR(ST_Buffer(ST_MakePoint(650000, 6860000), 18, 8)))), 2154), 6, 1, 3
    UNION ALL SELECT 2 + row_number() OVER (), ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 18 * cos(radians(a)), 6860000 + 18 * sin(radians(a))), ST_MakePoint(650000 + 118 * cos(radians(a)), 6860000 + 118 * sin(radians(a)))), 2154), 6, 2, 4
    FROM unnest(ARRAY[0, 22.5, 180, 270]) a;
END $$;
SELECT 'limits cross on a piece of the ring', count(*) BETWEEN 1 AND 3 FROM ring.section JOIN ring.edge USING (edge_id) WHERE method = 'crossed_limits' AND axis_id = 1;
SELECT 'the rest of it is a roundabout of SUMO', pg_temp.found('//roundabout', f) = 1 AND cardinality(string_to_array((xpath('string(//roundabout/@edges)', f))[1]::text, ' '))
  = (SELECT count(*) FROM ring.section JOIN ring.edge USING (edge_id) WHERE method <> 'crossed_limits' AND axis_id = 1) FROM pg_temp.sumo('ring', 'edges') f;
SELECT 'and a giratoire, by which each arm leads to each', pg_temp.found('//GIRATOIRE', f) = 1 AND pg_temp.found('//CARREFOURAFEUX', f) + pg_temp.found('//REPARTITEUR', f) = 0 AND (SELECT count(DISTINCT (a, b)) >= 12 FROM unnest(xpath('//GIRATOIRE//MOUVEMENT_AUTORISE', f)) m,
    LATERAL (SELECT (xpath('string(/*/@id_troncon_amont)', m))[1]::text AS a) n, unnest(xpath('//MOUVEMENT_SORTIE/@id_troncon_aval', m)) x(out), LATERAL (SELECT x.out::text AS b) o WHERE '-' || b <> a) FROM pg_temp.symuvia('ring') f;
