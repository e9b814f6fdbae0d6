\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Very many axes at one place: ground and pairs of lanes beyond the bounds.  (name, holds)
SELECT streetgen.create_model(m, 32631) FROM unnest(ARRAY['star', 'band', 'bundle', 'same', 'anew']) m \g /dev/null
SELECT streetgen.live(m, false) FROM unnest(ARRAY['star', 'band', 'bundle', 'same']) m \g /dev/null
INSERT INTO star.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(452000, 5411000),
    ST_MakePoint(452000 + 100 * cosd(3 * i), 5411000 + 100 * sind(3 * i))), 32631), 6 FROM generate_series(1, 120) i;
INSERT INTO band.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(452000, 5411000 + 2 * i),
    ST_MakePoint(452100, 5411000 + 2 * i)), 32631), 6 FROM generate_series(1, 200) i;
INSERT INTO bundle.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(452000, 5411000),
    ST_MakePoint(452050, 5411000 + 4 * i), ST_MakePoint(452100, 5411000)]), 32631), 6 FROM generate_series(1, 100) i;
INSERT INTO same.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(452000, 5411000),
    ST_MakePoint(452100, 5411000)), 32631), 6 FROM generate_series(1, 100) i;
SELECT streetgen.set('band', 'overlaps_maximal', '5') \g /dev/null
-- Kinks behind a fork stay sharp there.
SELECT streetgen.set('bundle', 'kerb_radius_minimal', '0') \g /dev/null
SELECT streetgen.generate(m) FROM unnest(ARRAY['star', 'band', 'bundle', 'same']) m \g /dev/null

CREATE FUNCTION pg_temp.ground(model name, OUT summed float8, OUT covered float8, OUT crowded bigint)
    LANGUAGE plpgsql AS $$
BEGIN
  EXECUTE format($q$SELECT sum(ST_Area(surface)), ST_Area(ST_Union(surface, 1e-6)), count(*) FILTER (WHERE method = 'crowded')
    FROM (SELECT surface, method FROM %1$I.section UNION ALL SELECT surface, method FROM %1$I.intersection) s$q$, model)
    INTO summed, covered, crowded;
END $$;
CREATE TABLE said AS SELECT m AS model, c.* FROM unnest(ARRAY['star', 'band', 'bundle']) m, streetgen.check_model(m) c;
SELECT m || ' tiles', abs(summed - covered) < 1e-3 FROM unnest(ARRAY['star', 'band', 'bundle']) m, pg_temp.ground(m);
SELECT 'a band covers what its axes claim', abs(summed - 100 * (6 + 199 * 2)) < 1e-3 FROM pg_temp.ground('band');
SELECT 'one street a hundred times covers what one claims', abs(summed - 600) < 1e-3 FROM pg_temp.ground('same');
SELECT 'nothing is broken', count(*) = 0 FROM said WHERE severity = 'error';
SELECT 'check_model names each surface that came into a crowd', count(*) = (SELECT crowded FROM pg_temp.ground('band'))
    FROM said WHERE model = 'band' AND severity = 'warning' AND rule LIKE 'ground shared out by rank%' AND relation = 'section';
SELECT 'it is a row with a place in each of the models', count(DISTINCT model) = 3 AND bool_and(NOT ST_IsEmpty(geom))
    FROM said WHERE rule LIKE 'ground shared out by rank%';
SELECT 'over interconnections_maximal no pairs are made', NOT EXISTS (SELECT FROM star.interconnection);
SELECT 'check_model names the node and the pairs', array_agg(relation || ' ' || measure) = '{node 14280}'
    FROM said WHERE model = 'star' AND severity = 'warning' AND rule LIKE 'pairs of lanes over interconnections_maximal%';
SELECT 'and none of its lanes', NOT EXISTS (SELECT FROM said WHERE model = 'star' AND rule LIKE 'lane%plausible way%');
SELECT streetgen.set('star', 'interconnections_maximal', '14280'), streetgen.set('star', 'overlaps_maximal', '1000') \g /dev/null
SELECT streetgen.set('bundle', 'interconnections_maximal', '9899'), streetgen.generate('bundle') \g /dev/null
SELECT 'a bundle of 100 has 9900 pairs at each end', count(*) = 2
    FROM streetgen.check_model('bundle') WHERE rule LIKE 'pairs of lanes over%' AND measure = 9900;
SELECT 'a bound out of its range is refused', bool_and(test.state(format('SELECT streetgen.set(''star'', %L, %L)', name, value)) = '22023')
    FROM (VALUES ('overlaps_maximal', '0'), ('overlaps_maximal', '1001'), ('interconnections_maximal', '-1')) v(name, value);

-- An edit in a crowd gives what a run from scratch gives.
SELECT streetgen.set(m, 'overlaps_maximal', '8') FROM unnest(ARRAY['band', 'anew']) m \g /dev/null
DELETE FROM band.axis WHERE axis_id > 30;
UPDATE band.axis SET geom = ST_Translate(geom, (axis_id % 7) * 9, (axis_id % 5) * 1.5 - 1.99 * axis_id), importance = 3 + axis_id % 3;
SELECT streetgen.generate('band'), streetgen.live('band', true) \g /dev/null
SELECT 'the model of the edits has a crowd', crowded > 10 FROM pg_temp.ground('band');
DELETE FROM band.axis WHERE axis_id = 4;
SELECT 'an axis taken out of a crowd', test.followed('band', 'anew');
INSERT INTO band.axis (geom, width, importance) VALUES ('SRID=32631;LINESTRING(452020 5410990,452060 5411020)', 7, 2);
SELECT 'an important axis across it', test.followed('band', 'anew');
UPDATE band.axis SET geom = ST_Translate(geom, 0, 4) WHERE axis_id IN (2, 9);
SELECT 'axes moved within it', test.followed('band', 'anew');
DELETE FROM band.axis WHERE axis_id % 6 > 0 AND axis_id < 31;
SELECT 'axes taken out until it is none', test.followed('band', 'anew') AND (SELECT crowded = 0 FROM pg_temp.ground('band'));
