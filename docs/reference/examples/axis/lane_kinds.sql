-- argument driving: number of driving lanes
-- argument buses: words of OSM's bus:lanes, parted by `\|`; designated: a bus lane
-- argument bus: is the driving lane at the near kerb a bus lane
-- argument near_cycle: is there a cycle lane at the near kerb
-- argument far_cycle: is there a cycle lane at the far kerb
-- argument near_parking: is there a parking lane at the near kerb
-- argument far_parking: is there a parking lane at the far kerb
-- see is_lane_list, import_osm
SELECT streetgen.lane_kinds(2, NULL, true, 'right', true, false, false, false);
