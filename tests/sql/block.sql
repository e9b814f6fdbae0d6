\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- City blocks: faces of the network less the roadway; their identity, kinds, edits and bad input.  (name, holds)
-- Each face of the network of the ground, made by a polygonizer, beside the blocks that lie in it.
CREATE FUNCTION pg_temp.faces(model name) RETURNS TABLE (face integer, ground float8, of_blocks float8, blocks bigint) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE replace($q$
    WITH face AS (SELECT (d).path[1] AS face, (d).geom FROM (SELECT ST_Dump(ST_Polygonize(geom)) AS d FROM (SELECT ST_UnaryUnion(ST_Collect(geom)) AS geom FROM @.edge WHERE level = 0) n) p),
    roadway AS (SELECT ST_Union(surface, 1e-4) AS geom FROM @.roadway WHERE level = 0),
    place AS (SELECT block_id, ST_Area(surface) AS area, ST_PointOnSurface(surface) AS geom FROM @.block WHERE NOT ST_IsEmpty(surface))
    SELECT f.face, ST_Area(ST_Difference(f.geom, r.geom, 1e-4)), coalesce(sum(p.area), 0), count(p.block_id) FROM face f CROSS JOIN roadway r LEFT JOIN place p ON ST_Contains(f.geom, p.geom)
    GROUP BY f.face, f.geom, r.geom$q$, '@', quote_ident(model));
END $$;
CREATE FUNCTION pg_temp.are_faces(model name) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  held boolean;
  there bigint;
BEGIN
  EXECUTE format('SELECT count(*) FROM %I.block', model) INTO there;
  SELECT coalesce(bool_and(abs(ground - of_blocks) < 0.1), true) AND count(*) = there INTO held FROM pg_temp.faces(model);
  RETURN held;
END $$;
-- Each side of each edge of the ground, once.
CREATE FUNCTION pg_temp.are_whole(model name) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
  held boolean;
BEGIN
  EXECUTE replace($q$SELECT coalesce(bool_and(coalesce(s.covered, 0) > 0.999 AND coalesce(s.covered, 0) < 1.001), true) FROM @.edge e CROSS JOIN unnest(ARRAY['left', 'right']) hand LEFT JOIN LATERAL (
    SELECT sum(b.end_abscissa - b.start_abscissa) / ST_Length(e.geom) AS covered FROM @.block_edge b WHERE (b.edge_id, b.side) = (e.edge_id, hand)) s ON true WHERE e.level = 0$q$, '@', quote_ident(model)) INTO held;
  RETURN held;
END $$;
CREATE FUNCTION pg_temp.refused(statement text, state text) RETURNS boolean LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE statement;
  RETURN false;
EXCEPTION WHEN OTHERS THEN
  RETURN SQLSTATE = state;
END $$;
SELECT streetgen.create_model('town', 2154, subjects => '{interconnection,block}'), streetgen.create_model('anew', 2154, subjects => '{interconnection,block}') \g /dev/null
SET streetgen_test.subjects = 'asked';
SELECT streetgen.create_model('bare', 2154) \g /dev/null
RESET streetgen_test.subjects;
INSERT INTO town.axis (axis_id, geom, width, radius) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 6, 4 FROM (VALUES
  (1, 'LINESTRING(0 0,100 0)'), (2, 'LINESTRING(100 0,100 60)'), (3, 'LINESTRING(100 60,0 60)'), (4, 'LINESTRING(0 60,0 0)')) v(id, line);

SELECT 'a new model has no blocks unless told so', to_regclass('bare.block') IS NULL AND 'block' <> ALL (streetgen._with_needs(NULL));
SELECT 'blocks need kerbs', streetgen._with_needs('{block}') @> '{kerb}';
SELECT 'four streets are about one block', count(*) = 1 AND bool_and(kind = 'block' AND method = 'hypothesis' AND abs(ST_Area(surface) - (94 * 54 - (4 - pi()) * 16)) < 0.5) FROM town.block;
SELECT 'with the block on the left of one side and nothing on the other', array_agg(edge_id || side ORDER BY ordinality) = '{1left,2left,3left,4left}' FROM town.block_edge WHERE block_id IS NOT NULL;
SELECT 'each side of each edge is told', pg_temp.are_whole('town') AND (SELECT count(*) = 4 FROM town.block_edge WHERE block_id IS NULL);
SELECT 'they are faces less the roadway', pg_temp.are_faces('town');

