\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Rings of the network, scored, decided and circulated.  (name, holds)
CREATE FUNCTION ring(x float8, y float8, radius float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_ForceRHR(ST_MakePolygon(ST_ExteriorRing(ST_Buffer(ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154), radius, 6)))) $$;
CREATE FUNCTION circle(x float8, y float8, radius float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_Reverse(ST_ExteriorRing(ring(x, y, radius))) $$;
CREATE FUNCTION arm(x float8, y float8, radius float8, angle float8, metres float8 DEFAULT 100) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + x + radius * cos(radians(angle)), 6860000 + y + radius * sin(radians(angle))),
    ST_MakePoint(650000 + x + (radius + metres) * cos(radians(angle)), 6860000 + y + (radius + metres) * sin(radians(angle)))), 2154) $$;
DO $$ BEGIN PERFORM streetgen.create_model('town', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right'); END $$;
-- A ring of four arms, and the outline of a block.
INSERT INTO town.axis (geom, width, lane_count, importance) SELECT circle(0, 0, 18), 7, 2, 3;
INSERT INTO town.axis (geom, width, lane_count, importance) SELECT arm(0, 0, 18, 90 * a), 6, 2, 4 FROM generate_series(0, 3) a;
INSERT INTO town.axis (geom, width, lane_count) SELECT ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(650300, 6860000), ST_MakePoint(650350, 6860000), ST_MakePoint(650350, 6860060),
  ST_MakePoint(650300, 6860060), ST_MakePoint(650300, 6860000)]), 2154), 6, 2;
SELECT 'a ring of four arms is accepted, a block is not', array_agg(accepted ORDER BY score DESC) IN ('{t}', '{t,f}') FROM town.roundabout;
SELECT 'its radius and centre are those drawn', abs(radius - 18) < 0.3 AND ST_DWithin(centre, 'SRID=2154;POINT(650000 6860000)', 0.1) FROM town.roundabout WHERE accepted;
SELECT 'its four edges come counter-clockwise, all with one axis', count(*) = 4 AND count(DISTINCT ordinality) = 4 AND count(DISTINCT axis_id) = 1 FROM town.roundabout JOIN town.roundabout_edge r USING (roundabout_id) JOIN town.edge e ON e.edge_id = r.edge_id WHERE accepted;
SELECT 'it has four arms', count(*) = 4 FROM town.roundabout_arm;
SELECT 'its lanes go round', count(*) = 8 AND bool_and(l.along_axis = r.along_axis AND NOT both_ways) FROM town.roundabout_edge r JOIN town.roundabout USING (roundabout_id) JOIN town.lane l ON l.edge_id = r.edge_id WHERE accepted;
SELECT 'its edges count lanes of one way', bool_and(least(lanes_forward, lanes_backward) = 0 AND greatest(lanes_forward, lanes_backward) = 2) FROM town.edge WHERE axis_id = 1;
SELECT 'each arm yields', count(*) = 4 FROM town.marking m JOIN town.roundabout_arm a ON a.edge_id = m.edge_id WHERE kind = 'yield';
SELECT 'nobody waits on the ring', NOT EXISTS (SELECT FROM town.marking m JOIN town.roundabout_edge r ON r.edge_id = m.edge_id WHERE m.kind IN ('yield', 'stop'));
SELECT 'its island is one', ST_NumGeometries(island) = 1 AND ST_Area(island) > 500 AND kind = 'ring' FROM town.roundabout WHERE accepted;
SELECT 'no path drives against it', NOT EXISTS (SELECT FROM town.interconnection i JOIN town.lane l ON l.lane_id = lane_out JOIN town.roundabout_edge r ON r.edge_id = l.edge_id
  WHERE plausible AND along_out <> r.along_axis);
SELECT 'check_model has no error', NOT EXISTS (SELECT FROM streetgen.check_model('town') WHERE severity = 'error');
CREATE TABLE before AS SELECT * FROM test.content('town');
SELECT 'a second run rewrites no row', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town');

