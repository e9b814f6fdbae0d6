-- A file of OpenDRIVE of model :model shall hold so much: how many lanes and how many movements, parted by a space. An edge whose limits cross between two
-- intersections is no road: a movement is a pair of lanes of which one is reached from the other by ways over such edges alone.
WITH RECURSIVE inner_lane AS (
    SELECT l.lane_id FROM :"model".lane l JOIN :"model".section s USING (edge_id) JOIN :"model".edge e USING (edge_id)
    WHERE s.method = 'crossed_limits' AND e.from_node IN (SELECT node_id FROM :"model".intersection)
        AND e.to_node IN (SELECT node_id FROM :"model".intersection)),
way AS (SELECT lane_in, along_in, lane_out, along_out FROM :"model".interconnection WHERE connecting),
reached AS (
    SELECT * FROM way WHERE lane_in NOT IN (SELECT lane_id FROM inner_lane)
    UNION SELECT r.lane_in, r.along_in, w.lane_out, w.along_out
    FROM reached r JOIN way w ON (w.lane_in, w.along_in) = (r.lane_out, r.along_out)
    WHERE r.lane_out IN (SELECT lane_id FROM inner_lane))
SELECT (SELECT count(*) FROM :"model".lane WHERE lane_id NOT IN (SELECT lane_id FROM inner_lane)) || ' ' || count(*)
FROM reached WHERE lane_out NOT IN (SELECT lane_id FROM inner_lane);
