CREATE TYPE streetgen.city_axis AS (
    geom geometry, width float8, lane_count integer, importance integer, name text, direction text, speed float8
);
COMMENT ON TYPE streetgen.city_axis IS 'An axis of a virtual city, in the words of the axis table of a model.';
COMMENT ON COLUMN streetgen.city_axis.geom IS 'LINESTRING with a vertex wherever another axis meets it';
COMMENT ON COLUMN streetgen.city_axis.width IS 'width kerb to kerb, m';
COMMENT ON COLUMN streetgen.city_axis.lane_count IS 'lanes of both directions';
COMMENT ON COLUMN streetgen.city_axis.importance IS '1 highest';
COMMENT ON COLUMN streetgen.city_axis.name IS 'name of the street';
COMMENT ON COLUMN streetgen.city_axis.direction IS 'both, direct (along the line) or reverse';
COMMENT ON COLUMN streetgen.city_axis.speed IS 'km/h';
