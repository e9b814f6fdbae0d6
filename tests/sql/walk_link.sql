\set ECHO none
\ir shared/truths.sql
-- The network of what people walk on: sidewalks, corners, crossings, mapped walks, streets without sidewalks.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.line(text) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.near(x float8, y float8, model name DEFAULT 'town') RETURNS bigint LANGUAGE plpgsql AS $$ DECLARE node bigint; BEGIN
  EXECUTE format('SELECT node_id FROM %I.walk_node ORDER BY geom <-> $1 LIMIT 1', model) INTO node USING pg_temp.line(format('POINT(%s %s)', x, y)); RETURN node; END $$;
-- The shortest way from a node to another one, metres; NULL: there is none.
CREATE FUNCTION pg_temp.way(from_node bigint, to_node bigint, model name DEFAULT 'town', allowed text DEFAULT 'true') RETURNS float8 LANGUAGE plpgsql AS $$ DECLARE shorter bigint; BEGIN
  DROP TABLE IF EXISTS pg_temp.way, pg_temp.reached;
  EXECUTE format('CREATE TEMP TABLE way AS SELECT from_node, to_node, metres FROM %1$I.walk_link WHERE %2$s UNION ALL SELECT to_node, from_node, metres FROM %1$I.walk_link WHERE %2$s', model, allowed);
  CREATE TEMP TABLE reached AS SELECT $1 AS node, 0::float8 AS metres;
  LOOP
    WITH next AS (SELECT w.to_node AS node, min(r.metres + w.metres) AS metres FROM reached r JOIN way w ON w.from_node = r.node GROUP BY 1),
    better AS (UPDATE reached r SET metres = n.metres FROM next n WHERE n.node = r.node AND n.metres < r.metres - 1e-9 RETURNING 1),
    new AS (INSERT INTO reached SELECT * FROM next n WHERE NOT EXISTS (SELECT FROM reached r WHERE r.node = n.node) RETURNING 1)
    SELECT (SELECT count(*) FROM better) + (SELECT count(*) FROM new) INTO shorter;
    EXIT WHEN shorter = 0;
  END LOOP;
  RETURN (SELECT metres FROM reached WHERE node = $2);
END $$;
CREATE FUNCTION pg_temp.parts(model name) RETURNS bigint LANGUAGE plpgsql AS $$ DECLARE nodes bigint[]; reached bigint[]; parts bigint := 0; BEGIN
  EXECUTE format('CREATE TEMP TABLE link AS SELECT from_node, to_node FROM %1$I.walk_link UNION SELECT to_node, from_node FROM %1$I.walk_link', model);
  LOOP
    WITH RECURSIVE part AS (SELECT (SELECT min(from_node) FROM link) AS node UNION SELECT to_node FROM part JOIN link ON from_node = node) SELECT array_agg(node) INTO reached FROM part;
    DELETE FROM link WHERE from_node = ANY (reached); EXIT WHEN NOT FOUND; parts := parts + 1;
  END LOOP;
  DROP TABLE link; RETURN parts; END $$;

-- Four arms with sidewalks; a service road without.
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{footway,object}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, radius, importance, sidewalk_left, sidewalk_right, kind) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 5, 4, 2, 2, 'tertiary'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 5, 4, 2, 2, 'tertiary'),
    (3, pg_temp.line('LINESTRING(100 0,100 90)'), 6, 5, 4, 2, 2, 'residential'), (4, pg_temp.line('LINESTRING(100 -90,100 0)'), 6, 5, 4, 2, 2, 'residential'),
    (5, pg_temp.line('LINESTRING(200 0,300 0)'), 8, 5, 4, 2, 2, 'tertiary'), (6, pg_temp.line('LINESTRING(200 0,200 60)'), 4, 3, 6, 0, 0, 'service');
