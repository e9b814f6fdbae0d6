\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Interconnections in a model: restrictions, settings, overrides, conflicts.  (name, holds)
-- A crossing of four streets of a lane each way, the third with two.
CREATE FUNCTION pg_temp.fill(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  PERFORM streetgen.create_model(model, 2154), streetgen.live(model, false);
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, lane_count, importance) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 3.5 * lanes, lanes, 4 FROM (VALUES
    (1, 'LINESTRING(-100 0,0 0)', 2), (2, 'LINESTRING(0 -100,0 0)', 2), (3, 'LINESTRING(0 0,100 0)', 4), (4, 'LINESTRING(0 0,0 100)', 2)) v(id, line, lanes)$q$, model);
END $$;
DO $$ BEGIN
  PERFORM pg_temp.fill(m) FROM unnest(ARRAY['crossing', 'ruled', 'single']::name[]) m;
  PERFORM streetgen.generate(m) FROM unnest(ARRAY['crossing', 'ruled']::name[]) m;
END $$;
CREATE VIEW public.pair AS
  SELECT c.*, a.axis_id AS axis_in, i.ordinality AS ordinality_in, b.axis_id AS axis_out, o.ordinality AS ordinality_out, i.geom AS geom_in, o.geom AS geom_out
  FROM crossing.interconnection c JOIN crossing.lane i ON i.lane_id = c.lane_in JOIN crossing.edge a ON a.edge_id = i.edge_id JOIN crossing.lane o ON o.lane_id = c.lane_out JOIN crossing.edge b ON b.edge_id = o.edge_id;
CREATE FUNCTION pg_temp.again(edit text) RETURNS void LANGUAGE plpgsql AS $$ BEGIN EXECUTE edit; PERFORM streetgen.generate('crossing'); END $$;

-- 1, 2, 4 have one lane in and one out; 3 has two of each: 5 * 5 less those of the same edge, 1 + 1 + 1 + 4.
SELECT 'every lane in is paired with every lane out of another edge' AS name, (SELECT count(*) = 18 FROM pair) AS holds;
SELECT 'no other pair', NOT EXISTS (SELECT FROM pair WHERE axis_in = axis_out);
SELECT 'turn and angle: ' || turn, (SELECT bool_and(p.turn = e.turn AND abs(p.angle - e.angle) < 1e-6) FROM pair p WHERE axis_in = 1 AND axis_out = e.axis_out)
  FROM (VALUES (2, 'right', -90), (3, 'through', 0), (4, 'left', 90)) e(axis_out, turn, angle);
SELECT 'a path runs from the end of a lane to the start of the other',
  (SELECT bool_and(ST_StartPoint(geom) = CASE WHEN along_in THEN ST_EndPoint(geom_in) ELSE ST_StartPoint(geom_in) END
               AND ST_EndPoint(geom) = CASE WHEN along_out THEN ST_StartPoint(geom_out) ELSE ST_EndPoint(geom_out) END) FROM pair);
SELECT 'connecting is as plausible', (SELECT bool_and(connecting = plausible) FROM pair);
SELECT 'by the order of lanes', (SELECT array_agg(ordinality_in || '>' || ordinality_out ORDER BY ordinality_in, ordinality_out) FROM pair WHERE axis_in = 3 AND axis_out = 2 AND plausible) = '{1>1}';

SELECT 'each along its lanes', bool_and((c.along_in, c.along_out) = (i.along_axis, o.along_axis)) FROM crossing.interconnection c JOIN crossing.lane i ON i.lane_id = c.lane_in JOIN crossing.lane o ON o.lane_id = c.lane_out;

