\set ECHO none
\ir shared/truths.sql
\ir shared/streets.sql
-- Settings, wherever they come from: proven before they are used.  Each test is a row (name, holds).
SELECT streetgen.create_model('town', 2154) \g /dev/null
INSERT INTO town.axis (axis_id, geom, width) VALUES
    (1, 'SRID=2154;LINESTRING(650000 6860000,650100 6860000)', 7), (2, 'SRID=2154;LINESTRING(650100 6860000,650100 6860090)', 6);
SELECT streetgen.generate('town') \g /dev/null
CREATE TABLE before AS SELECT xmin AS written, edge_id FROM town.edge;
CREATE FUNCTION pg_temp.untouched() RETURNS boolean LANGUAGE sql AS $$ SELECT count(*) = 2 AND (SELECT count(*) = 2 FROM town.edge) FROM before b JOIN town.edge e ON e.xmin = b.written AND e.edge_id = b.edge_id $$;

-- What generate finds in the table, whoever wrote it: the row as it was is put back after each.
CREATE TABLE wrong AS SELECT name, '22023' AS state, value FROM (VALUES
    ('tolerance', 'NaN'), ('tolerance', '0'), ('tolerance', 'Infinity'), ('tolerance', 'wide'), ('tolerance', '1e400'), ('crossing', 'under'),
    ('transition_kind', 'both'), ('radius_rule', ''), ('turning_mode', 'guess'), ('dead_end', 'square'), ('max_arc_distance', '-1'), ('cell_size', '1e-9'),
    ('reach', 'NaN'), ('radius_by_importance', '{"1": "NaN"}'), ('speed_by_importance', '[1, 2]'), ('radius_by_importance', '{"1": '),
    ('speed_by_importance', ''), ('taper_ratio', '{}'), ('taper_ratio', '{"fast": 3}'), ('taper_ratio', '{"50": null}'), ('taper_ratio', '{"50": "NaN"}'), ('taper_ratio', '10'), ('radius_by_importance', '{"01": 8}'), ('radius_by_importance', '{"0": 8}')) v(name, value)
    UNION ALL SELECT name, '22004', NULL FROM streetgen._default_setting() WHERE name NOT IN ('max_width_per_lane', 'lane_width_maximal', 'radius_function', 'corner_length', 'corner_area', 'follow_length', 'follow_area', 'limit_distance', 'transition_length', 'kerb_radius_minimal');
CREATE TABLE tried (name text, value text, wanted text, state text, said text, hint text, untouched boolean, restored boolean);
DO $$
DECLARE
    w record;
    r record;
BEGIN
    FOR w IN SELECT * FROM wrong LOOP
        UPDATE town.setting SET value = w.value WHERE name = w.name;
        r := test.refusal('SELECT streetgen.generate(''town'')');
        INSERT INTO tried VALUES (w.name, w.value, w.state, r.state, r.said, r.hint, pg_temp.untouched());
        UPDATE town.setting s SET value = d.value FROM streetgen._default_setting() d WHERE d.name = s.name AND s.name = w.name;
    END LOOP;
END $$;
SELECT format('generate refuses %s = %s', name, coalesce(value, 'NULL')), state = wanted AND said LIKE '%"' || name || '"%' AND hint LIKE '%.' FROM tried;
SELECT 'a refused setting changes no row', bool_and(untouched) FROM tried;

