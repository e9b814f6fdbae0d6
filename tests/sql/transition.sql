\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Changes of width: kind and length by setting and by node.  Each SELECT is one truth: (name, holds).
-- East along y = 0 from 6 m to 10 m wide at x = 100; the wide street comes back west along its axis.
CREATE FUNCTION pg_temp.fill(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  PERFORM streetgen.create_model(model, 32631), streetgen.live(model, false);
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width) VALUES (1, 'SRID=32631;LINESTRING(0 0,100 0)', 6), (2, 'SRID=32631;LINESTRING(200 0,100 0)', 10),
    (3, 'SRID=32631;LINESTRING(0 0,0 90)', 6), (4, 'SRID=32631;LINESTRING(0 90,0 180)', 12)$q$, model);
END $$;
DO $$ BEGIN PERFORM pg_temp.fill('town'); PERFORM streetgen.set('town', 'transition_length', '8'); PERFORM streetgen.generate('town'); END $$;
-- Whether a place east of the change and north of the axis is roadway.
CREATE FUNCTION pg_temp.roadway(x float8, y float8) RETURNS boolean LANGUAGE sql AS $$
  SELECT ST_Contains(surface, ST_SetSRID(ST_MakePoint(100 + x, y), 32631)) FROM town.intersection JOIN town.node USING (node_id) WHERE ST_DWithin(geom, 'SRID=32631;POINT(100 0)', 0.01) $$;
-- Kerbs 0.4 of the length before and after the node: linear ones lie 3.2 and 4.8 m from the axis, stepped ones 3 and 5.
CREATE FUNCTION pg_temp.kerbs(length float8) RETURNS text LANGUAGE sql AS $$
  SELECT string_agg(CASE WHEN pg_temp.roadway(-0.4 * length, side * 3.19) AND NOT pg_temp.roadway(-0.4 * length, side * 3.21) AND pg_temp.roadway(0.4 * length, side * 4.79) AND NOT pg_temp.roadway(0.4 * length, side * 4.81) THEN 'linear'
                         WHEN pg_temp.roadway(-0.4 * length, side * 2.99) AND NOT pg_temp.roadway(-0.4 * length, side * 3.01) AND pg_temp.roadway(0.4 * length, side * 4.99) AND NOT pg_temp.roadway(0.4 * length, side * 5.01) THEN 'steps'
                         ELSE 'neither' END, ' ' ORDER BY side DESC) FROM unnest('{1,-1}'::float8[]) side $$;
CREATE FUNCTION pg_temp.place() RETURNS bigint LANGUAGE sql AS $$ SELECT from_node FROM town.edge WHERE axis_id = 2 AND ST_DWithin(ST_StartPoint(geom), 'SRID=32631;POINT(100 0)', 0.01)
  UNION SELECT to_node FROM town.edge WHERE axis_id = 2 AND ST_DWithin(ST_EndPoint(geom), 'SRID=32631;POINT(100 0)', 0.01) $$;
CREATE FUNCTION pg_temp.decide(kind text, length float8) RETURNS text LANGUAGE plpgsql AS $$
BEGIN
  PERFORM streetgen.set_transition('town', pg_temp.place(), kind, length);
  PERFORM streetgen.generate('town');
  RETURN pg_temp.kerbs(length);
END $$;
-- By speed, 60 km/h for the width of 10 m: 1:10, and each kerb moves 2 m sideways.
CREATE FUNCTION pg_temp.limits() RETURNS text LANGUAGE sql AS $$
  SELECT array_agg(round(ST_X(l.geom)::numeric, 6) ORDER BY ST_X(l.geom)) FROM town.section_limit l WHERE ST_X(geom) BETWEEN 50 AND 150 $$;
