\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
\ir shared/made_terrain.sql
-- Heights along edges: clearances, grades, edits by any path.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,height}'), streetgen.create_model('fresh', 2154, subjects => '{interconnection,height}'),
    streetgen.create_model('hill', 2154, 3, subjects => '{height}');
END $$;
INSERT INTO town.axis (axis_id, geom, width, level, speed) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)', 7, 0, 50), (2, 'SRID=2154;LINESTRING(650300 6859700, 650300 6859960)', 7, 0, 50),
    (3, 'SRID=2154;LINESTRING(650300 6859960, 650300 6860040)', 7, 1, 50), (4, 'SRID=2154;LINESTRING(650300 6860040, 650300 6860400)', 7, 0, 50),
    (5, 'SRID=2154;LINESTRING(650100 6859800, 650100 6860200)', 7, -1, 50), (6, 'SRID=2154;LINESTRING(650600 6860000, 650900 6860000)', 7, 0, 50);
-- Height of the road of an edge, metres along it.
CREATE FUNCTION pg_temp.height(model name, edge bigint, at float8) RETURNS float8 LANGUAGE plpgsql AS $$
DECLARE z float8; BEGIN
  EXECUTE format('SELECT ST_Z(ST_LineInterpolatePoint(geom, least(1, greatest(0, $2 / ST_Length2D(geom))))) FROM %I.profile WHERE edge_id = $1', model) INTO z USING edge, at;
  RETURN z;
