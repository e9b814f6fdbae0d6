-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{mapped_sidewalk
footway_rule AS MATERIALIZED (
    SELECT max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_distance') AS distance,
        max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_minimal') AS minimal,
        max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_maximal') AS maximal
    FROM {model}.setting WHERE name IN ('mapped_sidewalk_distance', 'mapped_sidewalk_minimal',
        'mapped_sidewalk_maximal')),
-- The borders of the roadway beside each edge, where it begins and ends, as the width runs along the axis. Nobody walks
-- along a class such as a motorway.
beside_footway AS MATERIALIZED (
    SELECT e.number, e.geom, e.level, e.beside_left, e.beside_right, row_number() OVER (ORDER BY e.number)::integer
            AS place, roadway_offset, (width + (width_end - width) * start_abscissa / length) / 2 AS half_at_start,
        (width + (width_end - width) * end_abscissa / length) / 2 AS half_at_end,
        greatest(width, width_end) / 2 + abs(roadway_offset) AS half, sidewalk_apart, parking_left, parking_right,
        strips_left, strips_right
    FROM (SELECT e.number, e.geom, e.level, e.beside_left, e.beside_right, e.start_abscissa, e.end_abscissa, u.width,
            u.width_end, u.roadway_offset, ST_Length2D(u.geom) AS length, a.*
        FROM written_edge e JOIN used u USING (axis_id), LATERAL (
            SELECT kind, sidewalk_apart, parking_left, parking_right, strips_left, strips_right FROM {model}.axis a
            WHERE a.axis_id = e.axis_id {by_key}) a) e LEFT JOIN (
        SELECT class, walked_along FROM {model}.axis_class) c ON c.class = e.kind
    WHERE c.walked_along IS NOT FALSE),
-- A walk of no role may be the sidewalk of a side that says that it has one apart. track: half the width of a cycle
-- track, which may lie where a sidewalk is estimated.
near_footway AS MATERIALIZED (
    SELECT f.*, row_number() OVER (ORDER BY footway_id)::integer AS place,
        CASE WHEN c.use = 'cycle' THEN coalesce(f.width, c.width, r.minimal) / 2 END AS track
    FROM ({footways}) f LEFT JOIN {model}.axis_class c ON c.class = f.kind, footway_rule r
    WHERE role = 'sidewalk' OR role IS NULL AND coalesce(c.use IN ('walk', 'cycle'), true)),
-- On medians, splitters and islands nobody walks along the street. before_walk: how deep strips and bays lie before the
-- walk.
walked_side AS MATERIALIZED (
    SELECT row_number() OVER (ORDER BY place, "left")::integer AS number, place, "left", at_start, at_end, apart,
        strips, strips_width + CASE WHEN parking LIKE 'street\_side%' AND {bays_stand}
            THEN streetgen._parking_depth(parking, (SELECT v FROM setting)) ELSE 0 END AS before_walk
    FROM (SELECT place, true AS "left", half_at_start + roadway_offset AS at_start,
            half_at_end + roadway_offset AS at_end, sidewalk_apart IN ('left', 'both') AS apart,
            parking_left AS parking, strips_left AS strips
        FROM beside_footway WHERE beside_left = 'outer'
        UNION ALL SELECT place, false, half_at_start - roadway_offset, half_at_end - roadway_offset,
            sidewalk_apart IN ('right', 'both'), parking_right, strips_right
        FROM beside_footway WHERE beside_right = 'outer') s,
        LATERAL (SELECT CASE WHEN strips IS NULL THEN 0 ELSE streetgen._strips_width(strips, (SELECT v FROM setting))
            END AS strips_width) w),
along_side AS MATERIALIZED (
    SELECT e.number, CASE WHEN s."left" THEN 'left' ELSE 'right' END AS side, f.footway_id, m.start_abscissa,
        m.end_abscissa, d.distance, f.track, f.role IS NULL AS only_apart, c.width, c.places, c.widths,
        greatest(c.width, (SELECT max(w) FROM unnest(c.widths) w)) AS widest
    FROM footway_rule r,
        (SELECT array_agg(ST_Force2D(geom)::bytea ORDER BY place) AS lines, array_agg(level ORDER BY place) AS levels
            FROM beside_footway) g,
        (SELECT array_agg(ST_Force2D(geom)::bytea ORDER BY place) AS lines, array_agg(level ORDER BY place) AS levels
            FROM near_footway) w,
        (SELECT array_agg(place ORDER BY number) AS edges, array_agg("left" ORDER BY number) AS lefts,
            array_agg(at_start ORDER BY number) AS at_start, array_agg(at_end ORDER BY number) AS at_end
            FROM walked_side) t,
        LATERAL streetgen._sidewalk_sources(g.lines, g.levels, w.lines, w.levels, t.edges, t.lefts, t.at_start,
            t.at_end, r.distance) m, walked_side s, beside_footway e, near_footway f,
        LATERAL (SELECT m.distance - s.before_walk AS distance) d,
        LATERAL (SELECT s.before_walk + least(50 - s.before_walk, streetgen._mapped_width(d.distance, f.width,
                r.minimal, r.maximal)) AS width, m.places,
            ARRAY(SELECT s.before_walk + least(50 - s.before_walk, streetgen._mapped_width(away - s.before_walk,
                    f.width, r.minimal, r.maximal))
                FROM unnest(m.distances) WITH ORDINALITY a(away, n) ORDER BY n) AS widths) c
    WHERE s.number = m.side AND e.place = s.place AND f.place = m.footway
        AND (f.role = 'sidewalk' OR s.apart OR f.track IS NOT NULL)),
-- One of two footways beside each other counts: that of role sidewalk, else the nearer one.
found_source AS MATERIALIZED (
    SELECT * FROM along_side s WHERE track IS NULL AND NOT EXISTS (SELECT FROM along_side o
        WHERE (o.number, o.side) = (s.number, s.side) AND o.track IS NULL
            AND (o.only_apart, o.distance, o.footway_id, o.start_abscissa)
            < (s.only_apart, s.distance, s.footway_id, s.start_abscissa)
        AND least(o.end_abscissa, s.end_abscissa) - greatest(o.start_abscissa, s.start_abscissa)
            > (s.end_abscissa - s.start_abscissa) / 2)),
-- Tracks along a side: how far behind its kerb they begin and end.
beside_track AS MATERIALIZED (
    SELECT number AS track_number, max(near) FILTER (WHERE side = 'left') AS near_left,
        max(far) FILTER (WHERE side = 'left') AS far_left, max(near) FILTER (WHERE side = 'right') AS near_right,
        max(far) FILTER (WHERE side = 'right') AS far_right
    FROM (SELECT s.number, s.side, sum((s.distance - s.track) * metres ORDER BY s.footway_id, s.start_abscissa)
                / sum(metres ORDER BY s.footway_id, s.start_abscissa) AS near,
            sum((s.distance + s.track) * metres ORDER BY s.footway_id, s.start_abscissa)
                / sum(metres ORDER BY s.footway_id, s.start_abscissa) AS far,
            sum(metres) >= least(20, 0.3 * min(ST_Length2D(e.geom))) AS enough
        FROM along_side s JOIN beside_footway e USING (number),
            LATERAL (SELECT s.end_abscissa - s.start_abscissa AS metres) m
        WHERE s.track IS NOT NULL GROUP BY s.number, s.side) t
    WHERE enough GROUP BY number),
-- A side of which a footway runs along a part is as wide as its footways are on the whole.
mapped_sidewalk AS MATERIALIZED (
    SELECT number AS mapped_number, max(width) FILTER (WHERE side = 'left') AS mapped_left,
        max(width) FILTER (WHERE side = 'right') AS mapped_right
    FROM (SELECT e.number, CASE WHEN s."left" THEN 'left' ELSE 'right' END AS side, CASE WHEN s.strips IS NULL
                THEN 0 ELSE streetgen._with_strips(0, NULL, s.strips, (SELECT v FROM setting)) END AS width,
            true AS enough
        FROM walked_side s JOIN beside_footway e USING (place)
        WHERE s.apart AND (SELECT value = 'none' FROM {model}.setting WHERE name = 'mapped_sidewalk_missing')
        UNION ALL SELECT s.number, s.side, sum(s.width * (s.end_abscissa - s.start_abscissa) ORDER BY s.footway_id,
                s.start_abscissa) / sum(s.end_abscissa - s.start_abscissa ORDER BY s.footway_id, s.start_abscissa),
            sum(s.end_abscissa - s.start_abscissa) >= least(20, 0.3 * min(ST_Length2D(e.geom)))
        FROM found_source s JOIN beside_footway e USING (number) GROUP BY s.number, s.side) m
    WHERE enough GROUP BY number)

--{sidewalk_before_track
-- An estimated sidewalk on whose ground a track lies goes on behind the track.
CASE WHEN u.sidewalk_{side} > 0 AND track.far_{side} > 0 AND track.near_{side} < u.sidewalk_{side}
        AND 'sidewalk_{side}' = ANY (u.estimated)
    THEN u.sidewalk_{side} + greatest(0, track.far_{side}) ELSE u.sidewalk_{side} END

--{kerbs_beside
-- Half of the least width of a sidewalk lies between a kerb and its footway, and none of the footway before the kerb.
-- One that lies nearer to the axis than to its kerb is no sidewalk, and along less than 0.3 of a side none tells.
(SELECT CASE WHEN num_nonnulls(on_left, on_right) > 0 THEN ARRAY[on_left, on_right] END FROM (
    SELECT min(to_kerb) FILTER (WHERE "left") AS on_left, min(to_kerb) FILTER (WHERE NOT "left") AS on_right FROM (
        SELECT side = 1 AS "left", round(least(middle - least_width / 2, nearest)::numeric, 3)::float8 AS to_kerb
        FROM (SELECT m.side, r.least_width, sum(m.distance * p.metres ORDER BY m.footway, m.start_abscissa)
                / sum(p.metres ORDER BY m.footway, m.start_abscissa) AS middle,
                min(least(m.distance, (SELECT min(d) FROM unnest(m.distances) d))) AS nearest,
                sum(p.metres ORDER BY m.footway, m.start_abscissa) AS metres
            -- Each setting is looked up once for all axes.
            FROM (SELECT least_width, distance,
                    width_guess / 2 + abs(coalesce(roadway_offset, 0)) + least_width / 2 AS farthest
                FROM (SELECT (SELECT value::float8 FROM setting WHERE name = 'mapped_sidewalk_minimal') AS least_width,
                    (SELECT value::float8 FROM setting WHERE name = 'mapped_sidewalk_distance') AS distance) v) r,
                LATERAL (SELECT array_agg(ST_Force2D(f.geom)::bytea ORDER BY footway_id) AS lines,
                    array_agg(f.level ORDER BY footway_id) AS levels,
                    array_agg(f.role IS NULL ORDER BY footway_id) AS only_apart,
                    bool_or(ST_DWithin(f.geom, a.geom, r.farthest)) AS within
                FROM footway f
                WHERE (f.role = 'sidewalk' OR f.role IS NULL AND sidewalk_apart IS NOT NULL
                        AND coalesce((SELECT use = 'walk' FROM axis_class WHERE class = f.kind), true))
                    AND f.geom && ST_Expand(a.geom, r.farthest)) f,
                LATERAL streetgen._sidewalk_sources(ARRAY[ST_Force2D(a.geom)::bytea], ARRAY[a.level], f.lines,
                    f.levels, '{1,1}', '{true,false}', '{0,0}', '{0,0}', least(50, r.farthest + r.distance)) m,
                LATERAL (SELECT m.end_abscissa - m.start_abscissa AS metres) p
            WHERE f.within AND (NOT f.only_apart[m.footway]
                OR sidewalk_apart IN ('both', (ARRAY['left', 'right'])[m.side]))
            GROUP BY m.side, r.least_width) s,
            LATERAL (SELECT (streetgen._kerbs_between(width_guess, roadway_offset, NULL))[side] AS kerb) k
        WHERE metres >= 0.3 * ST_Length(a.geom) AND middle > kerb / 2) s) b)

--{footways_near
SELECT DISTINCT ON (f.footway_id) f.* FROM footway_rule r, beside_footway e, LATERAL (
    SELECT footway_id, geom, kind, role, level, width FROM {model}.footway f
    WHERE f.geom && ST_Expand(e.geom, e.half + r.distance) OFFSET 0) f

--{all_footways
SELECT footway_id, geom, kind, role, level, width FROM {model}.footway

--{sidewalk_source_rows
SELECT row_number() OVER (ORDER BY s.number, s.side, s.start_abscissa, s.footway_id) AS number,
    (SELECT ids FROM edge_ids)[s.number] AS edge_id, s.side,
    row_number() OVER (PARTITION BY s.number, s.side ORDER BY s.start_abscissa, s.footway_id)::integer AS part,
    s.footway_id, s.start_abscissa, s.end_abscissa, s.distance, s.width, s.places, s.widths, s.widest
FROM found_source s

--{sidewalk_course
-- Sides along which the widths of their footways hold. The width runs straight from one stretch to the next, and goes
-- on before and beyond them.
SELECT coalesce(array_agg(number ORDER BY number, share, width), ARRAY[]::integer[]) AS course_kerbs,
    coalesce(array_agg(share ORDER BY number, share, width), ARRAY[]::float8[]) AS shares,
    coalesce(array_agg(width ORDER BY number, share, width), ARRAY[]::float8[]) AS course_widths
FROM (SELECT k.number::integer, (c.place - x.low) / (x.high - x.low) AS share, c.width
    FROM (SELECT edge_id, side, place, width, mean, max(width) OVER of_side - min(width) OVER of_side AS change
        FROM (SELECT s.edge_id, s.side, p.place, p.width, mean, max(s.end_abscissa) OVER (PARTITION BY s.edge_id, s.side
                ORDER BY s.start_abscissa, s.footway_id RANGE UNBOUNDED PRECEDING EXCLUDE GROUP) AS known_to
            FROM (SELECT *, sum(width * (end_abscissa - start_abscissa)) OVER of_side
                    / sum(end_abscissa - start_abscissa) OVER of_side AS mean
                FROM ({sources}) s WINDOW of_side AS (PARTITION BY edge_id, side)) s, LATERAL (
                SELECT * FROM unnest(
                    CASE cardinality(s.places) WHEN 0 THEN ARRAY[s.start_abscissa, s.end_abscissa] ELSE s.places END,
                    CASE cardinality(s.places) WHEN 0 THEN ARRAY[s.width, s.width] ELSE s.widths END)
                    u(place, width)) p) s
        -- The first of two footways says how wide a stretch is that both map.
        WHERE known_to IS NULL OR place > known_to
        WINDOW of_side AS (PARTITION BY edge_id, side)) c
    JOIN sidewalk_kerb k USING (edge_id, side), LATERAL (
        SELECT ST_LineLocatePoint(k.line, ST_StartPoint(k.geom)) * ST_Length2D(k.line) AS low,
            ST_LineLocatePoint(k.line, ST_EndPoint(k.geom)) * ST_Length2D(k.line) AS high) x
    WHERE c.change > 0.01 AND NOT k.by_hand AND abs(k.width - c.mean) < 0.01 AND abs(x.high - x.low) > 0.01) c

--{standing_sources
SELECT (SELECT ids FROM edge_ids)[number] AS edge_id, side, footway_id, start_abscissa, end_abscissa, places, widths,
    width FROM found_source
UNION ALL SELECT s.edge_id, s.side, s.footway_id, s.start_abscissa, s.end_abscissa, s.places, s.widths, s.width
FROM (SELECT DISTINCT edge_id FROM sidewalk_kerb) n, LATERAL (
    SELECT * FROM {model}.sidewalk_source s WHERE s.edge_id = n.edge_id OFFSET 0) s
WHERE s.edge_id NOT IN (SELECT edge_id FROM sidewalk_edge)

--{new_sources
SELECT (SELECT ids FROM edge_ids)[number] AS edge_id, side, footway_id, start_abscissa, end_abscissa, places, widths,
    width FROM found_source

--{has_crossing_footways
BEGIN
    RETURN EXISTS (SELECT FROM footway) AND EXISTS (SELECT FROM setting
        WHERE name = 'footway_crossings' AND value <> 'none');
END

--{footway_over
BEGIN
    RETURN (SELECT footway_id FROM footway f WHERE f.geom && ST_Expand(place, 1) AND ST_DWithin(f.geom, place, 1)
        AND f.level = _footway_over.level
        ORDER BY f.role IS DISTINCT FROM 'crossing', ST_Distance(f.geom, place), f.footway_id LIMIT 1);
END

--{footway_crossings
#variable_conflict use_column
DECLARE
    mapped_alone constant boolean := (SELECT value = 'mapped' FROM setting WHERE name = 'footway_crossings');
BEGIN
    IF NOT _has_crossing_footways() THEN
        RETURN;
    END IF;
    RETURN QUERY
    WITH street AS MATERIALIZED (
        SELECT e.edge_id, e.axis_id, e.level, e.from_node, e.to_node, e.start_abscissa, e.end_abscissa,
            ST_Force2D(e.geom) AS geom, ST_Force2D(a.geom) AS line, coalesce(c.walked_along, true) AS walked,
            greatest(e.width, e.width_end) / 2 + e.roadway_offset AS to_left,
            greatest(e.width, e.width_end) / 2 - e.roadway_offset AS to_right
        FROM edge e JOIN axis a USING (axis_id) LEFT JOIN axis_class c ON c.class = a.kind
        WHERE e.edge_id = ANY (edges)),
    -- A footway meets the edge or ends there, and goes on so far to the left of it and to the right.
    met AS MATERIALIZED (
        SELECT s.edge_id, f.footway_id, f.marked, f.width, streetgen._locate_on(s.line::bytea, p.geom::bytea) AS at,
            l.to_left, l.to_right
        FROM street s, LATERAL (
                SELECT footway_id, role = 'crossing' IS TRUE AS marked,
                    coalesce(f.width, CASE c.use WHEN 'cycle' THEN c.width END) AS width, ST_Force2D(f.geom) AS way
                FROM footway f LEFT JOIN axis_class c ON c.class = f.kind
                WHERE f.geom && ST_Expand(s.geom, 0.05) AND f.level = s.level AND ST_DWithin(f.geom, s.geom, 0.05)
                    AND (f.role = 'crossing' OR s.walked AND NOT mapped_alone)
                    AND coalesce(c.use, 'walk') = ANY (streetgen._footway_uses()) OFFSET 0) f,
            LATERAL (SELECT geom FROM ST_Dump(ST_Intersection(f.way, s.geom)) WHERE ST_Dimension(geom) = 0
                UNION ALL SELECT geom FROM unnest(ARRAY[ST_StartPoint(f.way), ST_EndPoint(f.way)]) geom
                WHERE ST_DWithin(geom, s.geom, 0.05)) p,
            LATERAL (SELECT ST_LineLocatePoint(f.way, p.geom) AS share, ST_Length(f.way) AS size) w,
            -- One that runs askew leaves the middle late.
            LATERAL (SELECT (array_agg(geom) FILTER (WHERE aside > 0))[1] AS to_left,
                    (array_agg(geom) FILTER (WHERE aside < 0))[1] AS to_right
                FROM (VALUES (-1), (1)) v(ahead), LATERAL (
                    SELECT geom, (streetgen._locate_on(s.line::bytea, geom::bytea))[2] AS aside
                    FROM generate_series(1, 3) step, LATERAL (SELECT ST_LineInterpolatePoint(f.way, greatest(0, least(1,
                        share + ahead * step * (greatest(s.to_left, s.to_right) + 0.5) / size))) AS geom) g
                    WHERE (streetgen._locate_on(s.line::bytea, geom::bytea))[2] NOT BETWEEN
                        -greatest(0.3, 0.4 * s.to_right) AND greatest(0.3, 0.4 * s.to_left)
                    ORDER BY step LIMIT 1) g) l
        WHERE size > 0),
    grouped AS (
        SELECT *, sum(apart) OVER (PARTITION BY edge_id ORDER BY at[1], footway_id) AS place FROM (
            SELECT *, (at[1] - lag(at[1]) OVER (PARTITION BY edge_id ORDER BY at[1], footway_id) > 0.5)::integer
                AS apart
            FROM met WHERE num_nonnulls(to_left, to_right) > 0) m),
    -- Footways that meet there are one crossing, of the one that says so, or else of the one that leads across.
    place AS MATERIALIZED (
        SELECT edge_id, (array_agg(footway_id ORDER BY turn))[1] AS footway_id, bool_or(marked) AS marked,
            (array_agg(at[1] ORDER BY turn))[1] AS abscissa, (array_agg(width ORDER BY turn))[1] AS width,
            (array_agg(to_left ORDER BY turn) FILTER (WHERE to_left IS NOT NULL))[1] AS to_left,
            (array_agg(to_right ORDER BY turn) FILTER (WHERE to_right IS NOT NULL))[1] AS to_right
        FROM (SELECT *, row_number() OVER (ORDER BY marked DESC, num_nonnulls(to_left, to_right) DESC, footway_id,
            at[1]) AS turn FROM grouped) g
        GROUP BY edge_id, place
        HAVING bool_or(to_left IS NOT NULL) AND bool_or(to_right IS NOT NULL)),
    across AS MATERIALIZED (
        SELECT s.edge_id, s.axis_id, s.start_abscissa, s.end_abscissa, s.from_node, s.to_node, p.footway_id, p.marked,
            greatest(s.start_abscissa, least(s.end_abscissa, round(p.abscissa::numeric, 6)::float8)) AS abscissa,
            -- Nobody paints one that runs on nearly along the street.
            round(greatest(30, least(150, degrees(ST_Angle(p.to_right, p.to_left, ST_LineInterpolatePoint(s.line,
                b.share), ST_LineInterpolatePoint(s.line, b.share_behind)))))::numeric, 6)::float8 AS angle,
            degrees(ST_Azimuth(p.to_right, p.to_left)) AS heading,
            greatest(0.5, least(20, coalesce(p.width, (streetgen._usual_crossing()).width))) AS width
        FROM place p JOIN street s USING (edge_id), LATERAL (SELECT greatest(0, p.abscissa - 1) / ST_Length(s.line)
            AS share, least(1, (p.abscissa + 1) / ST_Length(s.line)) AS share_behind) b)
    SELECT DISTINCT ON (x.axis_id, round(10 * x.abscissa)) x.edge_id, x.abscissa, x.angle, x.width FROM across x
    -- One crossing is made of two that lie on each other by half.
    WHERE NOT EXISTS (SELECT FROM across o WHERE o.edge_id = x.edge_id
            AND abs(o.abscissa - x.abscissa) < greatest(o.width, x.width) / 2
            AND (NOT o.marked, o.footway_id, o.abscissa) < (NOT x.marked, x.footway_id, x.abscissa))
        -- At a node the edge is crossed that is met squarest.
        AND NOT EXISTS (SELECT FROM (VALUES (x.from_node, x.abscissa - x.start_abscissa),
                (x.to_node, x.end_abscissa - x.abscissa)) n(node_id, away),
            LATERAL (SELECT edge_id FROM (SELECT *, 0 AS at, 1 AS ahead FROM edge WHERE from_node = n.node_id
                    UNION ALL SELECT *, 1, -1 FROM edge WHERE to_node = n.node_id) o,
                LATERAL (SELECT ST_Azimuth(ST_LineInterpolatePoint(geom, at), ST_LineInterpolatePoint(geom,
                    at + ahead * least(1, 2 / ST_Length(geom)))) AS leaves) l
                ORDER BY round(sind(x.heading - degrees(leaves))::numeric ^ 2, 2) DESC, axis_id, start_abscissa
                LIMIT 1) squarest
            WHERE n.away < 0.1 AND squarest.edge_id <> x.edge_id)
    ORDER BY x.axis_id, round(10 * x.abscissa), x.edge_id;
END

--{walk_link
CREATE OR REPLACE VIEW walk_link WITH (security_invoker = true) AS
SELECT walk_link_id, kind, from_node, to_node, level, metres, width, kerb_from, kerb_to, marking, surface, incline,
    climb, tactile_paving, wheelchair, foot, barriers, footway_id, edge_id, side, street_object_id, geom
FROM streetgen.walk_links({model})

--{footway_kerb_at
BEGIN
    RETURN (SELECT kerb FROM footway_kerb k WHERE k.geom && ST_Expand(place, 6) AND ST_DWithin(k.geom, place, 6)
        AND ST_Distance(k.geom, place) < ST_Distance(k.geom, across)
        ORDER BY ST_Distance(k.geom, place), footway_kerb_id LIMIT 1);
END
