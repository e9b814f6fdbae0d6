-- Kerbs that lack the sidewalk of their street: psql -v model=NAME -f tests/measure/sidewalk_gaps.sql
-- Prints model, and of kerbs of at least 0.01 m beside streets with sidewalks the number and those without one:
-- straight kerbs, corner kerbs between two streets with sidewalks, and corners between a street that has one and a
-- street that has none, of which no kerb has one though one begins there. Last: sidewalks of less than 0.01 m2.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
CREATE TEMPORARY TABLE kerb_of_street AS
SELECT k.edge_id, k.node_id, k.side, k.part, w.own, w.other, s.sidewalk_id, k.geom
FROM :"model".kerb k JOIN :"model".edge e USING (edge_id)
    LEFT JOIN :"model".corner c ON (c.node_id, c.edge_a) = (k.node_id, k.edge_id) AND 'corner_at_' || c.end_a = k.side
    LEFT JOIN :"model".edge b ON b.edge_id = c.edge_b
    LEFT JOIN :"model".sidewalk s ON (s.edge_id, s.side, s.part) = (k.edge_id, k.side, k.part)
    CROSS JOIN LATERAL (SELECT
        CASE WHEN k.side IN ('left', 'corner_at_start') THEN e.sidewalk_left ELSE e.sidewalk_right END AS own,
        CASE c.end_b WHEN 'start' THEN b.sidewalk_right ELSE b.sidewalk_left END AS other) w
WHERE k.beside = 'outer' AND k.method <> 'level_change' AND ST_Length(k.geom) >= 0.01
    AND (k.side IN ('left', 'right') OR c.edge_a <> c.edge_b);
CREATE INDEX ON kerb_of_street USING gist (geom);
CREATE TEMPORARY TABLE ending AS
SELECT edge_id, node_id, side, bool_or(sidewalk_id IS NOT NULL) AS has_one
FROM kerb_of_street c WHERE (own > 0) <> (other > 0) GROUP BY 1, 2, 3
HAVING bool_or(EXISTS (SELECT FROM kerb_of_street k WHERE k.node_id IS NULL AND k.sidewalk_id IS NOT NULL
    AND k.geom && ST_Expand(c.geom, 1e-3) AND (ST_DWithin(ST_StartPoint(k.geom), ST_EndPoint(c.geom), 1e-3)
        OR ST_DWithin(ST_EndPoint(k.geom), ST_StartPoint(c.geom), 1e-3))));
SELECT :'model', count(*) FILTER (WHERE node_id IS NULL AND own > 0) AS straight,
    count(*) FILTER (WHERE node_id IS NULL AND own > 0 AND sidewalk_id IS NULL) AS straight_without,
    count(*) FILTER (WHERE own > 0 AND other > 0) AS between,
    count(*) FILTER (WHERE own > 0 AND other > 0 AND sidewalk_id IS NULL) AS between_without,
    (SELECT count(*) FROM ending) AS ending, (SELECT count(*) FROM ending WHERE NOT has_one) AS ending_without,
    (SELECT count(*) FROM :"model".sidewalk WHERE ST_Area(surface) < 0.01) AS crumbs
FROM kerb_of_street;