END $$;
SELECT 'all is one network', pg_temp.parts('town') = 1;
SELECT 'a sidewalk lies in the middle of its strip', bool_and(abs(ST_Distance(ST_LineInterpolatePoint(l.geom, 0.5), e.geom) - (e.width / 2 + 1)) < 0.01) AND count(*) >= 8 FROM town.walk_link l JOIN town.edge e USING (edge_id) WHERE l.kind = 'sidewalk' AND side IN ('left', 'right') AND l.metres > 20;
SELECT 'sidewalks join around each corner', count(*) = 4 FROM town.walk_link WHERE side LIKE 'corner%' AND ST_DWithin(geom, pg_temp.line('POINT(100 0)'), 20);
SELECT 'each arm of a junction is crossed', count(*) = 4 AND count(DISTINCT edge_id) = 4 FROM town.walk_link WHERE kind = 'crossing' AND ST_DWithin(geom, pg_temp.line('POINT(100 0)'), 20);
SELECT 'at a mouth that nobody crosses a street for, the mouth alone', count(DISTINCT edge_id) = 1 AND min(edge_id) = (SELECT edge_id FROM town.edge WHERE axis_id = 6) FROM town.walk_link WHERE kind = 'crossing' AND ST_DWithin(geom, pg_temp.line('POINT(200 0)'), 20);
SELECT 'people walk along a street without a sidewalk, up to the walk across its mouth', count(*) = 1 AND bool_and(ST_Length(geom) BETWEEN 50 AND 56) FROM town.walk_link WHERE kind = 'street';
SELECT 'nodes have the links that end there', (SELECT sum(links) FROM town.walk_node) = 2 * (SELECT count(*) FROM town.walk_link) AND NOT EXISTS (SELECT FROM town.walk_link l WHERE NOT EXISTS (SELECT FROM town.walk_node n WHERE n.node_id = l.to_node AND ST_DWithin(n.geom, ST_EndPoint(l.geom), 1e-9)));
SELECT 'keys are unique', count(*) = count(DISTINCT walk_link_id) FROM town.walk_link;
SELECT 'over the junction it is not far', pg_temp.way(pg_temp.near(0, 5), pg_temp.near(200, -5)) BETWEEN 205 AND 225;
SELECT 'an extent gives the links that touch it, as they are', count(*) > 5 AND count(*) = (SELECT count(*) FROM town.walk_link WHERE geom && pg_temp.line('LINESTRING(90 -10,110 12)')) AND bool_and(EXISTS (SELECT FROM town.walk_link l WHERE l.walk_link_id = w.walk_link_id AND (l.from_node, l.to_node) = (w.from_node, w.to_node)))
  FROM streetgen.walk_links('town', ST_Envelope(pg_temp.line('LINESTRING(90 -10,110 12)'))) w;

-- A line of a crossing that ends within the roadway is led on to the sidewalk ahead, one beyond it ends there.
INSERT INTO town.footway (footway_id, geom, kind, role) VALUES (20, pg_temp.line('LINESTRING(30 -6,30 3)'), 'footway', 'crossing');
SELECT 'a mapped crossing leads from sidewalk to sidewalk', count(*) = 1 AND bool_and(metres BETWEEN 9.9 AND 10.1) FROM town.walk_link WHERE footway_id = 20;
DELETE FROM town.footway WHERE footway_id = 20;

-- Crossings that are known, and mapped walks.
INSERT INTO town.pedestrian_crossing_editing (geom, marking, kerb) VALUES (pg_temp.line('POINT(50 0)'), 'zebra', 'lowered'), (pg_temp.line('POINT(250 0)'), 'lines', 'raised');
SELECT 'a crossing of a street joins its sides', count(*) = 2 AND bool_and(street_object_id IS NOT NULL AND metres BETWEEN 9.9 AND 10.1 AND width = 4 AND kerb_from = kerb_to) AND array_agg(marking || ' ' || kerb_from ORDER BY edge_id) = '{"zebra lowered","lines raised"}' FROM town.walk_link WHERE street_object_id IS NOT NULL;
SELECT 'and makes ways shorter', pg_temp.way(pg_temp.near(50, 5), pg_temp.near(50, -5)) < 10.1;
SELECT 'but not by wheelchair over raised kerbs', pg_temp.way(pg_temp.near(250, 5), pg_temp.near(250, -5)) < 10.1 AND pg_temp.way(pg_temp.near(250, 5), pg_temp.near(250, -5), 'town', $$wheelchair IS DISTINCT FROM 'no'$$) > 100;
-- A kerb at one end alone, and one of which nothing is known.
INSERT INTO town.footway (footway_id, geom, kind, role) VALUES (21, pg_temp.line('LINESTRING(80 -7,80 7)'), 'footway', 'crossing');
INSERT INTO town.footway_kerb (geom, kerb) VALUES (pg_temp.line('POINT(80 4.2)'), 'raised');
SELECT 'each end of a crossing has its own kerb', count(*) = 1 AND bool_and(CASE WHEN ST_Y(ST_StartPoint(geom)) > 6860000 THEN kerb_from ELSE kerb_to END = 'raised' AND num_nulls(kerb_from, kerb_to) = 1 AND wheelchair = 'no')
  FROM town.walk_link WHERE footway_id = 21;
