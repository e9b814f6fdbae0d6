-- Edits of lanes and of how traffic goes on: lane_editing, lane_adjacency_editing, interconnection_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_lane() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    edge record;
    known bigint[];
    middle float8;
    astray float8;
    merging boolean;
    turned boolean;
    widened boolean;
    redrawn boolean;
    emptied boolean;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Lanes come from the lane_count of their axis: change it in axis_editing.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{along_axis,both_ways,width,by_hand,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    SELECT EXISTS (SELECT FROM lane WHERE lane_id = OLD.lane_id AND kind = 'merging') INTO merging;
    IF merging THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP || ' of a merging lane',
            'It follows from its ramp: type its length in ramp_editing.');
    END IF;
    subject := format('lane %s (%s of edge %s)', OLD.lane_id, OLD.ordinality, OLD.edge_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge WHERE edge_id = %s',
        TG_TABLE_SCHEMA, OLD.edge_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    SELECT coalesce(array_agg(lane_override_id ORDER BY lane_override_id DESC), '{}') FROM lane_override
        WHERE axis_id = edge.axis_id AND ordinality = OLD.ordinality AND abscissa >= edge.start_abscissa
        AND abscissa < edge.end_abscissa INTO known;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        DELETE FROM lane_override WHERE lane_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    PERFORM streetgen._check_edit_number('the width of ' || subject, NEW.width, 0.1, greatest(edge.width,
        edge.width_end), 'm, the width of its roadway', 'Leave it empty to have it computed, or widen the axis.')
        WHERE NEW.width IS DISTINCT FROM OLD.width;
    IF NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_line(subject, NEW.geom, 0);
        astray := (SELECT max(ST_Distance(v.geom, edge.geom)) FROM ST_DumpPoints(NEW.geom) v);
        IF astray > 200 THEN
            PERFORM streetgen._refuse('22023', format('%s cannot lie %s m from its edge', subject, round(astray)),
                detail => 'The widest street is 200 m wide.', hint => 'Undo, and draw it beside its edge.');
        END IF;
        IF streetgen._remap_runs_against(streetgen._heading(edge.geom, ST_StartPoint(NEW.geom)), NEW.geom,
            ST_StartPoint(NEW.geom)) THEN
            NEW.geom := ST_Reverse(NEW.geom);
        END IF;
    END IF;
    -- Values that are not edited stay computed, or as they were decided before.
    turned := (NEW.along_axis, NEW.both_ways) IS DISTINCT FROM (OLD.along_axis, OLD.both_ways);
    -- What is emptied and was not decided takes nothing else back: the direction of a lane that both use, and that one
    -- does so on an edge where none is computed to.
    IF NEW.along_axis IS NULL AND NEW.both_ways AND OLD.both_ways
        OR NEW.both_ways IS NULL AND NOT OLD.both_ways AND NEW.along_axis = OLD.along_axis AND edge.lanes_both = 0 THEN
        NEW.along_axis := OLD.along_axis;
        NEW.both_ways := OLD.both_ways;
        turned := false;
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    ELSIF turned AND (NEW.along_axis IS NULL AND NEW.both_ways IS NOT TRUE
            AND NOT (NEW.both_ways IS FALSE AND OLD.both_ways AND edge.lanes_both > 0)
        OR NEW.both_ways IS NULL AND NEW.along_axis = OLD.along_axis) THEN
        NEW.along_axis := NULL;
        NEW.both_ways := NULL;
    ELSIF turned THEN
        -- A direction typed for a lane that both use is the only one from then on.
        NEW.both_ways := coalesce(NEW.both_ways, false) AND (coalesce(NEW.along_axis, true) OR NOT OLD.both_ways);
        NEW.along_axis := coalesce(NEW.along_axis, true) OR NEW.both_ways;
    END IF;
    widened := NEW.width IS DISTINCT FROM OLD.width;
    redrawn := NEW.geom IS DISTINCT FROM OLD.geom;
    IF NOT (turned OR widened OR redrawn) AND NEW.by_hand THEN
        PERFORM streetgen._refuse('22023', format('nothing is decided by hand of %s', subject),
            hint => 'Change along_axis, both_ways, width or geom, and by_hand follows.');
    END IF;
    IF known = '{}' THEN
        middle := (edge.start_abscissa + edge.end_abscissa) / 2;
        INSERT INTO lane_override (axis_id, abscissa, ordinality, along_axis, both_ways, width, line, geom)
            SELECT edge.axis_id, middle, OLD.ordinality, d.*,
                ST_LineInterpolatePoint(edge.axis, least(middle / ST_Length2D(edge.axis), 1))
            FROM (VALUES (CASE WHEN turned THEN NEW.along_axis END, CASE WHEN turned THEN NEW.both_ways END,
                CASE WHEN widened THEN NEW.width END, CASE WHEN redrawn THEN NEW.geom END))
                d(along, both_ways, width, line)
            WHERE num_nonnulls(d.along, d.both_ways, d.width, d.line) > 0;
        emptied := NOT FOUND;
    ELSE
        UPDATE lane_override SET along_axis = CASE WHEN turned THEN NEW.along_axis ELSE along_axis END, both_ways = CASE
            WHEN turned THEN NEW.both_ways ELSE both_ways END,
            width = CASE WHEN widened THEN NEW.width ELSE width END, line = CASE WHEN redrawn THEN NEW.geom ELSE line
                END
            WHERE lane_override_id = known[1] RETURNING num_nonnulls(along_axis, both_ways, width, line) = 0
            INTO emptied;
        DELETE FROM lane_override WHERE emptied AND lane_override_id = ANY (known);
    END IF;
    NEW.by_hand := NOT emptied;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_lane() IS
    'Trigger of lane_editing: writes lane_override, a line drawn against the axis turned round. NULL in along_axis or '
    'both_ways takes back what was decided of that one alone, as far as the other is decided by itself. '
    'A width below 0.1 m or '
    'beyond that of the roadway, a line that collapses or leaves the edge by more than 200 m: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._edit_lane_adjacency() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    known bigint[];
    decided text;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'There is a row for every two lanes side by side: set its change.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{change,by_hand}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
        decided := CASE WHEN NOT OLD.by_hand OR NEW.by_hand THEN NEW.change END;
        IF decided = 'opposite' OR decided IS NOT NULL AND OLD.change = 'opposite' THEN
            PERFORM streetgen._refuse('22023',
                format('the change of lane adjacency %s (lane %s to lane %s) cannot be "%s"', OLD.lane_adjacency_id,
                    OLD.lane_a, OLD.lane_b, decided),
                detail => format('It is "%s"; "opposite" says that traffic comes against one.', OLD.change),
                hint => 'Turn a lane round in lane_editing; lanes of one direction take allowed or forbidden.');
        END IF;
        PERFORM streetgen._check_edit_word(format('lane adjacency %s (lane %s to lane %s)', OLD.lane_adjacency_id,
            OLD.lane_a, OLD.lane_b), decided, format('%I.lane_adjacency_override', TG_TABLE_SCHEMA), 'change');
        NEW.by_hand := decided IS NOT NULL;
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %1$I.lane JOIN %1$I.edge USING (edge_id) '
        'WHERE lane_id = %2$s', TG_TABLE_SCHEMA, OLD.lane_a));
    SELECT e.axis_id, e.start_abscissa, e.end_abscissa, a.ordinality AS lane_from, b.ordinality AS lane_to
        FROM lane a JOIN lane b USING (edge_id) JOIN edge e USING (edge_id) JOIN axis x USING (axis_id)
        WHERE a.lane_id = OLD.lane_a AND b.lane_id = OLD.lane_b INTO place;
    IF place.axis_id IS NULL THEN
        PERFORM streetgen._refuse('22023',
            format('lanes %s and %s no longer lie beside each other', OLD.lane_a, OLD.lane_b),
            detail => 'Somebody else changed their axis.', hint => 'Refresh the layer.');
    END IF;
    SELECT coalesce(array_agg(lane_adjacency_override_id
        ORDER BY lane_adjacency_override_id DESC), '{}') FROM lane_adjacency_override
        WHERE axis_id = place.axis_id AND abscissa >= place.start_abscissa AND abscissa < place.end_abscissa
            AND (lane_from, lane_to) = (place.lane_from, place.lane_to) INTO known;
    DELETE FROM lane_adjacency_override WHERE lane_adjacency_override_id = ANY (CASE WHEN decided IS NULL THEN known
        ELSE known[2:] END);
    IF decided IS NOT NULL AND known = '{}' THEN
        INSERT INTO lane_adjacency_override (axis_id, abscissa, lane_from, lane_to, change)
            VALUES (place.axis_id, (place.start_abscissa + place.end_abscissa) / 2, place.lane_from, place.lane_to,
            decided);
    ELSIF decided IS NOT NULL THEN
        UPDATE lane_adjacency_override SET change = decided WHERE lane_adjacency_override_id = known[1];
    END IF;
    RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
