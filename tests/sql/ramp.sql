\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Ramps: where a link meets a highway, tangent to its lanes, and the merging lanes there.
DO $$ BEGIN
  PERFORM streetgen.create_model('road', srid => 2154, subjects => '{ramp,junction,alignment}'), streetgen.create_model('fresh', srid => 2154, subjects => '{ramp,junction,alignment}');
  PERFORM set_config('streetgen_test.subjects', 'asked', true), streetgen.create_model('plain', srid => 2154);
END $$;
SELECT 'a model has ramps on demand alone', to_regclass('plain.ramp') IS NULL AND to_regclass('road.ramp') IS NOT NULL;
INSERT INTO road.axis (axis_id, geom, width, lane_count, direction, kind, speed) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000, 650600 6860000)', 10.5, 3, 'direct', 'motorway', 100),
    (2, 'SRID=2154;LINESTRING(650600 6860000, 651400 6860000)', 10.5, 3, 'direct', 'motorway', 100),
    (3, 'SRID=2154;LINESTRING(651400 6860000, 652000 6860000)', 10.5, 3, 'direct', 'motorway', 100),
    (4, 'SRID=2154;LINESTRING(650360 6859936, 650600 6860000)', 3.5, 1, 'direct', 'motorway_link', 50),
    (5, 'SRID=2154;LINESTRING(651400 6860000, 651640 6859936)', 3.5, 1, 'direct', 'motorway_link', 50);
SELECT 'a ramp on and a ramp off', array_agg((kind, side, lanes_before, lanes_ramp, lanes_after, lanes_missing, lanes_merging, auxiliary, cut, short_link)::text ORDER BY ST_X(geom))
    = '{"(on,right,3,1,3,1,1,f,f,f)","(off,right,3,1,3,1,1,f,f,f)"}' FROM road.ramp;
CREATE VIEW merging AS SELECT l.*, axis_id, e.start_abscissa AS edge_start, e.geom AS edge FROM road.lane l JOIN road.edge e USING (edge_id) WHERE l.kind = 'merging';
SELECT 'each has a lane on the highway between them', count(*) = 2 AND bool_and(axis_id = 2 AND side = 'right' AND along_axis AND abs(width - 3.5) < 1e-9) FROM merging;
SELECT 'the first begins at the limit and ends by a taper, the other the other way round', array_agg((start_abscissa IS NULL, end_abscissa IS NULL)::text ORDER BY ST_X(ST_StartPoint(geom))) = '{"(t,f)","(f,t)"}' FROM merging;
SELECT 'a lane keeps its width for merging_length, then tapers by taper_ratio', bool_and(abs(ST_Length(m.geom) - 60 - 30 * 3.5) < 1) FROM merging m;
SELECT 'their numbers follow those of the others', array_agg(ordinality ORDER BY ordinality) = '{4,5}' FROM merging;
SELECT 'the roadway is as wide as its lanes', abs(sum(ST_Area(l.surface)) - min(ST_Area(s.surface) + s.contested_area)) < 0.01 FROM road.lane l JOIN road.section s USING (edge_id) JOIN road.edge e USING (edge_id) WHERE axis_id = 2;
SELECT 'lane_extent says where each lies', count(*) = 2 AND bool_and(abs(x.end_abscissa - x.start_abscissa - ST_Length(m.geom)) < 1) FROM merging m JOIN road.lane_extent x USING (lane_id);
SELECT 'one may change to and from them as far as they go', count(*) = 4 AND bool_and(change = 'allowed' AND end_abscissa - start_abscissa BETWEEN 150 AND 175)
    FROM road.lane_adjacency a WHERE lane_a IN (SELECT lane_id FROM merging) OR lane_b IN (SELECT lane_id FROM merging);
