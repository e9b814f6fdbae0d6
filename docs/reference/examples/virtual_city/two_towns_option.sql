-- see create_two_towns, city_option
SELECT name, value, unit, minimum, maximum FROM streetgen.two_towns_option() WHERE name ~ 'highway|ramp';