END $$;
CREATE FUNCTION pg_temp.holds(model name) RETURNS TABLE (name text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE replace($q$
    SELECT 'every edge has a profile along its line', (SELECT count(*) FROM @.edge) = (SELECT count(*) FROM @.profile)
      AND (SELECT bool_and(ST_HausdorffDistance(ST_Force2D(e.geom), ST_Force2D(p.geom)) < 1e-6) FROM @.edge e JOIN @.profile p USING (edge_id))
    UNION ALL SELECT 'clearances hold', coalesce(bool_and(pg_temp.height('@', edge_above, abscissa_above) >= pg_temp.height('@', edge_below, abscissa_below) + clearance - 1e-5), true) FROM @.overpass
    UNION ALL SELECT 'no road is steeper than its grade', bool_and(abs(ST_Z(b.geom) - ST_Z(a.geom)) <= p.grade_max * ST_Distance(a.geom, b.geom) + 1e-5)
      FROM @.profile p, ST_DumpPoints(p.geom) a, ST_DumpPoints(p.geom) b WHERE b.path[1] = a.path[1] + 1
    UNION ALL SELECT 'roads meet at one height', bool_and(low = high) FROM (SELECT min(z) AS low, max(z) AS high FROM (
      SELECT from_node AS node_id, round(ST_Z(ST_StartPoint(p.geom))::numeric, 9) AS z FROM @.edge JOIN @.profile p USING (edge_id)
      UNION ALL SELECT to_node, round(ST_Z(ST_EndPoint(p.geom))::numeric, 9) FROM @.edge JOIN @.profile p USING (edge_id)) v GROUP BY node_id) n$q$, '@', model);
END $$;
SELECT h.* FROM pg_temp.holds('town') h;
SELECT 'the bridge is lifted, and the roads that lead to it', array_agg(axis_id ORDER BY axis_id) = '{2,3,4}' FROM town.profile JOIN town.edge USING (edge_id) WHERE method = 'lifted';
SELECT 'the tunnel sinks alone', array_agg(axis_id) = '{5}' FROM town.profile JOIN town.edge USING (edge_id) WHERE method = 'sunk';
SELECT 'what is not near stays on the ground', bool_and(ST_ZMax(p.geom) = 0 AND ST_ZMin(p.geom) = 0) FROM town.profile p JOIN town.edge USING (edge_id) WHERE axis_id IN (1, 6);
SELECT 'a second run changes no row', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');

-- Any path gives the same heights.
CREATE FUNCTION pg_temp.same_from_scratch() RETURNS boolean LANGUAGE plpgsql AS $$
BEGIN
  PERFORM set_config('streetgen.live', 'off', true);
  DELETE FROM fresh.axis; DELETE FROM fresh.height_override;
  INSERT INTO fresh.axis SELECT * FROM town.axis; INSERT INTO fresh.height_override SELECT * FROM town.height_override;
  PERFORM set_config('streetgen.live', 'on', true);
  PERFORM streetgen.generate('fresh');
  RETURN NOT EXISTS (SELECT FROM (SELECT axis_id, start_abscissa, p.geom, p.method FROM town.profile p JOIN town.edge USING (edge_id)) t
    FULL JOIN (SELECT axis_id, start_abscissa, p.geom, p.method FROM fresh.profile p JOIN fresh.edge USING (edge_id)) f USING (axis_id, start_abscissa)
    WHERE t.method IS DISTINCT FROM f.method OR ST_3DMaxDistance(t.geom, f.geom) IS NULL OR ST_3DHausdorff(t.geom, f.geom) > 1e-6);
END $$;
CREATE FUNCTION ST_3DHausdorff(a geometry, b geometry) RETURNS float8 LANGUAGE sql AS $$
  SELECT max(abs(ST_Z(p.geom) - ST_Z(ST_LineInterpolatePoint(b, ST_LineLocatePoint(b, p.geom))))) FROM ST_DumpPoints(a) p $$;
SELECT 'as from scratch', pg_temp.same_from_scratch();
UPDATE town.axis SET level = 0 WHERE axis_id = 3;
SELECT 'a bridge that is none any more crosses on the ground or above by importance', pg_temp.same_from_scratch();
UPDATE town.axis SET level = 2 WHERE axis_id = 3;
SELECT 'as a bridge again', pg_temp.same_from_scratch();
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'where the road below is gone the bridge lies half a metre over the ground', (SELECT array_agg(axis_id ORDER BY axis_id) = '{2,3,4}' FROM town.profile JOIN town.edge USING (edge_id) WHERE method = 'lifted') AND (SELECT abs(max(ST_ZMax(p.geom)) - 0.5) < 0.2 FROM town.profile p);
SELECT 'the same from scratch', pg_temp.same_from_scratch();
INSERT INTO town.axis (axis_id, geom, width, level, speed) VALUES (7, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)', 7, 0, 50), (8, 'SRID=2154;LINESTRING(650250 6859900, 650500 6860100)', 7, 4, 50);
SELECT 'roads in three storeys', pg_temp.same_from_scratch();
SELECT h.* FROM pg_temp.holds('town') h;
UPDATE town.axis SET geom = ST_SetPoint(geom, 1, 'SRID=2154;POINT(650300 6860300)') WHERE axis_id = 4;
SELECT 'a road that leads up is made shorter', pg_temp.same_from_scratch();
UPDATE town.axis SET speed = 30 WHERE axis_id IN (2, 4);
SELECT 'a slower road is steeper', pg_temp.same_from_scratch();


-- A bridge without heights of its own is clear of the ground, also of several pieces, and without a road below.
SELECT streetgen.create_model('river', 2154, subjects => '{height}') \g /dev/null
INSERT INTO river.axis (axis_id, geom, width, level, speed) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 0, 50), (2, 'SRID=2154;LINESTRING(650200 6860000, 650260 6860000)', 7, 1, 50),
    (3, 'SRID=2154;LINESTRING(650260 6860000, 650300 6860000)', 7, 1, 50), (4, 'SRID=2154;LINESTRING(650300 6860000, 650500 6860000)', 7, 0, 50),
    (5, 'SRID=2154;LINESTRING(650500 6860000, 650520 6860000)', 7, 1, 50), (6, 'SRID=2154;LINESTRING(650520 6860000, 650700 6860000)', 7, 0, 50);
