-- see virtual_city
SELECT name, value, unit, minimum, maximum FROM streetgen.city_option() WHERE unit = 'km/h';
