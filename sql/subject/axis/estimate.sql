-- Named functions estimate what the source lacks; their coefficients are settings of the model.

CREATE OR REPLACE FUNCTION streetgen.believed_width(width float8, lane_count integer, max_width_per_lane float8)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN width > max_width_per_lane * lane_count THEN NULL ELSE width END;
COMMENT ON FUNCTION streetgen.believed_width(float8, integer, float8) IS
    'A source width in metres, or NULL where it exceeds the bound per stated lane. A NULL bound or lane count '
    'believes all. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen.believed_roadway_offset(roadway_offset float8, width float8,
    width_end float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN roadway_offset IS NULL OR roadway_offset = 0 THEN 0
        ELSE greatest(-least(width, width_end) / 2, least(roadway_offset, least(width, width_end) / 2)) END;
COMMENT ON FUNCTION streetgen.believed_roadway_offset(float8, float8, float8) IS
    'How far the middle of a roadway lies beside its axis, metres, left positive: at most as far as leaves the axis on '
    'the roadway, half of the least of its widths at the start and the end (metres). An argument that is NULL is '
    'unknown: an offset counts as 0.';

CREATE OR REPLACE FUNCTION streetgen._names_ring(tag text) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(tag IN ('roundabout', 'circular', 'Rond-point'), false);
COMMENT ON FUNCTION streetgen._names_ring(text) IS
    'Does a tag of a source, as in axis.roundabout_tag, say that a street is part of a roundabout?';

