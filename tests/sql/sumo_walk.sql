\set ECHO none
\ir shared/truths.sql
-- Where people walk and cross in files of SUMO: on streets without a sidewalk, at corners without paint, over medians.  (name, holds)
CREATE FUNCTION pg_temp.file(model name, part text, options jsonb DEFAULT '{}') RETURNS xml LANGUAGE sql AS $$
  SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo(model, part, options) $$;
CREATE FUNCTION pg_temp.found(path text, file xml) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, file)) $$;
CREATE FUNCTION pg_temp.crossed(model name) RETURNS text[] LANGUAGE sql AS $$ SELECT array_agg(format('%s %s', (xpath('string(/crossing/@edges)', c))[1], (xpath('string(/crossing/@priority)', c))[1]) ORDER BY c::text COLLATE "C") FROM unnest(xpath('//crossing', pg_temp.file(model, 'connections'))) c $$;
CREATE FUNCTION pg_temp.shape(element xml) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_GeomFromText('LINESTRING(' || translate((xpath('string(/*/@shape)', element))[1]::text, ' ,', ', ') || ')') $$;
-- Two streets with sidewalks go on from each other, one without comes to them, and one of cars alone.
DO $$ BEGIN
  PERFORM streetgen.create_model('corner', 2154, subjects => '{interconnection,sidewalk}', driving_side => 'right'), streetgen.create_model('left_corner', 2154, subjects => '{interconnection,sidewalk}', driving_side => 'left');
  INSERT INTO corner.axis (axis_id, geom, width, sidewalk_left, sidewalk_right, kind) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 2, 2, 'residential'), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 2, 2, 'residential'),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 7, 0, 0, 'residential'), (4, 'SRID=2154;LINESTRING(650200 6860000,650300 6860000)', 7, 2, 2, 'residential'), (5, 'SRID=2154;LINESTRING(650400 6860000,650500 6860000)', 7, 0, 0, 'motorway');
  INSERT INTO left_corner.axis SELECT * FROM corner.axis;
END $$;
SELECT m || ': a street without a sidewalk is walked along at both borders of its roadway', pg_temp.found('//edge[@id="3" or @id="-3"]/lane[@index="0" and @allow="pedestrian" and @width="1.30"]', f) = 2
  AND (SELECT bool_and(ST_Within(ST_Buffer(ST_Translate(ST_SetSRID(pg_temp.shape(l), 2154), 650000, 6860000), 0.6, 'endcap=flat'), ST_Buffer(s.surface, 0.01))) AND count(*) = 2 FROM unnest(xpath('//edge[@id="3" or @id="-3"]/lane[@index="0"]', f)) l, corner.section s WHERE edge_id = 3)
  FROM unnest('{corner,left_corner}'::name[]) m, pg_temp.file(m, 'edges') f;
SELECT m || ': nobody walks along a motorway', pg_temp.found('//edge[@id="5" or @id="-5"]/lane[@allow="pedestrian"]', pg_temp.file(m, 'edges')) = 0 FROM unnest('{corner,left_corner}'::name[]) m;
SELECT m || ': where three streets meet each is crossed without paint, and cars go first; where one goes on none is', pg_temp.crossed(m) = '{-1 1 0,-2 2 0,-3 3 0}' FROM unnest('{corner,left_corner}'::name[]) m;
SELECT 'one crosses where lanes end', ST_Distance(pg_temp.shape(c), ST_MakePoint(100, (SELECT abscissa FROM corner.section_limit WHERE (edge_id, which) = (3, 'start')))) < 0.01 AND abs(ST_Length(pg_temp.shape(c)) - 7) < 0.01
  FROM unnest(xpath('//crossing[@edges="-3 3"]', pg_temp.file('corner', 'connections'))) c;
SELECT 'nobody waits before it', pg_temp.found('//stopOffset', pg_temp.file('corner', 'edges')) = 0;
UPDATE corner.axis SET kind = 'service' WHERE axis_id = 3;
SELECT 'the mouth of a drive is crossed, and not the street for it', pg_temp.crossed('corner') = '{-3 3 0}';
-- At the mouth of a loop people cross it once.
DO $$ BEGIN
  PERFORM streetgen.create_model('loop', 2154, subjects => '{interconnection,sidewalk}', driving_side => 'right');
  INSERT INTO loop.axis (axis_id, geom, width) VALUES (4, 'SRID=2154;LINESTRING(650600 6860000,650700 6860000,650700 6860100,650600 6860000)', 6);
END $$;
SELECT 'a loop is crossed once', pg_temp.crossed('loop') = '{-1.end 1 0}';
-- A street of two carriageways, with a crossing of each in mid-block, and a street that comes to one of them.
DO $$ BEGIN
  PERFORM streetgen.create_model('dual', 2154, subjects => '{interconnection,sidewalk,object,junction}', driving_side => 'right');
  INSERT INTO dual.axis (axis_id, geom, width, direction, name, kind, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650200 6860000)', 7, 'direct', 'avenue', 'secondary', 0, 2), (2, 'SRID=2154;LINESTRING(650200 6860000,650400 6860000)', 7, 'direct', 'avenue', 'secondary', 0, 2),
    (3, 'SRID=2154;LINESTRING(650400 6860012,650200 6860012)', 7, 'direct', 'avenue', 'secondary', 0, 2), (4, 'SRID=2154;LINESTRING(650200 6860012,650000 6860012)', 7, 'direct', 'avenue', 'secondary', 0, 2);
  INSERT INTO dual.pedestrian_crossing_editing (geom, width, angle) VALUES ('SRID=2154;POINT(650195 6860000)', 4, 90), ('SRID=2154;POINT(650205 6860012)', 3, 90);
END $$;
SELECT 'the carriageways have a median between them', bool_and('median' IN (beside_left, beside_right)) AND count(*) = 4 FROM dual.edge;
SELECT 'nobody walks along it', pg_temp.found('//lane[@allow="pedestrian"]', f) = 5 AND pg_temp.found('//edge[contains(@id, "refuge")]', f) = 1 FROM pg_temp.file('dual', 'edges') f;
SELECT 'people cross both, and wait on a refuge between, as wide as the narrower crossing', pg_temp.found('//crossing[@priority="1"]', pg_temp.file('dual', 'connections')) = 2 AND pg_temp.found('//edge[contains(@id, "refuge")]/lane[@width="3.00"]', f) = 1
  AND (SELECT abs(ST_Length(pg_temp.shape(l)) - sqrt(5 ^ 2 + 10 ^ 2)) < 0.1 FROM unnest(xpath('//edge[contains(@id, "refuge")]/lane', f)) l) FROM pg_temp.file('dual', 'edges') f;