END $$;
COMMENT ON FUNCTION streetgen._edit_lane_adjacency() IS
    'Trigger of lane_adjacency_editing: writes lane_adjacency_override; change NULL, or DELETE, takes it back. '
    '"opposite", a change between lanes of opposite directions, lanes that are gone: 22023; another word: 23514; '
    'INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._lane_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('lane_editing', 'Edit layer: flip a lane, open it to both directions, redraw it, give it a width of its own; '
        'DELETE takes back what was decided by hand',
        ARRAY['key', 'the edge', 'number from the middle outwards',
            'does traffic run in the direction of the axis; NULL takes it back',
            'do both directions use it; NULL takes it back',
            'width, metres, that of the roadway at most; NULL takes it back',
            'decided by hand; false takes it back',
            'centre line, in the direction of the axis'],
        $sql$SELECT l.lane_id, l.edge_id, l.ordinality, l.along_axis, l.both_ways, l.width,
            EXISTS (SELECT FROM {model}.lane_override o WHERE (o.axis_id, o.ordinality) = (e.axis_id, l.ordinality)
                AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa) AS by_hand, l.geom
        FROM {model}.lane l JOIN {model}.edge e USING (edge_id)$sql$, 'lane'),
    ('lane_adjacency_editing', 'Edit layer: say whether traffic may change from a lane to the one beside it; DELETE '
        'takes back what was decided by hand',
        ARRAY['key', 'the lane that one leaves', 'the lane beside it', 'on which side of lane_a, left or right along '
            'the axis', 'allowed or forbidden; opposite where traffic comes against one; NULL takes it back',
            'decided by hand; false takes it back', 'the line between them'],
        $sql$SELECT lane_adjacency_id, lane_a, lane_b, side, change, by_hand, geom
        FROM {model}.lane_adjacency$sql$, 'lane') $$;
