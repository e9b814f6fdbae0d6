-- argument on_circle: share of the ring within a tenth of the radius of its circle
-- argument compactness: area by that of the circle of the same length
-- see roundabout_network, roundabout_name, roundabout_score
SELECT streetgen.roundabout_shape(1, 0.99) AS circle, round(streetgen.roundabout_shape(0.5, 0.785)::numeric, 2) AS square;
