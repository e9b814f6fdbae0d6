-- argument axis: key of the axis
-- argument metres: how far along the axis
-- argument theme: how it is drawn, as of `svg`
-- argument scale: drawn as for 1:scale, where a pixel is 0.28 mm
-- see cross_section, svg
SELECT streetgen.create_model('avenue', srid => 2154, subjects => '{lane,sidewalk}');
INSERT INTO avenue.axis (geom, width, lanes_forward, lanes_backward, kind_forward, sidewalk_left, sidewalk_right, name) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 14, 2, 1, 'general|bus', 3, 2, 'avenue');
SELECT length(streetgen.cross_section_svg('avenue', 1, 50)) > 1000 AS drawn;
