\set ECHO none
\ir shared/truths.sql
-- Links: what traffic goes along, with courses that are smooth from lane to lane.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, subjects => '{junction,signal}', driving_side => 'right');
  INSERT INTO town.axis (axis_id, geom, width, lane_count, direction, importance, speed) OVERRIDING SYSTEM VALUE VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 14, 4, 'both', 2, 50), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860020)', 14, 4, 'both', 2, 50),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650100 6860090)', 6, 2, 'both', 4, 30), (4, 'SRID=2154;LINESTRING(650100 6860000,650110 6859900)', 4, 1, 'both', 5, 30),
    (5, 'SRID=2154;LINESTRING(650200 6860020,650300 6860025)', 14, 4, 'both', 2, 70);
  INSERT INTO town.control_point (kind, geom) VALUES ('signals', 'SRID=2154;POINT(650100 6860000)');
  PERFORM streetgen.generate('town', wait => true);
END $$;
SELECT 'each lane has a link in each of its directions' AS name, count(*) = count(DISTINCT link_id) AND bool_and(link_id = 4 * lane_id + along_axis::integer)
    AND count(*) = (SELECT sum(1 + both_ways::integer) FROM town.lane) AND count(*) FILTER (WHERE NOT along_axis) > 0 AS holds FROM town.link WHERE kind = 'lane';
SELECT 'each movement that connects has one', count(*) = (SELECT count(*) FROM town.movement WHERE connecting) AND count(DISTINCT link_id) = count(*) AND bool_and(link_id & 2 = 2) FROM town.link WHERE kind = 'movement';
SELECT 'a movement leads from the end of a lane to the beginning of another', bool_and(ST_Distance(ST_EndPoint(i.geom), ST_StartPoint(m.geom)) < 0.01 AND ST_Distance(ST_EndPoint(m.geom), ST_StartPoint(o.geom)) < 0.01
    AND m.from_node = i.to_node AND m.to_node = o.from_node AND m.speed = least(i.speed, o.speed)) FROM town.link m JOIN town.link i ON i.link_id = m.comes_from JOIN town.link o ON o.link_id = m.leads_to;
SELECT 'a lane knows the junction that it leads to', bool_and(junction_id = to_node) AND count(*) = 6 FROM town.link WHERE kind = 'lane' AND junction_id IS NOT NULL AND to_node = (SELECT controller_id FROM town.controller);

-- The courses of all, in one value.
CREATE TEMPORARY TABLE piece AS SELECT p.*, p.ends - p.starts AS length FROM streetgen._link_pieces(streetgen._network_of_links('town')) p;
CREATE TEMPORARY VIEW place AS SELECT *, CASE WHEN curvature = 0 THEN length ELSE 2 * sin(curvature * length / 2) / curvature END AS chord, heading + curvature * length / 2 AS direction FROM piece;
CREATE TEMPORARY TABLE course AS SELECT link_id, (array_agg(ST_Point(x, y) ORDER BY starts))[1] AS start, (array_agg(heading ORDER BY starts))[1] AS heading_from, max(ends) AS length,
  (array_agg(ST_Point(x + chord * cos(direction), y + chord * sin(direction)) ORDER BY starts DESC))[1] AS finish, (array_agg(heading + curvature * length ORDER BY starts DESC))[1] AS heading_to FROM place GROUP BY link_id;
SELECT 'each link has a course', count(*) = (SELECT count(*) FROM town.link) FROM course;
SELECT 'courses go on in place and heading from link to link', count(*) > 20 AND bool_and(ST_Distance(a.finish, b.start) < 1e-6 AND abs(sin((a.heading_to - b.heading_from) / 2)) < 1e-6)
  FROM (SELECT comes_from AS a, link_id AS b FROM town.link UNION ALL SELECT link_id, leads_to FROM town.link) j JOIN course a ON a.link_id = j.a JOIN course b ON b.link_id = j.b;
SELECT 'and within a link', bool_and(abs(sin((next - heading - curvature * length) / 2)) < 1e-6) FROM (SELECT *, lead(heading) OVER (PARTITION BY link_id ORDER BY starts) AS next FROM piece) p WHERE next IS NOT NULL;
SELECT 'a part of the network has the same courses', bool_and(length(streetgen._network_near_links('town', ARRAY[l.link_id])) < length(streetgen._network_of_links('town')))
    AND NOT bool_or(EXISTS (SELECT FROM streetgen._link_pieces(streetgen._network_near_links('town', ARRAY[l.link_id])) p WHERE p.link_id = l.link_id AND NOT EXISTS (
      SELECT FROM piece w WHERE w.link_id = p.link_id AND w.starts = p.starts AND abs(w.x - p.x) + abs(w.y - p.y) + abs(w.heading - p.heading) < 1e-9))) FROM (SELECT link_id FROM town.link ORDER BY md5(link_id::text) LIMIT 12) l;

