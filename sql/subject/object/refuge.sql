-- Refuges: islands in the roadway on which people wait who cross it.

CREATE OR REPLACE FUNCTION streetgen._make_refuge_function(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _refuge(axis bigint, line geometry, abscissa float8, width float8, angle float8,
            wanted float8) RETURNS geometry
        LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    DECLARE
        -- Cars pass it on lanes so wide. It reaches so far beyond the crossing, and is so wide at least; metres.
        lane_least constant float8 := 2.5;
        nose constant float8 := 1.5;
        least_width constant float8 := 1;
        middle float8;
        room float8;
        place float8;
        run float8;
        island geometry;
        ground geometry;
    BEGIN
        IF coalesce(wanted, 0) = 0 OR to_regclass('lane') IS NULL THEN
            RETURN NULL;
        END IF;
        -- Between the lanes of both directions, as far as these can be narrower. What lies between them is free.
        SELECT (low + high) / 2, high - low + 2 * least(room_right, room_left) INTO middle, room
        FROM (SELECT max(axis_offset + width / 2) FILTER (WHERE on_right) AS low,
                min(axis_offset - width / 2) FILTER (WHERE NOT on_right) AS high,
                sum(spare) FILTER (WHERE on_right) AS room_right, sum(spare) FILTER (WHERE NOT on_right) AS room_left
            FROM (SELECT l.axis_offset, l.width, CASE WHEN l.kind IN ('general', 'bus', 'carpool')
                        THEN greatest(l.width - lane_least, 0) ELSE 0 END AS spare,
                    avg(l.axis_offset) OVER (PARTITION BY l.along_axis) < avg(l.axis_offset) OVER () AS on_right
                FROM edge e JOIN lane l ON l.edge_id = e.edge_id AND l.kind <> 'merging' AND NOT l.both_ways
                WHERE e.axis_id = axis AND _refuge.abscissa BETWEEN e.start_abscissa AND e.end_abscissa) l) s
        WHERE high > low - 0.01;
        IF coalesce(least(wanted, room), 0) < least_width THEN
            RETURN NULL;
        END IF;
        room := least(wanted, room);
        place := _refuge.abscissa + middle * cotd(angle);
        run := greatest(_refuge.width / 2 + nose - room / 2, 0.1);
        IF place - run < 0 OR place + run > ST_Length2D(line) THEN
            RETURN NULL;
        END IF;
        island := ST_Buffer(ST_SetSRID(ST_MakeLine(ARRAY(SELECT streetgen._place_on(line::bytea, place + along * run,
            middle)::geometry FROM generate_series(-1, 1) along ORDER BY along)), ST_SRID(line)), room / 2);
        SELECT ST_Union(surface) INTO ground FROM (
            SELECT surface FROM section WHERE surface && island AND edge_id IN (SELECT edge_id FROM edge e
                WHERE e.axis_id = axis)
            UNION ALL SELECT i.surface FROM intersection i JOIN edge e ON i.node_id IN (e.from_node, e.to_node)
                WHERE e.axis_id = axis AND i.surface && island) g;
        RETURN CASE WHEN ST_Covers(ground, island) THEN island END;
    END $body$;
    PERFORM streetgen._own_function(model, '_refuge(bigint, geometry, float8, float8, float8, float8)',
        'The refuge (POLYGON) of a crossing that is to have one so wide: between the lanes of both directions, as wide '
        'as lanes of 2.5 m leave it, and 1.5 m longer than the crossing at both ends. NULL: without lanes, in a '
        'one-way street, where it would be narrower than 1 m, or not all on the roadway');
END $$;
COMMENT ON FUNCTION streetgen._make_refuge_function(name) IS
    'Makes the function of a model that lays the refuge of a crossing.';
