-- see generate_cluster, generate_clusters
SELECT streetgen.finish_clusters('town') IS NULL AS nothing_is_left;
