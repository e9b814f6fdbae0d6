-- Rules of check_model for objects.

CREATE OR REPLACE FUNCTION streetgen._crowding_objects(model name)
    RETURNS TABLE(street_object_id bigint, geom geometry, type text, source text, source_ref text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    SELECT o.street_object_id, o.geom, o.type, o.source, o.source_ref
    FROM street_object o JOIN object_type t USING (type)
    WHERE o.placed_by <> 'rule' AND t.distance_least > 0 AND EXISTS (SELECT FROM street_object p
        WHERE p.placed_by <> 'rule' AND p.street_object_id <> o.street_object_id
            AND ST_DWithin(p.geom, o.geom, t.distance_least));
END $$;
COMMENT ON FUNCTION streetgen._crowding_objects(name) IS
    'The objects of users and imports that stand nearer to another such one than distance_least of their type.';

CREATE OR REPLACE FUNCTION streetgen._hindered_objects(model name)
    RETURNS TABLE(street_object_id bigint, geom geometry, hindrance text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    -- What is a control point stands where its traffic obeys it, as on the axis.
    WITH standing AS MATERIALIZED (
        SELECT o.street_object_id, o.geom, ROW (o.type, o.geom, coalesce(e.level, 0),
            CASE o.placement WHEN 'border' THEN o.axis_offset END,
            o.placement = 'border' AND o.method = 'relative' AND coalesce(r.along, 'border') <> 'arm',
            o.street_object_id)::streetgen.standing_place AS place, row_number() OVER () AS number
        FROM street_object o LEFT JOIN object_edge USING (street_object_id) LEFT JOIN edge e USING (edge_id)
            LEFT JOIN placement_rule r ON r.rule_id = o.rule_id
        WHERE ST_Dimension(o.geom) = 0 AND o.control_point_id IS NULL)
    SELECT DISTINCT s.street_object_id, s.geom, h.hindrance
    FROM _hindrances((SELECT array_agg(place ORDER BY number) FROM standing)) h JOIN standing s USING (number);
END $$;
COMMENT ON FUNCTION streetgen._hindered_objects(name) IS
    'The objects that stand where a rule would place none, with what is in the way: those by hand and imported ones '
    'stay.';

CREATE OR REPLACE FUNCTION streetgen._check_object(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
    rings bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'warning', 'object whose axis is gone', 'street_object', o.street_object_id, NULL::float8, o.geom
        FROM street_object o WHERE o.method = 'orphaned'
    UNION ALL
    -- An orphan is told above.
    SELECT 'warning', 'pedestrian crossing without its roadway', 'pedestrian_crossing', o.street_object_id,
        NULL::float8, o.geom FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
        WHERE c.surface IS NULL AND o.method <> 'orphaned'
    UNION ALL
    SELECT 'notice', 'refuge without room, m', 'pedestrian_crossing', o.street_object_id, c.refuge, o.geom
        FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
            JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id)
        WHERE c.island IS NULL AND c.surface IS NOT NULL
            AND (c.refuge > 0 OR c.refuge IS NULL AND EXISTS (SELECT FROM control_point p WHERE p.refuge = 'yes'
                AND (p.control_point_id = o.control_point_id OR o.control_point_id IS NULL
                    AND p.kind = 'pedestrian_crossing' AND ST_DWithin(p.geom, o.geom, 1))))
            AND (e.lanes_both > 0 OR e.lanes_forward > 0 AND e.lanes_backward > 0)
    UNION ALL
    SELECT 'warning', 'parking bay without its ground', 'parking_bay', o.street_object_id, NULL::float8, o.geom
        FROM parking_bay b JOIN street_object o USING (street_object_id)
        WHERE b.surface IS NULL AND o.method <> 'orphaned'
    UNION ALL
    SELECT 'notice', 'placement rule for a kind that no street has', 'placement_rule', rule_id, NULL::float8,
        NULL::geometry FROM placement_rule r WHERE EXISTS (SELECT FROM unnest(r.kind) k
            WHERE NOT EXISTS (SELECT FROM axis_class c WHERE c.class = k)
                AND NOT EXISTS (SELECT FROM axis a WHERE a.kind = k))
    UNION ALL
    SELECT 'notice', 'placement rule along lanes, which the model does not compute', 'placement_rule', rule_id,
        NULL::float8, NULL::geometry FROM placement_rule WHERE active AND along = 'lane' AND to_regclass('lane') IS NULL
    UNION ALL
    SELECT 'notice', 'object nearer to another one than distance_least', 'street_object', street_object_id,
        NULL::float8, geom FROM streetgen._crowding_objects(model)
    UNION ALL
    SELECT 'notice', CASE hindrance WHEN 'roadway' THEN 'object in a roadway' WHEN 'bay' THEN 'object in a parking bay'
            WHEN 'mouth' THEN 'object in the mouth of a crossing'
            WHEN 'sight' THEN 'object in the sight of a stop or yield line'
            WHEN 'no_kerb' THEN 'object beside no kerb' WHEN 'median' THEN 'tree on a narrow median'
            WHEN 'underground' THEN 'object on a level below the ground'
            WHEN 'near' THEN 'object nearer to another one than object_distance' END, 'street_object',
        street_object_id, NULL::float8, geom FROM streetgen._hindered_objects(model)
    UNION ALL
    SELECT 'error', 'object off the place that its axis gives, m', 'street_object', o.street_object_id,
        ST_Distance(o.geom, g.geom), o.geom
        FROM street_object o JOIN axis_used a USING (axis_id)
            LEFT JOIN streetgen._axis_borders(model, NULL) b USING (axis_id),
            LATERAL (SELECT streetgen._object_geometry(ST_Force2D(a.geom), a.width, a.width_end, a.roadway_offset,
                b.borders, o.abscissa, o.abscissa_end, o.side, o.axis_offset) AS geom) g
        WHERE o.method = 'relative' AND ST_Distance(o.geom, g.geom) > 1e-3
    UNION ALL
    SELECT 'notice', 'parking bay on a crossing or an intersection', 'parking_bay', b.street_object_id, NULL::float8,
        b.surface FROM parking_bay b JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id)
        WHERE EXISTS (SELECT FROM intersection i WHERE i.surface && b.surface AND i.level - e.level = 0
                AND streetgen._takes_ground(i.surface, b.surface))
            OR EXISTS (SELECT FROM pedestrian_crossing c WHERE c.surface && b.surface
                AND streetgen._takes_ground(c.surface, b.surface))
    UNION ALL SELECT 'notice', 'parking bay on another bay', 'parking_bay', b.street_object_id, NULL::float8, b.surface
        FROM parking_bay a JOIN parking_bay b ON a.surface && b.surface
            AND a.street_object_id < b.street_object_id AND streetgen._takes_ground(a.surface, b.surface)
    UNION ALL
    SELECT 'notice', CASE t.what WHEN 'lane' THEN 'parking bay on a lane for others'
            WHEN 'narrow' THEN 'parking bay that narrows a lane, m'
            WHEN 'roadway' THEN 'parking bay that leaves a narrow roadway, m' END, 'parking_bay', b.street_object_id,
        t.measure, p.surface FROM _judged_bays() b JOIN parking_bay p USING (street_object_id),
            (SELECT value::float8 AS least_lane FROM setting WHERE name = 'lane_width_minimal') s, LATERAL (VALUES
            ('lane', NULL::float8, on_lane), ('narrow', narrowest, narrowest < least_lane - 1e-6),
            ('roadway', remains, remains < needed - 1e-6)) t(what, measure, told)
        WHERE t.told
    UNION ALL
    SELECT 'notice', 'parking lane too narrow for bays, m', 'edge', e.edge_id, p.depth, e.geom
        FROM _parking_lanes(CASE WHEN EXISTS (SELECT FROM placement_rule WHERE active AND along = 'lane')
            THEN ARRAY(SELECT edge_id FROM edge) ELSE '{}' END) p JOIN edge e USING (edge_id)
        WHERE p.depth < streetgen._least_bay_depth()
    UNION ALL
    SELECT 'notice', 'fewer parking bays than the source says', 'axis', a.axis_id, p.cars - b.bays, a.geom
        FROM axis a, LATERAL (VALUES ('left', a.parking_left), ('right', a.parking_right)) v(side, said), LATERAL (
            SELECT streetgen._parking_capacity(said)::float8 AS cars, split_part(said, '|', 1) AS place) p, LATERAL (
            SELECT count(*) AS bays FROM street_object o JOIN parking_bay b USING (street_object_id)
            WHERE o.axis_id = a.axis_id AND o.side = v.side AND o.method = 'relative' AND b.surface IS NOT NULL) b
        WHERE EXISTS (SELECT FROM placement_rule WHERE active AND along = 'lane')
            AND CASE WHEN p.cars IS NULL THEN p.place NOT IN ('no', 'lane') AND b.bays = 0 ELSE b.bays < p.cars END
    UNION ALL SELECT 'error', 'object on an axis that is not there', 'street_object', o.street_object_id, NULL::float8,
        o.geom
        FROM street_object o WHERE o.method = 'relative' AND NOT EXISTS (SELECT FROM axis a
            WHERE a.axis_id = o.axis_id)
    UNION ALL SELECT 'error', 'row of object_edge whose object or edge is gone', 'object_edge', street_object_id,
        NULL::float8, coalesce(o.geom, e.geom)
        FROM object_edge LEFT JOIN street_object o USING (street_object_id) LEFT JOIN edge e USING (edge_id)
        WHERE o.street_object_id IS NULL OR e.edge_id IS NULL
    LOOP
        RETURN NEXT finding;
    END LOOP;
    IF to_regclass(format('%I.sidewalk', model)) IS NOT NULL THEN
        RETURN QUERY SELECT 'notice', 'parking bay that leaves a narrow sidewalk, m', 'parking_bay',
            b.street_object_id, w.width - o.axis_offset, b.surface
        FROM parking_bay b JOIN street_object o USING (street_object_id) JOIN object_edge USING (street_object_id)
            JOIN sidewalk w USING (edge_id)
        WHERE b.surface IS NOT NULL AND o.axis_offset > 0 AND o.side = w.side AND w.node_id IS NULL
            AND w.strip && b.surface AND ST_Intersects(w.strip, b.surface)
            AND w.width - o.axis_offset < streetgen._walking_width() - 1e-6;
        RETURN QUERY SELECT 'error', 'sidewalk under a parking bay, m2', 'sidewalk', w.sidewalk_id,
            sum(ST_Area(ST_Intersection(w.surface, b.surface))), w.surface::geometry
        FROM parking_bay b JOIN street_object o USING (street_object_id) JOIN axis a USING (axis_id)
            JOIN sidewalk w ON w.surface && b.surface
            JOIN kerb k ON (k.edge_id, k.side, k.part) = (w.edge_id, w.side, w.part)
        WHERE (o.side IS NULL OR o.axis_offset > 0.01) AND k.level = a.level
            AND streetgen._takes_ground(w.surface, b.surface)
        GROUP BY w.sidewalk_id;
    END IF;
    IF to_regclass(format('%I.marking', model)) IS NOT NULL THEN
        rings := streetgen._edges_on_rings(model, NULL);
        RETURN QUERY SELECT 'warning', CASE m.kind WHEN 'arrow' THEN 'arrow on a crossing'
            ELSE 'line on a crossing' END, 'marking', m.marking_id, NULL::float8, m.surface
        FROM marking m JOIN edge e USING (edge_id) JOIN pedestrian_crossing c ON c.surface && m.surface
            JOIN street_object o USING (street_object_id) JOIN axis a ON a.axis_id = o.axis_id AND a.level = e.level
        -- Who comes to a ring waits at the ring.
        WHERE (m.kind <> 'yield' OR NOT EXISTS (SELECT FROM edge r
                WHERE m.node_id IN (r.from_node, r.to_node) AND r.edge_id = ANY (rings)))
            AND streetgen._takes_ground(c.surface, m.surface);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_object(name) IS
    'The rows of streetgen.check_model for objects.';

CREATE OR REPLACE FUNCTION streetgen._object_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (70, 'object', $part$
    (SELECT 'objects, ' || type, count(*), NULL FROM %1$I.street_object GROUP BY type ORDER BY type)$part$),
    (71, 'object', $part$
    (SELECT 'objects, ' || method, count(*), NULL FROM %1$I.street_object GROUP BY method ORDER BY method)$part$) $$;
COMMENT ON FUNCTION streetgen._object_summary() IS 'What streetgen.summary counts of objects.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('parking bay on a crossing or an intersection', 'a bay that was put by hand takes ground where none parks',
        'drag the bay, or the crossing'),
    ('parking bay on a lane for others',
        'a bay by hand takes ground of a cycle, bus, carpool, merging or closed lane; rules place none there',
        'drag the bay, or change the lanes'),
    ('parking bay without its ground', 'a bay stands at no street, or its street ends before it or bends too sharply',
        'drag it to a street in `parking_bay_editing`, or delete it'),
    ('refuge without room, m',
        'beside the refuge in the middle of a crossing a lane would be narrower than 2.5 m, or the refuge than 1 m; or '
        'it would lie beside the roadway, or the model computes no lanes of two directions there',
        'widen the street, state its lanes, or type 0 as `refuge` in `pedestrian_crossing_editing`'),
    ('pedestrian crossing without its roadway', 'a crossing stands at no street, or meets no kerb',
        'drag it to a street in `pedestrian_crossing_editing`, or delete it'),
    ('line on a crossing', 'a stop or yield line lies where people walk', '`generate`'),
    ('arrow on a crossing', 'an arrow of a lane lies where people walk', '`generate`'),
    ('fewer parking bays than the source says',
        'so many cars that `parking_left` or `parking_right` counts have no bay for want of room; NULL: no car has one',
        'correct the axis or its column'),
    ('placement rule for a kind that no street has',
        '`kind` names what is neither a class nor the kind of an axis; the rule places nothing there',
        'write a kind of `axis_class`, or none'),
    ('placement rule along lanes, which the model does not compute', 'it places nothing',
        '`switch_subject` adds subject lane'),
    ('parking bay on another bay',
        'two bays that were put by hand, or by rules on both sides of a narrow street, share ground',
        'drag one of them, or delete it'),
    ('object nearer to another one than distance_least',
        'it was placed by hand or imported, and its type keeps a distance',
        'move it, delete one of both, or set distance_least of its type to 0'),
    ('object in a roadway', 'it was put there by hand or by an import; rules place none in a roadway of its level',
        'drag it behind the kerb, or give it a type below manhole, which lies on the roadway'),
    ('object in a parking bay', 'a car that parks there meets it', 'drag the object or the bay'),
    ('object in the mouth of a crossing', 'it stands where people walk from a crossing, within four metres of it',
        'drag it along the kerb, or drag the crossing'),
    ('object in the sight of a stop or yield line', 'it stands within setting `line_sight` of a line at a kerb',
        'drag it away from the junction, or set `line_sight` smaller'),
    ('object beside no kerb', 'it is placed by a border, and no kerb stands there, as where roadway goes on',
        'drag it to a kerb, or place it by the axis'),
    ('tree on a narrow median', 'the ground between two carriageways is narrower than setting `median_tree_width`',
        'delete the tree, or set `median_tree_width` smaller'),
    ('object on a level below the ground', 'its street is a tunnel', 'drag it to a street on the ground'),
    ('object nearer to another one than object_distance', 'two of these types stand nearer than table '
        '`object_distance` says', 'move it, delete one of both, or change the row of `object_distance`'),
    ('object whose axis is gone', 'the axis that placed the object is gone; it stays where it stood',
        'drag it to another street, or delete it'),
    ('object off the place that its axis gives, m', 'the object does not stand where its abscissa and offset say',
        '`generate`'),
    ('row of object_edge whose object or edge is gone', 'a row was deleted or written past the triggers',
        'generate all axes'),
    ('object on an axis that is not there', 'the object names an axis that was deleted past the triggers',
        'drag the object, or delete it');
INSERT INTO streetgen.check_rule (rule, meaning, hint, least_is_worst) VALUES
    ('parking bay that narrows a lane, m',
        'a bay by hand, or on a parking lane, leaves a general lane narrower than setting `lane_width_minimal`',
        'drag or delete the bay, or widen the roadway', true),
    ('parking bay that leaves a narrow roadway, m',
        'bays, parking lanes and cycle lanes leave less for driving than settings `bay_roadway_one_way` or '
        '`bay_roadway_both` ask; a rule places such bays on parking lanes alone, as the source says',
        'correct width or lanes, or delete the bay', true),
    ('parking bay that leaves a narrow sidewalk, m', 'it lies on the sidewalk and leaves less than 1.5 m of it',
        'correct `parking_left` or `parking_right`, or the width of the sidewalk', true),
    ('sidewalk under a parking bay, m2', 'a row of sidewalks or bays was written past the triggers',
        '`generate`', false),
    ('parking lane too narrow for bays, m', 'no car stands on a lane under 1.6 m, and rules place no bays there',
        'correct width or lanes', true);
