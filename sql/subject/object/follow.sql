-- Objects follow their axes: what moves with them, and what finds another axis, or none.

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

CREATE OR REPLACE FUNCTION streetgen._make_object_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model), streetgen._make_object_triggers(model);
    IF 'object' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model, '{_place_objects,_place_all_objects,_place_objects_along,'
            '_renew_grounds,_renew_grounds_along,_lines_of,_join_edges,_join_edges_of,_edges_near,_object_spread,'
            '_renew_all_rule_objects,_carry_objects,'
            'carry_objects_insert,carry_objects_update,carry_objects_delete,join_objects,_renew_rule_objects,'
            '_renew_crossings,_renew_bays,_lanes_across,_parking_lanes,_bay_room,'
            '_laid_bays,_judged_bays,'
            '_types_below,_has_rules,_has_rules_at_kerbs,_renew_placed,_types_on_roadway,_object_spacing,'
            '_hindrances,_near_earlier,_take_from_rules,'
            '_renew_rules_beside,_lock_beside,_begin_ruled_edit,'
            'free_places,fill_places,enter_rules,apply_rules,rejoin_objects,leave_edges,_street_of_objects,'
            '_hold_borders,redraw_ground,_renew_lines,_lock_streets}');
        RETURN;
    END IF;
    PERFORM streetgen._make_type_function(model), streetgen._make_street_function(model),
        streetgen._make_hindrances(model), streetgen._make_rule_functions(model), streetgen._make_rule_edits(model),
        streetgen._make_crossing_functions(model), streetgen._make_bay_functions(model),
        streetgen._make_bay_room(model),
        streetgen._make_redraw(model);
    CREATE OR REPLACE FUNCTION _renew_grounds(of_rules boolean) RETURNS void
        LANGUAGE sql VOLATILE SET search_path FROM CURRENT
        AS $body$
        SELECT _renew_crossings(ARRAY(SELECT c.street_object_id FROM pedestrian_crossing c
                JOIN street_object o USING (street_object_id) WHERE (o.placed_by = 'rule') = of_rules)),
            _renew_bays(ARRAY(SELECT b.street_object_id FROM parking_bay b
                JOIN street_object o USING (street_object_id) WHERE (o.placed_by = 'rule') = of_rules)) $body$;
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
        PERFORM _renew_grounds(of_rules => false);
        IF _has_rules() OR EXISTS (SELECT FROM street_object
            WHERE rule_id IS NOT NULL AND placed_by = 'rule') THEN
            PERFORM _renew_all_rule_objects(NULL, lying => true, ground => NULL, edges => NULL);
            PERFORM _renew_grounds(of_rules => true);
            -- Lines lie before these crossings, and no object in their sight.
            IF _has_rules_at_kerbs() THEN
                PERFORM streetgen._settle_lane(current_schema(), NULL);
            END IF;
            PERFORM _renew_all_rule_objects(NULL, lying => false, ground => NULL, edges => NULL);
        END IF;
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
        IF ruled THEN
            IF told THEN
                ground := ground || moved;
                lying_along := lying_along || ARRAY(SELECT axis_id FROM _edges_near(moved, beside));
            END IF;
            SELECT r.streets, r.moved FROM _renew_rule_objects(lying_along, lying => true, ground => NULL,
                edges => NULL) r INTO streets, moved;
            placed := placed || streets;
            moved := moved || _renew_grounds_along(lying_along, of_rules => true, ground => ground);
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
    CREATE OR REPLACE FUNCTION join_objects() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    #variable_conflict use_column
    BEGIN
        DELETE FROM object_edge o USING new_object n WHERE o.street_object_id = n.street_object_id
            AND n.method <> 'relative';
        INSERT INTO object_edge AS o (street_object_id, edge_id)
            SELECT DISTINCT ON (n.street_object_id) n.street_object_id, e.edge_id
            FROM new_object n JOIN edge e ON e.axis_id = n.axis_id
                AND n.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
            WHERE n.method = 'relative' ORDER BY n.street_object_id, e.start_abscissa
            ON CONFLICT (street_object_id) DO UPDATE SET edge_id = excluded.edge_id WHERE o.edge_id <> excluded.edge_id;
        INSERT INTO pedestrian_crossing (street_object_id)
            SELECT street_object_id FROM new_object WHERE type = ANY (_types_below('crossing')) ON CONFLICT DO NOTHING;
        DELETE FROM pedestrian_crossing c USING new_object n WHERE c.street_object_id = n.street_object_id
            AND n.type <> ALL (_types_below('crossing'));
        INSERT INTO parking_bay (street_object_id)
            SELECT street_object_id FROM new_object
                WHERE type = ANY (_types_below('parking_bay')) ON CONFLICT DO NOTHING;
        DELETE FROM parking_bay b USING new_object n WHERE b.street_object_id = n.street_object_id
            AND n.type <> ALL (_types_below('parking_bay'));
        PERFORM _renew_crossings(ARRAY(SELECT street_object_id FROM new_object)),
            _renew_bays(ARRAY(SELECT street_object_id FROM new_object)),
            streetgen._join_specialised(current_schema(), ARRAY(SELECT street_object_id FROM new_object));
        PERFORM _renew_rules_beside(ARRAY(SELECT geom FROM new_object));
        IF TG_OP = 'UPDATE' THEN
            PERFORM _renew_lines(ARRAY(SELECT geom FROM new_object WHERE type = ANY (_types_below('crossing'))
                UNION ALL SELECT geom FROM old_object WHERE type = ANY (_types_below('crossing'))));
        ELSE
            PERFORM _renew_lines(ARRAY(SELECT geom FROM new_object WHERE type = ANY (_types_below('crossing'))));
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE FUNCTION leave_edges() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    BEGIN
        IF TG_OP = 'TRUNCATE' THEN
            DELETE FROM object_edge o WHERE NOT EXISTS (SELECT FROM street_object s
                WHERE s.street_object_id = o.street_object_id);
        ELSIF TG_TABLE_NAME = 'edge' THEN
            DELETE FROM object_edge o USING gone g WHERE o.edge_id = g.edge_id;
        ELSE
            DELETE FROM object_edge o USING gone g WHERE o.street_object_id = g.street_object_id;
        END IF;
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER leave_edges AFTER DELETE ON street_object REFERENCING OLD TABLE AS gone
        FOR EACH STATEMENT EXECUTE FUNCTION leave_edges();
    CREATE OR REPLACE TRIGGER leave_edges AFTER DELETE ON edge REFERENCING OLD TABLE AS gone
        FOR EACH STATEMENT EXECUTE FUNCTION leave_edges();
    CREATE OR REPLACE TRIGGER leave_edges_truncate AFTER TRUNCATE ON street_object
        FOR EACH STATEMENT EXECUTE FUNCTION leave_edges();
    COMMENT ON TRIGGER leave_edges ON street_object IS 'An object that is gone stands at no edge';
    COMMENT ON TRIGGER leave_edges_truncate ON street_object IS 'An object that is gone stands at no edge';
    COMMENT ON TRIGGER leave_edges ON edge IS 'No object stands at an edge that is gone';
    CREATE OR REPLACE FUNCTION rejoin_objects() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    BEGIN
        UPDATE street_object SET type = type WHERE type = ANY (_types_below(NEW.type));
        RETURN NULL;
    END $body$;
    CREATE OR REPLACE TRIGGER rejoin_objects AFTER UPDATE OF parent ON object_type FOR EACH ROW
        WHEN (NEW.parent IS DISTINCT FROM OLD.parent) EXECUTE FUNCTION rejoin_objects();
    COMMENT ON TRIGGER rejoin_objects ON object_type IS 'Its objects get the rows of what they are a kind of now';
    CREATE OR REPLACE FUNCTION _carry_objects(axes bigint[], before geometry[], after geometry[]) RETURNS void
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
            SET streetgen.computes = 'on'
        AS $body$
    #variable_conflict use_column
    DECLARE
        tolerance constant float8 := streetgen._tolerance(current_schema());
    BEGIN
        -- Objects of changed axes are taken with the place of the old axis at which they stood.
        WITH changed AS MATERIALIZED (
            SELECT c.axis_id, ST_Force2D(c.was) AS was, ST_Force2D(c.now) AS now,
                c.was IS NOT NULL AND c.now IS NOT NULL AND NOT streetgen._remap_is_cut_back(ST_Force2D(c.was),
                    ST_Force2D(c.now), tolerance) AS moved
            FROM unnest(axes, before, after) c(axis_id, was, now)),
        standing AS MATERIALIZED (
            SELECT o.*, c.was, c.now, c.moved, f.foot, coalesce(ST_DWithin(c.now, f.foot, tolerance), false) AS stays,
                CASE WHEN o.abscissa_end IS NOT NULL THEN ST_LineInterpolatePoint(c.was,
                    least(1, o.abscissa_end / ST_Length2D(c.was))) END AS foot_end
            FROM changed c JOIN street_object o USING (axis_id),
                LATERAL (SELECT ST_LineInterpolatePoint(c.was, least(1, o.abscissa / ST_Length2D(c.was))) AS foot) f
            WHERE o.method = 'relative' AND o.placed_by <> 'rule' AND c.was IS NOT NULL),
        inherited AS MATERIALIZED (
            SELECT s.*, h.axis_id AS heir, h.line FROM standing s LEFT JOIN LATERAL (
                SELECT s.axis_id, s.now AS line, 1 AS turn WHERE s.stays
                -- Another axis took the ground over: it runs there as this one did.
                UNION ALL SELECT x.axis_id, ST_Force2D(x.geom), 2 FROM axis x
                WHERE NOT s.stays AND x.axis_id <> s.axis_id
                    AND ST_DWithin(x.geom, s.foot, tolerance)
                    AND abs(cos(streetgen._heading(s.was, s.foot) - streetgen._heading(ST_Force2D(x.geom), s.foot))) >
                        0.9
                -- The axis moved, and is not only cut back.
                UNION ALL SELECT s.axis_id, s.now, 3
                WHERE NOT s.stays AND s.moved
                ORDER BY turn, axis_id LIMIT 1) h ON true),
        new AS (
            SELECT street_object_id, heir, at.abscissa, at.abscissa_end, turned,
                heir IS NULL OR coalesce(at.abscissa_end - at.abscissa < (i.abscissa_end - i.abscissa) / 2, false)
                    AS lost,
                CASE WHEN turned THEN orientation + CASE WHEN orientation > 0 THEN -180 ELSE 180 END ELSE orientation
                    END
                    AS orientation
            FROM inherited i, LATERAL (SELECT (streetgen._locate_on(line::bytea, foot::bytea))[1] AS a,
                    (streetgen._locate_on(line::bytea, foot_end::bytea))[1] AS b) l,
                LATERAL (SELECT coalesce(cosd(streetgen._direction_on(was::bytea, i.abscissa, 0)
                    - streetgen._direction_on(line::bytea, a, 0)) < 0, false) AS turned) t,
                LATERAL (SELECT CASE WHEN abs(least(a, b) - i.abscissa) < 1e-6 THEN i.abscissa ELSE least(a, b) END
                    AS abscissa, CASE WHEN b IS NOT NULL THEN CASE WHEN abs(greatest(a, b) - i.abscissa_end) < 1e-6
                    THEN i.abscissa_end ELSE greatest(a, b) END END AS abscissa_end) at)
        UPDATE street_object o SET method = CASE WHEN lost THEN 'orphaned' ELSE 'relative' END,
            axis_id = CASE WHEN lost THEN o.axis_id ELSE n.heir END,
            abscissa = CASE WHEN lost THEN o.abscissa ELSE n.abscissa END,
            abscissa_end = CASE WHEN lost THEN o.abscissa_end ELSE n.abscissa_end END,
            axis_offset = CASE WHEN n.turned AND o.side IS NULL AND NOT lost THEN -o.axis_offset ELSE o.axis_offset END,
            side = CASE WHEN n.turned AND NOT lost THEN CASE o.side WHEN 'left' THEN 'right' WHEN 'right' THEN 'left'
                END
                ELSE o.side END,
            orientation = CASE WHEN o.orientation_kind = 'axis' AND NOT lost THEN n.orientation ELSE o.orientation END
        FROM new n
        WHERE o.street_object_id = n.street_object_id AND (lost OR turned OR (o.axis_id, o.abscissa, o.abscissa_end)
            IS DISTINCT FROM (n.heir, n.abscissa, n.abscissa_end));
        DELETE FROM object_edge e USING street_object o WHERE o.street_object_id = e.street_object_id
            AND o.axis_id = ANY (axes) AND o.method = 'orphaned';
        -- An orphan takes an axis that comes by where it stood at its own.
        WITH changed AS MATERIALIZED (SELECT c.axis_id FROM unnest(axes, after) c(axis_id, now) WHERE now IS NOT NULL),
        found AS (
            SELECT DISTINCT ON (o.street_object_id) o.street_object_id, u.axis_id, p.at[1] AS abscissa, p.at[2] AS
                beside,
                s.middle,
                CASE WHEN o.abscissa_end IS NOT NULL THEN p.at[1] + (o.abscissa_end - o.abscissa) END AS abscissa_end
            FROM changed JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end, roadway_offset
                FROM axis_used) u
                    USING (axis_id)
                JOIN street_object o ON o.method = 'orphaned' AND o.geom && ST_Expand(u.line, 400)
                CROSS JOIN LATERAL (SELECT streetgen._locate_on(u.line::bytea, CASE WHEN o.abscissa_end IS NULL
                    THEN o.geom ELSE ST_StartPoint(o.geom) END::bytea) AS at) p
                CROSS JOIN LATERAL (SELECT CASE WHEN o.side IS NULL THEN 0 ELSE u.roadway_offset END AS middle) s
            -- On either side, since the axis may run the other way.
            WHERE abs(abs(p.at[2] - s.middle) - abs(streetgen._border_offset(streetgen._to_border(u.width, u.width_end,
                    ST_Length2D(u.line), 0, NULL, p.at[1], o.side), o.axis_offset, o.side))) <= tolerance
                AND ST_DWithin(u.line, o.geom, abs(p.at[2]) + tolerance)
                AND p.at[1] + coalesce(o.abscissa_end - o.abscissa, 0) <= ST_Length2D(u.line) + 1e-6
                -- Not beyond an end of it.
                AND ST_DWithin(streetgen._place_on(u.line::bytea, p.at[1], p.at[2])::geometry, CASE
                    WHEN o.abscissa_end IS NULL THEN o.geom ELSE ST_StartPoint(o.geom) END, tolerance)
            ORDER BY o.street_object_id, abs(p.at[2]), u.axis_id)
        UPDATE street_object o SET method = 'relative', axis_id = f.axis_id, abscissa = f.abscissa,
            abscissa_end = f.abscissa_end,
            side = CASE WHEN o.side IS NOT NULL THEN CASE WHEN beside >= middle THEN 'left' ELSE 'right' END END,
            axis_offset = CASE WHEN o.side IS NULL THEN beside ELSE o.axis_offset END,
            orientation = CASE WHEN o.orientation_kind = 'axis' THEN round((o.angle - streetgen._direction_on(
                (SELECT ST_Force2D(geom)::bytea FROM axis a WHERE a.axis_id = f.axis_id), f.abscissa, 0))::numeric, 9)
                ELSE o.orientation END
        FROM found f WHERE o.street_object_id = f.street_object_id;
        -- Streets that follow take their objects along.
        IF NOT streetgen._live(current_schema()) OR streetgen._setting_changed(current_schema()) THEN
            PERFORM FROM _place_objects(axes);
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_renew_grounds(boolean)',
        'Draws the ground of all crossings and bays anew, of those of rules or of all others'),
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
        'near ground that changed (NULL: along these axes alone) and along all of the edges; a row per table'),
        streetgen._own_function(model, '_carry_objects(bigint[], geometry[], geometry[])',
        'Puts the objects of changed axes on the axis that they stand at now: axes with their lines before and after');
    PERFORM streetgen._own_function(model, 'join_objects()',
        'After objects were put or changed: the edge at which each stands'),
        streetgen._own_function(model, 'leave_edges()',
        'After objects or edges were deleted: which object stands at which edge'),
        streetgen._own_function(model, 'rejoin_objects()',
        'After a type got another parent: its objects get the rows of what they are a kind of now');
    CREATE OR REPLACE TRIGGER join_objects_insert AFTER INSERT ON street_object REFERENCING NEW TABLE AS new_object
        FOR EACH STATEMENT WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION join_objects();
    CREATE OR REPLACE TRIGGER join_objects_update AFTER UPDATE ON street_object
        REFERENCING OLD TABLE AS old_object NEW TABLE AS new_object FOR EACH STATEMENT
        WHEN (current_setting('streetgen.computes', true) IS DISTINCT FROM 'on')
        EXECUTE FUNCTION join_objects();
    COMMENT ON TRIGGER join_objects_insert ON street_object IS 'Finds the edges at which objects stand';
    COMMENT ON TRIGGER join_objects_update ON street_object IS 'Finds the edges at which objects stand';
    PERFORM streetgen._follow_axes(model, 'carry_objects', '{street_object}', '{_carry_objects}',
        'objects stay at the piece of road where they stand');
    PERFORM streetgen._tie_specialised(model);
    PERFORM streetgen._grant_object_locks(model);
END $$;
COMMENT ON FUNCTION streetgen._make_object_functions(name) IS
    'Makes the functions and triggers of a model by which objects follow its axes, or drops them where it computes '
    'none.';

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
