-- Places beside an axis, usable alone.

CREATE OR REPLACE FUNCTION streetgen._place_on(bytea, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_place_on';
COMMENT ON FUNCTION streetgen._place_on(bytea, float8, float8) IS
    'The place (EWKB) at an abscissa of an axis (EWKB), so many metres to its left';

CREATE OR REPLACE FUNCTION streetgen._direction_on(bytea, float8, float8) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_direction_on';
COMMENT ON FUNCTION streetgen._direction_on(bytea, float8, float8) IS
    'Direction of an axis (EWKB) at an abscissa, turned by so many degrees: clockwise from the north, from 0 to below '
    '360; at a vertex between those of both segments';

CREATE OR REPLACE FUNCTION streetgen._locate_on(bytea, bytea) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_locate_on';
COMMENT ON FUNCTION streetgen._locate_on(bytea, bytea) IS
    'Abscissa of an axis (EWKB) nearest to a place (EWKB), and how many metres to the left of it the place lies';

CREATE OR REPLACE FUNCTION streetgen._border_at(borders float8[], abscissa float8, side text) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_border_at';
COMMENT ON FUNCTION streetgen._border_at(float8[], float8, text) IS
    'Metres from an axis to the border of its roadway on a side, at an abscissa, by column borders of its sections.';

CREATE OR REPLACE FUNCTION streetgen._even_borders(width float8, width_end float8, length float8,
    roadway_offset float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        SELECT ARRAY[0, width / 2 + roadway_offset, width / 2 - roadway_offset,
            length, width_end / 2 + roadway_offset, width_end / 2 - roadway_offset];
    END;
COMMENT ON FUNCTION streetgen._even_borders(float8, float8, float8, float8) IS
    'Borders as column borders of a section has them, of a street of a length (m) that is as wide as its axis says.';

CREATE OR REPLACE FUNCTION streetgen._lane_borders(borders float8[], width float8, axis_offset float8)
    RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(borders, ARRAY[0, width / 2 + axis_offset, width / 2 - axis_offset]);
COMMENT ON FUNCTION streetgen._lane_borders(float8[], float8, float8) IS
    'Borders of a lane as column borders of a section has them, from its columns of these names.';

CREATE OR REPLACE FUNCTION streetgen._roadway_border(axis bytea, borders float8[], abscissa float8,
    abscissa_end float8, side text, axis_offset float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_roadway_border';
COMMENT ON FUNCTION streetgen._roadway_border(bytea, float8[], float8, float8, text, float8) IS
    'The line (LINESTRING) from one abscissa of an axis to another one, so many metres away from the border of its '
    'roadway on a side. NULL where both abscissas are the same.';

CREATE OR REPLACE FUNCTION streetgen._usual_crossing(OUT width float8, OUT angle float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 4.0::float8, 90.0::float8 $$;
COMMENT ON FUNCTION streetgen._usual_crossing() IS
    'Width (m) and angle (degrees) of a crossing of which nothing is said, such as one that a rule places.';

CREATE OR REPLACE FUNCTION streetgen._crossing_ground(axis bytea, borders float8[], abscissa float8, width float8,
    angle float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_crossing_ground';
COMMENT ON FUNCTION streetgen._crossing_ground(bytea, float8[], float8, float8, float8) IS
    'The roadway (POLYGON) under a crossing at an abscissa of an axis, between its borders. Axis and borders go '
    'straight on beyond their ends. NULL where the crossing meets no border.';

CREATE OR REPLACE FUNCTION streetgen._crossing_stripes(axis bytea, borders float8[], abscissa float8, width float8,
    angle float8, marking text) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_crossing_stripes';
COMMENT ON FUNCTION streetgen._crossing_stripes(bytea, float8[], float8, float8, float8, text) IS
    'The paint (MULTIPOLYGON) of such a crossing by its marking: zebra (stripes along the axis), ladder (these between '
    'two lines across), lines, dashes or dots, without what the axis bends too sharply for.';

CREATE OR REPLACE FUNCTION streetgen._crossing_marking_pattern() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '^(zebra|ladder|lines|dashes|dots|surface|yes|no)$';
COMMENT ON FUNCTION streetgen._crossing_marking_pattern() IS
    'The words for the paint of a crossing, as a regular expression: yes is paint of which no more is known.';

CREATE OR REPLACE FUNCTION streetgen._crossing_kerb_pattern() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN '^(raised|lowered|rolled|flush|no)$';
COMMENT ON FUNCTION streetgen._crossing_kerb_pattern() IS
    'The words for the kerbs at both ends of a crossing, as a regular expression.';

CREATE OR REPLACE FUNCTION streetgen._to_border(width float8, width_end float8, length float8, roadway_offset float8,
    borders float8[], abscissa float8, side text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        SELECT CASE WHEN borders IS NOT NULL THEN streetgen._border_at(borders, abscissa, side)
            ELSE (width + (width_end - width) * abscissa / length) / 2
                + CASE side WHEN 'left' THEN roadway_offset ELSE -roadway_offset END END;
    END;
COMMENT ON FUNCTION streetgen._to_border(float8, float8, float8, float8, float8[], float8, text) IS
    'Metres from an axis of a length (m) to the border of its roadway on a side: by column borders of its sections, '
    'else by its width, which changes linearly, and the middle of the roadway, roadway_offset (m) to its left.';

CREATE OR REPLACE FUNCTION streetgen._border_offset(to_border float8, axis_offset float8, side text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        SELECT CASE WHEN side IS NULL THEN axis_offset
            ELSE (to_border + axis_offset) * CASE side WHEN 'left' THEN 1 ELSE -1 END END;
    END;
COMMENT ON FUNCTION streetgen._border_offset(float8, float8, text) IS
    'Metres to the left of an axis: of a distance from its left or right border, away from the roadway, which lies so '
    'many metres from the axis; side NULL: the offset itself.';

CREATE OR REPLACE FUNCTION streetgen.place_on(axis geometry, width float8, abscissa float8, axis_offset float8,
    side text DEFAULT NULL, roadway_offset float8 DEFAULT 0) RETURNS geometry
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE COST 200 SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF num_nulls(axis, width, abscissa, axis_offset, roadway_offset) > 0 THEN
        RETURN NULL;
    ELSIF side NOT IN ('left', 'right') THEN
        RAISE EXCEPTION 'side is "%", expected left or right', side USING ERRCODE = '22023',
            HINT = 'NULL measures axis_offset from the axis.';
    ELSIF width NOT BETWEEN 0.001 AND 200 THEN
        RAISE EXCEPTION 'width is %, expected 0.001 to 200', width USING ERRCODE = '22023';
    ELSIF roadway_offset NOT BETWEEN -100 AND 100 THEN
        RAISE EXCEPTION 'roadway_offset is %, expected -100 to 100', roadway_offset USING ERRCODE = '22023';
    ELSIF abscissa NOT BETWEEN 0 AND ST_Length2D(axis) + 1e-6 THEN
        RAISE EXCEPTION 'abscissa is %, expected 0 to %', abscissa, ST_Length2D(axis) USING ERRCODE = '22023',
            HINT = 'The axis is no longer.';
    END IF;
    RETURN streetgen._place_on(axis::bytea, abscissa,
        streetgen._border_offset(streetgen._to_border(width, width, 1, roadway_offset, NULL, abscissa, side),
            axis_offset, side))::geometry;
END $$;
COMMENT ON FUNCTION streetgen.place_on(geometry, float8, float8, float8, text, float8) IS
    'The place (POINT) beside an axis (LINESTRING, metres) at an abscissa, metres along it. side NULL: axis_offset '
    'metres from the axis along its normal, positive to the left. side left or right: axis_offset metres from that '
    'border of the roadway, positive away from it; the roadway is width metres wide, its middle roadway_offset to the '
    'left of the axis. At a vertex the normal halves the angle of both. An abscissa beyond the axis, a place over '
    '1000 m away, other bad numbers or words: 22023. StreetGen paper, 2.9. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.locate_on(axis geometry, width float8, place geometry,
    roadway_offset float8 DEFAULT 0)
    RETURNS TABLE(abscissa float8, side text, axis_offset float8, border_offset float8)
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE COST 200 ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    found constant float8[] := streetgen._locate_on(axis::bytea, place::bytea);
BEGIN
    IF width NOT BETWEEN 0.001 AND 200 THEN
        RAISE EXCEPTION 'width is %, expected 0.001 to 200', width USING ERRCODE = '22023';
    ELSIF roadway_offset NOT BETWEEN -100 AND 100 THEN
        RAISE EXCEPTION 'roadway_offset is %, expected -100 to 100', roadway_offset USING ERRCODE = '22023';
    END IF;
    abscissa := found[1];
    axis_offset := found[2];
    side := CASE WHEN axis_offset >= roadway_offset THEN 'left' ELSE 'right' END;
    border_offset := abs(axis_offset - roadway_offset) - width / 2;
    RETURN NEXT;
END $$;
COMMENT ON FUNCTION streetgen.locate_on(geometry, float8, geometry, float8) IS
    'Where a place (POINT) lies beside an axis (LINESTRING, metres): abscissa, metres along it, of the nearest place '
    'of the axis, the first of equal ones; side of the middle of the roadway, left or right; axis_offset, metres from '
    'the axis, positive to the left; border_offset, metres from the border of that side, positive away from the '
    'roadway. The inverse of streetgen.place_on, with side and border_offset or with NULL and axis_offset, but for '
    'places nearest to a vertex or an end. Bad geometry or numbers, different SRIDs: 22023. StreetGen paper, 2.9. NULL '
    'for NULL: no row.';
