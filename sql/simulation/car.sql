-- Cars of users on the links of a model.

CREATE OR REPLACE FUNCTION streetgen._require_routes(model name, one bigint DEFAULT NULL) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    gone record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT c.car_id, r.link INTO gone FROM car c CROSS JOIN LATERAL unnest(c.route) r(link)
        WHERE (one IS NULL OR c.car_id = one) AND r.link NOT IN (SELECT unnest(streetgen._links_there(model,
            ARRAY(SELECT DISTINCT u FROM car o CROSS JOIN LATERAL unnest(o.route) u
                WHERE one IS NULL OR o.car_id = one)))) ORDER BY c.car_id LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'car %: there is no link % of its route', gone.car_id, gone.link USING ERRCODE = '22023',
            HINT = 'An edit may have taken it away. Function route finds a way anew.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_routes(name, bigint) IS
    'Raises 22023 for a car, or for one of that key, whose route names a link that is not there.';

CREATE OR REPLACE FUNCTION streetgen._cars_on_links(model name) RETURNS streetgen.traffic_car[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    placed streetgen.traffic_car[];
    nowhere bigint;
    astray bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._has_traffic(model) THEN
        RETURN '{}';
    END IF;
    PERFORM streetgen._require_routes(model);
    placed := ARRAY(SELECT (c.car_id, p.link_id, p.metres, c.speed, c.length, c.width, c.kind,
            c.route)::streetgen.traffic_car
        FROM car c JOIN car_place p USING (car_id) ORDER BY c.car_id);
    nowhere := (SELECT count(*) FROM car) - cardinality(placed);
    IF nowhere > 0 THEN
        RAISE WARNING '% cars of table car stand on no lane, and are left out', nowhere
            USING HINT = 'View car_place has those that do.';
    END IF;
    astray := (SELECT count(*) FROM unnest(placed) p WHERE p.link_id <> ALL (p.route) AND p.route <> '{}');
    IF astray > 0 THEN
        RAISE WARNING '% cars of table car stand on no link of their routes, and go straight on', astray
            USING HINT = 'Function check_model names them.';
    END IF;
    RETURN placed;
END $$;
COMMENT ON FUNCTION streetgen._cars_on_links(name) IS
    'The cars of a model that stand on a link; none of a model without traffic. Warnings count those that stand on '
    'none, and those that stand off their routes.';

CREATE OR REPLACE FUNCTION streetgen._cars_on_lanes(model name, lanes bigint[]) RETURNS streetgen.traffic_car[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT (c.car_id, p.link_id, p.metres, c.speed, c.length, c.width, c.kind,
            c.route)::streetgen.traffic_car
        FROM car c CROSS JOIN LATERAL (SELECT * FROM car_place o WHERE o.car_id = c.car_id OFFSET 0) p
        WHERE c.axis_id = ANY (ARRAY(SELECT e.axis_id FROM lane l JOIN edge e USING (edge_id)
                WHERE l.lane_id = ANY (lanes)))
            AND CASE WHEN p.link_id & 2 = 0 THEN p.link_id >> 2 = ANY (lanes)
                ELSE streetgen._lanes_of_links(model, ARRAY[p.link_id]) <@ lanes END
        ORDER BY c.car_id);
END $$;
COMMENT ON FUNCTION streetgen._cars_on_lanes(name, bigint[]) IS
    'The cars that stand on some lanes, or on movements between them.';

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
    'Places standing cars on the lanes of a model in place of those in table car, and gives how many these are. '
    'density: cars a kilometre of lane, equally far from each other. A part of a car that is left over comes '
    'by a chance: the same seed places the same cars. Lanes for both directions, and those that not all may drive on, '
    'stay empty. A density that is not 0 to 140: 22023; NULL: 22004; a model without traffic or without subject '
    'interconnection: 55000; not the owner of the model: 42501; an unknown model: 3F000.';
