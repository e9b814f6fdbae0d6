-- The rule of the trajectories is a setting: bezier, arcs, or a function of the user's.

CREATE OR REPLACE FUNCTION streetgen._trajectory(model name, rule text, lane_in geometry, in_along boolean,
    lane_out geometry, out_along boolean, centre geometry, control geometry, tolerance float8) RETURNS geometry
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE COST 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    lane_from constant geometry := CASE WHEN in_along THEN lane_in ELSE ST_Reverse(lane_in) END;
    lane_to constant geometry := CASE WHEN out_along THEN lane_out ELSE ST_Reverse(lane_out) END;
    path geometry;
BEGIN
    IF control IS NOT NULL THEN
        RETURN streetgen.interconnection(lane_from, lane_to, control, 'control', tolerance);
    END IF;
    EXECUTE format('SELECT %s($1, $2, $3, $4)', streetgen._called_function(model, 'trajectory', rule)) INTO path
        USING lane_from, lane_to, ST_Force2D(centre), tolerance;
    IF (GeometryType(path) = 'LINESTRING' AND ST_SRID(path) = ST_SRID(lane_in) AND NOT ST_IsEmpty(path)
        AND ST_Length(path) < 'Infinity') IS NOT TRUE THEN
        PERFORM streetgen._refuse('22023',
            format('trajectory function %s gave %s, expected a LINESTRING of SRID %s', rule,
                coalesce(left(ST_AsEWKT(path), 100), 'NULL'), ST_SRID(lane_in)),
            detail => format('From lane %s to lane %s.', ST_AsText(lane_from, 2), ST_AsText(lane_to, 2)),
            hint => 'Mend the function, or set the trajectory to bezier or arcs.');
    END IF;
    RETURN ST_Force2D(path);
END $$;
COMMENT ON FUNCTION streetgen._trajectory(name, text, geometry, boolean, geometry, boolean, geometry, geometry,
    float8) IS
    'The path between two lanes (in the point order of their axes) with a control point of the user''s, else by the '
    'function of the user''s that the setting names, as _called_function has it. Another result than a line: '
    '22023.';
