\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
\ir shared/made_design.sql
-- Who edits a design, and where two roads of it cross. tests/battery/design edits one at random.
SELECT test.make_design('edited') \g /dev/null
SELECT * FROM streetgen.design('edited', links => '{1,2}') \g /dev/null
SELECT * FROM streetgen.generate('edited') \g /dev/null
SELECT 'the roads cross at one height', count(*) = 1 AND bool_and(kind = 'level' AND abs(a.z - b.z) < 1e-5) FROM edited.design_crossing c,
    LATERAL streetgen._alignment_point(streetgen._link_elements('edited', design_link_id), streetgen._link_grades('edited', design_link_id), abscissa) a,
    LATERAL streetgen._alignment_point(streetgen._link_elements('edited', other_link_id), streetgen._link_grades('edited', other_link_id), other_abscissa) b;
-- What is computed anew of a row by hand too cannot be typed: the row would be by hand, and what was typed lost.
SELECT format('%s.%s is computed, and refused', relation, attribute), r.state = '0A000' AND r.said ~ format('^the %s of %s \d+ cannot be changed$', attribute, replace(relation, '_', ' ')) AND r.hint ~ 'can be changed'
  FROM (VALUES ('design_link', 'length', 'coalesce(length, 0) + 1'), ('design_link', 'utilisation', 'coalesce(utilisation, 0) + 1'), ('design_link', 'benefit', 'coalesce(benefit, 0) + 1'), ('design_link', 'cost', 'coalesce(cost, 0) + 1'), ('design_link', 'method', '''x'''), ('design_link', 'geom', 'ST_Translate(geom, 1, 0)'),
    ('design_crossing', 'abscissa', 'abscissa + 1'), ('design_crossing', 'other_abscissa', 'other_abscissa + 1'), ('design_crossing', 'geom', 'ST_Translate(geom, 1, 0)'), ('grade_point', 'geom', 'ST_Translate(geom, 1, 0)')) v(relation, attribute, value),
    LATERAL test.refusal(format('UPDATE edited.%1$s_editing SET %2$s = %3$s WHERE %1$s_id = (SELECT min(%1$s_id) FROM edited.%1$s_editing WHERE NOT rejected)', relation, attribute, value)) r;
SELECT 'a row that is sent back as it is stays computed: ' || relation, test.state(format('UPDATE edited.%1$s_editing SET %2$s = %2$s', relation, attribute)) = 'none' FROM (VALUES ('design_link', 'cost'), ('design_crossing', 'kind'), ('grade_point', 'height')) v(relation, attribute);
SELECT 'and none of them is by hand', NOT EXISTS (SELECT FROM edited.design_crossing WHERE by_hand UNION ALL SELECT FROM edited.grade_point WHERE by_hand);
-- Who may edit axes may edit a design, and nobody else.
CREATE ROLE draughtsman ROLE CURRENT_USER; CREATE ROLE visitor ROLE CURRENT_USER;
SELECT streetgen.grant('edited', 'draughtsman', 'editor'), streetgen.grant('edited', 'visitor', 'reader') \g /dev/null
SET ROLE draughtsman;
SELECT 'an editor edits a grade point', test.state('UPDATE edited.grade_point_editing SET height = height + 0.1 WHERE grade_point_id = (SELECT max(grade_point_id) - 3 FROM edited.grade_point WHERE NOT rejected)') IN ('none', '22023');
SELECT 'but writes no table of the design', test.state('UPDATE edited.grade_point SET height = 0') = '42501';
RESET ROLE; SET ROLE visitor;
SELECT 'a reader reads, and edits nothing', test.state('SELECT * FROM edited.grade_point_editing') = 'none' AND test.state('DELETE FROM edited.grade_point_editing') = '42501';
RESET ROLE;
DROP OWNED BY draughtsman, visitor; DROP ROLE draughtsman, visitor;
-- A radius by hand that fitted is cut where the road beside it moved, and told: one point must not stop the design.
CREATE TABLE point AS SELECT grade_point_id, design_link_id, abscissa, height FROM edited.grade_point WHERE design_link_id = 1 AND NOT rejected ORDER BY abscissa OFFSET 3 LIMIT 1;
SELECT 'a radius for which there is room is taken', test.state('UPDATE edited.grade_point_editing SET radius = 900 WHERE grade_point_id = (SELECT grade_point_id FROM point)') = 'none';
SELECT 'one for which there is none is refused', r.state = '22023' AND r.said ~ '^the radius of grade point \d+ of link 1 cannot be 9000000' AND r.detail ~ 'There is room for a radius of \d+ m' AND r.hint ~ 'smaller' FROM test.refusal('UPDATE edited.grade_point_editing SET radius = 9e6, height = height + 4 WHERE grade_point_id = (SELECT grade_point_id FROM point)') r;
-- As by a move of the road: the height beside it changes so much that the parabola has no room.
UPDATE edited.grade_point SET radius = 1e6, height = height + 5 WHERE grade_point_id = (SELECT grade_point_id FROM point);
SELECT 'a design goes on where a radius has no room any more', test.state('SELECT * FROM streetgen.design(''edited'', links => ''{1,2}'')') = 'none';
SELECT 'the radius by hand stays', radius = 1e6 AND by_hand FROM edited.grade_point JOIN point USING (grade_point_id);
SELECT 'the road has what there is room for', p.radius BETWEEN 1 AND 1e5 FROM point, streetgen._link_grade_points('edited', 1) p WHERE p.grade_point_id = point.grade_point_id;
SELECT 'and check_model tells it', count(*) = 1 FROM streetgen.check_model('edited') c JOIN point ON c.id = grade_point_id WHERE rule = 'by hand, radius cut to the room that there is, m' AND relation = 'grade_point';
DELETE FROM edited.grade_point_editing WHERE grade_point_id = (SELECT grade_point_id FROM point);
-- What a new row says is taken or refused, and what it became is told.
SELECT 'a new row that gives what is computed is refused: ' || relation, r.state = '0A000' AND r.said = format('the %s of a new %s cannot be given', attribute, replace(relation, '_', ' ')) AND r.hint ~ 'can be given'
  FROM (VALUES ('design_link', 'cost', 'node_a, node_b, network', '1, 3, ''rural''', '1'), ('grade_point', 'geom', 'design_link_id, abscissa, height', '1, 210, 40', '''SRID=2154;POINT Z (0 0 0)'''),
    ('structure', 'geom', 'design_link_id, kind, start_abscissa, end_abscissa', '1, ''bridge'', 10, 20', '''SRID=2154;LINESTRING Z (0 0 0, 1 1 1)'''), ('design_crossing', 'abscissa', 'design_link_id, other_link_id, kind, geom', '1, 2, ''over'', ''SRID=2154;POINT(0 0)''', '4')) v(relation, attribute, columns, vals, value),
    LATERAL test.refusal(format('INSERT INTO edited.%s_editing (%s, %s) VALUES (%s, %s)', relation, columns, attribute, vals, value)) r;