-- Decided by hand.
INSERT INTO town.roundabout_override (geom, confirmed) VALUES ('SRID=2154;POINT(650002 6860001)', false);
SELECT 'confirmed is put by hand', (SELECT NOT accepted AND NOT confirmed AND method = 'by_hand' FROM town.roundabout ORDER BY score DESC LIMIT 1);
SELECT 'a ring that is none has traffic both ways', (SELECT count(DISTINCT along_axis) = 2 FROM town.lane JOIN town.edge USING (edge_id) WHERE axis_id = 1);
DELETE FROM town.roundabout_override;
SELECT 'without the decision all is as before', NOT EXISTS ((SELECT test.content('town') EXCEPT TABLE before) UNION ALL (TABLE before EXCEPT SELECT test.content('town')));

-- A ring with a waist.
DO $$ BEGIN PERFORM streetgen.create_model('waist', 2154, subjects => '{interconnection,roundabout,block}', driving_side => 'right'); END $$;
INSERT INTO waist.axis (geom, width, lane_count) SELECT ST_ExteriorRing(ST_Union(ring(0, 0, 14), ring(22, 0, 14))), 6, 1;
INSERT INTO waist.axis (geom, width, lane_count) SELECT arm(x, 0, 14, a), 6, 2 FROM (VALUES (0, 180), (22, 0)) v(x, a);
SELECT 'a ring with a waist is offered as a peanut', (SELECT array_agg(kind || ' ' || accepted) = '{peanut false}' FROM waist.roundabout);
UPDATE waist.roundabout_editing SET confirmed = true;
SELECT 'confirmed, traffic goes round it', (SELECT count(DISTINCT l.along_axis) = 1 FROM waist.lane l JOIN waist.roundabout_edge r USING (edge_id));
SELECT 'the block of a ring is the ground within', (SELECT abs(ST_Area(ST_Intersection(b.surface, r.island)) / ST_Area(b.surface) - 1) < 0.05 FROM waist.roundabout r JOIN waist.roundabout_block USING (roundabout_id) JOIN waist.block b USING (block_id));
SELECT FROM streetgen.switch_subject('waist', 'block', false);
SELECT 'without blocks there is no such view', to_regclass('waist.roundabout_block') IS NULL AND to_regclass('waist.roundabout') IS NOT NULL;

-- Two rings with a piece of way between them.
CREATE FUNCTION way(x float8, radius float8, start float8, stop float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(ST_SetSRID(ST_MakePoint(650000 + x + radius * cos(radians(a)), 6860000 + radius * sin(radians(a))), 2154) ORDER BY i)
  FROM generate_series(0, 20) i, LATERAL (SELECT start + (stop - start) * i / 20.0 AS a) p $$;
CREATE PROCEDURE draw_double(model name, joined boolean) LANGUAGE plpgsql AS $$ BEGIN
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) VALUES (1, way(0, 15, 30, 330), 6, 1), (2, way(30 * cos(radians(30)), 15, -150, 150), 6, 1)', model);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) SELECT 10 + a, arm(x, 0, 15, b), 6, 2
    FROM (VALUES (1, 0, 90), (2, 0, 180), (3, 0, 270), (4, 30 * cos(radians(30)), 90), (5, 30 * cos(radians(30)), 0), (6, 30 * cos(radians(30)), 270)) v(a, x, b)', model);
  IF joined THEN
    EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count) SELECT 3, ST_MakeLine(ST_EndPoint(a.geom), ST_StartPoint(a.geom)), 6, 2 FROM %1$I.axis a WHERE axis_id = 1', model);
  END IF;
END $$;
DO $$ BEGIN PERFORM streetgen.create_model('two', 2154, subjects => '{interconnection,roundabout,block}', driving_side => 'right'); END $$;
CALL draw_double('two', true);
SELECT 'a double roundabout is one row of two faces', (SELECT array_agg(kind || ' ' || accepted) = '{double true}' FROM two.roundabout)
  AND (SELECT count(DISTINCT face) = 2 AND min(ordinality) = 1 AND max(ordinality) = count(*) FROM two.roundabout_edge);
SELECT 'its ring goes about both', ST_IsClosed(geom) AND ST_IsSimple(geom) AND NOT ST_IsPolygonCCW(ST_Reverse(ST_MakePolygon(geom))) AND abs(ST_Area(ST_MakePolygon(geom)) - 1340) < 30 FROM two.roundabout;
SELECT 'it has an island in each face', ST_NumGeometries(island) = 2 AND ST_IsValid(island) FROM two.roundabout;
SELECT 'the piece between the faces is in both, and no arm', (SELECT count(*) = 2 AND count(DISTINCT along_axis) = 2 FROM two.roundabout_edge JOIN two.edge USING (edge_id) WHERE axis_id = 3)
  AND (SELECT count(*) = 6 FROM two.roundabout_arm);
