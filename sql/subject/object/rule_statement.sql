-- Parts of the functions by which rules place objects, by name: streetgen._part gives each.

--{renew_rule_objects
#variable_conflict use_column
DECLARE
    bays_before geometry[];
    bays constant text[] := _types_below('parking_bay');
    crossings constant text[] := _types_below('crossing');
    on_roadway constant text[] := _types_on_roadway();
    -- Rules of the other sort place what an object keeps distance_least from.
    spaced constant boolean := EXISTS (SELECT FROM placement_rule JOIN object_type USING (type)
        WHERE active AND distance_least > 0);
    near_side constant text := (SELECT coalesce(max(value), 'right') FROM setting WHERE name = 'driving_side');
    bus_stops constant text[] := _types_below('bus_stop');
    least_lane constant float8 := (SELECT value::float8 FROM setting WHERE name = 'lane_width_minimal');
    bay_rules constant bigint := (SELECT count(*) FROM placement_rule WHERE active AND type = ANY (bays))
        + (SELECT count(*) FROM setting WHERE name = 'placement_function' AND value <> 'none');
    bays_stand constant boolean := EXISTS (SELECT FROM placement_rule WHERE active AND along = 'lane');
    on_lanes constant boolean := lying AND bays_stand;
    ruled constant boolean := EXISTS (SELECT FROM placement_rule WHERE active
            AND (type = ANY (on_roadway)) = lying)
        OR EXISTS (SELECT FROM setting WHERE name = 'placement_function' AND value <> 'none');
    -- Where footways lead over streets.
    walked constant streetgen.footway_crossing[] := CASE WHEN lying THEN ARRAY(
        SELECT f FROM _footway_crossings(ARRAY(SELECT edge_id FROM edge WHERE {of_streets})) f)
        ELSE ARRAY[]::streetgen.footway_crossing[] END;
{streets_beside}
    any_free constant boolean := EXISTS (SELECT FROM free_place);
    any_former constant boolean := EXISTS (SELECT FROM street_object WHERE placed_by <> 'rule'
        AND rule_id IS NOT NULL AND (type = ANY (on_roadway)) = lying
        AND {of_streets});
BEGIN
    IF NOT ruled AND cardinality(walked) = 0
        AND NOT EXISTS (SELECT FROM street_object WHERE rule_id IS NOT NULL AND (type = ANY (on_roadway)) = lying
            AND {of_streets}) THEN
        RETURN;
    END IF;
    -- A rule that places something else now places it anew: rows of the former type go with their objects.
    WITH gone AS (
        DELETE FROM street_object o USING placement_rule r WHERE o.rule_id = r.rule_id
            AND o.placed_by = 'rule' AND o.type <> r.type AND {of_streets} RETURNING o.street_object_id)
    SELECT array_agg(surface) FROM gone JOIN parking_bay USING (street_object_id) INTO bays_before;
{rule_objects}
    moved := moved || bays_before;
    IF any_former THEN
        UPDATE street_object SET rule_id = NULL, rule_place = NULL WHERE placed_by <> 'rule'
            AND rule_id IS NOT NULL AND (type = ANY (on_roadway)) = lying
            AND {of_streets};
    END IF;
    INSERT INTO pedestrian_crossing (street_object_id)
        SELECT o.street_object_id FROM street_object o WHERE o.placed_by = 'rule'
            AND o.type = ANY (crossings) AND {of_streets}
        ON CONFLICT DO NOTHING;
END

--{rule_objects
    WITH {spread}rule AS MATERIALIZED (
        SELECT r.*, t.distance_least, (r.type = ANY (on_roadway)) = lying AS own FROM placement_rule r
            JOIN object_type t USING (type) WHERE r.active AND (spaced OR (r.type = ANY (on_roadway)) = lying)),
    street AS MATERIALIZED (
        SELECT e.axis_id, e.level, e.edge_id, e.from_node, e.to_node, e.start_abscissa, e.end_abscissa,
            e.importance, a.kind, coalesce(c.crossed_on_foot, true) AS crossed, a.turn_forward, a.turn_backward,
            a.direction, a.parking_left, a.parking_right, a.strips_left, a.strips_right,
            e.edge_id IN (SELECT unnest(rings)) AS on_ring,
            ST_Force2D(u.geom) AS line, u.width, u.width_end, u.roadway_offset, b.borders,
            e.start_abscissa + l.abscissa AS low, e.start_abscissa + h.abscissa AS high,
            {beside} AS beside{away}
        FROM edge e JOIN axis a USING (axis_id) JOIN axis_used u USING (axis_id)
            LEFT JOIN axis_class c ON c.class = a.kind
            LEFT JOIN streetgen._axis_borders(current_schema(), computed) b USING (axis_id)
            JOIN section_limit l ON l.edge_id = e.edge_id AND l.which = 'start'
            JOIN section_limit h ON h.edge_id = e.edge_id AND h.which = 'end'{from_away}
        WHERE {of_edges}
            -- No other street has a place where footways alone make objects.
            AND (ruled OR e.edge_id IN (SELECT edge_id FROM unnest(walked)))),
    -- Lanes on which cars stand, and places for them beside the roadway: behind is how far these reach there.
    parking AS MATERIALIZED (
        SELECT p.edge_id, p.side, p.depth, p.borders, p.behind, b.*,
            streetgen._bay_run(b.length, b.width, b.angle) AS run
        FROM (SELECT edge_id, side, depth, borders, NULL::float8 AS behind, NULL AS orientation,
                along_axis
            FROM _parking_lanes(ARRAY(SELECT edge_id FROM street)) WHERE depth >= streetgen._least_bay_depth()
            UNION ALL SELECT s.edge_id, p.side, p.depth, NULL, p.behind, p.orientation,
                CASE s.direction WHEN 'both' THEN p.side = near_side ELSE s.direction = 'direct' END
            FROM street s, LATERAL streetgen._parking_beside(s.parking_left, s.parking_right,
                (SELECT settings FROM setting_used)) p
            WHERE num_nonnulls(s.parking_left, s.parking_right) > 0) p,
            LATERAL streetgen._bay_so_deep(p.depth, p.orientation, (p.side = 'right') = p.along_axis) b
        WHERE on_lanes),
    meeting AS MATERIALIZED (
        SELECT node, (SELECT count(*) FROM edge WHERE from_node = node)
            + (SELECT count(*) FROM edge WHERE to_node = node) AS arms
        FROM (SELECT from_node AS node FROM street UNION SELECT to_node FROM street) n
        WHERE EXISTS (SELECT FROM rule WHERE along = 'arm')),
    ruled AS (
        SELECT * FROM rule r, street s WHERE (r.importance_from IS NULL OR s.importance >= r.importance_from)
            AND (r.importance_to IS NULL OR s.importance <= r.importance_to)
            AND CASE WHEN r.kind IS NOT NULL THEN s.kind = ANY (r.kind) WHEN r.type = ANY (crossings)
                THEN s.crossed AND NOT s.on_ring ELSE true END{near_enough}),
    arc AS MATERIALIZED (
        SELECT r.rule_id, r.edge_id, c.half, c.at_end, c.centre, c.radius, k.kerb, ST_Length(k.kerb) AS size
        FROM ruled r, LATERAL (SELECT 0 AS half, arc, centre, radius, end_a AS at_end FROM corner
                WHERE edge_a = r.edge_id
                UNION ALL SELECT 1, arc, centre, radius, end_b FROM corner WHERE edge_b = r.edge_id) c,
            LATERAL (SELECT ST_CurveToLine(ST_Force2D(c.arc), 64) AS kerb OFFSET 0) k
        WHERE r.along = 'corner' AND c.radius > 0),
    place AS (
        SELECT r.*, CASE r.along WHEN 'border' THEN v.side END AS at_side, r.phase + k * r.every AS abscissa,
            (2 * k + (v.side = 'right')::integer)::integer AS rule_place, r.orientation AS turned,
            CASE WHEN r.along = 'border' AND (num_nonnulls(r.strips_left, r.strips_right) > 0 OR bays_stand
                    AND num_nonnulls(r.parking_left, r.parking_right) > 0) AND r.type <> ALL (bays)
                THEN streetgen._behind_strips(r.axis_offset, CASE WHEN bays_stand THEN CASE v.side WHEN 'left'
                        THEN r.parking_left ELSE r.parking_right END END, CASE v.side WHEN 'left' THEN r.strips_left
                    ELSE r.strips_right END, (SELECT settings FROM setting_used)) ELSE r.axis_offset END AS aside,
            NULL::float8 AS corner_offset, NULL::float8 AS bay_length, NULL::float8 AS bay_width
        FROM ruled r, LATERAL generate_series(
                greatest(0, ceil((low + distance_from_limit - phase) / every))::bigint,
                floor((high - distance_from_limit - phase) / every)::bigint) k,
            LATERAL (VALUES ('left'), ('right')) v(side)
        WHERE r.along IN ('axis', 'border')
            -- No other bays lie where a source says how cars stand, or that none does.
            AND (r.along = 'axis' OR r.type <> ALL (bays)
                OR CASE v.side WHEN 'left' THEN r.parking_left ELSE r.parking_right END IS NULL)
            AND CASE WHEN r.along = 'axis' THEN v.side = 'left'
            WHEN r.side = 'alternating' THEN v.side = CASE k % 2 WHEN 0 THEN 'left' ELSE 'right' END
            ELSE r.side IN (v.side, 'both') END
        UNION ALL
        -- An arm is seen as one comes to its node. Its places have negative numbers, by decimetres along the axis.
        -- Two arms of an edge share its middle where they have no room; an arm of one end alone goes to the other
        -- end, if the street goes on there, and else has none.
        SELECT r.*, CASE WHEN v.side <> 'middle' THEN CASE WHEN w.at_start THEN CASE v.side WHEN 'left' THEN 'right'
                ELSE 'left' END ELSE v.side END END,
            CASE WHEN w.at_start THEN low + within ELSE high - within END,
            (-1 - 2 * (2 * round(10 * CASE WHEN w.at_start THEN start_abscissa ELSE end_abscissa END)
                + w.at_start::integer) - (v.side = 'right')::integer)::integer,
            r.orientation + CASE WHEN w.at_start THEN CASE WHEN r.orientation > 0 THEN -180 ELSE 180 END ELSE 0 END,
            CASE v.side WHEN 'middle' THEN 0 ELSE r.axis_offset END, NULL, NULL, NULL
        FROM ruled r JOIN meeting f ON f.node = r.from_node JOIN meeting t ON t.node = r.to_node,
            LATERAL (SELECT f.arms AS of_start, t.arms AS of_end) n,
            LATERAL (SELECT of_start >= 3 AS at_start, of_end >= 3 AS at_end, 2 IN (of_start, of_end) AS goes_on,
                -- Two crossings leave the length of one between them.
                high - low > 2 * distance_from_limit + CASE WHEN r.type = ANY (crossings)
                    AND least(of_start, of_end) > 2 THEN 2 * (streetgen._usual_crossing()).width ELSE 0 END
                AS roomy) j,
            LATERAL (SELECT CASE WHEN j.roomy OR NOT (j.at_start AND j.at_end)
                THEN least(distance_from_limit, CASE WHEN j.goes_on THEN high - low ELSE (high - low) / 2 END)
                ELSE (high - low) / 2 END AS within) l,
            LATERAL (VALUES (true, j.at_start),
                (false, j.at_end AND (j.roomy OR NOT j.at_start OR r.side IN ('left', 'right'))))
                w(at_start, meets),
            LATERAL (VALUES ('left'), ('right'), ('middle')) v(side)
        WHERE r.along = 'arm' AND w.meets
            AND (j.roomy OR r.turn IS NULL AND (high > low AND j.at_start AND j.at_end OR j.goes_on))
            AND coalesce(r.turn = ANY (regexp_split_to_array(CASE WHEN w.at_start THEN r.turn_backward
                ELSE r.turn_forward END, '[|;]')), r.turn IS NULL)
            -- A crossing goes from kerb to kerb.
            AND CASE WHEN r.side = 'alternating' OR r.type = ANY (crossings) THEN v.side = 'middle'
                WHEN r.side = 'both' THEN v.side <> 'middle' ELSE v.side = r.side END
        UNION ALL
        -- Along the arc of a corner, behind its kerb: each half of it belongs to the street beside it, and is
        -- numbered by the place of the node there.
        SELECT r.*, NULL, at[1], (100000000 * (1 + (c.at_end = 'start')::integer + 2 * c.half) + n
            + 50 * (round(10 * CASE c.at_end WHEN 'start' THEN r.start_abscissa
                ELSE r.end_abscissa END)::bigint % 1000000))::integer, r.orientation, at[2], r.axis_offset, NULL,
            NULL
        FROM arc c JOIN ruled r ON (r.rule_id, r.edge_id) = (c.rule_id, c.edge_id),
            LATERAL (SELECT floor(size / r.every)::integer AS last OFFSET 0) s,
            LATERAL generate_series(0, least(last, 49)) n,
            LATERAL (SELECT (n * r.every + (size - last * r.every) / 2) / size AS share OFFSET 0) h,
            LATERAL (SELECT ST_LineInterpolatePoint(kerb, greatest(0, least(1, share))) AS foot OFFSET 0) f,
            LATERAL (SELECT streetgen._locate_on(r.line::bytea, ST_Translate(foot,
                (ST_X(c.centre) - ST_X(foot)) / c.radius * r.axis_offset,
                (ST_Y(c.centre) - ST_Y(foot)) / c.radius * r.axis_offset)::bytea) AS at OFFSET 0) l
        WHERE (share > 0.5) = (c.half = 1)
        UNION ALL
        -- Side by side in the middle of what a parking lane has between both limits, or its kerb, numbered by
        -- decimetres along the axis.
        SELECT r.*, l.side, c.at, (2 * round(10 * c.at) + (l.side = 'right')::integer
                + CASE WHEN l.behind IS NULL THEN 0 ELSE 1000000000 END)::integer, l.angle,
            coalesce(l.behind, round((b.outer_end - to_border)::numeric, 6)::float8), NULL, l.length, l.width
        FROM ruled r JOIN parking l ON l.edge_id = r.edge_id,
            LATERAL (SELECT high - low - 2 * distance_from_limit AS long) g,
            LATERAL (SELECT floor(long / run + 1e-9)::integer AS fit) f, LATERAL generate_series(0, fit - 1) k,
            LATERAL (SELECT low + distance_from_limit + (long - fit * run) / 2 + (k + 0.5) * run AS at) c,
            LATERAL (SELECT streetgen._border_at(l.borders, c.at - start_abscissa, l.side) AS outer_end,
                streetgen._to_border(r.width, width_end, ST_Length2D(line), roadway_offset, r.borders, c.at, l.side)
                AS to_border) b
        -- A false constant takes its places out of what is planned.
        WHERE on_lanes AND r.along = 'lane' AND r.side IN (l.side, 'both', 'alternating')
            -- A lane may begin or end between both limits.
            AND (l.behind IS NOT NULL OR l.depth - 0.05 <= (
                SELECT min(streetgen._border_at(l.borders, at - start_abscissa, 'left')
                    + streetgen._border_at(l.borders, at - start_abscissa, 'right'))
                FROM unnest(ARRAY[c.at - run / 2, c.at + run / 2]) at))
        UNION ALL
        -- By a function of the user, as rule 0, numbered by what it places and where.
        SELECT (own.rule).*, t.distance_least, true, s.*, p.side, p.abscissa, hashtext(concat_ws(' ', p.type,
            p.side, p.abscissa, p.axis_offset)), coalesce(p.orientation, 0), p.axis_offset, NULL,
            NULL, NULL
        FROM (SELECT DISTINCT ON (type, axis_id, side, abscissa, axis_offset) *
                FROM streetgen._own_placements(current_schema(), ARRAY(SELECT edge_id FROM street ORDER BY edge_id))
                ORDER BY type, axis_id, side, abscissa, axis_offset, orientation) p
            JOIN object_type t ON t.type = p.type AND (p.type = ANY (on_roadway)) = lying
            JOIN LATERAL (SELECT * FROM street x WHERE x.axis_id = p.axis_id
                AND p.abscissa BETWEEN x.start_abscissa AND x.end_abscissa ORDER BY x.start_abscissa LIMIT 1) s
                ON true,
            LATERAL (SELECT jsonb_populate_record(NULL::placement_rule, jsonb_build_object('rule_id', 0,
                'type', p.type, 'density', 1)) AS rule) own
        UNION ALL
        -- By a footway that leads over the street, as rule -1, numbered by decimetres along the axis.
        SELECT (own.rule).*, 0, true, s.*, NULL, p.abscissa, round(10 * p.abscissa)::integer, 90 - p.angle, 0, NULL,
            NULL, p.width
        FROM unnest(walked) p JOIN street s USING (edge_id),
            LATERAL (SELECT jsonb_populate_record(NULL::placement_rule, jsonb_build_object('rule_id', -1,
                'type', 'crossing', 'along', 'footway', 'density', 1)) AS rule) own,
            LATERAL (SELECT streetgen._place_on(s.line::bytea, p.abscissa, 0)::geometry AS foot,
                streetgen._crossing_ground(s.line::bytea, coalesce(s.borders, streetgen._even_borders(s.width,
                    s.width_end, ST_Length2D(s.line), s.roadway_offset)), p.abscissa, p.width, p.angle)::geometry
                AS ground OFFSET 0) g
        -- It is one with that of its node, or by hand, and lies on no other one by half, as where streets part.
        WHERE NOT EXISTS (SELECT FROM street_object o WHERE o.placed_by <> 'rule' AND o.type = ANY (crossings)
                AND o.method = 'relative' AND o.geom && ST_Expand(g.foot, 2)
                AND ST_DWithin(o.geom, g.foot, CASE o.axis_id WHEN s.axis_id THEN 2 ELSE 1 END))
            AND NOT EXISTS (SELECT FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
                WHERE c.surface && g.ground AND o.placed_by <> 'rule' AND ST_Area(ST_Intersection(c.surface, g.ground))
                    > least(ST_Area(c.surface), ST_Area(g.ground)) / 2)),
    taken AS MATERIALIZED (
        SELECT rule_id, type, along, every, distance_least, own, beside, {fresh} AS fresh, axis_id, level,
            edge_id, at_side, abscissa, rule_place, turned, aside, p.geom,
            streetgen._object_angle(line, abscissa, NULL, turned, 'axis') AS angle, corner_offset, bay_length,
            bay_width
        FROM place, LATERAL (SELECT streetgen._object_geometry(line, width, width_end, roadway_offset, borders,
            abscissa, NULL, at_side, aside) AS geom OFFSET 0) p{away_from_ground}
        WHERE streetgen._rule_takes(axis_id, rule_id, rule_place, density){places_near_enough}),
    bay AS MATERIALIZED (
        SELECT rule_id, t.axis_id, rule_place, t.level, edge_id, at_side, along,
            row_number() OVER (ORDER BY rule_id, t.axis_id, at_side = near_side DESC, rule_place) AS number,
            streetgen._bay_ground(line, streetgen._border_offset(
                streetgen._to_border(s.width, width_end, ST_Length2D(line), roadway_offset, borders, abscissa,
                    at_side), aside, at_side), at_side, abscissa, d.length, d.width, d.angle) AS ground,
            d.reach, abscissa, ROW (edge_id, at_side, abscissa - start_abscissa - d.reach,
                abscissa - start_abscissa + d.reach, aside,
                streetgen._bay_depth(d.length, d.width, d.angle))::streetgen.bay_place AS place
        FROM taken t JOIN street s USING (edge_id), LATERAL (
            SELECT *, streetgen._bay_reach(length, width, angle) AS reach FROM (
                SELECT coalesce(bay_length, usual.length) AS length, coalesce(bay_width, usual.width) AS width,
                    streetgen._bay_angle(turned) AS angle FROM streetgen._usual_bay() usual) l) d
        WHERE own AND type = ANY (bays)),
    given_bay AS MATERIALIZED (
        SELECT place FROM _laid_bays(CASE WHEN EXISTS (SELECT FROM bay) THEN ARRAY(SELECT edge_id FROM street)
            ELSE ARRAY[]::bigint[] END, of_rules => false) WHERE lying AND bay_rules > 0),
    -- Bays that others placed come first, and a rule leaves room beside them.
    laid AS MATERIALIZED (
        SELECT place, number, row_number() OVER (ORDER BY number) AS turn FROM (SELECT place, number FROM bay
            UNION ALL SELECT place, -row_number() OVER () FROM given_bay) p),
    room AS MATERIALIZED (
        SELECT l.place, l.number, r.on_lane, r.narrowest, r.taken, r.remains, r.needed
        FROM _bay_room((SELECT array_agg(place ORDER BY turn) FROM laid)) r JOIN laid l ON l.turn = r.number
        WHERE lying AND bay_rules > 0),
    roomy AS MATERIALIZED (
        SELECT r.*, b.rule_id, b.axis_id, b.rule_place, b.along FROM room r LEFT JOIN bay b USING (number)
        WHERE b.along IS NOT DISTINCT FROM 'lane' OR r.number < 0 OR NOT on_lane AND remains >= needed - 1e-6
            AND coalesce(narrowest >= least_lane - 1e-6, true)),
    crossed AS MATERIALIZED (SELECT axis_id, abscissa FROM taken WHERE own AND type = ANY (crossings)),
    -- Earlier versions let an object that became the user's keep its rule and place: that place is free.
    former AS MATERIALIZED (
        SELECT t.rule_id, t.axis_id, t.rule_place, t.geom FROM taken t
            JOIN street_object o USING (rule_id, axis_id, rule_place)
        WHERE any_former AND own AND o.placed_by <> 'rule'),
    left_free AS (
        INSERT INTO free_place (rule_id, geom)
        SELECT rule_id, geom FROM former ORDER BY rule_id, axis_id, rule_place),
    -- An object gives way to objects that others placed and to earlier rules; a bay also to intersections and
    -- crossings.
    in_the_way AS MATERIALIZED (
        SELECT t.rule_id, t.axis_id, t.rule_place FROM taken t JOIN taken b USING (axis_id)
            WHERE t.distance_least > 0 AND b.rule_id < t.rule_id AND b.at_side IS NOT DISTINCT FROM t.at_side
                AND abs(b.abscissa - t.abscissa) < t.distance_least
        UNION SELECT t.rule_id, t.axis_id, t.rule_place FROM taken t WHERE t.distance_least > 0
            AND EXISTS (SELECT FROM street_object o WHERE o.placed_by <> 'rule'
                AND ST_DWithin(o.geom, t.geom, t.distance_least))
        -- By difference, since a hash join of all places of a rule would pass over the spatial index.
        UNION SELECT t.rule_id, t.axis_id, t.rule_place FROM taken t JOIN free_place f
            ON f.rule_id - t.rule_id = 0 AND ST_DWithin(f.geom, t.geom, least(3, coalesce(t.every, 2) / 2))
            WHERE any_free
        UNION SELECT rule_id, axis_id, rule_place FROM former
        -- Three metres: half of a crossing, and one for who looks along the street.
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b JOIN crossed c USING (axis_id)
            WHERE abs(c.abscissa - b.abscissa) < b.reach + 3
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b JOIN bay c USING (axis_id)
            WHERE bay_rules > 1 AND c.rule_id < b.rule_id AND abs(c.abscissa - b.abscissa) < b.reach + c.reach
                AND c.ground && b.ground AND streetgen._takes_ground(c.ground, b.ground)
        UNION SELECT rule_id, axis_id, rule_place FROM bay WHERE ground IS NULL
        UNION SELECT rule_id, axis_id, rule_place FROM bay b
            WHERE NOT EXISTS (SELECT FROM roomy r WHERE r.number = b.number)
        -- The later one of two bays opposite each other goes where they leave too little. A source says that cars
        -- stand on parking lanes: these bays stay.
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM roomy b JOIN roomy c
            ON (c.place).edge_id = (b.place).edge_id AND (c.place).side <> (b.place).side
            WHERE b.number > c.number AND b.along <> 'lane' AND (c.place).low < (b.place).high
                AND (b.place).low < (c.place).high AND b.remains - c.taken < b.needed - 1e-6
        -- A bus needs 15 m to leave the roadway, and to come back.
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b JOIN street_object o USING (axis_id)
            JOIN street s USING (edge_id)
            WHERE o.type = ANY (bus_stops) AND o.placed_by <> 'rule' AND o.method = 'relative'
                AND b.at_side = streetgen._side_of_street(o.side, o.axis_offset, s.roadway_offset)
                AND abs(o.abscissa - b.abscissa) < b.reach + 15
        -- Nobody walks over one street twice within 20 m: an arm that has a crossing of others gets none.
        UNION SELECT t.rule_id, t.axis_id, t.rule_place FROM taken t JOIN street s USING (edge_id)
            JOIN street_object o ON o.axis_id = t.axis_id AND o.abscissa BETWEEN s.start_abscissa AND s.end_abscissa
            WHERE t.along = 'arm' AND t.type = ANY (crossings) AND o.type = ANY (crossings) AND o.placed_by <> 'rule'
                AND o.method = 'relative' AND abs(o.abscissa - t.abscissa) < 20
        UNION SELECT t.rule_id, t.axis_id, t.rule_place FROM taken t JOIN taken b USING (edge_id)
            WHERE t.along = 'arm' AND t.type = ANY (crossings) AND b.along = 'footway'
                AND abs(b.abscissa - t.abscissa) < 20
        -- Behind the kerb it leaves room for who comes to a crossing that others placed.
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b JOIN street_object o USING (axis_id)
            JOIN pedestrian_crossing c USING (street_object_id)
            WHERE (b.place).axis_offset > 0 AND o.placed_by <> 'rule' AND o.method = 'relative'
                AND abs(o.abscissa - b.abscissa) < b.reach + 3
        -- And other streets their roadway.
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b, LATERAL (
                SELECT s.edge_id FROM section s WHERE (b.place).axis_offset > 0 AND s.surface && b.ground
                    AND s.edge_id <> b.edge_id AND streetgen._takes_ground(s.surface, b.ground) OFFSET 0) s
            JOIN edge e USING (edge_id) WHERE e.level = b.level
        -- By difference, since a hash join of a whole level would pass over the spatial index.
        UNION SELECT rule_id, axis_id, rule_place FROM bay b JOIN intersection i ON i.surface && b.ground
            AND i.level - b.level = 0 AND streetgen._takes_ground(i.surface, b.ground)
        UNION SELECT b.rule_id, b.axis_id, b.rule_place FROM bay b, LATERAL (
                SELECT c.street_object_id FROM pedestrian_crossing c WHERE c.surface && b.ground
                    AND streetgen._takes_ground(c.surface, b.ground)
                UNION ALL SELECT c.street_object_id FROM parking_bay c WHERE c.surface && b.ground
                    AND streetgen._takes_ground(c.surface, b.ground) OFFSET 0) c
            JOIN street_object o USING (street_object_id) WHERE o.placed_by <> 'rule'),
    asked AS MATERIALIZED (
        SELECT t.*, row_number() OVER (ORDER BY rule_id, axis_id, rule_place) AS number,
            ROW (type, geom, level, CASE along WHEN 'corner' THEN corner_offset
                WHEN 'axis' THEN NULL ELSE CASE WHEN at_side IS NOT NULL THEN aside END END,
                along IN ('border', 'corner'), NULL)::streetgen.standing_place AS place
        FROM taken t WHERE own AND NOT EXISTS (SELECT FROM in_the_way w
            WHERE (w.rule_id, w.axis_id, w.rule_place) = (t.rule_id, t.axis_id, t.rule_place))),
    near AS MATERIALIZED (
        SELECT n.number, n.earlier FROM (SELECT array_agg(number) AS numbers, array_agg(place) AS places,
                array_agg(rule_id) AS rules, array_agg(axis_id) AS axes, array_agg(every) AS every,
                array_agg(fresh) AS fresh
            FROM asked WHERE NOT lying) a, _near_earlier(a.numbers, a.places, a.rules, a.axes, a.every,
                a.fresh) n),
    -- Other places are judged if an object may have to give way to them.
    judged AS MATERIALIZED (
        SELECT *, row_number() OVER (ORDER BY number) AS turn FROM asked
        WHERE fresh OR number IN (SELECT earlier FROM near)),
    clear AS MATERIALIZED (
        SELECT * FROM judged WHERE turn NOT IN (SELECT h.number
            FROM _hindrances((SELECT array_agg(place ORDER BY turn) FROM judged)) h)),
    free AS MATERIALIZED (
        SELECT * FROM clear WHERE fresh AND number NOT IN (SELECT number FROM near
            WHERE earlier IN (SELECT c.number FROM clear c))),
    -- No more bays than a source counts cars, along all of the side.
    counted AS (
        SELECT f.number FROM (SELECT number, edge_id, at_side, row_number() OVER side_of_axis AS nth,
                count(*) OVER (PARTITION BY rule_id, axis_id, at_side) AS many FROM free WHERE along = 'lane'
            WINDOW side_of_axis AS (PARTITION BY rule_id, axis_id, at_side ORDER BY abscissa)) f
            JOIN street s USING (edge_id), LATERAL (SELECT streetgen._parking_capacity(CASE at_side
                WHEN 'left' THEN parking_left ELSE parking_right END) AS cars) c
        WHERE many > cars AND (2 * nth * cars + many) / (2 * many) = (2 * (nth - 1) * cars + many) / (2 * many)),
    held AS MATERIALIZED (
        SELECT street_object_id, type, geom, angle, axis_id, abscissa, side, axis_offset, orientation, rule_id,
            rule_place, method
        FROM street_object WHERE placed_by = 'rule' AND (type = ANY (on_roadway)) = lying
            AND {of_held}),
    compared AS MATERIALIZED (
        SELECT f.type, f.geom, f.angle, CASE WHEN f.at_side IS NULL THEN 'axis' ELSE 'border' END AS placement,
            axis_id, f.abscissa, f.at_side, f.aside, f.turned, f.rule_id, f.rule_place,
            h.street_object_id AS held, h.geom AS was,
            (f.type, f.geom::bytea, f.angle, f.abscissa, f.at_side, f.aside, f.turned, 'relative')
                IS DISTINCT FROM (h.type, h.geom::bytea, h.angle, h.abscissa, h.side, h.axis_offset, h.orientation,
                h.method) AS differs, f.along, f.bay_length, f.bay_width
        FROM (SELECT * FROM free WHERE along <> 'lane' OR number NOT IN (SELECT number FROM counted)) f
            FULL JOIN held h USING (rule_id, axis_id, rule_place)),
    gone AS (
        DELETE FROM street_object o USING compared c
        WHERE c.type IS NULL AND o.street_object_id = c.held),
    moved AS (
        UPDATE street_object o SET type = c.type, geom = c.geom, angle = c.angle, placement = c.placement,
            abscissa = c.abscissa, side = c.at_side, axis_offset = c.aside, orientation = c.turned,
            method = 'relative'
        FROM compared c WHERE c.type IS NOT NULL AND c.differs AND o.street_object_id = c.held),
    put AS (
        INSERT INTO street_object (type, geom, angle, placement, axis_id, abscissa, side, axis_offset, orientation,
            placed_by, rule_id, rule_place, method)
        SELECT type, geom, angle, placement, axis_id, abscissa, at_side, aside, turned, 'rule', rule_id, rule_place,
            'relative'
        FROM compared WHERE held IS NULL ORDER BY rule_id, axis_id, rule_place
        RETURNING street_object_id, rule_id, axis_id, rule_place),
    -- A rule's orientation is the angle of its bays.
    put_bay AS (
    INSERT INTO parking_bay AS b (street_object_id, length, width, angle)
        SELECT coalesce(c.held, p.street_object_id), coalesce(c.bay_length, usual.length),
            coalesce(c.bay_width, usual.width), streetgen._bay_angle(c.turned)
        FROM compared c LEFT JOIN put p USING (rule_id, axis_id, rule_place), streetgen._usual_bay() usual
        WHERE c.type = ANY (bays)
        ON CONFLICT (street_object_id) DO UPDATE SET length = excluded.length, width = excluded.width,
            angle = excluded.angle
        WHERE (b.length, b.width, b.angle) <> (excluded.length, excluded.width, excluded.angle)),
    put_crossing AS (
    INSERT INTO pedestrian_crossing AS b (street_object_id, width, angle)
        SELECT coalesce(c.held, p.street_object_id), c.bay_width, 90 - c.turned
        FROM compared c LEFT JOIN put p USING (rule_id, axis_id, rule_place) WHERE c.along = 'footway'
        ON CONFLICT (street_object_id) DO UPDATE SET width = excluded.width, angle = excluded.angle
        WHERE (b.width, b.angle) <> (excluded.width, excluded.angle))
    {changed} INTO streets, moved;

--{rule_streets_beside
    -- An object gives way to one of an axis beside, which is looked at, and written where ground changed near it.
    far constant float8 := CASE WHEN NOT lying THEN CASE WHEN ground IS NULL THEN streetgen._object_reach(
        current_schema()) ELSE (SELECT max(farthest) FROM _object_spread()) END END;
    looked_at constant streetgen.edge_near[] := CASE WHEN lying THEN ARRAY[]::streetgen.edge_near[] ELSE ARRAY(
        SELECT ROW (edge_id, axis_id, CASE WHEN ground IS NULL THEN 0 ELSE away END)::streetgen.edge_near
        FROM _edges_near(coalesce(ground, ARRAY(SELECT s.surface FROM edge e JOIN section s USING (edge_id)
            WHERE e.axis_id = ANY (axes))), far) WHERE axis_id <> ALL (axes)) END;
    computed constant bigint[] := axes || ARRAY(SELECT axis_id FROM unnest(looked_at));
    rings constant bigint[] := streetgen._edges_on_rings(current_schema(),
        ARRAY(SELECT edge_id FROM edge WHERE axis_id = ANY (axes)));

--{rule_streets
    computed constant bigint[] := NULL;
    rings constant bigint[] := streetgen._edges_on_rings(current_schema(), NULL);

--{rules_looked_at

        LEFT JOIN unnest(looked_at) w ON w.edge_id = e.edge_id

--{rule_edges
a.axis_id = ANY (computed) AND u.axis_id = ANY (computed) AND e.axis_id = ANY (computed)
            AND (e.axis_id = ANY (axes) OR w.edge_id IS NOT NULL)

--{rules_near_enough

            AND (NOT s.beside OR s.away <= (SELECT farthest FROM spread f WHERE f.type = r.type))

--{fresh_places
CASE WHEN ground IS NULL THEN NOT beside ELSE edge_id = ANY (edges)
            OR coalesce(g.away <= (SELECT reach FROM spread f WHERE f.type = place.type), false) END

--{away_from_ground
,
            LATERAL (SELECT min(ST_Distance(s, p.geom)) AS away FROM unnest(ground) s
                WHERE edge_id <> ALL (edges) OFFSET 0) g

--{places_near_enough

            AND (NOT beside OR ground IS NULL
                OR g.away <= (SELECT farthest FROM spread f WHERE f.type = place.type))

--{rule_spread
spread AS MATERIALIZED (SELECT * FROM _object_spread()),

--{rule_held
axis_id = ANY (computed) AND CASE WHEN axis_id = ANY (axes)
                -- Places that are there no more too.
                THEN (rule_id, axis_id, rule_place) NOT IN (
                    SELECT rule_id, axis_id, rule_place FROM taken WHERE NOT beside AND NOT fresh)
                ELSE (rule_id, axis_id, rule_place) IN (
                    SELECT rule_id, axis_id, rule_place FROM taken WHERE beside AND fresh) END

--{rule_changes
SELECT array_agg(DISTINCT axis_id), array_agg(place) FROM (
            SELECT axis_id, was AS place FROM compared WHERE held IS NOT NULL AND differs
            UNION ALL SELECT axis_id, geom FROM compared WHERE type IS NOT NULL AND differs
            -- The ground of crossings and bays that go changes too.
            UNION ALL SELECT c.axis_id, p.surface FROM compared c JOIN pedestrian_crossing p
                ON p.street_object_id = c.held WHERE c.type IS NULL
            UNION ALL SELECT c.axis_id, p.surface FROM compared c JOIN parking_bay p
                ON p.street_object_id = c.held WHERE c.type IS NULL) c

--{no_rule_changes
SELECT NULL, array_agg(p.surface) FROM compared c JOIN parking_bay p ON p.street_object_id = c.held
        WHERE c.type IS NULL
