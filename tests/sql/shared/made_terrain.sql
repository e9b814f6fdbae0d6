-- Terrain by a formula, as raster WKB that nothing but this file makes.
CREATE FUNCTION test.hexadecimal(number bigint, bytes integer) RETURNS text LANGUAGE sql IMMUTABLE AS $$
    -- Little endian.
    SELECT string_agg(lpad(to_hex((number >> (8 * k)) & 255), 2, '0'), '' ORDER BY k) FROM generate_series(0, bytes - 1) k $$;

CREATE FUNCTION test.hexadecimal(number float8) RETURNS text LANGUAGE sql IMMUTABLE AS $$
    SELECT string_agg(substr(hex, 17 - 2 * k, 2), '' ORDER BY k) FROM (SELECT encode(float8send(number), 'hex') AS hex) h, generate_series(1, 8) k $$;

-- A tile of n x n heights of a formula over x and y, in metres, no data at -32768.
CREATE FUNCTION test.tile(x float8, y float8, cell float8, n integer, formula text, srid integer DEFAULT 2154) RETURNS bytea LANGUAGE plpgsql AS $$
DECLARE
    pixels text;
BEGIN
    EXECUTE format('SELECT string_agg(test.hexadecimal((%s)::bigint & 65535, 2), '''' ORDER BY j, i) FROM generate_series(0, $4 - 1) j, generate_series(0, $4 - 1) i,
        LATERAL (SELECT $1 + (i + 0.5) * $3 AS x, $2 - (j + 0.5) * $3 AS y) p', formula) INTO pixels USING x, y, cell, n;
    RETURN decode('01' || '0000' || '0100' || test.hexadecimal(cell) || test.hexadecimal(-cell) || test.hexadecimal(x) || test.hexadecimal(y)
        || test.hexadecimal(0) || test.hexadecimal(0) || test.hexadecimal(srid, 4) || test.hexadecimal(n, 2) || test.hexadecimal(n, 2)
        || '45' || '0080' || pixels, 'hex');
END $$;
