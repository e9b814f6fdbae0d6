-- Rows of whole chains, made at the end of a first run by clusters.

CREATE OR REPLACE FUNCTION streetgen._fill_chains(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    SET streetgen.computes = 'on'
    AS $$
DECLARE
    places jsonb := streetgen._upsert_places(model, 'whole');
    subject text;
    parts text[];
    part text;
    chained boolean := false;
BEGIN
    parts := ARRAY[streetgen._fill_template(streetgen._part('fill_chains'), places)];
    parts := parts || streetgen._parts_of_rooms('_%s_there', places);
    FOR subject IN SELECT jsonb_array_elements_text(places -> 'subjects') LOOP
        CONTINUE WHEN subject <> ALL (streetgen._subjects_at_end());
        EXECUTE format('SELECT streetgen.%I($1)', '_upsert_' || subject) INTO part USING places;
        parts := parts || part;
        chained := true;
    END LOOP;
    IF chained THEN
        EXECUTE 'WITH RECURSIVE ' || array_to_string(parts, ',') || ' SELECT';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._fill_chains(name) IS
    'Computes what is a function of whole chains from the nodes and edges of a model, for who is alone in it, at the '
    'end of a first run by clusters.';
