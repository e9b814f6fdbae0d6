-- argument stages: stages to compute: links, paths, horizontal, vertical, structures, axes; NULL: all
-- argument links: keys of links to compute; NULL: all
-- see create_design, design_nodes, path_cost, generate
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
INSERT INTO valley.design_node (name, kind, importance, geom) VALUES ('Upton', 'city', 40000, 'SRID=2154;POINT(652000 6863000)'),
    ('Nether', 'city', 20000, 'SRID=2154;POINT(657000 6866000)');
SELECT * FROM streetgen.design('valley');
SELECT network, method, round((ST_Length(geom) / 1000)::numeric, 1) AS km FROM valley.design_link;
SELECT count(*) AS axes FROM valley.axis WHERE source = 'design';
