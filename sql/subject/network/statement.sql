-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{written
computed_edge AS MATERIALIZED (SELECT * FROM streetgen._computed_edge((SELECT streets FROM computed))),
-- The axes whose rows come out, and those that are gone, or whose edges are. An axis that is gone and was not requested
-- is for the run that requests it.
written_axis AS MATERIALIZED (
    SELECT axis_id FROM computed_edge
        WHERE (affected OR lanes_affected OR kerbs_affected) AND axis_id IN (SELECT unnest($1))
        UNION SELECT unnest($3)
    UNION (SELECT axis_id FROM former_edge JOIN used USING (axis_id) EXCEPT SELECT axis_id FROM computed_edge)),
written_edge AS MATERIALIZED (
    SELECT * FROM computed_edge WHERE {whole} OR axis_id IN (SELECT axis_id FROM written_axis)),
written_node AS MATERIALIZED (
    SELECT * FROM streetgen._computed_node((SELECT streets FROM computed))
    WHERE number IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge)),
-- Edges of the written axes, and of those that meet what is written: they know its nodes.
old_edge AS MATERIALIZED (
    SELECT edge_id, axis_id, from_node, to_node, start_abscissa, end_abscissa, {whole} OR axis_id IN (SELECT axis_id
        FROM written_axis) AS written
    FROM {model}.edge WHERE NOT {empty} AND ({whole} OR axis_id = ANY (ARRAY(SELECT axis_id FROM written_axis
        UNION SELECT unnest(anchor_axis) FROM written_node))))