CREATE FUNCTION pg_temp.over_ground(axis bigint, low integer, high integer) RETURNS float8 LANGUAGE sql AS $$
  SELECT min(pg_temp.height('river', edge_id, at)) FROM river.edge, generate_series(low, high) at WHERE axis_id = axis $$;
SELECT 'a bridge of two pieces is clear of the ground', pg_temp.over_ground(2, 10, 60) >= 0.5 - 1e-6 AND pg_temp.over_ground(3, 0, 30) >= 0.5 - 1e-6;
SELECT 'and no higher than it needs', max(ST_ZMax(p.geom)) < 0.8 FROM river.profile p;
SELECT 'a short one is level with the ground, and is told', (SELECT array_agg(axis_id) FROM streetgen.check_model('river') c JOIN river.edge ON edge_id = id WHERE rule = 'level crossing of water') = '{5}';
SELECT 'nothing else is told of heights', count(*) = 0 FROM streetgen.check_model('river') WHERE rule LIKE 'bridge or tunnel%' OR rule LIKE 'clearance%';
CREATE FUNCTION pg_temp.river_as_anew() RETURNS boolean LANGUAGE sql AS $$ SELECT sum(inserted + updated + deleted) = 0 FROM streetgen.generate('river') $$;
UPDATE river.axis SET level = 0 WHERE axis_id = 3;
SELECT 'a piece that is none any more ends the bridge, as from scratch', pg_temp.river_as_anew() AND pg_temp.over_ground(3, 10, 40) < 0.5 AND pg_temp.over_ground(2, 10, 50) >= 0.5 - 1e-6;
UPDATE river.axis SET level = -1 WHERE axis_id = 3;
SELECT 'a tunnel after a bridge, as from scratch', pg_temp.river_as_anew();
SELECT 'neither is told: both are clear but for their ends', count(*) = 0 FROM streetgen.check_model('river') WHERE rule LIKE 'bridge or tunnel%';
UPDATE river.axis SET level = 1 WHERE axis_id = 3;
DELETE FROM river.axis WHERE axis_id = 4;
SELECT 'where the road beyond is gone it ends in the air, as from scratch', pg_temp.river_as_anew() AND pg_temp.over_ground(3, 0, 40) >= 0.5 - 1e-6;
INSERT INTO river.axis (axis_id, geom, width, level, speed) VALUES (7, 'SRID=2154;LINESTRING(650300 6860000, 650300 6860200)', 7, 0, 50), (8, 'SRID=2154;LINESTRING(650250 6859900, 650250 6860100)', 7, 0, 50), (9, 'SRID=2154;LINESTRING(650230 6859900, 650230 6860100)', 7, 0, 50);
SELECT 'a road that meets it, and two below, as from scratch', pg_temp.river_as_anew();
SELECT 'it stays up between the two', pg_temp.over_ground(2, 30, 50) >= 6 - 0.02;
DO $$ BEGIN PERFORM streetgen.set('river', 'plateau', '0'), streetgen.set('river', 'bridge_rise', '0'); PERFORM streetgen.generate('river'); END $$;
SELECT 'settings take both back', pg_temp.over_ground(2, 30, 50) < 5.9;

-- A bridge that begins with a short piece, without heights, or with heights that nobody knows.
SELECT streetgen.create_model('pieces', 2154, 3, subjects => '{height}') \g /dev/null
INSERT INTO pieces.axis (axis_id, geom, width, level, speed)
    SELECT axis_id, ST_SetSRID(ST_Force3DZ(geom::geometry, CASE axis_id WHEN 3 THEN -9999 ELSE 0 END), 2154), 7,
    level, 50
    FROM (VALUES (1, 'LINESTRING(650000 6860000, 650200 6860000)', 0),
        (2, 'LINESTRING(650200 6860000, 650204 6860000)', 1),
        (3, 'LINESTRING(650204 6860000, 650264 6860000)', 1), (4, 'LINESTRING(650264 6860000, 650464 6860000)', 0))
        v(axis_id, geom, level);
