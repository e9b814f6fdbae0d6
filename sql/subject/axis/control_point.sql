-- Control points: signals, signs and crossings before or at a junction, of a source or put by hand.

CREATE OR REPLACE FUNCTION streetgen._fill_axis() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    line geometry;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' AND NEW.axis_id IS NULL
        OR TG_OP = 'UPDATE' AND NEW.axis_id IS NOT DISTINCT FROM OLD.axis_id
            AND NEW.geom::bytea IS DISTINCT FROM OLD.geom::bytea THEN
        NEW.axis_id := streetgen._axis_beside(TG_TABLE_SCHEMA, NEW.geom);
    END IF;
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = NEW.axis_id INTO line;
    IF line IS NOT NULL THEN
        NEW.abscissa := ST_LineLocatePoint(line, NEW.geom) * ST_Length(line);
        NEW.axis_distance := ST_Distance(line, NEW.geom);
    ELSIF NEW.axis_id IS NULL THEN
        NEW.abscissa := NULL;
        NEW.axis_distance := NULL;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._fill_axis() IS
    'Trigger of control_point: the axis that the point stands on or beside where none is given or the point moved, and '
    'its place along that axis; as they were where the axis is gone.';

CREATE OR REPLACE FUNCTION streetgen._axis_beside(model name, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    found bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    -- The widest street is 200 m wide. What is no longer than the tolerance, an axis or the piece at an end of it, is a
    -- node and no edge.
    SELECT axis_id FROM (
        SELECT axis_id, round(ST_Distance(a.geom, _axis_beside.place)::numeric, 6) AS distance,
            coalesce(a.width, c.width, (SELECT value::float8 FROM setting WHERE name = 'width_default')) / 2 AS half,
            length <= tolerance AS collapses, p.place <= first AND first <= tolerance
                OR p.place >= length - last AND last <= tolerance AS behind, tolerance
        FROM (SELECT value::float8 AS tolerance FROM setting WHERE name = 'tolerance') s, axis a
            LEFT JOIN axis_class c ON c.class = a.kind CROSS JOIN LATERAL (
            SELECT length, ST_LineLocatePoint(line, _axis_beside.place) * length AS place,
                ST_Distance(ST_StartPoint(line), ST_PointN(line, 2)) AS first,
                ST_Distance(ST_PointN(line, -2), ST_EndPoint(line)) AS last
            FROM (SELECT ST_Force2D(a.geom) AS line, ST_Length(ST_Force2D(a.geom)) AS length OFFSET 0) l) p
        WHERE ST_DWithin(a.geom, _axis_beside.place, 103)) near
    WHERE distance <= half + 3 * tolerance
    ORDER BY collapses, distance, behind, axis_id LIMIT 1 INTO found;
    RETURN found;
END $$;
COMMENT ON FUNCTION streetgen._axis_beside(name, geometry) IS
    'The nearest axis of a model on whose roadway a place lies, or within three tolerances beside it; NULL: none. Of '
    'equally near axes the smallest axis_id. After these come axes whose end piece there is no longer than the '
    'tolerance, since their edge ends before it. Axes no longer than the tolerance have no edge and come last.';

CREATE OR REPLACE FUNCTION streetgen._axis_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('control_point'::name, 'ground', '{axis_id}'::name[], 'coalesce(axis_distance, 0) + {tolerance}',
        jsonb_build_object('direction', 'streetgen._swapped(o.direction, ''direct'', ''reverse'', n.turned)'), true, 5,
        'ROW(o.abscissa, o.kind, o.direction)') $$;
COMMENT ON FUNCTION streetgen._axis_decision() IS
    'The anchors of decisions about control points, and which of their columns follow the axes.';
