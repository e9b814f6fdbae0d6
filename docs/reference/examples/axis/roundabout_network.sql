-- argument one_way: share of the ring whose traffic goes round
-- argument against: share whose traffic goes the other way
-- argument arm_nodes: nodes with arms
-- argument single_arm: share of these that have one arm
-- argument inside: edges that hang into the face, and islands in it
-- see roundabout_shape, roundabout_name, roundabout_score
SELECT streetgen.roundabout_network(1, 0, 6, 1, 0) AS roundabout, streetgen.roundabout_network(0, 0, 1, 1, 0) AS turning_circle;
