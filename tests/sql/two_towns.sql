\set ECHO none
\ir shared/truths.sql
\ir shared/city.sql
-- Two virtual towns: what a model of them holds for any seed and either side to drive on, and what is refused.
CREATE TABLE model AS
SELECT number, format('towns_%s', number) AS name, seed, options, streetgen.create_two_towns(format('towns_%s', number), 2154, 650000, 6860000, seed, options) AS drawn
FROM (VALUES (1, 1, '{}'::jsonb), (2, -9223372036854775808, '{"driving_side": "left"}'),
    (3, 3, '{"highway_lanes": 3, "lanes": [4, 2], "overpasses": 0, "distance": 3000}'),
    (4, 4, '{"driving_side": "left", "distance": 5000, "overpasses": 6, "median": 20, "highway_speed": 130, "town_size": 1000, "roundabouts": 1, "one_way_pairs": 1}'),
    (5, 5, '{"ramp_length": 350, "ramp_speed": 40, "highway_speed": 90, "town_size": 700, "bend": 0, "stretch": 0}')) g(number, seed, options);
SELECT count(*) FROM model, streetgen.generate(name, wait => true) \g /dev/null
CREATE FUNCTION pg_temp.towns(model name) RETURNS TABLE(highway_lanes integer, overpasses bigint, clearance float8, grade float8, highway_height float8,
    links bigint, ramps bigint, ramps_on bigint, sides text, merging text, held_up boolean) LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format('SET LOCAL search_path = %I, public', model);
  RETURN QUERY SELECT (SELECT max(a.lane_count) FROM axis a WHERE kind = 'motorway'), (SELECT count(*) FROM overpass WHERE method = 'level'), (SELECT min(u.clearance) FROM underpass u),
      (SELECT max(abs(ST_Z(p) - ST_Z(before)) / nullif(ST_Distance(p, before), 0)) FROM (
          SELECT d.geom AS p, lag(d.geom) OVER (PARTITION BY edge_id ORDER BY d.path) AS before FROM profile, ST_DumpPoints(profile.geom) d) piece),
      (SELECT max(ST_ZMax(p.geom)) FROM profile p JOIN edge USING (edge_id) JOIN axis a USING (axis_id) WHERE kind = 'motorway'),
      (SELECT count(DISTINCT n.node_id) FROM node n, edge e JOIN axis a USING (axis_id), edge h JOIN axis b USING (axis_id)
       WHERE a.kind = 'motorway_link' AND b.kind = 'motorway' AND n.node_id IN (e.from_node, e.to_node) AND n.node_id IN (h.from_node, h.to_node)),
      count(*), count(*) FILTER (WHERE r.kind = 'on'), string_agg(DISTINCT r.side, ', '), string_agg(DISTINCT format('%s lane of %s m', r.lanes_merging, r.length), ', '),
      bool_or(r.cut OR r.short_link OR r.auxiliary) FROM ramp r;
END $$;
-- The streets of a town that a lane of one street of the other does not reach, by the highway alone.
CREATE FUNCTION pg_temp.out_of_reach(model name, town text, other text) RETURNS bigint LANGUAGE plpgsql AS $$
DECLARE
  streets bigint;
BEGIN
  EXECUTE format('SET LOCAL search_path = %I, public', model);
  WITH RECURSIVE street_lane AS (SELECT lane_id, axis_id, name, axis.kind FROM lane JOIN edge USING (edge_id) JOIN axis USING (axis_id) WHERE name !~ '^(North|South|Overpass) '),
  way AS MATERIALIZED (SELECT lane_in, lane_out FROM interconnection WHERE connecting UNION ALL SELECT lane_a, lane_b FROM lane_adjacency WHERE change = 'allowed'),
  reached AS (SELECT lane_id FROM street_lane WHERE axis_id = (SELECT max(axis_id) FROM street_lane WHERE kind = 'residential' AND starts_with(name, town || ' '))
      UNION SELECT l.lane_id FROM reached r JOIN way w ON w.lane_in = r.lane_id JOIN street_lane l ON l.lane_id = w.lane_out)
  SELECT count(*) FROM axis a WHERE starts_with(a.name, other || ' ') AND a.sidewalk_left IS NULL AND NOT EXISTS (SELECT FROM reached JOIN street_lane l USING (lane_id) WHERE l.axis_id = a.axis_id)
      INTO streets;
  RETURN streets;