CREATE TEMPORARY TABLE stored AS SELECT streetgen._network_of_links('town') AS bytes;
SELECT 'a network that a table holds is the same', NOT EXISTS (SELECT p.* FROM stored, streetgen._link_pieces(bytes) p EXCEPT SELECT link_id, starts, ends, x, y, heading, curvature FROM piece) FROM stored WHERE pg_column_size(bytes) > 2000;

-- A car on it.
SELECT 'a car stands on the line of its link', bool_and(ST_Distance(p.geom, ST_LineInterpolatePoint(l.geom, share)) < 0.3 AND ST_SRID(p.geom) = 2154)
  FROM town.link l, (VALUES (0), (0.3), (0.5), (1)) s(share), streetgen.link_at('town', link_id, length * share) p WHERE kind = 'lane';
SELECT 'its heading is that of the street', bool_and(abs(sind((p.heading - degrees(pi() / 2 - ST_Azimuth(ST_StartPoint(l.geom), ST_EndPoint(l.geom)))) / 2)) < 0.01 AND p.curvature = 0 AND p.steering = 0 AND p.grade IS NULL)
  FROM town.link l JOIN town.lane USING (lane_id) JOIN town.edge e USING (edge_id), streetgen.link_at('town', l.link_id, l.length / 2) p WHERE e.axis_id = 3;
SELECT 'the front wheels steer for the wheelbase', bool_and(abs(tand(p.steering) - 2.7 * p.curvature) < 1e-9 AND abs(tand(q.steering) - 6 * p.curvature) < 1e-9) AND bool_or(p.steering > 5) AND bool_or(p.steering < -5)
  FROM town.link, streetgen.link_at('town', link_id, length / 2) p, streetgen.link_at('town', link_id, length / 2, 6) q WHERE kind = 'movement';
SELECT 'an unknown link is refused', test.said($q$SELECT * FROM streetgen.link_at('town', 7000001, 0)$q$) = 'there is no link 7000001';
SELECT 'a place off the link too', test.said($q$SELECT * FROM streetgen.link_at('town', 4, 1e6)$q$) = 'link 4 has no place at 1000000 m';
SELECT 'NaN too', test.state($q$SELECT * FROM streetgen.link_at('town', 5, 'NaN')$q$) = '22023';
SELECT 'a wheelbase of 0 too', test.state($q$SELECT * FROM streetgen.link_at('town', 5, 1, 0)$q$) = '22023';
SELECT 'NULL too', test.state($q$SELECT * FROM streetgen.link_at('town', 5, NULL)$q$) = '22004';
SELECT 'bytes that are no network too', test.said($q$SELECT streetgen._link_frame('\x00', 5, 1, 2.7)$q$) = 'bytes that are no network of links'
    AND test.said($q$SELECT streetgen._link_frame(substr(streetgen._network_of_links('town'), 1, 500), 5, 1, 2.7)$q$) = 'bytes that are no network of links';

-- What signals show.
SELECT 'a movement is shown something in each state, and green now and then', count(*) > 5 AND bool_and(states = (SELECT count(*) FROM town.signal_state) AND greens > 0)
  FROM (SELECT lane_in, lane_out, count(*) AS states, count(*) FILTER (WHERE aspect IN ('permitted', 'protected')) AS greens FROM streetgen._movement_aspects('town', ARRAY(SELECT lane_id FROM town.lane)) GROUP BY 1, 2) a;

-- Heights, where a model knows them.
DO $$ BEGIN
  PERFORM streetgen.create_model('hill', 2154, 3, subjects => '{interconnection}', driving_side => 'right');
  INSERT INTO hill.axis (axis_id, geom, width, lane_count) OVERRIDING SYSTEM VALUE VALUES (1, 'SRID=2154;LINESTRING(650000 6860000 100,650100 6860000 104)', 7, 2);
  PERFORM streetgen.generate('hill', wait => true);
END $$;
SELECT 'a car climbs with its street', bool_and(abs(ST_Z(p.geom) - 102) < 1e-4 AND abs(abs(p.grade) - 0.04) < 1e-6) AND sum(p.grade) < 1e-6 AND count(*) = 2
  FROM hill.link, streetgen.link_at('hill', link_id, length / 2) p;
SELECT 'a model without junctions has links of its nodes', (SELECT count(*) FROM hill.link WHERE kind = 'lane') = 2 AND bool_and(junction_id IS NULL) FROM hill.link;
SELECT 'without interconnections there are no links', test.state($q$SELECT streetgen.switch_subject('hill', 'interconnection', false)$q$) = 'none' AND to_regclass('hill.link') IS NULL
    AND test.state($q$SELECT * FROM streetgen.link_at('hill', 5, 0)$q$) = '55000';
