-- What of a fit changes where one street in ten has no observation: psql -v model=MODEL -v points=TABLE. Streets that
-- touch none of these, and their greatest change, metres; those without keep their widths.
CREATE TEMPORARY TABLE left_out AS SELECT axis_id FROM :model.axis WHERE axis_id % 10 = 3;
CREATE TEMPORARY TABLE near_left AS
SELECT DISTINCT a.axis_id FROM :model.axis a, left_out l JOIN :model.axis o USING (axis_id)
WHERE ST_DWithin(a.geom, o.geom, 60);
DELETE FROM :model.observation;
SELECT count(*) FROM streetgen.observe(:'model', :'points' || '_observed', '{"source_ref": "id"}') \g /dev/null
SELECT fit_run AS whole FROM streetgen.fit(:'model') \gset
DELETE FROM :model.observation o USING :model.axis a JOIN left_out USING (axis_id)
WHERE a.axis_id = (SELECT n.axis_id FROM :model.axis n ORDER BY n.geom <-> o.geom LIMIT 1);
SELECT fit_run AS part FROM streetgen.fit(:'model') \gset
SELECT :'model', 'one street in ten without observations', count(*) AS others,
    round(max(greatest(abs(w.width - p.width), abs(coalesce(w.width_end, w.width) - coalesce(p.width_end, p.width)),
        abs(w.roadway_offset - p.roadway_offset)))::numeric, 3) AS changed
FROM :model.fit_proposal w LEFT JOIN :model.fit_proposal p ON p.fit_run = :part AND p.axis_id = w.axis_id
WHERE w.fit_run = :whole AND w.axis_id NOT IN (SELECT axis_id FROM near_left);
