-- A model finds functions of PostGIS by search_path, and so would find functions of others beside these whose arguments
-- fit better.

CREATE OR REPLACE FUNCTION streetgen._check_functions_beside(owner oid, caller oid) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    beside record;
    -- Roles that have the rights of the owner, of PostGIS or of its schema anyway.
    trusted oid[];
    creators text;
    planted text;
BEGIN
    SELECT n.oid, nspname, nspowner, coalesce(nspacl, acldefault('n', nspowner)) AS acl, extowner INTO beside
        FROM pg_extension JOIN pg_namespace n ON n.oid = extnamespace WHERE extname = 'postgis';
    trusted := ARRAY(SELECT r.oid FROM pg_roles r WHERE pg_has_role(r.oid, owner, 'MEMBER')
        OR pg_has_role(r.oid, beside.nspowner, 'MEMBER') OR r.oid = beside.extowner);
    SELECT string_agg(p.planted, ', ' ORDER BY p.planted) INTO planted FROM (
        SELECT p.oid::regprocedure || ' of role ' || proowner::regrole AS planted FROM pg_proc p
        WHERE pronamespace = beside.oid AND proowner <> ALL (trusted) AND EXISTS (SELECT FROM pg_proc o
            WHERE o.proname = p.proname AND (o.pronamespace = 'pg_catalog'::regnamespace
                OR o.pronamespace = beside.oid AND o.proowner = ANY (trusted)))
        UNION ALL SELECT 'operator ' || p.oid::regoperator || ' of role ' || oprowner::regrole FROM pg_operator p
        WHERE oprnamespace = beside.oid AND oprowner <> ALL (trusted)) p;
    IF planted IS NOT NULL THEN
        PERFORM streetgen._refuse('42501',
            format('functions of others stand in for those of the system in schema "%s": %s', beside.nspname, planted),
            detail => format('They could run with the rights of role %s.', owner::regrole),
            hint => 'Drop them, or have their owners move them to another schema.');
    ELSIF pg_has_role(caller, owner, 'MEMBER') THEN
        RETURN;
    END IF;
    SELECT string_agg(DISTINCT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END, ', ') INTO creators
        FROM aclexplode(beside.acl) WHERE privilege_type = 'CREATE' AND grantee <> ALL (trusted);
    IF creators IS NOT NULL THEN
        PERFORM streetgen._refuse('42501', format('schema "%s" is open to functions of %s', beside.nspname, creators),
            detail => format('PostGIS is there. What role %s edits runs with the rights of %s, the owner of the model, '
                'and so could those functions.', caller::regrole, owner::regrole),
            hint => format('REVOKE CREATE ON SCHEMA %I FROM %s, by an administrator; other schemas may stay open.',
                beside.nspname, creators));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_functions_beside(oid, oid) IS
    'Raises 42501 where the schema of PostGIS holds functions or operators of others by names of the system, or where '
    'somebody edits with the rights of the owner while others may make such. Others: roles that have neither the '
    'rights of the owner nor own PostGIS or its schema.';

CREATE OR REPLACE FUNCTION streetgen._only_own_functions(model name) RETURNS boolean
    LANGUAGE c STABLE STRICT PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_only_own_functions';
COMMENT ON FUNCTION streetgen._only_own_functions(name) IS
    'True; raises as _check_functions_beside for the owner of a model and, where a function runs with the rights of '
    'another role than that of the session, for who calls it. A model that is still to be made is that of the '
    'current role.';
