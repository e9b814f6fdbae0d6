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
        of_level constant integer := (SELECT level FROM axis a WHERE a.axis_id = axis);
        middle float8;
        room float8;
        place float8;
        run float8;
        island geometry;
        ground geometry;
    BEGIN
        IF line IS NULL OR coalesce(wanted, 0) = 0 OR to_regclass('lane') IS NULL THEN
            RETURN NULL;
        END IF;
        -- A refuge lies between the lanes of both directions, as far as these can be narrower.
        SELECT (low + high) / 2, high - low + 2 * least(room_right, room_left) INTO middle, room
        FROM (SELECT max(left_offset) FILTER (WHERE on_right) AS low,
                min(right_offset) FILTER (WHERE NOT on_right) AS high,
                sum(spare) FILTER (WHERE on_right) AS room_right, sum(spare) FILTER (WHERE NOT on_right) AS room_left
            FROM (SELECT l.left_offset, l.right_offset, CASE WHEN l.kind IN ('general', 'bus', 'carpool')
                        THEN greatest(l.left_offset - l.right_offset - lane_least, 0) ELSE 0 END AS spare,
                    avg(l.left_offset) OVER (PARTITION BY l.along_axis) < avg(l.left_offset) OVER () AS on_right
                FROM (SELECT l.kind, l.along_axis, streetgen._border_at(b.borders, e.at, 'left') AS left_offset,
                        -streetgen._border_at(b.borders, e.at, 'right') AS right_offset
                    FROM (SELECT edge_id, _refuge.abscissa - start_abscissa AS at FROM edge e WHERE e.axis_id = axis
                            AND _refuge.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
                        ORDER BY start_abscissa LIMIT 1) e
                        JOIN lane l ON l.edge_id = e.edge_id AND l.kind <> 'merging' AND NOT l.both_ways,
                        LATERAL (SELECT coalesce(l.borders, ARRAY[0, l.width / 2 + l.axis_offset,
                            l.width / 2 - l.axis_offset]) AS borders) b) l) o) s
        WHERE high > low - 0.01;
        room := least(wanted, room);
        IF coalesce(room, 0) < least_width THEN
            RETURN NULL;
        END IF;
        -- A source may cut its way at the crossing: the refuge runs straight, beyond the end of its axis too.
        place := least(greatest(_refuge.abscissa + middle * cotd(angle), 0), ST_Length2D(line));
        run := greatest(_refuge.width / 2 + nose - room / 2, 0.1);
        SELECT ST_Buffer(ST_SetSRID(ST_MakeLine(ST_Translate(at, -east * run, -north * run),
            ST_Translate(at, east * run, north * run)), ST_SRID(line)), room / 2) INTO island
        FROM (SELECT streetgen._place_on(line::bytea, place, middle)::geometry AS at,
            streetgen._direction_on(line::bytea, place, 0) AS direction) p,
            LATERAL (SELECT sind(direction) AS east, cosd(direction) AS north) d;
        SELECT ST_Union(surface) INTO ground FROM (
            SELECT surface FROM section s JOIN edge e USING (edge_id) WHERE s.surface && island AND e.level = of_level
            UNION ALL SELECT surface FROM intersection i WHERE i.surface && island AND i.level = of_level) g;
        RETURN CASE WHEN ST_Covers(ground, island) THEN island END;
    END $body$;
    PERFORM streetgen._own_function(model, '_refuge(bigint, geometry, float8, float8, float8, float8)',
        'The refuge (POLYGON) of a crossing that is to have one so wide: between the lanes of both directions, as wide '
        'as lanes of 2.5 m leave it, and 1.5 m longer than the crossing at both ends. NULL: without lanes, in a '
        'one-way street, on a lane for both directions, where it would be narrower than 1 m, or not all on the '
        'roadway');
END $$;
COMMENT ON FUNCTION streetgen._make_refuge_function(name) IS
    'Makes the function of a model that lays the refuge of a crossing.';
