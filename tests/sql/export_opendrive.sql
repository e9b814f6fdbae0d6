\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
\ir shared/made_design.sql
-- Files of OpenDRIVE: a road for each edge and each movement, with every lane; and chains of lines and arcs.  (name, holds)
SELECT 'a line is a line', (SELECT (count(*), min(length), min(curvature), min(heading)) = (1, 50, 0, 0) FROM streetgen.plan_view('LINESTRING(0 0,20 0,50 0)'));
SELECT 'a kink becomes an arc', (SELECT array_agg(sign(curvature) ORDER BY s) = '{0,-1,0}' FROM streetgen.plan_view('LINESTRING(0 0,50 0,80 -40)', 0.1));
SELECT 'a piece begins where the one before ends', (SELECT bool_and(abs(before - s) < 1e-9) FROM (SELECT s, lag(s + length) OVER (ORDER BY s) AS before FROM streetgen.plan_view('LINESTRING(0 0,50 0,80 -40,90 20)')) p);
SELECT 'no line, and a tolerance of nothing, are refused', test.state($$SELECT FROM streetgen.plan_view('POINT(0 0)')$$) = '22023' AND test.state($$SELECT FROM streetgen.plan_view('LINESTRING(0 0,0 0)')$$) = '22023'
  AND test.state($$SELECT FROM streetgen.plan_view('LINESTRING(0 0,1 0)', 0)$$) = '22023' AND test.state($$SELECT FROM streetgen.plan_view('LINESTRING(0 0,1 0)', 'NaN')$$) = '22023' AND test.state($$SELECT FROM streetgen.plan_view('LINESTRING(0 0,NaN 0)')$$) = '22023';
SELECT 'a path is as few arcs as it needs', (SELECT count(*) = 2 AND min(abs(1 / nullif(curvature, 0))) > 9 FROM streetgen.path_view('LINESTRING(0 0,3.83 0.76,7.07 2.93,9.24 6.17,10 10,10 14)', 0, pi() / 2));
SELECT 'its arcs are wider than half the lane', (SELECT bool_and(abs(curvature) < 1 / 3.9) FROM streetgen.path_view('LINESTRING(0 0,30 0)', 0.6, 0, 8));
SELECT 'a path that is none, and a lane of no width, are refused', test.state($$SELECT FROM streetgen.path_view('POINT(0 0)', 0, 0)$$) = '22023' AND test.state($$SELECT FROM streetgen.path_view('LINESTRING(0 0,1 0)', 0, 0, 0)$$) = '22023'
  AND test.state($$SELECT FROM streetgen.path_view('LINESTRING(0 0,1 0)', 'NaN', 0)$$) = '22023' AND NOT EXISTS (SELECT FROM streetgen.path_view('LINESTRING(0 0,1 0)', NULL, 0));
SELECT 'a part beyond its road, of no chain, or before it, is refused: ' || since, test.state(format('SELECT FROM streetgen._road_part(%1$L, %1$L, %1$L, %1$L, %2$L, %1$L, %1$L, ''{0,10}'', ''{1,1,-1,-1}'', %3$s, 20)', zero, length, since)) = '22023'
  FROM (VALUES ('{0}', '{10}', 10.0), ('{}', '{}', 0), ('{0}', '{0}', 1), ('{0}', '{10}', -1)) v(zero, length, since);
SELECT 'a path between places without x, y and heading is refused', test.state($$SELECT FROM streetgen._path_view(ST_AsEWKB('LINESTRING(0 0,1 1)'::geometry), '{}', '{1,1,1}', 0.1, 3)$$) = '22023' AND test.state($$SELECT FROM streetgen._path_view(ST_AsEWKB('LINESTRING(0 0,1 1)'::geometry), '{0,0,0}', '{1,1,1}', 0.1, 3)$$) = 'none';
SELECT 'heights at stations that do not increase are refused', test.state($$SELECT streetgen._height_curve('{0,0,1}', '{1,2,3}', 0.01)$$) = '22023' AND test.state($$SELECT streetgen._height_curve('{0,1}', '{1,2}', 0.01)$$) = 'none';
SELECT 'NULL for anything is no row', NOT EXISTS (SELECT FROM streetgen.plan_view(NULL)) AND NOT EXISTS (SELECT FROM streetgen.plan_view('LINESTRING(0 0,1 0)', NULL));
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('left_town', 2154, driving_side => 'left'), streetgen.create_model('bare', 2154, subjects => '{}');
  INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward, importance, name) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650050 6860005,650100 6860000)', 14, 'both', 'general|bus', 2, E'<"Rue" & \x01d''Ab>'),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 14, 'both', NULL, 2, NULL),
    (3, 'SRID=2154;LINESTRING(650100 6860100,650100 6860000)', 9, 'direct', 'general|cycle|parking', 6, NULL),
    (4, 'SRID=2154;LINESTRING(650200 6860000,650300 6860050)', 7, 'both', NULL, 2, NULL),
    (5, 'SRID=2154;LINESTRING(650100 6860000,650100 6859900)', 3, 'both', NULL, 6, 'both ways');
  INSERT INTO left_town.axis SELECT * FROM town.axis;
END $$;
CREATE FUNCTION pg_temp.file(model name, options jsonb DEFAULT '{}') RETURNS xml LANGUAGE sql AS $$
  SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_opendrive(model, options) $$;
