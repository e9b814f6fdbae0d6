-- CityJSON 2.0: roads with the surfaces that traffic uses.

CREATE OR REPLACE FUNCTION streetgen._cityjson_surface()
    RETURNS TABLE(number integer, layer text, type text, function text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 9 SET search_path = pg_catalog
    AS $$ VALUES (0, 'section', 'TrafficArea', 'roadway'), (1, 'intersection', 'TrafficArea', 'roadway'),
        (2, 'sidewalk', 'TrafficArea', 'footpath'), (3, 'kerb', 'AuxiliaryTrafficArea', 'kerbstone'),
        (4, 'lane_separator', 'TransportationMarking', 'lane line'), (5, 'marking', 'TransportationMarking', 'marking'),
        (6, 'rim_marking', 'TransportationMarking', 'marking'), (7, 'crossing', 'TransportationMarking', 'crossing'),
        (8, 'bus_stop_box', 'TransportationMarking', 'bus stop') $$;
COMMENT ON FUNCTION streetgen._cityjson_surface() IS
    'What the layers of a mesh of streets are in CityJSON: semantic type and function.';

CREATE OR REPLACE FUNCTION streetgen._cityjson_boundaries(triangles integer[], corners integer[], places bigint[])
    RETURNS TABLE(mesh integer, boundaries text)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_cityjson_boundaries';
COMMENT ON FUNCTION streetgen._cityjson_boundaries(integer[], integer[], bigint[]) IS
    'The boundaries of each mesh of streetgen._indexed_mesh; places are the numbers of these in the file.';

CREATE OR REPLACE FUNCTION streetgen.export_cityjson(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000
    SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'cityjson', 'surface', options);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH origin AS MATERIALIZED (SELECT * FROM streetgen._export_origin(model, known)),
    block AS MATERIALIZED (
        SELECT b.* FROM origin o, streetgen._indexed_blocks(model, ARRAY(SELECT s.layer
            FROM streetgen._cityjson_surface() s), known, o.x, o.y, o.z, o.digits, false) b),
    -- A place is one vertex, whatever square it lies in.
    vertex AS MATERIALIZED (
        SELECT cell, n, place, dense_rank() OVER (ORDER BY place COLLATE "C") - 1 AS number
        FROM block, unnest(places) WITH ORDINALITY p(place, n)),
    numbered AS (SELECT cell, array_agg(number ORDER BY n) AS numbers FROM vertex GROUP BY cell),
    surface AS MATERIALIZED (
        SELECT edge_ids[mesh] AS edge_id, node_ids[mesh] AS node_id, s.number AS semantic, ids[mesh] AS id, boundaries,
            triangles[mesh] AS triangles
        FROM block JOIN numbered USING (cell)
            CROSS JOIN LATERAL streetgen._cityjson_boundaries(triangles, corners, numbers)
            JOIN streetgen._mesh_material(model) m ON m.number = materials[mesh]
            JOIN streetgen._cityjson_surface() s USING (layer)),
    road AS (
        SELECT edge_id, node_id, string_agg(boundaries, ',' ORDER BY semantic, id) AS boundaries,
            string_agg(left(repeat(place || ',', triangles), -1), ',' ORDER BY semantic, id) AS of_surface,
            array_agg(DISTINCT semantic) AS semantics
        FROM (SELECT *, dense_rank() OVER (PARTITION BY edge_id, node_id ORDER BY semantic) - 1 AS place
            FROM surface) t
        GROUP BY edge_id, node_id),
    object AS (
        SELECT r.edge_id, r.node_id, format('"%s":{"type":"Road","attributes":%s,"geometry":[{"type":"MultiSurface",'
                '"lod":"2","boundaries":[%s],"semantics":{"surfaces":%s,"values":[%s]}}]}',
            coalesce('edge_' || r.edge_id, 'node_' || r.node_id), json_strip_nulls(json_build_object('edge_id',
                r.edge_id,
                'node_id', r.node_id, 'name', streetgen._xml_text(a.name), 'class', streetgen._xml_text(a.kind),
                'importance', e.importance, 'level', e.level, 'width', e.width, 'speed', e.speed)),
            boundaries, surfaces, of_surface) AS text
        FROM road r LEFT JOIN edge e ON e.edge_id = r.edge_id LEFT JOIN axis a USING (axis_id), LATERAL (
            SELECT json_agg(json_strip_nulls(json_build_object('type', type, 'function', function, 'surfaceMaterial',
                CASE layer WHEN 'section' THEN roadway WHEN 'sidewalk' THEN CASE sidewalk_left WHEN sidewalk_right
                    THEN sidewalk_left END END)) ORDER BY number) AS surfaces
            FROM streetgen._cityjson_surface() LEFT JOIN paving p ON p.edge_id = r.edge_id
            WHERE number = ANY (semantics)) m),
    box AS (
        SELECT json_build_array(min(place[1]) * step + o.x, min(place[2]) * step + o.y, min(place[3]) * step + o.z,
            max(place[1]) * step + o.x, max(place[2]) * step + o.y, max(place[3]) * step + o.z) AS extent,
            json_build_object('scale', json_build_array(step, step, step), 'translate', json_build_array(o.x, o.y, o.z))
                AS transform
        FROM (SELECT string_to_array(v.place, ',')::bigint[] AS place FROM vertex v) v, origin o,
            LATERAL (SELECT round(10::numeric ^ -digits, digits) AS step) s GROUP BY step, o.x, o.y, o.z),
    line AS (
        SELECT 1 AS turn, 0::bigint AS id, 0 AS part, format('{"type":"CityJSON","version":"2.0","transform":%s,'
            '"metadata":%s,"CityObjects":{', transform, json_strip_nulls(json_build_object('geographicalExtent', extent,
                'referenceSystem', 'https://www.opengis.net/def/crs/EPSG/0/'
                    || CASE auth_name WHEN 'EPSG' THEN auth_srid END, 'title', streetgen._xml_text(model)))) AS text
        FROM box CROSS JOIN origin LEFT JOIN spatial_ref_sys USING (srid)
        UNION ALL
        SELECT 2, coalesce(edge_id, node_id), CASE WHEN edge_id IS NULL THEN 1 ELSE 0 END,
            text || CASE WHEN lead(true) OVER (ORDER BY node_id NULLS FIRST, edge_id) THEN ',' ELSE '' END FROM object
        UNION ALL SELECT 3, 0, 0, '},"vertices":['
        UNION ALL
        SELECT 4, number, 0, '[' || place || CASE WHEN lead(true) OVER (ORDER BY number) THEN '],' ELSE ']' END
        FROM (SELECT DISTINCT ON (number) number, place FROM vertex ORDER BY number) v
        UNION ALL SELECT 5, 0, 0, ']}')
    SELECT row_number() OVER (ORDER BY turn, part, id), text FROM line ORDER BY turn, part, id;
END $$;
COMMENT ON FUNCTION streetgen.export_cityjson(name, jsonb) IS
    'A file of CityJSON 2.0, line by line. Each edge and each node is a Road (edge_ID, node_ID) with one geometry of '
    'lod 2, a MultiSurface of triangles: the roadway of its section or intersection (TrafficArea, roadway) and, of a '
    'model with subject sidewalk, the sidewalks (TrafficArea, footpath), 0.15 m above it, and their kerbs '
    '(AuxiliaryTrafficArea, kerbstone), which are upright. Paint is TransportationMarking: lines between lanes, '
    'markings, crossings and boxes of bus stops; it lies above the roadway by 5 mm and, where streets have heights, '
    'twice the tolerance. Neighbours share vertices. Heights are those of streetgen.road_mesh. Vertices are whole '
    'steps of the precision from the origin in transform, and no place has two. options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
