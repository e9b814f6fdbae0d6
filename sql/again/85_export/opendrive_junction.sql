-- OpenDRIVE: junctions, and the ways across them.

CREATE OR REPLACE FUNCTION streetgen._opendrive_junctions() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT $part$,
-- A road that comes into a junction lies in none. So what crossed limits join is one junction, and nothing between.
touching AS MATERIALIZED (
    SELECT DISTINCT v.* FROM (SELECT place_id, min(place_id) OVER (PARTITION BY group_id) AS first
        FROM %1$I.intersection_group JOIN place USING (node_id)) g,
        LATERAL (VALUES (g.place_id, first), (first, g.place_id)) v(place_id, other) WHERE g.place_id <> first),
joined_place AS MATERIALIZED (
    WITH RECURSIVE reached AS (
        SELECT place_id, other FROM touching
        UNION SELECT r.place_id, t.other FROM reached r JOIN touching t ON t.place_id = r.other)
    SELECT place_id, min(other) AS first FROM reached GROUP BY place_id),
joined_node AS MATERIALIZED (
    SELECT node_id, coalesce(first, place_id) AS place_id FROM place LEFT JOIN joined_place USING (place_id)),
inner_lane AS MATERIALIZED (
    SELECT l.lane_id, l.geom
    FROM written_edge e JOIN %1$I.section s USING (edge_id) JOIN joined_node f ON f.node_id = e.from_node
        JOIN joined_node t ON t.node_id = e.to_node JOIN %1$I.lane l USING (edge_id)
    WHERE s.method = 'crossed_limits' AND f.place_id = t.place_id),
-- Ways over inner lanes, each lane once; the shortest one from lane to lane. Nobody turns back within two metres.
joined_way AS MATERIALIZED (
    WITH RECURSIVE longer AS (
        SELECT way_id, ARRAY[way_id] AS ways, lane_in, lane_out, along_in, along_out, geom::geometry AS geom,
            '{}'::bigint[] AS over
        FROM way WHERE lane_in NOT IN (SELECT lane_id FROM inner_lane) AND lane_out IN (SELECT lane_id FROM inner_lane)
        UNION ALL
        SELECT r.way_id, r.ways || w.way_id, r.lane_in, w.lane_out, r.along_in, w.along_out, ST_MakeLine(ARRAY[
            r.geom, CASE WHEN r.along_out THEN i.geom ELSE ST_Reverse(i.geom) END, w.geom]), over || i.lane_id
        FROM longer r JOIN inner_lane i ON i.lane_id = r.lane_out
            JOIN way w ON (w.lane_in, w.along_in) = (r.lane_out, r.along_out)
        WHERE i.lane_id <> ALL (over))
    SELECT DISTINCT ON (lane_in, along_in, lane_out, along_out) way_id, array_to_string(ways, ' ') AS ways, lane_in,
        lane_out, along_in, along_out, geom
    FROM longer
    WHERE lane_out NOT IN (SELECT lane_id FROM inner_lane) AND (lane_out <> lane_in OR ST_Length(geom) >= 2)
    ORDER BY lane_in, along_in, lane_out, along_out, ST_Length(geom), ways),
junction_way AS NOT MATERIALIZED (
    SELECT way_id, way_id::text AS ways, lane_in, lane_out, along_in, along_out, geom FROM way
    WHERE lane_in NOT IN (SELECT lane_id FROM inner_lane) AND lane_out NOT IN (SELECT lane_id FROM inner_lane)
    UNION ALL SELECT * FROM joined_way)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_junctions() IS
    'Queries of a file of OpenDRIVE over a model: joined_node, the junction that each node is part of, where places '
    'whose limits cross are one; inner_lane, the lanes of edges of crossed limits inside; junction_way, the ways from '
    'lane to lane across junctions, over inner lanes too.';
