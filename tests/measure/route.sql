-- Routes of a model beside a search in plain SQL.
-- psql -v model=NAME -f tests/measure/route.sql asks for 1,000 pairs of lanes; the database has extension pgrouting.
\set ON_ERROR_STOP on
\ir ../sql/shared/quickest.sql
SET client_min_messages = error;
CREATE TEMPORARY TABLE lane_link AS SELECT link_id FROM :"model".link WHERE kind = 'lane' AND traffic IS NULL;
CREATE TEMPORARY TABLE origin AS SELECT link_id FROM lane_link ORDER BY md5(link_id::text) LIMIT 20;
CREATE TEMPORARY TABLE pair AS SELECT o.link_id AS from_link, t.link_id AS to_link FROM origin o,
    LATERAL (SELECT link_id FROM lane_link l ORDER BY md5(concat(o.link_id, '>', l.link_id)) LIMIT 50) t;
CREATE TEMPORARY TABLE known AS SELECT * FROM pg_temp.quickest(:'model', ARRAY(SELECT link_id FROM origin));
CREATE TEMPORARY TABLE asked AS SELECT p.*, r.links, r.seconds FROM pair p,
    LATERAL (SELECT count(*) AS links, max(seconds) AS seconds FROM streetgen.route(:'model', from_link, to_link)) r;
SELECT count(*) AS pairs, count(a.seconds) AS with_a_way, round(avg(links) FILTER (WHERE links > 0)) AS links,
    count(*) FILTER (WHERE (a.seconds IS NULL) <> (k.seconds IS NULL)) AS found_by_one_alone,
    max(abs(a.seconds - k.seconds) / greatest(k.seconds, 1)) AS cost_differs_at_most
FROM asked a LEFT JOIN known k ON (k.origin, k.link) = (from_link, to_link);
