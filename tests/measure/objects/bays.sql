-- What bays of rules lie on and what they leave: psql -v model=MODEL. A row a measure: how many break it, and of how many. Surfaces, axes and kinds of lanes alone tell.
SET search_path = :"model", public;
CREATE TEMP TABLE bay AS SELECT o.street_object_id AS id, o.axis_id, o.side, o.abscissa, b.surface, b.length, b.angle, e.edge_id, e.level, a.direction, coalesce(r.along, 'function') AS along, o.placed_by,
    ST_Force2D(a.geom) AS line
    FROM parking_bay b JOIN street_object o USING (street_object_id) JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id) JOIN axis a ON a.axis_id = o.axis_id LEFT JOIN placement_rule r USING (rule_id)
    WHERE b.surface IS NOT NULL;
CREATE INDEX ON bay USING gist (surface);
CREATE INDEX ON bay (edge_id);
-- Three lines across the street: through the middle of each bay and near both its ends.
CREATE TEMP TABLE cut AS SELECT b.id, b.edge_id, b.direction, ST_MakeLine(ST_MakePoint(ST_X(p) - 40 * cos(t), ST_Y(p) + 40 * sin(t)), ST_MakePoint(ST_X(p) + 40 * cos(t), ST_Y(p) - 40 * sin(t))) AS across
    FROM bay b, (VALUES (0.1), (0.5), (0.9)) v(share), LATERAL (SELECT ST_Envelope(b.surface) AS box, ST_Length(line) AS long) l,
    LATERAL (SELECT min(a) + (max(a) - min(a)) * share AS at FROM (SELECT ST_LineLocatePoint(line, q.geom) AS a FROM ST_DumpPoints(b.surface) q) s) w,
    LATERAL (SELECT ST_LineInterpolatePoint(line, at) AS p, ST_Azimuth(ST_LineInterpolatePoint(line, greatest(0, at - 0.5 / long)), ST_LineInterpolatePoint(line, least(1, at + 0.5 / long))) AS t) d WHERE b.placed_by = 'rule';
UPDATE cut SET across = ST_SetSRID(across, (SELECT ST_SRID(surface) FROM bay LIMIT 1));
CREATE INDEX ON cut (edge_id);
ANALYZE bay, cut;
-- Metres that each line leaves to those who drive: roadway without bays, parking lanes and cycle lanes. Metres of each driven lane, with and without bays.
CREATE TEMP TABLE left_to AS SELECT c.id, c.direction, ST_Length(ST_Difference(c.across_roadway, coalesce((SELECT ST_Union(x.surface) FROM (SELECT surface FROM bay b WHERE b.surface && c.across_roadway
        UNION ALL SELECT surface FROM lane l WHERE l.edge_id = c.edge_id AND l.kind IN ('parking', 'cycle', 'closed')) x), ST_SetSRID('POLYGON EMPTY'::geometry, ST_SRID(c.across_roadway))))) AS metres
    FROM (SELECT c.*, ST_Intersection(c.across, s.surface) AS across_roadway FROM cut c JOIN section s USING (edge_id)) c WHERE NOT ST_IsEmpty(across_roadway);
CREATE TEMP TABLE narrowed AS SELECT c.id, l.kind, ST_Length(w.whole) AS before, ST_Length(ST_Difference(w.whole, (SELECT ST_Union(b.surface) FROM bay b WHERE b.surface && w.whole))) AS after
    FROM cut c JOIN lane l USING (edge_id), LATERAL (SELECT ST_Intersection(c.across, l.surface) AS whole) w
    WHERE l.kind IN ('general', 'merging') AND EXISTS (SELECT FROM bay b WHERE b.surface && w.whole AND ST_Intersects(b.surface, w.whole));
CREATE TEMP TABLE broken AS
SELECT DISTINCT 'on a ' || l.kind || ' lane' AS measure, b.id FROM bay b JOIN lane l ON l.surface && b.surface AND l.kind IN ('bus', 'carpool', 'cycle', 'closed') JOIN edge e ON e.edge_id = l.edge_id AND e.level - b.level = 0
    WHERE b.placed_by = 'rule' AND ST_Area(ST_Intersection(l.surface, b.surface)) > 0.1
UNION SELECT CASE direction WHEN 'both' THEN 'leaves under 5.5 m, two ways' ELSE 'leaves under 3 m, one way' END, id FROM left_to WHERE metres < CASE direction WHEN 'both' THEN 5.5 ELSE 3 END - 0.02
UNION SELECT 'makes a driven lane narrower than 2 m', id FROM narrowed WHERE after < 2 - 0.02 AND after < before - 0.02
UNION SELECT 'on an intersection', b.id FROM bay b JOIN intersection i ON i.surface && b.surface AND i.level - b.level = 0 WHERE b.placed_by = 'rule' AND ST_Area(ST_Intersection(i.surface, b.surface)) > 0.1
UNION SELECT 'on a crossing', b.id FROM bay b JOIN pedestrian_crossing c ON c.surface && b.surface WHERE b.placed_by = 'rule' AND ST_Area(ST_Intersection(c.surface, b.surface)) > 0.1
UNION SELECT 'on another bay', b.id FROM bay b JOIN bay c ON c.surface && b.surface AND c.id < b.id AND c.level = b.level WHERE b.placed_by = 'rule' AND ST_Area(ST_Intersection(c.surface, b.surface)) > 0.1;
SELECT b.along, measure, count(*) AS broken, (SELECT count(*) FROM bay o WHERE o.placed_by = 'rule' AND o.along = b.along) AS bays FROM broken JOIN bay b USING (id) GROUP BY b.along, measure ORDER BY 1, 2;
SELECT along, 'bays that break none' AS measure, count(*) FILTER (WHERE id NOT IN (SELECT id FROM broken)) AS bays, count(*) AS of FROM bay WHERE placed_by = 'rule' GROUP BY along ORDER BY along;
-- Kerbs of parking lanes that have bays.
SELECT 'parking lanes' AS measure, count(*) AS lanes, round(sum(ST_Length(l.geom))) AS metres, count(*) FILTER (WHERE EXISTS (SELECT FROM bay b WHERE b.edge_id = l.edge_id AND ST_Intersects(b.surface, l.surface))) AS with_bays,
    (SELECT round(sum(CASE b.angle WHEN 0 THEN b.length ELSE 2.3 / sind(b.angle) END)) FROM bay b WHERE b.along = 'lane') AS metres_of_bays FROM lane l WHERE l.kind = 'parking';
