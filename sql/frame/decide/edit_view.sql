-- Edit views: what a plain GIS user writes to. Each shows what is there and turns an edit into a change of axes or
-- overrides.

CREATE OR REPLACE FUNCTION streetgen._edit_view(model name, srid integer)
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT v.name, v.description, v.columns, format(v.query, model, srid), v.subject FROM (VALUES
    ('axis_editing', 'Edit layer: draw, reshape, delete axes; width and lanes of a street',
        ARRAY['key; NULL for a new axis', 'the axis of the road', 'width kerb to kerb, metres; NULL: estimated',
            'number of lanes of both directions; NULL: estimated', 'both, direct or reverse',
              'km/h; NULL: estimated', 'importance, 1 the highest; NULL: that of the class', 'name of the street',
                  'level above the ground'],
        $sql$SELECT axis_id, geom, width, lane_count, direction, speed, importance, name, level
            FROM %1$I.axis$sql$, 'network'),
    ('node_editing', 'Edit layer: drag a node, and all axes that meet there follow',
        ARRAY['key', 'place'],
        $sql$SELECT node_id, geom FROM %1$I.node$sql$, 'network'),
    ('edge_editing', 'Edit layer: redraw a piece of an axis between two nodes',
        ARRAY['key', 'the axis that it is a piece of', 'the piece; where its ends move, the axis follows'],
        $sql$SELECT edge_id, axis_id, geom FROM %1$I.edge$sql$, 'network'),
    ('section_limit_editing',
        'Edit layer: drag the place where an intersection ends along the axis, or type it; DELETE takes back what '
        'was decided by hand',
        ARRAY['key', 'the edge', 'start or end of the edge', 'metres along the edge; NULL takes it back',
            'decided by hand; false takes it back', 'the place on the edge'],
        $sql$SELECT l.section_limit_id, l.edge_id, l.which, l.abscissa,
            EXISTS (SELECT FROM %1$I.section_limit_override o WHERE (o.axis_id, o.which) = (e.axis_id, l.which)
                AND CASE o.which WHEN 'start' THEN o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa
                ELSE o.abscissa > e.start_abscissa AND o.abscissa <= e.end_abscissa END) AS by_hand, l.geom
        FROM %1$I.section_limit l JOIN %1$I.edge e USING (edge_id)$sql$, 'surface'),
    ('corner_editing', 'Edit layer: drag the centre of a corner''s arc or type its radius; DELETE takes back what '
        'was decided by hand',
        ARRAY['key', 'the node', 'radius of the kerb, metres, 0: no arc; NULL takes it back',
            'decided by hand; false takes it back',
            'centre of the arc; where there is none, the place on the kerb where the corner begins'],
        $sql$SELECT c.corner_id, c.node_id, c.radius,
            EXISTS (SELECT FROM %1$I.corner_override o WHERE (o.axis_a, o.axis_b) = (a.axis_id, b.axis_id)
                AND ST_DWithin(o.geom, n.geom, 3 * (SELECT value::float8 FROM %1$I.setting WHERE name = 'tolerance'))
                AND (streetgen._on_side(o.geom, n.geom, of_a, of_b) OR NOT EXISTS (SELECT FROM %1$I.corner t
                    JOIN %1$I.edge u ON u.edge_id = t.edge_a JOIN %1$I.edge v ON v.edge_id = t.edge_b
                    WHERE t.node_id = c.node_id AND t.corner_id <> c.corner_id
                        AND (u.axis_id, v.axis_id) = (a.axis_id, b.axis_id)))) AS by_hand,
            c.geom
        FROM (SELECT *, centre AS geom FROM %1$I.corner WHERE centre IS NOT NULL
              UNION ALL SELECT k.*, CASE l.which WHEN 'start' THEN ST_StartPoint(l.border_line)
                  ELSE ST_EndPoint(l.border_line) END::geometry(Point, %2$s)
              FROM %1$I.corner k JOIN %1$I.section_limit l ON (l.edge_id, l.which) = (k.edge_a, k.end_a)
                  WHERE k.centre IS NULL) c
        JOIN %1$I.node n USING (node_id) JOIN %1$I.edge a ON a.edge_id = c.edge_a
            JOIN %1$I.edge b ON b.edge_id = c.edge_b
        CROSS JOIN LATERAL (SELECT streetgen._direction_from(a.geom, c.end_a) AS of_a,
            streetgen._direction_from(b.geom, c.end_b) AS of_b) d$sql$, 'surface'),
    ('kerb_point_editing', 'Edit layer: drop a point on a kerb, and the width of the nearest axis follows; DELETE '
        'takes it back',
        ARRAY['key; NULL for a new point', 'the axis; NULL: the nearest',
            'width of the axis that the point means, metres', 'the place on the kerb'],
        $sql$SELECT kerb_point_override_id AS kerb_point_id, axis_id, width, geom FROM %1$I.kerb_point_override$sql$,
            'surface'),
    ('road_arc_editing', 'Edit layer: drag the centre of a bend or type its radius; DELETE takes back what was '
        'decided by hand',
        ARRAY['key', 'the axis', 'where it bends, metres along the axis',
            'radius of the bend, metres, 0: it is sharp; NULL takes it back',
            'decided by hand; false takes it back', 'centre of the arc; of a sharp bend its place'],
        streetgen._road_arc_handles(), 'alignment'),
    ('lane_editing', 'Edit layer: flip a lane, open it to both directions, redraw it, give it a width of its own; '
        'DELETE takes back what was decided by hand',
        ARRAY['key', 'the edge', 'number from the middle outwards',
            'does traffic run in the direction of the axis; NULL takes it back',
            'do both directions use it; NULL takes it back',
            'width, metres, that of the roadway at most; NULL takes it back',
            'decided by hand; false takes it back',
            'centre line, in the direction of the axis'],
        $sql$SELECT l.lane_id, l.edge_id, l.ordinality, l.along_axis, l.both_ways, l.width,
            EXISTS (SELECT FROM %1$I.lane_override o WHERE (o.axis_id, o.ordinality) = (e.axis_id, l.ordinality)
                AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa) AS by_hand, l.geom
        FROM %1$I.lane l JOIN %1$I.edge e USING (edge_id)$sql$, 'lane'),
    ('sidewalk_editing',
        'Edit layer: type the width of the sidewalk on one side of an edge, which has a row for each piece of its '
        'kerb: the width is that of all; DELETE takes back what was decided by hand',
        ARRAY['key', 'the edge', 'left or right', 'width, metres; 0: none; NULL takes it back',
            'decided by hand; false takes it back',
            'its ground'],
        $sql$SELECT s.sidewalk_id, s.edge_id, s.side, s.width,
            EXISTS (SELECT FROM %1$I.sidewalk_override o WHERE (o.axis_id, o.side) = (e.axis_id, s.side)
                AND o.abscissa >= e.start_abscissa AND o.abscissa < e.end_abscissa) AS by_hand, s.surface AS geom
        FROM %1$I.sidewalk s JOIN %1$I.edge e USING (edge_id) WHERE s.side IN ('left', 'right')$sql$, 'sidewalk'),
    ('lane_adjacency_editing', 'Edit layer: say whether traffic may change from a lane to the one beside it; DELETE '
        'takes back what was decided by hand',
        ARRAY['key', 'the lane that one leaves', 'the lane beside it', 'on which side of lane_a, left or right along '
            'the axis', 'allowed or forbidden; opposite where traffic comes against one; NULL takes it back',
            'decided by hand; false takes it back', 'the line between them'],
        $sql$SELECT lane_adjacency_id, lane_a, lane_b, side, change, by_hand, geom
        FROM %1$I.lane_adjacency$sql$, 'lane'),
    ('junction_editing', 'Edit layer: say what kind of junction a place is; DELETE takes back what was decided by hand',
        ARRAY['key', 'ramp, signals, stop, priority, right_before_left, roundabout, continuation or end; '
            'NULL takes it back', 'decided by hand; false takes it back', 'the middle of its nodes'],
        $sql$SELECT j.junction_id, j.kind, j.method = 'by_hand' AS by_hand, j.geom
        FROM %1$I.junction j$sql$, 'junction'),
    ('junction_edge_editing', 'Edit layer: say whether an edge lies inside a junction: what is at its ends is one '
        'junction, or two; DELETE takes back what was decided by hand',
        ARRAY['key', 'does it lie inside a junction; NULL takes it back',
            'decided by hand; false takes it back', 'the edge'],
        $sql$SELECT e.edge_id, EXISTS (SELECT FROM %1$I.junction_edge j WHERE j.edge_id = e.edge_id) AS inside,
            EXISTS (SELECT FROM %1$I.junction_override o WHERE o.axis_id = e.axis_id AND o.inside IS NOT NULL
                -- As streetgen._edge_at, but by no name, which may change before the model is adopted.
                AND e.edge_id = (SELECT n.edge_id FROM %1$I.edge n WHERE n.axis_id = o.axis_id
                    ORDER BY ST_Distance(n.geom, o.geom), n.edge_id LIMIT 1)) AS by_hand, e.geom
        FROM %1$I.edge e$sql$, 'junction'),
    ('controller_editing', 'Edit layer: type program, cycle, offset or durations of signals; DELETE takes back what '
        'was decided by hand',
        ARRAY['key', 'phases, paper, or a function; NULL takes it back', 'seconds; NULL takes it back',
            'seconds after which a cycle begins; NULL takes it back', 'seconds of each state; NULL takes them back',
            'decided by hand; false takes it back', 'the junction'],
        $sql$SELECT c.controller_id, c.program, c.cycle, c.start_offset,
            ARRAY(SELECT s.duration FROM %1$I.signal_state s WHERE s.controller_id = c.controller_id
                ORDER BY s.ordinality) AS durations, c.method = 'by_hand' AS by_hand, c.geom
        FROM %1$I.controller c$sql$, 'signal'),
    ('ramp_editing', 'Edit layer: type the tangent of a ramp or the length of its merging lanes; DELETE takes back '
        'what was decided by hand',
        ARRAY['key', 'the link', 'on or off the highway',
            'metres before and behind the bend into its lane; NULL takes it back',
            'metres that merging lanes keep their width, as typed or computed; 0: none; NULL takes it back',
            'decided by hand; false takes it back', 'its node'],
        -- The length typed, also where an auxiliary lane goes on beyond it or the next junction cuts it.
        $sql$SELECT r.ramp_id, e.axis_id, r.kind, r.tangent, coalesce(d.length, r.length) AS length,
            r.method = 'by_hand' AS by_hand, r.geom
        FROM %1$I.ramp r JOIN %1$I.edge e USING (edge_id) LEFT JOIN LATERAL (
            SELECT o.length FROM %1$I.ramp_override o WHERE o.axis_id = e.axis_id AND o.length IS NOT NULL
                AND o.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
                AND (2 * o.abscissa <= e.start_abscissa + e.end_abscissa) = (e.from_node = r.node_id)
            ORDER BY o.ramp_override_id DESC LIMIT 1) d ON r.method = 'by_hand'$sql$, 'ramp'),
    ('overpass_editing', 'Edit layer: type which axis passes over, or the clearance; DELETE takes back what was '
        'decided by hand',
        ARRAY['key', 'axis that passes over: the other one swaps them', 'axis below; type axis_above to swap',
            'from roadway to roadway, metres; NULL takes back what was decided',
            'decided by hand; false takes it back', 'the crossing'],
        $sql$SELECT o.overpass_id, a.axis_id AS axis_above, b.axis_id AS axis_below, o.clearance,
            o.method = 'by_hand' AS by_hand, o.geom
        FROM %1$I.overpass o JOIN %1$I.edge a ON a.edge_id = o.edge_above
            JOIN %1$I.edge b ON b.edge_id = o.edge_below$sql$, 'overpass'),
    ('height_editing', 'Edit layer: drop a point on a road and type how high it lies there at least; DELETE takes it '
        'back',
        ARRAY['key', 'the axis: the nearest one where left out', 'height, metres', 'the place on the axis'],
        $sql$SELECT height_override_id AS height_id, axis_id, height, geom FROM %1$I.height_override$sql$, 'height'),
    ('street_object_editing', 'Edit layer: drop, drag or turn an object; type where it stands. It follows its axis',
        ARRAY['key; NULL for a new object', 'what it is', 'where it stands', 'absolute, axis or border; NULL for a new '
            'one: by the place', 'the axis; NULL: the nearest', 'metres along the axis', 'left or right, of a '
            'placement by the border', 'metres to the left of the axis, or away '
            'from the border', 'degrees clockwise from the axis, or from the north', 'axis or absolute',
            'direction, degrees clockwise from the north; type orientation to turn it',
            'computed: absolute, relative or orphaned'],
        $sql$SELECT street_object_id, type, geom::geometry(Point, %2$s) AS geom, placement, axis_id, abscissa, side,
            axis_offset, orientation, orientation_kind, angle, method
        FROM %1$I.street_object WHERE abscissa_end IS NULL AND ST_Dimension(geom) = 0$sql$, 'object'),
    ('pedestrian_crossing_editing', 'Edit layer: drop or drag a pedestrian crossing; type its width and its angle',
        ARRAY['key; NULL for a new crossing', 'its middle on the axis', 'the axis; NULL: the nearest',
            'metres along the axis', 'metres along the street; NULL: 4',
            'degrees counter-clockwise from the axis to the way across; NULL: 90'],
        $sql$SELECT c.street_object_id, o.geom::geometry(Point, %2$s) AS geom, o.axis_id, o.abscissa, c.width, c.angle
        FROM %1$I.pedestrian_crossing c JOIN %1$I.street_object o USING (street_object_id)$sql$, 'object'),
    ('parking_bay_editing', 'Edit layer: drop or drag a parking bay; type its size and its angle',
        ARRAY['key; NULL for a new bay', 'the middle of its end at the border', 'the axis; NULL: the nearest',
            'metres along the axis', 'left or right', 'metres away from the border; negative on the roadway',
            'metres; NULL: 5', 'metres; NULL: 2.3', 'degrees: 0 or NULL parallel to the border, 90 perpendicular'],
        $sql$SELECT b.street_object_id, o.geom::geometry(Point, %2$s) AS geom, o.axis_id, o.abscissa, o.side,
            o.axis_offset, b.length, b.width, b.angle
        FROM %1$I.parking_bay b JOIN %1$I.street_object o USING (street_object_id)$sql$, 'object'),
    ('roundabout_editing', 'Edit layer: confirm that a ring is a roundabout, or that it is none; the least certain '
        'come first; DELETE takes back what was decided by hand',
        ARRAY['key', 'is it a roundabout; NULL: as its score says', 'ring, mini, double or peanut', 'radius, metres',
            'score, 0 to 1', 'how far its score is from setting roundabout_accept', 'does traffic go round',
            'the ring'],
        $sql$SELECT r.roundabout_id, r.confirmed, r.kind, r.radius, r.score,
            abs(r.score - (SELECT value::float8 FROM %1$I.setting WHERE name = 'roundabout_accept')) AS nearness,
            r.accepted, r.geom
        FROM %1$I.roundabout r ORDER BY nearness, r.roundabout_id$sql$, 'roundabout'),
    ('interconnection_editing',
        'Edit layer: say whether a lane goes on to another, or drag the middle point of its path; DELETE takes back '
        'what was decided by hand',
        ARRAY['key', 'the node', 'the lane that comes in', 'the lane that goes out', 'through, left, right or u_turn',
            'does it connect; NULL takes it back', 'would traffic take it', 'decided by hand; false takes it back',
            'start, control point and end of the path'],
        $sql$SELECT c.interconnection_id, c.node_id, c.lane_in, c.lane_out, c.turn, c.connecting, c.plausible,
            c.method = 'by_hand' AS by_hand,
            ST_MakeLine(ARRAY[ST_StartPoint(c.geom), coalesce(c.control, ST_LineInterpolatePoint(c.geom, 0.5)),
                ST_EndPoint(c.geom)])::geometry(LineString, %2$s) AS geom
        FROM %1$I.interconnection c$sql$, 'interconnection'),
    ('block_editing', 'Edit layer: say what kind of block a piece of ground is; DELETE takes back what was decided by '
        'hand',
        ARRAY['key', 'block, island or strip; NULL takes it back', 'decided by hand; false takes it back',
            'the ground'],
        $sql$SELECT b.block_id, b.kind, EXISTS (SELECT FROM %1$I.block_override o WHERE o.geom && b.surface
                AND ST_Intersects(o.geom, b.surface)) AS by_hand, b.surface AS geom
            FROM %1$I.block b$sql$, 'block')) v(name, description, columns, query, subject) $$;
