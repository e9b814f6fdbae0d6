-- see observe, match_axes, forest_value
SELECT streetgen.create_model('grid', 2154, subjects => '{kerb,fit}');
SELECT streetgen.set('grid', 'crossing', 'split');
INSERT INTO grid.axis (geom, width, importance, radius)
    SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 60 * n, 6860000), ST_MakePoint(650000 + 60 * n, 6860200)), 2154), 7, 5, 4 FROM generate_series(1, 4) n
    UNION ALL SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650020, 6860050 + 90 * n), ST_MakePoint(650280, 6860050 + 90 * n)), 2154), 9, 3, 4 FROM generate_series(0, 1) n;
SELECT count(*) FROM streetgen.generate('grid');
CREATE TABLE kerb_line AS SELECT geom FROM grid.kerb;
SELECT count(*) FROM streetgen.observe('grid', 'kerb_line', '{}');
SELECT function, corners, round(mean_error::numeric, 2) AS mean_error FROM streetgen.train_radius('grid');
SELECT round(grid.trained_radius(9, 50, 3, 2, NULL)::numeric, 2);
