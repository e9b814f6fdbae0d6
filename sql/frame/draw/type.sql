-- A room gives what it draws as rows of this type.

CREATE TYPE streetgen.shape AS (layer text, kind text, level integer, geom geometry, id bigint);
COMMENT ON TYPE streetgen.shape IS
    'Something of a model that can be drawn, by the rules that streetgen.symbol_rule has for its layer and kind.';
COMMENT ON COLUMN streetgen.shape.layer IS 'name of what is drawn, such as lane';
COMMENT ON COLUMN streetgen.shape.kind IS 'part of the layer, such as bus of lane; empty: nothing is said';
COMMENT ON COLUMN streetgen.shape.level IS 'level by which it lies over or under others; NULL: above all';
COMMENT ON COLUMN streetgen.shape.geom IS 'what is drawn, in metres';
COMMENT ON COLUMN streetgen.shape.id IS 'key of the row that it shows';

-- A room gives what moves in a picture as rows of this type.
CREATE TYPE streetgen.animated_shape AS (layer text, kind text, level integer, id bigint, element text);
COMMENT ON TYPE streetgen.animated_shape IS
    'Something of a model that moves, drawn by the rules that streetgen.symbol_rule has for its layer and kind.';
COMMENT ON COLUMN streetgen.animated_shape.layer IS 'name of what is drawn, such as car';
COMMENT ON COLUMN streetgen.animated_shape.kind IS 'part of the layer; empty: nothing is said';
COMMENT ON COLUMN streetgen.animated_shape.level IS 'level by which it lies over or under others';
COMMENT ON COLUMN streetgen.animated_shape.id IS 'key of the row that it shows';
COMMENT ON COLUMN streetgen.animated_shape.element IS
    'an element of SVG, in metres from the upper left corner of the picture';
