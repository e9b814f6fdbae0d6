-- Corners, kerbs and limits of one model against the laws that they must keep: each failure is a row of `finding`.
-- Reads the temporary table `surface` of quality.sql, and calls its `remainder`.
CREATE TEMPORARY TABLE finding (measure text, relation text, id bigint, value float8, geom geometry);

-- Edge ends, counter-clockwise about their node, each oriented away from it; where one edge goes out and back on one line, its start first, as in `corner`.
CREATE TEMPORARY TABLE arm AS
SELECT e.edge_id, e.axis_id, which, node_id, line, ST_Length(line) AS length, width / 2 AS half, abs(e.width - e.width_end) < 1e-9 AS constant, radius, azimuth,
       row_number() OVER around AS turn, count(*) OVER (PARTITION BY node_id) AS degree
FROM (SELECT edge_id, axis_id, 'start' AS which, from_node AS node_id, ST_Force2D(geom) AS line, width, width_end FROM :"model".edge
      UNION ALL SELECT edge_id, axis_id, 'end', to_node, ST_Reverse(ST_Force2D(geom)), width, width_end FROM :"model".edge) e
JOIN (SELECT axis_id, radius FROM :"model".axis_used) u USING (axis_id)
CROSS JOIN LATERAL (SELECT ST_Azimuth(ST_StartPoint(line), ST_LineInterpolatePoint(line, least(1, 1 / ST_Length(line)))) AS azimuth) d
WINDOW around AS (PARTITION BY node_id ORDER BY azimuth DESC, edge_id, which DESC);
ANALYZE arm;

CREATE TEMPORARY TABLE pair AS
SELECT a.node_id, a.degree, a.edge_id AS edge_a, a.which AS end_a, b.edge_id AS edge_b, b.which AS end_b, a.line AS line_a, b.line AS line_b,
       a.length AS length_a, b.length AS length_b, a.azimuth AS azimuth_a, b.azimuth AS azimuth_b, a.half AS half_a, b.half AS half_b,
       least(a.radius, b.radius) AS r, a.constant AND b.constant AS constant,
       a.azimuth - b.azimuth + CASE WHEN a.azimuth < b.azimuth THEN 2 * pi() ELSE 0 END AS phi
FROM arm a JOIN arm b ON b.node_id = a.node_id AND b.turn = a.turn % a.degree + 1 WHERE a.degree >= 2;

-- Straight to 0.1 m beyond the arc's foot, long enough and near enough for the wanted radius: the law of two lines holds.
CREATE TEMPORARY TABLE lawful AS
SELECT p.*, centre FROM pair p
CROSS JOIN LATERAL (SELECT CASE WHEN phi BETWEEN radians(20) AND radians(160) THEN sin(phi) END AS sine) s
CROSS JOIN LATERAL (SELECT (half_b + r + (half_a + r) * cos(phi)) / sine AS o_a, (half_a + r + (half_b + r) * cos(phi)) / sine AS o_b) o
CROSS JOIN LATERAL (SELECT least(o_a + 0.1, length_a) AS s_a, least(o_b + 0.1, length_b) AS s_b) s_ab
CROSS JOIN LATERAL (SELECT ST_Translate(ST_StartPoint(line_a), o_a * sin(azimuth_a) - (half_a + r) * cos(azimuth_a), o_a * cos(azimuth_a) + (half_a + r) * sin(azimuth_a)) AS centre) c
WHERE constant AND r > 0 AND sine IS NOT NULL AND o_a BETWEEN 0 AND length_a AND o_b BETWEEN 0 AND length_b
  AND NOT (degree = 2 AND abs(half_a - half_b) > 0.005 AND abs(phi - pi()) < pi() / 3) -- a transition has no corner
  AND ST_Distance(centre, ST_StartPoint(line_a)) < (SELECT value::float8 FROM :"model".setting WHERE name = 'max_arc_distance')
  AND ST_Distance(ST_LineInterpolatePoint(line_a, s_a / length_a), ST_Translate(ST_StartPoint(line_a), s_a * sin(azimuth_a), s_a * cos(azimuth_a))) < 1e-4
  AND ST_Distance(ST_LineInterpolatePoint(line_b, s_b / length_b), ST_Translate(ST_StartPoint(line_b), s_b * sin(azimuth_b), s_b * cos(azimuth_b))) < 1e-4
  AND ST_Distance(centre, line_a) > half_a + r - 1e-6 AND ST_Distance(centre, line_b) > half_b + r - 1e-6 -- touching no bend before that
  -- The corner of an island is none of two lines alone.
  AND NOT EXISTS (SELECT FROM :"model".corner k WHERE (k.node_id, k.edge_a, k.end_a, k.edge_b, k.end_b) = (p.node_id, p.edge_a, p.end_a, p.edge_b, p.end_b) AND k.method = 'nose');

