-- Edits of places on streets: section_limit_editing, corner_editing, kerb_point_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_section_limit() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    edge record;
    other float8;
    place geometry;
    known bigint;
    written bigint;
    node bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'Each edge has its two limits: move one of them.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{abscissa,by_hand,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := format('section limit %s (%s of edge %s)', OLD.section_limit_id, OLD.which, OLD.edge_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge WHERE edge_id = %s',
        TG_TABLE_SCHEMA, OLD.edge_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    IF TG_OP = 'DELETE' OR NEW.abscissa IS NULL AND NEW.geom IS NOT DISTINCT FROM OLD.geom
        OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM section_limit_override WHERE axis_id = edge.axis_id AND which = OLD.which
            AND CASE OLD.which WHEN 'start' THEN abscissa >= edge.start_abscissa
            AND abscissa < edge.end_abscissa ELSE abscissa > edge.start_abscissa AND abscissa <= edge.end_abscissa END;
        GET DIAGNOSTICS written = ROW_COUNT;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN written > 0 THEN OLD END;
    END IF;
    node := CASE OLD.which WHEN 'start' THEN edge.from_node ELSE edge.to_node END;
    IF (SELECT count(*) FROM edge e WHERE e.from_node = node) + (SELECT count(*) FROM edge e WHERE e.to_node = node) = 1
        THEN
        PERFORM streetgen._refuse('22023', format('%s cannot be moved', subject),
            detail => 'It lies at a dead end, where no intersection ends.',
            hint => 'Draw the axis shorter or longer in axis_editing.');
    END IF;
    IF NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        NEW.abscissa := ST_LineLocatePoint(edge.geom, NEW.geom) * ST_Length2D(edge.geom);
    END IF;
    SELECT abscissa FROM section_limit WHERE edge_id = OLD.edge_id AND which <> OLD.which INTO other;
    IF NOT NEW.abscissa BETWEEN 0 AND ST_Length2D(edge.geom)
        OR (CASE OLD.which WHEN 'start' THEN NEW.abscissa >= other ELSE NEW.abscissa <= other END) THEN
        PERFORM streetgen._refuse('22023',
            format('%s cannot be at %s m', subject, round(NEW.abscissa::numeric, 2)),
            detail => format('The edge is %s m long and its other limit is at %s m.',
                round(ST_Length2D(edge.geom)::numeric, 2), round(other::numeric, 2)),
            hint => CASE OLD.which WHEN 'start' THEN 'Put it before the other limit.'
                ELSE 'Put it beyond the other limit.' END);
    END IF;
    -- The end of an edge belongs to the next one.
    NEW.abscissa := least(edge.start_abscissa + NEW.abscissa, edge.end_abscissa - 1e-6);
    place := ST_LineInterpolatePoint(edge.axis, least(NEW.abscissa / ST_Length2D(edge.axis), 1));
    SELECT max(section_limit_override_id) FROM section_limit_override WHERE axis_id = edge.axis_id
        AND which = OLD.which AND CASE OLD.which WHEN 'start' THEN abscissa >= edge.start_abscissa
        AND abscissa < edge.end_abscissa ELSE abscissa > edge.start_abscissa AND abscissa <= edge.end_abscissa END
        INTO known;
    IF known IS NULL THEN
        INSERT INTO section_limit_override (axis_id, abscissa, which, geom) VALUES (edge.axis_id, NEW.abscissa,
            OLD.which, place);
    ELSE
        UPDATE section_limit_override SET abscissa = NEW.abscissa, geom = place WHERE section_limit_override_id = known;
    END IF;
    NEW.abscissa := NEW.abscissa - edge.start_abscissa;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_section_limit() IS
    'Trigger of section_limit_editing: writes section_limit_override. A limit beyond its edge or past the other one: '
    '22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._place_of_corner(node geometry, of_a float8, of_b float8, aside float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- The direction in the middle of both, counter-clockwise from the first, in radians.
    SELECT CASE WHEN aside IS NULL THEN node ELSE ST_Translate(node, aside * cos(middle), aside * sin(middle)) END
    FROM (SELECT (of_a + of_b) / 2 - pi() * floor((of_b - of_a) / (2 * pi())) AS middle) m $$;
