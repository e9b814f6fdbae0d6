\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Lines upon lines and ends that miss: told, proposed, mended.  Each SELECT is one truth: (name, holds).
CREATE FUNCTION pg_temp.line(line text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText(line, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.of(model name) RETURNS TABLE (axis bigint, proposal text, line text, measure numeric, others bigint[]) LANGUAGE plpgsql AS $$ BEGIN
  RETURN QUERY EXECUTE format('SELECT axes[1], proposal, ST_AsText(ST_Force2D(ST_Translate(geom, -650000, -6860000)), 2), round(measure::numeric, 2), axes[2:] FROM %I.axis_to_mend ORDER BY axes[1]', model);
END $$;
CREATE FUNCTION pg_temp.mend(model name) RETURNS bigint LANGUAGE plpgsql AS $$
DECLARE mended bigint;
BEGIN
  EXECUTE format('SELECT streetgen.accept_mend(%1$L, (SELECT array_agg(id) FROM %1$I.axis_to_mend))', model) INTO mended;
  RETURN mended;
END $$;
\set rules '''axis lies on another'', ''end of an axis in the roadway of another, without a node'''

-- One street under two names, a part of a longer one drawn back, two centre lines of one street, ends before and beyond a street, and a bridge.
SELECT streetgen.create_model('town', 2154), streetgen.create_model('plain', 2154), streetgen.create_model('once', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width, lane_count, level) SELECT id, pg_temp.line(line), width, 2, level FROM (VALUES
  (1, 'LINESTRING(0 0,80 0,160 0)', 9, 0), (2, 'LINESTRING(160 0,80 0,0 0)', 9, 0), (3, 'LINESTRING(80 0,80 70)', 6, 0),
  (4, 'LINESTRING(120 1.2,120 60)', 6, 0), (5, 'LINESTRING(40 60,40 -1)', 6, 0), (6, 'LINESTRING(140 2,140 60)', 6, 1),
  (11, 'LINESTRING(0 200,40 200,60 200,160 200,200 200)', 9, 0), (12, 'LINESTRING(160 200,60 200,40 200,40 270)', 6, 0),
  (21, 'LINESTRING(0 400,20 400.7,180 400.7,200 400)', 8, 0), (22, 'LINESTRING(0 400,20 399.3,180 399.3,200 400)', 8, 0), (23, 'LINESTRING(0 400,-60 400)', 8, 0),
  (31, 'LINESTRING(0 600,100 600,200 600)', 8, 0), (32, 'LINESTRING(50 680,100 600,200 600,200 690)', 6, 0),
  (41, 'LINESTRING(0 800,100 800)', 7, 0), (42, 'LINESTRING(0 830,60 830,60 802.5)', 7, 0)) v(id, line, width, level);
SELECT 'each is told with its axis and its measure' AS name, array_agg((rule LIKE 'end%', id, round(measure::numeric, 2))::text ORDER BY id)
  = '{"(f,2,160.00)","(t,4,1.20)","(t,5,1.00)","(f,12,120.00)","(f,22,200.02)","(f,32,100.00)","(t,42,2.50)"}' AS holds FROM streetgen.check_model('town') WHERE rule IN (:rules);
SELECT 'each rule has words', count(*) = 2 FROM streetgen.check_rule WHERE rule IN (:rules);
SELECT 'nothing is stale, and nothing waits for its streets', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule LIKE 'stale%' OR rule = 'not_generated' OR severity = 'error');
SELECT 'each has a proposal', array_agg(p::text ORDER BY axis) = ARRAY[
  '(2,delete,"MULTILINESTRING((0 0,80 0,160 0))",160.00,{1})', '(4,join,"MULTILINESTRING((120 0,120 60))",1.20,{1})', '(5,join,"MULTILINESTRING((40 60,40 0))",1.00,{1})',
  '(12,split,"MULTILINESTRING((40 200,40 270))",120.00,{11})', '(22,delete,"MULTILINESTRING((0 400,20 400.7,180 400.7,200 400))",200.02,{21})',
  '(32,split,"MULTILINESTRING((50 680,100 600),(200 600,200 690))",100.00,{31})', '(42,join,"MULTILINESTRING((0 830,60 830,60 800))",2.50,{41})'] FROM pg_temp.of('town') p;

-- What lies on another takes nothing: the streets are those of the model without it.
INSERT INTO plain.axis (axis_id, geom, width, lane_count, level) SELECT axis_id, geom, width, lane_count, level FROM town.axis WHERE axis_id NOT IN (2, 22);
SELECT 'the roadway is as without the twins: ' || level, ST_Area(ST_SymDifference(ST_Union(t.surface), (SELECT ST_Union(p.surface) FROM plain.roadway p WHERE p.level = t.level))) < 1e-4 FROM town.roadway t GROUP BY level;
SELECT 'so are lanes, paths and turns back', (SELECT array_agg(n ORDER BY n) FROM (SELECT count(*) || kind AS n FROM town.lane GROUP BY kind UNION ALL SELECT count(*) || turn FROM town.interconnection GROUP BY turn) t)
  = (SELECT array_agg(n ORDER BY n) FROM (SELECT count(*) || kind AS n FROM plain.lane GROUP BY kind UNION ALL SELECT count(*) || turn FROM plain.interconnection GROUP BY turn) p);

-- Who may, and which proposals.
CREATE ROLE mend_editor; CREATE ROLE mend_reader;
SELECT streetgen.grant('town', 'mend_editor', 'editor'), streetgen.grant('town', 'mend_reader', 'reader') \g /dev/null
CREATE TABLE seen AS SELECT id, axes[1] AS axis FROM town.axis_to_mend;
GRANT SELECT ON seen TO mend_editor, mend_reader;
SET ROLE mend_reader;
SELECT 'a reader sees proposals', count(*) = 7 FROM town.axis_to_mend;
SELECT 'and may not accept one: one line says so, and who allows it', (r).state = '42501' AND (r).said = 'role "mend_reader" may not edit model "town"' AND (r).hint LIKE '%editor%'
  FROM (SELECT test.refusal($$SELECT streetgen.accept_mend('town', ARRAY[(SELECT id FROM seen WHERE axis = 4)])$$) AS r) t;
RESET ROLE;
SELECT 'one that never was: 22023, named, with the way out', (r).state = '22023' AND (r).said LIKE '%no proposal 7' AND (r).hint LIKE 'SELECT * FROM town.axis_to_mend%'
  FROM (SELECT test.refusal($$SELECT streetgen.accept_mend('town', array_append((SELECT array_agg(id) FROM seen), 7))$$) AS r) t;
SELECT 'then none is done', (SELECT count(*) FROM town.axis_to_mend) = 7;
SELECT 'no list, as of an empty view, does nothing', streetgen.accept_mend('town', NULL) = 0;
SELECT 'NULL is no proposal', test.state($$SELECT streetgen.accept_mend('town', '{NULL}')$$) = '22023';
SELECT 'an unknown model: 3F000', test.state($$SELECT streetgen.accept_mend('no such', '{1}')$$) = '3F000';
SELECT 'no proposal does nothing', streetgen.accept_mend('town', '{}') = 0;
UPDATE town.axis SET geom = pg_temp.line('LINESTRING(120 1.2,121 60)') WHERE axis_id = 4;
SELECT 'one that changed since: 22023', test.state($$SELECT streetgen.accept_mend('town', ARRAY[(SELECT id FROM seen WHERE axis = 4)])$$) = '22023';

-- By hand on what stays, and on what goes.
UPDATE town.corner_editing SET radius = 4 WHERE corner_id = (SELECT min(corner_id) FROM town.corner WHERE method = 'hypothesis');
INSERT INTO town.sidewalk_override (axis_id, abscissa, side, width) VALUES (32, 250, 'left', 4), (2, 30, 'left', 3);
SET ROLE mend_editor;
SELECT 'an editor mends all', pg_temp.mend('town') = 7;
RESET ROLE;
SELECT 'nothing is left to mend', NOT EXISTS (SELECT FROM town.axis_to_mend) AND NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule IN (:rules));
SELECT 'the axes lie as proposed', array_agg(ST_AsText(ST_Translate(geom, -650000, -6860000), 2) ORDER BY axis_id) = ARRAY['LINESTRING(119.98 0,121 60)', 'LINESTRING(40 60,40 0)', 'LINESTRING(40 200,40 270)', 'LINESTRING(50 680,100 600)', 'LINESTRING(0 830,60 830,60 800)']
  FROM town.axis WHERE axis_id IN (2, 4, 5, 12, 22, 32, 42);
