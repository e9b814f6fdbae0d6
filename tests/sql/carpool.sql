\set ECHO none
\ir shared/truths.sql
-- Carpool lanes: they lead where general lanes lead, and every writer knows them.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 10.5, 'direct', 'carpool|general|general'),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 10.5, 'direct', 'carpool|general|general'),
    (3, 'SRID=2154;LINESTRING(650200 6860000,650300 6860000)', 7, 'direct', 'general|general'),
    (4, 'SRID=2154;LINESTRING(650300 6860000,650400 6860000)', 7, 'direct', 'carpool|general'),
    (5, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 7, 'both', NULL);
END $$;
CREATE FUNCTION pg_temp.paths(a bigint, b bigint) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(i.lane_position || i.kind || '>' || o.lane_position || o.kind, ' ' ORDER BY i.lane_position, o.lane_position) FROM town.interconnection k JOIN town.lane i ON i.lane_id = k.lane_in JOIN town.lane o ON o.lane_id = k.lane_out
    JOIN town.edge e ON e.edge_id = i.edge_id JOIN town.edge f ON f.edge_id = o.edge_id WHERE (e.axis_id, f.axis_id) = (a, b) AND k.connecting $$;
CREATE FUNCTION pg_temp.found(path text, lines text[]) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, xmlparse(document array_to_string(lines, E'\n')))) $$;
SELECT 'lanes go on one by one', pg_temp.paths(1, 2) = '1carpool>1carpool 2general>2general 3general>3general';
SELECT 'it turns as the left one of three lanes would', pg_temp.paths(1, 5) = '1carpool>2general';
SELECT 'it goes on in a general lane where it ends', pg_temp.paths(2, 3) ~ '1carpool>1general' AND pg_temp.paths(2, 3) !~ 'carpool>.carpool';
SELECT 'no general lane leads to it alone', pg_temp.paths(3, 4) = '1general>1carpool 1general>2general 2general>2general';
SELECT 'it counts as a lane of motor traffic', (SELECT array_agg(lane_count ORDER BY axis_id) = '{3,3,2,2,2}' FROM town.axis_used) AND streetgen.driving_lanes('carpool|cycle|bus') = 2 AND streetgen.is_lane_list('carpool|general', 'kind');
SELECT 'lists of widths speak of it too', (SELECT array_agg(round(lane_width::numeric, 3) ORDER BY lane_position) = '{4,3.5,1.5}' FROM streetgen.lanes('SRID=2154;LINESTRING(0 0,50 0)', 9, 3, 0, 'carpool|general|cycle', '', '4|3.5|1.5'))
  AND (SELECT max(lane_width) / min(lane_width) > 1.1 FROM streetgen.lanes('SRID=2154;LINESTRING(0 0,50 0)', 7.5, 2, 0, 'carpool|general', '', '4|3.5'));
SELECT 'HOV in OpenDRIVE', pg_temp.found('//road[@junction="-1"]//lane[@type="HOV"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_opendrive('town'))) = 3;
SELECT 'hov in SUMO', pg_temp.found('//lane[contains(@allow, "hov")]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_sumo('town', 'edges'))) = 3;
SELECT 'its own participant in Lanelet2', pg_temp.found('//tag[@k="participant:vehicle:car:hov" and @v="yes"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_lanelet2('town'))) >= 3;
SELECT 'reserved in SymuVia', pg_temp.found('//VOIE_RESERVEE[@id_typesvehicules="COVOITURAGE"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_symuvia('town'))) = 3 AND pg_temp.found('//TYPE_DE_VEHICULE[@id="COVOITURAGE"]', (SELECT array_agg(line ORDER BY ordinality) FROM streetgen.export_symuvia('town'))) = 1;
SELECT 'drawn in a colour of its own', streetgen.svg('town', scale => 500) LIKE '%' || (SELECT fill FROM streetgen.symbol_rule WHERE (theme, layer, kind) = ('street', 'lane', 'carpool')) || '%';
-- A model of an older build.
ALTER TABLE town.axis DROP CONSTRAINT axis_kind_forward_check, ADD CONSTRAINT axis_kind_forward_check CHECK (kind_forward ~ '^(general|bus|cycle|parking)(\|(general|bus|cycle|parking)){0,39}$') NOT VALID;
ALTER TABLE town.lane DROP CONSTRAINT lane_kind_check, ADD CONSTRAINT lane_kind_check CHECK (kind IN ('general', 'bus', 'cycle', 'parking', 'merging')) NOT VALID;
SELECT FROM streetgen.adopt_model('town') \g /dev/null
SELECT 'an older model takes it when it is adopted', test.state($$UPDATE town.axis SET kind_forward = 'general|carpool' WHERE axis_id = 3$$) = 'none';
