-- argument width: width of the extent, metres
-- argument height: height of the extent, metres
-- see virtual_city, generate
SELECT streetgen.create_virtual_city('invented', 2177, 6560000, 5570000, 1500, 1000, 7) > 0 AS has_axes;
SELECT name, srid FROM streetgen.model ORDER BY name;
