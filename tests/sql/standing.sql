\set ECHO none
\ir shared/truths.sql
-- Where objects of rules may stand: at kerbs, and off roadways, crossings, lines, narrow medians and each other.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
SELECT streetgen.create_model('town', 2154, subjects => '{lane,object}', driving_side => 'right') \g /dev/null
SELECT 'a model with objects has kerbs', to_regclass('town.kerb') IS NOT NULL;
INSERT INTO town.axis (axis_id, geom, width, importance, direction, lane_count) VALUES (1, pg_temp.line('LINESTRING(0 0, 100 0)'), 8, 2, 'both', 2), (2, pg_temp.line('LINESTRING(100 0, 200 0)'), 8, 2, 'both', 2),
  (3, pg_temp.line('LINESTRING(100 0, 100 -80)'), 6, 5, 'both', 2);
CREATE FUNCTION pg_temp.stand(text) RETURNS text[] LANGUAGE sql AS $$ SELECT array_agg(axis_id || side || round(abscissa) ORDER BY axis_id, side, abscissa) FROM town.street_object WHERE type = $1 AND placed_by = 'rule' $$;
CREATE FUNCTION pg_temp.told(text) RETURNS bigint LANGUAGE sql AS $$ SELECT count(*) FROM streetgen.check_model('town') WHERE rule = $1 $$;
CREATE FUNCTION pg_temp.still() RETURNS boolean LANGUAGE sql AS $$ SELECT sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town', wait => true) $$;

-- In a roadway of the level.
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (1, 'bench', 'both', 20, 3, 5);
SELECT 'benches stand on both sides', pg_temp.stand('bench') @> '{1left40,1right40,2left40,2right40,3left20,3right20}';
INSERT INTO town.axis (axis_id, geom, width, importance, level) VALUES (4, pg_temp.line('LINESTRING(0 10.2, 200 10.2)'), 8, 5, 0);
SELECT 'none in the roadway of a street beside, which no node joins', NOT pg_temp.stand('bench') && '{1left40,2left40,4right40}' AND pg_temp.stand('bench') @> '{1right40,2right40,4left40}' AND pg_temp.still();
UPDATE town.axis SET level = 1 WHERE axis_id = 4;
SELECT 'they stand below a bridge', pg_temp.stand('bench') @> '{1left40,2left40,4right40}' AND pg_temp.still();
UPDATE town.axis SET level = -1 WHERE axis_id = 4;
SELECT 'but none in a tunnel', NOT EXISTS (SELECT FROM town.street_object WHERE axis_id = 4) AND pg_temp.stand('bench') @> '{1left40,2left40}' AND pg_temp.still();
DELETE FROM town.axis WHERE axis_id = 4;

-- What lies on the roadway may.
INSERT INTO town.placement_rule (rule_id, type, along, every, axis_offset) VALUES (2, 'manhole', 'axis', 30, 1), (3, 'bollard', 'axis', 30, 1);
SELECT 'manholes lie on the roadway, and bollards do not', EXISTS (SELECT FROM town.street_object WHERE type = 'manhole') AND NOT EXISTS (SELECT FROM town.street_object WHERE type = 'bollard');
INSERT INTO town.object_type (type, parent) VALUES ('cover', 'manhole');
UPDATE town.placement_rule SET type = 'cover' WHERE rule_id = 3;
SELECT 'a type below one of these does', EXISTS (SELECT FROM town.street_object WHERE type = 'cover');
DELETE FROM town.placement_rule WHERE rule_id IN (2, 3);

-- In the mouth of a crossing.
SELECT streetgen.set('town', 'line_sight', '0') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
INSERT INTO town.pedestrian_crossing_editing (axis_id, abscissa, width) VALUES (1, 41, 4);
SELECT 'none where people walk from a crossing', NOT pg_temp.stand('bench') && '{1left40,1right40}' AND pg_temp.stand('bench') @> '{1left60,1right60,2left40}' AND pg_temp.still();
UPDATE town.pedestrian_crossing_editing SET angle = 45;
SELECT 'along the way across, if that leans', pg_temp.stand('bench') @> '{1left40,1right40}' AND pg_temp.still();
UPDATE town.pedestrian_crossing_editing SET angle = 90;
UPDATE town.street_object SET abscissa = 44 WHERE type = 'crossing';
SELECT 'they come back beside its strip', pg_temp.stand('bench') @> '{1left40,1right40}' AND pg_temp.still();

