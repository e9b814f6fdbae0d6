-- Clusters of model :model with their convex hulls, as the paper's figure 29 has them: 8 and 20, as SVG.
\ir ../../../data/colours.sql
CREATE FUNCTION pg_temp.panel(model name, k integer, place integer) RETURNS SETOF text LANGUAGE plpgsql AS $$
BEGIN
    RETURN QUERY EXECUTE format($sql$
WITH axis AS MATERIALIZED (SELECT cluster, geom FROM streetgen.cluster(%1$L, %2$s) JOIN %1$I.axis USING (axis_id)),
extent AS (SELECT ST_XMin(e) AS west, ST_YMax(e) AS north, 580 / greatest(ST_XMax(e) - ST_XMin(e), ST_YMax(e) - ST_YMin(e)) AS scale FROM (SELECT ST_Extent(geom) AS e FROM axis) x),
drawn AS (SELECT cluster, format('hsl(%%s,65%%%%,42%%%%)', cluster * 137 %% 360) AS colour, ST_Affine(ST_Translate(ST_Collect(geom), -west, -north), scale, 0, 0, scale, 10 + 600 * %3$s, -40) AS lines,
                 ST_Affine(ST_Translate(ST_ConvexHull(ST_Collect(ST_Centroid(geom))), -west, -north), scale, 0, 0, scale, 10 + 600 * %3$s, -40) AS hull
          FROM axis CROSS JOIN extent GROUP BY cluster, west, north, scale)
SELECT format('<path d="%%1$s" fill="none" stroke="%%2$s" stroke-width="0.7"/><path d="%%3$s" fill="%%4$s" fill-opacity="0.05" stroke="%%4$s" stroke-width="1.2"/>', ST_AsSVG(lines, 0, 1), colour, ST_AsSVG(hull, 0, 1), pg_temp.colour('ink')) FROM drawn
UNION ALL SELECT format('<text x="%%s" y="26" font-size="16">k = %%s</text>', 10 + 600 * %3$s, %2$s) $sql$, model, k, place);
END $$;
SELECT format('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1200 500" font-family="sans-serif"><rect width="1200" height="500" fill="%s"/>', pg_temp.colour('paper'));
SELECT pg_temp.panel(:'model', 8, 0);
SELECT pg_temp.panel(:'model', 20, 1);
SELECT '</svg>';