SELECT 'from the middle of a merging lane one comes to the lane beside it', l.lane_position = m.lane_position - 1 AND abs(b.metres - ST_Length(m.geom) / 2) < 20
    FROM (SELECT * FROM merging ORDER BY ordinality LIMIT 1) m, streetgen.lane_beside('road', m.lane_id, ST_Length(m.geom) / 2, 'left') b JOIN road.lane l ON l.lane_id = b.lane_id;
SELECT 'ramps lead to merging lanes, and from them', count(*) = 2 AND bool_and('merging' IN (i.kind, o.kind)) FROM road.ramp_path p JOIN road.lane i ON i.lane_id = lane_in JOIN road.lane o ON o.lane_id = lane_out;
SELECT 'the highway goes on as one road past its ramps', count(*) = 3 AND count(DISTINCT road_id) = 1 FROM road.road_edge JOIN road.edge USING (edge_id) WHERE axis_id <= 3;
SELECT 'its surfaces need no union', count(*) FILTER (WHERE method = 'robust_fallback') = 0 FROM road.intersection;
SELECT 'nothing is wrong', count(*) = 0 FROM streetgen.check_model('road') WHERE severity <> 'notice';
SELECT 'lanes have ways on', count(*) = 0 FROM streetgen.check_model('road') WHERE rule ~ 'plausible way';
SELECT 'the summary counts them', array_agg(amount ORDER BY subject) = '{2,1,1}' FROM streetgen.summary('road') WHERE subject ~ '^ramps|^lanes, merging';
SELECT 'a second run changes no row', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('road');

-- What a class means is a row of axis_class: the words of BD TOPO, and those of a source of one's own, tell ramps as those of OpenStreetMap do.
DO $$ BEGIN PERFORM streetgen.create_model('topo', srid => 2154, subjects => '{ramp,junction}'); END $$;
INSERT INTO topo.axis_class (class, taken, highway_role) VALUES ('Schnellstraße', true, 'highway'), ('Ast', true, 'link');
INSERT INTO topo.axis (axis_id, geom, width, lane_count, direction, kind, speed)
  SELECT axis_id + shift, ST_Translate(geom, 0, 1000 * shift), width, lane_count, direction, CASE kind WHEN 'motorway' THEN highway ELSE link END, speed
  FROM road.axis, (VALUES (0, 'motorway', 'motorway_link'), (10, 'Type autoroutier', 'Bretelle'), (20, 'Schnellstraße', 'Ast')) v(shift, highway, link);
SELECT 'ramps are told by what a class means, whatever its word', count(*) = 6 AND count(DISTINCT (kind, side, lanes_before, lanes_ramp, lanes_after, lanes_merging, length, taper)) = 2 FROM topo.ramp;
SELECT 'so are their junctions', count(*) = 6 FROM topo.junction WHERE kind = 'ramp';
SELECT 'and who waits there', count(*) > 0 AND bool_and((a.kind IN ('motorway_link', 'Bretelle', 'Ast')) = (r.rule = 'yield'))
  FROM topo.right_of_way r JOIN topo.junction j USING (junction_id) JOIN topo.lane l ON l.lane_id = r.lane_in JOIN topo.edge e USING (edge_id) JOIN topo.axis a USING (axis_id) WHERE j.kind = 'ramp';
UPDATE topo.axis_class SET highway_role = NULL WHERE class = 'Ast';
SELECT 'a class that means something else makes its streets stale', count(*) = 2 FROM streetgen.check_model('topo') WHERE rule = 'stale: the axis changed since' AND id IN (24, 25);
SELECT 'the next run takes its ramps away', deleted = 2 FROM streetgen.generate('topo') WHERE relation = 'ramp';
SELECT 'and theirs alone', count(*) = 4 FROM topo.ramp;
UPDATE topo.axis SET speed = 100 WHERE axis_id = 22;
SELECT 'an edit afterwards too', count(*) = 4 FROM topo.ramp;

