-- argument mapping: class to a column (a string) or to `{"value": class}`; geom to a column; width: breadth of zones that are lines, metres
-- see import_terrain, design
SELECT streetgen.create_model('valley', srid => 2154, dimension => 3);
SELECT streetgen.create_design('valley');
CREATE TABLE river AS SELECT 'SRID=2154;LINESTRING(654000 6860000, 654200 6869000)'::geometry AS geom;
SELECT streetgen.import_zones('valley', 'river', '{"class": {"value": "water"}, "width": 12}') AS zones;
