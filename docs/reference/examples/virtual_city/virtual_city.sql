-- argument width: width of the extent, metres
-- argument height: height of the extent, metres
-- see create_virtual_city, city_option, city_density
SELECT width, lane_count, importance, name, direction, speed FROM streetgen.virtual_city(2177, 6560000, 5570000, 1500, 1000, 7) LIMIT 3;
-- drawing
SELECT geom, CASE importance WHEN 1 THEN 'result' ELSE 'kerb' END, NULL FROM streetgen.virtual_city(2177, 6560000, 5570000, 6000, 4000, 7)