SELECT 'the other piece has the values of its axis', (width, lane_count, level) = (6, 2, 0) FROM town.axis WHERE ST_DWithin(geom, pg_temp.line('LINESTRING(200 650,200 690)'), 0.01);
SELECT 'a corner by hand stays', count(*) = 1 FROM town.corner WHERE method = 'by_hand' AND radius = 4;
SELECT 'what lay on the piece that was cut off is on it', ST_DWithin(a.geom, pg_temp.line('LINESTRING(200 600,200 690)'), 0.01) FROM town.sidewalk_override o JOIN town.axis a USING (axis_id) WHERE o.width = 4;
SELECT 'what lay on the twin is on the street that stays, on its side', (axis_id, side) = (1, 'right') FROM town.sidewalk_override WHERE width = 3;
SELECT 'the streets followed', test.followed('town', 'once');
SELECT 'accepted twice: 22023', test.state($$SELECT streetgen.accept_mend('town', (SELECT array_agg(id) FROM seen))$$) = '22023';

-- Two that lead one way each, and one that alone leads to a street, have no proposal.
SELECT streetgen.create_model('apart', 2154) \g /dev/null
INSERT INTO apart.axis (axis_id, geom, width, direction) SELECT id, pg_temp.line(line), 8, direction FROM (VALUES
  (1, 'LINESTRING(0 0,100 0)', 'direct'), (2, 'LINESTRING(0 0,100 0)', 'reverse'),
  (3, 'LINESTRING(0 200,10 199,100 199,110 200)', 'both'), (4, 'LINESTRING(0 200,10 200.5,50 200.5,100 200.5,110 200)', 'both'), (5, 'LINESTRING(50 200.5,50 260)', 'both')) v(id, line, direction);