COMMENT ON FUNCTION streetgen._lane_edit_view() IS 'The views in which lanes are edited.';

CREATE OR REPLACE FUNCTION streetgen._lanes_at(model name, axis bigint, abscissa float8) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane l WHERE l.kind <> 'merging' AND edge_id = (SELECT e.edge_id FROM edge e
        WHERE axis_id = axis AND e.start_abscissa <= abscissa ORDER BY e.start_abscissa DESC LIMIT 1) INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_at(name, bigint, float8) IS
    'Number of lanes of an axis at an abscissa, or beyond it at its end, without merging lanes, as generated last; 0 '
    'where there are none.';

CREATE OR REPLACE FUNCTION streetgen._lanes_by(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane WHERE edge_id = streetgen._edge_at(model, axis, place) INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_by(name, bigint, geometry) IS
    'Number of lanes of an axis at its edge nearest to a place, as generated last.';

CREATE OR REPLACE FUNCTION streetgen._note_lost_lane(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE lost_place SET lanes = CASE WHEN abscissa IS NULL THEN streetgen._lanes_by(model, axis_id, geom)
        ELSE streetgen._lanes_at(model, axis_id, abscissa) END WHERE lanes IS NULL;
END $$;
COMMENT ON FUNCTION streetgen._note_lost_lane(name) IS
    'Notes how many lanes there are where decisions of a model just lost their axes.';

CREATE OR REPLACE FUNCTION streetgen._lost_lanes(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT lanes FROM lost_place WHERE axis_id = axis AND geom = ST_Force2D(place) LIMIT 1);
END $$;
COMMENT ON FUNCTION streetgen._lost_lanes(name, bigint, geometry) IS
    'Number of lanes where a decision lost its axis; NULL where none did.';

CREATE OR REPLACE FUNCTION streetgen._mirrored_ordinality(ordinality integer, lanes bigint) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN lanes = 0 OR (lanes % 2 = 1 AND ordinality = 1) THEN ordinality
        WHEN (ordinality + lanes) % 2 = 1 THEN ordinality + 1 ELSE ordinality - 1 END $$;
COMMENT ON FUNCTION streetgen._mirrored_ordinality(integer, bigint) IS
    'Ordinality, on an axis turned round, of the lane that had this one among so many lanes (0: unknown, as it was).';

CREATE OR REPLACE FUNCTION streetgen._ordinality_along(ordinality integer, axis bigint, abscissa float8, place geometry,
    turned boolean) RETURNS integer
    LANGUAGE sql STABLE PARALLEL UNSAFE
    RETURN CASE WHEN turned THEN streetgen._mirrored_ordinality(ordinality,
        coalesce(streetgen._lost_lanes(current_schema(), axis, place),
            streetgen._lanes_at(current_schema(), axis, abscissa))) ELSE ordinality END;
COMMENT ON FUNCTION streetgen._ordinality_along(integer, bigint, float8, geometry, boolean) IS
    'Ordinality of a lane at an abscissa of an axis of the model in use, where the axis may be turned round.';

CREATE OR REPLACE FUNCTION streetgen._lane_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('lane_override'::name, 'along', '{axis_id}'::name[], '{tolerance}', jsonb_build_object(
        'along_axis', 'o.along_axis <> (n.turned AND o.both_ways IS NOT TRUE)',
        'line', 'CASE WHEN n.turned THEN ST_Reverse(o.line) ELSE o.line END',
        'ordinality', 'streetgen._ordinality_along(o.ordinality, o.axis_id, o.abscissa, o.geom, n.turned)'), true, 4,
        'ROW(o.abscissa, o.ordinality, o.along_axis, o.both_ways, o.width, o.line::bytea)'),
    ('lane_adjacency_override', 'along', '{axis_id}', '{tolerance}', jsonb_build_object(
        'lane_from', 'streetgen._ordinality_along(o.lane_from, o.axis_id, o.abscissa, o.geom, n.turned)',
        'lane_to', 'streetgen._ordinality_along(o.lane_to, o.axis_id, o.abscissa, o.geom, n.turned)'), true, 11,
        'ROW(o.abscissa, o.lane_from, o.lane_to, o.change)') $$;
COMMENT ON FUNCTION streetgen._lane_decision() IS
    'The anchors of decisions about lanes, and which of their columns follow the axes.';
