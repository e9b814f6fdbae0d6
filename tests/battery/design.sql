-- Seed :seed of tests/battery/design: :edits random edits of every stage of a design, half of them of towns that move, come and go, and of what is by hand
-- on the roads between them. Rows by hand stay, the streets follow, and one design with the same rows by hand gives the same roads. Prints truths as the
-- files of tests/sql do.
\ir ../sql/shared/truths.sql
\ir ../sql/shared/made_terrain.sql
\ir ../sql/shared/made_design.sql
\ir ../sql/shared/made_network.sql
SELECT test.make_design('edited'), test.make_design('anew') \g /dev/null
SELECT * FROM streetgen.design('edited', links => '{1,2}') \g /dev/null
SELECT * FROM streetgen.generate('edited') \g /dev/null

-- The effect of an edit, and whether it was refused; a refused one leaves everything as it was. Edits of nodes, zones and classes are followed at once.
CREATE FUNCTION pg_temp.edit(turn integer) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    what constant integer := abs(hashint4(turn)) % 10;
    statement text;
BEGIN
    statement := CASE what
        WHEN 0 THEN format('UPDATE edited.design_vertex_editing SET geom = ST_Translate(geom, %s, %s) WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', 25 * sin(turn), 25 * cos(turn), turn)
        WHEN 1 THEN format('UPDATE edited.grade_point_editing SET height = height + %s WHERE grade_point_id = (SELECT grade_point_id FROM edited.grade_point WHERE NOT rejected AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', sin(turn), turn)
        WHEN 2 THEN format('DELETE FROM edited.grade_point_editing WHERE grade_point_id = (SELECT grade_point_id FROM edited.grade_point WHERE NOT rejected AND NOT by_hand AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', turn)
        WHEN 3 THEN format('INSERT INTO edited.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) VALUES (%s, ''bridge'', %s, %s)', 1 + turn % 2, 200 + 40 * (turn % 90), 220 + 40 * (turn % 90))
        WHEN 4 THEN 'UPDATE edited.design_crossing_editing SET kind = CASE kind WHEN ''level'' THEN ''over'' ELSE ''level'' END'
        WHEN 5 THEN format('DELETE FROM edited.design_vertex_editing WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', turn)
        WHEN 6 THEN format('UPDATE edited.design_node_editing SET geom = ST_Translate(geom, %s, %s) WHERE design_node_id = %s', 40 * sin(turn), 40 * cos(turn), 1 + turn % 4)
        WHEN 7 THEN format('INSERT INTO edited.zone_editing (class, geom) VALUES (''forest'', ST_Multi(ST_Buffer(ST_SetSRID(ST_Point(%s, %s), 2154), 60)))', 901000 + abs(hashint4(turn + 7)) % 4000, 6450500 + abs(hashint4(turn + 9)) % 2000)
        WHEN 8 THEN format('UPDATE edited.design_class_editing SET width = %s WHERE network = ''rural''', 10 + turn % 4)
        ELSE format('UPDATE edited.design_vertex_editing SET radius = 140 + %s %% 50, clothoid_in = 40, clothoid_out = 50 WHERE design_vertex_id = (SELECT design_vertex_id FROM edited.design_vertex WHERE NOT rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', turn, turn) END;
    EXECUTE statement;
    IF what BETWEEN 6 AND 8 THEN
        PERFORM streetgen.design('edited', links => '{1,2}');
    END IF;
    RETURN 'made';
EXCEPTION WHEN invalid_parameter_value THEN
    RETURN 'refused';
END $$;
CREATE TABLE made AS SELECT turn, pg_temp.edit(turn) AS outcome FROM generate_series(:edits * :seed, :edits * :seed + :edits - 1, 2) turn;
SELECT 'half of the edits are made', count(*) FILTER (WHERE outcome = 'made') >= :edits / 4 FROM made;
SELECT 'nothing is stale after them', sum(computed) = 0 FROM streetgen.design('edited', links => '{1,2}');
SELECT * FROM streetgen.generate('edited') \g /dev/null
SELECT 'no error in the streets', count(*) = 0 FROM streetgen.check_model('edited') WHERE severity = 'error' OR rule LIKE 'stale: the axis%';