SELECT 'a bridge whose heights nobody knows is clear of the ground',
    min(pg_temp.height('pieces', edge_id, at)) >= 0.5 - 1e-6
    FROM pieces.edge, generate_series(6, 50) at WHERE axis_id = 3;
SELECT 'nothing is told of its first ten metres, of two pieces', count(*) = 0 FROM streetgen.check_model('pieces')
    WHERE rule ~ '^(bridge or tunnel|level crossing)';
DO $$ BEGIN PERFORM streetgen.set('pieces', 'bridge_rise', '0'), streetgen.generate('pieces'); END $$;
SELECT 'where bridges need not rise none is told', count(*) = 0 FROM streetgen.check_model('pieces')
    WHERE rule ~ '^(bridge or tunnel|level crossing)';

-- How high vehicles may be that pass under roads.
SELECT streetgen.create_model('low', 2154, subjects => '{height}') \g /dev/null
INSERT INTO low.axis (axis_id, geom, width, level, speed, height_limit) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650400 6860000)', 7, 0, 50, 4),
    (2, 'SRID=2154;LINESTRING(650100 6859700, 650100 6860300)', 7, 1, 50, NULL),
    (3, 'SRID=2154;LINESTRING(650300 6859700, 650300 6860300)', 7, 2, 50, NULL),
    (4, 'SRID=2154;LINESTRING(650250 6859900, 650350 6859900)', 7, -1, 50, 3);
INSERT INTO low.height_override (axis_id, abscissa, height) VALUES (3, 300, 9);
CREATE FUNCTION pg_temp.limit_told() RETURNS text LANGUAGE sql AS $$
    SELECT string_agg(axis_id || ' by ' || round(measure::numeric, 2), ', ') FROM streetgen.check_model('low') c
        JOIN low.underpass u ON u.overpass_id = c.id JOIN low.edge USING (edge_id)
        WHERE rule = 'height limit other than the clearance, m' $$;
SELECT 'the clearance is from the road below to the deck',
    string_agg(concat_ws(' ', e.axis_id, a.axis_id, round(u.clearance::numeric, 1)), ', ' ORDER BY e.axis_id, a.axis_id)
    = '1 2 5.0, 1 3 8.0, 4 3 5.0'
    FROM low.underpass u JOIN low.edge e USING (edge_id) JOIN low.overpass o USING (overpass_id)
        JOIN low.edge a ON a.edge_id = o.edge_above;
SELECT 'a limit under the lowest deck is none of the higher one, nor of a tunnel', pg_temp.limit_told() IS NULL;
UPDATE low.axis SET height_limit = 5.2 WHERE axis_id = 1;
SELECT 'a limit over the clearance is told', pg_temp.limit_told() = '1 by 0.20';
UPDATE low.axis SET height_limit = 2.6 WHERE axis_id = 1;
SELECT 'one far under it too', pg_temp.limit_told() = '1 by -2.40';
DO $$ BEGIN PERFORM streetgen.set('low', 'deck_depth', '2'); END $$;
SELECT 'a deeper deck leaves less room', pg_temp.limit_told() IS NULL;
SELECT 'refused: a limit of half a metre',
    test.state('UPDATE low.axis SET height_limit = 0.5 WHERE axis_id = 1') = '23514';

-- By hand: the road lies at least so high at a place.
INSERT INTO town.height_editing (geom, height) VALUES ('SRID=2154;POINT(650750 6860002)', 4);
SELECT 'a height drawn lies on the nearest axis', (SELECT array_agg((axis_id, round(abscissa), height)::text) FROM town.height_override) = '{"(6,150,4)"}';
SELECT 'the road lies so high there, and little more', height BETWEEN 4 - 1e-6 AND 4 + 0.7 FROM (SELECT pg_temp.height('town', edge_id, 150) AS height FROM town.edge WHERE axis_id = 6) h;
SELECT 'no kink is left there', max(abs(after - before)) < 0.02 FROM (SELECT (z - lag(z) OVER w) / nullif(at - lag(at) OVER w, 0) AS before, (lead(z) OVER w - z) / nullif(lead(at) OVER w - at, 0) AS after
    FROM (SELECT d.path[1] AS n, ST_Z(d.geom) AS z, ST_X(d.geom) AS at FROM town.profile p JOIN town.edge USING (edge_id), ST_DumpPoints(p.geom) d WHERE axis_id = 6) v WINDOW w AS (ORDER BY n)) g;