INSERT INTO finding
SELECT 'arc', 'node', node_id, degrees(phi), ST_StartPoint(line_a)
FROM lawful l LEFT JOIN :"model".corner k USING (node_id, edge_a, end_a, edge_b, end_b)
WHERE NOT coalesce(abs(radius - r) <= 1e-3 AND ST_Distance(k.centre, l.centre) <= 1e-3 * greatest(1, 1 / tan(phi / 2))
    AND abs(ST_Distance(k.centre, line_a) - half_a - r) <= 1e-3 AND abs(ST_Distance(k.centre, line_b) - half_b - r) <= 1e-3
    AND abs(ST_Distance(ST_StartPoint(arc), line_a) - half_a) <= 1e-3 AND abs(ST_Distance(ST_EndPoint(arc), line_b) - half_b) <= 1e-3
    AND abs(ST_Distance(ST_PointN(arc, 2), k.centre) - r) <= 1e-3 AND abs(ST_Distance(ST_StartPoint(arc), k.centre) - r) <= 1e-3 AND abs(ST_Distance(ST_EndPoint(arc), k.centre) - r) <= 1e-3
    AND abs(cos(ST_Azimuth(ST_StartPoint(arc), k.centre) - azimuth_a)) <= sin(radians(0.1))
    AND abs(cos(ST_Azimuth(ST_EndPoint(arc), k.centre) - azimuth_b)) <= sin(radians(0.1)), false);

-- No arc below 160 degrees, and why. Between two axes lies a block, a face of the network of their level; no ground is between them
-- where they are one line drawn twice, be it on two levels, or where their block is wholly roadway.
CREATE TEMPORARY TABLE arcless AS
SELECT p.*, CASE a.level WHEN b.level THEN a.level END AS level, ST_Translate(ST_StartPoint(line_a), away * sin(azimuth_a - phi / 2), away * cos(azimuth_a - phi / 2)) AS place
FROM pair p JOIN :"model".corner k USING (node_id, edge_a, end_a, edge_b, end_b)
JOIN :"model".edge a ON a.edge_id = edge_a JOIN :"model".edge b ON b.edge_id = edge_b
CROSS JOIN LATERAL (SELECT least(0.5, length_a / 2, length_b / 2) AS away) w
WHERE k.method = 'no_arc' AND phi < radians(160);
CREATE TEMPORARY TABLE block AS
SELECT level, (ST_Dump(ST_Polygonize(line))).geom AS block
FROM (SELECT level, (ST_Dump(ST_UnaryUnion(ST_Collect(ST_Force2D(geom))))).geom AS line FROM :"model".edge WHERE level IN (SELECT level FROM arcless) GROUP BY level) l GROUP BY level;
CREATE INDEX ON block USING gist (block);
CREATE TEMPORARY TABLE groundless AS
SELECT node_id, edge_a, end_a, edge_b, end_b FROM arcless c WHERE ST_HausdorffDistance(line_a, line_b) < 1e-3
    OR EXISTS (SELECT FROM block b WHERE b.level = c.level AND ST_Intersects(block, place)
        AND ST_Area(ST_Difference(block, (SELECT ST_Union(surface) FROM surface s WHERE s.surface && block AND s.level = c.level))) < 0.01);
