-- argument extent: what to draw, in the reference of the model; NULL: all
-- argument width: width of the picture, pixels
-- argument legend: also draw, beside the map, what colours and lines mean, and a scale
-- see export_layer
SELECT left(streetgen.svg('town', width => 600), 4) AS begins_with;
-- svg
SELECT streetgen.svg('town', ST_MakeEnvelope(650070, 6859950, 650150, 6860020, 2154), 600)
