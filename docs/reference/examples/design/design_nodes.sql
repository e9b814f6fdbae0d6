-- argument area: POLYGON in which towns are drawn
-- argument count: how many, 1 to 1000
-- argument seed: another number, other towns
-- argument options: cities, towns, largest, exponent, spacing and steepest, where they differ from their defaults
-- see design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
SELECT streetgen.design_nodes('valley', 'SRID=2154;POLYGON((651000 6861000, 659000 6861000, 659000 6869000, 651000 6869000, 651000 6861000))', 6, 1) AS nodes;
SELECT kind, importance FROM valley.design_node ORDER BY importance DESC;
