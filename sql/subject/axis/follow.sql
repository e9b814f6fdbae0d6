-- The streets follow an edit of axes.

CREATE OR REPLACE FUNCTION streetgen._make_axis_follower(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _follow_axis() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT SET plan_cache_mode = force_generic_plan
        AS $body$
    DECLARE
        changed bigint[];
        elsewhere bigint[];
        -- Axes whose width is new, or what it is judged by.
        judged bigint[];
        labelled constant text :=
            'SELECT ''axis '' || axis_id AS label, geom FROM %I.axis WHERE axis_id = ANY (%L)';
        live boolean := streetgen._live(current_schema());
        -- Axes whose overrides moved with these.
        remapped constant bigint[] := streetgen._remapped(current_schema());
    BEGIN
        IF remapped IS NOT NULL THEN
            PERFORM streetgen._note_remapped(current_schema(), NULL);
        END IF;
        IF TG_OP = 'TRUNCATE' THEN
            IF live THEN
                EXECUTE (SELECT 'TRUNCATE ' || string_agg(format('%I.%I', current_schema(), r), ', ' ORDER BY n)
                    FROM unnest(streetgen._computed_tables(current_schema())) WITH ORDINALITY t(r, n));
                PERFORM pg_notify('qgis', current_schema());
            END IF;
            RETURN NULL;
        ELSIF TG_OP = 'INSERT' THEN
            changed := ARRAY(SELECT axis_id FROM new_axis);
            judged := ARRAY(SELECT axis_id FROM new_axis WHERE lane_count IS NOT NULL
                AND coalesce(width, width_end) IS NOT NULL);
        ELSIF TG_OP = 'DELETE' THEN
            changed := ARRAY(SELECT axis_id FROM old_axis);
        ELSE
            changed := ARRAY(SELECT axis_id FROM (SELECT o.axis_id FROM old_axis o LEFT JOIN new_axis n USING (axis_id)
                WHERE o IS DISTINCT FROM n
                                                  UNION SELECT n.axis_id FROM new_axis n
                                                      LEFT JOIN old_axis o USING (axis_id) WHERE o.axis_id IS NULL) c);
            judged := ARRAY(SELECT axis_id FROM new_axis n LEFT JOIN old_axis o USING (axis_id)
                WHERE n.lane_count IS NOT NULL AND coalesce(n.width, n.width_end) IS NOT NULL
                    AND (n.width, n.width_end, n.lane_count, n.kind, n.width_by_hand)
                        IS DISTINCT FROM (o.width, o.width_end, o.lane_count, o.kind, o.width_by_hand));
        END IF;
        IF changed = '{}' THEN
            RETURN NULL;
        ELSIF TG_OP = 'DELETE' AND (NOT live OR _setting_changed()) THEN
            PERFORM streetgen._drop_results(current_schema(), changed);
        ELSIF live THEN
            -- Ten kilometres around streets that are there the scale is known to hold.
            elsewhere := ARRAY(SELECT axis_id FROM axis a WHERE axis_id = ANY (changed)
                AND (ST_Length(geom) < 1 OR NOT EXISTS (SELECT FROM edge e WHERE e.geom && ST_Expand(a.geom, 10000)
                    AND ST_Expand(e.geom, 10000) ~ a.geom OFFSET 0 LIMIT 1)));
            IF elsewhere <> '{}' THEN
                PERFORM streetgen._check_scale(lines), streetgen._warn_misplaced(lines)
                    FROM format(labelled, current_schema(), elsewhere) lines;
            END IF;
            IF EXISTS (SELECT FROM axis WHERE axis_id = ANY (changed) AND ST_Length(geom) > (SELECT value::float8
                FROM setting WHERE name = 'axis_length_maximal')) THEN
                PERFORM streetgen._check_length(current_schema(), format(labelled, current_schema(), changed));
            END IF;
            IF judged <> '{}' THEN
                PERFORM streetgen._tell_unbelieved(current_schema(), judged);
            END IF;
            PERFORM streetgen._update_streets(current_schema(), changed || remapped);
        END IF;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_follow_axis()', 'After an edit of axes: the streets follow');
END $$;
COMMENT ON FUNCTION streetgen._make_axis_follower(name) IS
    'Makes the function of the triggers by which the streets of a model follow its axes.';