SELECT h.* FROM pg_temp.holds('town') h;
SELECT 'a height by hand, as from scratch', pg_temp.same_from_scratch();
UPDATE town.height_editing SET height = 7, geom = 'SRID=2154;POINT(650890 6860000)';
SELECT 'moved and higher it is the same from scratch', pg_temp.same_from_scratch() AND (SELECT max(ST_ZMax(p.geom)) >= 7 FROM town.profile p JOIN town.edge USING (edge_id) WHERE axis_id = 6);
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 6;
SELECT 'it stays at its place on an axis that is turned round', abs(abscissa - 10) < 1e-6 AND pg_temp.same_from_scratch() FROM town.height_override;
UPDATE town.height_editing SET height = -3;
SELECT 'a height under the ground changes nothing, and is told', pg_temp.same_from_scratch() AND (SELECT count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'height by hand below the road, m')
    AND (SELECT bool_and(p.method = 'ground') FROM town.profile p JOIN town.edge USING (edge_id) WHERE axis_id = 6);
UPDATE town.height_override SET axis_id = 999;
SELECT 'one without its axis is told', count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'height override without its axis';
DELETE FROM town.height_editing;
SELECT 'taken back by the view', count(*) = 0 FROM town.height_override;
SELECT 'refused: ' || name, test.state(statement) = state FROM (VALUES
    ('a height that is no number', $$INSERT INTO town.height_editing (geom, height) VALUES ('SRID=2154;POINT(650750 6860000)', 'NaN')$$, '22023'),
    ('a height beyond its range', $$INSERT INTO town.height_editing (geom, height) VALUES ('SRID=2154;POINT(650750 6860000)', 20000)$$, '22023'),
    ('a height far from all axes', $$INSERT INTO town.height_editing (geom, height) VALUES ('SRID=2154;POINT(750750 6860000)', 5)$$, '22023'),
    ('a height without a place', $$INSERT INTO town.height_editing (height) VALUES (5)$$, '22023'),
    ('a height in the table that is infinite', $$INSERT INTO town.height_override (axis_id, abscissa, height) VALUES (6, 10, 'Infinity')$$, '23514')) r(name, statement, state);

-- Roads that pass over each other in turn, nearer than their grades allow.
DO $$ BEGIN PERFORM streetgen.create_model('spiral', 2154, subjects => '{height}'); END $$;
INSERT INTO spiral.axis (axis_id, geom, width, level, speed) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 0, 50), (2, 'SRID=2154;LINESTRING(650030 6859990, 650030 6860010, 650050 6860010, 650050 6859990)', 7, 0, 50);
INSERT INTO spiral.overpass_override (geom, axis_above, axis_below) VALUES ('SRID=2154;POINT(650030 6860000)', 1, 2), ('SRID=2154;POINT(650050 6860000)', 2, 1);
SELECT 'a clearance that cannot be kept is an error of check_model, and heights are finite', count(*) >= 1 AND (SELECT bool_and(ST_ZMax(geom) < 100) FROM spiral.profile) FROM streetgen.check_model('spiral') WHERE (severity, rule) = ('error', 'clearance not kept, m');
-- Streets of one level cross without a node, too, and one of them is lifted.
SELECT streetgen.create_model('level', 2154, subjects => '{height}') \g /dev/null
INSERT INTO level.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650200 6860000)', 7);
SET streetgen.live = off;
INSERT INTO level.axis (axis_id, geom, width) VALUES (2, 'SRID=2154;LINESTRING(650050 6859900, 650050 6860100)', 7), (3, 'SRID=2154;LINESTRING(650100 6859900, 650100 6860000, 650100 6860100)', 7);
SELECT 'who draws axis ' || a || ' waits for others where roads are off the ground, or not', waits = EXISTS (SELECT FROM level._chain_keys(ARRAY[a], ARRAY[a], '{}', '{}') WHERE key = streetgen._chain_key('profile', 0))
    FROM (VALUES (2::bigint, true), (3, false)) v(a, waits);
