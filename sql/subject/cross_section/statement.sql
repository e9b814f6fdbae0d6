-- View cross_section, and what each subject that a model computes gives to it, by name: streetgen._part gives each.

--{cross_section
CREATE OR REPLACE VIEW cross_section WITH (security_invoker = true) AS
SELECT e.edge_id, e.axis_id, e.first + s.low AS start_abscissa, e.first + s.high AS end_abscissa, p.side, p."order",
    p.kind, p.kerb, p.lane_id, r.offset_from, nullif(r.offset_to, 'Infinity') AS offset_to, r.offset_from_end,
    nullif(r.offset_to_end, 'Infinity') AS offset_to_end,
    CASE WHEN p.kind IN ('sidewalk', 'furnishing')
            THEN CASE p.side WHEN 'left' THEN g.sidewalk_left ELSE g.sidewalk_right END
        WHEN p.kind = 'cycle' THEN CASE p.side WHEN 'left' THEN g.cycle_left ELSE g.cycle_right END
        WHEN p.kind = 'cycle_track' THEN CASE p.side WHEN 'left' THEN e.track_left ELSE e.track_right END
        WHEN p.lane_id IS NOT NULL OR p.kind IN ('roadway', 'rail', 'shoulder', 'gutter') AND p."order" > 0
            AND r.offset_to < 'Infinity' THEN g.roadway END AS paved
FROM (
    SELECT e.edge_id, e.axis_id, e.start_abscissa AS first, ST_Force2D(e.geom) AS line, e.beside_left, e.beside_right,
        e.median_left, e.median_right, x.strips_left, x.strips_right, x.cycle_paved_left AS track_left,
        x.cycle_paved_right AS track_right,
        a.abscissa AS low, b.abscissa AS high, coalesce(s.borders, streetgen._even_borders(e.width, e.width_end,
            e.end_abscissa - e.start_abscissa, e.roadway_offset)) AS borders
    FROM edge e JOIN section s USING (edge_id) JOIN axis x USING (axis_id)
        JOIN section_limit a ON (a.edge_id, a.which) = (e.edge_id, 'start')
        JOIN section_limit b ON (b.edge_id, b.which) = (e.edge_id, 'end')
    WHERE a.abscissa < b.abscissa) e
JOIN paving g USING (edge_id)
-- A stretch has the same pieces from its start to its end, and their borders run straight.
CROSS JOIN LATERAL (
    SELECT place AS low, lead(place) OVER (ORDER BY place) AS high FROM (
        SELECT place, place - lag(place) OVER (ORDER BY place) AS step FROM (
            VALUES (e.low), (e.high) UNION ALL SELECT * FROM streetgen._border_places(e.borders){places}) known(place)
        WHERE place BETWEEN e.low AND e.high) steps
    WHERE step IS NULL OR step > 1e-6) s
CROSS JOIN LATERAL (
    WITH driven AS MATERIALIZED ({lanes}),
    -- Outwards from the axis to each border, and what lies before and behind it.
    roadside AS MATERIALIZED (
        SELECT v.outwards, b.border, b.border_end, y.bay_from, y.bay_from_end, y.bay_to, y.bay_to_end,
            coalesce(y.bay_from, b.border) AS inner_border, coalesce(y.bay_from_end, b.border_end) AS inner_border_end,
            -- Cars drive over the kerb before a bay behind it.
            CASE WHEN f.behind > 0 AND k.kerb = 'standing' THEN 'flush' ELSE k.kerb END AS kerb, f.behind, f.front,
            k.sidewalk, k.sidewalk_end, k.beside, CASE WHEN k.sidewalk - k.paved > f.front + t.strips + 0.05
                THEN 'verge' ELSE 'furnishing' END AS before_walk,
            CASE WHEN k.sidewalk - k.paved > f.front + t.strips + 0.05
                    THEN k.sidewalk - k.paved - f.front - t.strips
                WHEN y.bay_behind IS NULL AND k.sidewalk > y.parking_strip
                    AND y.parking_strip > k.stone THEN y.parking_strip - k.stone
                WHEN t.strips > 0 THEN 0
                WHEN k.sidewalk - f.front - g.furnishing >= streetgen._walking_width() THEN g.furnishing
                ELSE 0 END AS furnishing, g.gutter, k.sidewalk_end - k.sidewalk AS change, t.said, t.strips,
            -- A bay on the kerb takes from what lies there, and moves none of it.
            CASE WHEN t.strips > 0 AND y.parking_strip = 0 THEN least(f.front, k.stone) ELSE f.front END AS kept_front
        FROM (VALUES ('left', 1, e.beside_left), ('right', -1, e.beside_right)) v(side, outwards, beside)
            CROSS JOIN LATERAL (SELECT streetgen._border_at(e.borders, s.low, v.side) AS border,
                streetgen._border_at(e.borders, s.high, v.side) AS border_end, (s.low + s.high) / 2 AS middle) b
            CROSS JOIN LATERAL ({kerbs}) k CROSS JOIN LATERAL ({bays}) y
            -- The stone lies behind a bay beside the roadway, and in the ground of one on the kerb.
            CROSS JOIN LATERAL (SELECT coalesce(y.bay_behind, 0) AS behind, coalesce(y.bay_behind, 0)
                + CASE WHEN y.bay_behind IS NULL OR y.parking_strip > 0 THEN k.stone ELSE 0 END AS front) f
            CROSS JOIN (SELECT (SELECT value::float8 FROM setting WHERE name = 'gutter_width') AS gutter,
                (SELECT value::float8 FROM setting WHERE name = 'furnishing_width') AS furnishing) g
            CROSS JOIN LATERAL (SELECT said, CASE WHEN said IS NULL THEN 0 ELSE streetgen._strips_width(said,
                (SELECT settings FROM setting_used)) END AS strips
                FROM (SELECT CASE v.side WHEN 'left' THEN e.strips_left ELSE e.strips_right END AS said) a) t),
    beside_lanes AS (
        SELECT r.*, greatest(filled, border - gutter) AS gutter_from,
            greatest(filled_end, border_end - gutter) AS gutter_from_end
        FROM (SELECT r.*, least(inner_border, d.outer_border) AS room, least(inner_border_end, d.outer_border_end)
                AS room_end, greatest(bay_to, least(border, d.outer_border)) AS filled,
                greatest(bay_to_end, least(border_end, d.outer_border_end)) AS filled_end
            FROM roadside r CROSS JOIN LATERAL (
                SELECT max(CASE r.outwards WHEN 1 THEN left_offset ELSE -right_offset END) AS outer_border,
                    max(CASE r.outwards WHEN 1 THEN left_offset_end ELSE -right_offset_end END) AS outer_border_end
                FROM driven) d) r),
    -- Metres to the left of the axis.
    strip AS (
        SELECT d.lane_id, d.kind, NULL AS kerb, least(d.left_offset, l.inner_border) AS left_offset,
            least(greatest(d.right_offset, -r.inner_border), d.left_offset, l.inner_border) AS right_offset,
            least(d.left_offset_end, l.inner_border_end) AS left_offset_end,
            least(greatest(d.right_offset_end, -r.inner_border_end), d.left_offset_end, l.inner_border_end)
                AS right_offset_end
        FROM driven d, roadside l, roadside r WHERE (l.outwards, r.outwards) = (1, -1)
        -- A lane goes on behind a bay, as a cycle lane does at the kerb.
        UNION ALL SELECT d.lane_id, d.kind, NULL, d.left_offset,
            least(d.left_offset, greatest(d.right_offset, r.bay_to)), d.left_offset_end,
            least(d.left_offset_end, greatest(d.right_offset_end, r.bay_to_end))
        FROM driven d, roadside r WHERE r.outwards = 1 AND r.bay_to IS NOT NULL
        UNION ALL SELECT d.lane_id, d.kind, NULL, greatest(d.right_offset, least(d.left_offset, -r.bay_to)),
            d.right_offset, greatest(d.right_offset_end, least(d.left_offset_end, -r.bay_to_end)), d.right_offset_end
        FROM driven d, roadside r WHERE r.outwards = -1 AND r.bay_to IS NOT NULL
        UNION ALL SELECT NULL, CASE x.kind WHEN 'stone' THEN 'kerb' ELSE x.kind END,
            CASE x.kind WHEN 'kerb' THEN b.kerb WHEN 'stone' THEN 'standing' END,
            CASE b.outwards WHEN 1 THEN x.outer_border ELSE -x.inner_border END,
            CASE b.outwards WHEN 1 THEN x.inner_border ELSE -x.outer_border END,
            CASE b.outwards WHEN 1 THEN x.outer_border_end ELSE -x.inner_border_end END,
            CASE b.outwards WHEN 1 THEN x.inner_border_end ELSE -x.outer_border_end END
        FROM beside_lanes b CROSS JOIN LATERAL (
            -- The verge before a sidewalk of one width changes with the ground.
            SELECT CASE before_walk WHEN 'verge' THEN greatest(change, -furnishing) ELSE 0 END AS verge_change) h
            CROSS JOIN LATERAL (SELECT border + kept_front + furnishing AS strips_from,
                border_end + kept_front + furnishing + verge_change AS strips_from_end, border + front AS behind_bay,
                border_end + front AS behind_bay_end) c
            CROSS JOIN LATERAL (SELECT strips_from + strips AS walk_from, strips_from_end + strips
                AS walk_from_end) w
            CROSS JOIN LATERAL (VALUES
            ('shoulder', room, coalesce(bay_from, gutter_from), room_end, coalesce(bay_from_end, gutter_from_end)),
            ('bay', bay_from, bay_to, bay_from_end, bay_to_end),
            ('shoulder', CASE WHEN bay_to IS NOT NULL THEN filled END, gutter_from, filled_end, gutter_from_end),
            ('gutter', gutter_from, border, gutter_from_end, border_end),
            ('kerb', border, CASE WHEN behind > 0 THEN border ELSE border + front END, border_end,
                CASE WHEN behind > 0 THEN border_end ELSE border_end + front END),
            ('bay', border, border + behind, border_end, border_end + behind),
            ('stone', CASE WHEN behind > 0 AND front > behind THEN border + behind END, border + front,
                border_end + behind, border_end + front),
            (before_walk, border + front, border + front + furnishing, border_end + front,
                border_end + front + furnishing + verge_change),
            ('sidewalk', least(greatest(walk_from, behind_bay), border + sidewalk), border + sidewalk,
                least(greatest(walk_from_end, behind_bay_end), border_end + sidewalk_end), border_end + sidewalk_end),
            (beside, border + greatest(front, sidewalk), 'Infinity', border_end + greatest(front, sidewalk_end),
                'Infinity')
            UNION ALL SELECT t.kind, least(greatest(strips_from + near, behind_bay), border + sidewalk),
                least(greatest(strips_from + far, behind_bay), border + sidewalk),
                least(greatest(strips_from_end + near, behind_bay_end), border_end + sidewalk_end),
                least(greatest(strips_from_end + far, behind_bay_end), border_end + sidewalk_end)
            FROM streetgen._side_strips(b.said, (SELECT settings FROM setting_used)) t WHERE b.strips > 0)
            x(kind, inner_border, outer_border, inner_border_end, outer_border_end)
        WHERE x.inner_border IS NOT NULL AND (x.kind <> 'kerb' OR b.kerb IS NOT NULL))
    SELECT f.side, row_number() OVER (PARTITION BY f.side ORDER BY f.offset_from + f.offset_from_end,
            f.offset_to + f.offset_to_end)::integer AS "order", t.kind, t.kerb, t.lane_id, f.offset_from, f.offset_to,
        f.offset_from_end, f.offset_to_end
    FROM strip t CROSS JOIN LATERAL (VALUES
        ('left', greatest(0, t.right_offset), greatest(0, t.left_offset), greatest(0, t.right_offset_end),
            greatest(0, t.left_offset_end)),
        ('right', greatest(0, -t.left_offset), greatest(0, -t.right_offset), greatest(0, -t.left_offset_end),
            greatest(0, -t.right_offset_end))) f(side, offset_from, offset_to, offset_from_end, offset_to_end)
    WHERE greatest(f.offset_to - f.offset_from, f.offset_to_end - f.offset_from_end) > 1e-9
        OR t.kind = 'kerb' AND greatest(f.offset_from, f.offset_from_end) > 0) p
-- Neighbours end at the same number.
CROSS JOIN LATERAL (SELECT round(p.offset_from::numeric, 9)::float8 AS offset_from,
    round(p.offset_to::numeric, 9)::float8 AS offset_to, round(p.offset_from_end::numeric, 9)::float8
        AS offset_from_end, round(p.offset_to_end::numeric, 9)::float8 AS offset_to_end) r
WHERE s.high IS NOT NULL

--{cross_section_without_lanes
SELECT NULL::bigint AS lane_id, 'roadway' AS kind, streetgen._border_at(e.borders, s.low, 'left') AS left_offset,
    -streetgen._border_at(e.borders, s.low, 'right') AS right_offset,
    streetgen._border_at(e.borders, s.high, 'left') AS left_offset_end,
    -streetgen._border_at(e.borders, s.high, 'right') AS right_offset_end

--{cross_section_lanes
SELECT l.lane_id, l.kind, streetgen._border_at(b.borders, s.low, 'left') AS left_offset,
    -streetgen._border_at(b.borders, s.low, 'right') AS right_offset,
    streetgen._border_at(b.borders, s.high, 'left') AS left_offset_end,
    -streetgen._border_at(b.borders, s.high, 'right') AS right_offset_end
FROM lane l CROSS JOIN LATERAL (SELECT streetgen._lane_borders(l.borders, l.width, l.axis_offset) AS borders) b
WHERE l.edge_id = e.edge_id AND (s.low + s.high) / 2 BETWEEN coalesce(l.start_abscissa - e.first, e.low)
    AND coalesce(l.end_abscissa - e.first, e.high)

--{cross_section_tracks
WITH across AS ({lanes}),
track AS (
    SELECT streetgen._border_at(t.borders, s.low, 'left') AS "left", -streetgen._border_at(t.borders, s.low, 'right')
            AS "right", streetgen._border_at(t.borders, s.high, 'left') AS left_end,
        -streetgen._border_at(t.borders, s.high, 'right') AS right_end
    FROM street_track t WHERE t.edge_id = e.edge_id AND t.borders IS NOT NULL
        AND (s.low + s.high) / 2 BETWEEN t.start_abscissa AND t.end_abscissa),
-- The part of each lane that each track takes.
taken AS (
    SELECT a.lane_id, greatest(a.right_offset, least(a.left_offset, "left")) AS "left",
        greatest(a.right_offset, least(a.left_offset, "right")) AS "right",
        greatest(a.right_offset_end, least(a.left_offset_end, left_end)) AS left_end,
        greatest(a.right_offset_end, least(a.left_offset_end, right_end)) AS right_end
    FROM across a, track)
SELECT p.lane_id, CASE WHEN EXISTS (SELECT FROM taken t WHERE t.lane_id IS NOT DISTINCT FROM p.lane_id
        AND 2 * (t."left" + t.left_end) > m.twice AND 2 * (t."right" + t.right_end) < m.twice)
        THEN 'rail' ELSE p.kind END AS kind,
    p.left_offset, p.right_offset, p.left_offset_end, p.right_offset_end
FROM (
    SELECT lane_id, kind, at AS left_offset, lead(at) OVER w AS right_offset, at_end AS left_offset_end,
        lead(at_end) OVER w AS right_offset_end
    FROM (
        SELECT lane_id, kind, at, at_end FROM across, LATERAL (VALUES (left_offset, left_offset_end),
            (right_offset, right_offset_end)) v(at, at_end)
        UNION SELECT a.lane_id, a.kind, at, at_end
        FROM taken t JOIN across a ON a.lane_id IS NOT DISTINCT FROM t.lane_id,
            LATERAL (VALUES ("left", left_end), ("right", right_end)) v(at, at_end)
        -- Tracks that lie on each other are one piece.
        WHERE NOT EXISTS (SELECT FROM taken o WHERE o.lane_id IS NOT DISTINCT FROM t.lane_id
            AND o."left" + o.left_end > at + at_end AND o."right" + o.right_end < at + at_end)) v
    WINDOW w AS (PARTITION BY lane_id ORDER BY at + at_end DESC)) p, LATERAL (
        SELECT p.left_offset + p.left_offset_end + p.right_offset + p.right_offset_end AS twice) m
WHERE p.right_offset IS NOT NULL

--{cross_section_track_places
UNION ALL SELECT p.place FROM street_track t CROSS JOIN LATERAL (
    VALUES (t.start_abscissa), (t.end_abscissa) UNION ALL SELECT * FROM streetgen._border_places(t.borders)) p(place)
    WHERE t.edge_id = e.edge_id AND t.borders IS NOT NULL

--{cross_section_lane_places
UNION ALL SELECT p.place FROM lane l CROSS JOIN LATERAL (
    VALUES (l.start_abscissa - e.first), (l.end_abscissa - e.first)
    UNION ALL SELECT * FROM streetgen._border_places(l.borders)) p(place) WHERE l.edge_id = e.edge_id

--{cross_section_without_kerbs
SELECT NULL AS kerb, 0::float8 AS stone, 0::float8 AS sidewalk, 0::float8 AS sidewalk_end, NULL::float8 AS paved,
    v.beside

--{cross_section_kerbs
SELECT CASE WHEN k.kerb_id IS NULL THEN 'none' ELSE coalesce({flush}, 'standing') END AS kerb,
    CASE WHEN k.kerb_id IS NULL THEN 0 ELSE (SELECT value::float8 FROM setting WHERE name = 'kerb_stone_width') END
        AS stone, {sidewalk} AS sidewalk, {sidewalk_end} AS sidewalk_end, {paved} AS paved,
    coalesce(k.beside, 'roadway') AS beside
FROM (VALUES (1)) one LEFT JOIN LATERAL (
    SELECT k.* FROM kerb k CROSS JOIN LATERAL streetgen._kerb_extent(k.method, k.geom, e.line, e.low, e.high,
        CASE k.side WHEN 'left' THEN e.median_left ELSE e.median_right END) x
    WHERE k.edge_id = e.edge_id AND k.node_id IS NULL AND k.side = v.side AND b.middle BETWEEN x.low AND x.high
        -- There the roadway goes on.
        AND k.method <> 'level_change' LIMIT 1) k ON true

--{cross_section_kerb_places
UNION ALL SELECT p.place FROM kerb k CROSS JOIN LATERAL streetgen._kerb_extent(k.method, k.geom, e.line, e.low, e.high,
    CASE k.side WHEN 'left' THEN e.median_left ELSE e.median_right END) x
    CROSS JOIN LATERAL (VALUES (x.low), (x.high)) p(place)
WHERE k.edge_id = e.edge_id AND k.node_id IS NULL AND k.side IN ('left', 'right')

--{cross_section_sidewalk
coalesce((SELECT CASE WHEN w.method = 'contested' {or_changing} THEN ST_Length(ST_Intersection(
        coalesce(w.strip, w.surface), ST_MakeLine(
            streetgen._place_on(e.line::bytea, {at}, v.outwards * {border})::geometry,
            streetgen._place_on(e.line::bytea, {at}, v.outwards * ({border} + {widest}))::geometry)))
        ELSE w.width END
    FROM sidewalk w WHERE (w.edge_id, w.side, w.part) = (k.edge_id, k.side, k.part)), 0)

--{cross_section_changing
OR EXISTS (SELECT FROM sidewalk_source s WHERE (s.edge_id, s.side) = (k.edge_id, k.side))

--{cross_section_widest
greatest(w.width, (SELECT max(s.widest) FROM sidewalk_source s WHERE (s.edge_id, s.side) = (k.edge_id, k.side)))

--{cross_section_paved
-- That of the stretch beside, or of the nearest one, where the sidewalk is as wide as its footways ask for.
(SELECT CASE WHEN abs(c.mean - CASE v.side WHEN 'left' THEN g.sidewalk_left ELSE g.sidewalk_right END) < 0.01
        AND c.width < c.wanted THEN c.width END
    FROM edge g, LATERAL (SELECT sum(s.width * (s.end_abscissa - s.start_abscissa))
                / sum(s.end_abscissa - s.start_abscissa) AS mean,
            (array_agg(f.width ORDER BY greatest(s.start_abscissa - b.middle, b.middle - s.end_abscissa),
                s.part))[1] AS width,
            (array_agg(s.width ORDER BY greatest(s.start_abscissa - b.middle, b.middle - s.end_abscissa),
                s.part))[1] AS wanted
        FROM sidewalk_source s JOIN footway f USING (footway_id)
        WHERE (s.edge_id, s.side) = (e.edge_id, v.side)) c
    WHERE g.edge_id = e.edge_id)

--{cross_section_changing_places
UNION ALL SELECT p.place FROM sidewalk_source s CROSS JOIN LATERAL (VALUES (s.start_abscissa), (s.end_abscissa)
    UNION ALL SELECT unnest(s.places)) p(place) WHERE s.edge_id = e.edge_id

--{cross_section_flush
(SELECT CASE says WHEN 'raised' THEN 'standing' WHEN 'no' THEN 'flush' ELSE says END
    FROM street_object o JOIN pedestrian_crossing c USING (street_object_id)
    CROSS JOIN LATERAL (SELECT coalesce(CASE v.side WHEN 'left' THEN c.kerb_left ELSE c.kerb_right END, 'flush')
        AS says) w
    CROSS JOIN LATERAL streetgen._crossing_mouth(o.abscissa - e.first, c.width, c.angle, v.outwards
        * streetgen._border_at(e.borders, o.abscissa - e.first, v.side)) m
    WHERE o.axis_id = e.axis_id AND o.method = 'relative' AND c.surface IS NOT NULL
        AND b.middle BETWEEN m.low AND m.high ORDER BY o.street_object_id LIMIT 1)

--{cross_section_flush_places
UNION ALL SELECT p.place FROM street_object o JOIN pedestrian_crossing c USING (street_object_id)
    CROSS JOIN (VALUES ('left', 1), ('right', -1)) v(side, outwards)
    CROSS JOIN LATERAL streetgen._crossing_mouth(o.abscissa - e.first, c.width, c.angle, v.outwards
        * streetgen._border_at(e.borders, o.abscissa - e.first, v.side)) m
    CROSS JOIN LATERAL (VALUES (m.low), (m.high)) p(place)
WHERE o.axis_id = e.axis_id AND o.method = 'relative' AND c.surface IS NOT NULL

--{cross_section_without_bays
SELECT NULL::float8 AS bay_from, NULL::float8 AS bay_from_end, NULL::float8 AS bay_to, NULL::float8 AS bay_to_end,
    NULL::float8 AS bay_behind, 0::float8 AS parking_strip

--{cross_section_bays
SELECT y.*, coalesce(p.depth, 0) AS parking_strip
FROM (VALUES (1)) one LEFT JOIN LATERAL (
    -- Between roadway and sidewalk.
    SELECT streetgen._parking_depth(a.said, (SELECT settings FROM setting_used)) AS depth
    FROM (SELECT CASE v.side WHEN 'left' THEN parking_left ELSE parking_right END AS said FROM axis a
        WHERE a.axis_id = e.axis_id AND EXISTS (SELECT FROM placement_rule WHERE active AND along = 'lane')) a
    WHERE a.said LIKE 'street\_side%') p ON true LEFT JOIN LATERAL (
    -- On the roadway, and behind its border.
    SELECT CASE WHEN on_roadway THEN b.border + o.axis_offset - d.depth END AS bay_from,
        CASE WHEN on_roadway THEN b.border_end + o.axis_offset - d.depth END AS bay_from_end,
        CASE WHEN on_roadway THEN b.border + least(o.axis_offset, 0) END AS bay_to,
        CASE WHEN on_roadway THEN b.border_end + least(o.axis_offset, 0) END AS bay_to_end,
        CASE WHEN o.axis_offset > 0.01 THEN o.axis_offset END AS bay_behind
    FROM street_object o JOIN parking_bay p USING (street_object_id)
        CROSS JOIN LATERAL (SELECT streetgen._bay_depth(p.length, p.width, p.angle) AS depth,
            streetgen._bay_run(p.length, p.width, p.angle) / 2 AS half) d
        CROSS JOIN LATERAL (SELECT o.axis_offset < d.depth - 0.01 AS on_roadway) w
    WHERE o.axis_id = e.axis_id AND o.method = 'relative' AND o.side = v.side AND p.surface IS NOT NULL
        AND b.middle BETWEEN o.abscissa - e.first - d.half AND o.abscissa - e.first + d.half
        -- One away from its kerb is on other ground.
        AND o.axis_offset < d.depth + 0.01
    ORDER BY d.depth - o.axis_offset DESC LIMIT 1) y ON true

--{cross_section_bay_places
UNION ALL SELECT o.abscissa - e.first + end_of.sign * streetgen._bay_run(p.length, p.width, p.angle) / 2
FROM street_object o JOIN parking_bay p USING (street_object_id) CROSS JOIN (VALUES (-1), (1)) end_of(sign)
WHERE o.axis_id = e.axis_id AND o.method = 'relative' AND p.surface IS NOT NULL
