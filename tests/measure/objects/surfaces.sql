-- The ground of a crossing on each arm: psql -v model=MODEL
DELETE FROM :"model".placement_rule;
INSERT INTO :"model".placement_rule (rule_id, type, along, side, distance_from_limit) VALUES (2, 'crossing', 'arm', 'alternating', 2.5);
CREATE TEMPORARY TABLE crossing AS
SELECT c.street_object_id, c.surface, c.width, c.angle, o.abscissa, a.line, a.width AS street, a.width_end, a.roadway_offset, e.level
FROM :"model".pedestrian_crossing c JOIN :"model".street_object o USING (street_object_id) JOIN :"model".object_edge USING (street_object_id) JOIN :"model".edge e USING (edge_id)
    JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end, roadway_offset FROM :"model".axis_used OFFSET 0) a ON a.axis_id = o.axis_id;
CREATE TEMPORARY TABLE judged AS
SELECT c.*, ST_IsValid(surface) AS valid, ST_Area(surface) AS area,
    (SELECT coalesce(sum(ST_Area(ST_Intersection(r.surface, c.surface))), 0) FROM :"model".roadway r WHERE r.surface && c.surface AND r.level = c.level) AS on_roadway,
    -- The ends of the way across the roadway, through the middle of the crossing.
    (SELECT ST_HausdorffDistance(w.geom, ST_Intersection(w.geom, c.surface)) FROM (SELECT ST_MakeLine(streetgen._place_on(line::bytea, abscissa, roadway_offset - at / 2 - 9)::geometry,
            streetgen._place_on(line::bytea, abscissa, roadway_offset + at / 2 + 9)::geometry) AS across) x,
        LATERAL ST_Dump(ST_Intersection(across, (SELECT ST_Union(r.surface) FROM :"model".roadway r WHERE r.surface && across AND r.level = c.level))) w
        ORDER BY ST_Distance(w.geom, streetgen._place_on(line::bytea, abscissa, 0)::geometry) LIMIT 1) AS short,
    ST_NPoints(ST_Simplify(near, 0.001)) = 2 AND street = width_end AND abscissa > 3 AND abscissa < ST_Length(line) - 3 AS straight,
    ST_Length(ST_Intersection(surface, near)) - c.width / sin(radians(c.angle)) AS off
FROM crossing c, LATERAL (SELECT street + (width_end - street) * abscissa / ST_Length(line) AS at,
    ST_LineSubstring(line, greatest(0, abscissa / ST_Length(line) - 15 / ST_Length(line)), least(1, abscissa / ST_Length(line) + 15 / ST_Length(line))) AS near) n;
SELECT '| ' || :'model', count(*), count(*) FILTER (WHERE surface IS NULL), count(*) FILTER (WHERE NOT valid), round((100 * sum(on_roadway) / sum(area))::numeric, 3), count(*) FILTER (WHERE short > 0.1),
    count(*) FILTER (WHERE straight), count(*) FILTER (WHERE straight AND abs(off) > 0.01) || ' |' FROM judged;
