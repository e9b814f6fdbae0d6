-- The taken lines of a place as OSM XML, a node where coordinates agree: psql -v place=MODEL -v lines=TABLE
WITH taken AS (SELECT l.* FROM :"lines" l JOIN :"place".axis_class c USING (class) WHERE c.taken AND c.use = 'roadway'),
vertex AS (SELECT way_id, d.path[1] AS i, ST_X(d.geom)::numeric(12, 8) AS x, ST_Y(d.geom)::numeric(12, 8) AS y FROM taken, ST_DumpPoints(ST_Transform(geom, 4326)) d),
known AS (SELECT *, dense_rank() OVER (ORDER BY x, y) AS id FROM vertex),
reference AS (SELECT way_id, string_agg(format('<nd ref="%s"/>', id), '' ORDER BY i) AS nodes FROM known GROUP BY way_id)
SELECT '<osm version="0.6">'
UNION ALL (SELECT DISTINCT format('<node id="%s" lat="%s" lon="%s" version="1"/>', id, y, x) FROM known)
UNION ALL (SELECT format('<way id="%s" version="1">%s%s</way>', way_id, reference.nodes, (
    SELECT string_agg(format('<tag k="%s" v="%s"/>', k, replace(replace(replace(v, '&', '&amp;'), '"', '&quot;'), '<', '&lt;')), '')
    FROM (SELECT 'highway' AS k, class AS v UNION ALL SELECT * FROM jsonb_each_text(tags) WHERE key = ANY ('{lanes,lanes:forward,lanes:backward,oneway,junction,layer,bridge,tunnel,maxspeed,width}')) tag))
    FROM taken JOIN reference USING (way_id))
UNION ALL SELECT '</osm>';