-- Restrictions.
SELECT pg_temp.again($q$INSERT INTO crossing.turn_restriction (from_axis, to_axis, geom, kind) VALUES (1, 4, 'SRID=2154;POINT(650000 6860000)', 'no')$q$) \g /dev/null
SELECT 'a restriction forbids', (SELECT bool_and(NOT plausible AND NOT connecting AND reason = 'restriction') FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT 'and nothing else', (SELECT bool_or(plausible) FROM pair WHERE axis_in = 1 AND axis_out = 3) AND (SELECT bool_or(plausible) FROM pair WHERE axis_in = 4 AND axis_out = 1);
SELECT 'a restriction has a place', NOT EXISTS (SELECT FROM streetgen.check_model('crossing') WHERE relation = 'turn_restriction');
SELECT pg_temp.again($q$INSERT INTO crossing.turn_restriction (from_axis, to_axis, geom, kind) VALUES (1, 4, 'SRID=2154;POINT(650000 6860000)', 'only')$q$) \g /dev/null
SELECT 'of contradictory restrictions the forbidding one holds', NOT EXISTS (SELECT FROM pair WHERE axis_in = 1 AND plausible);
SELECT 'contradictory restrictions are a warning', (SELECT count(*) = 1 FROM streetgen.check_model('crossing') WHERE rule = 'contradictory turn restrictions' AND severity = 'warning');
SELECT 'and so is the lane that they leave no way', EXISTS (SELECT FROM streetgen.check_model('crossing') WHERE rule = 'lane without a plausible way on' AND severity = 'notice');
SELECT pg_temp.again($q$UPDATE crossing.turn_restriction SET geom = ST_Translate(geom, 20, 0); DELETE FROM crossing.turn_restriction WHERE kind = 'only'$q$) \g /dev/null
SELECT 'a restriction without a place forbids nothing', (SELECT bool_or(plausible) FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT 'and is a warning', (SELECT count(*) = 1 FROM streetgen.check_model('crossing') WHERE rule = 'turn restriction without a place' AND severity = 'warning');
SELECT pg_temp.again('DELETE FROM crossing.turn_restriction') \g /dev/null

-- Overrides.
SELECT pg_temp.again($q$INSERT INTO crossing.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) VALUES ('SRID=2154;POINT(650000 6860000)', 1, 2, 4, 2, false)$q$) \g /dev/null
SELECT 'a user disconnects', (SELECT plausible AND NOT connecting AND method = 'by_hand' FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT pg_temp.again($q$UPDATE crossing.interconnection_override SET connecting = NULL, control = 'SRID=2154;POINT(649999 6860005)'$q$) \g /dev/null
SELECT 'a user draws the control point', (SELECT ST_Equals(control, 'SRID=2154;POINT(649999 6860005)') AND connecting = plausible
  AND ST_DWithin(geom, ST_SetSRID(ST_MakePoint((ST_X(ST_StartPoint(geom)) + 2 * 649999 + ST_X(ST_EndPoint(geom))) / 4, (ST_Y(ST_StartPoint(geom)) + 2 * 6860005 + ST_Y(ST_EndPoint(geom))) / 4), 2154), 0.05)
  FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT pg_temp.again('UPDATE crossing.axis SET width = 9 WHERE axis_id = 1') \g /dev/null
SELECT pg_temp.again('UPDATE crossing.axis SET width = 7 WHERE axis_id = 1') \g /dev/null
SELECT 'it holds over an edit and its undoing', (SELECT ST_Equals(control, 'SRID=2154;POINT(649999 6860005)') FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT 'a second run changes no row', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('crossing'));
SELECT 'generate counts what was decided by hand', (SELECT fallbacks = 1 FROM streetgen.generate('crossing') WHERE relation = 'interconnection');
SELECT pg_temp.again($q$INSERT INTO crossing.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) VALUES ('SRID=2154;POINT(650000 6860000)', 1, 2, 4, 2, false)$q$) \g /dev/null
SELECT 'of two overrides the younger holds', (SELECT NOT connecting FROM pair WHERE axis_in = 1 AND axis_out = 4);
SELECT pg_temp.again($q$INSERT INTO crossing.interconnection_override (geom, axis_in, lane_in, axis_out, lane_out, connecting) VALUES ('SRID=2154;POINT(650000 6860000)', 1, 7, 4, 2, true)$q$) \g /dev/null
SELECT 'an override for a lane that is gone stays and is a warning', (SELECT count(*) = 1 FROM streetgen.check_model('crossing') WHERE rule = 'interconnection override without a place' AND severity = 'warning')
  AND (SELECT count(*) = 3 FROM crossing.interconnection_override);
UPDATE crossing.interconnection_override SET connecting = true WHERE lane_in = 2;
SELECT 'an override that is not applied yet is stale', EXISTS (SELECT FROM streetgen.check_model('crossing') WHERE rule = 'stale: an interconnection override changed since');
SELECT pg_temp.again('DELETE FROM crossing.interconnection_override') \g /dev/null
SELECT 'without overrides the model is as it was', test.same('crossing', 'ruled');

-- Settings.
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'u_turn', 'true')$q$) \g /dev/null
-- At the crossing 1 + 1 + 1 + 4 more, at the four dead ends as many.
SELECT 'u_turn pairs lanes of one edge', (SELECT count(*) = 18 + 7 + 7 FROM pair);
SELECT 'these turn back', (SELECT bool_and(turn = 'u_turn') FROM pair WHERE axis_in = axis_out);
SELECT 'which is plausible at dead ends alone', (SELECT bool_and(plausible = (node_id IN (SELECT node_id FROM crossing.intersection)) IS FALSE) FROM pair WHERE axis_in = axis_out AND axis_in <> 3);
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'u_turn', 'false')$q$) \g /dev/null
SELECT 'without it they go', test.same('crossing', 'ruled');
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'trajectory_radius', '0')$q$) \g /dev/null
SELECT 'without a radius every path is that of the primitive', (SELECT bool_and(ST_Equals(p.geom, streetgen.interconnection(CASE WHEN along_in THEN geom_in ELSE ST_Reverse(geom_in) END, CASE WHEN along_out THEN geom_out ELSE ST_Reverse(geom_out) END, n.geom)))
  FROM pair p JOIN crossing.node n USING (node_id));
