\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
\ir shared/switch.sql
-- Kerbs: the border of the roadway, by side, corner and end; edits, clusters and the subject itself.  (name, holds)
-- What the rows of a level are not of the border of its roadway, and the border not of the rows, in metres: as surfaces on a
-- grid of a tenth of a millimetre, which closes gaps that are noise, leave it.
CREATE FUNCTION pg_temp.beside(model name) RETURNS TABLE (level integer, missing float8, too_many float8, border float8, kerbs float8) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE replace($q$
    SELECT level, ST_Length(ST_Difference(b.geom, ST_Buffer(k.geom, 2e-4))), ST_Length(ST_Difference(k.geom, ST_Buffer(b.geom, 2e-4))), ST_Length(b.geom), k.length
    FROM (SELECT level, ST_Boundary(ST_Union(surface, 1e-4)) AS geom FROM @.roadway GROUP BY level) b
    FULL JOIN (SELECT level, ST_Collect(geom) AS geom, sum(ST_Length(geom)) AS length FROM @.kerb GROUP BY level) k USING (level)$q$, '@', quote_ident(model));
END $$;
CREATE FUNCTION pg_temp.is_border(model name) RETURNS boolean LANGUAGE sql AS $$
  SELECT bool_and(missing < 1e-3 AND too_many < 1e-3 AND abs(border - kerbs) < 1e-6 * border) IS TRUE FROM pg_temp.beside(model) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,kerb}'), streetgen.create_model('anew', 2154, subjects => '{interconnection,kerb}');
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('bare', 2154, subjects => '{}');
  INSERT INTO town.axis (axis_id, geom, width, radius, level, name) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 8, 5, 0, 'west'), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 8, 5, 0, 'east'),
    (3, 'SRID=2154;LINESTRING(650100 6859920,650100 6860000)', 6, 5, 0, 'south'), (4, 'SRID=2154;LINESTRING(650100 6860000,650100 6860080)', 6, 5, 0, 'north'),
    (5, 'SRID=2154;LINESTRING(650200 6860000,650300 6860010)', 5, 5, 0, 'on'), (6, 'SRID=2154;LINESTRING(650150 6859940,650150 6860060)', 7, 5, 1, 'bridge'),
    (7, 'SRID=2154;LINESTRING(650300 6860010,650380 6860060)', 5, 5, 1, 'ramp');
END $$;

SELECT 'a new model has no kerbs unless told so', to_regclass('bare.kerb') IS NULL AND (SELECT NOT wanted FROM streetgen.subject('bare') WHERE subject = 'kerb')
  AND 'kerb' <> ALL (streetgen._with_needs(NULL));
SELECT 'kerbs are the border of the roadway, each metre once', pg_temp.is_border('town');
SELECT 'of each level', count(DISTINCT level) = 2 FROM town.kerb;
SELECT 'a section has a left and a right kerb', bool_and(sides = '{left,right}') FROM (
  SELECT array_agg(side ORDER BY side) AS sides FROM town.kerb WHERE node_id IS NULL AND side IN ('left', 'right') GROUP BY edge_id) s;
SELECT 'the left one runs along the edge, the right one against it', bool_and((ST_LineLocatePoint(e.geom, ST_StartPoint(k.geom)) < ST_LineLocatePoint(e.geom, ST_EndPoint(k.geom))) = (side = 'left'))
  FROM town.kerb k JOIN town.edge e USING (edge_id) WHERE node_id IS NULL AND side IN ('left', 'right');
SELECT 'a dead end has one across', (SELECT array_agg(name ORDER BY name) FILTER (WHERE k.method = 'hypothesis') = '{bridge,bridge,north,ramp,south,west}'
  FROM town.kerb k JOIN town.edge USING (edge_id) JOIN town.axis USING (axis_id) WHERE side IN ('start', 'end'));
