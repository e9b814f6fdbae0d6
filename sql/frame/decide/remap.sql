-- Decisions by hand find their axes again after a split, merge, reversal or redraw.

CREATE OR REPLACE FUNCTION streetgen._projected(line geometry, place geometry, onto boolean, former float8,
    OUT abscissa float8, OUT geom geometry)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN abs(at - former) < 1e-6 THEN former ELSE at END, CASE WHEN onto THEN ST_ClosestPoint(line, place)
        ELSE place END
    FROM (SELECT ST_LineLocatePoint(line, place) * ST_Length2D(line) AS at) p
    $$;
COMMENT ON FUNCTION streetgen._projected(geometry, geometry, boolean, float8) IS
    'Abscissa (metres) of a line nearest to a place, the former one where it is the same within a micrometre; and the '
    'place, put onto the line where asked.';

CREATE OR REPLACE FUNCTION streetgen._lanes_at(model name, axis bigint, abscissa float8) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane l WHERE l.kind <> 'merging' AND edge_id = (SELECT e.edge_id FROM edge e
        WHERE axis_id = axis AND e.start_abscissa <= abscissa ORDER BY e.start_abscissa DESC LIMIT 1) INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_at(name, bigint, float8) IS
    'Number of lanes of an axis at an abscissa, or beyond it at its end, without merging lanes, as generated last; 0 '
    'where there are none.';

CREATE OR REPLACE FUNCTION streetgen._lanes_by(model name, axis bigint, place geometry) RETURNS bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lanes bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' <> ALL (streetgen._subjects(model)) THEN
        RETURN 0;
    END IF;
    SELECT count(*) FROM lane WHERE edge_id = streetgen._edge_at(model, axis, place) INTO lanes;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_by(name, bigint, geometry) IS
    'Number of lanes of an axis at its edge nearest to a place, as generated last.';