COMMENT ON FUNCTION streetgen._place_of_corner(geometry, float8, float8, float8) IS
    'The place by which corner_override names a corner between two directions (radians): the node, or metres aside of '
    'it towards the corner, where its axes make another one.';

CREATE OR REPLACE FUNCTION streetgen._edit_corner() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance constant float8 := streetgen._tolerance(TG_TABLE_SCHEMA);
    subject text;
    place record;
    known bigint[];
    -- The youngest that speaks of this corner alone.
    own bigint;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Corners lie between the edges of a node: change the radius of one.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{radius,by_hand,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := 'corner ' || OLD.corner_id;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %1$I.corner JOIN %1$I.edge ON edge_id IN (edge_a, edge_b) WHERE corner_id = %2$s',
        TG_TABLE_SCHEMA, OLD.corner_id));
    SELECT ST_Force2D(n.geom) AS node, a.axis_id AS axis_a, b.axis_id AS axis_b, a.geom AS line_a, b.geom AS line_b,
        CASE c.end_a WHEN 'start' THEN a.width ELSE a.width_end END AS width_a, CASE c.end_b WHEN 'start' THEN b.width
        ELSE b.width_end END AS width_b,
           streetgen._direction_from(a.geom, c.end_a) AS of_a, streetgen._direction_from(b.geom, c.end_b) AS of_b,
           EXISTS (SELECT FROM corner t JOIN edge u ON u.edge_id = t.edge_a
               JOIN edge v ON v.edge_id = t.edge_b WHERE t.node_id = c.node_id AND t.corner_id <> c.corner_id
               AND (u.axis_id, v.axis_id) = (a.axis_id, b.axis_id)) AS twin
    FROM corner c JOIN node n USING (node_id) JOIN edge a ON a.edge_id = c.edge_a
        JOIN edge b ON b.edge_id = c.edge_b
    WHERE corner_id = OLD.corner_id AND EXISTS (SELECT FROM axis x WHERE x.axis_id = a.axis_id)
        AND EXISTS (SELECT FROM axis x WHERE x.axis_id = b.axis_id) INTO place;
    IF place.node IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject),
            detail => 'Its axes do not meet there any more.', hint => 'Refresh the layer.');
    END IF;
    SELECT coalesce(array_agg(corner_override_id), '{}'), max(corner_override_id) FILTER (WHERE NOT place.twin
        OR ST_Distance(geom, place.node) > 0.001) FROM corner_override
        WHERE (axis_a, axis_b) = (place.axis_a, place.axis_b) AND ST_DWithin(geom, place.node, 3 * tolerance)
            AND (NOT place.twin OR streetgen._on_side(geom, place.node, place.of_a, place.of_b)) INTO known, own;
    IF TG_OP = 'DELETE' OR NEW.radius IS NULL AND NEW.geom IS NOT DISTINCT FROM OLD.geom
        OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM corner_override WHERE corner_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    IF NEW.geom IS DISTINCT FROM OLD.geom THEN
        PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
        -- The centre lies a half width and the radius away from both axes; on the roadway there is no arc.
        NEW.radius := greatest(0, (ST_Distance(NEW.geom, place.line_a) - place.width_a / 2 + ST_Distance(NEW.geom,
            place.line_b) - place.width_b / 2) / 2);
    END IF;
    PERFORM streetgen._check_edit_number('the radius of ' || subject, NEW.radius, 0, 200, 'm',
        '0 for no arc; delete the row to take back what was decided by hand.');
    IF own IS NULL THEN
        INSERT INTO corner_override (geom, axis_a, axis_b, radius) VALUES (
            streetgen._place_of_corner(place.node, place.of_a, place.of_b, CASE WHEN place.twin THEN tolerance END),
            place.axis_a, place.axis_b, NEW.radius);
    ELSE
        UPDATE corner_override SET radius = NEW.radius WHERE corner_override_id = own;
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_corner() IS
    'Trigger of corner_editing: writes corner_override, the radius as typed or from where the centre was dragged to. '
    'A radius beyond 0 to 200 m: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._edit_kerb_point() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    axis geometry;
    foot geometry;
    at float8;
    moved constant boolean := NEW.geom IS DISTINCT FROM OLD.geom;
    -- The point as it is now: what this edit leaves alone another session may have changed.
    known record;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        DELETE FROM kerb_point_override WHERE kerb_point_override_id = OLD.kerb_point_id;
        RETURN OLD;
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{axis_id,width,geom}');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := CASE TG_OP WHEN 'INSERT' THEN 'the new kerb point' ELSE 'kerb point ' || OLD.kerb_point_id END;
    PERFORM streetgen._check_edit_geometry(subject, NEW.geom);
    IF NEW.axis_id IS NULL THEN
        NEW.axis_id := streetgen._nearest_axis(TG_TABLE_SCHEMA, NEW.geom);
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %I.kerb_point_override WHERE kerb_point_override_id = %s UNION ALL SELECT %s',
        TG_TABLE_SCHEMA, quote_nullable(OLD.kerb_point_id), quote_nullable(NEW.axis_id)));
    IF TG_OP = 'UPDATE' THEN
        SELECT axis_id, geom FROM kerb_point_override WHERE kerb_point_override_id = OLD.kerb_point_id FOR UPDATE
            INTO known;
        IF known.geom IS NULL THEN
            PERFORM streetgen._refuse('22023', format('%s is gone', subject), detail => 'Another session deleted it.',
                hint => 'Refresh the layer.');
        END IF;
        NEW.axis_id := CASE WHEN NEW.axis_id = OLD.axis_id THEN known.axis_id ELSE NEW.axis_id END;
        NEW.geom := CASE WHEN moved THEN NEW.geom ELSE known.geom END;
    END IF;
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = NEW.axis_id INTO axis;
    IF axis IS NULL THEN
        PERFORM streetgen._refuse('22023', format('the axis of %s is gone', subject),
            detail => format('There is no axis %s.', NEW.axis_id),
            hint => 'Leave axis_id empty to take the nearest axis.');
    END IF;
    at := ST_LineLocatePoint(axis, NEW.geom);
    foot := ST_LineInterpolatePoint(axis, at);
    -- A width that was typed puts the point where it means that width.
    IF NEW.width IS DISTINCT FROM OLD.width AND (TG_OP = 'INSERT' OR NOT moved) THEN
        IF NEW.width IS NULL THEN
            PERFORM streetgen._refuse('22023', format('the width of %s cannot be NULL', subject),
                detail => 'Expected 0.001 to 200 m.', hint => 'Delete the point to take it back.');
        END IF;
        PERFORM streetgen._check_edit_number('the width of ' || subject, NEW.width, 0.001, 200, 'm',
            'Delete the point to take it back.');
        IF ST_Distance(foot, NEW.geom) > 0 THEN
            NEW.geom := ST_SetSRID(ST_MakePoint(ST_X(foot) + (ST_X(NEW.geom) - ST_X(foot)) * NEW.width / 2 /
                ST_Distance(foot, NEW.geom),
                                                ST_Y(foot) + (ST_Y(NEW.geom) - ST_Y(foot)) * NEW.width / 2 /
                                                    ST_Distance(foot, NEW.geom)), ST_SRID(axis));
        END IF;
    END IF;
    NEW.width := 2 * ST_Distance(axis, NEW.geom);
    IF streetgen._metres_beyond(axis, NEW.geom) > 0.01 OR NOT NEW.width BETWEEN 0.001 AND 200 THEN
        PERFORM streetgen._refuse('22023', format('%s lies beside no street', subject),
            detail => format('It is %s m from axis %s%s.', round((NEW.width / 2)::numeric, 2), NEW.axis_id,
                CASE WHEN at IN (0, 1) THEN ', beyond its end' ELSE '' END),
            hint => 'Drop it on the kerb, up to 100 m from an axis and not beyond its end.');
    END IF;
    IF TG_OP = 'INSERT' THEN
        INSERT INTO kerb_point_override (axis_id, geom, abscissa, width) VALUES (NEW.axis_id, NEW.geom, at *
            ST_Length2D(axis), NEW.width) RETURNING kerb_point_override_id INTO NEW.kerb_point_id;
    ELSE
        UPDATE kerb_point_override SET axis_id = NEW.axis_id, geom = NEW.geom, abscissa = (at * ST_Length2D(axis)),
            width = NEW.width WHERE kerb_point_override_id = OLD.kerb_point_id;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_kerb_point() IS
    'Trigger of kerb_point_editing: writes kerb_point_override, the axis being the nearest and the width twice the '
    'distance to it. A point beyond the end of its axis, on it or over 100 m from it: 22023.';

