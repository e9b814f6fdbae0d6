-- see kerbside_width, is_lane_list
SELECT streetgen.driving_lanes('general|bus|cycle|parking');
