-- Columns that models of older builds lack, with what they mean for the rows that are there.

CREATE OR REPLACE FUNCTION streetgen._lacks_column(model name, relation name, attribute name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT to_regclass(format('%I.%I', model, relation)) IS NOT NULL AND NOT EXISTS (SELECT FROM pg_attribute
        WHERE attrelid = to_regclass(format('%I.%I', model, relation)) AND attname = attribute) $$;
COMMENT ON FUNCTION streetgen._lacks_column(name, name, name) IS
    'Does a model have a table without a column of that name?';

CREATE OR REPLACE FUNCTION streetgen._add_both_ways(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
DECLARE
    statement text;
BEGIN
    IF NOT streetgen._lacks_column(model, 'axis', 'lanes_both') THEN
        RETURN;
    END IF;
    -- Lanes computed before have one direction each.
    FOREACH statement IN ARRAY ARRAY[
        'ALTER TABLE %1$I.axis ADD lanes_both integer CHECK (lanes_both BETWEEN 0 AND 30)',
        'ALTER TABLE %1$I.turn_restriction ADD except_kinds text CHECK (except_kinds '
            '~ ''^(bus|cycle)(\|(bus|cycle)){0,9}$'')',
        'ALTER TABLE %1$I.lane_override ADD both_ways boolean',
        'ALTER TABLE %1$I.interconnection_override ADD along_in boolean, ADD along_out boolean',
        'ALTER TABLE %1$I.edge ADD lanes_both integer NOT NULL DEFAULT 0',
        'ALTER TABLE %1$I.edge ALTER lanes_both DROP DEFAULT',
        'ALTER TABLE %1$I.lane ADD both_ways boolean NOT NULL DEFAULT false CHECK (along_axis OR NOT both_ways)',
        'ALTER TABLE %1$I.marking ADD along_axis boolean, DROP CONSTRAINT IF EXISTS '
            'marking_edge_id_kind_lane_position_key,
            ADD UNIQUE (edge_id, kind, lane_position, along_axis)',
        'UPDATE %1$I.marking m SET along_axis = coalesce((SELECT l.along_axis FROM %1$I.lane l
            WHERE (l.edge_id, l.lane_position) = (m.edge_id, m.lane_position)), true)',
        'ALTER TABLE %1$I.marking ALTER along_axis SET NOT NULL',
        'ALTER TABLE %1$I.interconnection ADD along_in boolean, ADD along_out boolean,
            DROP CONSTRAINT IF EXISTS interconnection_lane_in_lane_out_key,
            ADD UNIQUE (lane_in, lane_out, along_in, along_out)',
        'UPDATE %1$I.interconnection c SET along_in = i.along_axis, along_out = o.along_axis
            FROM %1$I.lane i, %1$I.lane o WHERE (i.lane_id, o.lane_id) = (c.lane_in, c.lane_out)',
        'ALTER TABLE %1$I.interconnection ALTER along_in SET NOT NULL, ALTER along_out SET NOT NULL'
    ] LOOP
        EXECUTE format(statement, model);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._add_both_ways(name) IS
    'Adds to the tables of a model what lanes for both directions and exceptions of turn restrictions are told by, '
    'where it was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_sidewalks(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'axis', 'sidewalk_left') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %1$I.axis ADD sidewalk_left float8 CHECK (sidewalk_left BETWEEN 0 AND 50),
        ADD sidewalk_right float8 CHECK (sidewalk_right BETWEEN 0 AND 50)', model);
    EXECUTE format('ALTER TABLE %1$I.edge ADD sidewalk_left float8 NOT NULL DEFAULT 0,
        ADD sidewalk_right float8 NOT NULL DEFAULT 0', model);
    EXECUTE format('ALTER TABLE %1$I.edge ALTER sidewalk_left DROP DEFAULT, ALTER sidewalk_right DROP DEFAULT', model);
END $$;
COMMENT ON FUNCTION streetgen._add_sidewalks(name) IS
    'Adds the columns of axis and edge that say how wide sidewalks are, where a model was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_roadway_offset(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'axis', 'roadway_offset') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %1$I.axis ADD roadway_offset float8 CHECK (roadway_offset BETWEEN -100 AND 100)',
        model);
    EXECUTE format('ALTER TABLE %1$I.edge ADD roadway_offset float8 NOT NULL DEFAULT 0', model);
    EXECUTE format('ALTER TABLE %1$I.edge ALTER roadway_offset DROP DEFAULT', model);
    EXECUTE format('CREATE INDEX axis_roadway_offset ON %1$I.axis (roadway_offset) WHERE roadway_offset <> 0', model);
    EXECUTE format('DROP INDEX IF EXISTS %1$I.edge_width', model);
    EXECUTE format('CREATE INDEX edge_reach ON %1$I.edge ((greatest(width, width_end) + 2 * abs(roadway_offset)))',
        model);
