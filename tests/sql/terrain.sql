\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
-- Roads designed on terrain: from towns to axes. Each test is a row (name, holds).

SELECT streetgen.create_model('hills', srid => 2154, dimension => 3), streetgen.create_model('flat', srid => 2154) \g /dev/null
SELECT 'create_design: a flat model is refused', test.state($$SELECT streetgen.create_design('flat')$$) = '22023';
SELECT 'design: a model without a design is refused', test.state($$SELECT * FROM streetgen.design('hills')$$) = '55000';
SELECT streetgen.create_design('hills') \g /dev/null
SELECT 'create_design: twice is refused', test.state($$SELECT streetgen.create_design('hills')$$) = '55000';
SELECT 'create_design: every column has a comment', bool_and(col_description(attrelid, attnum) IS NOT NULL) FROM streetgen._design_table() t JOIN pg_attribute ON attrelid = format('hills.%I', relation)::regclass AND attnum > 0;
SELECT 'create_design: every table has its view', bool_and(to_regclass(format('hills.%I', relation || '_editing')) IS NOT NULL) FROM streetgen._design_table();

-- 8 x 8 km of hills, lower left corner 900000 6450000.
CREATE TABLE tile AS SELECT test.tile(900000 + 4000 * i, 6454000 + 4000 * j, 40, 100, '400 + 60 * sin(x / 700.0) * cos(y / 900.0)') AS heights FROM generate_series(0, 1) i, generate_series(0, 1) j;
SELECT 'import_terrain: counts its tiles', streetgen.import_terrain('hills', 'tile') = 4;
SELECT 'import_terrain: the same again is refused', test.state($$SELECT streetgen.import_terrain('hills', 'tile')$$) = '22023';
CREATE TABLE wrong AS SELECT test.tile(920000, 6454000, 40, 4, '1', srid => 4326) AS heights;
SELECT 'import_terrain: another SRID is refused', test.state($$SELECT streetgen.import_terrain('hills', 'wrong')$$) = '22023';
UPDATE wrong SET heights = test.tile(920000, 6454000, 25, 4, '1');
SELECT 'import_terrain: another cell is refused', test.state($$SELECT streetgen.import_terrain('hills', 'wrong')$$) = '22023';
UPDATE wrong SET heights = set_byte(test.tile(908000, 6454000, 40, 4, '-9999'), 61, 5);
SELECT 'import_terrain: -9999 without a value for missing heights is refused', test.state($$SELECT streetgen.import_terrain('hills', 'wrong')$$) = '22023';
UPDATE wrong SET heights = set_byte(test.tile(908000, 6454000, 40, 4, '0'), 61, 5);
SELECT 'import_terrain: heights of 0 are heights', test.state($$SELECT streetgen.import_terrain('hills', 'wrong'); DO $d$ BEGIN ASSERT streetgen.terrain_height('hills', 'SRID=2154;POINT(908080 6453920)') = 0; END $d$; DO $d$ BEGIN RAISE division_by_zero; END $d$ $$) = '22012';
UPDATE wrong SET heights = test.tile(300000, 4000000, 40, 4, '100');
SELECT 'import_terrain: heights of another country are refused', test.state($$SELECT streetgen.import_terrain('hills', 'wrong')$$) = '22023';
UPDATE wrong SET heights = '\x0102';
SELECT 'import_terrain: bytes that are no raster are refused', test.state($$SELECT streetgen.import_terrain('hills', 'wrong')$$) = '22023';
SELECT 'import_terrain: refused tiles leave nothing', count(*) = 4 FROM hills.terrain_tile;
CREATE TABLE as_text AS SELECT encode(test.tile(908000, 6454000, 40, 100, '400'), 'hex') AS heights;
SELECT 'import_terrain: hexadecimal text is taken', streetgen.import_terrain('hills', 'as_text') = 1;

SELECT 'terrain_height: that of the formula', bool_and(abs(streetgen.terrain_height('hills', p) - (400 + 60 * sin(ST_X(p) / 700.0) * cos(ST_Y(p) / 900.0))) < 1)
    FROM generate_series(1, 30) k, LATERAL (SELECT ST_SetSRID(ST_Point(900100 + 250 * k, 6450200 + 130 * k), 2154) AS p) q;
