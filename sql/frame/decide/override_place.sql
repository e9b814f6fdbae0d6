-- The place of an override beside axes, as they were and as they are.

CREATE OR REPLACE FUNCTION streetgen._heading(line geometry, place geometry) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Azimuth(ST_LineInterpolatePoint(line, greatest(at - step, 0)),
        ST_LineInterpolatePoint(line, least(at + step, 1)))
    FROM (SELECT ST_LineLocatePoint(line, place) AS at, 0.1 / greatest(ST_Length2D(line), 0.1) AS step) s
    $$;
COMMENT ON FUNCTION streetgen._heading(geometry, geometry) IS
    'Azimuth (radians) of a line where it is nearest to a place, over 0.1 m to either side.';

CREATE OR REPLACE FUNCTION streetgen._remap_runs_against(heading float8, line geometry, place geometry)
    RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT coalesce(cos(heading - streetgen._heading(line, place)) < 0, false) $$;
COMMENT ON FUNCTION streetgen._remap_runs_against(float8, geometry, geometry) IS
    'Whether a line runs against a heading (azimuth, radians) at a place; false where one is NULL.';

CREATE OR REPLACE FUNCTION streetgen._remap_joins_against(line geometry, piece geometry, slack float8)
    RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT (ST_DWithin(ST_EndPoint(line), ST_EndPoint(piece), slack)
            OR ST_DWithin(ST_StartPoint(line), ST_StartPoint(piece), slack))
        AND NOT ST_DWithin(ST_EndPoint(line), ST_StartPoint(piece), slack)
        AND NOT ST_DWithin(ST_StartPoint(line), ST_EndPoint(piece), slack)
    $$;
COMMENT ON FUNCTION streetgen._remap_joins_against(geometry, geometry, float8) IS
    'Whether a piece that goes on where a line was cut runs against it, as their ends say.';