SELECT 'they are told', array_agg(id ORDER BY id) = '{2,4}' FROM streetgen.check_model('apart') WHERE rule IN (:rules);
SELECT 'and have no proposal', NOT EXISTS (SELECT FROM apart.axis_to_mend);

-- An axis of which a part goes and whose ends miss: the piece that is new is led on too.  Two ends that miss each other are one join.
SELECT streetgen.create_model('cut', 2154) \g /dev/null
INSERT INTO cut.axis (axis_id, geom, width, lane_count) SELECT id, pg_temp.line(line), width, 2 FROM (VALUES
  (11, 'LINESTRING(0 200,100 200)', 8), (12, 'LINESTRING(103 198.5,103 260)', 8),
  (21, 'LINESTRING(0 400,40 400,100 400,160 400)', 8), (22, 'LINESTRING(40 470,40 400,100 400,100 470)', 6), (23, 'LINESTRING(60 472,140 472)', 6), (24, 'LINESTRING(0 472,46 472)', 6),
  (31, 'LINESTRING(0 600,40 600,100 600,160 600)', 8), (32, 'LINESTRING(40 670,40 600,100 600,100 670)', 6), (33, 'LINESTRING(60 672,140 672)', 6)) v(id, line, width);
SELECT 'of two ends that miss each other one is led on', array_agg(proposal ORDER BY axes[1], proposal) = '{join,join,split,join,split}' FROM cut.axis_to_mend;
SELECT 'all of them are done', pg_temp.mend('cut') = 5;
SELECT 'the ends of both pieces are led on', array_agg(ST_AsText(ST_Translate(geom, -650000, -6860000), 2) ORDER BY axis_id) = '{"LINESTRING(40 472,40 400)","LINESTRING(40 670,40 600)","LINESTRING(100 400,100 472)","LINESTRING(100 600,100 672)"}'
  FROM cut.axis WHERE axis_id IN (22, 32) OR axis_id > 33;
