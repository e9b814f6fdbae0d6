\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
\ir shared/made_network.sql
-- Towns that move, come and go: what is by hand stays, and the roads without a way are not built.
SET streetgen.live = off;
SELECT test.make_network('net') \g /dev/null
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'the highways meet at one interchange', count(*) = 1 FROM net.design_node WHERE kind = 'interchange';

-- Rows by hand on every link: a vertex that is dragged, a grade point, a structure; and a row by hand of each kind.
UPDATE net.design_vertex_editing v SET geom = ST_Translate(geom, 8, 5) FROM (SELECT DISTINCT ON (design_link_id) design_vertex_id FROM net.design_vertex JOIN net.design_link USING (design_link_id) WHERE network = 'highway' ORDER BY design_link_id, ordinality) f WHERE f.design_vertex_id = v.design_vertex_id;
UPDATE net.grade_point_editing g SET height = height + 0.2 FROM (SELECT DISTINCT ON (design_link_id) grade_point_id FROM net.grade_point WHERE abscissa BETWEEN 500 AND 1500 ORDER BY design_link_id, abscissa) f WHERE f.grade_point_id = g.grade_point_id;
INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) SELECT design_link_id, 'bridge', 300, 340 FROM net.design_link;
CREATE TABLE by_hand AS SELECT 'vertex' AS what, design_vertex_id AS id, design_link_id AS link FROM net.design_vertex WHERE by_hand
    UNION ALL SELECT 'grade', grade_point_id, design_link_id FROM net.grade_point WHERE by_hand UNION ALL SELECT 'structure', structure_id, design_link_id FROM net.structure WHERE by_hand
    UNION ALL SELECT 'crossing', design_crossing_id, design_link_id FROM net.design_crossing WHERE by_hand;
SELECT 'every link has rows by hand', count(*) > 30 AND count(DISTINCT link) = (SELECT count(*) FROM net.design_link) FROM by_hand;
SELECT 'a structure by hand lies on its road', bool_and(ST_Length(geom) BETWEEN 39.9 AND 40.1) FROM net.structure WHERE by_hand;
-- What is by hand now and was not then, or the other way round.
CREATE FUNCTION test.lost() RETURNS bigint LANGUAGE sql AS $$
    SELECT count(*) FROM ((SELECT 'vertex' AS what, design_vertex_id, design_link_id FROM net.design_vertex WHERE by_hand
        UNION ALL SELECT 'grade', grade_point_id, design_link_id FROM net.grade_point WHERE by_hand UNION ALL SELECT 'structure', structure_id, design_link_id FROM net.structure WHERE by_hand
        UNION ALL SELECT 'crossing', design_crossing_id, design_link_id FROM net.design_crossing WHERE by_hand) EXCEPT ALL SELECT * FROM by_hand) more
    FULL JOIN (SELECT * FROM by_hand EXCEPT ALL (SELECT 'vertex', design_vertex_id, design_link_id FROM net.design_vertex WHERE by_hand
        UNION ALL SELECT 'grade', grade_point_id, design_link_id FROM net.grade_point WHERE by_hand UNION ALL SELECT 'structure', structure_id, design_link_id FROM net.structure WHERE by_hand
        UNION ALL SELECT 'crossing', design_crossing_id, design_link_id FROM net.design_crossing WHERE by_hand)) less ON false $$;
-- A link that was deleted and is taken back is as it was.
CREATE TABLE built AS SELECT source_ref, geom FROM net.axis;
DELETE FROM net.design_link_editing WHERE design_link_id = (SELECT min(design_link_id) FROM net.design_link WHERE NOT by_hand AND method NOT LIKE 'no_path%' AND NOT EXISTS (SELECT FROM by_hand WHERE what = 'crossing' AND link = design_link_id));
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'the axes of a deleted link go', count(*) < (SELECT count(*) FROM built) FROM net.axis;
UPDATE net.design_link_editing SET by_hand = false WHERE rejected;
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'and come back with it', count(*) > 0 AND count(*) = count(a.source_ref) AND count(*) = (SELECT count(*) FROM net.axis) FROM built LEFT JOIN net.axis a USING (source_ref);
CREATE TABLE former AS SELECT design_link_id, node_a, node_b, network FROM net.design_link;
CREATE TABLE place AS SELECT design_node_id, geom FROM net.design_node WHERE kind = 'interchange';

