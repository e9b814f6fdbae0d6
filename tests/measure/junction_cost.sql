-- The cost of the axes of the model of variable model with variable subjects: prints axes, processor seconds of a first run, and processor milliseconds of an edit,
-- the mean of 80 axes widened by 0.3 m.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' '
SELECT streetgen.create_model('timed', srid, dimension, :'subjects'::text[]) FROM streetgen.model WHERE name = :'model' \g /dev/null
UPDATE timed.setting t SET value = s.value FROM :"model".setting s WHERE s.name = t.name AND s.value IS DISTINCT FROM t.value;
DELETE FROM timed.axis_class;
INSERT INTO timed.axis_class SELECT * FROM :"model".axis_class;
SELECT streetgen.live('timed', false) \g /dev/null
INSERT INTO timed.axis SELECT * FROM :"model".axis;
INSERT INTO timed.control_point SELECT * FROM :"model".control_point;
INSERT INTO timed.turn_restriction SELECT * FROM :"model".turn_restriction;
SELECT pg_backend_pid() AS pid \gset
\set hertz `getconf CLK_TCK`
\set ticks `cut -d' ' -f14,15 /proc/:pid/stat | tr ' ' '+'`
SELECT :ticks AS before \gset
SELECT count(*) FROM streetgen.generate('timed') \g /dev/null
\set ticks `cut -d' ' -f14,15 /proc/:pid/stat | tr ' ' '+'`
SELECT :ticks AS after \gset
SELECT streetgen.live('timed', true) \g /dev/null
CREATE FUNCTION pg_temp.widen(most integer) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
    edited bigint;
BEGIN
    FOR edited IN SELECT axis_id FROM timed.axis ORDER BY hashint8(axis_id) LIMIT most LOOP
        UPDATE timed.axis SET width = coalesce(width, 6) + 0.3 WHERE axis_id = edited;
    END LOOP;
END $$;
ANALYZE;
SELECT pg_temp.widen(10) \g /dev/null
\set ticks `cut -d' ' -f14,15 /proc/:pid/stat | tr ' ' '+'`
SELECT :ticks AS began \gset
SELECT pg_temp.widen(80) \g /dev/null
\set ticks `cut -d' ' -f14,15 /proc/:pid/stat | tr ' ' '+'`
SELECT count(*), round((:after - :before)::numeric / :hertz, 1), round(1000 * (:ticks - :began)::numeric / :hertz / 80, 1) FROM timed.axis;
SELECT streetgen.drop_model('timed') \g /dev/null
