-- Arc roads, usable alone. Private twins take lines and give geometries as EWKB; roads come as PostGIS stores them.

CREATE OR REPLACE FUNCTION streetgen._arc_road(bytea, float8, float8, float8[]) RETURNS bytea
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road';
COMMENT ON FUNCTION streetgen._arc_road(bytea, float8, float8, float8[]) IS 'EWKB twin of streetgen.arc_road';
CREATE OR REPLACE FUNCTION streetgen.arc_road(line geometry, cap float8 DEFAULT 4000, shift float8 DEFAULT NULL,
    radii float8[] DEFAULT NULL) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._arc_road(line::bytea, cap, shift, radii)::geometry $$;
COMMENT ON FUNCTION streetgen.arc_road(geometry, float8, float8, float8[]) IS
    'The arc road of a line (LINESTRING, metres): a COMPOUNDCURVE of straight pieces and arcs that touch them, in the '
    'point order of the line. Each inner point is a bend but for those that repeat another or lie on the way between '
    'their neighbours; the ends stay, also of a closed line. The radii are the greatest: none can grow unless one that '
    'is not greater shrinks. cap: the greatest radius, metres. shift: how far the road may leave a point of the line, '
    'metres; NULL: as far as it likes. radii: one for each point, metres, which comes before cap and shift; NULL: '
    'free. A bend straight back stays sharp. Of a LINESTRING Z each arc goes through its three points in space, which '
    'PostGIS takes for an arc of the plan: ask it by these functions. Bad geometry or numbers, radii of another '
    'length or that do not fit, a vertical piece: 22023. GIS data to functional road models, 6.2. NULL for NULL, but '
    'for shift and radii.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_arcs(bytea, float8, float8, float8[])
    RETURNS TABLE(vertex integer, centre bytea, radius float8, angle float8, start_abscissa float8,
        end_abscissa float8, start_direction float8[], orientation text, normal float8[])
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100 ROWS 10 AS 'MODULE_PATHNAME', 'streetgen_arc_road_arcs';
COMMENT ON FUNCTION streetgen._arc_road_arcs(bytea, float8, float8, float8[]) IS
    'EWKB twin of streetgen.arc_road_arcs';
