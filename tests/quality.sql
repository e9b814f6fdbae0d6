-- The figures of docs/quality.md for one model: psql -v model=NAME -f tests/quality.sql
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SELECT set_config('quality.model', :'model', false) \g /dev/null
CREATE TEMPORARY TABLE surface AS SELECT 'section' AS kind, s.edge_id AS id, s.level, s.surface, s.method FROM :"model".section s WHERE NOT ST_IsEmpty(surface)
    UNION ALL SELECT 'intersection', node_id, level, surface, method FROM :"model".intersection WHERE NOT ST_IsEmpty(surface);
CREATE INDEX ON surface USING gist (surface);
ANALYZE surface;
CREATE TEMPORARY TABLE degree AS SELECT node_id, count(*) AS degree FROM (SELECT from_node AS node_id FROM :"model".edge UNION ALL SELECT to_node FROM :"model".edge) e GROUP BY node_id;
SELECT '| ' || :'model', (SELECT count(*) FROM :"model".axis),
    (SELECT round(100.0 * count(*) FILTER (WHERE NOT ST_IsEmpty(i.surface) AND ST_IsValid(i.surface)) / nullif(count(*), 0), 2) FROM degree d LEFT JOIN :"model".intersection i USING (node_id) WHERE degree >= 3),
    (SELECT round(100.0 * count(*) FILTER (WHERE ST_IsValid(surface)) / count(*), 2) FROM surface),
    (SELECT round(100.0 * count(*) FILTER (WHERE k.method = 'no_arc') / nullif(count(*), 0), 2) FROM :"model".corner k JOIN :"model".edge a ON a.edge_id = edge_a JOIN :"model".edge b ON b.edge_id = edge_b
        CROSS JOIN LATERAL (SELECT degrees(ST_Azimuth(ST_StartPoint(g), ST_LineInterpolatePoint(g, least(1, 1 / ST_Length(g))))) AS az FROM (SELECT CASE end_a WHEN 'start' THEN a.geom ELSE ST_Reverse(a.geom) END AS g) q) u
        CROSS JOIN LATERAL (SELECT degrees(ST_Azimuth(ST_StartPoint(g), ST_LineInterpolatePoint(g, least(1, 1 / ST_Length(g))))) AS az FROM (SELECT CASE end_b WHEN 'start' THEN b.geom ELSE ST_Reverse(b.geom) END AS g) q) v
        WHERE (u.az - v.az + 720)::numeric % 360 < 160),
    (SELECT round((100 * coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) / (SELECT sum(ST_Area(surface)) FROM surface))::numeric, 5)
        FROM surface a JOIN surface b ON a.surface && b.surface AND a.level = b.level AND (a.kind, a.id) < (b.kind, b.id)),
    (SELECT round((100 * sum(ST_Length(ST_Intersection(e.geom, c.ground))) / sum(ST_Length(e.geom)))::numeric, 3)
        FROM (SELECT edge_id, ST_Force2D(geom) AS geom, level FROM :"model".edge) e
        CROSS JOIN LATERAL (SELECT ST_Union(s.surface) AS ground FROM surface s WHERE s.surface && e.geom) c),
    (SELECT round((100.0 * sum(CASE WHEN s.kind = 'intersection' AND s.method = 'contested' OR s.method = 'contested' THEN 1 ELSE 0 END) / count(*))::numeric, 2) FROM surface s) || ' |';
