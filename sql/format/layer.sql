CREATE OR REPLACE FUNCTION streetgen._for_exchange(geom geometry, wgs84 boolean) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN NOT wgs84 THEN snapped WHEN flat THEN ST_ReducePrecision(ST_Transform(snapped, 4326), 1e-11)
        ELSE ST_Transform(snapped, 4326) END
    FROM (SELECT ST_Dimension(geom) = 2 AND ST_NDims(geom) = 2 AS flat) k,
        LATERAL (SELECT CASE WHEN flat THEN ST_ReducePrecision(geom, 1e-6) ELSE geom END AS snapped) s
    $$;
COMMENT ON FUNCTION streetgen._for_exchange(geometry, boolean) IS
    'A geometry as files carry it, in its own reference or in WGS 84. Surfaces come on a grid of 1e-6 m or 1e-11 '
    'degrees, a micrometre either way, so that what reads, rounds or projects them again finds them valid. Triangles '
    'share their vertices as they are.';

CREATE OR REPLACE FUNCTION streetgen._format_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'road_meshes', 'MULTIPOLYGONZ', false,
        'coalesce(2 * edge_id, 2 * node_id + 1) AS id, edge_id, node_id, road_id, level', 'triangles',
        'road_edge RIGHT JOIN streetgen.road_mesh(%1$L) USING (edge_id), LATERAL (SELECT ST_Collect(ST_MakePolygon('
        'ST_ExteriorRing(t.geom)) ORDER BY path) AS triangles FROM ST_Dump(geom) t) t') $$;
COMMENT ON FUNCTION streetgen._format_layer() IS 'The layer of meshes in files.';

CREATE OR REPLACE FUNCTION streetgen._export_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
        source text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 30 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('layer');
END $$;
COMMENT ON FUNCTION streetgen._export_layer() IS
    'The layers that a model is exchanged in, from functions _ROOM_layer: fields and geometry as SQL over a relation '
    'of the model %1$I; of_axes: with heights where axes have them. No name of a field is longer than the ten '
    'characters that a shapefile holds.';

CREATE OR REPLACE FUNCTION streetgen.export_layer(model name, wgs84 boolean DEFAULT false)
    RETURNS TABLE(layer text, geometry_type text, query text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('wgs84', wgs84::text);
    -- OFFSET 0: a surface is snapped once, not again to see whether it is empty.
    RETURN QUERY SELECT l.layer, l.geometry_type || CASE WHEN m.dimension = 3 AND of_axes THEN 'Z' ELSE '' END,
        format('SELECT * FROM (SELECT ' || fields || ', streetgen._for_exchange(' || geometry || ', ' || wgs84 ||
            ') AS geom FROM %1$I.' || l.source || ' OFFSET 0) l WHERE NOT ST_IsEmpty(geom) ORDER BY id', model)
    FROM streetgen._export_layer() l, streetgen.model m
    -- The first word is the relation: layers of a subject that the model does not compute are not there.
    WHERE m.name = model AND to_regclass(format('%I.%I', model, split_part(l.source, ' ', 1))) IS NOT NULL
        ORDER BY turn;
END $$;
COMMENT ON FUNCTION streetgen.export_layer(name, boolean) IS
    'The layers of a model for exchange, as data/streetgen export writes them: name, type of the geometry, and a '
    'query of their rows with a unique integer id first and geom last, in the reference of the model or in WGS 84. '
    'Surfaces lie on a grid of a micrometre; what is narrower is left out. An unknown model: 3F000; a caller who may '
    'not read it: 42501.';