INSERT INTO town.axis (axis_id, geom, width, radius) VALUES (5, 'SRID=2154;LINESTRING(650050 6860000,650050 6860060)', 6, 4);
SELECT 'a street through it makes two, and the one with the first place keeps its id', array_agg(b.block_id = 1 ORDER BY b.block_id) = '{t,f}' AND bool_or(e.axis_id = 1 AND e.start_abscissa = 0 AND b.block_id = 1)
  FROM town.block b JOIN town.block_edge s ON (s.block_id, s.ordinality) = (b.block_id, 1) JOIN town.edge e USING (edge_id);
SELECT 'as from scratch', test.followed('town', 'anew') AND pg_temp.are_faces('town') AND pg_temp.are_whole('town');
DELETE FROM town.axis WHERE axis_id = 5;
SELECT 'without it they are one again', array_agg(block_id) = '{1}' FROM town.block;
INSERT INTO town.axis (axis_id, geom, width, radius) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 4, 2 FROM (VALUES
  (6, 'LINESTRING(0 0,20 20)'), (7, 'LINESTRING(40 20,60 20,60 40,40 40,40 20)'), (8, 'LINESTRING(80 20,80 40)')) v(id, line);
SELECT 'a block goes about dead ends and islands of streets', count(*) = 2 AND max(ST_NumInteriorRings(ST_GeometryN(surface, 1))) = 2 FROM town.block;
SELECT 'which are rings of their own', max(ring) = 3 FROM town.block_edge WHERE block_id = 1;
SELECT 'a small one is an island', kind = 'island' FROM town.block WHERE block_id <> 1;
SELECT 'and follow edits', test.followed('town', 'anew') AND pg_temp.are_faces('town') AND pg_temp.are_whole('town');
UPDATE town.axis SET geom = ST_Translate(geom, 100, 0) WHERE axis_id = 7;
SELECT 'a loop that moves to another face', test.followed('town', 'anew') AND pg_temp.are_faces('town') AND pg_temp.are_whole('town');
INSERT INTO town.axis (axis_id, geom, width) VALUES (9, 'SRID=2154;LINESTRING(650140 6860020,650140 6860025)', 3);
UPDATE town.axis SET geom = ST_Translate(geom, 0, 500) WHERE axis_id = 9;
SELECT 'streets far from all others', test.followed('town', 'anew') AND pg_temp.are_whole('town');
UPDATE town.axis SET width = 70 WHERE axis_id IN (1, 3);
SELECT 'a block that is paved all over stays without ground', count(*) = 1 AND bool_and(kind = 'roadway' AND ST_IsEmpty(surface)) FROM town.block WHERE method = 'covered' AND block_id = 1;
UPDATE town.axis SET width = 6 WHERE axis_id IN (1, 3);
SELECT 'and has it again under the same id', NOT ST_IsEmpty(surface) AND test.followed('town', 'anew') FROM town.block WHERE block_id = 1;

INSERT INTO town.axis (axis_id, geom, width, radius, level) SELECT id, ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000), 6, 4, level FROM (VALUES
  (10, 'LINESTRING(50 0,50 30)', 0), (11, 'LINESTRING(50 30,50 60)', 0), (12, 'LINESTRING(50 30,60 20)', 1), (13, 'LINESTRING(50 30,69 20)', 1), (14, 'LINESTRING(50 30,78 25)', 1)) v(id, line, level);
SELECT 'where a street has no roadway on its level its axis is the border', count(*) = 2 FROM town.block WHERE method = 'axis_bound';
SELECT 'also after edits', test.followed('town', 'anew') AND pg_temp.are_faces('town');
DELETE FROM town.axis WHERE axis_id >= 9;
INSERT INTO town.axis (axis_id, geom, width, radius) VALUES (15, 'SRID=2154;LINESTRING(649990 6860010,650110 6860010)', 5, 4);
SELECT 'a crossing without a node is a vertex', (SELECT max(start_abscissa) > 0 FROM town.block_edge) AND pg_temp.are_faces('town') AND pg_temp.are_whole('town');
SELECT 'from scratch too', test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id = 15;

