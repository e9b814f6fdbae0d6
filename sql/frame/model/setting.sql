-- Settings of a model: what there is, in which range, and how one is read and changed.

CREATE OR REPLACE FUNCTION streetgen._default_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    ('tolerance', '0.5', 'm', 'ends and vertices this near to each other are one node', 0.001, 10, NULL::text[]),
    ('crossing', 'over', NULL, 'axes of one level that cross without a vertex: over (no node) or split', NULL, NULL,
        ARRAY['over', 'split']),
    ('smoothing', 'none', NULL,
        'line of an edge: none (the polyline of its axis) or arcs (straight pieces and arcs that touch them)', NULL,
        NULL, ARRAY['none', 'arcs']),
    ('smoothing_shift', '0.5', 'm', 'such a line leaves the points of the axis by at most this', 0.001, 100, NULL),
    ('smoothing_tolerance', '0.01', 'm', 'chords of such a line leave its arcs by at most this', 0.0001, 1, NULL),
    ('road_friction', '0.7', NULL, 'friction of tyres on the road, for the speed limits of bends', 0.05, 2, NULL),
    ('axis_length_maximal', '100000', 'm', 'a longer axis is refused: its coordinates are hardly metres of the model',
        1000, 10000000, NULL),
    ('max_arc_distance', '60', 'm', 'an arc centre farther from its node gets the minimal radius', 1, 1000, NULL),
    ('radius_minimal', '0.15', 'm', 'radius of a kerb stone, for arcs that lie too far away', 0.01, 5, NULL),
    ('radius_rule', 'min', NULL, 'radius of a corner from those of its two axes: min, max or mean', NULL, NULL,
        ARRAY['min', 'max', 'mean']),
    ('short_axis', 'reduce', NULL,
        'an axis too short for the wanted radius: reduce (the radius, and follow only where none fits) or follow '
        '(the next axis in its direction first)', NULL, NULL, ARRAY['reduce', 'follow']),
    ('follow_length', '10', 'm',
        'a corner between nearly parallel kerbs, or one that follows its streets, closes the ground between no '
        'farther than this from the crossing of the kerbs; NULL: however far, as the paper has it', 0, 1000, NULL),
    ('follow_area', '20', 'm2', 'nor does such a corner close more ground than this; NULL: however much', 0, 100000,
        NULL),
    ('median_width_minimal', '0.5', 'm',
        'such a corner becomes the nose of a median where the ground between the kerbs is this wide', 0.02, 100,
        NULL),
    ('island_area', '1000', 'm2',
        'in a face smaller than this between axes of one level, no longer about than twice the reach, ground with '
        'room for a disc of 1 m stays: its corners become noses where their arcs would leave none; 0: nowhere, as '
        'the paper has it', 0, 100000, NULL),
    ('island_nose_radius', '0.75', 'm', 'radius of those noses', 0.05, 15, NULL),
    ('kerb_radius_minimal', '0.5', 'm',
        'kinks of kerbs of more than 30 degrees become arcs of this radius, where no limit lies and a radius of 0 is '
        'not wanted; NULL or 0: none', 0, 15, NULL),
    ('radius_by_importance', '{"1": 8, "2": 6.25, "3": 6.25, "4": 3}', 'm',
        'wanted radius by importance; an entry holds up to the next one, the first also before itself; null: no arc; '
        'empty: turning_radius', NULL, NULL, NULL),
    ('turning_mode', 'paper', NULL, 'law of turning_radius: paper or setra', NULL, NULL, ARRAY['paper', 'setra']),
    ('turning_radius_minimal', '0.15', 'm', 'turning_radius gives no less', 0, 3, NULL),
    ('turning_radius_maximal', '15', 'm', 'turning_radius gives no more', 3, 200, NULL),
    ('radius_function', NULL, NULL,
        'wanted radius of an axis, before radius_by_importance and turning_radius: an immutable function '
        '(width float8, speed float8, importance integer, lane_count integer, kind text) returning float8, with its '
            'schema; '
        'NULL: none', NULL, NULL, NULL),
    ('transition_length', NULL, 'm', 'length of a change of width; NULL: by taper_ratio', 0, 200, NULL),
    ('taper_ratio', '{"0": 10, "70": 20, "90": 30, "110": 40}', NULL,
        'metres along the street for each metre that a kerb moves sideways at a change of width, by speed in km/h; '
        'an entry holds up to the next one', NULL, NULL, NULL),
    ('transition_kind', 'symmetric', NULL,
        'kerbs that change linearly at a change of width, seen along the axis of the smaller axis_id: symmetric, '
        'left or right', NULL, NULL, ARRAY['symmetric', 'left', 'right']),
    ('dead_end', 'flat', NULL, 'end of a dead end: flat or round', NULL, NULL, ARRAY['flat', 'round']),
    ('max_hole_area', '0.5', 'm2', 'holes of one surface under this area are filled', 0, 100, NULL),
    ('slit_width', '0.2', 'm',
        'ground between two streets of one level that run beside each other no farther apart than this is roadway; '
        '0: none', 0, 2, NULL),
    ('kerb_stone_width', '0.3', 'm', 'width of the strip of kerb stones behind a kerb', 0.01, 5, NULL),
    ('ground_level', '0', NULL, 'level of which the faces are blocks', -100, 100, NULL),
    ('block_island_area', '300', 'm2', 'a block with less ground is an island; 0: none is', 0, 100000, NULL),
    ('block_strip_width', '12', 'm',
        'a block is a strip where the rectangle of its area and perimeter is no wider, and long; 0: none is', 0, 1000,
        NULL),
    ('block_strip_elongation', '4', NULL, 'the rectangle of a strip is at least so many times as long as wide', 1,
        1000, NULL),
    ('sidewalk_by_importance', '{"1": 3, "2": 3, "3": 2.5, "4": 2, "5": 1.5}', 'm',
        'width of the sidewalks of an axis that says none, by importance; an entry holds up to the next one, the '
        'first also before itself; motorways, their links, runways and taxiways have none', NULL, NULL, NULL),
    ('sidewalk_width_minimal', '0.5', 'm', 'import_sidewalk_widths reports a narrower sidewalk and leaves it out', 0, 5,
        NULL),
    ('sidewalk_width_maximal', '8', 'm', 'import_sidewalk_widths reports a wider sidewalk and leaves it out', 1, 50,
        NULL),
    ('sidewalk_transition', '5', 'm', 'metres of kerb over which the width of sidewalks changes at a corner', 0, 100,
        NULL),
    ('clearance', '6', 'm', 'from a roadway up to the one that passes over, its deck included', 0, 100, NULL),
    ('grade_maximal', '{"0": 12, "50": 8, "70": 7, "90": 6, "110": 5, "130": 4}', '%',
        'greatest grade of a road that is lifted or sunk, by speed in km/h; an entry holds up to the next one; ground '
        'that is steeper over 20 m keeps its grade', NULL, NULL, NULL),
    ('overlaps_maximal', '30', NULL,
        'where more surfaces come into a square of 10 m the first of them by rank owns each place', 1, 1000, NULL),
    ('max_width_per_lane', '5.5', 'm',
        'a width of a source beyond this per stated lane is not believed; NULL believes all', 2, 100, NULL),
    ('lane_width', '3.5', 'm', 'width of one lane, for estimates', 1, 10, NULL),
    ('two_way_width_minimal', '4.5', 'm',
        'a narrower two-way street of unknown lanes has one lane that both directions use; 0: none', 0, 20, NULL),
    ('lane_width_minimal', '2', 'm', 'lanes of unknown width get less only where all lanes of the roadway do', 0.5, 10,
        NULL),
    ('cycle_lane_width', '1.5', 'm', 'width of a cycle lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('parking_lane_width', '2', 'm', 'width of a parking lane that says none; 0: as the other lanes', 0, 10, NULL),
    ('lane_order', 'left_first', NULL, 'lanes are numbered from the middle outwards: left_first or right_first', NULL,
        NULL, ARRAY['left_first', 'right_first']),
    ('driving_side', 'auto', NULL,
        'side of the road that one drives on: right, left, or auto: right until the one-way axes of an import say '
        'otherwise', NULL, NULL, ARRAY['auto', 'right', 'left']),
    ('roundabout_radius_least', '3', 'm', 'a ring of a smaller radius is no roundabout', 0.5, 100, NULL),
    ('roundabout_radius_greatest', '60', 'm',
        'nor is a ring with a larger smallest circle about it; an edit looks as far as twice this', 1, 200, NULL),
    ('roundabout_shape_least', '0.5', NULL,
        'nor is one with a smaller share of the area of the circle of its length', 0, 1, NULL),
    ('roundabout_weight_shape', '0.5', NULL, 'weight of the shape in the score of a ring', 0, 100, NULL),
    ('roundabout_weight_name', '0.1', NULL, 'weight of the names in the score of a ring', 0, 100, NULL),
    ('roundabout_weight_network', '0.4', NULL, 'weight of the network in the score of a ring', 0, 100, NULL),
    ('roundabout_accept', '0.66', NULL, 'a ring with this score and more is a roundabout', 0, 1, NULL),
    ('roundabout_score', 'streetgen.roundabout_score', NULL,
        'score of a ring: a function (shape float8, name float8, network float8, weights float8[]) returning float8, '
        'with its schema', NULL, NULL, NULL),
    ('roundabout_names', 'plain', NULL,
        'how names are compared with roundabout_pattern: plain, unaccent (without accents) or fuzzy (words nearly '
        'alike too)', NULL, NULL, ARRAY['plain', 'unaccent', 'fuzzy']),
    ('roundabout_tags', 'true', NULL,
        'does the word of a source count that an axis is part of a roundabout, with the direction that it implies: '
        'true or false', NULL, NULL, ARRAY['true', 'false']),
    ('edge_line', 'none', NULL, 'line along the kerbs: none or solid', NULL, NULL, ARRAY['none', 'solid']),
    ('control_distance', '50', 'm',
        'a control point farther before its junction than this stands in the middle of its block', 0, 1000, NULL),
    ('ramp_tangent', '15', 'm', 'a ramp runs so far towards the lane that it joins before it bends into it', 0, 1000,
        NULL),
    ('merging_length', '60', 'm', 'a merging lane keeps its width so far, then it tapers; 0: no merging lanes', 0, 1000,
        NULL),
    ('junction_gap', '35', 'm', 'longest edge that makes one junction of the two carriageways which it links', 0, 200,
        NULL),
    ('junction_extent', '80', 'm', 'a junction by such links and slip lanes is no wider', 0, 500, NULL),
    ('classifier', 'streetgen.junction_kind', NULL,
        'the kind of a junction from its arms: streetgen.junction_kind, paper (a ramp where a highway takes part, else '
        'signals), or a function (arms streetgen.junction_arm[]) returning text, with its schema', NULL, NULL,
        ARRAY['streetgen.junction_kind', 'paper']),
    ('signal_program', 'phases', NULL,
        'the states of signals: phases (few, with turns that give way), paper (a state for each pair of roads), or a '
        'function (movements streetgen.signal_request[]) returning SETOF streetgen.signal_answer, with its schema',
        NULL, NULL, ARRAY['phases', 'paper']),
    ('u_turn', 'false', NULL, 'pairs also lanes of one edge at its nodes: true or false', NULL, NULL,
        ARRAY['true', 'false']),
    ('interconnections_maximal', '10000', NULL, 'at a node of more pairs of lanes none are made', 0, 1000000, NULL),
    ('trajectory', 'bezier', NULL,
        'path between two lanes: bezier or arcs, which follow the lanes towards the node where they would cross a '
        'kerb, or a function (lane_in geometry, lane_out geometry, centre geometry, tolerance float8) returning '
        'geometry, with its schema', NULL, NULL, ARRAY['bezier', 'arcs']),
    ('trajectory_radius', '15', 'm',
        'a Bezier path tighter than this bends nearer to the crossing of its lanes, away from the node, as far as '
        'the kerbs allow; 15 m is comfortable at 20 km/h; 0: the rule of the paper wherever its path stays on the '
        'roadway', 0, 100, NULL),
    ('trajectory_tolerance', '0.05', 'm', 'chords of a path between lanes leave its curve by at most this', 0.001, 10,
        NULL),
    ('width_default', '6', 'm', 'width of an axis of which nothing is known', 1, 200, NULL),
    ('importance_default', '5', NULL, 'importance of an axis of which nothing is known', 1, 99, NULL),
    ('speed_by_importance', '{"1": 90, "2": 70, "3": 50, "4": 50, "5": 30}', 'km/h',
        'speed by importance; an entry holds up to the next one, the first also before itself', NULL, NULL, NULL),
    ('speed_per_width', '6', 'km/h per m', 'speed of an axis of unknown importance, from its width', 0, 50, NULL),
    ('clean_epsilon', '0.3', 'm', 'importers remove points nearer to each other', 0, 10, NULL),
    ('clean_r_min', '3', 'm', 'importers remove points that turn more sharply than this radius', 0, 100, NULL),
    ('delivery_wins', 'hand', NULL,
        'where both somebody by hand and a new delivery of the source changed a column, this holds until view '
        'import_conflict is settled: hand or source', NULL, NULL, ARRAY['hand', 'source']),
    ('reach', '60', 'm', 'an edit changes nothing farther away along the network, or than max_arc_distance', 10, 1000,
        NULL),
    ('cell_size', '200', 'm', 'farther off than twice the reach and this edits wait for each other only for a road, '
        'block or junction that both may change, for what is off the ground, and for a transaction that holds many '
        'places', 50, 5000, NULL),
    ('lock_timeout', '5', 's', 'an edit waits so long for another session where its own lock_timeout is 0', 0.1, 3600,
        NULL),
    ('log', 'off', NULL, 'rows in edit_log of who edits what: off or on', NULL, NULL, ARRAY['off', 'on']),
    ('placement_function', 'none', NULL,
        'a rule of one''s own that places objects: none, or a function (model name, edges bigint[]) returning SETOF '
        'streetgen.placement, with its schema', NULL, NULL, ARRAY['none']),
    ('object_names', 'plain', NULL,
        'how import_objects compares names of streets: plain (alike but for capital letters) or fuzzy (by the '
        'similarity of pg_trgm)', NULL, NULL, ARRAY['plain', 'fuzzy']),
    ('object_snap', '20', 'm', 'an object that is dropped so near to an axis is placed by it', 0, 200, NULL),
    ('link_factor', '27.5', 'km', 'of a design: what a utilisation of 1 (thousands of people squared per km2) and a km '
        'saved are worth, in km of road', 0, 1000000, NULL),
    ('benefit', 'paper', NULL, 'trips that a link of a design is judged by: those between its ends (paper) or all '
        'that use it (network)', NULL, NULL, ARRAY['paper', 'network']),
    ('curve_radius', 'least', NULL, 'radius of the curves of designed roads where it fits: the least or the normal one '
        'of their standard, or the largest that fits', NULL, NULL, ARRAY['least', 'normal', 'largest']),
    ('fill_cost', '5', 'per m3', 'cost of a fill', 0, 1000000, NULL),
    ('cut_cost', '6', 'per m3', 'cost of a cut', 0, 1000000, NULL),
    ('land_cost', '2', 'per m2', 'cost of the land that a road and its slopes take', 0, 1000000, NULL),
    ('pavement_cost', '60', 'per m2', 'cost of a road surface, over its formation', 0, 1000000, NULL),
    ('bridge_cost', '1000', 'per m2', 'cost of a bridge, over the formation', 0, 1000000, NULL),
    ('tunnel_cost', '2000', 'per m2', 'cost of a tunnel, over the formation', 0, 1000000, NULL),
    ('use_cost', '100', 'per m', 'cost of the use of a road, by its length', 0.01, 1000000000, NULL),
    ('utilisation_cost', '0', 'per m', 'cost of the use of a road by its length, for each unit of the utilisation of '
        'its link', 0, 1000000000, NULL),
    ('climb_cost', '300', 'per m', 'cost of the use of a road, by what it climbs and descends', 0, 1000000000, NULL),
    ('side_slope', '1.5', NULL, 'run of the slope of a cut or fill for a rise of 1', 0.1, 20, NULL),
    ('fill_greatest', '20', 'm', 'a designed road that lies higher over the ground is a bridge', 0, 1000, NULL),
    ('cut_greatest', '25', 'm', 'a designed road that lies deeper in the ground is a tunnel', 0, 1000, NULL),
    ('design_axis_length', '1000', 'm', 'about every so many metres a designed road is cut into axes', 50, 100000,
        NULL),
    ('design_live', 'off', NULL, 'roads follow an edit of terrain, zones, nodes or links at once: off or on', NULL,
        NULL, ARRAY['off', 'on'])
    $$;
COMMENT ON FUNCTION streetgen._default_setting() IS 'The settings of a new model, with their ranges.';

CREATE OR REPLACE FUNCTION streetgen.setting(model name)
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model);
    RETURN QUERY SELECT * FROM setting s ORDER BY s.name;
