\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- A ring in place of a crossing.  (name, holds)
CREATE FUNCTION pg_temp.line(wkt text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText(wkt, 2154), 650000, 6860000) $$;
CREATE PROCEDURE pg_temp.draw(model name) LANGUAGE plpgsql AS $$ BEGIN
  -- A street that leads through, one that ends there, and one that bends behind the node.
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count, name, importance, kind) VALUES
    (1, pg_temp.line(''LINESTRING(-100 0, 0 0, 100 10)''), 9, 2, ''main'', 3, ''secondary''), (2, pg_temp.line(''LINESTRING(0 80, 0 0)''), 6, 2, ''end'', 4, ''tertiary''),
    (3, pg_temp.line(''LINESTRING(0 0, 5 -10, 5 -90)''), 6, 2, ''bend'', 5, ''residential'')', model);
END $$;
CREATE FUNCTION pg_temp.node_at(model name) RETURNS bigint LANGUAGE plpgsql AS $$ DECLARE found bigint; BEGIN
  EXECUTE format('SELECT node_id FROM %I.node ORDER BY geom <-> pg_temp.line(''POINT(0 0)'') LIMIT 1', model) INTO found; RETURN found; END $$;
DO $$ DECLARE side text; BEGIN
  FOREACH side IN ARRAY '{right,left}'::text[] LOOP
    PERFORM streetgen.create_model('town_' || side, 2154, subjects => '{junction,roundabout}', driving_side => side);
    EXECUTE format('CALL pg_temp.draw(%L)', 'town_' || side);
    PERFORM streetgen.make_roundabout('town_' || side, pg_temp.node_at('town_' || side), 18);
  END LOOP;
END $$;
CREATE VIEW ring AS SELECT 'right' AS side, a.*, r.accepted, r.radius AS measured, r.kind AS shape, r.roundabout_id FROM town_right.axis a, town_right.roundabout r WHERE roundabout_tag = 'roundabout'
  UNION ALL SELECT 'left', a.*, r.accepted, r.radius, r.kind, r.roundabout_id FROM town_left.axis a, town_left.roundabout r WHERE roundabout_tag = 'roundabout';
SELECT 'one ring each, a roundabout of that radius: ' || side, count(*) = 1 AND bool_and(accepted AND abs(measured - 18) < 0.1 AND shape = 'ring' AND ST_IsClosed(geom)) FROM ring GROUP BY side ORDER BY side;
SELECT 'drawn as traffic goes round: ' || side, bool_and(ST_IsPolygonCCW(ST_MakePolygon(geom)) = (side = 'right') AND direction = 'direct') FROM ring GROUP BY side ORDER BY side;
SELECT 'of the class of the most important arm, one lane, wider by the setting: ' || side, bool_and((kind, importance, lane_count, level, width) = ('secondary', 3, 1, 0, 3.5 + 2.5)) FROM ring GROUP BY side ORDER BY side;
SELECT 'no axis is left within', bool_and(ST_Distance(geom, pg_temp.line('POINT(0 0)')) > 17.9) AND count(*) = 5 FROM town_right.axis;
SELECT 'the pieces of an axis keep its values', count(*) = 2 AND bool_and((width, importance, kind) = (9, 3, 'secondary')) FROM town_right.axis WHERE name = 'main';
SELECT 'four arms come to it, and yield', (SELECT count(*) = 4 FROM town_right.roundabout_arm) AND (SELECT count(DISTINCT edge_id) = 4 FROM town_right.marking WHERE kind = 'yield');
SELECT 'every arm leads to every other', (SELECT count(*) = 4 AND bool_and(kind = 'roundabout') FROM town_right.junction WHERE kind <> 'end');
SELECT 'check_model finds nothing wrong: ' || side, NOT EXISTS (SELECT FROM streetgen.check_model('town_' || side) WHERE severity = 'error') FROM unnest('{right,left}'::text[]) side;
SELECT 'the ring has no node but where arms meet it', count(*) = 4 FROM town_right.edge JOIN ring ON ring.side = 'right' AND ring.axis_id = edge.axis_id;
SELECT 'what it made a run leaves', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town_right');
DO $$ BEGIN PERFORM streetgen.create_model('anew', 2154, subjects => '{junction,roundabout}', driving_side => 'right'); END $$;
INSERT INTO anew.axis SELECT * FROM town_right.axis;
SELECT 'and a model from scratch has the same', test.same('town_right', 'anew');

