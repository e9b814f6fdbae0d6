-- Pairs of lanes that a file of Lanelet2 of model :model shall join by a lanelet across a junction, as tests/cases/lanelet2.py prints them. An edge whose limits
-- cross between two intersections is inside a junction: a pair goes over such edges, too. Nobody drives on parking and closed lanes.
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
SELECT lane_in, a.both_ways AND NOT along_in, lane_out, b.both_ways AND NOT along_out
FROM reached JOIN :"model".lane a ON a.lane_id = lane_in JOIN :"model".lane b ON b.lane_id = lane_out
WHERE lane_out NOT IN (SELECT lane_id FROM inner_lane) AND a.kind NOT IN ('parking', 'closed') AND b.kind NOT IN ('parking', 'closed');
