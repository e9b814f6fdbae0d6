-- argument k: number of clusters, 1 to the number of axes
-- see plan_clusters
SELECT * FROM streetgen.cluster('town', 2) ORDER BY axis_id;