SELECT 'terrain_height: none where there is no tile', streetgen.terrain_height('hills', 'SRID=2154;POINT(0 0)') IS NULL;
SELECT 'terrain_height: of another SRID', streetgen.terrain_height('hills', ST_Transform('SRID=2154;POINT(902000 6452000)'::geometry, 4326)) - streetgen.terrain_height('hills', 'SRID=2154;POINT(902000 6452000)') < 0.01;
SELECT 'terrain_profile: every step and the end', count(*) = 12 AND max(abscissa) = 1050 AND bool_and(height IS NOT NULL) FROM streetgen.terrain_profile('hills', 'SRID=2154;LINESTRING(902000 6452000,903050 6452000)', 100);
SELECT 'hill_shade: rectangles cover the tiles once', abs(sum(ST_Area(s.geom)) / (SELECT ST_Area(ST_Union(t.geom)) FROM hills.terrain_tile t) - 1) < 0.05 AND bool_and(ST_IsValid(s.geom)) AND abs(ST_Area(ST_Union(s.geom)) / sum(ST_Area(s.geom)) - 1) < 1e-9 FROM streetgen.hill_shade('hills', NULL, 80) s;
WITH s AS MATERIALIZED (SELECT grey, streetgen.terrain_height('hills', ST_Translate(ST_Centroid(geom), 20, -20)) / 56.6 - streetgen.terrain_height('hills', ST_Translate(ST_Centroid(geom), -20, 20)) / 56.6 AS slope FROM streetgen.hill_shade('hills', ST_MakeEnvelope(901000, 6451000, 905000, 6455000, 2154), 60))
SELECT 'hill_shade: what faces the north west is lighter than what faces the south east', avg(grey) FILTER (WHERE slope > 0.04) > 5 + avg(grey) FILTER (WHERE slope < -0.04) FROM s;
SELECT 'hill_shade: no columns are refused', test.state($$SELECT * FROM streetgen.hill_shade('hills', NULL, 0)$$) = '22023';
SELECT 'terrain_profile: a step of 0 is refused', test.state($$SELECT streetgen.terrain_profile('hills', 'SRID=2154;LINESTRING(902000 6452000,903050 6452000)', 0)$$) = '22023';

CREATE TABLE lake (geom geometry(Polygon, 2154), what text);
INSERT INTO lake VALUES (ST_MakeEnvelope(903500, 6450000, 903560, 6457990, 2154), 'water'), (ST_MakeEnvelope(905000, 6452500, 905200, 6452700, 2154), 'building');
SELECT 'import_zones: class by a column', streetgen.import_zones('hills', 'lake', '{"class": "what"}') = 2;
SELECT 'import_zones: an unknown class is refused', test.state($$SELECT streetgen.import_zones('hills', 'lake', '{"class": {"value": "swamp"}}')$$) = '22023';
SELECT 'import_zones: a column that is not there is refused', test.state($$SELECT streetgen.import_zones('hills', 'lake', '{"class": "kind"}')$$) = '42703';

INSERT INTO hills.design_node_editing (name, kind, importance, geom) VALUES ('A', 'city', 200000, 'SRID=2154;POINT(901000 6451500)'), ('B', 'city', 90000, 'SRID=2154;POINT(907000 6452500)'), ('C', 'village', 2000, 'SRID=2154;POINT(904500 6456800)');
SELECT 'nodes: a row that is put in is by hand', bool_and(by_hand) FROM hills.design_node;
CREATE TABLE run AS SELECT * FROM streetgen.design('hills');
SELECT 'design: a row a stage', array_agg(stage) = '{links,paths,horizontal,vertical,structures,axes}' FROM run;
SELECT 'design: cities by highway, villages by rural roads', array_agg(DISTINCT network ORDER BY network) = '{highway,rural}' FROM hills.design_link;
SELECT 'design: nothing is stale after it', sum(computed) = 0 AND sum(written) = 0 FROM streetgen.design('hills');
SELECT 'design: vertices keep clear of the building', NOT bool_or(ST_Intersects(l.geom, ST_MakeEnvelope(905000, 6452500, 905200, 6452700, 2154))) FROM hills.design_link l;
SELECT 'design: water is bridged', count(*) > 0 FROM hills.structure s JOIN hills.design_link USING (design_link_id) WHERE kind = 'bridge' AND ST_Intersects(s.geom, ST_MakeEnvelope(903500, 6450000, 903560, 6457990, 2154));
SELECT 'design: grades keep the standard of their speed, or the method says not', bool_and(p.worst <= s.grade * 1.005 OR l.method LIKE '%grade%') FROM hills.design_link l JOIN hills.design_class c USING (network) JOIN hills.design_standard s USING (speed),
    LATERAL (SELECT max(greatest(abs(grade_start), abs(grade_end))) AS worst FROM streetgen._vertical_alignment(streetgen._link_grades('hills', l.design_link_id))) p;
