\set ECHO none
\ir shared/truths.sql
-- The roadway as triangles. Each test is a row (name, holds).
SELECT streetgen.create_model('flat', 2154) \g /dev/null
INSERT INTO flat.axis (geom, width, level) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 9, 0), ('SRID=2154;LINESTRING(650100 6860000, 650200 6860000, 650260 6860040)', 7, 0),
    ('SRID=2154;LINESTRING(650100 6860000, 650110 6859920)', 6, 0), ('SRID=2154;LINESTRING(650040 6860006, 650060 6860060)', 5, 0),
    ('SRID=2154;LINESTRING(650150 6859950, 650150 6860050)', 8, 1);
-- A straight climb, a bend of the plan on a slope, a crest, and streets side by side at different heights.
SELECT streetgen.create_model('hill', 2154, 3) \g /dev/null
INSERT INTO hill.axis (geom, width, level) VALUES
    ('SRID=2154;LINESTRING(650000 6860000 100, 650100 6860000 106)', 9, 0),
    ('SRID=2154;LINESTRING(650100 6860000 106, 650140 6860000 110, 650180 6860000 109, 650240 6860020 101)', 7, 0),
    ('SRID=2154;LINESTRING(650100 6860000 106, 650110 6859960 103, 650110 6859920 102.99)', 6, 0),
    ('SRID=2154;LINESTRING(650000 6860008 104, 650090 6860008 104)', 6, 0),
    ('SRID=2154;LINESTRING(650160 6859950 120, 650160 6860050 118)', 8, 1);

CREATE TEMPORARY TABLE mesh AS SELECT name, m.* FROM unnest(ARRAY['flat', 'hill']) name, streetgen.road_mesh(name) m;
CREATE TEMPORARY TABLE ground AS
SELECT 'flat' AS name, edge_id, NULL::bigint AS node_id, level, surface FROM flat.section UNION ALL SELECT 'flat', NULL, node_id, level, surface FROM flat.intersection
UNION ALL SELECT 'hill', edge_id, NULL, level, surface FROM hill.section UNION ALL SELECT 'hill', NULL, node_id, level, surface FROM hill.intersection;
CREATE TEMPORARY TABLE triangle AS
SELECT row_number() OVER () AS id, name, edge_id, node_id, level, ST_MakePolygon(ST_Force2D(r)) AS plan, ARRAY[a, b, c] AS corner,
    ((ST_X(b) - ST_X(a)) * (ST_Y(c) - ST_Y(a)) - (ST_X(c) - ST_X(a)) * (ST_Y(b) - ST_Y(a))) / 2 AS area
FROM mesh, ST_Dump(geom) t, LATERAL (SELECT ST_ExteriorRing(t.geom) AS r) s, LATERAL (SELECT ST_PointN(r, 1) AS a, ST_PointN(r, 2) AS b, ST_PointN(r, 3) AS c) p;
CREATE INDEX ON triangle USING gist (plan);
CREATE TEMPORARY TABLE side AS
SELECT name, level, least(a, b) AS a, greatest(a, b) AS b, count(*) AS uses, count(*) FILTER (WHERE a < b) AS forwards, (array_agg(ST_Force2D(ST_MakeLine(p, q))))[1] AS line
FROM (SELECT *, ST_AsBinary(p) AS a, ST_AsBinary(q) AS b FROM (SELECT name, level, corner[k] AS p, corner[k % 3 + 1] AS q FROM triangle, generate_series(1, 3) k) c) s GROUP BY 1, 2, 3, 4;

SELECT 'a row for each surface: ' || name, count(*) = count(m) AND bool_and(m.level = g.level) AND count(*) = (SELECT count(*) FROM mesh n WHERE n.name = g.name)
    FROM ground g LEFT JOIN mesh m USING (name) WHERE NOT ST_IsEmpty(surface) AND (m IS NULL OR (m.edge_id, m.node_id) IS NOT DISTINCT FROM (g.edge_id, g.node_id)) GROUP BY name ORDER BY name;
