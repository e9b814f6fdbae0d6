-- The extension as built now in a database of another build, as one transaction: the models keep their rows and get the
-- views of this build, and the tables that came with it.  Objects of others that depend on the extension or its views stop it.
\set ON_ERROR_STOP on
CREATE FUNCTION pg_temp.columns_of(model name) RETURNS SETOF text LANGUAGE sql AS $$
    SELECT format('%s.%s (%s)', c.relname, a.attname, format_type(a.atttypid, a.atttypmod))
    FROM pg_class c JOIN pg_attribute a ON a.attrelid = c.oid
    WHERE c.relnamespace = quote_ident(model)::regnamespace AND c.relkind = 'r' AND a.attnum > 0 AND NOT a.attisdropped $$;
DO $$
DECLARE
    known record;
    part text;
    missing text;
    models bigint;
    enough integer;
BEGIN
    CREATE TEMPORARY TABLE known_model ON COMMIT DROP AS SELECT name, srid, dimension FROM streetgen.model WHERE name IN (SELECT nspname FROM pg_namespace);
    FOR known IN SELECT * FROM known_model LOOP
        -- Its views: those of subjects, and those that are edited, whose triggers are the extension's or the model's own.
        EXECUTE (SELECT 'DROP VIEW IF EXISTS ' || string_agg(format('%I.%I', known.name, v), ', ')
            FROM (SELECT unnest(ARRAY['setting_used', 'axis_used', 'axis_to_mend', 'intersection_group', 'conflict', 'import_conflict', 'activity', 'roadway', 'override_place', 'lane_group', 'lane_driving', 'lane_interval', 'lane_adjacency', 'lane_extent',
                'corner_on_kerb', 'cross_section', 'paving', 'road_arc', 'movement', 'ramp_path', 'right_of_way',
                    'rim_marking', 'junction_link', 'signal_crossing', 'signal_green', 'junction_crossing',
                    'roundabout_block',
                    'sidewalk_block', 'block_interior', 'footway_surface', 'rail_crossing', 'lane_track',
                    'track_bed', 'rail', 'track_strip', 'area_surface', 'bus_stop_box', 'crossover',
                    'side_strip', 'car_place', 'event_place', 'walker_place', 'link', 'walk_node',
                    'walk_link', 'underpass', 'fit_change', 'observation_unused', 'axis_editing']) AS v
            UNION SELECT c.relname FROM pg_class c JOIN pg_trigger t ON t.tgrelid = c.oid JOIN pg_proc f ON f.oid = t.tgfoid
                WHERE c.relnamespace = quote_ident(known.name)::regnamespace AND c.relkind = 'v' AND c.relname LIKE '%\_editing' AND f.proname LIKE '\_edit%') w
            -- Anything else by such a name stays: adoption tells of it.
            WHERE NOT EXISTS (SELECT FROM pg_class c WHERE relnamespace = quote_ident(known.name)::regnamespace AND relname = v
                AND (relkind <> 'v' OR v = 'activity' AND pg_get_viewdef(c.oid) !~ 'edit_log_id\) AS activity_id'
                    OR v = 'link' AND pg_get_viewdef(c.oid) !~ 'AS junction_movement_id'
                    OR v = 'car_place' AND pg_get_viewdef(c.oid) !~ '_lane_measures')));
        -- The model's own functions that go with the extension, and the triggers that call them or it.
        FOR part IN
            WITH called AS (SELECT d.objid AS oid, d.deptype FROM pg_depend d JOIN pg_extension e ON e.oid = d.refobjid
                            WHERE d.classid = 'pg_proc'::regclass AND d.refclassid = 'pg_extension'::regclass AND e.extname = 'streetgen' AND d.deptype IN ('e', 'x'))
            SELECT drop FROM (
                SELECT 1 AS turn, format('DROP TRIGGER %I ON %s', tgname, tgrelid::regclass) AS drop FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid JOIN called ON called.oid = tgfoid JOIN pg_proc f ON f.oid = tgfoid
                    WHERE quote_ident(known.name)::regnamespace IN (relnamespace, pronamespace) AND NOT tgisinternal
                UNION ALL SELECT 2, format('DROP FUNCTION %s', p.oid::regprocedure) FROM pg_proc p JOIN called USING (oid) WHERE deptype = 'x' AND pronamespace = quote_ident(known.name)::regnamespace) d
            ORDER BY turn
        LOOP
            EXECUTE part;
        END LOOP;
    END LOOP;
    DROP EXTENSION streetgen;
    CREATE EXTENSION streetgen;
    -- One new model for all that are alike, since what is made and dropped stays locked to the end.
    CREATE TEMPORARY TABLE wanted_column (srid integer, dimension integer, subjects text[], description text) ON COMMIT DROP;
    FOR known IN SELECT DISTINCT srid, dimension, streetgen._subjects(name) AS subjects FROM known_model LOOP
        PERFORM streetgen.create_model('streetgen_renewed', known.srid, known.dimension, known.subjects);
        INSERT INTO wanted_column SELECT known.srid, known.dimension, known.subjects, pg_temp.columns_of('streetgen_renewed');
        PERFORM streetgen.drop_model('streetgen_renewed');
    END LOOP;
    FOR known IN SELECT * FROM known_model LOOP
        PERFORM streetgen._register_model(known.name, known.srid, known.dimension),
            streetgen._give_to_owner(known.name, '{}'), streetgen._as_owner(known.name, '_add_tables');
        SELECT string_agg(c, ', ') INTO missing FROM (SELECT description FROM wanted_column WHERE (srid, dimension, subjects) = (known.srid, known.dimension, streetgen._subjects(known.name)) EXCEPT SELECT pg_temp.columns_of(known.name) ORDER BY 1) m(c);
        IF missing IS NOT NULL THEN
            RAISE EXCEPTION 'model "%" lacks columns of this build: %', known.name, missing USING ERRCODE = '55000',
                HINT = format('Keep it with pg_dump -n %1$I and DROP SCHEMA %1$I CASCADE, or set STREETGEN_DATABASE to a new name.', known.name);
        END IF;
        PERFORM streetgen.adopt_model(known.name);
    END LOOP;
EXCEPTION WHEN out_of_memory THEN
    -- Seen: 530 locks a model, and 1,700 beside them.
    SELECT count(*) INTO models FROM streetgen.model;
    SELECT ceil((2000 + 600 * models) / sum(setting::numeric)) INTO enough FROM pg_settings WHERE name IN ('max_connections', 'max_prepared_transactions');
    RAISE EXCEPTION 'one transaction cannot renew % models: %', models, SQLERRM USING ERRCODE = '53200',
        HINT = format('ALTER SYSTEM SET max_locks_per_transaction = %s (it is %s), and start the server anew.', enough, current_setting('max_locks_per_transaction'));
END $$;