UPDATE net.design_node_editing SET geom = ST_Translate(geom, 60, -40) WHERE name = 'A';
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'a town that moves moves the interchange, which keeps its key', count(*) = 1 AND bool_and(ST_Distance(n.geom, p.geom) > 1) FROM net.design_node n JOIN place p USING (design_node_id) WHERE n.kind = 'interchange' AND NOT n.rejected;
SELECT 'the links keep their keys and ends', NOT EXISTS (SELECT * FROM former EXCEPT SELECT design_link_id, node_a, node_b, network FROM net.design_link WHERE NOT rejected);
SELECT 'and no row by hand is lost', test.lost() = 0;
SELECT 'nothing is stale, and nothing waits', sum(computed) = 0 FROM streetgen.design('net');
SELECT 'nothing waits', count(*) = 0 FROM streetgen.check_model('net') WHERE rule LIKE 'by hand, waits%';

DELETE FROM net.design_node_editing WHERE name = 'B';
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'links of a town that is deleted are out of the design', bool_and(rejected AND NOT by_hand) AND count(*) >= 3 FROM net.design_link WHERE 2 IN (node_a, node_b);
SELECT 'their rows by hand stay', test.lost() = 0;
SELECT 'each is a row of check_model', count(*) > 5 AND NOT EXISTS (SELECT FROM by_hand b JOIN net.design_link l ON l.design_link_id = b.link WHERE l.rejected
        AND NOT EXISTS (SELECT FROM streetgen.check_model('net') c WHERE c.rule LIKE 'by hand, waits%' AND c.severity = 'warning' AND c.id = b.id AND c.relation LIKE '%' || b.what || '%' AND c.measure >= 0 AND c.geom IS NOT NULL))
    FROM streetgen.check_model('net') WHERE rule LIKE 'by hand, waits%';
SELECT 'nothing else is left of them', NOT EXISTS (SELECT FROM net.axis JOIN net.design_link l ON split_part(source_ref, '/', 1)::bigint = l.design_link_id AND l.rejected)
    AND NOT EXISTS (SELECT FROM net.alignment_element JOIN net.design_link l USING (design_link_id) WHERE l.rejected) AND NOT EXISTS (SELECT FROM net.design_link WHERE rejected AND geom IS NOT NULL);
UPDATE net.design_node_editing SET rejected = false WHERE name = 'B';
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'with the town all links come back under their keys', NOT EXISTS (SELECT * FROM former EXCEPT SELECT design_link_id, node_a, node_b, network FROM net.design_link WHERE NOT rejected);
SELECT 'their rows by hand fit again', test.lost() = 0 AND count(*) = 0 FROM streetgen.check_model('net') WHERE rule LIKE 'by hand, waits%' OR severity = 'error' AND relation LIKE 'design%';
SELECT 'and their roads are there', bool_and(geom IS NOT NULL AND method IS NULL OR method LIKE 'breaks%') AND (SELECT count(DISTINCT split_part(source_ref, '/', 1)) FROM net.axis) = count(*) FROM net.design_link;

-- Another town in place of one: the nearest link goes on.
DELETE FROM net.design_node_editing WHERE name = 'D';
INSERT INTO net.design_node_editing (name, kind, importance, geom) VALUES ('D2', 'city', 91000, 'SRID=2154;POINT(905330 6450470)');
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'links go on to a town in the place of another', test.lost() = 0 AND count(*) = 0 FROM streetgen.check_model('net') WHERE rule LIKE 'by hand, waits%';
SELECT 'with their keys', count(*) = 0 FROM former WHERE design_link_id NOT IN (SELECT design_link_id FROM net.design_link WHERE NOT rejected);

