-- Distances to the kerbs observed follow the observations, whoever writes these.

CREATE OR REPLACE FUNCTION streetgen._update_distances(model name, places geometry[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Finding what lies about more places, or along such a line, takes longer than all of the model is worth.
    most_places constant integer := 64;
    longest constant float8 := 10000;
    far float8;
    axes bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- Streets that follow no edit get their distances from generate.
    IF places = '{}' OR NOT streetgen._live(model) THEN
        RETURN;
    END IF;
    PERFORM streetgen._begin_edit(model);
    IF cardinality(places) > most_places
        OR (SELECT bool_or(ST_Length(ST_BoundingDiagonal(place)) > longest) FROM unnest(places) place) THEN
        PERFORM streetgen._lock_all_places(model);
    ELSE
        -- A street that another session draws there comes before or after, and the later one sees the other.
        PERFORM streetgen._lock_ground(model, places);
        far := streetgen._fit_far(model);
        axes := ARRAY(SELECT DISTINCT e.axis_id FROM unnest(places) place
            JOIN edge e ON ST_DWithin(e.geom, place, far));
        PERFORM streetgen._lock_places(model, axes, wait => true);
    END IF;
    PERFORM FROM streetgen._update_fit(model, axes, NULL, NULL);
END $$;
COMMENT ON FUNCTION streetgen._update_distances(name, geometry[]) IS
    'Locks the places of observations that came, changed or went, and brings the distances of streets there up to '
    'date, where the model is live.';

CREATE OR REPLACE FUNCTION streetgen._make_fit_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'fit' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model, '{follow_observations}');
        RETURN;
    END IF;
    CREATE OR REPLACE FUNCTION follow_observations() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        IF TG_OP = 'INSERT' THEN
            PERFORM streetgen._update_distances(current_schema(), ARRAY(SELECT geom FROM new_observation));
        ELSIF TG_OP = 'DELETE' THEN
            PERFORM streetgen._update_distances(current_schema(), ARRAY(SELECT geom FROM old_observation));
        ELSIF TG_OP = 'UPDATE' THEN
            PERFORM streetgen._update_distances(current_schema(),
                ARRAY(SELECT geom FROM old_observation UNION ALL SELECT geom FROM new_observation));
        ELSIF streetgen._live(current_schema()) THEN
            -- TRUNCATE has its table alone. Who has read it is done, and who has not finds it empty: a session that
            -- holds places may wait for this one, which waits for no place.
            PERFORM FROM streetgen._update_fit(current_schema(), NULL, NULL, NULL);
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, 'follow_observations()', 'After an edit of observations: distances follow'),
        streetgen._make_statement_triggers(model, 'observation', 'follow', '{insert,update,delete,truncate}',
            'follow_observations()', 'old_observation', 'new_observation', 'Distances to kerbs follow');
END $$;
COMMENT ON FUNCTION streetgen._make_fit_functions(name) IS
    'Makes the triggers by which distances to kerbs follow the observations of a model that computes the fit.';
