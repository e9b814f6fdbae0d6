-- Axes whose decisions moved with others in this transaction.

CREATE OR REPLACE FUNCTION streetgen._remapped(model name) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL RESTRICTED SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN nullif(current_setting('streetgen.remapped', true), '')::jsonb ->> model;
END $$;
COMMENT ON FUNCTION streetgen._remapped(name) IS
    'Axes of a model whose overrides have moved with axes that are not followed yet; NULL where none move.';

CREATE OR REPLACE FUNCTION streetgen._note_remapped(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    others constant jsonb := coalesce(nullif(current_setting('streetgen.remapped', true), '')::jsonb,
        '{}') - model::text;
BEGIN
    PERFORM set_config('streetgen.remapped',
        (others || jsonb_strip_nulls(jsonb_build_object(model, axes::text)))::text, true);
END $$;
COMMENT ON FUNCTION streetgen._note_remapped(name, bigint[]) IS
    'Sets what _remapped of a model tells until its axes are followed; NULL: they are.';
