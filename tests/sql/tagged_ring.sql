\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Rings that a source names, with streets through them, and those of which it says nothing.  (name, holds)
CREATE FUNCTION pg_temp.place(x float8, y float8) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
CREATE FUNCTION pg_temp.polar(x float8, radius float8, degrees float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT pg_temp.place(x + radius * cos(radians(degrees)), radius * sin(radians(degrees))) $$;
CREATE FUNCTION pg_temp.arc(x float8, radius float8, low float8, high float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(pg_temp.polar(x, radius, low + (high - low) * i / 24) ORDER BY i) FROM generate_series(0, 24) i $$;
CREATE FUNCTION pg_temp.arm(x float8, radius float8, degrees float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(pg_temp.polar(x, radius, degrees), pg_temp.polar(x, radius + 80, degrees)) $$;
-- A ring of two axes with a street through its middle; beside it a round block that nobody calls a roundabout.
CREATE PROCEDURE pg_temp.draw(model name) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count, direction, roundabout_tag) VALUES
    (1, pg_temp.arc(0, 25, 0, 240), 7, 2, ''direct'', ''roundabout''), (2, pg_temp.arc(0, 25, 240, 360), 7, 2, ''direct'', ''roundabout'')', model);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) VALUES (3, ST_MakeLine(ARRAY[pg_temp.place(-120, 0), pg_temp.place(-25, 0), pg_temp.place(25, 0), pg_temp.place(120, 0)]), 6, 2)', model);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) SELECT 4 + n, pg_temp.arm(0, 25, 90 + 180 * n), 6, 2 FROM generate_series(0, 1) n', model);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) VALUES (11, pg_temp.arc(400, 25, 0, 180), 7, 2), (12, pg_temp.arc(400, 25, 180, 360), 7, 2)', model);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) SELECT 13 + n, pg_temp.arm(400, 25, 45 + 90 * n), 6, 2 FROM generate_series(0, 3) n', model);
END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction,roundabout}', driving_side => 'right');
  PERFORM streetgen.create_model('anew', 2154, subjects => '{junction,roundabout}', driving_side => 'right');
END $$;
CALL pg_temp.draw('town');
SELECT 'a ring with a street through its middle is one, and so is the round block by its score', (SELECT array_agg(round(radius) ORDER BY ST_X(centre)) = '{25,25}' AND bool_and(accepted) FROM town.roundabout);
SELECT 'the street through it has two arms within', (SELECT count(*) = 4 FROM town.roundabout_arm JOIN town.edge USING (edge_id) WHERE axis_id = 3) AND (SELECT count(*) = 10 FROM town.roundabout_arm);
SELECT 'it goes on both ways', (SELECT bool_and(lanes_forward = 1 AND lanes_backward = 1) FROM town.edge WHERE axis_id = 3);
SELECT 'its driver waits where it comes to the ring, from outside and from the middle', (SELECT count(DISTINCT (edge_id, along_axis)) = 4 FROM town.marking JOIN town.edge USING (edge_id) WHERE axis_id = 3 AND kind = 'yield');

