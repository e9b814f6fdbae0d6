-- Wavefront OBJ: streets as objects of triangles, with a file of their materials.

CREATE OR REPLACE FUNCTION streetgen._wavefront_faces(triangles integer[], corners integer[], places bigint[],
    texture_before bigint, normals_before bigint) RETURNS TABLE(mesh integer, faces text)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_wavefront_faces';
COMMENT ON FUNCTION streetgen._wavefront_faces(integer[], integer[], bigint[], bigint, bigint) IS
    'The faces of each mesh of streetgen._indexed_mesh; places are the numbers of these in the file, and so many '
    'texture coordinates and normals of others come before.';

CREATE OR REPLACE FUNCTION streetgen._wavefront_name(name text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT regexp_replace(name, '[\s[:cntrl:]]', '_', 'g') $$;
COMMENT ON FUNCTION streetgen._wavefront_name(text) IS
    'The name of a material as one word of one line: a kind of symbol_rule may have spaces.';

CREATE OR REPLACE FUNCTION streetgen._wavefront_materials(model name) RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 60 SET search_path = pg_catalog
    AS $$ SELECT number::bigint + 1, concat('newmtl ', streetgen._wavefront_name(name), E'\nKd ' || (
            SELECT string_agg(round(get_byte(decode(substr(fill, 2), 'hex'), n) / 255.0, 4)::text, ' ' ORDER BY n)
            FROM generate_series(0, 2) n), E'\nKs 0 0 0\nillum 1\n')
        FROM streetgen._mesh_material(model) $$;
COMMENT ON FUNCTION streetgen._wavefront_materials(name) IS
    'The lines of a file of materials: the colours of theme street.';

CREATE OR REPLACE FUNCTION streetgen._wavefront_objects(model name, options jsonb)
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, options)),
    block AS MATERIALIZED (
        SELECT b.*, sum(cardinality(b.texture)) OVER before - cardinality(b.texture) AS texture_before,
            sum(cardinality(b.normals)) OVER before - cardinality(b.normals) AS normals_before
        FROM origin o, streetgen._indexed_blocks(model, ARRAY(SELECT l.layer FROM streetgen._mesh_layer() l),
            options, o.x, o.y, o.z, o.digits, true) b WINDOW before AS (ORDER BY b.cell)),
    -- A place is one vertex, whatever square it lies in.
    vertex AS MATERIALIZED (
        SELECT cell, n, place, dense_rank() OVER (ORDER BY place COLLATE "C") AS number
        FROM block, unnest(places) WITH ORDINALITY p(place, n)),
    numbered AS (SELECT cell, array_agg(number ORDER BY n) AS numbers FROM vertex GROUP BY cell),
    surface AS MATERIALIZED (
        SELECT cell, edge_ids[mesh] AS edge_id, node_ids[mesh] AS node_id, m.number, ids[mesh] AS id, faces,
            streetgen._wavefront_name(m.name) AS name
        FROM block JOIN numbered USING (cell) CROSS JOIN LATERAL streetgen._wavefront_faces(triangles, corners, numbers,
                texture_before::bigint, normals_before::bigint)
            JOIN streetgen._mesh_material(model) m ON m.number = materials[mesh]),
    line AS (
        SELECT 1 AS turn, 0 AS cell, 0::bigint AS id, 0::bigint AS number, format(
            E'# Streets of model %s by StreetGen %s\n# SRID %s, metres, x to the east, y to the north, z up\n'
            '# origin %s %s %s, to be added to each vertex', translate(model, E'\n\r', '  '), streetgen.version(),
            o.srid, o.x, o.y, o.z) AS text
        FROM origin o
        UNION ALL SELECT 2, 0, 0, v.number, 'v ' || place
        FROM (SELECT DISTINCT ON (d.number) d.number, d.place FROM vertex d ORDER BY d.number) v
        UNION ALL SELECT 3, b.cell, 0, n, 'vt ' || t FROM block b, unnest(b.texture) WITH ORDINALITY u(t, n)
        UNION ALL SELECT 4, b.cell, 0, n, 'vn ' || t FROM block b, unnest(b.normals) WITH ORDINALITY u(t, n)
        UNION ALL SELECT 5, s.cell, coalesce(2 * edge_id, 2 * node_id + 1), row_number() OVER (PARTITION BY edge_id,
                node_id ORDER BY s.number, s.id),
            CASE WHEN lag(s.number) OVER street IS NULL THEN 'o ' || coalesce('edge_' || edge_id, 'node_' || node_id)
                || E'\n' ELSE '' END
            || CASE WHEN lag(s.number) OVER street IS DISTINCT FROM s.number THEN 'usemtl ' || s.name || E'\n'
                ELSE '' END || faces
        FROM surface s WINDOW street AS (PARTITION BY edge_id, node_id ORDER BY s.number, s.id))
    SELECT row_number() OVER (ORDER BY l.turn, l.cell, l.id, l.number), l.text FROM line l
    ORDER BY l.turn, l.cell, l.id, l.number;
END $$;
COMMENT ON FUNCTION streetgen._wavefront_objects(name, jsonb) IS
    'The lines of a file of triangles: vertices, texture coordinates and normals, then an object for each edge and '
    'each node.';

CREATE OR REPLACE FUNCTION streetgen.export_wavefront(model name, part text, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'wavefront', 'surface', options);
BEGIN
    PERFORM streetgen._check_given('part', part);
    CASE part WHEN 'objects' THEN RETURN QUERY SELECT * FROM streetgen._wavefront_objects(model, known);
        WHEN 'materials' THEN RETURN QUERY SELECT * FROM streetgen._wavefront_materials(model);
        ELSE RAISE EXCEPTION 'format wavefront has no part "%"', part USING ERRCODE = '22023',
            HINT = 'Its parts are objects, materials.';
    END CASE;
END $$;
COMMENT ON FUNCTION streetgen.export_wavefront(name, text, jsonb) IS
    'Wavefront files, line by line: part objects is the .obj, part materials its .mtl. Each edge and each node is an '
    'object (edge_ID, node_ID) of triangles: roadway, sidewalks with their kerbs, blocks, and paint and what else '
    'covers the ground, each with a material, as streetgen.export_gltf has them. A place is one vertex, with texture '
    'coordinates in metres along the edge and to its left, and normals. x is to the east, y to the north, z up, '
    'counted from an origin that the first lines name with the SRID. A line mtllib, which names the .mtl, is not '
    'among them. options as streetgen.export_option() lists them: an unknown one, another part, or no edge that '
    'they take: 22023. A caller who may not read the model: 42501. What is stale is written as it was, with a warning.';
