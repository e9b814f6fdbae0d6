\set ECHO none
\ir shared/truths.sql
-- Importers: what they take, follow and refuse. Rows (name, holds).
SELECT streetgen.create_model('town', 32631) \g /dev/null
CREATE TABLE source (id integer, the_geom geometry, largeur float8, nature text);
INSERT INTO source VALUES (1, 'SRID=32631;LINESTRING(0 0,50 0,100 0)', 7, 'residential'), (2, 'SRID=32631;LINESTRING(50 0,50 80)', 0, 'residential'),
    (3, 'SRID=32631;MULTILINESTRING((100 0,200 0),(300 0,400 0))', 6, 'primary'), (4, 'SRID=32631;LINESTRING(0 9,50 9)', 2, 'footway'), (5, 'SRID=32631;LINESTRING(0 0,0 10,0.1 10,0 60)', 6, 'service');
CREATE TEMPORARY TABLE told AS SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "width": "largeur", "kind": "nature", "source_ref": "id", "level": {"value": 0}}');
SELECT 'taken classes come in, parts apart', count(*) = 5 FROM town.axis;
SELECT 'a class that is walked makes a footway', count = 1 AND (SELECT (kind, width, source_ref) = ('footway', 2, '4') FROM town.footway) FROM told WHERE what = 'taken as footway' AND class = 'footway';
SELECT 'a zero width is unknown, and told by source id', source_refs = '{2}' FROM told WHERE what LIKE 'width of zero%';
SELECT 'a zero width becomes NULL', width IS NULL FROM town.axis WHERE source_ref = '2';
SELECT 'a vertex that another axis shares stays', ST_NPoints(geom) = 3 FROM town.axis WHERE source_ref = '1';
SELECT 'cleaning drops near points and keeps the original', ST_NPoints(geom) < 4 AND ST_NPoints(source_geom) = 4 FROM town.axis WHERE source_ref = '5';
UPDATE source SET largeur = 9 WHERE id = 1;
DELETE FROM source WHERE id = 2;
CREATE TEMPORARY TABLE kept AS SELECT axis_id FROM town.axis WHERE source_ref = '1';
CREATE TEMPORARY TABLE again AS SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "width": "largeur", "kind": "nature", "source_ref": "id"}');
SELECT 'importing again follows: changed under the same id', width = 9 AND axis_id = (SELECT axis_id FROM kept) FROM town.axis WHERE source_ref = '1';
SELECT 'importing again follows: vanished', NOT EXISTS (SELECT FROM town.axis WHERE source_ref = '2');
SELECT 'importing again touches only what changed', count = 1 FROM again WHERE what = 'new or changed';
SELECT 'a missing column is 42703', test.state($$SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "width": "breite"}')$$) = '42703';
SELECT 'SQL in a mapping is only a name', test.state($$SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "name": "(SELECT 1); DROP TABLE source; --"}')$$) = '42703';
SELECT 'an unknown target is 22023', test.state($$SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "colour": "nature"}')$$) = '22023';
SELECT 'bad rows are 22023 and change nothing: ' || what, test.state(format($$WITH bad AS (INSERT INTO source VALUES (9, %s, %s, 'service') RETURNING 1) SELECT * FROM bad$$, geom, width)) = 'none'
    AND test.state($$SELECT * FROM streetgen.import_axes('town', 'source', '{"geom": "the_geom", "width": "largeur", "kind": "nature", "source_ref": "id"}')$$) = '22023'
    AND test.state('DELETE FROM source WHERE id = 9') = 'none' AND (SELECT count(*) = 4 FROM town.axis)
    FROM (VALUES ('no SRID', $$'LINESTRING(0 0,9 9)'$$, '5'),
        ('a NaN vertex', $$ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(0, 0), ST_MakePoint('NaN', 0), ST_MakePoint(5, 5)]), 32631)$$, '5')) s(what, geom, width);

CREATE TABLE osm_line (way_id bigint, class text, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text, junction text, layer text, bridge text, tunnel text, maxspeed text, geom geometry);
INSERT INTO osm_line (way_id, class, geom, oneway, maxspeed, width, lanes, lanes_forward, lanes_backward, junction, layer, bridge) VALUES
    (11, 'residential', 'SRID=32631;LINESTRING(0 0,100 0)', '-1', '30 mph', '23 ft', NULL, '2', '1', NULL, NULL, NULL), (12, 'primary', 'SRID=32631;LINESTRING(0 50,100 50)', NULL, 'FR:urban', '7,5', '3', NULL, NULL, NULL, '2', 'yes'),
    (13, 'tertiary', 'SRID=32631;LINESTRING(0 90,50 90,50 120,0 90)', NULL, NULL, NULL, NULL, NULL, NULL, 'roundabout', NULL, 'viaduct'), (14, 'steps', 'SRID=32631;LINESTRING(0 70,100 70)', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL),
    (15, 'runway', 'SRID=32631;LINESTRING(0 -500,900 -500)', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL);
SELECT streetgen.create_model('osm', 32631) \g /dev/null
SELECT 'import_osm imports', count(*) > 0 FROM streetgen.import_osm('osm');
SELECT 'OSM: oneway -1, mph, feet, lanes by direction', direction = 'reverse' AND abs(speed - 48.28) < 0.01 AND abs(width - 7.0104) < 1e-6 AND lane_count = 3 FROM osm.axis WHERE source_ref = '11';
SELECT 'OSM: layer before bridge, a width with a comma', level = 2 AND width = 7.5 AND speed = 50 FROM osm.axis WHERE source_ref = '12';
SELECT 'OSM: a roundabout is one-way, a bridge without a layer is above', u.direction = 'direct' AND u.level = 1 FROM osm.axis_used u JOIN osm.axis USING (axis_id) WHERE source_ref = '13';
SELECT 'OSM: steps are not taken', NOT EXISTS (SELECT FROM osm.axis WHERE source_ref = '14');
SELECT count(*) FROM streetgen.generate('osm') \g /dev/null
SELECT 'OSM: a runway is 40 m wide by its class', osm.edge.width = 40 FROM osm.edge JOIN osm.axis USING (axis_id) WHERE source_ref = '15';

CREATE TABLE troncon (cleabs text, geom geometry, nature text, largeur_de_chaussee float8, nombre_de_voies integer, sens_de_circulation text, importance text, position_par_rapport_au_sol text);
INSERT INTO troncon VALUES ('T1', 'SRID=32631;LINESTRING Z(0 0 10,100 0 11)', 'Route à 1 chaussée', 5, 2, 'Sens inverse', '4', '-1');
SELECT streetgen.create_model('ign', 32631, 3) \g /dev/null
SELECT 'import_bdtopo imports', count(*) > 0 FROM streetgen.import_bdtopo('ign', 'troncon');
SELECT 'BD TOPO V3: width, lanes, direction, importance, level, heights', width = 5 AND lane_count = 2 AND direction = 'reverse' AND importance = 4 AND level = -1 AND ST_Z(ST_EndPoint(geom)) = 11 FROM ign.axis;
SELECT 'a table that is no BD TOPO is 22023', test.state($$SELECT * FROM streetgen.import_bdtopo('ign', 'osm_line')$$) = '22023';