INSERT INTO finding
SELECT 'no arc: ' || CASE WHEN r <= 0 THEN 'none wanted' WHEN EXISTS (SELECT FROM groundless g WHERE (g.node_id, g.edge_a, g.end_a, g.edge_b, g.end_b) = (p.node_id, p.edge_a, p.end_a, p.edge_b, p.end_b)) THEN 'no ground between'
        WHEN largest IS NULL THEN 'borders do not meet' WHEN largest <= 0.001 THEN 'under 1 mm fits' ELSE 'borders meet in one point' END,
       'node', node_id, degrees(phi), ST_StartPoint(line_a)
FROM pair p JOIN :"model".corner k USING (node_id, edge_a, end_a, edge_b, end_b)
CROSS JOIN LATERAL (SELECT streetgen.max_corner_radius(line_a, line_b, 2 * half_a, 2 * half_b) AS largest) m
WHERE method = 'no_arc' AND phi < radians(160);

-- Flat buffers of the axes (cut where a transition begins), and the corners' fillets: the ground between two borders and their arc.
CREATE TEMPORARY TABLE change AS SELECT node_id FROM pair WHERE degree = 2 GROUP BY node_id HAVING bool_or(abs(half_a - half_b) > 0.005)
  UNION SELECT node_id FROM :"model".corner WHERE method = 'transition';
CREATE TEMPORARY TABLE axis_buffer AS
SELECT axis_id, ST_Buffer(ST_MakeLine(line ORDER BY start_abscissa), min(half), 'endcap=flat join=round quad_segs=16') AS buffer
FROM (SELECT axis_id, start_abscissa, width / 2 AS half, ST_LineSubstring(line,
             CASE WHEN EXISTS (SELECT FROM change WHERE node_id = from_node) THEN least(first, last) / length ELSE 0 END,
             CASE WHEN EXISTS (SELECT FROM change WHERE node_id = to_node) THEN last / length ELSE 1 END) AS line
      FROM (SELECT e.*, ST_Force2D(e.geom) AS line, ST_Length(ST_Force2D(e.geom)) AS length, a.abscissa AS first, b.abscissa AS last
            FROM :"model".edge e JOIN :"model".section_limit a ON a.edge_id = e.edge_id AND a.which = 'start' JOIN :"model".section_limit b ON b.edge_id = e.edge_id AND b.which = 'end'
            WHERE abs(width - width_end) < 1e-9) e) e
GROUP BY axis_id;
CREATE INDEX ON axis_buffer USING gist (buffer);
CREATE TEMPORARY TABLE fillet AS
SELECT k.node_id, ST_BuildArea(ST_Node(ST_MakeLine(ARRAY[ring, ST_StartPoint(ring)]))) AS ground
FROM :"model".corner k JOIN pair p USING (node_id, edge_a, end_a, edge_b, end_b)
CROSS JOIN LATERAL (SELECT ST_CurveToLine(arc, 16) AS kerb) c
CROSS JOIN LATERAL (SELECT ST_MakeLine(ARRAY[kerb,
    ST_Reverse(ST_LineSubstring(line_b, 0, ST_LineLocatePoint(line_b, ST_EndPoint(kerb)))), ST_LineSubstring(line_a, 0, ST_LineLocatePoint(line_a, ST_StartPoint(kerb)))]) AS ring) r
WHERE arc IS NOT NULL
UNION ALL -- an arc that touches the round end of a border behind the node: the end up to there
SELECT node_id, ST_Intersection(ST_Buffer(node, half, 64), ST_MakePolygon(ST_MakeLine(ARRAY[node, ST_Translate(node, 3 * kx, 3 * ky),
           ST_Translate(node, 3 * (kx + tx), 3 * (ky + ty)), ST_Translate(node, 3 * tx, 3 * ty), node])))