-- In files.
SELECT 'SUMO has an edge more for each merging lane, which ends there', array_agg(n ORDER BY since) = '{4,3,4}' FROM (
    SELECT (xpath('/edge/@numLanes', line::xml))[1]::text::integer AS n, (xpath('/edge/@from', line::xml))[1]::text LIKE 'middle%' AS inner_from, ordinality AS since
    FROM streetgen.export_sumo('road', 'edges') WHERE line LIKE '%<edge %' AND (xpath('/edge/@id', line::xml))[1]::text ~ ('^' || (SELECT edge_id FROM road.edge WHERE axis_id = 2) || '(\.|$)')) e;
SELECT 'OpenDRIVE knows them as entry and exit, without width where they are not', count(*) FILTER (WHERE line LIKE '%type="entry"%') = 1 AND count(*) FILTER (WHERE line LIKE '%type="exit"%') = 1
    FROM streetgen.export_opendrive('road') WHERE line LIKE '%<userData code="edge"%';
SELECT 'SymuVia lets the ramp go on to the lane beside', count(*) > 0 FROM streetgen.export_symuvia('road') WHERE line ~ 'TRONCON|troncon';

-- By hand.
UPDATE road.ramp_editing SET length = 100 WHERE kind = 'on';
SELECT 'a length typed holds there alone', array_agg((method, round(length))::text ORDER BY kind DESC) = '{"(by_hand,100)","(hypothesis,60)"}' FROM road.ramp;
UPDATE road.ramp_editing SET tangent = 40 WHERE kind = 'on';
SELECT 'what is typed later leaves it', (tangent, length) = (40, 100) FROM road.ramp_override;
SELECT 'both hold', (tangent, round(length)) = (40, 100) FROM road.ramp WHERE kind = 'on';
UPDATE road.axis SET geom = ST_Reverse(geom), direction = 'reverse' WHERE axis_id = 4;
SELECT 'a link turned round keeps what was decided', (method, tangent, round(length)) = ('by_hand', 40, 100) FROM road.ramp WHERE kind = 'on';
UPDATE road.axis SET geom = ST_Reverse(geom), direction = 'direct' WHERE axis_id = 4;
SELECT 'by_hand typed alone is refused', test.state($$UPDATE road.ramp_editing SET by_hand = true WHERE kind = 'off'$$) = '22023';
SELECT 'and decides nothing', count(*) = 1 AND NOT EXISTS (SELECT FROM road.ramp WHERE kind = 'off' AND method = 'by_hand') FROM road.ramp_override;
INSERT INTO road.ramp_override (axis_id, abscissa, length) SELECT axis_id, abscissa, 80 FROM road.ramp_override;
UPDATE road.ramp_editing SET length = NULL WHERE kind = 'on';
SELECT 'a length emptied does not come back from an older row', (method, tangent, round(length)) = ('by_hand', 40, 60) FROM road.ramp WHERE kind = 'on';
UPDATE road.ramp_editing SET tangent = NULL WHERE kind = 'on';
SELECT 'emptied altogether nothing is decided', method = 'hypothesis' AND NOT EXISTS (SELECT FROM road.ramp_override) FROM road.ramp WHERE kind = 'on';
UPDATE road.ramp_editing SET length = 100 WHERE kind = 'on';
DELETE FROM road.ramp_editing WHERE kind = 'on';
SELECT 'deleted in the view it is computed again', (method, tangent, round(length)) = ('hypothesis', 15, 60) AND NOT EXISTS (SELECT FROM road.ramp_override) FROM road.ramp WHERE kind = 'on';
INSERT INTO road.ramp_override (axis_id, abscissa, length) VALUES (5, 0, 0);
SELECT 'a length of nothing takes the lane away', (lanes_missing, lanes_merging, method) = (0, 0, 'by_hand') FROM road.ramp WHERE kind = 'off';
DELETE FROM road.ramp_override;
SELECT 'refused: ' || name, test.state(statement) = state FROM (VALUES
    ('a length beyond its range', 'UPDATE road.ramp_editing SET length = 1001', '22023'),
    ('a tangent that is no number', $$UPDATE road.ramp_editing SET tangent = 'NaN'$$, '22023'),
    ('another axis', 'UPDATE road.ramp_editing SET axis_id = 1', '0A000'),
    ('a merging lane widened', $$UPDATE road.lane_editing SET width = 4 WHERE lane_id IN (SELECT lane_id FROM merging)$$, '0A000'),
    ('a ramp drawn', 'INSERT INTO road.ramp_editing (axis_id) VALUES (1)', '0A000'),
    ('a length in the table that is no number', $$INSERT INTO road.ramp_override (axis_id, abscissa, length) VALUES (4, 0, 'NaN')$$, '23514')) r(name, statement, state);
