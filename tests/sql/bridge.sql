\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Bridges and tunnels: decks over what edges cross, whole edges off the ground, edits by any path.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,bridge}'), streetgen.create_model('fresh', 2154, subjects => '{interconnection,bridge}');
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('plain', 2154);
END $$;
INSERT INTO town.axis (axis_id, geom, width, level, importance) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)', 8, 0, 4), (2, 'SRID=2154;LINESTRING(650100 6859700, 650100 6860300)', 10, 1, 2),
    (3, 'SRID=2154;LINESTRING(650200 6859700, 650200 6860300)', 8, -1, 3), (4, 'SRID=2154;LINESTRING(650300 6859700, 650300 6860300)', 10, 0, 1),
    (5, 'SRID=2154;LINESTRING(650000 6860012, 650600 6860012)', 8, 0, 4), (6, 'SRID=2154;LINESTRING(650400 6859900, 650600 6860100)', 10, 0, 1);
CREATE VIEW deck AS SELECT e.axis_id, b.* FROM town.bridge b JOIN town.edge e USING (edge_id);
SELECT 'a model has bridges on demand alone', to_regclass('plain.bridge') IS NULL AND to_regclass('town.tunnel') IS NOT NULL;
SELECT 'an edge above the ground is a bridge from end to end', (d.start_abscissa, d.end_abscissa, d.method) = (0, 600, 'stated') AND ST_Equals(d.surface, s.surface)
    FROM deck d JOIN town.section s USING (edge_id) WHERE axis_id = 2;
SELECT 'an edge below the ground is a tunnel', (SELECT array_agg((axis_id, t.start_abscissa, t.end_abscissa, t.method)::text) FROM town.tunnel t JOIN town.edge USING (edge_id)) = '{"(3,0,600,stated)"}';
-- Half of 8 m and 3 m more before the first road and behind the second one.
SELECT 'one deck spans two roads side by side', (abs(start_abscissa - 293) < 1e-9, abs(end_abscissa - 319) < 1e-9, method) = (true, true, 'overpass') AND abs(ST_Area(surface) - 26 * 10) < 1e-6 FROM deck WHERE axis_id = 4;
SELECT 'a deck is longer where roads cross at an angle', count(*) = 1 AND bool_and(abs(end_abscissa - start_abscissa - 12 * sqrt(2) - 2 * (7 * sqrt(2) + 5)) < 1e-6) FROM deck WHERE axis_id = 6;
SELECT 'a deck covers all that the two roads share', bool_and(ST_Area(ST_Difference(ST_Intersection(ST_Buffer(a.geom, a.width / 2, 'endcap=flat'), ST_Buffer(b.geom, b.width / 2, 'endcap=flat')), u.surface)) < 1e-6)
    FROM town.overpass o JOIN town.edge a ON a.edge_id = o.edge_above JOIN town.edge b ON b.edge_id = o.edge_below LEFT JOIN LATERAL (
        SELECT ST_Union(d.surface) AS surface FROM town.bridge d WHERE d.edge_id = o.edge_above) u ON true WHERE b.level >= 0;
SELECT 'a second run changes no row', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town');
SELECT 'the summary counts them', count(*) = 5 FROM streetgen.summary('town') WHERE subject ~ '^(bridge|tunnel)s, ';
SELECT 'a picture has decks, shadows and tunnels', bool_and(drawing ~ class) FROM (SELECT streetgen.svg('town', legend => true) AS drawing) s, unnest(ARRAY['class="bridge"', 'class="bridge_shadow"[^>]* transform="translate', 'class="tunnel"', 'class="tunnel_wall"[^>]*dasharray']) class;