UPDATE town.footway SET geom = ST_Reverse(geom) WHERE footway_id = 21;
SELECT 'whichever way it is drawn', count(*) = 1 AND bool_and(CASE WHEN ST_Y(ST_StartPoint(geom)) > 6860000 THEN kerb_from ELSE kerb_to END = 'raised' AND num_nulls(kerb_from, kerb_to) = 1) FROM town.walk_link WHERE footway_id = 21;
DELETE FROM town.footway WHERE footway_id = 21;
DELETE FROM town.footway_kerb;
SELECT 'all is one network still', pg_temp.parts('town') = 1;
INSERT INTO town.footway (footway_id, geom, kind, role, width, surface, incline, climb, tactile_paving, wheelchair, foot) VALUES
  (1, pg_temp.line('LINESTRING(60 0,60 40,95 80)'), 'footway', NULL, 1.5, 'gravel', 4, NULL, NULL, NULL, 'permissive'), (2, pg_temp.line('LINESTRING(60 40,40 40)'), 'steps', NULL, NULL, NULL, NULL, 'up', NULL, NULL, NULL),
  (3, pg_temp.line('LINESTRING(40 40,40 6)'), 'path', NULL, NULL, NULL, NULL, NULL, 'yes', 'limited', NULL), (4, pg_temp.line('LINESTRING(150 -20,150 20)'), 'footway', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  (5, pg_temp.line('LINESTRING(20 20,20 -20)'), 'cycleway', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL), (6, pg_temp.line('LINESTRING(30 20,30 -20)'), 'footway', NULL, NULL, NULL, NULL, NULL, NULL, NULL, 'no');
SELECT 'a walk that leads to the middle of a street ends at its sidewalk', count(*) = 2 AND bool_and(ST_YMin(geom) >= 6860004.9) FROM town.walk_link WHERE footway_id = 1;
SELECT 'one that ends before a sidewalk is led on to it', count(*) = 1 AND bool_and(abs(ST_YMin(geom) - 6860005) < 0.1) FROM town.walk_link WHERE footway_id = 3;
SELECT 'one that leads over a street crosses it between the sidewalks', array_agg(kind ORDER BY geom) FILTER (WHERE metres BETWEEN 9.9 AND 10.1) = '{crossing}' AND count(*) = 3 FROM town.walk_link WHERE footway_id = 4;
SELECT 'nobody walks on a cycle track of which nothing is said, nor where he may not', NOT EXISTS (SELECT FROM town.walk_link WHERE footway_id IN (5, 6));
SELECT 'nor over the street where these lead over it', count(*) = 2 AND NOT EXISTS (SELECT FROM town.walk_link JOIN
    town.pedestrian_crossing c USING (street_object_id) WHERE c.footway_id IN (5, 6)) FROM town.pedestrian_crossing
    WHERE footway_id IN (5, 6);
SELECT 'a link has what its footway has', (kind, width, surface, incline, foot) = ('walk', 1.5, 'gravel', 4, 'permissive') FROM town.walk_link WHERE footway_id = 1 LIMIT 1;
SELECT 'steps are none for a wheelchair; what is said of it counts', (SELECT (kind, wheelchair, climb) = ('steps', 'no', 'up') FROM town.walk_link WHERE footway_id = 2) AND (SELECT (wheelchair, tactile_paving) = ('limited', 'yes') FROM town.walk_link WHERE footway_id = 3);
SELECT 'walks, steps and sidewalks are one network', pg_temp.way(pg_temp.near(20, 5), pg_temp.near(103, 85)) IS NOT NULL;
INSERT INTO town.street_object_editing (type, geom, placement) VALUES ('bollard', pg_temp.line('POINT(60 20)'), 'absolute');
SELECT 'a bollard stands on the walk', array_agg(DISTINCT barriers::text) FILTER (WHERE barriers IS NOT NULL) = '{"{bollard}"}' AND bool_and(footway_id = 1) FILTER (WHERE barriers IS NOT NULL) FROM town.walk_link;

-- Sidewalks that are mapped stand for those of their sides.
INSERT INTO town.footway (footway_id, geom, kind, role) VALUES (7, pg_temp.line('LINESTRING(104.5 12,104.5 88)'), 'footway', 'sidewalk'), (8, pg_temp.line('LINESTRING(88 -6,88 6)'), 'footway', 'crossing');
SELECT 'a mapped sidewalk stands for that of its side', NOT EXISTS (SELECT FROM town.walk_link JOIN town.edge USING (edge_id) WHERE axis_id = 3 AND side = 'right') AND (SELECT sum(metres) BETWEEN 75 AND 90 FROM town.walk_link WHERE footway_id = 7 AND kind = 'sidewalk');
SELECT 'and corners lead to it', pg_temp.way(pg_temp.near(150, 5), pg_temp.near(104.5, 90)) BETWEEN 120 AND 140;
SELECT 'a mapped crossing stands for that of its arm', count(*) FILTER (WHERE footway_id = 8) > 0 AND count(*) FILTER (WHERE edge_id = (SELECT edge_id FROM town.edge WHERE axis_id = 1) AND street_object_id IS NULL) = 0 FROM town.walk_link WHERE kind = 'crossing';
SELECT 'and its ends meet the sidewalks', pg_temp.parts('town') = 1;

-- Live: an edit shows, and links that it leaves keep their keys.
CREATE TEMP TABLE before AS SELECT walk_link_id, from_node, to_node FROM town.walk_link;
UPDATE town.axis SET width = 7 WHERE axis_id = 5;
SELECT 'after an edit far links are the same, near ones others', count(*) FILTER (WHERE l.walk_link_id IS NULL) BETWEEN 2 AND 12 AND count(l.walk_link_id) > 15 FROM before LEFT JOIN town.walk_link l USING (walk_link_id, from_node, to_node);
UPDATE town.axis SET width = 8 WHERE axis_id = 5;
SELECT 'and taken back all is as it was', NOT EXISTS (TABLE before EXCEPT SELECT walk_link_id, from_node, to_node FROM town.walk_link) AND (SELECT count(*) FROM before) = (SELECT count(*) FROM town.walk_link);

-- Streets with a sidewalk on one side or none, beside each other.
DO $$ BEGIN
  PERFORM streetgen.create_model('odd', 2154, subjects => '{footway}', driving_side => 'left');
  INSERT INTO odd.axis (axis_id, geom, width, importance, sidewalk_left, sidewalk_right, kind) VALUES
    (1, pg_temp.line('LINESTRING(0 0,100 0)'), 8, 4, 2, 0, 'tertiary'), (2, pg_temp.line('LINESTRING(100 0,200 0)'), 8, 4, 0, 0, 'tertiary'), (3, pg_temp.line('LINESTRING(200 0,300 0)'), 8, 4, 0, 2, 'tertiary'),
    (4, pg_temp.line('LINESTRING(0 500,100 500)'), 12, 1, NULL, NULL, 'motorway');
END $$;
SELECT 'a street between sidewalks is entered from them', pg_temp.parts('odd') = 1 AND pg_temp.way(pg_temp.near(0, 5, 'odd'), pg_temp.near(300, -5, 'odd'), 'odd') BETWEEN 300 AND 330;
INSERT INTO odd.footway (footway_id, geom, kind, role) VALUES (2, pg_temp.line('LINESTRING(108 -8,108 8)'), 'footway', 'crossing');
SELECT 'also beside a crossing that is known', pg_temp.way(pg_temp.near(0, 5, 'odd'), pg_temp.near(300, -5, 'odd'), 'odd') BETWEEN 300 AND 330;
DELETE FROM odd.footway WHERE footway_id = 2;
SELECT 'nobody walks along a motorway', NOT EXISTS (SELECT FROM odd.walk_link JOIN odd.edge USING (edge_id) WHERE axis_id = 4);

-- What hangs alone is told.
SELECT 'a network in one part has nothing to tell', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule ~ 'on foot|joins to the others');
INSERT INTO odd.footway (footway_id, geom, kind) VALUES (1, pg_temp.line('LINESTRING(0 900,30 900,60 900)'), 'footway');
INSERT INTO odd.axis (axis_id, geom, width, importance, sidewalk_left, sidewalk_right, kind) VALUES (5, pg_temp.line('LINESTRING(0 700,100 700)'), 8, 4, 2, 2, 'tertiary');
SELECT 'parts and sides that nothing joins are told', (SELECT array_agg(round(measure) ORDER BY measure) FROM streetgen.check_model('odd') WHERE rule = 'walks that nothing joins to the others, m') = (SELECT '{60}'::float8[] || round(sum(metres)) FROM odd.walk_link JOIN odd.edge USING (edge_id) WHERE axis_id = 5)
  AND (SELECT count(*) = 2 AND bool_and(relation = 'edge' AND measure BETWEEN 95 AND 105) FROM streetgen.check_model('odd') WHERE rule = 'sidewalk that nobody reaches on foot, m');
