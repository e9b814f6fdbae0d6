\set ECHO none
\ir shared/truths.sql
-- Lanes beside lanes: which, where, and to which place one changes.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154);
  PERFORM streetgen.set('town', 'transition_length', '0');
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000,650100 6860100,650180 6860180)', 14, 4, 'both', 3),
    (2, 'SRID=2154;LINESTRING(649900 6860000,650000 6860000)', 7, 2, 'direct', 3), (3, 'SRID=2154;LINESTRING(650000 6860000,650000 6860090)', 6, 2, 'both', 4);
END $$;
SELECT 'each two lanes side by side have a row for each of them' AS name, (SELECT count(*) FROM town.lane_adjacency) = 2 * (SELECT sum(n - 1) FROM (SELECT count(*) AS n FROM town.lane GROUP BY edge_id) l) AS holds;
SELECT 'there and back are two rows of one place', NOT EXISTS (SELECT FROM town.lane_adjacency a WHERE NOT EXISTS (SELECT FROM town.lane_adjacency b WHERE (b.lane_a, b.lane_b, b.start_abscissa, b.end_abscissa) = (a.lane_b, a.lane_a, a.start_abscissa, a.end_abscissa) AND a.side <> b.side));
SELECT 'intervals of one side do not overlap', NOT EXISTS (SELECT FROM town.lane_adjacency GROUP BY lane_a, side HAVING count(*) > 1);
SELECT 'the middle of a two-way street parts the directions', (SELECT count(*) = 2 FROM town.lane_adjacency JOIN town.lane ON lane_id = lane_a JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND change = 'opposite');
SELECT 'lanes of one direction allow a change', (SELECT count(*) = 4 FROM town.lane_adjacency JOIN town.lane ON lane_id = lane_a JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND change = 'allowed')
  AND (SELECT bool_and(change = 'allowed') FROM town.lane_adjacency JOIN town.lane ON lane_id = lane_a JOIN town.edge USING (edge_id) WHERE axis_id = 2);
SELECT 'the intervals of the paper lie within 0 and 1', (SELECT bool_and(s >= -1e-9 AND e <= 1 + 1e-9 AND os >= -1e-9 AND oe <= 1 + 1e-9 AND s < e AND os < oe) FROM town.lane_interval);
SELECT 'a lane begins and ends at the limits of its section', (SELECT bool_and(abs(x.start_abscissa - e.start_abscissa - l.abscissa) < 1e-9) FROM town.lane_extent x JOIN town.edge e USING (edge_id) JOIN town.section_limit l ON (l.edge_id, l.which) = (x.edge_id, 'start'));
CREATE TABLE changed AS SELECT l.lane_id, l.edge_id, l.lane_position, l.geom, m.metres, s.side, b.lane_id AS beside, b.metres AS at
  FROM town.lane l CROSS JOIN LATERAL (SELECT ST_Length(l.geom) * g / 97.0 AS metres FROM generate_series(0, 97) g) m CROSS JOIN (VALUES ('left'), ('right')) s(side)
  CROSS JOIN LATERAL streetgen.lane_beside('town', l.lane_id, m.metres, s.side) b;
SELECT 'beside lies the next lane of that side', (SELECT bool_and(o.edge_id = c.edge_id AND o.lane_position = c.lane_position + CASE c.side WHEN 'left' THEN -1 ELSE 1 END) FROM changed c JOIN town.lane o ON o.lane_id = c.beside);
SELECT 'there and back is the same place', (SELECT bool_and(b.lane_id = c.lane_id AND abs(b.metres - c.metres) < 1e-6) FROM changed c, LATERAL streetgen.lane_beside('town', beside, at, CASE c.side WHEN 'left' THEN 'right' ELSE 'left' END) b);
SELECT 'farther on stays farther on', (SELECT bool_and(at >= before - 1e-9) FROM (SELECT at, lag(at) OVER (PARTITION BY lane_id, side ORDER BY metres) AS before FROM changed) c WHERE before IS NOT NULL);
SELECT 'on a straight piece the two places face each other', (SELECT bool_and(ST_Distance(ST_LineInterpolatePoint(c.geom, c.metres / ST_Length(c.geom)), ST_LineInterpolatePoint(o.geom, least(c.at / ST_Length(o.geom), 1))) < 3.6)
  FROM changed c JOIN town.lane o ON o.lane_id = c.beside WHERE NOT EXISTS (SELECT FROM (VALUES ('SRID=2154;POINT(650100 6860000)'::geometry), ('SRID=2154;POINT(650100 6860100)')) v(geom) WHERE ST_DWithin(v.geom, ST_LineInterpolatePoint(c.geom, c.metres / ST_Length(c.geom)), 16)));
