-- argument shape: term of the shape, 0 to 1
-- argument name: term of the names, 0 to 1
-- argument network: term of the network, 0 to 1
-- argument weights: of the three, in this order
-- see roundabout_shape, roundabout_network, roundabout_name
SELECT round(streetgen.roundabout_score(1, 0.5, 0.6, '{0.5,0.1,0.4}')::numeric, 2) AS score;
