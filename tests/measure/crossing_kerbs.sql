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
-- Then model, kerb and number of ends of crossings as they are drawn and as their nodes say (- : nothing), junctions
-- too; last, of kerbs on footways, their kind, number, those within 6 m of an end, and those that it has.
SELECT :'model', coalesce(p.kerb, '-'), v.kerb, count(*) FROM :"model".pedestrian_crossing c
    JOIN :"model".street_object o USING (street_object_id) LEFT JOIN :"model".control_point p USING (control_point_id)
    CROSS JOIN LATERAL (VALUES (kerb_left), (kerb_right)) v(kerb)
WHERE c.surface IS NOT NULL GROUP BY p.kerb, v.kerb ORDER BY p.kerb, count(*) DESC;
WITH there AS (
    SELECT v.kerb, streetgen._place_on(ST_Force2D(a.geom)::bytea, o.abscissa + v.aside * cotd(c.angle), v.aside)
        ::geometry AS geom
    FROM :"model".pedestrian_crossing c JOIN :"model".street_object o USING (street_object_id)
        JOIN :"model".axis a USING (axis_id) JOIN :"model".object_edge USING (street_object_id)
        JOIN :"model".edge e USING (edge_id), LATERAL (VALUES (kerb_left, e.width / 2 + e.roadway_offset),
            (kerb_right, e.roadway_offset - e.width / 2)) v(kerb, aside))
SELECT :'model', k.kerb, count(*), count(*) FILTER (WHERE n.away <= 6), count(*) FILTER (WHERE n.away <= 6
    AND n.kerb = k.kerb) FROM :"model".footway_kerb k, LATERAL (SELECT kerb, ST_Distance(t.geom, k.geom) AS away
        FROM there t ORDER BY t.geom <-> k.geom LIMIT 1) n GROUP BY k.kerb ORDER BY count(*) DESC;
