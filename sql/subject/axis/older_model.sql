-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._add_roadway_offset(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'axis', 'roadway_offset') THEN
        RETURN;
    END IF;
    ALTER TABLE axis ADD roadway_offset float8 CHECK (roadway_offset BETWEEN -100 AND 100);
    ALTER TABLE edge ADD roadway_offset float8 NOT NULL DEFAULT 0;
    ALTER TABLE edge ALTER roadway_offset DROP DEFAULT;
    EXECUTE format('DROP INDEX IF EXISTS %I.edge_width', model);
END $$;
COMMENT ON FUNCTION streetgen._add_roadway_offset(name) IS
    'Adds the columns of axis and edge that say how far the roadway lies beside the axis, where a model was made '
    'before them.';

CREATE OR REPLACE FUNCTION streetgen._add_class_meanings(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'axis_class', 'highway_role') THEN
        RETURN;
    END IF;
    ALTER TABLE axis_class ADD highway_role text
            CHECK (highway_role IN ('highway', 'fast_road', 'highway_link', 'link')),
        ADD walked_along boolean NOT NULL DEFAULT true, ADD crossed_on_foot boolean NOT NULL DEFAULT true,
        ADD lanes_by_width boolean NOT NULL DEFAULT true;
    UPDATE axis_class c SET (highway_role, walked_along, crossed_on_foot, lanes_by_width)
        = (d.highway_role, d.walked_along, d.crossed_on_foot, d.lanes_by_width)
        FROM streetgen._default_axis_class() d WHERE d.class = c.class;
    -- A class of the user's that was told by its last letters.
    UPDATE axis_class SET highway_role = 'link' WHERE class LIKE '%\_link' AND highway_role IS NULL;
END $$;
COMMENT ON FUNCTION streetgen._add_class_meanings(name) IS
    'Adds the columns of axis_class that say what a class means for ramps, people on foot and lanes, where a model was '
    'made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_class_lanes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'axis_class', 'lanes_one_way') THEN
        RETURN;
    END IF;
    ALTER TABLE axis_class ADD lanes_one_way integer CHECK (lanes_one_way BETWEEN 1 AND 15),
        ADD width_one_way float8 CHECK (width_one_way BETWEEN 0.001 AND 200),
        ADD lanes_each_way integer CHECK (lanes_each_way BETWEEN 1 AND 15),
        ADD parking_left float8 NOT NULL DEFAULT 0 CHECK (parking_left BETWEEN 0 AND 10),
        ADD parking_right float8 NOT NULL DEFAULT 0 CHECK (parking_right BETWEEN 0 AND 10);
END $$;
COMMENT ON FUNCTION streetgen._add_class_lanes(name) IS
    'Adds the columns of axis_class that say what lanes of one direction a class has, where a model was made before '
    'them. They stay empty: its streets are as they were.';

CREATE OR REPLACE FUNCTION streetgen._add_class_use(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._lacks_column(model, 'axis_class', 'use') THEN
        RETURN;
    END IF;
    ALTER TABLE axis_class ADD use text NOT NULL DEFAULT 'roadway'
        CHECK (use IN ('roadway', 'cycle', 'walk', 'steps', 'rail', 'none'));
    -- A class that was taken as axes stays so.
    UPDATE axis_class c SET use = d.use FROM streetgen._default_axis_class() d WHERE d.class = c.class AND NOT c.taken;
END $$;
COMMENT ON FUNCTION streetgen._add_class_use(name) IS
    'Adds the column of axis_class that says what lines of a class are, where a model was made before it. Its '
    'importers take what they took.';

CREATE OR REPLACE FUNCTION streetgen._add_later_classes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    without_busway constant boolean := streetgen._lacks_column(model, 'axis', 'access');
    without_tracks boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    without_tracks := NOT EXISTS (SELECT FROM setting WHERE name = 'track_width');
    -- Class busway came with column access, those of use rail with tracks. A class that somebody deleted since stays
    -- away.
    IF NOT (without_busway OR without_tracks) THEN
        RETURN;
    END IF;
    INSERT INTO axis_class (class, taken, width, speed, importance, highway_role, walked_along, crossed_on_foot,
            lanes_by_width, lanes_one_way, width_one_way, lanes_each_way, parking_left, parking_right, use)
        SELECT * FROM streetgen._default_axis_class() d WHERE d.class = 'busway' AND without_busway
            OR d.use = 'rail' AND without_tracks ON CONFLICT DO NOTHING;
END $$;
COMMENT ON FUNCTION streetgen._add_later_classes(name) IS
    'Adds the classes that came after the first models, where a model was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_roundabout_tag(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    ALTER TABLE axis ADD IF NOT EXISTS roundabout_tag text;
END $$;
COMMENT ON FUNCTION streetgen._add_roundabout_tag(name) IS
    'Adds the word of the source for a roundabout where a model was made before.';

CREATE OR REPLACE FUNCTION streetgen._mend_axis_tables(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._lacks_column(model, 'axis', 'source_hash') THEN
        ALTER TABLE axis ADD source_hash bigint;
    END IF;
    IF streetgen._lacks_column(model, 'axis', 'flow') THEN
        ALTER TABLE axis ADD flow float8 CHECK (flow BETWEEN 0 AND 1000000);
    END IF;
    IF streetgen._lacks_column(model, 'axis', 'change_forward') THEN
        EXECUTE format('ALTER TABLE %1$I.axis ADD change_forward text CHECK (change_forward ~ %2$L),
            ADD change_backward text CHECK (change_backward ~ %2$L)', model, streetgen._lane_list_pattern('change'));
    END IF;
    PERFORM streetgen._add_roundabout_tag(model), streetgen._add_width_by_hand(model),
        streetgen._add_roadway_offset(model), streetgen._add_class_meanings(model),
        streetgen._add_class_lanes(model), streetgen._add_class_use(model),
        streetgen._add_later_classes(model);
END $$;
COMMENT ON FUNCTION streetgen._mend_axis_tables(name) IS
    'Adds to the axes of a model what older ones lack, and what came after the first models.';
