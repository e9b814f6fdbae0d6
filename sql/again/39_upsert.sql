-- The one statement: streets computed, matched to the rows that are there, and upserted.

-- Height for a line or point computed in the plane: that of the nearest place of its axis.
CREATE OR REPLACE FUNCTION streetgen._with_height(place bytea, axis geometry) RETURNS bytea
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN count(*) = 1 THEN (array_agg(point))[1] ELSE ST_MakeLine(point ORDER BY path) END::bytea
    FROM (SELECT d.path, ST_SetSRID(ST_MakePoint(ST_X(d.geom), ST_Y(d.geom),
                   ST_Z(ST_LineInterpolatePoint(axis, ST_LineLocatePoint(ST_Force2D(axis), d.geom)))), ST_SRID(axis)) AS point
          FROM ST_DumpPoints(place::geometry) d) p
    $$;
COMMENT ON FUNCTION streetgen._with_height(bytea, geometry) IS 'A point or line of the plane (EWKB) with the heights of the nearest places of an axis.';

CREATE OR REPLACE FUNCTION streetgen._upsert_statement(model name, many boolean) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- A subquery by key and no join, which would spoil the estimates of all that follows.
    place constant text := CASE (SELECT m.dimension FROM streetgen.model m WHERE m.name = model)
        WHEN 3 THEN format('(SELECT streetgen._with_height(geom_1, a.geom) FROM %I.axis a WHERE a.axis_id = ?)', model) ELSE 'geom_1' END;
