-- see plan_clusters, generate_cluster, finish_clusters
SELECT streetgen.plan_clusters('town', 2);
CALL streetgen.generate_clusters('town');
SELECT clusters, ended FROM streetgen.progress('town');
