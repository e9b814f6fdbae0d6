-- argument first: number of the cluster to compute, if it is free; NULL: any
-- see plan_clusters, generate_clusters
SELECT streetgen.plan_clusters('town', 2);
SELECT cluster, axes, ended, clusters FROM streetgen.generate_cluster('town', 1);
