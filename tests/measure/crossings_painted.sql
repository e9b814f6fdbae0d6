-- Whether crossings are painted as their source says: psql -v model=NAME -f tests/measure/crossings_painted.sql Of
-- crossings with a control point and a roadway, prints model, what the source says (- : nothing), what they are painted
-- as, their number, and how many of these have paint; then those without a control point, and those without a roadway.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
CREATE TEMPORARY VIEW crossing AS SELECT p.*, c.control_point_id, c.marking AS said FROM :"model".pedestrian_crossing p
    JOIN :"model".street_object o USING (street_object_id) LEFT JOIN :"model".control_point c USING (control_point_id);
SELECT :'model', coalesce(said, '-'), painted_as, count(*), count(*) FILTER (WHERE ST_Area(stripes) > 0)
FROM crossing WHERE control_point_id IS NOT NULL AND surface IS NOT NULL GROUP BY said, painted_as
    ORDER BY count(*) DESC, said;
SELECT :'model', count(*) FILTER (WHERE control_point_id IS NULL), count(*) FILTER (WHERE surface IS NULL)
    FROM crossing;