SET streetgen.live = on;
SELECT 'a mesh lies as high as the profile', abs(max(ST_ZMax(m.geom)) - (SELECT max(ST_ZMax(geom)) FROM town.profile)) < 0.06 FROM streetgen.road_mesh('town') m;

-- Ground with heights.
INSERT INTO hill.axis (axis_id, geom, width, level, speed) VALUES
    (1, 'SRID=2154;LINESTRING Z(650000 6860000 100, 650300 6860000 100, 650600 6860000 130)', 7, 0, 50),
    (2, 'SRID=2154;LINESTRING Z(650150 6859700 100, 650150 6859990 108, 650150 6860010 108, 650150 6860300 100)', 7, 1, 50),
    (3, 'SRID=2154;LINESTRING Z(650450 6859700 115, 650450 6860300 115)', 7, 1, 50);
SELECT h.* FROM pg_temp.holds('hill') h;
SELECT 'a surveyed road that keeps all stays as it is', bool_and(p.method = 'ground' AND ST_Equals(p.geom, e.geom)) FROM hill.profile p JOIN hill.edge e USING (edge_id) WHERE axis_id IN (1, 2);
SELECT 'another one is lifted', bool_and(p.method = 'lifted') FROM hill.profile p JOIN hill.edge e USING (edge_id) WHERE axis_id = 3;
SELECT 'ground steeper than the grade keeps it', grade_max > 0.0999 FROM hill.profile p JOIN hill.edge e USING (edge_id) WHERE axis_id = 1;

-- Ground of a terrain, with a hole of 300 m between its tiles.
DO $$ BEGIN PERFORM streetgen.create_model('slope', 2154, 3, subjects => '{height}'), streetgen.create_design('slope'); END $$;
CREATE TABLE tile AS SELECT test.tile(x, 6861000, 20, 50, '200 + 0.02 * (x - 650000)') AS heights FROM (VALUES (650000), (651300)) v(x);
SELECT 'its tiles are there', streetgen.import_terrain('slope', 'tile') = 2;
INSERT INTO slope.axis (axis_id, geom, width, speed) VALUES (1, 'SRID=2154;LINESTRING Z(650100 6860500 0, 652100 6860500 0)', 7, 50), (2, 'SRID=2154;LINESTRING Z(650400 6860300 7, 650400 6860400 8)', 7, 50),
    (3, 'SRID=2154;LINESTRING Z(660400 6860300 0, 660400 6860400 0)', 7, 50);
SELECT 'an axis whose Z is 0 all along lies on the terrain, across a hole too', bool_and(abs(z - 200 - 0.02 * (x - 650000)) < 1.2) AND count(*) > 100 AND max(x - before) < 10.1
    FROM (SELECT ST_Z(d.geom) AS z, ST_X(d.geom) AS x, lag(ST_X(d.geom)) OVER (ORDER BY d.path) AS before
        FROM slope.profile JOIN slope.edge USING (edge_id), ST_DumpPoints(profile.geom) d WHERE axis_id = 1) v;
