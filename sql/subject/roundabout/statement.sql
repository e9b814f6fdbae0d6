-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{ring_score
ring_found AS MATERIALIZED (
    SELECT r.number, r.level, r.geom::geometry AS geom, r.centre::geometry AS centre, r.radius,
        streetgen.roundabout_shape(on_circle, compactness) AS term_shape,
        streetgen.roundabout_network(one_way, against, arm_nodes, single_arm, inside) AS term_network,
        edge_axes, edge_starts, edge_ends, edge_along, edge_faces, faces, waist, arm_axes, arm_starts, arm_ends,
        arm_along
    FROM (SELECT array_agg(axis_id ORDER BY axis_id) AS axis_ids, array_agg(ST_Force2D(geom)::bytea ORDER BY axis_id)
            AS lines, array_agg(level ORDER BY axis_id) AS levels,
            array_agg(CASE direction WHEN 'direct' THEN 1 WHEN 'reverse' THEN -1 ELSE 0 END ORDER BY axis_id)
                AS one_ways, array_agg(on_ring ORDER BY axis_id) AS tagged,
            array_agg(width ORDER BY axis_id) AS widths, array_agg(width_end ORDER BY axis_id) AS widths_end,
            array_agg(roadway_offset ORDER BY axis_id) AS offsets,
            array_agg(importance ORDER BY axis_id) AS importances,
            array_agg(lanes_forward + lanes_both ORDER BY axis_id) AS forward,
            array_agg(lanes_backward + lanes_both ORDER BY axis_id) AS backward FROM used) u, setting,
        -- Signals in mid-block cut edges of rings and of arms as they do those of the model.
        (SELECT ARRAY(SELECT ROW (axis_id, abscissa, kind, direction)::streetgen.street_control
            FROM {model}.control_point WHERE {whole} AND axis_id IS NOT NULL OR axis_id = ANY ($2)
            ORDER BY control_point_id) AS controls) c,
        streetgen._network_rings(axis_ids, lines, levels, one_ways, tagged, widths, widths_end, offsets, importances,
            forward, backward, (v ->> 'tolerance')::float8,
            (v ->> 'roundabout_radius_least')::float8, (v ->> 'roundabout_radius_greatest')::float8,
            (v ->> 'roundabout_shape_least')::float8, v ->> 'crossing' = 'split', v ->> 'driving_side' <> 'left',
            controls, (v ->> 'control_distance')::float8, (v ->> 'queue_length')::float8) r),
ring_pattern AS MATERIALIZED (SELECT coalesce(array_agg(pattern ORDER BY pattern), ARRAY[]::text[])
    AS patterns
    FROM {model}.roundabout_pattern),
ring_named AS MATERIALIZED (
    SELECT r.*, a.tagged,
        streetgen.roundabout_name(a.names, patterns, v ->> 'roundabout_names') AS term_name,
        (SELECT o.confirmed FROM {model}.roundabout_override o
            WHERE o.geom && r.geom AND ST_Covers(ST_ConvexHull(r.geom), o.geom)
            ORDER BY o.roundabout_override_id DESC LIMIT 1) AS confirmed
    FROM ring_found r, ring_pattern, setting, LATERAL (
        -- A piece of which the source says nothing may be part of a tagged ring, and is not made one-way by that.
        SELECT array_agg(a.name ORDER BY n) AS names, sum(CASE WHEN u.on_ring THEN e - s ELSE 0 END)
            > 0.5 * sum(e - s) AND bool_and(u.on_ring OR u.direction <> 'both') AS tagged
        FROM unnest(r.edge_axes, r.edge_starts, r.edge_ends) WITH ORDINALITY x(axis_id, s, e, n)
            JOIN {model}.axis a USING (axis_id) JOIN used u USING (axis_id)) a),
ring AS MATERIALIZED (
    SELECT *, coalesce(confirmed, tagged OR score >= (v ->> 'roundabout_accept')::float8
            AND NOT (v ->> 'roundabout_tags' = 'true' AND v ->> 'roundabout_untagged' = 'offered')) AS accepted,
        CASE WHEN confirmed IS NOT NULL THEN 'by_hand' ELSE 'hypothesis' END AS method
    FROM (SELECT r.*, v, CASE WHEN tagged THEN 1 ELSE streetgen._roundabout_score('{model_name}',
            v ->> 'roundabout_score', term_shape, term_name, term_network, ARRAY[v ->> 'roundabout_weight_shape',
                v ->> 'roundabout_weight_name', v ->> 'roundabout_weight_network']::float8[],
            centre) END AS score FROM ring_named r, setting) s)

--{ring
-- An edit moves the rings that an axis touches or lies within, as it is or was, and their neighbours: these may be
-- double roundabouts, half as wide as a ring may be. A cluster of a first run changes no neighbour.
ring_line AS MATERIALIZED (
    SELECT geom, {beside_rings} + 5 AS reach FROM (
        SELECT geom FROM used WHERE NOT {whole} AND axis_id IN (SELECT unnest($3))
        UNION ALL SELECT geom FROM {model}.edge WHERE NOT {whole} AND axis_id = ANY ($3)) l, setting),
-- A ring gets another edge of an arm that is cut anew, however far away.
ring_axis AS MATERIALIZED (
    SELECT array_agg(axis_id) AS ids FROM used u, setting WHERE EXISTS (SELECT FROM ring_line l
        WHERE ST_DWithin(u.geom, l.geom, 3 * (v ->> 'tolerance')::float8))),
old_ring AS MATERIALIZED (
    SELECT roundabout_id, accepted FROM {model}.roundabout r WHERE NOT {empty} AND ({whole} OR EXISTS (
        SELECT FROM ring_line l WHERE ST_DWithin(ST_ConvexHull(r.geom), l.geom, reach)
            AND r.geom && ST_Expand(l.geom, reach))
        OR roundabout_id IN (SELECT a.roundabout_id FROM {model}.edge e JOIN {model}.roundabout_arm a USING (edge_id)
            WHERE e.axis_id = ANY ((SELECT ids FROM ring_axis)::bigint[])))),
new_ring AS MATERIALIZED (
    SELECT r.*, row_number() OVER (ORDER BY number)::integer AS ring FROM ring r
    WHERE {whole} OR arm_axes && (SELECT ids FROM ring_axis) OR EXISTS (SELECT FROM ring_line l
        WHERE ST_DWithin(ST_ConvexHull(r.geom), l.geom, reach))),
new_ring_edge AS MATERIALIZED (
    SELECT ring, accepted, n::integer AS ordinality, face, axis_id, start_abscissa, end_abscissa, along_axis
    FROM new_ring, unnest(edge_axes, edge_starts, edge_ends, edge_along, edge_faces) WITH ORDINALITY
        e(axis_id, start_abscissa, end_abscissa, along_axis, face, n)),
new_ring_arm AS MATERIALIZED (
    SELECT DISTINCT ON (ring, axis_id, start_abscissa, along_axis) ring, accepted, axis_id, start_abscissa,
        end_abscissa, along_axis
    FROM new_ring, unnest(arm_axes, arm_starts, arm_ends, arm_along) WITH ORDINALITY
        e(axis_id, start_abscissa, end_abscissa, along_axis, n)),
-- Accepted rings beside the edit stay as they are.
circulated AS MATERIALIZED (
    SELECT axis_id, start_abscissa, end_abscissa, bool_and(along_axis) AS along_axis FROM (
    SELECT axis_id, start_abscissa, end_abscissa, along_axis FROM new_ring_edge WHERE accepted
    UNION ALL SELECT axis_id, start_abscissa, end_abscissa, r.along_axis
    FROM {model}.edge e JOIN {model}.roundabout_edge r USING (edge_id) JOIN {model}.roundabout USING (roundabout_id)
    WHERE NOT {whole} AND e.axis_id = ANY ($2) AND accepted AND roundabout_id NOT IN (SELECT roundabout_id
        FROM old_ring)) c
    -- Between the faces of a double roundabout traffic goes as the axis says.
    GROUP BY 1, 2, 3 HAVING bool_and(along_axis) = bool_or(along_axis)),
yielding AS MATERIALIZED (
    SELECT axis_id, start_abscissa, end_abscissa, along_axis FROM new_ring_arm WHERE accepted
    UNION ALL SELECT axis_id, start_abscissa, end_abscissa, r.along_axis
    FROM {model}.edge e JOIN {model}.roundabout_arm r USING (edge_id) JOIN {model}.roundabout USING (roundabout_id)
    WHERE NOT {whole} AND e.axis_id = ANY ($2) AND accepted AND roundabout_id NOT IN (SELECT roundabout_id
        FROM old_ring)),
-- The axes on which traffic turns with the rings.
ring_turned AS MATERIALIZED (
    SELECT axis_id FROM (
        (TABLE former_circulated EXCEPT TABLE now_circulated)
        UNION (TABLE now_circulated EXCEPT TABLE former_circulated)) t),
former_circulated AS MATERIALIZED (
    SELECT e.axis_id, e.start_abscissa, e.end_abscissa, r.along_axis
    FROM old_ring o JOIN {model}.roundabout_edge r USING (roundabout_id) JOIN {model}.edge e USING (edge_id)
    WHERE NOT {whole} AND accepted),
now_circulated AS MATERIALIZED (
    SELECT axis_id, start_abscissa, end_abscissa, along_axis FROM new_ring_edge WHERE NOT {whole} AND accepted)

--{roundabout
-- An edge of an axis that is not written is as it is there.
ring_edge_id AS MATERIALIZED (
    SELECT axis_id, start_abscissa, end_abscissa, edge_id, width, from_node, to_node FROM new_edge
    UNION ALL SELECT e.axis_id, e.start_abscissa, e.end_abscissa, e.edge_id, e.width, e.from_node, e.to_node
    FROM (SELECT axis_id FROM new_ring_edge UNION SELECT axis_id FROM new_ring_arm) r
        JOIN {model}.edge e USING (axis_id)
    WHERE NOT {whole} AND axis_id NOT IN (SELECT axis_id FROM written_edge)),
named_ring_edge AS MATERIALIZED (SELECT r.*, i.edge_id, i.width FROM new_ring_edge r
    JOIN ring_edge_id i USING (axis_id, start_abscissa, end_abscissa)),
-- Each face has an island of its own: the ground between two of them is roadway.
ring_island AS MATERIALIZED (
    SELECT ring, coalesce(ST_Multi(ST_CollectionExtract(ST_Union(ST_Buffer(
            ST_MakeValid(ST_MakePolygon(f.line::geometry)), -(SELECT max(width) / 2 FROM named_ring_edge e
                WHERE (e.ring, e.face) = (n.ring, f.face))) ORDER BY f.face), 3)),
        ST_SetSRID('MULTIPOLYGON EMPTY'::geometry, {srid})) AS island
    FROM new_ring n, unnest(n.faces) WITH ORDINALITY f(line, face) GROUP BY ring)

--{roundabout_rows
SELECT ring AS number, e.edge_id, e.along_axis, level, CASE WHEN cardinality(faces) > 1 THEN 'double'
    WHEN ST_IsEmpty(island) THEN 'mini'
    WHEN waist THEN 'peanut'
    ELSE 'ring' END AS kind, centre, radius, geom, island, score, term_shape, term_name, term_network,
    n.accepted, confirmed, method
FROM new_ring n JOIN ring_island USING (ring) JOIN named_ring_edge e USING (ring) WHERE ordinality = 1

--{roundabout_arm_rows
SELECT row_number() OVER (ORDER BY ring, edge_id, along_axis)::integer AS number,
    (SELECT ids FROM roundabout_ids)[ring] AS roundabout_id, edge_id, along_axis,
    CASE WHEN along_axis THEN to_node ELSE from_node END AS node_id
FROM new_ring_arm JOIN ring_edge_id USING (axis_id, start_abscissa, end_abscissa)
WHERE ring IN (SELECT ring FROM named_ring_edge WHERE ordinality = 1)

--{lanes_of_edge
CASE WHEN turned_along THEN u.lane_count WHEN NOT turned_along THEN 0 ELSE u.lanes_forward END
    AS lanes_forward,
CASE WHEN turned_along THEN 0 WHEN NOT turned_along THEN u.lane_count ELSE u.lanes_backward END
    AS lanes_backward,
CASE WHEN turned_along IS NULL THEN u.lanes_both ELSE 0 END AS lanes_both