CREATE OR REPLACE FUNCTION streetgen._swapped(word text, one text, other text, swap boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN NOT swap THEN word WHEN word = one THEN other WHEN word = other THEN one ELSE word END;
COMMENT ON FUNCTION streetgen._swapped(text, text, text, boolean) IS
    'One of two words in place of the other, where asked for, as of the sides of an axis that is turned round; any '
    'other word as it is.';

CREATE OR REPLACE FUNCTION streetgen._end_of(line geometry, which text) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE which WHEN 'start' THEN ST_StartPoint(line) ELSE ST_EndPoint(line) END $$;
COMMENT ON FUNCTION streetgen._end_of(geometry, text) IS 'The start or the end of a line.';

CREATE OR REPLACE FUNCTION streetgen._moved_vertex(before geometry, after geometry, place geometry, reach float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- A vertex that stays keeps its place, also where the line is turned round or has vertices more and less.
    SELECT coalesce((SELECT geom FROM ST_DumpPoints(after) v WHERE ST_DWithin(geom, place, reach)
            ORDER BY ST_Distance(geom, place) LIMIT 1),
        CASE WHEN ST_DWithin(ST_StartPoint(before), place, reach) THEN ST_StartPoint(after)
            WHEN ST_DWithin(ST_EndPoint(before), place, reach) THEN ST_EndPoint(after)
            WHEN ST_NPoints(before) = ST_NPoints(after)
            THEN (SELECT ST_PointN(after, v.path[1]) FROM ST_DumpPoints(before) v
                WHERE ST_DWithin(v.geom, place, reach) ORDER BY ST_Distance(v.geom, place) LIMIT 1) END)
    $$;
COMMENT ON FUNCTION streetgen._moved_vertex(geometry, geometry, geometry, float8) IS
    'Where the vertex of a line that was within reach of a place is now; NULL where nothing says so.';

CREATE OR REPLACE FUNCTION streetgen._remap_is_cut_back(before geometry, after geometry, slack float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Length2D(after) < ST_Length2D(before) AND NOT EXISTS (SELECT FROM ST_DumpPoints(after) v
        WHERE NOT ST_DWithin(v.geom, before, slack)) $$;
COMMENT ON FUNCTION streetgen._remap_is_cut_back(geometry, geometry, float8) IS
    'Whether a line is a piece of what it was, as the first half of a split is.';

CREATE OR REPLACE FUNCTION streetgen._remap_point_beside(line geometry, place geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_LineInterpolatePoint(line, CASE WHEN at < 0.5 THEN least(at + step, 1) ELSE greatest(at - step, 0) END)
    FROM (SELECT ST_LineLocatePoint(line, place) AS at, 5 / greatest(ST_Length2D(line), 5) AS step) s
    $$;
COMMENT ON FUNCTION streetgen._remap_point_beside(geometry, geometry) IS
    'The place on a line 5 m along it from another, towards its farther end.';

CREATE OR REPLACE FUNCTION streetgen._remap_leaves(line geometry, place geometry, reach float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_DWithin(ST_StartPoint(line), place, reach) OR ST_DWithin(ST_EndPoint(line), place, reach)
        THEN ST_Azimuth(ST_ClosestPoint(line, place), streetgen._remap_point_beside(line, place)) END
    $$;
COMMENT ON FUNCTION streetgen._remap_leaves(geometry, geometry, float8) IS
    'Azimuth (radians) in which a line leads away from a place at its end, over 5 m; NULL: it goes on there.';

CREATE OR REPLACE FUNCTION streetgen._remap_part_of_axis(anchor text, line geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE anchor WHEN 'end' THEN ST_Collect(ST_StartPoint(line), ST_EndPoint(line))
        ELSE line END $$;
COMMENT ON FUNCTION streetgen._remap_part_of_axis(text, geometry) IS
    'What of an axis a decision with that anchor lies at: its ends or all of it.';

CREATE OR REPLACE FUNCTION streetgen._remap_lies_beside(line geometry, place geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT at > 0 AND at < 1 FROM (SELECT ST_LineLocatePoint(line, place) AS at) l $$;
COMMENT ON FUNCTION streetgen._remap_lies_beside(geometry, geometry) IS
    'Whether a place lies beside a line and not beyond its ends.';

CREATE OR REPLACE FUNCTION streetgen._metres_beyond(line geometry, place geometry) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN at > 0 AND at < 1 THEN 0 ELSE greatest(0,
        ST_Distance(foot, place) * cos(ST_Azimuth(inside, foot) - ST_Azimuth(foot, place))) END
    FROM (SELECT ST_LineLocatePoint(line, place) AS at) l, ST_LineInterpolatePoint(line, at) foot,
        streetgen._remap_point_beside(line, foot) inside
    $$;
COMMENT ON FUNCTION streetgen._metres_beyond(geometry, geometry) IS
    'How far (metres) a place lies beyond the nearer end of a line, along the last 5 m of it; 0 beside the line.';

CREATE OR REPLACE FUNCTION streetgen._remap_lies_along(before geometry, line geometry, place geometry, slack float8)
    RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- A stretch of less than twice the slack may be the end of a street that meets the line.
    SELECT coalesce(bool_or(stretch.length >= 2 * slack AND NOT EXISTS (
        SELECT FROM ST_DumpPoints(ST_LineSubstring(line, stretch.start, stretch.start + stretch.length / whole)) v
        WHERE NOT ST_DWithin(v.geom, before, slack))), false)
    FROM (SELECT ST_LineLocatePoint(line, place) AS at, ST_Length2D(line) AS whole) l,
        LATERAL (VALUES (greatest(at - 5 / whole, 0), least(5, at * whole)),
            (at, least(5, (1 - at) * whole))) stretch(start, length)
    $$;
COMMENT ON FUNCTION streetgen._remap_lies_along(geometry, geometry, geometry, float8) IS
    'Whether a line, 5 m back or on from a place or to its end, lies along another line.';

CREATE OR REPLACE FUNCTION streetgen._remap_comes_by(anchor text, before geometry, after geometry, place geometry,
    reach float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_DWithin(streetgen._remap_part_of_axis(anchor, before), place, reach) IS NOT TRUE
        OR anchor NOT IN ('end', 'node', 'via')
            AND streetgen._remap_lies_beside(after, place) AND NOT streetgen._remap_lies_beside(before, place)
    $$;
COMMENT ON FUNCTION streetgen._remap_comes_by(text, geometry, geometry, geometry, float8) IS
    'Whether an axis that lies at the place of an override did not before (NULL: was not there), or ended beside it.';

CREATE OR REPLACE FUNCTION streetgen._edge_at(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT e.edge_id FROM edge e WHERE e.axis_id = axis ORDER BY ST_Distance(e.geom, place), e.edge_id LIMIT 1);
END $$;
COMMENT ON FUNCTION streetgen._edge_at(name, bigint, geometry) IS
    'Of the edges of an axis the nearest to a place; NULL where the axis has none.';
