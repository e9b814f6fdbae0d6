-- Traffic is added to a model and taken away.

CREATE OR REPLACE FUNCTION streetgen._require_traffic(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT streetgen._has_traffic(model) THEN
        RAISE EXCEPTION 'model "%" has no traffic', model USING ERRCODE = '55000',
            HINT = format('SELECT streetgen.create_traffic(%L) adds its tables.', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_traffic(name) IS 'Raises 55000 for a model without the tables of traffic.';

CREATE OR REPLACE FUNCTION streetgen.create_traffic(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    before oid[];
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._require_subject(model, 'interconnection');
    IF streetgen._has_traffic(model) THEN
        RAISE EXCEPTION 'model "%" has traffic', model USING ERRCODE = '55000',
            HINT = format('SELECT streetgen.drop_traffic(%L) removes it.', model);
    END IF;
    before := streetgen._relations(model);
    PERFORM streetgen._make_tables(model, '{table}', streetgen._traffic_rooms());
    PERFORM streetgen._make_views(model), streetgen._make_simulation_edit_views(model),
        streetgen._give_to_owner(model, before), streetgen._grant_simulation_views(model),
        streetgen._make_own_keys(model);
    PERFORM streetgen._grant_like_axes(model, ARRAY(
        SELECT oid FROM unnest(streetgen._relations(model)) oid WHERE oid <> ALL (before)));
END $$;
COMMENT ON FUNCTION streetgen.create_traffic(name) IS
    'Adds the tables of traffic to a model: car and walker, with who is on its streets, actor_rule, with who '
    'place_actors places there, traffic_event, with what happens in simulations, and simulated, with what these kept; '
    'and views car_place, car_editing, event_place and walker_place. Editors may write all but simulated. A model '
    'without subject interconnection, or one with traffic: 55000; not the owner of the model: 42501; an unknown '
    'model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen.drop_traffic(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._require_traffic(model);
    EXECUTE (SELECT 'DROP VIEW IF EXISTS ' || string_agg(concat(quote_ident(model), '.', view), ', ')
        FROM unnest('{car_editing,car_place,event_place,walker_place}'::name[]) view);
    EXECUTE (SELECT 'DROP TABLE ' || string_agg(concat(quote_ident(model), '.', relation), ', ')
        FROM streetgen.template WHERE room = ANY (streetgen._traffic_rooms()));
END $$;
COMMENT ON FUNCTION streetgen.drop_traffic(name) IS
    'Removes the tables of traffic with all in them. No traffic: 55000; something of others that builds on them: '
    '2BP01; not the owner of the model: 42501.';

CREATE OR REPLACE FUNCTION streetgen._simulation_edited() RETURNS TABLE(relation name)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('car'::name), ('traffic_event') $$;
COMMENT ON FUNCTION streetgen._simulation_edited() IS 'The tables of traffic that an editor may write.';
