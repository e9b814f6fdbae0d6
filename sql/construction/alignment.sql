-- Alignments of lines, clothoids and arcs, usable alone. Private twins take numbers and EWKB.

CREATE OR REPLACE FUNCTION streetgen._horizontal_alignment(line bytea, radii float8[], clothoids_in float8[],
    clothoids_out float8[])
    RETURNS TABLE(kind text, abscissa float8, x float8, y float8, heading float8, length float8,
        curvature_start float8, curvature_end float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 20 COST 100
    AS 'MODULE_PATHNAME', 'streetgen_horizontal_alignment';
COMMENT ON FUNCTION streetgen._horizontal_alignment(bytea, float8[], float8[], float8[]) IS
    'Twin of streetgen.horizontal_alignment with two clothoids for each point.';

CREATE OR REPLACE FUNCTION streetgen.horizontal_alignment(line geometry, radii float8[], clothoids float8[])
    RETURNS SETOF streetgen.alignment_element
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 20 COST 100 SET search_path = pg_catalog, public
    AS $$
    SELECT e.ordinality::integer, e.kind, e.abscissa, ST_SetSRID(ST_Point(e.x, e.y), ST_SRID(line)), e.heading,
        e.length, e.curvature_start, e.curvature_end
    FROM streetgen._horizontal_alignment(line::bytea, radii, clothoids, clothoids) WITH ORDINALITY e $$;
COMMENT ON FUNCTION streetgen.horizontal_alignment(geometry, float8[], float8[]) IS
    'The alignment along a line (LINESTRING, metres) with a clothoid, an arc and a clothoid at each vertex: its '
    'elements in order. radii: one for each point of the line, metres, 0 stays sharp; those of the ends mean nothing. '
    'clothoids: the parameter A of both clothoids of each point, metres, 0: none; a clothoid is A^2 / radius long. '
    'Where both clothoids turn by more than the vertex they are shortened until they meet, and there is no arc. '
    'Headings are radians counter-clockwise from the x axis, curvatures 1/m, positive on left bends. Curves that do '
    'not fit, points that repeat another, lists of another length: 22023. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen._vertical_alignment(grades float8[])
    RETURNS TABLE(kind text, start_abscissa float8, end_abscissa float8, height float8, grade_start float8,
        grade_end float8, radius float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_vertical_alignment';
COMMENT ON FUNCTION streetgen._vertical_alignment(float8[]) IS
    'Twin of streetgen.vertical_alignment: abscissa, height and radius of each point beside each other.';

CREATE OR REPLACE FUNCTION streetgen.vertical_alignment(abscissas float8[], heights float8[], radii float8[])
    RETURNS TABLE(kind text, start_abscissa float8, end_abscissa float8, height float8, grade_start float8,
        grade_end float8, radius float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
    SELECT a.* FROM streetgen._vertical_alignment(ARRAY(SELECT v
        FROM unnest(abscissas, heights, radii) WITH ORDINALITY p(abscissa, height, radius, nth),
            unnest(ARRAY[abscissa, p.height, p.radius]) WITH ORDINALITY n(v, k) ORDER BY nth, k)) a $$;
COMMENT ON FUNCTION streetgen.vertical_alignment(float8[], float8[], float8[]) IS
    'Straight grades and parabolas through grade points, a row each in order. abscissas: metres along the road, '
    'ascending; heights: where the straight grades meet, metres; radii: of the parabolas, metres, 0: a corner. A '
    'parabola is radius times change of grade long, half of it on each side of its point. height and grade_start are '
    'those of the start of the row, grades rise over run, radius NULL on straight grades. Points out of order and '
    'parabolas that overlap: 22023; lists of different lengths: 22004. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen._element_numbers(elements streetgen.alignment_element[]) RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ARRAY(SELECT v FROM unnest(elements) e,
        unnest(ARRAY[e.abscissa, ST_X(e.start), ST_Y(e.start), e.heading, e.length, e.curvature_start,
            e.curvature_end]) WITH ORDINALITY n(v, k) ORDER BY e.abscissa, e.ordinality, k) $$;
COMMENT ON FUNCTION streetgen._element_numbers(streetgen.alignment_element[]) IS
    'Seven numbers for each element: abscissa, x, y, heading, length, and the two curvatures.';

CREATE OR REPLACE FUNCTION streetgen._grade_numbers(grades streetgen.alignment_grade[]) RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY(SELECT v FROM unnest(grades) g,
        unnest(ARRAY[g.abscissa, g.height, g.radius]) WITH ORDINALITY n(v, k) ORDER BY g.abscissa, k) $$;
COMMENT ON FUNCTION streetgen._grade_numbers(streetgen.alignment_grade[]) IS
    'Three numbers for each grade point: abscissa, height and radius.';

CREATE OR REPLACE FUNCTION streetgen._alignment_point(elements float8[], grades float8[], metres float8)
    RETURNS TABLE(x float8, y float8, z float8, heading float8, curvature float8, grade float8)
    LANGUAGE c IMMUTABLE PARALLEL SAFE ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_alignment_point';
COMMENT ON FUNCTION streetgen._alignment_point(float8[], float8[], float8) IS 'Twin of streetgen.alignment_point.';

CREATE OR REPLACE FUNCTION streetgen.alignment_point(elements streetgen.alignment_element[], metres float8,
    grades streetgen.alignment_grade[] DEFAULT NULL)
    RETURNS TABLE(geom geometry, heading float8, curvature float8, grade float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
    SELECT ST_SetSRID(CASE WHEN p.z IS NULL THEN ST_Point(p.x, p.y) ELSE ST_MakePoint(p.x, p.y, p.z) END,
        ST_SRID(elements[1].start)), p.heading, p.curvature, p.grade
    FROM streetgen._alignment_point(streetgen._element_numbers(elements), streetgen._grade_numbers(grades), metres) p
    WHERE elements IS NOT NULL AND metres IS NOT NULL $$;
COMMENT ON FUNCTION streetgen.alignment_point(streetgen.alignment_element[], float8, streetgen.alignment_grade[]) IS
    'The place after some metres of an alignment, clamped to it: POINT, heading in radians counter-clockwise from the '
    'x axis, curvature in 1/m, positive on left bends. With grades the point has a height and grade is rise over run. '
    'No elements: 22023. NULL for NULL: no row.';

CREATE OR REPLACE FUNCTION streetgen._alignment_line(elements float8[], grades float8[], srid integer, start_at float8,
    end_at float8, tolerance float8, axis_offset float8 DEFAULT 0, taper float8 DEFAULT 0) RETURNS bytea
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_alignment_line';
COMMENT ON FUNCTION streetgen._alignment_line(float8[], float8[], integer, float8, float8, float8, float8, float8)
    IS 'EWKB twin of streetgen.alignment_line, of the part between two abscissas. axis_offset: metres to its left; the '
    'line leaves the ends of the alignment over a taper, metres.';

CREATE OR REPLACE FUNCTION streetgen.alignment_line(elements streetgen.alignment_element[],
    tolerance float8 DEFAULT 0.01, grades streetgen.alignment_grade[] DEFAULT NULL) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 100 SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._alignment_line(streetgen._element_numbers(elements), streetgen._grade_numbers(grades),
        ST_SRID(elements[1].start), 0, 'Infinity', tolerance)::geometry
        WHERE elements IS NOT NULL AND tolerance IS NOT NULL $$;
COMMENT ON FUNCTION streetgen.alignment_line(streetgen.alignment_element[], float8, streetgen.alignment_grade[]) IS
    'A LINESTRING along an alignment whose chords leave plan and heights by at most the tolerance, metres (1e-5 to '
    '100). With grades the line has heights. No elements, or another tolerance: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.clothoid(start geometry, heading float8, length float8, curvature_start float8,
    curvature_end float8, tolerance float8 DEFAULT 0.01) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100 SET search_path = pg_catalog, public
    AS $$
    SELECT streetgen._check_type('start', start, '{POINT}', 'A clothoid begins at one point.');
    SELECT streetgen._alignment_line(ARRAY[0, ST_X(start), ST_Y(start), heading, length, curvature_start,
        curvature_end], NULL, ST_SRID(start), 0, length, tolerance)::geometry $$;
COMMENT ON FUNCTION streetgen.clothoid(geometry, float8, float8, float8, float8, float8) IS
    'A clothoid as a LINESTRING whose chords leave it by at most the tolerance, metres. start: POINT; heading: '
    'radians counter-clockwise from the x axis; length: metres; curvatures at both ends: 1/m, positive on left bends, '
    'linear in between. Equal curvatures give an arc, or a straight line. Another geometry, values that are not '
    'finite: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._least_radius(speed float8, superelevation float8, friction float8) RETURNS float8
    LANGUAGE c IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_least_radius';
COMMENT ON FUNCTION streetgen._least_radius(float8, float8, float8) IS 'Twin of streetgen.least_radius.';

CREATE OR REPLACE FUNCTION streetgen.least_radius(speed float8, superelevation float8 DEFAULT 0.07,
    friction float8 DEFAULT NULL) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._least_radius(speed, superelevation, friction)
        WHERE speed IS NOT NULL AND superelevation IS NOT NULL $$;
COMMENT ON FUNCTION streetgen.least_radius(float8, float8, float8) IS
    'The least radius of a curve at a speed (km/h), metres: V^2 / (127 (e + f)) with superelevation e, rise over run, '
    'and side friction f. friction NULL: that of the Portuguese norm JAE P3/94, 0.16 at 40 km/h falling to 0.06 at '
    '140. A speed outside 1 to 400, or no grip at all: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.benefit(population_a float8, population_b float8, length float8,
    alternative float8, operating_cost float8 DEFAULT 1) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN alternative IS NULL OR length = 0 THEN 'Infinity'::float8
        ELSE population_a * population_b / (length * length) * (alternative - length) * operating_cost END
        WHERE population_a IS NOT NULL AND population_b IS NOT NULL AND length IS NOT NULL $$;
COMMENT ON FUNCTION streetgen.benefit(float8, float8, float8, float8, float8) IS
    'The benefit of a direct road between two towns: U (alternative - length) operating_cost with the utilisation '
    'U = population_a population_b / length^2. Equations 1 and 2 of Campos, Leitao and Coelho, "Integrated Modeling of '
    'Road Environments for Driving Simulation" (2015); equation 2 prints the difference with the other sign. '
    'alternative: length of the shortest way without the road, in the unit of length. An argument that is NULL is '
    'unknown: without an alternative, as between towns at one place, the benefit is infinite; else it is NULL.';

CREATE OR REPLACE FUNCTION streetgen._curvature_spectrum(line bytea, step float8, extent float8) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 AS 'MODULE_PATHNAME', 'streetgen_curvature_spectrum';
COMMENT ON FUNCTION streetgen._curvature_spectrum(bytea, float8, float8) IS
    'EWKB twin of streetgen.curvature_spectrum: the five shares.';

CREATE OR REPLACE FUNCTION streetgen.curvature_spectrum(line geometry, step float8 DEFAULT 10,
    extent float8 DEFAULT 2000) RETURNS TABLE(cycles_from float8, cycles_to float8, share float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 5 COST 10000 SET search_path = pg_catalog, public
    AS $$
    SELECT b.low, b.high, s.share
    FROM unnest(streetgen._curvature_spectrum(line::bytea, step, extent)) WITH ORDINALITY s(share, nth)
    JOIN (VALUES (1, 0::float8, 1::float8), (2, 1, 2), (3, 2, 4), (4, 4, 8), (5, 8, NULL)) b(nth, low, high)
        USING (nth) ORDER BY s.nth $$;
COMMENT ON FUNCTION streetgen.curvature_spectrum(geometry, float8, float8) IS
    'How the curvature of a line is spread over wavelengths: the share of its energy in each band of cycles per '
    'kilometre. Headings every step metres, smoothed over 7, are differenced; windows of extent metres (Hann, half '
    'overlapping) are transformed, and their shares averaged. A line shorter than the extent, or straight, gives no '
    'row. Another step or extent: 22023. NULL for NULL: no row.';
