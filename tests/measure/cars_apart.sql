-- Cars of a simulation that come too near each other: psql -v model=NAME -v flow=100 -f tests/measure/cars_apart.sql prints how many pairs of a movement and another link
-- have bodies (4.5 m behind the front, along the way that the car came) nearer than a metre, in 300 s of 600, and the worst ones. Two that start from one lane side by side may be among them.
\set ON_ERROR_STOP on
SET client_min_messages = error;
CREATE TEMPORARY TABLE driven AS SELECT * FROM streetgen.simulate(:'model', 'idm', 600, 0.1, jsonb_build_object('flow', :flow), options => '{"output": 2}');
CREATE INDEX ON driven (car_id, t);
CREATE TEMPORARY TABLE body AS
SELECT a.t, a.car_id, a.link, ST_MakeLine(a.geom, ST_Translate(a.geom, (ST_X(b.geom) - ST_X(a.geom)) * 4.5 / d, (ST_Y(b.geom) - ST_Y(a.geom)) * 4.5 / d)) AS geom
FROM driven a CROSS JOIN LATERAL (SELECT b.geom, ST_Distance(a.geom, b.geom) AS d FROM driven b WHERE b.car_id = a.car_id AND b.t < a.t AND ST_Distance(a.geom, b.geom) > 1.5 ORDER BY b.t DESC LIMIT 1) b
WHERE a.t > 300;
CREATE INDEX ON body USING gist (geom);
CREATE TEMPORARY TABLE pair AS
SELECT a.t, least(a.link, b.link) AS link, greatest(a.link, b.link) AS other, ST_Distance(a.geom, b.geom) AS apart
FROM body a JOIN body b ON a.t = b.t AND a.car_id < b.car_id AND a.link <> b.link AND ST_DWithin(a.geom, b.geom, 1)
    JOIN :"model".link k ON k.link_id = a.link JOIN :"model".link o ON o.link_id = b.link WHERE 'movement' IN (k.kind, o.kind);
SELECT (SELECT count(*) FROM body) AS bodies, count(*) AS near, count(DISTINCT (link, other)) AS places FROM pair;
SELECT link, other, count(*), round(min(apart)::numeric, 2) AS apart FROM pair GROUP BY link, other ORDER BY count(*) DESC, link LIMIT 10;
