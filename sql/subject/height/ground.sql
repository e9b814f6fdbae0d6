-- Heights start from the ground along edges, and from heights by hand.

CREATE OR REPLACE FUNCTION streetgen._ground_line(line geometry, from_place geometry, to_place geometry)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN ST_NDims(line) = 2 THEN line
        ELSE ST_SetPoint(ST_SetPoint(line, 0, from_place), -1, to_place) END $$;
COMMENT ON FUNCTION streetgen._ground_line(geometry, geometry, geometry) IS
    'The ground along an edge: its line, at its ends the places of its nodes, at which edges have one height.';

CREATE OR REPLACE FUNCTION streetgen._known_height(z float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN z BETWEEN -500 AND 10000 THEN z END $$;
COMMENT ON FUNCTION streetgen._known_height(float8) IS
    'A height (m), NULL for one that stands for none: under -500 m there is no land, and -1000, -9999 or less say that '
    'nobody knows.';

CREATE OR REPLACE FUNCTION streetgen._terrain_heights(model name, area geometry, places geometry[]) RETURNS float8[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF to_regclass(format('%I.terrain_tile', model)) IS NULL THEN
        RETURN array_fill('NaN'::float8, ARRAY[cardinality(places)]);
    END IF;
    RETURN streetgen._ground_heights(streetgen._tiles_of(model, area),
        ARRAY(SELECT ST_X(p) FROM unnest(places) WITH ORDINALITY u(p, n) ORDER BY n),
        ARRAY(SELECT ST_Y(p) FROM unnest(places) WITH ORDINALITY u(p, n) ORDER BY n));
END $$;
COMMENT ON FUNCTION streetgen._terrain_heights(name, geometry, geometry[]) IS
    'The heights (m) of places in an area by the tiles of a model; NaN where there are none.';

CREATE OR REPLACE FUNCTION streetgen._nearest_height(model name, place geometry, OUT z float8, OUT distance float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- The twenty nearest boxes bound how far the twenty nearest axes lie.
    SELECT ST_Z(d.geom), ST_Distance(d.geom, place) FROM (SELECT geom FROM axis
            WHERE ST_DWithin(geom, place, least(500, (SELECT max(ST_Distance(b.geom, place))
                FROM (SELECT geom FROM axis ORDER BY geom <#> place LIMIT 20) b)))
            ORDER BY ST_Distance(geom, place), axis_id LIMIT 20) a, ST_DumpPoints(a.geom) d
        WHERE streetgen._known_height(ST_Z(d.geom)) IS NOT NULL ORDER BY 2, 1 LIMIT 1 INTO z, distance;
END $$;
COMMENT ON FUNCTION streetgen._nearest_height(name, geometry) IS
    'The height (m) of the nearest vertex of an axis that has one, and how far it is (m); NULL where none is within '
    '500 m.';

CREATE OR REPLACE FUNCTION streetgen._node_ground(model name, place geometry) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    z float8 := streetgen._known_height(ST_Z(place));
BEGIN
    IF z <> 0 THEN
        RETURN z;
    END IF;
    z := coalesce(nullif((streetgen._terrain_heights(model, place, ARRAY[place]))[1], 'NaN'), z);
    RETURN coalesce(z, (streetgen._nearest_height(model, place)).z, 0);
END $$;
COMMENT ON FUNCTION streetgen._node_ground(name, geometry) IS
    'The ground (m) at the place of a node: its Z; where that is 0 or unknown, the terrain; else the nearest vertex of '
    'an axis that has a height, within 500 m, else 0.';

CREATE OR REPLACE FUNCTION streetgen._filled_ground(model name, line geometry, from_place geometry,
    to_place geometry, bare boolean) RETURNS geometry
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
    WITH point AS MATERIALIZED (SELECT path[1] AS n, geom, count(*) OVER () AS points,
            CASE WHEN NOT bare THEN streetgen._known_height(ST_Z(geom)) END AS own
        FROM ST_DumpPoints(CASE WHEN bare THEN ST_Segmentize(line, 10) ELSE line END)),
    terrain AS MATERIALIZED (SELECT streetgen._terrain_heights(model, line, array_agg(geom ORDER BY n)) AS heights
        FROM point),
    known AS MATERIALIZED (SELECT n, geom, CASE WHEN n IN (1, points) THEN e.z
            ELSE coalesce(own, nullif(heights[n], 'NaN')) END AS z
        FROM point, terrain,
            -- Asked of an end alone.
            LATERAL (SELECT CASE n WHEN 1 THEN streetgen._node_ground(model, from_place)
                WHEN points THEN streetgen._node_ground(model, to_place) END AS z) e)
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(k.geom), ST_Y(k.geom), coalesce(k.z, b.z + (a.z - b.z)
            * ((k.n - b.n)::float8 / (a.n - b.n)))) ORDER BY k.n), ST_SRID(line))
    FROM known k
        LEFT JOIN LATERAL (SELECT n, z FROM known o WHERE k.z IS NULL AND o.n < k.n AND o.z IS NOT NULL
            ORDER BY o.n DESC LIMIT 1) b ON true
        LEFT JOIN LATERAL (SELECT n, z FROM known o WHERE k.z IS NULL AND o.n > k.n AND o.z IS NOT NULL
            ORDER BY o.n LIMIT 1) a ON true $$;
COMMENT ON FUNCTION streetgen._filled_ground(name, geometry, geometry, geometry, boolean) IS
    'The ground along an edge (LINESTRING Z) whose heights are missing in part, or all of them (bare): of the terrain, '
    'then every ten metres; where nothing knows, even steps between the vertices that are known.';

CREATE OR REPLACE FUNCTION streetgen._ground_of(model name, line geometry, from_place geometry, to_place geometry)
    RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bare boolean;
    has_terrain boolean;
BEGIN
    IF ST_NDims(line) = 3 THEN
        bare := ST_ZMin(line) = 0 AND ST_ZMax(line) = 0;
        has_terrain := (bare OR 0 IN (ST_Z(from_place), ST_Z(to_place)))
            AND to_regclass(format('%I.terrain_tile', model)) IS NOT NULL;
        IF has_terrain OR streetgen._known_height(least(ST_ZMin(line), ST_Z(from_place), ST_Z(to_place))) IS NULL
            OR streetgen._known_height(greatest(ST_ZMax(line), ST_Z(from_place), ST_Z(to_place))) IS NULL THEN
            RETURN streetgen._filled_ground(model, line, from_place, to_place, bare AND has_terrain);
        END IF;
    END IF;
    RETURN streetgen._ground_line(line, from_place, to_place);
END $$;
COMMENT ON FUNCTION streetgen._ground_of(name, geometry, geometry, geometry) IS
    'The ground along an edge between the places of its nodes, at which all edges have one height: the Z of its line; '
    'where that is 0 all along, or at a node, the terrain of the model, if it has one. Holes of Z are filled.';

CREATE OR REPLACE FUNCTION streetgen._off_ground(level integer, line geometry) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN level = 0 OR ST_NDims(line) = 3 AND (streetgen._known_height(ST_ZMin(line)) <> 0
            OR streetgen._known_height(ST_ZMax(line)) <> 0) IS TRUE THEN 0
        ELSE sign(level)::integer END $$;
COMMENT ON FUNCTION streetgen._off_ground(integer, geometry) IS
    'Where an edge lies by its level alone: 1, a bridge without heights of its own, -1, such a tunnel; 0: neither.';

CREATE OR REPLACE FUNCTION streetgen._bridge_ends(model name, nodes bigint[]) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT e.node_id FROM (SELECT from_node AS node_id, level, geom FROM edge WHERE from_node = ANY (nodes)
            UNION ALL SELECT to_node, level, geom FROM edge WHERE to_node = ANY (nodes)) e
        GROUP BY e.node_id HAVING count(DISTINCT streetgen._off_ground(level, geom)) > 1;
END $$;
COMMENT ON FUNCTION streetgen._bridge_ends(name, bigint[]) IS
    'The nodes, of these, at which a bridge or a tunnel ends, since an edge there is none.';

CREATE OR REPLACE FUNCTION streetgen._ends_off_ground(model name, node bigint) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$ SELECT EXISTS (SELECT FROM streetgen._bridge_ends(model, ARRAY[node])) $$;
COMMENT ON FUNCTION streetgen._ends_off_ground(name, bigint) IS
    'Does a bridge or a tunnel end at a node, since an edge there is none?';

CREATE OR REPLACE FUNCTION streetgen._heights_by_hand(model name, edge bigint, axis bigint, low float8, high float8,
    length float8) RETURNS SETOF streetgen.profile_height
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT edge, (abscissa - low) / (high - low) * length, height FROM height_override
        WHERE axis_id = axis AND abscissa BETWEEN low AND high;
END $$;
COMMENT ON FUNCTION streetgen._heights_by_hand(name, bigint, bigint, float8, float8, float8) IS
    'The heights by hand of an edge: of its axis, between two abscissas; length is that of the edge, m.';

CREATE OR REPLACE FUNCTION streetgen._tiles_of(model name, area geometry) RETURNS bytea[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tiles bytea[];
BEGIN
    EXECUTE format('SELECT coalesce(array_agg(heights ORDER BY terrain_tile_id), ''{}'') FROM %I.terrain_tile
        WHERE geom && $1 AND NOT rejected', model) INTO tiles USING area;
    RETURN tiles;
END $$;
COMMENT ON FUNCTION streetgen._tiles_of(name, geometry) IS 'The tiles of heights whose boxes meet that of an area.';