INSERT INTO road.ramp_override (axis_id, abscissa, length) VALUES (1, 0, 10);
SELECT 'an override without its ramp is a row of check_model', count(*) = 1 FROM streetgen.check_model('road') WHERE rule = 'ramp override without its ramp';
DELETE FROM road.ramp_override;

-- A source forbids a change by its own lanes, and knows no merging lane.
UPDATE road.axis SET change_forward = 'yes|yes|no' WHERE axis_id = 2;
SELECT 'no word of a source keeps merging traffic from its way', count(*) = 4 AND bool_and(change = 'allowed') FROM road.lane_adjacency WHERE lane_a IN (SELECT lane_id FROM merging) OR lane_b IN (SELECT lane_id FROM merging);
SELECT 'between the other lanes the words hold', count(*) FILTER (WHERE change = 'forbidden') = 1 AND count(*) = 4 FROM road.lane_adjacency a JOIN road.lane l ON l.lane_id = lane_a JOIN road.lane r ON r.lane_id = lane_b
    JOIN road.edge e ON e.edge_id = l.edge_id WHERE axis_id = 2 AND 'merging' NOT IN (l.kind, r.kind);
UPDATE road.axis SET change_forward = NULL WHERE axis_id = 2;
SELECT 'no line on the ramp whose traffic has its lane', count(*) = 0 FROM road.marking WHERE kind IN ('stop', 'yield');
UPDATE road.axis SET lane_count = 4, width = 14 WHERE axis_id = 2;
SELECT 'nor where the highway has a lane more behind it', (lanes_before, lanes_after, lanes_merging) = (3, 4, 0) AND NOT EXISTS (SELECT FROM road.marking WHERE kind IN ('stop', 'yield')) FROM road.ramp WHERE kind = 'on';
UPDATE road.axis SET lane_count = 3, width = 10.5 WHERE axis_id = 2;
UPDATE road.axis SET kind = 'trunk', speed = 50 WHERE axis_id <= 3;
SELECT 'links of a slow trunk road are turning lanes, no ramps', NOT EXISTS (SELECT FROM road.ramp) AND NOT EXISTS (SELECT FROM merging) AND NOT EXISTS (SELECT FROM road.junction WHERE kind = 'ramp');
UPDATE road.axis SET speed = 60 WHERE axis_id <= 3;
SELECT 'from 60 km/h they are ramps', count(*) = 2 AND (SELECT count(*) = 2 FROM merging) FROM road.ramp;
UPDATE road.axis SET kind = 'motorway', speed = 100 WHERE axis_id <= 3;

-- Mirrored, and against its traffic.
DO $$ BEGIN
  PERFORM streetgen.create_model('left_hand', 2154, driving_side => 'left', subjects => '{ramp}'), streetgen.create_model('backwards', 2154, subjects => '{ramp}');
END $$;
CREATE FUNCTION pg_temp.mirrored(line geometry) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_Affine(line, 1, 0, 0, -1, 0, 2 * 6860000) $$;
INSERT INTO left_hand.axis (axis_id, geom, width, lane_count, direction, kind, speed) SELECT axis_id, pg_temp.mirrored(geom), width, lane_count, direction, kind, speed FROM road.axis;
INSERT INTO backwards.axis (axis_id, geom, width, lane_count, direction, kind, speed) SELECT axis_id, CASE axis_id WHEN 2 THEN ST_Reverse(geom) ELSE geom END, width, lane_count,
    CASE axis_id WHEN 2 THEN 'reverse' ELSE direction END, kind, speed FROM road.axis;
