-- A model in step with a user's own table: statement triggers on it import the rows concerned.

CREATE OR REPLACE FUNCTION streetgen._follower(source text) RETURNS name
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ('_follow_' || md5(source))::name $$;
COMMENT ON FUNCTION streetgen._follower(text) IS
    'Name of the trigger function in the schema of a model that follows a source.';

CREATE OR REPLACE FUNCTION streetgen._refs_of(source_ref text, geom geometry) RETURNS SETOF text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$ SELECT source_ref
        UNION ALL SELECT source_ref || '/' || nth FROM generate_series(1, ST_NumGeometries(geom)) nth
        WHERE ST_NumGeometries(geom) > 1 $$;
COMMENT ON FUNCTION streetgen._refs_of(text, geometry) IS
    'The source_refs of the axes of a source row: its own, and of a line of several parts one each.';

CREATE OR REPLACE FUNCTION streetgen._import_change(model name, source text, among text[],
    clean boolean DEFAULT true) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- A few rows among many.
    SET jit = off SET enable_seqscan = off
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
    told record;
    bad record;
    concerned text[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._copy_classes(model);
    FOR told IN SELECT * FROM streetgen._take_rows(model, whole => false, any_class => true) t
        WHERE t.what LIKE '%, left out' OR t.what LIKE '% not understood, taken as unknown'
            OR t.what LIKE 'unknown class, %' LOOP
        RAISE NOTICE 'source %: %: %', source, told.what, array_to_string(told.source_refs, ', ');
    END LOOP;
    PERFORM streetgen._refuse_twins();
    SELECT p.source_ref INTO bad FROM pg_temp._import_part p WHERE p.source_ref IS NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'a row of source % has no source_ref', source USING ERRCODE = '22023',
            HINT = 'The column that source_ref is mapped to tells the rows apart: fill it.';
    END IF;
    PERFORM streetgen._part_tracks();
    PERFORM FROM streetgen._part_footways(model);
    concerned := among || ARRAY(SELECT p.source_ref FROM pg_temp._import_part p);
    PERFORM streetgen._adopt_axes(model, source, clean, concerned);
    SELECT p.source_ref INTO bad FROM pg_temp._import_part p JOIN delivered d ON (d.relation, d.source, d.source_ref)
        = ('axis', origin, p.source_ref) WHERE p.source_ref <> ALL (among) AND NOT d.gone LIMIT 1;
    IF bad.source_ref IS NOT NULL THEN
        PERFORM streetgen._refuse_twin(bad.source_ref);
    END IF;
    PERFORM streetgen._drop_vanished(model, 'axis', source, among), streetgen._write_axes(model, source, clean);
    FOR told IN SELECT * FROM streetgen._tell_by_hand(model, 'axis', source, concerned) LOOP
        RAISE NOTICE 'source %: %: %', source, told.what, array_to_string(told.source_refs, ', ');
    END LOOP;
    DROP VIEW pg_temp._import_said;
    DROP TABLE pg_temp._import, pg_temp._import_shapeless, pg_temp._import_part, pg_temp._import_class;
    PERFORM FROM streetgen._deliver_parted(model, 'footway', source, among);
    PERFORM FROM streetgen._deliver_parted(model, 'rail_track', source, among);
END $$;
COMMENT ON FUNCTION streetgen._import_change(name, text, text[], boolean) IS
    'Brings the axes of a source up to date with rows of it that changed: what they are in _import, and the '
    'source_refs of what they were; their lines are cleaned if asked to.';

CREATE OR REPLACE FUNCTION streetgen._make_follower(model name, source regclass, mapping jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    follower constant name := streetgen._follower(source::text);
    mapped constant text := streetgen._mapped(source, mapping);
    entries constant jsonb := streetgen._mapping_entries(source, mapping);
    -- What rows are made of, as text: not every type can be compared.
    was text;
    is_now text;
    event text;
BEGIN
    SELECT string_agg(format('o.%I::text', name), ', '), string_agg(format('n.%I::text', name), ', ') INTO was, is_now
        FROM (SELECT DISTINCT value ->> 'column' AS name FROM jsonb_each(entries) WHERE value ? 'column') c;
    EXECUTE format('DROP FUNCTION IF EXISTS %I.%I() CASCADE', model, follower);
    EXECUTE format('CREATE FUNCTION %I.%I() RETURNS trigger LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET '
        'search_path FROM CURRENT AS %L', model, follower, streetgen._fill_template(streetgen._part('follower'),
        jsonb_build_object('model', quote_ident(model), 'name', quote_literal(model), 'source', quote_literal(source),
            'rows', mapped,
            'no_rows', quote_literal(format('CREATE TEMPORARY TABLE _import ON COMMIT DROP AS SELECT %s '
                'FROM %%s n WHERE false', replace(mapped, '%', '%%'))),
            'refs', format('streetgen._refs_of(o.%I::text, o.%I)', entries #>> '{source_ref,column}',
                entries #>> '{geom,column}'), 'was', was, 'is_now', is_now)));
    PERFORM streetgen._own_function(model, format('%I()', follower),
        'After an edit of ' || source || ': the axes follow');
    FOREACH event IN ARRAY ARRAY['insert', 'update', 'delete', 'truncate'] LOOP
        EXECUTE format('CREATE TRIGGER %I AFTER %s ON %s %s FOR EACH STATEMENT EXECUTE FUNCTION %I.%I()',
            format('follow_%s_%s', event, model), event, source,
            CASE event WHEN 'insert' THEN 'REFERENCING NEW TABLE AS new_row' WHEN 'update'
                THEN 'REFERENCING OLD TABLE AS old_row NEW TABLE AS new_row' WHEN 'delete'
                THEN 'REFERENCING OLD TABLE AS old_row' END, model, follower);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_follower(name, regclass, jsonb) IS
    'Makes the trigger function in the schema of a model that follows a source, and its triggers.';

CREATE OR REPLACE FUNCTION streetgen.follow(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET client_min_messages = warning
    AS $$
DECLARE
    -- Its name without the model.
    origin constant text COLLATE "default" := source;
    relation record;
    ref_column name;
    nameless boolean;
    twin text;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    SELECT c.relkind, n.nspname IN (SELECT name FROM streetgen.model) AS derived, relispartition
        OR EXISTS (SELECT FROM pg_inherits WHERE inhrelid = c.oid OR inhparent = c.oid) AS shared
        INTO relation FROM pg_class c JOIN pg_namespace n ON n.oid = relnamespace WHERE c.oid = source;
    IF relation.relkind IS DISTINCT FROM 'r' OR relation.shared THEN
        RAISE EXCEPTION '% cannot be followed: it is no table of its own', source USING ERRCODE = '42809',
            HINT = 'Follow the ordinary table that holds the rows; import_axes reads views and partitions too.';
    ELSIF relation.derived THEN
        RAISE EXCEPTION '% cannot be followed: it is a table of a model', source USING ERRCODE = '42809',
            HINT = 'Follow a table outside of the schemas of models.';
    END IF;
    PERFORM streetgen._mapped(source, mapping);
    ref_column := streetgen._mapping_entries(source, mapping) #>> '{source_ref,column}';
    IF ref_column IS NULL THEN
        RAISE EXCEPTION 'the mapping names no column for source_ref' USING ERRCODE = '22023',
            HINT = 'Map it to the column that tells the rows apart, for example {"source_ref": "id"}.';
    END IF;
    -- Before the import: from here on nobody else writes the source.
    PERFORM streetgen._make_follower(model, source, mapping);
    EXECUTE format('SELECT bool_or(ref IS NULL), min(ref) FILTER (WHERE rows > 1) '
        'FROM (SELECT %I::text AS ref, count(*) AS rows FROM %s GROUP BY 1) r', ref_column, source) INTO nameless, twin;
    IF nameless THEN
        RAISE EXCEPTION 'a row of source % has no source_ref', source USING ERRCODE = '22023',
            HINT = 'The column that source_ref is mapped to tells the rows apart: fill it.';
    END IF;
    IF twin IS NOT NULL THEN
        PERFORM streetgen._refuse_twin(twin);
    END IF;
    INSERT INTO followed VALUES (origin, mapping)
        ON CONFLICT ON CONSTRAINT followed_pkey DO UPDATE SET mapping = excluded.mapping;
    RETURN QUERY SELECT * FROM streetgen.import_axes(model, source, mapping);
END $$;
COMMENT ON FUNCTION streetgen.follow(name, regclass, jsonb) IS
    'Imports a line table as import_axes does, then keeps the model in step with it by triggers: each statement that '
    'inserts, updates, deletes or truncates imports the rows concerned, and the streets follow. mapping as in '
    'import_axes; source_ref must name a column that tells the rows apart. Called again it takes the new mapping. '
    'Generate is due after it, once. pg_dump keeps it, adopt_model brings it back; what changed in between comes with '
    'the next call. Whoever writes the table, or owns it, runs a function of the model with the rights of its owner: '
    'follow tables of people whom you trust. Needs the rights of the owner of the model and TRIGGER and SELECT on the '
    'table (42501); a view, partition or table of a model: 42809; bad rows: 22023, here and in later statements on '
    'the table, which are refused then.';

CREATE OR REPLACE FUNCTION streetgen._adopt_source(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    owner constant name := (SELECT rolname FROM pg_namespace JOIN pg_roles r ON r.oid = nspowner WHERE nspname = model);
    kept record;
BEGIN
    -- Names of tables are read as anywhere else, without the model.
    FOR kept IN EXECUTE format('SELECT source, mapping, to_regclass(source) AS relation FROM %I.followed ORDER BY '
        'source', model) LOOP
        BEGIN
            IF kept.relation IS NULL THEN
                RAISE EXCEPTION 'there is no such table' USING ERRCODE = '42P01';
            ELSIF NOT (has_table_privilege(owner, kept.relation, 'TRIGGER')
                AND has_table_privilege(owner, kept.relation, 'SELECT')) THEN
                RAISE EXCEPTION 'role "%" has not the rights TRIGGER and SELECT on it', owner USING ERRCODE = '42501';
            END IF;
            PERFORM streetgen._make_follower(model, kept.relation, kept.mapping);
        EXCEPTION WHEN insufficient_privilege OR undefined_table OR undefined_column OR invalid_parameter_value
            OR wrong_object_type THEN
            RAISE WARNING 'model "%" does not follow % any more: %', model, kept.source, SQLERRM
                USING HINT = 'streetgen.follow follows it again; a table that is gone is forgotten.';
            EXECUTE format('DELETE FROM %I.followed WHERE source = $1 AND $2 IS NULL', model) USING kept.source,
                kept.relation;
        END;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._adopt_source(name) IS
    'Makes the triggers by which a model follows its sources anew; a warning for each that cannot be followed now.';

CREATE OR REPLACE FUNCTION streetgen.unfollow(model name, source regclass) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET client_min_messages = warning
    AS $$
DECLARE
    -- Its name without the model.
    origin constant text COLLATE "default" := source;
    follower record;
    forgotten bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text);
    SELECT p.oid::regprocedure AS signature, p.proname AS name INTO follower FROM pg_trigger t
        JOIN pg_proc p ON p.oid = t.tgfoid
        WHERE t.tgrelid = source AND p.pronamespace = quote_ident(model)::regnamespace AND p.proname LIKE '\_follow\_%'
            LIMIT 1;
    DELETE FROM followed f WHERE f.source = origin OR streetgen._follower(f.source) = follower.name;
    GET DIAGNOSTICS forgotten = ROW_COUNT;
    IF follower.signature IS NULL AND forgotten = 0 THEN
        RAISE EXCEPTION 'model "%" does not follow %', model, origin USING ERRCODE = '42704',
            HINT = format('SELECT * FROM streetgen.follow(%L, %L, …) makes it do so.', model, origin);
    END IF;
    IF follower.signature IS NOT NULL THEN
        EXECUTE format('DROP FUNCTION %s CASCADE', follower.signature);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen.unfollow(name, regclass) IS
    'Takes follow back: the triggers go, the axes stay. Needs the rights of the owner of the model (42501), not of '
    'the table; a table that is not followed: 42704.';
