-- A model is a schema of the user's: these functions make it, hand it out and take it away.

CREATE OR REPLACE FUNCTION streetgen._register_model(model name, srid integer, dimension integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SECURITY DEFINER SET search_path = pg_catalog, pg_temp
    AS $$
BEGIN
    -- Inside a definer function current_user is the function's owner: ask for the caller's role.
    IF NOT pg_has_role(coalesce(nullif(current_setting('role'), 'none'), session_user)::name,
        (SELECT nspowner FROM pg_namespace WHERE nspname = model), 'MEMBER') THEN
        RAISE EXCEPTION 'schema "%" belongs to another role', model USING ERRCODE = '42501',
            HINT = 'Only the owner of a schema registers it as a model.';
    END IF;
    INSERT INTO streetgen.model VALUES (model, srid, dimension, streetgen.version(), streetgen._build_mark())
        ON CONFLICT (name) DO UPDATE SET srid = excluded.srid, dimension = excluded.dimension,
            template_version = excluded.template_version, build = excluded.build;
    DELETE FROM streetgen.model m WHERE NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = m.name);
END $$;
COMMENT ON FUNCTION streetgen._register_model(name, integer, integer) IS
    'Writes the registry, for the owner of the schema only; forgets models whose schema is gone.';

CREATE OR REPLACE FUNCTION streetgen._give_to_owner(model name, before oid[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    made record;
BEGIN
    FOR made IN SELECT c.oid::regclass AS relation, nspowner::regrole AS owner FROM pg_class c
        JOIN pg_namespace n ON n.oid = relnamespace
        WHERE c.oid = ANY (streetgen._relations(model)) AND c.oid <> ALL (before) AND relowner <> nspowner
    LOOP
        EXECUTE format('ALTER TABLE %s OWNER TO %s', made.relation, made.owner);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._give_to_owner(name, oid[]) IS
    'Gives the tables and views of a model that were not there before to the owner of its schema, whoever made them.';

CREATE OR REPLACE FUNCTION streetgen._add_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._make_tables(model, '{input_table}', streetgen._rooms());
    -- A room of which one table stands has all of them: a subject of which one is missing counts as switched off.
    PERFORM streetgen._make_tables(model, ARRAY[p.part], ARRAY(SELECT DISTINCT t.room FROM streetgen.template t
            WHERE t.part = p.part AND to_regclass(format('%I.%I', model, t.relation)) IS NOT NULL))
        FROM unnest('{kept_table,table}'::text[]) p(part);
    PERFORM streetgen._call_rooms('_mend_%s_tables', model, streetgen._rooms()),
        streetgen._complete_tables(model);
END $$;
COMMENT ON FUNCTION streetgen._add_tables(name) IS
    'Makes the tables, columns, indexes and comments that came after the first models, where they are missing.';

CREATE OR REPLACE FUNCTION streetgen._complete_settings(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    INSERT INTO setting AS s SELECT * FROM streetgen._default_setting() ON CONFLICT (name) DO UPDATE
        SET (unit, description, minimum, maximum, choice)
            = (excluded.unit, excluded.description, excluded.minimum, excluded.maximum, excluded.choice)
        WHERE (s.unit, s.description, s.minimum, s.maximum, s.choice) IS DISTINCT FROM (excluded.unit,
            excluded.description, excluded.minimum, excluded.maximum, excluded.choice);
END $$;
COMMENT ON FUNCTION streetgen._complete_settings(name) IS
    'Gives a model the settings that came later, with their defaults, and all settings the ranges of this build.';

CREATE OR REPLACE FUNCTION streetgen.create_model(model name, srid integer, dimension integer DEFAULT 2,
    subjects text[] DEFAULT NULL, driving_side text DEFAULT 'auto') RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wanted constant text[] := streetgen._with_needs(subjects);
BEGIN
    PERFORM streetgen._require_one_build(), streetgen._check_given('model', model, 'srid', srid::text,
        'dimension', dimension::text, 'driving_side', driving_side);
    IF model = '' THEN
        RAISE EXCEPTION 'the model needs a name' USING ERRCODE = '22023',
            HINT = 'It names the schema of the model''s tables.';
    END IF;
    IF dimension NOT IN (2, 3) THEN
        RAISE EXCEPTION 'dimension is %, expected 2 or 3', dimension USING ERRCODE = '22023',
            HINT = '3 keeps the heights of axes and nodes.';
    END IF;
    PERFORM streetgen._check_srid(srid);
    IF EXISTS (SELECT FROM pg_namespace WHERE nspname = model) THEN
        RAISE EXCEPTION 'schema "%" already exists', model USING ERRCODE = '42P06',
            HINT = format('Choose another name, or SELECT streetgen.drop_model(%L) if it is a model that may go.',
                model);
    END IF;
    IF NOT has_database_privilege(current_database(), 'CREATE') THEN
        RAISE EXCEPTION 'role "%" may not make models in database "%"', current_user, current_database()
            USING ERRCODE = '42501',
            HINT = format('GRANT CREATE ON DATABASE %I TO %I by its owner allows it.', current_database(),
                current_user);
    END IF;
    PERFORM streetgen._only_own_functions(model);
    EXECUTE format('CREATE SCHEMA %1$I; COMMENT ON SCHEMA %1$I IS %2$L', model,
        'Street model of StreetGen: axes in, streets out');
    PERFORM streetgen._register_model(model, srid, dimension);
    PERFORM streetgen._make_tables(model, '{kept_table,table}', '{frame,axis}'::text[] || wanted),
        streetgen._make_tables(model, '{input_table}', streetgen._rooms());
    PERFORM streetgen._make_dependents(model);
    IF driving_side <> 'auto' THEN
        PERFORM streetgen.set(model, 'driving_side', driving_side);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen.create_model(name, integer, integer, text[], text) IS
    'Makes schema model with the tables of a street model in the given SRID (projected, metres). dimension: 3 keeps '
    'the heights of axes and nodes. subjects: what is computed besides network and surface, each with what it needs '
    '(streetgen.subject lists them); the word all stands for every one, drawn for those that pictures show, default '
    'or NULL for lanes and paths; '
    'another word: 22023. '
    'driving_side: the setting of that name, auto, right or left. An existing schema: 42P06; an unfit '
    'SRID: 22023 with a hint; a role that may not create schemas: 42501.';

CREATE OR REPLACE FUNCTION streetgen.drop_model(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    schema oid;
    part text;
BEGIN
    PERFORM streetgen._require_owner(model);
    schema := (SELECT oid FROM pg_namespace WHERE nspname = model);
    -- The parts named here go without a notice. A notice tells of what others made of them.
    FOR part IN SELECT format('DROP %s %s CASCADE', kind, string_agg(name, ', ')) FROM (
            SELECT 1 AS turn, 'VIEW' AS kind, oid::regclass::text AS name FROM pg_class WHERE relnamespace = schema
                AND relkind = 'v'
            UNION ALL SELECT 2, 'TABLE', oid::regclass::text FROM pg_class WHERE relnamespace = schema
                AND relkind IN ('r', 'p')
            -- Functions of the rows of a table have gone with it.
            UNION ALL SELECT 3, 'ROUTINE', p.oid::regprocedure::text FROM pg_proc p WHERE pronamespace = schema
                AND NOT EXISTS (SELECT FROM pg_type t WHERE t.typnamespace = schema
                    AND (t.oid = prorettype OR t.oid = ANY (proargtypes)))) p
                GROUP BY turn, kind ORDER BY turn
    LOOP
        EXECUTE part;
    END LOOP;
    EXECUTE format('DROP SCHEMA %I CASCADE', model);
    PERFORM streetgen._forget_models(), streetgen._forget_styles(model);
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.drop_model(name) IS
    'Drops the schema of a model with all in it, its QGIS project too, and the styles that QGIS keeps for its layers '
    'in public.layer_styles; a table of styles that belongs neither to the caller nor to a superuser, or may not be '
    'written, is left as it is. A lock_timeout that ends: 55P03, naming who holds the model.';

CREATE OR REPLACE FUNCTION streetgen._forget_styles(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A table of somebody else could run his trigger with the rights of the caller.
    IF EXISTS (SELECT FROM pg_class c JOIN pg_roles r ON r.oid = relowner JOIN pg_attribute ON attrelid = c.oid
        WHERE c.oid = to_regclass('public.layer_styles') AND relkind = 'r'
               AND (r.rolsuper OR r.rolname = current_user) AND has_table_privilege(c.oid, 'SELECT')
                   AND has_table_privilege(c.oid, 'DELETE') AND attname = 'f_table_schema' AND NOT attisdropped) THEN
        EXECUTE 'DELETE FROM public.layer_styles WHERE f_table_schema = $1' USING model;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._forget_styles(name) IS
    'Deletes the styles of the layers of a model from the table that QGIS keeps them in.';

CREATE OR REPLACE FUNCTION streetgen._forget_models() RETURNS void
    LANGUAGE sql VOLATILE PARALLEL UNSAFE SECURITY DEFINER SET search_path = pg_catalog, pg_temp
    AS $$ DELETE FROM streetgen.model m WHERE NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = m.name) $$;
COMMENT ON FUNCTION streetgen._forget_models() IS 'Takes models whose schema is gone out of the registry.';

CREATE OR REPLACE FUNCTION streetgen._renew_model(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    before constant oid[] := streetgen._relations(model);
BEGIN
    PERFORM streetgen._add_tables(model), streetgen._complete_settings(model), streetgen._make_dependents(model);
    -- Also on views that a restore brought back without their readers.
    PERFORM streetgen._grant_like_axes(model, ARRAY(
        SELECT oid FROM pg_class WHERE oid = ANY (streetgen._relations(model))
            AND (oid <> ALL (before) OR relkind = 'v' AND relname NOT LIKE '%\_editing')));
    PERFORM streetgen._grant_edit_views(model), streetgen._call_rooms('_grant_%s_views', model, streetgen._rooms());
    PERFORM streetgen._call_rooms('_adopt_%s', model, streetgen._rooms());
END $$;
COMMENT ON FUNCTION streetgen._renew_model(name) IS
    'Gives a model of another build the tables, settings, views, triggers and rights of this one.';

CREATE OR REPLACE FUNCTION streetgen.adopt_model(schema name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid integer;
    dimension integer;
    missing text[];
BEGIN
    PERFORM streetgen._require_one_build(), streetgen._check_given('schema', schema);
    missing := ARRAY(SELECT name
        FROM unnest(ARRAY['setting', 'axis_class', 'axis', 'transition_override', 'node', 'edge', 'section_limit',
        'section', 'corner', 'intersection', 'report']) name
        -- Whoever may not see the schema is told so below, not that nothing is there.
        WHERE NOT EXISTS (SELECT FROM pg_class c JOIN pg_namespace n ON n.oid = relnamespace
            WHERE nspname = schema AND relname = name));
    IF missing <> '{}' THEN
        RAISE EXCEPTION 'schema "%" holds no street model', schema USING ERRCODE = '3F000',
            HINT = format('Its tables %s are missing.', array_to_string(missing, ', '));
    END IF;
    PERFORM streetgen._require_schema_owner(schema);
    SELECT g.srid, g.coord_dimension INTO srid, dimension FROM geometry_columns g
        WHERE f_table_schema = schema AND f_table_name = 'axis' AND f_geometry_column = 'geom';
    IF NOT FOUND OR srid = 0 THEN
        RAISE EXCEPTION 'schema "%" holds no street model', schema USING ERRCODE = '3F000',
            HINT = 'Its table axis has no column geom with an SRID.';
    END IF;
    PERFORM streetgen._register_model(schema, srid, dimension);
    PERFORM streetgen._only_own_functions(schema);
    PERFORM streetgen._drop_own_functions(schema), streetgen._give_to_owner(schema, '{}'),
        streetgen._as_owner(schema, '_renew_model');
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(schema, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.adopt_model(name) IS
    'Registers a schema that holds the tables of a model (after a restore, or DROP EXTENSION CASCADE) and puts its '
    'views and triggers back, with their comments and readers, also those by which it follows a table (a warning for '
    'one that it cannot follow); tables that came later are added. What it makes belongs to the owner of the schema, '
    'also where a superuser calls it. A schema without the tables: 3F000; one of another role: 42501; something else '
    'by the name of one of its tables or views: 42809. A lock_timeout that ends: 55P03, naming who holds the model.';

CREATE OR REPLACE FUNCTION streetgen._take_back(model name, role name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- 0 is everybody.
    holder constant oid := coalesce((SELECT oid FROM pg_roles WHERE rolname = role), 0);
    held text;
BEGIN
    IF role <> 'public' AND holder = 0 THEN
        RAISE EXCEPTION 'role "%" does not exist', role USING ERRCODE = '42704',
            HINT = 'SELECT rolname FROM pg_roles lists them; public is everybody.';
    ELSIF holder = (SELECT nspowner FROM pg_namespace WHERE nspname = model) THEN
        RAISE EXCEPTION 'role "%" owns model "%" and keeps all rights', role, model USING ERRCODE = '22023',
            HINT = format('Another role owns it after ALTER SCHEMA %I OWNER TO …, and the same for its tables and '
                'views.', model);
    END IF;
    FOR held IN
        SELECT c.oid::regclass::text FROM pg_class c
        WHERE relnamespace = quote_ident(model)::regnamespace AND relkind IN ('r', 'p', 'v', 'm', 'f', 'S')
            AND relowner <> holder
            AND (EXISTS (SELECT FROM aclexplode(relacl) a WHERE a.grantee = holder)
                OR EXISTS (SELECT FROM pg_attribute, aclexplode(attacl) a WHERE attrelid = c.oid
                    AND a.grantee = holder))
        UNION ALL SELECT 'ROUTINE ' || p.oid::regprocedure FROM pg_namespace n JOIN pg_proc p ON pronamespace = n.oid
        WHERE nspname = model AND proowner = nspowner
            AND EXISTS (SELECT FROM aclexplode(proacl) a WHERE a.grantee = holder)
        UNION ALL SELECT format('SCHEMA %I', model)
    LOOP
        EXECUTE format('REVOKE ALL ON %s FROM %I CASCADE', held, role);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._take_back(name, name) IS
    'Takes all rights on the schema of a model and on what is in it from a role. An unknown role: 42704; the owner '
        'of the model: 22023.';

CREATE OR REPLACE FUNCTION streetgen.grant(model name, role name, kind text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
    written record;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('role', role, 'kind', kind);
    IF kind NOT IN ('reader', 'editor') THEN
        RAISE EXCEPTION 'unknown kind of right "%"', kind USING ERRCODE = '22023', HINT = 'reader or editor';
    END IF;
    PERFORM streetgen._take_back(model, role);
    EXECUTE format('GRANT USAGE ON SCHEMA %1$I TO %2$I; GRANT SELECT ON ALL TABLES IN SCHEMA %1$I TO %2$I', model,
        role);
    IF kind = 'editor' THEN
        FOREACH relation IN ARRAY streetgen._edited_tables(model) LOOP
            EXECUTE format('GRANT INSERT, UPDATE, DELETE ON %I.%I TO %I', model, relation, role);
        END LOOP;
        FOR written IN SELECT * FROM streetgen._written() LOOP
            EXECUTE format('GRANT %s ON %I.%I TO %I', written.privilege, model, written.relation, role);
        END LOOP;
    END IF;
    PERFORM streetgen._grant_edit_views(model),
        streetgen._call_rooms('_grant_%s_views', model, streetgen._rooms()),
        streetgen._call_rooms('_grant_%s_locks', model, streetgen._rooms());
END $$;
COMMENT ON FUNCTION streetgen.grant(name, name, text) IS
    'Sets the rights of a role on a model: to read it (reader), or also to edit its input: axes, turn restrictions, '
        'overrides (editor). Rights beyond these are taken back. '
    'Role public: everybody. An unknown role: 42704; the owner of the model, who keeps all rights: 22023; another '
        'kind: 22023. Needs the rights of the owner (42501).';

CREATE OR REPLACE FUNCTION streetgen.revoke(model name, role name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    through text;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('role', role);
    PERFORM streetgen._take_back(model, role);
    -- A right that a role has by others stays when it loses its own.
    SELECT string_agg(CASE grantee WHEN 0 THEN 'public' ELSE grantee::regrole::text END, ', ' ORDER BY grantee)
        INTO through
        FROM pg_namespace, aclexplode(nspacl) WHERE nspname = model AND privilege_type = 'USAGE' AND role <> 'public'
            AND CASE WHEN grantee = 0 THEN true ELSE pg_has_role(role, grantee, 'USAGE') END;
    IF through IS NOT NULL THEN
        RAISE WARNING 'role "%" still has rights on model "%" through %', role, model, through
            USING HINT = 'Revoke those too, or take the role out of these roles.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen.revoke(name, name) IS
    'Takes all rights on a model from a role; role public: what everybody has. A warning names the roles through '
        'which it still has some. '
    'An unknown role: 42704; the owner of the model, who keeps all rights: 22023. Needs the rights of the owner '
        '(42501).';
