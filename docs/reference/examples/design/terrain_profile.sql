-- argument line: LINESTRING
-- argument step: metres between heights
-- see terrain_height
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
SELECT abscissa, height FROM streetgen.terrain_profile('valley', 'SRID=2154;LINESTRING(652500 6865000, 657500 6865000)', 2500);
-- drawing
SELECT ST_Point(20 * k, 10 * sin(k / 2.0)), 'point', NULL FROM generate_series(0, 8) k
UNION ALL SELECT ST_MakeLine(ST_Point(4 * k, 10 * sin(k / 10.0)) ORDER BY k), 'result', NULL FROM generate_series(0, 40) k
