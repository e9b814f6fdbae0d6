\set ECHO none
\ir shared/truths.sql
-- Virtual cities whose kerbs and objects were seen, then put off: a fit brings widths and axes back.  Each SELECT is
-- one truth: (name, holds).
CREATE FUNCTION pg_temp.town(model name, seed integer, side text) RETURNS void LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2177, subjects => '{kerb,fit}', driving_side => side);
  EXECUTE format('INSERT INTO %I.axis (geom, width, lane_count, importance, name, direction, speed)
      SELECT geom, width, lane_count, importance, name, direction, speed
      FROM streetgen.virtual_city(2177, 6560000, 5570000, 1500, 1000, %s, ''{"axes": 40}'')', model, seed);
  PERFORM streetgen.generate(model);
END $$;
\set apart 2
\set noise 0.2
\set seed 7
SELECT pg_temp.town('city', 3, 'right'), pg_temp.town('turned', 5, 'left') \g /dev/null
\set model city
\set points city_object
\ir ../measure/fit_objects.sql
\set points city_point
\ir ../measure/fit_disturb.sql
\set model turned
\set points turned_point
\ir ../measure/fit_disturb.sql
-- Digitised the other way round, a street has its kerbs where they were.
UPDATE turned.axis SET geom = ST_Reverse(geom) WHERE axis_id % 2 = 0;
UPDATE turned_point_truth SET geom = ST_Reverse(geom) WHERE axis_id % 2 = 0;
SELECT FROM streetgen.observe('city', 'city_point', '{"source_ref": "id"}') \g /dev/null
SELECT FROM streetgen.observe('turned', 'turned_point', '{"source_ref": "id"}') \g /dev/null

CREATE FUNCTION pg_temp.apart(model name, truth regclass, OUT width float8, OUT axis float8, OUT farther bigint)
    LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format('SELECT percentile_cont(0.5) WITHIN GROUP (ORDER BY abs((a.width + coalesce(a.width_end, a.width)) / 2
      - t.width)) FROM %I.axis a JOIN %s t USING (axis_id)', model, truth) INTO width;
  EXECUTE format('SELECT percentile_cont(0.5) WITHIN GROUP (ORDER BY ST_Distance(ST_LineInterpolatePoint(a.geom,
      n / 20.0), t.geom)) FROM %I.axis a JOIN %s t USING (axis_id), generate_series(0, 20) n', model, truth) INTO axis;
  EXECUTE format('SELECT count(*) FROM %I.axis a JOIN %s t USING (axis_id), ST_DumpPoints(t.geom) v
      WHERE ST_Distance(ST_Points(a.geom), v.geom) > 1.3', model, truth) INTO farther;
END $$;
SELECT 'before, widths and axes are off', width > 0.5 AND axis > 0.4 FROM pg_temp.apart('city', 'city_point_truth');
SELECT count(*) FROM (SELECT streetgen.accept_fit(m, fit_run) FROM (VALUES ('city'::name), ('turned')) v(m),
    streetgen.fit(m, options => '{"moves": "axis"}')) a \g /dev/null
SELECT 'half of all widths are within 0.1 m: ' || m, width <= 0.1 FROM (VALUES ('city'::name), ('turned')) v(m),
    pg_temp.apart(m, (m || '_point_truth')::regclass);
SELECT 'half of all axes are within 0.1 m: ' || m, axis <= 0.1 FROM (VALUES ('city'::name), ('turned')) v(m),
    pg_temp.apart(m, (m || '_point_truth')::regclass);
SELECT 'no vertex is farther off than before by over 0.3 m: ' || m, farther = 0
    FROM (VALUES ('city'::name), ('turned')) v(m), pg_temp.apart(m, (m || '_point_truth')::regclass);
SELECT 'an accepted fit leaves no error', NOT EXISTS (SELECT FROM streetgen.check_model('city')
    WHERE severity = 'error' OR rule LIKE 'stale%');
SELECT fit_run AS second FROM streetgen.fit('city') \gset
SELECT 'a second fit proposes little', coalesce(max(greatest(abs(p.width - a.width), abs(p.roadway_offset
    - coalesce(a.roadway_offset, 0)))), 0) < 0.3 FROM city.fit_proposal p JOIN city.axis a USING (axis_id)
    WHERE fit_run = :second;
SELECT count(*) FROM streetgen.undo_fit('city', 1) \g /dev/null
SELECT 'undone, widths are as before', width > 0.5 FROM pg_temp.apart('city', 'city_point_truth');

-- Objects alone.
DELETE FROM city.observation;
SELECT FROM streetgen.observe('city', 'city_object',
    '{"source_ref": "id", "kind": "kind", "relation": "relation"}') \g /dev/null
SELECT streetgen.accept_fit('city', fit_run) FROM streetgen.fit('city', options => '{"moves": "axis"}') \g /dev/null
SELECT 'of objects ' || relation || ' the roadway one in fifty at most is on the other side', count(*) FILTER (WHERE
    (relation = 'in') <> EXISTS (SELECT FROM city.roadway r WHERE ST_Intersects(r.surface, o.geom))) <= 0.02 * count(*)
    FROM city_object o WHERE relation <> 'border' GROUP BY relation ORDER BY relation;
SELECT 'of those on its border one in fifty at most is over 0.25 m off it', count(*) FILTER (WHERE NOT EXISTS (
    SELECT FROM city.kerb k WHERE ST_DWithin(k.geom, o.geom, 0.25))) <= 0.02 * count(*)
    FROM city_object o WHERE relation = 'border';
