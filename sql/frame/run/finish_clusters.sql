-- The end of a first run by clusters: what reaches beyond a cluster.

CREATE OR REPLACE FUNCTION streetgen._finish_clusters(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    SET streetgen.computes = 'on'
    AS $$
DECLARE
    places jsonb := streetgen._upsert_places(model, 'whole');
    chains constant text[] := ARRAY(SELECT s FROM unnest(streetgen._subjects_of_reach('chain')) WITH ORDINALITY u(s, n)
        WHERE places -> 'subjects' ? s ORDER BY n);
    subject text;
    part text;
    parts text[];
BEGIN
    IF chains <> '{}' THEN
        parts := ARRAY[streetgen._fill_template(streetgen._part('rows_there'), places)]
            || streetgen._parts_of_rooms('_%s_there', places);
        FOREACH subject IN ARRAY chains LOOP
            EXECUTE format('SELECT streetgen.%I($1)', '_upsert_' || subject) INTO part USING places;
            parts := parts || part;
        END LOOP;
        EXECUTE 'WITH RECURSIVE ' || array_to_string(parts, ',') || ' SELECT';
    END IF;
    PERFORM FROM streetgen._update_groups(model, NULL);
END $$;
COMMENT ON FUNCTION streetgen._finish_clusters(name) IS
    'Computes the chains of a model from the rows that clusters wrote, and then the groups, for who is alone in it. '
    'Rooms give the rows there that chains of others read by functions _ROOM_there (places).';