SELECT 'traffic goes round both, and both ways between them', (SELECT bool_and((ways = 2) = (axis_id = 3)) FROM (SELECT axis_id, count(DISTINCT l.along_axis) AS ways
  FROM two.lane l JOIN two.edge e USING (edge_id) WHERE axis_id < 10 GROUP BY edge_id, axis_id) w);
SELECT 'its block is that of its first face', (SELECT ST_Intersects(b.surface, ST_GeometryN(r.island, 1)) OR ST_Intersects(b.surface, ST_GeometryN(r.island, 2)) FROM two.roundabout r JOIN two.roundabout_block USING (roundabout_id) JOIN two.block b USING (block_id));
SELECT 'check_model has no error of a double one', NOT EXISTS (SELECT FROM streetgen.check_model('two') WHERE severity = 'error' OR rule LIKE '%roundabout%');
SELECT 'SUMO gets each face as a roundabout', (SELECT count(*) = 2 FROM streetgen.export_sumo('two', 'edges') WHERE line LIKE '%<roundabout %');
SELECT 'SymuVia gets its nodes as places', NOT EXISTS (SELECT FROM streetgen.export_symuvia('two') WHERE line LIKE '%<GIRATOIRE %');
UPDATE two.roundabout_editing SET confirmed = false;
SELECT 'it is refused as a whole', (SELECT count(*) = 1 AND NOT bool_or(accepted) FROM two.roundabout)
  AND (SELECT bool_and(ways = 2) FROM (SELECT count(DISTINCT l.along_axis) AS ways FROM two.lane l JOIN two.edge USING (edge_id) WHERE lane_count = 2 AND axis_id < 10 GROUP BY edge_id) w);
DELETE FROM two.roundabout_editing;
SELECT 'and taken back as a whole', (SELECT count(*) = 1 AND bool_and(accepted) FROM two.roundabout) AND NOT EXISTS (SELECT FROM two.roundabout_override);
DELETE FROM two.axis WHERE axis_id = 3;
SELECT 'without the piece between it is a peanut', (SELECT array_agg(kind || ' ' || accepted) = '{peanut true}' FROM two.roundabout);
DO $$ BEGIN PERFORM streetgen.create_model('two_anew', 2154, subjects => '{interconnection,roundabout,block}', driving_side => 'right'); END $$;
CALL draw_double('two_anew', false);
SELECT 'edits of a double one give what a model from scratch has', test.same('two', 'two_anew');
INSERT INTO two.axis (axis_id, geom, width, lane_count) SELECT 3, ST_MakeLine(ST_EndPoint(geom), ST_StartPoint(geom)), 6, 2 FROM two.axis WHERE axis_id = 1;
DELETE FROM two.axis WHERE axis_id IN (14, 15, 16);
DELETE FROM two.axis WHERE axis_id = 2;
SELECT 'with half of it gone the other half is none', (SELECT count(*) = 1 AND bool_and(kind = 'ring') FROM two.roundabout);
SELECT 'and a run over all leaves what edits made of rings', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('two') WHERE relation ~ 'roundabout|lane|interconnection';

-- A node with a painted circle.
DO $$ BEGIN PERFORM streetgen.create_model('painted', 2154, subjects => '{interconnection,junction,roundabout}', driving_side => 'right'); END $$;
INSERT INTO painted.axis (geom, width, lane_count) SELECT arm(0, 0, 0, 90 * a), 6, 2 FROM generate_series(0, 3) a;
INSERT INTO painted.control_point (geom, kind) VALUES ('SRID=2154;POINT(650000.4 6860000.2)', 'mini_roundabout');
SELECT 'at a mini-roundabout all arms yield, and its junction is a roundabout', (SELECT count(*) = 4 FROM painted.marking WHERE kind = 'yield') AND (SELECT array_agg(kind) = '{roundabout}' FROM painted.junction WHERE kind <> 'end')
  AND (SELECT bool_and(rule = 'yield') FROM painted.right_of_way WHERE connecting AND junction_id = (SELECT junction_id FROM painted.junction WHERE kind = 'roundabout'));
