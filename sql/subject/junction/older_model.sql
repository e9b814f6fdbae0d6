-- Kinds that models of older builds do not know.

CREATE OR REPLACE FUNCTION streetgen._mend_junction_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    older constant name[] := ARRAY(SELECT c.relname FROM pg_constraint k JOIN pg_class c ON c.oid = k.conrelid
        WHERE k.connamespace = to_regnamespace(quote_ident(model))
            AND k.conname IN ('junction_kind_check', 'junction_override_kind_check')
            AND pg_get_constraintdef(k.oid) NOT LIKE '%fork%');
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' = ANY (older) THEN
        ALTER TABLE junction DROP CONSTRAINT junction_kind_check, ADD CONSTRAINT junction_kind_check
            CHECK (kind IN ('ramp', 'fork', 'merge', 'signals', 'stop', 'priority', 'right_before_left', 'roundabout',
                'continuation', 'end'));
    END IF;
    IF 'junction_override' = ANY (older) THEN
        ALTER TABLE junction_override DROP CONSTRAINT junction_override_kind_check,
            ADD CONSTRAINT junction_override_kind_check CHECK (kind IN ('ramp', 'fork', 'merge', 'signals', 'stop',
                'priority', 'right_before_left', 'roundabout', 'continuation', 'end'));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mend_junction_tables(name) IS
    'Lets junctions of a model and decisions on them be a fork or a merge, where it was made before these kinds.';