FROM (SELECT node_id, node, half, half * sin(kerb) AS kx, half * cos(kerb) AS ky, ST_X(touch) - ST_X(node) AS tx, ST_Y(touch) - ST_Y(node) AS ty
      FROM :"model".corner k JOIN pair p USING (node_id, edge_a, end_a, edge_b, end_b)
      CROSS JOIN LATERAL (VALUES (line_a, half_a, azimuth_a - pi() / 2, ST_StartPoint(arc)), (line_b, half_b, azimuth_b + pi() / 2, ST_EndPoint(arc))) v(line, half, kerb, touch)
      CROSS JOIN LATERAL (SELECT ST_StartPoint(line) AS node) n
      WHERE arc IS NOT NULL AND ST_LineLocatePoint(line, touch) = 0) t
WHERE kx * tx + ky * ty < half * half * (1 - 1e-6)
UNION ALL
SELECT node_id, ST_Buffer(ST_StartPoint(line_a), least(half_a, half_b), 64) FROM pair WHERE degree = 2 AND node_id NOT IN (SELECT node_id FROM change);
CREATE INDEX ON fillet USING gist (ground);
ANALYZE axis_buffer; ANALYZE fillet;

-- Piece by piece, also without what tapers within a section.
CREATE TEMPORARY TABLE full_width AS
SELECT axis_id, ST_Buffer(ST_LineMerge(ST_Collect(line)), min(half), 'endcap=flat join=round quad_segs=16') AS buffer
FROM (SELECT axis_id, start_abscissa, width / 2 AS half, ST_LineSubstring(line,
             CASE WHEN EXISTS (SELECT FROM change WHERE node_id = from_node) THEN least(first, last) / length ELSE 0 END,
             CASE WHEN EXISTS (SELECT FROM change WHERE node_id = to_node) THEN last / length ELSE 1 END) AS line
      FROM (SELECT e.*, ST_Force2D(e.geom) AS line, ST_Length(ST_Force2D(e.geom)) AS length,
                -- A taper that goes on within the section ends at 0.4 of the edge.
                CASE WHEN abs(ST_Length(a.border_line) - e.width) > 0.005 THEN greatest(a.abscissa, 0.4 * ST_Length(ST_Force2D(e.geom))) ELSE a.abscissa END AS first,
                CASE WHEN abs(ST_Length(b.border_line) - e.width) > 0.005 THEN least(b.abscissa, 0.6 * ST_Length(ST_Force2D(e.geom))) ELSE b.abscissa END AS last
            FROM :"model".edge e JOIN :"model".section_limit a ON a.edge_id = e.edge_id AND a.which = 'start' JOIN :"model".section_limit b ON b.edge_id = e.edge_id AND b.which = 'end'
            WHERE abs(width - width_end) < 1e-9) e) e
GROUP BY axis_id;
CREATE TEMPORARY TABLE uncovered AS
SELECT axis_id, ST_Area(buffer) AS area, ST_Area(missing) AS missing_area, missing
FROM full_width CROSS JOIN LATERAL (SELECT pg_temp.remainder(buffer, ARRAY(SELECT surface FROM surface s WHERE s.surface && buffer)) AS missing) m;
INSERT INTO finding SELECT 'buffer outside roadway', 'axis', axis_id, missing_area, missing FROM uncovered WHERE missing_area > 0.0005 * area;

CREATE TEMPORARY TABLE excess AS
SELECT kind, id, ST_Area(surface) AS area, ST_Area(beyond) AS excess_area, beyond
FROM surface s CROSS JOIN LATERAL (SELECT pg_temp.remainder(surface, ARRAY(
    SELECT buffer FROM axis_buffer WHERE buffer && surface UNION ALL SELECT ground FROM fillet WHERE ground && surface)) AS beyond) d
