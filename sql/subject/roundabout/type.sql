-- On which side traffic goes round, as the core takes it.

CREATE TYPE streetgen.street_circulation AS (axis_id bigint, abscissa float8, along_axis boolean, turned boolean);
COMMENT ON TYPE streetgen.street_circulation IS 'An edge of a roundabout, on which traffic goes round.';
COMMENT ON COLUMN streetgen.street_circulation.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_circulation.abscissa IS 'a place on the edge, m along the axis';
COMMENT ON COLUMN streetgen.street_circulation.along_axis IS 'does this traffic drive along the axis?';
COMMENT ON COLUMN streetgen.street_circulation.turned IS
    'do all its lanes go round, since no source states a direction?';
