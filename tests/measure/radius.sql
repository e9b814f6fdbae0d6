-- Corners of model neukoelln that an observed arc answers: round, fold, radius observed, by a forest and by a constant
-- of the other folds, and half the width and the speed of both axes.
WITH sample AS MATERIALIZED (SELECT s AS sample, s.* FROM streetgen._radius_samples('neukoelln') s),
axes AS (
    SELECT corner_id, min(ARRAY[width / 2, speed]) AS one, max(ARRAY[width / 2, speed]) AS other FROM sample GROUP BY 1)
SELECT round, fold, observed, by_forest, by_constant, one[1], one[2], other[1], other[2]
FROM generate_series(1, 10) round, (SELECT array_agg(sample) AS samples FROM sample) s,
    LATERAL streetgen._tried_radii(samples, 'major', round) JOIN axes USING (corner_id)
ORDER BY round, corner_id;
