-- argument link: key of the link
-- argument width: pixels
-- see design_svg, design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
INSERT INTO valley.design_node (name, kind, importance, geom) VALUES ('Upton', 'city', 40000, 'SRID=2154;POINT(652000 6863000)'),
    ('Nether', 'city', 20000, 'SRID=2154;POINT(657000 6866000)');
SELECT count(*) AS stages FROM streetgen.design('valley');
SELECT length(streetgen.profile_svg('valley', 1)) > 0 AS drawn;