SELECT 'beside the outermost lane there is none', NOT EXISTS (SELECT FROM changed WHERE lane_position = 1 AND side = 'left');
SELECT 'a place off the lane is refused', test.state($q$SELECT * FROM streetgen.lane_beside('town', (SELECT min(lane_id) FROM town.lane), 1e6, 'left')$q$) = '22023';
SELECT 'NaN too', test.state($q$SELECT * FROM streetgen.lane_beside('town', (SELECT min(lane_id) FROM town.lane), 'NaN', 'left')$q$) = '22023';
SELECT 'a lane that is not there too', test.state($q$SELECT * FROM streetgen.lane_beside('town', -1, 0, 'left')$q$) = '22023';
SELECT 'another side too', test.state($q$SELECT * FROM streetgen.lane_beside('town', (SELECT min(lane_id) FROM town.lane), 0, 'up')$q$) = '22023';
SELECT 'NULL too', test.state($q$SELECT * FROM streetgen.lane_beside('town', NULL, 0, 'left')$q$) = '22004';
DROP TABLE changed;

-- What a source says of changing lanes.
INSERT INTO town.axis (axis_id, geom, width, lanes_forward, lanes_backward, change_forward, change_backward) OVERRIDING SYSTEM VALUE VALUES (9, 'SRID=2154;LINESTRING(650000 6861000,650100 6861000)', 17.5, 3, 2, 'no|not_left|', 'only_right|yes');
CREATE VIEW said AS SELECT a.along_axis, a.lane_position AS from_lane, b.lane_position AS to_lane, change FROM town.lane_adjacency JOIN town.lane a ON a.lane_id = lane_a JOIN town.lane b ON b.lane_id = lane_b JOIN town.edge e ON e.edge_id = a.edge_id WHERE axis_id = 9;
SELECT 'forward lanes 3, 4, 5: none leaves the first, the second to the right alone, the third as painted', array_agg(concat(from_lane, to_lane, ' ', change) ORDER BY from_lane, to_lane) = '{"34 forbidden","43 forbidden","45 allowed","54 allowed"}'
  FROM said WHERE along_axis AND change <> 'opposite';
