-- Whether walks over roadways have crossings: psql -v model=NAME -f tests/measure/walks_over_roadways.sql Prints model,
-- the runs of footways from kerb to kerb over an axis of their level, the runs on which no crossing lies (over
-- motorways, aprons and their links apart), pairs of crossings that lie on each other by half, crossings by hand or
-- of a source, of rules, of footways that say that they are crossings, and of other footways.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
CREATE TEMPORARY TABLE roadway AS SELECT s.surface, e.level FROM :"model".section s JOIN :"model".edge e USING (edge_id)
    UNION ALL SELECT surface, level FROM :"model".intersection;
CREATE INDEX ON roadway USING gist (surface);
ANALYZE roadway;
CREATE TEMPORARY TABLE run AS
SELECT f.footway_id, f.role, f.level, r.geom, c.walked_along
FROM :"model".footway f, LATERAL (SELECT ST_Union(surface, 0.0001) AS surface FROM roadway w
        WHERE w.surface && f.geom AND w.level = f.level) w,
    LATERAL (SELECT geom FROM ST_Dump(ST_CollectionExtract(ST_Intersection(ST_Force2D(f.geom), w.surface), 2))) r,
    LATERAL (SELECT bool_and(coalesce(k.walked_along, true)) AS walked_along FROM :"model".edge e
        JOIN :"model".axis a USING (axis_id) LEFT JOIN :"model".axis_class k ON k.class = a.kind
        WHERE e.geom && r.geom AND e.level = f.level AND ST_Intersects(e.geom, r.geom) HAVING count(*) > 0) c
WHERE ST_Length(r.geom) > 2.5 AND NOT ST_DWithin(r.geom, ST_StartPoint(f.geom), 0.1)
    AND NOT ST_DWithin(r.geom, ST_EndPoint(f.geom), 0.1);
CREATE TEMPORARY TABLE bare AS SELECT * FROM run r WHERE (walked_along OR role = 'crossing') AND NOT EXISTS (
    SELECT FROM :"model".pedestrian_crossing c JOIN :"model".street_object USING (street_object_id)
        JOIN :"model".object_edge USING (street_object_id) JOIN :"model".edge e USING (edge_id)
    WHERE c.surface && r.geom AND e.level = r.level AND ST_Intersects(c.surface, r.geom));
SELECT :'model', (SELECT count(*) FROM run), (SELECT count(*) FROM bare),
    (SELECT count(*) FROM :"model".pedestrian_crossing a JOIN :"model".pedestrian_crossing b
        ON a.surface && b.surface AND a.street_object_id < b.street_object_id
            AND ST_Area(ST_Intersection(a.surface, b.surface))
                > least(ST_Area(a.surface), ST_Area(b.surface)) / 2),
    count(*) FILTER (WHERE placed_by <> 'rule'), count(*) FILTER (WHERE rule_id >= 0),
    count(*) FILTER (WHERE rule_id = -1 AND role = 'crossing'),
    count(*) FILTER (WHERE rule_id = -1 AND role IS DISTINCT FROM 'crossing')
FROM :"model".pedestrian_crossing JOIN :"model".street_object USING (street_object_id)
    LEFT JOIN :"model".footway USING (footway_id);
