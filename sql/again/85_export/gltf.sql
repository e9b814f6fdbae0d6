-- glTF 2.0 in one binary file: streets to look at.

CREATE OR REPLACE FUNCTION streetgen._gltf_mesh(surfaces bytea[], levels integer[], wanted boolean[], raised float8[],
    lines bytea[], axes bytea[], axis_levels integer[], tolerance float8, kinds integer[], kerb integer,
    x float8, y float8, z float8)
    RETURNS TABLE(kind integer, vertices bigint, indices bigint, lowest real[], highest real[], bytes bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 5 AS 'MODULE_PATHNAME', 'streetgen_gltf_mesh';
COMMENT ON FUNCTION streetgen._gltf_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[], float8,
    integer[], integer, float8, float8, float8) IS
    'The meshes that streetgen._road_mesh makes of its arguments as data of glTF, one row for each kind of surface '
    'and one for the kerbs, which are of kind kerb. Counted from an origin x, y, z; y of the file is up, z to the '
    'south. lowest and highest: the box of the positions. bytes: positions, normals, texture coordinates, indices.';

CREATE OR REPLACE FUNCTION streetgen._gltf_blocks(model name, options jsonb, x float8, y float8)
    RETURNS TABLE(cell integer, kind integer, vertices bigint, indices bigint, lowest real[], highest real[],
        bytes bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    dimension integer;
    part record;
    query constant text := streetgen._mesh_input(model) || $q$,
-- Paint lies above both: it leaves the heights by a tolerance, and so does the roadway.
painted AS (SELECT array_agg(surface::bytea ORDER BY id) AS surfaces, array_agg(level ORDER BY id) AS levels,
    array_agg(true) AS wanted, array_agg(raised + 2 * $5) AS raised, array_agg(line::bytea ORDER BY id) AS lines,
    array_agg(number) AS kinds
    FROM paint, streetgen._mesh_kind() k WHERE k.kind = 'marking' AND edge_id = ANY ($1) AND NOT ST_IsEmpty(surface))
SELECT $6, t.* FROM axes a, (SELECT * FROM laid UNION ALL SELECT * FROM painted) l, streetgen._mesh_kind() k,
    streetgen._gltf_mesh(surfaces, levels, l.wanted, l.raised, lines, axes, axis_levels, $5, kinds, k.number, $7, $8,
        0) t WHERE k.kind = 'kerb' ORDER BY t.kind$q$;
BEGIN
    SELECT m.dimension INTO dimension FROM streetgen.model m WHERE m.name = model;
    FOR part IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY EXECUTE query USING part.edges, part.nodes, part.about, dimension,
            (options ->> 'tolerance')::float8, part.cell, x, y;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._gltf_blocks(name, jsonb, float8, float8) IS
    'The data of a file of glTF: a row for each kind of surface of each cell, counted from an origin.';

CREATE OR REPLACE FUNCTION streetgen._gltf_word(value bigint) RETURNS bytea
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN (SELECT string_agg(substring(int8send(value) FROM 8 - i FOR 1), '' ORDER BY i) FROM generate_series(0, 3) i);
COMMENT ON FUNCTION streetgen._gltf_word(bigint) IS 'A whole number below 2^32 as four bytes, the lowest first.';

CREATE OR REPLACE FUNCTION streetgen._gltf_query() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
block AS MATERIALIZED (
    SELECT b.*, row_number() OVER place - 1 AS number, sum(length(bytes)) OVER place - length(bytes) AS start
    FROM origin o, streetgen._gltf_blocks(%1$L, $1, o.x, o.y) b WINDOW place AS (ORDER BY cell, kind)),
size AS (SELECT sum(length(bytes))::bigint AS bytes FROM block),
view AS NOT MATERIALIZED (
    SELECT number, start, a.*
    FROM block, LATERAL (VALUES
        (0, 0, 12 * vertices, 34962, 5126, vertices, 'VEC3', to_json(lowest::float8[]), to_json(highest::float8[])),
        (1, 12 * vertices, 12 * vertices, 34962, 5126, vertices, 'VEC3', NULL, NULL),
        (2, 24 * vertices, 8 * vertices, 34962, 5126, vertices, 'VEC2', NULL, NULL),
        (3, 32 * vertices, 4 * indices, 34963, 5125, indices, 'SCALAR', NULL, NULL))
        a(k, after, bytes, target, component, count, type, low, high)),
mesh AS (
    SELECT cell, row_number() OVER (ORDER BY cell) - 1 AS number, json_build_object('name', 'cell_' || cell,
        'primitives', json_agg(json_build_object('attributes', json_build_object('POSITION', 4 * number,
            'NORMAL', 4 * number + 1, 'TEXCOORD_0', 4 * number + 2), 'indices', 4 * number + 3,
            'material', kind) ORDER BY number)) AS mesh
    FROM block GROUP BY cell),
-- A list of thousands of elements in one value would be copied many times: it is written piece by piece.
element AS (
    SELECT 2 AS turn, number, number::text AS text FROM mesh
    UNION ALL SELECT 4, number, json_build_object('name', 'cell_' || cell, 'mesh', number)::text FROM mesh
    UNION ALL SELECT 6, number, mesh::text FROM mesh
    UNION ALL SELECT 8, 4 * number + k, json_strip_nulls(json_build_object('bufferView', 4 * number + k,
        'componentType', component, 'count', count, 'type', type, 'min', low, 'max', high))::text FROM view
    UNION ALL SELECT 10, 4 * number + k, json_build_object('buffer', 0, 'byteOffset', start + after, 'byteLength',
        bytes, 'target', target)::text FROM view),
told AS MATERIALIZED (
    SELECT turn, number / 1000 AS id, convert_to(CASE WHEN number / 1000 > 0 THEN ', ' ELSE '' END
        || string_agg(text, ', ' ORDER BY number), 'UTF8') AS bytes
    FROM element GROUP BY turn, number / 1000
    UNION ALL SELECT turn, 0, convert_to(text, 'UTF8') FROM origin o, size, LATERAL (VALUES
        (1, '{"asset" : ' || json_build_object('version', '2.0', 'generator', 'StreetGen ' || streetgen.version(),
            'extras', json_build_object('model', streetgen._xml_text(%1$L), 'srid', %2$s, 'origin',
                json_build_array(o.x, o.y, 0), 'axes', 'x east, y up, z south, metres'))
            || ', "scene" : 0, "scenes" : [{"nodes" : ['),
        (3, ']}], "nodes" : ['), (5, '], "meshes" : ['),
        (7, '], "materials" : ' || (SELECT json_agg(json_build_object('name', kind, 'pbrMetallicRoughness',
            json_build_object('baseColorFactor', color || 1::float8, 'metallicFactor', 0, 'roughnessFactor', roughness))
            ORDER BY number) FROM streetgen._mesh_kind()) || ', "accessors" : ['),
        (9, '], "bufferViews" : ['),
        (11, '], "buffers" : ' || json_build_array(json_build_object('byteLength', size.bytes)) || '}')) t(turn, text)),
padded AS (SELECT bytes, bytes + (-bytes & 3) AS whole FROM (SELECT sum(length(bytes)) AS bytes FROM told) t),
-- Header, the chunk of JSON, the chunk of data.
piece AS (
    SELECT 0 AS turn, 0::bigint AS id, 'glTF'::bytea || streetgen._gltf_word(2)
        || streetgen._gltf_word(28 + whole + size.bytes) || streetgen._gltf_word(whole) || 'JSON'::bytea AS bytes
    FROM padded, size
    UNION ALL SELECT * FROM told
    UNION ALL SELECT 12, 0, repeat(' ', (whole - p.bytes)::integer)::bytea || streetgen._gltf_word(size.bytes)
        || '\x42494e00'::bytea FROM padded p, size
    UNION ALL SELECT 13, number, bytes FROM block)
SELECT row_number() OVER (ORDER BY turn, id, start), substring(bytes FROM start + 1 FOR 1048576)
FROM piece, generate_series(0, length(bytes) - 1, 1048576) start ORDER BY turn, id, start$part$ $$;
COMMENT ON FUNCTION streetgen._gltf_query() IS
    'The queries of a file of glTF over a model %1$L of SRID %2$s and its options $1, after those of '
    'streetgen._export_edges: the parts.';

CREATE OR REPLACE FUNCTION streetgen.export_gltf(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, part bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'gltf', 'surface', options);
BEGIN
    RETURN QUERY EXECUTE streetgen._export_query(model, known, streetgen._gltf_query()) USING known;
END $$;
COMMENT ON FUNCTION streetgen.export_gltf(name, jsonb) IS
    'A binary file of glTF 2.0 (.glb), in parts of at most 1 MB that follow each other. What streets consist of has a '
    'material each: section, intersection, sidewalk and kerb (subject sidewalk), marking (subject lane). Sidewalks lie '
    '0.15 m above the roadway and kerbs close the step; paint lies above the roadway by 5 mm and twice the tolerance. '
    'Heights, normals and texture coordinates, metres, are those of streetgen.road_mesh. x is to the east, y up, z to '
    'the south. Positions are floats, counted from whole metres that extras of the asset name with the SRID; a float '
    'resolves a millimetre ten kilometres from there. A node is a square of 500 m. options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
