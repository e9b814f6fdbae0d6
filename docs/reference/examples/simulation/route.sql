-- argument from_link: key of a row of view link
-- argument to_link: key of a row of view link
-- argument kind: who drives: car, bus, carpool or cycle
-- see free_path, leaders
CREATE EXTENSION IF NOT EXISTS pgrouting;
SELECT ordinality, round(seconds) AS seconds
FROM streetgen.route('town', (SELECT min(comes_from) FROM town.link), (SELECT max(leads_to) FROM town.link
    WHERE comes_from = (SELECT min(comes_from) FROM town.link)));
