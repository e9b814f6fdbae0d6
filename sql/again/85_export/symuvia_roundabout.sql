-- Roundabouts for SymuVia: a ring is one connection, whose edges lie within it.

CREATE OR REPLACE FUNCTION streetgen._symuvia_rings(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN NOT computed THEN $part$,
ring_node AS (SELECT 0::bigint AS node_id, 0::bigint AS place_id WHERE false),
ring_troncon AS (SELECT '' AS name WHERE false),
ring_movement AS (SELECT * FROM step WHERE false),
ring_element AS (SELECT 0::bigint AS place_id, ''::text AS name, '' AS troncons, 0 AS lanes, 0::float8 AS lane_width,
    0::float8 AS speed, NULL::xml AS inside WHERE false)$part$
    ELSE $part$,
-- In the order of traffic; the table runs counter-clockwise.
ring_edge AS MATERIALIZED (
    SELECT r.roundabout_id AS ring, r.centre, g.name, g.from_node, g.to_node, g.line, g.lane_count, g.lane_width,
        w.speed, keeps_right, CASE WHEN keeps_right THEN e.ordinality ELSE -e.ordinality END AS turn,
        count(*) OVER (PARTITION BY r.roundabout_id) AS edges
    FROM (SELECT value <> 'left' AS keeps_right FROM %1$I.setting WHERE name = 'driving_side') s
        CROSS JOIN %1$I.roundabout r
        JOIN %1$I.roundabout_edge e USING (roundabout_id)
        LEFT JOIN troncon g ON g.edge_id = e.edge_id AND g.along_axis = e.along_axis
        LEFT JOIN written_edge w ON w.edge_id = e.edge_id
    WHERE r.accepted),
at_ring AS MATERIALIZED (
    SELECT n.ring, t.name, t.edge_id, n.from_node AS node_id, n.turn, t.from_node = n.from_node AS leaves, n.centre,
        n.keeps_right,
        CASE WHEN t.from_node = n.from_node THEN ST_StartPoint(t.line) ELSE ST_EndPoint(t.line) END AS ends
    FROM ring_edge n JOIN troncon t ON n.from_node IN (t.from_node, t.to_node)
    WHERE NOT EXISTS (SELECT FROM ring_edge e WHERE e.ring = n.ring AND e.name = t.name)),
-- One lane group for each edge; all else at its nodes are arms, and none of these is of another ring or has signals.
whole_ring AS MATERIALIZED (
    SELECT ring, min(from_node) AS place_id FROM ring_edge e GROUP BY ring, edges
    HAVING count(DISTINCT name) = edges AND count(DISTINCT from_node) = edges AND count(DISTINCT to_node) = edges
        AND NOT EXISTS (SELECT FROM ring_edge n JOIN place p ON p.node_id = n.from_node
            WHERE n.ring = e.ring AND (p.place_id <> p.node_id OR p.kind = 'signals'))
        AND EXISTS (SELECT FROM at_ring a WHERE a.ring = e.ring)
        AND NOT EXISTS (SELECT FROM at_ring a WHERE a.ring = e.ring AND (a.name IN (SELECT name FROM ring_edge)
            OR NOT EXISTS (SELECT FROM %1$I.roundabout_arm m WHERE (m.roundabout_id, m.edge_id, m.node_id)
                = (a.ring, a.edge_id, a.node_id))))),
-- Round the centre from each node on, as traffic meets them.
ring_end AS MATERIALIZED (
    SELECT ring, name, node_id, row_number() OVER (PARTITION BY ring ORDER BY a.turn,
        mod((degrees(ST_Azimuth(centre, n.geom) - ST_Azimuth(centre, ends))::numeric + 900) * CASE WHEN keeps_right
            THEN 1 ELSE -1 END + 1800, 360), NOT leaves, name COLLATE "C") AS turn
    FROM at_ring a JOIN whole_ring USING (ring) JOIN %1$I.node n USING (node_id)),
-- Edges between which there is no arm are one piece; the first one begins at an arm.
ring_troncon AS MATERIALIZED (
    SELECT *, sum(begins) OVER (PARTITION BY ring ORDER BY step) AS piece
    FROM (SELECT *, mod(turn - min(turn) FILTER (WHERE begins = 1) OVER (PARTITION BY ring) + edges, edges) AS step
        FROM (SELECT e.*, place_id, EXISTS (SELECT FROM ring_end a WHERE (a.ring, a.node_id)
                = (e.ring, e.from_node))::integer AS begins FROM ring_edge e JOIN whole_ring USING (ring)) e) e),
ring_node AS MATERIALIZED (SELECT from_node AS node_id, place_id FROM ring_troncon),
-- From the lanes that come in, round the ring, to those that leave it.
ring_movement AS MATERIALIZED (
    WITH RECURSIVE round AS (
        SELECT r.place_id, s.name_in, s.lane_in, s.name_out, s.lane_out, s.sign FROM step s
            JOIN ring_node r ON r.node_id = s.place_id
        WHERE s.name_in NOT IN (SELECT name FROM ring_troncon)
        UNION SELECT r.place_id, r.name_in, r.lane_in, s.name_out, s.lane_out, r.sign
        FROM round r JOIN ring_troncon t ON t.name = r.name_out
            JOIN step s ON (s.name_in, s.lane_in) = (r.name_out, r.lane_out))
    SELECT place_id,
        row_number() OVER (ORDER BY name_in COLLATE "C", lane_in, name_out COLLATE "C", lane_out) AS way_id,
        name_in, lane_in, name_out, lane_out, NULL::geometry AS line, sign
    FROM round WHERE name_out NOT IN (SELECT name FROM ring_troncon)),
ring_piece AS (
    SELECT ring, piece, (array_agg(name ORDER BY step))[1] AS name,
        ST_RemoveRepeatedPoints(ST_MakeLine(line ORDER BY step)) AS line,
        (array_agg(from_node ORDER BY step))[1] AS from_node, (array_agg(to_node ORDER BY step DESC))[1] AS to_node
    FROM ring_troncon GROUP BY ring, piece),
ring_inside AS (
    SELECT p.ring, xmlagg(xmlelement(name "TRONCON_INTERNE", xmlattributes(p.name AS id, a.name AS troncon_amont,
        b.name AS troncon_aval, round(ST_Length(line)::numeric, 2) AS longueur,
        streetgen._symuvia_place(ST_StartPoint(line), x, y, digits) AS extremite_amont,
        streetgen._symuvia_place(ST_EndPoint(line), x, y, digits) AS extremite_aval),
        streetgen._symuvia_points(line, x, y, digits)::xml) ORDER BY p.piece) AS inside
    FROM origin, ring_piece p
        JOIN (SELECT DISTINCT ON (ring, node_id) * FROM ring_end ORDER BY ring, node_id, turn DESC) a
            ON (a.ring, a.node_id) = (p.ring, p.from_node)
        JOIN (SELECT DISTINCT ON (ring, node_id) * FROM ring_end ORDER BY ring, node_id, turn) b
            ON (b.ring, b.node_id) = (p.ring, p.to_node)
    GROUP BY p.ring),
ring_element AS (
    SELECT r.*, e.troncons, i.inside
    FROM (SELECT ring, place_id, 'G_' || ring AS name, max(lane_count) AS lanes,
            avg(lane_width ORDER BY step) AS lane_width, min(speed) AS speed
            FROM ring_troncon GROUP BY ring, place_id) r
        JOIN (SELECT ring, string_agg(name, ' ' ORDER BY turn) AS troncons FROM ring_end GROUP BY ring) e USING (ring)
        JOIN ring_inside i USING (ring))$part$ END $$;
COMMENT ON FUNCTION streetgen._symuvia_rings(boolean) IS
    'Queries of the network of SymuVia over a model, after troncon and step: ring_node, the nodes of rings with the '
    'place that stands for each; ring_troncon, their lane groups; ring_movement, the ways of traffic from arm to arm, '
    'as those of step are; ring_element, what a GIRATOIRE says. A ring is one where roundabouts are computed and this '
    'one is accepted, each of its edges is written and has one lane group, no signals stand there, and it shares no '
    'node with another; the nodes of others are places like all.';
