-- Derived rows that somebody changes or deletes by hand: their edges are marked, for check_model to tell and generate
-- to repair.

CREATE OR REPLACE FUNCTION streetgen._changed_by_hand() RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT -1::bigint; END;
COMMENT ON FUNCTION streetgen._changed_by_hand() IS
    'The input_hash of an edge of which rows were changed by hand since they were computed; it is that of no axis.';

CREATE OR REPLACE FUNCTION streetgen._make_marks_by_hand(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _mark_by_hand() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        IF TG_OP = 'TRUNCATE' THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand();
        ELSIF TG_TABLE_NAME = 'edge' THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE axis_id = OLD.axis_id;
        ELSIF TG_TABLE_NAME = 'corner' THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE edge_id IN (OLD.edge_a, OLD.edge_b);
        ELSIF TG_TABLE_NAME = 'road' THEN
            -- Its rows of road_edge may be gone with it.
            UPDATE edge e SET input_hash = streetgen._changed_by_hand() WHERE NOT EXISTS (
                SELECT FROM road_edge m WHERE m.edge_id = e.edge_id AND m.road_id <> OLD.road_id);
        ELSIF TG_TABLE_NAME IN ('node', 'intersection', 'interconnection', 'junction_node') THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE from_node = OLD.node_id
                OR to_node = OLD.node_id;
        ELSIF TG_TABLE_NAME = 'block' THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE edge_id IN (
                SELECT edge_id FROM block_edge WHERE block_id = OLD.block_id);
        ELSIF TG_TABLE_NAME IN ('controller', 'signal_state', 'signal_movement', 'signal_head') THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE from_node = OLD.controller_id
                OR to_node = OLD.controller_id;
        ELSIF TG_TABLE_NAME IN ('junction', 'junction_movement') THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE from_node = OLD.junction_id
                OR to_node = OLD.junction_id;
        ELSE
            UPDATE edge SET input_hash = streetgen._changed_by_hand() WHERE edge_id = OLD.edge_id;
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_mark_by_hand()',
        'After derived rows were changed by hand: marks their edges as stale');
    FOREACH relation IN ARRAY streetgen._computed_tables(model) LOOP
        CONTINUE WHEN relation = 'report';
        -- Not what a run writes, nor what goes with something else.
        EXECUTE format($sql$
CREATE OR REPLACE TRIGGER by_hand AFTER UPDATE OR DELETE ON %1$I.%2$I FOR EACH ROW
    WHEN (pg_trigger_depth() = 0 AND current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
    EXECUTE FUNCTION %1$I._mark_by_hand();
COMMENT ON TRIGGER by_hand ON %1$I.%2$I IS 'Marks edges of which rows were changed by hand' $sql$, model, relation);
        CONTINUE WHEN relation IN ('node', 'edge');
        EXECUTE format($sql$
CREATE OR REPLACE TRIGGER by_hand_truncate BEFORE TRUNCATE ON %1$I.%2$I FOR EACH STATEMENT
    WHEN (pg_trigger_depth() = 0 AND current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
    EXECUTE FUNCTION %1$I._mark_by_hand();
COMMENT ON TRIGGER by_hand_truncate ON %1$I.%2$I IS
    'Marks all edges where a table was emptied by hand' $sql$, model, relation);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_marks_by_hand(name) IS
    'Makes the triggers of a model that mark the edges of derived rows which are changed or deleted by hand.';