SELECT 'where one keeps left all is mirrored', (SELECT count(*) FROM left_hand.lane WHERE kind = 'merging') = 2 AND bool_and(EXISTS (SELECT FROM left_hand.lane l JOIN left_hand.edge f USING (edge_id)
    WHERE l.kind = r.kind AND f.axis_id = e.axis_id AND ST_HausdorffDistance(pg_temp.mirrored(l.geom), r.geom) < 1e-3 AND ST_Area(ST_SymDifference(pg_temp.mirrored(l.surface), r.surface)) < 0.01))
    FROM road.lane r JOIN road.edge e USING (edge_id);
SELECT 'an axis drawn against its traffic has the same lanes', bool_and(EXISTS (SELECT FROM backwards.lane l WHERE l.kind = r.kind AND ST_Area(ST_SymDifference(l.surface, r.surface)) < 0.01)) FROM road.lane r;
SELECT 'on its left, against it', count(*) = 2 AND bool_and(side = 'left' AND NOT along_axis) FROM backwards.lane WHERE kind = 'merging';
SELECT 'nothing is wrong with ' || name, NOT EXISTS (SELECT FROM streetgen.check_model(name::name) WHERE severity <> 'notice') FROM (VALUES ('left_hand'), ('backwards')) m(name);

-- Live: by any path the same.
CREATE FUNCTION agree(what text) RETURNS TABLE(said text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
  DELETE FROM fresh.axis;
  SET LOCAL streetgen.live = 'off';
  INSERT INTO fresh.ramp_override SELECT * FROM road.ramp_override;
  INSERT INTO fresh.lane_override SELECT * FROM road.lane_override;
  INSERT INTO fresh.axis SELECT * FROM road.axis;
  PERFORM streetgen.generate('fresh');
  SET LOCAL streetgen.live TO DEFAULT;
  RETURN QUERY SELECT what || ' as from scratch', test.same('road', 'fresh');
  DELETE FROM fresh.ramp_override;
  DELETE FROM fresh.lane_override;
END $$;
SELECT * FROM agree('ramps');
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650600 6860000, 650780 6860000)' WHERE axis_id = 2;
SELECT * FROM agree('a highway cut short');
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650600 6860000, 651400 6860000)' WHERE axis_id = 2;
SELECT * FROM agree('a highway joined again');
-- A highway in pieces: its lanes go on over nodes of two edges.
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650600 6860000, 650660 6860000)' WHERE axis_id = 2;
INSERT INTO road.axis (axis_id, geom, width, lane_count, direction, kind, speed) VALUES
    (7, 'SRID=2154;LINESTRING(650660 6860000, 650720 6860000)', 10.5, 3, 'direct', 'motorway', 100),
    (8, 'SRID=2154;LINESTRING(650720 6860000, 651400 6860000)', 10.5, 3, 'direct', 'motorway', 100);
CREATE VIEW on_lane AS SELECT axis_id, l.start_abscissa, l.end_abscissa, l.turn, l.geom FROM merging l WHERE ST_XMax(geom) < 651000;
SELECT 'a lane goes on over nodes of two edges', (SELECT (lanes_merging, cut) = (1, false) FROM road.ramp WHERE kind = 'on') AND array_agg(axis_id ORDER BY axis_id) = '{2,7,8}'
    AND abs(sum(ST_Length(geom)) - 60 - sqrt((30 * 3.5) ^ 2 + 1.75 ^ 2)) < 0.001 FROM on_lane;