SELECT 'all its arms are joined to all others', (SELECT count(DISTINCT (a.edge_id, b.edge_id)) = 12 FROM painted.interconnection JOIN painted.lane a ON a.lane_id = lane_in JOIN painted.lane b ON b.lane_id = lane_out WHERE plausible AND a.edge_id <> b.edge_id);
SELECT 'in SUMO who comes from the left goes first there', (SELECT count(*) = 1 FROM streetgen.export_sumo('painted', 'nodes') WHERE line LIKE '%type="left_before_right"%');
-- Three metres off its node, under a bridge with a node above it.
INSERT INTO painted.axis (geom, width, lane_count, level) SELECT arm(3.7, 1.2, 0, 45 + 90 * a), 6, 2, 1 FROM generate_series(0, 3) a;
UPDATE painted.control_point SET geom = 'SRID=2154;POINT(650003 6860000)';
SELECT 'also 3 m off its node, and not at the bridge above', (SELECT count(*) = 4 AND bool_and(level = 0) FROM painted.junction JOIN painted.edge e ON junction_id IN (from_node, to_node) WHERE junction.kind = 'roundabout')
  AND (SELECT array_agg(substring(line FROM 'id="(\d+)"')::bigint) = (SELECT array_agg(junction_id) FROM painted.junction WHERE kind = 'roundabout') FROM streetgen.export_sumo('painted', 'nodes') WHERE line LIKE '%type="left_before_right"%');

-- What is no ring, or an odd one, beside a good one.
DO $$ BEGIN PERFORM streetgen.create_model('odd', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right'); END $$;
INSERT INTO odd.axis (geom, width, lane_count, name) SELECT circle(0, 0, 18), 6, 1, repeat('Place ', 180000);
INSERT INTO odd.axis (geom, width, lane_count, name) SELECT arm(0, 0, 18, 90 * a), 6, 2, 'دوار السلام' FROM generate_series(0, 3) a;
-- Of three points, of a thousand vertices, crossing itself, of two levels, of radius 0.01 m and of 10 km.
INSERT INTO odd.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650200 6860000, 650230 6860000, 650215 6860026, 650200 6860000)', 5);
INSERT INTO odd.axis (geom, width) SELECT ST_ExteriorRing(ST_Buffer('SRID=2154;POINT(650300 6860000)'::geometry, 20, 250)), 5;
INSERT INTO odd.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650400 6860000, 650440 6860040, 650440 6860000, 650400 6860040, 650400 6860000)', 5);
INSERT INTO odd.axis (geom, width, level) SELECT ST_MakeLine(ST_SetSRID(ST_MakePoint(650500 + 20 * cos(radians(180 * h + 15 * i)), 6860000 + 20 * sin(radians(180 * h + 15 * i))), 2154) ORDER BY i), 5, h FROM generate_series(0, 1) h, generate_series(0, 12) i GROUP BY h;
INSERT INTO odd.axis (geom, width) SELECT ST_ExteriorRing(ST_Buffer(ST_SetSRID(ST_MakePoint(x, 6860000), 2154), r, 6)), 5 FROM (VALUES (650600, 0.01), (680000, 10000)) v(x, r);
SELECT 'odd rings are found or left out, and the good one is accepted', (SELECT array_agg(round(ST_X(centre)) || ' ' || accepted ORDER BY ST_X(centre)) = '{"650000 true","650215 false","650300 false","650500 false"}' FROM odd.roundabout);
SELECT 'their streets are sound', NOT EXISTS (SELECT FROM streetgen.check_model('odd') WHERE severity = 'error');
CREATE FUNCTION public.raising_score(float8, float8, float8, float8[]) RETURNS float8 LANGUAGE plpgsql AS $$ BEGIN RAISE EXCEPTION 'no score today'; END $$;
SELECT streetgen.set('odd', 'roundabout_score', 'public.raising_score') \gset
SELECT 'a score function that raises names the ring', r.said = 'score function public.raising_score failed: no score today' AND r.detail LIKE 'At the ring about POINT%' AND (SELECT count(*) = 4 FROM odd.roundabout) FROM test.refusal($q$SELECT FROM streetgen.generate('odd')$q$) r;
SELECT streetgen.set('odd', 'roundabout_score', 'streetgen.roundabout_score') \gset
SELECT streetgen.set('odd', 'roundabout_weight_' || w, '0') FROM unnest(ARRAY['shape', 'name', 'network']) w \g /dev/null
SELECT 'weights that sum to 0 are refused with their settings', r.state = '22023' AND r.hint LIKE 'Settings roundabout_weight_shape%' FROM test.refusal($q$SELECT FROM streetgen.generate('odd')$q$) r;
SELECT 'a negative weight is refused', test.state($q$SELECT streetgen.set('odd', 'roundabout_weight_shape', '-1')$q$) = '22023';

