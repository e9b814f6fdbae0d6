-- Ground that overlaps on one level goes to intersections before sections, then to the smaller key: each point has one owner, as in model `timed`.
DROP TABLE IF EXISTS plain.surface, plain.tile;
CREATE TABLE plain.surface AS
SELECT row_number() OVER (ORDER BY turn, key) AS surface_id, turn, key, level, surface
FROM (SELECT 1 AS turn, node_id AS key, min(level) AS level, surface FROM plain.intersection JOIN plain.arm USING (node_id) JOIN timed.edge USING (edge_id) WHERE surface IS NOT NULL GROUP BY node_id, surface
      UNION ALL SELECT 2, edge_id, level, s.surface FROM plain.section s JOIN timed.edge USING (edge_id)) s;
CREATE INDEX ON plain.surface USING gist (surface);
ANALYZE plain.surface;
CREATE TABLE plain.tile AS
SELECT a.surface_id, turn, key, CASE WHEN taken IS NULL THEN surface ELSE ST_Difference(surface, taken) END AS surface
FROM plain.surface a, LATERAL (SELECT ST_Union(b.surface) AS taken FROM plain.surface b WHERE b.surface && a.surface AND b.surface_id < a.surface_id AND b.level = a.level) b;
SELECT count(*) AS rows FROM plain.tile \gset