SELECT 'one with heights keeps them', ST_ZMin(p.geom) = 7 AND ST_ZMax(p.geom) = 8 FROM slope.profile p JOIN slope.edge USING (edge_id) WHERE axis_id = 2;
SELECT 'without terrain it is 0', ST_ZMin(p.geom) = 0 AND ST_ZMax(p.geom) = 0 FROM slope.profile p JOIN slope.edge USING (edge_id) WHERE axis_id = 3;
INSERT INTO slope.axis (axis_id, geom, width, speed) VALUES (4, 'SRID=2154;LINESTRING Z(650500 6860600 0, 650500 6860700 0)', 7, 50), (5, 'SRID=2154;LINESTRING Z(650500 6860700 0, 650600 6860700 213)', 7, 50);
SELECT 'where it meets one with heights both lie on the terrain', count(*) = 0 AND (SELECT bool_and(abs(ST_ZMin(p.geom) - 210) < 1.2) FROM slope.profile p JOIN slope.edge USING (edge_id) WHERE axis_id IN (4, 5))
    FROM streetgen.check_model('slope') WHERE rule = 'edges of one node at two heights, m';
-- Holes of Z, as BD TOPO writes them.
DO $$ BEGIN PERFORM streetgen.create_model('holes', 2154, 3, subjects => '{height}'); END $$;
INSERT INTO holes.axis (axis_id, geom, width, speed) VALUES (1, 'SRID=2154;LINESTRING Z(650000 6860000 100, 650100 6860000 -1000, 650200 6860000 104)', 7, 50),
    (2, 'SRID=2154;LINESTRING Z(650200 6860000 104, 650300 6860000 -1000)', 7, 50), (3, 'SRID=2154;LINESTRING Z(650300 6860000 -1000, 650400 6860000 -1000)', 7, 50);
SELECT 'a hole of Z is filled between what is known, and at a node by what is near', array_agg(round(ST_Z(d.geom)::numeric, 6) ORDER BY axis_id, d.path) = '{100,102,104,104,104,104,104}'
    FROM holes.profile p JOIN holes.edge USING (edge_id), ST_DumpPoints(p.geom) d;
SELECT 'roads meet at one height beside holes', count(*) = 0 FROM streetgen.check_model('holes') WHERE severity = 'error';
-- The nearest vertex with a height may lie far beyond the reach.
INSERT INTO holes.axis (axis_id, geom, width, speed) VALUES (4, 'SRID=2154;LINESTRING Z(650600 6860000 -1000, 650600 6860100 -1000)', 7, 50);
INSERT INTO holes.axis (axis_id, geom, width, speed) VALUES (5, 'SRID=2154;LINESTRING Z(650500 6859700 120, 650600 6859700 120)', 7, 50);
CREATE FUNCTION pg_temp.filled() RETURNS float8[] LANGUAGE sql AS $$ SELECT ARRAY[ST_ZMin(p.geom), ST_ZMax(p.geom)] FROM holes.profile p JOIN holes.edge USING (edge_id) WHERE axis_id = 4 $$;
SELECT 'a node without a height follows an axis that is drawn nearer', pg_temp.filled() = '{120,120}', sum(updated) = 0 FROM streetgen.generate('holes') WHERE relation = 'profile';
SELECT 'and who edits that waits for who edits there', streetgen._chain_key('profile', 0) = ANY (chains) FROM streetgen._reach_of('holes', '{5}');
DELETE FROM holes.axis WHERE axis_id = 5;
SELECT 'and the next one where it is gone', pg_temp.filled() = '{104,104}', sum(updated) = 0 FROM streetgen.generate('holes') WHERE relation = 'profile';
SELECT 'refused: ' || name, test.state(statement) = state FROM (VALUES
    ('grades that are no object', $$SELECT streetgen.set('town', 'grade_maximal', '8')$$, '22023'),
    ('a grade of nought', $$SELECT streetgen.set('town', 'grade_maximal', '{"0": 0}')$$, '22023'),
    ('arrays of two lengths', $$SELECT streetgen._profiles(ARRAY[]::bytea[], '{1}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', '{}', 30, 1, 2154)$$, '2202E')) r(name, statement, state);

