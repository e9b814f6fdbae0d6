-- Columns that models of older builds lack, and rights that they give.

CREATE OR REPLACE FUNCTION streetgen._mend_object_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    part text;
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regclass(format('%I.street_object', model)) IS NULL THEN
        RETURN;
    END IF;
    ALTER TABLE placement_rule ADD IF NOT EXISTS turn text CHECK (turn ~ '^[a-z_]+$'),
        DROP CONSTRAINT IF EXISTS placement_rule_along_check,
        ADD CONSTRAINT placement_rule_along_check CHECK (along IN ('border', 'axis', 'arm', 'corner', 'lane'));
    ALTER TABLE street_object ADD IF NOT EXISTS control_point_id bigint,
        ADD IF NOT EXISTS by_hand text[] NOT NULL DEFAULT '{}';
    -- Types that came with tracks and refuges. One that somebody deleted since stays away.
    IF NOT EXISTS (SELECT FROM setting WHERE name = 'track_width') THEN
        INSERT INTO object_type (type, category, parent, geometry, symbol, size, description)
            SELECT * FROM streetgen._default_object_type() d WHERE d.type IN ('tram_stop', 'platform')
                OR d.category = 'calming' ON CONFLICT DO NOTHING;
    END IF;
    ALTER TABLE IF EXISTS object_edge DROP CONSTRAINT IF EXISTS object_edge_street_object_id_fkey,
        DROP CONSTRAINT IF EXISTS object_edge_edge_id_fkey;
    -- Rights on single columns are rights to write them, too.
    FOR part IN SELECT DISTINCT format('REVOKE %s ON %I.specialised_type FROM %s CASCADE',
            privilege_type || CASE WHEN attribute IS NULL THEN '' ELSE format(' (%I)', attribute) END, model,
            CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END)
        FROM pg_class c CROSS JOIN LATERAL (
            SELECT a.*, NULL AS attribute FROM aclexplode(c.relacl) a
            UNION ALL SELECT a.*, attname FROM pg_attribute, aclexplode(attacl) a WHERE attrelid = c.oid) held
        WHERE c.oid = to_regclass(format('%I.specialised_type', model)) AND grantee <> relowner
            AND privilege_type <> 'SELECT'
    LOOP
        EXECUTE part;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._mend_object_tables(name) IS
    'Adds to the tables of objects of an older model what they lack, and takes from its editors what names a function, '
    'which runs with the rights of the owner: table specialised_type.';
