-- Places of junctions of one model by kind, in order of md5(place), whoever computed the model: psql -v model=NAME -f tests/measure/fixed_draw.sql
-- The kinds follow from the axes and the network alone: `crossing` (four legs, no other junction within 30 m), `dual` (two carriageways of one
-- name that one street crosses), `roundabout` (a ring of the source), `slip` (a one-way edge across the corner of two others).
-- Two places of a kind are 60 m apart at least. A row: md5, kind, model, east, north, all metres of the model's reference.
\pset format unaligned
\pset tuples_only on
SET client_min_messages = warning;
CREATE TEMPORARY TABLE leg AS
SELECT e.edge_id, e.axis_id, e.level, a.direction <> 'both' AS one_way, a.name, a.roundabout_tag IS NOT NULL AS ring, ST_Length(e.geom) AS length, l.*
FROM :"model".edge e JOIN :"model".axis a USING (axis_id),
    LATERAL (VALUES (e.from_node, e.to_node, e.geom, a.direction = 'direct'), (e.to_node, e.from_node, ST_Reverse(e.geom), a.direction = 'reverse')) l(node, other, geom, leaves)
WHERE e.from_node <> e.to_node;
CREATE INDEX ON leg (node);
CREATE TEMPORARY TABLE node AS SELECT node_id, n.geom, count(*) AS degree FROM :"model".node n JOIN leg l ON l.node = node_id GROUP BY node_id, n.geom;
CREATE INDEX ON node USING gist (geom);
CREATE TEMPORARY TABLE found AS
SELECT 'crossing' AS kind, geom FROM node n WHERE degree = 4
    AND NOT EXISTS (SELECT FROM node o WHERE o.node_id <> n.node_id AND o.degree > 2 AND ST_DWithin(o.geom, n.geom, 30))
UNION ALL
-- From `here` to `there` along the street that crosses; one carriageway leaves here, the other comes in there.
SELECT 'dual', ST_Centroid(ST_Collect(here.geom, there.geom))
FROM leg across JOIN node here ON here.node_id = across.node JOIN node there ON there.node_id = across.other
WHERE across.length BETWEEN 4 AND 35 AND NOT across.ring AND across.node < across.other
    AND EXISTS (SELECT FROM leg a JOIN leg b ON b.node = across.other AND b.name = a.name
        WHERE a.node = across.node AND a.one_way AND b.one_way AND a.leaves <> b.leaves AND a.name IS DISTINCT FROM across.name
            AND ST_Distance(ST_LineInterpolatePoint(a.geom, least(1, 20 / a.length)), ST_LineInterpolatePoint(b.geom, least(1, 20 / b.length))) BETWEEN 4 AND 35)
UNION ALL
SELECT 'roundabout', ST_Centroid(geom) FROM (
    SELECT ST_Collect(geom) AS geom FROM (SELECT geom, ST_ClusterDBSCAN(geom, 1, 1) OVER () AS ring FROM :"model".axis WHERE roundabout_tag = 'roundabout') r GROUP BY ring) r
UNION ALL
SELECT 'slip', ST_Centroid(ST_Collect(ARRAY[b.geom, e.geom, c.geom]))
FROM leg slip JOIN node b ON b.node_id = slip.node JOIN node e ON e.node_id = slip.other JOIN leg f ON f.node = slip.node JOIN leg g ON g.node = slip.other AND g.other = f.other
    JOIN node c ON c.node_id = f.other
WHERE slip.one_way AND slip.leaves AND NOT slip.ring AND NOT f.ring AND NOT g.ring AND slip.length BETWEEN 12 AND 80 AND f.length < 60 AND g.length < 60
    AND f.edge_id <> slip.edge_id AND g.edge_id <> slip.edge_id AND f.edge_id <> g.edge_id AND c.degree > 2
    AND abs(degrees(ST_Angle(c.geom, b.geom, c.geom, e.geom)) - 180) BETWEEN 40 AND 140
    -- One goes on to the crossing by the street that the lane leaves, too.
    AND (NOT f.one_way OR f.leaves);
WITH place AS (SELECT kind, round(ST_X(geom)) AS east, round(ST_Y(geom)) AS north, ST_ClusterDBSCAN(geom, 60, 1) OVER (PARTITION BY kind) AS same FROM found),
    one AS (SELECT DISTINCT ON (kind, same) kind, east, north FROM place ORDER BY kind, same, east, north)
SELECT md5(:'model' || ' ' || east || ' ' || north), kind, :'model', east, north FROM one ORDER BY 1;
