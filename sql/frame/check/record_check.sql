-- Findings of a check stay in the model, where a GIS shows them.

CREATE OR REPLACE FUNCTION streetgen._frame_written() RETURNS TABLE(relation name, privilege text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES ('check_result'::name, 'INSERT'), ('check_result', 'DELETE') $$;
COMMENT ON FUNCTION streetgen._frame_written() IS
    'The rights by which an editor calls streetgen.record_check.';

CREATE OR REPLACE FUNCTION streetgen._flag_place(geom geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE WHEN NOT ST_IsEmpty(geom) THEN ST_PointOnSurface(ST_CurveToLine(ST_Force2D(geom))) END $$;
COMMENT ON FUNCTION streetgen._flag_place(geometry) IS
    'The point where a flag for a geometry stands, on it; NULL: it is empty.';

CREATE OR REPLACE FUNCTION streetgen.record_check(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    owner constant name := (SELECT pg_get_userbyid(nspowner) FROM pg_namespace WHERE nspname = model);
    found bigint;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_reader(model);
    IF owner <> current_user AND pg_has_role(owner, 'USAGE') THEN
        RETURN streetgen._as_owner(model, 'record_check');
    END IF;
    IF NOT has_table_privilege('check_result', 'INSERT') OR NOT has_table_privilege('check_result', 'DELETE') THEN
        RAISE EXCEPTION 'role "%" may not write check_result of model "%"', current_user, model
            USING ERRCODE = '42501', HINT = format('SELECT * FROM streetgen.check_model(%L) shows the same; '
                'SELECT streetgen.grant(%1$L, %L, ''editor'') by its owner allows it.', model, current_user);
    END IF;
    -- Two checks at a time would both leave their rows.
    LOCK TABLE check_result IN SHARE ROW EXCLUSIVE MODE;
    DELETE FROM check_result;
    INSERT INTO check_result (rule, severity, relation, id, measure, hint, place)
        SELECT f.rule, f.severity, f.relation, f.id, f.measure, replace(r.hint, '`', ''),
            streetgen._flag_place(f.geom)
        FROM streetgen.check_model(model) f LEFT JOIN streetgen.check_rule r USING (rule);
    GET DIAGNOSTICS found = ROW_COUNT;
    RETURN found;
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.record_check(name) IS
    'Writes what streetgen.check_model finds, with the way out of each, into table check_result of the model, in place '
    'of what stood there, and returns the number of rows. Who has the rights of the owner of the model '
    'writes with these alone. Needs the rights of an editor (42501). An unknown model: '
    '3F000. A lock_timeout that ends: 55P03, naming who holds the table.';