DELETE FROM town.setting WHERE name = 'tolerance';
SELECT 'a setting that was deleted is 22004', (r).state = '22004' AND (r).said LIKE '%"tolerance"%' FROM (SELECT test.refusal('SELECT streetgen.generate(''town'')') AS r) t;
SELECT 'nor can axes be cleaned without it', (r).state = '22004' FROM (SELECT test.refusal($$SELECT streetgen.import_axes('town', 'town.axis', '{}')$$) AS r) t;
SELECT 'it deletes nothing', pg_temp.untouched();
SELECT (test.refusal('SELECT streetgen.generate(''town'')')).hint AS hint \gset
SELECT 'the hint puts it back', (r).state = 'none' FROM (SELECT test.refusal(substring(:'hint' FROM '^SELECT [^;]*\)')) AS r) t;
SELECT 'and generate goes on as before', (SELECT bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('town')) AND pg_temp.untouched();
SELECT 'with all that the setting says of itself', (SELECT s FROM town.setting s WHERE name = 'tolerance')::text = (SELECT d FROM streetgen._default_setting() d WHERE name = 'tolerance')::text;
SELECT 'what a corner may close has no bound where it is NULL', (test.refusal($$UPDATE town.setting SET value = NULL WHERE name IN ('corner_length', 'corner_area', 'follow_length', 'follow_area', 'limit_distance')$$)).state = 'none' AND (test.refusal('SELECT streetgen.generate(''town'')')).state = 'none';
SELECT 'max_width_per_lane may be NULL', (test.refusal($$UPDATE town.setting SET value = NULL WHERE name = 'max_width_per_lane'$$)).state = 'none' AND (test.refusal('SELECT streetgen.generate(''town'')')).state = 'none';