-- In the sight of a line.
UPDATE town.placement_rule SET distance_from_limit = 0, every = 2, side = 'right', axis_offset = 1;
CREATE FUNCTION pg_temp.nearest() RETURNS float8 LANGUAGE sql AS $$ SELECT min(ST_Distance(o.geom, m.geom)) FROM town.street_object o, town.marking m WHERE o.type = 'bench' AND m.kind IN ('stop', 'yield') $$;
SELECT 'a line on the side street, and benches beside it', pg_temp.nearest() < 6;
SELECT streetgen.set('town', 'line_sight', '8') \g /dev/null
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'none in its sight', pg_temp.nearest() BETWEEN 8 AND 10.5 AND pg_temp.still();
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (4, 'sign', 'right', 2, 1.5, 0);
SELECT 'but signs, which are to be seen there', EXISTS (SELECT FROM town.street_object o, town.marking m WHERE o.type = 'sign' AND m.kind IN ('stop', 'yield') AND ST_DWithin(o.geom, m.geom, 4));
DELETE FROM town.placement_rule;

-- Distances.
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (1, 'lamp', 'right', 30, 1, 5), (2, 'tree', 'right', 6, 1, 5);
SELECT 'trees keep off lamps of an earlier rule', pg_temp.stand('lamp') @> '{1right30,1right60}' AND NOT pg_temp.stand('tree') && '{1right30,1right60}' AND pg_temp.stand('tree') @> '{1right24,1right66}';
SELECT 'and five metres off the ground of a crossing', NOT pg_temp.stand('tree') && '{1right42,1right48}' AND pg_temp.stand('tree') @> '{1right54}';
UPDATE town.object_distance SET metres = 7 WHERE (type_a, type_b) = ('tree', 'lamp');
SELECT 'as far as the table says, at once', NOT pg_temp.stand('tree') && '{1right24,1right66}' AND pg_temp.still();
DELETE FROM town.object_distance WHERE (type_a, type_b) IN (('tree', 'lamp'), ('tree', 'crossing'));
SELECT 'and not at all without a row', pg_temp.stand('tree') @> '{1right24,1right48,1right66}' AND pg_temp.still();
INSERT INTO town.placement_rule (rule_id, type, side, every, axis_offset, distance_from_limit) VALUES (3, 'lamp', 'left', 30, 1, 5), (4, 'tree', 'right', 6, 1.4, 5);
SELECT 'two lamps of two rules keep 15 m, across the street', pg_temp.stand('lamp') IS NOT NULL AND NOT EXISTS (SELECT FROM town.street_object WHERE rule_id = 3 AND axis_id = 1 AND abscissa = 30);
SELECT 'no tree stands on a tree', NOT EXISTS (SELECT FROM town.street_object WHERE rule_id = 4) AND EXISTS (SELECT FROM town.street_object WHERE rule_id = 2);
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset, placed_by) VALUES ('tree', 'border', 1, 54.5, 'right', 1, 'import');
SELECT 'nor on an imported one', NOT pg_temp.stand('tree') && '{1right54}' AND pg_temp.still();
SELECT 'a distance that cannot be is refused', test.state($$UPDATE town.object_distance SET metres = 51$$) = '23514';
SELECT 'a type that is none, too', test.state($$INSERT INTO town.object_distance VALUES ('oak', 'lamp', 3)$$) = '23503';
CREATE TABLE stood AS SELECT type, rule_id, axis_id, rule_place, geom::bytea AS geom FROM town.street_object;
UPDATE town.axis SET width = 9 WHERE axis_id = 1;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 2;
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 2;
UPDATE town.axis SET width = 8 WHERE axis_id = 1;
SELECT 'edits there and back leave what stood', NOT EXISTS (SELECT FROM stood FULL JOIN (SELECT type, rule_id, axis_id, rule_place, geom::bytea AS geom FROM town.street_object) o USING (type, axis_id, geom)
  WHERE stood.axis_id IS NULL OR o.rule_id IS DISTINCT FROM stood.rule_id);