SELECT 'nothing of it is left to mend', NOT EXISTS (SELECT FROM cut.axis_to_mend) AND NOT EXISTS (SELECT FROM streetgen.check_model('cut') WHERE rule IN (:rules));

-- In three dimensions, on levels, and where one drives on the left.
SELECT streetgen.create_model('high', 2154, 3, driving_side => 'left') \g /dev/null
INSERT INTO high.axis (axis_id, geom, width, level) SELECT id, ST_Translate(ST_SetSRID(line::geometry, 2154), 650000, 6860000), 8, level FROM (VALUES
  (1, 'LINESTRING Z (0 0 10,100 0 20)', 0), (2, 'LINESTRING Z (50 60 12,50 2 15)', 0), (3, 'LINESTRING Z (70 60 12,70 2 25)', 1), (4, 'LINESTRING Z (0 0 10,100 0 20)', 2)) v(id, line, level);
SELECT 'only what lies on its level', array_agg(axes[1]) = '{2}' FROM high.axis_to_mend;
SELECT pg_temp.mend('high') \g /dev/null
SELECT 'the end is led on at its height', ST_AsText(ST_Translate(geom, -650000, -6860000), 2) = 'LINESTRING Z (50 60 12,50 0 15)' FROM high.axis WHERE axis_id = 2;

-- A delivery of the source keeps what was mended.
CREATE TABLE lines AS SELECT id, pg_temp.line(line) AS geom, name FROM (VALUES (1, 'LINESTRING(0 0,80 0,160 0)', 'Main Street'), (2, 'LINESTRING(0 0,80 0,160 0)', 'Route 9'), (3, 'LINESTRING(120 1.2,120 60)', 'Mill Lane'),
  (4, 'LINESTRING(0 200,60 200,160 200)', 'Long Road'), (5, 'LINESTRING(0 270,60 200,160 200,160 290)', 'Loop Road')) v(id, line, name);
SELECT streetgen.create_model('source', 2154) \g /dev/null
CREATE TABLE told AS SELECT * FROM streetgen.import_axes('source', 'lines', '{"source_ref": "id", "name": "name", "width": {"value": 8}}');
SELECT 'the import tells the axes that lie on others', source_refs = '{2,5}' FROM told WHERE what = 'axis lies on another';
SELECT 'and the ends that miss, with the tolerance', source_refs = '{3}' AND what LIKE '%tolerance 1.2 would join them all' FROM told WHERE what LIKE 'end of an axis in the roadway of another%';
SELECT count(*) FROM streetgen.generate('source', wait => true) \g /dev/null
SELECT 'all are mended', pg_temp.mend('source') = 3;
CREATE TABLE mended AS SELECT axis_id, geom FROM source.axis;
UPDATE lines SET name = name || ' II';
SELECT count(*) FROM streetgen.import_axes('source', 'lines', '{"source_ref": "id", "name": "name", "width": {"value": 8}}') \g /dev/null
SELECT 'another delivery brings no twin back', count(*) = 5 AND bool_and(m.geom::bytea = a.geom::bytea) FROM mended m FULL JOIN source.axis a USING (axis_id);
SELECT 'and its other news come in', bool_and(name LIKE '% II') FROM source.axis WHERE source IS NOT NULL;

-- Any streets: twins, parts, near misses, folds and bridges, edited one by one, then mended.
CREATE FUNCTION pg_temp.draw(model name) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  y float8;
  a geometry;
