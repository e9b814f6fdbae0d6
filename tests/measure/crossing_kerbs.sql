-- Whether kerbs at both ends of crossings are as their source says: psql -v model=NAME -f
-- tests/measure/crossing_kerbs.sql Of crossings with a control point and a roadway, prints model, what the source says
-- (- : nothing), what the cross-section has at an end in the middle of the crossing (none: no kerb is there), and how
-- many ends.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SELECT :'model', coalesce(p.kerb, '-'), coalesce(x.kerb, 'none'), count(*)
FROM :"model".pedestrian_crossing c JOIN :"model".street_object o USING (street_object_id)
    JOIN :"model".control_point p USING (control_point_id) CROSS JOIN (VALUES ('left'), ('right')) v(side)
    LEFT JOIN LATERAL (SELECT kerb FROM :"model".cross_section x WHERE x.axis_id = o.axis_id AND x.side = v.side
        AND x.kind = 'kerb' AND o.abscissa BETWEEN x.start_abscissa AND x.end_abscissa
        ORDER BY x.end_abscissa - x.start_abscissa LIMIT 1) x ON true
WHERE c.surface IS NOT NULL GROUP BY p.kerb, x.kerb ORDER BY p.kerb, count(*) DESC;
