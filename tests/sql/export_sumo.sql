\set ECHO none
\ir shared/truths.sql
-- Plain files of SUMO: as many lanes and connections as the model has, well-formed whatever a name holds, the same bytes again.  (name, holds)
DO $$ BEGIN
  PERFORM streetgen.create_model('town', 2154, driving_side => 'right'), streetgen.create_model('empty', 2154), streetgen.create_model('bare', 2154, subjects => '{}');
  INSERT INTO town.axis (axis_id, geom, width, direction, kind_forward, level, name, kind) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 12, 'both', NULL, 0, E'<"Rue" & \x01d''Ab>', 'residential'),
    (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 4, 'direct', 'general', 0, NULL, NULL),
    (3, 'SRID=2154;LINESTRING(650100 6860000,650100 6860100)', 9, 'direct', 'general|cycle|parking', 0, 'north', 'runway'),
    (4, 'SRID=2154;LINESTRING(650050 6859950,650050 6860050)', 7, 'both', NULL, 1, 'bridge', NULL),
    (5, 'SRID=2154;LINESTRING(650200 6860000,650300 6860000,650300 6860100,650200 6860000)', 7, 'both', NULL, 0, 'loop', NULL);
  UPDATE town.axis SET source_ref = 'w<1' WHERE axis_id = 1;