END $$;
CREATE TABLE found AS SELECT m.*, c.*, f.* FROM model m, test.city(name) c, pg_temp.towns(name) f;
SELECT format('%s: the model holds the axes', name), axes = drawn AND axes > 30 FROM found;
SELECT format('%s: nothing is broken%s', name, ': ' || broken), broken IS NULL FROM found;
SELECT format('%s: all is one piece, on the ground without overlap and slits', name), pieces = 1 AND crossings + slits = 0 AND abs(overlap) < 1e-6 AND outside < 1e-3 FROM found;
SELECT format('%s: one drives from Weston to Easton by the highway', name), pg_temp.out_of_reach(name, 'Weston', 'Easton') = 0 FROM found;
SELECT format('%s: and back', name), pg_temp.out_of_reach(name, 'Easton', 'Weston') = 0 FROM found;
SELECT format('%s: each link meets the highway as a ramp', name), (links, ramps, ramps_on) = (8, 8, 4) FROM found;
SELECT format('%s: on its outer side', name), sides = coalesce(options ->> 'driving_side', 'right') FROM found;
SELECT format('%s: with a merging lane as long as is wanted', name), merging = '1 lane of 250 m' AND NOT held_up FROM found;
SELECT format('%s: roads pass over both carriageways', name), overpasses = 2 * (2 + coalesce((options ->> 'overpasses')::integer, 3)) FROM found;
-- The clearance of 6 m, less a deck of 1 m.
SELECT format('%s: with their clearance', name), clearance > 5 - 1e-6 FROM found;
SELECT format('%s: by usual grades, the highway on the ground', name), grade < CASE WHEN options ->> 'ramp_speed' = '40' THEN 0.06 ELSE 0.04 END + 1e-6 AND highway_height = 0 FROM found;
SELECT format('%s: the highway has the lanes that are asked for', name), highway_lanes = coalesce((options ->> 'highway_lanes')::integer, 2) FROM found;
SELECT 'the model drives where the option says', array_agg(s.value ORDER BY number) = '{right,left,right,left,right}' FROM model m CROSS JOIN LATERAL (SELECT streetgen._setting_text(name, 'driving_side') AS value) s;
SELECT 'the corner is the lower left one', (ST_XMin(e), ST_YMin(e)) = (650000, 6860000) FROM (SELECT ST_Extent(geom) AS e FROM towns_1.axis) e;
SELECT 'people walk along streets of towns alone', bool_and((sidewalk_left IS NULL) = (name ~ '^(Weston|Easton) (Main Road|Avenue|Street|Lane|Roundabout) ')) FROM towns_1.axis;
SELECT 'a second run finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('towns_2');
SELECT streetgen.create_two_towns('again', 2154, 650000, 6860000, 1) \g /dev/null
SELECT 'the same again', NOT EXISTS (SELECT geom::bytea, name, width, kind, level, speed FROM towns_1.axis EXCEPT SELECT geom::bytea, name, width, kind, level, speed FROM again.axis)
    AND (SELECT count(*) FROM again.axis) = (SELECT count(*) FROM towns_1.axis);
SELECT 'another seed is other towns', NOT EXISTS (SELECT geom::bytea FROM towns_1.axis INTERSECT SELECT geom::bytea FROM towns_5.axis);
SELECT 'the options are listed with their defaults', count(*) FILTER (WHERE name IN ('distance', 'overpasses', 'ramp_speed', 'bend')) = 4 AND bool_and(description <> '' AND minimum < maximum AND value[1] BETWEEN minimum AND maximum)
FROM streetgen.two_towns_option();
SELECT 'those of a city are among them, but for the number of axes', array_agg(name) = '{axes}' FROM (SELECT name FROM streetgen.city_option() EXCEPT SELECT name FROM streetgen.two_towns_option()) o;

-- Bad input: one error with a hint, and no model.
CREATE TABLE bad(what, arguments, expected, says) AS VALUES
    ('a corner that is no number', $$2154, 'NaN', 0, 1$$, '22023', 'corner'),
    ('a corner without end', $$2154, 0, 'Infinity', 1$$, '22023', 'corner'),
    ('a geographic SRID', '4326, 0, 0, 1', '22023', 'not projected'),
    ('an unknown SRID', '424242, 0, 0, 1', '22023', 'unknown'),
    ('feet', '2263, 0, 0, 1', '22023', 'not in metres'),
    ('NULL as seed', '2154, 650000, 6860000, NULL', '22004', 'argument seed is NULL'),
    ('NULL as corner', '2154, NULL, 6860000, 1', '22004', 'argument x is NULL'),
    ('NULL as options', '2154, 650000, 6860000, 1, NULL', '22023', 'expected an object'),
    ('options that are no object', $$2154, 650000, 6860000, 1, '[1]'$$, '22023', 'expected an object'),
    ('an unknown option', $$2154, 650000, 6860000, 1, '{"towns": 3}'$$, '22023', 'unknown option "towns"'),
    ('the number of axes', $$2154, 650000, 6860000, 1, '{"axes": 100}'$$, '22023', 'unknown option "axes"'),
    ('a side that is none', $$2154, 650000, 6860000, 1, '{"driving_side": "middle"}'$$, '22023', 'option "driving_side" is "middle"'),
    ('a side that is null', $$2154, 650000, 6860000, 1, '{"driving_side": null}'$$, '22023', 'option "driving_side" is null'),
    ('a highway of one lane', $$2154, 650000, 6860000, 1, '{"highway_lanes": 1}'$$, '22023', 'option "highway_lanes" is 1'),
    ('half a lane', $$2154, 650000, 6860000, 1, '{"highway_lanes": 2.5}'$$, '22023', 'option "highway_lanes" is 2.5'),
    ('a number that is none', $$2154, 650000, 6860000, 1, '{"distance": "far"}'$$, '22023', 'option "distance" is "far"'),
    ('towns too near', $$2154, 650000, 6860000, 1, '{"distance": 2000}'$$, '22023', 'option "distance" is 2000, expected 2550 m'),
    ('a street wider than its town', $$2154, 650000, 6860000, 1, '{"town_size": 500, "clearance": 9000}'$$, '22023', 'of the extent'),
    ('a place where the projection fails', '2154, 65000000, 6860000, 1', '22023', '');
SELECT what || ' is refused', state = expected AND said LIKE '%' || says || '%' AND hint <> '' FROM bad, test.refusal(format('SELECT streetgen.create_two_towns(''lost'', %s)', arguments));
SELECT 'a name that is NULL is refused', test.state('SELECT streetgen.create_two_towns(NULL, 2154, 650000, 6860000, 1)') = '22004';
SELECT 'an existing model is refused', test.state($$SELECT streetgen.create_two_towns('towns_1', 2154, 650000, 6860000, 1)$$) = '42P06';
SELECT 'nothing of a refused model is left', to_regnamespace('lost') IS NULL AND NOT EXISTS (SELECT FROM streetgen.model WHERE name = 'lost');
