-- Widths, lanes and parking that the streets of a class have, learnt from those that state them.

CREATE OR REPLACE FUNCTION streetgen._parking_at(kinds text, widths text, last boolean, parking_lane_width float8)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN (SELECT CASE WHEN kind[place] = 'parking' THEN coalesce(nullif(nullif(width[place], '')::float8, 0),
            parking_lane_width) END
        FROM (SELECT string_to_array(kinds, '|') AS kind, string_to_array(widths, '|') AS width) l,
            LATERAL (SELECT CASE WHEN last THEN cardinality(kind) ELSE 1 END AS place) p);
COMMENT ON FUNCTION streetgen._parking_at(text, text, boolean, float8) IS
    'Width in metres of the parking lane that comes first or last in a list of kinds of lanes, with a list of their '
    'widths; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._parking_room(width float8, lanes integer, lane_width float8,
    parking_lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN CASE WHEN width < lanes * lane_width + 2 * parking_lane_width THEN 0
        -- Cars stand at right angles in 5 m, and no lane of a class has more than 4.5 m.
        ELSE least(greatest(parking_lane_width, (width - lanes * greatest(4.5, lane_width)) / 2), 5) END;
COMMENT ON FUNCTION streetgen._parking_room(float8, integer, float8, float8) IS
    'Width in metres for parking at each kerb that lanes of a number and a usual width leave of a roadway; 0 where '
    'there is no room at both kerbs.';

