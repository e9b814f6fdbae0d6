-- 3D Tiles 1.1: a tree of tiles on the ellipsoid, each a file of glTF.

CREATE OR REPLACE FUNCTION streetgen._geocentric(place geometry, undulation float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ARRAY[ST_X(p), ST_Y(p), ST_Z(p)]
        FROM ST_Transform(ST_Translate(ST_Force3D(place), 0, 0, undulation), 4978) p $$;
COMMENT ON FUNCTION streetgen._geocentric(geometry, float8) IS
    'The coordinates of a POINT on earth (ECEF of WGS 84, metres), its height plus that of the geoid.';

CREATE OR REPLACE FUNCTION streetgen._tile_transform(place geometry, undulation float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- A metre of the projection is no metre on earth, and its north is not the north: differences over 200 m tell.
    SELECT array_agg(value ORDER BY axis, n) FROM (
        SELECT axis, n, coalesce((ahead[n] - behind[n]) / 200, 0) AS value
        FROM (VALUES (1, 100, 0, 0), (2, 0, 100, 0), (3, 0, 0, 100)) v(axis, east, north, up), ST_Force3D(place) p,
            streetgen._geocentric(ST_Translate(p, east, north, up), undulation) ahead,
            streetgen._geocentric(ST_Translate(p, -east, -north, -up), undulation) behind, generate_series(1, 4) n
        UNION ALL SELECT 4, n, coalesce(there[n], 1)
        FROM streetgen._geocentric(place, undulation) there, generate_series(1, 4) n) m
    $$;
COMMENT ON FUNCTION streetgen._tile_transform(geometry, float8) IS
    'The matrix (16 numbers, by columns) from metres east, north and up of a POINT to coordinates on earth.';

CREATE OR REPLACE FUNCTION streetgen._tile_region(about geometry, low float8, high float8) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ARRAY[radians(ST_XMin(b)), radians(ST_YMin(b)), radians(ST_XMax(b)), radians(ST_YMax(b)), low, high]
        FROM ST_Transform(ST_Segmentize(about, 100), 4326) b $$;
COMMENT ON FUNCTION streetgen._tile_region(geometry, float8, float8) IS
    'The region of a tile: west, south, east, north, radians, and its heights above the ellipsoid, metres.';

CREATE OR REPLACE FUNCTION streetgen._tiles(model name, options jsonb)
    RETURNS TABLE(cell integer, east integer, north integer, edges bigint[], nodes bigint[], about geometry, path text,
        origin geometry, region float8[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    undulation constant float8 := options ->> 'undulation';
BEGIN
    PERFORM streetgen._use_model(model);
    -- Surfaces lie about their lines, and trees stand on them.
    RETURN QUERY SELECT c.cell, c.east, c.north, c.edges, c.nodes, c.about, format('%s_%s.glb', c.east, c.north),
        ST_Translate(ST_Force3D(ST_Centroid(about)), 0, 0, coalesce(round(low), 0)),
        streetgen._tile_region(ST_Expand(about, 100), coalesce(low, 0) + undulation - 10,
            coalesce(high, 0) + undulation + 30)
    FROM streetgen._mesh_cells(model, options) c CROSS JOIN LATERAL streetgen._mesh_heights(model, about) h
        CROSS JOIN LATERAL (SELECT min(ST_ZMin(a::geometry)) AS low, max(ST_ZMax(a::geometry)) AS high
            FROM unnest(h.axes) a) z
    WHERE EXISTS (SELECT FROM section s WHERE s.edge_id = ANY (edges) AND NOT ST_IsEmpty(s.surface))
        OR EXISTS (SELECT FROM intersection i WHERE i.node_id = ANY (nodes) AND NOT ST_IsEmpty(i.surface));
END $$;
COMMENT ON FUNCTION streetgen._tiles(name, jsonb) IS
    'The squares of 500 m with streets that options take: their files, the POINT Z that each is counted from, and '
    'their regions on earth.';

CREATE OR REPLACE FUNCTION streetgen._tileset(model name, options jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    undulation constant float8 := options ->> 'undulation';
    size float8 := 500;
    -- Rows of one level: their square, their region and what the file says of them. Squares are counted from the
    -- least one: -1 and 0 remain apart, however often they are halved.
    tiles jsonb := (SELECT jsonb_agg(jsonb_build_object('east', east - least_east, 'north', north - least_north,
            'region', region, 'tile', jsonb_build_object('boundingVolume', jsonb_build_object('region', region),
                'geometricError', 0, 'transform', streetgen._tile_transform(origin, undulation),
                'content', jsonb_build_object('uri', path))))
        FROM (SELECT t.*, min(t.east) OVER () AS least_east, min(t.north) OVER () AS least_north
            FROM streetgen._tiles(model, options) t) s);
BEGIN
    -- A tile that is not drawn is as wrong as it is large: no coarser one stands for it.
    WHILE jsonb_array_length(tiles) > 1 LOOP
        tiles := (SELECT jsonb_agg(jsonb_build_object('east', g.east, 'north', g.north, 'region', g.region, 'tile',
                CASE WHEN g.children > 1 THEN jsonb_build_object('boundingVolume', jsonb_build_object('region',
                    g.region), 'geometricError', size, 'children', g.tiles) ELSE g.tiles -> 0 END))
            FROM (SELECT e AS east, n AS north, count(*) AS children, jsonb_agg(t -> 'tile' ORDER BY t -> 'east',
                    t -> 'north') AS tiles, ARRAY[min((r ->> 0)::float8), min((r ->> 1)::float8),
                    max((r ->> 2)::float8), max((r ->> 3)::float8), min((r ->> 4)::float8), max((r ->> 5)::float8)]
                    AS region
                FROM jsonb_array_elements(tiles) t, LATERAL (SELECT floor((t ->> 'east')::float8 / 2)::integer AS e,
                    floor((t ->> 'north')::float8 / 2)::integer AS n, t -> 'region' AS r) k
                GROUP BY e, n ORDER BY e, n) g);
        size := 2 * size;
    END LOOP;
    RETURN json_build_object('asset', json_build_object('version', '1.1', 'generator', 'StreetGen '
            || streetgen.version(), 'extras', json_build_object('model', streetgen._xml_text(model), 'undulation',
            undulation)), 'geometricError', size, 'root', tiles -> 0 -> 'tile' || '{"refine": "ADD"}');
END $$;
COMMENT ON FUNCTION streetgen._tileset(name, jsonb) IS
    'The tree of the tiles that options take, as the text of a tileset.json: four squares of a level are one of the '
    'next.';

CREATE OR REPLACE FUNCTION streetgen.export_tiles(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, path text, part bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'tiles', 'surface', options);
    tile record;
    written bigint := 1;
BEGIN
    RETURN QUERY SELECT written, 'tileset.json'::text, convert_to(streetgen._tileset(model, known), 'UTF8');
    FOR tile IN SELECT * FROM streetgen._tiles(model, known) t ORDER BY t.cell LOOP
        RETURN QUERY SELECT written + f.ordinality, tile.path, f.part
            FROM streetgen._gltf_file(model, known, ST_X(tile.origin), ST_Y(tile.origin), ST_Z(tile.origin),
                tile.edges, tile.nodes, tile.about) f;
        written := written + 1000000;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen.export_tiles(name, jsonb) IS
    'A folder of 3D Tiles 1.1, part by part (at most 1 MB, those of one file follow each other) with the path of its '
    'file: tileset.json, and a file of glTF for each square of 500 m, as streetgen.export_gltf writes it. Four squares '
    'are one tile of the next level, and so on. Tiles stand on earth (ECEF of WGS 84): each has the matrix that '
    'belongs to its middle, which is off by less than 0.02 m within it. Heights of the model are those above the '
    'ellipsoid, or with option undulation above a geoid that lies so many metres above it. options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