CREATE FUNCTION pg_temp.found(path text, file xml) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, file)) $$;
CREATE FUNCTION pg_temp.texts(path text, file xml) RETURNS text[] LANGUAGE sql AS $$ SELECT array_agg(x::text ORDER BY x::text COLLATE "C") FROM unnest(xpath(path, file)) x $$;
CREATE TEMPORARY TABLE written AS SELECT pg_temp.file('town') AS file, pg_temp.file('left_town') AS on_left;
SELECT 'there is a road for each edge', pg_temp.found('//road[@junction="-1"]', file) = (SELECT count(*) FROM town.edge) FROM written;
SELECT 'and a connecting road for each interconnection that connects', pg_temp.found('//road[@junction!="-1"]', file) = (SELECT count(*) FROM town.interconnection WHERE connecting) FROM written;
SELECT 'every lane is there, with its kind', pg_temp.texts('//road[@junction="-1"]//lane[@id!="0"]/@type', file) = (SELECT array_agg(t ORDER BY t COLLATE "C") FROM (SELECT streetgen._opendrive_lane_type(kind, both_ways) AS t FROM town.lane) l) FROM written;
SELECT 'ids of roads and junctions are numbers of 32 bits, each once', (SELECT count(DISTINCT id) = count(*) AND bool_and(id::bigint BETWEEN 1 AND 2147483647) FROM unnest(pg_temp.texts('//road/@id|//junction/@id', file)) id) FROM written;
SELECT 'a road has the id of its edge', (SELECT bool_and(pg_temp.texts('//road[userData[@code="edge" and @value="' || edge_id || '"]]/@id', file) = ARRAY[streetgen._file_id('edge', edge_id)::text]) FROM town.edge) FROM written;
SELECT 'a connecting road that of its interconnection', (SELECT bool_and(pg_temp.texts('//road[userData[@code="interconnection" and @value="' || interconnection_id || '"]]/@id', file) = ARRAY[streetgen._file_id('interconnection', interconnection_id)::text]) FROM town.interconnection WHERE connecting) FROM written;
SELECT 'ids of kinds are disjoint, those of parts too', count(DISTINCT streetgen._file_id(kind, id, part)) = count(*) FROM (VALUES ('node', 1), ('object', 1), ('lane', 4), ('entry', 2), ('edge', 10), ('movement', 10), ('bridge', 2), ('tunnel', 2), ('interconnection', 32)) k(kind, parts), generate_series(0, parts - 1) part, generate_series(1, 5) id;
SELECT 'they lie within 31 bits', streetgen._file_id('node', 1) > 0 AND streetgen._file_id('interconnection', 33554431, 31) = 2147483647;
SELECT 'an id beyond, a part beyond and a kind unknown are refused', bool_and(test.state('SELECT streetgen._file_id(' || what || ')') = '22003') FROM unnest(ARRAY['''edge'', 33554432', '''edge'', 0', '''node'', 1, 1', '''edge'', 1, -1', '''edge'', 1, 10', '''car'', 1']) what;
SELECT 'a connecting road is one of its junction', (SELECT bool_and(pg_temp.found('//junction[@id="' || j || '"]/connection[@connectingRoad="' || r || '"]', file) = 1)
  FROM unnest(xpath('//road[@junction!="-1"]', file)) x, LATERAL (SELECT (xpath('/road/@id', x))[1]::text AS r, (xpath('/road/@junction', x))[1]::text AS j) i) FROM written;
SELECT 'lanes are linked in the junction as in the road', (SELECT bool_and(pg_temp.found('//connection[@connectingRoad="' || r || '" and @incomingRoad="' || i || '"]/laneLink[@from="' || p || '" and @to="-1"]', file) = 1)
  FROM unnest(xpath('//road[@junction!="-1"]', file)) x, LATERAL (SELECT (xpath('/road/@id', x))[1]::text AS r, (xpath('/road/link/predecessor/@elementId', x))[1]::text AS i, (xpath('//lane/link/predecessor/@id', x))[1]::text AS p) l) FROM written;
SELECT 'roads lead to junctions that are there', (SELECT bool_and(pg_temp.found('//junction[@id="' || j || '"]', file) = 1) FROM unnest(pg_temp.texts('//road[@junction="-1"]/link/*/@elementId', file)) j) FROM written;
SELECT 'one drives on the side that the model says', pg_temp.texts('//road/@rule', file) @> '{RHT}' AND NOT pg_temp.texts('//road/@rule', file) @> '{LHT}' AND NOT pg_temp.texts('//road/@rule', on_left) @> '{RHT}' FROM written;
SELECT 'a one-way street has lanes of one side', pg_temp.found('//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@id < 0]', file) = 3 AND pg_temp.found('//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@id > 0]', on_left) = 3 FROM written, town.edge WHERE axis_id = 3;
SELECT 'lengths are those of the pieces', (SELECT bool_and(abs((xpath('/road/@length', x))[1]::text::float8 - (xpath('sum(//geometry/@length)', x))[1]::text::float8) < 1e-5) FROM unnest(xpath('//road', file)) x) FROM written;
SELECT 'coordinates are near zero', (SELECT bool_and(x::float8 BETWEEN -1 AND 400) FROM unnest(pg_temp.texts('//geometry/@x', file)) x) AND pg_temp.texts('//offset/@x', file) = '{650000}' FROM written;
SELECT 'the projection is told', (xpath('string(//geoReference)', file))[1]::text LIKE '%+proj=lcc%' FROM written;
SELECT 'a name keeps what XML can hold', (xpath('string(//road[userData[@code="edge" and @value="1"]]/@name)', file))[1]::text = (xpath('string(/n/@m)', '<n m="&lt;&quot;Rue&quot; &amp; d''Ab&gt;"/>'))[1]::text FROM written;
SELECT 'widths at the beginning of roads are those of the lanes', (SELECT bool_and(abs(f.width - l.width) <= 0.01) FROM town.lane l JOIN town.edge USING (edge_id),
    LATERAL (SELECT (xpath('(//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@id != 0])[' || lane_position || ']/width[1]/@a', file))[1]::text::float8 AS width) f WHERE axis_id IN (1, 2, 3)) FROM written;
SELECT 'lines between lanes are marks, and edges of fast roads', pg_temp.found('//road[@junction="-1"]//roadMark[@type="broken" or @type="solid"]', file) = (SELECT count(*) FROM town.lane_separator) + (SELECT 2 * count(*) FROM town.edge WHERE speed >= 70) FROM written;
SELECT 'a part of the town has whole edges, and no way out of them', pg_temp.found('//road', f) = 1 AND pg_temp.found('//junction', f) = 0 FROM pg_temp.file('town', '{"extent": [650240, 6860000, 650300, 6860050]}') f;
SELECT 'the version as asked for', pg_temp.texts('//header/@revMinor', pg_temp.file('town', '{"version": "1.6"}')) = '{6}' AND pg_temp.texts('//header/@revMinor', file) = '{7}' FROM written;
SELECT 'the same bytes again', file::text = pg_temp.file('town')::text FROM written;
SELECT 'bad options are refused: ' || bad, test.state(format($$SELECT FROM streetgen.export_opendrive('town', %L)$$, bad)) = '22023' FROM unnest(ARRAY['{"colour": 1}', '{"version": "1.4"}', '{"tolerance": 0}', '{"extent": [0, 0, 1, 1]}', '{"two_way_lanes": "biking"}', '{"georeference": 2154}']) bad;
SELECT 'a model without interconnections is refused, and one without junctions that are asked for', test.state($$SELECT FROM streetgen.export_opendrive('bare')$$) = '55000' AND test.state($$SELECT FROM streetgen.export_opendrive('town', '{"junctions": "group"}')$$) = '55000';
-- Lanes for both directions as a lane each way, and coordinates about the origin.
CREATE TEMPORARY TABLE each_way AS SELECT f.name, pg_temp.file(f.name, '{"two_way_lanes": "driving"}') AS file FROM unnest('{town,left_town}'::name[]) f(name);
SELECT name || ': a lane for both directions is one each way', pg_temp.found('//lane[@type="bidirectional"]', file) = 0 AND pg_temp.texts('//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@type="driving"]/@id', file) = '{-1,1}' FROM each_way, town.edge WHERE axis_id = 5;
SELECT name || ': each is half as wide', (SELECT array_agg(DISTINCT w::text::float8) FROM unnest(xpath('//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@type="driving"]/width/@a', file)) w) = '{1.5}' FROM each_way, town.edge WHERE axis_id = 5;
SELECT name || ': ways lead from and to the half of their direction', (SELECT array_agg(DISTINCT n ORDER BY n) FROM unnest(pg_temp.texts('//connection[@incomingRoad="' || r.id || '"]/laneLink/@from', file)) n) = '{1}' AND (SELECT array_agg(DISTINCT n ORDER BY n) FROM unnest(pg_temp.texts('//road[link/successor/@elementId="' || r.id || '"]//lane/link/successor/@id', file)) n) = '{-1}'
  FROM each_way, town.edge, streetgen._file_id('edge', edge_id) r(id) WHERE axis_id = 5 AND name = 'town'
  UNION ALL SELECT name || ': ways lead from and to the half of their direction', (SELECT array_agg(DISTINCT n ORDER BY n) FROM unnest(pg_temp.texts('//connection[@incomingRoad="' || r.id || '"]/laneLink/@from', file)) n) = '{-1}' AND (SELECT array_agg(DISTINCT n ORDER BY n) FROM unnest(pg_temp.texts('//road[link/successor/@elementId="' || r.id || '"]//lane/link/successor/@id', file)) n) = '{1}'
  FROM each_way, town.edge, streetgen._file_id('edge', edge_id) r(id) WHERE axis_id = 5 AND name = 'left_town';
SELECT name || ': as many lanes as before, and those', pg_temp.found('//road[@junction="-1"]//lane[@id!="0"]', file) = (SELECT count(*) + count(*) FILTER (WHERE both_ways) FROM town.lane) FROM each_way;
CREATE TEMPORARY TABLE about_origin AS SELECT pg_temp.file('town', '{"georeference": "local"}') AS file;
SELECT 'a local file counts from 0 on a projection about its origin', pg_temp.texts('//offset/@x|//offset/@y', file) = '{0,0}' AND (xpath('string(//geoReference)', file))[1]::text LIKE '+proj=tmerc +lat_0=48.%' FROM about_origin;
SELECT 'its roads lie where they do on earth', max(ST_Distance(ST_Transform(ST_SetSRID(ST_Point(l[1], l[2]), 0), (xpath('string(//geoReference)', about_origin.file))[1]::text, 2154), ST_SetSRID(ST_Point(650000 + m[1], y + m[2]), 2154))) < 0.001
  FROM about_origin, written, LATERAL (SELECT (xpath('number(//offset/@y)', written.file))[1]::text::float8 AS y) o, unnest(pg_temp.texts('//road/@id', written.file)) id,
    LATERAL (SELECT ARRAY(SELECT (xpath('number(//road[@id="' || id || '"]//geometry[1]/@' || a || ')', about_origin.file))[1]::text::float8 FROM unnest('{x,y}'::text[]) a)) p(l),
    LATERAL (SELECT ARRAY(SELECT (xpath('number(//road[@id="' || id || '"]//geometry[1]/@' || a || ')', written.file))[1]::text::float8 FROM unnest('{x,y}'::text[]) a)) q(m);
-- Two roads that meet lane to lane are joined, where nobody waits.
SELECT FROM streetgen.create_model('in_line', 2154, subjects => '{interconnection,object}', driving_side => 'right') \g /dev/null
INSERT INTO in_line.axis (axis_id, geom, width, direction) SELECT i, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 100 * i, 6860000), ST_MakePoint(650100 + 100 * i, 6860000)), 2154), CASE i WHEN 3 THEN 8 ELSE 7 END, 'both' FROM generate_series(1, 5) i;
INSERT INTO in_line.axis (axis_id, geom, width, direction) VALUES (6, 'SRID=2154;LINESTRING(650600 6860030,650620 6860030,650620 6860010,650600 6860000)', 4, 'direct'), (7, 'SRID=2154;LINESTRING(650600 6860000,650600 6860030)', 7, 'both');
INSERT INTO in_line.street_object (type, geom, axis_id, abscissa, axis_offset) VALUES ('crossing', 'SRID=2154;POINT(650500 6860000)', 4, 100, 0);
CREATE TEMPORARY TABLE in_line_file AS SELECT pg_temp.file('in_line') AS file;
CREATE FUNCTION pg_temp.road_of(axis bigint) RETURNS text LANGUAGE sql AS $$ SELECT '//road[@id="' || streetgen._file_id('edge', edge_id) || '"]' FROM in_line.edge WHERE axis_id = axis $$;
SELECT 'roads of one width are joined', pg_temp.found(pg_temp.road_of(1) || '/link/successor[@elementType="road" and @contactPoint="start"]', file) = 1 AND pg_temp.found(pg_temp.road_of(2) || '/link/predecessor[@elementType="road" and @contactPoint="end"]', file) = 1 FROM in_line_file;
SELECT 'lane to lane, either way', pg_temp.texts(pg_temp.road_of(1) || '//lane/link/successor/@id', file) = '{-1,1}' AND pg_temp.texts(pg_temp.road_of(2) || '//lane/link/predecessor/@id', file) = '{-1,1}' FROM in_line_file;
SELECT 'those of two widths by a junction', pg_temp.found(pg_temp.road_of(2) || '/link/successor[@elementType="junction"]', file) = 1 AND pg_temp.found(pg_temp.road_of(4) || '/link/predecessor[@elementType="junction"]', file) = 1 FROM in_line_file;
SELECT 'also where people cross', pg_temp.found(pg_temp.road_of(4) || '/link/successor[@elementType="junction"]', file) = 1 FROM in_line_file;
-- Roads are cut back at one end, and have the height of the axis at the other one.
SELECT FROM streetgen.create_model('sloping', 2154, 3) \g /dev/null
INSERT INTO sloping.axis (geom, width) SELECT ST_Translate(ST_MakeLine(ST_SetSRID(ST_MakePoint(v.x, 0, 100), 2154),
        ST_SetSRID(ST_MakePoint(v.x + v.dx, v.dy, 103), 2154)), 650000, 6860000 + 40 * i), 7
    FROM generate_series(1, 40) i, LATERAL (VALUES (0, 50, 0), (50, 30 + 0.7 * i, 0.03 * i)) v(x, dx, dy);