UPDATE odd.axis SET geom = pg_temp.line('LINESTRING(100 0,100 80)') WHERE axis_id = 5;
SELECT 'joined it is told no more', count(*) = 1 FROM streetgen.check_model('odd') WHERE rule ~ 'on foot|joins to the others';

-- Nothing there, and refusals.
CREATE FUNCTION pg_temp.refused(statement text) RETURNS text LANGUAGE plpgsql AS $$ BEGIN EXECUTE statement; RETURN 'taken'; EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;
SELECT 'an extent of another reference is refused', pg_temp.refused($$SELECT count(*) FROM streetgen.walk_links('town', ST_MakeEnvelope(0, 0, 1, 1, 4326))$$) = '22023';
SELECT 'an empty place has no links', NOT EXISTS (SELECT FROM streetgen.walk_links('town', ST_Envelope(pg_temp.line('LINESTRING(9000 9000,9100 9100)'))));
SELECT 'an incline beyond 100 % is refused', pg_temp.refused('UPDATE town.footway SET incline = 300') = '23514';
SET streetgen_test.subjects = 'asked';
DO $$ BEGIN PERFORM streetgen.create_model('bare', 2154, subjects => '{sidewalk}'); END $$;
SELECT 'without the subject there is no network', to_regclass('bare.walk_link') IS NULL AND pg_temp.refused($$SELECT count(*) FROM streetgen.walk_links('bare')$$) = '55000';
DO $$ BEGIN PERFORM streetgen.switch_subject('bare', 'footway', true); END $$;
SELECT 'with it there is one, empty', (SELECT count(*) = 0 FROM bare.walk_link);
DO $$ BEGIN PERFORM streetgen.switch_subject('bare', 'footway', false); END $$;
SELECT 'and without it again none', to_regclass('bare.walk_link') IS NULL;

