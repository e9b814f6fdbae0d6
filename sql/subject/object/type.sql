-- The rows that a user's rule of placement gives.
CREATE TYPE streetgen.placement AS (type text, axis_id bigint, abscissa float8, side text, axis_offset float8,
    orientation float8);
COMMENT ON TYPE streetgen.placement IS 'Where a rule of one''s own places an object.';
COMMENT ON COLUMN streetgen.placement.type IS 'what it is: a row of object_type';
COMMENT ON COLUMN streetgen.placement.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.placement.abscissa IS 'm along the axis';
COMMENT ON COLUMN streetgen.placement.side IS 'left or right: by that border of the roadway; NULL: by the axis';
COMMENT ON COLUMN streetgen.placement.axis_offset IS 'm away from the border, or to the left of the axis';
COMMENT ON COLUMN streetgen.placement.orientation IS 'degrees clockwise from the axis; NULL: 0';
