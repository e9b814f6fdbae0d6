-- The count of ways closed to cars by an independent reading of their tags, and of those on which a car finds a lane or a path, with those for buses alone:
-- psql -v m=MODEL -v lines=TABLE, after generate with subject junction. TABLE is what osm2pgsql made.
WITH way AS (
  SELECT a.axis_id, l.tags, l.class,
    coalesce(l.tags->>'motorcar', l.tags->>'motor_vehicle', l.tags->>'vehicle', l.tags->>'access', CASE WHEN l.class = 'busway' THEN 'no' END) IS NOT DISTINCT FROM 'no' AS closed,
    coalesce(l.tags->>'bus', l.tags->>'psv', CASE WHEN l.class = 'busway' THEN 'yes' END) IN ('yes', 'designated') AS buses
  FROM :"m".axis a JOIN :"lines" l ON a.source_ref = l.way_id::text),
found AS (
  SELECT w.*, EXISTS (SELECT FROM :"m".edge e JOIN :"m".lane k USING (edge_id) WHERE e.axis_id = w.axis_id AND k.kind IN ('general', 'carpool', 'merging')) AS lane_for_cars,
    EXISTS (SELECT FROM :"m".edge e JOIN :"m".lane k USING (edge_id) JOIN :"m".movement m ON m.lane_in = k.lane_id OR m.lane_out = k.lane_id
        WHERE e.axis_id = w.axis_id AND m.connecting AND m.traffic IS NULL) AS path_for_cars
  FROM way w WHERE closed)
SELECT count(*) AS closed_to_cars, count(*) FILTER (WHERE lane_for_cars OR path_for_cars) AS open_to_cars, count(*) FILTER (WHERE buses) AS for_buses,
       count(*) FILTER (WHERE buses AND (lane_for_cars OR path_for_cars)) AS for_buses_open_to_cars FROM found;