CREATE OR REPLACE FUNCTION streetgen._fill_width() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axis geometry;
    moved constant boolean := (NEW.axis_id, NEW.geom::bytea) IS DISTINCT FROM (OLD.axis_id, OLD.geom::bytea);
BEGIN
    PERFORM streetgen._use_model(TG_TABLE_SCHEMA);
    SELECT ST_Force2D(geom) FROM axis WHERE axis_id = NEW.axis_id INTO axis;
    IF NEW.abscissa IS NULL OR moved AND NEW.abscissa = OLD.abscissa THEN
        NEW.abscissa := coalesce(ST_LineLocatePoint(axis, NEW.geom) * ST_Length(axis), NEW.abscissa);
    END IF;
    IF NEW.width IS NULL OR moved AND NEW.width = OLD.width THEN
        NEW.width := coalesce(2 * ST_Distance(axis, NEW.geom), NEW.width);
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._fill_width() IS
    'Trigger of kerb_point_override: abscissa, and width as twice the distance from the axis, where none is given or '
    'the point moves without it; as they are where the axis is gone.';

CREATE OR REPLACE FUNCTION streetgen._surface_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('section_limit_editing',
        'Edit layer: drag the place where an intersection ends along the axis, or type it; DELETE takes back what '
        'was decided by hand',
        ARRAY['key', 'the edge', 'start or end of the edge', 'metres along the edge; NULL takes it back',
            'decided by hand; false takes it back', 'the place on the edge'],
        $sql$SELECT l.section_limit_id, l.edge_id, l.which, l.abscissa,
            EXISTS (SELECT FROM {model}.section_limit_override o WHERE (o.axis_id, o.which) = (e.axis_id, l.which)
                AND CASE o.which WHEN 'start' THEN o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
                ELSE o.abscissa > e.start_abscissa AND o.abscissa <= e.end_abscissa END) AS by_hand, l.geom
        FROM {model}.section_limit l JOIN {model}.edge e USING (edge_id)$sql$, 'surface'),
    ('corner_editing', 'Edit layer: drag the centre of a corner''s arc or type its radius; DELETE takes back what '
        'was decided by hand',
        ARRAY['key', 'the node', 'radius of the kerb, metres, 0: no arc; NULL takes it back',
            'decided by hand; false takes it back',
            'centre of the arc; where there is none, the place on the kerb where the corner begins'],
        streetgen._part('corner_editing'), 'surface'),
    ('kerb_point_editing', 'Edit layer: drop a point on a kerb, and the width of the nearest axis follows; DELETE '
        'takes it back',
        ARRAY['key; NULL for a new point', 'the axis; NULL: the nearest',
            'width of the axis that the point means, metres', 'the place on the kerb'],
        $sql$SELECT kerb_point_override_id AS kerb_point_id, axis_id, width, geom FROM {model}.kerb_point_override$sql$,
            'surface') $$;
