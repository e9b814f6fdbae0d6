-- argument on_circle: share of the ring within a tenth of the radius of its circle
-- argument fill: area by that of the smallest circle about it
-- see roundabout_network, roundabout_name, roundabout_score
SELECT streetgen.roundabout_shape(1, 0.95) AS circle, round(streetgen.roundabout_shape(0.5, 0.637)::numeric, 2) AS square;
