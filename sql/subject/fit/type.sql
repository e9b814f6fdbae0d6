-- Types of the fit.

CREATE TYPE streetgen.radius_sample AS (corner_id bigint, observed float8, major boolean, width float8, speed float8,
    importance integer, lane_count integer, kind text);
COMMENT ON TYPE streetgen.radius_sample IS
    'An axis of a corner that an observed arc answers, for streetgen._radius_forest.';
COMMENT ON COLUMN streetgen.radius_sample.corner_id IS 'the corner';
COMMENT ON COLUMN streetgen.radius_sample.observed IS 'radius of the arc, m';
COMMENT ON COLUMN streetgen.radius_sample.major IS 'is it the major axis of the corner, or are both alike?';
COMMENT ON COLUMN streetgen.radius_sample.width IS 'width kerb to kerb, m';
COMMENT ON COLUMN streetgen.radius_sample.speed IS 'km/h';
COMMENT ON COLUMN streetgen.radius_sample.importance IS '1 highest';
COMMENT ON COLUMN streetgen.radius_sample.lane_count IS 'its lanes';
COMMENT ON COLUMN streetgen.radius_sample.kind IS 'its class';
