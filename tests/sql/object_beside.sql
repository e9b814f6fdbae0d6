\set ECHO none
\ir shared/truths.sql
-- Objects of rules beside an edit: those of other streets follow too, and what is far away stays.  (name, holds)
SET client_min_messages = warning;
SELECT streetgen.create_model('town', 2154, subjects => '{object,lane}') \g /dev/null
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.lamps(axis bigint) RETURNS integer[] LANGUAGE sql AS $$ SELECT array_agg(round(ST_X(geom) - 650000)::integer ORDER BY ST_X(geom)) FROM town.street_object WHERE type = 'lamp' AND axis_id = axis $$;
CREATE FUNCTION pg_temp.content() RETURNS SETOF text LANGUAGE sql AS $$
  SELECT concat_ws(' ', type, geom::text, angle, placement, axis_id, abscissa, abscissa_end, side, axis_offset, orientation, placed_by, rule_id, rule_place, method) FROM town.street_object
  UNION ALL SELECT concat_ws(' ', o.axis_id, o.abscissa, c.width, c.angle, c.surface::text, c.stripes::text) FROM town.pedestrian_crossing c JOIN town.street_object o USING (street_object_id)
  UNION ALL SELECT concat_ws(' ', o.axis_id, o.abscissa, b.width, b.angle, b.surface::text) FROM town.parking_bay b JOIN town.street_object o USING (street_object_id)
  UNION ALL SELECT concat_ws(' ', o.axis_id, o.rule_id, o.rule_place, e.start_abscissa) FROM town.object_edge x JOIN town.street_object o USING (street_object_id) JOIN town.edge e USING (edge_id)
  UNION ALL SELECT concat_ws(' ', kind, lane_position, along_axis, geom::text, surface::text) FROM town.marking $$;
-- Rows that a run over all objects changes.
CREATE FUNCTION pg_temp.unlike_all() RETURNS bigint LANGUAGE plpgsql SET streetgen.computes = 'on' AS $$
DECLARE
  stood constant text[] := ARRAY(SELECT pg_temp.content());
BEGIN
  PERFORM FROM town._place_objects(NULL);
  PERFORM streetgen._settle_lane('town', NULL);
  RETURN (SELECT count(*) FROM (SELECT unnest(stood) EXCEPT ALL SELECT pg_temp.content()) x) + (SELECT count(*) FROM (SELECT pg_temp.content() EXCEPT ALL SELECT unnest(stood)) x);
END $$;

-- Streets 3 and 5 lead to street 2, which goes on beside street 1 for 300 m; 4 lies beside 1 on the other side.
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(200 24, 500 24)'), 6), (2, pg_temp.line('LINESTRING(0 12, 500 12)'), 6), (3, pg_temp.line('LINESTRING(60 12, 60 -80)'), 6),
  (4, pg_temp.line('LINESTRING(200 36, 500 36)'), 6), (5, pg_temp.line('LINESTRING(120 12, 120 -80)'), 6);
UPDATE town.object_distance SET metres = 17 WHERE (type_a, type_b) = ('lamp', 'lamp');
INSERT INTO town.placement_rule (type, along, side, every, axis_offset, distance_from_limit) VALUES ('lamp', 'border', 'left', 20, 1, 2);
SELECT 'lamps of a later street give way to those of an earlier one', pg_temp.lamps(1) @> '{260,280,480}' AND pg_temp.lamps(4) IS NULL;
SELECT 'on both sides', pg_temp.lamps(2) @> '{20,40,80,140,160}' AND NOT pg_temp.lamps(2) && '{220,240,260,280,300,400,480}';
CREATE TABLE far AS SELECT street_object_id, xmin::text AS written FROM town.street_object WHERE ST_X(geom) > 650250;
UPDATE town.axis SET width = 9 WHERE axis_id = 3;
SELECT 'they do where another part of their street changes', pg_temp.lamps(2) @> '{20,140,160}' AND NOT pg_temp.lamps(2) && '{220,240,260,280,300,400,480}';
SELECT 'and what is far away is not written', bool_and(o.xmin::text = f.written) AND count(*) = (SELECT count(*) FROM far) FROM far f JOIN town.street_object o USING (street_object_id);
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(200 24, 350 24)') WHERE axis_id = 1;
SELECT 'where the earlier one ends, those of the later ones beside it come', pg_temp.lamps(2) @> '{400,420,480}' AND pg_temp.lamps(4) @> '{400,420,480}' AND NOT pg_temp.lamps(2) && '{220,240,260,300}';
SELECT 'as a run over all says', pg_temp.unlike_all() = 0;
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'where it goes they come all along', pg_temp.lamps(2) @> '{220,240,260,300}' AND pg_temp.lamps(4) @> '{220,240,260,300}';
INSERT INTO town.axis (axis_id, geom, width) VALUES (1, pg_temp.line('LINESTRING(200 24, 500 24)'), 6);
SELECT 'where it comes again they go', pg_temp.lamps(4) IS NULL AND NOT pg_temp.lamps(2) && '{220,240,260,280,300,400,480}';
SELECT 'as a run over all says too', pg_temp.unlike_all() = 0;

