CREATE TYPE streetgen.alignment_element AS (
    ordinality integer, kind text, abscissa float8, start geometry, heading float8, length float8,
    curvature_start float8, curvature_end float8
);
COMMENT ON TYPE streetgen.alignment_element IS 'A straight line, clothoid or arc of the alignment of a road in plan.';
COMMENT ON COLUMN streetgen.alignment_element.ordinality IS 'its number along the alignment, from 1';
COMMENT ON COLUMN streetgen.alignment_element.kind IS 'line, clothoid or arc';
COMMENT ON COLUMN streetgen.alignment_element.abscissa IS 'of its start along the alignment, m';
COMMENT ON COLUMN streetgen.alignment_element.start IS 'POINT where it starts';
COMMENT ON COLUMN streetgen.alignment_element.heading IS
    'at its start, radians counter-clockwise from the x axis';
COMMENT ON COLUMN streetgen.alignment_element.length IS 'm';
COMMENT ON COLUMN streetgen.alignment_element.curvature_start IS '1/m, positive on left bends';
COMMENT ON COLUMN streetgen.alignment_element.curvature_end IS '1/m, positive on left bends';

CREATE TYPE streetgen.alignment_grade AS (abscissa float8, height float8, radius float8);
COMMENT ON TYPE streetgen.alignment_grade IS
    'A vertex of the straight grades of a road, with the parabola that rounds it.';
COMMENT ON COLUMN streetgen.alignment_grade.abscissa IS 'along the alignment, m';
COMMENT ON COLUMN streetgen.alignment_grade.height IS 'where the straight grades meet, m';
COMMENT ON COLUMN streetgen.alignment_grade.radius IS
    'of the parabola, m: its length is the radius times the change of grade; 0: none';
