-- The network of model `timed` for netconvert: lines "node …" and "edge …", an edge for each direction that is driven in.
SELECT format('node <node id="%s" x="%s" y="%s"/>', node_id, round(ST_X(geom)::numeric, 3), round(ST_Y(geom)::numeric, 3)) FROM timed.node ORDER BY node_id;
SELECT format('edge <edge id="%s%s" from="%s" to="%s" numLanes="%s" speed="%s" width="%s" shape="%s"/>', sign, edge_id, tail, head, lanes, round((speed / 3.6)::numeric, 2), round((width / lane_count)::numeric, 2),
              (SELECT string_agg(round(ST_X(d.geom)::numeric, 3) || ',' || round(ST_Y(d.geom)::numeric, 3), ' ' ORDER BY d.path) FROM ST_DumpPoints(line) d))
FROM timed.edge e, LATERAL (VALUES ('', from_node, to_node, lanes_forward + lanes_both, e.geom), ('-', to_node, from_node, lanes_backward + lanes_both, ST_Reverse(e.geom))) v(sign, tail, head, lanes, line)
WHERE lanes > 0 ORDER BY edge_id, sign;
