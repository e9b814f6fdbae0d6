-- Decisions by hand find their axes again after a split, merge, reversal or redraw.

CREATE OR REPLACE FUNCTION streetgen._projected(line geometry, place geometry, onto boolean, within boolean,
    former float8, OUT abscissa float8, OUT geom geometry)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN abs(at - former) < 1e-6 THEN former ELSE at END, CASE WHEN onto THEN ST_ClosestPoint(line, place)
        ELSE place END
    FROM (SELECT least(ST_LineLocatePoint(line, place) * length,
        CASE WHEN within THEN greatest(length - 0.001, length / 2) ELSE length END) AS at
        FROM (SELECT ST_Length2D(line) AS length) l) p
    $$;
COMMENT ON FUNCTION streetgen._projected(geometry, geometry, boolean, boolean, float8) IS
    'Abscissa (metres) of a line nearest to a place, the former one where it is the same within a micrometre, and '
    'a millimetre before the end at most where asked; and the place, put onto the line where asked.';

CREATE OR REPLACE FUNCTION streetgen._frame_axis_follower() RETURNS TABLE(relation name, follower name)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('override_place'::name, '_remap'::name) $$;
COMMENT ON FUNCTION streetgen._frame_axis_follower() IS 'Decisions by hand stay where they lie.';

CREATE OR REPLACE FUNCTION streetgen._make_held_decisions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._compose_function(model, '_hold_decisions(near geometry)', 'text[]', (
        SELECT format('BEGIN RETURN ARRAY(SELECT concat(relation, id) FROM (%s) h); END', string_agg(format(
            'SELECT %1$L AS relation, id FROM (SELECT %2$I AS id FROM %1$I WHERE geom && near%3$s ORDER BY id '
            'FOR UPDATE) r', relation, key, CASE anchor WHEN 'route' THEN ' OR coalesce(to_geom, geom) && near OR '
                'via_axes IS NOT NULL AND via_geom && near' ELSE '' END), ' UNION ALL ' ORDER BY n))
        FROM streetgen._decisions_of(model) WHERE axes <> '{}'), '_hold_decisions(geometry)',
        'Locks the rows of decisions within a box, table by table in one order; their tables and keys');
END $$;
COMMENT ON FUNCTION streetgen._make_held_decisions(name) IS
    'Makes the function of a model that locks the rows of decisions near changed axes.';

CREATE OR REPLACE FUNCTION streetgen._make_remap(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._make_override_view(model), streetgen._make_held_decisions(model),
        streetgen._make_moved_overrides(model), streetgen._make_written_decisions(model);
    -- Most models have few overrides, and most edits none near: a session keeps the plans.
    CREATE OR REPLACE FUNCTION _remap(axes bigint[], lines_before geometry[], lines_after geometry[]) RETURNS void
        LANGUAGE plpgsql VOLATILE SET search_path FROM CURRENT SET jit = off SET enable_seqscan = off
            SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        extent constant geometry := (SELECT ST_Extent(line)::geometry FROM unnest(lines_before || lines_after) line);
        -- Nothing beside an axis is farther from it than 100 m, and three tolerances are 30 m at most.
        near constant geometry := ST_Expand(extent, 110);
        concerned bigint[];
        held text[];
    BEGIN
        LOOP
            BEGIN
                -- Their rows first, and by one lock all their places, so that none waits for more while it holds some.
                held := _hold_decisions(near);
                IF streetgen._live(current_schema()) THEN
                    -- Places on the ground are many, and only those beside a changed axis move. One off all axes
                    -- names none.
                    concerned := ARRAY(
                        SELECT o.axis_id FROM override_place o WHERE o.geom && near
                            AND (anchor <> 'ground' OR o.geom && ST_Expand(extent, o.reach))
                        UNION SELECT a.axis_id FROM override_place o JOIN axis a ON ST_DWithin(a.geom, o.geom, o.reach)
                            WHERE o.geom && near
                            AND (anchor <> 'ground' OR o.geom && ST_Expand(extent, o.reach)));
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
    PERFORM streetgen._own_function(model, '_remap(bigint[], geometry[], geometry[])',
        'Puts the overrides near changed axes on the axis that they lie on now: axes with their lines before and '
        'after, NULL where there was or is none');
    PERFORM streetgen._follow_axes(model, 'remap', array_agg(relation), array_agg(follower),
        'overrides stay on the piece of road where they lie, and routes on their axes')
        FROM streetgen._axis_follower();
END $$;
COMMENT ON FUNCTION streetgen._make_remap(name) IS
    'Makes the view override_place of a model and the triggers on its axes by which its overrides and what else stays '
    'with axes follow.';