-- A bridge whose street goes on from both its ends, of two pieces, with sidewalks; a tunnel that no block covers.
SELECT streetgen.create_model('ends', 2154, subjects => '{bridge,sidewalk}') \g /dev/null
INSERT INTO ends.axis (axis_id, geom, width, level, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 8, 0, 2, 2), (2, 'SRID=2154;LINESTRING(650100 6860000,650150 6860000)', 8, 1, 2, 2), (3, 'SRID=2154;LINESTRING(650150 6860000,650200 6860000)', 8, 1, 2, 2),
  (4, 'SRID=2154;LINESTRING(650200 6860000,650300 6860000)', 8, 0, 2, 2), (5, 'SRID=2154;LINESTRING(650130 6859900,650130 6860100)', 8, 0, 2, 2), (6, 'SRID=2154;LINESTRING(650000 6859800,650300 6859800)', 8, -1, 0, 0);
DO $$ BEGIN PERFORM streetgen.generate('ends'); END $$;
CREATE TEMPORARY TABLE drawn AS SELECT s.* FROM streetgen._shapes('ends', ST_MakeEnvelope(649900, 6859700, 650400, 6860200, 2154), ARRAY(SELECT DISTINCT layer FROM streetgen.symbol_rule)) s;
SELECT 'the pieces of a bridge are one deck, with its sidewalks', count(*) = 1 AND bool_and(ST_Covers(ST_Buffer(geom, 1e-6), ST_MakeEnvelope(650101, 6859994.5, 650199, 6860005.5, 2154))) FROM drawn WHERE layer = 'bridge';
SELECT 'parapets stand along both sides of it', count(*) = 1 AND bool_and(ST_Area(geom) BETWEEN 95 AND 101) FROM drawn WHERE layer = 'parapet';
SELECT 'and nothing lies across the street at its ends: ' || layer, count(*) > 0 AND NOT bool_or(ST_Intersects(geom, ST_MakeEnvelope(x - 3, 6859997, x + 3, 6860003, 2154))) FROM drawn, unnest('{650100,650200}'::float8[]) x WHERE layer IN ('parapet', 'kerb') GROUP BY layer ORDER BY layer;
SELECT 'its shadow falls on no street that it goes on to', count(*) = 1 AND bool_and(NOT ST_Intersects(ST_Translate(geom, 2, -2), a.surface)) FROM drawn, (SELECT ST_Union(surface) AS surface FROM ends.section JOIN ends.edge USING (edge_id) WHERE axis_id IN (1, 4)) a WHERE layer = 'bridge_shadow' GROUP BY layer;
SELECT 'but on what it passes over', bool_and(ST_Area(ST_Intersection(ST_Translate(drawn.geom, 2, -2), s.surface)) > 8 * 8) FROM drawn, ends.section s JOIN ends.edge USING (edge_id) WHERE layer = 'bridge_shadow' AND axis_id = 5;
SELECT streetgen.set('ends', 'ground_level', '1') \g /dev/null
SELECT 'the walls of a tunnel lie on the ground, whatever its level', count(*) > 0 AND bool_and(level = 1) FROM streetgen._shapes('ends', ST_MakeEnvelope(649900, 6859700, 650400, 6860200, 2154), '{tunnel_wall}');
SELECT streetgen.set('ends', 'ground_level', '-2') \g /dev/null
SELECT 'and never below its own road', count(*) > 0 AND bool_and(level = -1) FROM streetgen._shapes('ends', ST_MakeEnvelope(649900, 6859700, 650400, 6860200, 2154), '{tunnel_wall}');
SELECT streetgen.set('ends', 'ground_level', '0') \g /dev/null
SELECT 'a veil lies over all of a tunnel', count(*) = 1 AND bool_and(d.level = -1 AND ST_Covers(ST_Buffer(d.geom, 0.001), s.surface)) FROM drawn d, ends.section s JOIN ends.edge e USING (edge_id) WHERE d.layer = 'tunnel' AND axis_id = 6;
SELECT 'above its paint and below the ground: ' || theme, min(place) FILTER (WHERE layer = 'tunnel') > max(place) FILTER (WHERE layer IN ('section', 'lane', 'lane_separator', 'marking')) AND max(place) FILTER (WHERE layer = 'tunnel') < 10 + min(place) FILTER (WHERE layer = 'block') FROM streetgen.symbol_rule WHERE place < 10 GROUP BY theme ORDER BY theme;
DROP TABLE drawn;
SELECT streetgen.drop_model('ends') \g /dev/null