UPDATE town.block_editing SET kind = 'strip' WHERE block_id = 1;
SELECT 'a kind by hand holds', (SELECT kind = 'strip' AND by_hand FROM town.block_editing WHERE block_id = 1);
UPDATE town.axis SET width = 7 WHERE axis_id = 1;
SELECT 'through edits and runs', (SELECT kind = 'strip' FROM town.block WHERE block_id = 1) AND test.followed('town', 'anew');
INSERT INTO town.block_override (geom, kind) VALUES ('SRID=2154;POINT(650000 6860030)', 'island');
SELECT 'an override on no block is told', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'block override on no block';
DELETE FROM town.block_override WHERE kind = 'island';
DELETE FROM town.block_editing WHERE block_id = 1;
SELECT 'and can be taken back', (SELECT kind = 'block' FROM town.block WHERE block_id = 1) AND NOT EXISTS (SELECT FROM town.block_override);
SELECT 'another kind is refused', pg_temp.refused($$UPDATE town.block_editing SET kind = 'park' WHERE block_id = 1$$, '23514');
SELECT 'a block cannot be drawn', pg_temp.refused($$INSERT INTO town.block_editing (kind) VALUES ('block')$$, '0A000');
-- A ring of a width of its own: the tag changes the kind alone.
INSERT INTO town.axis (axis_id, geom, width, direction) VALUES (20, ST_Translate(ST_GeomFromText('LINESTRING(325 0,318 18,300 25,282 18,275 0,282 -18,300 -25,318 -18,325 0)', 2154), 650000, 6860000), 6, 'direct');
CREATE FUNCTION pg_temp.kind_within() RETURNS text LANGUAGE sql AS $$ SELECT kind FROM town.block WHERE ST_Covers(surface, 'SRID=2154;POINT(650300 6860000)') $$;
SELECT 'what a loop goes round is a block', pg_temp.kind_within() = 'block';
UPDATE town.axis SET roundabout_tag = 'roundabout' WHERE axis_id = 20;
SELECT 'what a roundabout goes round is an island', pg_temp.kind_within() = 'island' AND test.followed('town', 'anew');
UPDATE town.axis SET roundabout_tag = NULL WHERE axis_id = 20;
SELECT 'as long as it is one', pg_temp.kind_within() = 'block' AND test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id = 20;
SELECT streetgen.set('town', 'block_island_area', '100000') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'settings tell the kinds', bool_and(kind = 'island') FROM town.block;
SELECT streetgen.set('town', 'ground_level', '1') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'and the level of the ground', NOT EXISTS (SELECT FROM town.block) AND NOT EXISTS (SELECT FROM town.block_edge);
SELECT streetgen.set('town', 'ground_level', '0') \g /dev/null
SELECT 'a level is a whole number', pg_temp.refused($$SELECT streetgen.set('town', 'ground_level', '0.5')$$, '22023');
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'a second run writes nothing', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');
SELECT 'the model is sound', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
UPDATE town.block SET kind = 'strip' WHERE block_id = 1;
SELECT 'rows changed by hand are told', EXISTS (SELECT FROM streetgen.check_model('town'));
DELETE FROM town.block_edge WHERE side = 'left';
SELECT 'a side without a row too', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'side of an edge that faces no block nor the outside');
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'a run repairs them', test.followed('town', 'anew') AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
SELECT 'blocks are a layer of files', query LIKE '%block%' FROM streetgen.export_layer('town') WHERE layer = 'blocks';
SELECT 'and of pictures', streetgen.svg('town') LIKE '%class="block%' AND streetgen.svg('town', legend => true) LIKE '%island%';
SELECT 'and summed up', bool_or(subject = 'blocks, ground' AND amount > 0) FROM streetgen.summary('town');
SELECT FROM streetgen.switch_subject('town', 'block', false) \g /dev/null
SELECT 'switched off there are none', to_regclass('town.block') IS NULL AND to_regclass('town.block_edge') IS NULL AND to_regclass('town.block_editing') IS NULL;
UPDATE town.axis SET width = 6.5 WHERE axis_id = 4;
SELECT 'switched on they are filled', (SELECT inserted > 0 FROM streetgen.switch_subject('town', 'block', true) WHERE relation = 'block') AND test.followed('town', 'anew');
TRUNCATE town.axis;
SELECT 'no axes, no blocks', NOT EXISTS (SELECT FROM town.block) AND NOT EXISTS (SELECT FROM town.block_edge);
INSERT INTO town.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860010,650200 6860000)', 6);
SELECT 'a network that is one line has none', NOT EXISTS (SELECT FROM town.block) AND pg_temp.are_whole('town');
TRUNCATE town.axis;
SELECT 'streets at the end of the world are refused', pg_temp.refused($$INSERT INTO town.axis (geom, width) VALUES ('SRID=2154;LINESTRING(1e9 1e9,1000000100 1e9)', 6)$$, '22023');
TRUNCATE town.axis;
-- A grid of streets between two long ones: a face of a thousand edges.
INSERT INTO town.axis (axis_id, geom, width) SELECT 2 * n + side, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 40 * n, 6860000 + 200 * side), ST_MakePoint(650040 + 40 * n, 6860000 + 200 * side)), 2154), 6 FROM generate_series(1, 250) n, generate_series(0, 1) side;
INSERT INTO town.axis (axis_id, geom, width) SELECT 1000 + 2 * n + side, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 40 * n, 6860000 + 200 * side), ST_MakePoint(650000 + 40 * n, 6860040 + 120 * side)), 2154), 5 FROM generate_series(2, 250) n, generate_series(0, 1) side;
INSERT INTO town.axis (axis_id, geom, width) SELECT 3000 + side, ST_SetSRID(ST_MakeLine(ST_MakePoint(650040 + 10000 * side, 6860000), ST_MakePoint(650040 + 10000 * side, 6860200)), 2154), 6 FROM generate_series(0, 1) side;
SELECT 'a face of very many edges is a block', count(*) = 1 AND max(n) > 1000 FROM (SELECT block_id, count(*) AS n FROM town.block_edge WHERE block_id IS NOT NULL GROUP BY block_id) b;
UPDATE town.axis SET width = 7 WHERE axis_id = 2;
UPDATE town.axis SET width = 8 WHERE axis_id = 501;
SELECT 'edits at either end of it', test.followed('town', 'anew');

