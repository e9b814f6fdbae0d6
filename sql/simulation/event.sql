-- Events of traffic: what is to happen in a simulation, and when it did.

CREATE OR REPLACE FUNCTION streetgen._events_on_links(model name) RETURNS streetgen.traffic_event[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    placed streetgen.traffic_event[];
    nowhere bigint;
    for_nobody bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._has_traffic(model) THEN
        RETURN '{}';
    END IF;
    placed := ARRAY(SELECT (v.traffic_event_id, v.kind, v.trigger, p.link_id, p.metres, v.at, v.car_id,
            v.speed, v.deceleration, coalesce(v.duration, 'infinity'))::streetgen.traffic_event
        FROM traffic_event v JOIN event_place p USING (traffic_event_id) ORDER BY v.traffic_event_id);
    nowhere := (SELECT count(*) FROM traffic_event) - cardinality(placed);
    IF nowhere > 0 THEN
        RAISE WARNING '% rows of table traffic_event are on no lane, and are left out', nowhere
            USING HINT = 'View event_place has those that are.';
    END IF;
    for_nobody := (SELECT count(*) FROM traffic_event v LEFT JOIN car c USING (car_id)
        WHERE v.car_id IS NOT NULL AND c.car_id IS NULL);
    IF for_nobody > 0 THEN
        RAISE WARNING '% rows of table traffic_event are for cars that table car lacks, and do not fire', for_nobody
            USING HINT = 'Set their car_id to NULL for whichever car comes first, or delete them.';
    END IF;
    RETURN placed;
END $$;
COMMENT ON FUNCTION streetgen._events_on_links(name) IS
    'The events of a model that are on a link, with a warning of those on none, and of those for no car; none of a '
    'model without traffic.';

CREATE OR REPLACE FUNCTION streetgen._fired_events(network bytea, cars streetgen.traffic_car[], entries bigint[],
    flows float8[], turn_links bigint[], turn_next bigint[], turn_shares float8[], events streetgen.traffic_event[],
    duration float8, step float8, seed bigint)
    RETURNS TABLE(event_id bigint, t float8, car_id bigint, link bigint, metres float8)
    LANGUAGE c STABLE STRICT PARALLEL UNSAFE COST 100000 ROWS 10 AS 'MODULE_PATHNAME', 'streetgen_fired_events';
COMMENT ON FUNCTION streetgen._fired_events(bytea, streetgen.traffic_car[], bigint[], float8[], bigint[], bigint[],
    float8[], streetgen.traffic_event[], float8, float8, bigint) IS
    'What streetgen.fired_events gives, on a network.';

CREATE OR REPLACE FUNCTION streetgen._fired(model name, duration float8, step float8, demand jsonb, seed bigint)
    RETURNS TABLE(event_id bigint, t float8, car_id bigint, link_id bigint, metres float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('duration', duration::text, 'step', step::text,
        'demand', demand::text, 'seed', seed::text), streetgen._require_traffic(model),
        streetgen._require_subject(model, 'interconnection'),
        streetgen._known_keys(demand, 'demand', '{flow,entries,turns}');
    RETURN QUERY SELECT f.event_id, f.t, f.car_id, f.link, f.metres FROM streetgen._demand_arrays(model, demand) d,
        streetgen._fired_events(streetgen._network_of_links(model), streetgen._cars_on_links(model), d.entries, d.flows,
            d.turn_links, d.turn_next, d.turn_shares, streetgen._events_on_links(model), duration, step, seed) f;
END $$;
COMMENT ON FUNCTION streetgen._fired(name, float8, float8, jsonb, bigint) IS 'What streetgen.fired_events gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.fired_events(model name, duration float8 DEFAULT 600, step float8 DEFAULT 0.1,
    demand jsonb DEFAULT '{}', seed bigint DEFAULT 1)
    RETURNS TABLE(traffic_event_id bigint, t float8, car_id bigint, link bigint, metres float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._fired($1, $2, $3, $4, $5) $$;
COMMENT ON FUNCTION streetgen.fired_events(name, float8, float8, jsonb, bigint) IS
    'When each row of table traffic_event fires in the run that streetgen.simulate gives by method idm for these '
    'arguments: at t, seconds, in the step after its trigger; for which car, NULL: none; where its front is then. An '
    'event whose trigger does not come has no row. A model without traffic: 55000; else as simulate. Campos, section '
    '3.4.';