-- More lanes, three dimensions, a street that begins and ends at the node.
DO $$ BEGIN PERFORM streetgen.create_model('high', 2154, 3, subjects => '{roundabout}', driving_side => 'right'); END $$;
INSERT INTO high.axis (geom, width, lane_count, level) VALUES (ST_Force3DZ(pg_temp.line('LINESTRING(-100 0, 0 0, 100 0)'), 40), 14, 4, 1), (ST_Force3DZ(pg_temp.line('LINESTRING(0 0, 60 60, -60 60, 0 0)'), 40), 6, 2, 1);
SELECT streetgen.make_roundabout('high', pg_temp.node_at('high'), 20) \g /dev/null
SELECT 'two lanes lead to it, so that it has two, on their level and at their height', (SELECT (lane_count, width, level, ST_ZMin(geom), ST_ZMax(geom)) = (2, 9.5::float8, 1, 40::float8, 40::float8) FROM high.axis WHERE roundabout_tag IS NOT NULL)
  AND (SELECT count(*) = 4 FROM high.roundabout_arm JOIN high.roundabout USING (roundabout_id) WHERE accepted) AND (SELECT bool_or(accepted AND abs(radius - 20) < 0.1) FROM high.roundabout);

-- Refused, and nothing is done.
DO $$ BEGIN PERFORM streetgen.create_model('kept', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right'); END $$;
CALL pg_temp.draw('kept');
INSERT INTO kept.axis (axis_id, geom, width, name) VALUES (4, pg_temp.line('LINESTRING(30 -60, 30 -20, 80 -20)'), 5, 'beside');
CREATE TABLE before AS SELECT * FROM test.content('kept');
SELECT 'refused: ' || said, (r).state = '22023' AND (r).said LIKE said AND coalesce((r).detail, '') LIKE detail FROM (VALUES
  (pg_temp.node_at('kept'), 90::float8, 'radius is 90 m, expected 3 to 60', ''), (pg_temp.node_at('kept'), 'NaN', 'radius is NaN m%', ''), (0, 20, 'model "kept" has no node 0', ''),
  ((SELECT from_node FROM kept.edge WHERE axis_id = 4), 5, 'node % has 1 arms, expected three and more', ''),
  (pg_temp.node_at('kept'), 40, 'a ring of 40 m about node % has no room', 'Axis 4 passes within.')) v(node, metres, said, detail),
  LATERAL (SELECT test.refusal(format('SELECT streetgen.make_roundabout(''kept'', %s, %L)', node, metres)) AS r) t;
UPDATE kept.axis SET geom = pg_temp.line('LINESTRING(0 30, 0 0)') WHERE axis_id = 2;
SELECT 'refused where an arm ends within', (r).state = '22023' AND (r).detail = 'Axis 2 has its end or its next node within.' AND (r).hint = 'Take a smaller radius.'
  FROM (SELECT test.refusal(format('SELECT streetgen.make_roundabout(''kept'', %s, 32)', pg_temp.node_at('kept'))) AS r) t;
UPDATE kept.axis SET geom = pg_temp.line('LINESTRING(0 80, 0 0)') WHERE axis_id = 2;
SELECT 'nothing was done', NOT EXISTS ((SELECT test.content('kept') EXCEPT TABLE before) UNION ALL (TABLE before EXCEPT SELECT test.content('kept')));
SELECT 'NULL is refused', test.state($q$SELECT streetgen.make_roundabout('kept', NULL, 20)$q$) = '22004';
SELECT 'an unknown model is refused', test.state($q$SELECT streetgen.make_roundabout('nowhere', 1, 20)$q$) = '3F000';
