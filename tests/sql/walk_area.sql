\set ECHO none
\ir shared/truths.sql
-- Walks over squares and platforms in the network on foot.  (name, holds)
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.shape(text) RETURNS geometry LANGUAGE sql
  AS $$ SELECT ST_Translate(ST_GeomFromText($1, 2154), 650000, 6860000) $$;
CREATE FUNCTION pg_temp.box(west float8, south float8, east float8, north float8) RETURNS geometry LANGUAGE sql
  AS $$ SELECT ST_Multi(ST_MakeEnvelope(650000 + west, 6860000 + south, 650000 + east, 6860000 + north, 2154)) $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{footway}');
  INSERT INTO town.axis (axis_id, geom, width, importance, kind, sidewalk_left, sidewalk_right)
    VALUES (1, pg_temp.shape('LINESTRING(-100 0,200 0)'), 8, 4, 'residential', 2, 2);
  -- Ways come to three sides of a square, which lies beside the street.
  INSERT INTO town.footway (footway_id, geom, kind) VALUES (1, pg_temp.shape('LINESTRING(-40 40,10 40)'), 'footway'),
    (2, pg_temp.shape('LINESTRING(90 40,150 40)'), 'footway'),
    (3, pg_temp.shape('LINESTRING(40 120,40 69)'), 'footway');
END $$;
CREATE FUNCTION over() RETURNS text LANGUAGE sql
  AS $$ SELECT coalesce(string_agg(round(metres)::text, ' ' ORDER BY metres), '')
    FROM town.walk_link WHERE kind = 'square' $$;
CREATE FUNCTION parts() RETURNS bigint LANGUAGE sql AS $$
  WITH link AS MATERIALIZED (SELECT * FROM town.walk_link ORDER BY walk_link_id)
  SELECT count(DISTINCT part)
    FROM streetgen._walk_parts(ARRAY(SELECT from_node FROM link), ARRAY(SELECT to_node FROM link)) $$;
CREATE FUNCTION as_whole(extent geometry) RETURNS boolean LANGUAGE sql AS $$
  SELECT NOT EXISTS ((SELECT walk_link_id, kind, from_node, to_node FROM streetgen.walk_links('town', extent)
      EXCEPT SELECT walk_link_id, kind, from_node, to_node FROM town.walk_link)
    UNION ALL (SELECT walk_link_id, kind, from_node, to_node FROM town.walk_link WHERE geom && extent
      EXCEPT SELECT walk_link_id, kind, from_node, to_node FROM streetgen.walk_links('town', extent))) $$;
SELECT 'three ways end anywhere', parts() = 4 AND over() = '';
INSERT INTO town.street_area (street_area_id, geom, kind, surface)
  VALUES (1, pg_temp.box(10, 3, 90, 70), 'square', 'sett');
-- From the west to the north 42 m, from there to the east 58, and to the sidewalk 52, 52 and 64 m. From the west to the
-- east one of 80 m would save less than a fifth.
SELECT 'over a square one walks from each to each and to the sidewalk along it'
   , parts() = 1 AND over() = '1 42 52 52 58 64';
SELECT 'on its surface', bool_and(surface = 'sett' AND level = 0 AND width IS NULL)
    FROM town.walk_link WHERE kind = 'square';
SELECT 'ids are of shapes, and an extent has the same as the whole', count(*) = count(DISTINCT walk_link_id)
    AND as_whole(pg_temp.box(0, 30, 30, 50)) AND as_whole(pg_temp.box(60, 20, 70, 60))
    AND as_whole(pg_temp.box(-60, -5, -50, 5))
  FROM town.walk_link;
-- A way leads from the sidewalk into the square.
INSERT INTO town.footway (footway_id, geom, kind) VALUES (4, pg_temp.shape('LINESTRING(50 5,50 20)'), 'footway');
SELECT 'a way into it is a place of it', over() LIKE '% 45 45 %' AND parts() = 1;
INSERT INTO town.footway (footway_id, geom, kind) VALUES (5, pg_temp.shape('LINESTRING(10 40,50 41,90 40)'), 'footway');
SELECT 'no walk leads beside one that is mapped', over() NOT LIKE '%80%' AND parts() = 1;
DELETE FROM town.footway WHERE footway_id IN (4, 5);
-- A pond lies between west and east.
UPDATE town.street_area SET geom = ST_Multi(ST_Difference(geom, pg_temp.box(40, 20, 60, 45)));
SELECT 'walks lead about holes', over() = '1 42 52 52 58 66';
SELECT 'and not over them', bool_and(NOT ST_Intersects(geom, pg_temp.box(41, 21, 59, 44)))
    FROM town.walk_link WHERE kind = 'square';
UPDATE town.street_area SET foot = 'no';
SELECT 'nobody walks where one may not', over() = '' AND parts() = 4;
UPDATE town.street_area SET foot = NULL, kind = 'parking_area';
SELECT 'nor in a car park', over() = '';
UPDATE town.street_area SET kind = 'platform', level = 1;
SELECT 'nor on another level', over() = '';
UPDATE town.street_area SET level = 0;
SELECT 'on a platform one does', over() = '1 42 52 52 58 66';
INSERT INTO town.axis (axis_id, geom, width, importance, kind, sidewalk_left, sidewalk_right)
  VALUES (2, pg_temp.shape('LINESTRING(75 100,75 3)'), 6, 5, 'residential', 0, 0);
SELECT 'a roadway parts it', bool_and(NOT ST_Intersects(geom, pg_temp.shape('LINESTRING(75 65,75 20)')))
    AND count(*) > 0
  FROM town.walk_link WHERE kind = 'square';
DELETE FROM town.axis WHERE axis_id = 2;
UPDATE town.street_area SET geom = ST_Multi(pg_temp.shape('POLYGON((10 3,90 70,90 3,10 70,10 3))'));
SELECT 'one that crosses itself has two parts', over() = '';
SELECT 'files of OpenSidewalks have them as footways', count(*) > 0
    FROM streetgen._opensidewalks_edges('town', '{}') WHERE edge ->> 'highway' = 'footway';