-- The border proves again what the core cannot bear.
SELECT 'the border takes what is good', (test.refusal(test.streets('{}'))).state = 'none';
SELECT format('the border refuses %s', given), (r).state = wanted AND (r).said LIKE '%' || part || '%'
    FROM (VALUES ('{"tolerance": "NaN"}'::jsonb, '22023', 'tolerance is nan'), ('{"tolerance": "0"}', '22023', 'tolerance is 0'), ('{"tolerance": "Infinity"}', '22023', 'tolerance is inf'),
        ('{"tolerance": "0.5 m"}', '22023', 'tolerance is "0.5 m", expected a number'), ('{"tolerance": ""}', '22023', 'tolerance is "", expected a number'),
        ('{"tolerance": null}', '22023', 'setting tolerance has no value'), ('{"crossing": null}', '22023', 'setting crossing has no value'),
        ('{"max_arc_distance": "-1"}', '22023', 'max_arc_distance is -1'), ('{"radius_minimal": "1e300"}', '22023', 'radius_minimal is 1e+300'),
        ('{"transition_length": "NaN"}', '22023', 'transition_length is nan'), ('{"max_hole_area": "NaN"}', '22023', 'max_hole_area is nan'),
        ('{"taper_ratio": "{\"0\": \"NaN\"}"}', '22023', 'taper_ratio'), ('{"taper_ratio": "10"}', '22023', 'taper_ratio is no JSON object'), ('{"taper_ratio": "{\"0\": -1}"}', '22023', 'taper_ratio is -1'),
        ('{"smoothing": "splines"}', '22023', 'unknown smoothing "splines", expected none or arcs'), ('{"smoothing": "arcs", "smoothing_shift": "0"}', '22023', 'smoothing_shift is 0'),
        ('{"smoothing": "arcs", "smoothing_tolerance": "NaN"}', '22023', 'smoothing_tolerance is nan'), ('{"follow_length": "NaN"}', '22023', 'follow_length is nan'), ('{"follow_area": "-1"}', '22023', 'follow_area is -1'),
        ('{"median_width_minimal": "0"}', '22023', 'median_width_minimal is 0'), ('{"median_width_maximal": "-1"}', '22023', 'median_width_maximal is -1'), ('{"island_area": "wide"}', '22023', 'island_area is "wide"'),
        ('{"island_area_minimal": "-1"}', '22023', 'island_area_minimal is -1'),
        ('{"island_nose_radius": "0"}', '22023', 'island_nose_radius is 0'), ('{"kerb_radius_minimal": "NaN"}', '22023', 'kerb_radius_minimal is nan'), ('{"kerb_radius_minimal": "-1"}', '22023', 'kerb_radius_minimal is -1'), ('{"slit_width": "NaN"}', '22023', 'slit_width is nan'),
        ('{"crossing": "under"}', '22023', 'unknown crossing "under", expected over or split'),
        ('{"transition_kind": "both"}', '22023', 'unknown transition_kind "both", expected symmetric or left or right'),
        ('{"reach": "NaN"}', '22023', 'reach is nan'), ('{"short_axis": "wait"}', '22023', 'unknown short_axis "wait", expected reduce or follow'),
        ('{"radius_rule": ""}', '22023', 'unknown radius_rule "", expected min or max or mean or major'), ('{"dead_end": "square"}', '22023', 'unknown dead_end "square", expected flat or round'),
        ('{"lane_order": "any"}', '22023', 'unknown lane_order'), ('{"driving_side": "both"}', '22023', 'unknown driving_side'), ('{"lane_width_minimal": "NaN"}', '22023', 'lane_width_minimal is nan'),
        ('{"edge_line": "dotted"}', '22023', 'unknown edge_line'), ('{"u_turn": "maybe"}', '22023', 'unknown u_turn'),
        ('{"trajectory": "spline"}', '22023', 'unknown trajectory'), ('{"trajectory_tolerance": "0"}', '22023', 'trajectory_tolerance is 0'), ('{"trajectory_radius": "NaN"}', '22023', 'trajectory_radius is nan'),
        ('{"axes.axis_id": "{7,7}"}', '22023', 'axis 7 stands more than once'), ('{"axes.axis_id": "{7,8,9}"}', '22004', 'geom is NULL in row 3 of the axes'),
        ('{"axes.width": "{7,NaN}"}', '22023', 'width of axis 8 is nan'), ('{"axes.width_end": "{7,201}"}', '22023', 'width_end of axis 8 is 201, expected 0.001 to 200'),
        ('{"axes.radius": "{Infinity,3}"}', '22023', 'radius of axis 7 is inf'), ('{"axes.width": "{7,NULL}"}', '22004', 'width is NULL in row 2 of the axes'),
        ('{"axes.lanes_forward": "{1,-1}"}', '22023', 'lanes of axis 8 is -1'), ('{"axes.kind_forward": "{tram,general}"}', '22023', 'unknown lane of axis 7 "tram"'),
        ('{"axes.lane_width_forward": "{3m,3|3}"}', '22023', 'lane width of axis 7'), ('{"axes.turn_forward": "{up,left}"}', '22023', '"up"'),
        ('{"axes.speed": "{50,NaN}"}', '22023', 'speed of axis 8 is nan'), ('{"srid": "2154"}', '22023', 'axis 7 has SRID 0, expected 2154'),
        ('{"axes.geom": ["LINESTRING(0 0,50 0)", "LINESTRING Z (0 0 0,0 50 1e13)"]}', '22023', 'axis 8 has a coordinate beyond 1e12 m at vertex 2'),
        ('{"axes.geom": ["LINESTRING(0 0,50 0)", "LINESTRING(3 3,3 3)"]}', '22023', 'axis 8 has no length'),
        ('{"lanes.width": "{-1}"}', '22023', 'width of a lane override is -1'), ('{"lanes.abscissa": "{NULL}"}', '22004', 'abscissa is NULL in row 1 of the lanes'),
        ('{"lanes.line": ["POINT(1 2)"]}', '22023', 'line of a lane override of axis 7'), ('{"limits.abscissa": "{NaN}"}', '22023', 'abscissa of a section limit override is nan'),
        ('{"limits.which": "{middle}"}', '22023', 'unknown end of a section limit override "middle"'), ('{"corners.radius": "{1001}"}', '22023', 'radius of a corner override is 1001'),
        ('{"restrictions.x": "{NaN}"}', '22023', 'x of a turn restriction is nan'), ('{"restrictions.to_axis": "{NULL}"}', '22004', 'to_axis is NULL in row 1 of the turn restrictions'),
        ('{"restrictions.kind": "{maybe}"}', '22023', 'unknown kind of a turn restriction "maybe"'), ('{"restrictions.turn": "{up}"}', '22023', 'unknown turn of a turn restriction "up"'),
        ('{"transitions.which": "{middle}"}', '22023', 'unknown transition end "middle", expected start or end'), ('{"transitions.kind": "{both}"}', '22023', 'unknown transition_kind "both"'),
        ('{"transitions.length": "{NaN}"}', '22023', 'transition length of axis 7 is nan'), ('{"transitions.axis_id": "{NULL}"}', '22004', 'axis_id is NULL in row 1 of the transitions'),
        ('{"former_nodes.y": "{NaN}"}', '22023', 'y of a former node is nan'), ('{"former_nodes.surface": ["POINT(1 2)"]}', '22023', 'a former surface is a POINT, expected a MULTIPOLYGON'),
        ('{"former_nodes.surface": ["MULTIPOLYGON(EMPTY,((0 3,0 -3,9 3,0 3)))"]}', '22023', 'a former surface has an empty part'),
        ('{"former_nodes.surface": ["MULTIPOLYGON(((0 3,0 -3,1e13 3,0 3)))"]}', '22023', 'a former surface has a coordinate beyond 1e12 m at vertex 3'), ('{"former_edges.geom": ["POINT(1 2)"]}', '22023', 'a former edge'),
        ('{"neighbours.y": "{NaN}"}', '22023', 'y of a neighbour is nan'), ('{"neighbours.level": "{NULL}"}', '22004', 'level is NULL in row 1 of the neighbours'),
        ('{"neighbours.surface": ["POINT(1 2)"]}', '22023', 'a neighbour is a POINT, expected a MULTIPOLYGON')) v(given, wanted, part),
    LATERAL (SELECT test.refusal(test.streets(given)) AS r) t;
