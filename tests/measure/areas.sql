-- Areas of the street of a model with subject footway: psql -v model=MODEL
-- Printed: areas with ground, and square kilometres of it; ground that they share with other surfaces of their level,
-- m2, and pairs that share over 1 dm2; holes under 0.5 m2 at their rims that are a millimetre wide or more. Borders
-- lie on a grid of 0.1 mm.
SET search_path = :"model", public;
CREATE TEMPORARY TABLE ground AS
    SELECT 'area' AS of, street_area_id AS id, level, surface FROM area_surface
    UNION ALL SELECT 'footway', footway_id, level, surface FROM footway_surface
    UNION ALL SELECT 'section', edge_id, e.level, s.surface FROM section s JOIN edge e USING (edge_id)
    UNION ALL SELECT 'intersection', node_id, level, surface FROM intersection
    UNION ALL SELECT 'sidewalk', sidewalk_id, k.level, s.surface
        FROM sidewalk s JOIN kerb k USING (edge_id, side, part);
CREATE INDEX ON ground USING gist (surface);
WITH around AS (
    SELECT a.id, a.level, g.whole FROM ground a, LATERAL (SELECT ST_Union(o.surface, 0.0001) AS whole FROM ground o
        WHERE o.surface && a.surface AND o.level = a.level) g WHERE a.of = 'area'),
hole AS (
    SELECT DISTINCT ST_SnapToGrid(ST_Centroid(p.geom), 0.001) AS place
    FROM around n JOIN ground a ON a.of = 'area' AND a.id = n.id, ST_Dump(n.whole) w, ST_DumpRings(w.geom) p
    WHERE p.path[1] > 0 AND ST_Area(p.geom) < 0.5
        AND 2 * ST_Area(p.geom) > 0.001 * ST_Perimeter(p.geom) AND ST_DWithin(p.geom, a.surface, 0.001)),
shared AS (
    SELECT ST_Area(ST_Intersection(a.surface, o.surface)) AS m2 FROM ground a JOIN ground o ON o.surface && a.surface
        AND o.level = a.level AND (o.of, o.id) <> (a.of, a.id) AND (o.of <> 'area' OR o.id < a.id) WHERE a.of = 'area')
SELECT (SELECT count(*) FROM ground WHERE of = 'area') AS areas,
    (SELECT round(sum(ST_Area(surface))::numeric / 1e6, 4) FROM ground WHERE of = 'area') AS km2,
    (SELECT round(sum(m2)::numeric, 3) FROM shared) AS shared_m2,
    (SELECT count(*) FROM shared WHERE m2 > 0.01) AS pairs_over_a_square_decimetre,
    (SELECT count(*) FROM hole) AS holes;
