-- argument open: is the direction open to traffic
-- argument listed: does a list name the kinds of its lanes
-- argument stated: number of lanes that is stated; NULL: none is
-- argument against: number of lanes of the other direction; NULL: unknown
-- argument fewest: the least number of lanes of an open direction; 0 where lanes for both directions are there
-- see lanes_of_both, estimated_lane_count
SELECT streetgen.lanes_of_way(true, false, NULL, 1, 3) AS what_is_left, streetgen.lanes_of_way(false, false, NULL, 1, 3) AS closed;