CREATE OR REPLACE FUNCTION streetgen.estimated_width(lane_count integer, class_width float8, lane_width float8,
    width_default float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN least(coalesce(lane_count * lane_width, class_width, width_default), 200);
COMMENT ON FUNCTION streetgen.estimated_width(integer, float8, float8, float8) IS
    'Width in metres from the lanes, else from the class, else the default. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen._by_importance(entries jsonb) RETURNS float8[]
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    list float8[];
    entry float8;
BEGIN
    FOR importance IN 1 .. coalesce((SELECT max(key::integer) FROM jsonb_object_keys(entries) key
        WHERE key ~ '^[1-9]\d?$'), 0) LOOP
        IF entries ? importance::text THEN
            entry := entries ->> importance::text;
            list := coalesce(list, array_fill(entry, ARRAY[importance - 1]));
        END IF;
        IF list IS NOT NULL THEN
            list := list || entry;
        END IF;
    END LOOP;
    RETURN list;
END $$;
COMMENT ON FUNCTION streetgen._by_importance(jsonb) IS
    'What each importance from 1 to the last of an object of importance (1 to 99) to number has: the last entry at or '
    'before it, before the first entry the first; NULL for no entry.';

CREATE OR REPLACE FUNCTION streetgen._of_importance(importance integer, list float8[]) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN list[CASE WHEN importance < 1 THEN 1 WHEN importance > cardinality(list) THEN cardinality(list)
        ELSE importance END];
COMMENT ON FUNCTION streetgen._of_importance(integer, float8[]) IS
    'What an importance has by the list of streetgen._by_importance; one beyond it what the nearest has.';

CREATE OR REPLACE FUNCTION streetgen._estimated_speed(importance integer, width float8, speeds float8[],
    speed_per_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(streetgen._of_importance(importance, speeds), greatest(20, least(110, width * speed_per_width)));
COMMENT ON FUNCTION streetgen._estimated_speed(integer, float8, float8[], float8) IS
    'streetgen.estimated_speed by a list that is read already.';

CREATE OR REPLACE FUNCTION streetgen.estimated_speed(importance integer, width float8, speed_by_importance jsonb,
    speed_per_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._estimated_speed(importance, width, streetgen._by_importance(speed_by_importance),
        speed_per_width);
COMMENT ON FUNCTION streetgen.estimated_speed(integer, float8, jsonb, float8) IS
    'Speed in km/h from the importance (the last entry at or before it, before the first entry the first), else from '
    'the width (metres), 20 to 110. Speeds that are no JSON object: 22023. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen._narrowest_of_several(lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN 0.75 * lane_width;
COMMENT ON FUNCTION streetgen._narrowest_of_several(float8) IS
    'The width in metres below which a width alone makes no several lanes: three quarters of the usual one.';

CREATE OR REPLACE FUNCTION streetgen.estimated_lane_count(width float8, speed float8, lane_width float8) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN width BETWEEN 0 AND 1e6 AND lane_width BETWEEN 1e-3 AND 1e6
        THEN greatest(1, least(30, round(width / (lane_width * CASE WHEN speed > 70 THEN 1 ELSE 0.9 END)),
            floor(width / streetgen._narrowest_of_several(lane_width))))::integer END;
COMMENT ON FUNCTION streetgen.estimated_lane_count(float8, float8, float8) IS
    'Lanes from the width (metres) and the speed (km/h): slow lanes are a tenth narrower, none of several is narrower '
    'than three quarters of lane_width; 1 to 30, NULL for a width below 0 (of a lane: 1 mm), beyond 1e6 m or NaN. An '
    'argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen.driving_lanes(kinds text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN cardinality(array_positions(string_to_array(kinds, '|'), 'general')) +
        cardinality(array_positions(string_to_array(kinds, '|'), 'bus')) +
        cardinality(array_positions(string_to_array(kinds, '|'), 'carpool'));
COMMENT ON FUNCTION streetgen.driving_lanes(text) IS
    'How many lanes of a list of kinds are for motor traffic: general, bus or carpool. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.kerbside_width(kinds text, cycle_lane_width float8, parking_lane_width float8)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN cardinality(array_positions(string_to_array(kinds, '|'), 'cycle')) * cycle_lane_width +
        cardinality(array_positions(string_to_array(kinds, '|'), 'parking')) * parking_lane_width;
COMMENT ON FUNCTION streetgen.kerbside_width(text, float8, float8) IS
    'Width in metres of the cycle and parking lanes of a list of kinds. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._listed_kerbside_width(kinds text, widths text, lane_width float8,
    cycle_lane_width float8, parking_lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN (SELECT sum(coalesce(nullif(CASE cardinality(said) WHEN lanes THEN nullif(said[place], '')::float8 END, 0),
            CASE kind WHEN 'cycle' THEN cycle_lane_width WHEN 'parking' THEN parking_lane_width ELSE lane_width END))
        FROM (SELECT string_to_array(widths, '|') AS said) s,
            (SELECT kind, place, count(*) OVER () AS lanes
            FROM unnest(string_to_array(kinds, '|')) WITH ORDINALITY k(kind, place)) l
        WHERE kind IN ('cycle', 'parking', 'closed'));
COMMENT ON FUNCTION streetgen._listed_kerbside_width(text, text, float8, float8, float8) IS
    'streetgen._kerbside_width of lanes with a list of widths, which leaves some open, or speaks of the others alone. '
    'NULL where there are none.';

CREATE OR REPLACE FUNCTION streetgen._kerbside_width(kinds text, widths text, lane_width float8,
    cycle_lane_width float8, parking_lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(CASE WHEN widths IS NULL AND (kinds LIKE '%closed%') IS NOT TRUE
        THEN streetgen.kerbside_width(kinds, cycle_lane_width, parking_lane_width)
        ELSE streetgen._listed_kerbside_width(kinds, widths, lane_width, cycle_lane_width, parking_lane_width) END, 0);
COMMENT ON FUNCTION streetgen._kerbside_width(text, text, float8, float8, float8) IS
    'Width in metres of the lanes of a direction on which no motor traffic drives, with these kinds and widths of '
    'lanes: cycle, parking and closed lanes, each as wide as it says, else as the settings do; 0 where there are none.';

CREATE OR REPLACE FUNCTION streetgen._kinds_beside_parking(driving integer, parking_left float8, parking_right float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN nullif(concat_ws('|', CASE WHEN parking_left > 0 THEN 'parking' END,
        CASE WHEN driving > 0 THEN 'general' || repeat('|general', driving - 1) END,
        CASE WHEN parking_right > 0 THEN 'parking' END), '');
COMMENT ON FUNCTION streetgen._kinds_beside_parking(integer, float8, float8) IS
    'Kinds of so many general lanes from left to right, between parking lanes of these widths, 0: none.';

CREATE OR REPLACE FUNCTION streetgen._widths_beside_parking(driving integer, parking_left float8, parking_right float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN nullif(concat_ws('|', CASE WHEN parking_left > 0 THEN round(parking_left::numeric, 6)::text END,
        CASE WHEN driving > 0 THEN repeat('|', driving - 1) END,
        CASE WHEN parking_right > 0 THEN round(parking_right::numeric, 6)::text END), '');
COMMENT ON FUNCTION streetgen._widths_beside_parking(integer, float8, float8) IS
    'Widths of the lanes of streetgen._kinds_beside_parking: general lanes share what the others leave.';

CREATE OR REPLACE FUNCTION streetgen._lanes_width(driving integer, kinds text, widths text, lane_width float8,
    cycle_lane_width float8, parking_lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN widths IS NULL AND kinds IS NULL THEN driving * lane_width
        ELSE (SELECT coalesce(sum(coalesce(nullif(nullif(CASE cardinality(said) WHEN driving
                THEN CASE WHEN drives THEN said[nth] END WHEN lanes THEN said[place] END, '')::float8, 0), usual)), 0)
            FROM (SELECT string_to_array(widths, '|') AS said) s,
                (SELECT place, drives, count(*) FILTER (WHERE drives) OVER (ORDER BY place) AS nth,
                    count(*) OVER () AS lanes, CASE WHEN drives THEN lane_width
                        ELSE coalesce(nullif(CASE kind WHEN 'cycle' THEN cycle_lane_width
                            ELSE parking_lane_width END, 0), lane_width) END AS usual
                 FROM (SELECT kind, place, kind NOT IN ('cycle', 'parking') AS drives
                     FROM unnest(coalesce(string_to_array(kinds, '|'),
                         array_fill('general'::text, ARRAY[driving]))) WITH ORDINALITY k(kind, place)) k) l) END;
COMMENT ON FUNCTION streetgen._lanes_width(integer, text, text, float8, float8, float8) IS
    'How wide the lanes of one direction are together, metres: so many driving lanes, or those of a list of kinds; '
    'what a list of widths leaves open is as wide as the settings say for its kind.';

CREATE OR REPLACE FUNCTION streetgen.lanes_of_both(stated integer, stated_forward integer, stated_backward integer,
    listed boolean,
        lane_count integer, narrow boolean) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN stated_forward > 0 OR stated_backward > 0 THEN greatest(stated, 0)
        WHEN stated > 0 THEN stated + CASE WHEN lane_count > stated THEN (lane_count - stated) % 2 ELSE 0 END
        WHEN lane_count = 1 OR listed AND lane_count > 0 THEN lane_count
        WHEN lane_count % 2 = 1 OR narrow AND lane_count IS NULL AND NOT listed THEN 1 ELSE 0 END;
COMMENT ON FUNCTION streetgen.lanes_of_both(integer, integer, integer, boolean, integer, boolean) IS
    'Lanes of a two-way street that both directions use: what is stated; else none where lanes of a direction are; '
    'else the one lane that there is, by lane_count or on a narrow street of which no count is stated. An odd lane of '
    'which nothing says the direction is of both. Lists of kinds (listed) without a lane for motor traffic leave all '
    'of lane_count. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen._lanes_by_list(lane_count integer, lanes_both integer, turns text, widths text)
    RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN lane_count % 2 = 1 AND NOT lanes_both > 0 IS TRUE AND (lane_count + 1) / 2
        IN (cardinality(string_to_array(turns, '|')), cardinality(string_to_array(widths, '|')))
        THEN (lane_count + 1) / 2 END;
COMMENT ON FUNCTION streetgen._lanes_by_list(integer, integer, text, text) IS
    'How many of an odd number of lanes a direction of a two-way street has whose list of turns or widths has the odd '
    'one; NULL where no list has it.';

CREATE OR REPLACE FUNCTION streetgen.lanes_of_way(open boolean, listed boolean, stated integer, against integer,
    lane_count integer, fewest integer DEFAULT 1) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN listed THEN stated WHEN NOT open THEN 0 WHEN stated > 0 THEN stated
        ELSE greatest(lane_count - against, fewest) END;
COMMENT ON FUNCTION streetgen.lanes_of_way(boolean, boolean, integer, integer, integer, integer) IS
    'General, bus and carpool lanes of one direction: what is stated; else what the other direction (against) leaves '
    'of lane_count, at least so many. A direction that is closed to traffic has none but those that a list of kinds '
    'names (a bus lane against the traffic). An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen.lane_kinds(driving integer, buses text, bus boolean, driving_side text,
    near_cycle boolean, far_cycle boolean, near_parking boolean, far_parking boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN bus OR by_list OR near_cycle OR far_cycle OR near_parking OR far_parking
                THEN array_to_string(CASE driving_side WHEN 'right' THEN far_inwards || lanes || near
                    ELSE near_inwards || lanes || far END, '|') END
    FROM (SELECT string_to_array(buses, '|') AS said WHERE driving BETWEEN 0 AND 40) b,
    LATERAL (SELECT coalesce(cardinality(said) = driving AND 'designated' = ANY (said), false) AS by_list,
        array_fill('general'::text, ARRAY[CASE WHEN driving > 1 THEN driving - 1 ELSE driving END]) AS beside_bus) y,
    LATERAL (SELECT CASE WHEN by_list THEN ARRAY(SELECT CASE word WHEN 'designated' THEN 'bus' ELSE 'general'
        END FROM unnest(said) WITH ORDINALITY w(word, i) ORDER BY i)
                         WHEN NOT bus THEN array_fill('general'::text, ARRAY[driving])
                         WHEN driving_side = 'right' THEN beside_bus || 'bus'::text
                         ELSE 'bus'::text || beside_bus END AS lanes) l,
    LATERAL (SELECT array_remove(ARRAY[CASE WHEN near_cycle THEN 'cycle' END, CASE WHEN near_parking
        THEN 'parking' END], NULL) AS near,
                    array_remove(ARRAY[CASE WHEN near_parking THEN 'parking' END, CASE WHEN near_cycle
                        THEN 'cycle' END], NULL) AS near_inwards,
                    array_remove(ARRAY[CASE WHEN far_cycle THEN 'cycle' END, CASE WHEN far_parking THEN 'parking' END],
                        NULL) AS far,
                    array_remove(ARRAY[CASE WHEN far_parking THEN 'parking' END, CASE WHEN far_cycle THEN 'cycle' END],
                        NULL) AS far_inwards) k $$;
COMMENT ON FUNCTION streetgen.lane_kinds(integer, text, boolean, text, boolean, boolean, boolean, boolean) IS
    'Kinds of the lanes of one direction from left to right: so many driving lanes, those designated in the list '
    'buses bus lanes (with bus: the one at the near kerb, which is on the driving side, in place of a driving lane '
    'where there are two and more), cycle lanes and beyond them parking at the near kerb and the far one. NULL where '
    'all are general, or driving is not 0 to 40. An argument that is NULL is unknown.';

CREATE OR REPLACE FUNCTION streetgen._turn_words() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT
        'reverse|sharp_left|left|slight_left|merge_to_left|through|merge_to_right|slight_right|right|sharp_right|none'
    $$;
COMMENT ON FUNCTION streetgen._turn_words() IS 'The turns that a lane can be marked for, parted by |.';

CREATE OR REPLACE FUNCTION streetgen._lane_list_pattern(kind text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('^(%1$s)(\|(%1$s)){0,39}$', CASE kind
        WHEN 'kind' THEN 'general|bus|carpool|cycle|parking|closed'
        WHEN 'width' THEN '(\d{1,2}(\.\d{1,6})?)?'
        WHEN 'change' THEN '(yes|no|not_left|not_right|only_left|only_right)?'
        WHEN 'turn' THEN format('(%1$s)?(;(%1$s)){0,9}', streetgen._turn_words()) END) $$;
COMMENT ON FUNCTION streetgen._lane_list_pattern(text) IS
    'The form of a list of lanes as a regular expression, for streetgen.is_lane_list and the constraints of axis.';

CREATE OR REPLACE FUNCTION streetgen.is_lane_list(list text, kind text) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT list ~ streetgen._lane_list_pattern(kind) $$;
COMMENT ON FUNCTION streetgen.is_lane_list(text, text) IS
    'Does a text list something of up to 40 lanes, from left to right in driving direction, parted by |: kind '
    '(general, bus, carpool, cycle, parking, closed), width (metres, empty or 0: unknown), turn (words of turn:lanes '
    'parted by ;, empty: nothing said), or change (yes, no, not_left, not_right, only_left, only_right, empty: nothing '
    'said). NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen._wanted_radius(radius float8, importance integer, speed float8, width float8,
        radii float8[], mode text, minimal float8, maximal float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(radius, CASE WHEN importance IS NOT NULL AND radii IS NOT NULL
        THEN coalesce(streetgen._of_importance(importance, radii), 0) END,
        streetgen.turning_radius(least(speed, 400), width, mode, minimal, maximal));
COMMENT ON FUNCTION streetgen._wanted_radius(float8, integer, float8, float8, float8[], text, float8, float8) IS
    'streetgen.wanted_radius by a list that is read already.';

CREATE OR REPLACE FUNCTION streetgen.wanted_radius(radius float8, importance integer, speed float8, width float8,
        radius_by_importance text, mode text, minimal float8 DEFAULT 0.15, maximal float8 DEFAULT 15) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._wanted_radius(radius, importance, speed, width,
        streetgen._by_importance(nullif(radius_by_importance, '')::jsonb), mode, minimal, maximal);
COMMENT ON FUNCTION streetgen.wanted_radius(float8, integer, float8, float8, text, text, float8, float8) IS
    'Corner radius (metres) an axis wants: its own, else by importance (the last entry at or before it, before the '
    'first entry the first; a null entry: 0, no arc), else turning_radius between minimal and maximal. An argument '
    'that is NULL is unknown. A text that is no JSON: 22P02.';
