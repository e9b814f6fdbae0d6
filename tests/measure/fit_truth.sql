-- How far widths and axes of a model are from the truth that fit_disturb.sql kept: psql -v model=MODEL -v points=TABLE
-- -v what=WORDS. Of each axis its width; of places 5 m apart along axes the distance to the true axis; of vertices
-- those over 0.3 m farther from where they were than the metre that moved them.
SELECT :'points' || '_truth' AS truth \gset
WITH street AS (
    SELECT a.axis_id, a.geom, t.geom AS true_geom, abs((a.width + coalesce(a.width_end, a.width)) / 2 - t.width) AS off
    FROM :model.axis a JOIN :truth t USING (axis_id)),
place AS (
    SELECT ST_Distance(ST_LineInterpolatePoint(geom, (n - 0.5) / steps), true_geom) AS off
    FROM street, LATERAL (SELECT greatest(1, round(ST_Length2D(geom) / 5)) AS steps) s,
        generate_series(1, steps::integer) n),
vertex AS (
    SELECT min(ST_Distance(f.geom, t.geom)) AS off FROM street s, ST_DumpPoints(s.true_geom) t, ST_DumpPoints(s.geom) f
    GROUP BY s.axis_id, t.path)
SELECT :'model', :'what', (SELECT count(*) FROM street) AS axes,
    (SELECT round(percentile_cont(0.5) WITHIN GROUP (ORDER BY off)::numeric, 3) FROM street) AS width,
    (SELECT round(percentile_cont(0.5) WITHIN GROUP (ORDER BY off)::numeric, 3) FROM place) AS axis,
    (SELECT count(*) FILTER (WHERE off > 1.3) || ' of ' || count(*) FROM vertex) AS vertices;
