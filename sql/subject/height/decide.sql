-- The edit view of heights by hand.

CREATE OR REPLACE FUNCTION streetgen._edit_height() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    axis geometry;
    at float8;
    known bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        DELETE FROM height_override WHERE height_override_id = OLD.height_id;
        RETURN OLD;
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{axis_id,height,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := CASE TG_OP WHEN 'INSERT' THEN 'the new height' ELSE 'height ' || OLD.height_id END;
    PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
    IF NEW.axis_id IS NULL THEN
        NEW.axis_id := streetgen._nearest_axis(TG_TABLE_SCHEMA, NEW.geom);
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %I.height_override WHERE height_override_id = %s UNION ALL SELECT %s',
        TG_TABLE_SCHEMA, quote_nullable(OLD.height_id), quote_nullable(NEW.axis_id)));
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = NEW.axis_id INTO axis;
    IF axis IS NULL THEN
        PERFORM streetgen._refuse('22023', format('the axis of %s is gone', subject),
            detail => format('There is no axis %s.', coalesce(NEW.axis_id::text, 'in the model')),
            hint => 'Leave axis_id empty to take the nearest axis.');
    END IF;
    IF NOT ST_DWithin(axis, NEW.geom, 100) THEN
        PERFORM streetgen._refuse('22023',
            format('%s lies %s m from axis %s', subject, round(ST_Distance(axis, NEW.geom)::numeric, 1), NEW.axis_id),
            hint => 'Put it on the axis, within 100 m.');
    END IF;
    PERFORM streetgen._check_edit_number('the height of ' || subject, NEW.height, -1000, 10000, 'm',
        'Delete the row to take back what was decided by hand.');
    at := ST_LineLocatePoint(axis, NEW.geom) * ST_Length2D(axis);
    NEW.geom := ST_LineInterpolatePoint(axis, ST_LineLocatePoint(axis, NEW.geom));
    IF TG_OP = 'INSERT' THEN
        INSERT INTO height_override (axis_id, abscissa, height, geom) VALUES (NEW.axis_id, at, NEW.height, NEW.geom)
            RETURNING height_override_id INTO NEW.height_id;
        RETURN NEW;
    END IF;
    UPDATE height_override SET axis_id = NEW.axis_id, abscissa = at, height = NEW.height, geom = NEW.geom
        WHERE height_override_id = OLD.height_id RETURNING height_override_id INTO known;
    IF known IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject), detail => 'Another session deleted it.',
            hint => 'Refresh the layer.');
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_height() IS
    'Trigger of height_editing: writes height_override, the axis being the nearest one unless given. A point over '
    '100 m from it, or a height beyond -1000 to 10000 m: 22023.';

CREATE OR REPLACE FUNCTION streetgen._height_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('height_editing', 'Edit layer: drop a point on a road and type how high it lies there at least; DELETE takes it '
        'back',
        ARRAY['key', 'the axis: the nearest one where left out', 'height, metres', 'the place on the axis'],
        $sql$SELECT height_override_id AS height_id, axis_id, height, geom FROM {model}.height_override$sql$,
        'height') $$;
COMMENT ON FUNCTION streetgen._height_edit_view() IS 'The views in which heights are edited.';

CREATE OR REPLACE FUNCTION streetgen._height_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('height_override'::name, 'along', '{axis_id}'::name[], '{tolerance}', '{}'::jsonb, true, 9,
        'ROW(o.abscissa, o.height)') $$;
COMMENT ON FUNCTION streetgen._height_decision() IS
    'The anchors of decisions about heights, and which of their columns follow the axes.';
