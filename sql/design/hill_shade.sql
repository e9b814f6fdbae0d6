-- The terrain as it looks from above, in the light of the north west.

CREATE OR REPLACE FUNCTION streetgen._shaded_cells(model name, extent geometry, cell float8)
    RETURNS TABLE(i integer, j integer, grey integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns constant integer := ceil((ST_XMax(extent) - ST_XMin(extent)) / cell)::integer + 1;
    rows constant integer := ceil((ST_YMax(extent) - ST_YMin(extent)) / cell)::integer + 1;
    heights float8[];
BEGIN
    heights := streetgen._ground_heights(streetgen._tiles_of(model, extent),
        ARRAY(SELECT ST_XMin(extent) + c * cell FROM generate_series(0, rows - 1) r, generate_series(0, columns - 1) c
            ORDER BY r, c),
        ARRAY(SELECT ST_YMax(extent) - r * cell FROM generate_series(0, rows - 1) r, generate_series(0, columns - 1) c
            ORDER BY r, c));
    RETURN QUERY SELECT c, r,
            170 + 5 * round(greatest(-12, least(15, 8 + 14 * ((h2 - h1) + (h3 - h1)) / cell)))::integer
        FROM generate_series(0, rows - 2) r, generate_series(0, columns - 2) c,
            LATERAL (SELECT heights[r * columns + c + 1] AS h1, heights[r * columns + c + 2] AS h2,
                heights[(r + 1) * columns + c + 1] AS h3) h
        WHERE h1 + h2 + h3 <> 'NaN';
END $$;
COMMENT ON FUNCTION streetgen._shaded_cells(name, geometry, float8) IS
    'The grey (110 to 245, steps of 5) of square cells in an extent: column i from the left and row j from above, from '
    '0; no row where the ground has no height.';

CREATE OR REPLACE FUNCTION streetgen.hill_shade(model name, extent geometry DEFAULT NULL, columns integer DEFAULT 300)
    RETURNS TABLE(hill_shade_id bigint, grey integer, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    shown geometry := extent;
    cell float8;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._require_design(model),
        streetgen._check_given('columns', columns::text);
    IF columns NOT BETWEEN 1 AND 2000 THEN
        RAISE EXCEPTION 'columns is %', columns USING ERRCODE = '22023', HINT = 'Expected 1 to 2000 columns of cells.';
    END IF;
    IF shown IS NULL THEN
        SELECT ST_SetSRID(ST_Extent(t.geom)::geometry, 0) FROM terrain_tile t WHERE NOT rejected INTO shown;
        IF shown IS NULL THEN
            RETURN;
        END IF;
    END IF;
    shown := ST_Envelope(streetgen._in_model(model, shown, 'the extent'));
    cell := greatest(ST_XMax(shown) - ST_XMin(shown), ST_YMax(shown) - ST_YMin(shown)) / columns;
    IF cell <= 0 THEN
        RETURN;
    END IF;
    -- Cells of one grey that follow each other in a row are one rectangle.
    RETURN QUERY SELECT row_number() OVER (ORDER BY r.j, min(r.i)), r.grey,
            ST_MakeEnvelope(ST_XMin(shown) + min(r.i) * cell, ST_YMax(shown) - (r.j + 1) * cell,
                ST_XMin(shown) + (max(r.i) + 1) * cell, ST_YMax(shown) - r.j * cell, ST_SRID(shown))
        FROM (SELECT c.*, c.i - row_number() OVER (PARTITION BY c.j, c.grey ORDER BY c.i) AS run
            FROM streetgen._shaded_cells(model, shown, cell) c) r
        GROUP BY r.j, r.grey, r.run;
END $$;
COMMENT ON FUNCTION streetgen.hill_shade(name, geometry, integer) IS
    'The terrain of a model in the light of the north west: rectangles (POLYGON) of one grey, 110 (dark) to 245, that '
    'do not overlap. extent: what is shown, NULL: the terrain. columns: square cells along its longer side, 1 to 2000. '
    'Ground without heights, or without an extent: no row. Another number: 22023; NULL for columns: 22004; a model '
    'without a design: 55000.';
