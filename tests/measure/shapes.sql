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

-- Medians of 2 m and more: every 5 m from 10 m beyond the limits of one carriageway to the other one of its street, which runs the other way; no other edge there.
CREATE TEMPORARY TABLE carriageway AS
SELECT e.edge_id, e.level, coalesce(name, '') AS name, e.importance, CASE WHEN e.lanes_forward = 0 THEN -1 ELSE 1 END AS way, e.width / 2 AS half, ST_Force2D(e.geom) AS geom, ST_Length(e.geom) AS size, a.abscissa + 10 AS first, b.abscissa - 10 AS last
FROM :"model".edge e JOIN :"model".axis USING (axis_id) JOIN :"model".section_limit a ON a.edge_id = e.edge_id AND a.which = 'start' JOIN :"model".section_limit b ON b.edge_id = e.edge_id AND b.which = 'end'
WHERE e.lanes_both = 0 AND (e.lanes_forward = 0) <> (e.lanes_backward = 0) AND b.abscissa - a.abscissa > 20 AND e.width = e.width_end;
CREATE INDEX ON carriageway USING gist (geom);
ANALYZE carriageway;
CREATE TEMPORARY TABLE median AS
SELECT a.edge_id, a.level, b.edge_id AS other, ST_LineInterpolatePoint(across, least(a.half / d, 1)) AS kerb, ST_LineInterpolatePoint(across, greatest(1 - b.half / d, 0)) AS other_kerb
FROM carriageway a CROSS JOIN LATERAL generate_series(a.first::numeric, a.last::numeric, 5) s CROSS JOIN LATERAL (SELECT ST_LineInterpolatePoint(a.geom, s / a.size) AS place, ST_LineInterpolatePoint(a.geom, least((s + 0.1) / a.size, 1)) AS onwards) p
JOIN carriageway b ON b.edge_id > a.edge_id AND (b.level, b.name, b.importance) = (a.level, a.name, a.importance) AND ST_DWithin(b.geom, place, 60)
CROSS JOIN LATERAL (SELECT ST_LineLocatePoint(b.geom, place) AS t) l CROSS JOIN LATERAL (SELECT ST_LineInterpolatePoint(b.geom, t) AS there, ST_LineInterpolatePoint(b.geom, least(t + 0.1 / b.size, 1)) AS there_onwards) q
CROSS JOIN LATERAL (SELECT ST_MakeLine(place, there) AS across, ST_Distance(place, there) AS d) c
WHERE t * b.size BETWEEN b.first AND b.last AND d - a.half - b.half >= 2 AND a.way * b.way * cos(ST_Azimuth(place, onwards) - ST_Azimuth(there, there_onwards)) < -cos(radians(10));
INSERT INTO finding
SELECT 'median paved', 'edge', edge_id, paved, ground
FROM (SELECT *, ST_MakeLine(kerb, other_kerb) AS ground FROM median) m
CROSS JOIN LATERAL (SELECT ST_Length(ground) - ST_Length(pg_temp.remainder(ground, ARRAY(SELECT s.surface FROM surface s WHERE s.level = m.level AND s.surface && ground))) AS paved) p
WHERE paved > 0.5 AND NOT EXISTS (SELECT FROM :"model".edge e WHERE e.edge_id NOT IN (m.edge_id, m.other) AND e.level = m.level AND ST_DWithin(e.geom, ground, greatest(e.width, e.width_end) / 2));

-- Traffic islands: ground without flat buffers in faces of a level under island_area, with room for a disc of 1 m. Gone: no disc of 0.75 m is left, the radius of its noses.
CREATE TEMPORARY TABLE traffic_island AS
SELECT row_number() OVER () AS island_id, level, ground
FROM (SELECT level, (ST_Dump(ST_Polygonize(ST_Force2D(geom)))).geom AS face FROM :"model".edge GROUP BY level) f
CROSS JOIN LATERAL (SELECT (ST_Dump(pg_temp.remainder(face, ARRAY(SELECT ST_Buffer(ST_Force2D(e.geom), width / 2, 'endcap=flat') FROM :"model".edge e
    WHERE e.level = f.level AND ST_DWithin(e.geom, face, width / 2))))).geom AS ground) g
WHERE ST_Area(face) < (SELECT (settings ->> 'island_area')::float8 FROM :"model".setting_used) AND ST_Dimension(ground) = 2 AND (ST_MaximumInscribedCircle(ground)).radius >= 1;
INSERT INTO finding
SELECT 'island gone', 'level', level, ST_Area(ground), ground FROM traffic_island i
CROSS JOIN LATERAL (SELECT pg_temp.remainder(ground, ARRAY(SELECT s.surface FROM surface s WHERE s.level = i.level AND s.surface && ground)) AS rest) r
WHERE ST_IsEmpty(rest) OR coalesce((ST_MaximumInscribedCircle(rest)).radius, 0) < 0.75;
