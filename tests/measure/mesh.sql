-- The roadway of a model as triangles (streetgen.road_mesh), held against its profiles; psql -v model=NAME -f
-- tests/measure/mesh.sql. A model computes height. thin: triangles whose least height in the plane is under 1 cm. off:
-- places of profiles, every 2 m, over whose own surface the mesh lies over 0.05 m above or below; over 2 m. seams: ends
-- of limits at which two surfaces of different levels touch at their node, and those that have no common vertex there.
CREATE TEMP TABLE meshed AS
SELECT row_number() OVER () AS id, m.edge_id, m.node_id, m.level, t.geom, ST_Force2D(t.geom)::geometry AS flat
FROM streetgen.road_mesh(:'model') m, LATERAL (SELECT ST_GeomFromEWKT(replace(ST_AsEWKT((ST_Dump(m.geom)).geom),
    'TRIANGLE', 'POLYGON')) AS geom) t;
CREATE INDEX ON meshed USING gist (flat);
CREATE TEMP TABLE corner_of AS
SELECT id, ST_X(a) AS ax, ST_Y(a) AS ay, ST_Z(a) AS az, ST_X(b) AS bx, ST_Y(b) AS by, ST_Z(b) AS bz, ST_X(c) AS cx,
    ST_Y(c) AS cy, ST_Z(c) AS cz
FROM (SELECT id, ST_PointN(r, 1) AS a, ST_PointN(r, 2) AS b, ST_PointN(r, 3) AS c
    FROM (SELECT id, ST_ExteriorRing(geom) AS r FROM meshed) m) p;
CREATE INDEX ON corner_of (id);
ANALYZE meshed, corner_of;
SELECT count(*) AS triangles, count(*) FILTER (WHERE thin < 0.01) AS thin,
    round(100.0 * avg((thin < 0.01)::integer), 2) AS percent
FROM (SELECT abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / greatest(sqrt((bx - ax) ^ 2 + (by - ay) ^ 2),
    sqrt((cx - ax) ^ 2 + (cy - ay) ^ 2), sqrt((cx - bx) ^ 2 + (cy - by) ^ 2)) AS thin FROM corner_of) t;
CREATE TEMP TABLE place_of AS
SELECT p.edge_id, e.level, e.from_node, e.to_node, g.geom FROM :"model".profile p JOIN :"model".edge e USING (edge_id),
    LATERAL (SELECT greatest(1, ceil(ST_Length(p.geom) / 2))::integer AS steps) s,
    LATERAL (SELECT ST_LineInterpolatePoint(p.geom, n::float8 / steps) AS geom FROM generate_series(1, steps - 1) n) g;
SELECT count(*) AS places, count(*) FILTER (WHERE off > 0.05) AS off, count(*) FILTER (WHERE off > 2) AS over_2_m
FROM (SELECT p.edge_id, min(abs(ST_Z(p.geom) - ((1 - u - v) * az + u * bz + v * cz))) AS off
    FROM place_of p JOIN meshed m ON m.flat && p.geom
        AND (m.edge_id = p.edge_id OR m.node_id IN (p.from_node, p.to_node))
        AND ST_Covers(m.flat, ST_Force2D(p.geom)) JOIN corner_of USING (id),
        LATERAL (SELECT (bx - ax) * (cy - ay) - (cx - ax) * (by - ay) AS twice) d,
        LATERAL (SELECT ((ST_X(p.geom) - ax) * (cy - ay) - (cx - ax) * (ST_Y(p.geom) - ay)) / twice AS u,
            ((bx - ax) * (ST_Y(p.geom) - ay) - (ST_X(p.geom) - ax) * (by - ay)) / twice AS v) w
    WHERE twice <> 0 GROUP BY p.edge_id, p.geom) o;
WITH seam AS (
    SELECT l.edge_id, n.node_id, ST_Force2D(p.geom) AS place
    FROM :"model".section_limit l JOIN :"model".edge e USING (edge_id)
        JOIN :"model".section s USING (edge_id) JOIN :"model".intersection n
            ON n.node_id = CASE l.which WHEN 'start' THEN e.from_node ELSE e.to_node END AND n.level <> s.level,
        LATERAL (VALUES (ST_StartPoint(l.border_line)), (ST_EndPoint(l.border_line))) p(geom)
    WHERE ST_DWithin(s.surface, p.geom, 1e-4) AND ST_DWithin(n.surface, p.geom, 1e-4))
SELECT count(*) AS seams, count(*) FILTER (WHERE NOT shared) AS without_common_vertex
FROM (SELECT EXISTS (SELECT FROM meshed a, ST_DumpPoints(a.geom) x, meshed b, ST_DumpPoints(b.geom) y
        WHERE a.flat && ST_Expand(place, 1e-4) AND b.flat && ST_Expand(place, 1e-4) AND a.edge_id = s.edge_id
            AND b.node_id = s.node_id AND ST_DWithin(x.geom, place, 1e-4) AND ST_DWithin(y.geom, place, 1e-4)
            AND ST_3DDistance(x.geom, y.geom) < 1e-3) AS shared FROM seam s) t;
