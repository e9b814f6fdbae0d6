-- argument links: keys of movements in view link; NULL: all
-- see link_at
SELECT precedence, count(*) FROM streetgen.link_conflicts('town') GROUP BY precedence ORDER BY precedence;
