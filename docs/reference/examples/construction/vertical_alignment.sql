-- argument abscissas: of the grade points, metres along the road, ascending
-- argument heights: where the straight grades meet, metres
-- argument radii: of the parabolas, metres; 0: the grades meet in a corner
-- see horizontal_alignment, alignment_point
SELECT kind, start_abscissa, end_abscissa, height, grade_start, grade_end, radius
FROM streetgen.vertical_alignment('{0, 400, 900}', '{100, 120, 110}', '{0, 2000, 0}');
