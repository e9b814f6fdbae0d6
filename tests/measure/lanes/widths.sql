-- The count of general lanes of improbable width where the source states none: psql -v m=MODEL, after generate.
SELECT count(*) AS lanes, count(*) FILTER (WHERE l.width > 4.5 + 1e-6) AS over_4_5, count(*) FILTER (WHERE l.width < 2.4 - 1e-6) AS under_2_4,
       array_agg(DISTINCT a.source_ref || ' ' || round(l.width::numeric, 2)) FILTER (WHERE l.width NOT BETWEEN 2.4 - 1e-6 AND 4.5 + 1e-6) AS ways
FROM :"m".lane l JOIN :"m".edge USING (edge_id) JOIN :"m".axis a USING (axis_id)
WHERE l.kind = 'general' AND num_nulls(a.width, a.width_end, a.lane_width_forward, a.lane_width_backward) = 4
  AND coalesce(a.kind, '') NOT IN (SELECT class FROM :"m".axis_class WHERE NOT lanes_by_width);
