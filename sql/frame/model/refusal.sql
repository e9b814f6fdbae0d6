-- Refusals: an edit that cannot be is told what is wrong and what to do, and of a row of input what it may hold.
-- Constraints of its table hold too, but give neither value nor way out.

CREATE OR REPLACE FUNCTION streetgen._refuse(state text, message text, detail text DEFAULT NULL,
    hint text DEFAULT NULL, schema text DEFAULT NULL, relation text DEFAULT NULL, attribute text DEFAULT NULL,
    rule text DEFAULT NULL) RETURNS void
    LANGUAGE c VOLATILE PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_refuse';
COMMENT ON FUNCTION streetgen._refuse(text, text, text, text, text, text, text, text) IS
    'Raises an error with the SQLSTATE given, as RAISE does with the same words, but without CONTEXT: a refusal says '
    'what is wrong and what to do, and a GIS shows all of it. NULL leaves a field out. A state that is no '
    'SQLSTATE: 22023.';

CREATE OR REPLACE FUNCTION streetgen._input_rule()
    RETURNS TABLE(relation name, attribute name, expected text, way_out text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 50 SET search_path = pg_catalog
    AS $$ VALUES
    ('axis'::name, 'geom'::name, 'a line through two different places, every coordinate a number within 1e12',
        'Draw it again, or undo the edit.'),
    ('axis', 'width', '0.001 to 200 m', 'Leave it empty to have it estimated.'),
    ('axis', 'width_end', '0.001 to 200 m', 'Leave it empty where the width stays the same.'),
    ('axis', 'roadway_offset', '-100 to 100 m', 'Leave it empty where the axis runs along the middle.'),
    ('axis', 'lane_count', '1 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'direction', 'both, direct (that of the line) or reverse', 'Leave it out for both.'),
    ('axis', 'speed', '0.001 to 400 km/h', 'Leave it empty to have it estimated.'),
    ('axis', 'importance', '1 to 99, 1 the highest', 'Leave it empty to take that of the class.'),
    ('axis', 'level', '-50 to 50', 'Leave it out for 0, the ground.'),
    ('axis', 'radius', '0 to 200 m', 'Leave it empty to have it estimated, 0 for no arc.'),
    ('axis', 'lanes_forward', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'lanes_backward', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'lanes_both', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'flow', '0 to 1000000 vehicles an hour', 'Leave it empty where it is unknown.'),
    ('controller_override', 'program', 'phases or paper', 'Leave it empty for setting signal_program.'),
    ('controller_override', 'cycle', '10 to 3600 s', 'Leave it empty for as long as the states last.'),
    ('controller_override', 'durations', '0.1 to 3600 s for each state', 'Leave it empty to have them computed.'),
    ('controller_override', 'start_offset', '0 to 3600 s', 'Leave it empty for 0.'),
    ('axis', 'sidewalk_left', '0 to 50 m, 0 for none', 'Leave it empty to have it estimated.'),
    ('axis', 'sidewalk_right', '0 to 50 m, 0 for none', 'Leave it empty to have it estimated.'),
    ('axis', 'kind_forward', 'kinds of lanes such as general|bus',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'kind_backward', 'kinds of lanes such as general|bus',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'lane_width_forward', 'widths in metres such as 3.5||3',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'lane_width_backward', 'widths in metres such as 3.5||3',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'turn_forward', 'turns such as left|through;right',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'turn_backward', 'turns such as left|through;right',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'change_forward', 'words such as yes|not_right|no',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'change_backward', 'words such as yes|not_right|no',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis_class', 'width', '0.001 to 200 m', 'Leave it empty to have it estimated.'),
    ('axis_class', 'speed', '0 to 400 km/h', 'Leave it empty to have it estimated.'),
    ('axis_class', 'importance', '1 to 99, 1 the highest', 'Leave it empty for setting importance_default.'),
    ('axis_class', 'highway_role', 'highway, fast_road, highway_link or link',
        'Leave it empty where the class is nothing at ramps.'),
    ('junction_override', 'kind',
        'ramp, signals, stop, priority, right_before_left, roundabout, continuation or end',
        'Leave it empty where the row decides of an edge.'),
    ('control_point', 'kind', 'signals, stop, yield, mini_roundabout or pedestrian_crossing', 'Say what stands there.'),
    ('control_point', 'abscissa', '0 m or more along the axis', 'Leave it empty: it follows from the place.'),
    ('control_point', 'axis_distance', '0 m or more from the axis', 'Leave it empty: it follows from the place.'),
    ('control_point', 'direction', 'direct, reverse or both', 'Leave it empty where it is unknown.'),
    ('turn_restriction', 'kind', 'no or only', 'no forbids the turn, only forbids all others.'),
    ('turn_restriction', 'turn', 'through, left, right or u_turn',
        'Leave it empty for all ways from the one axis to the other.'),
    ('turn_restriction', 'via_geom', 'a point on each of via_axes, every coordinate a number within 1e12',
        'Leave via_axes, via_geom and to_geom empty where it is about one node.'),
    ('turn_restriction', 'to_geom', 'a point, every coordinate a number within 1e12',
        'Leave via_axes, via_geom and to_geom empty where it is about one node.'),
    ('turn_restriction', 'except_kinds', 'bus, cycle or bus|cycle', 'Leave it empty where it binds all traffic.'),
    ('transition_override', 'which', 'start or end', 'It is the end of the axis where the width changes.'),
    ('transition_override', 'kind', 'symmetric, left or right', 'Leave it empty for setting transition_kind.'),
    ('transition_override', 'length', '0 to 200 m', 'Leave it empty for setting transition_length.'),
    ('lane_override', 'abscissa', '0 m or more along the axis', 'Edit lane_editing, which fills it.'),
    ('lane_override', 'ordinality', '1 to 60', 'Lanes are numbered from the middle outwards.'),
    ('lane_override', 'width', '0.1 to 200 m', 'Leave it empty to have it computed.'),
    ('lane_override', 'line', 'a line with every coordinate a number within 1e12',
        'Leave it empty to have it computed.'),
    ('lane_adjacency_override', 'abscissa', '0 m or more along the axis', 'Edit lane_adjacency_editing, which fills '
        'it.'),
    ('lane_adjacency_override', 'lane_from', '1 to 60', 'Lanes are numbered from the middle outwards.'),
    ('lane_adjacency_override', 'lane_to', '1 to 60', 'Lanes are numbered from the middle outwards.'),
    ('lane_adjacency_override', 'change', 'allowed or forbidden', 'Delete the row to have it computed.'),
    ('sidewalk_override', 'abscissa', '0 m or more along the axis', 'Edit sidewalk_editing, which fills it.'),
    ('sidewalk_override', 'side', 'left or right', 'It is the side of the axis.'),
    ('sidewalk_override', 'width', '0 to 50 m', '0 takes the sidewalk away; delete the row to have it computed.'),
    ('section_limit_override', 'abscissa', '0 m or more along the axis', 'Edit section_limit_editing, which fills it.'),
    ('section_limit_override', 'which', 'start or end', 'It is the end of the edge that the limit is at.'),
    ('corner_override', 'radius', '0 to 200 m', '0 for no arc; delete the row to have it computed.'),
    ('kerb_point_override', 'abscissa', '0 m or more along the axis', 'Leave it empty: it follows from the place.'),
    ('kerb_point_override', 'width', '0.001 to 200 m', 'Leave it empty: it is twice the distance from the axis.'),
    ('block_override', 'kind', 'block, island or strip', 'Delete the row to have it computed.'),
    ('road_override', 'abscissa', '0 m or more along the axis', 'Edit road_arc_editing, which fills it.'),
    ('road_override', 'radius', '0 to 4000 m', '0 for a sharp bend; delete the row to have it computed.'),
    ('ramp_override', 'abscissa', '0 m or more along the axis', 'Edit ramp_editing, which fills it.'),
    ('ramp_override', 'tangent', '0 to 1000 m', 'Leave it empty for setting ramp_tangent.'),
    ('ramp_override', 'length', '0 to 1000 m', '0 for no merging lane; leave it empty for setting merging_length.'),
    ('height_override', 'abscissa', '0 m or more along the axis', 'Edit height_editing, which fills it.'),
    ('height_override', 'height', '-1000 to 10000 m', 'Delete the row to have the height computed.'),
    ('overpass_override', 'clearance', '0 to 100 m', 'Leave it empty for setting clearance.'),
    ('interconnection_override', 'lane_in', '1 to 60', 'Lanes are numbered from the middle outwards.'),
    ('interconnection_override', 'lane_out', '1 to 60', 'Lanes are numbered from the middle outwards.'),
    ('interconnection_override', 'control', 'a point, every coordinate a number within 1e12',
        'Leave it empty to have it computed.')
    $$;
COMMENT ON FUNCTION streetgen._input_rule() IS
    'What the constraints on columns of input tables ask for, in words, and the way out.';

CREATE OR REPLACE FUNCTION streetgen._conditions(input regclass)
    RETURNS TABLE(attribute name, condition text, sqlstate text, name name)
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
    SELECT attname, c.* FROM pg_attribute a CROSS JOIN LATERAL (
        SELECT format('%I IS NOT NULL', attname), '23502', NULL::name WHERE attnotnull
        UNION ALL SELECT pg_get_expr(conbin, conrelid), '23514', conname FROM pg_constraint WHERE conrelid = input
            AND contype = 'c' AND conkey = ARRAY[attnum]) c
    WHERE attrelid = input AND attnum > 0 AND NOT attisdropped ORDER BY attnum, 3
    $$;
COMMENT ON FUNCTION streetgen._conditions(regclass) IS
    'What holds for each column of a table: NOT NULL and the constraints that name it alone, as SQL, with the '
    'SQLSTATE of a row that breaks it.';

CREATE OR REPLACE FUNCTION streetgen._refuse_row() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    broken record;
    rule record;
    key text;
    value text;
    holds boolean;
BEGIN
    FOR broken IN SELECT c.*, atttypid, attidentity, (SELECT k.attname FROM pg_attribute k WHERE k.attrelid = TG_RELID
        AND k.attnum = 1) AS key
        FROM streetgen._conditions(TG_RELID) c JOIN pg_attribute ON attrelid = TG_RELID AND attname = attribute
        -- The place comes first: columns that are left out follow from it.
        ORDER BY atttypid <> 'geometry'::regtype, attnum
    LOOP
        EXECUTE format('SELECT %s, %I::text, %s FROM (SELECT ($1).*) r', broken.condition, broken.key,
            format(CASE broken.atttypid WHEN 'geometry'::regtype THEN 'left(ST_AsText(%I), 80)' WHEN 'text'::regtype
                THEN 'to_json(%I)::text' ELSE '%I::text' END, broken.attribute)) INTO holds, key, value USING NEW;
        IF holds IS FALSE THEN
            SELECT expected, way_out INTO rule FROM streetgen._input_rule()
                WHERE (relation, attribute) = (TG_TABLE_NAME, broken.attribute);
            PERFORM streetgen._refuse(broken.sqlstate,
                format('the %s of %s cannot be %s', broken.attribute, concat_ws(' ', CASE TG_OP WHEN 'INSERT'
                    THEN 'the new' END, replace(TG_TABLE_NAME, '_', ' '), key), coalesce(value, 'NULL')),
                detail => format('Expected %s.', coalesce(rule.expected, CASE broken.atttypid WHEN 'geometry'::regtype
                    THEN 'a place, every coordinate a number within 1e12' ELSE 'a value' END)),
                hint => coalesce(rule.way_out, CASE WHEN broken.attidentity <> ''
                    THEN 'Leave it out: it is numbered by itself.' ELSE 'Fill it, or undo the edit.' END),
                schema => TG_TABLE_SCHEMA, relation => TG_TABLE_NAME, attribute => broken.attribute,
                rule => broken.name);
        END IF;
    END LOOP;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._refuse_row() IS
    'Trigger of input tables, for rows that a constraint would refuse: names row, column and value, what is expected '
    'and the way out, with the SQLSTATE of the constraint (23514, 23502). A constraint that is no longer there '
    'refuses nothing.';

CREATE OR REPLACE FUNCTION streetgen._make_refusals(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    ruled record;
    former record;
BEGIN
    -- Models of older builds have a trigger a column.
    FOR former IN SELECT tgname AS name, tgrelid::regclass AS input FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid
        WHERE relnamespace = quote_ident(model)::regnamespace AND tgname <> 'refuse'
            AND tgfoid = 'streetgen._refuse_row()'::regprocedure
    LOOP
        EXECUTE format('DROP TRIGGER %I ON %s', former.name, former.input);
    END LOOP;
    FOR ruled IN
        SELECT c.oid::regclass AS input, string_agg(DISTINCT quote_ident(attribute), ', ') AS attributes,
            string_agg(regexp_replace(condition, format('\m%s\M', attribute), format('NEW.%I', attribute), 'g'),
            ' AND ' ORDER BY attribute, condition) AS condition
        FROM pg_class c CROSS JOIN LATERAL streetgen._conditions(c.oid)
        -- Columns that others added keep to their constraints: a trigger would bar them from being dropped or altered.
        JOIN streetgen._model_column() USING (attribute)
        WHERE relation = relname AND relnamespace = quote_ident(model)::regnamespace
            AND relname = ANY (streetgen._street_input(model) || 'axis_class'::name)
        GROUP BY c.oid
    LOOP
        -- The condition is read with the row; the function is called for a row that breaks it.
        EXECUTE format('CREATE OR REPLACE TRIGGER refuse BEFORE INSERT OR UPDATE OF %s ON %s FOR EACH ROW WHEN ((%s) '
            'IS FALSE) EXECUTE FUNCTION streetgen._refuse_row()', ruled.attributes, ruled.input, ruled.condition);
        EXECUTE format('COMMENT ON TRIGGER refuse ON %s IS %L', ruled.input,
            'Says what a column may hold, before its constraint refuses the row');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_refusals(name) IS
    'Makes the triggers on the input tables of a model that say what is wrong with a row and what to do.';
