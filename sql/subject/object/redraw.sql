-- Triggers on crossings and parking bays, by which their ground follows an edit.

CREATE OR REPLACE FUNCTION streetgen._make_redraw(model name, relation name, objects text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I.%3$I() RETURNS trigger
    LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
    AS $body$
BEGIN
    PERFORM streetgen._require_one_build();
    IF TG_OP = 'DELETE' THEN
        DELETE FROM %1$I.street_object o USING before b WHERE o.street_object_id = b.street_object_id;
    ELSE
        PERFORM %1$I._take_from_rules(ARRAY(SELECT street_object_id FROM after)),
            %1$I.%4$I(ARRAY(SELECT street_object_id FROM after)),
            %1$I._renew_rules_beside(ARRAY(SELECT geom FROM after JOIN %1$I.street_object USING (street_object_id)));
    END IF;
    RETURN NULL;
END $body$;
CREATE OR REPLACE TRIGGER redraw_update AFTER UPDATE ON %1$I.%2$I REFERENCING NEW TABLE AS after
    FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
    EXECUTE FUNCTION %1$I.%3$I();
CREATE OR REPLACE TRIGGER redraw_delete AFTER DELETE ON %1$I.%2$I REFERENCING OLD TABLE AS before
    FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
    EXECUTE FUNCTION %1$I.%3$I();
COMMENT ON TRIGGER redraw_update ON %1$I.%2$I IS 'Draws the ground anew';
COMMENT ON TRIGGER redraw_delete ON %1$I.%2$I IS 'The object goes with its ground'
$sql$, model, relation, 'redraw_' || objects, '_renew_' || objects);
    PERFORM streetgen._own_function(model, format('redraw_%s()', objects),
        format('After an edit of %s: their ground follows', objects));
END $$;
COMMENT ON FUNCTION streetgen._make_redraw(name, name, text) IS
    'Makes the triggers of a table of a model that has the ground of objects (crossings, bays). An edit of a row draws '
    'ground anew by the function _renew_ with the name of these objects.';