COMMENT ON FUNCTION streetgen._surface_edit_view() IS 'The views in which the roadway is edited.';

CREATE OR REPLACE FUNCTION streetgen._surface_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES
    ('transition_override'::name, 'end', '{axis_id}'::name[], '{tolerance}', jsonb_build_object(
        'kind', 'streetgen._swapped(o.kind, ''left'', ''right'', e.which <> o.which)'), true, 1,
        'ROW(o.which, o.kind, o.length)'),
    ('section_limit_override', 'along', '{axis_id}', '{tolerance}', jsonb_build_object(
        'which', 'streetgen._swapped(o.which, ''start'', ''end'', n.turned)'), true, 2,
        'ROW(o.abscissa, o.which)'),
    ('corner_override', 'node', '{axis_a,axis_b}', '3 * {tolerance}', '{}', true, 3,
        'ROW(o.geom::bytea, o.axis_a, o.axis_b, o.radius)'),
    ('kerb_point_override', 'beside', '{axis_id}', 'width / 2 + {tolerance}', jsonb_build_object(
        'width', '2 * ST_Distance(n.line, n.place)'), true, NULL, NULL) $$;
COMMENT ON FUNCTION streetgen._surface_decision() IS
    'The anchors of decisions about surfaces, and which of their columns follow the axes.';