-- Where no roadway of the ground lies on an axis, kerbs of other streets tell what is ground. Heights could not keep apart such levels.
SET streetgen_test.subjects = 'asked';
DO $$ BEGIN
  PERFORM streetgen.create_model('mixed', 2154, subjects => '{interconnection,block}'), streetgen.create_model('mixed_anew', 2154, subjects => '{interconnection,block}');
  INSERT INTO mixed.axis (axis_id, geom, width, importance, direction, level) SELECT axis_id, ST_GeomFromText(line, 2154), width, importance, 'direct', level FROM (VALUES
    (1, 'LINESTRING(649991.3921 6860006.5584,650051.6474 6859988.5228)', 16.62, 5, 0), (2, 'LINESTRING(649991.3921 6860006.5584,650046.7286 6860040.1702)', NULL, 5, 1),
    (8, 'LINESTRING(650051.6474 6859988.5228,650071.6474 6859993.5228,650059.6474 6860010.5228,650051.6474 6859988.5228)', 3.82, NULL, 0),
    (9, 'LINESTRING(650051.8974 6859988.5928,650083.6196 6859996.3109)', 19.95, 5, 0), (10, 'LINESTRING(650051.6474 6859988.5228,650093.4572 6860036.0712)', 13.12, NULL, 1)) a(axis_id, line, width, importance, level);
END $$;
SELECT 'a face whose kerb another level has is what roadways of the ground leave of it', count(*) = 1 AND bool_and(abs(ST_Area(b.surface) - ST_Area(ST_Difference(ST_MakePolygon(a.geom), r.geom))) < 1e-3) AND test.followed('mixed', 'mixed_anew')
  FROM mixed.block b, mixed.axis a, (SELECT ST_Union(surface) AS geom FROM mixed.roadway WHERE level = 0) r WHERE a.axis_id = 8;
DO $$ BEGIN
  DELETE FROM mixed.axis;
  INSERT INTO mixed.axis (axis_id, geom, width, level, direction, importance) SELECT axis_id, ST_GeomFromText(line, 2154), width, level, direction, importance FROM (VALUES
    (2, 'LINESTRING(649992.4876 6860010.732,650059.0260000001 6860062.7822)', 10.22, -1, 'reverse', NULL), (4, 'LINESTRING(649996.2438 6860066.5384,650059.0260000001 6860062.7822)', NULL, 0, 'direct', NULL),
    (5, 'LINESTRING(650046.6842 6860004.8294,650021.7250999999 6860089.7145,650055.8064 6860102.4906)', 6.78, 0, 'reverse', 5), (6, 'LINESTRING(650046.6842 6860004.8294,650059.0260000001 6860062.7822)', NULL, 0, 'reverse', 5)) a(axis_id, line, width, level, direction, importance);
  UPDATE mixed.axis SET geom = 'SRID=2154;LINESTRING(649995.8476 6860022.532,650059.0260000001 6860062.7822)' WHERE axis_id = 6;
END $$;
SELECT 'and one at the end of another level is as from scratch', test.followed('mixed', 'mixed_anew');
RESET streetgen_test.subjects;
DO $$ BEGIN
  DELETE FROM mixed.axis;
  INSERT INTO mixed.axis (axis_id, geom, width, level) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650000 6860060)', 6, -1);
  INSERT INTO mixed.axis (axis_id, geom, width, level) VALUES (2, 'SRID=2154;LINESTRING(650000 6860000,650060 6860000)', 6, 0);
