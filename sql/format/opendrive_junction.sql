-- OpenDRIVE: junctions.

CREATE OR REPLACE FUNCTION streetgen._held_places(model name, options jsonb) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT j.place_id FROM streetgen._places(model, options) j
        WHERE j.node_id IN (SELECT m.node_id FROM marking m WHERE m.kind IN ('stop', 'yield')
            UNION ALL SELECT CASE WHEN h.along_axis THEN e.to_node ELSE e.from_node END
            FROM streetgen._signal_heads(model) h JOIN lane l USING (lane_id) JOIN edge e USING (edge_id)
            UNION ALL SELECT n.node_id FROM streetgen._opendrive_objects(model) o JOIN node n
                ON o.kind = 'crosswalk' AND ST_DWithin(n.geom, o.geom, 5));
END $$;
COMMENT ON FUNCTION streetgen._held_places(name, jsonb) IS
    'The junctions of OpenDRIVE at which somebody waits, for signals or at a stop or yield line, or crosses on foot.';