DO $$ BEGIN PERFORM streetgen.set('town', 'transition_length', NULL); PERFORM streetgen.generate('town'); END $$;
SELECT 'without a length it is the taper of the speed', pg_temp.limits() = '{90.000000,110.000000}';
UPDATE town.axis SET speed = CASE axis_id WHEN 1 THEN 70 ELSE 90 END WHERE axis_id < 3;
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'the faster street decides', pg_temp.limits() = '{70.000000,130.000000}';
DO $$ BEGIN PERFORM streetgen.set('town', 'taper_ratio', '{"50": 3, "90": 25}'); PERFORM streetgen.generate('town'); END $$;
SELECT 'the ratio is a setting', pg_temp.limits() = '{75.000000,125.000000}';
DO $$ BEGIN PERFORM streetgen.set('town', 'taper_ratio', '{"0": 100}'); PERFORM streetgen.generate('town'); END $$;
SELECT 'it takes no more than 0.4 of an edge', pg_temp.limits() = '{60.000000,140.000000}';
UPDATE town.axis SET speed = NULL;
DO $$ BEGIN PERFORM streetgen.set('town', 'transition_length', '8'); PERFORM streetgen.generate('town'); END $$;
SELECT 'symmetric: both kerbs are linear' AS name, pg_temp.kerbs(8) = 'linear linear' AS holds;
SELECT 'limits lie half a length from the node', (SELECT array_agg(round(ST_X(l.geom)::numeric, 6) ORDER BY ST_X(l.geom)) = '{96,104}' FROM town.section_limit l WHERE ST_X(geom) BETWEEN 50 AND 150);
DO $$ BEGIN PERFORM streetgen.set('town', 'transition_kind', 'left'); PERFORM streetgen.generate('town'); END $$;
SELECT 'left by setting: the left kerb along the smaller axis is linear', pg_temp.kerbs(8) = 'linear steps';
DO $$ BEGIN PERFORM streetgen.set('town', 'transition_kind', 'right'); PERFORM streetgen.generate('town'); END $$;
SELECT 'right by setting', pg_temp.kerbs(8) = 'steps linear';
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (1, 2);
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'sides turn with the axis', pg_temp.kerbs(8) = 'linear steps';
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id IN (1, 2);
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;

CREATE TABLE other AS SELECT md5(string_agg(i::text, ',' ORDER BY node_id)) AS rows FROM town.intersection i WHERE node_id <> pg_temp.place();
SELECT 'left by node', pg_temp.decide('left', 12) = 'linear steps';
SELECT 'its length by node', (SELECT count(*) = 2 FROM town.section_limit l WHERE abs(abs(ST_X(geom) - 100) - 6) < 1e-6);
SELECT 'it is kept by the end of the smaller axis', array_agg((axis_id, which, kind, length)::text) = '{"(1,end,left,12)"}' FROM town.transition_override;
SELECT 'other nodes follow the settings', rows = (SELECT md5(string_agg(i::text, ',' ORDER BY node_id)) FROM town.intersection i WHERE node_id <> pg_temp.place()) FROM other;
SELECT 'symmetric by node', pg_temp.decide('symmetric', 12) = 'linear linear';
SELECT 'a second run writes nothing', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');
SELECT 'no length: that of the setting', pg_temp.decide('left', NULL) = 'neither neither' AND pg_temp.kerbs(8) = 'linear steps';
SELECT 'no kind: that of the setting', pg_temp.decide(NULL, 20) = 'steps linear';
DO $$ BEGIN PERFORM streetgen.set_transition('town', pg_temp.place(), 'left', 12); END $$;
SELECT 'check_model says that the axis is stale', array_agg(id) = '{1}' FROM streetgen.check_model('town') WHERE rule LIKE 'stale: the axis changed%';
DO $$ BEGIN PERFORM streetgen.generate('town', '{1}'); END $$;
SELECT 'a run for the axis takes it', pg_temp.kerbs(12) = 'linear steps' AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule LIKE 'stale%');

