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