END $$;
COMMENT ON FUNCTION streetgen.setting(name) IS 'The settings of a model. An unknown model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen._check_setting(model name, setting text, value text) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known record;
    holds boolean;
    expected text;
BEGIN
    SELECT * INTO known FROM streetgen._default_setting() d WHERE d.name = setting;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'there is no setting "%"', setting USING ERRCODE = '22023',
            HINT = format('SELECT * FROM streetgen.setting(%L) lists them.', model);
    END IF;
    IF value IS NULL THEN
        IF setting IN ('max_width_per_lane', 'radius_function', 'follow_length', 'follow_area',
            'transition_length', 'kerb_radius_minimal') THEN RETURN NULL; END IF;
        RAISE EXCEPTION 'the value of setting "%" of model "%" is NULL or missing', setting, model
            USING ERRCODE = '22004',
            HINT = format('SELECT streetgen.set(%L, %L, %L) puts the default back.', model, setting, known.value);
    END IF;
    IF setting = 'radius_function' THEN
        RETURN streetgen._radius_function(model, value);
    ELSIF value = ANY (known.choice) OR value = known.value THEN
        RETURN value;
    ELSIF EXISTS (SELECT FROM streetgen._setting_function() f WHERE f.setting = _check_setting.setting) THEN
        RETURN streetgen._called_function(model, setting, value);
    ELSIF known.choice IS NOT NULL THEN
        holds := false;
        expected := 'One of ' || array_to_string(known.choice, ', ') || '.';
    ELSIF known.minimum IS NOT NULL THEN
        holds := CASE WHEN value ~ '^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,2})?\s*$'
            THEN value::float8 BETWEEN known.minimum AND known.maximum ELSE false END;
        expected := concat_ws(' ', 'Expected', known.minimum, 'to', known.maximum, known.unit) || '.';
        IF setting = 'ground_level' THEN
            holds := holds AND value ~ '^\s*[-+]?\d+\s*$';
            expected := replace(expected, 'Expected', 'Expected a whole number,');
        END IF;
    ELSIF setting IN ('taper_ratio', 'grade_maximal') THEN
        expected := format('Expected a JSON object of speed (0 to 999 km/h) to %s, such as %s.', CASE setting
            WHEN 'taper_ratio' THEN 'ratio (0 to 100)' ELSE 'grade (0.1 to 100 %)' END, known.value);
        BEGIN
            SELECT count(*) > 0 AND bool_and(e.key ~ '^\d{1,3}$' AND coalesce(e.value::float8
                BETWEEN CASE setting WHEN 'taper_ratio' THEN 0 ELSE 0.1 END AND 100, false))
                INTO holds FROM jsonb_each_text(value::jsonb) e;
        EXCEPTION WHEN data_exception THEN
            holds := false;
        END;
    ELSE
        expected := CASE setting WHEN 'sidewalk_by_importance'
            THEN 'Expected a JSON object of importance to metres, 0 to 50, such as {"1": 3, "4": 1.5}.'
            ELSE 'Expected a JSON object of importance to number, such as {"1": 8, "2": 6.25}.' END;
        BEGIN
            -- Only a radius has another law to fall back on.
            holds := value = '' AND setting = 'radius_by_importance'
                OR NOT EXISTS (SELECT FROM jsonb_each_text(value::jsonb) e WHERE e.key !~ '^[1-9]\d?$'
                OR NOT (coalesce(e.value, '1')::float8 BETWEEN 0 AND CASE setting
                    WHEN 'sidewalk_by_importance' THEN 50 ELSE 400 END));
        EXCEPTION WHEN data_exception THEN
            holds := false;
        END;
    END IF;
    IF NOT holds THEN
        RAISE EXCEPTION 'setting "%" of model "%" cannot be %', setting, model, quote_literal(value)
            USING ERRCODE = '22023', HINT = expected;
    END IF;
    RETURN value;
