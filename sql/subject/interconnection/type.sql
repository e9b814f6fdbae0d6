-- Turn restrictions, as the core takes them.

CREATE TYPE streetgen.street_restriction AS (from_axis bigint, to_axis bigint, x float8, y float8, kind text,
    turn text, except_kinds text);
COMMENT ON TYPE streetgen.street_restriction IS 'What traffic may not do at a node, or only may.';
COMMENT ON COLUMN streetgen.street_restriction.from_axis IS 'the axis that traffic comes by';
COMMENT ON COLUMN streetgen.street_restriction.to_axis IS 'the axis that it goes on by';
COMMENT ON COLUMN streetgen.street_restriction.x IS 'abscissa of a place near the node, in the plane';
COMMENT ON COLUMN streetgen.street_restriction.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_restriction.kind IS 'no or only';
COMMENT ON COLUMN streetgen.street_restriction.turn IS
    'through, left, right or u_turn, where both axes go on beyond the node; NULL: any';
COMMENT ON COLUMN streetgen.street_restriction.except_kinds IS
    'kinds of lanes that it does not bind, parted by |; NULL: it binds all';
