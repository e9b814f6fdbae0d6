-- argument population_a: importance of one town
-- argument population_b: importance of the other town
-- argument length: length of the road
-- argument alternative: length of the shortest way without the road; NULL: there is none
-- argument operating_cost: cost of a unit of length driven
SELECT streetgen.benefit(273.584, 93.587, 47.1, 60) AS detour, streetgen.benefit(273.584, 93.587, 47.1, NULL) AS no_other_way;
