-- CityJSON 2.0: roads with the surfaces that traffic uses.

CREATE OR REPLACE FUNCTION streetgen._cityjson_surface()
    RETURNS TABLE(number integer, kind text, type text, function text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES (0, 'section', 'TrafficArea', 'roadway'), (1, 'intersection', 'TrafficArea', 'roadway'),
        (2, 'sidewalk', 'TrafficArea', 'footpath'), (3, 'kerb', 'AuxiliaryTrafficArea', 'kerbstone') $$;
COMMENT ON FUNCTION streetgen._cityjson_surface() IS
    'What the kinds of surfaces of streets are in CityJSON: semantic type and function.';

CREATE OR REPLACE FUNCTION streetgen._cityjson_place(place geometry, x float8, y float8, steps float8)
    RETURNS bigint[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN ARRAY[round((ST_X(place) - x) * steps)::bigint, round((ST_Y(place) - y) * steps)::bigint,
        round(ST_Z(place) * steps)::bigint];
COMMENT ON FUNCTION streetgen._cityjson_place(geometry, float8, float8, float8) IS
    'A point as whole steps from an origin, so many of them a metre.';

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
    -- A place is one vertex, counted in steps of the precision. A triangle that they leave no ground is left out.
    rounded AS MATERIALIZED (
        SELECT m.edge_id, m.node_id, s.number AS semantic, m.id, t.path[1] AS triangle,
            streetgen._cityjson_place(ST_PointN(ring, 1), x, y, steps) AS a,
            streetgen._cityjson_place(ST_PointN(ring, 2), x, y, steps) AS b,
            streetgen._cityjson_place(ST_PointN(ring, 3), x, y, steps) AS c
        FROM origin, streetgen._street_mesh(model, known) m JOIN streetgen._cityjson_surface() s USING (kind),
            LATERAL (SELECT 10::float8 ^ digits AS steps OFFSET 0) d, LATERAL ST_Dump(m.mesh) t,
            LATERAL (SELECT ST_ExteriorRing(t.geom) AS ring OFFSET 0) r),
    corner AS MATERIALIZED (
        SELECT edge_id, node_id, semantic, id, triangle, k, dense_rank() OVER (ORDER BY place) - 1 AS vertex, place
        FROM (SELECT *, CASE k WHEN 1 THEN a WHEN 2 THEN b ELSE c END AS place FROM rounded, generate_series(1, 3) k
            WHERE a <> b AND b <> c AND c <> a) r),
    triangle AS (
        SELECT edge_id, node_id, semantic, id, triangle, string_agg(vertex::text, ',' ORDER BY k) AS ring FROM corner
        GROUP BY edge_id, node_id, semantic, id, triangle),
    road AS (
        SELECT edge_id, node_id, string_agg('[[' || ring || ']]', ',' ORDER BY semantic, id, triangle) AS boundaries,
            string_agg(place::text, ',' ORDER BY semantic, id, triangle) AS of_surface,
            array_agg(DISTINCT semantic) AS semantics
        FROM (SELECT *, dense_rank() OVER (PARTITION BY edge_id, node_id ORDER BY semantic) - 1 AS place
            FROM triangle) t
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
                CASE kind WHEN 'section' THEN roadway WHEN 'sidewalk' THEN CASE sidewalk_left WHEN sidewalk_right
                    THEN sidewalk_left END END)) ORDER BY number) AS surfaces
            FROM streetgen._cityjson_surface() LEFT JOIN paving p ON p.edge_id = r.edge_id
            WHERE number = ANY (semantics)) m),
    box AS (
        SELECT json_build_array(min(place[1]) * step + o.x, min(place[2]) * step + o.y, min(place[3]) * step,
            max(place[1]) * step + o.x, max(place[2]) * step + o.y, max(place[3]) * step) AS extent,
            json_build_object('scale', json_build_array(step, step, step), 'translate', json_build_array(o.x, o.y, 0))
                AS transform
        FROM corner, origin o, LATERAL (SELECT round(10::numeric ^ -digits, digits) AS step) s GROUP BY step, o.x, o.y),
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
        SELECT 4, vertex, 0, format('[%s]', array_to_string(place, ','))
            || CASE WHEN lead(true) OVER (ORDER BY vertex) THEN ',' ELSE '' END
        FROM (SELECT DISTINCT vertex, place FROM corner) v
        UNION ALL SELECT 5, 0, 0, ']}')
    SELECT row_number() OVER (ORDER BY turn, part, id), text FROM line ORDER BY turn, part, id;
END $$;
COMMENT ON FUNCTION streetgen.export_cityjson(name, jsonb) IS
    'A file of CityJSON 2.0, line by line. Each edge and each node is a Road (edge_ID, node_ID) with one geometry of '
    'lod 2, a MultiSurface of triangles: the roadway of its section or intersection (TrafficArea, roadway) and, of a '
    'model with subject sidewalk, the sidewalks (TrafficArea, footpath), 0.15 m above it, and their kerbs '
    '(AuxiliaryTrafficArea, kerbstone), which are upright. Neighbours share vertices. Heights are those of '
    'streetgen.road_mesh. Vertices are whole steps of the precision from the whole metres of transform, and no place '
    'has two. What a model computes beyond this, as lanes and paint, is not written. options as '
    'streetgen.export_option() lists them: an unknown one, or no edge that they take: 22023. A caller who may not read '
    'the model: 42501. What is stale is written as it was, with a warning.';