BEGIN
  FOR i IN 0..7 LOOP
    y := 70 * i;
    a := pg_temp.line(format('LINESTRING(0 %s,%s %s,150 %1$s)', y, 40 + floor(70 * random()), y + round((6 * random() - 3)::numeric, 2)));
    EXECUTE format('INSERT INTO %I.axis (geom, width, lane_count, direction, level) VALUES ($1, $2, 2, $3, $4)', model) USING a, 6 + floor(5 * random()), CASE WHEN random() < 0.8 THEN 'both' ELSE 'direct' END, (random() < 0.1)::integer;
    EXECUTE format('INSERT INTO %I.axis (geom, width, lane_count, level) SELECT g, 6 + floor(5 * random()), 2, (random() < 0.1)::integer FROM unnest($1) g', model) USING ARRAY[
      CASE floor(4 * random()) WHEN 0 THEN ST_Reverse(a) WHEN 1 THEN ST_Translate(a, 0, round((4 * random() - 2)::numeric, 2)) WHEN 2 THEN ST_LineSubstring(a, 0.2, 0.7)
        ELSE ST_AddPoint(ST_AddPoint(a, ST_Translate(ST_EndPoint(a), 20, 25)), ST_Translate(ST_StartPoint(a), -30, 10), 0) END,
      pg_temp.line(format('LINESTRING(%s %s,%s %s)', 10 + floor(130 * random()), y + round((7 * random() - 3)::numeric, 2), 10 + floor(130 * random()), y + 66 + round((7 * random() - 3)::numeric, 2))),
      pg_temp.line(format('LINESTRING(%1$s %2$s,%1$s %3$s,%1$s %4$s)', 10 + floor(130 * random()), y + 2, y + 40, y + 15))];
  END LOOP;
END $$;
CREATE FUNCTION pg_temp.tried(seed float8, side text) RETURNS TABLE (followed boolean, mended boolean, still_followed boolean) LANGUAGE plpgsql AS $$
DECLARE
  rounds integer := 0;
BEGIN
  PERFORM setseed(seed), streetgen.drop_model(m.name) FROM streetgen.model m WHERE m.name = 'any';
  PERFORM setseed(seed), streetgen.create_model('any', 2154, driving_side => side);
  PERFORM pg_temp.draw('any');
  UPDATE "any".axis SET geom = ST_Translate(geom, 0, 0.9) WHERE axis_id = 5 + floor(20 * random());
  DELETE FROM "any".axis WHERE axis_id % 9 = floor(9 * random());
  UPDATE "any".axis SET width = 12 WHERE axis_id = 5 + floor(20 * random());
  followed := test.followed('any', 'once');
  -- What one proposal moved another may go by.
  WHILE rounds < 3 AND EXISTS (SELECT FROM "any".axis_to_mend) LOOP
    rounds := rounds + 1;
    PERFORM pg_temp.mend('any');
  END LOOP;
  mended := rounds > 0 AND NOT EXISTS (SELECT FROM "any".axis_to_mend)
    AND NOT EXISTS (SELECT FROM streetgen.check_model('any') WHERE rule LIKE 'end of an axis%');
  still_followed := test.followed('any', 'once');
  RETURN NEXT;
END $$;
SELECT format('edited one by one as from scratch, mended in few rounds, and as from scratch again: %s, %s', seed, side), t.followed AND t.mended AND t.still_followed
  FROM (VALUES (0.11, 'right'), (0.42, 'left'), (0.73, 'right'), (-0.36, 'left')) v(seed, side), pg_temp.tried(seed, side) t;
DROP OWNED BY mend_editor, mend_reader;
DROP ROLE mend_editor, mend_reader;
-- The last two vertices of an end that misses are one place.
SELECT streetgen.create_model('upright', 2154) \g /dev/null
INSERT INTO upright.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 8), ('SRID=2154;LINESTRING(650050 6860040, 650050 6860002, 650050 6860002)', 6);
SELECT 'an end whose last two vertices are one place is joined too', array_agg(proposal) = '{join}' FROM upright.axis_to_mend;