-- The list to work through.
SELECT 'the least certain ring comes first', array_agg(nearness) = array_agg(nearness ORDER BY nearness) FROM town.roundabout_editing;
UPDATE town.roundabout_editing SET confirmed = false WHERE accepted;
SELECT 'an edit in the list is an override within the ring', (SELECT NOT confirmed FROM town.roundabout_override) AND NOT EXISTS (SELECT FROM town.roundabout WHERE accepted);
UPDATE town.roundabout_editing SET confirmed = true WHERE NOT confirmed;
SELECT 'the other way round it is the same override', (SELECT count(*) = 1 AND bool_and(confirmed) FROM town.roundabout_override);
DELETE FROM town.roundabout_editing WHERE confirmed;
SELECT 'DELETE takes it back', NOT EXISTS (SELECT FROM town.roundabout_override) AND (SELECT count(*) = 1 FROM town.roundabout WHERE accepted AND confirmed IS NULL);
SELECT 'a roundabout cannot be drawn', test.state($q$INSERT INTO town.roundabout_editing (confirmed) VALUES (true)$q$) = '0A000';
INSERT INTO town.roundabout_override (geom, confirmed) VALUES ('SRID=2154;POINT(650900 6860900)', true);
SELECT 'an override on no face is told', EXISTS (SELECT FROM streetgen.check_model('town') WHERE rule = 'roundabout override without its ring');
DELETE FROM town.roundabout_override;

-- Terms and scores.
SELECT 'a score is the mean of its terms', streetgen.roundabout_score(1, 0.5, 0.25, '{1,1,2}') = 0.5;
SELECT 'weights that are none are 22023: ' || weights, test.state(format('SELECT streetgen.roundabout_score(1, 1, 1, %L)', weights)) = '22023' FROM unnest(ARRAY['{0,0,0}', '{-1,1,1}', '{1,1}', '{NaN,1,1}']) weights;
SELECT 'terms stay within 0 and 1', bool_and(streetgen.roundabout_shape(s, f) BETWEEN 0 AND 1 AND streetgen.roundabout_network(s, f, n, s, n) BETWEEN 0 AND 1)
  FROM unnest(ARRAY[-1, 0, 0.5, 1, 2]) s, unnest(ARRAY[0, 0.6, 1]) f, generate_series(0, 12, 4) n;
SELECT 'a name of a roundabout is one', streetgen.roundabout_name('{Place de la Gare,Place de la Gare,NULL}', ARRAY['\mplace\M']) = 1;
SELECT 'one name all round is something', streetgen.roundabout_name('{Ring,Ring}', '{}') = 0.7;
SELECT 'no names say nothing', streetgen.roundabout_name('{NULL,NULL}', '{place}') = 0.5;
SELECT 'a long name and an Arabic one are names', streetgen.roundabout_name(ARRAY[repeat('x', 1000000), 'دوار السلام'], '{place,دوار}') = 1;
SELECT 'a missing extension is 0A000 with its line', r.state = '0A000' AND r.hint LIKE 'CREATE EXTENSION unaccent;%' FROM test.refusal($q$SELECT streetgen.roundabout_name('{Kirche}', '{kreisel}', 'fuzzy')$q$) r
  WHERE NOT EXISTS (SELECT FROM pg_extension WHERE extname = 'unaccent');