-- Where not all clearances can be kept, the lines tell which ones are, and no key: it says who came first.
\o /dev/null
\ir ../../data/quarter.sql
\o
SELECT streetgen.create_model('copies', 2154, subjects => '{height}') \g /dev/null
SET streetgen.live = off;
INSERT INTO copies.axis (geom, width, width_end, lane_count, importance, level, kind, direction, name) SELECT ST_Translate(geom, 600 * (i % 6), 600 * (i / 6)), width, width_end, lane_count, importance, level, kind, direction, name FROM quarter.axis, generate_series(0, 8) i ORDER BY i, axis_id;
SELECT FROM streetgen.generate('copies') \g /dev/null
CREATE FUNCTION pg_temp.heights(turned bigint) RETURNS TABLE (edge_id bigint, geom geometry) LANGUAGE sql AS $$
  SELECT turned * p.edge_id, p.line::geometry FROM streetgen._solved_profile(
    (SELECT array_agg(ROW (turned * e.edge_id, e.from_node, e.to_node, streetgen._ground_of('copies', e.geom, f.geom, t.geom)::bytea, 0.06, 0.06, e.speed, 0, true, true)::streetgen.profile_edge)
      FROM copies.edge e JOIN copies.node f ON f.node_id = e.from_node JOIN copies.node t ON t.node_id = e.to_node),
    (SELECT array_agg(ROW (turned * edge_above, abscissa_above, turned * edge_below, abscissa_below, clearance, false)::streetgen.profile_lift) FROM copies.overpass), '{}', 30, 1, 2154) p $$;
SELECT 'heights are those of other keys', count(*) > 100 AND bool_and(a.geom::bytea = b.geom::bytea) FROM pg_temp.heights(1) a JOIN pg_temp.heights(-1) b USING (edge_id);
SELECT 'clearances that cannot be kept', count(*) > 0 FROM streetgen.check_model('copies') WHERE rule = 'clearance not kept, m';

-- Heights depend on what hangs together alone: a tunnel far away says nothing of a crossing whose clearance cannot be kept.
SELECT streetgen.create_model('apart', 32629, subjects => '{height}') \g /dev/null
SET streetgen.live = on;
INSERT INTO apart.axis (axis_id, geom, direction) VALUES
  (72, 'SRID=32629;LINESTRING(532107.30 4554729.38,532102.42 4554716.76,532102.93 4554712.93,532102.65 4554714.52,532104.83 4554704.21,532099.09 4554703.07,532085.02 4554718.72,532100.63 4554750.29,532108.03 4554749.43,532107.30 4554729.38)', 'reverse'),
  (169, 'SRID=32629;LINESTRING(532102.93 4554712.93,532148.57 4554698.98,532265.37 4554723.51)', 'both');
CREATE TEMPORARY TABLE alone AS SELECT edge_id, p.geom FROM apart.profile p;
INSERT INTO apart.axis (axis_id, geom, level) VALUES (11, 'SRID=32629;LINESTRING(534000 4555000,534400 4555000)', 0), (12, 'SRID=32629;LINESTRING(534200 4554800,534200 4555200)', -1);
SELECT 'the crossing cannot be kept, and the tunnel is sunk', (SELECT count(*) FROM streetgen.check_model('apart') WHERE rule = 'clearance not kept, m') = 1, (SELECT count(*) FROM apart.profile WHERE method = 'sunk') = 1;
SELECT 'a run moves no height', sum(updated) = 0 FROM streetgen.generate('apart') WHERE relation = 'profile';
SELECT 'heights are those without the tunnel', count(*) = 3 AND bool_and(p.geom::bytea = a.geom::bytea) FROM apart.profile p JOIN alone a USING (edge_id);
UPDATE apart.axis SET width = 5 WHERE axis_id = 169;
SELECT 'nor after an edit', sum(updated) = 0 FROM streetgen.generate('apart') WHERE relation = 'profile';
