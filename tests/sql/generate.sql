-- The one query: same result however one gets there, and nothing half done. Rows (name, holds).
SET client_min_messages = warning;
CREATE FUNCTION pg_temp.sqlstate_of(statement text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN EXECUTE statement; RETURN '00000'; EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;
-- A jittered grid of streets with side streets: seeded, of awkward angles, widths and lengths.
CREATE FUNCTION pg_temp.town(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, 2154);
    PERFORM setseed(0.42);
    CREATE TEMPORARY TABLE IF NOT EXISTS place AS
        SELECT x, y, 650000 + 60 * x + 14 * random() AS px, 6860000 + 60 * y + 14 * random() AS py, random() AS dice FROM generate_series(0, 7) x, generate_series(0, 7) y ORDER BY x, y;
    EXECUTE format($q$INSERT INTO %I.axis (geom, width, importance, source, source_ref)
        SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(a.px, a.py), ST_MakePoint(b.px, b.py)), 2154), 4 + round((12 * a.dice)::numeric, 1), 1 + (a.dice * 5)::integer, 'town', a.x || ',' || a.y || ',' || b.x
        FROM place a JOIN place b ON (b.x, b.y) IN ((a.x + 1, a.y), (a.x, a.y + 1)) ORDER BY a.x, a.y, b.x, b.y$q$, model);
END $$;
CREATE FUNCTION pg_temp.picture(model name) RETURNS text LANGUAGE plpgsql AS $$
DECLARE it text;
BEGIN
    EXECUTE format($q$SELECT md5(string_agg(row, E'\n' ORDER BY row)) FROM (
        SELECT concat_ws('|', 'edge', axis_id, start_abscissa, end_abscissa, geom::text, width) AS row FROM %1$I.edge
        UNION ALL SELECT concat_ws('|', 'limit', axis_id, start_abscissa, which, abscissa, border_line::text, method) FROM %1$I.section_limit JOIN %1$I.edge USING (edge_id)
        UNION ALL SELECT concat_ws('|', 'section', axis_id, start_abscissa, surface::text, method) FROM %1$I.section JOIN %1$I.edge USING (edge_id)
        UNION ALL SELECT concat_ws('|', 'corner', a.axis_id, end_a, b.axis_id, end_b, radius, arc::text, method) FROM %1$I.corner JOIN %1$I.edge a ON a.edge_id = edge_a JOIN %1$I.edge b ON b.edge_id = edge_b
        UNION ALL SELECT concat_ws('|', 'intersection', n.geom::text, surface::text, method) FROM %1$I.intersection JOIN %1$I.node n USING (node_id)) q$q$, model) INTO it;
    RETURN it;
END $$;
SELECT pg_temp.town(m) FROM unnest(ARRAY['whole', 'single', 'halves']) m \g /dev/null
SELECT 'generate inserts', bool_or(inserted > 0) FROM streetgen.generate('whole');
SELECT 'no row of severity error', count(*) = 0 FROM streetgen.check_model('whole') WHERE severity = 'error';
CREATE TEMPORARY TABLE version AS SELECT 'edge' AS t, edge_id AS id, ctid::text AS c, xmin::text AS x FROM whole.edge UNION ALL SELECT 'section', edge_id, ctid::text, xmin::text FROM whole.section
    UNION ALL SELECT 'corner', corner_id, ctid::text, xmin::text FROM whole.corner UNION ALL SELECT 'intersection', node_id, ctid::text, xmin::text FROM whole.intersection
    UNION ALL SELECT 'limit', section_limit_id, ctid::text, xmin::text FROM whole.section_limit UNION ALL SELECT 'node', node_id, ctid::text, xmin::text FROM whole.node;
SELECT 'a second run reports no change', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('whole');
SELECT 'a second run keeps ctid and xmin of every row', count(*) = 0 FROM (
    SELECT 'edge' AS t, edge_id AS id, ctid::text AS c, xmin::text AS x FROM whole.edge UNION ALL SELECT 'section', edge_id, ctid::text, xmin::text FROM whole.section
    UNION ALL SELECT 'corner', corner_id, ctid::text, xmin::text FROM whole.corner UNION ALL SELECT 'intersection', node_id, ctid::text, xmin::text FROM whole.intersection
    UNION ALL SELECT 'limit', section_limit_id, ctid::text, xmin::text FROM whole.section_limit UNION ALL SELECT 'node', node_id, ctid::text, xmin::text FROM whole.node
    EXCEPT SELECT * FROM version) d;
