-- The edit view of roundabouts: a list to work through, the least certain ring first.

CREATE OR REPLACE FUNCTION streetgen._edit_roundabout() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    decided boolean;
    known bigint[];
BEGIN
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse('0A000', 'a roundabout cannot be drawn',
            hint => 'It stands where axes close a ring: draw these.');
    ELSIF TG_OP = 'UPDATE' THEN
        decided := NEW.confirmed;
        NEW.geom := OLD.geom;
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge JOIN %1$I.roundabout_edge r '
        'USING (edge_id) WHERE r.roundabout_id = %s', TG_TABLE_SCHEMA, OLD.roundabout_id));
    EXECUTE format('SELECT coalesce(array_agg(roundabout_override_id ORDER BY roundabout_override_id), ''{}'') '
        'FROM %I.roundabout_override WHERE geom && $1 AND ST_Covers(ST_ConvexHull($1), geom)', TG_TABLE_SCHEMA)
        INTO known USING OLD.geom;
    EXECUTE format('DELETE FROM %I.roundabout_override WHERE roundabout_override_id = ANY ($1)', TG_TABLE_SCHEMA)
        USING CASE WHEN decided IS NULL THEN known ELSE known[2:] END;
    IF decided IS NULL THEN
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    ELSIF known = '{}' THEN
        EXECUTE format('INSERT INTO %I.roundabout_override (geom, confirmed) VALUES ($1, $2)', TG_TABLE_SCHEMA)
            USING ST_PointOnSurface(ST_MakeValid(ST_MakePolygon(OLD.geom))), decided;
    ELSE
        EXECUTE format('UPDATE %I.roundabout_override SET confirmed = $2 WHERE roundabout_override_id = $1',
            TG_TABLE_SCHEMA) USING known[1], decided;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_roundabout() IS
    'Trigger of roundabout_editing: writes roundabout_override at a place within the ring; confirmed NULL, or DELETE, '
    'takes it back. INSERT: 0A000.';
