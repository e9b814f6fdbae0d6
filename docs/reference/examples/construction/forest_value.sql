-- argument forest: the forest as numbers, as above
-- argument features: as many numbers as the forest has features
-- see train_radius
SELECT streetgen.forest_value('{2,1,3,0,4,1,2,-1,5,0,0,-1,6,0,0}', '{3.5,50}') AS narrow, streetgen.forest_value('{2,1,3,0,4,1,2,-1,5,0,0,-1,6,0,0}', '{7,50}') AS wide;