SELECT 'a corner has its arc', count(*) = 5 AND bool_and(ST_Distance(ST_StartPoint(k.curve), ST_EndPoint(c.arc)) < 1e-6 AND ST_Distance(ST_EndPoint(k.curve), ST_StartPoint(c.arc)) < 1e-6
    AND abs(ST_Length(k.curve) - ST_Length(c.arc)) < 1e-6)
  FROM town.kerb k JOIN town.corner c ON (c.node_id, c.edge_a, 'corner_at_' || c.end_a) = (k.node_id, k.edge_id, k.side) WHERE k.curve IS NOT NULL;
SELECT 'all of it is kerb where no other street comes near', (SELECT count(*) = 5 AND bool_and(abs(on_kerb - 1) < 1e-6) FROM town.corner_on_kerb);
SELECT 'a transition has two sides', count(*) = 2 FROM town.kerb WHERE method = 'transition';
SELECT 'the roadway is on the right', bool_and(ST_Distance(r.surface, ST_Translate(m.geom, d.y * 0.01, -d.x * 0.01)) = 0)
  FROM town.kerb k, LATERAL (SELECT ST_LineInterpolatePoint(k.geom, 0.5) AS geom) m,
    LATERAL (SELECT (ST_X(ST_LineInterpolatePoint(k.geom, 0.51)) - ST_X(m.geom)) AS x, ST_Y(ST_LineInterpolatePoint(k.geom, 0.51)) - ST_Y(m.geom) AS y) v,
    LATERAL (SELECT x / sqrt(x * x + y * y) AS x, y / sqrt(x * x + y * y) AS y) d,
    LATERAL (SELECT ST_Union(surface) AS surface FROM town.roadway r WHERE r.level = k.level) r WHERE ST_Length(k.geom) > 1;
SELECT 'across, where the roadway goes on on another level', array_agg(side ORDER BY side) = '{across_start,start}' FROM town.kerb WHERE method = 'level_change';
SELECT 'every vertex is one of a surface', NOT EXISTS (SELECT FROM (SELECT (ST_DumpPoints(geom)).geom FROM town.kerb) k
  WHERE NOT EXISTS (SELECT FROM town.roadway r, ST_DumpPoints(r.surface) v WHERE ST_DWithin(v.geom, k.geom, 1e-6)));
SELECT 'stones are as wide as the setting', bool_and(ST_IsValid(surface) AND abs(ST_Area(surface) - 0.3 * ST_Length(geom)) < 0.05 + 0.02 * ST_Length(geom)) FROM town.kerb;
SELECT 'and lie behind the kerb', sum(ST_Area(ST_Intersection(k.surface, r.surface))) < 0.3 FROM town.kerb k JOIN town.roadway r ON r.level = k.level AND ST_Intersects(k.surface, r.surface);
SELECT 'numbers of parts follow each other', bool_and(parts = last) FROM (SELECT count(*) AS parts, max(part) AS last FROM town.kerb GROUP BY edge_id, side) p;
SELECT 'the model is sound', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
-- All kerbs of a city lie on one level.
CREATE FUNCTION pg_temp.plan(statement text) RETURNS SETOF text LANGUAGE plpgsql SET enable_nestloop = off AS $$ BEGIN RETURN QUERY EXECUTE 'EXPLAIN ' || statement; END $$;
SET search_path = town, public;
SELECT 'the check pairs no kerbs by their level', NOT bool_or(line ~ 'Cond: \(\w+\.level = \w+\.level\)') FROM pg_temp.plan((SELECT substring(prosrc, 'FOR finding IN(.*?)LOOP') FROM pg_proc WHERE oid = 'streetgen._check_kerb'::regproc)) line;
RESET search_path;