SELECT 'streets are kept until their statement ends, and then no more', (r).state = '55000' AND (r).hint <> '' FROM (SELECT test.refusal('SELECT FROM streetgen._computed_node(1)') AS r) t;
SELECT format('rows of %s are given %s', computed, CASE state WHEN 'none' THEN 'again and again' ELSE 'once' END),
        test.state(format('WITH s AS MATERIALIZED (%s) SELECT (SELECT count(*) FROM streetgen._computed_%s) + (SELECT count(*) FROM streetgen._computed_%2$s)', replace(test.streets('{}'), 'count(*) FROM ', ''), computed)) = state
    FROM (VALUES ('node((TABLE s))', 'none'), ('edge((TABLE s))', 'none'), ('interconnection((TABLE s), ''{1}'', ''{1,2}'')', 'none'),
        ('section_limit((TABLE s), ''{1}'')', '55000'), ('lane((TABLE s), ''{1}'')', '55000'), ('marking((TABLE s), ''{1}'', ''{1}'')', '55000')) v(computed, state);
SELECT 'a row that is NULL is refused', (r).state = '22004' AND (r).said LIKE 'row 1 of the axes is NULL' FROM (SELECT test.refusal('SELECT streetgen._streets(0, ''{}'', ARRAY[NULL::streetgen.street_axis], NULL, NULL, NULL, NULL, NULL, NULL, NULL)') AS r) t;
SELECT 'no axes have no streets', streetgen._streets(0, '{}', NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL) IS NULL;
SELECT 'a NULL model is 22004, with a hint', bool_and((r).state = '22004' AND (r).hint <> '') FROM (SELECT test.refusal(call) AS r FROM unnest(ARRAY['SELECT streetgen.generate(NULL)',
    'SELECT streetgen.set(NULL, ''tolerance'', ''1'')', 'SELECT streetgen.set_transition(NULL, 1)', 'SELECT streetgen.svg(NULL)']) call) t;

-- By importance: an entry holds up to the next one, the first also before itself.
SELECT format('a corner of importance %s wants %s m', importance, wanted), streetgen.wanted_radius(NULL, importance, 50, 7, '{"3": 8, "5": null, "7": 2}', 'paper') = wanted
    FROM (VALUES (1, 8), (2, 8), (3, 8), (4, 8), (5, 0), (6, 0), (7, 2), (99, 2)) v(importance, wanted);
SELECT format('an axis of importance %s has %s km/h', importance, wanted), streetgen.estimated_speed(importance, 7, '{"3": 50, "5": 30}', 6) = wanted
    FROM (VALUES (1, 50), (3, 50), (4, 50), (5, 30), (99, 30)) v(importance, wanted);
SELECT 'unknown importance leaves it to the width', streetgen.estimated_speed(NULL, 7, '{"3": 50}', 6) = 42 AND streetgen.wanted_radius(NULL, NULL, 50, 7, '{"3": 8}', 'paper') = streetgen.turning_radius(50, 7, 'paper');
SELECT format('no entry at all leaves it to turning_radius: %s', quote_literal(entries)), streetgen.wanted_radius(NULL, 1, 50, 7, entries, 'paper') = streetgen.turning_radius(50, 7, 'paper')
    FROM (VALUES (''), ('{}')) v(entries);