COMMENT ON FUNCTION streetgen._edit_view(name, integer) IS
    'The edit views of a model: their comments, those of their columns, and their queries.';

CREATE OR REPLACE FUNCTION streetgen._make_edit_indexes(model name, srid integer) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    -- On the very expressions of the views, and of _reach.
    EXECUTE format($sql$
CREATE INDEX IF NOT EXISTS corner_centre ON %1$I.corner USING gist (centre);
CREATE INDEX IF NOT EXISTS section_limit_kerb ON %1$I.section_limit
    USING gist ((CASE which WHEN 'start' THEN ST_StartPoint(border_line)
    ELSE ST_EndPoint(border_line) END::geometry(Point, %2$s)));
CREATE INDEX IF NOT EXISTS report_collapsed ON %1$I.report USING gist (ST_Expand(geom, measure))
    WHERE issue = 'collapsed_axis';
CREATE INDEX IF NOT EXISTS report_other ON %1$I.report (axis_b)
$sql$, model, srid);
    IF 'interconnection' = ANY (streetgen._subjects(model)) THEN
        EXECUTE format($sql$
CREATE INDEX IF NOT EXISTS interconnection_handle ON %1$I.interconnection USING gist ((ST_MakeLine(ARRAY[
    ST_StartPoint(geom), coalesce(control, ST_LineInterpolatePoint(geom, 0.5)),
        ST_EndPoint(geom)])::geometry(LineString, %2$s)))
$sql$, model, srid);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_edit_indexes(name, integer) IS
    'Makes the indexes by which a GIS finds rows of corner_editing and interconnection_editing in its window, and an '
    'edit axes too short for an edge and reports of an axis.';