CREATE OR REPLACE FUNCTION streetgen.arc_road_arcs(line geometry, cap float8 DEFAULT 4000, shift float8 DEFAULT NULL,
    radii float8[] DEFAULT NULL)
    RETURNS TABLE(vertex integer, centre geometry, radius float8, angle float8, start_abscissa float8,
        end_abscissa float8, start_direction float8[], orientation text, normal float8[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 100 ROWS 10
    SET search_path = pg_catalog, public
    AS $$ SELECT a.vertex, a.centre::geometry, a.radius, a.angle, a.start_abscissa, a.end_abscissa, a.start_direction,
        a.orientation, a.normal
          FROM streetgen._arc_road_arcs(line::bytea, cap, shift, radii) a $$;
COMMENT ON FUNCTION streetgen.arc_road_arcs(geometry, float8, float8, float8[]) IS
    'The bends of the arc road of a line (arguments as of arc_road), a row each along the road, in the plane and in '
    'space: number of the point of the line from 1, centre (POINT), radius (metres; 0: it stays sharp), angle '
    '(degrees), metres along the road where the arc starts and ends, unit vector from the centre to the start '
    '(x, y, z), orientation (left, right; straight on a crest or in a sag) and unit normal of its plane (up on left '
    'bends). The arc is centre + radius (cos t start_direction + sin t normal x start_direction). Bad geometry or '
    'numbers: 22023. GIS data to functional road models, 6.1, where (12) starts elsewhere. NULL for NULL, but for '
    'shift and radii: no row.';

CREATE OR REPLACE FUNCTION streetgen.arc_road_length(road geometry) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road_length';
COMMENT ON FUNCTION streetgen.arc_road_length(geometry) IS
    'Length of a road in metres, in closed form. The road is what arc_road gives, or another COMPOUNDCURVE, '
    'CIRCULARSTRING or LINESTRING, taken as it is; of one with heights in space. Bad geometry: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.arc_road_point(road geometry, metres float8, wheelbase float8 DEFAULT 2.7)
    RETURNS TABLE(geom geometry, forward float8[], rightward float8[], upward float8[], heading float8,
        curvature float8, steering_angle float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_arc_road_point';
COMMENT ON FUNCTION streetgen.arc_road_point(geometry, float8, float8) IS
    'The place (POINT) at a number of metres along a road (as of arc_road_length; clamped to it) and how a car stands '
    'there: unit vectors (x, y, z) forward, to the right (horizontal) and up (their normal); heading in degrees '
    'clockwise from the y axis, as ST_Azimuth; curvature in the plan, 1/m, and the steering angle of a car of that '
    'wheelbase (0.01 to 100 m), degrees, both positive on left bends. Bad geometry or numbers: 22023. GIS data to '
    'functional road models, 6.1. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen.arc_road_locate(road geometry, point geometry)
    RETURNS TABLE(metres float8, axis_offset float8, distance float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_arc_road_locate';
COMMENT ON FUNCTION streetgen.arc_road_locate(geometry, geometry) IS
    'Where a point (POINT) lies by a road (as of arc_road_length): metres along it of the nearest place, the first of '
    'equal ones; how far to the left of the road there (negative: to the right); its distance, which is more beyond an '
    'end, or above. A road with heights needs a point with one; a flat one asks for none. Bad geometry, another SRID: '
    '22023. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen.arc_road_distance(road geometry, a geometry, b geometry) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road_distance';
COMMENT ON FUNCTION streetgen.arc_road_distance(geometry, geometry, geometry) IS
    'Metres along a road (as of arc_road_length) from the place that is nearest to a to that nearest to b (POINT '
    'both); negative where b comes before a. Bad geometry, another SRID: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_offset(geometry, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road_offset';
COMMENT ON FUNCTION streetgen._arc_road_offset(geometry, float8) IS
    'Twin of streetgen.arc_road_offset that gives EWKB';
CREATE OR REPLACE FUNCTION streetgen.arc_road_offset(road geometry, axis_offset float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._arc_road_offset(road, axis_offset)::geometry $$;
COMMENT ON FUNCTION streetgen.arc_road_offset(geometry, float8) IS
    'The road (COMPOUNDCURVE, in its direction) at an offset of a road (as of arc_road_length), metres to its left '
    '(negative: to the right, up to 200). Of a flat road it is exact: the radius of a left bend less the offset, that '
    'of a right bend more; what an inner bend turns over is cut out as offset_line does; sharp bends are round '
    'outside. Of a road with heights it is near: within |axis_offset| slope (1 + tan(angle / 2)) for its greatest '
    'slope (rise / run, below 0.2) and sharpest bend. NULL where nothing is left. Bad geometry or numbers: 22023; a '
    'bend with heights that is tighter than the offset, or turns back: 0A000. GIS data to functional road models, 6.3. '
    'NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.arc_road_speed_limit(radius float8, friction float8 DEFAULT 0.7,
    superelevation float8 DEFAULT 0, safety float8 DEFAULT 1) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_arc_road_speed_limit';
COMMENT ON FUNCTION streetgen.arc_road_speed_limit(float8, float8, float8, float8) IS
    'Speed in km/h up to which a car does not slip on an arc of a radius (0 to 1000000 m), times safety (0 to 1): '
    'v^2 = g r (friction + superelevation) / (1 - friction superelevation). friction: static, 0 to 2, 0.7 on a dry '
    'road; superelevation: rise / run across the road, -0.2 to 0.2, positive where it leans into the bend. A number '
    'out of its range: 22023. GIS data to functional road models, equation 7. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_stretches(geometry)
    RETURNS TABLE(start_abscissa float8, end_abscissa float8, radius float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_arc_road_stretches';
COMMENT ON FUNCTION streetgen._arc_road_stretches(geometry) IS
    'The pieces of a road: metres along it where each starts and ends, its radius (NULL: straight).';
CREATE OR REPLACE FUNCTION streetgen.arc_road_speed_profile(road geometry, friction float8 DEFAULT 0.7,
    superelevation float8 DEFAULT 0, safety float8 DEFAULT 1)
    RETURNS TABLE(start_abscissa float8, end_abscissa float8, radius float8, speed_limit float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 20
    SET search_path = pg_catalog, public
    AS $$ SELECT s.start_abscissa, s.end_abscissa, s.radius,
        streetgen.arc_road_speed_limit(s.radius, friction, superelevation, safety)
          FROM streetgen._arc_road_stretches(road) s ORDER BY 1 $$;
COMMENT ON FUNCTION streetgen.arc_road_speed_profile(geometry, float8, float8, float8) IS
    'The pieces of a road (as of arc_road_length) in their order: metres along it where each starts and ends, its '
    'radius and arc_road_speed_limit there, km/h, with the other arguments; both NULL where it is straight. Bad '
    'geometry or numbers: 22023. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_line(geometry, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road_line';
COMMENT ON FUNCTION streetgen._arc_road_line(geometry, float8) IS
    'Twin of streetgen.arc_road_line that gives EWKB';
CREATE OR REPLACE FUNCTION streetgen.arc_road_line(road geometry, tolerance float8 DEFAULT 0.05) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._arc_road_line(road, tolerance)::geometry $$;
COMMENT ON FUNCTION streetgen.arc_road_line(geometry, float8) IS
    'A road (as of arc_road_length) as a LINESTRING in its direction: equal chords of each arc that leave it by at '
    'most the tolerance, 0.001 to 10 m. Bad geometry or numbers: 22023. GIS data to functional road models, 6.4.1. '
    'NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._arc_road_mesh(geometry, float8, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_road_mesh';
COMMENT ON FUNCTION streetgen._arc_road_mesh(geometry, float8, float8, float8) IS
    'Twin of streetgen.arc_road_mesh that gives EWKB';
CREATE OR REPLACE FUNCTION streetgen.arc_road_mesh(road geometry, offset_left float8, offset_right float8,
    tolerance float8 DEFAULT 0.05) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._arc_road_mesh(road, offset_left, offset_right, tolerance)::geometry $$;
COMMENT ON FUNCTION streetgen.arc_road_mesh(geometry, float8, float8, float8) IS
    'The surface (TIN Z, counter-clockwise from above) between two offsets of a road (as of arc_road_length), metres '
    'to its left, up to 200 to either side, offset_left the greater one: a strip along the road whose borders have the '
    'same number of steps and leave the true ones by at most the tolerance, 0.001 to 10 m. Horizontal across the road; '
    'heights are those of the road, else 0. Where an inner bend turns a border over, triangles fan out from where the '
    'border meets itself. Bad geometry or numbers: 22023. GIS data to functional road models, 6.4.2. NULL for NULL.';