SELECT 'a pattern that is no expression is refused', test.state($q$INSERT INTO town.roundabout_pattern VALUES ('(', 'en')$q$) = '2201B';
CREATE FUNCTION public.no_score(float8, float8, float8, float8[]) RETURNS float8 LANGUAGE sql AS $$ SELECT 'NaN'::float8 $$;
SELECT streetgen.set('town', 'roundabout_score', 'public.no_score') \gset
SELECT 'a score that is none names the ring', r.state = '22023' AND r.detail LIKE 'At the ring about POINT%' FROM test.refusal($q$SELECT FROM streetgen.generate('town')$q$) r;
SELECT 'a score function that is none is refused', test.state($q$SELECT streetgen.set('town', 'roundabout_score', 'nobody')$q$) = '22023';
SELECT streetgen.set('town', 'roundabout_score', 'streetgen.roundabout_score') \gset

-- Edits are as a run over all.
UPDATE town.axis SET geom = circle(0, 0, 25) WHERE axis_id = 1;
UPDATE town.axis SET geom = arm(0, 0, 25, 30) WHERE axis_id = 2;
UPDATE town.axis SET geom = arm(0, 0, 25, 90) WHERE axis_id = 3;
UPDATE town.axis SET geom = arm(0, 0, 25, 180) WHERE axis_id = 4;
UPDATE town.axis SET geom = arm(0, 0, 25, 270) WHERE axis_id = 5;
SELECT 'a ring that was moved is one again', (SELECT accepted AND abs(radius - 25) < 0.4 FROM town.roundabout ORDER BY score DESC LIMIT 1);
CREATE TABLE edited AS SELECT * FROM test.content('town');
SELECT 'what edits made a run leaves', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town');
DO $$ BEGIN PERFORM streetgen.create_model('anew', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right'); END $$;
INSERT INTO anew.axis SELECT * FROM town.axis;
SELECT 'edits give what a model from scratch has', test.same('town', 'anew');
-- An arm that comes to the ring, cut 300 m before: another edge is the arm then.
UPDATE town.axis SET geom = ST_Reverse(arm(0, 0, 25, 180, 500)) WHERE axis_id = 4;
INSERT INTO town.axis (axis_id, geom, width) VALUES (90, 'SRID=2154;LINESTRING(649600 6860000, 649600 6860080)', 5);
SELECT 'an arm that is cut far away is the edge at the ring', (SELECT count(*) = 1 FROM town.roundabout_arm JOIN town.edge USING (edge_id) WHERE axis_id = 4 AND ST_Length(geom) < 420)
  AND (SELECT bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town'));
DELETE FROM town.axis WHERE axis_id = 90;
SELECT 'and joined again the whole', (SELECT count(*) = 1 FROM town.roundabout_arm JOIN town.edge USING (edge_id) WHERE axis_id = 4 AND ST_Length(geom) > 450)
  AND (SELECT bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town'));
-- What hangs within a ring, leaves it across and leads far away.
INSERT INTO town.axis (axis_id, geom, width) SELECT n, ST_Translate(line, 650000, 6862000), 4 FROM (VALUES
  (91, ST_SetSRID(ST_Boundary(ST_Buffer(ST_Point(0, 0), 20)), 2154)), (92, 'SRID=2154;LINESTRING(20 0, 0 7, -300 9)'::geometry), (93, 'SRID=2154;LINESTRING(-300 9, -340 49, -380 9)'),
  (94, 'SRID=2154;LINESTRING(-300 9, -340 -31, -380 9)')) a(n, line);
DELETE FROM town.axis WHERE axis_id = 94;
SELECT 'no edit far away makes a ring or takes one', bool_and(inserted = 0 AND updated = 0 AND deleted = 0) FROM streetgen.generate('town', wait => true);
DELETE FROM town.axis WHERE axis_id BETWEEN 91 AND 93;
DELETE FROM town.axis WHERE axis_id = 1;
SELECT 'with its axis the ring goes', NOT EXISTS (SELECT FROM town.roundabout WHERE accepted) AND NOT EXISTS (SELECT FROM town.roundabout_edge JOIN town.roundabout USING (roundabout_id) WHERE accepted);
UPDATE anew.axis SET direction = 'reverse' WHERE axis_id = 1;
SELECT 'a direction of the source stays', NOT EXISTS (SELECT FROM anew.lane l JOIN anew.edge USING (edge_id) WHERE axis_id = 1 AND l.along_axis);

-- Junctions of a ring that no source tags.
DO $$ BEGIN PERFORM streetgen.create_model('kinds', 2154, subjects => '{junction,roundabout}', driving_side => 'right'); END $$;
CALL draw_double('kinds', false);
SELECT 'junctions of an accepted ring are roundabouts', (SELECT count(*) = 6 AND bool_and(j.kind = 'roundabout') FROM kinds.roundabout_arm JOIN kinds.junction_node USING (node_id) JOIN kinds.junction j USING (junction_id));
UPDATE kinds.roundabout_editing SET confirmed = false;
SELECT 'those of a refused one are none', NOT EXISTS (SELECT FROM kinds.junction WHERE kind = 'roundabout');
DELETE FROM kinds.roundabout_editing;
SELECT 'they are again as the decision is taken back', (SELECT count(*) = 6 AND bool_and(j.kind = 'roundabout') FROM kinds.roundabout_arm JOIN kinds.junction_node USING (node_id) JOIN kinds.junction j USING (junction_id));
SELECT 'and a run over all leaves what edits made of junctions', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('kinds') WHERE relation LIKE 'junction%';
SELECT streetgen.switch_subject('kinds', 'roundabout', false) \g /dev/null
SELECT 'without roundabouts the tags of the source decide', NOT EXISTS (SELECT FROM kinds.junction WHERE kind = 'roundabout');

-- Signals in mid-block of an arm, and on a ring that no source tags.
DO $$ BEGIN
  PERFORM streetgen.create_model(name, 2154, subjects => '{interconnection,junction,roundabout}',
    driving_side => 'right') FROM unnest('{signalled,signalled_anew}'::name[]) name;
  INSERT INTO signalled.axis (axis_id, geom, width, lane_count, importance, roundabout_tag)
    VALUES (1, circle(0, 0, 20), 6, 1, 4, 'roundabout'), (2, circle(900, 0, 50), 7, 2, 4, NULL);
  INSERT INTO signalled.axis (axis_id, geom, width, lane_count, importance)
    SELECT 10 * n + a, arm(900 * (n - 1), 0, radius, 120 * a, 220), 6, 2, 4
    FROM (VALUES (1, 20), (2, 50)) r(n, radius), generate_series(0, 2) a;
END $$;
-- The ring of an axis: is it accepted, how many edges it has, its arms by axis and place, kinds of junctions on it.
CREATE FUNCTION ring_of(axis bigint) RETURNS text LANGUAGE sql AS $$
  SELECT format('%s, edges %s, arms %s, junctions %s', CASE WHEN accepted THEN 'accepted' ELSE 'none' END,
    (SELECT count(*) FROM signalled.roundabout_edge n WHERE n.roundabout_id = r.roundabout_id),
    (SELECT string_agg(format('%s:%s-%s', axis_id, round(start_abscissa), round(end_abscissa)), ' ' ORDER BY axis_id)
      FROM signalled.roundabout_arm a JOIN signalled.edge USING (edge_id) WHERE a.roundabout_id = r.roundabout_id),
    (SELECT string_agg(j.kind, ' ' ORDER BY j.kind) FROM signalled.junction_node JOIN signalled.node n USING (node_id)
      JOIN signalled.junction j USING (junction_id) WHERE ST_DWithin(n.geom, r.geom, 0.01)))
  FROM signalled.roundabout r WHERE EXISTS (SELECT FROM signalled.roundabout_edge n JOIN signalled.edge e
    ON e.edge_id = n.edge_id WHERE n.roundabout_id = r.roundabout_id AND axis_id = axis) $$;
CREATE FUNCTION ring_places() RETURNS bigint LANGUAGE sql AS
  $$ SELECT count(*) FROM streetgen.export_symuvia('signalled') WHERE line LIKE '%<GIRATOIRE %' $$;
CREATE FUNCTION followed() RETURNS boolean LANGUAGE sql AS $$ SELECT test.followed('signalled', 'signalled_anew') $$;
CREATE TABLE unsignalled AS SELECT axis, ring_of(axis) AS ring FROM generate_series(1, 2) axis;
SELECT 'without signals both rings have three arms', ring_places() = 2 AND array_agg(ring ORDER BY axis) = ARRAY[
    'accepted, edges 3, arms 10:0-220 11:0-220 12:0-220, junctions roundabout roundabout roundabout',
    'accepted, edges 3, arms 20:0-220 21:0-220 22:0-220, junctions roundabout roundabout roundabout']
  FROM unsignalled;
INSERT INTO signalled.control_point (geom, kind) VALUES ('SRID=2154;POINT(650150 6860000)', 'signals');
SELECT 'signals on an arm leave it the piece at the ring', ring_places() = 2 AND followed()
  AND ring_of(1) = replace(ring, '10:0-220', '10:0-130') FROM unsignalled WHERE axis = 1;
UPDATE signalled.axis SET geom = ST_Reverse(geom) WHERE axis_id = 10;
SELECT 'also where the arm is drawn to the ring', followed()
  AND ring_of(1) = replace(ring, '10:0-220', '10:90-220') FROM unsignalled WHERE axis = 1;
UPDATE signalled.control_point SET geom = 'SRID=2154;POINT(650180 6860000)';
SELECT 'moved they move its end', followed()
  AND ring_of(1) = replace(ring, '10:0-220', '10:60-220') FROM unsignalled WHERE axis = 1;
UPDATE signalled.axis SET geom = ST_Reverse(geom) WHERE axis_id = 10;
DELETE FROM signalled.control_point;
SELECT 'without them the arm is whole', ring_places() = 2 AND followed() AND ring_of(1) = ring
  FROM unsignalled WHERE axis = 1;
INSERT INTO signalled.control_point (geom, kind, direction)
  SELECT ST_StartPoint(arm(900, 0, 50, 36)), 'signals', 'direct';
SELECT 'signals on a ring stand on a node of it, and it stays one', followed()
  AND ring_of(2) = replace(ring, 'edges 3', 'edges 4') || ' signals' FROM unsignalled WHERE axis = 2;
SELECT 'on all its pieces traffic goes round', count(*) = 8 AND bool_and(l.along_axis AND NOT both_ways)
  FROM signalled.lane l JOIN signalled.edge USING (edge_id) WHERE axis_id = 2;
SELECT 'and each arm still yields', count(*) = 3
  FROM signalled.marking JOIN signalled.edge USING (edge_id) WHERE axis_id BETWEEN 20 AND 22 AND kind = 'yield';
UPDATE signalled.control_point SET geom = ST_StartPoint(arm(900, 0, 50, 300)), direction = NULL;
SELECT 'moved to another side too', followed()
  AND ring_of(2) = replace(ring, 'edges 3', 'edges 4') || ' signals' FROM unsignalled WHERE axis = 2;
UPDATE signalled.axis SET roundabout_tag = 'roundabout' WHERE axis_id = 2;
SELECT 'a ring that its source tags is not cut', followed() AND ring_of(2) = ring FROM unsignalled WHERE axis = 2;
UPDATE signalled.axis SET roundabout_tag = NULL WHERE axis_id = 2;
DELETE FROM signalled.control_point;
SELECT 'without them it is as before', followed() AND ring_of(2) = ring FROM unsignalled WHERE axis = 2;
-- A road goes on behind an arm, and a street comes to it: that junction is within reach of the signals on the arm.
INSERT INTO signalled.axis (axis_id, geom, width, lane_count, importance)
  VALUES (30, 'SRID=2154;LINESTRING(650240 6860000, 650400 6860000)', 6, 2, 4);
INSERT INTO signalled.control_point (geom, kind) VALUES ('SRID=2154;POINT(650210 6860000)', 'signals');
SELECT 'signals far from the next junction cut an arm', followed() AND ring_of(1) LIKE '% arms 10:0-190 11%';
INSERT INTO signalled.axis (axis_id, geom, width, lane_count, importance)
  VALUES (31, 'SRID=2154;LINESTRING(650255 6860000, 650255 6860100)', 6, 2, 4);
SELECT 'a junction that comes within their reach makes it whole', followed()
  AND ring_of(1) LIKE '% arms 10:0-220 11%';
DELETE FROM signalled.axis WHERE axis_id = 31;
SELECT 'and parts it again as it goes', followed() AND ring_of(1) LIKE '% arms 10:0-190 11%';
