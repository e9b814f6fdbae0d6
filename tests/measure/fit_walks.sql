-- Shared ground by ground of both, of sidewalks of a model and of surveyed ones: psql -v model=MODEL -v survey=TABLE
-- -v judge=TABLE -v what=WORDS. Ground within areas of the judge counts.
SELECT :'model', :'what', count(*) AS pieces, round(sum(surveyed)) AS surveyed, round(sum(made)) AS made,
    round((sum(shared) / sum(surveyed + made - shared))::numeric, 3) AS agreement
FROM (SELECT coalesce(ST_Area(s), 0) AS surveyed, coalesce(ST_Area(m), 0) AS made,
        coalesce(ST_Area(ST_Intersection(s, m)), 0) AS shared
    FROM :judge c, LATERAL (SELECT ST_Intersection(ST_Union(t.geom), c.geom) AS s FROM :survey t
            WHERE t.geom && c.geom) t,
        LATERAL (SELECT ST_Intersection(ST_Union(r.surface), c.geom) AS m FROM :model.sidewalk r
            WHERE r.surface && c.geom) r) g;
