-- Objects follow their axes: what moves with them, and what finds another axis, or none.

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
            '_renew_crossings,_refuge,_renew_bays,_edges_between_borders,_lanes_across,_parking_lanes,_bay_room,'
            '_laid_bays,_judged_bays,'
            '_types_below,_has_rules,_has_rules_at_kerbs,_renew_placed,_types_on_roadway,_object_spacing,'
            '_hindrances,_near_earlier,_take_from_rules,'
            '_renew_rules_beside,_lock_beside,_begin_ruled_edit,'
            'free_places,fill_places,enter_rules,apply_rules,rejoin_objects,leave_edges,_street_of_objects,'
            '_hold_borders,redraw_ground,repaint_crossings,_renew_lines,_lock_streets}');
        RETURN;
    END IF;
    PERFORM streetgen._make_type_function(model), streetgen._make_street_function(model),
        streetgen._make_hindrances(model), streetgen._make_rule_functions(model), streetgen._make_rule_edits(model),
        streetgen._make_refuge_function(model), streetgen._make_crossing_functions(model),
        streetgen._make_bay_functions(model), streetgen._make_bay_room(model),
        streetgen._make_object_renewal(model), streetgen._make_redraw(model);
    CREATE OR REPLACE FUNCTION join_objects() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET streetgen.computes = 'on'
        AS $body$
    #variable_conflict use_column
    DECLARE
        bays geometry[];
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
        WITH gone AS (
            DELETE FROM parking_bay b USING new_object n WHERE b.street_object_id = n.street_object_id
                AND n.type <> ALL (_types_below('parking_bay')) RETURNING b.surface)
        SELECT array_agg(surface) FROM gone INTO bays;
        PERFORM _renew_crossings(ARRAY(SELECT street_object_id FROM new_object)),
            _cut_sidewalks(_sidewalks_on(coalesce(bays || _renew_bays(ARRAY(SELECT street_object_id FROM new_object),
                told => true), '{}'))),
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
        heirs bigint[];
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
                    THEN i.abscissa_end ELSE greatest(a, b) END END AS abscissa_end) at),
        carried AS (UPDATE street_object o SET method = CASE WHEN lost THEN 'orphaned' ELSE 'relative' END,
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
            IS DISTINCT FROM (n.heir, n.abscissa, n.abscissa_end)) RETURNING o.axis_id)
        SELECT coalesce(array_agg(DISTINCT axis_id), '{}') FROM carried WHERE axis_id <> ALL (axes) INTO heirs;
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
        -- Streets that follow take their objects along, but one that took over ground may be as it was.
        IF NOT streetgen._live(current_schema()) OR streetgen._setting_changed(current_schema()) THEN
            PERFORM FROM _place_objects(axes || heirs);
        ELSIF heirs <> '{}' THEN
            PERFORM FROM _place_objects(heirs);
        END IF;
    END $body$;
    PERFORM streetgen._own_function(model, '_carry_objects(bigint[], geometry[], geometry[])',
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
    -- A refuge has no place any more where lanes were switched off.
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        PERFORM _renew_crossings(ARRAY(SELECT street_object_id FROM pedestrian_crossing WHERE island IS NOT NULL));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_object_functions(name) IS
    'Makes the functions and triggers of a model by which objects follow its axes, or drops them where it computes '
    'none.';
