-- glTF 2.0 in one binary file: streets to look at.

CREATE OR REPLACE FUNCTION streetgen._gltf_mesh(surfaces bytea[], levels integer[], wanted boolean[], raised float8[],
    lines bytea[], axes bytea[], axis_levels integer[], axis_widths float8[], tolerance float8, parts integer[],
    kerb_parts integer[], x float8, y float8, z float8)
    RETURNS TABLE(part integer, vertices bigint, indices bigint, lowest real[], highest real[], bytes bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 5 AS 'MODULE_PATHNAME', 'streetgen_gltf_mesh';
COMMENT ON FUNCTION streetgen._gltf_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[], float8[],
    float8, integer[], integer[], float8, float8, float8) IS
    'The meshes that streetgen._road_mesh makes of its arguments as data of glTF, one row for each part: parts has '
    'that of each surface, kerb_parts that of its kerbs. Counted from an origin x, y, z; y of the file is up, z to the '
    'south. lowest and highest: the box of the positions. bytes: positions, normals, texture coordinates, indices.';

CREATE OR REPLACE FUNCTION streetgen._gltf_blocks(model name, options jsonb, x float8, y float8, z float8,
    edges bigint[], nodes bigint[], about geometry)
    RETURNS TABLE(cell integer, edge_id bigint, node_id bigint, material integer, vertices bigint, indices bigint,
        lowest real[], highest real[], bytes bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    part record;
    by_street constant boolean := options ->> 'nodes' = 'street';
    layers constant text[] := ARRAY(SELECT l.layer FROM streetgen._mesh_layer() l);
    names constant text[] := streetgen._mesh_names(model);
    kerb_material constant integer := array_position(names, 'kerb') - 1;
BEGIN
    FOR part IN SELECT 1 AS cell, _gltf_blocks.edges, _gltf_blocks.nodes, _gltf_blocks.about
        WHERE _gltf_blocks.edges IS NOT NULL
        UNION ALL (SELECT c.cell, c.edges, c.nodes, c.about FROM streetgen._mesh_cells(model, options) c
            WHERE _gltf_blocks.edges IS NULL ORDER BY c.cell)
    LOOP
        RETURN QUERY WITH heights AS MATERIALIZED (SELECT * FROM streetgen._mesh_heights(model, part.about)),
        laid AS MATERIALIZED (SELECT l.* FROM heights a, streetgen._mesh_laid(model, part.edges, part.nodes, layers,
            names, options, streetgen._mesh_lift(a.axes, options)) l),
        -- A part is one material, of one street where streets are nodes.
        owner AS MATERIALIZED (
            SELECT n, u.edge_id, u.node_id, u.material,
                CASE WHEN by_street THEN dense_rank() OVER (ORDER BY u.edge_id, u.node_id)::integer ELSE 1 END AS owner
            FROM laid l, unnest(l.edge_ids, l.node_ids, l.materials) WITH ORDINALITY u(edge_id, node_id, material, n)),
        parts AS (SELECT array_agg(1000 * owner + material ORDER BY n) AS parts,
            array_agg(1000 * owner + kerb_material ORDER BY n) AS kerb_parts FROM owner)
        SELECT part.cell, o.edge_id, o.node_id, t.part % 1000, t.vertices, t.indices, t.lowest, t.highest, t.bytes
        FROM heights a, laid l, parts p,
            streetgen._gltf_mesh(l.surfaces, l.levels, l.wanted, l.raised, l.lines, a.axes, a.axis_levels,
                a.axis_widths, (options ->> 'tolerance')::float8, p.parts, p.kerb_parts, x, y, z) t
            LEFT JOIN (SELECT DISTINCT owner, edge_id, node_id FROM owner WHERE by_street) o ON o.owner = t.part / 1000
        ORDER BY t.part;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._gltf_blocks(name, jsonb, float8, float8, float8, bigint[], bigint[], geometry) IS
    'The data of a file of glTF: a row for each material of each square, or of each edge and node in it, counted from '
    'an origin. edges, nodes and about are those of one square alone; NULL: of all.';

CREATE OR REPLACE FUNCTION streetgen._gltf_shape(kind text)
    RETURNS TABLE(part integer, vertices bigint, indices bigint, lowest real[], highest real[], bytes bytea)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 100 ROWS 2 AS 'MODULE_PATHNAME', 'streetgen_gltf_shape';
COMMENT ON FUNCTION streetgen._gltf_shape(text) IS
    'The shape of objects of a kind as data of glTF about its foot: its post (part 0) and its head (1), which looks to '
    'the north. No row for what lies in the ground.';

CREATE OR REPLACE FUNCTION streetgen._gltf_objects(model name, edges bigint[], about geometry, options jsonb)
    RETURNS TABLE(name text, kind text, shape text, place geometry, angle float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    subjects constant text[] := streetgen._subjects(model);
    written constant bigint[] := coalesce(edges, ARRAY(SELECT streetgen._written_edges(model, options)));
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' = ANY (subjects) THEN
        RETURN QUERY WITH drawn AS MATERIALIZED (SELECT k.kind, k.drawn_as
            FROM streetgen._drawn_kinds(model, 'street', 1) k WHERE k.layer = 'object')
        SELECT o.type || '_' || o.street_object_id, coalesce(k.drawn_as, ''), coalesce(k.drawn_as, ''),
            streetgen._raised_place(o.geom, h.geom), o.angle
        FROM street_object o LEFT JOIN drawn k ON k.kind = o.type
            LEFT JOIN object_edge b ON b.street_object_id = o.street_object_id
            -- The nearest street may be the one below a bridge.
            CROSS JOIN LATERAL (SELECT b.edge_id WHERE b.edge_id IS NOT NULL
                UNION ALL (SELECT n.edge_id FROM edge n WHERE b.edge_id IS NULL AND ST_DWithin(n.geom, o.geom, 50)
                    ORDER BY ST_Distance(n.geom, o.geom), n.edge_id LIMIT 1)) e
            LEFT JOIN streetgen._heights_along(model) h ON h.edge_id = e.edge_id
        -- A control point lies on the axis, where its traffic obeys it.
        WHERE e.edge_id = ANY (written) AND (about IS NULL OR o.geom && ST_Expand(about, 50))
            AND GeometryType(o.geom) = 'POINT' AND o.control_point_id IS NULL
            AND o.type <> ALL (_types_below('crossing') || _types_below('parking_bay'))
        ORDER BY o.street_object_id;
    END IF;
    IF 'signal' = ANY (subjects) THEN
        RETURN QUERY SELECT 'signal_' || s.lane_id, 'traffic_light'::text, 'signal'::text,
            streetgen._raised_place(s.geom, h.geom), s.angle + 180
        FROM signal_head s JOIN lane l USING (lane_id)
            LEFT JOIN streetgen._heights_along(model) h ON h.edge_id = l.edge_id
        WHERE l.edge_id = ANY (written) ORDER BY s.lane_id, s.along_axis;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._gltf_objects(name, bigint[], geometry, jsonb) IS
    'The objects and lights at edges about a box (NULL: those that options take), each at the edge that its axis gives '
    'it, else at the nearest one: what they are drawn as, their shape, '
    'their place (POINT Z) and where they look, degrees clockwise from north.';

CREATE OR REPLACE FUNCTION streetgen._raised_place(place geometry, line geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_SetSRID(ST_MakePoint(ST_X(place), ST_Y(place), coalesce(ST_Z(ST_LineInterpolatePoint(line,
        ST_LineLocatePoint(line, place))), 0)), ST_SRID(place)) $$;
COMMENT ON FUNCTION streetgen._raised_place(geometry, geometry) IS
    'A POINT with the height of the nearest place of a LINESTRING Z; 0 without one.';

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

CREATE OR REPLACE FUNCTION streetgen._gltf_file(model name, options jsonb, x float8, y float8, z float8,
    edges bigint[], nodes bigint[], about geometry) RETURNS TABLE(ordinality bigint, part bytea)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH object AS MATERIALIZED (SELECT * FROM streetgen._gltf_objects(model, edges, about, options)),
    every_material AS MATERIALIZED (SELECT * FROM streetgen._mesh_material(model)),
    -- A shape is one mesh, however many objects have it.
    block AS MATERIALIZED (
        SELECT b.*, dense_rank() OVER (ORDER BY cell, edge_id, node_id, shape) - 1 AS mesh,
            row_number() OVER place - 1 AS number, sum(length(bytes)) OVER place - length(bytes) AS start
        FROM (SELECT g.cell, g.edge_id, g.node_id, NULL::text AS shape, 0 AS part, g.material, g.vertices, g.indices,
                g.lowest, g.highest, g.bytes
            FROM streetgen._gltf_blocks(model, options, x, y, z, edges, nodes, about) g
            UNION ALL SELECT NULL, NULL, NULL, k.shape, s.part, m.number, s.vertices, s.indices, s.lowest, s.highest,
                s.bytes
            FROM (SELECT DISTINCT o.kind, o.shape FROM object o) k CROSS JOIN LATERAL streetgen._gltf_shape(k.shape) s
                CROSS JOIN LATERAL (SELECT m.number FROM every_material m WHERE m.layer = 'object'
                    AND m.kind IN ('', CASE s.part WHEN 1 THEN k.kind ELSE '' END) ORDER BY m.kind DESC LIMIT 1) m) b
        WINDOW place AS (ORDER BY cell, edge_id, node_id, shape, material, part)),
    material AS MATERIALIZED (
        SELECT m.*, row_number() OVER (ORDER BY number) - 1 AS place FROM every_material m
        WHERE number IN (SELECT material FROM block)),
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
        SELECT mesh AS number, shape, coalesce('edge_' || edge_id, 'node_' || node_id, 'cell_' || cell,
                nullif(shape, ''), 'object') AS name,
            CASE WHEN num_nonnulls(edge_id, node_id) > 0 THEN json_build_object('edge_id', edge_id, 'node_id', node_id,
                'name', min(a.name), 'class', min(a.kind)) END AS extras,
            json_agg(json_build_object('attributes', json_build_object('POSITION', 4 * number,
                'NORMAL', 4 * number + 1, 'TEXCOORD_0', 4 * number + 2), 'indices', 4 * number + 3,
                'material', place) ORDER BY number) AS primitives
        FROM (SELECT b.*, m.place FROM block b JOIN material m ON m.number = material) b LEFT JOIN (
            SELECT edge_id, streetgen._xml_text(name) AS name, streetgen._xml_text(kind) AS kind
            FROM edge JOIN axis USING (axis_id) WHERE edge_id IN (SELECT s.edge_id FROM block s)) a USING (edge_id)
        GROUP BY mesh, cell, edge_id, node_id, shape),
    node AS MATERIALIZED (
        SELECT number, json_strip_nulls(json_build_object('name', name, 'mesh', number, 'extras', extras)) AS node
        FROM mesh WHERE shape IS NULL
        UNION ALL SELECT (SELECT count(*) FROM mesh WHERE shape IS NULL)
                + row_number() OVER (ORDER BY o.name, o.shape) - 1,
            json_build_object('name', streetgen._xml_text(o.name), 'mesh', m.number, 'translation', json_build_array(
                round((ST_X(o.place) - x)::numeric, 3), round((ST_Z(o.place) - z)::numeric, 3),
                round((y - ST_Y(o.place))::numeric, 3)), 'rotation', json_build_array(0,
                round(sind(-turned / 2)::numeric, 6), 0, round(cosd(turned / 2)::numeric, 6)))
        FROM object o JOIN mesh m ON m.shape = o.shape CROSS JOIN LATERAL (SELECT coalesce(o.angle, 0) AS turned) t),
    -- A list of thousands of elements in one value would be copied many times: it is written piece by piece.
    element AS (
        SELECT 2 AS turn, number, number::text AS text FROM node UNION ALL SELECT 4, number, node::text FROM node
        UNION ALL SELECT 6, number, json_build_object('name', name, 'primitives', primitives)::text FROM mesh
        UNION ALL SELECT 8, 4 * number + k, json_strip_nulls(json_build_object('bufferView', 4 * number + k,
            'componentType', component, 'count', count, 'type', type, 'min', low, 'max', high))::text FROM view
        UNION ALL SELECT 10, 4 * number + k, json_build_object('buffer', 0, 'byteOffset', start + after, 'byteLength',
            bytes, 'target', target)::text FROM view),
    told AS MATERIALIZED (
        SELECT turn, number / 1000 AS id, convert_to(CASE WHEN number / 1000 > 0 THEN ', ' ELSE '' END
            || string_agg(text, ', ' ORDER BY number), 'UTF8') AS bytes
        FROM element GROUP BY turn, number / 1000
        UNION ALL SELECT turn, 0, convert_to(text, 'UTF8') FROM size, LATERAL (VALUES
            (1, '{"asset" : ' || json_build_object('version', '2.0', 'generator', 'StreetGen ' || streetgen.version(),
                'extras', json_build_object('model', streetgen._xml_text(model), 'srid', srid, 'origin',
                    json_build_array(x, y, z), 'axes', 'x east, y up, z south, metres'))
                || ', "scene" : 0, "scenes" : [{"nodes" : ['),
            (3, ']}], "nodes" : ['), (5, '], "meshes" : ['),
            (7, '], "materials" : ' || (SELECT json_agg(json_strip_nulls(json_build_object('name', m.name,
                'pbrMetallicRoughness', json_build_object('baseColorFactor', streetgen._linear_colour(fill),
                    'metallicFactor', 0, 'roughnessFactor', roughness))) ORDER BY place) FROM material m)
                || ', "accessors" : ['),
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
COMMENT ON FUNCTION streetgen._gltf_file(name, jsonb, float8, float8, float8, bigint[], bigint[], geometry) IS
    'A file of glTF with the edges and nodes of one square (NULL: all), counted from an origin, in parts that '
    'follow each other.';

CREATE OR REPLACE FUNCTION streetgen.export_gltf(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, part bytea)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
    SELECT f.* FROM streetgen._begin_export(model, 'gltf', 'surface', options) known,
        streetgen._export_origin(model, known) o,
        streetgen._gltf_file(model, known, o.x, o.y, o.z, NULL, NULL, NULL) f $$;
COMMENT ON FUNCTION streetgen.export_gltf(name, jsonb) IS
    'A binary file of glTF 2.0 (.glb), in parts of at most 1 MB that follow each other. What streets consist of has a '
    'material each, in the colour of theme street, and so have the kinds that it draws by themselves: section, '
    'section_stone, intersection, sidewalk and kerb (subject sidewalk), lane_cycle, lane_separator and marking (lane), '
    'crossing, bay and refuge (object), block (block) and others. Sidewalks lie 0.15 m above the roadway, blocks '
    '0.13 m, and kerbs close the step. Paint lies above the roadway by 5 mm and, where streets have heights, twice the '
    'tolerance. Heights, normals and texture coordinates, metres, are those of streetgen.road_mesh. x is to the east, '
    'y up, z to the south. Positions are floats, counted from an origin that extras of the asset name with the SRID; a '
    'float resolves a millimetre ten kilometres from there. A node is a square of 500 m, or by option nodes each edge '
    'and each node of the model, whose extras have its id, name and class. An object (subject object) is a node with '
    'the mesh of its kind: tree, lamp, sign, bollard and others; so are signals (signal), which hang over their lanes. '
    'options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
