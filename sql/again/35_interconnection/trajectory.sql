-- The rule of the trajectories is a setting: bezier, arcs, or a function of the user's.

CREATE OR REPLACE FUNCTION streetgen._trajectory_function(rule text) RETURNS regprocedure
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT p.oid FROM pg_proc p WHERE p.oid = to_regprocedure(rule || '(geometry, geometry, geometry, float8)')
        AND p.prorettype = 'geometry'::regtype AND NOT p.proretset $$;
COMMENT ON FUNCTION streetgen._trajectory_function(text) IS
    'The function of that name, with its schema unless in public, of the signature of a trajectory rule: (lane_in '
    'geometry, lane_out geometry, centre geometry, tolerance float8) returning geometry; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._trajectory(rule text, lane_in geometry, in_along boolean, lane_out geometry,
    out_along boolean, centre geometry, control geometry, tolerance float8) RETURNS geometry
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE COST 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    lane_from constant geometry := CASE WHEN in_along THEN lane_in ELSE ST_Reverse(lane_in) END;
    lane_to constant geometry := CASE WHEN out_along THEN lane_out ELSE ST_Reverse(lane_out) END;
    rule_function regprocedure;
    path geometry;
BEGIN
    IF control IS NOT NULL THEN
        RETURN streetgen.interconnection(lane_from, lane_to, control, 'control', tolerance);
    END IF;
    rule_function := streetgen._trajectory_function(rule);
    IF rule_function IS NULL THEN
        RAISE EXCEPTION 'trajectory function % is gone', rule USING ERRCODE = '42883',
            HINT = 'Make it again, or set the trajectory to bezier or arcs.';
    END IF;
    EXECUTE format('SELECT %s($1, $2, $3, $4)', rule_function::regproc) INTO path USING lane_from, lane_to,
        ST_Force2D(centre), tolerance;
    IF (GeometryType(path) = 'LINESTRING' AND ST_SRID(path) = ST_SRID(lane_in) AND NOT ST_IsEmpty(path)
        AND ST_Length(path) < 'Infinity') IS NOT TRUE THEN
        RAISE EXCEPTION 'trajectory function % gave %, expected a LINESTRING of SRID %', rule,
            coalesce(left(ST_AsEWKT(path), 100), 'NULL'), ST_SRID(lane_in) USING ERRCODE = '22023',
            DETAIL = format('From lane %s to lane %s.', ST_AsText(lane_from, 2), ST_AsText(lane_to, 2)),
                HINT = 'Mend the function, or set the trajectory to bezier or arcs.';
    END IF;
    RETURN ST_Force2D(path);
END $$;
COMMENT ON FUNCTION streetgen._trajectory(text, geometry, boolean, geometry, boolean, geometry, geometry, float8) IS
    'The path between two lanes (in the point order of their axes) with a control point of the user''s, else by the '
    'function of the user''s that the setting names. A function that is gone: 42883; another result than a line: '
    '22023.';
