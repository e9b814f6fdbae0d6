-- argument clusters: how many clusters; NULL: about 2,500 axes each
-- argument sessions: how many sessions will compute them: as many clusters at least
-- see generate_clusters, generate_cluster, progress, finish_clusters
SELECT streetgen.plan_clusters('town', 2) AS left_to_compute;