--{node_rows
SELECT coalesce(node_id, {next_id}) AS node_id, number, affected, kerbs_affected, {geom_with_height} AS geom
FROM (SELECT n.number, n.affected, n.kerbs_affected, n.geom, anchor_axis[1] AS axis_id, k.node_id
      FROM written_node n LEFT JOIN (
          -- Identity of nodes: an axis end is known by its side, a shared vertex by its abscissa, in
          -- centimetres.
          SELECT number, min(node_id) AS node_id FROM (
              SELECT DISTINCT ON (o.node_id) o.node_id, n.number
              FROM (SELECT axis_id, unnest(ARRAY[CASE WHEN start_abscissa = first THEN -1
                  ELSE round(start_abscissa * 100) END,
                                                 CASE WHEN end_abscissa = last THEN -2
                                                     ELSE round(end_abscissa * 100) END]) AS place,
                                                     unnest(ARRAY[from_node, to_node]) AS node_id
                    FROM (SELECT *, min(start_abscissa) OVER (PARTITION BY axis_id) AS first, max(end_abscissa)
                        OVER (PARTITION BY axis_id) AS last FROM old_edge) e) o
              JOIN (SELECT number, axis_id, CASE WHEN abscissa = first THEN -1 WHEN abscissa = last THEN -2
                  ELSE round(abscissa * 100) END AS place
                    FROM (SELECT number, unnest(anchor_axis) AS axis_id, unnest(anchor_abscissa) AS abscissa
                        FROM written_node WHERE NOT {empty}) a
                    LEFT JOIN (SELECT axis_id, min(start_abscissa) AS first, max(end_abscissa) AS last
                        FROM computed_edge GROUP BY axis_id) s USING (axis_id) OFFSET 0) n
                        USING (axis_id, place)
              ORDER BY o.node_id, axis_id, n.number) heir GROUP BY number) k USING (number)
                  ORDER BY n.number OFFSET 0) c

--{edge_rows
SELECT coalesce(edge_id, {next_id}) AS edge_id, number, lanes_affected AS affected, kerbs_affected, axis_id,
       (SELECT ids FROM node_ids)[from_node] AS from_node, (SELECT ids FROM node_ids)[to_node] AS to_node,
       level, start_abscissa, end_abscissa, {geom_with_height} AS geom, curve,
       width, width_end, roadway_offset, lane_count, lanes_forward, lanes_backward, lanes_both,
       -- No sidewalk is estimated on medians, splitters and islands, nor where one is mapped. A line that is mapped
       -- says more than an axis that has none.
       coalesce(sidewalk_left_by_hand, CASE WHEN 'sidewalk_left' <> ALL (estimated)
               AND NOT (sidewalk_left = 0 AND coalesce(mapped_left, 0) > 0) THEN sidewalk_left
           ELSE coalesce(mapped_left, CASE WHEN beside_left = 'outer' OR cardinality(median_left) > 0
               THEN sidewalk_left ELSE 0 END) END) AS sidewalk_left,
       coalesce(sidewalk_right_by_hand, CASE WHEN 'sidewalk_right' <> ALL (estimated)
               AND NOT (sidewalk_right = 0 AND coalesce(mapped_right, 0) > 0) THEN sidewalk_right
           ELSE coalesce(mapped_right, CASE WHEN beside_right = 'outer' OR cardinality(median_right) > 0
               THEN sidewalk_right ELSE 0 END) END) AS sidewalk_right, beside_left, beside_right,
       median_left, median_right, speed, importance,
       array_remove(array_remove(estimated,
           CASE WHEN num_nonnulls(sidewalk_left_by_hand, mapped_left) > 0 THEN 'sidewalk_left' END),
           CASE WHEN num_nonnulls(sidewalk_right_by_hand, mapped_right) > 0 THEN 'sidewalk_right' END) AS estimated,
       input_hash, setting_hash
FROM (SELECT e.*, k.edge_id, u.width, u.width_end, u.roadway_offset, u.lane_count, {lanes_of_edge},
    {usual_left} AS sidewalk_left, {usual_right} AS sidewalk_right, h.sidewalk_left_by_hand, h.sidewalk_right_by_hand,
             {mapped_left} AS mapped_left, {mapped_right} AS mapped_right, u.speed, u.importance,
             u.estimated, CASE WHEN e.spreads_to THEN 0 ELSE u.input_hash END AS input_hash, u.setting_hash
      FROM written_edge e JOIN used u USING (axis_id) {sidewalks_by_hand} {sidewalks_mapped} {edge_circulation}
      LEFT JOIN (
          -- Identity of edges: by their ends along the axis, then by the node they begin at and their turn
          -- there.
          SELECT number, edge_id FROM same_edge
          UNION ALL SELECT n.number, o.edge_id
          FROM (SELECT number, axis_id, (SELECT ids FROM node_ids)[from_node] AS from_node, row_number()
              OVER (PARTITION BY axis_id, from_node ORDER BY start_abscissa) AS turn
                FROM written_edge WHERE number NOT IN (SELECT number FROM same_edge)) n
          JOIN (SELECT edge_id, axis_id, from_node, row_number() OVER (PARTITION BY axis_id, from_node
              ORDER BY start_abscissa) AS turn
                FROM old_edge WHERE edge_id NOT IN (SELECT edge_id FROM same_edge)) o
                    USING (axis_id, from_node, turn)) k USING (number) ORDER BY e.number OFFSET 0) c

--{left_node
left_node AS MATERIALIZED (
    SELECT node_id FROM (
        SELECT from_node AS node_id FROM old_edge WHERE written UNION SELECT to_node FROM old_edge WHERE written
        UNION SELECT node_id FROM {model}.node WHERE {whole} AND NOT {empty}
        EXCEPT SELECT node_id FROM new_node) o
    WHERE {whole}
        OR (SELECT true FROM {model}.edge WHERE from_node = o.node_id AND axis_id NOT IN (SELECT axis_id
            FROM written_axis) LIMIT 1) IS NULL
            AND (SELECT true FROM {model}.edge WHERE to_node = o.node_id AND axis_id NOT IN (SELECT axis_id
                FROM written_axis) LIMIT 1) IS NULL)

--{axis_to_mend
CREATE OR REPLACE VIEW axis_to_mend WITH (security_invoker = true) AS
WITH lying AS (
    SELECT axis_a, array_agg(axis_b ORDER BY measure DESC, axis_b) AS others, sum(measure) AS measure,
        array_agg(geom) AS places
    FROM report WHERE issue = 'axis lies on another' GROUP BY axis_a),
lying_piece AS (
    SELECT l.*, a.geom, streetgen._off_twins(a.geom, e.starts, e.ends, l.places) AS pieces, e.starts IS NULL AS whole
    FROM lying l JOIN axis a ON a.axis_id = l.axis_a, LATERAL (
        SELECT array_agg(start_abscissa) AS starts, array_agg(end_abscissa) AS ends FROM edge
        WHERE axis_id = l.axis_a) e
    WHERE NOT EXISTS (SELECT FROM unnest(places) p WHERE NOT ST_DWithin(p, a.geom, 0.5))),
missed AS (
    SELECT r.axis_a, r.axis_b, r.measure, r.geom AS place, b.geom AS other, e.half_width, e.nodes,
        row_number() OVER (PARTITION BY axis_a ORDER BY r.measure DESC, r.axis_b) AS nth
    FROM report r JOIN axis b ON b.axis_id = r.axis_b, LATERAL (
        SELECT max(greatest(width, width_end)) / 2 + max(abs(roadway_offset)) AS half_width,
            ST_Collect(n.geom) AS nodes
        FROM edge JOIN node n ON n.node_id IN (from_node, to_node) WHERE axis_id = r.axis_b) e
    WHERE r.issue = 'end of an axis in the roadway of another, without a node'
        -- One of two ends that miss each other's axes is led on, which mends both.
        AND NOT EXISTS (SELECT FROM report o WHERE o.issue = r.issue AND (o.axis_a, o.axis_b) = (r.axis_b, r.axis_a)
            AND ST_DWithin(o.geom, r.geom, r.measure + o.measure)
            AND (o.measure, o.axis_a) < (r.measure, r.axis_a))
        -- Edges lie where their nodes are, and those within the tolerance of the axes.
        AND ST_DWithin(b.geom, r.geom, r.measure
            + (SELECT 2 * value::float8 FROM setting WHERE name = 'tolerance'))),
joined AS (
    SELECT a.axis_id, array_remove(ARRAY[m.axis_b, n.axis_b], NULL) AS others, m.measure,
        streetgen._joined(streetgen._joined(a.geom, m.place, m.other, m.nodes, m.half_width), n.place, n.other,
            n.nodes, n.half_width) AS geom
    FROM missed m JOIN axis a ON a.axis_id = m.axis_a
        LEFT JOIN missed n ON n.axis_a = m.axis_a AND n.nth = 2
    WHERE m.nth = 1 AND ST_DWithin(ST_Boundary(a.geom), m.place, 0.5)),
proposal AS (
    SELECT 'axis lies on another' AS rule, axis_a || others AS axes, CASE WHEN whole THEN 'delete' ELSE 'split' END
        AS proposal, l.measure, CASE WHEN whole THEN (SELECT b.geom FROM axis b WHERE b.axis_id = others[1])
        ELSE pieces END AS geom
    FROM lying_piece l WHERE whole OR pieces IS NOT NULL
    UNION ALL SELECT 'end of an axis in the roadway of another, without a node', axis_id || others, 'join', measure,
        geom FROM joined WHERE geom IS NOT NULL)
SELECT hash_record_extended(ROW (rule, axes, geom::bytea), 0) & 9223372036854775807 AS id, rule, axes, proposal,
    measure, ST_Multi(geom)::geometry(MultiLineString{z}, {srid}) AS geom
FROM proposal