SELECT 'no road reaches beyond its edge, by a rounding', count(*) = 80 AND bool_and(share_from >= 0 AND share_to <= 1)
    FROM streetgen._opendrive_roads('sloping', streetgen._export_options('opendrive', '{}'), false) WHERE NOT connecting;
SELECT 'roads with heights are written: ' || format, test.state('SELECT FROM streetgen.export_' || format || '(''sloping'')') = 'none'
    FROM unnest('{opendrive,lanelet2}'::text[]) format;
SELECT FROM streetgen.create_model('beyond', 2154, driving_side => 'right') \g /dev/null
SELECT setval(pg_get_serial_sequence('beyond.edge', 'edge_id'), 5000000000) \g /dev/null
INSERT INTO beyond.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7);
SELECT 'so is a model with an edge beyond 32 bits', test.state($$SELECT FROM streetgen.export_opendrive('beyond')$$) = '22003';
-- A lane that lies among those of the other direction.
SELECT FROM streetgen.create_model('wide', 2154, subjects => '{interconnection,junction}', driving_side => 'right') \g /dev/null
INSERT INTO wide.axis (axis_id, geom, width, direction) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 'direct'), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 'direct'),
    (3, 'SRID=2154;LINESTRING(650200 6860010,650100 6860010)', 7, 'direct'), (4, 'SRID=2154;LINESTRING(650100 6860010,650000 6860010)', 7, 'direct'),
    (5, 'SRID=2154;LINESTRING(650100 6859900,650100 6860000)', 7, 'both'), (6, 'SRID=2154;LINESTRING(650100 6860000,650100 6860010)', 7, 'both'), (7, 'SRID=2154;LINESTRING(650100 6860010,650100 6860100)', 7, 'both');