SELECT 'backward lanes, from left to right 2 and 1', array_agg(concat(from_lane, to_lane, ' ', change) ORDER BY from_lane, to_lane) = '{"12 allowed","21 allowed"}' FROM said WHERE NOT along_axis AND change <> 'opposite';
UPDATE town.axis SET change_backward = 'no|no' WHERE axis_id = 9;
SELECT 'its paint says so, live as from scratch', (SELECT array_agg(format('%s %s', lane_position, dashed) ORDER BY lane_position) = '{"1 f","3 f","4 t"}' FROM town.lane_separator JOIN town.edge USING (edge_id) WHERE axis_id = 9 AND kind = 'same_direction') AND (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town'));
SELECT 'the line says who may cross it, seen along the axis', array_agg(format('%s %s %s %s', lane_position, kind, leftwards, rightwards) ORDER BY lane_position)
  = '{"1 same_direction f f","2 centre f f","3 same_direction f f","4 same_direction t t"}' FROM town.lane_separator JOIN town.edge USING (edge_id) WHERE axis_id = 9;
SELECT 'typed anew', bool_and(change = 'forbidden') FROM said WHERE NOT along_axis AND change <> 'opposite';
SELECT 'other words are refused', test.state($$UPDATE town.axis SET change_forward = 'maybe' WHERE axis_id = 9$$) = '23514';
-- By hand.
CREATE VIEW typed AS SELECT v.*, a.lane_position AS from_lane, b.lane_position AS to_lane FROM town.lane_adjacency_editing v JOIN town.lane a ON a.lane_id = lane_a JOIN town.lane b ON b.lane_id = lane_b JOIN town.edge e ON e.edge_id = a.edge_id WHERE axis_id = 1;
UPDATE town.lane_adjacency_editing SET change = 'forbidden' WHERE lane_adjacency_id = (SELECT lane_adjacency_id FROM typed WHERE (from_lane, to_lane) = (3, 4));
CREATE FUNCTION mark(lane integer) RETURNS text LANGUAGE sql AS $$ SELECT (xpath('//lane[@id = "' || lane || '"]/roadMark/@type', road))[1] || ' ' || (xpath('//lane[@id = "' || lane || '"]/roadMark/@laneChange', road))[1]
  FROM (SELECT string_agg(line, '' ORDER BY ordinality)::xml AS file FROM streetgen.export_opendrive('town')) f, LATERAL (SELECT (xpath('//road[userData[@code="edge" and @value="' || edge_id || '"]]', file))[1] AS road FROM town.edge WHERE axis_id = 1 LIMIT 1) r $$;
CREATE FUNCTION dashes(border integer) RETURNS text LANGUAGE sql AS $$ SELECT format('%s %s', dashed, count(*) FILTER (WHERE ST_Perimeter(d.geom) > 50)) FROM town.lane_separator s JOIN town.edge USING (edge_id), ST_Dump(s.surface) d WHERE axis_id = 1 AND lane_position = border GROUP BY s.lane_separator_id LIMIT 1 $$;
SELECT 'a solid line lies beside the dashed one, and OpenDRIVE says so', dashes(3) = 't 1' AND dashes(1) = 't 0' AND mark(-1) = 'solid broken increase' AND mark(1) = 'broken both';
SELECT 'a change forbidden to the right leaves the one to the left', (leftwards, rightwards) = (true, false) FROM town.lane_separator JOIN town.edge USING (edge_id) WHERE axis_id = 1 AND lane_position = 3 LIMIT 1;
UPDATE town.lane_adjacency_editing SET change = 'forbidden' WHERE lane_adjacency_id = (SELECT lane_adjacency_id FROM typed WHERE (from_lane, to_lane) = (4, 3));
SELECT 'forbidden both ways it is one solid line', dashes(3) = 'f 1' AND mark(-1) = 'solid none';
DELETE FROM town.lane_adjacency_editing WHERE lane_adjacency_id = (SELECT lane_adjacency_id FROM typed WHERE (from_lane, to_lane) = (4, 3));
SELECT 'and a run changes nothing for it', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town'));
SELECT 'a change typed holds one way', array_agg(concat(from_lane, to_lane, ' ', change, ' ', by_hand) ORDER BY from_lane, to_lane) = '{"12 allowed f","21 allowed f","34 forbidden t","43 allowed f"}' FROM typed WHERE change <> 'opposite';
SELECT 'the interval of the paper goes with it', NOT EXISTS (SELECT FROM town.lane_interval i JOIN typed t ON (t.lane_a, t.lane_b) = (i.lane_id, i.l) WHERE t.by_hand);
UPDATE town.axis SET geom = ST_Reverse(geom) WHERE axis_id = 1;
SELECT 'turned round the same lanes have it', array_agg(concat(from_lane, to_lane, ' ', change)) = '{"21 forbidden"}' FROM typed WHERE by_hand;
UPDATE town.axis SET geom = 'SRID=2154;LINESTRING(650180 6860180,650100 6860100,650100 6860050)' WHERE axis_id = 1;
INSERT INTO town.axis (axis_id, geom, width, lane_count, importance) OVERRIDING SYSTEM VALUE VALUES (8, 'SRID=2154;LINESTRING(650100 6860050,650100 6860000,650000 6860000)', 14, 4, 3);
SELECT 'a split leaves it on the piece where it lies', (SELECT count(*) = 1 FROM town.lane_adjacency_override o JOIN town.axis a USING (axis_id) WHERE ST_DWithin(o.geom, a.geom, 1e-6)) AND (SELECT count(*) = 1 FROM town.lane_adjacency WHERE by_hand);
UPDATE town.axis SET lane_count = 2 WHERE axis_id IN (1, 8);
SELECT 'one whose lanes are gone stays and is told', (SELECT count(*) = 1 FROM streetgen.check_model('town') WHERE rule = 'lane adjacency override without its lanes');
UPDATE town.axis SET lane_count = 4 WHERE axis_id IN (1, 8);
SELECT 'and holds again with them', (SELECT count(*) = 1 FROM town.lane_adjacency WHERE by_hand);
DELETE FROM town.lane_adjacency_editing WHERE by_hand;
SELECT 'deleted its line is dashed again', dashes(3) = 't 0' AND mark(-1) = 'broken both';
SELECT 'deleted it is as painted', (SELECT bool_and(change = 'allowed') FROM typed WHERE change <> 'opposite') AND NOT EXISTS (SELECT FROM town.lane_adjacency_override);
SELECT 'an edit that means nothing is refused: ' || name, test.state(statement) = state FROM (VALUES
  ('a change drawn', $$INSERT INTO town.lane_adjacency_editing (change) VALUES ('allowed')$$, '0A000'), ('another lane', 'UPDATE town.lane_adjacency_editing SET lane_b = lane_a', '0A000'), ('a line moved', 'UPDATE town.lane_adjacency_editing SET geom = ST_Translate(geom, 1, 1)', '0A000'),
  ('a word that is none', $$UPDATE town.lane_adjacency_editing SET change = 'perhaps' WHERE change = 'allowed'$$, '23514'), ('opposite', $$UPDATE town.lane_adjacency_editing SET change = 'opposite' WHERE change = 'allowed'$$, '22023'),
  ('to lanes against one', $$UPDATE town.lane_adjacency_editing SET change = 'allowed' WHERE change = 'opposite'$$, '22023')) v(name, statement, state);
UPDATE town.lane_adjacency_editing SET change = change, by_hand = by_hand;
SELECT 'what changes nothing writes nothing', NOT EXISTS (SELECT FROM town.lane_adjacency_override);