DO $$ DECLARE id bigint; BEGIN FOR id IN SELECT axis_id FROM single.axis ORDER BY md5(axis_id::text) LOOP PERFORM streetgen.generate('single', ARRAY[id]); END LOOP; END $$;
SELECT 'axis by axis equals all at once', pg_temp.picture('single') = pg_temp.picture('whole');
DO $$ BEGIN PERFORM streetgen.generate('halves', (SELECT array_agg(axis_id) FROM halves.axis WHERE axis_id % 2 = 0)); PERFORM streetgen.generate('halves', (SELECT array_agg(axis_id) FROM halves.axis WHERE axis_id % 2 = 1)); END $$;
SELECT 'by halves equals all at once', pg_temp.picture('halves') = pg_temp.picture('whole');
SELECT 'an empty list does nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('whole', '{}');
SELECT 'an unknown axis does nothing', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('whole', '{424242}');

-- An edit and back: what is far keeps its rows, what comes back is equal.
CREATE TEMPORARY TABLE before AS SELECT pg_temp.picture('whole') AS picture;
UPDATE whole.axis SET width = 20 WHERE axis_id = 1;
SELECT 'check_model tells that an axis changed', count(*) = 1 FROM streetgen.check_model('whole') WHERE rule = 'stale: the axis changed since' AND id = 1;
SELECT 'an edit updates few rows', sum(updated) BETWEEN 1 AND 40 FROM streetgen.generate('whole', '{1}');
SELECT 'an edit by its axis equals a run over all', bool_and(inserted + updated + deleted = 0) FROM streetgen.generate('whole');
UPDATE whole.axis SET width = (SELECT width FROM single.axis s WHERE s.axis_id = 1) WHERE axis_id = 1;
SELECT 'taking the edit back updates', bool_or(updated > 0) FROM streetgen.generate('whole', '{1}');
SELECT 'and brings the model back', pg_temp.picture('whole') = (SELECT picture FROM before);
DELETE FROM whole.axis WHERE axis_id = 5;
SELECT 'the leftovers of a deleted axis stay until generate, and are told', EXISTS (SELECT FROM whole.edge WHERE axis_id = 5) AND EXISTS (SELECT FROM streetgen.check_model('whole') WHERE rule = 'stale: the axis is gone');
SELECT 'generate goes on after a deleted axis', bool_or(updated > 0) FROM streetgen.generate('whole');
SELECT 'and the model is sound', count(*) = 0 FROM streetgen.check_model('whole') WHERE severity = 'error';

-- A violation in mid-run leaves every table as it was.
CREATE TEMPORARY TABLE sound AS SELECT pg_temp.picture('single') AS picture;
UPDATE single.axis SET width = 30;
ALTER TABLE single.intersection ADD CONSTRAINT planted CHECK (ST_Area(surface) < 1) NOT VALID;
SELECT 'a planted violation fails the run', pg_temp.sqlstate_of($$SELECT * FROM streetgen.generate('single')$$) = '23514';
SELECT 'and leaves every table unchanged', pg_temp.picture('single') = picture FROM sound;
ALTER TABLE single.intersection DROP CONSTRAINT planted;

BEGIN ISOLATION LEVEL REPEATABLE READ;
SELECT 'above read committed: 0A000', pg_temp.sqlstate_of($$SELECT * FROM streetgen.generate('halves')$$) = '0A000';
COMMIT;

-- Levels, crossings and classes.
SELECT streetgen.create_model('levels', 2154) \g /dev/null
INSERT INTO levels.axis (geom, width, level) VALUES ('SRID=2154;LINESTRING(0 0,100 0)', 7, 0), ('SRID=2154;LINESTRING(50 -50,50 0,50 50)', 7, 1), ('SRID=2154;LINESTRING(50 50,50 100)', 7, 0), ('SRID=2154;LINESTRING(20 -40,20 40)', 7, 0);
DO $$ BEGIN PERFORM streetgen.generate('levels'); END $$;
SELECT 'a bridge passes over: no node', NOT EXISTS (SELECT FROM levels.node WHERE ST_DWithin(geom, 'SRID=2154;POINT(50 0)', 1));
SELECT 'levels meet at a shared end', EXISTS (SELECT FROM levels.node WHERE ST_DWithin(geom, 'SRID=2154;POINT(50 50)', 0.01));
SELECT 'a crossing without a vertex is a notice', count(*) = 1 FROM streetgen.check_model('levels') WHERE severity = 'notice' AND rule = 'crossing';
SELECT streetgen.set('levels', 'crossing', 'split') \g /dev/null
SELECT count(*) FROM streetgen.generate('levels') \g /dev/null
SELECT 'with split it becomes a node', EXISTS (SELECT FROM levels.intersection i JOIN levels.node n USING (node_id) WHERE ST_DWithin(n.geom, 'SRID=2154;POINT(20 0)', 0.01));
SELECT 'svg draws', streetgen.svg('levels') LIKE '<svg%</svg>' || E'\n';
