-- Cars of which get_leader gives another leader than leaders does: none is right.
-- psql -v model=marais -f tests/measure/one_leader.sql, of a model with cars.
CREATE TEMP TABLE whole AS SELECT * FROM streetgen.leaders(:'model');
SELECT count(*) AS cars, count(*) FILTER (WHERE (w.leader, w.virtual) IS DISTINCT FROM (g.leader, g.virtual)
    OR abs(w.distance - g.distance) > 1e-6) AS otherwise
FROM whole w, LATERAL streetgen.get_leader(:'model', w.car_id) g;
