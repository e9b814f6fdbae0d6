-- argument place: POINT beside the axis
-- argument roadway_offset: metres from the axis to the middle of the roadway, positive to the left
-- see place_on, arc_road_locate
SELECT * FROM streetgen.locate_on('LINESTRING(0 0, 40 0)', 8, 'POINT(10 7)');
