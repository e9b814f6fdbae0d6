-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{mapped_sidewalk
footway_rule AS MATERIALIZED (
    SELECT max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_distance') AS distance,
        max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_minimal') AS minimal,
        max(value::float8) FILTER (WHERE name = 'mapped_sidewalk_maximal') AS maximal
    FROM {model}.setting WHERE name LIKE 'mapped\_sidewalk\_%'),
-- The borders of the roadway beside each edge, where it begins and ends, as the width runs along the axis.
beside_footway AS MATERIALIZED (
    SELECT number, geom, level, beside_left, beside_right, row_number() OVER (ORDER BY number)::integer AS place,
        roadway_offset, (width + (width_end - width) * start_abscissa / length) / 2 AS half_at_start,
        (width + (width_end - width) * end_abscissa / length) / 2 AS half_at_end,
        greatest(width, width_end) / 2 + abs(roadway_offset) AS half
    FROM (SELECT e.number, e.geom, e.level, e.beside_left, e.beside_right, e.start_abscissa, e.end_abscissa, u.width,
            u.width_end, u.roadway_offset, ST_Length2D(u.geom) AS length
        FROM written_edge e JOIN used u USING (axis_id)) e),
near_footway AS MATERIALIZED (
    SELECT f.*, row_number() OVER (ORDER BY footway_id)::integer AS place FROM ({footways}) f
    WHERE role = 'sidewalk'),
found_source AS MATERIALIZED (
    SELECT e.number, CASE WHEN s."left" THEN 'left' ELSE 'right' END AS side, f.footway_id, m.start_abscissa,
        m.end_abscissa, m.distance, least(50, coalesce(f.width,
            greatest(r.minimal, least(r.maximal, 2 * m.distance), m.distance + r.minimal / 2))) AS width
    FROM footway_rule r,
        (SELECT array_agg(ST_Force2D(geom)::bytea ORDER BY place) AS lines, array_agg(level ORDER BY place) AS levels
            FROM beside_footway) g,
        (SELECT array_agg(ST_Force2D(geom)::bytea ORDER BY place) AS lines, array_agg(level ORDER BY place) AS levels
            FROM near_footway) w,
        -- On medians, splitters and islands nobody walks along the street.
        (SELECT array_agg(place ORDER BY place, "left") AS edges, array_agg("left" ORDER BY place, "left") AS lefts,
            array_agg(at_start ORDER BY place, "left") AS at_start, array_agg(at_end ORDER BY place, "left") AS at_end
            FROM (SELECT place, true AS "left", half_at_start + roadway_offset AS at_start,
                    half_at_end + roadway_offset AS at_end FROM beside_footway WHERE beside_left = 'outer'
                UNION ALL SELECT place, false, half_at_start - roadway_offset, half_at_end - roadway_offset
                FROM beside_footway WHERE beside_right = 'outer') s) t,
        LATERAL streetgen._sidewalk_sources(g.lines, g.levels, w.lines, w.levels, t.edges, t.lefts, t.at_start,
            t.at_end, r.distance) m,
        LATERAL (SELECT t.edges[m.side] AS place, t.lefts[m.side] AS "left") s, beside_footway e, near_footway f
    WHERE e.place = s.place AND f.place = m.footway),
-- A side of which a footway runs along a part is as wide as its footways are on the whole.
mapped_sidewalk AS MATERIALIZED (
    SELECT number AS mapped_number, max(width) FILTER (WHERE side = 'left') AS mapped_left,
        max(width) FILTER (WHERE side = 'right') AS mapped_right
    FROM (SELECT s.number, s.side, sum(s.width * (s.end_abscissa - s.start_abscissa))
                / sum(s.end_abscissa - s.start_abscissa) AS width,
            sum(s.end_abscissa - s.start_abscissa) >= least(20, 0.3 * ST_Length2D(min(e.geom))) AS enough
        FROM found_source s JOIN beside_footway e USING (number) GROUP BY s.number, s.side) m
    WHERE enough GROUP BY number)

--{footways_near
SELECT DISTINCT ON (f.footway_id) f.* FROM footway_rule r, beside_footway e, LATERAL (
    SELECT footway_id, geom, role, level, width FROM {model}.footway f
    WHERE f.geom && ST_Expand(e.geom, e.half + r.distance) OFFSET 0) f

--{all_footways
SELECT footway_id, geom, role, level, width FROM {model}.footway

--{sidewalk_source_rows
SELECT row_number() OVER (ORDER BY s.number, s.side, s.start_abscissa, s.footway_id) AS number,
    (SELECT ids FROM edge_ids)[s.number] AS edge_id, s.side,
    row_number() OVER (PARTITION BY s.number, s.side ORDER BY s.start_abscissa, s.footway_id)::integer AS part,
    s.footway_id, s.start_abscissa, s.end_abscissa, s.distance, s.width
FROM found_source s
