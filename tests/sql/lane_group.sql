\set ECHO none
\ir shared/truths.sql
\ir shared/switch.sql
-- Lanes in the direction of their traffic, and the lanes of one direction side by side.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('left_town', 2154, driving_side => 'left');
  PERFORM streetgen.set('town', 'transition_length', '0');
  INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward, kind_backward, lanes_both) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 14, 'both', 'general|general', 'general|parking', NULL),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 4, 'both', NULL, NULL, 1),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 8, 'direct', 'general|general', NULL, NULL);
  INSERT INTO left_town.axis SELECT * FROM town.axis;
END $$;
SELECT 'each lane stands once, one for both directions once for each', (SELECT count(*) FROM town.lane_driving) = (SELECT count(*) + count(*) FILTER (WHERE both_ways) FROM town.lane);
SELECT 'a key tells lane and direction', (SELECT bool_and(lane_driving_id = 2 * lane_id + along_axis::integer) AND count(*) = count(DISTINCT lane_driving_id) FROM town.lane_driving);
SELECT 'lines run with their traffic', (SELECT bool_and(ST_Equals(ST_StartPoint(d.geom), CASE WHEN d.along_axis THEN ST_StartPoint(l.geom) ELSE ST_EndPoint(l.geom) END))
  FROM town.lane_driving d JOIN town.lane l USING (lane_id));
SELECT 'every lane and direction is in one group', (SELECT array_agg(lane_id ORDER BY lane_id) FROM town.lane_driving) = (SELECT array_agg(lane ORDER BY lane) FROM town.lane_group, unnest(lanes) lane);
SELECT 'a group has one direction', (SELECT bool_and(l.both_ways OR l.along_axis = g.along_axis) FROM town.lane_group g, unnest(lanes) m(lane_id) JOIN town.lane l USING (lane_id));
-- To the right of the line on which traffic runs: seen in its direction.
CREATE FUNCTION pg_temp.from_right(model name) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE ordered boolean;
BEGIN
  EXECUTE format('SELECT bool_and(offsets = sorted) FROM (SELECT array_agg(off ORDER BY i) AS offsets, array_agg(off ORDER BY off) AS sorted FROM (
    SELECT lane_group_id, i, CASE WHEN g.along_axis THEN l.axis_offset ELSE -l.axis_offset END AS off FROM %1$I.lane_group g, unnest(lanes) WITH ORDINALITY m(lane_id, i) JOIN %1$I.lane l USING (lane_id)) o
    GROUP BY lane_group_id) g', model) INTO ordered;
  RETURN ordered;
END $$;
SELECT 'numbers count from the right kerb where one drives on the right', pg_temp.from_right('town');
SELECT 'and from the left kerb where one drives on the left', NOT pg_temp.from_right('left_town');
SELECT 'the line is the mean of its lanes', (SELECT bool_and(ST_HausdorffDistance(g.geom, ST_MakeLine(middle_start, middle_end)) < 1e-6) FROM town.lane_group g, LATERAL (
  SELECT ST_Centroid(ST_Collect(CASE WHEN g.along_axis THEN ST_StartPoint(geom) ELSE ST_EndPoint(geom) END)) AS middle_start,
    ST_Centroid(ST_Collect(CASE WHEN g.along_axis THEN ST_EndPoint(geom) ELSE ST_StartPoint(geom) END)) AS middle_end FROM town.lane WHERE lane_id = ANY (lanes)) m);
SELECT 'its nodes are those that traffic comes from and to', (SELECT bool_and((g.from_node, g.to_node) = CASE WHEN along_axis THEN (e.from_node, e.to_node) ELSE (e.to_node, e.from_node) END)
  FROM town.lane_group g JOIN town.edge e USING (edge_id));
INSERT INTO town.lane_override (axis_id, abscissa, ordinality, along_axis) SELECT axis_id, 50, ordinality, false FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND along_axis ORDER BY lane_position DESC LIMIT 1;
SELECT 'lanes that others part are groups of their own', (SELECT array_agg(number ORDER BY number) = '{1,2}' FROM town.lane_group JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND NOT along_axis);
SELECT 'a mean of one line is that line', streetgen.mean_line(ARRAY['LINESTRING(0 0,1 1,1 1)'::geometry])::bytea = 'LINESTRING(0 0,1 1,1 1)'::geometry::bytea;
SELECT 'of two it runs halfway', ST_AsText(streetgen.mean_line(ARRAY['LINESTRING(0 0,10 0)', 'LINESTRING(0 2,10 4)']::geometry[])) = 'LINESTRING(0 1,10 2)';
SELECT 'of lines that cancel out there is none', streetgen.mean_line(ARRAY['LINESTRING(0 0,10 0)', 'LINESTRING(10 0,0 0)']::geometry[]) IS NULL;
SELECT 'a NULL among them is an error', test.state($$SELECT streetgen.mean_line(ARRAY['LINESTRING(0 0,10 0)', NULL]::geometry[])$$) = '22004';
SELECT 'so is a point', test.state($$SELECT streetgen.mean_line(ARRAY['LINESTRING(0 0,10 0)', 'POINT(0 0)']::geometry[])$$) = '22023';
SELECT test.switch_off('town', 'lane') \g /dev/null
SELECT 'without lanes there are no views of them', to_regclass('town.lane_group') IS NULL AND to_regclass('town.lane_driving') IS NULL;
