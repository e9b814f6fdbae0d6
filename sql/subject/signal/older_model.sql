-- Values that models of older builds may hold.

CREATE OR REPLACE FUNCTION streetgen._mend_signal_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    named bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT EXISTS (SELECT FROM pg_constraint WHERE conrelid = format('%I.controller_override', model)::regclass
        AND conname = 'controller_override_program_check') THEN
        WITH named AS (UPDATE controller_override SET program = NULL WHERE program NOT IN ('phases', 'paper')
                RETURNING controller_override_id)
            SELECT array_agg(controller_override_id ORDER BY controller_override_id) INTO named FROM named;
        IF named IS NOT NULL THEN
            RAISE WARNING 'rows % of %.controller_override named a function: they have the program of the model now',
                named, model USING HINT = 'Setting signal_program names a function for all of them.';
        END IF;
        ALTER TABLE controller_override ADD CONSTRAINT controller_override_program_check
            CHECK (program IN ('phases', 'paper'));
    END IF;
    IF to_regclass('signal_state') IS NOT NULL THEN
        ALTER TABLE signal_state DROP CONSTRAINT signal_state_kind_check,
            ADD CONSTRAINT signal_state_kind_check CHECK (kind IN ('green', 'amber', 'all_red', 'walk'));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mend_signal_tables(name) IS
    'Takes from the editors of an older model what names a function, which runs with the rights of the owner: '
    'controller_override.program. States may be walks.';