INSERT INTO edited.grade_point_editing (design_link_id, abscissa, height) SELECT 1, abscissa + 10, height FROM point RETURNING grade_point_id AS new_point, by_hand, geom IS NOT NULL AS placed \gset
SELECT 'a new row is returned with its key, and as it became', :'by_hand' AND :'placed' AND EXISTS (SELECT FROM edited.grade_point WHERE grade_point_id = :new_point AND by_hand);
SELECT name || ' is refused', r.state = v.state AND r.said ~ wanted AND r.hint <> ''
  FROM (VALUES ('a vertex without a number', 'INSERT INTO edited.design_vertex_editing (design_link_id, ordinality, geom) SELECT 1, ''NaN'', geom FROM edited.design_node LIMIT 1', '22023', '^the ordinality of the design vertex cannot be NaN'),
    ('a vertex far off the order', 'INSERT INTO edited.design_vertex_editing (design_link_id, ordinality, geom) SELECT 1, 1e300, geom FROM edited.design_node LIMIT 1', '22023', '^the ordinality of the design vertex cannot be 1e\+300'),
    ('a number that another vertex has', 'INSERT INTO edited.design_vertex_editing (design_link_id, ordinality, geom) SELECT design_link_id, ordinality, geom FROM edited.design_vertex WHERE NOT rejected ORDER BY design_vertex_id LIMIT 1', '23505', '^the ordinality of the design vertex cannot be'),
    ('a number that another element has', 'INSERT INTO edited.alignment_element_editing (design_link_id, ordinality, kind, abscissa, start, heading, length, curvature_start, curvature_end) SELECT design_link_id, ordinality, kind, abscissa, start, heading, length, curvature_start, curvature_end FROM edited.alignment_element WHERE NOT rejected ORDER BY alignment_element_id LIMIT 1', '23505', '^the ordinality of the alignment element cannot be 1'),
    ('an element beyond those after it', 'UPDATE edited.alignment_element_editing SET abscissa = 1e6 WHERE design_link_id = 1 AND ordinality = 2', '22023', '^the abscissa of the alignment element \d+ cannot be 1000000'),
    ('an element before its link', 'UPDATE edited.alignment_element_editing SET abscissa = -5 WHERE design_link_id = 1 AND ordinality = 1', '22023', '^the abscissa of the alignment element \d+ cannot be -5')) v(name, statement, state, wanted),
    LATERAL test.refusal(statement) r;
-- A statement over several rows of one link, and two in one transaction: each is kept, whatever the first of them computes anew.
CREATE TABLE three AS SELECT grade_point_id, height FROM edited.grade_point WHERE design_link_id = 1 AND NOT rejected AND NOT by_hand ORDER BY abscissa OFFSET 2 LIMIT 3;
UPDATE edited.grade_point_editing SET height = height + 0.05 WHERE grade_point_id IN (SELECT grade_point_id FROM three);
SELECT 'each grade point of a statement is kept', count(*) = 3 AND bool_and(g.by_hand AND abs(g.height - t.height - 0.05) < 1e-9) FROM three t JOIN edited.grade_point g USING (grade_point_id);
DELETE FROM edited.grade_point_editing WHERE grade_point_id IN (SELECT grade_point_id FROM three);
SELECT 'and each that a statement deletes is rejected', count(*) = 3 AND bool_and(g.rejected) FROM three t JOIN edited.grade_point g USING (grade_point_id);
CREATE TABLE elements AS SELECT alignment_element_id, ordinality, length FROM edited.alignment_element WHERE design_link_id = 2 AND ordinality IN (1, 3);
UPDATE edited.alignment_element_editing SET length = length + 0.0002 WHERE alignment_element_id IN (SELECT alignment_element_id FROM elements);
SELECT 'each element of a statement is kept', count(*) = 2 AND bool_and(e.by_hand AND e.ordinality = o.ordinality AND abs(e.length - o.length - 0.0002) < 1e-9) FROM elements o JOIN edited.alignment_element e USING (alignment_element_id);
