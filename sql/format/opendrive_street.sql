-- OpenDRIVE: what roads have of their streets: type, lines at their edges, bridges and tunnels.

CREATE OR REPLACE FUNCTION streetgen._opendrive_road_type(highway_role text, use text, speed float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN use IN ('walk', 'steps') THEN 'pedestrian' WHEN use = 'cycle' THEN 'bicycle'
        WHEN highway_role = 'highway' THEN 'motorway'
        WHEN speed <= 30 THEN 'lowSpeed' WHEN speed < 70 THEN 'town' ELSE 'rural' END;
COMMENT ON FUNCTION streetgen._opendrive_road_type(text, text, float8) IS
    'The type of a road of OpenDRIVE, by what its class is at ramps, who uses it and its speed, km/h.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_streets(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, name text, road_type text, edge_lines boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT e.edge_id, a.name, t.road_type, a.lane_markings IS DISTINCT FROM 'no'
            AND t.road_type IN ('motorway', 'rural')
        FROM edge e JOIN axis a USING (axis_id) LEFT JOIN axis_class c ON c.class = a.kind,
            streetgen._opendrive_road_type(c.highway_role, c.use, e.speed) t(road_type)
        WHERE e.edge_id IN (SELECT streetgen._written_edges(model, options));
END $$;
COMMENT ON FUNCTION streetgen._opendrive_streets(name, jsonb) IS
    'The edges of a file of OpenDRIVE, with the name and type of their roads, and whether these are fast ones, which '
    'have lines at their edges.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_structures(model name)
    RETURNS TABLE(kind text, type text, id bigint, edge_id bigint, share_from float8, share_to float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'bridge' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY SELECT s.kind, s.type, s.id, s.edge_id, s.start_abscissa / l.length, s.end_abscissa / l.length
        FROM (SELECT 'tunnel' AS kind, 'standard' AS type, tunnel_id AS id, t.edge_id, start_abscissa, end_abscissa
            FROM tunnel t
            UNION ALL SELECT 'bridge', 'concrete', bridge_id, b.edge_id, start_abscissa, end_abscissa FROM bridge b) s
            JOIN edge e USING (edge_id), LATERAL (SELECT ST_Length2D(e.geom) AS length) l;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_structures(name) IS
    'The tunnels and bridges of a model with their type, by shares of the length of their edge.';
