-- argument cycle_lane_width: width of a cycle lane, metres
-- argument parking_lane_width: width of a parking lane, metres
-- see driving_lanes
SELECT streetgen.kerbside_width('general|cycle|parking', 1.5, 2);
