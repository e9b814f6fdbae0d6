-- How often the lines that match_axes finds with names left out have the name of their axis: psql -v model=MODEL -v source=TABLE, whose columns are
-- geom, source_ref and name.  Names are alike from the similarity on that pg_trgm takes for one word.
CREATE EXTENSION IF NOT EXISTS pg_trgm;
CREATE TEMPORARY TABLE matched AS SELECT * FROM streetgen.match_axes(:'model', :'source'::regclass, '{}');
WITH line AS (
    SELECT source_ref::text, name, ST_Transform(geom, (SELECT srid FROM streetgen.model WHERE name = :'model')) AS geom FROM :"source"),
judged AS (
    SELECT m.axis_id, similarity(a.name, l.name) > 0.3 AS one_name FROM matched m JOIN :"model".axis a USING (axis_id) JOIN line l ON l.source_ref = m.source_ref
    WHERE a.name <> '' AND l.name <> ''),
there AS (
    SELECT a.axis_id FROM :"model".axis a WHERE EXISTS (SELECT FROM line l
        WHERE ST_DWithin(l.geom, ST_LineInterpolatePoint(a.geom, 0.5), 10) AND similarity(a.name, l.name) > 0.3))
SELECT format('| %s | %s | %s | %s |', :'model', (SELECT count(*) FROM matched),
    (SELECT format('%s of %s = %s', count(*) FILTER (WHERE one_name), count(*), round(avg(one_name::integer), 3)) FROM judged),
    (SELECT format('%s of %s = %s', count(*) FILTER (WHERE found), count(*), round(avg(found::integer), 3))
        FROM (SELECT axis_id IN (SELECT axis_id FROM judged WHERE one_name) AS found FROM there) t));
DROP TABLE matched;
