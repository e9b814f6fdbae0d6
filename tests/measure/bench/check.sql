-- Rows "t or f, name", of what was measured in the file :measured and of the surfaces in the database: that the harness works. No times.
\ir taken.sql
\pset fieldsep ' '
SELECT (rows > 0) = (part <> 'subjects' OR phase NOT LIKE '% unchanged') AND peak > 0 OR part = 'netconvert' AND wall > 0, format('bench: %s, %s', part, phase) FROM median ORDER BY 2;
SELECT count(DISTINCT part) = :parts, 'bench: every part is measured' FROM median;
WITH area AS (
    SELECT (SELECT sum(ST_Area(surface)) FROM plain.tile) AS plain, (SELECT sum(ST_Area(surface)) FROM surfaces.surface) AS ours,
           (SELECT sum(ST_Area(surface)) FROM (SELECT surface FROM timed.section UNION ALL SELECT surface FROM timed.intersection) s) AS model)
SELECT v.* FROM area, LATERAL (VALUES
    (abs(plain / model - 1) < 0.05, 'bench: plain PostGIS covers the same ground, within a twentieth'),
    (abs(ours / model - 1) < 1e-9, 'bench: surfaces alone are those of the model')) v;