CREATE OR REPLACE FUNCTION streetgen._make_remap(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW override_place WITH (security_invoker = true) AS
    SELECT 'transition_override' AS relation, transition_override_id AS override_id, 'axis_id' AS role, axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance') AS reach, NULL::float8 AS abscissa
        FROM transition_override
    UNION ALL SELECT 'lane_override', lane_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM lane_override
    UNION ALL SELECT 'lane_adjacency_override', lane_adjacency_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM lane_adjacency_override
    UNION ALL SELECT 'section_limit_override', section_limit_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM section_limit_override
    UNION ALL SELECT 'road_override', road_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM road_override
    UNION ALL SELECT 'ramp_override', ramp_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM ramp_override
    UNION ALL SELECT 'height_override', height_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM height_override
    UNION ALL SELECT 'sidewalk_override', sidewalk_override_id, 'axis_id', axis_id, geom,
        (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM sidewalk_override
    UNION ALL SELECT 'kerb_point_override', kerb_point_override_id, 'axis_id', axis_id, geom,
        width / 2 + (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa FROM kerb_point_override
    UNION ALL SELECT 'control_point', control_point_id, 'axis_id', axis_id, geom,
        coalesce(axis_distance, 0) + (SELECT value::float8 FROM setting WHERE name = 'tolerance'), abscissa
        FROM control_point
    UNION ALL SELECT 'junction_override', junction_override_id, 'axis_id', axis_id, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM junction_override
    UNION ALL SELECT 'controller_override', controller_override_id, 'axis_id', axis_id, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM controller_override
    UNION ALL SELECT 'corner_override', corner_override_id, 'axis_a', axis_a, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM corner_override
    UNION ALL SELECT 'corner_override', corner_override_id, 'axis_b', axis_b, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM corner_override
    UNION ALL SELECT 'interconnection_override', interconnection_override_id, 'axis_in', axis_in, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM interconnection_override
    UNION ALL SELECT 'interconnection_override', interconnection_override_id, 'axis_out', axis_out, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM interconnection_override
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'from_axis', from_axis, geom,
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM turn_restriction
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'to_axis', to_axis, coalesce(to_geom, geom),
        3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL FROM turn_restriction
    UNION ALL SELECT 'turn_restriction', turn_restriction_id, 'via_axis ' || v.i, v.axis_id,
        ST_GeometryN(via_geom, v.i::integer), 3 * (SELECT value::float8 FROM setting WHERE name = 'tolerance'), NULL
        FROM turn_restriction, unnest(via_axes) WITH ORDINALITY v(axis_id, i) WHERE via_axes IS NOT NULL
    UNION ALL SELECT 'overpass_override', overpass_override_id, 'axis_above', axis_above, geom, 20, NULL
        FROM overpass_override
    UNION ALL SELECT 'overpass_override', overpass_override_id, 'axis_below', axis_below, geom, 20, NULL
        FROM overpass_override;
    COMMENT ON VIEW override_place IS
        'Where each decision by hand lies, and the axes that it names, a row for each of them';
    COMMENT ON COLUMN override_place.relation IS 'table of the override';
    COMMENT ON COLUMN override_place.override_id IS 'its key there';
    COMMENT ON COLUMN override_place.role IS 'column that names the axis';
    COMMENT ON COLUMN override_place.axis_id IS 'the axis';
    COMMENT ON COLUMN override_place.geom IS 'place on the axis or of the node; of a kerb point, beside the axis';
    COMMENT ON COLUMN override_place.reach IS 'an axis within this distance lies at the place, metres';
    COMMENT ON COLUMN override_place.abscissa IS 'metres along the axis; NULL for what lies at an end or a node';
    -- Most models have few overrides, and most edits none near: a session keeps the plans.
    CREATE OR REPLACE FUNCTION _remap(axes bigint[], lines_before geometry[], lines_after geometry[]) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET enable_seqscan = off
            SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        extent constant geometry := (SELECT ST_Extent(line)::geometry FROM unnest(lines_before || lines_after) line);
        -- No kerb lies farther from its axis than 100 m, and three tolerances are 30 m at most.
        near constant geometry := ST_Expand(extent, 110);
        concerned bigint[];
        held text[];
    BEGIN
        LOOP
            BEGIN
                -- Their rows first, and by one lock all their places, so that none waits for more while it holds some.
                held := ARRAY(SELECT concat(relation, id) FROM (
                SELECT 'transition_override', id FROM (SELECT transition_override_id AS id
                    FROM transition_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'lane_override', id FROM (SELECT lane_override_id AS id
                    FROM lane_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'section_limit_override', id FROM (SELECT section_limit_override_id AS id
                    FROM section_limit_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'sidewalk_override', id FROM (SELECT sidewalk_override_id AS id
                    FROM sidewalk_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'kerb_point_override', id FROM (SELECT kerb_point_override_id AS id
                    FROM kerb_point_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'corner_override', id FROM (SELECT corner_override_id AS id
                    FROM corner_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'interconnection_override', id FROM (SELECT interconnection_override_id AS id
                    FROM interconnection_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'turn_restriction', id FROM (SELECT turn_restriction_id AS id
                    FROM turn_restriction WHERE geom && near OR coalesce(to_geom, geom) && near
                        OR via_axes IS NOT NULL AND via_geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'control_point', id FROM (SELECT control_point_id AS id
                    FROM control_point WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'overpass_override', id FROM (SELECT overpass_override_id AS id
                    FROM overpass_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'junction_override', id FROM (SELECT junction_override_id AS id
                    FROM junction_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'controller_override', id FROM (SELECT controller_override_id AS id
                    FROM controller_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'road_override', id FROM (SELECT road_override_id AS id
                    FROM road_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'ramp_override', id FROM (SELECT ramp_override_id AS id
                    FROM ramp_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'height_override', id FROM (SELECT height_override_id AS id
                    FROM height_override WHERE geom && near ORDER BY id FOR UPDATE) r
                UNION ALL SELECT 'lane_adjacency_override', id FROM (SELECT lane_adjacency_override_id AS id
                    FROM lane_adjacency_override WHERE geom && near ORDER BY id FOR UPDATE) r) h(relation, id));
                IF streetgen._live(current_schema()) THEN
                    -- Control points are many, and only those on a changed axis move. One off all axes names none.
                    concerned := ARRAY(
                        SELECT o.axis_id FROM override_place o WHERE o.geom && near
                            AND (relation <> 'control_point' OR o.geom && ST_Expand(extent, o.reach))
                        UNION SELECT a.axis_id FROM override_place o JOIN axis a ON ST_DWithin(a.geom, o.geom, o.reach)
                            WHERE o.geom && near
                            AND (relation <> 'control_point' OR o.geom && ST_Expand(extent, o.reach)));
                    IF concerned <> '{}' THEN
                        PERFORM FROM streetgen._lock_places(current_schema(), concerned || axes, wait => true);
                    END IF;
                END IF;
                EXIT WHEN NOT EXISTS (SELECT FROM override_place WHERE geom && near
                    AND concat(relation, override_id) <> ALL (held));
                -- One that came while this waited may be held by who waits for this one's: all is given back.
                RAISE SQLSTATE 'SG001';
            EXCEPTION WHEN SQLSTATE 'SG001' THEN
                NULL;
            END;
        END LOOP;
        IF concerned <> '{}' THEN
            -- Streets follow the changes below with the axes, and not on their own.
            PERFORM streetgen._note_remapped(current_schema(), coalesce(streetgen._remapped(current_schema()), '{}'));
        END IF;
        IF held <> '{}' THEN
            PERFORM _move_overrides(axes, lines_before, lines_after, extent);
        END IF;
    END $body$;
    PERFORM streetgen._make_moved_overrides(model);
    PERFORM streetgen._own_function(model, '_remap(bigint[], geometry[], geometry[])',
        'Puts the overrides near changed axes on the axis that they lie on now: axes with their lines before and '
        'after, NULL where there was or is none');
    PERFORM streetgen._follow_axes(model, 'remap', 'override_place', '_remap',
        'overrides stay on the piece of road where they lie');
END $$;
COMMENT ON FUNCTION streetgen._make_remap(name) IS
    'Makes the view override_place of a model and the triggers on its axes that keep overrides where they lie.';