BEGIN
    RETURN format($sql$
WITH setting AS MATERIALIZED (SELECT jsonb_object_agg(name, value) AS v FROM %1$I.setting),
used AS MATERIALIZED (SELECT * FROM %1$I.axis_used WHERE axis_id = ANY ($2)),
-- What the changed axes met and what lay beside their ground before the change.
former_node AS MATERIALIZED (SELECT DISTINCT node_id FROM %1$I.edge e, LATERAL (VALUES (e.from_node), (e.to_node)) v(node_id) WHERE e.axis_id IN (SELECT unnest($3))),
followed AS MATERIALIZED (
    SELECT c.node_id FROM %1$I.edge e JOIN %1$I.corner c ON c.edge_a = e.edge_id WHERE e.axis_id IN (SELECT unnest($1)) AND c.method = 'followed'
    UNION SELECT c.node_id FROM %1$I.edge e JOIN %1$I.corner c ON c.edge_b = e.edge_id WHERE e.axis_id IN (SELECT unnest($1)) AND c.method = 'followed'),
-- An edge that they cut, or meet no longer, gives up ground at its far node too: to those that had lost some.
line AS MATERIALIZED (SELECT geom FROM used WHERE axis_id IN (SELECT unnest($3)) UNION ALL SELECT geom FROM %1$I.edge e WHERE e.axis_id IN (SELECT unnest($3))),
met_edge AS MATERIALIZED (SELECT DISTINCT e.edge_id, e.from_node, e.to_node FROM setting CROSS JOIN line l JOIN %1$I.edge e ON ST_DWithin(e.geom, l.geom, 3 * (v ->> 'tolerance')::float8)),
-- LIMIT: looked up by key, and not joined.
ground AS MATERIALIZED (
    SELECT surface, own FROM (SELECT edge_id, true AS own FROM %1$I.edge e WHERE e.axis_id IN (SELECT unnest($3)) UNION ALL SELECT edge_id, false FROM met_edge) e, LATERAL (SELECT surface FROM %1$I.section s WHERE s.edge_id = e.edge_id LIMIT 1) s
    UNION ALL SELECT surface, own FROM (
        SELECT node_id, bool_or(own) AS own FROM (SELECT node_id, true AS own FROM former_node UNION ALL SELECT from_node, false FROM met_edge UNION ALL SELECT to_node, false FROM met_edge UNION ALL SELECT node_id, false FROM followed) n
        GROUP BY node_id) n, LATERAL (SELECT surface FROM %1$I.intersection i WHERE i.node_id = n.node_id LIMIT 1) i),
beside AS MATERIALIZED (
    SELECT DISTINCT e.axis_id FROM (SELECT DISTINCT s.edge_id FROM ground g JOIN %1$I.section s ON ST_DWithin(s.surface, g.surface, 1) AND (g.own OR s.contested_area > 0)) s,
        LATERAL (SELECT e.axis_id FROM %1$I.edge e WHERE e.edge_id = s.edge_id LIMIT 1) e),
former_place AS (
    SELECT geom, bool_or(met) AS met FROM (
        SELECT node_id, true AS met FROM followed
        UNION ALL SELECT i.node_id, false FROM ground g JOIN %1$I.intersection i ON ST_DWithin(i.surface, g.surface, 1) AND (g.own OR i.contested_area > 0)) p,
        LATERAL (SELECT geom FROM %1$I.node n WHERE n.node_id = p.node_id LIMIT 1) n GROUP BY p.node_id, geom),
result AS MATERIALIZED (
    SELECT s.* FROM setting, (
        SELECT array_agg(axis_id ORDER BY axis_id) AS axis_id, array_agg(ST_Force2D(geom)::bytea ORDER BY axis_id) AS geom,
               array_agg(width ORDER BY axis_id) AS width, array_agg(width_end ORDER BY axis_id) AS width_end,
               array_agg(radius ORDER BY axis_id) AS radius, array_agg(importance ORDER BY axis_id) AS importance,
               array_agg(level ORDER BY axis_id) AS level, array_agg(speed ORDER BY axis_id) AS speed, array_agg(axis_id = ANY ($3) ORDER BY axis_id) AS changed, array_agg(NOT axis_id = ANY ($1) ORDER BY axis_id) AS outer_axis, array_agg(axis_id IN (SELECT b.axis_id FROM beside b) ORDER BY axis_id) AS beside,
               array_agg(lanes_forward ORDER BY axis_id) AS lanes_forward, array_agg(lanes_backward ORDER BY axis_id) AS lanes_backward,
               array_agg(coalesce(kind_forward, '') ORDER BY axis_id) AS kind_forward, array_agg(coalesce(kind_backward, '') ORDER BY axis_id) AS kind_backward,
               array_agg(coalesce(lane_width_forward, '') ORDER BY axis_id) AS lane_width_forward, array_agg(coalesce(lane_width_backward, '') ORDER BY axis_id) AS lane_width_backward,
               array_agg(coalesce(turn_forward, '') ORDER BY axis_id) AS turn_forward, array_agg(coalesce(turn_backward, '') ORDER BY axis_id) AS turn_backward FROM used) u, (
        SELECT coalesce(array_agg(axis_id), '{}') AS axis_id, coalesce(array_agg(which), '{}') AS which,
               coalesce(array_agg(coalesce(kind, v ->> 'transition_kind')), '{}') AS kind, coalesce(array_agg(coalesce(length, (v ->> 'transition_length')::float8)), '{}') AS length
        FROM (SELECT DISTINCT ON (axis_id, which) * FROM %1$I.transition_override WHERE axis_id = ANY ($2) ORDER BY axis_id, which, transition_override_id DESC) o, setting) t, (
        SELECT coalesce(array_agg(axis_id ORDER BY lane_override_id), '{}') AS axis_id, coalesce(array_agg(abscissa ORDER BY lane_override_id), '{}') AS abscissa, coalesce(array_agg(ordinality ORDER BY lane_override_id), '{}') AS ordinality,
               coalesce(array_agg(CASE along_axis WHEN true THEN 'along' WHEN false THEN 'against' ELSE 'as_is' END ORDER BY lane_override_id), '{}') AS direction, coalesce(array_agg(coalesce(width, 0) ORDER BY lane_override_id), '{}') AS width,
               coalesce(array_agg(coalesce(line::bytea, '') ORDER BY lane_override_id), '{}') AS line
        FROM %1$I.lane_override WHERE axis_id = ANY ($2)) o, (
        SELECT coalesce(array_agg(axis_id ORDER BY section_limit_override_id), '{}') AS axis_id, coalesce(array_agg(abscissa ORDER BY section_limit_override_id), '{}') AS abscissa, coalesce(array_agg(which ORDER BY section_limit_override_id), '{}') AS which
        FROM %1$I.section_limit_override WHERE axis_id = ANY ($2)) l, (
        SELECT coalesce(array_agg(axis_a ORDER BY corner_override_id), '{}') AS axis_a, coalesce(array_agg(axis_b ORDER BY corner_override_id), '{}') AS axis_b, coalesce(array_agg(radius ORDER BY corner_override_id), '{}') AS radius,
               coalesce(array_agg(ST_X(geom) ORDER BY corner_override_id), '{}') AS x, coalesce(array_agg(ST_Y(geom) ORDER BY corner_override_id), '{}') AS y
        FROM %1$I.corner_override WHERE axis_a = ANY ($2)) c, (
        SELECT coalesce(array_agg(from_axis ORDER BY turn_restriction_id), '{}') AS from_axis, coalesce(array_agg(to_axis ORDER BY turn_restriction_id), '{}') AS to_axis,
               coalesce(array_agg(ST_X(geom) ORDER BY turn_restriction_id), '{}') AS x, coalesce(array_agg(ST_Y(geom) ORDER BY turn_restriction_id), '{}') AS y,
               coalesce(array_agg(kind ORDER BY turn_restriction_id), '{}') AS kind, coalesce(array_agg(coalesce(turn, '') ORDER BY turn_restriction_id), '{}') AS turn
        FROM %1$I.turn_restriction WHERE from_axis = ANY ($2)) b, (
        SELECT coalesce(array_agg(ST_X(geom)), '{}') AS x, coalesce(array_agg(ST_Y(geom)), '{}') AS y, coalesce(array_agg(met), '{}') AS met FROM former_place) p, (
        SELECT coalesce(array_agg(e.axis_id), '{}') AS axis_id, coalesce(array_agg(ST_Force2D(e.geom)::bytea), '{}') AS geom, coalesce(array_agg(s.wanted_abscissa), '{}') AS wanted_start,
               coalesce(array_agg(s.abscissa), '{}') AS start, coalesce(array_agg(t.wanted_abscissa), '{}') AS wanted_end, coalesce(array_agg(t.abscissa), '{}') AS "end"
        FROM %1$I.edge e JOIN %1$I.section_limit s ON (s.edge_id, s.which) = (e.edge_id, 'start') JOIN %1$I.section_limit t ON (t.edge_id, t.which) = (e.edge_id, 'end')
        WHERE e.axis_id IN (SELECT unnest($1))) f,
    LATERAL streetgen._streets(u.axis_id, u.geom, u.width, u.width_end, u.radius, u.importance, u.level, %2$s,
        (v ->> 'tolerance')::float8, v ->> 'crossing', (v ->> 'max_arc_distance')::float8, (v ->> 'radius_minimal')::float8,
        (v ->> 'transition_length')::float8, v ->> 'transition_kind', v ->> 'radius_rule', v ->> 'dead_end' = 'round', (v ->> 'max_hole_area')::float8,
        (v ->> 'reach')::float8, v ->> 'short_axis', t.axis_id, t.which, t.kind, t.length,
        u.lanes_forward, u.lanes_backward, u.kind_forward, u.kind_backward, u.lane_width_forward, u.lane_width_backward, u.turn_forward, u.turn_backward,
        o.axis_id, o.abscissa, o.ordinality, o.direction, o.width,
        v ->> 'lane_order', v ->> 'driving_side', (v ->> 'lane_width_minimal')::float8, (v ->> 'cycle_lane_width')::float8, (v ->> 'parking_lane_width')::float8, v ->> 'edge_line' = 'solid',
        u.speed, b.from_axis, b.to_axis, b.x, b.y, b.kind, b.turn, (v ->> 'u_turn')::boolean, CASE v ->> 'trajectory' WHEN 'arcs' THEN 'arcs' ELSE 'bezier' END, (v ->> 'trajectory_tolerance')::float8, (v ->> 'trajectory_radius')::float8, u.changed, u.beside, f.axis_id, f.geom, f.wanted_start, f.start, f.wanted_end, f."end", p.x, p.y, p.met,
        o.line, l.axis_id, l.abscissa, l.which, c.axis_a, c.axis_b, c.x, c.y, c.radius, u.outer_axis) s),
-- The axes whose rows come out, and those that are gone.
asked_axis AS MATERIALIZED (
    SELECT DISTINCT of_axis AS axis_id FROM result WHERE relation = 'edge' AND (start_a OR start_b) AND of_axis = ANY ($1) UNION SELECT unnest($3)),
new_edge AS MATERIALIZED (
    SELECT row_index, start_b AS asked, of_axis AS axis_id, node_a, node_b, of_level AS level, measure_1 AS start_abscissa, measure_2 AS end_abscissa, %3$s AS geom
    FROM result WHERE relation = 'edge' AND of_axis IN (SELECT axis_id FROM asked_axis)),
new_node AS MATERIALIZED (
    SELECT row_index, start_a AS asked, %4$s AS geom, anchor_axis, anchor_abscissa FROM result
    WHERE relation = 'node' AND row_index IN (SELECT node_a FROM new_edge UNION SELECT node_b FROM new_edge)),
-- Identity: an axis end is known by its side, a shared vertex by its abscissa.
old_edge AS MATERIALIZED (SELECT e.*, axis_id IN (SELECT axis_id FROM asked_axis) AS asked FROM %1$I.edge e WHERE axis_id = ANY ($1) OR axis_id = ANY ($2)),
old_span AS (SELECT axis_id, min(start_abscissa) AS first, max(end_abscissa) AS last FROM old_edge GROUP BY axis_id),
old_anchor AS (
    SELECT DISTINCT o.axis_id, CASE WHEN start_abscissa = first THEN -1 ELSE round((start_abscissa * 100)::numeric) END AS place, from_node AS node_id FROM old_edge o JOIN old_span USING (axis_id)
    UNION SELECT o.axis_id, CASE WHEN end_abscissa = last THEN -2 ELSE round((end_abscissa * 100)::numeric) END, to_node FROM old_edge o JOIN old_span USING (axis_id)),
new_span AS (SELECT of_axis AS axis_id, min(measure_1) AS first, max(measure_2) AS last FROM result WHERE relation = 'edge' GROUP BY of_axis),
new_anchor AS (
    SELECT row_index, a.axis_id, CASE WHEN abscissa = first THEN -1 WHEN abscissa = last THEN -2 ELSE round((abscissa * 100)::numeric) END AS place
    FROM new_node, unnest(anchor_axis, anchor_abscissa) AS a(axis_id, abscissa) LEFT JOIN new_span USING (axis_id)),
claim_of AS (SELECT row_index, node_id, min(axis_id) AS axis_id FROM new_anchor JOIN old_anchor USING (axis_id, place) GROUP BY row_index, node_id),
heir AS (SELECT DISTINCT ON (node_id) node_id, row_index FROM claim_of ORDER BY node_id, axis_id, row_index),
kept_node AS (SELECT row_index, min(node_id) AS node_id FROM heir GROUP BY row_index),
node_id_of AS MATERIALIZED (
    SELECT row_index, coalesce(node_id, nextval('%6$s.node_node_id_seq')) AS node_id, geom, asked
    FROM (SELECT n.row_index, k.node_id, n.geom, n.asked FROM new_node n LEFT JOIN kept_node k USING (row_index) ORDER BY n.row_index OFFSET 0) t),
same_edge AS MATERIALIZED (SELECT e.row_index, o.edge_id FROM new_edge e JOIN old_edge o USING (axis_id, start_abscissa, end_abscissa)),
old_key AS (
    SELECT edge_id, axis_id, from_node, row_number() OVER (PARTITION BY axis_id, from_node ORDER BY start_abscissa) AS turn
    FROM old_edge o WHERE NOT EXISTS (SELECT FROM same_edge s WHERE s.edge_id = o.edge_id)),
edge_id_of AS MATERIALIZED (
    SELECT t.row_index, coalesce(t.edge_id, nextval('%6$s.edge_edge_id_seq')) AS edge_id, t.axis_id, t.from_node, t.to_node, t.level, t.start_abscissa, t.end_abscissa, t.geom, t.asked
    FROM (SELECT e.*, coalesce(e.same_id, o.edge_id) AS edge_id FROM (
            SELECT e.*, s.edge_id AS same_id, a.node_id AS from_node, b.node_id AS to_node, row_number() OVER (PARTITION BY e.axis_id, a.node_id, s.edge_id IS NULL ORDER BY e.start_abscissa) AS turn
            FROM new_edge e LEFT JOIN same_edge s USING (row_index) JOIN node_id_of a ON a.row_index = e.node_a JOIN node_id_of b ON b.row_index = e.node_b) e
          LEFT JOIN old_key o ON e.same_id IS NULL AND (o.axis_id, o.from_node, o.turn) = (e.axis_id, e.from_node, e.turn) ORDER BY e.row_index OFFSET 0) t),
gone_edge AS (
    DELETE FROM %1$I.edge d USING old_edge o WHERE d.edge_id = o.edge_id AND o.asked
        AND NOT EXISTS (SELECT FROM edge_id_of n WHERE n.edge_id = o.edge_id) RETURNING d.edge_id, d.from_node, d.to_node),
set_node AS (
    INSERT INTO %1$I.node AS t (node_id, geom) SELECT node_id, geom::geometry FROM node_id_of
    ON CONFLICT (node_id) DO UPDATE SET geom = excluded.geom WHERE t.geom::bytea <> excluded.geom::bytea RETURNING xmax = 0 AS fresh),
-- LIMIT: asked of each node, and not joined.
left_node AS MATERIALIZED (
    SELECT node_id FROM (
        SELECT from_node AS node_id FROM old_edge WHERE asked UNION SELECT to_node FROM old_edge WHERE asked UNION SELECT node_id FROM %1$I.node WHERE $1 IS NULL
        EXCEPT SELECT node_id FROM node_id_of) o
    WHERE (SELECT true FROM %1$I.edge e WHERE e.from_node = o.node_id AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis) LIMIT 1) IS NULL
        AND (SELECT true FROM %1$I.edge e WHERE e.to_node = o.node_id AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis) LIMIT 1) IS NULL),
