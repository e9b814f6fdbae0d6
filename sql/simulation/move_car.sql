-- A car changes lanes.

CREATE OR REPLACE FUNCTION streetgen.move_car(model name, car_id bigint, side text) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
#variable_conflict use_column
DECLARE
    least_gap constant float8 := 2;
    place record;
    beside record;
    lanes bigint[];
    near record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('car_id', car_id::text, 'side', side),
        streetgen._require_traffic(model), streetgen._require_subject(model, 'interconnection');
    IF side NOT IN ('left', 'right') THEN
        RAISE EXCEPTION 'side is "%", expected left or right', side USING ERRCODE = '22023',
            HINT = 'Sides are those of who drives.';
    END IF;
    -- Two cars do not take one gap.
    LOCK TABLE car IN SHARE ROW EXCLUSIVE MODE;
    SELECT c.*, p.link_id INTO place FROM car c LEFT JOIN car_place p USING (car_id)
        WHERE c.car_id = move_car.car_id;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no car %', car_id USING ERRCODE = '22023',
            HINT = format('SELECT car_id FROM %I.car lists them.', model);
    ELSIF place.link_id IS NULL OR place.onto_axis IS NOT NULL THEN
        RAISE EXCEPTION 'car % stands on no lane', car_id USING ERRCODE = '22023',
            HINT = 'Between lanes nobody changes. View car_place says where each car is.';
    END IF;
    SELECT b.lane_id, b.lane_position, a.change INTO beside FROM lane_adjacency a JOIN lane b ON b.lane_id = a.lane_b
        WHERE a.lane_a = place.link_id >> 2 AND (a.side = 'left') = ((move_car.side = 'left') = place.along_axis)
            AND place.abscissa BETWEEN a.start_abscissa - 1e-6 AND a.end_abscissa + 1e-6 LIMIT 1;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'no lane lies on the % of car %', side, car_id USING ERRCODE = '22023',
            HINT = 'View lane_adjacency lists lanes beside each other, and from where to where.';
    ELSIF beside.change <> 'allowed' THEN
        RAISE EXCEPTION 'car % may not change to the lane on its %', car_id, side USING ERRCODE = '22023',
            DETAIL = CASE beside.change WHEN 'opposite' THEN 'Its traffic comes towards.'
                ELSE 'The line between the lanes is solid, or the lane is for others.' END,
            HINT = 'View lane_adjacency says where one may change.';
    END IF;
    UPDATE car c SET lane_position = beside.lane_position WHERE c.car_id = move_car.car_id;
    lanes := streetgen._lanes_about_path(model, ARRAY[4 * beside.lane_id + place.along_axis::integer],
        (SELECT max(o.length) FROM car o), (SELECT max(o.length) FROM car o));
    SELECT CASE WHEN l.car_id = move_car.car_id THEN l.leader ELSE l.car_id END AS other, l.gap INTO near
        FROM streetgen._leaders(streetgen._network_of_lanes(model, lanes), streetgen._cars_on_lanes(model, lanes), 0,
            200, 'none', 'moving') l
        WHERE move_car.car_id IN (l.car_id, l.leader) AND l.leader IS NOT NULL AND l.gap < least_gap
        ORDER BY l.gap LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'car % has no gap on its %', car_id, side USING ERRCODE = '22023',
            DETAIL = format('Car %s would be %s m away.', near.other, round(near.gap::numeric, 2)),
            HINT = format('It needs %s m before and behind it.', least_gap);
    END IF;
    RETURN 4 * beside.lane_id + place.along_axis::integer;
END $$;
COMMENT ON FUNCTION streetgen.move_car(name, bigint, text) IS
    'Moves a car of table car to the lane beside it, at its place along the axis, and gives the link that it is on '
    'then. side: left or right of who drives. No lane there, a change that view lane_adjacency does not allow, another '
    'car less than 2 m before or behind: 22023. So are an unknown car, one between lanes, and another side; NULL: '
    '22004; a model without traffic or subject interconnection: 55000; an unknown model: 3F000; who may not write the '
    'cars of the model: 42501. Wilkie, Sewall and Lin, section 3.1.';
