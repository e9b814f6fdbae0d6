-- The accepted rings of a model as they are drawn: psql -v model=M -f tests/measure/roundabouts_drawn.sql, of a model with subjects interconnection and roundabout.
-- Each line counts the rings, corners or ways for which a truth holds, of all; then come those for which none does, to be looked at.
\set ON_ERROR_STOP on
\set QUIET on
\pset footer off
SET client_min_messages = warning;
BEGIN;
CREATE TEMP TABLE ring ON COMMIT DROP AS
SELECT r.*, (SELECT max(face) FROM :"model".roundabout_edge e WHERE e.roundabout_id = r.roundabout_id) AS faces FROM :"model".roundabout r WHERE accepted;
CREATE TEMP TABLE ring_edge ON COMMIT DROP AS
SELECT roundabout_id, e.edge_id, n.along_axis, e.from_node, e.to_node, a.direction <> 'both' AND (a.direction = 'direct') <> n.along_axis AS against
FROM ring JOIN :"model".roundabout_edge n USING (roundabout_id) JOIN :"model".edge e ON e.edge_id = n.edge_id JOIN :"model".axis_used a USING (axis_id);
CREATE TEMP TABLE ring_node ON COMMIT DROP AS SELECT DISTINCT roundabout_id, unnest(ARRAY[from_node, to_node]) AS node_id FROM ring_edge;
CREATE INDEX ON ring_edge (edge_id);
CREATE INDEX ON ring_node (node_id);
ANALYZE ring_edge;
ANALYZE ring_node;
CREATE TEMP TABLE way ON COMMIT DROP AS
SELECT n.roundabout_id, i.interconnection_id, i.lane_in, i.lane_out, i.along_in, i.along_out, a.edge_id AS edge_in, b.edge_id AS edge_out, i.geom
FROM ring_node n JOIN :"model".interconnection i USING (node_id) JOIN :"model".lane a ON a.lane_id = i.lane_in JOIN :"model".lane b ON b.lane_id = i.lane_out WHERE i.plausible;
-- An arc touches a kerb where its radius points to the nearest place of the axis; of streets of one width along them.
CREATE TEMP TABLE touch ON COMMIT DROP AS
SELECT DISTINCT ON (c.corner_id, k.edge_id) n.roundabout_id, c.corner_id, k.place,
    degrees(abs(asin(greatest(-1, least(1, sin(ST_Azimuth(place, c.centre) - ST_Azimuth(place, ST_ClosestPoint(e.geom, place)))))))) AS degrees
FROM ring_node n JOIN :"model".corner c USING (node_id), LATERAL (VALUES (edge_a, ST_StartPoint(arc)), (edge_a, ST_EndPoint(arc)), (edge_b, ST_StartPoint(arc)), (edge_b, ST_EndPoint(arc))) k(edge_id, place)
    JOIN :"model".edge e ON e.edge_id = k.edge_id
WHERE c.arc IS NOT NULL AND c.method = 'hypothesis' AND c.edge_a <> c.edge_b AND e.width = e.width_end AND e.roadway_offset = 0
-- The end of the arc that lies on this street.
ORDER BY c.corner_id, k.edge_id, abs(ST_Distance(e.geom, place) - e.width / 2);
-- From each arm by which one comes, round the ring, to those by which one leaves; between its nodes one may change lanes.
CREATE TEMP TABLE reached ON COMMIT DROP AS
WITH RECURSIVE round AS (
    SELECT w.roundabout_id, edge_in AS comes, along_out, edge_out FROM way w WHERE NOT EXISTS (SELECT FROM ring_edge r WHERE (r.roundabout_id, r.edge_id) = (w.roundabout_id, w.edge_in))
    UNION SELECT w.roundabout_id, comes, w.along_out, w.edge_out
    FROM round d JOIN ring_edge r ON (r.roundabout_id, r.edge_id) = (d.roundabout_id, d.edge_out)
        JOIN way w ON (w.roundabout_id, w.edge_in, w.along_in) = (d.roundabout_id, d.edge_out, d.along_out))
SELECT DISTINCT roundabout_id, comes, edge_out AS leaves FROM round d WHERE NOT EXISTS (SELECT FROM ring_edge r WHERE (r.roundabout_id, r.edge_id) = (d.roundabout_id, d.edge_out));
CREATE TEMP TABLE pair ON COMMIT DROP AS
WITH arm AS (SELECT DISTINCT a.roundabout_id, a.edge_id, l.along_axis = a.along_axis OR both_ways AS comes, l.along_axis <> a.along_axis OR both_ways AS leaves
    FROM ring JOIN :"model".roundabout_arm a USING (roundabout_id) JOIN :"model".lane l ON l.edge_id = a.edge_id WHERE l.kind = 'general')
SELECT i.roundabout_id, i.edge_id AS comes, o.edge_id AS leaves, r.comes IS NOT NULL AS joined
FROM arm i JOIN arm o USING (roundabout_id) LEFT JOIN reached r ON (r.roundabout_id, r.comes, r.leaves) = (i.roundabout_id, i.edge_id, o.edge_id)
WHERE i.comes AND o.leaves AND i.edge_id <> o.edge_id;
CREATE TEMP TABLE truth ON COMMIT DROP AS
SELECT 1 AS place, 'its line is closed and simple' AS says, ST_IsClosed(geom) AND ST_IsSimple(geom) AS holds, roundabout_id, NULL::geometry AS at FROM ring
UNION ALL SELECT 2, 'an island in each face, valid, or none (mini)', ST_IsValid(island) AND (ST_NumGeometries(island) = faces OR ST_IsEmpty(island) AND kind = 'mini'), roundabout_id, NULL FROM ring
UNION ALL SELECT 3, 'no roadway of the ring on the island', NOT EXISTS (SELECT FROM ring_edge e JOIN :"model".section s USING (edge_id) WHERE e.roundabout_id = r.roundabout_id AND ST_Area(ST_Intersection(s.surface, island)) > 0.1), roundabout_id, NULL FROM ring r
UNION ALL SELECT 4, 'arcs of arms are tangent to a degree', degrees <= 1, roundabout_id, place FROM touch
UNION ALL SELECT 5, 'no path against the ring, unless the source says so', NOT EXISTS (SELECT FROM way w JOIN ring_edge e ON (e.roundabout_id, e.edge_id) = (w.roundabout_id, w.edge_out)
    WHERE w.roundabout_id = r.roundabout_id AND w.along_out <> e.along_axis AND NOT e.against
        AND NOT EXISTS (SELECT FROM ring_edge o WHERE o.edge_id = e.edge_id AND o.along_axis <> e.along_axis)), roundabout_id, NULL FROM ring r
UNION ALL SELECT 6, 'a way from an arm to another one', joined, roundabout_id, (SELECT ST_StartPoint(geom) FROM :"model".edge e WHERE e.edge_id = comes) FROM pair;
SELECT says, count(*) FILTER (WHERE holds) AS holds, count(*) AS of, count(DISTINCT roundabout_id) FILTER (WHERE NOT holds) AS rings_without FROM truth GROUP BY place, says ORDER BY place;
SELECT says, kind, round(radius) AS radius, ST_X(centre)::bigint AS x, ST_Y(centre)::bigint AS y, n FROM (SELECT place, says, roundabout_id, count(*) AS n, row_number() OVER (PARTITION BY place ORDER BY count(*) DESC, roundabout_id) AS i
    FROM truth WHERE NOT holds GROUP BY place, says, roundabout_id) t JOIN ring USING (roundabout_id) WHERE i <= 8 ORDER BY place, i;
ROLLBACK;