-- A link without a way is not built, and comes back.
INSERT INTO net.zone_editing (class, geom) SELECT 'building', ST_Multi(ST_Difference(ST_Buffer(geom, 300), ST_Buffer(geom, 200))) FROM net.design_node WHERE name = 'E';
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'a town within walls has no way', count(*) > 1 AND bool_and(method LIKE 'no_path%') FROM net.design_link WHERE network = 'rural' AND NOT rejected;
SELECT 'its roads are gone from the axes', NOT EXISTS (SELECT FROM net.axis JOIN net.design_link l ON split_part(source_ref, '/', 1)::bigint = l.design_link_id AND l.method LIKE 'no_path%');
SELECT * FROM streetgen.generate('net') \g /dev/null
SELECT 'and are not built', NOT EXISTS (SELECT FROM net.section s JOIN net.edge e USING (edge_id) WHERE NOT EXISTS (SELECT FROM net.axis a WHERE a.axis_id = e.axis_id)) AND NOT EXISTS (SELECT FROM net.alignment_element e JOIN net.design_link l USING (design_link_id) WHERE method LIKE 'no_path%');
SELECT 'check_model tells each', count(*) FILTER (WHERE rule = 'link of the design without a way') = (SELECT count(*) FROM net.design_link WHERE method LIKE 'no_path%') FROM streetgen.check_model('net');
SELECT 'rows by hand stay without a way', test.lost() = 0;
DELETE FROM net.zone;
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'with a way they are built again', test.lost() = 0 AND count(*) > 1 AND bool_and(coalesce(method, '') NOT LIKE 'no_path%' AND geom IS NOT NULL AND EXISTS (SELECT FROM net.axis WHERE split_part(source_ref, '/', 1)::bigint = design_link_id)) FROM net.design_link WHERE network = 'rural' AND NOT rejected;

-- Towns that are drawn again.
SELECT test.make_network('drawn') \g /dev/null
DELETE FROM drawn.design_node;
SELECT 'towns are drawn', streetgen.design_nodes('drawn', 'SRID=2154;POLYGON((900300 6450300,905700 6450300,905700 6452700,900300 6452700,900300 6450300))', 8, 3) = 8;
SELECT * FROM streetgen.design('drawn') \g /dev/null
UPDATE drawn.grade_point_editing g SET height = height + 0.2 FROM (SELECT DISTINCT ON (design_link_id) grade_point_id FROM drawn.grade_point WHERE abscissa > 300 ORDER BY design_link_id, abscissa) f WHERE f.grade_point_id = g.grade_point_id;
SELECT * FROM streetgen.design('drawn') \g /dev/null
CREATE TABLE held AS SELECT grade_point_id, design_link_id FROM drawn.grade_point WHERE by_hand;
SELECT 'towns drawn again alike are the same', streetgen.design_nodes('drawn', 'SRID=2154;POLYGON((900300 6450300,905700 6450300,905700 6452700,900300 6452700,900300 6450300))', 8, 3) = 8 AND (SELECT sum(computed) FROM streetgen.design('drawn')) = 0;
SELECT streetgen.design_nodes('drawn', 'SRID=2154;POLYGON((900300 6450300,905700 6450300,905700 6452700,900300 6452700,900300 6450300))', 8, 4) \g /dev/null
SELECT * FROM streetgen.design('drawn', '{links}') \g /dev/null
SELECT 'others leave what is by hand', count(*) > 3 AND NOT EXISTS (SELECT * FROM held EXCEPT SELECT grade_point_id, design_link_id FROM drawn.grade_point WHERE by_hand) FROM held;
SELECT 'which waits', count(*) > 0 FROM streetgen.check_model('drawn') WHERE rule LIKE 'by hand, waits for its link%';
SELECT streetgen.design_nodes('drawn', 'SRID=2154;POLYGON((900300 6450300,905700 6450300,905700 6452700,900300 6452700,900300 6450300))', 8, 3) \g /dev/null
SELECT * FROM streetgen.design('drawn', '{links}') \g /dev/null
SELECT 'the first towns again, and it fits again', NOT EXISTS (SELECT * FROM held EXCEPT SELECT grade_point_id, design_link_id FROM drawn.grade_point g JOIN drawn.design_link l USING (design_link_id) WHERE g.by_hand AND NOT l.rejected);

