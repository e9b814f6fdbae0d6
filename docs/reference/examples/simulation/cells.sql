-- argument size: metres
-- see simulate
SELECT streetgen.create_model('cut', 2154, driving_side => 'right');
INSERT INTO cut.axis (geom, width, lane_count) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650100 6860000)', 7, 2);
SELECT cell_id, ordinality, round(starts) AS starts, round(ends) AS ends, next, opposite_left
FROM streetgen.cells('cut', 25) ORDER BY cell_id LIMIT 4;