UPDATE anew.design_node a SET geom = e.geom FROM edited.design_node e WHERE e.design_node_id = a.design_node_id;
UPDATE anew.design_class a SET width = e.width FROM edited.design_class e WHERE e.network = a.network;
INSERT INTO anew.zone (zone_id, class, geom, by_hand, rejected) SELECT zone_id, class, geom, by_hand, rejected FROM edited.zone;
INSERT INTO anew.design_vertex SELECT * FROM edited.design_vertex WHERE by_hand;
INSERT INTO anew.grade_point SELECT * FROM edited.grade_point WHERE by_hand;
INSERT INTO anew.structure SELECT * FROM edited.structure WHERE by_hand;
INSERT INTO anew.design_crossing SELECT * FROM edited.design_crossing WHERE by_hand;
SELECT setval(pg_get_serial_sequence('anew.' || r, r || '_id'), 100000) FROM unnest('{zone,design_vertex,grade_point,structure,design_crossing}'::text[]) r \g /dev/null
SELECT * FROM streetgen.design('anew', links => '{1,2}') \g /dev/null
SELECT 'one design with the rows by hand gives the same alignments', count(*) = 2 AND bool_and(ST_HausdorffDistance(a.geom, b.geom) < 1e-6 AND abs(ST_3DLength(a.geom) - ST_3DLength(b.geom)) < 1e-4) FROM edited.design_link a JOIN anew.design_link b USING (design_link_id);
SELECT 'and the same axes', NOT EXISTS (SELECT source_ref, level, round(ST_Length(geom)::numeric, 3) FROM edited.axis EXCEPT SELECT source_ref, level, round(ST_Length(geom)::numeric, 3) FROM anew.axis);
SELECT 'and keeps them as they are', NOT EXISTS (SELECT ordinality, geom, by_hand, rejected FROM edited.design_vertex WHERE by_hand EXCEPT SELECT ordinality, geom, by_hand, rejected FROM anew.design_vertex)
    AND NOT EXISTS (SELECT abscissa, height, by_hand, rejected FROM edited.grade_point WHERE by_hand EXCEPT SELECT abscissa, height, by_hand, rejected FROM anew.grade_point);
CREATE TABLE known AS SELECT xmin::text AS version, axis_id FROM edited.axis;
SELECT * FROM streetgen.design('edited', links => '{1,2}') \g /dev/null
SELECT 'a second design changes no row', NOT EXISTS (SELECT * FROM known EXCEPT SELECT xmin::text, axis_id FROM edited.axis);

-- Towns of a network: what is by hand on its roads is there after each edit, on a link or told.
SELECT test.make_network('net') \g /dev/null
SET streetgen.live = off;
DELETE FROM net.design_node WHERE name = 'E';
SELECT * FROM streetgen.design('net') \g /dev/null
CREATE FUNCTION pg_temp.by_hand() RETURNS text[] LANGUAGE plpgsql AS $$
BEGIN
    RETURN ARRAY(SELECT relation || ' ' || id FROM streetgen._rows_by_hand('net') ORDER BY relation, id);
END $$;
CREATE FUNCTION pg_temp.edit_network(turn integer) RETURNS text LANGUAGE plpgsql AS $$
DECLARE
    what constant integer := abs(hashint4(turn)) % 7;
    held constant text[] := pg_temp.by_hand();
    town constant text := 'A B C D';