-- Written to the table, seen along the axis that is named; the smaller axis holds where both are.
INSERT INTO town.transition_override (axis_id, which, kind, length) VALUES (2, 'end', 'symmetric', 20);
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'of two the smaller axis holds', pg_temp.kerbs(12) = 'linear steps';
DELETE FROM town.transition_override WHERE axis_id = 1;
UPDATE town.transition_override SET kind = 'left', length = 12;
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'left of the axis that comes west is south', pg_temp.kerbs(12) = 'steps linear';
SELECT 'deciding by node replaces both', pg_temp.decide('left', 12) = 'linear steps';
SELECT 'and it is one', count(*) = 1 FROM town.transition_override;

-- What it survives.
CREATE TABLE was AS SELECT pg_temp.place() AS node_id;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, 'SRID=32631;POINT(110 0)') WHERE axis_id IN (1, 2);
DO $$ BEGIN PERFORM streetgen.generate('town', '{1,2}'); END $$;
SELECT 'the node moved', ST_X(geom) = 110 FROM town.node JOIN was USING (node_id);
SELECT 'and took its length along', count(*) = 2 FROM town.section_limit WHERE abs(abs(ST_X(geom) - 110) - 6) < 1e-6;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, 'SRID=32631;POINT(100 0)') WHERE axis_id IN (1, 2);
DELETE FROM town.edge;
DELETE FROM town.node;
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'the node has another id', pg_temp.place() <> node_id FROM was;
SELECT 'a rebuild with other node ids keeps it', pg_temp.kerbs(12) = 'linear steps';
DO $$ BEGIN
  PERFORM pg_temp.fill('single');
  UPDATE single.setting s SET value = t.value FROM town.setting t WHERE t.name = s.name;
  INSERT INTO single.transition_override SELECT * FROM town.transition_override;
  PERFORM streetgen.generate('single', ARRAY[id]) FROM generate_series(1, 4) id;
END $$;
SELECT 'axis by axis gives the same model', test.same('town', 'single');

-- What finds no place, and what is refused.
INSERT INTO town.transition_override (transition_override_id, axis_id, which, length) VALUES (91, 1, 'start', 9), (92, 77, 'end', 9), (93, 2, 'start', 9);
SELECT 'an override that finds no change of width stays and is told', array_agg(id ORDER BY id) = '{91,92,93}' FROM streetgen.check_model('town') WHERE severity = 'warning' AND relation = 'transition_override';
DO $$ BEGIN PERFORM streetgen.generate('town'); END $$;
SELECT 'and changes no kerb', pg_temp.kerbs(12) = 'linear steps';
SELECT 'refused: ' || call, test.state(call) = wanted FROM (VALUES
  ('SELECT streetgen.set_transition(''town'', 999999, ''left'')', '22023'), ('SELECT streetgen.set_transition(''town'', NULL, ''left'')', '22004'), ('SELECT streetgen.set_transition(''no such'', 1, ''left'')', '3F000'),
  (format('SELECT streetgen.set_transition(''town'', %s, ''both'')', pg_temp.place()), '23514'), (format('SELECT streetgen.set_transition(''town'', %s, ''left'', ''NaN'')', pg_temp.place()), '23514'),
  (format('SELECT streetgen.set_transition(''town'', %s, NULL, -1)', pg_temp.place()), '23514'), (format('SELECT streetgen.set_transition(''town'', %s, NULL, 201)', pg_temp.place()), '23514'),
  (format('SELECT streetgen.set_transition(''town'', %s, ''left'')', (SELECT from_node FROM town.edge WHERE axis_id = 2)), '22023')) v(call, wanted);
SELECT 'a node that is not there is told as such', said = 'model "town" has no node 999999' AND hint <> '' FROM test.refusal('SELECT streetgen.set_transition(''town'', 999999, ''left'')');
SELECT 'what was refused changed nothing', array_agg((axis_id, which, kind, length)::text) = '{"(1,end,left,12)"}' FROM town.transition_override WHERE transition_override_id < 90;
SELECT 'NULL and NULL take the decision back', pg_temp.decide(NULL, NULL) = 'neither neither' AND pg_temp.kerbs(8) = 'steps linear';
SELECT 'and leave no row', count(*) = 0 FROM town.transition_override WHERE (axis_id, which) IN ((1, 'end'), (2, 'end'));
