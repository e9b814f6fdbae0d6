-- Heights of the ground: imported as tiles, asked at places and along lines.

CREATE OR REPLACE FUNCTION streetgen._check_tile_places(model name, target_srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    rims constant text := format('SELECT concat(''the tile at '', box[1], '' '', box[4]) AS label, ST_ExteriorRing(
        ST_MakeEnvelope(box[1], box[2], box[3], box[4], %s)) AS geom FROM pg_temp._tile', target_srid);
    wrong record;
    apart float8;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._check_scale(rims);
    SELECT * INTO wrong FROM streetgen._misplaced(rims);
    IF FOUND THEN
        RAISE EXCEPTION '%', wrong.remark USING ERRCODE = '22023', HINT = wrong.way_out;
    END IF;
    SELECT ST_Distance(t.ground, m.ground) INTO apart FROM (
        SELECT ST_Collect(ST_MakeEnvelope(box[1], box[2], box[3], box[4], target_srid)) AS ground
        FROM pg_temp._tile) t, (
        SELECT ST_SetSRID(ST_Collect(extent::geometry), target_srid) AS ground FROM (
            SELECT ST_Extent(geom) AS extent FROM axis
            UNION ALL SELECT ST_Extent(geom) FROM design_node WHERE NOT rejected
            UNION ALL SELECT ST_Extent(geom) FROM terrain_tile) e) m;
    IF apart > 0 THEN
        RAISE WARNING 'the heights lie % m beside the axes, nodes and heights of model "%"', round(apart), model
            USING HINT = 'Look whether the file is that of another area, or says another spatial reference.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_tile_places(name, integer) IS
    'Raises 22023 for tiles to be added (temporary table _tile) that lie outside of the area of their SRID, or where '
    'its scale is more than 1 % off; warns where they lie beside all that the model has.';

CREATE OR REPLACE FUNCTION streetgen._take_tiles(source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE _tile ON COMMIT DROP AS SELECT heights, streetgen._height_tile_box(heights)
        AS box FROM (%s) s(heights)', source);
END $$;
COMMENT ON FUNCTION streetgen._take_tiles(text) IS
    'Makes temporary table _tile of the tiles that a query gives (bytea, raster WKB), each with its box.';

CREATE OR REPLACE FUNCTION streetgen._add_tiles(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    wrong record;
    added bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT box[5]::integer AS srid INTO wrong FROM pg_temp._tile WHERE box[5] NOT IN (0, target_srid) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'a tile has SRID %, the model %', wrong.srid, target_srid USING ERRCODE = '22023',
            HINT = 'data/streetgen terrain FILE MODEL transforms a file; gdalwarp -t_srs does, too.';
    END IF;
    SELECT t.box AS a INTO wrong FROM pg_temp._tile t JOIN terrain_tile o
        ON ST_Area(ST_Intersection(o.geom, ST_MakeEnvelope(box[1], box[2], box[3], box[4], target_srid))) > 1e-3
        LIMIT 1;
    IF wrong.a IS NOT NULL THEN
        RAISE EXCEPTION 'the tile at % % overlaps a tile of the model', wrong.a[1], wrong.a[4]
            USING ERRCODE = '22023', HINT = 'Delete the tiles of terrain_tile that the new ones replace.';
    END IF;
    PERFORM streetgen._check_tile_places(model, target_srid);
    INSERT INTO terrain_tile (geom, heights) SELECT ST_MakeEnvelope(box[1], box[2], box[3], box[4], target_srid),
        heights FROM pg_temp._tile ORDER BY box;
    GET DIAGNOSTICS added = ROW_COUNT;
    DROP TABLE pg_temp._tile;
    -- Tiles that differ in cell, or overlap each other, are refused here.
    PERFORM streetgen._ground_heights(array_agg(heights), '{}', '{}') FROM terrain_tile;
    RETURN added;
END $$;
COMMENT ON FUNCTION streetgen._add_tiles(name) IS
    'Adds the tiles of temporary table _tile, which goes, to a model, and returns how many. Tiles of another SRID, '
    'area or cell, or that overlap: 22023.';

CREATE OR REPLACE FUNCTION streetgen.import_terrain(model name, source regclass) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    raster record;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text),
        streetgen._require_design(model);
    SELECT attname AS name, typname AS type, n.nspname AS schema INTO raster FROM pg_attribute a
        JOIN pg_type t ON t.oid = a.atttypid JOIN pg_namespace n ON n.oid = t.typnamespace
        WHERE attrelid = source AND attnum > 0 AND NOT attisdropped AND typname IN ('raster', 'bytea', 'text')
        ORDER BY typname = 'raster' DESC, typname = 'bytea' DESC, attname IN ('rast', 'heights') DESC, attnum LIMIT 1;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'table % has no column of rasters', source USING ERRCODE = '42703',
            HINT = 'Expected a column of type raster, or raster WKB as bytea or as hexadecimal text.';
    END IF;
    PERFORM streetgen._take_tiles(format('SELECT %s FROM %s WHERE %I IS NOT NULL', CASE raster.type
        WHEN 'raster' THEN format('%I.ST_AsBinary(%I)', raster.schema, raster.name)
        WHEN 'text' THEN format('decode(%I, ''hex'')', raster.name) ELSE quote_ident(raster.name) END, source,
        raster.name));
    RETURN streetgen._add_tiles(model);
END $$;
COMMENT ON FUNCTION streetgen.import_terrain(name, regclass) IS
    'Adds the tiles of a table to the terrain of a model: a column of type raster (postgis_raster), or raster WKB as '
    'bytea or hexadecimal text. Returns how many. The first band counts; cells are square, in the SRID of the model. '
    'Tiles beside all that the model has are taken with a warning. Other tiles, tiles of another area than that of '
    'their SRID, that differ in cell, that overlap, or with heights of -9999 or alike and no value for missing '
    'ones: 22023; no such column: 42703; a model without a '
    'design: 55000; not its owner: 42501.';

CREATE OR REPLACE FUNCTION streetgen._in_model(model name, geom geometry, what text, expected text[] DEFAULT NULL,
    way_out text DEFAULT NULL) RETURNS geometry
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._check_edit_geometry(what, geom), streetgen._check_type(what, geom, expected, way_out);
    RETURN CASE WHEN ST_SRID(geom) IN (0, target_srid) THEN ST_SetSRID(geom, target_srid)
        ELSE streetgen._transformed(what, geom, target_srid) END;
END $$;
COMMENT ON FUNCTION streetgen._in_model(name, geometry, text, text[], text) IS
    'A geometry in the SRID of a model. NULL, empty, not finite or, where types are expected, of another: 22023.';

CREATE OR REPLACE FUNCTION streetgen.terrain_height(model name, place geometry) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    at geometry;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._require_design(model);
    at := streetgen._in_model(model, place, 'the place', '{POINT}',
        'streetgen.terrain_profile reads heights along a line.');
    RETURN nullif((streetgen._ground_heights(streetgen._tiles_of(model, at), ARRAY[ST_X(at)], ARRAY[ST_Y(at)]))[1],
        'NaN');
END $$;
COMMENT ON FUNCTION streetgen.terrain_height(name, geometry) IS
    'Height of the ground at a place (POINT, of any SRID), metres, bilinear between the centres of cells; NULL where '
    'there is no tile or no data. Another geometry: 22023; a model without a design: 55000. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.terrain_profile(model name, line geometry, step float8)
    RETURNS TABLE(abscissa float8, height float8, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
DECLARE
    along geometry;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._require_design(model);
    along := ST_Force2D(streetgen._in_model(model, line, 'the line', '{LINESTRING}',
        'ST_LineMerge makes one line of parts that meet.'));
    IF NOT (step > 0 AND ST_Length(along) / step < 1e6) THEN
        RAISE EXCEPTION 'step is % m for a line of % m', step, ST_Length(along) USING ERRCODE = '22023',
            HINT = 'Expected a step above 0 that makes less than a million heights.';
    END IF;
    RETURN QUERY WITH place AS MATERIALIZED (
        SELECT s, ST_LineInterpolatePoint(along, least(s / nullif(ST_Length(along), 0), 1)) AS at
        FROM (SELECT least(k * step, ST_Length(along)) AS s
            FROM generate_series(0, ceil(ST_Length(along) / step)::bigint) k) k),
    known AS (SELECT streetgen._ground_heights(streetgen._tiles_of(model, along), array_agg(ST_X(at) ORDER BY s),
        array_agg(ST_Y(at) ORDER BY s)) AS heights FROM place)
    SELECT s, nullif(h.height, 'NaN'), at FROM (SELECT s, at, row_number() OVER (ORDER BY s) AS nth FROM place) p
        JOIN (SELECT * FROM known, unnest(heights) WITH ORDINALITY u(height, nth)) h USING (nth) ORDER BY s;
END $$;
COMMENT ON FUNCTION streetgen.terrain_profile(name, geometry, float8) IS
    'Heights of the ground along a line (LINESTRING, of any SRID), every step metres and at its end; NULL where there '
    'is no data. Another geometry or step: 22023; a model without a design: 55000. NULL for NULL: no row.';
