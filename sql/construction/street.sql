-- The constructions, usable alone. A private twin of each takes and gives EWKB.

CREATE OR REPLACE FUNCTION streetgen._arc_centre(bytea, bytea, float8, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_arc_centre';
COMMENT ON FUNCTION streetgen._arc_centre(bytea, bytea, float8, float8, float8) IS 'EWKB twin of streetgen.arc_centre';
CREATE OR REPLACE FUNCTION streetgen.arc_centre(axis_a geometry, axis_b geometry, width_a float8, width_b float8,
    radius float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._arc_centre(axis_a::bytea, axis_b::bytea, width_a, width_b, radius)::geometry $$;
COMMENT ON FUNCTION streetgen.arc_centre(geometry, geometry, float8, float8, float8) IS
    'Centre (POINT) of the circle of the given radius that touches the left border of a and the right border of b, '
    'the first on the way out from the node along both. Both axes (LINESTRING, metres) start at the node; the corner '
    'lies counter-clockwise from a to b. Widths are kerb to kerb, up to 200 m. Bad geometry or numbers: 22023. NULL '
    'where the offset borders do not meet. StreetGen paper, 2.4. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._corner_arc(bytea, bytea, float8, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_corner_arc';
COMMENT ON FUNCTION streetgen._corner_arc(bytea, bytea, float8, float8, float8) IS 'EWKB twin of streetgen.corner_arc';
CREATE OR REPLACE FUNCTION streetgen.corner_arc(axis_a geometry, axis_b geometry, width_a float8, width_b float8,
    radius float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._corner_arc(axis_a::bytea, axis_b::bytea, width_a, width_b, radius)::geometry $$;
COMMENT ON FUNCTION streetgen.corner_arc(geometry, geometry, float8, float8, float8) IS
    'The arc of that circle (CIRCULARSTRING) from the border of a to the border of b. Both axes (LINESTRING, metres) '
    'start at the node; the corner lies counter-clockwise from a to b. Widths are kerb to kerb, up to 200 m. Bad '
    'geometry or numbers: 22023. NULL as arc_centre. StreetGen paper, 2.5. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._max_corner_radius(bytea, bytea, float8, float8) RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_max_corner_radius';
COMMENT ON FUNCTION streetgen._max_corner_radius(bytea, bytea, float8, float8) IS
    'EWKB twin of streetgen.max_corner_radius';
CREATE OR REPLACE FUNCTION streetgen.max_corner_radius(axis_a geometry, axis_b geometry, width_a float8,
    width_b float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._max_corner_radius(axis_a::bytea, axis_b::bytea, width_a, width_b) $$;
COMMENT ON FUNCTION streetgen.max_corner_radius(geometry, geometry, float8, float8) IS
    'The largest radius, up to 1000 m, whose arc touches both axes within their lengths, to 1e-6 m. Both axes '
    '(LINESTRING, metres) start at the node; the corner lies counter-clockwise from a to b. Widths are kerb to kerb, '
    'up to 200 m. Bad geometry or numbers: 22023. NULL where not even radius 0 does. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._border_line(bytea, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_border_line';
COMMENT ON FUNCTION streetgen._border_line(bytea, float8, float8) IS 'EWKB twin of streetgen.border_line';
CREATE OR REPLACE FUNCTION streetgen.border_line(axis geometry, abscissa float8, width float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._border_line(axis::bytea, abscissa, width)::geometry $$;
COMMENT ON FUNCTION streetgen.border_line(geometry, float8, float8) IS
    'The line (LINESTRING) across the axis at an abscissa (metres, clamped to the axis), from the left to the right '
    'kerb, normal to the axis between 0.1 m before and after. Width kerb to kerb, 0.001 to 200 m. Bad geometry or '
    'numbers: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._section_surface(bytea, float8, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_section_surface';
COMMENT ON FUNCTION streetgen._section_surface(bytea, float8, float8, float8) IS
    'EWKB twin of streetgen.section_surface';
CREATE OR REPLACE FUNCTION streetgen.section_surface(axis geometry, width float8, start_abscissa float8,
    end_abscissa float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._section_surface(axis::bytea, width, start_abscissa, end_abscissa)::geometry $$;
COMMENT ON FUNCTION streetgen.section_surface(geometry, float8, float8, float8) IS
    'The roadway (POLYGON) of an axis between two abscissas (metres, clamped to the axis): flat ends, round outer '
    'bends, mitred inner ones. Width kerb to kerb, 0.001 to 200 m. Empty where the abscissas cross. Bad geometry or '
    'numbers: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._offset_line(bytea, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_offset_line';
COMMENT ON FUNCTION streetgen._offset_line(bytea, float8, float8) IS 'EWKB twin of streetgen.offset_line';
CREATE OR REPLACE FUNCTION streetgen.offset_line(axis geometry, axis_offset float8, offset_end float8 DEFAULT NULL)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._offset_line(axis::bytea, axis_offset, coalesce(offset_end, axis_offset))::geometry $$;
COMMENT ON FUNCTION streetgen.offset_line(geometry, float8, float8) IS
    'The line (LINESTRING, in the point order of the axis) at an offset, metres to the left of the axis (negative: to '
    'the right, up to 200), changing linearly to offset_end: mitred in inner bends, round about outer ones, without '
    'the loops of bends tighter than the offset. Bad geometry or numbers: 22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._lanes(axis bytea, width float8, width_end float8, lanes_forward integer,
    lanes_backward integer, kind_forward text, kind_backward text, lane_width_forward text, lane_width_backward text,
    lane_order text, driving_side text, lanes_both integer)
    RETURNS TABLE(ordinality integer, lane_position integer, side text, along_axis boolean, both_ways boolean,
        kind text, lane_width float8, axis_offset float8, geom bytea, surface bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 4 AS 'MODULE_PATHNAME', 'streetgen_lanes';
COMMENT ON FUNCTION streetgen._lanes(bytea, float8, float8, integer, integer, text, text, text, text, text, text,
    integer) IS
    'EWKB twin of streetgen.lanes';
CREATE OR REPLACE FUNCTION streetgen.lanes(axis geometry, width float8, lanes_forward integer DEFAULT 1,
    lanes_backward integer DEFAULT 1, kind_forward text DEFAULT '', kind_backward text DEFAULT '',
        lane_width_forward text DEFAULT '', lane_width_backward text DEFAULT '', width_end float8 DEFAULT NULL,
            lane_order text DEFAULT 'left_first', driving_side text DEFAULT 'right', lanes_both integer DEFAULT 0)
    RETURNS TABLE(ordinality integer, lane_position integer, side text, along_axis boolean, both_ways boolean,
        kind text, lane_width float8, axis_offset float8,
        geom geometry, surface geometry)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE COST 1000 ROWS 4
    SET search_path = pg_catalog, public
    AS $$ SELECT l.ordinality, l.lane_position, l.side, l.along_axis, l.both_ways, l.kind, l.lane_width, l.axis_offset,
        l.geom::geometry, l.surface::geometry
          FROM streetgen._lanes(axis::bytea, width, coalesce(width_end, width), lanes_forward, lanes_backward,
              kind_forward, kind_backward, lane_width_forward, lane_width_backward, lane_order, driving_side,
              lanes_both) l $$;
COMMENT ON FUNCTION streetgen.lanes(geometry, float8, integer, integer, text, text, text, text, float8, text, text,
    integer) IS
    'The lanes of an axis (LINESTRING) of a width in metres kerb to kerb, from the left kerb to the right one: counts '
    'along and against it and, between them, of lanes that both directions use (lanes_both), or lists of kinds and '
    'widths as in axis.kind_forward and axis.lane_width_forward; no lane at all: one along it. lane_width and '
    'axis_offset (metres to the left of the axis) hold at its start; geom in its point order; the surfaces '
    '(MULTIPOLYGON) tile the roadway. Bad geometry, numbers or words, widths for another number of lanes: 22023; '
    'NULL for anything but width_end: no row. StreetGen paper, 2.5 and 2.7.2.';

CREATE OR REPLACE FUNCTION streetgen._clean(bytea, boolean[], float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_clean';
COMMENT ON FUNCTION streetgen._clean(bytea, boolean[], float8, float8) IS 'EWKB twin of streetgen.clean';
CREATE OR REPLACE FUNCTION streetgen.clean(line geometry, keep boolean[], epsilon float8, r_min float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._clean(line::bytea, keep, epsilon, r_min)::geometry $$;
COMMENT ON FUNCTION streetgen.clean(geometry, boolean[], float8, float8) IS
    'Removes points nearer than epsilon to the last kept one, collinear ones (within 1 mm of the chord that replaces '
    'them), then those where r_min tan(theta / 2) exceeds half of a neighbouring segment; never an end, nor a point '
    'whose keep is true (empty: none), nor what would fold a closed line flat. Metres. A keep of another length, an '
    'epsilon or r_min beyond 0 to 1000: 22023. GIS data to functional road models, 3.4. A line that is no LINESTRING: '
    '22023. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._intersection_surface(bytea[], float8[], float8[], boolean) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500 AS 'MODULE_PATHNAME', 'streetgen_intersection_surface';
COMMENT ON FUNCTION streetgen._intersection_surface(bytea[], float8[], float8[], boolean) IS
    'EWKB twin of streetgen.intersection_surface';
CREATE OR REPLACE FUNCTION streetgen.intersection_surface(axes geometry[], widths float8[], radii float8[],
    curved boolean DEFAULT false) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 500
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._intersection_surface(ARRAY(SELECT axis::bytea FROM unnest(axes) WITH ORDINALITY
        AS t(axis, i) ORDER BY i), widths, radii, curved)::geometry $$;
COMMENT ON FUNCTION streetgen.intersection_surface(geometry[], float8[], float8[], boolean) IS
    'The intersection (POLYGON) of axes that start at one node, in any order; radii[i] (0 to 1000 m) belongs to the '
    'corner from axes[i] to the next axis counter-clockwise. curved: a CURVEPOLYGON with true arcs, where the outline '
    'can be built piece by piece. Lists of different length, bad geometry or numbers: 22023. NULL for NULL.';
CREATE OR REPLACE FUNCTION streetgen._variable_buffer(bytea, float8[], text, text) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 500 AS 'MODULE_PATHNAME', 'streetgen_variable_buffer';
COMMENT ON FUNCTION streetgen._variable_buffer(bytea, float8[], text, text) IS 'EWKB twin of streetgen.variable_buffer';
CREATE OR REPLACE FUNCTION streetgen.variable_buffer(line geometry, radii float8[], side text DEFAULT 'both',
    ends text DEFAULT 'flat') RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 500
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._variable_buffer(line::bytea, radii, side, ends)::geometry $$;
COMMENT ON FUNCTION streetgen.variable_buffer(geometry, float8[], text, text) IS
    'The roadway about a line whose half width is linear between vertices (radii, 0 to 1000 m, one a vertex); side '
    'both, left or right; ends flat or round. Bad geometry, numbers or words, radii for another number of vertices: '
    '22023. StreetGen paper, figure 11. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._offset_strip(bytea, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200 AS 'MODULE_PATHNAME', 'streetgen_offset_strip';
COMMENT ON FUNCTION streetgen._offset_strip(bytea, float8, float8) IS 'EWKB twin of streetgen.offset_strip';
CREATE OR REPLACE FUNCTION streetgen.offset_strip(kerb geometry, width_start float8, width_end float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 200
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._offset_strip(kerb::bytea, width_start, width_end)::geometry $$;
COMMENT ON FUNCTION streetgen.offset_strip(geometry, float8, float8) IS
    'The strip (POLYGON) on the left of a kerb, a LINESTRING, CIRCULARSTRING or COMPOUNDCURVE in metres with the '
    'roadway on its right, as in table kerb. The width, 0 to 200 m, changes linearly from the start of the kerb to '
    'the end. Round about outer bends, flat at both ends; arcs become chords within 1 mm. Empty where both widths '
    'are 0; a MULTIPOLYGON where a strip that narrows to nothing comes apart. Bad geometry or numbers: 22023. NULL '
    'for NULL.';

CREATE OR REPLACE FUNCTION streetgen._crossing_surface(bytea, bytea, bytea, float8, float8, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 200 AS 'MODULE_PATHNAME', 'streetgen_crossing_surface';
COMMENT ON FUNCTION streetgen._crossing_surface(bytea, bytea, bytea, float8, float8, float8) IS
    'EWKB twin of streetgen.crossing_surface';
CREATE OR REPLACE FUNCTION streetgen.crossing_surface(axis geometry, kerb_left geometry, kerb_right geometry,
    abscissa float8, width float8, angle float8 DEFAULT 90) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 200
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._crossing_surface(axis::bytea, kerb_left::bytea, kerb_right::bytea, abscissa, width,
        angle)::geometry $$;
COMMENT ON FUNCTION streetgen.crossing_surface(geometry, geometry, geometry, float8, float8, float8) IS
    'The roadway (POLYGON) under a pedestrian crossing about the place of the axis (LINESTRING, metres) at an '
    'abscissa (clamped to the axis). width: between its parallel borders, 0.1 to 100 m. angle: degrees counter-'
    'clockwise from the direction of the axis to the way across, 10 to 170; 90 is square. Both borders go left and '
    'right from the axis to the kerbs (LINESTRING, CIRCULARSTRING or COMPOUNDCURVE in either direction), which are '
    'followed between them: arcs as chords within 1 mm, cut straight where a kerb goes farther than a width beyond '
    'the borders. NULL where a border meets no kerb within ten widths. Bad geometry or numbers, different SRIDs: '
    '22023. StreetGen paper, figure 22. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.turning_radius(
    speed float8, width float8, mode text DEFAULT 'paper', minimal float8 DEFAULT 0.15, maximal float8 DEFAULT 15)
        RETURNS float8
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_turning_radius';
COMMENT ON FUNCTION streetgen.turning_radius(float8, float8, text, float8, float8) IS
    'Corner radius in metres, from minimal to maximal, of a speed in km/h and a width in metres, kerb to kerb. mode '
    'paper: equation 1 of the StreetGen paper; setra: the law it comes from. Another mode, or a number out of its '
    'range (bounds: 0 to 1000 m, minimal first): 22023. NULL for NULL.';
CREATE OR REPLACE FUNCTION streetgen._interconnection(bytea, bytea, bytea, text, float8) RETURNS bytea
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 AS 'MODULE_PATHNAME', 'streetgen_interconnection';
COMMENT ON FUNCTION streetgen._interconnection(bytea, bytea, bytea, text, float8) IS
    'EWKB twin of streetgen.interconnection';
CREATE OR REPLACE FUNCTION streetgen.interconnection(lane_in geometry, lane_out geometry, centre geometry,
    rule text DEFAULT 'bezier', tolerance float8 DEFAULT 0.05) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 100
    SET search_path = pg_catalog, public
    AS $$ SELECT streetgen._interconnection(lane_in::bytea, lane_out::bytea, centre::bytea, rule,
        tolerance)::geometry $$;
COMMENT ON FUNCTION streetgen.interconnection(geometry, geometry, geometry, text, float8) IS
    'Path (LINESTRING) from the end of lane_in to the start of lane_out, both LINESTRINGs in their driving direction; '
    'centre (POINT) is that of the intersection. rule bezier: the paper''s quadratic curve; arcs: arcs tangent to '
    'both lanes; control: the quadratic curve whose control point is centre. Its chords leave the curve by at most '
    'the tolerance, 0.001 to 10 m; ends are exact. Lanes that touch: a line of two equal points. Bad geometry or '
    'numbers: 22023. StreetGen paper, 2.7.3. NULL for NULL.';