gone_node AS (DELETE FROM %1$I.node d USING left_node o WHERE d.node_id = o.node_id RETURNING d.node_id),
set_edge AS (
    INSERT INTO %1$I.edge AS t (edge_id, axis_id, from_node, to_node, level, start_abscissa, end_abscissa, geom, width, width_end, lane_count, lanes_forward, lanes_backward, speed, importance, estimated, input_hash, setting_hash)
    SELECT e.edge_id, e.axis_id, e.from_node, e.to_node, e.level, e.start_abscissa, e.end_abscissa, e.geom::geometry, u.width, u.width_end, u.lane_count, u.lanes_forward, u.lanes_backward, u.speed, u.importance, u.estimated, u.input_hash, u.setting_hash
    FROM edge_id_of e JOIN used u USING (axis_id) ORDER BY e.row_index
    ON CONFLICT (edge_id) DO UPDATE SET axis_id = excluded.axis_id, from_node = excluded.from_node, to_node = excluded.to_node, level = excluded.level, start_abscissa = excluded.start_abscissa,
        end_abscissa = excluded.end_abscissa, geom = excluded.geom, width = excluded.width, width_end = excluded.width_end, lane_count = excluded.lane_count, lanes_forward = excluded.lanes_forward, lanes_backward = excluded.lanes_backward, speed = excluded.speed,
        importance = excluded.importance, estimated = excluded.estimated, input_hash = excluded.input_hash, setting_hash = excluded.setting_hash
    WHERE (t.axis_id, t.from_node, t.to_node, t.level, t.start_abscissa, t.end_abscissa, t.geom::bytea, t.width, t.width_end, t.lane_count, t.lanes_forward, t.lanes_backward, t.speed, t.importance, t.estimated, t.input_hash, t.setting_hash)
        IS DISTINCT FROM (excluded.axis_id, excluded.from_node, excluded.to_node, excluded.level, excluded.start_abscissa, excluded.end_abscissa, excluded.geom::bytea, excluded.width, excluded.width_end,
                          excluded.lane_count, excluded.lanes_forward, excluded.lanes_backward, excluded.speed, excluded.importance, excluded.estimated, excluded.input_hash, excluded.setting_hash)
    RETURNING xmax = 0 AS fresh),
