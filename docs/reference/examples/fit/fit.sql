-- argument axes: axes that may change; NULL: all
-- argument options: `moves`: `roadway`, `axis` or `corner`
-- see accept_fit, observe
SELECT streetgen.create_model('surveyed', 2154, subjects => '{fit}');
INSERT INTO surveyed.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 6);
INSERT INTO surveyed.observation (geom) VALUES ('SRID=2154;LINESTRING(650000 6860004, 650100 6860004)'), ('SRID=2154;LINESTRING(650000 6859996, 650100 6859996)');
SELECT fit_run, axes, used, round(mean_before::numeric, 2) AS mean_before, round(mean_after::numeric, 2) AS mean_after FROM streetgen.fit('surveyed');
