-- argument at_x: abscissa of the place, metres
-- argument at_y: ordinate of the place, metres
-- argument width: width of the extent, metres
-- argument height: height of the extent, metres
-- see virtual_city
SELECT round(streetgen.city_density(5000, 5000, 0, 0, 10000, 10000)::numeric, 3) AS centre, round(streetgen.city_density(0, 0, 0, 0, 10000, 10000)::numeric, 3) AS corner;
