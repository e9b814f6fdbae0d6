-- argument link: key of a row of view link
-- argument metres: along the link, in the direction of its traffic
-- argument horizon: how far ahead, metres
-- see leaders
SELECT ordinality, round(starts) AS starts FROM streetgen.free_path('town', (SELECT min(link_id) FROM town.link WHERE kind = 'lane'), 3, 200);