SELECT 'the nodes of a junction are one, its movements the connecting roads', pg_temp.found('//road[@junction!="-1"]', f) = (SELECT count(*) FROM wide.movement WHERE connecting) AND pg_temp.found('//junction', f) = 1
  AND pg_temp.found('//road[userData[@code="edge" and @value="6"]]', f) = 0 FROM pg_temp.file('wide', '{"junctions": "group"}') f;
-- What stands beside lanes: signals with their programs, signs, objects, sidewalks, and the junctions of a ring.
SELECT FROM streetgen.create_model('busy', 2154, subjects => '{interconnection,sidewalk,roundabout,signal,object}', driving_side => 'right') \g /dev/null
INSERT INTO busy.axis (axis_id, geom, width, importance, roundabout_tag, direction) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 8, 2, NULL, 'both'), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 8, 2, NULL, 'both'),
  (3, 'SRID=2154;LINESTRING(650100 6859900,650100 6860000)', 8, 2, NULL, 'both'), (4, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 8, 2, NULL, 'both'), (5, 'SRID=2154;LINESTRING(650050 6860080,650050 6860000)', 6, 6, NULL, 'both'),
  (6, ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(650220 + 20 * cos(pi() + i * pi() / 6), 6860000 + 20 * sin(pi() + i * pi() / 6)) FROM generate_series(0, 12) i)), 2154), 6, 2, 'roundabout', 'direct'), (7, 'SRID=2154;LINESTRING(650240 6860000,650300 6860000)', 8, 2, NULL, 'both');