WHERE NOT (kind = 'intersection' AND EXISTS (SELECT FROM change WHERE node_id = id))
  AND NOT (kind = 'section' AND EXISTS (SELECT FROM :"model".edge e WHERE e.edge_id = s.id AND abs(width - width_end) >= 1e-9));
INSERT INTO finding SELECT 'roadway outside buffers and fillets', kind, id, excess_area, beyond FROM excess WHERE excess_area > greatest(0.01, 0.001 * area);

-- Each limit's border line lies on the boundary of both neighbours, where nothing was given away; a loop whose limits cross is all
-- one intersection. Where a street ends on roadway of its own, be it a turning loop's, there is one neighbour and no boundary.
CREATE TEMPORARY TABLE giving AS
SELECT edge_id FROM :"model".section WHERE contested_area > 0
UNION SELECT edge_id FROM :"model".edge JOIN :"model".intersection ON node_id = from_node WHERE contested_area > 0
UNION SELECT edge_id FROM :"model".edge JOIN :"model".intersection ON node_id = to_node WHERE contested_area > 0;
CREATE TEMPORARY TABLE border AS
SELECT l.section_limit_id, l.border_line, array_agg(s.surface) AS neighbours
FROM :"model".section_limit l JOIN :"model".edge e USING (edge_id)
CROSS JOIN LATERAL (SELECT CASE which WHEN 'start' THEN from_node ELSE to_node END AS near, CASE which WHEN 'start' THEN to_node ELSE from_node END AS far) o
CROSS JOIN LATERAL (VALUES ('section', edge_id), ('intersection', near), ('intersection', CASE l.method WHEN 'crossed_limits' THEN far END)) n(kind, id)
JOIN surface s ON s.kind = n.kind AND s.id = n.id
WHERE NOT EXISTS (SELECT FROM giving g WHERE g.edge_id = e.edge_id) AND NOT (near = far AND l.method = 'crossed_limits') GROUP BY l.section_limit_id;
INSERT INTO finding
SELECT CASE WHEN alone AND bool_or(inside) THEN 'street ends on its own roadway' ELSE 'border line off a boundary' END, 'section_limit', section_limit_id, max(off), border_line FROM (
    SELECT b.*, cardinality(neighbours) = 1 AS alone, ST_Covers(n, p) AS inside, ST_Distance(ST_Boundary(n), p) AS off FROM border b, unnest(neighbours) n, generate_series(0, 4) t, ST_LineInterpolatePoint(border_line, t / 4.0) p) p
GROUP BY section_limit_id, border_line, alone HAVING max(off) > 1e-3;

-- Holes of a level's union that no surface fills by right: of the level (GEOS loses some of many in a union), or of another that tiles
-- with one of the level, since an edge of both is its own or ends there; 1e-6 m2, or a width of 1e-7 m, is the noise of coordinates.
INSERT INTO finding
SELECT 'hole', 'level', level, ST_Area(open), open FROM (
    SELECT level, ST_Difference(hole, coalesce((
        SELECT ST_Union(b.surface) FROM surface b
        WHERE b.surface && hole AND (b.level = r.level OR EXISTS (SELECT FROM surface a WHERE a.level = r.level AND CASE
            WHEN a.kind = 'section' THEN b.kind = 'intersection' AND b.id IN (a.node_a, a.node_b) WHEN b.kind = 'section' THEN a.id IN (b.node_a, b.node_b)
            ELSE EXISTS (SELECT FROM :"model".edge WHERE (from_node, to_node) IN ((a.id, b.id), (b.id, a.id))) END))), ST_SetSRID('POLYGON EMPTY'::geometry, ST_SRID(hole)))) AS open
    FROM (SELECT level, ST_MakePolygon(ST_ExteriorRing((ST_DumpRings(part)).geom)) AS hole, (ST_DumpRings(part)).path[1] AS ring
          FROM (SELECT level, (ST_Dump(ST_Union(surface))).geom AS part FROM surface GROUP BY level) u) r
    WHERE ring > 0 AND ST_Area(hole) BETWEEN 1e-6 AND 0.5) o
