-- Edits of the bends of roads: road_arc_editing.

CREATE OR REPLACE FUNCTION streetgen._road_arc_handles() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    -- A bend that is sharp by hand has no arc: its handle is its vertex.
    AS $f$ SELECT $sql$
        SELECT a.road_arc_id, b.axis_id, b.abscissa, a.radius,
            EXISTS (SELECT FROM %1$I.road_override o
                WHERE o.axis_id = b.axis_id AND abs(o.abscissa - b.abscissa) <= 1) AS by_hand, a.centre AS geom
        FROM %1$I.road_arc a, LATERAL (
            SELECT e.axis_id, v.abscissa FROM %1$I.road_edge m JOIN %1$I.edge e USING (edge_id)
                JOIN %1$I.axis x USING (axis_id),
                LATERAL streetgen._bend_of(x.geom, a.corner, e.start_abscissa, e.end_abscissa) v
            WHERE m.road_id = a.road_id AND ST_DWithin(x.geom, a.corner, 1) AND v.abscissa IS NOT NULL
            ORDER BY ST_Distance(v.vertex, a.corner), e.axis_id LIMIT 1) b
        UNION ALL SELECT -o.road_override_id, o.axis_id, o.abscissa, o.radius, true, o.geom
        FROM %1$I.road_override o WHERE o.radius = 0 AND o.geom IS NOT NULL$sql$ $f$;
COMMENT ON FUNCTION streetgen._road_arc_handles() IS 'The query of road_arc_editing, over a model %1$I.';

CREATE OR REPLACE FUNCTION streetgen._edit_road_arc() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    axis geometry;
    bend record;
    known bigint;
    written bigint;
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'Bends lie where axes bend: change the radius of one.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{radius,by_hand,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := format('the bend at %s m of axis %s', round(OLD.abscissa::numeric, 2), OLD.axis_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, 'SELECT ' || OLD.axis_id);
    SELECT geom FROM axis WHERE axis_id = OLD.axis_id INTO axis;
    IF TG_OP = 'DELETE' OR NEW.radius IS NULL AND NEW.geom IS NOT DISTINCT FROM OLD.geom
        OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM road_override WHERE axis_id = OLD.axis_id AND abs(abscissa - OLD.abscissa) <= 1;
        GET DIAGNOSTICS written = ROW_COUNT;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN written > 0 THEN OLD END;
    END IF;
    bend := streetgen._bend_of(axis, ST_LineInterpolatePoint(ST_Force2D(axis),
        least(OLD.abscissa / ST_Length2D(axis), 1)), 0, ST_Length2D(axis));
    IF bend.abscissa IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject),
            detail => 'The axis does not bend there any more.', hint => 'Refresh the layer.');
    END IF;
    IF NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        -- The centre lies on the line that halves the angle, and the arc touches both segments. Far off it lies as for
        -- the greatest radius.
        NEW.radius := least(ST_Distance(bend.vertex, NEW.geom) * abs(sin(bend.half_angle)), 4000);
    END IF;
    PERFORM streetgen._check_edit_number('the radius of ' || subject, NEW.radius, 0, 4000, 'm',
        '0 for a sharp bend; delete the row to take back what was decided by hand.');
    SELECT max(road_override_id) FROM road_override WHERE axis_id = OLD.axis_id
        AND abs(abscissa - bend.abscissa) <= 1 INTO known;
    IF known IS NULL THEN
        INSERT INTO road_override (axis_id, abscissa, radius, geom) VALUES (OLD.axis_id, bend.abscissa, NEW.radius,
            bend.vertex);
    ELSE
        UPDATE road_override SET radius = NEW.radius WHERE road_override_id = known;
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_road_arc() IS
    'Trigger of road_arc_editing: writes road_override, the radius as typed or from where the centre was dragged to. '
    'A radius beyond 0 to 4000 m, or a bend that is gone: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._alignment_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('road_arc_editing', 'Edit layer: drag the centre of a bend or type its radius; DELETE takes back what was '
        'decided by hand',
        ARRAY['key', 'the axis', 'where it bends, metres along the axis',
            'radius of the bend, metres, 0: it is sharp; NULL takes it back',
            'decided by hand; false takes it back', 'centre of the arc; of a sharp bend its place'],
        streetgen._road_arc_handles(), 'alignment') $$;
COMMENT ON FUNCTION streetgen._alignment_edit_view() IS 'The views in which roads are edited.';

CREATE OR REPLACE FUNCTION streetgen._alignment_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('road_override'::name, 'vertex', '{axis_id}'::name[], '{tolerance}', '{}'::jsonb, true, 8,
        'ROW(o.abscissa, o.radius)') $$;
COMMENT ON FUNCTION streetgen._alignment_decision() IS
    'The anchors of decisions about roads, and which of their columns follow the axes.';
