-- argument axis: key of the axis
-- argument metres: how far along the axis
-- see lane_beside, switch_subject
SELECT streetgen.create_model('avenue', srid => 2154, subjects => '{lane,sidewalk}');
INSERT INTO avenue.axis (geom, width, lanes_forward, lanes_backward, kind_forward, sidewalk_left, sidewalk_right) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 14, 2, 1, 'general|bus', 3, 2);
SELECT side, "order", kind, offset_from, offset_to, kerb FROM streetgen.cross_section('avenue', 1, 50);