new_limit AS MATERIALIZED (
    SELECT l.section_limit_id, e.edge_id, CASE WHEN r.start_a THEN 'start' ELSE 'end' END AS which, r.measure_1 AS wanted, r.measure_2 AS abscissa, %5$s AS geom_1, r.geom_2, r.method
    FROM result r JOIN edge_id_of e ON e.row_index = r.edge_a
    LEFT JOIN %1$I.section_limit l ON l.edge_id = e.edge_id AND l.which = CASE WHEN r.start_a THEN 'start' ELSE 'end' END WHERE r.relation = 'section_limit'),
set_limit AS (
    INSERT INTO %1$I.section_limit AS t (section_limit_id, edge_id, which, wanted_abscissa, abscissa, geom, border_line, method)
    SELECT coalesce(section_limit_id, nextval('%6$s.section_limit_section_limit_id_seq')), edge_id, which, wanted, abscissa, geom_1::geometry, geom_2::geometry, method FROM new_limit
    ON CONFLICT (section_limit_id) DO UPDATE SET wanted_abscissa = excluded.wanted_abscissa, abscissa = excluded.abscissa, geom = excluded.geom, border_line = excluded.border_line, method = excluded.method
    WHERE (t.wanted_abscissa, t.abscissa, t.geom::bytea, t.border_line::bytea, t.method) IS DISTINCT FROM (excluded.wanted_abscissa, excluded.abscissa, excluded.geom::bytea, excluded.border_line::bytea, excluded.method)
    RETURNING xmax = 0 AS fresh),
new_section AS MATERIALIZED (
    SELECT e.edge_id, r.of_level AS level, r.geom_1 AS surface, r.method, r.measure_1 AS contested_area
    FROM result r JOIN edge_id_of e ON e.row_index = r.edge_a WHERE r.relation = 'section'),
