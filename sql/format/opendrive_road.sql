-- OpenDRIVE: roads, those along edges with their lanes, and those of the ways from lane to lane.

CREATE OR REPLACE FUNCTION streetgen._opendrive_roads(model name, options jsonb, joining boolean DEFAULT false)
    RETURNS TABLE(road_id bigint, connecting boolean, s float8[], x float8[], y float8[], heading float8[],
        length float8[],
        curvature float8[], curvature_end float8[], total float8, edge_id bigint, before integer, lefts integer,
        lanes bigint[], types text[], positions integer[], halves boolean[], share_from float8, share_to float8,
        station float8[], border float8[], ways text, road_in bigint, road_out bigint, number_in bigint,
        number_out bigint, in_end boolean, out_end boolean, width_in float8, width_out float8, node_id bigint,
        type text, lane_in bigint, speed float8, lean_in float8, lean_out float8, own_ends boolean[],
        joined_road bigint[], joined_end boolean[], joined_numbers integer[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH written_edge AS MATERIALIZED (
        SELECT * FROM edge WHERE edge_id IN (SELECT streetgen._written_edges(model, options))),
    origin AS MATERIALIZED (SELECT * FROM streetgen._opendrive_origin(model, options)),
    -- Geometries are here where coordinates count on a projection of their own.
    projected AS MATERIALIZED (SELECT * FROM streetgen._projected_geometries(model, options)),
    way AS MATERIALIZED (
        SELECT f.file_id, interconnections, lane_in, lane_out, along_in, along_out, traffic,
            coalesce(p.geom, w.geom) AS geom
        FROM streetgen._connecting_ways(model, options) w
            CROSS JOIN LATERAL (SELECT streetgen._file_id(way_kind, way_id, part) AS file_id) f
            LEFT JOIN projected p ON (p.kind, p.id) = ('way', f.file_id)),
    placed_lane AS MATERIALIZED (
        SELECT l.lane_id, l.edge_id, l.lane_position, l.along_axis, l.both_ways, l.kind, l.turn, l.width,
            l.start_abscissa, l.end_abscissa, coalesce(p.geom, l.geom) AS geom, coalesce(q.geom, l.surface) AS surface
        FROM lane l JOIN written_edge USING (edge_id)
            LEFT JOIN projected p ON (p.kind, p.id) = ('lane', l.lane_id)
            LEFT JOIN projected q ON (q.kind, q.id) = ('surface', l.lane_id)),
    place AS MATERIALIZED (SELECT node_id, place_id FROM streetgen._places(model, options)),
    course AS MATERIALIZED (
        SELECT c.edge_id, coalesce(streetgen._course_through(c.alignment, p.geom), c.alignment) AS alignment, c.reach
        FROM streetgen._opendrive_courses(model, options) c
            LEFT JOIN projected p ON (p.kind, p.id) = ('course', c.edge_id)),
    side AS MATERIALIZED (
        SELECT value IS DISTINCT FROM 'left' AS right_hand FROM setting WHERE name = 'driving_side'),
    -- Lanes on the right have negative numbers and lead along the road where one drives on the right. A lane that comes
    -- between others against this order begins a road of its own.
    -- A lane for both directions has two halves where these are lanes of their own: part 1 is the left one.
    sided AS (
        SELECT *, lag(on_right) OVER (PARTITION BY edge_id ORDER BY lane_position, part) AS was_right
        FROM (SELECT l.*, part, part = 2 OR part = 0 AND along_axis = right_hand AS on_right, right_hand
            FROM side, placed_lane l JOIN (VALUES (0), (1), (2)) v(part)
                ON (part > 0) = (both_ways AND options ->> 'two_way_lanes' IS NOT DISTINCT FROM 'driving')) l),
    road AS (
        SELECT edge_id, run, min(lane_position) - 1 AS before,
            count(*) FILTER (WHERE NOT on_right)::integer AS lefts,
            array_agg(lane_id ORDER BY lane_position, part) AS lanes,
            array_agg(streetgen._opendrive_lane_type(kind, both_ways AND part = 0, turn)
                ORDER BY lane_position, part) AS types,
            array_agg(lane_position ORDER BY lane_position, part) AS positions,
            array_agg(part ORDER BY lane_position, part) AS parts,
            array_agg(CASE WHEN part > 0 THEN on_right = right_hand END ORDER BY lane_position, part) AS halves,
            array_agg(geom::bytea ORDER BY lane_position, part) AS lines,
            array_agg(surface::bytea ORDER BY lane_position, part) AS surfaces,
            -- A merging lane lies on its ground alone.
            array_agg(CASE WHEN start_abscissa IS NULL AND end_abscissa IS NULL THEN width ELSE 0 END
                ORDER BY lane_position, part) AS widths
        FROM (SELECT *, count(*) FILTER (WHERE was_right AND NOT on_right)
                OVER (PARTITION BY edge_id ORDER BY lane_position, part) AS run FROM sided) s
        GROUP BY edge_id, run),
    stretch AS (
        SELECT e.edge_id, coalesce(p.geom, e.geom) AS geom, first.abscissa AS since,
            last.abscissa AS until, ST_Length(e.geom) AS total
        FROM written_edge e LEFT JOIN projected p ON (p.kind, p.id) = ('edge', e.edge_id)
            JOIN section_limit first ON (first.edge_id, first.which) = (e.edge_id, 'start')
            JOIN section_limit last ON (last.edge_id, last.which) = (e.edge_id, 'end')),
    whole AS MATERIALIZED (
        SELECT r.edge_id, r.run, r.before, r.lefts, r.lanes, r.types, r.positions, r.halves, v.share_from,
            v.share_to, d.*, d.s[cardinality(d.s)] + d.length[cardinality(d.s)] AS total
        FROM origin o, road r JOIN stretch t USING (edge_id) LEFT JOIN course c USING (edge_id),
            -- Crossed limits lie at one place; those within 5 mm of a node lie on it.
            LATERAL (SELECT greatest(least(since, (since + until - 0.01) / 2, total - 0.01), 0) AS first) u,
            LATERAL (SELECT least(greatest(until, first + 0.01), total) AS final) z,
            LATERAL (SELECT CASE WHEN first > 0.005 THEN first / total ELSE 0 END AS share_from,
                CASE WHEN final < total - 0.005 THEN final / total ELSE 1 END AS share_to) v,
            LATERAL streetgen._road_lanes(ST_LineSubstring(ST_Force2D(t.geom), share_from, share_to)::bytea,
                coalesce(c.alignment, '{}'), coalesce(c.reach, 0), r.lines, r.surfaces, r.widths, r.parts,
                o.tolerance) d),
    whole_end AS MATERIALIZED (
        SELECT lane_id, edge_id, run, i::integer AS i, v.at_end, at_node, halves[i] AS half, places[4 * i - 3] AS x,
            places[4 * i - 2] AS y, places[4 * i - 1] AS heading, places[4 * i] AS width
        FROM whole, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i), LATERAL (VALUES
            (false, share_from = 0, starts), (true, share_to = 1, ends)) v(at_end, at_node, places)),
    way_end AS MATERIALIZED (
        SELECT k.file_id, n.place_id, a.edge_id AS edge_in, a.run AS run_in, a.i AS i_in,
            a.at_end AS in_end, b.edge_id AS edge_out, b.run AS run_out, b.i AS i_out, b.at_end AS out_end,
            ST_Length(k.geom) AS length, k.traffic,
            joining AND a.at_node AND b.at_node AND sqrt((a.x - b.x) ^ 2 + (a.y - b.y) ^ 2) < 0.005
                AND abs(a.width - b.width) < 0.01
                AND cos(a.heading - b.heading) * CASE WHEN a.at_end = b.at_end THEN -1 ELSE 1 END > 0.999999 AS meets
        FROM way k JOIN whole_end a ON (a.lane_id, a.at_end) = (k.lane_in, k.along_in)
                AND coalesce(a.half = k.along_in, true)
            JOIN whole_end b ON (b.lane_id, b.at_end) = (k.lane_out, NOT k.along_out)
                AND coalesce(b.half = k.along_out, true)
            JOIN written_edge e ON e.edge_id = a.edge_id
            JOIN place n ON n.node_id = CASE WHEN k.along_in THEN e.to_node ELSE e.from_node END),
    -- Two roads that meet lane to lane, where nobody waits or crosses, are joined without a junction.
    joint AS MATERIALIZED (
        SELECT place_id
        FROM way_end
        GROUP BY place_id
        HAVING bool_and(meets AND traffic IS NULL AND edge_in <> edge_out)
            AND min(least(edge_in, edge_out)) = max(least(edge_in, edge_out))
            AND min(greatest(edge_in, edge_out)) = max(greatest(edge_in, edge_out))
            AND max(run_in) = 0 AND max(run_out) = 0
            AND min(in_end::integer) FILTER (WHERE edge_in < edge_out)
                IS NOT DISTINCT FROM max(in_end::integer) FILTER (WHERE edge_in < edge_out)
            AND count(DISTINCT (edge_in, i_in, in_end)) = count(*)
            AND count(DISTINCT (edge_out, i_out, out_end)) = count(*)
            AND place_id NOT IN (SELECT streetgen._held_places(model, options))
            AND place_id IN (SELECT n.place_id
                FROM written_edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id)
                    JOIN place n USING (node_id) GROUP BY n.place_id HAVING count(*) = 2)),
    -- Roads are cut back where lanes meet in a junction, or go on beside their end: a way of no length is none.
    met AS MATERIALIZED (
        SELECT edge_id, at_end, greatest(0.05, 2 * max(length)) AS cut
        FROM way_end, LATERAL (VALUES (edge_in, in_end), (edge_out, out_end)) v(edge_id, at_end)
        WHERE length < 2 AND place_id NOT IN (TABLE joint) GROUP BY edge_id, at_end),
    -- CARLA does not tell the ends of a road apart that begins and ends at one junction: it is two, joined.
    looped AS (
        SELECT e.edge_id FROM written_edge e JOIN place f ON f.node_id = e.from_node
            JOIN place t ON t.node_id = e.to_node
        WHERE joining AND f.place_id = t.place_id AND f.place_id IN (SELECT place_id FROM way_end)),
    -- The halves meet within the longest piece of the chain, where no border bends: at no plain share of it.
    piece AS MATERIALIZED (
        SELECT edge_id, run, nth, streetgen._file_id('edge', edge_id, (run + 5 * nth)::integer) AS road_id,
            ARRAY[nth = 0, nth = last] AS ends, CASE nth WHEN 0 THEN first ELSE middle END AS since,
            CASE nth WHEN last THEN final ELSE middle END AS until
        FROM (SELECT w.edge_id, w.run, w.total, least(coalesce(f.cut, 0), w.total / 4) AS first,
                w.total - least(coalesce(t.cut, 0), w.total / 4) AS final,
                (w.edge_id IN (TABLE looped))::integer AS last, CASE WHEN w.edge_id IN (TABLE looped) THEN (
                    SELECT greatest(least(since + 0.618034 * extent, 0.7 * w.total), 0.3 * w.total)
                    FROM unnest(w.s, w.length) u(since, extent)
                    ORDER BY extent DESC, since LIMIT 1) END AS middle
            FROM whole w LEFT JOIN met f ON f.edge_id = w.edge_id AND NOT f.at_end
                LEFT JOIN met t ON t.edge_id = w.edge_id AND t.at_end) w, generate_series(0, last) nth),
    drawn AS MATERIALIZED (
        SELECT p.road_id, p.nth, p.ends AS own_ends, w.*
        FROM whole w JOIN piece p USING (edge_id, run) WHERE p.since = 0 AND p.until = w.total
        UNION ALL
        SELECT p.road_id, p.nth, p.ends, w.edge_id, w.run, w.before, w.lefts, w.lanes, w.types, w.positions, w.halves,
            v.share_from, v.share_to, d.*, p.until - p.since
        FROM whole w JOIN piece p USING (edge_id, run),
            -- A mean weighed so is never beyond both ends, however it is rounded.
            LATERAL (SELECT w.share_from * (1 - p.since / w.total) + w.share_to * (p.since / w.total) AS share_from,
                w.share_from * (1 - p.until / w.total) + w.share_to * (p.until / w.total) AS share_to) v,
            streetgen._road_part(w.s, w.x, w.y, w.heading, w.length,
            w.curvature, w.curvature_end, w.station, w.border, p.since, p.until) d
        WHERE p.since > 0 OR p.until < w.total),
    placed AS MATERIALIZED (
        SELECT lane_id, road_id, edge_id, i::integer AS i, v.at_end,
            CASE WHEN i <= lefts THEN lefts - i + 1 ELSE lefts - i END AS number,
            halves[i] AS half, types[i] AS type, places[4 * i - 3] AS x, places[4 * i - 2] AS y,
            places[4 * i - 1] - CASE WHEN abs(lean) < 0.002 THEN 0 ELSE lean END AS heading,
            CASE WHEN abs(lean) < 0.002 THEN 0 ELSE tan(lean) END AS lean, places[4 * i] AS width
        FROM drawn, streetgen._few(lanes) WITH ORDINALITY u(lane_id, i),
            LATERAL (SELECT cardinality(heading) AS n) c,
            LATERAL (VALUES (false, own_ends[1], starts, heading[1]), (true, own_ends[2], ends,
                heading[n] + length[n] * (curvature[n] + curvature_end[n]) / 2)) v(at_end, own, places, across),
            -- A lane of a taper leads aside of its road, across which it ends.
            LATERAL (SELECT asin(sin(places[4 * i - 1] - across)) AS lean) w
        WHERE own),
    -- The lanes of a road at one end, and those of the road to which it is joined there.
    joined AS MATERIALIZED (
        SELECT a.road_id, a.at_end, min(b.road_id) AS other, bool_or(b.at_end) AS other_end,
            array_agg(a.i) AS lanes, array_agg(b.number::integer) AS numbers
        FROM (SELECT edge_in, i_in, in_end, edge_out, i_out, out_end FROM way_end WHERE place_id IN (TABLE joint)
            UNION SELECT edge_out, i_out, out_end, edge_in, i_in, in_end FROM way_end
            WHERE place_id IN (TABLE joint)) w
            JOIN placed a ON (a.edge_id, a.i, a.at_end) = (edge_in, i_in, in_end)
            JOIN placed b ON (b.edge_id, b.i, b.at_end) = (edge_out, i_out, out_end)
        GROUP BY a.road_id, a.at_end
        UNION ALL
        SELECT d.road_id, NOT d.own_ends[2], o.road_id, d.own_ends[2], array_agg(i),
            array_agg(CASE WHEN i <= d.lefts THEN d.lefts - i + 1 ELSE d.lefts - i END)
        FROM drawn d JOIN drawn o ON (o.edge_id, o.run, o.nth) = (d.edge_id, d.run, 1 - d.nth),
            LATERAL generate_series(1, cardinality(d.lanes)) i
        WHERE NOT (d.own_ends[1] AND d.own_ends[2]) GROUP BY d.road_id, d.own_ends, o.road_id),
    way_road AS MATERIALIZED (
        SELECT k.file_id AS road_id, array_to_string(interconnections, ' ') AS ways, a.road_id AS road_in,
            b.road_id AS road_out, a.number AS number_in, b.number AS number_out,
            a.at_end AS in_end, b.at_end AS out_end, a.width AS width_in, b.width AS width_out, a.lean AS lean_in,
            b.lean AS lean_out,
            CASE WHEN k.along_in THEN e.to_node ELSE e.from_node END AS node_id, k.lane_in, e.speed,
            coalesce(streetgen._opendrive_lane_type(split_part(k.traffic, '|', 1), false), a.type) AS type,
            (CASE WHEN short THEN ST_MakeLine(ST_MakePoint(a.x, a.y), ST_MakePoint(b.x, b.y)) ELSE k.geom END)::bytea
                AS path,
            ARRAY[a.x, a.y, a.heading + CASE WHEN a.at_end THEN 0 ELSE pi() END] AS path_from,
            ARRAY[b.x, b.y, b.heading + CASE WHEN b.at_end THEN pi() ELSE 0 END] AS path_to,
            CASE WHEN short THEN 1 ELSE o.tolerance END AS path_tolerance
        FROM origin o, way k JOIN placed a ON (a.lane_id, a.at_end) = (k.lane_in, k.along_in)
                AND coalesce(a.half = k.along_in, true)
            JOIN placed b ON (b.lane_id, b.at_end) = (k.lane_out, NOT k.along_out)
                AND coalesce(b.half = k.along_out, true)
            JOIN written_edge e ON e.edge_id = a.edge_id,
            LATERAL (SELECT ST_Length(k.geom) < 2 AS short) w
        WHERE k.file_id NOT IN (SELECT file_id FROM way_end WHERE place_id IN (TABLE joint)))
    SELECT d.road_id, false, s, x, y, heading, length, curvature, curvature_end, total, edge_id, before::integer,
        lefts, d.lanes, types, positions, halves, share_from, share_to, station, border, NULL, NULL::bigint,
        NULL::bigint, NULL::bigint, NULL::bigint, NULL::boolean, NULL::boolean, NULL::float8, NULL::float8,
        NULL::bigint, NULL, NULL::bigint, NULL::float8, NULL::float8, NULL::float8, own_ends, ARRAY[f.other, t.other],
        ARRAY[f.other_end, t.other_end], ARRAY(SELECT CASE WHEN at_end THEN t.numbers[array_position(t.lanes, i)]
            ELSE f.numbers[array_position(f.lanes, i)] END
            FROM (VALUES (false), (true)) v(at_end), generate_series(1, cardinality(d.lanes)) i ORDER BY at_end, i)
    FROM drawn d LEFT JOIN joined f ON f.road_id = d.road_id AND NOT f.at_end
        LEFT JOIN joined t ON t.road_id = d.road_id AND t.at_end
    UNION ALL
    SELECT w.road_id, true, d.*, d.s[cardinality(d.s)] + d.length[cardinality(d.s)], NULL, NULL, NULL, NULL, NULL, NULL,
        NULL, NULL, NULL, NULL, NULL, ways, road_in, road_out, number_in, number_out, in_end, out_end, width_in,
        width_out, node_id, type, lane_in, speed, lean_in, lean_out, NULL, NULL, NULL, NULL
    FROM way_road w, streetgen._path_view(path, path_from, path_to, path_tolerance, greatest(width_in, width_out))
        d;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_roads(name, jsonb, boolean) IS
    'The roads of a file of OpenDRIVE, each with its chain (s to curvature_end) and its length (total). A road of an '
    'edge has its lanes from the left, lefts of them left of the centre lane, before others of the edge, and what '
    'streetgen._road_lanes gives; halves: of half a lane whether it is driven along the axis. A connecting one is of '
    'a way from lane to lane: the roads that it joins, the numbers and widths of their lanes and at which of their '
    'ends, node and speed. It begins and ends across these roads; a lane that leads aside there does so by as many '
    'metres a metre, to the left of the way (lean_in, lean_out). joining: whether two roads that meet '
    'lane to lane are joined, and one that begins and ends at one junction is two. own_ends: whether a road begins and '
    'ends where its edge does; joined_road, joined_end, joined_numbers: at its start and its end the road to which it '
    'is joined, at which of its ends, and the numbers of the lanes there.';

CREATE OR REPLACE FUNCTION streetgen._lines_between(model name)
    RETURNS TABLE(edge_id bigint, lane_position integer, leftwards boolean, rightwards boolean, paint text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT s.edge_id, s.lane_position, s.leftwards, s.rightwards,
        CASE WHEN a.lane_markings = 'no' THEN NULL WHEN NOT s.dashed THEN 'solid'
            WHEN s.leftwards = s.rightwards THEN 'dashed' ELSE 'mixed' END
        FROM lane_separator s JOIN edge e USING (edge_id) JOIN axis a USING (axis_id);
END $$;
COMMENT ON FUNCTION streetgen._lines_between(name) IS
    'The lines between lanes, and who may cross them, seen along the axis: solid, dashed or mixed; NULL on streets '
    'without lane markings.';
