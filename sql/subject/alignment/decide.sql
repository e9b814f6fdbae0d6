-- Edits of the bends of roads: road_arc_editing.

CREATE OR REPLACE FUNCTION streetgen._sharp_bends(model name)
    RETURNS TABLE(axis_id bigint, abscissa float8, place geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT youngest.axis_id, youngest.abscissa, youngest.place FROM (
        SELECT DISTINCT ON (o.axis_id, p.place) o.axis_id, p.place, o.radius,
            coalesce(b.abscissa, o.abscissa) AS abscissa
        FROM road_override o LEFT JOIN axis x USING (axis_id)
            LEFT JOIN LATERAL streetgen._bend_at(x.geom, o.abscissa) b ON true,
            LATERAL (SELECT coalesce(b.vertex, o.geom) AS place) p
        WHERE p.place IS NOT NULL ORDER BY o.axis_id, p.place, o.road_override_id DESC) youngest
        WHERE radius = 0;
END $$;
COMMENT ON FUNCTION streetgen._sharp_bends(name) IS
    'The bends of a model that are sharp by hand, at their vertices; at its own place a decision without its bend.';

CREATE OR REPLACE FUNCTION streetgen._edit_road_arc() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    axis geometry;
    bend record;
    decided bigint[];
    written bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
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
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = OLD.axis_id INTO axis;
    -- Another session may have drawn the axis anew meanwhile.
    SELECT b.* FROM ST_DumpPoints(axis) v, streetgen._bend_of(axis, v.geom, 0, ST_Length2D(axis)) b
        WHERE streetgen._bend_key(OLD.axis_id, v.geom) = OLD.road_arc_id AND b.vertex = v.geom INTO bend;
    decided := ARRAY(SELECT road_override_id FROM road_override WHERE axis_id = OLD.axis_id
        AND abs(coalesce((streetgen._bend_at(axis, abscissa)).abscissa, abscissa)
            - coalesce(bend.abscissa, OLD.abscissa)) < 1e-6
        ORDER BY road_override_id DESC);
    IF TG_OP = 'DELETE' OR NEW.radius IS NULL AND NEW.geom IS NOT DISTINCT FROM OLD.geom
        OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM road_override WHERE road_override_id = ANY (decided);
        GET DIAGNOSTICS written = ROW_COUNT;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN written > 0 THEN OLD END;
    END IF;
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
    UPDATE road_override SET radius = NEW.radius WHERE road_override_id = decided[1];
    IF NOT FOUND THEN
        INSERT INTO road_override (axis_id, abscissa, radius, geom) VALUES (OLD.axis_id, bend.abscissa, NEW.radius,
            bend.vertex);
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_road_arc() IS
    'Trigger of road_arc_editing: writes road_override, the radius as typed or from where the centre was dragged to. '
    'A radius beyond 0 to 4000 m, or a bend that is gone: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._alignment_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('road_arc_editing', 'Edit layer: drag the centre of a bend or type its radius; DELETE takes back what was '
        'decided by hand',
        ARRAY['key of the bend, by its axis and vertex: it stays while these do', 'the axis',
            'where it bends, metres along the axis',
            'radius of the bend, metres, 0: it is sharp; NULL takes it back',
            'decided by hand; false takes it back', 'centre of the arc; of a sharp bend its place'],
        streetgen._part('road_arc_editing'), 'alignment') $$;
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