WHERE ST_Area(open) > greatest(1e-6, 1e-7 * ST_Perimeter(open) / 2);

-- T junctions on a street that is straight on both sides: how far the kerb opposite to the side street leaves its line. Noded at a micrometre: without a
-- grid GEOS leaves whole bands where two edges run beside each other.
CREATE TEMPORARY TABLE tee AS
SELECT p.node_id, l.method <> 'crossed_limits' AND reach > 0 AS free, surface, line, half, ST_MakePolygon(ST_MakeLine(ARRAY[o, t, ST_Translate(t, 30 * nx, 30 * ny), ST_Translate(o, 30 * nx, 30 * ny), o])) AS strip,
       ST_MakePolygon(ST_MakeLine(ARRAY[o, t, ST_Translate(t, half * nx, half * ny), ST_Translate(o, half * nx, half * ny), o])) AS band
FROM pair p JOIN :"model".intersection i ON i.node_id = p.node_id AND i.contested_area = 0
CROSS JOIN LATERAL (VALUES (line_a, length_a, azimuth_a, half_a, edge_a, end_a, 1), (line_b, length_b, azimuth_b, half_b, edge_b, end_b, -1)) s(line, length, azimuth, half, edge_id, which, side)
JOIN :"model".section_limit l ON l.edge_id = s.edge_id AND l.which = s.which
CROSS JOIN LATERAL (SELECT CASE l.which WHEN 'start' THEN l.abscissa ELSE length - l.abscissa END - 0.5 AS reach, -side * cos(azimuth) AS nx, side * sin(azimuth) AS ny, ST_StartPoint(line) AS o) r
CROSS JOIN LATERAL (SELECT ST_Translate(o, reach * sin(azimuth), reach * cos(azimuth)) AS t, least(length, greatest(reach, 0) + half) AS far) e
WHERE degree = 3 AND abs(phi - pi()) < radians(0.5) AND constant AND abs(half_a - half_b) < 1e-6
  AND ST_Distance(ST_LineInterpolatePoint(line, far / length), ST_Translate(o, far * sin(azimuth), far * cos(azimuth))) < 1e-3;
DELETE FROM tee WHERE NOT free OR node_id IN (SELECT node_id FROM tee GROUP BY node_id HAVING count(*) < 2);
CREATE TEMPORARY TABLE departure AS
SELECT node_id, max(off) AS departure, ST_Union(part) AS geom FROM (
    SELECT node_id, abs(ST_Distance(d.geom, line) - half) AS off, part
    FROM tee CROSS JOIN LATERAL (VALUES (ST_Difference(ST_CollectionExtract(ST_Intersection(surface, strip, 1e-6), 3), band, 1e-6)), (ST_Difference(band, surface, 1e-6))) q(part) CROSS JOIN LATERAL ST_DumpPoints(part) d
    WHERE NOT ST_IsEmpty(ST_Buffer(part, -0.001))
    UNION ALL SELECT node_id, 0, NULL FROM tee) o GROUP BY node_id;
INSERT INTO finding SELECT 'opposite kerb of a T departs', 'node', node_id, 100 * departure, geom FROM departure WHERE departure > 0.01;

-- Inside a loop: what is neither flat buffer nor fillet.
CREATE TEMPORARY TABLE filled AS
    SELECT e.edge_id, ST_Union(ST_Intersection(x.beyond, ST_BuildArea(ST_Node(ST_Force2D(e.geom))))) AS filled
    FROM :"model".edge e JOIN excess x ON x.beyond && e.geom WHERE from_node = to_node GROUP BY e.edge_id;
INSERT INTO finding SELECT 'inside of a loop filled', 'edge', edge_id, ST_Area(filled), filled FROM filled WHERE ST_Area(filled) > 0.01;