-- Any path gives the same bridges.
CREATE FUNCTION pg_temp.same_from_scratch() RETURNS boolean LANGUAGE plpgsql AS $$
BEGIN
  PERFORM set_config('streetgen.live', 'off', true);
  DELETE FROM fresh.axis; DELETE FROM fresh.overpass_override;
  INSERT INTO fresh.axis SELECT * FROM town.axis; INSERT INTO fresh.overpass_override SELECT * FROM town.overpass_override;
  PERFORM set_config('streetgen.live', 'on', true);
  PERFORM streetgen.generate('fresh');
  RETURN test.same('town', 'fresh');
END $$;
SELECT 'as from scratch', pg_temp.same_from_scratch();
UPDATE town.axis SET width = 14 WHERE axis_id = 1;
SELECT 'a wider road below makes decks longer', abs(start_abscissa - 290) < 1e-9 AND pg_temp.same_from_scratch() FROM deck WHERE axis_id = 4;
UPDATE town.axis SET geom = ST_Translate(geom, 0, -40) WHERE axis_id = 1;
SELECT 'a road below that moves away leaves two decks', count(*) = 2 AND pg_temp.same_from_scratch() FROM deck WHERE axis_id = 4;
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'a road below that is gone takes its deck along', count(*) = 1 AND pg_temp.same_from_scratch() FROM deck WHERE axis_id = 4;
INSERT INTO town.overpass_override (geom, axis_above, axis_below) VALUES ('SRID=2154;POINT(650300 6860012)', 5, 4);
SELECT 'by hand the other one has the deck', pg_temp.same_from_scratch() AND (SELECT count(*) = 0 FROM deck WHERE axis_id = 4) AND (SELECT count(*) = 1 FROM deck WHERE axis_id = 5);
UPDATE town.axis SET level = 0 WHERE axis_id = 3;
SELECT 'a tunnel of the ground is none', pg_temp.same_from_scratch() AND NOT EXISTS (SELECT FROM town.tunnel);
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650300 6860014, 650300 6860300)' WHERE axis_id = 4;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650400 6859900, 650515 6860015)' WHERE axis_id = 6;
DELETE FROM town.overpass_override;
SELECT 'a bridge that ends above the road below is told', count(*) = 1 FROM streetgen.check_model('town') WHERE (severity, rule) = ('notice', 'bridge ends at a node above what it crosses, m');

-- Roads that touch, spiral and turn back.
DO $$ BEGIN PERFORM streetgen.create_model('odd', 2154, subjects => '{bridge}'); END $$;
INSERT INTO odd.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650100 6860060, 650050 6860060, 650050 6859950)', 7),
    (2, 'SRID=2154;LINESTRING(650200 6860000, 650204 6860000)', 30), (3, 'SRID=2154;LINESTRING(650202 6859950, 650202 6860050)', 7), (4, 'SRID=2154;LINESTRING(650300 6860000, 650400 6860004)', 7),
    (5, 'SRID=2154;LINESTRING(650300 6860004, 650400 6860000)', 7);
SELECT 'a road that spirals over itself has a deck', count(*) = 1 FROM odd.bridge JOIN odd.edge USING (edge_id) WHERE axis_id = 1;
SELECT 'decks have ground, within their edges', count(*) = 3 AND bool_and(ST_Area(b.surface) > 1 AND ST_IsValid(b.surface) AND b.start_abscissa >= 0 AND b.end_abscissa <= ST_Length(e.geom) + 1e-9) FROM odd.bridge b JOIN odd.edge e USING (edge_id);
DROP VIEW deck;
DO $$ BEGIN PERFORM streetgen.switch_subject('town', 'bridge', false); END $$;
SELECT 'switched off, the tables are gone', to_regclass('town.bridge') IS NULL AND to_regclass('town.tunnel') IS NULL;
UPDATE town.axis SET width = 9 WHERE axis_id = 5;
SELECT 'switched on they are filled', sum(inserted) > 0 FROM streetgen.switch_subject('town', 'bridge', true) WHERE relation = 'bridge';