CREATE OR REPLACE FUNCTION streetgen._stated_of_class(model name)
    RETURNS TABLE(class text, column_name text, value float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    lane float8;
    parking float8;
    left_hand boolean;
BEGIN
    PERFORM streetgen._use_model(model);
    lane := streetgen._setting_number(model, 'lane_width');
    parking := streetgen._setting_number(model, 'parking_lane_width');
    left_hand := streetgen._driving_side(model) = 'left';
    RETURN QUERY
    SELECT a.kind, v.column_name, v.value FROM axis_used u JOIN axis a USING (axis_id)
        JOIN axis_class c ON c.class = a.kind AND c.use = 'roadway',
        LATERAL (SELECT u.direction <> 'both' AS one_way,
            CASE WHEN 'width' <> ALL (u.estimated) THEN (u.width + u.width_end) / 2 END AS width,
            CASE WHEN 'lane_count' <> ALL (u.estimated) THEN u.lane_count END AS lanes) s,
        -- Lists of lanes are read in driving direction.
        LATERAL (SELECT u.direction = 'direct' OR u.direction = 'both' AND left_hand AS left_is_first,
            u.direction = 'direct' OR u.direction = 'both' AND NOT left_hand AS right_is_last) d,
        LATERAL (SELECT CASE WHEN left_is_first
                THEN streetgen._parking_at(a.kind_forward, a.lane_width_forward, false, parking)
                ELSE streetgen._parking_at(a.kind_backward, a.lane_width_backward, true, parking) END AS on_left,
            CASE WHEN right_is_last
                THEN streetgen._parking_at(a.kind_forward, a.lane_width_forward, true, parking)
                ELSE streetgen._parking_at(a.kind_backward, a.lane_width_backward, false, parking) END AS on_right,
            -- Nobody parks on a highway.
            CASE WHEN c.highway_role IS NULL
                AND num_nonnulls(a.kind_forward, a.kind_backward, a.parking_left, a.parking_right) = 0
                THEN streetgen._parking_room(s.width, s.lanes, lane, parking) END AS room) p,
        LATERAL (VALUES ('width', CASE WHEN NOT one_way THEN s.width END),
            ('width_one_way', CASE WHEN one_way THEN s.width END),
            ('lanes_each_way', CASE WHEN NOT one_way THEN ceil(s.lanes / 2.0) END),
            ('lanes_one_way', CASE WHEN one_way THEN s.lanes END),
            ('parking_left', coalesce(on_left, room, CASE WHEN a.parking_left IS NOT NULL THEN 0 END)),
            ('parking_right', coalesce(on_right, room, CASE WHEN a.parking_right IS NOT NULL THEN 0 END))
        ) v(column_name, value)
    WHERE NOT u.on_ring AND v.value IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._stated_of_class(name) IS
    'What each street of a class of roadways states, by the column of axis_class that says it where a source is '
    'silent: widths kerb to kerb, lanes of a direction, and parking lanes at both kerbs (0: none), which are also the '
    'room that a stated width leaves beside stated lanes. Widths that are not believed are not stated; roundabouts are '
    'no street of their class.';

CREATE OR REPLACE FUNCTION streetgen.learn_classes(model name, accept boolean DEFAULT false)
    RETURNS TABLE(class text, column_name text, now float8, proposed float8, ways bigint, spread float8)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('accept', accept::text);
    CREATE TEMPORARY TABLE _learnt_class ON COMMIT DROP AS
    WITH stated AS MATERIALIZED (SELECT * FROM streetgen._stated_of_class(model)),
    middle AS (
        SELECT class, column_name, percentile_disc(0.5) WITHIN GROUP (ORDER BY value) AS middle, count(*) AS ways
        FROM stated GROUP BY class, column_name
        HAVING count(*) >= streetgen._setting_number(model, 'class_ways_minimal')),
    spread AS (
        SELECT class, column_name, middle, ways,
            percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(value - middle)) AS spread
        FROM stated JOIN middle USING (class, column_name) GROUP BY class, column_name, middle, ways),
    there AS (
        SELECT c.class, v.column_name, v.now FROM axis_class c, LATERAL (VALUES ('width', c.width),
            ('width_one_way', c.width_one_way), ('lanes_each_way', c.lanes_each_way),
            ('lanes_one_way', c.lanes_one_way), ('parking_left', c.parking_left), ('parking_right', c.parking_right)
        ) v(column_name, now)),
    -- A class says its width without the parking that it says.
    parking AS (
        SELECT class, sum(coalesce(middle, now)) AS width FROM there LEFT JOIN spread USING (class, column_name)
        WHERE column_name LIKE 'parking%' GROUP BY class)
    SELECT class, column_name, now, round((CASE WHEN column_name LIKE 'width%'
            THEN greatest(middle - p.width, 1) ELSE middle END)::numeric, 1)::float8 AS proposed, ways, spread
        FROM spread JOIN there USING (class, column_name) JOIN parking p USING (class);
    -- No lane of a class has more than 4.5 m, so that a width asks for so many.
    UPDATE pg_temp._learnt_class l SET proposed = greatest(l.proposed, ceil(w.proposed / 4.5
            / CASE w.column_name WHEN 'width' THEN 2 ELSE 1 END))
        FROM pg_temp._learnt_class w WHERE w.class = l.class
            AND (l.column_name, w.column_name) IN (('lanes_each_way', 'width'), ('lanes_one_way', 'width_one_way'));
    DELETE FROM pg_temp._learnt_class WHERE proposed IS NOT DISTINCT FROM now;
    IF accept THEN
        UPDATE axis_class c SET width = coalesce(p.width, c.width),
            width_one_way = coalesce(p.width_one_way, c.width_one_way),
            lanes_each_way = coalesce(p.lanes_each_way, c.lanes_each_way),
            lanes_one_way = coalesce(p.lanes_one_way, c.lanes_one_way),
            parking_left = coalesce(p.parking_left, c.parking_left),
            parking_right = coalesce(p.parking_right, c.parking_right)
        FROM (SELECT class, max(proposed) FILTER (WHERE column_name = 'width') AS width,
                max(proposed) FILTER (WHERE column_name = 'width_one_way') AS width_one_way,
                max(proposed) FILTER (WHERE column_name = 'lanes_each_way') AS lanes_each_way,
                max(proposed) FILTER (WHERE column_name = 'lanes_one_way') AS lanes_one_way,
                max(proposed) FILTER (WHERE column_name = 'parking_left') AS parking_left,
                max(proposed) FILTER (WHERE column_name = 'parking_right') AS parking_right
            FROM pg_temp._learnt_class GROUP BY class) p
        WHERE p.class = c.class;
    END IF;
    RETURN QUERY SELECT class, column_name, now, proposed, ways, spread FROM pg_temp._learnt_class
        ORDER BY class, column_name;
    DROP TABLE pg_temp._learnt_class;
END $$;
COMMENT ON FUNCTION streetgen.learn_classes(name, boolean) IS
    'What columns of axis_class would say if streets of a class that a source is silent about were as those that state '
    'it, by hand or fitted ones too: a row for each column that would change, with its value now, the median, how many '
    'axes state it, and the median by which these differ from it. Columns are width and width_one_way (metres, less '
    'the parking of the class), lanes_each_way, lanes_one_way, parking_left and parking_right, which is also the room '
    'that a stated width leaves beside stated lanes. What fewer axes state than setting class_ways_minimal says stays; '
    'a width asks for lanes of at most 4.5 m; widths that are not believed and roundabouts do not count. accept: true '
    'writes all of it to axis_class, for which one needs the rights of an editor (42501); the next run computes the '
    'streets.';