-- The least radius of the circles through successive quarter points, metres; straight lines have none.
CREATE FUNCTION pg_temp.least_radius(path geometry) RETURNS float8 LANGUAGE sql AS $$
  SELECT min(ST_Distance(p, q) * ST_Distance(q, r) * ST_Distance(p, r) / nullif(4 * ST_Area(ST_MakePolygon(ST_MakeLine(ARRAY[p, q, r, p]))), 0))
    FROM generate_series(0, 2) i, LATERAL (SELECT ST_LineInterpolatePoint(path, i / 4.0) AS p, ST_LineInterpolatePoint(path, (i + 1) / 4.0) AS q, ST_LineInterpolatePoint(path, (i + 2) / 4.0) AS r) v $$;
SELECT 'with a radius tight paths are wider', (SELECT count(*) > 0 AND bool_and(pg_temp.least_radius(b.geom) > pg_temp.least_radius(a.geom))
  FROM crossing.interconnection a JOIN ruled.interconnection b USING (lane_in, lane_out) WHERE NOT ST_Equals(a.geom, b.geom));
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'trajectory_radius', '15')$q$) \g /dev/null
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'trajectory', 'arcs')$q$) \g /dev/null
SELECT 'by arcs the path is that of the primitive', (SELECT bool_and(ST_Equals(p.geom, streetgen.interconnection(CASE WHEN along_in THEN geom_in ELSE ST_Reverse(geom_in) END, CASE WHEN along_out THEN geom_out ELSE ST_Reverse(geom_out) END, n.geom, 'arcs')))
  FROM pair p JOIN crossing.node n USING (node_id));