-- A town of narrow blocks, with all sorts of rules.
DELETE FROM town.axis;
DELETE FROM town.placement_rule;
INSERT INTO town.placement_rule (type, along, side, every, phase, axis_offset, distance_from_limit) VALUES ('crossing', 'arm', 'both', 25, 0, 0, 2.5), ('parking_bay', 'border', 'right', 6, 3, 0, 5),
  ('lamp', 'border', 'alternating', 12, 10, 0.8, 2), ('tree', 'border', 'both', 8, 0, 1.2, 5), ('bollard', 'corner', 'both', 3, 0, 0.5, 0), ('bench', 'border', 'right', 20, 7, 2, 5);
SELECT streetgen.set('town', 'crossing', 'split') \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) SELECT 10 + i, ST_Translate(pg_temp.line('LINESTRING(0 0, 60 0, 130 4, 200 0)'), 0, 40 * i), 6 + 2 * i FROM generate_series(0, 3) i;
INSERT INTO town.axis (axis_id, geom, width) SELECT 20 + i, ST_Translate(pg_temp.line('LINESTRING(0 -30, 0 150)'), 30 + 70 * i, 0), 5 + 3 * i FROM generate_series(0, 2) i;
SELECT 'a town of some hundred objects', count(*) > 150 AND count(DISTINCT type) = 6 FROM town.street_object;
CREATE PROCEDURE pg_temp.edit(i integer) LANGUAGE plpgsql AS $$
DECLARE
  id constant bigint := (SELECT axis_id FROM town.axis ORDER BY hashint8(axis_id * 100 + i) LIMIT 1);
BEGIN
  CASE i % 6
    WHEN 0 THEN UPDATE town.axis SET width = 4 + i % 7 WHERE axis_id = id;
    WHEN 1 THEN UPDATE town.axis SET geom = ST_Translate(geom, i % 3, i % 4) WHERE axis_id = id;
    WHEN 2 THEN INSERT INTO town.axis (geom, width) SELECT ST_MakeLine(p, ST_Translate(p, 9, -13)), 4 FROM town.axis, ST_LineInterpolatePoint(geom, 0.3 + 0.05 * (i % 8)) p WHERE axis_id = id;
    WHEN 3 THEN UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = id;
    WHEN 4 THEN UPDATE town.axis SET geom = ST_LineSubstring(geom, 0.1, 1) WHERE axis_id = id;
    ELSE UPDATE town.axis SET radius = 3 + i % 5, direction = CASE direction WHEN 'both' THEN 'direct' ELSE 'both' END WHERE axis_id = id;
  END CASE;
END $$;
CREATE TABLE unlike (i integer, rows bigint);
DO $$ BEGIN FOR i IN 1 .. 18 LOOP CALL pg_temp.edit(i); INSERT INTO unlike SELECT i, pg_temp.unlike_all(); END LOOP; END $$;
SELECT 'after each edit objects stand as a run over all places them', sum(rows) = 0 FROM unlike;
DO $$ BEGIN FOR i IN 19 .. 30 LOOP CALL pg_temp.edit(i); END LOOP; END $$;
SELECT 'after edits in one transaction too', pg_temp.unlike_all() = 0;
DELETE FROM town.axis WHERE axis_id IN (11, 21);
SELECT 'and after deletes', pg_temp.unlike_all() = 0;
