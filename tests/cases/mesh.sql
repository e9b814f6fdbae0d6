-- The mesh of a real model. Variable: model. Each row is a truth: its name, and t where it holds.
CREATE TEMPORARY TABLE ground AS
SELECT edge_id, NULL::bigint AS node_id, level, surface FROM :"model".section WHERE NOT ST_IsEmpty(surface) UNION ALL SELECT NULL, node_id, level, surface FROM :"model".intersection WHERE NOT ST_IsEmpty(surface);
CREATE TEMPORARY TABLE triangle AS
SELECT edge_id, node_id, level, ARRAY[a, b, c] AS corner, ((ST_X(b) - ST_X(a)) * (ST_Y(c) - ST_Y(a)) - (ST_X(c) - ST_X(a)) * (ST_Y(b) - ST_Y(a))) / 2 AS area
FROM streetgen.road_mesh(:'model'), ST_Dump(geom) t, LATERAL (SELECT ST_ExteriorRing(t.geom) AS r) s, LATERAL (SELECT ST_PointN(r, 1) AS a, ST_PointN(r, 2) AS b, ST_PointN(r, 3) AS c) p;
SELECT 'triangles of the mesh are counter-clockwise', bool_and(area > 0) FROM triangle;
SELECT 'each surface has the area of its triangles', count(*) = count(covered) AND bool_and(abs(covered - ST_Area(surface)) <= 5e-6 * ST_Perimeter(surface))
FROM ground g LEFT JOIN (SELECT edge_id, node_id, sum(area) AS covered FROM triangle GROUP BY 1, 2) t ON (g.edge_id = t.edge_id OR g.node_id = t.node_id);
SELECT 'a side of a triangle has one other triangle at most, the other way', bool_and(uses = 1 OR uses = 2 AND forwards = 1) FROM (
    SELECT count(*) AS uses, count(*) FILTER (WHERE a < b) AS forwards FROM (SELECT level, ST_AsBinary(corner[k]) AS a, ST_AsBinary(corner[k % 3 + 1]) AS b FROM triangle, generate_series(1, 3) k) s
    GROUP BY level, least(a, b), greatest(a, b)) u;
