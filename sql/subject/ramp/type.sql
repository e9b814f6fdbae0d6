-- The rows from which the core tells ramps.
CREATE TYPE streetgen.street_ramp_axis AS (axis_id bigint, part text, counted boolean);
COMMENT ON TYPE streetgen.street_ramp_axis IS 'An axis that may be part of a ramp.';
COMMENT ON COLUMN streetgen.street_ramp_axis.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_ramp_axis.part IS 'highway, link, or unclassed where no class is known';
COMMENT ON COLUMN streetgen.street_ramp_axis.counted IS 'does a source state its lanes? Else none is missing at it';

CREATE TYPE streetgen.street_ramp AS (axis_id bigint, abscissa float8, tangent float8, length float8);
COMMENT ON TYPE streetgen.street_ramp IS 'A ramp by hand.';
COMMENT ON COLUMN streetgen.street_ramp.axis_id IS 'the link';
COMMENT ON COLUMN streetgen.street_ramp.abscissa IS 'a place on it, m along the axis: the nearer end of its '
    'edge is meant';
COMMENT ON COLUMN streetgen.street_ramp.tangent IS 'm; NULL: setting ramp_tangent';
COMMENT ON COLUMN streetgen.street_ramp.length IS 'of its merging lanes, m; 0: none; NULL: setting merging_length';