END $$;
SELECT 'the first street of the ground faces the outside, though it begins at one below', count(*) = 2 AND bool_and(block_id IS NULL) FROM mixed.block_edge;

-- What a run looks at: of 5 by 5 blocks of 50 m, within reach of the street in the middle lie nearly all.
DO $$ BEGIN
  PERFORM streetgen.create_model('grid', 2154, subjects => '{block}');
  INSERT INTO grid.axis (axis_id, geom, width) SELECT 100 * y + x, ST_MakeLine(ST_SetSRID(ST_MakePoint(650000 + 50 * x, 6860000 + 50 * y), 2154), ST_SetSRID(ST_MakePoint(650050 + 50 * x, 6860000 + 50 * y), 2154)), 6 FROM generate_series(0, 4) x, generate_series(0, 5) y
    UNION ALL SELECT 1000 + 100 * y + x, ST_MakeLine(ST_SetSRID(ST_MakePoint(650000 + 50 * x, 6860000 + 50 * y), 2154), ST_SetSRID(ST_MakePoint(650000 + 50 * x, 6860050 + 50 * y), 2154)), 6 FROM generate_series(0, 5) x, generate_series(0, 4) y;
END $$;
SELECT 'a run over nothing changed looks at the two blocks beside its street', (SELECT count(*) = 25 FROM grid.block) AND inserted + updated + deleted = 0 AND unchanged = 2 FROM streetgen.generate('grid', '{203}') WHERE relation = 'block';
CREATE TEMPORARY TABLE before AS SELECT block_id, xmin AS writer, ST_AsBinary(surface) AS surface FROM grid.block;
UPDATE grid.axis SET width = 9 WHERE axis_id = 203;
SELECT 'a width writes the blocks whose ground moved and no other', count(*) FILTER (WHERE b.xmin <> writer) BETWEEN 2 AND 6 AND bool_and((b.xmin <> writer) = (ST_AsBinary(b.surface) <> before.surface)) FROM grid.block b JOIN before USING (block_id);

-- A triangle of streets of 80, 80 and 41 m that leaves room for a disc of 12 m. The corner by hand lies beyond that disc.
DO $$ BEGIN
  PERFORM streetgen.create_model('paved', 2154, subjects => '{block}'), streetgen.set('paved', 'max_arc_distance', '200');
  INSERT INTO paved.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650080 6860000)', 6), (2, 'SRID=2154;LINESTRING(650080 6860000,650069.282 6860040)', 6),
    (3, 'SRID=2154;LINESTRING(650069.282 6860040,650000 6860000)', 6), (4, 'SRID=2154;LINESTRING(650000 6860000,649950 6859990)', 6), (5, 'SRID=2154;LINESTRING(650080 6860000,650130 6859980)', 6),
    (6, 'SRID=2154;LINESTRING(650069.282 6860040,650110 6860090)', 6);
END $$;
CREATE FUNCTION pg_temp.paved(model name) RETURNS SETOF streetgen.finding LANGUAGE sql AS $$ SELECT severity, rule, relation, id, measure, geom FROM streetgen.check_model(model) WHERE rule = 'block that is roadway, m2' $$;
SELECT 'a block of ground is not told as roadway', NOT EXISTS (SELECT FROM pg_temp.paved('paved'));
INSERT INTO paved.corner_override (geom, axis_a, axis_b, radius) VALUES ('SRID=2154;POINT(650000 6860000)', 1, 3, 18);
SELECT 'one that a corner paves is', count(*) = 1 AND bool_and(measure BETWEEN 1599 AND 1601) FROM pg_temp.paved('paved');
DO $$ BEGIN
  PERFORM streetgen.create_model('middle', 2154, subjects => '{block}'), streetgen.set('middle', 'crossing', 'split');
  INSERT INTO middle.axis (geom, width, direction) SELECT ST_SetSRID(ST_GeomFromText(line), 2154), 7, 'direct' FROM (VALUES ('LINESTRING(649880 6859990,650120 6859990)'), ('LINESTRING(650120 6860010,649880 6860010)'),
    ('LINESTRING(650010 6859880,650010 6860120)'), ('LINESTRING(649990 6860120,649990 6859880)')) a(line);
END $$;
SELECT 'the middle of dual carriageways that cross is roadway by right', (SELECT count(*) FROM middle.block WHERE kind = 'roadway') = 1 AND NOT EXISTS (SELECT FROM pg_temp.paved('middle'));
