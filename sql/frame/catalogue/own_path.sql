-- A model finds its tables and functions, and functions and types of PostGIS, by search_path. So it would find those of
-- others there that fit better or come first.

CREATE OR REPLACE FUNCTION streetgen._check_functions_beside(model name, owner oid, caller oid) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    postgis record;
    searched record;
    -- Roles that have the rights of the owner, of PostGIS or of its schema anyway.
    trusted oid[];
    creators text;
    planted text;
BEGIN
    PERFORM streetgen._require_its_build(model);
    SELECT n.oid, nspowner, extowner, e.oid AS extension INTO postgis
        FROM pg_extension e JOIN pg_namespace n ON n.oid = extnamespace WHERE extname = 'postgis';
    trusted := ARRAY(SELECT r.oid FROM pg_roles r WHERE pg_has_role(r.oid, owner, 'MEMBER')
        OR pg_has_role(r.oid, postgis.nspowner, 'MEMBER') OR r.oid = postgis.extowner);
    FOR searched IN SELECT oid, nspname, coalesce(nspacl, acldefault('n', nspowner)) AS acl,
            CASE oid WHEN postgis.oid THEN 'PostGIS is there.' ELSE 'The tables of the model are there.' END AS holds,
            CASE oid WHEN postgis.oid THEN 'an administrator' ELSE 'its owner' END AS keeper
        FROM pg_namespace WHERE oid = postgis.oid OR nspname = model ORDER BY oid = postgis.oid DESC
    LOOP
        SELECT string_agg(p.planted, ', ' ORDER BY p.planted) INTO planted FROM (
            SELECT p.oid::regprocedure || ' of role ' || proowner::regrole AS planted FROM pg_proc p
            WHERE pronamespace = searched.oid AND proowner <> ALL (trusted) AND EXISTS (SELECT FROM pg_proc o
                WHERE o.proname = p.proname AND (o.pronamespace = 'pg_catalog'::regnamespace
                    OR o.pronamespace IN (postgis.oid, searched.oid) AND o.proowner = ANY (trusted)))
            UNION ALL SELECT 'operator ' || p.oid::regoperator || ' of role ' || oprowner::regrole FROM pg_operator p
            WHERE oprnamespace = searched.oid AND oprowner <> ALL (trusted)
            UNION ALL SELECT 'type ' || p.oid::regtype || ' of role ' || typowner::regrole FROM pg_type p
            -- An array type goes with its element.
            WHERE typnamespace = searched.oid AND typowner <> ALL (trusted)
                AND NOT EXISTS (SELECT FROM pg_type e WHERE e.oid = p.typelem AND e.typarray = p.oid)
                AND EXISTS (SELECT FROM pg_depend
                JOIN pg_type o ON o.oid = objid WHERE (classid, refobjid, deptype) = ('pg_type'::regclass,
                    postgis.extension, 'e') AND o.typname = p.typname)) p;
        IF planted IS NOT NULL THEN
            PERFORM streetgen._refuse('42501', format('functions or types of others stand in for those of the '
                'system in schema "%s": %s', searched.nspname, planted),
                detail => format('They could run with the rights of role %s.', owner::regrole),
                hint => 'Drop them, or have their owners move them to another schema.');
        END IF;
        CONTINUE WHEN pg_has_role(caller, owner, 'MEMBER');
        SELECT string_agg(DISTINCT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END, ', ')
            INTO creators FROM aclexplode(searched.acl) WHERE privilege_type = 'CREATE' AND grantee <> ALL (trusted);
        IF creators IS NOT NULL THEN
            PERFORM streetgen._refuse('42501',
                format('schema "%s" is open to functions of %s', searched.nspname, creators),
                detail => format('%s What role %s edits runs with the rights of %s, the owner of the model, and so '
                    'could those functions.', searched.holds, caller::regrole, owner::regrole),
                hint => format('REVOKE CREATE ON SCHEMA %I FROM %s, by %s; other schemas may stay open.',
                    searched.nspname, creators, searched.keeper));
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_functions_beside(name, oid, oid) IS
    'Raises 55000 for a model of another build. Raises 42501 where the schema of PostGIS or of a model holds functions '
    'of others by names of the system, of PostGIS or of functions that the model has, or operators of theirs, or types '
    'by names of PostGIS. So it does where somebody edits with the rights of the owner while others may make such. '
    'Others: roles that have neither the rights of the owner nor own PostGIS or its schema.';

CREATE OR REPLACE FUNCTION streetgen._only_own_functions(model name) RETURNS boolean
    LANGUAGE c STABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_only_own_functions';
COMMENT ON FUNCTION streetgen._only_own_functions(name) IS
    'True; raises as _check_functions_beside for the owner of a model and, where a function runs with the rights of '
    'another role than that of the session, for who calls it. A model that is still to be made is that of the '
    'current role.';
