-- Objects that are control points too: the crossing, signal or sign of a node of OpenStreetMap.

CREATE OR REPLACE FUNCTION streetgen._carry_controlled_object() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        UPDATE street_object SET control_point_id = NULL WHERE control_point_id = OLD.control_point_id;
    ELSE
        UPDATE street_object SET geom = NEW.geom, axis_id = NEW.axis_id, abscissa = NULL, placement = CASE
                WHEN placement = 'absolute' THEN 'axis' ELSE placement END
            WHERE control_point_id = NEW.control_point_id;
    END IF;
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._carry_controlled_object() IS
    'Trigger of control_point: the object of a control point that moved stands where the control point does; the '
    'object of one that is gone stays.';

CREATE OR REPLACE FUNCTION streetgen._stands_at_control_point(model name, control_point bigint, place geometry)
    RETURNS boolean
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    stands boolean := false;
BEGIN
    PERFORM streetgen._use_model(model);
    IF control_point IS NOT NULL THEN
        SELECT ST_DWithin(geom, place, 1e-9) FROM control_point
            WHERE control_point_id = _stands_at_control_point.control_point
            INTO stands;
    END IF;
    RETURN coalesce(stands, false);
END $$;
COMMENT ON FUNCTION streetgen._stands_at_control_point(name, bigint, geometry) IS
    'Does an object that is put at this place go with the control point that it points to?';

CREATE OR REPLACE FUNCTION streetgen._find_control_points(model name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH kind AS MATERIALIZED (
        SELECT unnest(_types_below(type)) AS type, kind FROM (VALUES ('crossing', 'pedestrian_crossing'),
            ('traffic_light', 'signals'), ('sign', 'stop'), ('sign', 'yield')) k(type, kind)),
    pair AS (
        SELECT o.street_object_id, c.control_point_id, ST_Distance(o.geom, c.geom) AS away
        FROM street_object o JOIN kind USING (type)
            JOIN control_point c ON c.kind = kind.kind AND ST_DWithin(c.geom, o.geom, 1)
        WHERE o.source = _find_control_points.source AND o.control_point_id IS NULL
            AND NOT EXISTS (SELECT FROM street_object p WHERE p.control_point_id = c.control_point_id)),
    nearest AS (
        SELECT DISTINCT ON (control_point_id) * FROM pair ORDER BY control_point_id, away, street_object_id)
    UPDATE street_object o SET control_point_id = n.control_point_id
    FROM (SELECT DISTINCT ON (street_object_id) * FROM nearest ORDER BY street_object_id, away, control_point_id) n
    WHERE o.street_object_id = n.street_object_id;
END $$;
COMMENT ON FUNCTION streetgen._find_control_points(name, text) IS
    'Lets the crossings, signals and signs of an import point to the control point of their kind within a metre, each '
    'to one that no other object points to.';
