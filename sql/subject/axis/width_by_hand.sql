-- A width put by hand is always believed, one of a source where its lanes can need it: up to setting max_width_per_lane
-- for each, and from lane_width_minimal on.

CREATE OR REPLACE FUNCTION streetgen._add_width_by_hand(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    ALTER TABLE axis ADD IF NOT EXISTS width_by_hand boolean NOT NULL DEFAULT false,
        ADD IF NOT EXISTS source_width float8, ADD IF NOT EXISTS source_width_end float8;
END $$;
COMMENT ON FUNCTION streetgen._add_width_by_hand(name) IS
    'Adds the columns of axis that tell a width put by hand from one of the source, where they are missing.';

CREATE OR REPLACE FUNCTION streetgen._width_by_hand() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    emptied constant boolean := NEW.width IS NULL
        AND (NEW.width_end IS NULL OR NEW.width_end IS NOT DISTINCT FROM OLD.width_end);
BEGIN
    -- Importers write what the source says with its line and its hash, one of which is another then. Who puts back
    -- what was writes all of it.
    IF (NEW.source_hash, NEW.source_geom) IS DISTINCT FROM (OLD.source_hash, OLD.source_geom)
        OR current_setting('streetgen.puts_back', true) = 'on' THEN
        RETURN NEW;
    END IF;
    IF OLD.width_by_hand AND (emptied OR NOT NEW.width_by_hand) THEN
        NEW.width := OLD.source_width;
        NEW.width_end := OLD.source_width_end;
    END IF;
    NEW.width_by_hand := NOT emptied AND (NEW.width_by_hand OR NOT OLD.width_by_hand);
    IF NOT NEW.width_by_hand THEN
        NEW.source_width := NULL;
        NEW.source_width_end := NULL;
    ELSIF NOT OLD.width_by_hand AND NEW.source IS NOT NULL THEN
        NEW.source_width := OLD.width;
        NEW.source_width_end := OLD.width_end;
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._width_by_hand() IS
    'Trigger of axis, for an update of width or width_end that is not the source''s: the width is put by hand, and '
    'that of the source kept beside it. An empty width, or width_by_hand set to false, gives the axis that of the '
    'source back.';

CREATE OR REPLACE FUNCTION streetgen._make_axis_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE TRIGGER by_hand BEFORE UPDATE OF width, width_end, width_by_hand ON axis FOR EACH ROW
        WHEN ((NEW.width, NEW.width_end, NEW.width_by_hand)
            IS DISTINCT FROM (OLD.width, OLD.width_end, OLD.width_by_hand))
        EXECUTE FUNCTION streetgen._width_by_hand();
    COMMENT ON TRIGGER by_hand ON axis IS 'Tells a width put by hand from one of the source';
    CREATE OR REPLACE TRIGGER by_hand BEFORE UPDATE OF lanes_one_way, width_one_way ON axis_class FOR EACH ROW
        WHEN (NEW.lanes_one_way_by IS NOT DISTINCT FROM OLD.lanes_one_way_by)
        EXECUTE FUNCTION streetgen._class_by_hand();
    COMMENT ON TRIGGER by_hand ON axis_class IS 'Tells lanes put by hand from those that an import learned';
    PERFORM streetgen._make_axis_follower(model);
END $$;
COMMENT ON FUNCTION streetgen._make_axis_functions(name) IS
    'Makes the triggers of a model that tell widths and lanes of classes put by hand from those of a source, and the '
    'function by which streets follow axes.';

CREATE OR REPLACE FUNCTION streetgen._unbelieved(model name, axes bigint[] DEFAULT NULL)
    RETURNS TABLE(axis_id bigint, attribute text, width float8, taken float8, too_small boolean, lane_count integer,
        source_ref text, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
        -- One plan for all axes would not reach some by their keys.
        SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
DECLARE
    doubted bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    -- To plan the values used costs more than to see that there is nothing to doubt, and to compute those of all axes
    -- more than of these.
    SELECT array_agg(a.axis_id) FROM axis a WHERE (axes IS NULL OR a.axis_id = ANY (axes) AND a.lane_count IS NOT NULL)
        AND NOT a.width_by_hand AND a.source IS NOT NULL AND (a.width IS NOT NULL OR a.width_end IS NOT NULL)
        INTO doubted;
    IF doubted IS NULL THEN
        RETURN;
    END IF;
    RETURN QUERY SELECT a.axis_id, w.attribute, w.width, w.taken, NOT s.estimated, a.lane_count, a.source_ref,
            a.geom::geometry
        FROM axis a JOIN axis_used u USING (axis_id),
            LATERAL (VALUES ('width', a.width, u.width), ('width_end', a.width_end, u.width_end))
                w(attribute, width, taken), LATERAL (SELECT w.attribute = ANY (u.estimated) AS estimated) s
        -- Both relations are narrowed: the planner computes the values used of all axes otherwise.
        WHERE a.axis_id = ANY (doubted) AND u.axis_id = ANY (doubted) AND NOT u.by_area
            AND w.width IS NOT NULL AND CASE WHEN s.estimated THEN a.lane_count IS NOT NULL
                ELSE w.width < w.taken AND NOT EXISTS (SELECT FROM kerb_point_override k
                    WHERE k.axis_id = a.axis_id) END
        ORDER BY 1, 2;
END $$;
COMMENT ON FUNCTION streetgen._unbelieved(name, bigint[]) IS
    'The widths (metres, in column width or width_end) that sources give the axes of a model, or some of them, and '
    'that are not believed, or are too small for their lanes, and what they are taken as.';

CREATE OR REPLACE FUNCTION streetgen._wide_by_hand(model name, axes bigint[])
    RETURNS TABLE(axis_id bigint, attribute text, width float8, lane_count integer)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    bound float8;
    lane float8;
    cycle_lane float8;
    parking_lane float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT (max(value) FILTER (WHERE name = 'max_width_per_lane'))::float8,
        (max(value) FILTER (WHERE name = 'lane_width'))::float8,
        (max(value) FILTER (WHERE name = 'cycle_lane_width'))::float8,
        (max(value) FILTER (WHERE name = 'parking_lane_width'))::float8 FROM setting
        INTO bound, lane, cycle_lane, parking_lane;
    RETURN QUERY SELECT a.axis_id, w.attribute, w.width, a.lane_count
        FROM axis a LEFT JOIN axis_class c ON c.class = a.kind,
            LATERAL (VALUES ('width', a.width), ('width_end', a.width_end)) w(attribute, width)
        WHERE a.axis_id = ANY (axes) AND (a.width_by_hand OR a.source IS NULL) AND c.lanes_by_width IS NOT FALSE
            AND NOT streetgen._names_ring(a.roundabout_tag)
            AND streetgen.believed_width(w.width
                - streetgen._kerbside_width(a.kind_forward, a.lane_width_forward, lane, cycle_lane, parking_lane)
                - streetgen._kerbside_width(a.kind_backward, a.lane_width_backward, lane, cycle_lane, parking_lane),
                a.lane_count, bound) IS NULL AND w.width IS NOT NULL ORDER BY 1, 2;
END $$;
COMMENT ON FUNCTION streetgen._wide_by_hand(name, bigint[]) IS
    'The widths (metres) of some axes of a model that would not be believed of a source, and are by hand.';

CREATE OR REPLACE FUNCTION streetgen._tell_later(model name, axes bigint[]) RETURNS boolean
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    -- The model, and its axes so far.
    gathered constant text[] := nullif(current_setting('streetgen.edited_axes', true), '');
BEGIN
    IF gathered[1] = model THEN
        PERFORM set_config('streetgen.edited_axes', (gathered || axes::text[])::text, true);
        RETURN true;
    END IF;
    RETURN false;
END $$;
COMMENT ON FUNCTION streetgen._tell_later(name, bigint[]) IS
    'Whether a statement on axis_editing of a model is under way, which edits row by row and tells of all rows at its '
    'end; it gathers the axes whose widths are not believed.';

CREATE OR REPLACE FUNCTION streetgen._tell_edited_axes() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    gathered constant text[] := nullif(current_setting('streetgen.edited_axes', true), '');
BEGIN
    PERFORM set_config('streetgen.edited_axes', CASE TG_WHEN WHEN 'BEFORE' THEN ARRAY[TG_TABLE_SCHEMA]::text ELSE ''
        END, true);
    IF TG_WHEN = 'AFTER' THEN
        PERFORM streetgen._tell_unbelieved(TG_TABLE_SCHEMA, gathered[2:]::bigint[]);
    END IF;
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._tell_edited_axes() IS
    'Trigger of axis_editing, before and after a statement: tells once of all its rows which widths are not believed.';

CREATE OR REPLACE FUNCTION streetgen._make_axis_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE TRIGGER gather_axes BEFORE INSERT OR UPDATE ON axis_editing
        FOR EACH STATEMENT EXECUTE FUNCTION streetgen._tell_edited_axes();
    CREATE OR REPLACE TRIGGER tell_axes AFTER INSERT OR UPDATE ON axis_editing
        FOR EACH STATEMENT EXECUTE FUNCTION streetgen._tell_edited_axes();
    COMMENT ON TRIGGER gather_axes ON axis_editing IS 'Begins to gather the axes that a statement edits';
    COMMENT ON TRIGGER tell_axes ON axis_editing IS 'Tells which widths of the statement are not believed';
END $$;
COMMENT ON FUNCTION streetgen._make_axis_edit_views(name) IS
    'Makes the triggers of axis_editing that tell once a statement which widths are not believed.';

CREATE OR REPLACE FUNCTION streetgen._tell_unbelieved(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bound text;
    first record;
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NULL OR axes = '{}' THEN
        RETURN;
    END IF;
    SELECT *, count(*) OVER (PARTITION BY by_hand) - 1 AS others, array_agg(axis_id) OVER () AS all_axes INTO first
        FROM (SELECT axis_id, attribute, width, lane_count, false AS by_hand
                FROM streetgen._unbelieved(model, axes) WHERE NOT too_small
            UNION ALL SELECT *, true FROM streetgen._wide_by_hand(model, axes)) w ORDER BY by_hand, axis_id LIMIT 1;
    IF FOUND AND NOT streetgen._tell_later(model, first.all_axes)
        AND streetgen._first_in_statement('widths', model) THEN
        SELECT value FROM setting WHERE name = 'max_width_per_lane' INTO bound;
        RAISE NOTICE '% % m of axis % is %, with lane_count %: setting max_width_per_lane is % m%',
            first.attribute, first.width, first.axis_id,
            CASE WHEN first.by_hand THEN 'taken, since it is by hand' ELSE 'not believed' END, first.lane_count, bound,
            CASE WHEN first.others = 0 THEN '' WHEN first.by_hand THEN format('; so are %s others', first.others)
                ELSE format('; nor are %s others', first.others) END
            USING DETAIL = CASE WHEN first.by_hand THEN 'That of a source would not be believed.'
                    ELSE 'It is estimated.' END,
                HINT = CASE WHEN first.by_hand THEN 'Correct width or lane_count where one is a slip.'
                    ELSE format('A width put by hand is believed. SELECT * FROM streetgen.check_model(%L) lists '
                    'all that are not; SELECT streetgen.set(%1$L, ''max_width_per_lane'', NULL) believes all.', model)
                    END;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._tell_unbelieved(name, bigint[]) IS
    'A notice where a source gives some of the axes a width that is not believed, or somebody by hand one that would '
    'not be: the first with its axis and the setting, and how many others there are.';