INSERT INTO busy.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 'signals');
UPDATE busy.axis SET speed = 50;
INSERT INTO busy.street_object (type, geom, axis_id, abscissa, axis_offset) VALUES ('lamp', 'SRID=2154;POINT(650020 6860006)', 1, 20, 6), ('crossing', 'SRID=2154;POINT(650150 6860000)', 2, 50, 0);
INSERT INTO busy.object_type (type, parent) VALUES ('oak', 'tree');
INSERT INTO busy.street_object (type, geom, placement) VALUES ('oak', 'SRID=2154;POINT(650102 6860003)', 'absolute'), ('bench', 'SRID=2154;POINT(650330 6860001)', 'absolute');
CREATE TEMPORARY TABLE busy_file AS SELECT pg_temp.file('busy') AS file;
SELECT 'each lane that waits has a signal, and one controller has it', pg_temp.found('//signal[@dynamic="yes"]', file) = (SELECT count(*) FROM busy.signal_head) AND pg_temp.found('//signal[@dynamic="yes"]', file) = pg_temp.found('//controller/control', file)
  AND (SELECT bool_and(pg_temp.found('//controller/control[@signalId="' || id || '"]', file) = 1) FROM unnest(pg_temp.texts('//signal[@dynamic="yes"]/@id', file)) id) FROM busy_file;
SELECT 'two streets that cross have two greens', pg_temp.texts('//controller/userData[@code="green"]/@value', file) = (SELECT array_agg(ordinality::text ORDER BY ordinality::text) FROM busy.signal_state WHERE kind = 'green') FROM busy_file;
SELECT 'the junction has the controllers and the program', pg_temp.found('//junction/controller', file) = 2 AND pg_temp.found('//junction[controller]', file) = 1 AND (xpath('string(//junction/userData[@code="program"]/@value)', file))[1]::text LIKE 'cycle %: 1 green %' FROM busy_file;
SELECT 'a street that gives way has a sign on the right of who comes', pg_temp.texts('//road[userData[@code="edge" and @value="' || edge_id || '"]]//signal[@type!="274"]/@orientation', file) = '{+}' AND (xpath('number(//road[userData[@code="edge" and @value="' || edge_id || '"]]//signal[@type!="274"]/@t)', file))[1]::text::float8 = -3.5 FROM busy_file, busy.edge WHERE axis_id = 5;
SELECT 'objects have their type, that of their parent, and their place', pg_temp.texts('//object[@type!="roadMark"]/@type', file) = '{crosswalk,obstacle,streetLamp,tree}' AND (xpath('number(//object[@type="streetLamp"]/@t)', file))[1]::text::float8 = 6 FROM busy_file;
SELECT 'each stop and yield line is an object, of the lane that waits', count(*) > 0 AND count(*) = pg_temp.found('//object[@subtype="signalLines"]', min(file::text)::xml) AND bool_and(pg_temp.found('//object[@name="' || m.kind || ' line" and @id="' || streetgen._file_id('lane', lane_id, 2 + m.along_axis::integer) || '"]/validity', file) = 1)
  FROM busy_file, busy.marking m JOIN busy.lane USING (edge_id, lane_position) WHERE m.kind <> 'arrow' AND NOT ST_IsEmpty(m.surface);
SELECT 'one within a junction, and one beyond all roads, too', pg_temp.found('//road[@junction!="-1"]//object[@name="oak"]', file) = 1 AND pg_temp.found('//object[@name="bench"]//cornerLocal', file) >= 4
  AND (xpath('number(//object[@name="bench"]//cornerLocal/@u)', file))[1]::text::float8 > 25 FROM busy_file;
SELECT 'sidewalks are raised lanes', pg_temp.found('//lane[@type="sidewalk" and height[@inner="0.15"]]', file) = (SELECT count(DISTINCT (edge_id, side)) FROM busy.sidewalk WHERE side IN ('left', 'right') AND node_id IS NULL) FROM busy_file;
SELECT 'the junctions of a ring are a group', pg_temp.found('//junctionGroup[@type="roundabout"]', file) = 1 AND pg_temp.found('//junctionReference', file) = 2 FROM busy_file;
SELECT 'a part of it has what stands there', pg_temp.found('//object', f) = 1 AND pg_temp.found('//controller', f) = 0 FROM pg_temp.file('busy', '{"extent": [650000, 6859999, 650010, 6860001]}') f;
-- A designed road has the elements of its alignment, also where a street was cut out of them, and a smoothed edge its arcs.
SELECT test.make_design('designed') \g /dev/null
SELECT FROM streetgen.design('designed', stages => '{paths,horizontal,vertical,structures,axes}'), streetgen.generate('designed') \g /dev/null
CREATE TEMPORARY TABLE piece AS SELECT (xpath('name(/geometry/*)', g))[1]::text AS kind, n[1] AS x, n[2] AS y, n[3] AS length, coalesce((xpath('/geometry/spiral/@curvStart', g))[1]::text::float8, 0) AS curvature_start, coalesce((xpath('/geometry/spiral/@curvEnd', g))[1]::text::float8, 0) AS curvature_end,
    ST_SetSRID(ST_Point(n[1] + (xpath('number(//offset/@x)', f))[1]::text::float8, n[2] + (xpath('number(//offset/@y)', f))[1]::text::float8), 2154) AS place
  FROM pg_temp.file('designed') f, unnest(xpath('//road[@junction="-1"]//geometry', f)) g, LATERAL (SELECT ARRAY(SELECT (xpath('/geometry/@' || a, g))[1]::text::float8 FROM unnest(ARRAY['x', 'y', 'length']) WITH ORDINALITY u(a, k) ORDER BY k)) v(n);
