-- argument controller: key of the controller
-- see signal_plan
SELECT streetgen.create_model('lit', srid => 2154, subjects => '{signal}', driving_side => 'right');
INSERT INTO lit.axis (geom, width, lane_count, speed) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 2, 50),
    ('SRID=2154;LINESTRING(650100 6860000, 650200 6860000)', 7, 2, 50), ('SRID=2154;LINESTRING(650100 6859900, 650100 6860000)', 7, 2, 50);
INSERT INTO lit.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 'signals');
SELECT length(streetgen.signal_svg('lit', controller_id)) > 1000 AS drawn FROM lit.controller;