-- A rule of the user's: by the centre.
CREATE FUNCTION public.by_centre(lane_in geometry, lane_out geometry, centre geometry, tolerance float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS
  $$ SELECT ST_MakeLine(ARRAY[ST_EndPoint(lane_in), centre, ST_StartPoint(lane_out)]) $$;
CREATE FUNCTION public.nowhere(lane_in geometry, lane_out geometry, centre geometry, tolerance float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS $$ SELECT centre $$;
CREATE FUNCTION public.no_number(lane_in geometry, lane_out geometry, centre geometry, tolerance float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS
  $$ SELECT ST_MakeLine(ARRAY[ST_EndPoint(lane_in), ST_SetSRID(ST_MakePoint('NaN', 0), ST_SRID(centre)), ST_StartPoint(lane_out)]) $$;
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'trajectory', 'public.by_centre')$q$) \g /dev/null
SELECT 'a function of the user''s draws the paths', (SELECT bool_and(ST_NPoints(p.geom) = 3 AND ST_Equals(ST_PointN(p.geom, 2), n.geom) AND control IS NULL
    AND ST_StartPoint(p.geom) = CASE WHEN along_in THEN ST_EndPoint(geom_in) ELSE ST_StartPoint(geom_in) END) FROM pair p JOIN crossing.node n USING (node_id));
SELECT 'and changes nothing else', (SELECT array_agg((lane_in, lane_out, turn, plausible, reason)::text ORDER BY lane_in, lane_out) FROM crossing.interconnection) = (SELECT array_agg((lane_in, lane_out, turn, plausible, reason)::text ORDER BY lane_in, lane_out) FROM ruled.interconnection);
SELECT 'a second run with it writes no row', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('crossing'));
SELECT 'a function that draws no line is refused', test.state($q$SELECT pg_temp.again($e$SELECT streetgen.set('crossing', 'trajectory', 'public.nowhere')$e$)$q$) = '22023';
SELECT 'its name and result are said', test.said($q$SELECT pg_temp.again($e$SELECT streetgen.set('crossing', 'trajectory', 'public.nowhere')$e$)$q$) LIKE 'trajectory function public.nowhere gave SRID=2154;POINT%';
SELECT 'a function whose line has no numbers is refused, and its name and result are said', test.said($q$SELECT pg_temp.again($e$SELECT streetgen.set('crossing', 'trajectory', 'public.no_number')$e$)$q$) LIKE 'trajectory function public.no_number gave SRID=2154;LINESTRING%NaN%';
SELECT 'a function that is not there is refused', test.state($q$SELECT streetgen.set('crossing', 'trajectory', 'public.no_such')$q$) = '22023';
SELECT format('%s, which is no name, is refused', quote_literal(word)), test.state(format('SELECT streetgen.set(''crossing'', ''trajectory'', %L)', word)) = '22023'
  FROM unnest(ARRAY['', ' ', 'a b', 'a.b.c.d', 'public.', '"', '1', 'a''b', 'f(', 'public.by_centre(geometry, geometry, geometry, float8)']) word;
SELECT 'and one of another signature', test.state($q$SELECT streetgen.set('crossing', 'trajectory', 'st_makeline')$q$) = '22023';
DO $$ BEGIN PERFORM streetgen.live('crossing', true); END $$;
DROP FUNCTION public.by_centre;
SELECT 'an edit where the function is gone names it', state = '22023' AND said LIKE 'setting "trajectory" of model "crossing" cannot be ''public.by_centre''' AND detail <> '' AND hint <> '' FROM test.refusal('UPDATE crossing.axis SET width = 8 WHERE axis_id = 1');
DO $$ BEGIN PERFORM streetgen.live('crossing', false); END $$;
SELECT pg_temp.again($q$SELECT streetgen.set('crossing', 'trajectory', 'bezier')$q$) \g /dev/null
SELECT 'back to the paper''s rule', test.same('crossing', 'ruled');

-- Axis by axis.
DO $$ BEGIN
  PERFORM streetgen.generate('single', ARRAY[axis_id]) FROM (SELECT axis_id FROM single.axis ORDER BY axis_id DESC) a;
END $$;
SELECT 'axis by axis gives the same interconnections', test.same('single', 'ruled');

-- Conflicts.
SELECT 'paths of two lanes that cross are in conflict', (SELECT bool_and(ST_Intersects(a.geom, b.geom) AND a.lane_in <> b.lane_in AND a.lane_out <> b.lane_out AND a.connecting AND b.connecting)
  FROM crossing.conflict f JOIN crossing.interconnection a ON a.interconnection_id = interconnection_a JOIN crossing.interconnection b ON b.interconnection_id = interconnection_b WHERE kind = 'crossing');
SELECT 'paths into one lane merge at its start', (SELECT bool_and(a.lane_out = b.lane_out AND ST_Equals(f.geom, ST_EndPoint(a.geom)))
  FROM crossing.conflict f JOIN crossing.interconnection a ON a.interconnection_id = interconnection_a JOIN crossing.interconnection b ON b.interconnection_id = interconnection_b WHERE kind = 'merging');