END $$;
COMMENT ON FUNCTION streetgen._add_roadway_offset(name) IS
    'Adds the columns of axis and edge that say how far the roadway lies beside the axis, '
    'where a model was made before '
    'them.';

CREATE OR REPLACE FUNCTION streetgen._add_merging_lanes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'lane', 'start_abscissa') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %I.lane ADD start_abscissa float8, ADD end_abscissa float8, '
        'DROP CONSTRAINT IF EXISTS lane_kind_check, ADD CONSTRAINT lane_kind_check CHECK (kind IN (%s))', model,
        '''general'', ''bus'', ''cycle'', ''parking'', ''merging''');
END $$;
COMMENT ON FUNCTION streetgen._add_merging_lanes(name) IS
    'Adds to the lanes of a model their kind merging and the columns that say where one begins and ends, where the '
    'model was made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_lane_changes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- No trigger takes this change for an edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'lane_separator', 'leftwards') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %I.lane_separator ADD leftwards boolean, ADD rightwards boolean', model);
    -- The next run reads lane changes of sources and those by hand, which the paint does not tell.
    EXECUTE format('UPDATE %I.lane_separator SET leftwards = dashed, rightwards = dashed', model);
    EXECUTE format('ALTER TABLE %I.lane_separator ALTER leftwards SET NOT NULL, ALTER rightwards SET NOT NULL', model);
END $$;
COMMENT ON FUNCTION streetgen._add_lane_changes(name) IS
    'Adds the columns of lane_separator that say who may cross a line between lanes, where a model was made before '
    'them: over a dashed line all may.';

CREATE OR REPLACE FUNCTION streetgen._add_roundabout_faces(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'roundabout_edge', 'face') THEN
        RETURN;
    END IF;
    -- Rings computed before have one face each.
    EXECUTE format('ALTER TABLE %I.roundabout_edge ADD face integer NOT NULL DEFAULT 1', model);
    EXECUTE format('ALTER TABLE %I.roundabout_edge ALTER face DROP DEFAULT', model);
END $$;
COMMENT ON FUNCTION streetgen._add_roundabout_faces(name) IS
    'Adds the column that says which face of its ring an edge bounds, where a model was made before double '
    'roundabouts.';

