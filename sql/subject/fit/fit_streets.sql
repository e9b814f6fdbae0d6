-- Streets fitted to observations, by the core.

CREATE OR REPLACE FUNCTION streetgen._fit_streets(lines bytea[], widths float8[], lanes integer[], moves boolean[],
    stretch_axes integer[], stretches float8[], nodes bigint[], kinds integer[], relations integer[], x float8[],
    y float8[], confidence float8[], weight float8[], width float8[], rules float8[], loss text)
    RETURNS TABLE(number integer, geom geometry, new_width float8, new_width_end float8, new_offset float8,
        new_sidewalk_left float8, new_sidewalk_right float8, used integer, mean_before float8, mean_after float8,
        median_before float8, median_after float8, iterations integer)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000000 ROWS 1000 AS 'MODULE_PATHNAME', 'streetgen_fit_streets';
COMMENT ON FUNCTION streetgen._fit_streets(bytea[], float8[], integer[], boolean[], integer[], float8[], bigint[],
    integer[], integer[], float8[], float8[], float8[], float8[], float8[], float8[], text) IS
    'Axes fitted to observations: row 0 tells of all, row n of axis n. lines: axes as EWKB; widths: five numbers each '
    '(width, width_end, roadway_offset, sidewalks left and right, metres); stretches: four numbers each (start and end '
    'along the axis, from and to of the section, metres) of the axis in stretch_axes, with two nodes. kinds: 0 kerb, 1 '
    'sidewalk_back, 2 marking, 3 object, 4 width; relations: 0 border, 1 in, 2 out. rules: as streetgen._fit_rules '
    'says. include/streetgen/fit.hpp says what is least. Numbers that are not finite: 22023; an axis without length: '
    '22000.';

CREATE OR REPLACE FUNCTION streetgen._taken_observations(lines bytea[], widths float8[], lanes integer[],
    moves boolean[], stretch_axes integer[], stretches float8[], nodes bigint[], kinds integer[], relations integer[],
    x float8[], y float8[], confidence float8[], weight float8[], width float8[], rules float8[], loss text)
    RETURNS TABLE(number integer, fate text, axis integer, stretch integer, abscissa float8, aside float8, off float8)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000000 ROWS 100000
    AS 'MODULE_PATHNAME', 'streetgen_taken_observations';
COMMENT ON FUNCTION streetgen._taken_observations(bytea[], float8[], integer[], boolean[], integer[], float8[],
    bigint[], integer[], integer[], float8[], float8[], float8[], float8[], float8[], float8[], text) IS
    'Which axis takes each observation, as streetgen._fit_streets takes both: fate is taken, no street, at junction or '
    'not sure; axis and stretch count from 1, abscissa along the axis, aside from it, left positive, and off beyond '
    'the kerb of that side are metres.';
