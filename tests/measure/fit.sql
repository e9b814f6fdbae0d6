-- Points of surveyed kerbs against the kerbs of sections: psql -v model=MODEL -v points=TABLE -v what=WORDS. Points
-- count that are to judge.
WITH nearest AS (
    SELECT ST_Distance(k.geom, p.geom) AS off
    FROM :points p CROSS JOIN LATERAL (
        SELECT geom, node_id FROM :model.kerb k
        WHERE k.side <> 'start' AND k.side <> 'end' AND ST_DWithin(k.geom, p.geom, 10)
        ORDER BY k.geom <-> p.geom LIMIT 1) k
    WHERE p.judges AND k.node_id IS NULL)
SELECT :'model', :'what', count(*), round(avg(off)::numeric, 3) AS mean,
    round(percentile_cont(0.5) WITHIN GROUP (ORDER BY off)::numeric, 3) AS median
FROM nearest;