SELECT 'a TIN Z in the reference of the model', bool_and(GeometryType(geom) = 'TIN' AND ST_NDims(geom) = 3 AND ST_SRID(geom) = 2154) FROM mesh;
SELECT 'triangles are counter-clockwise', count(*) > 100 AND bool_and(area > 0) FROM triangle;
SELECT 'triangles have the area of their surface', bool_and(abs(covered - ST_Area(surface)) <= 1e-6 * ST_Perimeter(surface))
    FROM (SELECT name, edge_id, node_id, sum(area) AS covered FROM triangle GROUP BY 1, 2, 3) t JOIN ground g USING (name) WHERE (t.edge_id, t.node_id) IS NOT DISTINCT FROM (g.edge_id, g.node_id);
SELECT 'triangles lie on their surface', bool_and(ST_Covers(ST_Buffer(surface, 1e-5), plan))
    FROM triangle t JOIN ground g USING (name) WHERE (t.edge_id, t.node_id) IS NOT DISTINCT FROM (g.edge_id, g.node_id);
SELECT 'no overlap within a level', coalesce(sum(ST_Area(ST_Intersection(a.plan, b.plan))), 0) < 1e-4 FROM triangle a JOIN triangle b ON a.plan && b.plan AND a.name = b.name AND a.level = b.level AND a.id < b.id;
SELECT 'a side has one triangle or two, one each way', count(*) FILTER (WHERE uses = 2) > 100 AND bool_and(uses = 1 OR uses = 2 AND forwards = 1) FROM side;
SELECT 'a side with one triangle lies on the rim', bool_and(ST_CoveredBy(line, ST_Buffer(rim, 1e-4)))
    FROM side JOIN (SELECT name, level, ST_Boundary(ST_Union(surface, 1e-5)) AS rim FROM ground GROUP BY 1, 2) r USING (name, level) WHERE uses = 1;
SELECT 'no vertex lies within a side of a neighbour', count(*) = 0 FROM side s JOIN triangle t USING (name, level), unnest(corner) p
    WHERE uses = 1 AND plan && line AND ST_DWithin(p, line, 1e-5) AND NOT ST_DWithin(p, ST_StartPoint(line), 1e-5) AND NOT ST_DWithin(p, ST_EndPoint(line), 1e-5);

SELECT 'without heights z is 0', max(abs(ST_ZMin(geom))) = 0 AND max(abs(ST_ZMax(geom))) = 0 FROM mesh WHERE name = 'flat';
SELECT 'a place has one height within a level', max(n) = 1 FROM (SELECT count(DISTINCT ST_Z(p)) AS n FROM triangle, unnest(corner) p GROUP BY name, level, ST_X(p), ST_Y(p)) z;
CREATE TEMPORARY TABLE off AS
SELECT a.edge_id, p.geom AS place, l.u * ST_Z(corner[1]) + l.v * ST_Z(corner[2]) + (1 - l.u - l.v) * ST_Z(corner[3]) - ST_Z(p.geom) AS z
FROM hill.edge a, ST_DumpPoints(ST_Segmentize(a.geom, 0.5)) p JOIN triangle t ON t.name = 'hill' AND ST_Intersects(plan, ST_Force2D(p.geom)),
    LATERAL (SELECT ST_X(corner[1]) - ST_X(corner[3]) AS ax, ST_Y(corner[1]) - ST_Y(corner[3]) AS ay, ST_X(corner[2]) - ST_X(corner[3]) AS bx, ST_Y(corner[2]) - ST_Y(corner[3]) AS by,
        ST_X(p.geom) - ST_X(corner[3]) AS px, ST_Y(p.geom) - ST_Y(corner[3]) AS py) d,
    LATERAL (SELECT (px * by - bx * py) / (ax * by - bx * ay) AS u, (ax * py - px * ay) / (ax * by - bx * ay) AS v) l WHERE t.level = a.level;
SELECT 'the mesh leaves the heights of the axes by the tolerance', count(*) > 500 AND max(abs(z)) < 0.05 FROM off;
SELECT 'a crest is cut across, at both borders', count(DISTINCT ST_Y(p)) = 3 AND min(ST_Z(p)) = 110 AND max(ST_Z(p)) = 110 FROM triangle, unnest(corner) p
    WHERE name = 'hill' AND level = 0 AND abs(ST_X(p) - 650140) < 0.011;