set_section AS (
    INSERT INTO %1$I.section AS t SELECT edge_id, level, surface::geometry, method, contested_area FROM new_section
    ON CONFLICT (edge_id) DO UPDATE SET level = excluded.level, surface = excluded.surface, method = excluded.method, contested_area = excluded.contested_area
    WHERE (t.level, t.surface::bytea, t.method, t.contested_area) IS DISTINCT FROM (excluded.level, excluded.surface::bytea, excluded.method, excluded.contested_area) RETURNING xmax = 0 AS fresh),
new_corner AS MATERIALIZED (
    SELECT k.corner_id, n.node_id, a.edge_id AS edge_a, CASE WHEN r.start_a THEN 'start' ELSE 'end' END AS end_a, b.edge_id AS edge_b, CASE WHEN r.start_b THEN 'start' ELSE 'end' END AS end_b,
           r.geom_1 AS centre, r.measure_1 AS radius_wanted, r.measure_2 AS radius, r.geom_2 AS arc, r.method
    FROM result r JOIN node_id_of n ON n.row_index = r.node_a JOIN edge_id_of a ON a.row_index = r.edge_a JOIN edge_id_of b ON b.row_index = r.edge_b
    LEFT JOIN %1$I.corner k ON (k.node_id, k.edge_a, k.end_a, k.edge_b, k.end_b)
        = (n.node_id, a.edge_id, CASE WHEN r.start_a THEN 'start' ELSE 'end' END, b.edge_id, CASE WHEN r.start_b THEN 'start' ELSE 'end' END)
    WHERE r.relation = 'corner' ORDER BY r.row_index),
set_corner AS (
    INSERT INTO %1$I.corner AS t (corner_id, node_id, edge_a, end_a, edge_b, end_b, centre, radius_wanted, radius, arc, method)
    SELECT coalesce(corner_id, nextval('%6$s.corner_corner_id_seq')), node_id, edge_a, end_a, edge_b, end_b, centre::geometry, radius_wanted, radius, arc::geometry, method FROM new_corner
    ON CONFLICT (corner_id) DO UPDATE SET centre = excluded.centre, radius_wanted = excluded.radius_wanted, radius = excluded.radius, arc = excluded.arc, method = excluded.method
    WHERE (t.centre::bytea, t.radius_wanted, t.radius, t.arc::bytea, t.method) IS DISTINCT FROM (excluded.centre::bytea, excluded.radius_wanted, excluded.radius, excluded.arc::bytea, excluded.method)
    RETURNING xmax = 0 AS fresh),
gone_corner AS (
    DELETE FROM %1$I.corner k USING node_id_of n WHERE k.node_id = n.node_id
        AND k.edge_a IN (SELECT edge_id FROM edge_id_of) AND k.edge_b IN (SELECT edge_id FROM edge_id_of)
        AND NOT EXISTS (SELECT FROM (SELECT %7$s corner_id FROM new_corner) c WHERE c.corner_id = k.corner_id) RETURNING k.corner_id),
new_intersection AS MATERIALIZED (
    SELECT n.node_id, r.of_level AS level, r.geom_1 AS surface, r.method, r.measure_1 AS contested_area
    FROM result r JOIN node_id_of n ON n.row_index = r.node_a WHERE r.relation = 'intersection'),
set_intersection AS (
    INSERT INTO %1$I.intersection AS t SELECT node_id, level, surface::geometry, method, contested_area FROM new_intersection
    ON CONFLICT (node_id) DO UPDATE SET level = excluded.level, surface = excluded.surface, method = excluded.method, contested_area = excluded.contested_area
    WHERE (t.level, t.surface::bytea, t.method, t.contested_area) IS DISTINCT FROM (excluded.level, excluded.surface::bytea, excluded.method, excluded.contested_area) RETURNING xmax = 0 AS fresh),
gone_intersection AS (
    DELETE FROM %1$I.intersection i USING node_id_of n WHERE i.node_id = n.node_id AND n.asked
        AND NOT EXISTS (SELECT FROM new_intersection c WHERE c.node_id = i.node_id) RETURNING i.node_id),
new_lane AS MATERIALIZED (
    SELECT row_index, coalesce(lane_id, nextval('%6$s.lane_lane_id_seq')) AS lane_id, edge_id, axis_id, ordinality, lane_position, side, along_axis, kind, width, axis_offset, turn, geom, surface, method FROM (
    SELECT r.row_index, l.lane_id, e.edge_id, e.axis_id, r.ordinality, r.lane_position, r.side, r.start_a AS along_axis, r.kind, r.measure_1 AS width, r.measure_2 AS axis_offset, r.turn, r.geom_1 AS geom, r.geom_2 AS surface, r.method
    FROM result r JOIN edge_id_of e ON e.row_index = r.edge_a LEFT JOIN %1$I.lane l ON (l.edge_id, l.ordinality) = (e.edge_id, r.ordinality) WHERE r.relation = 'lane' ORDER BY r.row_index OFFSET 0) t),
set_lane AS (
    INSERT INTO %1$I.lane AS t (lane_id, edge_id, ordinality, lane_position, side, along_axis, kind, width, axis_offset, turn, geom, surface, method)
    SELECT lane_id, edge_id, ordinality, lane_position, side, along_axis, kind, width, axis_offset, turn, geom::geometry, surface::geometry, method FROM new_lane
    ON CONFLICT (lane_id) DO UPDATE SET lane_position = excluded.lane_position, side = excluded.side, along_axis = excluded.along_axis, kind = excluded.kind, width = excluded.width,
        axis_offset = excluded.axis_offset, turn = excluded.turn, geom = excluded.geom, surface = excluded.surface, method = excluded.method
    WHERE (t.lane_position, t.side, t.along_axis, t.kind, t.width, t.axis_offset, t.turn, t.geom::bytea, t.surface::bytea, t.method)
        IS DISTINCT FROM (excluded.lane_position, excluded.side, excluded.along_axis, excluded.kind, excluded.width, excluded.axis_offset, excluded.turn, excluded.geom::bytea, excluded.surface::bytea, excluded.method)
    RETURNING xmax = 0 AS fresh),
