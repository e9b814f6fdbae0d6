-- OSM lines as osm2pgsql writes them, to axes.  Each SELECT is one truth: (name, holds).
SET client_min_messages = warning;
DO $$ BEGIN
  PERFORM streetgen.create_model('import_osm', 32631);
END $$;
CREATE TABLE import_line (way_id bigint, class text NOT NULL, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text,
  junction text, layer text, bridge text, tunnel text, maxspeed text, area text, geom geometry(LineString, 32631));
INSERT INTO import_line (way_id, class, lanes, lanes_forward, lanes_backward, width, oneway, junction, layer, bridge, tunnel, maxspeed, geom)
SELECT v.*, ST_SetSRID(ST_MakeLine(ST_MakePoint(0, 100 * way_id), ST_MakePoint(100, 100 * way_id)), 32631) FROM (VALUES
  (1::bigint, 'residential', '2', NULL, NULL, '7 m', 'yes', NULL, NULL, NULL, NULL, '30 mph'),
  (2, 'residential', NULL, '2', '1', '23 ft', '-1', NULL, '2', 'yes', NULL, 'FR:urban'),
  (3, 'tertiary', 'many', NULL, NULL, 'wide', NULL, 'roundabout', NULL, NULL, NULL, 'signals'),
  (4, 'primary_link', NULL, NULL, NULL, '0', NULL, NULL, NULL, 'viaduct', NULL, '50'),
  (5, 'secondary', NULL, NULL, NULL, NULL, 'no', NULL, NULL, NULL, 'yes', NULL),
  (6, 'runway', '1', NULL, NULL, '60', NULL, NULL, NULL, NULL, NULL, NULL),
  (7, 'cycleway', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
  (8, 'motorway', '2', NULL, NULL, '30', NULL, NULL, NULL, 'no', NULL, NULL)) AS v (way_id);
CREATE TABLE import_report AS SELECT * FROM streetgen.import_osm('import_osm', 'import');

SELECT 'metres and feet are widths' AS name,
       (SELECT width = 7 FROM import_osm.axis WHERE source_ref = '1') AND (SELECT abs(width - 7.0104) < 1e-9 FROM import_osm.axis WHERE source_ref = '2') AS holds;
SELECT 'miles per hour and urban limits are speeds',
       (SELECT abs(speed - 48.28032) < 1e-9 FROM import_osm.axis WHERE source_ref = '1') AND (SELECT speed = 50 FROM import_osm.axis WHERE source_ref = '2');
SELECT 'what is no number is unknown', (SELECT width IS NULL AND lane_count IS NULL AND speed IS NULL FROM import_osm.axis WHERE source_ref = '3');
SELECT 'lanes forward and backward add up', (SELECT lane_count = 3 FROM import_osm.axis WHERE source_ref = '2');
SELECT 'oneway gives the direction, roundabouts and motorways are direct',
       (SELECT string_agg(direction, ',' ORDER BY source_ref) = 'direct,reverse,direct,both,both,both,direct' FROM import_osm.axis);
SELECT 'layer is the level; without it bridges are above and tunnels below',
       (SELECT string_agg(level::text, ',' ORDER BY source_ref) = '0,2,0,1,-1,0,0' FROM import_osm.axis);
SELECT 'a width of zero is unknown and named', (SELECT source_refs = '{4}' FROM import_report WHERE what LIKE 'width of zero%');
SELECT 'a width beyond the lanes is named, a runway''s is believed', (SELECT source_refs = '{8}' FROM import_report WHERE what = 'width not believed');
SELECT 'a cycleway is not taken', (SELECT count = 1 FROM import_report WHERE what LIKE 'not taken%' AND class = 'cycleway');
SELECT 'the taken ways are axes', (SELECT count(*) = 7 FROM import_osm.axis);
DROP TABLE import_line, import_report;
DO $$ BEGIN
  PERFORM streetgen.drop_model('import_osm');
END $$;
