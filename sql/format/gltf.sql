-- glTF 2.0 in one binary file: streets to look at.

CREATE OR REPLACE FUNCTION streetgen._gltf_mesh(surfaces bytea[], levels integer[], wanted boolean[], raised float8[],
    lines bytea[], axes bytea[], axis_levels integer[], axis_widths float8[], tolerance float8, kinds integer[],
    kerb integer, x float8, y float8, z float8)
    RETURNS TABLE(kind integer, vertices bigint, indices bigint, lowest real[], highest real[], bytes bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 5 AS 'MODULE_PATHNAME', 'streetgen_gltf_mesh';
COMMENT ON FUNCTION streetgen._gltf_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[], float8[],
    float8, integer[], integer, float8, float8, float8) IS
    'The meshes that streetgen._road_mesh makes of its arguments as data of glTF, one row for each kind of surface '
    'and one for the kerbs, which are of kind kerb. Counted from an origin x, y, z; y of the file is up, z to the '
    'south. lowest and highest: the box of the positions. bytes: positions, normals, texture coordinates, indices.';

CREATE OR REPLACE FUNCTION streetgen._paint_along(model name, edges bigint[])
    RETURNS TABLE(id bigint, level integer, surface geometry, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 2 * s.lane_separator_id, e.level, s.surface, e.geom
            FROM lane_separator s JOIN edge e ON e.edge_id = s.edge_id WHERE s.edge_id = ANY (edges);
        RETURN QUERY SELECT 2 * m.marking_id + 1, e.level, m.surface, e.geom
            FROM marking m JOIN edge e ON e.edge_id = m.edge_id WHERE m.edge_id = ANY (edges);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._paint_along(name, bigint[]) IS
    'The lines between lanes and the markings of edges; none of a model that computes no lanes.';

CREATE OR REPLACE FUNCTION streetgen._gltf_blocks(model name, options jsonb, x float8, y float8)
    RETURNS TABLE(cell integer, kind integer, vertices bigint, indices bigint, lowest real[], highest real[],
        bytes bytea)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part record;
    tolerance constant float8 := options ->> 'tolerance';
BEGIN
    FOR part IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY WITH laid AS (
            SELECT l.surfaces, l.levels, l.wanted, l.raised, l.lines, l.kinds
            FROM streetgen._mesh_laid(model, part.edges, part.nodes) l
            -- Paint lies above both: it leaves the heights by a tolerance, and so does the roadway.
            UNION ALL SELECT array_agg(p.surface::bytea ORDER BY p.id), array_agg(p.level ORDER BY p.id),
                array_agg(true), array_agg(k.raised + 2 * tolerance), array_agg(p.line::bytea ORDER BY p.id),
                array_agg(k.number)
            FROM streetgen._paint_along(model, part.edges) p, streetgen._mesh_kind() k
            WHERE k.kind = 'marking' AND NOT ST_IsEmpty(p.surface))
        SELECT part.cell, t.* FROM streetgen._mesh_heights(model, part.about) a, laid l, streetgen._mesh_kind() k,
            streetgen._gltf_mesh(l.surfaces, l.levels, l.wanted, l.raised, l.lines, a.axes, a.axis_levels,
                a.axis_widths, tolerance, l.kinds, k.number, x, y, 0) t
        WHERE k.kind = 'kerb' ORDER BY t.kind;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._gltf_blocks(name, jsonb, float8, float8) IS
    'The data of a file of glTF: a row for each kind of surface of each cell, counted from an origin.';

CREATE OR REPLACE FUNCTION streetgen._gltf_word(value bigint) RETURNS bytea
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN (SELECT string_agg(substring(int8send(value) FROM 8 - i FOR 1), '' ORDER BY i) FROM generate_series(0, 3) i);
COMMENT ON FUNCTION streetgen._gltf_word(bigint) IS 'A whole number below 2^32 as four bytes, the lowest first.';

CREATE OR REPLACE FUNCTION streetgen._linear_colour(colour text) RETURNS float8[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(round(CASE WHEN v <= 0.04045 THEN v / 12.92 ELSE ((v + 0.055) / 1.055) ^ 2.4 END, 4)::float8
            ORDER BY n) || 1::float8
        FROM generate_series(0, 2) n, decode(substr(colour, 2), 'hex') c, LATERAL (SELECT get_byte(c, n) / 255.0 AS v) s
    $$;
COMMENT ON FUNCTION streetgen._linear_colour(text) IS
    'The colour of a rule (sRGB) as glTF has it: linear red, green and blue, 0 to 1, and 1 for opaque.';

CREATE OR REPLACE FUNCTION streetgen.export_gltf(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, part bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'gltf', 'surface', options);
BEGIN
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, known)),
    block AS MATERIALIZED (
        SELECT b.*, row_number() OVER place - 1 AS number, sum(length(bytes)) OVER place - length(bytes) AS start
        FROM origin o, streetgen._gltf_blocks(model, known, o.x, o.y) b WINDOW place AS (ORDER BY cell, kind)),
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
    -- As one sees it from near.
    paint AS (SELECT DISTINCT ON (layer) layer, fill FROM streetgen._symbols(model, 'street', 1) s
        WHERE s.kind = '' AND marker IS NULL AND fill IS NOT NULL ORDER BY layer, symbol DESC),
    told AS MATERIALIZED (
        SELECT turn, number / 1000 AS id, convert_to(CASE WHEN number / 1000 > 0 THEN ', ' ELSE '' END
            || string_agg(text, ', ' ORDER BY number), 'UTF8') AS bytes
        FROM element GROUP BY turn, number / 1000
        UNION ALL SELECT turn, 0, convert_to(text, 'UTF8') FROM origin o, size, LATERAL (VALUES
            (1, '{"asset" : ' || json_build_object('version', '2.0', 'generator', 'StreetGen ' || streetgen.version(),
                'extras', json_build_object('model', streetgen._xml_text(model), 'srid', o.srid, 'origin',
                    json_build_array(o.x, o.y, 0), 'axes', 'x east, y up, z south, metres'))
                || ', "scene" : 0, "scenes" : [{"nodes" : ['),
            (3, ']}], "nodes" : ['), (5, '], "meshes" : ['),
            (7, '], "materials" : ' || (SELECT json_agg(json_strip_nulls(json_build_object('name', k.kind,
                'pbrMetallicRoughness', json_build_object('baseColorFactor', streetgen._linear_colour(fill),
                    'metallicFactor', 0, 'roughnessFactor', roughness))) ORDER BY number)
                FROM streetgen._mesh_kind() k LEFT JOIN paint p ON layer = k.kind) || ', "accessors" : ['),
            (9, '], "bufferViews" : ['),
            (11, '], "buffers" : ' || json_build_array(json_build_object('byteLength', size.bytes)) || '}')) t(turn,
                text)),
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
    FROM piece, generate_series(0, length(bytes) - 1, 1048576) start ORDER BY turn, id, start;
END $$;
COMMENT ON FUNCTION streetgen.export_gltf(name, jsonb) IS
    'A binary file of glTF 2.0 (.glb), in parts of at most 1 MB that follow each other. What streets consist of has a '
    'material each, in the colour of theme street: section, intersection, sidewalk and kerb (subject sidewalk), '
    'marking (subject lane). Sidewalks lie '
    '0.15 m above the roadway and kerbs close the step; paint lies above the roadway by 5 mm and twice the tolerance. '
    'Heights, normals and texture coordinates, metres, are those of streetgen.road_mesh. x is to the east, y up, z to '
    'the south. Positions are floats, counted from whole metres that extras of the asset name with the SRID; a float '
    'resolves a millimetre ten kilometres from there. A node is a square of 500 m. options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