SELECT 'it ends once', array_agg((start_abscissa IS NULL, end_abscissa IS NULL, turn)::text ORDER BY axis_id) = '{"(t,t,merge_to_left)","(t,t,merge_to_left)","(t,f,merge_to_left)"}' FROM on_lane;
SELECT 'the lanes lie end to end', ST_NumGeometries(ST_LineMerge(ST_Collect(geom))) = 1 AND abs(ST_Length(ST_LineMerge(ST_Collect(geom))) - 60 - sqrt((30 * 3.5) ^ 2 + 1.75 ^ 2)) < 0.001 FROM on_lane;
SELECT 'traffic stays in its lane over a node', count(*) = 2 FROM road.interconnection i JOIN merging a ON a.lane_id = lane_in JOIN merging b ON b.lane_id = lane_out WHERE plausible;
SELECT 'in SUMO too', count(*) = 2 FROM (SELECT (xpath('/connection/@from', line::xml))[1]::text AS f, (xpath('/connection/@to', line::xml))[1]::text AS t, (xpath('/connection/@fromLane', line::xml))[1]::text AS lane
    FROM streetgen.export_sumo('road', 'connections') WHERE line LIKE '%<connection %') c
    JOIN road.edge e ON f ~ ('^' || e.edge_id || '(\.|$)') WHERE axis_id IN (2, 7) AND lane = '0' AND t !~ ('^' || e.edge_id || '(\.|$)');
SELECT streetgen.create_model('pieces', 2154, subjects => '{ramp}') \g /dev/null
INSERT INTO pieces.axis SELECT * FROM road.axis WHERE axis_id NOT IN (3, 5);
SELECT 'in OpenDRIVE its three pieces and what joins them are entries, and each leads to the next', count(*) FILTER (WHERE line LIKE '%type="entry"%') = 4
    AND sum(cardinality(regexp_split_to_array(line, 'from="-4" to="-|type="entry" level="false"><link><successor id="-4"')) - 1) = 2
    FROM streetgen.export_opendrive('pieces');
SELECT 'nothing is wrong with a highway in pieces', NOT EXISTS (SELECT FROM streetgen.check_model('road') WHERE severity <> 'notice' OR rule ~ 'merging');
SELECT * FROM agree('a highway in pieces');
UPDATE road.ramp_editing SET length = 130 WHERE kind = 'on';
SELECT 'a longer lane changes further edges alone', abs(sum(ST_Length(geom)) - 130 - sqrt((30 * 3.5) ^ 2 + 1.75 ^ 2)) < 0.001 FROM on_lane;
SELECT * FROM agree('a longer lane');
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650360 6859936, 650480 6859968)' WHERE axis_id = 4;
INSERT INTO road.axis (axis_id, geom, width, lane_count, direction, kind, speed) VALUES (9, 'SRID=2154;LINESTRING(650480 6859968, 650600 6860000)', 3.5, 1, 'direct', 'motorway_link', 50);
SELECT 'what is decided of a ramp goes to the piece of a split link that is there', (SELECT array_agg(axis_id) = '{9}' FROM road.ramp_override) AND (SELECT (method, round(length)) = ('by_hand', 130) FROM road.ramp WHERE kind = 'on');
SELECT * FROM agree('a split link');
DELETE FROM road.axis WHERE axis_id = 9;
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650360 6859936, 650600 6860000)' WHERE axis_id = 4;
SELECT 'and comes back to the link made one again', (SELECT array_agg(axis_id) = '{4}' FROM road.ramp_override) AND (SELECT (method, round(length)) = ('by_hand', 130) FROM road.ramp WHERE kind = 'on');
UPDATE road.axis SET lane_count = 2, width = 7 WHERE axis_id = 7;
SELECT 'where the highway changes it ends', (cut, lanes_merging) = (true, 1) AND (SELECT array_agg(axis_id) = '{2}' FROM on_lane) FROM road.ramp WHERE kind = 'on';
SELECT * FROM agree('a highway that changes');
UPDATE road.axis SET lane_count = 3, width = 10.5 WHERE axis_id = 7;
SELECT * FROM agree('a highway as before');
UPDATE road.axis SET geom = ST_Translate(geom, 0, 9) WHERE axis_id = 4;
SELECT 'with its link it goes from all edges', NOT EXISTS (SELECT FROM on_lane) AND NOT EXISTS (SELECT FROM road.ramp WHERE kind = 'on');
SELECT * FROM agree('a link that is off');
UPDATE road.axis SET geom = ST_Translate(geom, 0, -9) WHERE axis_id = 4;
SELECT 'and comes back with it', count(*) = 3 FROM on_lane;
SELECT * FROM agree('a link that is on');
SET streetgen.live = 'off';
DELETE FROM fresh.axis;
INSERT INTO fresh.ramp_override SELECT * FROM road.ramp_override;
INSERT INTO fresh.axis SELECT * FROM road.axis;
RESET streetgen.live;
SELECT 'by clusters too', streetgen.plan_clusters('fresh', 4) > 1;
SELECT streetgen.generate_cluster('fresh') FROM generate_series(1, 4) \g /dev/null
SELECT 'a run by clusters as one run', test.same('road', 'fresh');
DELETE FROM fresh.ramp_override;
DELETE FROM road.ramp_editing WHERE by_hand;
DELETE FROM road.axis WHERE axis_id IN (7, 8);
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650600 6860000, 651400 6860000)' WHERE axis_id = 2;
SELECT * FROM agree('a highway in one piece');

