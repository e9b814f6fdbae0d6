-- argument extent: what is shown; NULL: the terrain
-- argument columns: square cells along the longer side, 1 to 2000
-- see design_svg, terrain_height
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE raster AS SELECT '\x0100000100000000000088b340000000000088b3c00000000020d6234100000000fc345a41000000000000000000000000000000006a080000020002004500806a019c0152018401'::bytea AS heights;
SELECT streetgen.import_terrain('valley', 'raster') AS tiles;
SELECT grey, ST_AsText(ST_Envelope(geom)) AS cell FROM streetgen.hill_shade('valley', 'SRID=2154;POLYGON((652500 6862500, 657500 6862500, 657500 6867500, 652500 6867500, 652500 6862500))', 1);
-- svg
SELECT format('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 200">%s</svg>', string_agg(format('<rect x="%s" y="%s" width="10.2" height="10.2" fill="rgb(%s,%3$s,%3$s)"/>',
    10 * i, 10 * j, 170 + 5 * round(greatest(-12, least(15, 8 + 60 * (sin((i + j + 1) / 6.0) * cos((i - j) / 9.0) - sin((i + j) / 6.0) * cos((i - j) / 9.0)))))), '' ORDER BY j, i))
FROM generate_series(0, 39) i, generate_series(0, 19) j