BEGIN
    EXECUTE CASE what
        WHEN 0 THEN format('UPDATE net.design_node_editing SET geom = ST_Translate(geom, %s, %s) WHERE name = %L', 30 * sin(turn), 30 * cos(turn), split_part(town, ' ', 1 + turn % 4))
        WHEN 1 THEN format('UPDATE net.design_node_editing SET geom = ST_Translate(geom, %s, %s) WHERE name = %L', 120 * sin(turn), 120 * cos(turn), split_part(town, ' ', 1 + turn % 4))
        WHEN 2 THEN format('UPDATE net.design_node_editing SET rejected = NOT rejected, by_hand = true WHERE name = %L', split_part(town, ' ', 1 + turn % 4))
        WHEN 3 THEN format('UPDATE net.design_vertex_editing SET geom = ST_Translate(geom, %s, %s) WHERE design_vertex_id = (SELECT design_vertex_id FROM net.design_vertex JOIN net.design_link USING (design_link_id) WHERE NOT design_vertex.rejected AND NOT design_link.rejected ORDER BY md5(%L || ordinality || design_link_id) LIMIT 1)', 15 * sin(turn), 15 * cos(turn), turn)
        WHEN 4 THEN format('UPDATE net.grade_point_editing SET height = height + %s WHERE grade_point_id = (SELECT grade_point_id FROM net.grade_point JOIN net.design_link USING (design_link_id) WHERE NOT grade_point.rejected AND NOT design_link.rejected AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', sin(turn) / 2, turn)
        WHEN 5 THEN format('INSERT INTO net.structure_editing (design_link_id, kind, start_abscissa, end_abscissa) SELECT design_link_id, ''bridge'', %s, %s FROM net.design_link WHERE NOT rejected ORDER BY md5(%L || design_link_id) LIMIT 1', 100 + 10 * (turn % 90), 120 + 10 * (turn % 90), turn)
        ELSE format('DELETE FROM net.grade_point_editing WHERE grade_point_id = (SELECT grade_point_id FROM net.grade_point JOIN net.design_link USING (design_link_id) WHERE NOT grade_point.rejected AND NOT design_link.rejected AND NOT grade_point.by_hand AND abscissa > 300 ORDER BY md5(%L || round(abscissa)) LIMIT 1)', turn) END;
    IF what < 3 THEN
        PERFORM streetgen.design('net');
    END IF;
    RETURN CASE WHEN held <@ pg_temp.by_hand() THEN 'made' ELSE 'lost' END;
EXCEPTION WHEN invalid_parameter_value THEN
    RETURN 'refused';
END $$;
CREATE TABLE moved AS SELECT turn, pg_temp.edit_network(turn) AS outcome FROM generate_series(:edits * :seed + 1, :edits * :seed + :edits, 2) turn;
SELECT 'no row by hand is lost where towns move, come and go', count(*) FILTER (WHERE outcome = 'lost') = 0 FROM moved;
SELECT 'and half of these edits are made', count(*) FILTER (WHERE outcome = 'made') >= :edits / 4 FROM moved;
UPDATE net.design_node_editing SET rejected = false, by_hand = true WHERE rejected \g /dev/null
SELECT * FROM streetgen.design('net') \g /dev/null
SELECT 'nothing is stale after them', sum(computed) = 0 FROM streetgen.design('net');
SELECT 'what is by hand lies on a link, or is told', count(*) = 0 FROM (SELECT design_vertex_id AS id, 'design_vertex' AS relation, design_link_id FROM net.design_vertex WHERE by_hand UNION ALL SELECT grade_point_id, 'grade_point', design_link_id FROM net.grade_point WHERE by_hand
        UNION ALL SELECT structure_id, 'structure', design_link_id FROM net.structure WHERE by_hand) h
    JOIN net.design_link l USING (design_link_id) WHERE l.rejected AND NOT EXISTS (SELECT FROM streetgen.check_model('net') c WHERE c.relation = h.relation AND c.id = h.id AND c.rule LIKE 'by hand, waits%');
SELECT 'only links of the design have axes', NOT EXISTS (SELECT FROM net.axis WHERE source = 'design' AND NOT EXISTS (SELECT FROM net.design_link WHERE design_link_id = split_part(source_ref, '/', 1)::bigint AND NOT rejected AND coalesce(method, '') NOT LIKE 'no_path%'));