END $$;
CREATE FUNCTION pg_temp.file(model name, part text, options jsonb DEFAULT '{}') RETURNS xml LANGUAGE sql AS $$
  SELECT xmlparse(document string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo(model, part, options) $$;
CREATE FUNCTION pg_temp.found(path text, file xml) RETURNS integer LANGUAGE sql AS $$ SELECT cardinality(xpath(path, file)) $$;
-- A loop is two edges, its lanes too, which go on in its middle.
CREATE TEMPORARY VIEW looped AS SELECT d.* FROM town.lane_driving d JOIN town.edge USING (edge_id) WHERE from_node = to_node;
SELECT 'there is a node for each node, and one in the middle of a loop', pg_temp.found('/nodes/node', pg_temp.file('town', 'nodes')) = (SELECT count(*) FROM town.node) + (SELECT count(*) FROM town.lane_group WHERE from_node = to_node);
SELECT 'there is a lane for each lane and direction', pg_temp.found('/edges/edge/lane', pg_temp.file('town', 'edges')) = (SELECT count(*) FROM town.lane_driving) + (SELECT count(*) FROM looped) AND (SELECT count(*) = 2 FROM looped);
CREATE FUNCTION pg_temp.turns_back(model name) RETURNS bigint LANGUAGE plpgsql AS $$ DECLARE found bigint; BEGIN
  EXECUTE format('SELECT count(*) FROM %1$I.lane_group a WHERE EXISTS (SELECT FROM %1$I.lane_group b WHERE (b.edge_id, b.along_axis, b.from_node) = (a.edge_id, NOT a.along_axis, a.to_node))
    AND NOT EXISTS (SELECT FROM %1$I.interconnection WHERE connecting AND lane_in = ANY (a.lanes) AND along_in = a.along_axis)', model) INTO found; RETURN found; END $$;
SELECT 'there is a connection for each interconnection that connects, and one back where none does', pg_temp.found('/connections/connection', pg_temp.file('town', 'connections')) = (SELECT count(*) FROM town.interconnection WHERE connecting) + (SELECT count(*) FROM looped) + pg_temp.turns_back('town') AND pg_temp.turns_back('town') = 5;
SELECT 'it leads from lane to lane in the middle of the street', pg_temp.found('//connection[@from="-1" and @to="1" and @fromLane="1" and @toLane="1" and not(@shape)]', pg_temp.file('town', 'connections')) = 1;
SELECT 'an edge without a way on or back is parted from those that leave its node', pg_temp.found('//delete', pg_temp.file('town', 'connections')) = (SELECT count(*) FROM town.lane_group a JOIN town.lane_group b ON b.from_node = a.to_node
  WHERE NOT EXISTS (SELECT FROM town.lane_group b WHERE (b.edge_id, b.along_axis) = (a.edge_id, NOT a.along_axis)) AND NOT EXISTS (SELECT FROM town.interconnection WHERE connecting AND lane_in = ANY (a.lanes) AND along_in = a.along_axis));
SELECT 'a loop ends where it began', pg_temp.found('//edge[@id="5.end" and @from = //edge[@id="5"]/@to and @to = //edge[@id="5"]/@from]', pg_temp.file('town', 'edges')) = 1;
SELECT 'types are those of OpenStreetMap where the kind is one, else by importance', (SELECT array_agg(DISTINCT concat(abs(id::float8), ' ', type) ORDER BY concat(abs(id::float8), ' ', type)) FROM unnest(xpath('//edge[not(contains(@id, "end"))]', f)) e,
    LATERAL (SELECT (xpath('string(/edge/@id)', e))[1]::text AS id, (xpath('string(/edge/@type)', e))[1]::text AS type) v) = '{1 highway.residential,2 highway.residential,3 aeroway.runway,4 highway.residential,5 highway.residential}' FROM pg_temp.file('town', 'edges') f;
SELECT 'each has a row', (SELECT array_agg(id::text ORDER BY id::text) FROM unnest(xpath('/types/type/@id', pg_temp.file('town', 'types'))) id) = '{aeroway.runway,highway.residential}';
SELECT 'each lane says of which way it is', pg_temp.found('//lane/param[@key="origId" and @value="w<1"]', f) = 4 AND pg_temp.found('//lane[count(param[@key="origId"]) = 1]', f) = pg_temp.found('//lane', f) FROM pg_temp.file('town', 'edges') f;
SELECT 'lines are numbered from one without a gap', bool_and(ordinality = turn) FROM (SELECT ordinality, row_number() OVER () AS turn FROM streetgen.export_sumo('town', 'edges')) l;
SELECT 'a name keeps what XML can hold', (xpath('string(//edge[@id="1"]/@name)', pg_temp.file('town', 'edges')))[1]::text = (xpath('string(/n/@m)', '<n m="&lt;&quot;Rue&quot; &amp; d''Ab&gt;"/>'))[1]::text;
SELECT 'widths are those of the lanes', (SELECT array_agg(w::text::numeric ORDER BY w::text::numeric) FROM unnest(xpath('//edge[not(contains(@id, "end"))]/lane/@width', pg_temp.file('town', 'edges'))) w)
  = (SELECT array_agg(round(width::numeric, 2) ORDER BY round(width::numeric, 2)) FROM town.lane_driving);
SELECT 'only bicycles ride on a cycle lane, and none drives on a parking lane', pg_temp.found('//lane[@allow="bicycle"]', pg_temp.file('town', 'edges')) = (SELECT count(*) FROM town.lane WHERE kind = 'cycle')
  AND pg_temp.found('//lane[@disallow="all"]', pg_temp.file('town', 'edges')) = (SELECT count(*) FROM town.lane WHERE kind = 'parking');
SELECT 'speed is in metres a second', (SELECT bool_and(abs((xpath('string(//edge[@id="' || edge_id || '"]/@speed)', f))[1]::text::float8 - speed / 3.6) <= 0.005) FROM town.edge, pg_temp.file('town', 'edges') f);
SELECT 'an extent takes whole edges that touch it', (SELECT array_agg(DISTINCT abs(id::text::float8)) FROM unnest(xpath('//edge/@id', pg_temp.file('town', 'edges', '{"extent": [650150, 6859990, 650160, 6860010]}'))) id) = '{2}';
SELECT 'its nodes are theirs alone', pg_temp.found('//node', pg_temp.file('town', 'nodes', '{"extent": [650150, 6859990, 650160, 6860010]}')) = 2;
SELECT 'and no connection leads out of it', pg_temp.found('//connection', pg_temp.file('town', 'connections', '{"extent": [650150, 6859990, 650160, 6860010]}')) = 0;
SELECT 'a level by itself', (SELECT array_agg(DISTINCT abs(id::text::float8)) FROM unnest(xpath('//edge/@id', pg_temp.file('town', 'edges', '{"level": 1}'))) id) = '{4}';
SELECT 'digits as asked for', (SELECT bool_and(x::text ~ '^[0-9]+[.][0-9]{4}$') FROM unnest(xpath('//node/@x', pg_temp.file('town', 'nodes', '{"precision": 4}'))) x);
SELECT 'a model without streets is refused, and an extent without them', test.state($$SELECT FROM streetgen.export_sumo('empty', 'edges')$$) = '22023' AND test.state($$SELECT FROM streetgen.export_sumo('town', 'edges', '{"extent": [0, 0, 1, 1]}')$$) = '22023';
SELECT 'the same bytes again: ' || part, (SELECT md5(string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo('town', part)) = (SELECT md5(string_agg(line, E'\n' ORDER BY ordinality)) FROM streetgen.export_sumo('town', part))
  FROM unnest('{nodes,edges,connections,types,tlLogics,additional}'::text[]) part;
-- Options and arguments.
SELECT 'an unknown option is refused', test.state($$SELECT FROM streetgen.export_sumo('town', 'edges', '{"colour": 1}')$$) = '22023';
SELECT 'so is ' || bad, test.state(format($$SELECT FROM streetgen.export_sumo('town', 'edges', %L)$$, bad)) = '22023'
  FROM unnest(ARRAY['[]', '{"precision": 1}', '{"precision": 2.5}', '{"precision": "2"}', '{"tolerance": -1}', '{"level": "0"}', '{"extent": [1, 2, 3]}', '{"extent": [3, 0, 1, 9]}', '{"extent": [0, 0, 1e13, 1]}', '{"extent": 1}']) bad;
SELECT 'and options that are NULL', test.state($$SELECT FROM streetgen.export_sumo('town', 'edges', NULL)$$) = '22023';
SELECT 'an unknown part is refused', test.state($$SELECT FROM streetgen.export_sumo('town', 'roads')$$) = '22023' AND test.state($$SELECT FROM streetgen.export_sumo('town', NULL)$$) = '22004';
SELECT 'a model without interconnections is refused', test.state($$SELECT FROM streetgen.export_sumo('bare', 'edges')$$) = '55000';
SELECT 'an unknown model is refused', test.state($$SELECT FROM streetgen.export_sumo('nowhere', 'edges')$$) = '3F000';
SELECT 'every option is one that its formats take', (SELECT bool_and(streetgen._export_options(format, jsonb_build_object(name, value)) ->> name IS NOT DISTINCT FROM value #>> '{}') FROM streetgen.export_option(), unnest(formats) format);
-- The nodes of a junction as one.
SELECT 'without junctions their nodes cannot be one', test.state($$SELECT FROM streetgen.export_sumo('town', 'nodes', '{"junctions": "group"}')$$) = '55000' AND test.state($$SELECT FROM streetgen.export_sumo('town', 'nodes', '{"junctions": "all"}')$$) = '22023';
DO $$ BEGIN
  PERFORM streetgen.create_model('wide', 2154, subjects => '{interconnection,junction}', driving_side => 'right');
  -- Corners of 4 m leave the street between both carriageways room.
  INSERT INTO wide.axis (axis_id, geom, width, direction, radius) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 'direct', 4), (2, 'SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 'direct', 4),
    (3, 'SRID=2154;LINESTRING(650200 6860030,650100 6860030)', 7, 'direct', 4), (4, 'SRID=2154;LINESTRING(650100 6860030,650000 6860030)', 7, 'direct', 4),
    (5, 'SRID=2154;LINESTRING(650100 6859900,650100 6860000)', 7, 'both', 4), (6, 'SRID=2154;LINESTRING(650100 6860000,650100 6860030)', 7, 'both', 4), (7, 'SRID=2154;LINESTRING(650100 6860030,650100 6860100)', 7, 'both', 4);
END $$;
SELECT 'a junction of two nodes is one node', pg_temp.found('//node', pg_temp.file('wide', 'nodes', '{"junctions": "group"}')) = (SELECT count(*) - 1 FROM wide.node) AND (SELECT count(*) = 1 FROM wide.junction_edge);
SELECT 'without the edge inside', pg_temp.found('//edge[@id="6" or @id="-6"]', pg_temp.file('wide', 'edges', '{"junctions": "group"}')) = 0 AND pg_temp.found('//edge[@id="6" or @id="-6"]', pg_temp.file('wide', 'edges')) = 2;
SELECT 'its movements are the connections, and none is contradicted', pg_temp.found('//connection', f) = (SELECT count(*) FROM wide.movement WHERE connecting) + pg_temp.turns_back('wide') AND pg_temp.found('//delete[@from = //connection/@from and @to = //connection/@to]', f) = 0 FROM pg_temp.file('wide', 'connections', '{"junctions": "group"}') f;
INSERT INTO wide.junction_override (axis_id, geom, kind) VALUES (6, 'SRID=2154;POINT(650100 6860000)', 'signals');
SELECT 'signals are traffic lights, one for all nodes of a junction', (SELECT count(*) > 0 FROM wide.junction WHERE kind = 'signals') AND pg_temp.found('//node[@type="traffic_light"]', pg_temp.file('wide', 'nodes')) = 2
  AND pg_temp.found('//node[@type="traffic_light" and @tl = preceding-sibling::node/@tl]', pg_temp.file('wide', 'nodes')) = 1;
SELECT FROM streetgen.switch_subject('wide', 'signal', true);
SELECT 'each connection at signals has green in some phase', bool_and(green) AND count(*) > 10 FROM (SELECT bool_or(substr(state::text, i, 1) IN ('G', 'g')) AS green
  FROM unnest(xpath('//tlLogic/phase/@state', pg_temp.file('wide', 'tlLogics'))) state, generate_series(1, length(state::text)) i GROUP BY i) s;
SELECT 'and is in the program once', (SELECT count(*) = count(DISTINCT n::text) AND count(*) = max(n::text::integer) + 1 FROM unnest(xpath('//connection/@linkIndex', pg_temp.file('wide', 'tlLogics'))) n);
-- Roundabouts, and bus lanes that cars cross.
DO $$ BEGIN
  PERFORM streetgen.create_model('ring', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right');
  INSERT INTO ring.axis (axis_id, geom, width, lane_count, importance) SELECT 1, ST_SetSRID(ST_Reverse(ST_ExteriorRing(ST_ForceRHR(ST_Buffer(ST_MakePoint(650000, 6860000), 18, 6)))), 2154), 7, 2, 3
    UNION ALL SELECT 2 + a, ST_SetSRID(ST_MakeLine(ST_MakePoint(650000 + 18 * cos(radians(90 * a)), 6860000 + 18 * sin(radians(90 * a))), ST_MakePoint(650000 + 118 * cos(radians(90 * a)), 6860000 + 118 * sin(radians(90 * a)))), 2154), 6, 2, 4 FROM generate_series(0, 3) a;
  INSERT INTO ring.axis (axis_id, geom, width, direction, kind_forward) VALUES (6, 'SRID=2154;LINESTRING(650300 6860000,650400 6860000)', 10.5, 'direct', 'general|bus|general'), (7, 'SRID=2154;LINESTRING(650300 6860100,650400 6860100)', 10.5, 'direct', 'general|general|bus');
END $$;
SELECT 'a ring is a roundabout of its edges and nodes', (SELECT array_agg(x ORDER BY x) FROM regexp_split_to_table((xpath('string(//roundabout/@edges)', f))[1]::text, ' ') x) = (SELECT array_agg(name ORDER BY name) FROM ring.roundabout r JOIN ring.roundabout_edge e USING (roundabout_id), streetgen._lane_group_text(e.edge_id, e.along_axis, 1) name WHERE accepted)
  AND (SELECT count(DISTINCT x) = 4 AND bool_and(x IN (SELECT from_node::text FROM ring.edge WHERE axis_id = 1)) FROM regexp_split_to_table((xpath('string(//roundabout/@nodes)', f))[1]::text, ' ') x) FROM pg_temp.file('ring', 'edges') f;
SELECT 'a part of it is none', pg_temp.found('//roundabout', pg_temp.file('ring', 'edges', '{"extent": [650010, 6860001, 650020, 6860012]}')) = 0;
SELECT 'cars may cross a bus lane between theirs, and no other', (SELECT array_agg(pg_temp.found('//edge[@id="' || edge_id || '"]/lane[@allow]', f) ORDER BY axis_id) = '{0,1}' FROM ring.edge WHERE axis_id > 5) FROM pg_temp.file('ring', 'edges') f;
-- What is stale is written with a warning that counts.
SELECT FROM streetgen.live('town', false);
UPDATE town.axis SET width = 13 WHERE axis_id = 1;
SELECT 'a stale model is written', pg_temp.found('/edges/edge/lane', pg_temp.file('town', 'edges')) = (SELECT count(*) FROM town.lane_driving) + (SELECT count(*) FROM looped);
-- A street that people alone cross at signals: without their crossing in the file nobody can ask for their state.
SELECT FROM streetgen.create_model('alone', 2154, subjects => '{signal}', driving_side => 'right') \g /dev/null
INSERT INTO alone.axis (geom, width, lane_count, importance, speed) VALUES ('SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7, 2, 3, 50), ('SRID=2154;LINESTRING(650100 6860000,650200 6860000)', 7, 2, 3, 50), ('SRID=2154;LINESTRING(650100 6860000,650100 6860060)', 4, 2, 6, 20);
INSERT INTO alone.control_point (geom, kind) VALUES ('SRID=2154;POINT(650100 6860000)', 'signals'), ('SRID=2154;POINT(650088 6860000)', 'pedestrian_crossing');
SELECT 'a state for people alone is left out where the file has no crossing of theirs', (SELECT count(*) = 1 FROM alone.signal_state WHERE kind = 'walk') AND cardinality(xpath('//phase', f)) = (SELECT count(*) FROM alone.signal_state WHERE kind <> 'walk') FROM pg_temp.file('alone', 'tlLogics') f;

-- People on foot: a cross whose east is one-way, with sidewalks, crossings by objects and by control points, and signals.
CREATE FUNCTION pg_temp.on_foot(model name, driving_side text) RETURNS void LANGUAGE plpgsql AS $$ BEGIN
  PERFORM streetgen.create_model(model, 2154, subjects => '{interconnection,sidewalk,signal,object}', driving_side => driving_side);
  EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, direction, sidewalk_left, sidewalk_right) VALUES
    (1, ''SRID=2154;LINESTRING(650000 6860000,650100 6860000)'', 7, ''both'', 2, 3), (2, ''SRID=2154;LINESTRING(650100 6860000,650200 6860000)'', 7, ''direct'', 2, 2),
    (3, ''SRID=2154;LINESTRING(650100 6860000,650100 6860100)'', 7, ''both'', 2, 2), (4, ''SRID=2154;LINESTRING(650100 6859900,650100 6860000)'', 7, ''both'', 2, 0)', model);
  EXECUTE format('INSERT INTO %I.control_point (geom, kind) VALUES (''SRID=2154;POINT(650100 6860000)'', ''signals''), (''SRID=2154;POINT(650072 6860000)'', ''pedestrian_crossing''),
    (''SRID=2154;POINT(650100 6860012)'', ''pedestrian_crossing'')', model);
  EXECUTE format('INSERT INTO %I.pedestrian_crossing_editing (geom, width, angle) VALUES (''SRID=2154;POINT(650075 6860000)'', 3, 90), (''SRID=2154;POINT(650112 6860000)'', 5, 70), (''SRID=2154;POINT(650100 6859988)'', 4, 90)', model);
END $$;
SELECT pg_temp.on_foot('foot', 'right'), pg_temp.on_foot('left_foot', 'left') \g /dev/null
SELECT model || ': a sidewalk is a lane at the kerb', pg_temp.found('//lane[@allow="pedestrian"]', f) = 8 AND pg_temp.found('//lane[@allow="pedestrian" and @index="0"]', f) = 8 FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'edges') f;
SELECT model || ': beside no lane of its direction it is an edge', (SELECT array_agg(id::text) FROM unnest(xpath('//edge[contains(@id, ".walk")]/@id', f)) id) = '{-2.walk}' AND pg_temp.found('//edge[@id="-2.walk"]/lane', f) = 1 FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'edges') f;
SELECT model || ': lanes lie in the sidewalks of the model', bool_and(ST_Contains(ST_Buffer(s.surface, 0.1), ST_Translate(ST_SetSRID(ST_GeomFromText('LINESTRING(' || translate(shape, ' ,', ', ') || ')'), 2154), 650000, 6859900))) AND count(*) = 7
  FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'edges') f, unnest(xpath('//edge', f)) edge,
    LATERAL (SELECT (xpath('string(/edge/@id)', edge))[1]::text AS id, (xpath('string(/edge/lane[@allow="pedestrian"]/@shape)', edge))[1]::text AS shape) l,
    LATERAL (SELECT surface FROM (SELECT 'foot' AS of, * FROM foot.sidewalk UNION ALL SELECT 'left_foot', * FROM left_foot.sidewalk) s
      WHERE of = model AND node_id IS NULL AND edge_id = abs(replace(id, '.walk', '')::bigint) AND side = CASE WHEN (id LIKE '-%') = (model = 'left_foot') THEN 'right' ELSE 'left' END) s
  WHERE shape <> '' GROUP BY model;
SELECT model || ': connections lead from lanes of cars to lanes of cars', count(*) > 0 AND bool_and(pg_temp.found(format('//edge[@id="%s"]/lane[@index="%s" and not(@allow)]', edge, lane), edges) = 1)
  FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'edges') edges, pg_temp.file(model, 'connections') c, unnest(xpath('//connection', c)) k, (VALUES ('from'), ('to')) w(which),
    LATERAL (SELECT (xpath('string(/connection/@' || which || ')', k))[1]::text AS edge, (xpath('string(/connection/@' || which || 'Lane)', k))[1]::text AS lane) e GROUP BY model;
-- An object comes before a control point. South there is one sidewalk, and a walk on the roadway.
SELECT model || ': a crossing of each street', (SELECT array_agg(format('%s %s', (xpath('string(/crossing/@edges)', c))[1], (xpath('string(/crossing/@width)', c))[1]) ORDER BY c::text COLLATE "C") FROM unnest(xpath('//crossing', f)) c)
  = '{-1 1 3.00,-3 3 4.00,-4 4 4.00,2 5.00}' AND pg_temp.found('//crossing[@priority="1"]', f) = 4 FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'connections') f;
SELECT 'it lies where the model has it, from the right to the left of those who leave', (xpath('string(//crossing[@edges="-1 1"]/@shape)', pg_temp.file('foot', 'connections')))[1]::text = '75,103.5 75,96.5';
SELECT 'who waits leaves it free', abs((xpath('string(//edge[@id="1"]/stopOffset/@value)', f))[1]::text::float8 - ((SELECT abscissa - 75 FROM foot.section_limit WHERE (edge_id, which) = (1, 'end')) + 1.5 + 0.5)) < 0.006
  AND pg_temp.found('//edge[@id="-1" or @id="2"]/stopOffset', f) = 0 FROM pg_temp.file('foot', 'edges') f;
CREATE TEMPORARY VIEW shown AS SELECT model, (xpath('string(/phase/@state)', p))[1]::text AS state, f FROM (VALUES ('foot'::name), ('left_foot')) m(model), pg_temp.file(model, 'tlLogics') f, unnest(xpath('//phase', f)) p;
SELECT model || ': a program shows connections, then crossings', bool_and(length(state) = 4 + pg_temp.found('//connection', f)) AND bool_and(pg_temp.found('//connection[@linkIndex="0"]', f) = 1) AND bool_and((SELECT array_agg((i::text)::integer - pg_temp.found('//connection', f) ORDER BY i::text::integer)
  FROM unnest(xpath('//crossing/@linkIndex', pg_temp.file(model, 'connections'))) i) = '{0,1,2,3}') FROM shown GROUP BY model;
SELECT model || ': durations are whole seconds', bool_and(state ~ '^[0-9]+$') FROM (SELECT model, unnest(xpath('//@duration|//@offset', pg_temp.file(model, 'tlLogics')))::text AS state FROM (VALUES ('foot'::name), ('left_foot')) m(model)) d GROUP BY model;
BEGIN;
UPDATE foot.signal_state SET duration = duration + 0.6 WHERE ordinality IN (1, 2);
SELECT 'a fraction goes to the next phase, and the cycle lasts as long', bool_and(d ~ '^[0-9]+$') AND sum(d::float8) = (SELECT round(sum(duration)) FROM foot.signal_state) FROM unnest(xpath('//@duration', pg_temp.file('foot', 'tlLogics'))) u, LATERAL (SELECT u::text AS d) t;
ROLLBACK;
CREATE TEMPORARY VIEW adapted AS SELECT model, (xpath('string(/phase/@duration)', p))[1]::text::float8 AS duration, nullif((xpath('string(/phase/@minDur)', p))[1]::text, '')::float8 AS least, nullif((xpath('string(/phase/@maxDur)', p))[1]::text, '')::float8 AS most,
    (xpath('string(/phase/@state)', p))[1]::text AS state FROM (VALUES ('foot'::name), ('wide')) m(model), unnest(xpath('//tlLogic[@type="actuated"]/phase', pg_temp.file(model, 'tlLogics', '{"programs": "actuated"}'))) p;
SELECT model || ': programs follow detectors within bounds', count(least) > 0 AND count(least) < count(*) AND bool_and(least <= duration AND duration <= most AND least >= least(duration, 5)) FROM adapted GROUP BY model;
SELECT model || ': no amber and no all red changes', bool_and(least IS NULL) FROM adapted WHERE state ~ 'y' OR state !~ '[Gg]' GROUP BY model;
SELECT 'where people walk greens are not cut', bool_and(least = duration) AND count(*) > 0 FROM adapted WHERE model = 'foot' AND least IS NOT NULL AND right(state, 4) ~ 'G';
SELECT model || ': each crossing has green, and then nobody drives in from there or straight out', bool_and(i >= first) FILTER (WHERE stopped) AND count(DISTINCT i) FILTER (WHERE stopped) = 4 FROM (
  SELECT model, i, first, substr(state, i + 1, 1) = 'G' AND NOT EXISTS (SELECT FROM unnest(xpath('//connection', s.f)) k, LATERAL (SELECT (xpath('string(/connection/@from)', k))[1]::text AS a, (xpath('string(/connection/@to)', k))[1]::text AS b,
      (xpath('string(/connection/@linkIndex)', k))[1]::text::integer AS link) l, unnest(string_to_array((xpath(format('string(//crossing[@linkIndex="%s"]/@edges)', i), pg_temp.file(model, 'connections')))[1]::text, ' ')) e
    WHERE substr(state, link + 1, 1) IN ('G', 'g') AND (a = e OR b = e AND (a, b) IN (('1', '2'), ('4', '3')))) AS stopped FROM shown s, LATERAL (SELECT pg_temp.found('//connection', s.f) AS first) n, generate_series(first, first + 3) i WHERE substr(state, i + 1, 1) = 'G') c GROUP BY model;
SELECT FROM streetgen.switch_subject('left_foot', 'sidewalk', false) \g /dev/null
SELECT 'without crossings there are none, and without sidewalks neither', pg_temp.found('//crossing', pg_temp.file('wide', 'connections')) = 0
  AND pg_temp.found('//crossing', pg_temp.file('left_foot', 'connections')) = 0 AND pg_temp.found('//lane[@allow="pedestrian"]', pg_temp.file('left_foot', 'edges')) = 0;
-- A sidewalk beside a merging lane that ends along its edge.
SELECT FROM streetgen.create_model('beside', 2154, subjects => '{ramp,junction,alignment,sidewalk}', driving_side => 'right') \g /dev/null
INSERT INTO beside.axis (axis_id, geom, width, lane_count, direction, kind, speed, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650600 6860000)', 10.5, 3, 'direct', 'motorway', 110, 0, 2),
    (2, 'SRID=2154;LINESTRING(650600 6860000,651400 6860000)', 10.5, 3, 'direct', 'motorway', 110, 0, 2), (3, 'SRID=2154;LINESTRING(650300 6859900,650500 6859970,650600 6860000)', 3.5, 1, 'direct', 'motorway_link', 60, 0, 2);
SELECT 'the edge is two, and the node between them is there', pg_temp.found('//edge[@from="middle.2" and @id="2.end"]', pg_temp.file('beside', 'edges')) = 1 AND pg_temp.found('//node[@id="middle.2"]', pg_temp.file('beside', 'nodes')) = 1 AND count(*) = 1 FROM beside.lane WHERE kind = 'merging' AND end_abscissa IS NOT NULL;
BEGIN;
UPDATE beside.lane SET end_abscissa = 1e-13 WHERE kind = 'merging';
SELECT 'a lane that ends where its edge begins parts nothing', pg_temp.found('//edge[@id="2.end"]', pg_temp.file('beside', 'edges')) = 0;
ROLLBACK;
SELECT 'both have the sidewalk at their kerb, which goes round the merging lane', count(*) = 2 AND bool_and(ST_Contains(ST_Buffer(surface, 0.1), line)) AND abs(sum(ST_Length(line)) - 800) < 2
  FROM beside.sidewalk s, unnest(xpath('//edge[starts-with(@id, "2")]/lane[@index="0" and @allow="pedestrian"]/@shape', pg_temp.file('beside', 'edges'))) shape,
    LATERAL (SELECT ST_Translate(ST_SetSRID(ST_GeomFromText('LINESTRING(' || translate(shape::text, ' ,', ', ') || ')'), 2154), 650000, 6859900) AS line) l WHERE edge_id = 2 AND side = 'right' AND node_id IS NULL;
-- What is written of each row is no call of SQL: such a call costs more than the text.
CREATE FUNCTION pg_temp.plan(query text) RETURNS text LANGUAGE plpgsql AS $$
DECLARE line text; plan text := '';
BEGIN
  FOR line IN EXECUTE 'EXPLAIN (VERBOSE, COSTS OFF) ' || query LOOP plan := plan || line || E'\n'; END LOOP;
  RETURN plan;
END $$;
SELECT 'the name of a lane group is no call', pg_temp.plan('SELECT streetgen._lane_group_text(edge_id, along_axis, number) FROM town.lane_group') !~ '_lane_group_text';
SELECT 'a join of lanes expects no ten of them in a group', pg_temp.plan('SELECT FROM streetgen._few(ARRAY[1, 2])') ~ '_few' AND (SELECT prorows = 2 FROM pg_proc WHERE proname = '_few');
-- Coordinates are those of PostGIS on the grid of their digits.
CREATE TEMPORARY TABLE odd AS SELECT n, ST_MakeLine(ARRAY(SELECT ST_MakePoint(650000 + round((sin(n * 37 + k) * 90)::numeric, 2 + n % 3)::float8, 6860000 + (k - 4) * 0.0025) FROM generate_series(0, 9) k)) AS line FROM generate_series(1, 60) n
  UNION ALL SELECT 0, 'LINESTRING(649999.998 6859999.996, 650000.002 6860000.004, 650000 6860000.1)';
SELECT 'coordinates are as PostGIS writes them: ' || digits, bool_and(streetgen._coordinates(line, 650000, 6860000, digits, tolerance) IS NOT DISTINCT FROM
    translate(substr(ST_AsText(ST_SnapToGrid(ST_Translate(ST_Simplify(line, tolerance, true), -650000, -6860000), 10.0 ^ -digits), digits), 12), ' ,)', ', ')) AND count(*) > 100
  FROM odd, generate_series(2, 6) digits, unnest('{0,0.1}'::float8[]) tolerance GROUP BY digits ORDER BY digits;
SELECT 'a line in one place has none', streetgen._coordinates('LINESTRING(1 1, 1.001 1)', 0, 0, 2, 0) IS NULL;
SELECT 'what has no numbers is refused', test.state($$SELECT streetgen._coordinates('LINESTRING(1 1, NaN 1)', 0, 0, 2, 0)$$) = '22023';

-- Lanes of stated widths leave room at the kerb, and the sidewalk lies beyond it.
SELECT FROM streetgen.create_model('roomy', 2154, subjects => '{interconnection,sidewalk}', driving_side => 'right') \g /dev/null
INSERT INTO roomy.axis (axis_id, geom, width, direction, lanes_forward, lane_width_forward, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 12, 'direct', 2, '3|3', 2, 2);
SELECT 'a sidewalk lies beyond the room at its kerb', bool_and(ST_Contains(ST_Buffer(surface, 0.1), line)) AND count(DISTINCT side) = 2
  FROM roomy.sidewalk s JOIN LATERAL (SELECT ST_Translate(ST_SetSRID(ST_GeomFromText('LINESTRING(' || translate(shape::text, ' ,', ', ') || ')'), 2154), 650000, 6860000) AS line
    FROM unnest(xpath('//lane[@allow="pedestrian"]/@shape', pg_temp.file('roomy', 'edges'))) shape) l ON ST_Intersects(ST_Buffer(surface, 0.1), line) WHERE node_id IS NULL;

-- Where vehicles stand, along the lane that drives past.
SELECT FROM streetgen.create_model('stands', 2154, subjects => '{interconnection,sidewalk,object}', driving_side => 'right') \g /dev/null
INSERT INTO stands.axis (axis_id, geom, width, direction, kind_forward, kind_backward, sidewalk_left, sidewalk_right) VALUES (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 9, 'both', 'general|parking', 'general', 2, 2),
    (2, 'SRID=2154;LINESTRING(650000 6860050,650100 6860050)', 7, 'both', NULL, NULL, 2, 2);
INSERT INTO stands.street_object (type, placement, axis_id, abscissa, side, axis_offset) VALUES ('bus_stop', 'border', 2, 60, 'left', 0.5);
CREATE TEMPORARY TABLE stand AS SELECT (xpath('name(/*)', e))[1]::text AS kind, (xpath('string(/*/@lane)', e))[1]::text AS lane, (xpath('string(/*/@startPos)', e))[1]::text::float8 AS low, (xpath('string(/*/@endPos)', e))[1]::text::float8 AS high, (xpath('string(/*/@roadsideCapacity)', e))[1]::text AS lots
  FROM unnest(xpath('/additional/*', pg_temp.file('stands', 'additional'))) e;
SELECT 'a parking lane is a place along the lane beside it, a car every six metres', count(*) = 1 AND bool_and(lane = '1_2' AND lots::integer = floor((high - low) / 6) AND high - low > 90) FROM stand WHERE kind = 'parkingArea';
SELECT 'a bus stop lies on the lane of its side, where the bus stands', count(*) = 1 AND bool_and(lane = '-2_1' AND 38 BETWEEN low AND high AND high - low BETWEEN 10 AND 20) FROM stand WHERE kind = 'busStop';
