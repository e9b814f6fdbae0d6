-- A place where a footway leads over a street.
CREATE TYPE streetgen.footway_crossing AS (edge_id bigint, abscissa float8, angle float8, width float8);
COMMENT ON TYPE streetgen.footway_crossing IS 'Where a footway leads over a street.';
COMMENT ON COLUMN streetgen.footway_crossing.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.footway_crossing.abscissa IS 'm along the axis';
COMMENT ON COLUMN streetgen.footway_crossing.angle IS 'degrees counter-clockwise from the axis to the way across';
COMMENT ON COLUMN streetgen.footway_crossing.width IS 'm along the street';
