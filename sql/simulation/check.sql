-- Rules of check_model for cars and events.

CREATE OR REPLACE FUNCTION streetgen._check_simulation(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
    links bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN SELECT 'warning', 'car without its axis', 'car', c.car_id, 0, NULL::geometry
        FROM car c LEFT JOIN axis a USING (axis_id) WHERE a.axis_id IS NULL
    LOOP
        RETURN NEXT finding;
    END LOOP;
    IF 'interconnection' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    links := streetgen._links_there(model, ARRAY(SELECT DISTINCT r FROM car c CROSS JOIN LATERAL unnest(c.route) r));
    FOR finding IN SELECT 'warning', 'car without its lane', 'car', c.car_id, 0, ST_LineInterpolatePoint(
            ST_Force2D(a.geom), least(1, c.abscissa / nullif(ST_Length2D(a.geom), 0)))
        FROM car c JOIN axis a USING (axis_id) LEFT JOIN car_place p USING (car_id) WHERE p.car_id IS NULL
    UNION ALL SELECT 'warning', 'car whose route has links that are gone', 'car', c.car_id, count(*), p.geom
        FROM car c CROSS JOIN LATERAL unnest(c.route) r(link) LEFT JOIN car_place p USING (car_id)
        WHERE r.link NOT IN (SELECT unnest(links)) GROUP BY c.car_id, p.geom
    UNION ALL SELECT 'warning', 'car that is not on its route', 'car', c.car_id, 0, p.geom
        FROM car c JOIN car_place p USING (car_id) WHERE p.link_id <> ALL (c.route) AND c.route <> '{}'
            AND NOT EXISTS (SELECT FROM unnest(c.route) r WHERE r NOT IN (SELECT unnest(links)))
    UNION ALL SELECT 'warning', 'event without its lane', 'traffic_event', v.traffic_event_id, 0, NULL
        FROM traffic_event v LEFT JOIN event_place p USING (traffic_event_id) WHERE p.traffic_event_id IS NULL
    UNION ALL SELECT 'warning', 'event without its car', 'traffic_event', v.traffic_event_id, v.car_id, p.geom
        FROM traffic_event v LEFT JOIN event_place p USING (traffic_event_id) LEFT JOIN car c USING (car_id)
        WHERE v.car_id IS NOT NULL AND c.car_id IS NULL
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_simulation(name) IS 'What check_model finds of cars, and of events.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('car without its axis', 'the axis is gone', 'delete the car, or drag it to a lane in car_editing'),
    ('car without its lane', 'the street has no such lane there any more: the car is left out of traffic',
        'drag the car to a lane in car_editing, or delete it'),
    ('car whose route has links that are gone', 'streets along its route are others since: traffic refuses it',
        'ask `route` for another way, or set its route to NULL'),
    ('car that is not on its route',
        'it was dragged or moved to a link that its route does not have: it goes straight on',
        'ask `route` for a way from there, set its route to NULL, or drag the car back'),
    ('event without its lane', 'the street has no such lane there: it never happens',
        'move it to a lane that is there, or delete it'),
    ('event without its car', 'table car has no such car: it never happens; measure is the key',
        'set its car_id to NULL for whichever car comes first, or delete it');
