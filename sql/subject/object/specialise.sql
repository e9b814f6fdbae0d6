-- Objects of a type with a table of its own: a row there for each of them, kept in step on both sides.

CREATE OR REPLACE FUNCTION streetgen._hold_specialised(model name, alone boolean) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    key constant bigint := hashtextextended('streetgen specialised objects of ' || model, 0);
BEGIN
    IF alone THEN
        PERFORM pg_advisory_xact_lock(key);
    ELSE
        PERFORM pg_advisory_xact_lock_shared(key);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._hold_specialised(name, boolean) IS
    'Who edits specialised objects of a model, on either side, does so alone: each side writes the other one, so that '
    'two sessions would lock them in turn. Who edits axes, which objects follow, waits for them, but not for others '
    'who edit axes.';

CREATE OR REPLACE FUNCTION streetgen._hold_specialised_types(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    any_type boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT EXISTS (SELECT FROM specialised_type) INTO any_type;
    IF any_type THEN
        PERFORM streetgen._hold_specialised(model, true);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._hold_specialised_types(name) IS
    'Waits for who edits specialised objects, where a model has any: before an edit view locks an axis.';

CREATE OR REPLACE FUNCTION streetgen._specialised_function(model name, relation name, function text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._called_function(model, format('the function of table "%s"', relation), function,
        streetgen._function_named(function, format('%1$I.%2$I, %1$I.street_object', model, relation),
            format('%I.%I', model, relation), false),
        format('NULL, or a function of (%1$I.%2$I, %1$I.street_object) that returns one %1$I.%2$I', model,
            relation)) $$;
COMMENT ON FUNCTION streetgen._specialised_function(name, name, text) IS
    'The function that computes the rows of a specialised table, as _called_function has it.';

CREATE OR REPLACE FUNCTION streetgen._compute_specialised(model name, relation name, function text, objects bigint[])
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    attributes text;
    has_geom boolean;
BEGIN
    SELECT string_agg(quote_ident(attname), ', ') FILTER (WHERE attname NOT IN ('street_object_id', 'geom')),
            bool_or(attname = 'geom') INTO attributes, has_geom
        FROM pg_attribute WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0
            AND NOT attisdropped AND attgenerated = '';
    IF has_geom THEN
        EXECUTE format('UPDATE %1$I.%2$I r SET geom = o.geom FROM %1$I.street_object o
            WHERE o.street_object_id = r.street_object_id AND r.street_object_id = ANY ($1)
                AND r.geom::bytea IS DISTINCT FROM o.geom::bytea', model, relation) USING objects;
    END IF;
    IF function IS NOT NULL AND attributes IS NOT NULL THEN
        EXECUTE format('UPDATE %1$I.%2$I r SET (%3$s) = (SELECT %3$s FROM (SELECT (n.new).*) v)
            FROM (SELECT r.street_object_id, %4$s(r, o) AS new FROM %1$I.%2$I r
                JOIN %1$I.street_object o USING (street_object_id) WHERE street_object_id = ANY ($1) OFFSET 0) n
            WHERE n.street_object_id = r.street_object_id AND n.new::text IS DISTINCT FROM r::text',
            model, relation, attributes, streetgen._specialised_function(model, relation, function)) USING objects;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._compute_specialised(name, name, text, bigint[]) IS
    'Computes the rows of a specialised table anew, as far as they changed.';

CREATE OR REPLACE FUNCTION streetgen._join_specialised(model name, objects bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
DECLARE
    special record;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR special IN SELECT relation, function, _types_below(type) AS types FROM specialised_type ORDER BY type LOOP
        -- A row that is just being written there brings its object.
        IF current_setting('streetgen.specialises', true) IS DISTINCT FROM special.relation::text THEN
            EXECUTE format('INSERT INTO %1$I.%2$I (street_object_id) SELECT street_object_id FROM %1$I.street_object
                WHERE street_object_id = ANY ($1) AND type = ANY ($2) ORDER BY street_object_id
                ON CONFLICT (street_object_id) DO NOTHING', model, special.relation) USING objects, special.types;
        END IF;
        EXECUTE format('DELETE FROM %1$I.%2$I r USING %1$I.street_object o
            WHERE o.street_object_id = r.street_object_id AND o.street_object_id = ANY ($1) AND o.type <> ALL ($2)',
            model, special.relation) USING objects, special.types;
        PERFORM streetgen._compute_specialised(model, special.relation, special.function, objects);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._join_specialised(name, bigint[]) IS
    'Gives objects their rows of specialised tables, takes away those of other types, and computes them.';

CREATE OR REPLACE FUNCTION streetgen._renew_specialised(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    objects bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT array_agg(street_object_id ORDER BY street_object_id) FROM street_object o
        WHERE type = ANY (ARRAY(SELECT unnest(_types_below(s.type)) FROM specialised_type s))
            AND (axes IS NULL OR o.axis_id = ANY (axes)) INTO objects;
    IF objects IS NOT NULL THEN
        PERFORM streetgen._hold_specialised(model, false), streetgen._join_specialised(model, objects);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._renew_specialised(name, bigint[]) IS
    'Computes the specialised rows of objects of axes (NULL: of all) anew.';

CREATE OR REPLACE FUNCTION streetgen._hold_specialised() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA),
        streetgen._hold_specialised(TG_TABLE_SCHEMA, TG_ARGV[0]::boolean);
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._hold_specialised() IS
    'Trigger of axes, of street_object and of specialised tables, before a statement: waits for who edits specialised '
    'objects.';

CREATE OR REPLACE FUNCTION streetgen._write_specialised() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    has_geom constant boolean := TG_ARGV[1]::boolean;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        DELETE FROM street_object WHERE street_object_id = OLD.street_object_id;
        RETURN NULL;
    ELSIF TG_OP = 'UPDATE' AND TG_WHEN = 'AFTER' THEN
        IF has_geom AND NEW.geom IS DISTINCT FROM OLD.geom THEN
            UPDATE street_object_editing SET geom = NEW.geom WHERE street_object_id = NEW.street_object_id;
        END IF;
    ELSIF TG_OP = 'UPDATE' THEN
        IF NEW.street_object_id IS DISTINCT FROM OLD.street_object_id THEN
            PERFORM streetgen._refuse('22023',
                format('row %s of %s.%s cannot become row %s', OLD.street_object_id, TG_TABLE_SCHEMA, TG_TABLE_NAME,
                    NEW.street_object_id), hint => 'Its key is that of its object.');
        END IF;
    ELSIF NEW.street_object_id IS NULL THEN
        IF NOT has_geom OR NEW.geom IS NULL THEN
            PERFORM streetgen._refuse('22023',
                format('the new row of %s.%s has neither an object nor a place', TG_TABLE_SCHEMA, TG_TABLE_NAME),
                hint => format('Insert an object of type %s into %I.street_object_editing: '
                    'its row comes by itself.', TG_ARGV[0], TG_TABLE_SCHEMA));
        END IF;
        PERFORM set_config('streetgen.specialises', TG_TABLE_NAME, true);
        INSERT INTO street_object_editing (type, geom) VALUES (TG_ARGV[0], NEW.geom) RETURNING street_object_id
            INTO NEW.street_object_id;
        PERFORM set_config('streetgen.specialises', '', true);
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._write_specialised() IS
    'Trigger of specialised tables: a new row with a place makes its object, a place that changes drags the object, '
    'and the object goes with its row.';

CREATE OR REPLACE FUNCTION streetgen._compute_specialised() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    function text;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    SELECT t.function FROM specialised_type t WHERE t.relation = TG_TABLE_NAME INTO function;
    PERFORM streetgen._compute_specialised(TG_TABLE_SCHEMA, TG_TABLE_NAME, function,
        ARRAY(SELECT street_object_id FROM new_row));
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._compute_specialised() IS
    'Trigger of specialised tables, after a statement: computes the rows that it wrote.';

CREATE OR REPLACE FUNCTION streetgen._check_specialised(model name, type text, relation name, function regprocedure)
    RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    oid constant regclass := to_regclass(format('%I.%I', model, relation));
    row_type constant regtype := to_regtype(format('%I.%I', model, relation));
    wanted record;
BEGIN
    IF oid IS NULL THEN
        RAISE EXCEPTION 'there is no table %.%', model, relation USING ERRCODE = '42P01',
            HINT = 'Make it first, in the schema of the model.';
    ELSIF relation IN (SELECT t.relation FROM streetgen.template t WHERE t.room = 'object') THEN
        RAISE EXCEPTION 'table %.% is one of the model itself', model, relation USING ERRCODE = '22023',
            HINT = 'Make a table of your own, in the schema of the model.';
    ELSIF NOT EXISTS (SELECT FROM pg_index i JOIN pg_attribute a ON a.attrelid = i.indrelid AND a.attnum = i.indkey[0]
        WHERE i.indrelid = oid AND i.indisprimary AND i.indnkeyatts = 1 AND a.attname = 'street_object_id'
            AND a.atttypid = 'bigint'::regtype) THEN
        RAISE EXCEPTION 'table %.% lacks its key', model, relation USING ERRCODE = '22023',
            HINT = 'Give it a column street_object_id bigint PRIMARY KEY.';
    END IF;
    SELECT a.attname INTO wanted FROM pg_attribute a WHERE a.attrelid = oid AND a.attnum > 0 AND NOT a.attisdropped
        AND a.attnotnull AND NOT a.atthasdef AND a.attidentity = '' AND a.attname NOT IN ('street_object_id') LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'column % of %.% has no default', wanted.attname, model, relation USING ERRCODE = '22023',
            DETAIL = 'A row comes by itself with each new object.', HINT = 'Give it one, or let it be NULL.';
    END IF;
    IF function IS NOT NULL AND NOT EXISTS (SELECT FROM pg_proc p WHERE p.oid = function AND p.prorettype = row_type
        AND NOT p.proretset AND p.pronargs = 2 AND p.proargtypes[0] = row_type
        AND p.proargtypes[1] = to_regtype(format('%I.street_object', model))) THEN
        RAISE EXCEPTION 'function % does not compute rows of %.%', function, model, relation USING ERRCODE = '22023',
            HINT = format('It takes (%1$I.%2$I, %1$I.street_object) and returns one %1$I.%2$I.', model, relation);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_specialised(name, text, name, regprocedure) IS
    'Refuses a table that cannot hold specialised objects, or a function that does not compute its rows: 22023, 42P01.';

CREATE OR REPLACE FUNCTION streetgen._tie_specialised(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    tied record;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR tied IN
        WITH special AS (SELECT s.relation, format('_write_specialised(%L, %L)', s.type, EXISTS (SELECT FROM
                pg_attribute WHERE attrelid = c.oid AND attname = 'geom' AND NOT attisdropped)) AS write
            FROM specialised_type s JOIN pg_class c ON c.relnamespace = quote_ident(model)::regnamespace
                AND c.relname = s.relation)
        SELECT s.relation, v.* FROM special s, LATERAL (VALUES
            ('hold_specialised', 'BEFORE INSERT OR UPDATE OR DELETE', 'FOR EACH STATEMENT', '_hold_specialised(true)'),
            ('write_before', 'BEFORE INSERT OR UPDATE', 'FOR EACH ROW', s.write),
            ('write_after', 'AFTER UPDATE OR DELETE', 'FOR EACH ROW', s.write),
            ('compute_insert', 'AFTER INSERT', 'REFERENCING NEW TABLE AS new_row FOR EACH STATEMENT',
                '_compute_specialised()'),
            ('compute_update', 'AFTER UPDATE', 'REFERENCING NEW TABLE AS new_row FOR EACH STATEMENT',
                '_compute_specialised()')) v(name, event, each, called) ORDER BY s.relation
    LOOP
        EXECUTE format('CREATE OR REPLACE TRIGGER %I %s ON %I.%I %s WHEN (current_setting(''streetgen.computes'', '
            'true) IS DISTINCT FROM ''on'') EXECUTE FUNCTION streetgen.%s', tied.name, tied.event, model,
            tied.relation, tied.each, tied.called);
    END LOOP;
    IF FOUND THEN
        CREATE OR REPLACE TRIGGER hold_specialised BEFORE INSERT OR UPDATE OR DELETE ON street_object
            FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
            EXECUTE FUNCTION streetgen._hold_specialised(true);
        CREATE OR REPLACE TRIGGER hold_specialised BEFORE INSERT OR UPDATE OR DELETE ON axis
            FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
            EXECUTE FUNCTION streetgen._hold_specialised(false);
        COMMENT ON TRIGGER hold_specialised ON street_object IS 'Waits for who edits specialised objects';
        COMMENT ON TRIGGER hold_specialised ON axis IS 'Waits for who edits specialised objects';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._tie_specialised(name) IS
    'Makes the triggers that keep the specialised tables of a model and their objects in step, again and again.';

CREATE OR REPLACE FUNCTION streetgen._untie_specialised(model name, relation name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    IF to_regclass(format('%I.%I', model, relation)) IS NOT NULL THEN
        EXECUTE format('ALTER TABLE %I.%I DROP CONSTRAINT IF EXISTS object_of_the_row', model, relation);
        EXECUTE (SELECT string_agg(format('DROP TRIGGER IF EXISTS %I ON %I.%I', made, model, relation), '; ')
            FROM unnest('{hold_specialised,write_before,write_after,compute_insert,compute_update}'::text[]) made);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._untie_specialised(name, name) IS
    'Takes from a table what tied it to objects; its rows stay as they are.';

CREATE OR REPLACE FUNCTION streetgen.specialise(model name, type text, relation name,
    function regprocedure DEFAULT NULL) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    known boolean;
    other text;
    objects bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._check_given('model', model, 'type', type, 'relation', relation::text);
    PERFORM streetgen._require_owner(model), streetgen._require_subject(model, 'object'),
        streetgen._hold_specialised(model, true);
    SELECT EXISTS (SELECT FROM object_type t WHERE t.type = specialise.type) INTO known;
    IF NOT known THEN
        RAISE EXCEPTION 'there is no object type "%"', type USING ERRCODE = '22023',
            HINT = format('SELECT type FROM %I.object_type lists them; a row there makes another.', model);
    END IF;
    PERFORM streetgen._check_specialised(model, type, relation, function);
    SELECT s.type FROM specialised_type s WHERE s.relation = specialise.relation
        AND s.type <> specialise.type INTO other;
    IF other IS NOT NULL THEN
        RAISE EXCEPTION 'table %.% holds objects of type "%" already', model, relation, other
            USING ERRCODE = '22023', HINT = 'Each type has a table of its own.';
    END IF;
    SELECT s.relation FROM specialised_type s WHERE s.type = specialise.type
        AND s.relation <> specialise.relation INTO other;
    PERFORM streetgen._untie_specialised(model, other::name);
    EXECUTE format('ALTER TABLE %1$I.%2$I DROP CONSTRAINT IF EXISTS object_of_the_row, ADD CONSTRAINT object_of_the_row
        FOREIGN KEY (street_object_id) REFERENCES %1$I.street_object ON UPDATE CASCADE ON DELETE CASCADE', model,
        relation);
    INSERT INTO specialised_type AS s (type, relation, function) VALUES (type, relation,
        streetgen._specialised_function(model, relation, streetgen._qualified(function)))
        ON CONFLICT ON CONSTRAINT specialised_type_pkey
        DO UPDATE SET relation = excluded.relation, function = excluded.function;
    PERFORM streetgen._tie_specialised(model);
    SELECT coalesce(array_agg(street_object_id ORDER BY street_object_id), '{}')
        FROM street_object o WHERE o.type = ANY (_types_below(specialise.type)) INTO objects;
    PERFORM streetgen._join_specialised(model, objects);
    RETURN cardinality(objects);
END $$;
COMMENT ON FUNCTION streetgen.specialise(name, text, name, regprocedure) IS
    'Ties a table of yours, in the schema of the model, to the objects of a type and of those below it: each has a row '
    'there, by its key street_object_id, and what is inserted, changed or deleted on either side follows on the other. '
    'function (row of the table, row of street_object) returns the row as it is to be, and is called again whenever '
    'the object or its row changes; NULL computes nothing. A column geom of the table is the place of the object, and '
    'an INSERT with it and without a key makes one. Called again with another table, the type lets go of the first '
    'one, whose rows stay. Returns how many objects there are. An unknown type, a table of the model itself or of '
    'another type, one without its key or with a column that has no default, a function of another signature: 22023; '
    'no such table: 42P01; a function of a role without the rights of the owner of the model, now or at a later call, '
    'or a caller without them: 42501. StreetGen paper, 4.6. NULL is refused: 22004.';