SELECT 'clothoids are spirals that change as those of the alignment', count(*) > 4 AND bool_and(EXISTS (SELECT FROM designed.alignment_element e WHERE e.kind = 'clothoid' AND abs(abs((e.curvature_end - e.curvature_start) / e.length) - abs((p.curvature_end - p.curvature_start) / p.length)) < 1e-8)) FROM piece p WHERE kind = 'spiral';
SELECT 'one that no street cuts is there whole, where it begins or ends', count(*) > 4 FROM designed.alignment_element e WHERE kind = 'clothoid' AND EXISTS (SELECT FROM piece p WHERE kind = 'spiral' AND abs(p.length - e.length) < 1e-3 AND abs(p.curvature_start - e.curvature_start) < 1e-9 AND abs(p.curvature_end - e.curvature_end) < 1e-9 AND ST_DWithin(p.place, e.start, 1e-3));
SELECT 'each piece begins on the alignment', bool_and((SELECT min(ST_Distance(p.place, ST_Force2D(streetgen._alignment_line(streetgen._link_elements('designed', design_link_id), '{}', 2154, 0, 'Infinity', 1e-4)::geometry))) < 1e-3 FROM designed.design_link)) FROM piece p;
SELECT FROM streetgen.create_model('bent', 2154), streetgen.set('bent', 'smoothing', 'arcs') \g /dev/null
INSERT INTO bent.axis (geom, width) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000,650180 6860060,650300 6860060)', 7);
SELECT 'the arcs of a smoothed edge are those of its curve', count(*) = 2 AND (SELECT array_agg(round((1 / radius)::numeric, 6) ORDER BY r.start_abscissa) FROM bent.edge, streetgen._arc_road_stretches(curve) r WHERE radius IS NOT NULL) = array_agg(round(abs(c::text::float8)::numeric, 6))
  FROM pg_temp.file('bent') f, unnest(xpath('//arc/@curvature', f)) c;
UPDATE bent.axis SET geom = 'SRID=2154;LINESTRING(650000 6860000,650100 6860000,650000 6860005,650300 6860060)';
SELECT 'an edge whose curve keeps a kink is a chain without one', pg_temp.found('//road[@junction="-1"]', f) = 1 FROM pg_temp.file('bent') f;
CREATE TEMPORARY TABLE designed_here AS SELECT pg_temp.file('designed', '{"georeference": "local"}') AS file;
SELECT 'alignments have their spirals about the origin too', pg_temp.found('//spiral', file) = pg_temp.found('//spiral', pg_temp.file('designed')) FROM designed_here;
SELECT 'and go on without a gap', count(*) > 4 AND bool_and(abs(x + length * cos(heading) - next_x) < 0.001 AND abs(y + length * sin(heading) - next_y) < 0.001)
  FROM (SELECT *, lead(x) OVER w AS next_x, lead(y) OVER w AS next_y FROM (SELECT k, n, cardinality(xpath('/geometry/line', piece)) = 1 AS line, v[1] AS x, v[2] AS y, v[3] AS heading, v[4] AS length FROM designed_here, unnest(xpath('//road', file)) WITH ORDINALITY r(road, k), unnest(xpath('/road/planView/geometry', road)) WITH ORDINALITY g(piece, n),
    LATERAL (SELECT ARRAY(SELECT (xpath('/geometry/@' || a, piece))[1]::text::float8 FROM unnest(ARRAY['x', 'y', 'hdg', 'length']) WITH ORDINALITY u(a, k) ORDER BY k)) c(v)) p WINDOW w AS (PARTITION BY k ORDER BY n)) p WHERE line AND next_x IS NOT NULL;
SELECT FROM streetgen.create_model('beside', 2154, subjects => '{ramp,junction,alignment,sidewalk}', driving_side => 'right') \g /dev/null
INSERT INTO beside.axis (axis_id, geom, width, lane_count, direction, kind, speed, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650600 6860000)', 10.5, 3, 'direct', 'motorway', 110, 0, 2),
    (2, 'SRID=2154;LINESTRING(650600 6860000,651400 6860000)', 10.5, 3, 'direct', 'motorway', 110, 0, 2), (3, 'SRID=2154;LINESTRING(650300 6859900,650500 6859970,650600 6860000)', 3.5, 1, 'direct', 'motorway_link', 60, 0, 2);
