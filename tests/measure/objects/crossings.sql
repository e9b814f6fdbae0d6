-- Crossings by one rule against mapped ones on axes, and those that netconvert guesses: psql -v model=MODEL -v guess=TABLE -v within=METRES
CREATE TEMPORARY TABLE mapped AS SELECT geom FROM :"model".control_point WHERE kind = 'pedestrian_crossing' AND axis_distance <= :within;
CREATE INDEX ON mapped USING gist (geom);
CREATE TEMPORARY TABLE found (place integer, rule text, geom geometry);
DELETE FROM :"model".placement_rule;
INSERT INTO :"model".placement_rule (type, along, side, distance_from_limit)
    VALUES ('crossing', 'arm', 'alternating', 1);
INSERT INTO found SELECT 1, 'each arm of three, 1 m from the limit', geom FROM :"model".street_object WHERE type = 'crossing';
UPDATE :"model".placement_rule SET distance_from_limit = 2.5;
INSERT INTO found SELECT 2, 'each arm of three, 2.5 m from the limit', geom FROM :"model".street_object WHERE type = 'crossing';
UPDATE :"model".placement_rule SET distance_from_limit = 1, kind = ARRAY(SELECT DISTINCT kind FROM :"model".axis);
INSERT INTO found SELECT 3, 'the same of all classes, 1 m', geom FROM :"model".street_object WHERE type = 'crossing';
UPDATE :"model".placement_rule SET kind = NULL;
INSERT INTO found SELECT 4, 'netconvert''s guess', geom FROM :"guess";
CREATE INDEX ON found USING gist (geom);
SELECT '| ' || :'model', (SELECT count(*) FROM mapped), rule, count(*), (SELECT round(avg(EXISTS (SELECT FROM found g WHERE g.place = f.place AND ST_DWithin(g.geom, m.geom, 8))::integer), 3) FROM mapped m),
    round(avg(EXISTS (SELECT FROM mapped m WHERE ST_DWithin(f.geom, m.geom, 15))::integer), 3) || ' |'
FROM found f GROUP BY place, rule ORDER BY place;
