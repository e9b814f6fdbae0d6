-- The count of edges of two-way ways that say nothing of lanes, and of those whose two directions have not equally many general lanes:
-- psql -v m=MODEL -v lines=TABLE, after generate. TABLE is what osm2pgsql made.
WITH edge AS (
  SELECT a.source_ref, count(*) FILTER (WHERE l.along_axis OR l.both_ways) AS forward, count(*) FILTER (WHERE NOT l.along_axis OR l.both_ways) AS backward
  FROM :"m".axis a JOIN :"m".axis_used u USING (axis_id) JOIN :"lines" w ON a.source_ref = w.way_id::text JOIN :"m".edge e USING (axis_id) JOIN :"m".lane l USING (edge_id)
  WHERE u.direction = 'both' AND l.kind = 'general'
    AND NOT EXISTS (SELECT FROM jsonb_each_text(w.tags) WHERE key ~ 'lane|busway|oneway|cycleway|access|vehicle|motorcar|psv|bus|junction')
  GROUP BY e.edge_id, a.source_ref)
SELECT count(*) AS edges, count(*) FILTER (WHERE forward <> backward) AS unequal, (array_agg(DISTINCT source_ref) FILTER (WHERE forward <> backward))[:9] AS ways FROM edge;
