-- Views of axes, by name: streetgen._part gives each.

--{axis_used
CREATE OR REPLACE VIEW axis_used WITH (security_invoker = true) AS
SELECT axis_id, geom, level, width_used AS width, coalesce(CASE WHEN kerb_width IS NULL THEN believed_end END,
    width_used) AS width_end,
       forward_used + backward_used + both_used AS lane_count, forward_used AS lanes_forward,
           backward_used AS lanes_backward, both_used AS lanes_both, direction_used AS direction,
       CASE WHEN parks THEN streetgen._kinds_beside_parking(forward_used, left_of_forward, right_of_forward)
           ELSE kind_forward END AS kind_forward,
       CASE WHEN parks THEN streetgen._kinds_beside_parking(backward_used, left_of_backward, right_of_backward)
           ELSE kind_backward END AS kind_backward,
       CASE WHEN parks THEN streetgen._widths_beside_parking(forward_used, left_of_forward, right_of_forward)
           ELSE lane_width_forward END AS lane_width_forward,
       CASE WHEN parks THEN streetgen._widths_beside_parking(backward_used, left_of_backward, right_of_backward)
           ELSE lane_width_backward END AS lane_width_backward, turn_forward, turn_backward,
       speed_used AS speed, coalesce(importance_known, importance_default) AS importance,
       streetgen._wanted_radius(
           coalesce(radius, CASE WHEN predictor IS NOT NULL THEN streetgen._predicted_radius(predictor, axis_id,
               width_used, speed_used,
               coalesce(importance_known, importance_default), forward_used + backward_used + both_used, kind) END),
           importance_known, speed_used, width_used, radii, turning_mode, turning_minimal, turning_maximal) AS radius,
       array_remove(ARRAY[CASE WHEN kerb_width IS NULL AND believed IS NULL THEN 'width' END,
                          CASE WHEN kerb_width IS NULL AND believed_end IS NULL AND width_end IS NOT NULL
                              THEN 'width_end' END, CASE WHEN lane_count IS NULL AND stated_forward IS NULL
                              AND stated_backward IS NULL THEN 'lane_count' END,
                          CASE WHEN speed IS NULL THEN 'speed' END, CASE WHEN importance IS NULL
                              THEN 'importance' END, CASE WHEN sidewalk_left IS NULL THEN 'sidewalk_left' END,
                          CASE WHEN sidewalk_right IS NULL THEN 'sidewalk_right' END], NULL) AS estimated,
       hash_record_extended(ROW(geom::bytea, level, width, width_end, lane_count, speed, importance, radius, kind,
           class_width, class_speed, class_importance, kerb_width,
           CASE WHEN {any} THEN (SELECT string_agg(says::text, '|' ORDER BY place, key, later) FROM ({says}) o) END,
           direction_used, lanes_forward, lanes_backward, lanes_both, kind_forward, kind_backward,
               lane_width_forward,
               lane_width_backward, turn_forward, turn_backward, by_hand{rings}),
           -- Sidewalks, flows, lane changes, tags of roundabouts and what a class means are the seed, so that it stays
           -- the same where nothing is said of them.
           CASE WHEN coalesce(sidewalk_left, sidewalk_right) IS NULL THEN 0
               ELSE hash_record_extended(ROW(sidewalk_left, sidewalk_right), 0) END
           # CASE WHEN coalesce(change_forward, change_backward) IS NULL THEN 0
               ELSE hash_record_extended(ROW(change_forward, change_backward), 3) END
           # CASE WHEN lane_markings IS NULL THEN 0 ELSE hashtextextended(lane_markings, 10) END
           # CASE WHEN sidewalk_apart IS NULL THEN 0 ELSE hashtextextended(sidewalk_apart, 11) END
           # CASE WHEN roundabout_tag IS NULL THEN 0 ELSE hashtextextended(roundabout_tag, 4) END
           -- Carriageways of one street are told by its name.
           # CASE WHEN name <> '' AND direction_used <> 'both' THEN hashtextextended(lower(name), 8) ELSE 0 END
           # CASE WHEN access IS NULL THEN 0 ELSE hashtextextended(access, 6) END
           # CASE WHEN coalesce(parking_left, parking_right) IS NULL THEN 0
               ELSE hash_record_extended(ROW(parking_left, parking_right), CASE WHEN bays_beside
                   AND concat(parking_left, parking_right) ~ 'street_side' THEN 9 ELSE 10 END) END
           # CASE WHEN coalesce(strips_left, strips_right) IS NULL THEN 0
               ELSE hash_record_extended(ROW(strips_left, strips_right), 14) END
           # CASE WHEN flow IS NULL THEN 0 ELSE hashfloat8extended(flow, 1) END
           # CASE WHEN coalesce(roadway_offset, 0) = 0 THEN 0 ELSE hashfloat8extended(roadway_offset, 2) END
           # CASE WHEN surveyed IS NULL THEN 0 ELSE hashfloat8extended(surveyed[2], 12) END
           # CASE WHEN kerbs_beside IS NULL THEN 0 ELSE hash_array_extended(kerbs_beside, 13) END
           # CASE WHEN highway_role IS NULL AND coalesce(walked_along AND crossed_on_foot AND lanes_by_width, true)
               THEN 0
               ELSE hash_record_extended(ROW(highway_role, walked_along, crossed_on_foot, lanes_by_width), 5) END
           # CASE WHEN num_nonnulls(lanes_one_way, width_one_way, lanes_each_way) = 0 AND NOT parks THEN 0
               ELSE hash_record_extended(ROW(lanes_one_way, width_one_way, lanes_each_way, parks, class_parking_left,
                   class_parking_right), 7) END)
           AS input_hash,
       setting_hash,
       CASE WHEN (NOT bays_beside OR parking_left IS NULL) AND strips_left IS NULL
           THEN coalesce(sidewalk_left, sidewalk_usual)
           ELSE streetgen._with_strips(coalesce(sidewalk_left, sidewalk_usual), CASE WHEN bays_beside
               THEN parking_left END, strips_left, settings) END AS sidewalk_left,
       CASE WHEN (NOT bays_beside OR parking_right IS NULL) AND strips_right IS NULL
           THEN coalesce(sidewalk_right, sidewalk_usual)
           ELSE streetgen._with_strips(coalesce(sidewalk_right, sidewalk_usual), CASE WHEN bays_beside
               THEN parking_right END, strips_right, settings) END AS sidewalk_right,
       streetgen.believed_roadway_offset(CASE WHEN kerbs_beside IS NULL THEN coalesce(surveyed[2], roadway_offset)
           ELSE (kerbs_used[1] - kerbs_used[2]) / 2 END, width_used, CASE WHEN kerb_width IS NULL THEN believed_end END)
           AS roadway_offset,
       access,
       -- Cycle and parking lanes lie at the kerbs, and leave nothing there.
       -- Lanes share all of a roadway that widens, since neither end is the one to measure at.
       CASE WHEN lanes_by_width IS NOT FALSE AND coalesce(kerb_width, believed) IS NOT NULL AND kerbside = 0
           AND (kerb_width IS NOT NULL OR coalesce(believed_end = believed, true))
           AND num_nonnulls(lane_count, stated_forward, stated_backward, lanes_both) > 0 THEN widest_lane END
           AS lane_width_maximal,
       coalesce(tags_count, false) AND streetgen._names_ring(roundabout_tag) AS on_ring,
       CASE WHEN name <> '' THEN hashtextextended(lower(name), 0) ELSE 0 END AS street,
       surveyed IS NOT NULL AS by_area,
       CASE WHEN kerbs_beside IS NULL THEN 0 ELSE width_unmoved - width_used END AS width_moved, {area} AS area
FROM axis a LEFT JOIN (SELECT class AS kind, width AS class_width, speed AS class_speed,
    importance AS class_importance,
    highway_role, walked_along, crossed_on_foot, lanes_by_width, lanes_one_way, width_one_way, lanes_each_way,
    parking_left AS class_parking_left, parking_right AS class_parking_right FROM axis_class) c USING (kind)
LEFT JOIN setting_used ON true
LEFT JOIN (
    SELECT (max(value) FILTER (WHERE name = 'lane_width'))::float8 AS lane_width,
        (max(value) FILTER (WHERE name = 'max_width_per_lane'))::float8 AS max_width_per_lane,
           (max(value) FILTER (WHERE name = 'lane_width_maximal'))::float8 AS widest_lane,
           (max(value) FILTER (WHERE name = 'lane_width_minimal'))::float8 AS narrowest_lane,
           (max(value) FILTER (WHERE name = 'width_default'))::float8 AS width_default,
               (max(value) FILTER (WHERE name = 'cycle_lane_width'))::float8 AS cycle_lane_width,
           (max(value) FILTER (WHERE name = 'parking_lane_width'))::float8 AS parking_lane_width,
               (max(value) FILTER (WHERE name = 'importance_default'))::integer AS importance_default,
           (max(value) FILTER (WHERE name = 'two_way_width_minimal'))::float8 AS two_way_width_minimal,
           streetgen._by_importance((max(value) FILTER (WHERE name = 'speed_by_importance'))::jsonb) AS speeds,
               (max(value) FILTER (WHERE name = 'speed_per_width'))::float8 AS speed_per_width,
           streetgen._by_importance(nullif(max(value) FILTER (WHERE name = 'radius_by_importance'), '')::jsonb)
               AS radii, max(value) FILTER (WHERE name = 'turning_mode') AS turning_mode,
           (max(value) FILTER (WHERE name = 'turning_radius_minimal'))::float8 AS turning_minimal,
           (max(value) FILTER (WHERE name = 'turning_radius_maximal'))::float8 AS turning_maximal,
           streetgen._by_importance((max(value) FILTER (WHERE name = 'sidewalk_by_importance'))::jsonb)
               AS sidewalks,
           streetgen._radius_function({model}, max(value) FILTER (WHERE name = 'radius_function')) AS predictor,
           bool_or(value = 'true') FILTER (WHERE name = 'roundabout_tags') AS tags_count,
           max(value) FILTER (WHERE name = 'driving_side') AS driving_side
    FROM setting) s ON true
-- Most models have none or one kind, and no axis of them is asked for its own of the others.
LEFT JOIN (SELECT EXISTS (SELECT FROM kerb_point_override) AS any_kerb, {flags}, {bays} AS bays_beside HAVING true) o
    ON true
-- HAVING: each step is computed once, not again in every expression that names it, and left out where none that is
-- asked for does.
-- The ways of OpenStreetMap that are tagged so run one way round, in their direction.
LEFT JOIN LATERAL (
    SELECT CASE WHEN direction = 'both' AND tags_count AND roundabout_tag IN ('roundabout', 'circular') THEN 'direct'
        ELSE direction END AS direction_used HAVING true) way ON true
LEFT JOIN LATERAL (
    SELECT CASE WHEN any_kerb THEN (SELECT avg(k.width ORDER BY k.kerb_point_override_id)
        FROM kerb_point_override k WHERE k.axis_id = a.axis_id) END AS kerb_by_hand HAVING true) hand ON true
-- A survey says the width and the offset of the roadway.
LEFT JOIN LATERAL (SELECT {surveyed} AS surveyed HAVING true) survey ON true
LEFT JOIN LATERAL (SELECT coalesce(kerb_by_hand, surveyed[1]) AS kerb_width HAVING true) kerb ON true
-- What a street has by its class alone: lanes of a direction, width without parking, and parking.
LEFT JOIN LATERAL (
    SELECT CASE WHEN direction_used = 'both' THEN lanes_each_way
            WHEN tags_count AND streetgen._names_ring(roundabout_tag) THEN 2 ELSE lanes_one_way END AS lanes_a_way,
        CASE WHEN direction_used = 'both' OR tags_count AND streetgen._names_ring(roundabout_tag) THEN class_width
            ELSE coalesce(width_one_way, lanes_one_way * lane_width, class_width) END AS width_usual,
        coalesce(class_parking_left + class_parking_right > 0 AND num_nonnulls(width, width_end,
            lane_count, nullif(lanes_forward, 0), nullif(lanes_backward, 0), nullif(lanes_both, 0), kind_forward,
            kind_backward, lane_width_forward, lane_width_backward) = 0, false) AND kerb_width IS NULL
            AS parks HAVING true) usual ON true
LEFT JOIN LATERAL (
    SELECT coalesce(streetgen.driving_lanes(kind_forward), nullif(lanes_forward, 0),
            CASE direction_used WHEN 'both' THEN streetgen._lanes_by_list(lane_count, lanes_both, turn_forward,
                lane_width_forward) END) AS stated_forward,
        coalesce(streetgen.driving_lanes(kind_backward), nullif(lanes_backward, 0),
            CASE direction_used WHEN 'both' THEN streetgen._lanes_by_list(lane_count, lanes_both, turn_backward,
                lane_width_backward) END) AS stated_backward,
           coalesce(importance, class_importance) AS importance_known, width_by_hand OR source IS NULL AS by_hand
               HAVING true) known ON true
LEFT JOIN LATERAL (
    -- A lane of a roundabout is as wide as long vehicles need that turn.
    SELECT narrowest, CASE WHEN by_hand OR NOT lanes_by_width OR streetgen._names_ring(roundabout_tag)
        THEN NULL ELSE max_width_per_lane END AS most_per_lane,
        -- Nobody drives a car where it is forbidden, nor where the class is made for walking or cycling.
        CASE WHEN by_hand OR NOT lanes_by_width OR class_width <= narrowest_lane
            OR access IN ('no', 'cycle', 'no|cycle', 'cycle|no') THEN 0 ELSE narrowest END AS least_width
    FROM (SELECT least(narrowest_lane * greatest(lane_count, coalesce(stated_forward, 0) + coalesce(stated_backward, 0)
        + coalesce(lanes_both, 0), 1), coalesce(width_usual, width_default)) AS narrowest HAVING true) n) m ON true
CROSS JOIN LATERAL (SELECT coalesce(lane_count, stated_forward + stated_backward + coalesce(lanes_both, 0))
        AS lanes_stated,
    streetgen._kerbside_width(kind_forward, lane_width_forward, lane_width, cycle_lane_width, parking_lane_width)
        + streetgen._kerbside_width(kind_backward, lane_width_backward, lane_width, cycle_lane_width,
            parking_lane_width) AS kerbside,
    CASE WHEN parks THEN class_parking_left + class_parking_right ELSE 0 END AS parking) stated
-- Lanes of the kerbs lie beside those that lane_count counts.
LEFT JOIN LATERAL (
    SELECT CASE WHEN streetgen.believed_width(width - kerbside, lane_count, most_per_lane) IS NOT NULL
            THEN greatest(width, least_width) END AS believed,
        CASE WHEN streetgen.believed_width(width_end - kerbside, lane_count, most_per_lane) IS NOT NULL
            THEN greatest(width_end, least_width) END AS believed_end HAVING true) b ON true
LEFT JOIN LATERAL (
    SELECT coalesce(kerb_width, believed,
        least(200, streetgen.estimated_width(CASE WHEN lanes_by_width IS NOT FALSE THEN lanes_stated END, width_usual,
            lane_width, width_default) + CASE WHEN lanes_stated IS NULL THEN parking ELSE kerbside END)) AS width_guess
            HAVING true) w ON true
-- The kerbs of a width that nothing states give way to what is mapped beside the street.
LEFT JOIN LATERAL (
    SELECT CASE WHEN kerb_width IS NULL AND believed IS NULL AND believed_end IS NULL
            AND num_nonnulls(lane_width_forward, lane_width_backward) = 0 AND lanes_by_width IS NOT FALSE
            AND (tags_count AND streetgen._names_ring(roundabout_tag)) IS NOT TRUE
        THEN {kerbs_beside} END AS kerbs_beside, narrowest + CASE WHEN lanes_stated IS NULL THEN parking ELSE kerbside
            END AS narrowest_between HAVING true) beside ON true
LEFT JOIN LATERAL (
    SELECT CASE WHEN kerbs_beside IS NULL THEN width_guess ELSE streetgen._width_between(streetgen._kerbs_between(
        width_guess, roadway_offset, kerbs_beside), width_guess, narrowest_between) END AS width_first
        HAVING true) moved ON true
LEFT JOIN LATERAL (
    SELECT coalesce(speed, class_speed, streetgen._estimated_speed(importance_known, width_first, speeds,
        speed_per_width)) AS speed_used HAVING true) p ON true
LEFT JOIN LATERAL (
    SELECT greatest(width_first, CASE WHEN kerb_width IS NULL THEN believed_end END) - parking < two_way_width_minimal
        AS narrow HAVING true) r ON true
LEFT JOIN LATERAL (
    SELECT CASE direction_used WHEN 'both' THEN streetgen.lanes_of_both(lanes_both, stated_forward, stated_backward,
               coalesce(kind_forward, kind_backward) IS NOT NULL, lane_count, narrow) ELSE 0 END AS both_used
                   HAVING true) t ON true
{more}
-- The rest is left to the lanes of one direction.
LEFT JOIN LATERAL (
    SELECT CASE WHEN lane_count IS NOT NULL THEN greatest(lane_count - both_used, 0) WHEN narrow AND both_used > 0
        THEN 0
                WHEN NOT lanes_by_width THEN CASE direction_used WHEN 'both' THEN 2 ELSE 1 END
                -- Both directions have as many.
                WHEN direction_used = 'both' THEN 2 * least(lanes_a_way, streetgen.estimated_lane_count(
                    greatest(width_first - kerbside - parking - both_used * lane_width, 0) / 2, speed_used,
                    lane_width), 15)
                ELSE least(lanes_a_way, streetgen.estimated_lane_count(
                    greatest(width_first - kerbside - parking, 0), speed_used, lane_width))
                END AS count_used,
           CASE WHEN both_used > 0 THEN 0 ELSE 1 END AS fewest HAVING true) n ON true
LEFT JOIN LATERAL (
    SELECT streetgen.lanes_of_way(direction_used <> 'reverse', kind_forward IS NOT NULL, stated_forward,
               CASE WHEN direction_used = 'both' THEN coalesce(stated_backward, count_used / 2)
                   WHEN kind_backward IS NULL THEN 0 ELSE stated_backward END, count_used, fewest) AS forward_used,
           streetgen.lanes_of_way(direction_used <> 'direct', kind_backward IS NOT NULL, stated_backward,
               CASE WHEN direction_used = 'both' THEN coalesce(stated_forward, (count_used + 1) / 2)
                   WHEN kind_forward IS NULL THEN 0 ELSE stated_forward END, count_used, fewest) AS backward_used
                   HAVING true) l ON true
-- A roadway of stated lanes that says no width is as wide as they are together, and that of a class leaves none of
-- its lanes more than 4.5 m.
LEFT JOIN LATERAL (
    SELECT CASE WHEN coalesce(kerb_width, believed) IS NOT NULL OR NOT lanes_by_width THEN width_first
        WHEN num_nonnulls(lane_count, stated_forward, stated_backward, lanes_both) = 0
        THEN least(width_first, (forward_used + backward_used + both_used) * greatest(4.5, lane_width) + parking)
        ELSE least(200, both_used * lane_width
            + streetgen._lanes_width(forward_used, kind_forward, lane_width_forward, lane_width, cycle_lane_width,
                parking_lane_width)
            + streetgen._lanes_width(backward_used, kind_backward, lane_width_backward, lane_width, cycle_lane_width,
                parking_lane_width)) END AS width_lanes HAVING true) f ON true
LEFT JOIN LATERAL (
    SELECT CASE WHEN num_nonnulls(lane_count, stated_forward, stated_backward, lanes_both) = 0 THEN width_guess
        ELSE width_lanes END AS width_unmoved HAVING true) g ON true
LEFT JOIN LATERAL (
    SELECT CASE WHEN kerbs_beside IS NOT NULL THEN streetgen._kerbs_between(width_unmoved, roadway_offset,
        kerbs_beside) END AS kerbs_used HAVING true) k ON true
LEFT JOIN LATERAL (
    SELECT CASE WHEN kerbs_beside IS NULL THEN width_lanes ELSE least(width_lanes, streetgen._width_between(
        kerbs_used, width_unmoved, narrowest_between)) END AS width_used HAVING true) u ON true
-- Each direction lists its lanes from its left to its right.
LEFT JOIN LATERAL (
    SELECT CASE WHEN direction_used = 'direct' OR direction_used = 'both' AND driving_side = 'left'
            THEN class_parking_left ELSE 0 END AS left_of_forward,
        CASE WHEN direction_used = 'direct' OR direction_used = 'both' AND driving_side <> 'left'
            THEN class_parking_right ELSE 0 END AS right_of_forward,
        CASE direction_used WHEN 'reverse' THEN class_parking_left
            WHEN 'both' THEN CASE driving_side WHEN 'left' THEN class_parking_right ELSE 0 END ELSE 0 END
            AS left_of_backward,
        CASE direction_used WHEN 'reverse' THEN class_parking_right
            WHEN 'both' THEN CASE driving_side WHEN 'left' THEN 0 ELSE class_parking_left END ELSE 0 END
            AS right_of_backward HAVING true) parked ON true

--{setting_used
CREATE OR REPLACE VIEW setting_used WITH (security_invoker = true) AS
SELECT jsonb_object_agg(name, value) AS settings, hashtextextended(string_agg(
        concat(name, '=', coalesce(value, '-'), CASE name WHEN 'radius_function'
            THEN streetgen._predictor_definition(value) END), ',' ORDER BY name){rings}, 3) AS setting_hash
FROM setting WHERE name <> ALL ({beside})

--{rings_used
    || coalesce((SELECT string_agg(pattern, ',' ORDER BY pattern) FROM roundabout_pattern), '')
