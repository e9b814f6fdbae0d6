-- argument road_id: road of the model
-- argument metres: how far along the road
-- see arc_road_point, switch_subject
SELECT streetgen.create_model('valley', srid => 2154, subjects => '{alignment}');
INSERT INTO valley.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650060 6860000, 650100 6860030)', 6),
    ('SRID=2154;LINESTRING(650200 6860070, 650140 6860070, 650100 6860030)', 6);
SELECT metres, ST_AsText(geom, 1) AS place, edge_id, round(heading::numeric, 1) AS heading, round(curvature::numeric, 3) AS curvature
    FROM unnest(ARRAY[0, 60, 120]) metres, streetgen.road_at('valley', 1, metres);
