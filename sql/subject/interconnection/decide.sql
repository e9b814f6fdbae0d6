-- Edits of interconnections in the view of what is decided by hand.

CREATE OR REPLACE FUNCTION streetgen._edit_interconnection() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(TG_TABLE_SCHEMA);
    subject text;
    place record;
    known bigint[];
    decided boolean;
    dragged geometry;
    emptied boolean;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'There is a row for every two lanes that meet: set its connecting.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{connecting,by_hand,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := 'interconnection ' || OLD.interconnection_id;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %1$I.interconnection JOIN %1$I.lane ON lane_id IN (lane_in, lane_out) JOIN '
        '%1$I.edge USING (edge_id) WHERE interconnection_id = %2$s',
        TG_TABLE_SCHEMA, OLD.interconnection_id));
    SELECT ST_Force2D(n.geom) AS node, a.axis_id AS axis_in, i.ordinality AS lane_in, b.axis_id AS axis_out,
        o.ordinality AS lane_out,
        CASE WHEN i.both_ways THEN c.along_in END AS along_in, CASE WHEN o.both_ways THEN c.along_out END AS along_out
    FROM interconnection c JOIN node n USING (node_id) JOIN lane i ON i.lane_id = c.lane_in
        JOIN edge a ON a.edge_id = i.edge_id JOIN lane o ON o.lane_id = c.lane_out
        JOIN edge b ON b.edge_id = o.edge_id
    WHERE interconnection_id = OLD.interconnection_id AND EXISTS (SELECT FROM axis x WHERE x.axis_id = a.axis_id)
        AND EXISTS (SELECT FROM axis x WHERE x.axis_id = b.axis_id) INTO place;
    IF place.node IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject),
            detail => 'Its lanes do not meet there any more.', hint => 'Refresh the layer.');
    END IF;
    SELECT coalesce(array_agg(interconnection_override_id
        ORDER BY interconnection_override_id DESC), '{}') FROM interconnection_override
        WHERE (axis_in, lane_in, axis_out, lane_out) = (place.axis_in, place.lane_in, place.axis_out, place.lane_out)
            AND (along_in = place.along_in) IS NOT FALSE
            AND (along_out = place.along_out) IS NOT FALSE
            AND ST_DWithin(geom, place.node, 3 * tolerance) INTO known;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        DELETE FROM interconnection_override WHERE interconnection_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    IF NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        IF ST_NPoints(NEW.geom) <> 3 OR ST_Distance(ST_StartPoint(NEW.geom), ST_StartPoint(OLD.geom)) > 1e-6
            OR ST_Distance(ST_EndPoint(NEW.geom), ST_EndPoint(OLD.geom)) > 1e-6 THEN
            PERFORM streetgen._refuse('22023', format('of %s only the middle point can be dragged', subject),
                detail => 'Its ends lie on its lanes, and it has three points.',
                hint => 'Undo, and drag the middle point.');
        ELSIF ST_Distance(ST_PointN(NEW.geom, 2), place.node) > 200 THEN
            PERFORM streetgen._refuse('22023',
                format('the middle point of %s cannot lie %s m from its node', subject,
                    round(ST_Distance(ST_PointN(NEW.geom, 2), place.node))),
                detail => 'The widest street is 200 m wide.', hint => 'Undo, and drag it less far.');
        END IF;
    END IF;
    decided := NEW.connecting IS DISTINCT FROM OLD.connecting;
    dragged := CASE WHEN NEW.geom IS DISTINCT FROM OLD.geom THEN ST_PointN(NEW.geom, 2) END;
    IF NOT decided AND dragged IS NULL THEN
        PERFORM streetgen._refuse('22023', format('nothing is decided by hand of %s', subject),
            hint => 'Change connecting or geom, and by_hand follows.');
    ELSIF known = '{}' THEN
        INSERT INTO interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, along_in, along_out,
            connecting, control) SELECT place.node, place.axis_in, place.lane_in, place.axis_out, place.lane_out,
            place.along_in, place.along_out, CASE WHEN decided THEN NEW.connecting END, dragged
            WHERE NEW.connecting IS NOT NULL OR dragged IS NOT NULL;
        emptied := NOT FOUND;
    ELSE
        UPDATE interconnection_override SET connecting = CASE WHEN decided THEN NEW.connecting ELSE connecting END,
            control = coalesce(dragged, control) WHERE interconnection_override_id = known[1]
            RETURNING num_nonnulls(connecting, control) = 0 INTO emptied;
        DELETE FROM interconnection_override WHERE emptied AND interconnection_override_id = ANY (known);
    END IF;
    NEW.by_hand := NOT emptied;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_interconnection() IS
    'Trigger of interconnection_editing: writes interconnection_override. A line whose ends moved, that has not three '
    'points, or whose middle one lies over 200 m from its node: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('interconnection_editing',
        'Edit layer: say whether a lane goes on to another, or drag the middle point of its path; DELETE takes back '
        'what was decided by hand',
        ARRAY['key', 'the node', 'the lane that comes in', 'the lane that goes out', 'through, left, right or u_turn',
            'does it connect; NULL takes it back', 'would traffic take it', 'decided by hand; false takes it back',
            'start, control point and end of the path'],
        $sql$SELECT c.interconnection_id, c.node_id, c.lane_in, c.lane_out, c.turn, c.connecting, c.plausible,
            c.method = 'by_hand' AS by_hand,
            ST_MakeLine(ARRAY[ST_StartPoint(c.geom), coalesce(c.control, ST_LineInterpolatePoint(c.geom, 0.5)),
                ST_EndPoint(c.geom)])::geometry(LineString, {srid}) AS geom
        FROM {model}.interconnection c$sql$, 'interconnection') $$;
COMMENT ON FUNCTION streetgen._interconnection_edit_view() IS 'The views in which interconnections are edited.';

CREATE OR REPLACE FUNCTION streetgen._ordinality_at(ordinality integer, axis bigint, place geometry, turned boolean)
    RETURNS integer
    LANGUAGE sql STABLE PARALLEL UNSAFE
    RETURN CASE WHEN turned THEN streetgen._mirrored_ordinality(ordinality,
        coalesce(streetgen._lost_lanes(current_schema(), axis, place),
            streetgen._lanes_by(current_schema(), axis, place))) ELSE ordinality END;
COMMENT ON FUNCTION streetgen._ordinality_at(integer, bigint, geometry, boolean) IS
    'Ordinality of a lane beside a node of an axis of the model in use, where the axis may be turned round.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('interconnection_override'::name, 'node', '{axis_in,axis_out}'::name[], '3 * {tolerance}', jsonb_build_object(
        'geom', 'coalesce(n.new_place, o.geom)',
        'control', 'ST_Translate(o.control, n.east, n.north)',
        'lane_in', 'streetgen._ordinality_at(o.lane_in, o.axis_in, o.geom, n.first_turned)',
        'lane_out', 'streetgen._ordinality_at(o.lane_out, o.axis_out, o.geom, n.second_turned)',
        'along_in', 'o.along_in <> n.first_turned',
        'along_out', 'o.along_out <> n.second_turned'), false, NULL::integer, NULL::text),
    ('turn_restriction', 'route', '{from_axis,to_axis}', '3 * {tolerance}', '{}', false, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._interconnection_decision() IS
    'The anchors of decisions about interconnections, and which of their columns follow the axes.';
