-- Derived rows that somebody changes or deletes by hand: their edges are marked, for check_model to tell and generate
-- to repair.

CREATE OR REPLACE FUNCTION streetgen._changed_by_hand() RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT -1::bigint; END;
COMMENT ON FUNCTION streetgen._changed_by_hand() IS
    'The input_hash of an edge of which rows were changed by hand since they were computed; it is that of no axis.';

CREATE OR REPLACE FUNCTION streetgen._marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('marked_by_hand');
END $$;
COMMENT ON FUNCTION streetgen._marked_by_hand() IS
    'The edges e to which a row of a computed table belongs, $1, as SQL, from functions _ROOM_marked_by_hand. A table '
    'that is not on the list belongs to its edge_id.';

CREATE OR REPLACE FUNCTION streetgen._make_marks_by_hand(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    computed record;
    -- Not what a run writes, nor what goes with something else.
    by_hand constant text := 'pg_trigger_depth() = 0 AND current_setting(''streetgen.computes'', true) '
        'IS DISTINCT FROM ''on''';
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _mark_by_hand() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        IF TG_OP = 'TRUNCATE' THEN
            UPDATE edge SET input_hash = streetgen._changed_by_hand();
        ELSE
            EXECUTE 'UPDATE edge e SET input_hash = streetgen._changed_by_hand() WHERE ' || TG_ARGV[0] USING OLD;
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_mark_by_hand()',
        'After derived rows were changed by hand: marks their edges as stale');
    FOR computed IN SELECT t.relation, coalesce(m.edges, 'e.edge_id = ($1).edge_id') AS edges
        FROM unnest(streetgen._computed_tables(model)) t(relation)
            LEFT JOIN streetgen._marked_by_hand() m USING (relation)
    LOOP
        CONTINUE WHEN computed.relation = 'report';
        PERFORM streetgen._execute_each(ARRAY['CREATE OR REPLACE TRIGGER by_hand AFTER UPDATE OR DELETE ON %1$I.%2$I '
            'FOR EACH ROW WHEN (%3$s) EXECUTE FUNCTION %1$I._mark_by_hand(%4$L)',
            'COMMENT ON TRIGGER by_hand ON %1$I.%2$I IS ''Marks edges of which rows were changed by hand'''], model,
            computed.relation, by_hand, computed.edges);
        CONTINUE WHEN computed.relation IN ('node', 'edge');
        PERFORM streetgen._execute_each(ARRAY['CREATE OR REPLACE TRIGGER by_hand_truncate BEFORE TRUNCATE ON '
            '%1$I.%2$I FOR EACH STATEMENT WHEN (%3$s) EXECUTE FUNCTION %1$I._mark_by_hand()',
            'COMMENT ON TRIGGER by_hand_truncate ON %1$I.%2$I IS ''Marks all edges: a table was emptied by hand'''],
            model, computed.relation, by_hand);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_marks_by_hand(name) IS
    'Makes the triggers of a model that mark the edges of derived rows which are changed or deleted by hand.';