gone_lane AS (
    DELETE FROM %1$I.lane l USING edge_id_of e WHERE l.edge_id = e.edge_id AND e.asked AND NOT EXISTS (SELECT FROM new_lane n WHERE n.lane_id = l.lane_id) RETURNING 1),
new_separator AS MATERIALIZED (
    SELECT s.lane_separator_id, e.edge_id, r.lane_position, r.kind, r.start_a AS dashed, r.measure_2 AS axis_offset, r.geom_1 AS geom, r.geom_2 AS surface
    FROM result r JOIN edge_id_of e ON e.row_index = r.edge_a LEFT JOIN %1$I.lane_separator s ON (s.edge_id, s.lane_position) = (e.edge_id, r.lane_position) WHERE r.relation = 'lane_separator'),
set_separator AS (
    INSERT INTO %1$I.lane_separator AS t (lane_separator_id, edge_id, lane_position, kind, dashed, axis_offset, geom, surface)
    SELECT coalesce(lane_separator_id, nextval('%6$s.lane_separator_lane_separator_id_seq')), edge_id, lane_position, kind, dashed, axis_offset, geom::geometry, surface::geometry FROM new_separator
    ON CONFLICT (lane_separator_id) DO UPDATE SET kind = excluded.kind, dashed = excluded.dashed, axis_offset = excluded.axis_offset, geom = excluded.geom, surface = excluded.surface
    WHERE (t.kind, t.dashed, t.axis_offset, t.geom::bytea, t.surface::bytea) IS DISTINCT FROM (excluded.kind, excluded.dashed, excluded.axis_offset, excluded.geom::bytea, excluded.surface::bytea)
    RETURNING xmax = 0 AS fresh),
gone_separator AS (
    DELETE FROM %1$I.lane_separator s USING edge_id_of e WHERE s.edge_id = e.edge_id AND e.asked AND NOT EXISTS (SELECT FROM new_separator n WHERE n.lane_separator_id = s.lane_separator_id) RETURNING 1),
new_marking AS MATERIALIZED (
    SELECT m.marking_id, e.edge_id, r.lane_position, n.node_id, r.kind, r.geom_1 AS geom, r.geom_2 AS surface
    FROM result r JOIN edge_id_of e ON e.row_index = r.edge_a JOIN node_id_of n ON n.row_index = r.node_a
    LEFT JOIN %1$I.marking m ON (m.edge_id, m.kind, m.lane_position) = (e.edge_id, r.kind, r.lane_position) WHERE r.relation = 'marking'),
set_marking AS (
    INSERT INTO %1$I.marking AS t (marking_id, edge_id, lane_position, node_id, kind, geom, surface)
    SELECT coalesce(marking_id, nextval('%6$s.marking_marking_id_seq')), edge_id, lane_position, node_id, kind, geom::geometry, surface::geometry FROM new_marking
    ON CONFLICT (marking_id) DO UPDATE SET node_id = excluded.node_id, geom = excluded.geom, surface = excluded.surface
    WHERE (t.node_id, t.geom::bytea, t.surface::bytea) IS DISTINCT FROM (excluded.node_id, excluded.geom::bytea, excluded.surface::bytea) RETURNING xmax = 0 AS fresh),
gone_marking AS (
    DELETE FROM %1$I.marking m USING edge_id_of e WHERE m.edge_id = e.edge_id AND e.asked AND NOT EXISTS (SELECT FROM new_marking n WHERE n.marking_id = m.marking_id) RETURNING 1),
interconnection_decided AS MATERIALIZED (
    SELECT DISTINCT ON (r.row_index) r.row_index, d.connecting, d.control
    FROM %1$I.interconnection_override d JOIN new_lane i ON (i.axis_id, i.ordinality) = (d.axis_in, d.lane_in) JOIN new_lane o ON (o.axis_id, o.ordinality) = (d.axis_out, d.lane_out)
    JOIN result r ON r.relation = 'interconnection' AND (r.edge_a, r.edge_b) = (i.row_index, o.row_index) JOIN node_id_of n ON n.row_index = r.node_a CROSS JOIN setting
    WHERE ST_DWithin(d.geom, n.geom::geometry, 3 * (v ->> 'tolerance')::float8) ORDER BY r.row_index, d.interconnection_override_id DESC),
new_interconnection AS MATERIALIZED (
    SELECT k.interconnection_id, n.node_id, i.lane_id AS lane_in, o.lane_id AS lane_out, r.turn, r.measure_1 AS angle, r.start_a AS plausible, r.kind AS reason, coalesce(d.connecting, r.start_a) AS connecting,
           CASE WHEN d.control IS NOT NULL THEN d.control::bytea WHEN drawn THEN r.geom_2 END AS control,
           CASE WHEN d.control IS NULL AND drawn THEN r.geom_1
                ELSE streetgen._trajectory(v ->> 'trajectory', i.geom::geometry, i.along_axis, o.geom::geometry, o.along_axis, n.geom::geometry, d.control, (v ->> 'trajectory_tolerance')::float8)::bytea END AS geom,
           CASE WHEN d.row_index IS NULL THEN 'hypothesis' ELSE 'by_hand' END AS method
    FROM result r CROSS JOIN (SELECT v, v ->> 'trajectory' IN ('bezier', 'arcs') AS drawn FROM setting) s
    JOIN node_id_of n ON n.row_index = r.node_a JOIN new_lane i ON i.row_index = r.edge_a JOIN new_lane o ON o.row_index = r.edge_b
    LEFT JOIN interconnection_decided d ON d.row_index = r.row_index LEFT JOIN %1$I.interconnection k ON (k.lane_in, k.lane_out) = (i.lane_id, o.lane_id)
    WHERE r.relation = 'interconnection' ORDER BY r.row_index),
