-- Decisions about overpasses, as the core takes them.

CREATE TYPE streetgen.street_overpass AS (axis_above bigint, axis_below bigint, x float8, y float8,
    clearance float8);
COMMENT ON TYPE streetgen.street_overpass IS 'Which of two axes passes over the other where they cross, by hand.';
COMMENT ON COLUMN streetgen.street_overpass.axis_above IS 'the axis that passes over';
COMMENT ON COLUMN streetgen.street_overpass.axis_below IS 'the axis below';
COMMENT ON COLUMN streetgen.street_overpass.x IS 'abscissa of a place near the crossing, in the plane';
COMMENT ON COLUMN streetgen.street_overpass.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_overpass.clearance IS 'm from roadway to roadway; NULL: setting clearance';
