-- argument line: LINESTRING; with heights it is built at them
-- argument network: highway, secondary or rural
-- see design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
SELECT term, round(cost) AS cost FROM streetgen.path_cost('valley', 'SRID=2154;LINESTRING(652000 6863000, 657000 6866000)', 'rural');