CREATE OR REPLACE FUNCTION streetgen._direction_from(line geometry, which text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        SELECT pi() / 2 - CASE which WHEN 'start'
            THEN ST_Azimuth(ST_StartPoint(line), ST_LineInterpolatePoint(line, 1 / greatest(ST_Length2D(line), 1)))
                                     ELSE ST_Azimuth(ST_EndPoint(line),
                                         ST_LineInterpolatePoint(line, 1 - 1 / greatest(ST_Length2D(line), 1))) END;
    END;
COMMENT ON FUNCTION streetgen._direction_from(geometry, text) IS
    'Direction in which a line leaves its start or end, over 1 m: radians counter-clockwise from the east.';

CREATE OR REPLACE FUNCTION streetgen._on_side(place geometry, node geometry, of_a float8, of_b float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Distance(place, node) <= 0.001
        OR to_place - 2 * pi() * floor(to_place / (2 * pi())) <= to_b - 2 * pi() * floor(to_b / (2 * pi()))
    FROM (SELECT pi() / 2 - ST_Azimuth(node, place) - of_a AS to_place, of_b - of_a AS to_b) t
    $$;
COMMENT ON FUNCTION streetgen._on_side(geometry, geometry, float8, float8) IS
    'Whether a place lies at a node, within 1 mm, or beside it counter-clockwise from one direction to the other '
    '(radians).';

CREATE OR REPLACE FUNCTION streetgen._make_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    layer record;
    attribute record;
BEGIN
    FOR layer IN SELECT v.* FROM streetgen.model m, streetgen._edit_view(m.name, m.srid) v,
        unnest(streetgen._subjects(model)) computed WHERE m.name = model AND v.subject = computed
    LOOP
        -- By its registry the view hangs on the extension: both go together.
        EXECUTE format('CREATE OR REPLACE VIEW %I.%I WITH (security_invoker = true) AS SELECT * FROM (%s) v WHERE '
            'EXISTS (SELECT FROM streetgen.model)', model, layer.name, layer.query);
        EXECUTE format('COMMENT ON VIEW %I.%I IS %L', model, layer.name, layer.description);
        FOR attribute IN SELECT attname, attnum FROM pg_attribute
            WHERE attrelid = format('%I.%I', model, layer.name)::regclass AND attnum > 0 LOOP
            EXECUTE format('COMMENT ON COLUMN %I.%I.%I IS %L', model, layer.name, attribute.attname,
                layer.columns[attribute.attnum]);
        END LOOP;
        EXECUTE format('CREATE OR REPLACE TRIGGER edit INSTEAD OF INSERT OR UPDATE OR DELETE ON %I.%I FOR EACH ROW '
            'EXECUTE FUNCTION streetgen.%I()',
            model, layer.name, '_edit_' || replace(layer.name, '_editing', ''));
        EXECUTE format('COMMENT ON TRIGGER edit ON %I.%I IS %L', model, layer.name,
            'Turns an edit into a change of axes or overrides');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_edit_views(name) IS
    'Makes the edit views of a model and their triggers, again and again.';

CREATE OR REPLACE FUNCTION streetgen._grant_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    held record;
BEGIN
    FOR held IN SELECT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END AS role,
        privilege_type AS privilege, v.name AS view
        FROM pg_class c, aclexplode(c.relacl)
            JOIN streetgen._edit_view('m', 0) v ON true
            JOIN unnest(streetgen._subjects(model)) computed ON computed = v.subject
        WHERE c.oid = format('%I.axis', model)::regclass AND grantee <> c.relowner
            AND privilege_type IN ('SELECT', 'INSERT', 'UPDATE', 'DELETE')
    LOOP
        EXECUTE format('GRANT %s ON %I.%I TO %s', held.privilege, model, held.view, held.role);
        EXECUTE format('GRANT SELECT ON %1$I.edit_log, %1$I.override_place TO %2$s', model, held.role);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._grant_edit_views(name) IS
    'Who may read or write the axes of a model may do so with its edit views, and read its log.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_number(subject text, value float8, minimum float8, maximum float8,
    unit text, way_out text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT value BETWEEN minimum AND maximum THEN
        PERFORM streetgen._refuse('22023', format('%s cannot be %s', subject, value),
            detail => concat_ws(' ', 'Expected', minimum, 'to', maximum, unit) || '.', hint => way_out);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_number(text, float8, float8, float8, text, text) IS
    'Raises 22023 for a value of an edit beyond its range, or NaN; NULL passes.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_word(subject text, value text, relation name, attribute name)
    RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    expected text;
BEGIN
    SELECT r.expected FROM streetgen._input_rule() r WHERE (r.relation, r.attribute) = ($3, $4) INTO expected;
    IF value <> ALL (regexp_split_to_array(expected, ', | or ')) THEN
        PERFORM streetgen._refuse('23514', format('the %s of %s cannot be %s', attribute, subject, to_json(value)),
            detail => format('Expected %s.', expected), hint => 'NULL takes back what was decided by hand.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_word(text, text, name, name) IS
    'Raises 23514 for a word of an edit that is none of those that a column of an override table takes, naming the row '
    'of the view; NULL passes.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_geometry(subject text, geom geometry) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF geom IS NULL OR ST_IsEmpty(geom) THEN
        PERFORM streetgen._refuse('22023', format('%s has no place', subject),
            detail => 'Its geometry is NULL or empty.', hint => 'Draw it again, or undo the edit.');
    ELSIF EXISTS (SELECT FROM ST_DumpPoints(geom) p
                  WHERE NOT (ST_X(p.geom) BETWEEN -1e12 AND 1e12 AND ST_Y(p.geom) BETWEEN -1e12 AND 1e12
                      AND coalesce(ST_Z(p.geom) BETWEEN -1e12 AND 1e12, true))) THEN
        PERFORM streetgen._refuse('22023', format('%s has a coordinate that is no place', subject),
            detail => 'A coordinate is NaN, infinite or beyond 1e12.', hint => 'Draw it again, or undo the edit.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_geometry(text, geometry) IS
    'Raises 22023 for a geometry of an edit that is NULL, empty or not finite.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_line(subject text, line geometry, tolerance float8) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_edit_geometry(subject, line);
    IF ST_Length2D(line) <= tolerance OR NOT EXISTS (SELECT FROM ST_DumpPoints(line) p
        WHERE NOT ST_DWithin(p.geom, ST_StartPoint(line), tolerance)) THEN
        PERFORM streetgen._refuse('22023', format('%s would collapse to a point', subject),
            detail => format('It would stay within the tolerance of %s m.', tolerance),
            hint => 'Put its points farther apart, or delete the axis.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_line(text, geometry, float8) IS
    'Raises 22023 for a line of an edit that is NULL, empty, not finite or within the tolerance of its start.';

CREATE OR REPLACE FUNCTION streetgen._refuse_edit(relation name, operation text, way_out text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('0A000', format('%s of %s is not possible', operation, relation),
        detail => 'Its rows are computed from axes and overrides.', hint => way_out);
END $$;
COMMENT ON FUNCTION streetgen._refuse_edit(name, text, text) IS
    'Raises 0A000 for an edit that means nothing, with the way to go instead.';

CREATE OR REPLACE FUNCTION streetgen._edited_row(view regclass, former anyelement, edited anyelement, editable name[],
    way_out text DEFAULT NULL) RETURNS anyelement
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns constant name[] := ARRAY(SELECT attname FROM pg_attribute WHERE attrelid = view AND attnum > 0
        ORDER BY attnum);
    key text;
    fixed text;
    emptied boolean;
BEGIN
    EXECUTE format('SELECT ($1).%I::text, concat_ws('', '', %s), %s', columns[1],
        (SELECT string_agg(format('CASE WHEN ($1).%1$I IS DISTINCT FROM ($2).%1$I THEN %1$L END', c), ', ')
            FROM unnest(columns) c WHERE c <> ALL (editable)),
        CASE WHEN 'by_hand' = ANY (editable) THEN '($2).by_hand IS NULL' ELSE 'false' END)
        INTO key, fixed, emptied USING former, edited;
    IF fixed <> '' THEN
        PERFORM streetgen._refuse('0A000', format('the %s of %s %s cannot be changed', fixed,
                (SELECT replace(replace(relname, '_editing', ''), '_', ' ') FROM pg_class WHERE oid = view), key),
            detail => 'It is a key, or computed.',
            hint => concat_ws(' ', 'Only', array_to_string(editable[:cardinality(editable) - 1], ', ') || ' and',
                editable[cardinality(editable)], 'can be changed.', way_out));
    END IF;
    -- Who empties by_hand means that nothing is decided.
    RETURN CASE WHEN emptied THEN jsonb_populate_record(edited, '{"by_hand": false}') ELSE edited END;
END $$;
COMMENT ON FUNCTION streetgen._edited_row(regclass, anyelement, anyelement, name[], text) IS
    'The row of an edit view as an UPDATE wants it, by_hand NULL as false. A change of the key or of what is computed: '
    '0A000, naming row and columns, those that can be changed, and the way out.';

CREATE OR REPLACE FUNCTION streetgen._edit_axis_of(model name, subject text, edge bigint) RETURNS record
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT e.*, ST_Force2D(a.geom) AS axis FROM edge e JOIN axis a USING (axis_id) WHERE edge_id = edge INTO place;
    IF place.edge_id IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s lies on an axis that is gone', subject),
            detail => format('Edge %s has no axis any more.', edge),
            hint => format('Refresh the layer; if it is still there, SELECT * FROM streetgen.generate(%L).', model));
    END IF;
    RETURN place;
END $$;
COMMENT ON FUNCTION streetgen._edit_axis_of(name, text, bigint) IS
    'The edge of what is edited, with the line of its axis; 22023 where the axis is gone.';
