-- The model that is measured.
CREATE SCHEMA bench;

-- Model `timed` with the axes and settings of an input, and no streets; subjects: as create_model takes them.
CREATE PROCEDURE bench.fill(input name, subjects text[] DEFAULT NULL) LANGUAGE plpgsql AS $$
DECLARE
    same name;
BEGIN
    IF to_regnamespace('timed') IS NOT NULL THEN PERFORM streetgen.drop_model('timed'); END IF;
    PERFORM streetgen.create_model('timed', srid, dimension, subjects => subjects) FROM streetgen.model WHERE name = input;
    PERFORM streetgen.live('timed', false);
    FOREACH same IN ARRAY ARRAY['setting', 'axis_class', 'axis', 'turn_restriction'] LOOP
        EXECUTE format('TRUNCATE timed.%1$I', same);
        EXECUTE format('INSERT INTO timed.%1$I SELECT * FROM %2$I.%1$I ORDER BY 1', same, input);
    END LOOP;
    ANALYZE timed.axis;
END $$;

-- The tables that generate fills, those that others refer to first.
CREATE FUNCTION bench.derived(model name) RETURNS SETOF text LANGUAGE sql AS $$
    SELECT relation FROM streetgen.generate(model, '{}') WITH ORDINALITY ORDER BY ordinality
$$;

-- Statistics as generate makes them, or by ANALYZE as PostgreSQL comes.
CREATE PROCEDURE bench.analyse(model name, by_default boolean DEFAULT false) LANGUAGE plpgsql AS $$
DECLARE
    relation text;
BEGIN
    FOR relation IN SELECT bench.derived('timed') LOOP
        IF by_default THEN
            EXECUTE format('ANALYZE %I.%I', model, relation);
        ELSE
            PERFORM streetgen._analyse(format('%I.%I', model, relation));
        END IF;
    END LOOP;
END $$;
