-- argument accept: write what is proposed
-- see estimated_width, match_axes
SELECT streetgen.create_model('learnt', 2154);
INSERT INTO learnt.axis (geom, kind, width)
SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 50 * n, 6860000), ST_MakePoint(650000 + 50 * n, 6860040)), 2154), 'residential', 7 + n % 3
FROM generate_series(1, 12) n;
SELECT * FROM streetgen.learn_classes('learnt');
