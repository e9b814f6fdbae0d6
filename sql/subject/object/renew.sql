-- Objects are brought up to date after a run: of all axes, or of some and near ground that changed.

CREATE OR REPLACE FUNCTION streetgen._object_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (70, 'object_edge', 'object', 'street_object_id', NULL, 'object_edge', 1) $$;
COMMENT ON FUNCTION streetgen._object_computed_table() IS 'The computed table of objects at streets.';

CREATE OR REPLACE FUNCTION streetgen._thin_ground(ground geometry[]) RETURNS geometry[]
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    united constant geometry := (SELECT ST_Union(g) FROM unnest(ground) g WHERE ST_Dimension(g) = 2);
BEGIN
    RETURN ARRAY(SELECT geom FROM ST_Dump(united)) || ARRAY(SELECT DISTINCT g FROM unnest(ground) g
        WHERE ST_Dimension(g) < 2 AND NOT coalesce(ST_Covers(united, g), false));
END $$;
COMMENT ON FUNCTION streetgen._thin_ground(geometry[]) IS
    'The same ground in few pieces: surfaces united, and the lines and points beside them.';

CREATE OR REPLACE FUNCTION streetgen._make_object_renewal(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _renew_grounds(of_rules boolean) RETURNS geometry[]
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT
        AS $body$
    BEGIN
        PERFORM _renew_crossings(ARRAY(SELECT c.street_object_id FROM pedestrian_crossing c
            JOIN street_object o USING (street_object_id) WHERE (o.placed_by = 'rule') = of_rules));
        RETURN _renew_bays(ARRAY(SELECT b.street_object_id FROM parking_bay b
            JOIN street_object o USING (street_object_id) WHERE (o.placed_by = 'rule') = of_rules), told => true);
    END $body$;
    CREATE OR REPLACE FUNCTION _renew_grounds_along(axes bigint[], of_rules boolean, ground geometry[])
        RETURNS geometry[]
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    DECLARE
        along constant bigint[] := ARRAY(SELECT street_object_id FROM street_object
            WHERE axis_id = ANY (axes) AND (placed_by = 'rule') = of_rules);
    BEGIN
        RETURN _renew_crossings(ARRAY(
                SELECT street_object_id FROM pedestrian_crossing c WHERE street_object_id = ANY (along)
                -- The ground of a crossing ends where roadway does.
                UNION SELECT c.street_object_id FROM unnest(ground) g, LATERAL (SELECT c.street_object_id
                        FROM pedestrian_crossing c WHERE c.surface && g OFFSET 0) c
                    JOIN street_object o USING (street_object_id) WHERE (o.placed_by = 'rule') = of_rules),
                told => true)
            || _renew_bays(ARRAY(SELECT street_object_id FROM parking_bay WHERE street_object_id = ANY (along)),
                told => true);
    END $body$;
    CREATE OR REPLACE FUNCTION _place_all_objects() RETURNS void
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        -- The joins of a city have too many parts with less memory. Nothing is known of rows just computed: all of
        -- them are joined by hash.
        SET plan_cache_mode = force_custom_plan SET work_mem = '16MB' SET enable_nestloop = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        bays geometry[];
    BEGIN
        UPDATE street_object o SET geom = n.geom, angle = n.angle
        FROM (SELECT o.street_object_id, streetgen._object_geometry(a.line, a.width, a.width_end,
                    a.roadway_offset, b.borders, o.abscissa, o.abscissa_end, o.side, o.axis_offset) AS geom,
                streetgen._object_angle(a.line, o.abscissa, o.abscissa_end, o.orientation, o.orientation_kind) AS angle
            FROM street_object o JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end,
                    roadway_offset FROM axis_used OFFSET 0) a USING (axis_id)
                LEFT JOIN streetgen._axis_borders(current_schema(), NULL) b USING (axis_id)
            -- Objects of rules are new.
            WHERE o.method = 'relative' AND o.placed_by <> 'rule') n
        WHERE o.street_object_id = n.street_object_id
            AND (o.geom::bytea, o.angle) IS DISTINCT FROM (n.geom::bytea, n.angle);
        -- First what others placed, then what rules put on the roadway, then what they stand beside it.
        bays := _renew_grounds(of_rules => false);
        IF _has_rules() OR EXISTS (SELECT FROM street_object
            WHERE rule_id IS NOT NULL AND placed_by = 'rule') THEN
            SELECT r.moved || bays FROM _renew_all_rule_objects(NULL, lying => true, ground => NULL, edges => NULL) r
                INTO bays;
            bays := bays || _renew_grounds(of_rules => true);
            -- Lines lie before these crossings, and no object in their sight.
            IF _has_rules_at_kerbs() THEN
                PERFORM streetgen._settle_lane(current_schema(), NULL);
            END IF;
            PERFORM _renew_all_rule_objects(NULL, lying => false, ground => NULL, edges => NULL);
        END IF;
        PERFORM _cut_sidewalks(_sidewalks_on(coalesce(bays, '{}')));
        PERFORM streetgen._renew_specialised(current_schema(), NULL);
    END $body$;
    CREATE OR REPLACE FUNCTION _lines_of(axes bigint[], OUT lines bigint[], OUT places geometry[],
            OUT painted boolean[])
        LANGUAGE plpgsql STABLE SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    BEGIN
        IF to_regclass('marking') IS NOT NULL THEN
            SELECT array_agg(marking_id), array_agg(m.geom), array_agg(NOT ST_IsEmpty(m.surface))
                FROM edge e JOIN marking m USING (edge_id)
                WHERE e.axis_id = ANY (axes) AND m.kind <> 'arrow' INTO lines, places, painted;
        END IF;
    END $body$;
    CREATE OR REPLACE FUNCTION _place_objects_along(axes bigint[], ground geometry[], edges bigint[])
        RETURNS bigint[]
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        -- A session plans each statement once: planning anew costs an edit more than the plan does. The joins of a
        -- few are looked up by key.
        SET plan_cache_mode = force_generic_plan SET enable_seqscan = off SET enable_mergejoin = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        ruled constant boolean := _has_rules() OR EXISTS (SELECT FROM street_object
            WHERE rule_id IS NOT NULL AND placed_by = 'rule');
        -- Objects along these axes alone are written if no ground is told.
        told constant boolean := ground IS NOT NULL;
        placed bigint[];
        lying_along bigint[] := axes;
        lined bigint[];
        before record;
        streets bigint[];
        moved geometry[];
        bays geometry[];
        -- Objects on a roadway look at the ground there, and bays behind its kerb at the ground of other streets.
        beside constant float8 := 3 + greatest(0, (SELECT max(axis_offset) FROM placement_rule
            WHERE active AND type = ANY (_types_below('parking_bay'))), (SELECT max(value::float8) FROM setting
            WHERE name IN ('parking_depth_parallel', 'parking_depth_diagonal', 'parking_depth_perpendicular')
                AND EXISTS (SELECT FROM placement_rule WHERE active AND along = 'lane')));
    BEGIN
        IF told THEN
            ground := streetgen._thin_ground(ground);
            lying_along := axes || ARRAY(SELECT axis_id FROM _edges_near(ground, beside));
        END IF;
        -- Objects of a street that went may stand along one beside it.
        placed := lying_along;
        WITH new AS MATERIALIZED (
            SELECT o.street_object_id, o.geom AS was, streetgen._object_geometry(a.line, a.width, a.width_end,
                    a.roadway_offset, b.borders, o.abscissa, o.abscissa_end, o.side, o.axis_offset) AS geom,
                o.angle AS angle_was, streetgen._object_angle(a.line, o.abscissa, o.abscissa_end, o.orientation,
                    o.orientation_kind) AS angle
            FROM street_object o JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end,
                    roadway_offset FROM axis_used WHERE axis_id = ANY (placed) OFFSET 0) a USING (axis_id)
                LEFT JOIN streetgen._axis_borders(current_schema(), placed) b USING (axis_id)
            WHERE o.method = 'relative' AND o.placed_by <> 'rule' AND o.axis_id = ANY (placed)),
        stood AS (
            UPDATE street_object o SET geom = n.geom, angle = n.angle FROM new n
            WHERE o.street_object_id = n.street_object_id
                AND (n.was::bytea, n.angle_was) IS DISTINCT FROM (n.geom::bytea, n.angle)
            RETURNING n.was, n.geom)
        SELECT array_agg(was) || array_agg(geom) FROM stood INTO moved;
        IF told THEN
            lying_along := lying_along || ARRAY(SELECT axis_id
                FROM _edges_near(moved, (SELECT max(reach) FROM _object_spread())));
            ground := ground || moved;
        END IF;
        -- First what others placed, then what rules put on the roadway, then what they stand beside it.
        moved := _renew_grounds_along(lying_along, of_rules => false, ground => ground);
        bays := moved;
        IF ruled THEN
            IF told THEN
                ground := ground || moved;
                lying_along := lying_along || ARRAY(SELECT axis_id FROM _edges_near(moved, beside));
            END IF;
            SELECT r.streets, r.moved FROM _renew_rule_objects(lying_along, lying => true, ground => NULL,
                edges => NULL) r INTO streets, moved;
            placed := placed || streets;
            moved := moved || _renew_grounds_along(lying_along, of_rules => true, ground => ground);
            bays := bays || moved;
            -- Lines lie before these crossings, and no object in their sight.
            IF _has_rules_at_kerbs() AND told THEN
                ground := ground || moved;
                lined := axes || ARRAY(SELECT axis_id FROM _edges_near(ground, 5));
                before := _lines_of(lined);
                PERFORM streetgen._settle_lane(current_schema(), lined);
                IF before.lines IS NOT NULL THEN
                    ground := ground || ARRAY(SELECT unnest(ARRAY[b.geom, m.geom])
                        FROM unnest(before.lines, before.places, before.painted) b(marking_id, geom, painted)
                            JOIN marking m USING (marking_id)
                        WHERE b.geom::bytea <> m.geom::bytea OR b.painted = ST_IsEmpty(m.surface));
                END IF;
                ground := streetgen._thin_ground(ground);
            ELSIF _has_rules_at_kerbs() THEN
                PERFORM streetgen._settle_lane(current_schema(), axes);
            END IF;
            SELECT r.streets FROM _renew_rule_objects(axes, lying => false, ground => ground, edges => edges) r
                INTO streets;
            placed := placed || streets;
        END IF;
        PERFORM _cut_sidewalks(_sidewalks_on(coalesce(bays, '{}')));
        RETURN placed;
    END $body$;
    CREATE OR REPLACE FUNCTION _place_objects(axes bigint[], ground geometry[] DEFAULT NULL,
        edges bigint[] DEFAULT NULL)
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    DECLARE
        placed bigint[];
    BEGIN
        IF axes IS NULL THEN
            PERFORM _place_all_objects();
            RETURN QUERY SELECT * FROM _join_edges();
        ELSIF EXISTS (SELECT FROM street_object) OR _has_rules() THEN
            placed := _place_objects_along(axes, ground, edges);
            PERFORM streetgen._renew_specialised(current_schema(), placed);
            RETURN QUERY SELECT * FROM _join_edges_of(placed);
        ELSE
            RETURN QUERY VALUES ('object_edge', 0::bigint, 0::bigint, 0::bigint, 0::bigint, 0::bigint);
        END IF;
    END $body$;
    PERFORM streetgen._compose_function(model, declaration, 'TABLE(relation text, inserted bigint, updated bigint, '
            'deleted bigint, unchanged bigint, fallbacks bigint)', streetgen._fill_template(
            streetgen._part('join_object_edges'), jsonb_build_object('of_axes', of_axes, 'of_objects', of_objects)),
        signature, 'Brings the edges at which objects stand up to date: of objects of ' || which,
        'VOLATILE PARALLEL UNSAFE ROWS 1 SET jit = off SET ' || plan)
    FROM (VALUES ('_join_edges()', '_join_edges()', 'true', 'true', 'all axes', 'enable_nestloop = off'),
        ('_join_edges_of(axes bigint[])', '_join_edges_of(bigint[])', 's.axis_id = ANY (axes)',
            'o.street_object_id = ANY (ARRAY(SELECT street_object_id FROM there))', 'some axes',
            'enable_seqscan = off SET enable_mergejoin = off SET plan_cache_mode = force_generic_plan'))
        made(declaration, signature, of_axes, of_objects, which, plan);
    PERFORM streetgen._own_function(model, '_renew_grounds(boolean)',
        'Draws the ground of all crossings and bays anew, of those of rules or of all others; tells where bays were '
            'and are'),
        streetgen._own_function(model, '_renew_grounds_along(bigint[], boolean, geometry[])',
        'The same of those along axes and of crossings on ground that changed; tells what changed'),
        streetgen._own_function(model, '_lines_of(bigint[])',
        'The lines on lanes of axes, their places, and whether they have paint'),
        streetgen._own_function(model, '_place_all_objects()', 'Brings the places of all objects up to date'),
        streetgen._own_function(model, '_place_objects_along(bigint[], geometry[], bigint[])',
        'Brings the places of the objects of axes up to date, and of those that rules place near ground that changed '
        'and along all of the edges; tells along which axes'),
        streetgen._own_function(model, '_place_objects(bigint[], geometry[], bigint[])',
        'Brings the places of the objects of axes (NULL: of all), and their edges, up to date, with what rules place '
        'near ground that changed (NULL: along these axes alone) and along all of the edges; a row per table');
