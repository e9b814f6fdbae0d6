-- OpenDRIVE: heights along roads.

CREATE OR REPLACE FUNCTION streetgen._height_curve(station float8[], height float8[], tolerance float8)
    RETURNS TABLE(s float8[], a float8[], b float8[], c float8[], d float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_height_curve';
COMMENT ON FUNCTION streetgen._height_curve(float8[], float8[], float8) IS
    'Heights at increasing stations as polynomials a + b ds + c ds^2 + d ds^3 from stations s, in one row of arrays: '
    'as few as pass each height by tolerance (metres), without breaks of grade, but where one needs more than that '
    'to vanish. Arrays of different length, other stations: 22023. Fewer than two: no row.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_climb(length float8, height_from float8, grade_from float8,
    height_to float8, grade_to float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN (SELECT streetgen._opendrive_cubics('elevation', 's', ARRAY[0::float8], ARRAY[height_from],
        ARRAY[grade_from], ARRAY[(3 * rise - 2 * grade_from - grade_to) / length],
        ARRAY[(grade_from + grade_to - 2 * rise) / length ^ 2])
        FROM (SELECT (height_to - height_from) / length AS rise) r);
COMMENT ON FUNCTION streetgen._opendrive_climb(float8, float8, float8, float8, float8) IS
    'The elevation of a road of that length as one polynomial, from a height and a grade to others.';
