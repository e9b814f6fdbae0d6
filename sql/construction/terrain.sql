-- Heights of tiles of terrain, read without a model.

CREATE OR REPLACE FUNCTION streetgen._ground_heights(tiles bytea[], xs float8[], ys float8[]) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_ground_heights';
COMMENT ON FUNCTION streetgen._ground_heights(bytea[], float8[], float8[]) IS
    'Heights of the ground at places, NaN where there are none; tiles as raster WKB.';

CREATE OR REPLACE FUNCTION streetgen._height_tile_box(tile bytea) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_height_tile_box';
COMMENT ON FUNCTION streetgen._height_tile_box(bytea) IS
    'Left, lower, right and upper side of a tile of heights (raster WKB), and its SRID. Other bytes: 22023.';
