-- Shapes that nobody would build, of the model of variable model: each is a row of `finding`.
-- Reads the temporary tables `surface`, `degree` and `path` of quality.sql and traffic.sql, and calls their `remainder`. Switches subject kerb on.
SELECT streetgen.switch_subject(:'model', 'kerb', true) \g /dev/null

-- The outline of the roadway, without what is shorter than a centimetre.
CREATE TEMPORARY TABLE outline AS
SELECT row_number() OVER () AS outline_id, level, ST_Simplify(geom, 0.01) AS geom, ST_IsClosed(geom) AS closed
FROM (SELECT level, (ST_Dump(ST_LineMerge(ST_Collect(ST_Force2D(geom))))).geom FROM :"model".kerb GROUP BY level) merged;
CREATE TEMPORARY TABLE outline_vertex AS
SELECT outline_id, level, (d).geom AS place, lag((d).geom) OVER along AS before, lead((d).geom) OVER along AS after
FROM (SELECT outline_id, level, ST_DumpPoints(CASE WHEN closed THEN ST_AddPoint(geom, ST_PointN(geom, 2)) ELSE geom END) AS d FROM outline) v
WINDOW along AS (PARTITION BY outline_id ORDER BY (d).path[1]);
CREATE FUNCTION pg_temp.turn(before geometry, place geometry, after geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT degrees(least(t, 2 * pi() - t)) FROM (SELECT abs(ST_Azimuth(place, after) - ST_Azimuth(before, place))) a(t) $$;

-- Limits, and with them the flat ends of dead ends and of levels.
CREATE TEMPORARY TABLE limit_end AS SELECT (ST_DumpPoints(border_line)).geom AS place FROM :"model".section_limit;
CREATE INDEX ON limit_end USING gist (place);
ANALYZE limit_end;
INSERT INTO finding SELECT 'kink of the outline', 'outline', outline_id, pg_temp.turn(before, place, after), place FROM outline_vertex v
WHERE pg_temp.turn(before, place, after) > 45 AND NOT EXISTS (SELECT FROM limit_end l WHERE ST_DWithin(l.place, v.place, 0.02));

-- The kerb goes on in its direction, aside by more than 0.1 m within 0.5 m.
INSERT INTO finding
SELECT 'step of a kerb', 'outline', outline_id, aside, place
FROM (SELECT outline_id, place, before, after, lead(after) OVER along AS next FROM outline_vertex WINDOW along AS (PARTITION BY outline_id ORDER BY ctid)) s
CROSS JOIN LATERAL (SELECT ST_Azimuth(before, place) AS way, ST_Azimuth(place, after) AS across, ST_Azimuth(after, next) AS onwards, ST_Distance(place, after) AS size) a
CROSS JOIN LATERAL (SELECT size * abs(sin(across - way)) AS aside) b
WHERE cos(onwards - way) > cos(radians(10)) AND size < 0.7 AND aside > 0.1 AND abs(sin(across - way)) > sin(radians(20));

INSERT INTO finding SELECT 'surface under 0.01 m2', kind, id, ST_Area(surface), surface FROM surface WHERE ST_Area(surface) < 0.01;

-- Between surfaces that meet at no node.
INSERT INTO finding
SELECT 'slit', 'surface', a.id, ST_Area(slit), slit
FROM surface a JOIN surface b ON a.level = b.level AND (a.kind, a.id) < (b.kind, b.id) AND ST_DWithin(a.surface, b.surface, 0.2)
    AND NOT ARRAY[a.node_a, a.node_b] && ARRAY[b.node_a, b.node_b]
CROSS JOIN LATERAL (SELECT ST_Union(a.surface, b.surface) AS both_surfaces) u
CROSS JOIN LATERAL (SELECT (ST_Dump(ST_Difference(ST_Buffer(ST_Buffer(both_surfaces, 0.1, 'join=mitre mitre_limit=2'), -0.1001, 'join=mitre mitre_limit=2'), both_surfaces))).geom AS closed) c
CROSS JOIN LATERAL (SELECT pg_temp.remainder(closed, ARRAY(SELECT s.surface FROM surface s WHERE s.level = a.level AND s.surface && closed)) AS slit) d
WHERE ST_Area(closed) > 0.02 AND ST_Area(slit) > 0.02;

INSERT INTO finding
SELECT 'corner of a path over 30 degrees', 'interconnection', interconnection_id, max(pg_temp.turn(before, place, after)), ST_Collect(place)
FROM (SELECT interconnection_id, (d).geom AS place, lag((d).geom) OVER along AS before, lead((d).geom) OVER along AS after
      FROM (SELECT interconnection_id, ST_DumpPoints(ST_RemoveRepeatedPoints(geom, 1e-6)) AS d FROM path) p WINDOW along AS (PARTITION BY interconnection_id ORDER BY (d).path[1])) v
WHERE pg_temp.turn(before, place, after) > 30 GROUP BY interconnection_id;
INSERT INTO finding SELECT 'path under 3 m of radius', 'interconnection', interconnection_id, -radius, geom FROM path WHERE radius < 3;
INSERT INTO finding SELECT 'path that no car drives', 'interconnection', interconnection_id, ST_Length(geom), geom FROM :"model".interconnection WHERE reason = 'not_drivable';
