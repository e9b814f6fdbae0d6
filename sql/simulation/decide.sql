-- Cars by hand: the view in which they are dragged.

CREATE OR REPLACE FUNCTION streetgen._lane_at(model name, point geometry)
    RETURNS TABLE(axis_id bigint, abscissa float8, lane_position integer, along_axis boolean, both_ways boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT e.axis_id, e.start_abscissa + streetgen._measure_at(m.on_lane, m.on_axis,
            ST_LineLocatePoint(l.geom, point) * ST_Length(l.geom)), l.lane_position, l.along_axis, l.both_ways
        FROM (SELECT * FROM lane n WHERE ST_DWithin(n.geom, point, 20)
                AND EXISTS (SELECT FROM link k WHERE k.kind = 'lane' AND k.lane_id = n.lane_id)
            ORDER BY ST_Distance(n.geom, point), n.lane_id LIMIT 1) l
            JOIN edge e USING (edge_id) JOIN lane_extent x ON x.lane_id = l.lane_id
            CROSS JOIN LATERAL streetgen._lane_measures(ST_Force2D(e.geom)::bytea, l.geom::bytea, x.widest,
                x.start_abscissa - e.start_abscissa, x.end_abscissa - e.start_abscissa) m;
END $$;
COMMENT ON FUNCTION streetgen._lane_at(name, geometry) IS
    'The lane nearest to a point, within 20 m, and its place along the axis; no row where none is.';

CREATE OR REPLACE FUNCTION streetgen._edit_car() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    nearest record;
    made bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        DELETE FROM car c WHERE c.car_id = OLD.car_id;
        RETURN OLD;
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{speed,length,width,kind,route,geom}',
            'A car moves with its point.');
        subject := format('car %s', OLD.car_id);
    ELSE
        subject := 'the new car';
    END IF;
    IF TG_OP = 'INSERT' OR NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        SELECT * INTO nearest FROM streetgen._lane_at(TG_TABLE_SCHEMA, ST_Force2D(NEW.geom));
        IF NOT FOUND THEN
            PERFORM streetgen._refuse('22023', format('%s has no lane within 20 m', subject),
                hint => 'Put the point on a lane.');
        END IF;
        NEW.axis_id := nearest.axis_id;
        NEW.abscissa := nearest.abscissa;
        NEW.lane_position := nearest.lane_position;
        -- On a lane for both directions it keeps its own.
        NEW.along_axis := CASE WHEN nearest.both_ways THEN coalesce(NEW.along_axis, true) ELSE nearest.along_axis END;
    END IF;
    IF TG_OP = 'INSERT' THEN
        INSERT INTO car (axis_id, abscissa, lane_position, along_axis, speed, length, width, kind, route)
            VALUES (NEW.axis_id, NEW.abscissa, NEW.lane_position, NEW.along_axis, coalesce(NEW.speed, 0),
                coalesce(NEW.length, 5), coalesce(NEW.width, 1.8), coalesce(NEW.kind, 'car'), NEW.route)
            RETURNING car.car_id INTO made;
        -- The column numbers itself, as an editor may not read its sequence.
        UPDATE car c SET car_id = NEW.car_id WHERE c.car_id = made AND NEW.car_id <> made;
        NEW.car_id := coalesce(NEW.car_id, made);
    ELSIF NEW.geom IS DISTINCT FROM OLD.geom THEN
        UPDATE car c SET (axis_id, abscissa, lane_position, along_axis, onto_axis, onto_position, onto_along, beyond,
                speed, length, width, kind, route) = (NEW.axis_id, NEW.abscissa, NEW.lane_position, NEW.along_axis,
                NULL, NULL, NULL, NULL, NEW.speed, NEW.length, NEW.width, NEW.kind, NEW.route)
            WHERE c.car_id = OLD.car_id;
    ELSE
        UPDATE car c SET (speed, length, width, kind, route) = (NEW.speed, NEW.length, NEW.width, NEW.kind, NEW.route)
            WHERE c.car_id = OLD.car_id;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_car() IS
    'Trigger of car_editing: writes table car. A point with no lane within 20 m: 22023; a change of what follows from '
    'the point: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._make_simulation_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF NOT streetgen._has_traffic(model) OR 'interconnection' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    PERFORM streetgen._make_edit_view(model, 'car_editing', streetgen._fill_template(streetgen._part('car_editing'),
            jsonb_build_object('model', quote_ident(model))),
        'Edit layer: drag a car to another place of a lane; a new point is a new car; DELETE removes one', ARRAY['key',
            'axis of its lane; follows the point', 'metres along the axis; follows the point',
            'number of the lane from the left kerb; follows the point',
            'does it drive in the direction of the axis? follows the point', 'km/h', 'metres', 'metres',
            'car, bus, carpool or cycle', 'the links that it follows; NULL: straight on',
            'POINT of its front; where its lane is gone the place on the axis'], 'streetgen._edit_car',
        'Turns an edit into a change of table car');
END $$;
COMMENT ON FUNCTION streetgen._make_simulation_edit_views(name) IS
    'Makes the view in which cars are edited, and its trigger, of a model with traffic, again and again.';

CREATE OR REPLACE FUNCTION streetgen._grant_simulation_views(model name) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._grant_views(model, '{car_editing}')
        WHERE to_regclass(format('%I.car_editing', model)) IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._grant_simulation_views(name) IS
    'Who may read or write the axes of a model may do so with its editing view of cars.';
