-- A town of streets 80 m long, and one random edit of it, which tests/battery/soak runs.
SELECT streetgen.create_model('town', 2154, subjects => '{interconnection,object}'), streetgen.create_model('anew', 2154, subjects => '{interconnection,object}') \g /dev/null
CREATE SCHEMA soak;

-- BLOCKS by BLOCKS blocks.
WITH place AS (SELECT x, y, ST_SetSRID(ST_Point(650000 + 80 * x + (x * 7 + y * 5) % 17, 6860000 + 80 * y + (x * 3 + y * 11) % 13), 2154) AS geom FROM generate_series(0, :blocks) x, generate_series(0, :blocks) y)
INSERT INTO town.axis (geom, width, importance) SELECT ST_MakeLine(a.geom, b.geom), 4 + (a.x * 5 + a.y * 3) % 12, 2 + (a.x + a.y) % 4
FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1)) ORDER BY a.x, a.y, b.x, b.y;
INSERT INTO town.placement_rule (type, along, side, every, axis_offset, distance_from_limit) VALUES ('lamp', 'border', 'alternating', 20, 0.8, 2), ('crossing', 'arm', 'alternating', 25, 0, 2.5);
ANALYZE town.axis;

CREATE FUNCTION soak.near(geom geometry, far float8) RETURNS geometry LANGUAGE sql VOLATILE
  RETURN ST_Translate(geom, far * (2 * random() - 1), far * (2 * random() - 1));

-- One decision by hand about something that an axis has, through its edit view; what another session took away meanwhile is refused.
CREATE FUNCTION soak.decide(chosen bigint) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  piece bigint := (SELECT edge_id FROM town.edge WHERE axis_id = chosen ORDER BY edge_id LIMIT 1);
BEGIN
  CASE floor(random() * 7)
    WHEN 0 THEN UPDATE town.lane_editing SET width = 2 + 2 * random() WHERE edge_id = piece AND ordinality = 1;
    WHEN 1 THEN UPDATE town.section_limit_editing SET abscissa = abscissa + 2 WHERE edge_id = piece AND which = 'start';
    WHEN 2 THEN UPDATE town.corner_editing SET radius = 8 * random() WHERE corner_id = (SELECT min(corner_id) FROM town.corner WHERE edge_a = piece);
    WHEN 3 THEN UPDATE town.interconnection_editing SET connecting = NOT connecting WHERE interconnection_id = (SELECT min(interconnection_id) FROM town.interconnection JOIN town.lane ON lane_id = lane_in WHERE edge_id = piece);
    WHEN 4 THEN INSERT INTO town.kerb_point_editing (axis_id, geom) SELECT axis_id, ST_Translate(ST_LineInterpolatePoint(geom, 0.5), 2, 3) FROM town.axis WHERE axis_id = chosen;
    WHEN 5 THEN UPDATE town.node_editing SET geom = soak.near(geom, 10) WHERE node_id = (SELECT from_node FROM town.edge WHERE edge_id = piece);
    ELSE DELETE FROM town.lane_editing WHERE edge_id = piece AND by_hand;
  END CASE;
EXCEPTION WHEN invalid_parameter_value THEN
  RETURN;
END $$;

-- One edit of what stands at an axis, through the edit view: put, dragged, or taken away.
CREATE FUNCTION soak.furnish(chosen bigint) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  standing bigint := (SELECT street_object_id FROM town.street_object WHERE axis_id = chosen ORDER BY random() LIMIT 1);
BEGIN
  CASE floor(random() * 3)
    WHEN 0 THEN INSERT INTO town.street_object_editing (type, geom) SELECT 'bench', soak.near(ST_LineInterpolatePoint(geom, random()), 6) FROM town.axis WHERE axis_id = chosen;
    WHEN 1 THEN UPDATE town.street_object_editing SET geom = soak.near(geom, 3) WHERE street_object_id = standing;
    ELSE DELETE FROM town.street_object_editing WHERE street_object_id = standing;
  END CASE;
EXCEPTION WHEN invalid_parameter_value THEN
  RETURN;
END $$;

-- One statement that touches one axis; the second piece of a split is the session's next, as QGIS has it.
CREATE FUNCTION soak.edit() RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  a town.axis;
  fresh geometry := nullif(current_setting('soak.second_piece', true), '');
  cut float8 := 0.2 + 0.6 * random();
BEGIN
  IF fresh IS NOT NULL THEN
    PERFORM set_config('soak.second_piece', '', false);
    INSERT INTO town.axis (geom, width) VALUES (fresh, 6);
    RETURN;
  END IF;
  SELECT * INTO a FROM town.axis WHERE axis_id >= (SELECT min(axis_id) + floor(random() * (max(axis_id) - min(axis_id) + 1)) FROM town.axis) ORDER BY axis_id LIMIT 1;
  CASE floor(random() * 21)
    WHEN 0, 1, 2 THEN UPDATE town.axis SET geom = ST_SetPoint(geom, floor(random() * ST_NPoints(geom))::integer, soak.near(ST_StartPoint(geom), 40)) WHERE axis_id = a.axis_id;
    WHEN 3, 4, 5 THEN UPDATE town.axis SET width = 3 + 15 * random() WHERE axis_id = a.axis_id;
    WHEN 6, 7 THEN INSERT INTO town.axis (geom, width, level) VALUES (ST_MakeLine(ST_EndPoint(a.geom), soak.near(ST_EndPoint(a.geom), 90)), 4 + 8 * random(), (random() < 0.1)::integer);
    WHEN 8, 9, 10 THEN DELETE FROM town.axis WHERE axis_id = a.axis_id;
    WHEN 11 THEN
      PERFORM set_config('soak.second_piece', ST_LineSubstring(a.geom, cut, 1)::text, false);
      UPDATE town.axis SET geom = ST_LineSubstring(a.geom, 0, cut) WHERE axis_id = a.axis_id;
    WHEN 12, 13, 14, 15 THEN PERFORM soak.decide(a.axis_id);
    WHEN 16, 17, 18 THEN PERFORM soak.furnish(a.axis_id);
    WHEN 19 THEN INSERT INTO town.lane_override (axis_id, abscissa, ordinality, width) VALUES (a.axis_id, random() * ST_Length(a.geom), 1, 2 + 2 * random());
    ELSE INSERT INTO town.transition_override (axis_id, which, kind, length) VALUES (a.axis_id, CASE WHEN random() < 0.5 THEN 'start' ELSE 'end' END, 'left', 20 * random());
  END CASE;
END $$;

-- The number of times that a client has tried its transaction: a sequence counts on where the transaction is undone.
SELECT format('CREATE SEQUENCE soak.attempt_%s', client) FROM generate_series(0, :sessions - 1) client \gexec

-- A transaction of several edits, and before each further attempt a random pause, longer each time: those that repeat at once
-- meet the same others again. pgbench repeats what fails with 40001 or 40P01: an edit that is refused (55P03) ends so.
CREATE FUNCTION soak.edits(many integer, client integer) RETURNS void LANGUAGE plpgsql VOLATILE AS $$
DECLARE
  attempt regclass := 'soak.attempt_' || client;
  before bigint := nextval(attempt) - 1;
BEGIN
  IF before > 0 THEN
    PERFORM pg_sleep(random() * least(0.05 * 2 ^ before, 8));
  END IF;
  BEGIN
    FOR i IN 1 .. many LOOP
      PERFORM soak.edit();
    END LOOP;
  EXCEPTION WHEN lock_not_available THEN
    RAISE EXCEPTION '%', SQLERRM USING ERRCODE = '40001';
  END;
  PERFORM setval(attempt, 1, false);
END $$;