set_interconnection AS (
    INSERT INTO %1$I.interconnection AS t (interconnection_id, node_id, lane_in, lane_out, turn, angle, plausible, reason, connecting, control, geom, method)
    SELECT coalesce(interconnection_id, nextval('%6$s.interconnection_interconnection_id_seq')), node_id, lane_in, lane_out, turn, angle, plausible, reason, connecting, control::geometry, geom::geometry, method FROM new_interconnection
    ON CONFLICT (interconnection_id) DO UPDATE SET node_id = excluded.node_id, turn = excluded.turn, angle = excluded.angle, plausible = excluded.plausible, reason = excluded.reason,
        connecting = excluded.connecting, control = excluded.control, geom = excluded.geom, method = excluded.method
    WHERE (t.node_id, t.turn, t.angle, t.plausible, t.reason, t.connecting, t.control::bytea, t.geom::bytea, t.method)
        IS DISTINCT FROM (excluded.node_id, excluded.turn, excluded.angle, excluded.plausible, excluded.reason, excluded.connecting, excluded.control::bytea, excluded.geom::bytea, excluded.method)
    RETURNING xmax = 0 AS fresh),
-- Of many, DISTINCT brings the planner's guess of the rows down, so that the hash is of one batch. An OR of both lanes could only be a nested loop.
gone_interconnection AS (
    DELETE FROM %1$I.interconnection k USING (SELECT node_id FROM node_id_of WHERE asked UNION ALL SELECT node_id FROM left_node) n WHERE k.node_id = n.node_id
        AND NOT EXISTS (SELECT FROM %1$I.lane l JOIN %1$I.edge e USING (edge_id) WHERE l.lane_id = k.lane_in AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis))
        AND NOT EXISTS (SELECT FROM %1$I.lane l JOIN %1$I.edge e USING (edge_id) WHERE l.lane_id = k.lane_out AND NOT e.axis_id IN (SELECT axis_id FROM asked_axis))
        AND NOT EXISTS (SELECT FROM (SELECT %7$s interconnection_id FROM new_interconnection) c WHERE c.interconnection_id = k.interconnection_id) RETURNING 1),
new_report AS MATERIALIZED (
    SELECT DISTINCT method AS issue, of_axis AS axis_a, anchor_axis[1] AS axis_b, measure_1 AS measure, geom_1::geometry AS geom
    FROM result WHERE relation = 'report' AND of_axis IN (SELECT axis_id FROM asked_axis)),
gone_report AS (
    DELETE FROM %1$I.report o WHERE o.axis_a IN (SELECT axis_id FROM asked_axis)
        AND NOT EXISTS (SELECT FROM new_report n WHERE (n.issue, n.axis_a, n.axis_b, n.measure, n.geom::bytea) = (o.issue, o.axis_a, o.axis_b, o.measure, o.geom::bytea)) RETURNING 1),
set_report AS (
    INSERT INTO %1$I.report SELECT n.* FROM new_report n
    WHERE NOT EXISTS (SELECT FROM %1$I.report o WHERE (n.issue, n.axis_a, n.axis_b, n.measure, n.geom::bytea) = (o.issue, o.axis_a, o.axis_b, o.measure, o.geom::bytea)) RETURNING 1),
counted(relation, place, total, inserted, updated, deleted, hard) AS (
    SELECT 'node', 1, (SELECT count(*) FROM node_id_of), (SELECT count(*) FROM set_node WHERE fresh), (SELECT count(*) FROM set_node WHERE NOT fresh), (SELECT count(*) FROM gone_node), 0
    UNION ALL SELECT 'edge', 2, (SELECT count(*) FROM edge_id_of), (SELECT count(*) FROM set_edge WHERE fresh), (SELECT count(*) FROM set_edge WHERE NOT fresh), (SELECT count(*) FROM gone_edge), 0
    UNION ALL SELECT 'section_limit', 3, (SELECT count(*) FROM new_limit), (SELECT count(*) FROM set_limit WHERE fresh), (SELECT count(*) FROM set_limit WHERE NOT fresh), (SELECT 2 * count(*) FROM gone_edge), (SELECT count(*) FROM new_limit WHERE method <> 'hypothesis')
    UNION ALL SELECT 'section', 4, (SELECT count(*) FROM new_section), (SELECT count(*) FROM set_section WHERE fresh), (SELECT count(*) FROM set_section WHERE NOT fresh), (SELECT count(*) FROM gone_edge), (SELECT count(*) FROM new_section WHERE method <> 'hypothesis')
    UNION ALL SELECT 'corner', 5, (SELECT count(*) FROM new_corner), (SELECT count(*) FROM set_corner WHERE fresh), (SELECT count(*) FROM set_corner WHERE NOT fresh), (SELECT count(*) FROM gone_corner), (SELECT count(*) FROM new_corner WHERE method <> 'hypothesis')
    UNION ALL SELECT 'intersection', 6, (SELECT count(*) FROM new_intersection), (SELECT count(*) FROM set_intersection WHERE fresh), (SELECT count(*) FROM set_intersection WHERE NOT fresh), (SELECT count(*) FROM gone_intersection), (SELECT count(*) FROM new_intersection WHERE method <> 'hypothesis')
    UNION ALL SELECT 'lane', 7, (SELECT count(*) FROM new_lane), (SELECT count(*) FROM set_lane WHERE fresh), (SELECT count(*) FROM set_lane WHERE NOT fresh), (SELECT count(*) FROM gone_lane), (SELECT count(*) FROM new_lane WHERE method <> 'hypothesis')
    UNION ALL SELECT 'lane_separator', 8, (SELECT count(*) FROM new_separator), (SELECT count(*) FROM set_separator WHERE fresh), (SELECT count(*) FROM set_separator WHERE NOT fresh), (SELECT count(*) FROM gone_separator), 0
    UNION ALL SELECT 'marking', 9, (SELECT count(*) FROM new_marking), (SELECT count(*) FROM set_marking WHERE fresh), (SELECT count(*) FROM set_marking WHERE NOT fresh), (SELECT count(*) FROM gone_marking), 0
    UNION ALL SELECT 'interconnection', 10, (SELECT count(*) FROM new_interconnection), (SELECT count(*) FROM set_interconnection WHERE fresh), (SELECT count(*) FROM set_interconnection WHERE NOT fresh), (SELECT count(*) FROM gone_interconnection), (SELECT count(*) FROM new_interconnection WHERE method <> 'hypothesis')
    UNION ALL SELECT 'report', 20, (SELECT count(*) FROM new_report), (SELECT count(*) FROM set_report), 0, (SELECT count(*) FROM gone_report), 0)
