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

-- A place at which an object may stand, or stands.
CREATE TYPE streetgen.standing_place AS (type text, geom geometry, level integer, away float8, by_kerb boolean,
    self bigint);
COMMENT ON TYPE streetgen.standing_place IS
    'A place of an object, of which is asked what keeps it from standing there.';
COMMENT ON COLUMN streetgen.standing_place.type IS 'what it is: a row of object_type';
COMMENT ON COLUMN streetgen.standing_place.geom IS 'the place';
COMMENT ON COLUMN streetgen.standing_place.level IS 'level of its street';
COMMENT ON COLUMN streetgen.standing_place.away IS 'm away from the border of the roadway; NULL: placed by the axis';
COMMENT ON COLUMN streetgen.standing_place.by_kerb IS 'does it stand along a border or a corner, and thus at a kerb';
COMMENT ON COLUMN streetgen.standing_place.self IS 'the object that stands there; NULL: none yet';

-- A bay by the border of its roadway.
CREATE TYPE streetgen.bay_place AS (edge_id bigint, side text, low float8, high float8, axis_offset float8,
    depth float8);
COMMENT ON TYPE streetgen.bay_place IS 'A parking bay, of which is asked what it takes of its roadway.';
COMMENT ON COLUMN streetgen.bay_place.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.bay_place.side IS 'left or right';
COMMENT ON COLUMN streetgen.bay_place.low IS 'where it begins, m along the edge';
COMMENT ON COLUMN streetgen.bay_place.high IS 'where it ends, m along the edge';
COMMENT ON COLUMN streetgen.bay_place.axis_offset IS 'm from the border of the roadway outwards to its outer end';
COMMENT ON COLUMN streetgen.bay_place.depth IS 'm from its outer end to its inner one';

-- An edge beside ground that changed.
CREATE TYPE streetgen.edge_near AS (edge_id bigint, axis_id bigint, away float8);
COMMENT ON TYPE streetgen.edge_near IS 'An edge near ground of which something changed.';
COMMENT ON COLUMN streetgen.edge_near.edge_id IS 'the edge';
COMMENT ON COLUMN streetgen.edge_near.axis_id IS 'its axis';
COMMENT ON COLUMN streetgen.edge_near.away IS 'm from the ground to its roadway';
