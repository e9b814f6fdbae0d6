-- argument stage: the last stage that is drawn
-- argument extent: what is shown; NULL: the terrain
-- argument width: pixels, 100 to 4000
-- see profile_svg, svg, design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
SELECT length(streetgen.design_svg('valley', 'terrain')) > 0 AS drawn;
