-- The keys by which sessions lock places of a model: cells, districts and axes. Of each lock the first key is the
-- model; of the second 0 is the model, -1 all its places. chain.sql has the keys of chains, 55_cluster/run.sql those of
-- clusters.

CREATE OR REPLACE FUNCTION streetgen._cells(line geometry, margin float8, size float8) RETURNS SETOF integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined. A cell is half as wide as the setting says: its diagonal counts.
    BEGIN ATOMIC
        SELECT 1073741824 + (hashint8(x * 1000003 + y) & 1073741823)
        FROM (SELECT size / 2 AS width, ceil(ST_Length2D(line) / 1000)::integer AS pieces) w,
            -- A long line is taken piece by piece: most cells of its box lie far off.
            LATERAL (SELECT CASE WHEN pieces < 2 THEN line ELSE
                ST_LineSubstring(line, n / pieces::float8, (n + 1) / pieces::float8) END AS piece
                FROM generate_series(0, greatest(pieces, 1) - 1) n) p,
            LATERAL generate_series(floor((ST_XMin(piece) - margin) / width)::bigint,
                floor((ST_XMax(piece) + margin) / width)::bigint) x,
            LATERAL generate_series(floor((ST_YMin(piece) - margin) / width)::bigint,
                floor((ST_YMax(piece) + margin) / width)::bigint) y
        WHERE ST_DWithin(ST_SetSRID(ST_MakePoint((x + 0.5) * width, (y + 0.5) * width), ST_SRID(line)), piece,
            margin + 0.7072 * width);
    END;
COMMENT ON FUNCTION streetgen._cells(geometry, float8, float8) IS
    'The keys (1073741824 and above) of the cells within a margin of a line or a point, metres; some more than once. '
    'size: that of setting cell_size.';

CREATE OR REPLACE FUNCTION streetgen._district_of(coordinate float8, size float8) RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN floor(coordinate / (5 * size))::bigint;
COMMENT ON FUNCTION streetgen._district_of(float8, float8) IS
    'The column or row of the districts in which a coordinate lies: a district is five times as wide as setting '
    'cell_size.';

CREATE OR REPLACE FUNCTION streetgen._districts(west bigint, south bigint, east bigint, north bigint)
    RETURNS SETOF integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        SELECT -2 - (hashint8(x * 1000003 + y) & 1073741823)
        FROM generate_series(west, east) x, generate_series(south, north) y;
    END;
COMMENT ON FUNCTION streetgen._districts(bigint, bigint, bigint, bigint) IS
    'The keys (-1073741825 to -2) of the districts from one column and row to another.';

CREATE OR REPLACE FUNCTION streetgen._axis_key(axis_id bigint) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    BEGIN ATOMIC SELECT 536875008 + (axis_id & 268435455)::integer; END;
COMMENT ON FUNCTION streetgen._axis_key(bigint) IS
    'The key (536875008 to 805310463) by which a session locks the rows of an axis.';

-- Below all others, so that it comes before them.
CREATE OR REPLACE FUNCTION streetgen._door() RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT '-2147483648'::integer; END;
COMMENT ON FUNCTION streetgen._door() IS
    'The key of the door of a model. A run beside others shuts it, so that nobody takes places that it does not know '
        'of.';

CREATE OR REPLACE FUNCTION streetgen._places_of(cells integer[], districts integer[], chains integer[],
    OUT alone integer[], OUT shared integer[])
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- A server has room for some 6,400 locks by default, all sessions together.
    SELECT CASE WHEN many_districts THEN ARRAY[-1] WHEN many_cells THEN districts ELSE cells END
            || CASE WHEN many_chains THEN ARRAY[streetgen._all_chains()] ELSE chains END,
        CASE WHEN many_districts THEN '{}' WHEN many_cells THEN ARRAY[-1] ELSE ARRAY[-1] || districts END
            || CASE WHEN many_chains THEN '{}' ELSE ARRAY[streetgen._all_chains()] END
    FROM (SELECT cardinality(cells) > 1024 AS many_cells, cardinality(districts) > 1024 AS many_districts,
        cardinality(chains) > 1024 AS many_chains) m $$;
COMMENT ON FUNCTION streetgen._places_of(integer[], integer[], integer[]) IS
    'The keys that lock cells, districts, axes and chains, for oneself and shared. Cells are locked within their '
    'districts, which are shared. Above 1,024 cells it is the districts, above 1,024 of these one key of all places, '
    'above 1,024 axes and chains one key of all of these.';
