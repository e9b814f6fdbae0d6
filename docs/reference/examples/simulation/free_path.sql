-- argument link: key of a row of view link
-- argument metres: along the link, in the direction of its traffic
-- argument horizon: how far ahead, metres
-- argument route: links that are followed where link is one of them
-- see leaders, route
SELECT ordinality, round(starts) AS starts
FROM streetgen.free_path('town', (SELECT min(link_id) FROM town.link WHERE kind = 'lane'), 3, 200);