SELECT relation, inserted, updated, deleted, total - inserted - updated, hard::bigint FROM counted ORDER BY place
$sql$, model, (SELECT m.srid FROM streetgen.model m WHERE m.name = model), replace(place, '?', 'of_axis'), replace(place, '?', 'anchor_axis[1]'), replace(place, '?', 'e.axis_id'),
        -- Between quotes.
        replace(quote_ident(model), '''', ''''''), CASE WHEN many THEN 'DISTINCT' ELSE '' END);
END $$;
COMMENT ON FUNCTION streetgen._upsert_statement(name, boolean) IS 'The statement that computes streets and upserts them, of three arrays: $1 the axes whose rows may be written, $2 those that they are computed with, $3 those that changed. many: planned anew for the sizes of tables. Gives a row per table: relation, inserted, updated, deleted, unchanged, hard.';

CREATE OR REPLACE FUNCTION streetgen._upsert_set(model name, written bigint[], gathered bigint[], changed bigint[], bare boolean DEFAULT false)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public SET jit = off
    -- Nothing is known of rows just computed, and tables just filled have no statistics: joins are on equal keys.
    SET enable_nestloop = off
    -- The core tells its progress here, in pg_stat_activity; whatever happens, the name of the session comes back.
    SET application_name = 'streetgen: reading or writing rows'
    AS $$
DECLARE
    work_mem_before text := current_setting('work_mem');
    statement text := streetgen._upsert_statement(model, many => true);
BEGIN
    PERFORM set_config('work_mem', '64MB', true) WHERE pg_size_bytes(work_mem_before) < pg_size_bytes('64MB');
    IF written IS NULL THEN
        -- Of the whole model every axis is asked.
        statement := regexp_replace(statement, '[a-z_.]+ (= ANY \(\$[123]\)|IN \(SELECT axis_id FROM asked_axis\))', 'true', 'g');
    END IF;
    IF bare THEN
        -- No row is there to meet.
        statement := regexp_replace(statement, 'ON CONFLICT.*?RETURNING xmax = 0 AS fresh', 'RETURNING true AS fresh', 'g');
    END IF;
    RETURN QUERY EXECUTE statement USING written, gathered, changed;
    PERFORM set_config('work_mem', work_mem_before, true);
END $$;
COMMENT ON FUNCTION streetgen._upsert_set(name, bigint[], bigint[], bigint[], boolean) IS 'Computes and upserts many streets, planned for the sizes of the tables: all axes of a model (NULL; leftovers of deleted ones go), or what changed axes can change of those written, with those gathered around them. bare: nothing was derived yet, so that rows are inserted, and nothing else.';

CREATE OR REPLACE FUNCTION streetgen._make_upsert(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- In the model's schema, so that a session plans the statement once. Its tables are reached by their keys: no page is far.
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._upsert(written bigint[], gathered bigint[], changed bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 10 SET search_path FROM CURRENT SET jit = off
    SET enable_seqscan = off SET random_page_cost = 0.01 SET plan_cache_mode = force_generic_plan
    AS $body$
#variable_conflict use_column
BEGIN
    RETURN QUERY %2$s;
END $body$ $sql$, model, streetgen._upsert_statement(model, many => false));
    PERFORM streetgen._own_function(model, '_upsert(bigint[], bigint[], bigint[])', 'Computes and upserts what changed axes can change of the axes written, with those gathered around them; streetgen.generate and the triggers call it');
END $$;
COMMENT ON FUNCTION streetgen._make_upsert(name) IS 'Makes the function of a model that upserts a part of it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_part(model name, written bigint[], gathered bigint[], changed bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, hard bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- More axes than this are worth a plan of their own.
    most_planned constant integer := 400;
BEGIN
    IF cardinality(changed) > most_planned THEN
        RETURN QUERY SELECT * FROM streetgen._upsert_set(model, written, gathered, changed);
    ELSE
        RETURN QUERY EXECUTE format('SELECT * FROM %I._upsert($1, $2, $3)', model) USING written, gathered, changed;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._upsert_part(name, bigint[], bigint[], bigint[]) IS 'Computes and upserts what changed axes can change, by the plan of the model for few axes or by one for many.';
