-- The edit view of objects.

CREATE OR REPLACE FUNCTION streetgen._snapped_axis(model name, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axis bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT axis_id FROM axis WHERE ST_DWithin(geom, place, (SELECT value::float8 FROM setting
        WHERE name = 'object_snap')) ORDER BY ST_Distance(geom, place), axis_id LIMIT 1 INTO axis;
    RETURN axis;
END $$;
COMMENT ON FUNCTION streetgen._snapped_axis(name, geometry) IS
    'The nearest axis within setting object_snap of a place; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._refuse_off_street(model name, subject text, place geometry) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    snap numeric;
    nearest record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value::numeric FROM setting WHERE name = 'object_snap' INTO snap;
    SELECT axis_id, round(ST_Distance(geom, place)::numeric, 1) AS metres FROM axis
        WHERE axis_id = streetgen._nearest_axis(model, place) INTO nearest;
    PERFORM streetgen._refuse('22023', format('%s stands at no street', subject),
        detail => CASE WHEN nearest.metres > snap THEN format('The nearest axis, %s, is %s m away: setting '
            'object_snap is %s m.', nearest.axis_id, nearest.metres, snap) ELSE 'It has no axis.' END,
        hint => 'Drop it at a street, or type axis_id and abscissa.');
END $$;
COMMENT ON FUNCTION streetgen._refuse_off_street(name, text, geometry) IS
    'Raises 22023 for an object that only a street can place, at a place where there is none, naming the nearest axis.';

CREATE OR REPLACE FUNCTION streetgen._require_street(model name, subject text, object bigint) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._refuse_off_street(model, subject, geom) FROM street_object
        WHERE street_object_id = object AND method = 'absolute'
            AND type = ANY (_types_below('crossing') || _types_below('parking_bay'));
END $$;
COMMENT ON FUNCTION streetgen._require_street(name, text, bigint) IS
    'Raises 22023 for a crossing or parking bay that stands at no street.';

CREATE OR REPLACE FUNCTION streetgen._enter_object_edit(model name, object bigint, axes bigint[], places geometry[])
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    ruled boolean := false;
BEGIN
    PERFORM streetgen._use_model(model);
    IF to_regprocedure(format('%I._begin_ruled_edit()', model)) IS NOT NULL THEN
        SELECT _begin_ruled_edit() INTO ruled;
    END IF;
    PERFORM streetgen._hold_axes(model, axes, CASE WHEN ruled THEN array_remove(places, NULL) END, wait => true);
    -- A wait for the object can be told here; one of the UPDATE below ends in a deadlock of the server.
    PERFORM FROM street_object WHERE street_object_id = object FOR NO KEY UPDATE;
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    PERFORM streetgen._refuse('55P03', 'another session edits the object or its street',
        detail => streetgen._holders(model), hint => 'Repeat the edit when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen._enter_object_edit(name, bigint, bigint[], geometry[]) IS
    'Before an edit view writes an object: locks what who edits axes locks before objects, in the same order. That is '
    'the model, the axes by which the object stands with their borders, and where rules place objects the axes beside '
    'its places; then the object (NULL: a new one). A lock_timeout that ends, or who waits for this one: 55P03, naming '
    'who holds them.';

CREATE OR REPLACE FUNCTION streetgen._grant_object_locks(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    editor text;
BEGIN
    IF 'object' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    FOR editor IN SELECT DISTINCT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END
        FROM pg_class c, aclexplode(c.relacl)
        WHERE c.oid = format('%I.axis', model)::regclass AND grantee <> c.relowner
            AND privilege_type IN ('INSERT', 'UPDATE', 'DELETE')
    LOOP
        EXECUTE format('GRANT EXECUTE ON FUNCTION %1$I._begin_ruled_edit(), %1$I._lock_beside(geometry[], boolean), '
            '%1$I._hold_borders(bigint[], boolean) TO %2$s', model, editor);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._grant_object_locks(name) IS
    'Who may write the axes of a model may call the functions by which edits of its objects lock.';

CREATE OR REPLACE FUNCTION streetgen._edit_street_object() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- The place where it was dropped.
    dropped geometry;
    axis record;
    at record;
    held bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    PERFORM streetgen._hold_specialised_types(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        PERFORM streetgen._enter_object_edit(TG_TABLE_SCHEMA, OLD.street_object_id, ARRAY[OLD.axis_id],
            ARRAY[OLD.geom]);
        DELETE FROM street_object WHERE street_object_id = OLD.street_object_id;
        RETURN OLD;
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{type,geom,placement,axis_id,abscissa,side,axis_offset,'
            'orientation,orientation_kind}',
            'Type orientation to turn it, and axis_id or placement to tie it.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        ELSIF NEW.placement IS NULL AND NEW.geom IS NOT DISTINCT FROM OLD.geom THEN
            PERFORM streetgen._refuse('22004', format('the placement of object %s cannot be NULL',
                OLD.street_object_id), hint => 'Type axis, border or absolute, or drag the object.');
        END IF;
        NEW.orientation := coalesce(NEW.orientation, 0);
        NEW.orientation_kind := coalesce(NEW.orientation_kind, 'axis');
    END IF;
    IF TG_OP = 'INSERT' AND NEW.geom IS NOT NULL AND NEW.abscissa IS NULL
        OR TG_OP = 'UPDATE' AND NEW.geom IS DISTINCT FROM OLD.geom THEN
        dropped := NEW.geom;
        PERFORM streetgen._check_edit_geometry(CASE TG_OP WHEN 'INSERT' THEN 'the new object'
            ELSE 'object ' || OLD.street_object_id END, dropped);
    END IF;
    IF dropped IS NOT NULL AND NEW.placement IS DISTINCT FROM 'absolute' THEN
        -- Its own axis, else the nearest one.
        IF NEW.axis_id IS NULL OR TG_OP = 'UPDATE' AND NEW.axis_id IS NOT DISTINCT FROM OLD.axis_id THEN
            NEW.axis_id := coalesce((SELECT axis_id FROM streetgen._own_axis_near(TG_TABLE_SCHEMA, NEW.axis_id,
                dropped) axis_id), streetgen._snapped_axis(TG_TABLE_SCHEMA, dropped));
        END IF;
        IF NEW.axis_id IS NULL AND NEW.placement IN ('axis', 'border')
            AND NEW.placement IS DISTINCT FROM OLD.placement THEN
            PERFORM streetgen._refuse_off_street(TG_TABLE_SCHEMA, CASE TG_OP
                WHEN 'INSERT' THEN 'the new ' || coalesce(replace(NEW.type, '_', ' '), 'object')
                ELSE 'object ' || OLD.street_object_id END, dropped);
        ELSIF NEW.axis_id IS NULL THEN
            NEW.placement := 'absolute';
        END IF;
    ELSIF TG_OP = 'UPDATE' AND NEW.placement IN ('axis', 'border') AND NEW.placement IS DISTINCT FROM OLD.placement
        AND (NEW.abscissa, NEW.axis_offset) IS NOT DISTINCT FROM (OLD.abscissa, OLD.axis_offset) THEN
        -- The object stays where it is, and is measured from another line.
        NEW.axis_id := coalesce(NEW.axis_id, streetgen._snapped_axis(TG_TABLE_SCHEMA, OLD.geom));
        NEW.abscissa := NULL;
    END IF;
    PERFORM streetgen._enter_object_edit(TG_TABLE_SCHEMA, OLD.street_object_id, ARRAY[OLD.axis_id,
        CASE WHEN NEW.placement IS DISTINCT FROM 'absolute' THEN NEW.axis_id END], ARRAY[OLD.geom, NEW.geom,
        streetgen._axis_foot(TG_TABLE_SCHEMA, NEW.axis_id, NEW.abscissa)]);
    IF dropped IS NOT NULL AND NEW.placement IS DISTINCT FROM 'absolute' THEN
        axis := streetgen._object_axis(TG_TABLE_SCHEMA, NEW.axis_id, NULL);
        at := streetgen._located(axis.line, axis.width, axis.width_end, axis.roadway_offset, axis.borders, dropped);
        NEW.placement := coalesce(NEW.placement, CASE WHEN at.border_offset > 0 THEN 'border' ELSE 'axis' END);
        NEW.abscissa := at.abscissa;
        NEW.side := CASE NEW.placement WHEN 'border' THEN at.side END;
        NEW.axis_offset := CASE NEW.placement WHEN 'border' THEN at.border_offset ELSE at.axis_offset END;
    END IF;
    IF TG_OP = 'INSERT' THEN
        INSERT INTO street_object (type, geom, placement, axis_id, abscissa, side, axis_offset, orientation,
                orientation_kind)
            VALUES (NEW.type, NEW.geom,
                -- A side without a placement means the border there.
                coalesce(NEW.placement, CASE WHEN NEW.side IS NULL THEN 'axis' ELSE 'border' END), NEW.axis_id,
                NEW.abscissa, NEW.side, NEW.axis_offset, coalesce(NEW.orientation, 0),
                coalesce(NEW.orientation_kind, 'axis'))
            RETURNING street_object_id, geom, placement, side, axis_offset, orientation, orientation_kind, angle, method
            INTO NEW.street_object_id, NEW.geom, NEW.placement, NEW.side, NEW.axis_offset, NEW.orientation,
                NEW.orientation_kind, NEW.angle, NEW.method;
        PERFORM streetgen._require_street(TG_TABLE_SCHEMA, 'the new ' || replace(NEW.type, '_', ' '),
            NEW.street_object_id);
        RETURN NEW;
    END IF;
    UPDATE street_object SET type = NEW.type, geom = NEW.geom, placement = NEW.placement, axis_id = NEW.axis_id,
        abscissa = NEW.abscissa, side = NEW.side, axis_offset = NEW.axis_offset, orientation = NEW.orientation,
        orientation_kind = NEW.orientation_kind, method = CASE WHEN (dropped IS NOT NULL) THEN 'absolute' ELSE method
        END WHERE street_object_id = OLD.street_object_id RETURNING street_object_id INTO held;
    IF held IS NULL THEN
        PERFORM streetgen._refuse('22023', format('object %s is gone', OLD.street_object_id),
            detail => 'Another session deleted it.', hint => 'Refresh the layer.');
    END IF;
    -- One that an import left away from streets may be edited otherwise.
    PERFORM streetgen._require_street(TG_TABLE_SCHEMA, replace(NEW.type, '_', ' ') || ' ' || held, held)
        WHERE (NEW.type, NEW.geom::bytea, NEW.placement, NEW.axis_id, NEW.abscissa)
            IS DISTINCT FROM (OLD.type, OLD.geom::bytea, OLD.placement, OLD.axis_id, OLD.abscissa);
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_street_object() IS
    'Trigger of street_object_editing: a point that is dropped or dragged gets the abscissa and offset of the place '
    'at its axis, or at the nearest one within setting object_snap, on the roadway from the axis and beside it from '
    'the border; farther away it stands absolute, or is refused where placement axis or border is typed, or where it '
    'is a crossing or parking bay, which only a street can place (22023). Typed values count as they are.';

CREATE OR REPLACE FUNCTION streetgen._axis_foot(model name, axis bigint, abscissa float8) RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    foot geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT ST_LineInterpolatePoint(geom, greatest(0, least(1, abscissa / ST_Length2D(geom)))) FROM axis
        WHERE axis_id = _axis_foot.axis INTO foot;
    RETURN foot;
END $$;
COMMENT ON FUNCTION streetgen._axis_foot(name, bigint, float8) IS
    'The place of an axis at an abscissa, or at the end that is nearer; NULL for an axis that is gone.';

CREATE OR REPLACE FUNCTION streetgen._own_axis_near(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    near bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT axis_id FROM axis WHERE axis_id = _own_axis_near.axis AND ST_DWithin(geom, place, (SELECT value::float8
        FROM setting WHERE name = 'object_snap')) INTO near;
    RETURN near;
END $$;
COMMENT ON FUNCTION streetgen._own_axis_near(name, bigint, geometry) IS
    'An axis that is still within setting object_snap of a place; else NULL.';

CREATE OR REPLACE FUNCTION streetgen._object_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('street_object_editing', 'Edit layer: drop, drag or turn an object; type where it stands. It follows its axis',
        ARRAY['key; NULL for a new object', 'what it is', 'where it stands', 'absolute, axis or border; NULL for a new '
            'one: by the place', 'the axis; NULL: the nearest', 'metres along the axis', 'left or right, of a '
            'placement by the border', 'metres to the left of the axis, or away '
            'from the border', 'degrees clockwise from the axis, or from the north', 'axis or absolute',
            'direction, degrees clockwise from the north; type orientation to turn it',
            'computed: absolute, relative or orphaned'],
        $sql$SELECT street_object_id, type, geom::geometry(Point, {srid}) AS geom, placement, axis_id, abscissa, side,
            axis_offset, orientation, orientation_kind, angle, method
        FROM {model}.street_object WHERE abscissa_end IS NULL AND ST_Dimension(geom) = 0$sql$, 'object'),
    ('pedestrian_crossing_editing', 'Edit layer: drop or drag a pedestrian crossing; type its width, angle, '
            'paint, kerbs and refuge',
        ARRAY['key; NULL for a new crossing', 'its middle on the axis', 'the axis; NULL: the nearest',
            'metres along the axis', 'metres along the street; NULL: 4',
            'degrees counter-clockwise from the axis to the way across; NULL: 90',
            'zebra, ladder, lines, dashes, dots, surface, yes or no; NULL: as its control point or settings say',
            'raised, lowered, rolled, flush or no; NULL: as its control point says, else flush',
            'width of the refuge in its middle, metres; 0: none; NULL: as its control point says'],
        $sql$SELECT c.street_object_id, o.geom::geometry(Point, {srid}) AS geom, o.axis_id, o.abscissa, c.width,
            c.angle, c.marking, c.kerb, c.refuge
        FROM {model}.pedestrian_crossing c JOIN {model}.street_object o USING (street_object_id)$sql$, 'object'),
    ('parking_bay_editing', 'Edit layer: drop or drag a parking bay; type its size and its angle',
        ARRAY['key; NULL for a new bay', 'the middle of its end at the border', 'the axis; NULL: the nearest',
            'metres along the axis', 'left or right', 'metres away from the border; negative on the roadway',
            'metres; NULL: 5', 'metres; NULL: 2.3', 'degrees: 0 or NULL parallel to the border, 90 perpendicular'],
        $sql$SELECT b.street_object_id, o.geom::geometry(Point, {srid}) AS geom, o.axis_id, o.abscissa, o.side,
            o.axis_offset, b.length, b.width, b.angle
        FROM {model}.parking_bay b JOIN {model}.street_object o USING (street_object_id)$sql$, 'object') $$;
COMMENT ON FUNCTION streetgen._object_edit_view() IS 'The views in which objects are edited.';
