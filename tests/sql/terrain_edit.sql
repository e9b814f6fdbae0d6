\set ECHO none
\ir shared/truths.sql
\ir shared/made_terrain.sql
-- Random edits of a design: rows by hand stay, the streets follow, and one design with the same rows by hand gives the same roads.

CREATE FUNCTION pg_temp.make(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, srid => 2154, dimension => 3), streetgen.create_design(model);
    EXECUTE format($f$
        INSERT INTO %1$I.terrain_tile (geom, heights) SELECT ST_MakeEnvelope(900000 + 3000 * i, 6450000, 903000 + 3000 * i, 6453000, 2154), test.tile(900000 + 3000 * i, 6453000, 50, 60, '400 + 40 * sin(x / 600.0) * cos(y / 800.0)') FROM generate_series(0, 1) i;
        INSERT INTO %1$I.design_node (design_node_id, name, kind, importance, geom, by_hand) VALUES (1, 'A', 'city', 200000, 'SRID=2154;POINT(900500 6451000)', true), (2, 'B', 'city', 90000, 'SRID=2154;POINT(905500 6451500)', true),
            (3, 'C', 'village', 900, 'SRID=2154;POINT(902500 6452700)', true), (4, 'D', 'village', 700, 'SRID=2154;POINT(903500 6450300)', true);
        INSERT INTO %1$I.design_link (design_link_id, node_a, node_b, network, by_hand) VALUES (1, 1, 2, 'secondary', true), (2, 3, 4, 'rural', true) $f$, model);
END $$;
SELECT pg_temp.make('edited'), pg_temp.make('anew') \g /dev/null
SELECT * FROM streetgen.design('edited', links => '{1,2}') \g /dev/null
SELECT * FROM streetgen.generate('edited') \g /dev/null
SELECT 'the roads cross at one height', count(*) = 1 AND bool_and(kind = 'level' AND abs(a.z - b.z) < 1e-5) FROM edited.design_crossing c,
    LATERAL streetgen._alignment_point(streetgen._link_elements('edited', design_link_id), streetgen._link_grades('edited', design_link_id), abscissa) a,
    LATERAL streetgen._alignment_point(streetgen._link_elements('edited', other_link_id), streetgen._link_grades('edited', other_link_id), other_abscissa) b;

-- What an edit does, and whether it was refused; a refused one leaves everything as it was.
CREATE FUNCTION pg_temp.edit(turn integer) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    what constant integer := turn % 7;
    statement text;
BEGIN
    statement := CASE what
        WHEN 0 THEN format('UPDATE edited.design_vertex_editing SET geom = ST_Translate(geom, %s, %s) WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', 25 * sin(turn), 25 * cos(turn), turn)
        WHEN 1 THEN format('UPDATE edited.grade_point_editing SET height = height + %s WHERE grade_point_id = (SELECT grade_point_id FROM edited.grade_point WHERE NOT rejected AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', sin(turn), turn)
        WHEN 2 THEN format('DELETE FROM edited.grade_point_editing WHERE grade_point_id = (SELECT grade_point_id FROM edited.grade_point WHERE NOT rejected AND NOT by_hand AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', turn)
        WHEN 3 THEN format('INSERT INTO edited.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (%s, ''bridge'', %s, %s)', 1 + turn % 2, 200 + 40 * turn, 220 + 40 * turn)
        WHEN 4 THEN 'UPDATE edited.design_crossing_editing SET kind = CASE kind WHEN ''level'' THEN ''over'' ELSE ''level'' END'
        WHEN 5 THEN format('DELETE FROM edited.design_vertex_editing WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', turn)
        ELSE format('UPDATE edited.design_vertex_editing SET radius = 140 + %s, clothoid_in = 40, clothoid_out = 50 WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', turn, turn) END;
    EXECUTE statement;
    RETURN 'made';
EXCEPTION WHEN invalid_parameter_value THEN
    RETURN 'refused';
END $$;
CREATE TABLE made AS SELECT turn, pg_temp.edit(turn) AS outcome FROM generate_series(1, 20) turn;
SELECT 'most edits are made', count(*) FILTER (WHERE outcome = 'made') >= 12 FROM made;
SELECT 'nothing is stale after them', sum(computed) = 0 FROM streetgen.design('edited', links => '{1,2}');
SELECT 'no error in the streets', count(*) = 0 FROM streetgen.check_model('edited') WHERE severity = 'error' OR rule LIKE 'stale: the axis%';

INSERT INTO anew.design_vertex SELECT * FROM edited.design_vertex WHERE by_hand;
INSERT INTO anew.grade_point SELECT * FROM edited.grade_point WHERE by_hand;
INSERT INTO anew.structure SELECT * FROM edited.structure WHERE by_hand;
INSERT INTO anew.design_crossing SELECT * FROM edited.design_crossing WHERE by_hand;
SELECT setval(pg_get_serial_sequence('anew.' || r, r || '_id'), 100000) FROM unnest('{design_vertex,grade_point,structure,design_crossing}'::text[]) r \g /dev/null
SELECT * FROM streetgen.design('anew', links => '{1,2}') \g /dev/null
SELECT 'one design with the rows by hand gives the same alignments', count(*) = 2 AND bool_and(ST_HausdorffDistance(a.geom, b.geom) < 1e-6 AND abs(ST_3DLength(a.geom) - ST_3DLength(b.geom)) < 1e-4) FROM edited.design_link a JOIN anew.design_link b USING (design_link_id);
SELECT 'and the same axes', NOT EXISTS (SELECT source_ref, level, round(ST_Length(geom)::numeric, 3) FROM edited.axis EXCEPT SELECT source_ref, level, round(ST_Length(geom)::numeric, 3) FROM anew.axis);
SELECT 'and keeps them as they are', NOT EXISTS (SELECT ordinality, geom, by_hand, rejected FROM edited.design_vertex WHERE by_hand EXCEPT SELECT ordinality, geom, by_hand, rejected FROM anew.design_vertex)
    AND NOT EXISTS (SELECT abscissa, height, by_hand, rejected FROM edited.grade_point WHERE by_hand EXCEPT SELECT abscissa, height, by_hand, rejected FROM anew.grade_point);
CREATE TABLE known AS SELECT xmin::text AS version, axis_id FROM edited.axis;
SELECT * FROM streetgen.design('edited', links => '{1,2}') \g /dev/null
SELECT 'a second design changes no row', NOT EXISTS (SELECT * FROM known EXCEPT SELECT xmin::text, axis_id FROM edited.axis);

-- Who may edit axes may edit a design, and nobody else.
CREATE ROLE draughtsman; CREATE ROLE visitor;
SELECT streetgen.grant('edited', 'draughtsman', 'editor'), streetgen.grant('edited', 'visitor', 'reader') \g /dev/null
SET ROLE draughtsman;
SELECT 'an editor edits a grade point', test.state('UPDATE edited.grade_point_editing SET height = height + 0.1 WHERE grade_point_id = (SELECT max(grade_point_id) - 3 FROM edited.grade_point WHERE NOT rejected)') IN ('none', '22023');
SELECT 'but writes no table of the design', test.state('UPDATE edited.grade_point SET height = 0') = '42501';
RESET ROLE; SET ROLE visitor;
SELECT 'a reader reads, and edits nothing', test.state('SELECT * FROM edited.grade_point_editing') = 'none' AND test.state('DELETE FROM edited.grade_point_editing') = '42501';
RESET ROLE;
DROP OWNED BY draughtsman, visitor; DROP ROLE draughtsman, visitor;