SELECT 'a change of slope below the tolerance is not', count(*) = 0 FROM streetgen.road_mesh('hill', tolerance => 10) m, ST_DumpPoints(geom) p WHERE m.level = 0 AND ST_DWithin(ST_Force2D(p.geom), 'SRID=2154;POINT(650140 6860000)', 1);
SELECT 'a level keeps its own heights', min(ST_ZMin(geom)) = 118 AND max(ST_ZMax(geom)) = 120 FROM mesh WHERE name = 'hill' AND level = 1;

-- Of each corner: where it is, its normal, its texture coordinates.
CREATE TEMPORARY TABLE corner AS
SELECT t.name, t.edge_id, t.node_id, t.level, t.corner[k] AS place, n[1] AS x, n[2] AS y, n[3] AS z, u[1] AS along, u[2] AS aside
FROM (SELECT *, row_number() OVER (PARTITION BY name, edge_id, node_id ORDER BY id) AS i FROM triangle) t
JOIN mesh m ON m.name = t.name AND (m.edge_id, m.node_id) IS NOT DISTINCT FROM (t.edge_id, t.node_id), generate_series(1, 3) k,
    LATERAL (SELECT normals[9 * i + 3 * k - 11:9 * i + 3 * k - 9] AS n, texture[6 * i + 2 * k - 7:6 * i + 2 * k - 6] AS u) v;
SELECT 'three normals and three texture coordinates a triangle', bool_and(cardinality(normals) = 9 * ST_NumGeometries(geom) AND cardinality(texture) = 6 * ST_NumGeometries(geom)) FROM mesh;
SELECT 'normals are unit vectors that point up', bool_and(abs(x * x + y * y + z * z - 1) < 1e-6 AND z > 0) FROM corner;
SELECT 'without heights they point straight up', bool_and(z = 1) FROM corner WHERE name = 'flat';
SELECT 'on a straight climb they lean back by its slope', count(*) > 3 AND bool_and(abs(x / z + 0.06) < 1e-6 AND y = 0) FROM corner JOIN hill.edge USING (edge_id) WHERE name = 'hill' AND axis_id = 1 AND ST_Y(place) < 6860003;
SELECT 'a place has one normal within a level', max(n) = 1 FROM (SELECT count(DISTINCT (x, y, z)) AS n FROM corner GROUP BY name, corner.level, ST_X(place), ST_Y(place)) s;
SELECT 'texture of a section: metres along the edge and to its left', count(*) > 3 AND bool_and(abs(aside - (ST_Y(place) - 6860000)) < 1e-3 AND abs(along - (ST_X(place) - 650000)) < 1e-3)
    FROM corner JOIN flat.edge USING (edge_id) WHERE name = 'flat' AND axis_id = 1 AND start_abscissa = 0;
SELECT 'texture of an intersection: metres east and north of its node', count(*) > 10 AND bool_and(abs(along - (ST_X(place) - ST_X(n.geom))) < 1e-4 AND abs(aside - (ST_Y(place) - ST_Y(n.geom))) < 1e-4)
    FROM corner JOIN flat.node n USING (node_id) WHERE name = 'flat';

CREATE TEMPORARY TABLE part AS SELECT 'hill' AS name, p.* FROM streetgen.road_mesh('hill', ST_MakeEnvelope(650070, 6859990, 650105, 6860003, 2154)) p;
SELECT 'an extent has the surfaces that it meets', count(*) BETWEEN 2 AND 4 AND count(*) = (SELECT count(*) FROM ground WHERE name = 'hill' AND ST_Intersects(surface, ST_MakeEnvelope(650070, 6859990, 650105, 6860003, 2154))) FROM part;
SELECT 'their meshes are those of the whole', bool_and(ST_AsBinary(p.geom) = ST_AsBinary(m.geom)) FROM mesh m JOIN part p USING (name) WHERE (m.edge_id, m.node_id) IS NOT DISTINCT FROM (p.edge_id, p.node_id);
SELECT 'an extent may be a point, and without a reference', count(*) = 1 FROM streetgen.road_mesh('hill', 'POINT(650160 6860040)');
SELECT 'an extent away from all, or empty, has no row', count(*) = 0 FROM (VALUES ('SRID=2154;POINT(0 0)'::geometry), ('SRID=2154;POLYGON EMPTY')) v(extent), streetgen.road_mesh('hill', extent);
SELECT streetgen.create_model('bare', 2154, 3) \g /dev/null
SELECT 'a model without streets has no row', count(*) = 0 FROM streetgen.road_mesh('bare');

