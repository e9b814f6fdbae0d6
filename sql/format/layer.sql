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

CREATE OR REPLACE FUNCTION streetgen._export_layer()
    RETURNS TABLE(turn integer, layer text, geometry_type text, of_axes boolean, fields text, geometry text,
    source text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'roads', 'MULTIPOLYGON', false,
        'roadway_id AS id, part, edge_id, node_id, axis_id, name, kind, importance, level, width, lane_count',
        'surface', 'roadway'),
    (2, 'axes', 'LINESTRING', true,
        'axis_id AS id, name, kind, u.importance, u.level, u.direction, u.width, u.width_end, '
        'u.roadway_offset AS offset_m, '
        'u.lane_count, '
        'u.lanes_forward AS lanes_fwd, u.lanes_backward AS lanes_bwd, u.lanes_both, u.sidewalk_left AS walk_left, '
        'u.sidewalk_right AS walk_right, u.speed, '
        'array_to_string(estimated, '','') AS estimated, source, source_ref', 'u.geom',
        'axis_used u JOIN %1$I.axis a USING (axis_id)'),
    (3, 'edges', 'LINESTRING', true,
        'edge_id AS id, axis_id, from_node, to_node, importance, level, start_abscissa AS from_m, end_abscissa AS '
        'to_m, width, width_end, roadway_offset AS offset_m, lane_count, lanes_forward AS lanes_fwd, '
        'lanes_backward AS lanes_bwd, lanes_both, '
        'speed', 'geom', 'edge'),
    (4, 'nodes', 'POINT', true, 'node_id AS id', 'geom', 'node'),
    (5, 'lanes', 'LINESTRING', false,
        'lane_id AS id, edge_id, ordinality, lane_position AS position, side, along_axis, both_ways, kind, width, '
        'turn', 'geom', 'lane'),
    (6, 'lane_separators', 'MULTIPOLYGON', false,
        'lane_separator_id AS id, edge_id, lane_position AS position, kind, dashed', 'surface', 'lane_separator'),
    (7, 'markings', 'MULTIPOLYGON', false,
        'marking_id AS id, edge_id, lane_position AS position, along_axis, node_id, kind', 'surface', 'marking'),
    (8, 'interconnections', 'LINESTRING', false,
        'interconnection_id AS id, node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, '
        'connecting', 'geom', 'interconnection'),
    (9, 'corners', 'LINESTRING', false, 'corner_id AS id, node_id, edge_a, edge_b, radius, method',
        'ST_CurveToLine(arc, 16)', 'corner WHERE arc IS NOT NULL'),
    (11, 'roundabouts', 'LINESTRING', false,
        'roundabout_id AS id, kind, radius, score, accepted, confirmed, level, method', 'geom', 'roundabout'),
    (10, 'kerbs', 'LINESTRING', false, 'kerb_id AS id, edge_id, node_id, level, side, part, method', 'geom', 'kerb'),
    (12, 'blocks', 'MULTIPOLYGON', false, 'block_id AS id, kind, method', 'surface', 'block'),
    (11, 'roads_arcs', 'LINESTRING', false, 'road_id AS id, from_node, to_node, closed, length',
        'streetgen.arc_road_line(geom, 0.01)', 'road'),
    (36, 'road_meshes', 'MULTIPOLYGONZ', false,
        'coalesce(2 * edge_id, 2 * node_id + 1) AS id, edge_id, node_id, road_id, level', 'triangles',
        'road_edge RIGHT JOIN streetgen.road_mesh(%1$L) USING (edge_id), LATERAL (SELECT ST_Collect(ST_MakePolygon('
        'ST_ExteriorRing(t.geom)) ORDER BY path) AS triangles FROM ST_Dump(geom) t) t'),
    (35, 'sidewalks', 'MULTIPOLYGON', false, 'sidewalk_id AS id, edge_id, node_id, side, part, width, method',
        'surface', 'sidewalk'),
    (40, 'junctions', 'MULTIPOLYGON', false, 'junction_id AS id, kind, method', 'surface', 'junction'),
    (41, 'movements', 'LINESTRING', false, 'row_number() OVER (ORDER BY lane_in, lane_out, along_in, along_out) AS id, '
        'junction_id AS junction, node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, '
        'connecting', 'geom', 'movement'),
    (60, 'signal_heads', 'POINT', false, 'row_number() OVER (ORDER BY lane_id, along_axis) AS id, controller_id AS '
        'controller, lane_id AS lane, along_axis AS along, angle', 'geom', 'signal_head'),
    (61, 'controllers', 'POINT', false, 'controller_id AS id, program, cycle, start_offset AS offset_s, method',
        'geom', 'controller'),
    (42, 'ramps', 'POINT', false, 'ramp_id AS id, node_id, edge_id, edge_before AS before, edge_after AS after, kind, '
        'side, lanes_missing AS missing, lanes_merging AS merging, length, taper, tangent, auxiliary, cut, method',
        'geom', 'ramp'),
    (55, 'overpasses', 'POINT', false, 'overpass_id AS id, edge_above, abscissa_above AS at_above, edge_below, '
        'abscissa_below AS at_below, clearance, method', 'geom', 'overpass'),
    (56, 'profiles', 'LINESTRINGZ', false, 'edge_id AS id, grade_max, method', 'geom', 'profile'),
    (57, 'bridges', 'MULTIPOLYGON', false, 'bridge_id AS id, edge_id, start_abscissa AS at_start, '
        'end_abscissa AS at_end, method', 'surface', 'bridge'),
    (58, 'tunnels', 'MULTIPOLYGON', false, 'tunnel_id AS id, edge_id, start_abscissa AS at_start, '
        'end_abscissa AS at_end, method', 'surface', 'tunnel'),
    (70, 'objects', 'POINT', false, 'street_object_id AS id, type, angle, placement, axis_id, abscissa, side, '
        'axis_offset AS aside, edge_id, placed_by, source, source_ref, method', 'geom',
        'object_edge RIGHT JOIN %1$I.street_object USING (street_object_id) WHERE ST_Dimension(geom) = 0'),
    (72, 'crossings', 'POLYGON', false, 'street_object_id AS id, width, angle', 'surface', 'pedestrian_crossing'),
    (73, 'parking_bays', 'POLYGON', false, 'street_object_id AS id, length, width, angle', 'surface', 'parking_bay'),
    (71, 'objects_line', 'LINESTRING', false, 'street_object_id AS id, type, placement, axis_id, abscissa, '
        'abscissa_end AS at_end, side, axis_offset AS aside, placed_by, source, source_ref, method', 'geom',
        'object_edge RIGHT JOIN %1$I.street_object USING (street_object_id) WHERE ST_Dimension(geom) = 1')
    $$;
COMMENT ON FUNCTION streetgen._export_layer() IS
    'The layers that a model is exchanged in: fields and geometry as SQL over a relation of the model %1$I; of_axes: '
    'with heights where axes have them. No name of a field is longer than the ten characters that a shapefile holds.';

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