-- What a source says and what it leaves open.
SELECT streetgen.set('town', 'roundabout_untagged', 'offered') \g /dev/null
SELECT FROM streetgen.generate('town');
SELECT 'where the silence of a source counts, the block is offered', (SELECT array_agg(accepted ORDER BY ST_X(centre)) = '{t,f}' FROM town.roundabout);
SELECT 'its streets go both ways', (SELECT bool_and(lanes_forward = 1 AND lanes_backward = 1) FROM town.edge WHERE axis_id IN (11, 12));
SELECT 'nothing is told of a tagged ring that is one', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'roundabout of a source without a ring');
SELECT streetgen.set('town', 'roundabout_radius_greatest', '20') \g /dev/null
SELECT FROM streetgen.generate('town');
SELECT 'a tagged ring that is wider than the setting is told', (SELECT array_agg(id ORDER BY id) = '{1,2}' FROM streetgen.check_model('town') WHERE rule = 'roundabout of a source without a ring');
SELECT streetgen.set('town', 'roundabout_tags', 'false') \g /dev/null
SELECT FROM streetgen.generate('town');
SELECT 'but not where tags do not count', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'roundabout of a source without a ring');
SELECT streetgen.set('town', 'roundabout_tags', 'true'), streetgen.set('town', 'roundabout_radius_greatest', '60') \g /dev/null
SELECT FROM streetgen.generate('town');
UPDATE town.roundabout_editing SET confirmed = true WHERE NOT accepted;
SELECT 'confirmed, traffic goes round it', (SELECT bool_and(accepted) FROM town.roundabout) AND (SELECT bool_and(least(lanes_forward, lanes_backward) = 0) FROM town.edge WHERE axis_id IN (11, 12));
DELETE FROM town.roundabout_override;
SELECT 'not any more, it is offered', (SELECT array_agg(accepted ORDER BY ST_X(centre)) = '{t,f}' FROM town.roundabout);
UPDATE town.axis SET roundabout_tag = NULL WHERE axis_id = 2;
SELECT 'of a ring that is named in part, with a street through it, the halves are none', NOT EXISTS (SELECT FROM town.roundabout WHERE accepted);
DELETE FROM town.axis WHERE axis_id = 3;
SELECT 'without that street it is one: the rest of it is one-way', (SELECT array_agg(accepted ORDER BY ST_X(centre)) = '{t,f}' FROM town.roundabout);
UPDATE town.axis SET roundabout_tag = 'circular' WHERE axis_id = 2;
SELECT 'named whole again it is one', (SELECT array_agg(accepted ORDER BY ST_X(centre)) = '{t,f}' FROM town.roundabout);
INSERT INTO town.axis (axis_id, geom, width, lane_count) VALUES (3, ST_MakeLine(ARRAY[pg_temp.place(-120, 0), pg_temp.place(-25, 0), pg_temp.place(25, 0), pg_temp.place(120, 0)]), 6, 2);
SELECT 'what edits made a run leaves', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town');
SELECT streetgen.set('anew', 'roundabout_untagged', 'offered') \g /dev/null
INSERT INTO anew.axis SELECT * FROM town.axis;
SELECT 'edits give what a model from scratch has', test.same('town', 'anew');
SELECT streetgen.set('town', 'roundabout_tags', 'false') \g /dev/null
SELECT FROM streetgen.generate('town');
SELECT 'where tags do not count, nor does silence', (SELECT bool_or(accepted) FROM town.roundabout WHERE ST_X(centre) > 650300);
SELECT 'another word is refused', test.state($q$SELECT streetgen.set('town', 'roundabout_untagged', 'never')$q$) = '22023';

-- A piece that a source leaves out of a ring, and says to go both ways, is not made one-way by the others.
DO $$ BEGIN PERFORM streetgen.create_model('piece', 2154, subjects => '{roundabout}', driving_side => 'right'); PERFORM streetgen.set('piece', 'roundabout_untagged', 'offered'); END $$;
INSERT INTO piece.axis (axis_id, geom, width, lane_count, direction, roundabout_tag) VALUES
  (1, pg_temp.arc(0, 25, 0, 270), 7, 2, 'direct', 'roundabout'), (2, pg_temp.arc(0, 25, 270, 360), 7, 2, 'both', NULL);
SELECT 'a piece both ways keeps its traffic', (SELECT bool_and(lanes_forward = 1 AND lanes_backward = 1) FROM piece.edge WHERE axis_id = 2) AND NOT (SELECT accepted FROM piece.roundabout);
UPDATE piece.axis SET direction = 'direct' WHERE axis_id = 2;
SELECT 'one-way, it is part of the ring', (SELECT accepted FROM piece.roundabout);

