-- Edits of rules and of what they place: locks before, and what follows after.

CREATE OR REPLACE FUNCTION streetgen._make_rule_edits(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _begin_ruled_edit() RETURNS boolean
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        ruled constant boolean := _has_rules();
    BEGIN
        IF ruled THEN
            PERFORM streetgen._begin_edit(current_schema());
        END IF;
        RETURN ruled;
    END $body$;
    CREATE OR REPLACE FUNCTION _lock_streets(axes bigint[], holding boolean) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT
        AS $body$
    DECLARE
        timeout constant text := current_setting('lock_timeout');
    BEGIN
        -- A session that holds places may wait for an object that this one has written.
        IF holding THEN
            PERFORM set_config('lock_timeout', '100ms', true);
        END IF;
        PERFORM streetgen._begin_edit(current_schema());
        PERFORM streetgen._lock_places(current_schema(), axes, wait => true);
        PERFORM set_config('lock_timeout', timeout, true);
    EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
        IF holding THEN
            PERFORM streetgen._refuse('55P03', 'another session works beside the objects of this edit',
                detail => streetgen._holders(current_schema()), hint => streetgen._object_edit_waits());
        END IF;
        RAISE;
    END $body$;
    CREATE OR REPLACE FUNCTION _lock_beside(places geometry[], holding boolean) RETURNS bigint[]
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        beside constant bigint[] := ARRAY(SELECT DISTINCT a.axis_id FROM unnest(places) place
            JOIN axis a ON ST_DWithin(a.geom, place, 100));
    BEGIN
        IF beside = '{}' THEN
            -- A street that comes there at the same time is seen, or sees these.
            PERFORM streetgen._lock_ground(current_schema(), places);
        END IF;
        PERFORM _lock_streets(beside, holding);
        RETURN beside;
    END $body$;
    CREATE OR REPLACE FUNCTION _renew_lines(places geometry[]) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT
        AS $body$
    DECLARE
        crossed bigint[];
    BEGIN
        IF places <> '{}' AND to_regclass(format('%I.marking', current_schema())) IS NOT NULL THEN
            -- An oblique crossing of a wide street goes so far along it.
            crossed := ARRAY(SELECT DISTINCT e.axis_id FROM unnest(places) place
                JOIN section s ON ST_DWithin(s.surface, place, 30) JOIN edge e USING (edge_id));
            PERFORM _lock_streets(crossed, holding => true);
            PERFORM streetgen._settle_lane(current_schema(), crossed);
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION _renew_placed(axes bigint[]) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT
        AS $body$
    BEGIN
        PERFORM FROM _place_objects(axes);
        -- Else lines were laid before objects beside the roadway were placed.
        IF NOT _has_rules_at_kerbs() THEN
            PERFORM streetgen._settle_lane(current_schema(), axes);
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION _renew_rules_beside(places geometry[]) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    DECLARE
        beside bigint[];
    BEGIN
        IF _has_rules() THEN
            IF places IS NOT NULL THEN
                beside := _lock_beside(places, holding => true);
            END IF;
            PERFORM _renew_placed(beside);
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION enter_rules() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        PERFORM streetgen._require_one_build();
        IF TG_TABLE_NAME IN ('placement_rule', 'object_type', 'object_distance') THEN
            PERFORM streetgen._lock_model(current_schema(), wait => true, alone => true);
        ELSIF TG_OP <> 'TRUNCATE' THEN
            PERFORM _begin_ruled_edit();
        ELSIF _has_rules() THEN
            PERFORM streetgen._lock_model(current_schema(), wait => true, alone => true);
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER enter_rules BEFORE INSERT OR UPDATE OR DELETE OR TRUNCATE ON placement_rule
        FOR EACH STATEMENT EXECUTE FUNCTION enter_rules();
    CREATE OR REPLACE TRIGGER enter_rules BEFORE UPDATE OF distance_least ON object_type
        FOR EACH STATEMENT EXECUTE FUNCTION enter_rules();
    CREATE OR REPLACE TRIGGER enter_rules BEFORE INSERT OR UPDATE OR DELETE OR TRUNCATE ON street_object
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION enter_rules();
    CREATE OR REPLACE TRIGGER enter_rules BEFORE INSERT OR UPDATE OR DELETE OR TRUNCATE ON free_place
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION enter_rules();
    -- Distances that go with a type had no objects to part.
    CREATE OR REPLACE TRIGGER enter_rules BEFORE INSERT OR UPDATE OR DELETE OR TRUNCATE ON object_distance
        FOR EACH STATEMENT WHEN (pg_trigger_depth() = 0) EXECUTE FUNCTION enter_rules();
    COMMENT ON TRIGGER enter_rules ON object_distance IS 'Locks the model: all its objects may follow';
    COMMENT ON TRIGGER enter_rules ON placement_rule IS 'Locks the model: all its objects may follow';
    COMMENT ON TRIGGER enter_rules ON object_type IS 'Locks the model: all its objects may follow';
    COMMENT ON TRIGGER enter_rules ON street_object IS 'Locks the model beside other editors, where rules place';
    COMMENT ON TRIGGER enter_rules ON free_place IS 'Locks the model beside other editors, where rules place';
    CREATE OR REPLACE FUNCTION apply_rules() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    BEGIN
        DELETE FROM free_place f WHERE f.rule_id > 0 AND NOT EXISTS (SELECT FROM placement_rule r
            WHERE r.rule_id = f.rule_id);
        IF streetgen._live(current_schema()) THEN
            -- Strips behind bays are as wide as these need, if rules make any.
            IF TG_TABLE_NAME = 'placement_rule' THEN
                PERFORM streetgen._update_streets(current_schema(), ARRAY(SELECT DISTINCT a.axis_id
                    FROM axis a JOIN edge e USING (axis_id), LATERAL (SELECT input_hash FROM axis_used u
                        WHERE u.axis_id = a.axis_id OFFSET 0) u
                    WHERE concat(parking_left, parking_right) ~ 'street_side' AND u.input_hash <> e.input_hash));
            END IF;
            PERFORM _renew_placed(NULL);
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER apply_rules AFTER INSERT OR UPDATE OR DELETE OR TRUNCATE ON placement_rule
        FOR EACH STATEMENT EXECUTE FUNCTION apply_rules();
    CREATE OR REPLACE TRIGGER apply_rules AFTER UPDATE OF distance_least ON object_type
        FOR EACH STATEMENT EXECUTE FUNCTION apply_rules();
    CREATE OR REPLACE TRIGGER apply_rules AFTER INSERT OR UPDATE OR DELETE OR TRUNCATE ON object_distance
        FOR EACH STATEMENT WHEN (pg_trigger_depth() = 0) EXECUTE FUNCTION apply_rules();
    COMMENT ON TRIGGER apply_rules ON object_distance IS 'The objects of rules keep their distance';
    COMMENT ON TRIGGER apply_rules ON placement_rule IS 'The objects follow their rules';
    COMMENT ON TRIGGER apply_rules ON object_type IS 'The objects of rules keep their distance';
    CREATE OR REPLACE FUNCTION free_places() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    BEGIN
        IF TG_OP = 'DELETE' THEN
            INSERT INTO free_place (rule_id, geom) SELECT rule_id, geom FROM old_object WHERE placed_by = 'rule'
                ORDER BY street_object_id;
            PERFORM _renew_rules_beside(ARRAY(SELECT geom FROM old_object));
            PERFORM _renew_lines(ARRAY(SELECT geom FROM old_object WHERE type = ANY (_types_below('crossing'))));
        ELSIF TG_WHEN = 'BEFORE' THEN
            -- TRUNCATE: what goes is known only before.
            INSERT INTO free_place (rule_id, geom) SELECT rule_id, geom FROM street_object
                WHERE placed_by = 'rule' ORDER BY street_object_id;
        ELSIF _has_rules() THEN
            PERFORM _renew_placed(NULL);
        ELSE
            PERFORM streetgen._settle_lane(current_schema(), NULL), _cut_sidewalks(NULL);
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER free_places AFTER DELETE ON street_object REFERENCING OLD TABLE AS old_object
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION free_places();
    CREATE OR REPLACE TRIGGER free_places_before BEFORE TRUNCATE ON street_object
        FOR EACH STATEMENT EXECUTE FUNCTION free_places();
    CREATE OR REPLACE TRIGGER free_places_truncate AFTER TRUNCATE ON street_object
        FOR EACH STATEMENT EXECUTE FUNCTION free_places();
    COMMENT ON TRIGGER free_places ON street_object
        IS 'Rules take the places of objects that are gone, and leave those of their own objects free';
    COMMENT ON TRIGGER free_places_before ON street_object IS 'Rules leave the places of their own objects free';
    COMMENT ON TRIGGER free_places_truncate ON street_object IS 'Rules take the places of objects that are gone';
    CREATE OR REPLACE FUNCTION fill_places() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        -- TRUNCATE: all.
        changed geometry[];
    BEGIN
        IF TG_OP = 'INSERT' THEN
            changed := ARRAY(SELECT geom FROM new_place);
        ELSIF TG_OP = 'DELETE' THEN
            changed := ARRAY(SELECT geom FROM old_place);
        ELSIF TG_OP = 'UPDATE' THEN
            changed := ARRAY(SELECT geom FROM old_place UNION ALL SELECT geom FROM new_place);
        END IF;
        PERFORM _renew_rules_beside(changed);
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER fill_places_insert AFTER INSERT ON free_place REFERENCING NEW TABLE AS new_place
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION fill_places();
    CREATE OR REPLACE TRIGGER fill_places_delete AFTER DELETE ON free_place REFERENCING OLD TABLE AS old_place
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION fill_places();
    CREATE OR REPLACE TRIGGER fill_places_update AFTER UPDATE ON free_place
        REFERENCING OLD TABLE AS old_place NEW TABLE AS new_place
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION fill_places();
    CREATE OR REPLACE TRIGGER fill_places_truncate AFTER TRUNCATE ON free_place
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION fill_places();
    COMMENT ON TRIGGER fill_places_insert ON free_place IS 'Rules place objects where they may again';
    COMMENT ON TRIGGER fill_places_delete ON free_place IS 'Rules place objects where they may again';
    COMMENT ON TRIGGER fill_places_update ON free_place IS 'Rules place objects where they may again';
    COMMENT ON TRIGGER fill_places_truncate ON free_place IS 'Rules place objects where they may again';
    PERFORM streetgen._own_function(model, '_begin_ruled_edit()',
        'Locks the model beside other editors where rules place objects, and tells whether they do'),
        streetgen._own_function(model, '_lock_beside(geometry[], boolean)',
        'Locks the axes within 100 m of places, or their ground, against other edits, and tells them; who holds '
        'objects does not wait'),
        streetgen._own_function(model, '_lock_streets(bigint[], boolean)',
        'Locks axes against other edits; who holds objects does not wait'),
        streetgen._own_function(model, '_renew_lines(geometry[])',
        'Lays lines before crossings that were or are at places, under locks'),
        streetgen._own_function(model, '_renew_placed(bigint[])',
        'Brings the objects of axes (NULL: of all) up to date where rules place some, and lines before crossings'),
        streetgen._own_function(model, '_renew_rules_beside(geometry[])',
        'Brings the objects that rules place within 100 m of places (NULL: everywhere) up to date, under locks'),
        streetgen._own_function(model, 'enter_rules()', 'Before an edit of rules or objects: locks the model'),
        streetgen._own_function(model, 'apply_rules()', 'After an edit of rules: their objects follow'),
        streetgen._own_function(model, 'fill_places()', 'After an edit of free places: rules place objects there'),
        streetgen._own_function(model, 'free_places()', 'After objects were deleted: rules take their places');
END $$;
COMMENT ON FUNCTION streetgen._make_rule_edits(name) IS
    'Makes the functions and triggers of a model by which edits of rules and objects lock, and others follow.';
