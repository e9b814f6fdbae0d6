-- Triggers on crossings and parking bays, by which their ground follows an edit, and on control points, which say how
-- crossings are painted.

CREATE OR REPLACE FUNCTION streetgen._make_redraw(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION redraw_ground() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        PERFORM streetgen._require_one_build();
        IF TG_OP = 'DELETE' THEN
            IF TG_TABLE_NAME = 'parking_bay' THEN
                PERFORM _cut_sidewalks(_sidewalks_on(ARRAY(SELECT surface FROM before)));
            END IF;
            DELETE FROM street_object o USING before b WHERE o.street_object_id = b.street_object_id;
            RETURN NULL;
        END IF;
        PERFORM _take_from_rules(ARRAY(SELECT street_object_id FROM after));
        IF TG_TABLE_NAME = 'pedestrian_crossing' THEN
            PERFORM _renew_crossings(ARRAY(SELECT street_object_id FROM after));
        ELSE
            PERFORM _cut_sidewalks(_sidewalks_on(_renew_bays(ARRAY(SELECT street_object_id FROM after), told => true)));
        END IF;
        PERFORM _renew_rules_beside(ARRAY(SELECT geom FROM after JOIN street_object USING (street_object_id)));
        IF TG_TABLE_NAME = 'pedestrian_crossing' THEN
            PERFORM _renew_lines(ARRAY(SELECT geom FROM after JOIN street_object USING (street_object_id)));
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE FUNCTION repaint_crossings() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        places geometry[];
    BEGIN
        IF TG_OP = 'INSERT' THEN
            places := ARRAY(SELECT geom FROM after);
        ELSIF TG_OP = 'DELETE' THEN
            places := ARRAY(SELECT geom FROM before);
        ELSE
            places := ARRAY(SELECT unnest(ARRAY[b.geom, a.geom]) FROM before b JOIN after a USING (control_point_id)
                WHERE (a.kind, a.marking, a.kerb, a.refuge, a.geom::bytea)
                    IS DISTINCT FROM (b.kind, b.marking, b.kerb, b.refuge, b.geom::bytea));
        END IF;
        -- Signals tell how the crossing at which they stand is painted.
        PERFORM _renew_crossings(ARRAY(SELECT o.street_object_id FROM unnest(places) place
                JOIN control_point c ON ST_DWithin(c.geom, place, 1) JOIN street_object o USING (control_point_id)
            -- Crossings without a control point of their own have that which lies there.
            UNION SELECT o.street_object_id FROM unnest(places) place
                JOIN street_object o ON o.control_point_id IS NULL AND o.type = ANY (_types_below('crossing'))
                    AND ST_DWithin(o.geom, place, 2)));
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER repaint_insert AFTER INSERT ON control_point REFERENCING NEW TABLE AS after
        FOR EACH STATEMENT EXECUTE FUNCTION repaint_crossings();
    CREATE OR REPLACE TRIGGER repaint_update AFTER UPDATE ON control_point
        REFERENCING OLD TABLE AS before NEW TABLE AS after FOR EACH STATEMENT EXECUTE FUNCTION repaint_crossings();
    CREATE OR REPLACE TRIGGER repaint_delete AFTER DELETE ON control_point REFERENCING OLD TABLE AS before
        FOR EACH STATEMENT EXECUTE FUNCTION repaint_crossings();
    COMMENT ON TRIGGER repaint_insert ON control_point IS 'Paints the crossings there anew';
    COMMENT ON TRIGGER repaint_update ON control_point IS 'Paints the crossings there anew';
    COMMENT ON TRIGGER repaint_delete ON control_point IS 'Paints the crossings there anew';
    CREATE OR REPLACE TRIGGER redraw_update AFTER UPDATE ON pedestrian_crossing REFERENCING NEW TABLE AS after
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION redraw_ground();
    CREATE OR REPLACE TRIGGER redraw_delete AFTER DELETE ON pedestrian_crossing REFERENCING OLD TABLE AS before
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION redraw_ground();
    CREATE OR REPLACE TRIGGER redraw_update AFTER UPDATE ON parking_bay REFERENCING NEW TABLE AS after
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION redraw_ground();
    CREATE OR REPLACE TRIGGER redraw_delete AFTER DELETE ON parking_bay REFERENCING OLD TABLE AS before
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION redraw_ground();
    COMMENT ON TRIGGER redraw_update ON pedestrian_crossing IS 'Draws the ground anew';
    COMMENT ON TRIGGER redraw_delete ON pedestrian_crossing IS 'The object goes with its ground';
    COMMENT ON TRIGGER redraw_update ON parking_bay IS 'Draws the ground anew';
    COMMENT ON TRIGGER redraw_delete ON parking_bay IS 'The object goes with its ground';
    PERFORM streetgen._own_function(model, 'redraw_ground()',
        'After an edit of crossings or parking bays: their ground follows'),
        streetgen._own_function(model, 'repaint_crossings()',
        'After an edit of control points: the paint of crossings there follows');
END $$;
COMMENT ON FUNCTION streetgen._make_redraw(name) IS
    'Makes the triggers on the crossings, parking bays and control points of a model, by which ground and paint follow '
    'an edit.';
