-- argument extent: what to draw, in the reference of the model; NULL: all
-- argument width: width of the picture, pixels
-- argument legend: also draw, beside the map, what colours and lines mean, and a scale
-- argument theme: how it is drawn, one of `symbol_rule.theme`: `street`, `dark`, `print` or `construction`
-- argument scale: drawn as on a sheet of 1:scale, a pixel for 0.28 mm; NULL: as extent and width say
-- argument run: a kept run of a simulation, which is drawn; NULL: the cars of table `car`
-- argument at: seconds of the run
-- see sheet, export_layer, animated_svg
SELECT left(streetgen.svg('town', width => 600), 4) AS begins_with;
-- svg
SELECT streetgen.svg('town', ST_MakeEnvelope(650070, 6859950, 650150, 6860020, 2154), 600)
