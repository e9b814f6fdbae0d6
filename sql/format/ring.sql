-- Roundabouts as the formats of simulators have them.

CREATE OR REPLACE FUNCTION streetgen._ring_edges(model name)
    RETURNS TABLE(roundabout_id bigint, face integer, ordinality integer, edge_id bigint, along_axis boolean,
        centre geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'roundabout' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT r.roundabout_id, e.face, e.ordinality, e.edge_id, e.along_axis, r.centre
            FROM roundabout r JOIN roundabout_edge e ON e.roundabout_id = r.roundabout_id WHERE r.accepted;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._ring_edges(name) IS
    'The edges of accepted roundabouts, counter-clockwise; none of a model that computes no roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._ring_arms(model name)
    RETURNS TABLE(roundabout_id bigint, edge_id bigint, node_id bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'roundabout' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT a.roundabout_id, a.edge_id, a.node_id FROM roundabout_arm a;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._ring_arms(name) IS
    'The arms of roundabouts; none of a model that computes no roundabouts.';
