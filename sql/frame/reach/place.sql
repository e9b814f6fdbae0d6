-- The keys by which sessions lock places of a model: cells, districts and axes. Of each lock the first key is the
-- model; of the second 0 is the model, -1 all its places. chain.sql has the keys of chains, and
-- frame/run/generate_clusters.sql those of clusters.

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

CREATE OR REPLACE FUNCTION streetgen._districts_of(line geometry, size float8) RETURNS SETOF integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        SELECT streetgen._districts(streetgen._district_of(ST_XMin(line) - 10, size),
            streetgen._district_of(ST_YMin(line) - 10, size), streetgen._district_of(ST_XMax(line) + 10, size),
            streetgen._district_of(ST_YMax(line) + 10, size));
    END;
COMMENT ON FUNCTION streetgen._districts_of(geometry, float8) IS
    'The keys of the districts that who writes the rows of an axis or an edge locks or shares.';

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

CREATE OR REPLACE FUNCTION streetgen._not_held(model_key integer, keys integer[], alone boolean) RETURNS integer[]
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE AS 'MODULE_PATHNAME', 'streetgen_not_held';
COMMENT ON FUNCTION streetgen._not_held(integer, integer[], boolean) IS
    'Those of the keys of a model that this session does not hold, for itself (alone) or at least shared.';

CREATE OR REPLACE FUNCTION streetgen._places_held() RETURNS integer
    LANGUAGE sql VOLATILE PARALLEL UNSAFE
    RETURN CASE WHEN current_setting('streetgen.places', true) ~ '^\d{1,9}$'
        THEN current_setting('streetgen.places')::integer ELSE 0 END;
COMMENT ON FUNCTION streetgen._places_held() IS
    'How many keys this transaction has locked, by setting streetgen.places, which counts for it and goes back with '
    'savepoints as the locks do.';

CREATE OR REPLACE FUNCTION streetgen._places_of(model name, cells integer[], districts integer[], chains integer[],
    OUT alone integer[], OUT shared integer[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    -- A server has room for some 6,400 locks by default, all sessions together.
    most_near constant integer := 512;
    most constant integer := 768;
    model_key constant integer := hashtext('streetgen.' || model);
    held constant integer := streetgen._places_held();
    axis_keys constant integer[] := ARRAY(SELECT key FROM unnest(chains) key WHERE key >= streetgen._axis_key(0));
    near constant integer[] := streetgen._not_held(model_key, cells || axis_keys, true);
    wide constant integer[] := streetgen._not_held(model_key, districts, true);
    chained constant integer[] := streetgen._not_held(model_key,
        ARRAY(SELECT key FROM unnest(chains) key WHERE key < streetgen._axis_key(0)), true);
BEGIN
    shared := streetgen._not_held(model_key, districts, false);
    IF near = '{}' OR wide = '{}' AND districts <> '{}' OR streetgen._not_held(model_key, ARRAY[-1], true) = '{}' THEN
        alone := '{}';
    ELSIF held + cardinality(near) + cardinality(shared) <= most_near THEN
        alone := near;
    ELSIF held + cardinality(wide) <= most THEN
        alone := wide;
        shared := '{}';
    ELSE
        alone := ARRAY[-1];
        shared := '{}';
    END IF;
    IF chained <> '{}' AND streetgen._not_held(model_key, ARRAY[streetgen._all_chains()], true) <> '{}' THEN
        alone := alone || CASE WHEN held + cardinality(alone) + cardinality(shared) + cardinality(chained) <= most
            THEN chained ELSE ARRAY[streetgen._all_chains()] END;
    END IF;
    shared := shared || ARRAY(SELECT unnest(streetgen._not_held(model_key, ARRAY[-1, streetgen._all_chains()], false))
        EXCEPT SELECT unnest(alone));
END $$;
COMMENT ON FUNCTION streetgen._places_of(name, integer[], integer[], integer[]) IS
    'The keys by which this transaction locks cells, districts, axes and chains of a model, for itself and shared, '
    'without those that it holds. Cells and axes are locked within their districts, which are shared. Where it would '
    'hold more than 512 keys in all it is the districts in place of cells and axes, where more than 768 one key of all '
    'places, and one of all chains.';
