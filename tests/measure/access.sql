-- psql -v m=MODEL, with search_path set to the model, after import_osm: ways closed to cars by an independent reading of their tags (column tags of the OSM table, -v lines=TABLE), and on how many of them a car finds a lane or a path.
WITH way AS (
  SELECT a.axis_id, l.tags, l.class, CASE WHEN coalesce(l.tags->>'motorcar', l.tags->>'motor_vehicle', l.tags->>'vehicle', l.tags->>'access', CASE WHEN l.class = 'busway' THEN 'no' END) = 'no' THEN true ELSE false END AS closed,
    coalesce(l.tags->>'bus', l.tags->>'psv', CASE WHEN l.class = 'busway' THEN 'yes' END) IN ('yes', 'designated') AS buses
  FROM axis a JOIN :lines l ON a.source_ref = l.way_id::text),
found AS (
  SELECT w.*, EXISTS (SELECT FROM edge e JOIN lane k USING (edge_id) WHERE e.axis_id = w.axis_id AND k.kind IN ('general', 'carpool', 'merging')) AS lane_for_cars,
    EXISTS (SELECT FROM edge e JOIN lane k USING (edge_id) JOIN movement m ON m.lane_in = k.lane_id OR m.lane_out = k.lane_id WHERE e.axis_id = w.axis_id AND m.connecting AND m.traffic IS NULL) AS path_for_cars
  FROM way w WHERE closed)
SELECT :'m' AS model, count(*) AS closed, count(*) FILTER (WHERE lane_for_cars OR path_for_cars) AS open_to_cars, count(*) FILTER (WHERE buses) AS buses_alone, count(*) FILTER (WHERE buses AND (lane_for_cars OR path_for_cars)) AS buses_alone_open_to_cars FROM found;