SELECT 'design: curves keep the least radius, or the method says not', bool_and(e.tightest >= s.radius * 0.999 OR l.method LIKE '%radius%') FROM hills.design_link l JOIN hills.design_class c USING (network) JOIN hills.design_standard s USING (speed),
    LATERAL (SELECT min(1 / nullif(greatest(abs(curvature_start), abs(curvature_end)), 0)) AS tightest FROM hills.alignment_element a WHERE a.design_link_id = l.design_link_id) e;
SELECT 'axes: two carriageways of a highway, one of others', array_agg(DISTINCT direction ORDER BY direction) FILTER (WHERE importance = 1) = '{direct,reverse}' AND array_agg(DISTINCT direction) FILTER (WHERE importance = 3) = '{both}' FROM hills.axis WHERE source = 'design';
SELECT 'axes: have heights', bool_and(ST_NDims(geom) = 3) AND min(ST_ZMin(geom)) > 300 FROM hills.axis;
SELECT 'axes: bridges lie on another level', count(*) > 0 FROM hills.axis WHERE level = 1;
SELECT 'axes: links begin and end at their nodes', bool_and(EXISTS (SELECT FROM hills.axis a WHERE ST_DWithin(ST_StartPoint(a.geom), n.geom, 1e-6) OR ST_DWithin(ST_EndPoint(a.geom), n.geom, 1e-6))) FROM hills.design_node n WHERE NOT rejected;
SELECT * FROM streetgen.generate('hills') \g /dev/null
SELECT 'streets: no error', count(*) = 0 FROM streetgen.check_model('hills') WHERE severity = 'error';

-- Edits of a link carry it to axes and streets.
CREATE TABLE drawn AS SELECT v.* FROM hills.design_vertex v JOIN hills.design_link USING (design_link_id) WHERE network = 'rural' ORDER BY ordinality OFFSET 1 LIMIT 1;
UPDATE hills.design_vertex_editing v SET geom = ST_Translate(v.geom, 30, 20) FROM drawn d WHERE d.design_vertex_id = v.design_vertex_id;
SELECT 'a vertex that is dragged stays by hand', v.by_hand AND ST_DWithin(v.geom, ST_Translate(d.geom, 30, 20), 1e-9) FROM hills.design_vertex v JOIN drawn d USING (design_vertex_id);
SELECT 'the streets followed in the same statement', count(*) = 0 FROM streetgen.check_model('hills') WHERE severity = 'error' OR rule LIKE 'stale%' OR rule = 'not_generated';
SELECT 'the axis runs by the dragged vertex', min(ST_Distance(a.geom, v.geom)) < 40 FROM hills.axis a, hills.design_vertex v JOIN drawn d USING (design_vertex_id) WHERE a.importance = 3;
SELECT 'nothing is stale after the edit', sum(computed) = 0 FROM streetgen.design('hills');
CREATE TABLE before AS SELECT ordinality, geom FROM hills.design_vertex WHERE by_hand;
UPDATE hills.design_class SET width = width + 1 WHERE network = 'rural';
SELECT * FROM streetgen.design('hills') \g /dev/null
SELECT 'rows by hand outlive a new design', NOT EXISTS (SELECT * FROM before EXCEPT SELECT ordinality, geom FROM hills.design_vertex WHERE by_hand);
DELETE FROM hills.design_vertex_editing v USING drawn d WHERE v.design_vertex_id = d.design_vertex_id;
SELECT 'a vertex that is deleted is rejected', v.rejected FROM hills.design_vertex v JOIN drawn USING (design_vertex_id);
SELECT 'and the road does without it', NOT EXISTS (SELECT FROM streetgen._link_places('hills', d.design_link_id, false) p WHERE ST_DWithin(p.geom, d.geom, 60)) FROM drawn d;
UPDATE hills.design_vertex_editing v SET by_hand = false, rejected = false FROM drawn d WHERE d.design_vertex_id = v.design_vertex_id;
SELECT 'taken back, the search fills the gap', count(*) > 0 FROM hills.design_vertex v, drawn d WHERE v.design_link_id = d.design_link_id AND NOT v.by_hand;

