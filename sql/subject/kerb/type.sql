-- Surfaces beside streets that keep their kerbs, as the core takes them.

CREATE TYPE streetgen.street_neighbour AS (x float8, y float8, x_end float8, y_end float8, surface bytea,
    level integer);
COMMENT ON TYPE streetgen.street_neighbour IS
    'A section or an intersection beside what a change writes, as it is there and stays.';
COMMENT ON COLUMN streetgen.street_neighbour.x IS
    'abscissa in the plane of the intersection''s node, or of that at the section''s start';
COMMENT ON COLUMN streetgen.street_neighbour.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_neighbour.x_end IS
    'abscissa in the plane of the node at the section''s end; NULL: it is an intersection';
COMMENT ON COLUMN streetgen.street_neighbour.y_end IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_neighbour.surface IS 'MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.street_neighbour.level IS 'level of the surface';
