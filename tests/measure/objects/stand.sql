-- What objects of rules stand on: psql -v model=MODEL. A row a measure: how many break it, and of how many. Surfaces and axes alone tell.
SET search_path = :"model", public;
CREATE TEMP TABLE thing AS SELECT o.street_object_id AS id, o.type, o.geom, o.placed_by, o.rule_id, o.axis_id, o.side, o.abscissa, e.edge_id, e.level
    FROM street_object o JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id) WHERE o.type NOT IN ('crossing', 'parking_bay', 'arrow', 'manhole', 'runway_light');
CREATE INDEX ON thing USING gist (geom);
CREATE TEMP TABLE ruled AS SELECT * FROM thing WHERE placed_by = 'rule';
CREATE INDEX ON ruled USING gist (geom);
CREATE TEMP TABLE paved AS SELECT surface, e.level FROM section JOIN edge e USING (edge_id) UNION ALL SELECT surface, level FROM intersection;
CREATE INDEX ON paved USING gist (surface);
CREATE TEMP TABLE crossed AS SELECT c.surface, e.level, c.width, l.at, l.ahead FROM pedestrian_crossing c JOIN street_object o USING (street_object_id) JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id)
    JOIN axis a ON a.axis_id = o.axis_id, LATERAL (SELECT least(1, o.abscissa / ST_Length(a.geom)) AS share) s, LATERAL (SELECT ST_Azimuth(ST_LineInterpolatePoint(a.geom, greatest(0, share - 0.001)),
    ST_LineInterpolatePoint(a.geom, least(1, share + 0.001))) - radians(c.angle - 90) AS ahead, ST_Force2D(ST_LineInterpolatePoint(a.geom, share)) AS at) l WHERE c.surface IS NOT NULL;
CREATE INDEX ON crossed USING gist (surface);
ANALYZE thing, ruled, paved, crossed;
SET enable_hashjoin = off;
SET enable_mergejoin = off;
CREATE TEMP TABLE broken AS
SELECT DISTINCT 'in a roadway' AS measure, r.id FROM ruled r JOIN paved p ON p.surface && r.geom AND p.level - r.level = 0 AND ST_Contains(p.surface, r.geom) AND ST_Distance(ST_Boundary(p.surface), r.geom) > 0.01
UNION SELECT 'in a bay', r.id FROM ruled r JOIN parking_bay b ON b.surface && r.geom AND ST_Contains(b.surface, r.geom) JOIN street_object o USING (street_object_id) JOIN axis a ON a.axis_id = o.axis_id AND a.level - r.level = 0
UNION SELECT 'in the mouth of a crossing', r.id FROM ruled r JOIN crossed c ON ST_DWithin(c.surface, r.geom, 3) AND c.level - r.level = 0
    AND abs((ST_X(r.geom) - ST_X(c.at)) * sin(c.ahead) + (ST_Y(r.geom) - ST_Y(c.at)) * cos(c.ahead)) < c.width / 2
UNION SELECT 'on another of its kind, under 1 m', r.id FROM ruled r JOIN thing t ON ST_DWithin(t.geom, r.geom, 1) AND t.id <> r.id AND t.type = r.type AND t.level - r.level = 0 AND (t.rule_id, t.axis_id, t.side) IS DISTINCT FROM (r.rule_id, r.axis_id, r.side)
    AND (t.placed_by <> 'rule' OR (t.rule_id, t.axis_id) < (r.rule_id, r.axis_id) OR (t.rule_id, t.axis_id) = (r.rule_id, r.axis_id) AND t.id < r.id)
UNION SELECT 'lamp under 15 m from one of another street', r.id FROM ruled r JOIN thing t ON r.type = 'lamp' AND t.type = 'lamp' AND ST_DWithin(t.geom, r.geom, 15) AND t.level - r.level = 0
    AND (t.placed_by <> 'rule' OR t.axis_id < r.axis_id)
UNION SELECT 'tree under 3 m from a lamp', r.id FROM ruled r JOIN thing t ON r.type = 'tree' AND t.type = 'lamp' AND ST_DWithin(t.geom, r.geom, 3) AND t.level - r.level = 0
UNION SELECT 'tree under 5 m from a crossing', r.id FROM ruled r JOIN crossed c ON r.type = 'tree' AND c.level - r.level = 0 AND ST_DWithin(c.surface, r.geom, 5)
UNION SELECT 'under 5 m from a stop or yield line', r.id FROM ruled r JOIN marking m ON m.kind IN ('stop', 'yield') AND ST_DWithin(m.geom, r.geom, 5) AND NOT ST_IsEmpty(m.surface) JOIN edge e ON e.edge_id = m.edge_id AND e.level - r.level = 0
UNION SELECT 'on a level below the ground', r.id FROM ruled r WHERE r.level < 0
-- Behind strips such as cycle tracks, and behind bays beside the roadway, things stand farther away.
UNION SELECT 'farther from a kerb than 2.5 m', r.id FROM ruled r JOIN axis a USING (axis_id)
    WHERE num_nonnulls(a.strips_left, a.strips_right, a.parking_left, a.parking_right) = 0 AND NOT EXISTS (SELECT FROM kerb k WHERE k.level - r.level = 0 AND k.method <> 'level_change' AND ST_DWithin(k.geom, r.geom, 2.5))
UNION SELECT 'tree on a median under 3 m', r.id FROM ruled r WHERE r.type = 'tree' AND (SELECT k.beside = 'median' FROM kerb k WHERE k.level - r.level = 0 AND ST_DWithin(k.geom, r.geom, 3) ORDER BY ST_Distance(k.geom, r.geom) LIMIT 1)
    AND (SELECT sum(d) FROM (SELECT ST_Distance(p.surface, r.geom) AS d FROM paved p WHERE p.level - r.level = 0 AND ST_DWithin(p.surface, r.geom, 3)
        AND p.surface && r.geom IS NOT NULL ORDER BY 1 LIMIT 1) x) < 3 AND EXISTS (SELECT FROM section s JOIN edge e USING (edge_id) WHERE e.axis_id <> r.axis_id AND e.level - r.level = 0 AND ST_DWithin(s.surface, r.geom, 1.8));
SELECT measure, count(*) AS broken, (SELECT count(*) FROM ruled) AS objects FROM broken GROUP BY measure ORDER BY measure;
SELECT 'objects that break none' AS measure, count(*) AS objects, (SELECT count(*) FROM ruled) AS of FROM ruled WHERE id NOT IN (SELECT id FROM broken);
SELECT 'bays', count(*) FROM parking_bay;
