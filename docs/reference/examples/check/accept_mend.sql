-- argument ids: ids of view axis_to_mend
-- see check_model
INSERT INTO town.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650050 6860002, 650050 6860060)', 6);
SELECT proposal, round(measure::numeric, 1) AS metres, streetgen.accept_mend('town', ARRAY[id]) AS mended FROM town.axis_to_mend;
