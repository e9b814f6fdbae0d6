-- Bends and parts of roads, as the core takes them.

CREATE TYPE streetgen.street_bend AS (axis_id bigint, abscissa float8, radius float8);
COMMENT ON TYPE streetgen.street_bend IS 'The radius of a bend of an axis, by hand.';
COMMENT ON COLUMN streetgen.street_bend.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_bend.abscissa IS 'the place, m along the axis';
COMMENT ON COLUMN streetgen.street_bend.radius IS 'm; 0: it stays sharp';

CREATE TYPE streetgen.road_part AS (edge_id bigint, axis_id bigint, from_node bigint, to_node bigint, level integer,
    start_abscissa float8, end_abscissa float8, line bytea);
COMMENT ON TYPE streetgen.road_part IS 'An edge that is to become part of a road.';
COMMENT ON COLUMN streetgen.road_part.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.road_part.axis_id IS 'its axis';
COMMENT ON COLUMN streetgen.road_part.from_node IS 'node at its start';
COMMENT ON COLUMN streetgen.road_part.to_node IS 'node at its end';
COMMENT ON COLUMN streetgen.road_part.level IS 'its level';
COMMENT ON COLUMN streetgen.road_part.start_abscissa IS 'where it starts, m along the axis';
COMMENT ON COLUMN streetgen.road_part.end_abscissa IS 'where it ends, m along the axis';
COMMENT ON COLUMN streetgen.road_part.line IS 'its line, LINESTRING, or its arc road, COMPOUNDCURVE; EWKB';
