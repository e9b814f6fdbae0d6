-- Traffic on the streets of a model, step by step.

CREATE OR REPLACE FUNCTION streetgen._simulate(network bytea, cars streetgen.traffic_car[], entries bigint[],
    flows float8[], turn_links bigint[], turn_next bigint[], turn_shares float8[], method text, duration float8,
    step float8, output float8, seed bigint, law oid,
    events streetgen.traffic_event[])
    RETURNS TABLE(t float8, car_id bigint, cell_id bigint, link bigint, metres float8, length float8, width float8,
        kind text, speed float8, density float8, x float8, y float8, height float8, heading float8)
    LANGUAGE c STABLE STRICT PARALLEL UNSAFE COST 100000 ROWS 10000 AS 'MODULE_PATHNAME', 'streetgen_simulate';
COMMENT ON FUNCTION streetgen._simulate(bytea, streetgen.traffic_car[], bigint[], float8[], bigint[], bigint[],
    float8[], text, float8, float8, float8, bigint, oid, streetgen.traffic_event[]) IS
    'What streetgen.simulate gives, on a network. x and y: of the front of a car or the middle of a cell. heading: '
    'radians, of a car from its rear to its front. length: of a car or a cell. Cars enter at links by flows (an hour) '
    'and turn by shares. law: of cars that follow, in place of that of idm; 0: none.';

CREATE OR REPLACE FUNCTION streetgen._known_keys(given jsonb, name text, known text[]) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    other text;
BEGIN
    IF jsonb_typeof(given) <> 'object' THEN
        RAISE EXCEPTION '% is a JSON %, expected an object', name, jsonb_typeof(given) USING ERRCODE = '22023',
            HINT = format('It may have %s.', array_to_string(known, ', '));
    END IF;
    other := (SELECT min(k) FROM jsonb_object_keys(given) k WHERE k <> ALL (known));
    IF other IS NOT NULL THEN
        RAISE EXCEPTION '% has no "%"', name, other USING ERRCODE = '22023',
            HINT = format('It may have %s.', array_to_string(known, ', '));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._known_keys(jsonb, text, text[]) IS
    'Raises 22023 for what is no object, and for a key that is none of those known.';

CREATE OR REPLACE FUNCTION streetgen._require_numbers(list jsonb, name text, keys text[]) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    wrong record;
BEGIN
    IF jsonb_typeof(list) <> 'array' THEN
        RAISE EXCEPTION '% is a JSON %, expected an array', name, jsonb_typeof(list) USING ERRCODE = '22023',
            HINT = format('Each element has %s.', array_to_string(keys, ', '));
    END IF;
    SELECT e.ordinality, k AS key INTO wrong FROM jsonb_array_elements(list) WITH ORDINALITY e(value, ordinality),
        unnest(keys) k WHERE jsonb_typeof(e.value -> k) IS DISTINCT FROM 'number' ORDER BY e.ordinality, k LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'element % of % has no number "%"', wrong.ordinality, name, wrong.key USING ERRCODE = '22023',
            HINT = format('Each element has %s.', array_to_string(keys, ', '));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_numbers(jsonb, text, text[]) IS
    'Raises 22023 for what is no array, and for an element without a number of each of some keys.';

