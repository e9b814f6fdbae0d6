-- argument names: of the edges, NULL where one has none
-- argument patterns: regular expressions, as in table roundabout_pattern
-- argument folding: plain, unaccent or fuzzy
-- see roundabout_shape, roundabout_network, roundabout_score
SELECT streetgen.roundabout_name('{Market Circus,Market Circus,High Street}', '{circus}');