CREATE TEMPORARY TABLE before AS SELECT * FROM town.kerb;
UPDATE town.axis SET width = 9 WHERE axis_id = 4;
SELECT 'an edit leaves the border whole', pg_temp.is_border('town') AND test.followed('town', 'anew');
SELECT 'and rows that it does not move', (SELECT count(*) FROM town.kerb JOIN before b USING (kerb_id) WHERE (kerb.*) = (b.*)) > 10;
INSERT INTO town.axis (axis_id, geom, width, radius) VALUES (8, 'SRID=2154;LINESTRING(650000 6860007,650100 6860004,650180 6860007)', 6, 4);
SELECT 'contested ground has its border once', pg_temp.is_border('town') AND test.followed('town', 'anew');
SELECT 'in parts', (SELECT count(*) > 0 FROM town.kerb WHERE method = 'contested');
UPDATE town.axis SET geom = ST_Translate(geom, 0, 3) WHERE axis_id = 8;
SELECT 'that move with it', pg_temp.is_border('town') AND test.followed('town', 'anew');
DELETE FROM town.axis WHERE axis_id IN (3, 8);
SELECT 'and go with it', pg_temp.is_border('town') AND test.followed('town', 'anew');
SELECT streetgen.set('town', 'dead_end', 'round'), streetgen.set('town', 'kerb_stone_width', '0.5') \g /dev/null
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'settings change them', pg_temp.is_border('town') AND test.followed('town', 'anew');
SELECT 'a run over all finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('town');
DELETE FROM town.kerb WHERE side = 'left';
SELECT 'rows deleted by hand are told', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'changed_by_hand' OR rule LIKE 'stale%');
SELECT FROM streetgen.generate('town') \g /dev/null
SELECT 'and come back', pg_temp.is_border('town') AND test.followed('town', 'anew');
SELECT test.switch_off('town', 'kerb') AS needing \gset
SELECT 'switched off there are none', to_regclass('town.kerb') IS NULL;
UPDATE town.axis SET width = 7 WHERE axis_id = 4;
SELECT 'switched on they are filled', (SELECT inserted > 20 FROM streetgen.switch_subject('town', 'kerb', true) WHERE relation = 'kerb') AND pg_temp.is_border('town');
SELECT test.switch_on('town', :'needing') \g /dev/null
SELECT 'as from scratch', test.followed('town', 'anew');
SELECT 'they are a layer of files', query LIKE '%kerb%' FROM streetgen.export_layer('town') WHERE layer = 'kerbs';
SELECT 'and summed up', amount > 0.5 FROM streetgen.summary('town') WHERE subject = 'kerbs, length';
TRUNCATE town.axis;
SELECT 'no axes, no kerbs', NOT EXISTS (SELECT FROM town.kerb);

-- A grid in clusters, also with streets that share ground at their borders.
DO $$ BEGIN PERFORM streetgen.create_model('parts', 2154, subjects => '{interconnection,kerb}'), streetgen.create_model('whole', 2154, subjects => '{interconnection,kerb}'); END $$;
SET streetgen.live = off;
INSERT INTO parts.axis (axis_id, geom, width, importance) SELECT 1 + i, ST_SetSRID(ST_MakeLine(ST_Point(650000 + 90 * (i / 2 % 9), 6860000 + 70 * (i / 18)),
  ST_Point(650000 + 90 * (i / 2 % 9 + (i + 1) % 2) + CASE WHEN i % 11 = 0 THEN 25 ELSE 0 END, 6860000 + 70 * (i / 18 + i % 2) + CASE WHEN i % 13 = 0 THEN 9 ELSE 0 END)), 2154), 4 + i % 17, 1 + i % 4 FROM generate_series(0, 143) i;
INSERT INTO whole.axis (axis_id, geom, width, importance) SELECT axis_id, geom, width, importance FROM parts.axis;
RESET streetgen.live;
SELECT FROM streetgen.generate('whole') \g /dev/null
SELECT streetgen.plan_clusters('parts', 4) \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT 'clusters give what one run gives', test.same('parts', 'whole') AND pg_temp.is_border('parts');
SELECT 'and a run over all finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('parts');