CREATE OR REPLACE FUNCTION streetgen._demand_entries(model name, demand jsonb)
    RETURNS TABLE(link bigint, flow float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF demand ?& '{flow,entries}' THEN
        RAISE EXCEPTION 'demand has flow and entries' USING ERRCODE = '22023',
            HINT = 'Entries name each lane, and flow holds for all that begin.';
    ELSIF demand ? 'flow' AND jsonb_typeof(demand -> 'flow') <> 'number' THEN
        RAISE EXCEPTION 'flow is "%", expected a number', demand ->> 'flow' USING ERRCODE = '22023',
            HINT = 'It counts cars an hour.';
    ELSIF demand ? 'entries' THEN
        PERFORM streetgen._require_numbers(demand -> 'entries', 'entries', '{link,flow}');
        RETURN QUERY SELECT (e ->> 'link')::bigint, (e ->> 'flow')::float8
            FROM jsonb_array_elements(demand -> 'entries') e;
        RETURN;
    END IF;
    -- Traffic comes from outside where no movement leads to a lane.
    RETURN QUERY SELECT k.link_id, coalesce((demand ->> 'flow')::float8,
            a.flow / greatest(e.lanes_forward + e.lanes_backward + e.lanes_both, 1))
        FROM link k JOIN lane l USING (lane_id) JOIN edge e USING (edge_id) JOIN axis a USING (axis_id)
        WHERE k.kind = 'lane' AND k.traffic IS NULL AND l.kind = 'general' AND (demand ? 'flow' OR a.flow IS NOT NULL)
            AND NOT EXISTS (SELECT FROM link m WHERE m.lane_out = k.lane_id AND m.along_out = k.along_axis)
            AND EXISTS (SELECT FROM link m WHERE m.lane_in = k.lane_id AND m.along_in = k.along_axis)
        ORDER BY k.link_id;
END $$;
COMMENT ON FUNCTION streetgen._demand_entries(name, jsonb) IS
    'Where cars enter by a demand, and how many an hour: as entries says, else where lanes begin to which no movement '
    'leads, as flow says for each, or as axis.flow says for the street.';

CREATE OR REPLACE FUNCTION streetgen._demand_turns(model name, demand jsonb)
    RETURNS TABLE(link bigint, next bigint, share float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF jsonb_typeof(demand -> 'turns') = 'array' THEN
        PERFORM streetgen._require_numbers(demand -> 'turns', 'turns', '{link,next,share}');
        RETURN QUERY SELECT (e ->> 'link')::bigint, (e ->> 'next')::bigint, (e ->> 'share')::float8
            FROM jsonb_array_elements(demand -> 'turns') e;
    ELSIF coalesce(demand ->> 'turns', 'even') = 'even' THEN
        -- Who may go on does not turn back. Nobody drives where that is for others alone.
        RETURN QUERY SELECT m.comes_from, m.link_id, 1::float8
            FROM link m JOIN streetgen._movement_rights(model, ARRAY(SELECT l.lane_id FROM lane l)) r
                USING (lane_in, lane_out, along_in, along_out)
            WHERE m.traffic IS NULL AND r.turn <> 'u_turn' ORDER BY 1, 2;
    ELSIF demand ->> 'turns' <> 'straight' THEN
        RAISE EXCEPTION 'turns is "%", expected even or straight', demand ->> 'turns' USING ERRCODE = '22023',
            HINT = 'A list of objects with link, next and share says how cars turn.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._demand_turns(name, jsonb) IS
    'How those on a link go on by a demand, in shares: as turns says, evenly over the movements of a lane, or straight '
    'on.';

CREATE OR REPLACE FUNCTION streetgen._following_law(method text) RETURNS oid
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    law constant regprocedure := streetgen._function_named(method, 'streetgen.following[]', 'float8[]', false);
BEGIN
    IF method IN ('idm', 'lwr', 'arz') THEN
        RETURN 0;
    ELSIF law IS NULL THEN
        RAISE EXCEPTION 'method is "%", expected idm or lwr or arz, or a function of streetgen.following[] that gives '
            'float8[]', method USING ERRCODE = '22023',
            HINT = 'Name a function of yours with its schema, such as public.my_law.';
    ELSIF NOT has_function_privilege(law, 'EXECUTE') THEN
        RAISE EXCEPTION 'role "%" may not run method %', current_user, law USING ERRCODE = '42501',
            HINT = format('GRANT EXECUTE ON FUNCTION %s TO %I by its owner allows it.', law, current_user);
    END IF;
    RETURN law;
END $$;
COMMENT ON FUNCTION streetgen._following_law(text) IS
    'The function of SQL that a method names, or 0 for the methods that there are. No such function: 22023; one that '
    'the role may not run: 42501.';

CREATE OR REPLACE FUNCTION streetgen._demand_arrays(model name, demand jsonb, OUT entries bigint[],
    OUT flows float8[], OUT turn_links bigint[], OUT turn_next bigint[], OUT turn_shares float8[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT coalesce(array_agg(e.link), '{}'), coalesce(array_agg(e.flow), '{}') INTO entries, flows
        FROM streetgen._demand_entries(model, demand) e;
    SELECT coalesce(array_agg(u.link), '{}'), coalesce(array_agg(u.next), '{}'), coalesce(array_agg(u.share), '{}')
        INTO turn_links, turn_next, turn_shares FROM streetgen._demand_turns(model, demand) u;
END $$;
COMMENT ON FUNCTION streetgen._demand_arrays(name, jsonb) IS 'Where cars enter, and how they turn, as arrays.';

CREATE OR REPLACE FUNCTION streetgen._simulate_demand(model name, method text, duration float8, step float8,
    demand jsonb, seed bigint, options jsonb)
    RETURNS TABLE(t float8, car_id bigint, cell_id bigint, link_id bigint, metres float8, speed float8,
        density float8, geom geometry, heading float8, length float8, width float8, kind text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    own_srid integer;
    law oid;
    demanded record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('method', method, 'duration', duration::text,
        'step', step::text, 'demand', demand::text, 'seed', seed::text, 'options', options::text),
        streetgen._require_subject(model, 'interconnection'),
        streetgen._known_keys(demand, 'demand', '{flow,entries,turns}'),
        streetgen._known_keys(options, 'options', '{output}');
    law := streetgen._following_law(method);
    own_srid := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    demanded := streetgen._demand_arrays(model, demand);
    RETURN QUERY SELECT s.t, s.car_id, s.cell_id, s.link, s.metres, s.speed, s.density, CASE
            WHEN s.car_id IS NULL AND k.length IS NULL THEN k.geom
            WHEN s.car_id IS NULL THEN ST_LineSubstring(k.geom, greatest(0, (s.metres - s.length / 2) / k.length),
                least(1, (s.metres + s.length / 2) / k.length))
            WHEN s.height IS NULL THEN ST_SetSRID(ST_MakePoint(s.x, s.y), own_srid)
            ELSE ST_SetSRID(ST_MakePoint(s.x, s.y, s.height), own_srid) END,
            degrees(s.heading), s.length, s.width, s.kind
        FROM streetgen._simulate(streetgen._network_of_links(model), streetgen._cars_on_links(model),
            demanded.entries, demanded.flows, demanded.turn_links, demanded.turn_next, demanded.turn_shares,
            CASE law WHEN 0 THEN method ELSE 'idm' END, duration, step, coalesce((options ->> 'output')::float8, 1),
            seed, law, CASE WHEN method IN ('lwr', 'arz') THEN '{}' ELSE streetgen._events_on_links(model) END) s
            LEFT JOIN (SELECT l.link_id, l.geom, nullif(l.length, 0) AS length FROM link l
                WHERE method IN ('lwr', 'arz')) k ON k.link_id = s.link;
END $$;
COMMENT ON FUNCTION streetgen._simulate_demand(name, text, float8, float8, jsonb, bigint, jsonb) IS
    'What streetgen.simulate gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.simulate(model name, method text DEFAULT 'idm', duration float8 DEFAULT 600,
    step float8 DEFAULT 0.1, demand jsonb DEFAULT '{}', seed bigint DEFAULT 1, options jsonb DEFAULT '{}')
    RETURNS TABLE(t float8, car_id bigint, cell_id bigint, link bigint, metres float8, speed float8, density float8,
        geom geometry)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog
    AS $$ SELECT s.t, s.car_id, s.cell_id, s.link_id, s.metres, s.speed, s.density, s.geom
        FROM streetgen._simulate_demand($1, $2, $3, $4, $5, $6, $7) s $$;
COMMENT ON FUNCTION streetgen.simulate(name, text, float8, float8, jsonb, bigint, jsonb) IS
    'Traffic on the streets of a model. method idm: cars that follow each other, obey signals and rights of way and '
    'change lanes; lwr or arz: a flow through cells of some 10 m; a function of yours, named with its schema, of '
    'streetgen.following[]: as idm, but each car accelerates as it says, float8[] in m/s2, a number for each row. '
    'duration and step: seconds; a step of cars is at '
    'most 1 s, one of a flow as the error says. The cars of table car stand on the streets at the start. Each event of '
    'table traffic_event fires once (fired_events says when). demand: flow '
    '(cars an hour on each lane that begins where no movement leads; without it as axis.flow says), or entries (a list '
    'of link and flow); turns (even, straight, or a list of link, next and share: '
    'those of a link share its cars among them, as one to the other). options: output (seconds between '
    'the states that are given, 1). Rows: at t, seconds, each car with its front on a link, metres along it, geom a '
    'POINT; or each cell by its middle, density in cars a kilometre, geom a LINESTRING. speed: km/h. The same seed '
    'gives the same rows. Nothing is locked. NaN, a duration or step out of range, an unknown word, a function '
    'that gives no finite number for each row: 22023; what a function raises, with its name; NULL: '
    '22004; a model without subject interconnection: 55000; an unknown model: 3F000; not a reader: 42501. Wilkie, '
    'Sewall and Lin, section 3; Treiber, Hennecke and Helbing 2000; Aw and Rascle 2000.';

CREATE OR REPLACE FUNCTION streetgen.keep_simulation(model name, run text, method text DEFAULT 'idm',
    duration float8 DEFAULT 600, step float8 DEFAULT 0.1, demand jsonb DEFAULT '{}', seed bigint DEFAULT 1,
    options jsonb DEFAULT '{}') RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    kept bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('run', run), streetgen._require_traffic(model);
    -- One run of a name comes after the other.
    LOCK TABLE simulated IN SHARE ROW EXCLUSIVE MODE;
    DELETE FROM simulated s WHERE s.run = keep_simulation.run;
    INSERT INTO simulated (run, t, car_id, link_id, metres, speed, density, geom, heading, length, width, kind)
        SELECT keep_simulation.run, s.t, s.car_id, s.link_id, s.metres, s.speed, s.density,
            ST_Force3D(s.geom), s.heading, s.length, s.width, s.kind
        FROM streetgen._simulate_demand(model, method, duration, step, demand, seed, options) s;
    GET DIAGNOSTICS kept = ROW_COUNT;
    RETURN kept;
END $$;
COMMENT ON FUNCTION streetgen.keep_simulation(name, text, text, float8, float8, jsonb, bigint, jsonb) IS
    'Writes the rows of streetgen.simulate into table simulated, and gives how many these are. run: its name; an '
    'older run of that name goes. streetgen.svg, streetgen.animated_svg and a GIS draw them by their time. '
    'A model without traffic: 55000; not the owner of the '
    'model: 42501; else as simulate.';
