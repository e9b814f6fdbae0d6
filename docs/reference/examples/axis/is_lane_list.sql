-- argument list: the text
-- argument kind: what it lists: kind, width or turn
-- see lanes, driving_lanes
SELECT streetgen.is_lane_list('general|cycle', 'kind') AS kinds, streetgen.is_lane_list('3.5||1.5', 'width') AS widths, streetgen.is_lane_list('left;thru', 'turn') AS turns;
