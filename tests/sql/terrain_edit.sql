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
