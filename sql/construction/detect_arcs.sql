-- Arcs in a line, found without a model.

CREATE OR REPLACE FUNCTION streetgen._detect_arcs(line bytea, radius_least float8, radius_greatest float8,
    tolerance float8, turn_least float8)
    RETURNS TABLE(centre bytea, radius float8, arc bytea, support integer, deviation float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_detect_arcs';
COMMENT ON FUNCTION streetgen._detect_arcs(bytea, float8, float8, float8, float8) IS
    'EWKB twin of streetgen.detect_arcs';

CREATE OR REPLACE FUNCTION streetgen.detect_arcs(line geometry, radius_least float8 DEFAULT 2,
    radius_greatest float8 DEFAULT 80, tolerance float8 DEFAULT 0.3, turn_least float8 DEFAULT 30)
    RETURNS TABLE(centre geometry, radius float8, arc geometry, support integer, deviation float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 1
    SET search_path = pg_catalog, public
    AS $$ SELECT a.centre::geometry, a.radius, a.arc::geometry, a.support, a.deviation
          FROM streetgen._detect_arcs(line::bytea, radius_least, radius_greatest, tolerance, turn_least) a $$;
COMMENT ON FUNCTION streetgen.detect_arcs(geometry, float8, float8, float8, float8) IS
    'The arcs of circles in a line (LINESTRING, metres), in its order: centre (POINT), radius in metres, arc '
    '(CIRCULARSTRING in the direction of the line, closed for a full circle), support (points of the line on the arc, '
    'four or more) and deviation (metres, the most by which one of them leaves the arc, up to tolerance; their '
    'standard deviation is a tenth of the arc''s height at most). Quadruplets of points vote for circles; a fit of '
    'least squares follows. turn_least: '
    'degrees that an arc turns at least. Between points over 3 m apart the chord leaves its arc by at most twice the '
    'tolerance, so that corners of blocks make no arc. Ends on the straight lines before and behind an arc are no part '
    'of it. With noise of e metres in n points that turn by a radians, a '
    'centre is off by about 10 e / (a^2 sqrt(n)). Radii from 0.001 to 1e6 m, tolerance from 1e-6 to 1000 m. A line '
    'that is no LINESTRING, a number out of range: 22023. NULL for anything: no row. StreetGen paper, 2.8.';