END $$;
COMMENT ON FUNCTION streetgen._check_setting(name, text, text) IS
    'The value as the model keeps it: a function with its schema. Raises 22023 for an unknown setting or a value '
    'beyond the range, words or form of _default_setting, 22004 for NULL, saying how to put the default back; for a '
    'function as _called_function.';

CREATE OR REPLACE FUNCTION streetgen._check_settings(model name) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A default is within its range.
    PERFORM streetgen._check_setting(model, d.name, s.value) FROM streetgen._default_setting() d LEFT
        JOIN setting s USING (name) WHERE s.value IS DISTINCT FROM d.value;
END $$;
COMMENT ON FUNCTION streetgen._check_settings(name) IS
    'Raises as _check_setting for what was written or deleted in the setting table of a model without streetgen.set.';

CREATE OR REPLACE FUNCTION streetgen.set(model name, setting text, value text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._check_given('setting', setting);
    value := streetgen._check_setting(model, setting, value);
    -- One at a time, since each goes on to hold out the other.
    LOCK TABLE setting IN SHARE ROW EXCLUSIVE MODE;
    INSERT INTO setting AS s SELECT d.name, set.value, d.unit, d.description, d.minimum, d.maximum, d.choice
        FROM streetgen._default_setting() d WHERE d.name = setting
        ON CONFLICT (name) DO UPDATE SET value = excluded.value WHERE s.value IS DISTINCT FROM excluded.value;
EXCEPTION WHEN lock_not_available THEN
    PERFORM streetgen._refuse_tables(model, 'Repeat the call when it has ended, or raise lock_timeout.');
END $$;
COMMENT ON FUNCTION streetgen.set(name, text, text) IS
    'Changes a setting of a model within its range (22023 outside, 22004 for NULL where it has no such meaning; a '
    'function that would hand on rights: 42501), also one that was deleted, once edits and runs under way have '
    'ended; rows computed before are stale until generate. A lock_timeout that ends: 55P03, naming who holds the '
    'settings.';

CREATE OR REPLACE FUNCTION streetgen._tolerance(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance float8;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value::float8 FROM setting WHERE name = 'tolerance' INTO tolerance;
    RETURN tolerance;
END $$;
COMMENT ON FUNCTION streetgen._tolerance(name) IS 'Setting tolerance of a model, metres.';