UPDATE road.ramp_editing SET length = 450;
SELECT 'two that meet are one auxiliary lane', bool_and(auxiliary) AND (SELECT count(*) = 1 AND bool_and(start_abscissa IS NULL AND end_abscissa IS NULL) FROM merging) FROM road.ramp;
SELECT 'each shows the length that was typed, and the lane its own', bool_and(length = 450) AND (SELECT bool_and(length > 500) FROM road.ramp) FROM road.ramp_editing;
SELECT * FROM agree('an auxiliary lane');
-- What somebody decided of ramps goes with a schema that is renamed and adopted.
ALTER SCHEMA road RENAME TO moved;
SELECT streetgen.adopt_model('moved') \g /dev/null
SELECT 'an adopted model keeps ramps by hand', (SELECT count(*) = 2 AND bool_and(length = 450) FROM moved.ramp_override) AND (SELECT bool_and(method = 'by_hand' AND auxiliary) FROM moved.ramp) AND (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('moved'));
UPDATE moved.ramp_editing SET length = 440 WHERE kind = 'on';
SELECT 'and follows edits of them', (SELECT array_agg(length ORDER BY length) = '{440,450}' FROM moved.ramp_override) AND (SELECT bool_and(auxiliary) FROM moved.ramp);
ALTER SCHEMA moved RENAME TO road;
SELECT streetgen.adopt_model('road') \g /dev/null
SELECT * FROM agree('an adopted model');
DELETE FROM road.ramp_editing WHERE kind = 'off';
UPDATE road.axis SET lane_count = 2 WHERE axis_id = 4;
SELECT 'two lanes of a ramp are two merging lanes', (lanes_missing, lanes_merging) = (2, 2) FROM road.ramp WHERE kind = 'on';
SELECT * FROM agree('another number of lanes');
INSERT INTO road.lane_override (axis_id, abscissa, ordinality, along_axis) VALUES (4, 100, 2, false);
SELECT 'a lane of it turned round by hand is none that merges', (lanes_ramp, lanes_merging) = (1, 1) FROM road.ramp WHERE kind = 'on';
SELECT * FROM agree('a lane turned round');
UPDATE road.lane_override SET along_axis = NULL, width = 2.5;
SELECT 'one made narrow is', (lanes_ramp, lanes_merging) = (2, 2) FROM road.ramp WHERE kind = 'on';
SELECT * FROM agree('a narrow lane');
DELETE FROM road.lane_override;
SELECT * FROM agree('lanes as they were');
UPDATE road.axis SET lane_count = NULL WHERE axis_id = 4;
SELECT 'where lanes are estimated none is missing', lanes_missing = 0 FROM road.ramp WHERE kind = 'on';
UPDATE road.axis SET lane_count = 1 WHERE axis_id = 4;
INSERT INTO road.axis (axis_id, geom, width, lane_count, direction, kind, speed) VALUES (6, 'SRID=2154;LINESTRING(650690 6859900, 650690 6860000)', 6, 2, 'both', 'secondary', 50);
UPDATE road.axis SET geom = 'SRID=2154;LINESTRING(650600 6860000, 650690 6860000, 651400 6860000)' WHERE axis_id = 2;
SELECT 'one cut by the next junction is reported', count(*) = 1 FROM streetgen.check_model('road') WHERE rule = 'merging lane cut by the next junction, m';
SELECT * FROM agree('a lane that is cut');
DELETE FROM road.axis WHERE axis_id = 4;
SELECT 'with the link its ramp and its lane go', count(*) = 1 AND (SELECT count(*) = 1 FROM merging) FROM road.ramp;
SELECT * FROM agree('a link that is gone');
UPDATE road.axis SET kind = 'residential' WHERE axis_id = 5;
SELECT 'a street of another class is no ramp', count(*) = 0 FROM road.ramp;
SELECT * FROM agree('another class');
SELECT 'switched off, nothing of it stays', to_regclass('road.ramp') IS NULL FROM streetgen.switch_subject('road', 'ramp', false);
SELECT 'and no lane is a merging lane', count(*) = 0 FROM streetgen.generate('road'), road.lane WHERE kind = 'merging';