SELECT 'left turns cross those who come straight on', EXISTS (SELECT FROM crossing.conflict f JOIN pair a ON a.interconnection_id = interconnection_a JOIN pair b ON b.interconnection_id = interconnection_b
  WHERE kind = 'crossing' AND (a.axis_in, a.axis_out, b.axis_in, b.axis_out) IN ((1, 4, 3, 1), (3, 1, 1, 4)));
SELECT 'paths from one lane are in no conflict', NOT EXISTS (SELECT FROM crossing.conflict f JOIN pair a ON a.interconnection_id = interconnection_a JOIN pair b ON b.interconnection_id = interconnection_b WHERE a.lane_in = b.lane_in);

-- What is counted and drawn.
SELECT 'the summary counts them', (SELECT sum(amount) = 18 FROM streetgen.summary('crossing') WHERE subject LIKE 'interconnections, %');
SELECT 'the picture shows plausible ones apart', svg ~ 'class="path"' AND svg ~ 'class="path implausible"' FROM streetgen.svg('crossing', theme => 'construction') svg;

-- Exceptions of restrictions: a bus lane of the street in the west.
SELECT pg_temp.again($q$UPDATE crossing.axis SET lane_count = 3, width = 10.5, kind_forward = 'general|bus', kind_backward = 'general' WHERE axis_id = 1;
  INSERT INTO crossing.turn_restriction (from_axis, to_axis, geom, kind, except_kinds) VALUES (1, 2, 'SRID=2154;POINT(650000 6860000)', 'no', 'bus')$q$) \g /dev/null
SELECT 'a restriction does not bind whom it excepts, on whatever lane', (SELECT array_agg(DISTINCT concat_ws(' ', l.kind, p.reason, p.traffic) ORDER BY concat_ws(' ', l.kind, p.reason, p.traffic)) FILTER (WHERE p.plausible) = '{bus lane_order bus,general traffic bus}' AND bool_and(p.plausible)
  FROM pair p JOIN crossing.lane l ON l.lane_id = p.lane_in WHERE axis_in = 1 AND axis_out = 2);
DO $$ BEGIN PERFORM streetgen.live('crossing', true); END $$;
UPDATE crossing.turn_restriction SET except_kinds = NULL;
SELECT 'without the exception it binds them too, at once', (SELECT bool_and(p.reason = 'restriction') FROM pair p WHERE axis_in = 1 AND axis_out = 2);
SELECT 'an exception for what has no lane is refused', test.state($q$UPDATE crossing.turn_restriction SET except_kinds = 'taxi'$q$) = '23514';

-- Lanes for both directions: a street through, whose axis goes on beyond the node, and one from the south.
DO $$ BEGIN
  PERFORM streetgen.create_model(m, 2154) FROM unnest(ARRAY['narrow', 'anew']::name[]) m;
  INSERT INTO narrow.axis (axis_id, geom, width) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 4 FROM (VALUES (1, 'LINESTRING(-80 0,0 0,80 0)'), (2, 'LINESTRING(0 -80,0 0)')) v(id, line);
END $$;
CREATE VIEW public.way AS
  SELECT c.*, a.axis_id AS axis_in, b.axis_id AS axis_out, i.geom AS geom_in, o.geom AS geom_out FROM narrow.interconnection c
  JOIN narrow.lane i ON i.lane_id = c.lane_in JOIN narrow.edge a ON a.edge_id = i.edge_id JOIN narrow.lane o ON o.lane_id = c.lane_out JOIN narrow.edge b ON b.edge_id = o.edge_id;
SELECT 'a lane for both directions comes in and goes out', (SELECT count(*) = 6 AND bool_and(plausible) FROM way)
  AND (SELECT array_agg(concat(axis_in, along_in, axis_out, along_out) ORDER BY axis_in, along_in, axis_out, along_out) = '{1f1f,1f2f,1t1t,1t2f,2t1f,2t1t}' FROM way);
SELECT 'its paths begin and end where one leaves and enters it', bool_and(ST_StartPoint(geom) = CASE WHEN along_in THEN ST_EndPoint(geom_in) ELSE ST_StartPoint(geom_in) END
  AND ST_EndPoint(geom) = CASE WHEN along_out THEN ST_StartPoint(geom_out) ELSE ST_EndPoint(geom_out) END) FROM way;