CREATE OR REPLACE FUNCTION streetgen._add_class_meanings(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'axis_class', 'highway_role') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %I.axis_class ADD highway_role text
            CHECK (highway_role IN (''highway'', ''fast_road'', ''highway_link'', ''link'')),
        ADD walked_along boolean NOT NULL DEFAULT true, ADD crossed_on_foot boolean NOT NULL DEFAULT true,
        ADD lanes_by_width boolean NOT NULL DEFAULT true', model);
    EXECUTE format('UPDATE %I.axis_class c SET (highway_role, walked_along, crossed_on_foot, lanes_by_width)
        = (d.highway_role, d.walked_along, d.crossed_on_foot, d.lanes_by_width)
        FROM streetgen._default_axis_class() d WHERE d.class = c.class', model);
    -- A class of the user's that was told by its last letters.
    EXECUTE format('UPDATE %I.axis_class SET highway_role = ''link'' WHERE class LIKE ''%%\_link''
        AND highway_role IS NULL', model);
END $$;
COMMENT ON FUNCTION streetgen._add_class_meanings(name) IS
    'Adds the columns of axis_class that say what a class means for ramps, people on foot and lanes, where a model was '
    'made before them.';

CREATE OR REPLACE FUNCTION streetgen._add_section_borders(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF streetgen._lacks_column(model, 'section', 'borders') THEN
        EXECUTE format('ALTER TABLE %I.section ADD borders float8[]', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._add_section_borders(name) IS
    'Adds the column that says where the borders of the roadway run, where a model was made before it; the next run '
    'fills it.';

CREATE OR REPLACE FUNCTION streetgen._add_ties(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Filling in a column is no edit by hand.
    SET streetgen.computes = 'on'
    AS $$
BEGIN
    IF NOT streetgen._lacks_column(model, 'profile', 'tied_from') THEN
        RETURN;
    END IF;
    EXECUTE format('ALTER TABLE %I.profile ADD tied_from boolean NOT NULL DEFAULT false,
        ADD tied_to boolean NOT NULL DEFAULT false', model);
    -- Heights in the end tell this for the most part; the next run knows more.
    EXECUTE format('UPDATE %I.profile SET tied_from = true, tied_to = true WHERE method <> ''ground''', model);
    EXECUTE format('ALTER TABLE %I.profile ALTER tied_from DROP DEFAULT, ALTER tied_to DROP DEFAULT', model);
    EXECUTE format('DROP INDEX IF EXISTS %I.profile_off_ground', model);
    EXECUTE format('CREATE INDEX profile_off_ground ON %I.profile (edge_id)
        WHERE method <> ''ground'' OR tied_from OR tied_to', model);
    EXECUTE format('CREATE INDEX IF NOT EXISTS node_without_height ON %I.node USING gist (geom)
        WHERE ST_Z(geom) NOT BETWEEN -500 AND 10000', model);
END $$;
COMMENT ON FUNCTION streetgen._add_ties(name) IS
    'Adds the columns that say at which nodes heights are found together, where a model was made before them.';

CREATE OR REPLACE FUNCTION streetgen._keep_functions_for_owner(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    named bigint[];
    part text;
BEGIN
    IF NOT EXISTS (SELECT FROM pg_constraint WHERE conrelid = format('%I.controller_override', model)::regclass
        AND conname = 'controller_override_program_check') THEN
        EXECUTE format('WITH named AS (UPDATE %I.controller_override SET program = NULL '
            'WHERE program NOT IN (''phases'', ''paper'') RETURNING controller_override_id) '
            'SELECT array_agg(controller_override_id ORDER BY controller_override_id) FROM named', model) INTO named;
        IF named IS NOT NULL THEN
            RAISE WARNING 'rows % of %.controller_override named a function: they have the program of the model now',
                named, model USING HINT = 'Setting signal_program names a function for all of them.';
        END IF;
        EXECUTE format('ALTER TABLE %I.controller_override ADD CONSTRAINT controller_override_program_check '
            'CHECK (program IN (''phases'', ''paper''))', model);
    END IF;
    -- Rights on single columns are rights to write them, too.
    FOR part IN SELECT DISTINCT format('REVOKE %s ON %I.specialised_type FROM %s CASCADE',
            privilege_type || CASE WHEN attribute IS NULL THEN '' ELSE format(' (%I)', attribute) END, model,
            CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END)
        FROM pg_class c CROSS JOIN LATERAL (
            SELECT a.*, NULL AS attribute FROM aclexplode(c.relacl) a
            UNION ALL SELECT a.*, attname FROM pg_attribute, aclexplode(attacl) a WHERE attrelid = c.oid) held
        WHERE c.oid = to_regclass(format('%I.specialised_type', model)) AND grantee <> relowner
            AND privilege_type <> 'SELECT'
    LOOP
        EXECUTE part;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._keep_functions_for_owner(name) IS
    'Takes from the editors of a model made before that what names a function, which runs with the rights of the '
    'owner: controller_override.program and table specialised_type.';
