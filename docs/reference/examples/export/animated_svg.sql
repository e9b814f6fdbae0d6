-- argument run: its name
-- argument extent: what to draw, in the reference of the model; NULL: all
-- argument width: width of the picture, pixels
-- argument theme: how it is drawn, as `svg` has it
-- argument scale: as `svg` has it
-- argument pace: seconds of the run in a second of the picture
-- see svg, keep_simulation
SELECT streetgen.create_model('moving', 2154, driving_side => 'right'), streetgen.create_traffic('moving');
INSERT INTO moving.axis (geom, width, lane_count) VALUES
    ('SRID=2154;LINESTRING(650000 6860000, 650200 6860000)', 7, 2),
    ('SRID=2154;LINESTRING(650200 6860000, 650400 6860000)', 7, 2);
SELECT streetgen.keep_simulation('moving', 'morning', 'idm', 20, 0.2, '{"flow": 600}') > 0 AS rows;
SELECT streetgen.animated_svg('moving', 'morning', pace => 5) LIKE '%<animateTransform%' AS moves;
