-- What is ahead of cars.

CREATE OR REPLACE FUNCTION streetgen._leaders(network bytea, cars streetgen.traffic_car[], at float8, horizon float8,
    merging_leader text, virtual_car text)
    RETURNS TABLE(car_id bigint, leader bigint, virtual text, distance float8, gap float8, speed float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_leaders';
COMMENT ON FUNCTION streetgen._leaders(bytea, streetgen.traffic_car[], float8, float8, text, text) IS
    'What streetgen.leaders gives, of cars on a network. A car on no link or twice, a number out of range: 22023.';

CREATE OR REPLACE FUNCTION streetgen._free_path(network bytea, link bigint, metres float8, horizon float8)
    RETURNS TABLE(link_id bigint, starts float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_free_path';
COMMENT ON FUNCTION streetgen._free_path(bytea, bigint, float8, float8) IS
    'The links straight ahead of a place, and how far ahead each begins, metres. An unknown link, a place off it, a '
    'horizon below 0 or beyond 1,000 km: 22023.';

CREATE OR REPLACE FUNCTION streetgen._cars_on_links(model name) RETURNS streetgen.traffic_car[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    placed streetgen.traffic_car[];
    nowhere bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._has_traffic(model) THEN
        RETURN '{}';
    END IF;
    placed := ARRAY(SELECT (c.car_id, p.link_id, p.metres, c.speed, c.length, c.width, c.kind)::streetgen.traffic_car
        FROM car c JOIN car_place p USING (car_id) ORDER BY c.car_id);
    nowhere := (SELECT count(*) FROM car) - cardinality(placed);
    IF nowhere > 0 THEN
        RAISE WARNING '% cars of table car stand on no lane, and are left out', nowhere
            USING HINT = 'View car_place has those that do.';
    END IF;
    RETURN placed;
END $$;
COMMENT ON FUNCTION streetgen._cars_on_links(name) IS
    'The cars of a model that stand on a link, with a warning of those that stand on none; none of a model without '
    'traffic.';

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
    'The leader of each car of table car, a row each: who is next on its path, straight on, as signals stand at '
    'seconds at. distance: metres from front to front along the path. gap: from the rear of the leader to the front '
    'of the car. speed: km/h, below 0 where it comes towards. A virtual car stands where nobody is before it: '
    'stationary at the end of a lane and at red, moving at the speed limit at horizon metres (setting virtual_car). '
    'Setting merging_leader tells whether who comes from another path into the same lane counts. A car '
    'on no lane is warned of, and has no row. A model without traffic or subject interconnection: 55000; NaN, a '
    'horizon below 0 or beyond 1,000 km: 22023; NULL: 22004; an unknown model: 3F000; not a reader of the model: '
    '42501. Wilkie, Sewall and Lin, section 3.1.1.';

CREATE OR REPLACE FUNCTION streetgen._free_path_of(model name, link bigint, place float8, horizon float8)
    RETURNS TABLE(ordinality integer, link_id bigint, starts float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('link', link::text, 'metres', place::text,
        'horizon', horizon::text), streetgen._require_subject(model, 'interconnection');
    RETURN QUERY SELECT p.ordinality::integer, p.link_id, p.starts FROM streetgen._free_path(
        streetgen._network_of_links(model), link, place, horizon) WITH ORDINALITY p;
END $$;
COMMENT ON FUNCTION streetgen._free_path_of(name, bigint, float8, float8) IS 'What streetgen.free_path gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.free_path(model name, link bigint, metres float8 DEFAULT 0,
    horizon float8 DEFAULT 1000)
    RETURNS TABLE(ordinality integer, link_id bigint, starts float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._free_path_of($1, $2, $3, $4) $$;
COMMENT ON FUNCTION streetgen.free_path(name, bigint, float8, float8) IS
    'The links ahead of a place of a link, as far as horizon metres, straight on at each junction: by the movement '
    'that turns least, of equal ones by that of the smallest key. The first one is link; starts: how far ahead each '
    'begins, metres, below 0 of the first. An unknown link, a place off it, NaN, a horizon below 0 or beyond 1,000 km: '
    '22023; NULL: 22004; a model without subject interconnection: 55000; an unknown model: 3F000; not a reader of the '
    'model: 42501. Wilkie, Sewall and Lin, section 3.1.1.';

CREATE OR REPLACE FUNCTION streetgen.place_cars(model name, density float8, seed bigint DEFAULT 1) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    placed bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('density', density::text, 'seed', seed::text),
        streetgen._require_traffic(model), streetgen._require_subject(model, 'interconnection');
    IF NOT density BETWEEN 0 AND 140 THEN
        RAISE EXCEPTION 'density is %, expected 0 to 140 cars a kilometre', density USING ERRCODE = '22023',
            HINT = 'A standing car takes 7 m with the gap before it.';
    END IF;
    -- Who places cars comes after who does now.
    LOCK TABLE car IN SHARE ROW EXCLUSIVE MODE;
    DELETE FROM car;
    INSERT INTO car (axis_id, abscissa, lane_position, along_axis)
    SELECT e.axis_id, e.start_abscissa + streetgen._measure_at(m.on_lane, m.on_axis,
            CASE WHEN k.along_axis THEN p.metres ELSE k.length - p.metres END), l.lane_position, k.along_axis
    FROM link k JOIN lane l USING (lane_id) JOIN edge e USING (edge_id) JOIN lane_extent x USING (lane_id)
        -- A part of a car that is left over comes by a chance that the seed gives. Cars stand 7 m apart.
        CROSS JOIN LATERAL (SELECT least(floor(k.length / 7), floor(k.length * density / 1000
            + (hashint8extended(k.link_id, seed) & 1048575) / 1048576.0)) AS cars) n
        CROSS JOIN LATERAL generate_series(1, n.cars::integer) i
        CROSS JOIN LATERAL (SELECT k.length * (i - 0.5) / nullif(n.cars, 0) AS metres) p
        CROSS JOIN LATERAL streetgen._lane_measures(ST_Force2D(e.geom)::bytea, l.geom::bytea, x.widest,
            x.start_abscissa - e.start_abscissa, x.end_abscissa - e.start_abscissa) m
    WHERE k.kind = 'lane' AND k.traffic IS NULL AND NOT l.both_ways
    ORDER BY k.link_id, i;
    GET DIAGNOSTICS placed = ROW_COUNT;
    RETURN placed;
END $$;
COMMENT ON FUNCTION streetgen.place_cars(name, float8, bigint) IS
    'Places standing cars on the lanes of a model in place of those in table car, as many a kilometre of lane as '
    'density says, equally far from each other, and gives how many these are. A part of a car that is left over comes '
    'by a chance: the same seed places the same cars. Lanes for both directions, and those that not all may drive on, '
    'stay empty. A density that is not 0 to 140: 22023; NULL: 22004; a model without traffic or without subject '
    'interconnection: 55000; not the owner of the model: 42501; an unknown model: 3F000.';
