-- Edits of sidewalks: sidewalk_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_sidewalk() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    edge record;
    known bigint[];
    abscissa float8;
BEGIN
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Sidewalks come from sidewalk_left and sidewalk_right of their axis.');
    ELSIF TG_OP = 'UPDATE' AND NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    ELSIF TG_OP = 'UPDATE' AND (NEW.sidewalk_id, NEW.edge_id, NEW.side, NEW.geom) IS DISTINCT FROM
        (OLD.sidewalk_id, OLD.edge_id, OLD.side, OLD.geom) THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, 'a change of its key, edge_id, side or geom',
            'Only width and by_hand can be changed.');
    END IF;
    subject := format('sidewalk %s (%s of edge %s)', OLD.sidewalk_id, OLD.side, OLD.edge_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge WHERE edge_id = %s',
        TG_TABLE_SCHEMA, OLD.edge_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    EXECUTE format('SELECT coalesce(array_agg(sidewalk_override_id ORDER BY sidewalk_override_id DESC), ''{}'') FROM '
        '%I.sidewalk_override WHERE axis_id = $1 AND side = $2 AND abscissa >= $3 AND abscissa < $4', TG_TABLE_SCHEMA)
        INTO known USING edge.axis_id, OLD.side, edge.start_abscissa, edge.end_abscissa;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        EXECUTE format('DELETE FROM %I.sidewalk_override WHERE sidewalk_override_id = ANY ($1)', TG_TABLE_SCHEMA)
            USING known;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    PERFORM streetgen._check_edit_number('the width of ' || subject, NEW.width, 0, 50, 'm', '0 takes it away.');
    IF known = '{}' THEN
        abscissa := (edge.start_abscissa + edge.end_abscissa) / 2;
        EXECUTE format('INSERT INTO %I.sidewalk_override (axis_id, abscissa, side, width, geom) '
            'VALUES ($1, $2, $3, $4, $5)', TG_TABLE_SCHEMA) USING edge.axis_id, abscissa, OLD.side, NEW.width,
                ST_LineInterpolatePoint(edge.axis, least(abscissa / ST_Length2D(edge.axis), 1));
    ELSE
        EXECUTE format('UPDATE %I.sidewalk_override SET width = $2 WHERE sidewalk_override_id = $1', TG_TABLE_SCHEMA)
            USING known[1], NEW.width;
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_sidewalk() IS
    'Trigger of sidewalk_editing: writes sidewalk_override for the side of an edge. A width beyond 0 to 50 m: 22023; '
    'INSERT and other changes: 0A000.';
