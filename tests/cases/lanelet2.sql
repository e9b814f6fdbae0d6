-- Pairs of lanes that a file of Lanelet2 of model :model shall join by a lanelet across a junction, as tests/cases/lanelet2.py prints them. Nobody drives on
-- parking and closed lanes.
SELECT lane_in, a.both_ways AND NOT along_in, lane_out, b.both_ways AND NOT along_out
FROM streetgen._begin_export(:'model', 'lanelet2', 'interconnection', '{}') options, streetgen._connecting_ways(:'model', options) JOIN :"model".lane a ON a.lane_id = lane_in JOIN :"model".lane b ON b.lane_id = lane_out
WHERE a.kind NOT IN ('parking', 'closed') AND b.kind NOT IN ('parking', 'closed');