-- An import that names rings.
CREATE TABLE rows (id integer, geom geometry(LineString, 2154), tag text, way text);
INSERT INTO rows SELECT axis_id, geom, roundabout_tag, direction FROM anew.axis;
DO $$ BEGIN PERFORM streetgen.create_model('told', 2154, subjects => '{roundabout}', driving_side => 'right'); PERFORM streetgen.create_model('silent', 2154, subjects => '{roundabout}', driving_side => 'right');
  PERFORM streetgen.create_model('scored', 2154, subjects => '{roundabout}', driving_side => 'right'); PERFORM streetgen.set('scored', 'roundabout_untagged', 'scored'); END $$;
CREATE TABLE said AS SELECT * FROM streetgen.import_axes('told', 'rows', '{"source_ref": "id", "roundabout_tag": "tag", "direction": "way"}');
SELECT 'an import that names rings says what becomes of the others', (SELECT count = 2 FROM said WHERE what LIKE 'part of a roundabout by a tag; other rings are offered%')
  AND (SELECT value = 'offered' FROM streetgen.setting('told') WHERE name = 'roundabout_untagged');
SELECT FROM streetgen.generate('told');
SELECT 'no two-way street of it is made one-way', (SELECT array_agg(accepted ORDER BY ST_X(centre)) = '{t,f}' FROM told.roundabout)
  AND NOT EXISTS (SELECT FROM told.edge JOIN told.axis USING (axis_id) WHERE direction = 'both' AND least(edge.lanes_forward, edge.lanes_backward) = 0);
SELECT FROM streetgen.import_axes('silent', 'rows', '{"source_ref": "id", "direction": "way"}');
SELECT FROM streetgen.import_axes('scored', 'rows', '{"source_ref": "id", "roundabout_tag": "tag", "direction": "way"}');
SELECT 'one that names none leaves it to the score, and so does one whose user said so', (SELECT array_agg(value ORDER BY model) = '{scored,auto}' FROM (SELECT 'scored' AS model, value FROM streetgen.setting('scored') WHERE name = 'roundabout_untagged'
  UNION ALL SELECT 'silent', value FROM streetgen.setting('silent') WHERE name = 'roundabout_untagged') s);

-- A model that looks for no rings takes the word of every source.
DO $$ BEGIN PERFORM streetgen.create_model('plain', 2154, subjects => '{junction}', driving_side => 'right'); END $$;
INSERT INTO plain.axis (geom, width, lane_count, direction, roundabout_tag) VALUES (pg_temp.arc(0, 25, 0, 360), 7, 2, 'direct', 'Rond-point');
INSERT INTO plain.axis (geom, width, lane_count) SELECT pg_temp.arm(0, 25, 90 * n), 6, 2 FROM generate_series(0, 3) n;
SELECT 'a Rond-point is a roundabout without that subject too', (SELECT count(*) = 4 FROM plain.junction WHERE kind = 'roundabout');
-- Signals say when traffic enters a ring: it waits at a stop line where they stand, and elsewhere yields.
SELECT streetgen.create_model('lit', 2154, subjects => '{signal}', driving_side => 'right') \g /dev/null
INSERT INTO lit.axis (axis_id, geom, width, lane_count, direction, roundabout_tag) VALUES (1, pg_temp.arc(0, 25, 0, 240), 7, 2, 'direct', 'roundabout'), (2, pg_temp.arc(0, 25, 240, 360), 7, 2, 'direct', 'roundabout');
INSERT INTO lit.axis (axis_id, geom, width, lane_count) SELECT 3 + n, pg_temp.arm(0, 25, 90 * n), 6, 2 FROM generate_series(0, 3) n;
INSERT INTO lit.control_point (geom, kind) VALUES (pg_temp.polar(0, 25, 90), 'signals');
SELECT 'who comes to signals of a ring stops there, and yields elsewhere', string_agg(concat_ws(' ', axis_id, kind), ', ' ORDER BY axis_id) = '3 yield, 4 stop, 5 yield, 6 yield' FROM lit.marking JOIN lit.edge USING (edge_id) WHERE axis_id > 2 AND kind <> 'arrow';
