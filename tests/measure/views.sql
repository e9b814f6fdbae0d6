-- How long the views of lanes, movements and signals take, of all rows and of one:
-- psql -v model=NAME -f tests/measure/views.sql
\timing on
SELECT count(*) AS movements FROM :"model".movement;
SELECT count(*) AS conflicts FROM :"model".conflict;
SELECT count(*) AS signal_crossings FROM :"model".signal_crossing;
SELECT count(*) AS lane_intervals FROM :"model".lane_interval;
SELECT count(*) AS of_one_node FROM :"model".conflict WHERE node_id = (SELECT max(node_id) FROM :"model".node);
SELECT count(*) AS of_one_controller FROM :"model".signal_crossing
WHERE controller_id = (SELECT max(controller_id) FROM :"model".controller);
SELECT count(*) AS of_one_lane FROM :"model".lane_interval WHERE lane_id = (SELECT max(lane_id) FROM :"model".lane);
