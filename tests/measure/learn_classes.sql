-- What learn_classes saves: psql -v model=MODEL, whose streets need no run.  Every other axis that states its width is asked to forget it, and its
-- lanes; the mean error of the widths used there, metres, by the classes as they are, and as the other half says.
BEGIN;
CREATE TEMPORARY TABLE known AS SELECT axis_id, u.width, a.kind, row_number() OVER (ORDER BY axis_id) % 2 = 0 AS asked
FROM :"model".axis_used u JOIN :"model".axis a USING (axis_id) WHERE 'width' <> ALL (estimated);
UPDATE :"model".axis SET width = NULL, width_end = NULL, lane_count = NULL, lanes_forward = NULL, lanes_backward = NULL, lanes_both = NULL, kind_forward = NULL,
    kind_backward = NULL, lane_width_forward = NULL, lane_width_backward = NULL, turn_forward = NULL, turn_backward = NULL, change_forward = NULL, change_backward = NULL
WHERE axis_id IN (SELECT axis_id FROM known WHERE asked);
CREATE TEMPORARY TABLE usual AS SELECT axis_id, u.width FROM known JOIN :"model".axis_used u USING (axis_id) WHERE asked;
CREATE TEMPORARY TABLE proposal AS SELECT * FROM streetgen.learn_classes(:'model', accept => true);
SELECT format('| %s | %s | %s | %s | %s | %s | %s |', :'model', (SELECT count(*) FROM proposal), count(*), round(avg(abs(b.width - k.width))::numeric, 2),
    round(avg(abs(u.width - k.width))::numeric, 2), round((avg(abs(u.width - k.width)) / avg(abs(b.width - k.width)))::numeric, 2), round(avg(u.width - k.width)::numeric, 2))
FROM known k JOIN usual b USING (axis_id) JOIN :"model".axis_used u USING (axis_id);
ROLLBACK;
