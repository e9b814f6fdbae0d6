-- Who is ahead of cars.

CREATE OR REPLACE FUNCTION streetgen._leaders(network bytea, cars streetgen.traffic_car[], at float8, horizon float8,
    merging_leader text, virtual_car text)
    RETURNS TABLE(car_id bigint, leader bigint, virtual text, distance float8, gap float8, speed float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_leaders';
COMMENT ON FUNCTION streetgen._leaders(bytea, streetgen.traffic_car[], float8, float8, text, text) IS
    'What streetgen.leaders gives, of cars on a network. A car on no link or twice, a number out of range: 22023.';

CREATE OR REPLACE FUNCTION streetgen.leaders(model name, at float8 DEFAULT 0, horizon float8 DEFAULT 1000)
    RETURNS TABLE(car_id bigint, leader bigint, virtual text, distance float8, gap float8, speed float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('at', at::text, 'horizon', horizon::text),
        streetgen._require_traffic(model), streetgen._require_subject(model, 'interconnection');
    RETURN QUERY SELECT l.* FROM streetgen._leaders(streetgen._network_of_links(model),
        streetgen._cars_on_links(model), at, horizon, streetgen._setting_text(model, 'merging_leader'),
        streetgen._setting_text(model, 'virtual_car')) l;
END $$;
COMMENT ON FUNCTION streetgen.leaders(name, float8, float8) IS
    'The leader of each car of table car, a row each: who is next on its path (as streetgen.free_path has it), as '
    'signals stand at seconds at. distance: metres from front to front along the path. gap: from the rear of the '
    'leader to the front of the car. speed: km/h, below 0 where it comes towards. A virtual car stands where nobody '
    'is before it: stationary at the end of a lane, at red, and before the place where a route goes on beside; '
    'moving at the speed limit at horizon metres (setting virtual_car). Setting merging_leader tells whether who '
    'comes from another path into the same lane counts. A car on no lane is warned of, and has no row. One that stands '
    'off its route is warned of, and goes straight on. A model '
    'without traffic or subject interconnection: 55000; a route with a gap, NaN, a horizon below 0 or beyond 1,000 '
    'km: 22023; NULL: 22004; an unknown model: 3F000; not a reader of the model: 42501. Wilkie, Sewall and Lin, '
    'section 3.1.1.';

CREATE OR REPLACE FUNCTION streetgen._lanes_about_path(model name, path bigint[], longest float8, merging float8)
    RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    lanes := streetgen._lanes_of_links(model, path);
    -- A car whose front has left the path may stand on it, and so on what it came by.
    lanes := ARRAY(WITH RECURSIVE onward AS (
        SELECT lane, 0::float8 AS way FROM unnest(lanes) lane
        UNION SELECT l.lane_id, o.way + m.length + ST_Length(l.geom)
        FROM onward o CROSS JOIN LATERAL (SELECT k.lane_out, k.length FROM link k
                WHERE k.kind = 'movement' AND k.lane_in = o.lane OFFSET 0) m
            JOIN lane l ON l.lane_id = m.lane_out
        WHERE o.way + m.length < longest)
        SELECT lane FROM onward);
    lanes := ARRAY(WITH RECURSIVE behind AS (
        SELECT lane, 0::float8 AS way FROM unnest(lanes) lane
        UNION SELECT l.lane_id, b.way + m.length + ST_Length(l.geom)
        FROM behind b CROSS JOIN LATERAL (SELECT k.lane_in, k.length FROM link k
                WHERE k.kind = 'movement' AND k.lane_out = b.lane OFFSET 0) m
            JOIN lane l ON l.lane_id = m.lane_in
        WHERE b.way <= merging)
        SELECT lane FROM behind);
    RETURN streetgen._lanes_near_turns(model, ARRAY(SELECT 4 * lane FROM unnest(lanes) lane));
END $$;
COMMENT ON FUNCTION streetgen._lanes_about_path(name, bigint[], float8, float8) IS
    'The lanes of a path of links and those about it from which a car may stand on it or come to it: longest metres '
    'on from it, and merging metres before these.';

CREATE OR REPLACE FUNCTION streetgen.get_leader(model name, car_id bigint, at float8 DEFAULT 0,
    horizon float8 DEFAULT 1000)
    RETURNS TABLE(leader bigint, virtual text, distance float8, gap float8, speed float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
#variable_conflict use_column
DECLARE
    merging text;
    place record;
    seen float8;
    lanes bigint[];
    found_leader record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('car_id', car_id::text, 'at', at::text, 'horizon',
        horizon::text), streetgen._require_traffic(model), streetgen._require_subject(model, 'interconnection');
    IF NOT horizon BETWEEN 0 AND 1000000 THEN
        RAISE EXCEPTION 'horizon is %, expected 0 to 1000000', horizon USING ERRCODE = '22023',
            HINT = 'It is how far ahead a car sees, metres.';
    END IF;
    SELECT p.link_id, p.metres, coalesce(c.route, '{}') AS route, (SELECT max(o.length) FROM car o) AS longest
        INTO place
        FROM car c LEFT JOIN car_place p USING (car_id) WHERE c.car_id = get_leader.car_id;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no car %', car_id USING ERRCODE = '22023',
            HINT = format('SELECT car_id FROM %I.car lists them.', model);
    ELSIF place.link_id IS NULL THEN
        RAISE WARNING 'car % stands on no lane', car_id USING HINT = 'View car_place has those that do.';
        RETURN;
    END IF;
    PERFORM streetgen._require_routes(model, car_id);
    IF place.link_id <> ALL (place.route) AND place.route <> '{}' THEN
        RAISE WARNING 'car % stands on no link of its route, and goes straight on', car_id
            USING HINT = 'Function route finds a way from there.';
    END IF;
    merging := streetgen._setting_text(model, 'merging_leader');
    -- Most have somebody near before them.
    seen := least(horizon, 100);
    LOOP
        -- Also the lane beside to which its route goes on.
        lanes := streetgen._lanes_about_path(model, ARRAY(SELECT p.link_id FROM streetgen._path_ahead(model,
                place.link_id, place.metres, seen, place.route) p)
                || streetgen._route_ahead(model, place.link_id, seen, place.route),
            place.longest, CASE merging WHEN 'none' THEN 0 ELSE 100 END);
        SELECT l.* INTO found_leader FROM streetgen._leaders(streetgen._network_of_lanes(model, lanes),
                streetgen._cars_on_lanes(model, lanes), at, seen, merging, CASE WHEN seen < horizon THEN 'moving'
                ELSE streetgen._setting_text(model, 'virtual_car') END) l WHERE l.car_id = get_leader.car_id;
        EXIT WHEN seen >= horizon OR found_leader.virtual IS DISTINCT FROM 'moving';
        seen := least(horizon, 4 * seen);
    END LOOP;
    RETURN QUERY SELECT found_leader.leader, found_leader.virtual, found_leader.distance, found_leader.gap,
        found_leader.speed;
END $$;
COMMENT ON FUNCTION streetgen.get_leader(name, bigint, float8, float8) IS
    'The leader of one car, as streetgen.leaders gives it, from the streets about its path alone. No row where the car '
    'stands on no lane. An unknown car: 22023; else as leaders.';

CREATE OR REPLACE FUNCTION streetgen.get_free_dist(model name, car_id bigint, at float8 DEFAULT 0,
    horizon float8 DEFAULT 1000) RETURNS float8
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT gap FROM streetgen.get_leader(model, car_id, at, horizon) $$;
COMMENT ON FUNCTION streetgen.get_free_dist(name, bigint, float8, float8) IS
    'Metres from the front of a car to the rear of its leader, at most the horizon; below 0 they overlap. NULL where '
    'the car stands on no lane. Else as streetgen.get_leader. Wilkie, Sewall and Lin, section 3.1.1.';