-- A vertex between two others.
CREATE FUNCTION test.bulge(aside float8) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
    side record;
    fine boolean := true;
BEGIN
    FOR side IN SELECT * FROM (SELECT design_link_id, ordinality, lead(ordinality) OVER w AS next, geom AS a, lead(geom) OVER w AS b, ST_Distance(geom, lead(geom) OVER w) AS length FROM net.design_vertex WHERE NOT rejected
        WINDOW w AS (PARTITION BY design_link_id ORDER BY ordinality)) s WHERE length > 200 ORDER BY design_link_id, ordinality LIMIT 6
    LOOP
        BEGIN
            INSERT INTO net.design_vertex_editing (design_link_id, ordinality, geom) VALUES (side.design_link_id, (side.ordinality + side.next) / 2,
                ST_SetSRID(ST_Point((ST_X(side.a) + ST_X(side.b)) / 2 - aside * (ST_Y(side.b) - ST_Y(side.a)) / side.length, (ST_Y(side.a) + ST_Y(side.b)) / 2 + aside * (ST_X(side.b) - ST_X(side.a)) / side.length), 2154));
            fine := fine AND (SELECT ST_IsSimple(l.geom) AND ST_Length(l.geom) < 1.2 * (SELECT ST_Length(ST_MakeLine(p.geom ORDER BY p.ordinality)) FROM streetgen._link_places('net', l.design_link_id, true) p) FROM net.design_link l WHERE l.design_link_id = side.design_link_id);
            RAISE EXCEPTION 'back' USING ERRCODE = 'P0002';
        EXCEPTION WHEN no_data_found THEN NULL;
        END;
    END LOOP;
    RETURN fine;
END $$;
SELECT 'a vertex ' || aside || ' m beside a side ties no loop', test.bulge(aside) FROM unnest(ARRAY[-100, -60, 30, 60]) aside;

-- What cannot be is told in one line, with row, value and way out.
CREATE ROLE draughtsman ROLE CURRENT_USER;
GRANT USAGE ON SCHEMA test TO draughtsman;
SELECT streetgen.grant('net', 'draughtsman', 'editor') \g /dev/null
CREATE FUNCTION test.told(statement text, state text, wanted text) RETURNS boolean LANGUAGE plpgsql AS $$
DECLARE
    hint text;
BEGIN
    EXECUTE statement;
    RETURN false;
EXCEPTION WHEN others THEN
    GET STACKED DIAGNOSTICS hint = PG_EXCEPTION_HINT;
    IF SQLSTATE = state AND SQLERRM ~ wanted AND hint <> '' THEN
        RETURN true;
    END IF;
    RAISE WARNING '% % %', SQLSTATE, SQLERRM, hint;
    RETURN false;