SELECT 'bad input: ' || statement, test.state(statement) = expected FROM (VALUES
    ($$SELECT streetgen.road_mesh('nowhere')$$, '3F000'), ($$SELECT streetgen.road_mesh(NULL)$$, '22004'), ($$SELECT streetgen.road_mesh('hill', tolerance => NULL)$$, '22004'),
    ($$SELECT streetgen.road_mesh('hill', tolerance => 'NaN')$$, '22023'), ($$SELECT streetgen.road_mesh('hill', tolerance => -1)$$, '22023'), ($$SELECT streetgen.road_mesh('bare', tolerance => 0)$$, '22023'),
    ($$SELECT streetgen.road_mesh('hill', tolerance => 'infinity')$$, '22023'), ($$SELECT streetgen.road_mesh('hill', 'SRID=4326;POINT(0 0)')$$, '22023'),
    ($$SELECT streetgen.road_mesh('hill', ST_MakePoint('NaN', 0))$$, '22023'), ($$SELECT streetgen.road_mesh('hill', ST_MakeLine(ST_Point(0, 0), ST_Point('infinity', 0)))$$, '22023')) s(statement, expected);
SELECT 'an error names the value', test.said($$SELECT streetgen.road_mesh('hill', tolerance => -1)$$) = 'tolerance is -1, expected 0.001 to 10'
    AND test.said($$SELECT streetgen.road_mesh('hill', 'SRID=4326;POINT(0 0)')$$) = 'the extent has SRID 4326, the model 2154';
-- A ramp of another level comes to a junction: both have the vertices of its limit, and the same heights there.
SELECT streetgen.create_model('ramp', 2154, dimension => 3) \g /dev/null
INSERT INTO ramp.axis (axis_id, geom, width, level) VALUES (1, ST_Translate('SRID=2154;LINESTRING Z (0 0 0,50 0 2)'::geometry, 650000, 6860000), 7, 0), (2, ST_Translate('SRID=2154;LINESTRING Z (50 0 2,150 0 12)'::geometry, 650000, 6860000), 6, 1),
  (3, ST_Translate('SRID=2154;LINESTRING Z (50 0 2,50 60 -4)'::geometry, 650000, 6860000), 6, 0);
CREATE TEMP TABLE seam AS SELECT e.edge_id, l.border_line, i.node_id FROM ramp.edge e JOIN ramp.section_limit l USING (edge_id) JOIN ramp.intersection i ON i.node_id = CASE l.which WHEN 'start' THEN from_node ELSE to_node END AND i.level <> e.level;
CREATE TEMP TABLE rim AS SELECT m.edge_id, m.node_id, p.geom FROM streetgen.road_mesh('ramp') m, ST_DumpPoints(m.geom) p;
SELECT 'levels meet in the same vertices', count(*) >= 2 AND bool_and(EXISTS (SELECT FROM rim r WHERE r.node_id = s.node_id AND ST_3DDWithin(r.geom, v.geom, 1e-6))) FROM seam s JOIN rim v ON v.edge_id = s.edge_id AND ST_DWithin(v.geom, s.border_line, 1e-4);
SELECT 'each way', count(*) >= 2 AND bool_and(EXISTS (SELECT FROM rim r WHERE r.edge_id = s.edge_id AND ST_3DDWithin(r.geom, v.geom, 1e-6))) FROM seam s JOIN rim v ON v.node_id = s.node_id AND ST_DWithin(v.geom, s.border_line, 1e-4);
