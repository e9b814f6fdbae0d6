\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Lines lie before the kerb of the street crossed, wherever the lanes end.  (name, holds)
-- A road 8 m wide along the x axis; from the south a street by 30 degrees, one with wide corners, two carriageways that come together; a ring.
CREATE FUNCTION at(x float8, y float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('held', 2154, subjects => '{signal}'), streetgen.create_model('anew', 2154, subjects => '{signal}');
  PERFORM set_config('search_path', 'held, public', false);
  INSERT INTO held.axis (axis_id, geom, width, importance, lane_count, radius) OVERRIDING SYSTEM VALUE VALUES
    (1, ST_MakeLine(at(-200, 0), at(0, 0)), 8, 3, 2, 6), (2, ST_MakeLine(at(0, 0), at(300, 0)), 8, 3, 2, 6), (3, ST_MakeLine(at(300, 0), at(600, 0)), 8, 3, 2, 6), (4, ST_MakeLine(at(600, 0), at(800, 0)), 8, 3, 2, 6),
    (5, ST_MakeLine(at(-150 * cos(pi() / 6), -150 * sin(pi() / 6)), at(0, 0)), 6, 4, 2, 6), (6, ST_MakeLine(at(300, -200), at(300, 0)), 6, 4, 2, 15);
  INSERT INTO held.axis (axis_id, geom, width, importance, lane_count, direction) OVERRIDING SYSTEM VALUE VALUES
    (7, ST_MakeLine(at(600 + 200 * sin(pi() / 18), -200 * cos(pi() / 18)), at(600, 0)), 6, 4, 1, 'direct'), (8, ST_MakeLine(at(600, 0), at(600 - 200 * sin(pi() / 18), -200 * cos(pi() / 18))), 6, 4, 1, 'direct');
  INSERT INTO held.axis (axis_id, geom, width, importance, lane_count, direction, roundabout_tag) OVERRIDING SYSTEM VALUE
  SELECT 9, ST_MakeLine(array_agg(at(300 + 20 * sin(i * pi() / 18), -220 + 20 * cos(i * pi() / 18)) ORDER BY -i)), 7, 4, 1, 'direct', 'roundabout' FROM generate_series(0, 36) i;
END $$;
-- How far the line of a street is from the road, or from the ring, along its lane; by its nearer corner.
CREATE VIEW line AS SELECT e.axis_id, m.kind, m.node_id, m.surface, m.geom, m.lane_position, m.edge_id, m.along_axis FROM held.marking m JOIN held.edge e USING (edge_id) WHERE m.kind <> 'arrow';
CREATE FUNCTION to_road(axis bigint) RETURNS float8 LANGUAGE sql AS $$
  SELECT ST_Distance(ST_Buffer(geom, 0.25, 'endcap=flat'), ST_SetSRID(ST_MakeEnvelope(649000, 6859996, 652000, 6860004), 2154)) FROM line WHERE axis_id = axis AND ST_Y(ST_Centroid(geom)) > 6859900 $$;
CREATE FUNCTION near(a float8, b float8) RETURNS boolean LANGUAGE sql IMMUTABLE AS $$ SELECT abs(a - b) < 1e-6 $$;
SELECT 'by 30 degrees the nearer corner lies half a metre along the lane before the kerb' AS name, near(to_road(5), 0.5 * sin(pi() / 6)) AS holds;
SELECT 'corners of 15 m leave the line at the kerb', near(to_road(6), 0.5);
-- By 20 degrees; the lane is 4 m wide, the other carriageway 6 m.
SELECT 'carriageways that come together wait where they begin to share ground', near(ST_Distance(ST_LineInterpolatePoint(geom, 0.5), at(600, 0)), (3 + 2 * cos(pi() / 9)) / sin(pi() / 9) + 0.75) FROM line WHERE axis_id = 7;
SELECT 'at a ring as far from its roadway', count(*) = 1 AND bool_and(abs(ST_Distance(ST_LineInterpolatePoint(geom, 0.5), at(300, -220)) - 20 - 3.5 - 0.75) < 0.1) FROM line WHERE axis_id = 6 AND ST_Y(ST_Centroid(geom)) < 6859900;
SELECT 'no line lies beside the roadway', NOT EXISTS (SELECT FROM line l WHERE NOT ST_Covers((SELECT ST_Buffer(ST_Union(surface), 1e-4) FROM held.roadway), l.surface));
UPDATE held.axis SET turn_forward = 'left;right', turn_backward = CASE axis_id WHEN 6 THEN 'right' END WHERE axis_id IN (5, 6, 7);
SELECT 'the arrow lies before the line, or before the end of its lane', count(*) > 3 AND bool_and(least(ST_Distance(ST_EndPoint(m.geom), l.geom), 5 + ST_Distance(l.geom, lane.geom)) > 4.9)
  FROM line l JOIN held.marking m USING (edge_id, lane_position, along_axis) JOIN held.lane USING (edge_id, lane_position) WHERE m.kind = 'arrow';
SELECT 'all is as from scratch', test.followed('held', 'anew');
CREATE TEMP TABLE before AS SELECT axis_id, node_id, geom FROM line;
UPDATE held.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (2, 5, 6);
SELECT 'streets drawn the other way have their lines at the same places', count(*) = (SELECT count(*) FROM line) AND bool_and(EXISTS (SELECT FROM line l WHERE l.axis_id = b.axis_id AND ST_HausdorffDistance(l.geom, b.geom) < 1e-6)) FROM before b;
SELECT 'and are as from scratch', test.followed('held', 'anew');
UPDATE held.axis SET width = 12 WHERE axis_id = 2;
SELECT 'a wider road pushes the line back, in the edit', near(ST_YMax(geom), 6860000 - 6.75) AND test.followed('held', 'anew') FROM line WHERE axis_id = 6 AND ST_Y(ST_Centroid(geom)) > 6859900;
UPDATE held.axis SET width = 8 WHERE axis_id = 2;
INSERT INTO held.control_point (geom, kind) VALUES (at(300, 0), 'signals'), (at(0, 0), 'signals');
SELECT 'signal heads stand at the lines', count(*) = 6 AND bool_and(ST_Distance(h.geom, ST_LineInterpolatePoint(m.geom, 0.5)) < 1e-9) AND bool_or(near(ST_Y(h.geom), 6860000 - 4.75))
  FROM held.signal_head h JOIN held.lane l USING (lane_id) JOIN held.marking m ON (m.edge_id, m.lane_position, m.along_axis, m.kind) = (l.edge_id, l.lane_position, h.along_axis, 'stop');
SELECT 'the road waits before the kerbs of the street from the south', near(ST_XMin(l.geom), 650303.75) FROM line l JOIN held.edge e USING (edge_id) WHERE l.axis_id = 3 AND l.kind = 'stop';
SELECT streetgen.set('held', 'driving_side', 'left') \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'where traffic keeps left the line lies on the other side, as far off', near(to_road(6), 0.5) AND ST_XMax(geom) <= 650300 + 1e-6 FROM line WHERE axis_id = 6 AND ST_Y(ST_Centroid(geom)) > 6859900;
SELECT streetgen.set('held', 'line_before_kerb', '1.5') \g /dev/null
SELECT relation, updated FROM streetgen.generate('held') WHERE relation = 'marking' \g /dev/null
SELECT 'the setting says how far', near(to_road(6), 1.5) AND test.followed('held', 'anew');
