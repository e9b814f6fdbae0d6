-- The place of an object by an axis, or by the border of its roadway.

CREATE OR REPLACE FUNCTION streetgen._side_of_street(side text, axis_offset float8, roadway_offset float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(side, CASE WHEN axis_offset > roadway_offset THEN 'left' ELSE 'right' END);
COMMENT ON FUNCTION streetgen._side_of_street(text, float8, float8) IS
    'The side of its street, left or right, on which an object stands: that of its border, else by its distance from '
    'the axis to the left and that of the middle of the roadway, metres.';

CREATE OR REPLACE FUNCTION streetgen._axis_borders(model name, axes bigint[])
    RETURNS TABLE(axis_id bigint, borders float8[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
        -- One plan for all axes would not reach some by their keys.
        SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH piece AS MATERIALIZED (
        SELECT e.axis_id, e.start_abscissa, e.end_abscissa, e.width, e.width_end, e.roadway_offset, s.borders
        FROM edge e LEFT JOIN section s USING (edge_id) WHERE axes IS NULL OR e.axis_id = ANY (axes))
    SELECT axis_id, array_agg(value ORDER BY start_abscissa, place)
    FROM piece, LATERAL (
        SELECT CASE mod(place, 3) WHEN 1 THEN start_abscissa + number ELSE number END AS value, place
        FROM unnest(coalesce(borders, streetgen._even_borders(width, width_end, end_abscissa - start_abscissa,
            roadway_offset))) WITH ORDINALITY b(number, place)) b
    WHERE axis_id IN (SELECT p.axis_id FROM piece p WHERE p.borders IS NOT NULL) GROUP BY axis_id;
END $$;
COMMENT ON FUNCTION streetgen._axis_borders(name, bigint[]) IS
    'Column borders of the sections of axes (NULL: of all), put together for each axis along which a roadway is '
    'anywhere not as wide as the axis says, in metres along the axis; the others are left out.';

CREATE OR REPLACE FUNCTION streetgen._make_street_function(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _street_of_objects(objects bigint[])
        RETURNS TABLE(axis_id bigint, level integer, line geometry, width float8, width_end float8, roadway_offset
            float8,
            borders float8[])
        LANGUAGE plpgsql STABLE ROWS 10 SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    DECLARE
        touched constant bigint[] := ARRAY(SELECT DISTINCT axis_id FROM street_object
            WHERE street_object_id = ANY (objects) AND method = 'relative' ORDER BY axis_id);
    BEGIN
        RETURN QUERY SELECT u.axis_id, u.level, ST_Force2D(u.geom), u.width, u.width_end, u.roadway_offset, b.borders
            FROM axis_used u LEFT JOIN streetgen._axis_borders(current_schema(), touched) b USING (axis_id)
            WHERE u.axis_id = ANY (touched);
    END $body$;
    CREATE OR REPLACE FUNCTION _edges_near(ground geometry[], metres float8) RETURNS SETOF streetgen.edge_near
        LANGUAGE plpgsql STABLE ROWS 20 SET search_path FROM CURRENT
        AS $body$
    DECLARE
        cornered constant boolean := EXISTS (SELECT FROM placement_rule WHERE active AND along = 'corner');
    BEGIN
        RETURN QUERY SELECT e.edge_id, e.axis_id, min(n.away) FROM (
                SELECT s.edge_id, ST_Distance(s.surface, g) AS away FROM unnest(ground) g, section s
                WHERE s.surface && ST_Expand(g, metres) AND ST_DWithin(s.surface, g, metres)
                -- Corners lie beyond sections, and where limits cross there is none.
                UNION ALL SELECT x.edge_id, ST_Distance(i.surface, g) FROM unnest(ground) g, intersection i,
                    LATERAL (SELECT edge_id FROM edge WHERE from_node = i.node_id
                        UNION ALL SELECT edge_id FROM edge WHERE to_node = i.node_id) x JOIN section s USING (edge_id)
                WHERE i.surface && ST_Expand(g, metres) AND ST_DWithin(i.surface, g, metres)
                    AND (ST_IsEmpty(s.surface) OR cornered)) n
            JOIN edge e ON e.edge_id = n.edge_id GROUP BY e.edge_id;
    END $body$;
    CREATE OR REPLACE FUNCTION _hold_borders(axes bigint[], wait boolean) RETURNS void
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        IF wait THEN
            PERFORM FROM section s JOIN edge e USING (edge_id) WHERE e.axis_id = ANY (axes) ORDER BY edge_id
                FOR SHARE OF s;
        ELSE
            PERFORM FROM section s JOIN edge e USING (edge_id) WHERE e.axis_id = ANY (axes) ORDER BY edge_id
                FOR SHARE OF s NOWAIT;
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_street_of_objects(bigint[])',
        'The axes by which objects stand, with their lines, widths and borders'),
        streetgen._own_function(model, '_edges_near(geometry[], float8)',
        'Edges whose roadway or corners lie so near ground, metres'),
        streetgen._own_function(model, '_hold_borders(bigint[], boolean)',
        'Keeps others from moving the borders of axes until the transaction ends; without wait 55P03 where one does');
END $$;
COMMENT ON FUNCTION streetgen._make_street_function(name) IS
    'Makes the functions of a model that tell and hold the streets of objects.';

CREATE OR REPLACE FUNCTION streetgen._stretch_beside(axis geometry, abscissa float8, abscissa_end float8,
    axis_offset float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE axis_offset WHEN 0 THEN stretch ELSE streetgen.offset_line(stretch, axis_offset, axis_offset) END
    FROM (SELECT ST_LineSubstring(axis, least(abscissa / length, 1), least(abscissa_end / length, 1)) AS stretch
        FROM ST_Length2D(axis) length) s $$;
COMMENT ON FUNCTION streetgen._stretch_beside(geometry, float8, float8, float8) IS
    'The line (LINESTRING) from one abscissa of an axis to another one, so many metres to the left of the axis.';

CREATE OR REPLACE FUNCTION streetgen._object_geometry(axis geometry, width float8, width_end float8,
    roadway_offset float8, borders float8[], abscissa float8, abscissa_end float8, side text, axis_offset float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        SELECT CASE WHEN abscissa_end IS NULL THEN streetgen._place_on(axis::bytea, abscissa,
                streetgen._border_offset(streetgen._to_border(width, width_end, ST_Length2D(axis), roadway_offset,
                    borders, abscissa, side), axis_offset, side))::geometry
            WHEN side IS NULL THEN streetgen._stretch_beside(axis, abscissa, abscissa_end, axis_offset)
            ELSE streetgen._roadway_border(axis::bytea, coalesce(borders, streetgen._even_borders(width, width_end,
                ST_Length2D(axis), roadway_offset)), abscissa, abscissa_end, side, axis_offset)::geometry END;
    END;
COMMENT ON FUNCTION streetgen._object_geometry(geometry, float8, float8, float8, float8[], float8, float8, text,
    float8) IS
    'Where an object stands: a point at an abscissa, or a line from there to another one; side NULL: so many metres to '
    'the left of the axis, else from that border. Widths as _to_border has them.';

CREATE OR REPLACE FUNCTION streetgen._located(axis geometry, width float8, width_end float8, roadway_offset float8,
    borders float8[], place geometry)
    RETURNS TABLE(abscissa float8, side text, axis_offset float8, border_offset float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1
    BEGIN ATOMIC
        SELECT f.at[1], s.side, f.at[2], CASE s.side WHEN 'left' THEN f.at[2] - b.to_left ELSE -f.at[2] - b.to_right END
        FROM (SELECT streetgen._locate_on(axis::bytea, place::bytea) AS at OFFSET 0) f,
            LATERAL (SELECT streetgen._to_border(width, width_end, ST_Length2D(axis), roadway_offset, borders, at[1],
                    'left') AS to_left,
                streetgen._to_border(width, width_end, ST_Length2D(axis), roadway_offset, borders, at[1], 'right')
                    AS to_right OFFSET 0) b,
            LATERAL (SELECT CASE WHEN f.at[2] >= (b.to_left - b.to_right) / 2 THEN 'left' ELSE 'right' END AS side) s;
    END;
COMMENT ON FUNCTION streetgen._located(geometry, float8, float8, float8, float8[], geometry) IS
    'Where a place lies beside an axis, as locate_on, with widths as _to_border has them: the inverse of '
    '_object_geometry.';

CREATE OR REPLACE FUNCTION streetgen._object_angle(axis geometry, abscissa float8, abscissa_end float8,
    orientation float8, orientation_kind text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC
        SELECT CASE WHEN orientation_kind = 'axis' AND axis IS NOT NULL THEN streetgen._direction_on(axis::bytea,
                coalesce((abscissa + abscissa_end) / 2, abscissa), orientation)
            ELSE orientation - 360 * floor(orientation / 360) END;
    END;
COMMENT ON FUNCTION streetgen._object_angle(geometry, float8, float8, float8, text) IS
    'The direction that an object faces, degrees clockwise from the north, from 0 to below 360: a stretch in its '
    'middle.';

CREATE OR REPLACE FUNCTION streetgen._hold_axes(model name, axes bigint[], places geometry[], wait boolean)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    hold_axes constant text := format('SELECT FROM %I.axis WHERE axis_id = ANY ($1) ORDER BY axis_id FOR SHARE', model);
    hold_borders constant text := CASE WHEN to_regprocedure(format('%I._hold_borders(bigint[], boolean)', model))
        IS NOT NULL THEN format('SELECT %I._hold_borders($1, $2)', model) END;
    held text;
    entered boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    -- Nobody waits here while holding anything that was taken here: who edits axes wants these in another order.
    LOOP
        entered := false;
        BEGIN
            IF places IS NOT NULL THEN
                PERFORM _lock_beside(places, false);
            END IF;
            entered := true;
            EXECUTE hold_axes || ' NOWAIT' USING axes;
            IF hold_borders IS NOT NULL THEN
                EXECUTE hold_borders USING axes, false;
            END IF;
            RETURN;
        EXCEPTION WHEN lock_not_available THEN
            IF NOT (entered AND wait) THEN
                RAISE;
            END IF;
        END;
        FOREACH held IN ARRAY array_remove(ARRAY[hold_axes, hold_borders], NULL) LOOP
            BEGIN
                EXECUTE held USING axes, true;
                RAISE SQLSTATE 'SG001';
            EXCEPTION WHEN SQLSTATE 'SG001' THEN
                NULL;
            END;
        END LOOP;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._hold_axes(name, bigint[], geometry[], boolean) IS
    'Keeps others from moving axes and their borders until the transaction ends, and from editing axes beside places '
    '(NULL: none): they wait, and then find an object there. Where one does so, or a lock_timeout ends: 55P03; without '
    'wait at once.';

CREATE OR REPLACE FUNCTION streetgen._object_edit_waits() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'Repeat the edit when it has ended, or edit street_object_editing, which waits.' $$;
COMMENT ON FUNCTION streetgen._object_edit_waits() IS
    'The way out of an edit of objects that is refused beside another one.';

CREATE OR REPLACE FUNCTION streetgen._object_axis(model name, axis bigint, holder text, OUT line geometry,
    OUT width float8, OUT width_end float8, OUT roadway_offset float8, OUT borders float8[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._hold_axes(model, ARRAY[axis], NULL, wait => holder IS NULL);
    SELECT ST_Force2D(u.geom), u.width, u.width_end, u.roadway_offset FROM axis_used u WHERE u.axis_id = axis
        INTO line, width, width_end, roadway_offset;
    borders := (SELECT b.borders FROM streetgen._axis_borders(model, ARRAY[axis]) b);
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    PERFORM streetgen._refuse('55P03',
        format('another session edits axis %s, by which %s stands, or its borders', axis, coalesce(holder,
            'the object')), detail => streetgen._holders(model),
        hint => CASE WHEN holder IS NULL THEN 'Repeat the edit when it has ended, or raise lock_timeout.'
            ELSE streetgen._object_edit_waits() END);
END $$;
COMMENT ON FUNCTION streetgen._object_axis(name, bigint, text) IS
    'The line, widths and roadway_offset (m) of an axis as the streets use them, and the borders of its roadway, '
    'held until the transaction ends; NULL for none. holder: who holds its object already and must not wait for who '
    'holds the axis, for whom that one may wait; NULL: nobody. An axis that another session edits: 55P03.';

CREATE OR REPLACE FUNCTION streetgen._leave_free(model name, rule bigint, place geometry) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    INSERT INTO free_place (rule_id, geom) VALUES (rule, place);
END $$;
COMMENT ON FUNCTION streetgen._leave_free(name, bigint, geometry) IS
    'Keeps a place free of objects of a rule; they are renewed later in the edit.';

CREATE OR REPLACE FUNCTION streetgen._keep_paint(model name, objects bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE pedestrian_crossing c SET marking = c.painted_as, refuge = coalesce(c.refuge,
        CASE WHEN c.island IS NOT NULL THEN streetgen._setting_number(model, 'refuge_width') END) FROM street_object o
        WHERE c.street_object_id = ANY (objects) AND o.street_object_id = c.street_object_id
            AND (o.placed_by, o.rule_id) = ('rule', -1) AND c.marking IS NULL;
END $$;
COMMENT ON FUNCTION streetgen._keep_paint(name, bigint[]) IS
    'Makes the paint and the refuge of crossings that footways made those of their user, before they are the user''s '
    'own.';

CREATE OR REPLACE FUNCTION streetgen._changed_columns(former record, now record) RETURNS text[]
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN array_remove(ARRAY[CASE WHEN now.type IS DISTINCT FROM former.type THEN 'type' END,
        CASE WHEN (now.orientation, now.orientation_kind) IS DISTINCT FROM (former.orientation, former.orientation_kind)
            THEN 'orientation' END,
        CASE WHEN (now.geom::bytea, now.placement, now.axis_id, now.abscissa, now.abscissa_end, now.side,
            now.axis_offset) IS DISTINCT FROM (former.geom::bytea, former.placement, former.axis_id, former.abscissa,
            former.abscissa_end, former.side, former.axis_offset) THEN 'geom' END], NULL);
END $$;
COMMENT ON FUNCTION streetgen._changed_columns(record, record) IS
    'What differs between two rows of street_object: type, orientation (with its kind), geom (all that places it).';

CREATE OR REPLACE FUNCTION streetgen._refuse_type(model name, subject text, type text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('22023',
        CASE WHEN type IS NULL THEN subject || ' has no type'
            ELSE format('there is no object type "%s"', type) END,
        hint => format('SELECT type FROM %I.object_type lists them; a row there makes another.', model));
END $$;
COMMENT ON FUNCTION streetgen._refuse_type(name, text, text) IS
    'Raises 22023 for a type of objects that is none, or NULL.';

CREATE OR REPLACE FUNCTION streetgen._place_object() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject constant text := CASE TG_OP WHEN 'INSERT' THEN 'the new object' ELSE 'object ' || OLD.street_object_id END;
    axis record;
    place record;
    known boolean;
    renamed boolean;
    changed text[] := '{}';
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    SELECT count(*) FILTER (WHERE type = NEW.type) = 1, count(*) FILTER (WHERE type = OLD.type) = 0
        FROM object_type WHERE type IN (NEW.type, OLD.type) INTO known, renamed;
    IF TG_OP = 'UPDATE' AND known AND renamed THEN
        -- Its type has another name now, and nothing else changed.
        RETURN NEW;
    END IF;
    IF NEW.geom IS NOT NULL THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        NEW.geom := ST_Force2D(NEW.geom);
    END IF;
    IF TG_OP = 'UPDATE' THEN
        changed := streetgen._changed_columns(OLD, NEW);
    END IF;
    IF OLD.placed_by = 'rule' AND (changed <> '{}'
        OR (NEW.placed_by, NEW.rule_id, NEW.rule_place) IS DISTINCT FROM (OLD.placed_by, OLD.rule_id, OLD.rule_place))
    THEN
        -- The object belongs to the user from then on, and the rule leaves its place free.
        PERFORM streetgen._leave_free(TG_TABLE_SCHEMA, OLD.rule_id, OLD.geom),
            streetgen._keep_paint(TG_TABLE_SCHEMA, ARRAY[OLD.street_object_id]);
        NEW.placed_by := CASE NEW.placed_by WHEN 'rule' THEN 'user' ELSE NEW.placed_by END;
    ELSIF OLD.source_ref IS NOT NULL AND changed <> '{}' AND NEW.by_hand = OLD.by_hand THEN
        IF 'geom' = ANY (changed) AND streetgen._stands_at_control_point(TG_TABLE_SCHEMA, NEW.control_point_id,
            NEW.geom) THEN
            changed := array_remove(changed, 'geom');
        END IF;
        -- A delivery of its source keeps what is by hand.
        NEW.by_hand := ARRAY(SELECT DISTINCT c FROM unnest(OLD.by_hand || changed) c ORDER BY c);
    END IF;
    IF NEW.placed_by <> 'rule' THEN
        NEW.rule_id := NULL;
        NEW.rule_place := NULL;
    END IF;
    IF NOT known THEN
        PERFORM streetgen._refuse_type(TG_TABLE_SCHEMA, subject, NEW.type);
    ELSIF NEW.side NOT IN ('left', 'right') THEN
        PERFORM streetgen._refuse('22023', format('the side of %s cannot be "%s"', subject, NEW.side),
            hint => 'It is left or right.');
    ELSIF NEW.placement NOT IN ('absolute', 'axis', 'border') THEN
        PERFORM streetgen._refuse('22023', format('the placement of %s cannot be "%s"', subject, NEW.placement),
            hint => 'It is absolute, axis or border.');
    ELSIF NEW.orientation_kind NOT IN ('absolute', 'axis') THEN
        PERFORM streetgen._refuse('22023', format('the orientation_kind of %s cannot be "%s"', subject,
            NEW.orientation_kind), hint => 'It is absolute or axis.');
    END IF;
    PERFORM streetgen._check_edit_number('the abscissa of ' || subject, NEW.abscissa, 0, 1e7, 'm', 'Drag it instead.'),
        streetgen._check_edit_number('the end of ' || subject, NEW.abscissa_end, 0, 1e7, 'm', 'Empty for a point.'),
        streetgen._check_edit_number('the offset of ' || subject, NEW.axis_offset, -200, 200, 'm', 'Drag it instead.'),
        streetgen._check_edit_number('the orientation of ' || subject, NEW.orientation, -360, 360, 'degrees',
            'They are counted clockwise.');
    IF NEW.axis_id IS NULL OR NEW.placement = 'absolute' THEN
        IF NEW.geom IS NULL THEN
            PERFORM streetgen._refuse('22023', format('%s has no place', subject),
                detail => 'It has neither a geometry nor an axis.', hint => 'Give geom, or axis_id and abscissa.');
        END IF;
        NEW.placement := 'absolute';
        NEW.method := 'absolute';
        NEW.angle := streetgen._object_angle(NULL, NULL, NULL, NEW.orientation, 'absolute');
        RETURN NEW;
    END IF;
    IF TG_OP = 'UPDATE' AND NEW.method = 'orphaned' AND (NEW.axis_id, NEW.abscissa) = (OLD.axis_id, OLD.abscissa) THEN
        NEW.angle := streetgen._object_angle(NULL, NULL, NULL, NEW.orientation
            + coalesce(OLD.angle - OLD.orientation, 0), 'absolute');
        RETURN NEW;
    END IF;
    axis := streetgen._object_axis(TG_TABLE_SCHEMA, NEW.axis_id, CASE TG_OP WHEN 'UPDATE' THEN subject END);
    IF axis.line IS NULL THEN
        PERFORM streetgen._refuse('22023', format('the axis of %s is gone', subject),
            detail => format('There is no axis %s.', NEW.axis_id),
            hint => 'Leave axis_id empty to put it where its geometry lies.');
    END IF;
    IF NEW.abscissa IS NULL AND NEW.geom IS NOT NULL THEN
        place := streetgen._located(axis.line, axis.width, axis.width_end, axis.roadway_offset, axis.borders,
            CASE ST_Dimension(NEW.geom) WHEN 0 THEN NEW.geom ELSE ST_StartPoint(NEW.geom) END);
        NEW.abscissa := place.abscissa;
        NEW.side := CASE NEW.placement WHEN 'border' THEN place.side END;
        NEW.axis_offset := CASE NEW.placement WHEN 'border' THEN place.border_offset ELSE place.axis_offset END;
    END IF;
    IF NEW.abscissa IS NULL OR greatest(NEW.abscissa, NEW.abscissa_end) > ST_Length2D(axis.line) + 1e-6 THEN
        PERFORM streetgen._refuse('22023',
            format('the abscissa of %s cannot be %s', subject, coalesce(greatest(NEW.abscissa,
                NEW.abscissa_end)::text, 'NULL')),
            detail => format('Axis %s is %s m long.', NEW.axis_id, round(ST_Length2D(axis.line)::numeric, 3)),
            hint => 'Drag it instead.');
    ELSIF NEW.abscissa_end - NEW.abscissa BETWEEN 0 AND 0.001 THEN
        PERFORM streetgen._refuse('22023', format('the end of %s lies at its start', subject),
            detail => 'A stretch is longer than a millimetre.', hint => 'Leave abscissa_end empty for a point.');
    ELSIF NEW.placement = 'axis' AND NEW.side IS NOT NULL AND NEW.side IS DISTINCT FROM OLD.side THEN
        PERFORM streetgen._refuse('22023', format('%s stands on no side', subject),
            detail => 'It is placed by its axis.', hint => 'Give placement "border", or leave side empty.');
    ELSIF NEW.placement = 'border' AND NEW.side IS NULL THEN
        PERFORM streetgen._refuse('22023', format('the side of %s is missing', subject),
            detail => 'It is placed by a border of the roadway.', hint => 'It is left or right.');
    END IF;
    NEW.side := CASE NEW.placement WHEN 'border' THEN NEW.side END;
    NEW.axis_offset := coalesce(NEW.axis_offset, 0);
    NEW.method := 'relative';
    NEW.geom := streetgen._object_geometry(axis.line, axis.width, axis.width_end, axis.roadway_offset, axis.borders,
        NEW.abscissa, NEW.abscissa_end, NEW.side, NEW.axis_offset);
    NEW.angle := streetgen._object_angle(axis.line, NEW.abscissa, NEW.abscissa_end, NEW.orientation,
        NEW.orientation_kind);
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._place_object() IS
    'Trigger of street_object: computes place, direction and method of an object from its axis, abscissa and offset; '
    'without an axis it stands where its geometry lies. What a user changes of a rule''s object makes it the user''s, '
    'and of an imported one is by hand; a type that was renamed is not, nor is a move of its control point. An '
    'abscissa beyond the axis, an axis or a type that is not there, a side that is missing or not used, a number that '
    'is none: 22023.';
