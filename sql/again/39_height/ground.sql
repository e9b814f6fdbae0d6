-- What heights start from: the ground along edges, and heights by hand.

CREATE OR REPLACE FUNCTION streetgen._ground_line(line geometry, from_place geometry, to_place geometry)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN ST_NDims(line) = 2 THEN line
        ELSE ST_SetPoint(ST_SetPoint(line, 0, from_place), -1, to_place) END $$;
COMMENT ON FUNCTION streetgen._ground_line(geometry, geometry, geometry) IS
    'The ground along an edge: its line, at its ends the places of its nodes, at which edges have one height.';

CREATE OR REPLACE FUNCTION streetgen._terrain_line(model name, line geometry, from_place geometry, to_place geometry)
    RETURNS geometry
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH point AS MATERIALIZED (SELECT path[1] AS n, geom, path[1] = 1 AS first, path[1] = count(*) OVER () AS last,
            count(*) OVER () AS points
        FROM ST_DumpPoints(ST_Segmentize(ST_Force2D(line), 10))),
    asked AS MATERIALIZED (SELECT streetgen._ground_heights(streetgen._tiles_of(model, line),
        array_agg(ST_X(geom) ORDER BY n), array_agg(ST_Y(geom) ORDER BY n)) AS heights FROM point),
    known AS MATERIALIZED (SELECT p.n, p.geom, CASE
            WHEN p.first THEN coalesce(nullif(ST_Z(from_place), 0), nullif(h.z, 'NaN'), 0)
            WHEN p.last THEN coalesce(nullif(ST_Z(to_place), 0), nullif(h.z, 'NaN'), 0)
            ELSE nullif(h.z, 'NaN') END AS z
        FROM point p JOIN (SELECT z, n FROM asked, unnest(heights) WITH ORDINALITY u(z, n)) h USING (n))
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(k.geom), ST_Y(k.geom), coalesce(k.z, b.z + (a.z - b.z)
            * ((k.n - b.n)::float8 / (a.n - b.n)))) ORDER BY k.n), ST_SRID(line))
    FROM known k
        LEFT JOIN LATERAL (SELECT n, z FROM known o WHERE k.z IS NULL AND o.n < k.n AND o.z IS NOT NULL
            ORDER BY o.n DESC LIMIT 1) b ON true
        LEFT JOIN LATERAL (SELECT n, z FROM known o WHERE k.z IS NULL AND o.n > k.n AND o.z IS NOT NULL
            ORDER BY o.n LIMIT 1) a ON true $$;
COMMENT ON FUNCTION streetgen._terrain_line(name, geometry, geometry, geometry) IS
    'The ground along an edge by the tiles of the terrain (LINESTRING Z), every ten metres; a node that has a height '
    'of its own keeps it. Where tiles have no data it is straight between places that have; a node without data: 0.';

CREATE OR REPLACE FUNCTION streetgen._ground_of(model name, line geometry, from_place geometry, to_place geometry)
    RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF ST_NDims(line) = 3 AND ST_ZMin(line) = 0 AND ST_ZMax(line) = 0
        AND to_regclass(format('%I.terrain_tile', model)) IS NOT NULL THEN
        RETURN streetgen._terrain_line(model, line, from_place, to_place);
    END IF;
    RETURN streetgen._ground_line(line, from_place, to_place);
END $$;
COMMENT ON FUNCTION streetgen._ground_of(name, geometry, geometry, geometry) IS
    'The ground along an edge between the places of its nodes: the Z of its line; where that is 0 all along, the '
    'terrain of the model, if it has one.';

CREATE OR REPLACE FUNCTION streetgen._heights_by_hand(model name, edge bigint, axis bigint, low float8, high float8,
    length float8) RETURNS SETOF streetgen.profile_height
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN QUERY EXECUTE format('SELECT $1, (abscissa - $3) / ($4 - $3) * $5, height FROM %I.height_override
        WHERE axis_id = $2 AND abscissa BETWEEN $3 AND $4', model) USING edge, axis, low, high, length;
END $$;
COMMENT ON FUNCTION streetgen._heights_by_hand(name, bigint, bigint, float8, float8, float8) IS
    'The heights by hand of an edge: of its axis, between two abscissas; length is that of the edge, m.';