END $$;
SET ROLE draughtsman;
SELECT 'an editor is told: ' || name, test.told(statement, state, wanted) FROM (VALUES
    ('a node at NaN', $$INSERT INTO net.design_node_editing (kind, geom) VALUES ('town', 'SRID=2154;POINT(NaN NaN)')$$, '22023', '^the geom of the design node has a coordinate'),
    ('a vertex at NaN', $$INSERT INTO net.design_vertex_editing (design_link_id, ordinality, geom) VALUES (1, 1.5, 'SRID=2154;POINT(NaN 3)')$$, '22023', '^the geom of the design vertex has a coordinate'),
    ('a zone at NaN', $$INSERT INTO net.zone_editing (class, geom) VALUES ('forest', 'SRID=2154;MULTIPOLYGON(((0 0, NaN 3, 4 4, 0 0)))')$$, '22023', '^the geom of the zone has a coordinate'),
    ('a radius of 50,000 of a standard', $$UPDATE net.design_standard_editing SET radius = 50000 WHERE speed = 60$$, '23514', '^the radius of design standard 4 cannot be 50000$'),
    ('a radius of 50,000 of a vertex', $$UPDATE net.design_vertex_editing SET radius = 50000 WHERE design_vertex_id = (SELECT min(design_vertex_id) FROM net.design_vertex WHERE by_hand AND NOT rejected)$$, '22023', '^link \d+ of the design: .*need'),
    ('a bend of 14 cm', $$UPDATE net.alignment_element_editing SET curvature_start = 7 WHERE alignment_element_id = (SELECT min(alignment_element_id) FROM net.alignment_element)$$, '22023', '^the curvature_start of alignment element'),
    ('a coil', $$UPDATE net.alignment_element_editing SET curvature_start = 0.2 WHERE alignment_element_id = (SELECT alignment_element_id FROM net.alignment_element ORDER BY length DESC, alignment_element_id LIMIT 1)$$, '22023', '^alignment element \d+ would turn by \d+ degrees$'),
    ('a coil to both sides', $$UPDATE net.alignment_element_editing SET curvature_start = 0.2, curvature_end = -0.2 WHERE alignment_element_id = (SELECT alignment_element_id FROM net.alignment_element ORDER BY length DESC, alignment_element_id LIMIT 1)$$, '22023', '^alignment element \d+ would turn by \d+ degrees$'),
    ('an importance of NaN', $$INSERT INTO net.design_node_editing (kind, importance, geom) VALUES ('town', 'NaN', 'SRID=2154;POINT(901500 6451500)')$$, '23514', '^the importance of design node.* cannot be NaN$'),
    ('a kind that is none', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (1, 'ford', 500, 520)$$, '23514', '^the kind of structure.* cannot be ford$'),
    ('a link that is not there', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (999, 'bridge', 500, 520)$$, '23503', '^the design_link_id of structure.* cannot be 999$'),
    ('a structure without a start', $$INSERT INTO net.structure_editing (design_link_id, kind, end_abscissa) VALUES (1, 'bridge', 520)$$, '23502', '^the start_abscissa of structure.* cannot be NULL$'),
    ('a structure that ends before it starts', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (1, 'bridge', 500, 400)$$, '23514', '^the (start|end)_abscissa, (start|end)_abscissa of structure.* cannot be'),
    ('a structure beyond the end', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (1, 'bridge', 90000, 90100)$$, '22023', '^the structure of link 1 lies at 90000 to 90100 m, and the link is [0-9.]+ m long$'),
    ('a structure across the end', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (1, 'bridge', 500, 90100)$$, '22023', '^the structure of link 1 lies at 500 to 90100 m'),
    ('a structure before the start', $$INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (1, 'bridge', -50, 100)$$, '22023', '^the structure of link 1 lies at -50 to 100 m'),
    ('a grade point beyond the end', $$INSERT INTO net.grade_point_editing (design_link_id, abscissa, height) VALUES (1, 90000, 400)$$, '22023', '^the grade point of link 1 lies at 90000 m')) v(name, statement, state, wanted);
RESET ROLE;
SELECT 'a node at NaN that is written past the views is named', test.told($$INSERT INTO net.design_node (name, kind, geom, by_hand) VALUES ('N', 'town', 'SRID=2154;POINT(NaN NaN)', true); SELECT * FROM streetgen.design('net')$$, '22023', '^node \d+ N of the design has a coordinate that is no place$');
DROP OWNED BY draughtsman; DROP ROLE draughtsman;
