-- Parts of the one statement, by name: streetgen._part gives each.

--{moved_object
-- Corners that came, went or changed, as they were and as they are.
object_corner AS MATERIALIZED (
    SELECT node_id, edge_a, edge_b FROM new_corner WHERE changed
    UNION ALL SELECT c.node_id, c.edge_a, c.edge_b
    FROM (SELECT corner_id FROM new_corner WHERE changed AND NOT fresh UNION ALL SELECT corner_id FROM gone_corner) g,
        LATERAL (SELECT * FROM {model}.corner c WHERE c.corner_id = g.corner_id OFFSET 0) c),
-- Nodes at which an edge came or went: their arms are counted.
object_node AS MATERIALIZED (
    SELECT unnest(ARRAY[n.from_node, n.to_node, o.from_node, o.to_node]) AS node_id
    FROM new_edge n LEFT JOIN LATERAL (SELECT from_node, to_node FROM {model}.edge o WHERE o.edge_id = n.edge_id
        OFFSET 0) o ON true
    WHERE n.changed AND (n.from_node, n.to_node) IS DISTINCT FROM (o.from_node, o.to_node)
    UNION SELECT unnest(ARRAY[from_node, to_node]) FROM old_edge WHERE edge_id IN (SELECT edge_id FROM gone_edge)),
-- Edges of which something changed that places by rules are counted from.
object_street AS MATERIALIZED (
    SELECT edge_id FROM new_edge WHERE changed
    UNION SELECT edge_id FROM gone_edge
    UNION SELECT edge_id FROM new_section WHERE changed
    UNION SELECT edge_id FROM new_section_limit WHERE changed
    UNION SELECT edge_a FROM object_corner UNION SELECT edge_b FROM object_corner
    UNION SELECT e.edge_id FROM object_node n, LATERAL (
        SELECT edge_id FROM {model}.edge e WHERE e.from_node = n.node_id
        UNION ALL SELECT edge_id FROM {model}.edge e WHERE e.to_node = n.node_id OFFSET 0) e
    UNION SELECT edge_id FROM {model}.edge WHERE axis_id = ANY ($3){lanes}{rings}),
-- Nodes at which intersections changed, or corners of streets.
object_meeting AS MATERIALIZED (
    SELECT node_id FROM new_intersection WHERE changed
    UNION SELECT node_id FROM gone_intersection UNION SELECT node_id FROM gone_node
    UNION SELECT node_id FROM object_corner
    UNION SELECT unnest(ARRAY[from_node, to_node]) FROM {model}.edge WHERE axis_id = ANY ($3)
    -- Places lie on the ground of both ends where limits cross.
    UNION SELECT unnest(ARRAY[from_node, to_node]) FROM object_street o, LATERAL (SELECT from_node, to_node
        FROM {model}.edge e, {model}.section s WHERE e.edge_id = o.edge_id AND s.edge_id = o.edge_id
            AND ST_IsEmpty(s.surface) OFFSET 0) e),
object_ground AS MATERIALIZED (
    SELECT o.edge_id, s.surface AS ground FROM object_street o, LATERAL (SELECT surface FROM {model}.section s
        WHERE s.edge_id = o.edge_id OFFSET 0) s
    UNION ALL SELECT edge_id, surface FROM new_section WHERE changed
    UNION ALL SELECT NULL, surface FROM new_intersection WHERE changed
    UNION ALL SELECT NULL, i.surface FROM object_meeting n, LATERAL (SELECT surface FROM {model}.intersection i
        WHERE i.node_id = n.node_id OFFSET 0) i
    -- Other kerbs lie on the border of this ground.
    UNION ALL SELECT NULL, geom FROM new_kerb k WHERE changed AND edge_id NOT IN (SELECT edge_id FROM object_street)
        AND NOT EXISTS (SELECT FROM object_meeting m WHERE m.node_id = k.node_id)
    UNION ALL SELECT NULL, k.geom FROM (SELECT kerb_id FROM new_kerb WHERE changed AND NOT fresh
            UNION ALL SELECT kerb_id FROM gone_kerb) c,
        LATERAL (SELECT geom, edge_id, node_id FROM {model}.kerb k WHERE k.kerb_id = c.kerb_id OFFSET 0) k
        WHERE edge_id NOT IN (SELECT edge_id FROM object_street)
            AND NOT EXISTS (SELECT FROM object_meeting m WHERE m.node_id = k.node_id){lines}),
moved_object AS MATERIALIZED (
    SELECT axis_id AS id, NULL::geometry AS ground FROM new_edge WHERE edge_id IN (SELECT edge_id FROM object_street)
    UNION SELECT e.axis_id, NULL FROM object_street o, LATERAL (SELECT axis_id FROM {model}.edge e
        WHERE e.edge_id = o.edge_id OFFSET 0) e
    UNION SELECT unnest($3), NULL
    UNION ALL SELECT edge_id, ground FROM object_ground)

--{moved_object_lanes

    UNION SELECT edge_id FROM new_lane WHERE changed
    UNION SELECT l.edge_id FROM gone_lane g, LATERAL (SELECT edge_id FROM {model}.lane l WHERE l.lane_id = g.lane_id
        OFFSET 0) l

--{moved_object_rings

    UNION SELECT e.edge_id FROM (SELECT roundabout_id FROM new_roundabout WHERE changed
            UNION ALL SELECT roundabout_id FROM gone_roundabout) r,
        LATERAL (SELECT edge_id FROM {model}.roundabout_edge e WHERE e.roundabout_id = r.roundabout_id OFFSET 0) e
    UNION SELECT edge_id FROM new_roundabout_edge WHERE changed OR roundabout_id IN (SELECT roundabout_id
        FROM new_roundabout WHERE changed)
    UNION SELECT e.edge_id FROM gone_roundabout_edge g, LATERAL (SELECT edge_id FROM {model}.roundabout_edge e
        WHERE e.roundabout_edge_id = g.roundabout_edge_id OFFSET 0) e

--{moved_object_lines

    UNION ALL SELECT NULL, geom FROM new_marking WHERE changed AND kind <> 'arrow'
    UNION ALL SELECT NULL, m.geom FROM (SELECT marking_id FROM new_marking WHERE changed AND NOT fresh
            UNION ALL SELECT marking_id FROM gone_marking) c,
        LATERAL (SELECT geom FROM {model}.marking m WHERE m.marking_id = c.marking_id AND kind <> 'arrow' OFFSET 0) m

--{join_object_edges
#variable_conflict use_column
BEGIN
    RETURN QUERY WITH there AS MATERIALIZED (
        SELECT s.street_object_id, s.axis_id, s.abscissa FROM street_object s
        WHERE s.method = 'relative' AND {of_axes}),
    new AS MATERIALIZED (
        SELECT DISTINCT ON (t.street_object_id) t.street_object_id, e.edge_id
        FROM there t JOIN edge e ON e.axis_id = t.axis_id
            AND t.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
        ORDER BY t.street_object_id, e.start_abscissa),
    old AS MATERIALIZED (
        SELECT o.street_object_id, o.edge_id FROM object_edge o
        WHERE {of_objects}),
    compared AS MATERIALIZED (
        SELECT n.*, o.edge_id AS before FROM new n LEFT JOIN old o USING (street_object_id)),
    -- Rows of what stands there no more, and of objects whose axes are gone.
    gone AS (
        DELETE FROM object_edge o WHERE o.street_object_id = ANY (ARRAY(SELECT street_object_id FROM old
            EXCEPT SELECT street_object_id FROM new)) RETURNING 1),
    -- A first run has no keys yet.
    put AS (
        INSERT INTO object_edge (street_object_id, edge_id)
        SELECT street_object_id, edge_id FROM compared WHERE before IS NULL ORDER BY street_object_id),
    moved AS (
        UPDATE object_edge o SET edge_id = c.edge_id FROM (SELECT * FROM compared WHERE before <> edge_id) c
        WHERE o.street_object_id = c.street_object_id)
    SELECT 'object_edge', count(*) FILTER (WHERE before IS NULL), count(*) FILTER (WHERE before <> edge_id),
        (SELECT count(*) FROM gone), count(*) FILTER (WHERE before = edge_id), 0::bigint FROM compared;
END

--{bus_stop_box
CREATE OR REPLACE VIEW bus_stop_box WITH (security_invoker = true) AS
WITH RECURSIVE stop_type AS (
    SELECT type FROM object_type WHERE type = 'bus_stop'
    UNION SELECT o.type FROM object_type o JOIN stop_type s ON o.parent = s.type)
SELECT o.street_object_id, e.edge_id, l.lane_id, e.level, CASE l.kind WHEN 'parking' THEN 'bay' ELSE 'mark' END AS kind,
    l.width, ST_Buffer(b.middle, l.width / 2, 'endcap=flat')::geometry(Polygon, {srid}) AS surface,
    streetgen._zigzag(b.middle, l.width)::geometry(MultiPolygon, {srid}) AS paint
FROM street_object o JOIN stop_type USING (type) JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id),
    LATERAL (SELECT * FROM lane l WHERE l.edge_id = e.edge_id AND l.kind IN ('general', 'bus', 'parking')
            AND l.method <> 'crossed_limits'
        ORDER BY abs(l.axis_offset - e.roadway_offset) * CASE WHEN (l.axis_offset > e.roadway_offset)
            = (streetgen._side_of_street(o.side, o.axis_offset, e.roadway_offset) = 'left') THEN 1 ELSE -1 END DESC
        LIMIT 1) l,
    LATERAL (SELECT value::float8 AS length FROM setting WHERE name = 'bus_stop_length') s,
    LATERAL (SELECT ST_Length2D(l.geom) AS whole, CASE WHEN l.along_axis THEN 1 ELSE -1 END AS ahead) w,
    -- Metres in the direction of the bus, from the start of the lane's line.
    LATERAL (SELECT ahead * whole * ST_LineLocatePoint(l.geom, o.geom) AS at) p,
    LATERAL (SELECT min(mouth - c.width / 2 - 1) FILTER (WHERE mouth >= at) AS before,
            max(mouth + c.width / 2 + 1) FILTER (WHERE mouth < at) AS behind
        FROM object_edge b JOIN pedestrian_crossing c USING (street_object_id)
            JOIN street_object there USING (street_object_id),
            LATERAL (SELECT ahead * whole * ST_LineLocatePoint(l.geom, there.geom) AS mouth) m
        WHERE b.edge_id = e.edge_id) c,
    LATERAL (SELECT least(at + 1, before, greatest(0, ahead * whole)) AS front) f,
    LATERAL (SELECT greatest(front - s.length, behind, least(0, ahead * whole)) AS back) k,
    LATERAL (SELECT ST_LineSubstring(l.geom, least(ahead * front, ahead * back) / whole,
        greatest(ahead * front, ahead * back) / whole) AS middle) b
WHERE front - back >= 5

--{refuge
#variable_conflict use_column
DECLARE
    -- Cars pass it on lanes so wide. It reaches so far beyond the crossing, and is so wide at least; metres.
    lane_least constant float8 := 2.5;
    nose constant float8 := 1.5;
    least_width constant float8 := 1;
    of_level constant integer := (SELECT level FROM axis a WHERE a.axis_id = axis);
    middle float8;
    room float8;
    place float8;
    run float8;
    island geometry;
    ground geometry;
BEGIN
    IF line IS NULL OR coalesce(wanted, 0) = 0 OR to_regclass('lane') IS NULL THEN
        RETURN NULL;
    END IF;
    -- A refuge lies between the lanes of both directions, as far as these can be narrower.
    SELECT (low + high) / 2, high - low + 2 * least(room_right, room_left) INTO middle, room
    FROM (SELECT max(left_offset) FILTER (WHERE on_right) AS low,
            min(right_offset) FILTER (WHERE NOT on_right) AS high,
            sum(spare) FILTER (WHERE on_right) AS room_right, sum(spare) FILTER (WHERE NOT on_right) AS room_left
        FROM (SELECT l.left_offset, l.right_offset, CASE WHEN l.kind IN ('general', 'bus', 'carpool')
                    THEN greatest(l.left_offset - l.right_offset - lane_least, 0) ELSE 0 END AS spare,
                avg(l.left_offset) OVER (PARTITION BY l.along_axis) < avg(l.left_offset) OVER () AS on_right
            FROM (SELECT l.kind, l.along_axis, streetgen._border_at(b.borders, e.at, 'left') AS left_offset,
                    -streetgen._border_at(b.borders, e.at, 'right') AS right_offset
                FROM (SELECT edge_id, _refuge.abscissa - start_abscissa AS at FROM edge e WHERE e.axis_id = axis
                        AND _refuge.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
                    ORDER BY start_abscissa LIMIT 1) e
                    JOIN lane l ON l.edge_id = e.edge_id AND l.kind <> 'merging' AND NOT l.both_ways,
                    LATERAL (SELECT streetgen._lane_borders(l.borders, l.width, l.axis_offset) AS borders) b) l) o) s
    WHERE high > low - 0.01;
    room := least(wanted, room);
    IF coalesce(room, 0) < least_width THEN
        RETURN NULL;
    END IF;
    -- A source may cut its way at the crossing: the refuge runs straight, beyond the end of its axis too.
    place := least(greatest(_refuge.abscissa + middle * cotd(angle), 0), ST_Length2D(line));
    run := greatest(_refuge.width / 2 + nose - room / 2, 0.1);
    SELECT ST_Buffer(ST_SetSRID(ST_MakeLine(ST_Translate(at, -east * run, -north * run),
        ST_Translate(at, east * run, north * run)), ST_SRID(line)), room / 2) INTO island
    FROM (SELECT streetgen._place_on(line::bytea, place, middle)::geometry AS at,
        streetgen._direction_on(line::bytea, place, 0) AS direction) p,
        LATERAL (SELECT sind(direction) AS east, cosd(direction) AS north) d;
    SELECT ST_Union(surface) INTO ground FROM roadway WHERE surface && island AND level = of_level;
    RETURN CASE WHEN ST_Covers(ground, island) THEN island END;
END