TRUNCATE town.node CASCADE;
SELECT FROM streetgen.generate('town', wait => true) \g /dev/null
SELECT 'as does a run from scratch', NOT EXISTS (SELECT FROM stood FULL JOIN (SELECT type, rule_id, axis_id, geom::bytea AS geom FROM town.street_object) o USING (type, axis_id, geom) WHERE stood.axis_id IS NULL OR o.rule_id IS DISTINCT FROM stood.rule_id);

-- What stands there by hand stays, and check_model tells.
SELECT 'nothing of rules is told', count(*) = 0 FROM streetgen.check_model('town') c JOIN town.street_object o ON c.relation = 'street_object' AND o.street_object_id = c.id WHERE o.placed_by = 'rule';
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) VALUES ('kiosk', 'border', 1, 70, 'right', -1), ('bench', 'border', 1, 44, 'left', 1), ('bench', 'border', 1, 44.5, 'left', 1), ('bench', 'border', 3, 10, 'left', 1);
SELECT 'told: ' || rule, pg_temp.told(rule) > 0 FROM unnest('{object in a roadway,object in the mouth of a crossing,object in the sight of a stop or yield line,object nearer to another one than object_distance}'::text[]) rule;
INSERT INTO town.parking_bay_editing (axis_id, abscissa, side, axis_offset) VALUES (1, 70, 'right', 0);
SELECT 'told: object in a parking bay', pg_temp.told('object in a parking bay') = 1;
SELECT 'all stay', (SELECT count(*) = 4 FROM town.street_object WHERE placed_by = 'user' AND type IN ('kiosk', 'bench')) AND pg_temp.still();
INSERT INTO town.axis (axis_id, geom, width, importance, level) VALUES (5, pg_temp.line('LINESTRING(0 6, 90 6)'), 8, 5, 0), (6, pg_temp.line('LINESTRING(0 -60, 80 -60)'), 8, 5, -1);
INSERT INTO town.street_object (type, placement, axis_id, abscissa, side, axis_offset) VALUES ('lamp', 'border', 5, 30, 'right', 1), ('lamp', 'border', 6, 30, 'right', 1);
SELECT 'told: object beside no kerb', pg_temp.told('object beside no kerb') > 0;
SELECT 'told: object on a level below the ground', pg_temp.told('object on a level below the ground') = 1;

-- Medians, on either driving side.
CREATE FUNCTION pg_temp.median(side text, gap float8) RETURNS bigint LANGUAGE plpgsql AS $f$
DECLARE inner_trees bigint; BEGIN
  PERFORM streetgen.create_model('avenue', 2154, subjects => '{lane,object}', driving_side => side);
  INSERT INTO avenue.axis (axis_id, geom, width, importance, direction, name, lane_count) VALUES
    (1, pg_temp.line(CASE side WHEN 'right' THEN 'LINESTRING(0 0, 150 0)' ELSE 'LINESTRING(150 0, 0 0)' END), 6, 3, 'direct', 'avenue', 2),
    (2, pg_temp.line(format(CASE side WHEN 'right' THEN 'LINESTRING(150 %1$s, 0 %1$s)' ELSE 'LINESTRING(0 %1$s, 150 %1$s)' END, 6 + gap)), 6, 3, 'direct', 'avenue', 2);
  INSERT INTO avenue.placement_rule (type, every, axis_offset) VALUES ('tree', 10, 0.9);
  SELECT count(*) FILTER (WHERE ST_Y(geom) BETWEEN 6860003 AND 6860003 + gap) INTO inner_trees FROM avenue.street_object;
  IF NOT EXISTS (SELECT FROM avenue.kerb WHERE beside = 'median') OR (SELECT count(*) < 20 FROM avenue.street_object WHERE NOT ST_Y(geom) BETWEEN 6860003 AND 6860003 + gap) THEN
    RAISE EXCEPTION 'no median, or no trees beside the street';
  END IF;
  PERFORM streetgen.drop_model('avenue');
  RETURN inner_trees;
END $f$;
SELECT 'trees stand on a median of 3.5 m and on none of 2.5 m, where traffic keeps ' || side, pg_temp.median(side, 3.5) > 10 AND pg_temp.median(side, 2.5) = 0 FROM unnest('{right,left}'::text[]) side;
