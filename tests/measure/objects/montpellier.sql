-- Montpellier's crossings and lamps beside its axes.
SELECT streetgen.create_model('montpellier', 2154, subjects => '{object}') \g /dev/null
SELECT count(*) FROM streetgen.import_axes('montpellier', 'montpellier_street', '{"name": "lib_off", "source_ref": "idarc"}') \g /dev/null
SELECT count(*) FROM streetgen.generate('montpellier') \g /dev/null
CREATE TEMPORARY TABLE told AS
SELECT 'crossing' AS type, * FROM streetgen.import_objects('montpellier', 'montpellier_crossing', '{"type": {"value": "crossing"}, "source_ref": "ogc_fid"}')
UNION ALL SELECT 'lamp', * FROM streetgen.import_objects('montpellier', 'montpellier_lamp', '{"type": {"value": "lamp"}, "source_ref": "ogc_fid"}');
SELECT '| type | in the file | objects | at an axis within % m | of all, % | absolute, listed |' \g
SELECT '| ' || type, (SELECT sum(count) FROM told t WHERE t.type = o.type AND what = 'objects'), count(*), CASE type WHEN 'crossing' THEN 5 ELSE 20 END,
    round(100.0 * count(*) FILTER (WHERE method = 'relative' AND ST_DWithin(a.geom, o.geom, CASE type WHEN 'crossing' THEN 5 ELSE 20 END)) / count(*), 1),
    count(*) FILTER (WHERE method = 'absolute') || ' |'
FROM montpellier.street_object o LEFT JOIN montpellier.axis a USING (axis_id) GROUP BY type ORDER BY type;
SELECT 'crossings without ground: ' || count(*) FROM montpellier.pedestrian_crossing WHERE surface IS NULL;
-- Again.
CREATE TEMPORARY TABLE before AS SELECT street_object_id, xmin::text AS written FROM montpellier.street_object;
SELECT FROM streetgen.import_objects('montpellier', 'montpellier_crossing', '{"type": {"value": "crossing"}, "source_ref": "ogc_fid"}') \g /dev/null
SELECT FROM streetgen.import_objects('montpellier', 'montpellier_lamp', '{"type": {"value": "lamp"}, "source_ref": "ogc_fid"}') \g /dev/null
SELECT 'rows written by importing again: ' || count(*) FROM before b JOIN montpellier.street_object o USING (street_object_id) WHERE b.written <> o.xmin::text;