-- A link that turns by 70 degrees within its intersection: arcs that touch both lanes would cross its inner kerb.
DO $$ BEGIN PERFORM streetgen.create_model('loop', srid => 2154, subjects => '{ramp}'); END $$;
INSERT INTO loop.axis (geom, width, lane_count, direction, kind, speed) VALUES
    ('SRID=2154;LINESTRING(649900 6860040, 650000 6860000)', 10.5, 3, 'direct', 'motorway', 100),
    ('SRID=2154;LINESTRING(650000 6860000, 650020 6859990, 650100 6859950)', 10.5, 3, 'direct', 'motorway', 100),
    ('SRID=2154;LINESTRING(650000 6860000, 650012 6859994, 650021 6859985, 650024 6859974, 650022 6859940)', 6, 2, 'direct', 'motorway_link', 50);
CREATE TEMPORARY TABLE chord AS
SELECT interconnection_id, ST_Azimuth(lag(d.geom) OVER w, d.geom) AS before, ST_Azimuth(d.geom, lead(d.geom) OVER w) AS behind
    FROM loop.ramp_path p JOIN loop.interconnection c USING (interconnection_id), ST_DumpPoints(p.geom) d WINDOW w AS (PARTITION BY interconnection_id ORDER BY d.path);
SELECT 'paths along such a link have no kink', count(DISTINCT interconnection_id) = 2 AND bool_and(cos(behind - before) > cos(radians(5))) FROM chord;
SELECT 'and stay on its ground', bool_and(ST_Length(ST_Difference(p.geom, ST_Buffer(i.surface, 1e-6))) < 1e-6) FROM loop.ramp_path p JOIN loop.interconnection c USING (interconnection_id) JOIN loop.intersection i USING (node_id);
-- A narrow link that turns at once: only a path past its kerbs has room.
DELETE FROM loop.axis WHERE kind = 'motorway_link';
INSERT INTO loop.axis (geom, width, direction, kind, speed) VALUES ('SRID=2154;LINESTRING(650000 6860000, 650006 6859997, 650011 6859980, 650003 6859940)', 4, 'direct', 'motorway_link', 50);
SELECT 'the control points of such paths lie by them', count(*) > 0 AND bool_and(ST_DWithin(control, geom, 100)) FROM loop.interconnection;