END $$;
COMMENT ON FUNCTION streetgen._make_object_renewal(name) IS
    'Makes the functions of a model that bring the places of objects, and the edges at which they stand, up to date.';

CREATE OR REPLACE FUNCTION streetgen._has_no_objects(model name) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- For fewer axes taking off costs more than it saves.
    worth_it constant integer := 1000;
    none boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT _has_rules() AND NOT EXISTS (SELECT FROM street_object)
        AND (SELECT count(*) = worth_it FROM (SELECT FROM axis LIMIT worth_it) a)
        AND pg_has_role(relowner, 'USAGE') FROM pg_class WHERE oid = format('%I.street_object', model)::regclass
            INTO none;
    RETURN none;
END $$;
COMMENT ON FUNCTION streetgen._has_no_objects(name) IS
    'Will rules place objects along a thousand axes and more into tables that are empty, and the caller''s?';

CREATE OR REPLACE FUNCTION streetgen._moved_object(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places ->> 'run' = 'part' AND subjects ? 'object'
        THEN streetgen._fill_template(streetgen._part('moved_object'), places || jsonb_build_object(
            'lanes', CASE WHEN subjects ? 'lane' THEN streetgen._fill_template(
                streetgen._part('moved_object_lanes'), places) ELSE '' END,
            'rings', CASE WHEN subjects ? 'roundabout' THEN streetgen._fill_template(
                streetgen._part('moved_object_rings'), places) ELSE '' END,
            'lines', CASE WHEN subjects ? 'lane' THEN streetgen._fill_template(streetgen._part('moved_object_lines'),
                places) ELSE '' END)) END
    FROM (SELECT places -> 'subjects' AS subjects) s $$;
COMMENT ON FUNCTION streetgen._moved_object(jsonb) IS
    'Part of the one statement in a run for some axes: moved_object, the axes of which something changed that '
    'objects are placed by, and the ground where something changed, with the edge whose all is such ground. '
    'NULL in other runs, and in a model without '
    'objects.';

CREATE OR REPLACE FUNCTION streetgen._update_object(model name, axes bigint[],
    moved streetgen.moved_row[] DEFAULT NULL, noted bigint[] DEFAULT NULL)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    back text[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    IF axes IS NULL AND streetgen._has_no_objects(model) THEN
        back := ARRAY(SELECT t.statement FROM streetgen._drop_keys(model, '{object_type,street_object,object_edge}') t
            ORDER BY t.turn);
    END IF;
    IF moved IS NULL OR axes IS NULL OR EXISTS (SELECT FROM setting
            WHERE name = 'placement_function' AND value <> 'none') THEN
        RETURN QUERY SELECT * FROM _place_objects(axes);
    ELSE
        RETURN QUERY SELECT p.* FROM (SELECT coalesce(array_agg(id) FILTER (WHERE m.ground IS NULL), ARRAY[]::bigint[])
                AS streets, coalesce(array_agg(DISTINCT m.ground) FILTER (WHERE m.ground IS NOT NULL),
                ARRAY[]::geometry[]) AS ground, coalesce(array_agg(DISTINCT id) FILTER (WHERE m.ground IS NOT NULL
                AND id IS NOT NULL), ARRAY[]::bigint[]) AS edges FROM unnest(moved) m WHERE room = 'object') m,
            _place_objects(m.streets, m.ground, m.edges) p;
    END IF;
    FOR i IN 1 .. cardinality(back) LOOP
        EXECUTE back[i];
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._update_object(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the places of objects up to date. The first '
    'objects of all rules come before their keys and indexes.';
