-- argument fit_run: the run, as [fit](#fit) tells
-- argument axes: these axes alone; NULL
-- see undo_fit, reject_fit
SELECT streetgen.create_model('surveyed', 2154, subjects => '{fit}');
INSERT INTO surveyed.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 6);
INSERT INTO surveyed.observation (geom) VALUES ('SRID=2154;LINESTRING(650000 6860004, 650100 6860004)'), ('SRID=2154;LINESTRING(650000 6859996, 650100 6859996)');
SELECT axes FROM streetgen.fit('surveyed');
SELECT streetgen.accept_fit('surveyed', 1);