SELECT 'a sidewalk lies outside of a merging lane', pg_temp.texts('//road[userData[@code="edge" and @value="2"]]//lane[@id="-4"]/@type', f) = '{entry}' AND pg_temp.texts('//road[userData[@code="edge" and @value="2"]]//lane[@id="-5"]/@type', f) = '{sidewalk}' FROM pg_temp.file('beside') f;
-- Types of roads, lines at the edges of fast ones, bridges and tunnels.
SELECT FROM streetgen.create_model('fast', 2154, subjects => '{interconnection,sidewalk,bridge}', driving_side => 'right') \g /dev/null
INSERT INTO fast.axis (axis_id, geom, width, direction, kind, speed, level, lane_markings) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650400 6860000)', 7, 'both', 'trunk', 90, 0, NULL), (2, 'SRID=2154;LINESTRING(650400 6860000,650500 6860000)', 7, 'both', 'primary', 50, 0, NULL),
  (3, 'SRID=2154;LINESTRING(650000 6860300,650400 6860300)', 10.5, 'direct', 'motorway', 60, 0, NULL), (4, 'SRID=2154;LINESTRING(650000 6860400,650400 6860400)', 7, 'both', 'secondary', 80, 0, 'no'), (5, 'SRID=2154;LINESTRING(650000 6860500,650400 6860500)', 6, 'both', 'residential', 30, -1, NULL),
  (6, 'SRID=2154;LINESTRING(650000 6860600,650400 6860600)', 4, 'both', 'pedestrian', NULL, 0, NULL), (7, 'SRID=2154;LINESTRING(650200 6859900,650200 6860100)', 7, 'both', 'secondary', 50, 1, NULL), (8, 'SRID=2154;LINESTRING(650500 6860000,650600 6860000)', 7, 'both', 'primary', 50, 0, NULL);
CREATE TEMPORARY TABLE fast_file AS SELECT pg_temp.file('fast') AS file;
CREATE FUNCTION pg_temp.fast(axis bigint, path text) RETURNS text[] LANGUAGE sql AS $$ SELECT pg_temp.texts('//road[userData[@code="edge" and @value="' || edge_id || '"]]' || path, file) FROM fast_file, fast.edge WHERE axis_id = axis $$;
SELECT 'a road has the type of its class and speed', (SELECT array_agg(kind[1] ORDER BY i) FROM generate_series(1, 7) i, pg_temp.fast(i, '/type/@type') kind) = '{rural,town,motorway,rural,lowSpeed,pedestrian,town}';
SELECT 'fast roads have solid lines at both edges', pg_temp.fast(1, '//lane[@id="1" or @id="-1"]/roadMark/@type') = '{solid,solid}' AND pg_temp.fast(3, '//lane[@id="0" or @id="-2"]/roadMark/@type') = '{solid,solid}';
SELECT 'other ones have none, nor those without lane markings', pg_temp.fast(2, '//lane[@id="1" or @id="-1"]/roadMark/@type') = '{none,none}' AND pg_temp.fast(4, '//lane[@id="1" or @id="-1"]/roadMark/@type') = '{none,none}';
SELECT 'a sign stands where a speed begins or changes', (SELECT array_agg(DISTINCT v) FROM unnest(pg_temp.fast(1, '//signal[@type="274"]/@value')) v) = '{90.0}' AND pg_temp.fast(1, '//signal[@type="274" and @s="0.0000"]/@orientation') = '{+}' AND pg_temp.fast(1, '//signal[@type="274" and @s!="0.0000"]/@orientation') = '{-}'
  AND pg_temp.fast(2, '//signal[@value="50.0" and @subtype="50" and @unit="km/h"]/@orientation') = '{+}' AND pg_temp.fast(8, '//signal/@orientation') = '{-}';
SELECT 'on the right of who comes, for the lanes by which he does', pg_temp.fast(2, '//signal/@t') = '{-4.0000}' AND pg_temp.fast(2, '//signal/validity/@fromLane') = '{-1}' AND pg_temp.fast(8, '//signal/@t') = '{4.0000}' AND pg_temp.fast(3, '//signal/validity/@*') = '{-1,-2}';
SELECT 'none for people on foot', pg_temp.fast(6, '//signal/@id') IS NULL;
SELECT 'bridges and tunnels lie along their road', (SELECT count(*) FROM fast.bridge b JOIN fast.edge USING (edge_id), LATERAL (SELECT pg_temp.fast(axis_id, '//bridge[@id="' || streetgen._file_id('bridge', bridge_id) || '"]/@length')) l(length) WHERE abs(length[1]::float8 - (b.end_abscissa - b.start_abscissa)) < 0.01) = (SELECT count(*) FROM fast.bridge)
  AND EXISTS (SELECT FROM fast.bridge) AND pg_temp.fast(5, '//tunnel/@length')::float8[] = pg_temp.fast(5, '/@length')::float8[] AND pg_temp.fast(5, '//tunnel/@s') = '{0.0000}';
-- Heights of axes, and of profiles.
SELECT FROM streetgen.create_model('hill', 2154, dimension => 3, driving_side => 'right') \g /dev/null
INSERT INTO hill.axis (axis_id, geom, width) VALUES (1, 'SRID=2154;LINESTRING Z (650000 6860000 10,650100 6860000 20)', 7), (2, 'SRID=2154;LINESTRING Z (650100 6860000 20,650200 6860000 20)', 5), (3, 'SRID=2154;LINESTRING Z (650100 6860000 20,650100 6860100 40)', 5);
SELECT 'without heights there is no elevation', pg_temp.found('//elevationProfile', file) = 0 FROM written;
SELECT 'roads and connecting roads have heights', pg_temp.found('//road/elevationProfile', f) = pg_temp.found('//road', f) FROM pg_temp.file('hill') f;
SELECT 'a road climbs as its axis does', abs((xpath('string(//road[userData[@code="edge" and @value="' || edge_id || '"]]//elevation[1]/@a)', f))[1]::text::float8 - 10) < 0.01 AND abs((xpath('string(//road[userData[@code="edge" and @value="' || edge_id || '"]]//elevation[1]/@b)', f))[1]::text::float8 - 0.1) < 1e-6
  FROM hill.edge, pg_temp.file('hill') f WHERE axis_id = 1;
