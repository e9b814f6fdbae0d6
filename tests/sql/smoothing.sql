\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Setting smoothing = arcs: edges as straight pieces and arcs, live. Each row is a truth (name, holds).
SELECT streetgen.create_model('road', 2154), streetgen.create_model('again', 2154), streetgen.set('road', 'smoothing', 'arcs') \g /dev/null
-- A road of two axes that bends at the node between, a side street, and a street on its own.
INSERT INTO road.axis (axis_id, geom, width) SELECT axis_id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 6 FROM (VALUES
  (1, 'LINESTRING(0 0, 60 0, 100 30)'), (2, 'LINESTRING(100 30, 140 70, 200 70)'), (3, 'LINESTRING(200 70, 200 150)'),
  (4, 'LINESTRING(200 70, 280 50, 300 20)'), (5, 'LINESTRING(0 200, 50 200)')) a(axis_id, line);
CREATE FUNCTION pg_temp.axis(id bigint) RETURNS geometry LANGUAGE sql AS $$ SELECT geom FROM road.axis WHERE axis_id = id $$;
SELECT 'edges have the points of arcs', (SELECT bool_and(ST_NPoints(geom) > 5) FROM road.edge WHERE axis_id IN (1, 2, 4));
SELECT 'one without bends stays', (SELECT bool_and(ST_Equals(geom, pg_temp.axis(axis_id)) AND ST_NPoints(geom) = 2) FROM road.edge WHERE axis_id IN (3, 5));
SELECT 'ends are those of the axes', (SELECT bool_and(ST_Equals(ST_StartPoint(geom), ST_StartPoint(pg_temp.axis(axis_id))) AND ST_Equals(ST_EndPoint(geom), ST_EndPoint(pg_temp.axis(axis_id)))) FROM road.edge);
SELECT 'no point of an axis is farther than the shift', (SELECT bool_and(ST_HausdorffDistance(geom, pg_temp.axis(axis_id)) <= 0.51) FROM road.edge);
SELECT 'abscissas are those of the axes', (SELECT bool_and(start_abscissa = 0 AND abs(end_abscissa - ST_Length(pg_temp.axis(axis_id))) < 1e-9) FROM road.edge);
-- The chord of an arc of radius r turns by 2 acos(1 - tolerance / r), 8.2 degrees where r is 4 m and less where r is more.
SELECT 'two edges go on with one tangent', (SELECT degrees(abs(ST_Angle(ST_PointN(a.geom, -2), ST_EndPoint(a.geom), ST_PointN(b.geom, 2)) - pi())) < 8.2
  FROM road.edge a, road.edge b WHERE a.axis_id = 1 AND b.axis_id = 2);
SELECT 'the axes do not', (SELECT degrees(abs(ST_Angle(ST_PointN(a.geom, -2), ST_EndPoint(a.geom), ST_PointN(b.geom, 2)) - pi())) > 8.1 FROM road.axis a, road.axis b WHERE a.axis_id = 1 AND b.axis_id = 2);
SELECT 'the model is sound', (SELECT count(*) = 0 FROM streetgen.check_model('road') WHERE severity = 'error');

-- Live: what turns the tangent at a node turns the edge that goes on, too.
CREATE TEMPORARY TABLE before AS SELECT axis_id, geom FROM road.edge;
UPDATE road.axis SET geom = ST_SetPoint(geom, 1, ST_Translate(ST_PointN(geom, 2), 5, -8)) WHERE axis_id = 1;
SELECT 'an edit is as from scratch', test.followed('road', 'again');
SELECT 'it turns the edge that goes on', (SELECT NOT ST_Equals(b.geom, e.geom) FROM before b JOIN road.edge e USING (axis_id) WHERE axis_id = 2);
SELECT 'and no other one', (SELECT bool_and(b.geom::bytea = e.geom::bytea) FROM before b JOIN road.edge e USING (axis_id) WHERE axis_id > 2);
INSERT INTO road.axis (axis_id, geom, width) VALUES (6, ST_Translate('SRID=2154;LINESTRING(100 30, 100 -60)'::geometry, 650000, 6860000), 6);
SELECT 'a street that comes to the node makes a junction of it, as from scratch', test.followed('road', 'again');
SELECT 'there edges leave as their axes do', (SELECT abs(sin(ST_Angle(ST_PointN(e.geom, -2), ST_EndPoint(e.geom), ST_PointN(a.geom, -2)))) < 1e-6 FROM road.edge e, road.axis a WHERE e.axis_id = 1 AND a.axis_id = 1);
DELETE FROM road.axis WHERE axis_id = 6;
SELECT 'and when it goes the tangent is back, as from scratch', test.followed('road', 'again');
SELECT streetgen.set('road', 'smoothing_shift', '3'), streetgen.generate('road') \g /dev/null
SELECT 'more shift is more radius', (SELECT bool_or(ST_HausdorffDistance(geom, pg_temp.axis(axis_id)) BETWEEN 1 AND 3.01) FROM road.edge);
SELECT streetgen.set('road', 'smoothing', 'none'), streetgen.generate('road') \g /dev/null
SELECT 'without smoothing edges are their axes', (SELECT bool_and(ST_Equals(geom, pg_temp.axis(axis_id))) FROM road.edge);

-- Decisions by hand stay where they were put along the axis.
SELECT streetgen.set('road', 'smoothing', 'arcs'), streetgen.set('road', 'smoothing_shift', '1'), streetgen.generate('road') \g /dev/null
INSERT INTO road.section_limit_override (axis_id, abscissa, which) SELECT 1, 0.7 * ST_Length(geom), 'end' FROM road.axis WHERE axis_id = 1;
SELECT 'a limit by hand lies at its share of the edge', (SELECT abs(ST_LineLocatePoint(e.geom, l.geom) - 0.7) < 1e-6 FROM road.section_limit l JOIN road.edge e USING (edge_id) WHERE axis_id = 1 AND which = 'end' AND l.method = 'by_hand');
SELECT 'as from scratch', test.followed('road', 'again');
SELECT 'a second run finds nothing to do', (SELECT sum(inserted + updated + deleted) = 0 FROM streetgen.generate('road'));
