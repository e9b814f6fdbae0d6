-- argument lanes_forward: number of lanes along the axis, where kind_forward is empty
-- argument lanes_backward: number of lanes against the axis, where kind_backward is empty
-- argument kind_forward: kinds of the lanes along the axis, as general\|bus\|cycle\|parking, from left to right
-- argument kind_backward: kinds of the lanes against the axis, from left to right in driving direction
-- argument lane_width_forward: widths of the lanes along the axis, metres, as 3.5\|\|1.5; empty: an equal share
-- argument lane_width_backward: widths of the lanes against the axis, metres
-- argument width_end: width at the end of the axis, metres; NULL: as at its start
-- argument lane_order: numbers from the middle outwards begin on the left (left_first) or on the right (right_first)
-- argument lanes_both: number of lanes between them that both directions use
-- see offset_line, is_lane_list
SELECT ordinality, lane_position, side, along_axis, kind, round(lane_width::numeric, 3) AS lane_width, round(axis_offset::numeric, 3) AS axis_offset
FROM streetgen.lanes('LINESTRING(0 0, 60 0)', 9, kind_forward => 'general|cycle', lane_width_forward => '|1.5');
-- drawing
SELECT surface, CASE WHEN kind = 'cycle' THEN 'intersection' ELSE 'section' END, NULL FROM streetgen.lanes('LINESTRING(0 0, 30 0, 60 12)', 9, kind_forward => 'general|cycle', lane_width_forward => '|1.5')
UNION ALL SELECT geom, 'result', kind FROM streetgen.lanes('LINESTRING(0 0, 30 0, 60 12)', 9, kind_forward => 'general|cycle', lane_width_forward => '|1.5')