-- What is stale is written with a warning that counts.
SELECT FROM streetgen.live('town', false);
UPDATE town.axis SET width = 13 WHERE axis_id = 1;
SELECT 'a stale model is written', pg_temp.found('//road[@junction="-1"]', pg_temp.file('town')) = (SELECT count(*) FROM town.edge);
-- Numbers as texts.
SELECT 'a number has its digits, and is never -0', (SELECT array_agg(streetgen._decimal(v, d)) FROM (VALUES (1.005::float8, 1), (-0.0004, 3), (-2.5, 4), (123456789.123456, 3), (1e-9, 9), (7, 0)) n(v, d)) = '{1.0,0.000,-2.5000,123456789.123,0.000000001,7}';
SELECT 'one that is not finite is refused', test.state($$SELECT streetgen._decimal('NaN', 2)$$) = '22023' AND test.state($$SELECT streetgen._decimal('Infinity', 2)$$) = '22023';
-- A planner that expects a thousand lanes of a road, or one, compares each road with each.
CREATE FUNCTION pg_temp.rows_compared(model name, statements_of name) RETURNS float8 LANGUAGE plpgsql AS $$
DECLARE plan jsonb; known jsonb := streetgen._begin_export(model, 'opendrive', 'interconnection', '{}'); statement text := (SELECT substring(prosrc, 'RETURN QUERY (.*);\s*END') FROM pg_proc WHERE proname = statements_of);
BEGIN
  PERFORM set_config('search_path', format('pg_catalog, %I, public', model), true);
  EXECUTE 'EXPLAIN (ANALYZE, FORMAT JSON) ' || regexp_replace(regexp_replace(replace(statement, 'joining AND', 'true AND'), '\moptions\M', quote_literal(known) || '::jsonb', 'g'), '\mmodel\M', quote_literal(model) || '::name', 'g') INTO plan;
  RETURN (SELECT max(r::text::float8) FROM (SELECT jsonb_path_query(plan, '$.**."Rows Removed by Join Filter"') UNION ALL SELECT jsonb_path_query(plan, '$.**."Actual Rows"')) p(r));
END $$;
DO $$ BEGIN
  PERFORM streetgen.create_model('many', 2154, driving_side => 'right');
  INSERT INTO many.axis (geom, width) SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + x, 6860000 + y), ST_MakePoint(650080 + x, 6860000 + y)), 2154), 7 FROM generate_series(0, 1900, 100) x, generate_series(0, 900, 100) y;
END $$;
ANALYZE many.axis, many.node, many.edge, many.section_limit, many.lane, many.lane_separator, many.interconnection, many.setting;
SELECT 'no step of ' || f || ' compares a hundred rows a lane', count(*) = 400 AND pg_temp.rows_compared('many', f) < 100 * count(*) FROM many.lane, unnest('{_opendrive_roads,_opendrive_elements,_lanelet2_elements}'::text[]) f GROUP BY f;

-- Lanes of stated widths leave room at the kerbs, which narrows with the roadway.
SELECT FROM streetgen.create_model('roomy', 2154, subjects => '{interconnection,sidewalk}', driving_side => 'right') \g /dev/null
INSERT INTO roomy.axis (axis_id, geom, width, width_end, direction, lanes_forward, lane_width_forward, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 12, NULL, 'direct', 2, '3|3', 2, 2),
  (2, 'SRID=2154;LINESTRING(650000 6860100,650100 6860100)', 12, 8, 'direct', 2, '3|3', 0, 0), (3, 'SRID=2154;LINESTRING(650000 6860200,650100 6860200)', 6, NULL, 'direct', 2, '3|3', 2, 2);
CREATE TEMPORARY TABLE roomy_file AS SELECT pg_temp.file('roomy') AS file;
CREATE FUNCTION pg_temp.lanes_of(axis bigint, attribute text) RETURNS text[] LANGUAGE sql AS $$
  SELECT pg_temp.texts('//road[userData[@code="edge" and @value="' || edge_id || '"]]//lane[@id!="0"]' || attribute, file) FROM roomy_file, roomy.edge WHERE axis_id = axis $$;
SELECT 'room lies between the lanes and the sidewalks at the kerbs', pg_temp.lanes_of(1, '/@type') = '{driving,driving,shoulder,shoulder,sidewalk,sidewalk}' AND pg_temp.lanes_of(1, '[@type="shoulder"]/@id') = '{-3,1}' AND pg_temp.lanes_of(1, '[@type="sidewalk"]/@id') = '{-4,2}';
SELECT 'all lanes but sidewalks are as wide as the roadway', (SELECT sum(a::float8) FROM unnest(pg_temp.lanes_of(1, '[@type!="sidewalk"]/width/@a')) a) = 12;
SELECT 'also where it narrows', abs((SELECT sum(a::float8) FROM unnest(pg_temp.lanes_of(2, '/width/@a')) a) - 12) < 1e-4 AND abs((SELECT sum(b::float8) FROM unnest(pg_temp.lanes_of(2, '/width/@b')) b) * 100 + 4) < 1e-4;
SELECT 'lanes that fill it have none', pg_temp.lanes_of(3, '/@type') = '{driving,driving,sidewalk,sidewalk}';
SELECT 'offsets that lean at one end have no record that says what the one before it says', regexp_count(streetgen._opendrive_lean(20, 1, 3, lean_in, lean_out), '<laneOffset') = n
  FROM (VALUES (0, 0, 1), (0.1, 0, 2), (0, 0.1, 2), (0.1, -0.1, 3)) v(lean_in, lean_out, n);
