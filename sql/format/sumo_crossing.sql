-- Pedestrian crossings for SUMO: each at the node of its end of an edge, where it lies in the model.

CREATE OR REPLACE FUNCTION streetgen._sumo_crossings(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, at_start boolean, along float8, across float8, line geometry, place_id bigint,
        names text[], controller_id bigint, number bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH place AS MATERIALIZED (SELECT * FROM streetgen._places(model, options)),
    sumo_edge AS MATERIALIZED (SELECT * FROM streetgen._sumo_edges(model, options, false, false)),
    signalled AS MATERIALIZED (
        SELECT DISTINCT place_id, controller_id
        FROM place JOIN streetgen._signal_controllers(model) ON controller_id = junction_id
        WHERE kind = 'signals' AND cycle > 0)
    -- Crossings have the last signals of a controller, as netconvert has them: tools of SUMO forget what comes last.
    SELECT c.edge_id, c.at_start, c.along, c.across, c.line, c.place_id, c.names, controller_id,
        CASE WHEN controller_id IS NOT NULL THEN row_number() OVER (
            PARTITION BY controller_id ORDER BY edge_id, at_start) - 1 END
    FROM (SELECT c.edge_id, c.at_start, c.along, c.across, c.line, p.place_id,
            array_agg(s.name ORDER BY s.name COLLATE "C") AS names
        FROM streetgen._crossings_at_ends(model, options) c JOIN place p USING (node_id)
            JOIN sumo_edge s ON s.edge_id = c.edge_id AND lane_count > 0
                AND CASE WHEN s.along_axis = c.at_start THEN since = 0 ELSE until = 1 END
        WHERE c.edge_id IN (SELECT edge_id FROM sumo_edge WHERE walk = 1
            GROUP BY edge_id HAVING count(DISTINCT along_axis) = 2)
        GROUP BY c.edge_id, c.at_start, c.along, c.across, c.line, p.place_id) c LEFT JOIN signalled USING (place_id);
END $$;
COMMENT ON FUNCTION streetgen._sumo_crossings(name, jsonb) IS
    'The crossings of edges with sidewalks on both sides for SUMO, with their place, the names of their edges, and '
    'their controller where they have one, with the number of their signal from 0 after those of its connections.';
