-- argument prefix: prefix of the tables that osm2pgsql wrote
-- argument schemas: schemas in which the tables are looked for
-- see import_axes, import_bdtopo
-- osm2pgsql -O flex -S data/osm2pgsql_flex.lua writes such a table.
CREATE TABLE city_line (way_id bigint, class text, name text, lanes text, lanes_forward text, lanes_backward text, width text, oneway text,
    junction text, layer text, bridge text, tunnel text, maxspeed text, area text, geom geometry(LineString, 2154));
INSERT INTO city_line (way_id, class, lanes, width, oneway, maxspeed, geom)
    VALUES (17, 'residential', '2', '23 ft', 'yes', '30 mph', 'SRID=2154;LINESTRING(650000 6860000, 650000 6860090)');
SELECT what, class, count FROM streetgen.import_osm('town', 'city');
SELECT round(width::numeric, 2) AS width, lane_count, direction, round(speed) AS speed, kind FROM town.axis WHERE source_ref = '17';
