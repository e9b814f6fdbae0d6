-- argument abscissa: metres along the axis, up to its length
-- argument axis_offset: metres to the left of the axis; with a side, metres away from that border, negative on the roadway
-- argument side: left or right: the border that axis_offset counts from; NULL: the axis
-- argument roadway_offset: metres from the axis to the middle of the roadway, positive to the left
-- see locate_on, offset_line
SELECT ST_AsText(streetgen.place_on('LINESTRING(0 0, 40 0)', 8, 10, 1, 'left')) AS place;
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 30 0, 45 15)'::geometry AS axis)
SELECT axis, 'axis', NULL FROM given
UNION ALL SELECT streetgen.offset_line(axis, 4), 'helper', NULL FROM given
UNION ALL SELECT streetgen.place_on(axis, 8, 10, 2, 'left'), 'point', NULL FROM given
UNION ALL SELECT streetgen.place_on(axis, 8, 20, -2), 'point', NULL FROM given
UNION ALL SELECT streetgen.place_on(axis, 8, 30, -3), 'point', NULL FROM given