CREATE TABLE lifted AS SELECT g.* FROM hills.grade_point g JOIN hills.design_link USING (design_link_id) WHERE network = 'rural' AND abscissa > 1000 ORDER BY abscissa LIMIT 1;
UPDATE hills.grade_point_editing g SET height = g.height + 2 FROM lifted l WHERE l.grade_point_id = g.grade_point_id;
SELECT 'a grade point that is lifted stays', g.by_hand AND g.height = l.height + 2 FROM hills.grade_point g JOIN lifted l USING (grade_point_id);
SELECT 'and no other lies there', count(*) = 1 FROM hills.grade_point g, lifted l WHERE g.design_link_id = l.design_link_id AND abs(g.abscissa - l.abscissa) < 5;
SELECT 'a grade point that does not fit is refused, and nothing is lost', test.state(format('UPDATE hills.grade_point_editing SET radius = 900000 WHERE grade_point_id = %s', grade_point_id)) IN ('22023', 'none') FROM lifted;
DELETE FROM hills.design_link_editing WHERE network = 'rural';
SELECT * FROM streetgen.design('hills') \g /dev/null
SELECT 'a link that is deleted is rejected, and its axes go', bool_and(rejected) AND NOT EXISTS (SELECT FROM hills.axis a JOIN hills.design_link l ON split_part(source_ref, '/', 1)::bigint = l.design_link_id AND l.rejected) FROM hills.design_link WHERE network = 'rural' AND by_hand;
SELECT 'it never comes back', NOT EXISTS (SELECT FROM hills.design_link a JOIN hills.design_link b USING (node_a, node_b, network) WHERE a.rejected AND NOT b.rejected);

SELECT 'path_cost: a term a row', array_agg(term) = '{pavement,land,fill,cut,bridge,tunnel,zones,use}' AND sum(cost) > 0 FROM streetgen.path_cost('hills', 'SRID=2154;LINESTRING(901000 6451500,903000 6451500)', 'rural');
SELECT 'path_cost: pavement by length and width', abs(cost - 60 * 13 * 2000) < 1 FROM streetgen.path_cost('hills', 'SRID=2154;LINESTRING(901000 6451500,903000 6451500)', 'rural') WHERE term = 'pavement';
SELECT 'path_cost: a line with heights is built at them', (SELECT sum(cost) FROM streetgen.path_cost('hills', 'SRID=2154;LINESTRING Z(901000 6451500 480,903000 6451500 480)', 'rural') WHERE term = 'bridge') > 1e6;
SELECT 'path_cost: another network is refused', test.state($$SELECT streetgen.path_cost('hills', 'SRID=2154;LINESTRING(901000 6451500,903000 6451500)', 'lane')$$) = '22023';

CREATE TABLE cheap AS SELECT design_link_id, ST_Length(geom) AS before FROM hills.design_link WHERE network = 'highway' AND NOT rejected;
SELECT streetgen.set('hills', 'utilisation_cost', '1000') \g /dev/null
SELECT 'utilisation_cost: paths are searched anew', sum(computed) > 0 FROM streetgen.design('hills') WHERE stage = 'paths';
SELECT 'utilisation_cost: a road that many use is shorter', bool_and(utilisation > 10 AND ST_Length(geom) < before + 1) AND sum(ST_Length(geom)) < sum(before) FROM hills.design_link JOIN cheap USING (design_link_id);
SELECT 'design: ' || name, test.state(statement) = '22023' FROM (VALUES
    ('an unknown stage is refused', $$SELECT streetgen.design('hills', '{kerbs}')$$),
    ('an unknown link is refused', $$SELECT streetgen.design('hills', links => '{99999}')$$),
    ('two nodes at one place are refused', $$INSERT INTO hills.design_node (kind, geom) VALUES ('town', 'SRID=2154;POINT(901000 6451500.5)'); SELECT streetgen.design('hills')$$),
    ('a node without terrain is refused', $$INSERT INTO hills.design_node (kind, geom) VALUES ('town', 'SRID=2154;POINT(5 45)'); SELECT streetgen.design('hills')$$),
    ('a speed without a standard is refused', $$UPDATE hills.design_class SET speed = 65; SELECT streetgen.design('hills')$$)) v(name, statement);

SELECT 'design_nodes: draws towns off the water', streetgen.design_nodes('hills', 'SRID=2154;POLYGON((900100 6450100,907900 6450100,907900 6457900,900100 6457900,900100 6450100))', 12, 7) = 12
    AND NOT EXISTS (SELECT FROM hills.design_node n JOIN hills.zone z ON ST_Intersects(n.geom, z.geom));
SELECT 'design_nodes: nodes by hand stay', count(*) = 3 FROM hills.design_node WHERE by_hand;
SELECT 'design_nodes: an unknown option is refused', test.state($$SELECT streetgen.design_nodes('hills', 'SRID=2154;POLYGON((900100 6450100,907900 6450100,907900 6457900,900100 6450100))', 12, 7, '{"hamlets": 3}')$$) = '22023';
SELECT 'drop_design: the tables go, the axes stay', test.state($$SELECT streetgen.drop_design('hills')$$) = 'none' AND to_regclass('hills.design_link') IS NULL AND (SELECT count(*) FROM hills.axis) > 0;