-- Attributes of OpenStreetMap.
CREATE TABLE osm_line (way_id bigint, class text, name text, ref text, tags jsonb, nodes integer, geom geometry(LineString, 2154));
INSERT INTO osm_line VALUES (1, 'residential', NULL, NULL, '{"width": "8"}', 2, pg_temp.line('LINESTRING(0 0,200 0)')), (2, 'footway', NULL, NULL, '{"surface": "asphalt", "incline": "-5 %", "wheelchair": "designated", "tactile_paving": "yes", "foot": "official"}', 2, pg_temp.line('LINESTRING(20 8,20 80)')),
  (3, 'steps', NULL, NULL, '{"incline": "up", "access": "private"}', 2, pg_temp.line('LINESTRING(40 8,40 80)')), (4, 'path', NULL, NULL, '{"incline": "10°", "wheelchair": "perhaps", "foot": "no", "tactile_paving": "partial"}', 2, pg_temp.line('LINESTRING(60 8,60 80)')), (5, 'cycleway', NULL, NULL, '{"access": "yes"}', 2, pg_temp.line('LINESTRING(80 8,80 80)'));
DO $$ BEGIN PERFORM streetgen.create_model('mapped', 2154, subjects => '{footway}'); END $$;
CREATE TEMP TABLE told AS SELECT * FROM streetgen.import_osm('mapped', 'osm');
SELECT 'tags of a walk are columns of its footway', array_agg(concat_ws(':', source_ref, surface, round(incline::numeric, 1), climb, wheelchair, tactile_paving, foot) ORDER BY source_ref) = '{"2:asphalt:-5.0:down:yes:yes:designated","3:up:private","4:17.6:up:no","5"}' FROM mapped.footway;
SELECT 'a word that means nothing is told', count(*) = 1 AND bool_and(source_refs = '{4}') FROM told WHERE what LIKE 'wheelchair not understood%';
UPDATE mapped.footway SET surface = 'sett' WHERE source_ref = '2';
UPDATE osm_line SET tags = tags || '{"surface": "concrete", "incline": "3"}' WHERE way_id = 2;
SELECT count(*) FROM streetgen.import_osm('mapped', 'osm') \g /dev/null
SELECT 'what is by hand stays at the next delivery, and what is not follows', surface = 'sett' AND incline = 3 FROM mapped.footway WHERE source_ref = '2';
