-- argument axes: axes to cut; NULL: all
-- see accept_fit, make_roundabout
SELECT streetgen.create_model('blocks', 2154);
INSERT INTO blocks.axis (geom, width, name) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000, 650200 6860000)', 7, 'High Street'), ('SRID=2154;LINESTRING(650100 6860000, 650100 6860080)', 6, 'Mill Lane');
SELECT streetgen.cut_at_junctions('blocks') AS cut;
SELECT name, ST_Length(geom) AS length FROM blocks.axis ORDER BY axis_id;