SELECT 'and run as one drives', bool_and(abs(ST_X(ST_PointN(geom, 2)) - 650000) < abs(ST_X(ST_StartPoint(geom)) - 650000)) FROM way WHERE axis_in <> axis_out AND axis_in = 1;
SELECT 'the model is sound', NOT EXISTS (SELECT FROM streetgen.check_model('narrow') WHERE severity <> 'notice' OR rule LIKE 'lane %');
SELECT 'who enters a lane opposes who leaves it', (SELECT array_agg(DISTINCT kind ORDER BY kind) = '{merging,opposing}' AND bool_and(ST_GeometryType(geom) = 'ST_Point') FROM narrow.conflict)
  AND EXISTS (SELECT FROM narrow.conflict f JOIN way a ON a.interconnection_id = interconnection_a JOIN way b ON b.interconnection_id = interconnection_b WHERE kind = 'opposing' AND a.axis_out = a.axis_in AND b.axis_in = b.axis_out);
UPDATE narrow.interconnection_editing SET connecting = false WHERE interconnection_id = (SELECT interconnection_id FROM way WHERE axis_in = 1 AND along_in AND axis_out = 2);
SELECT 'one decides of one way through it', (SELECT array_agg(concat(axis_in, along_in, axis_out, along_out)) = '{1t2f}' FROM way WHERE NOT connecting AND method = 'by_hand') AND (SELECT along_in AND NOT along_out FROM narrow.interconnection_override);
UPDATE narrow.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'the decision stays there when the axis is turned round', (SELECT array_agg(concat(axis_in, along_in, axis_out, along_out)) = '{1f2f}' FROM way WHERE NOT connecting AND method = 'by_hand') AND (SELECT NOT along_in FROM narrow.interconnection_override);
SELECT 'as a run from scratch has it', test.followed('narrow', 'anew');
UPDATE narrow.interconnection_editing SET by_hand = false WHERE by_hand;
SELECT 'and is taken back', NOT EXISTS (SELECT FROM narrow.interconnection_override) AND (SELECT bool_and(connecting) FROM way);
CREATE FUNCTION public.as_one_drives(lane_in geometry, lane_out geometry, centre geometry, tolerance float8) RETURNS geometry LANGUAGE sql IMMUTABLE AS $$ SELECT ST_MakeLine(ARRAY[ST_EndPoint(lane_in), centre, ST_StartPoint(lane_out)]) $$;
DO $$ BEGIN PERFORM streetgen.set('narrow', 'trajectory', 'as_one_drives'); PERFORM streetgen.generate('narrow'); END $$;
SELECT 'a function of the user''s gets its lines as one drives', bool_and(ST_Length(geom) < 40 AND ST_NPoints(geom) = 3) FROM way;
DO $$ BEGIN PERFORM streetgen.set('narrow', 'u_turn', 'true'); PERFORM streetgen.set('narrow', 'trajectory', 'bezier'); PERFORM streetgen.generate('narrow'); END $$;
SELECT 'it turns back upon itself at dead ends alone', (SELECT count(*) = 6 AND bool_and(turn = 'u_turn' AND along_in <> along_out) AND count(*) FILTER (WHERE plausible) = 3 FROM way WHERE lane_in = lane_out);
-- A closed street of one lane, with a way in.
DO $$ BEGIN
  PERFORM streetgen.set('narrow', 'u_turn', 'false');
  DELETE FROM narrow.axis;
  INSERT INTO narrow.axis (axis_id, geom, width) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 4 FROM (VALUES (1, 'LINESTRING(-80 0,0 0)'), (2, 'LINESTRING(0 0,60 50,120 0,60 -50,0 0)')) v(id, line);
  PERFORM streetgen.generate('narrow');
END $$;
SELECT 'both its ends are entered and left at one node', array_agg(concat(axis_in, along_in, axis_out, along_out) ORDER BY axis_in, along_in, axis_out, along_out) = '{1t2f,1t2t,2f1f,2t1f}' AND bool_and(plausible) FROM way;
