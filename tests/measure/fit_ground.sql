-- Shared ground by ground of both, of roadways of a model and of surveyed ones: psql -v model=MODEL -v survey=TABLE
-- -v what=WORDS. Ground counts within the extent of the survey and 20 m of an axis on the ground.
WITH frame AS (
    SELECT ST_SetSRID(ST_Extent(geom)::geometry, ST_SRID(min(geom))) AS box FROM (SELECT geom FROM :survey) s
    GROUP BY ST_SRID(geom)),
near AS MATERIALIZED (
    SELECT (ST_Dump(ST_Union(ST_Intersection(ST_Buffer(ST_Force2D(geom), 20), box)))).geom AS geom
    FROM :model.axis, frame WHERE level = 0 AND geom && box),
cell AS MATERIALIZED (SELECT ST_Subdivide(geom, 64) AS geom FROM near),
ground AS MATERIALIZED (
    SELECT coalesce(ST_Area(s), 0) AS surveyed, coalesce(ST_Area(m), 0) AS made,
        coalesce(ST_Area(ST_Intersection(s, m)), 0) AS shared
    FROM cell c, LATERAL (SELECT ST_Intersection(ST_Union(ST_MakeValid(t.geom)), c.geom) AS s FROM :survey t
            WHERE t.geom && c.geom) t,
        LATERAL (SELECT ST_Intersection(ST_Union(r.surface), c.geom) AS m FROM :model.roadway r
            WHERE r.surface && c.geom) r)
SELECT :'model', :'what', count(*) AS cells, round(sum(surveyed)) AS surveyed, round(sum(made)) AS made,
    round((sum(shared) / sum(surveyed + made - shared))::numeric, 3) AS agreement FROM ground;
