-- argument stated: number of such lanes that is stated; NULL: none is
-- argument stated_forward: stated number of lanes along the axis; NULL: none is
-- argument stated_backward: stated number of lanes against the axis; NULL: none is
-- argument listed: does a list name the kinds of its lanes
-- argument narrow: is the street narrower than setting `two_way_width_minimal`
-- see lanes_of_way, estimated_lane_count
SELECT streetgen.lanes_of_both(NULL, NULL, NULL, false, 1, false) AS one_lane, streetgen.lanes_of_both(NULL, NULL, NULL, false, NULL, true) AS narrow_street,
    streetgen.lanes_of_both(NULL, NULL, NULL, false, 2, true) AS two_lanes_are_stated;
