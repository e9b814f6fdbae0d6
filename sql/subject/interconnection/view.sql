-- Paths of a junction that traffic cannot take at the same time.

CREATE OR REPLACE FUNCTION streetgen._make_conflict_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE streetgen._fill_template(streetgen._part('conflict'), jsonb_build_object('path', streetgen._part(
        CASE WHEN 'junction' = ANY (streetgen._subjects(model)) THEN 'path_of_movement'
            ELSE 'path_of_interconnection' END)));
    COMMENT ON VIEW conflict
        IS 'Pairs of connecting paths from two lanes that cross, merge in one lane, or oppose each other in one that '
        'both directions use; geom is where. At a node: two interconnections; across a junction of several nodes, '
        'where the model computes junctions: two rows of junction_movement';
    COMMENT ON COLUMN conflict.node_id IS 'the node';
    COMMENT ON COLUMN conflict.interconnection_a IS 'one of the two, the smaller key';
    COMMENT ON COLUMN conflict.interconnection_b IS 'the other';
    COMMENT ON COLUMN conflict.kind IS
        'crossing, merging in one lane, or opposing: one enters the lane that the other leaves';
    COMMENT ON COLUMN conflict.geom IS 'where they cross, or the end of the lane in which they merge or meet';
    COMMENT ON COLUMN conflict.junction_id IS 'the junction, where the model computes junctions';
    COMMENT ON COLUMN conflict.junction_movement_a IS 'one of the paths, across a junction of several nodes';
    COMMENT ON COLUMN conflict.junction_movement_b IS 'the other one';
END $$;
COMMENT ON FUNCTION streetgen._make_conflict_view(name) IS 'Makes the view conflict of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('conflict'::name, 'interconnection'), ('conflict', 'junction') $$;
COMMENT ON FUNCTION streetgen._interconnection_view() IS
    'Views of interconnections, and the subjects whose tables they read.';

CREATE OR REPLACE FUNCTION streetgen._make_interconnection_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- Beside junctions the view is of their paths, and comes after these.
    IF 'junction' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._make_conflict_view(model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_interconnection_views(name) IS
    'Makes the view conflict of a model without junctions, again and again.';
