-- see plan_clusters, generate_cluster
SELECT streetgen.plan_clusters('town', 2);
SELECT clusters, ended, sessions, axes, axes_ended FROM streetgen.progress('town');
