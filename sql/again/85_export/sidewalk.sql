-- Sidewalks and crossings as the formats of simulators have them: beside the lanes of edges, and at the ends of edges.

CREATE OR REPLACE FUNCTION streetgen._export_sidewalks(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN NOT computed THEN $part$,
sidewalk_beside AS (SELECT NULL::bigint AS edge_id, NULL::text AS side, NULL::float8 AS width, NULL::bigint AS lane_id,
    NULL::boolean AS along_axis, NULL::geometry AS line WHERE false)$part$
    ELSE $part$,
-- One that lies along less than half of its edge is none of its lanes.
sidewalk_beside AS MATERIALIZED (
    SELECT edge_id, side, s.width, o.lane_id, (side = 'right') = h.right_hand AS along_axis,
        coalesce(round.line, streetgen.offset_line(o.geom, outwards * (o.width + s.width) / 2)) AS line
    FROM (SELECT edge_id, side, max(width) AS width, sum(ST_Area(surface)) AS area,
                CASE side WHEN 'left' THEN 1 ELSE -1 END AS outwards FROM %1$I.sidewalk
            WHERE node_id IS NULL AND side IN ('left', 'right') AND edge_id IN (SELECT edge_id FROM written_edge)
            GROUP BY edge_id, side) s
        CROSS JOIN LATERAL (SELECT lane_id, lane_position, width, geom FROM %1$I.lane l WHERE l.edge_id = s.edge_id
            AND start_abscissa IS NULL AND end_abscissa IS NULL ORDER BY outwards * lane_position LIMIT 1) o
        CROSS JOIN (SELECT value <> 'left' AS right_hand FROM %1$I.setting WHERE name = 'driving_side') h
        -- It goes round merging lanes beyond that lane, and along the lane from one to the next. A merging lane has its
        -- middle as far from its own border as from the lane inside.
        CROSS JOIN LATERAL (
            WITH merging AS (
                SELECT m.lane_position, i.width AS inner_width, i.geom AS inner_line, m.geom,
                    ST_LineLocatePoint(o.geom, ST_StartPoint(m.geom)) AS since,
                    ST_LineLocatePoint(o.geom, ST_EndPoint(m.geom)) AS until
                FROM %1$I.lane m JOIN %1$I.lane i ON i.edge_id = m.edge_id
                    AND i.lane_position = m.lane_position + outwards
                WHERE m.edge_id = s.edge_id AND outwards * (o.lane_position - m.lane_position) > 0
                    AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)),
            piece AS (
                SELECT share, lead(share) OVER (ORDER BY share) AS next
                FROM (SELECT 0::float8 AS share UNION SELECT 1 UNION SELECT since FROM merging
                    UNION SELECT until FROM merging) c)
            SELECT ST_MakeLine(coalesce(beyond, streetgen.offset_line(ST_LineSubstring(o.geom, share, next),
                outwards * (o.width + s.width) / 2)) ORDER BY share) AS line
            FROM piece LEFT JOIN LATERAL (SELECT * FROM merging WHERE since <= share AND until >= next
                    ORDER BY outwards * lane_position LIMIT 1) m ON true,
                LATERAL (SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(foot) + (ST_X(p.geom) - ST_X(foot)) * further,
                        ST_Y(foot) + (ST_Y(p.geom) - ST_Y(foot)) * further) ORDER BY p.path), %2$s) AS beyond
                    FROM ST_DumpPoints(ST_LineSubstring(m.geom, greatest((share - since) / (until - since), 0),
                            least((next - since) / (until - since), 1))) p,
                        ST_ClosestPoint(inner_line, p.geom) foot,
                        LATERAL (SELECT 2 - (inner_width - s.width) / 2 / ST_Distance(foot, p.geom) AS further) f) l
            WHERE next > share AND EXISTS (SELECT FROM merging)) round
    WHERE s.width > 0 AND area >= s.width * ST_Length(o.geom) / 2)$part$ END $$;
COMMENT ON FUNCTION streetgen._export_sidewalks(boolean) IS
    'Query sidewalk_beside of writers over a model, after streetgen._export_edges: the sidewalks along edges that are '
    'lanes in a file. Each has its side and width, and the lane beside it. along_axis is the direction of traffic that '
    'has it at its kerb, and line lies along the axis. A model that computes no sidewalks has none.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_sidewalks(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._export_sidewalks(computed) || $part$,
sidewalk_lane AS MATERIALIZED (
    SELECT d.road_id, s.side, '<lane id="' || CASE s.side WHEN 'left' THEN lefts + 1
            ELSE lefts - cardinality(lanes) - 1 END || '" type="sidewalk" level="false"><width sOffset="0" a="'
        || streetgen._decimal(s.width, 5) || '" b="0" c="0" d="0"/>'
        || '<roadMark sOffset="0" type="none" color="standard" laneChange="none"/><height sOffset="0" inner="'
        || raised || '" outer="' || raised || '"/></lane>' AS text
    FROM sidewalk_beside s
        JOIN drawn d ON d.edge_id = s.edge_id AND s.lane_id = ANY (d.lanes),
        (SELECT k.raised FROM streetgen._mesh_kind() k WHERE k.kind = 'sidewalk') k)$part$ $$;
COMMENT ON FUNCTION streetgen._opendrive_sidewalks(boolean) IS
    'Query sidewalk_lane of a file of OpenDRIVE, after streetgen._opendrive_roads(): the sidewalk on a side of a road '
    'as a lane, raised by a kerb; nothing of a model that computes none.';

CREATE OR REPLACE FUNCTION streetgen._export_crossings(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN subjects @> '{sidewalk}' AND subjects && '{junction,object}' THEN $part$,
marked AS (
    $part$ || concat_ws(' UNION ALL ',
        CASE WHEN 'object' = ANY (subjects) THEN $part$SELECT edge_id, 1 AS turn, c.width, c.angle, o.geom
    FROM %1$I.pedestrian_crossing c JOIN %1$I.street_object o USING (street_object_id)
        JOIN %1$I.object_edge USING (street_object_id)$part$ END,
        CASE WHEN 'junction' = ANY (subjects) THEN $part$SELECT edge_id, 2 AS turn, usual.width, usual.angle, geom
    FROM %1$I.junction_crossing, streetgen._usual_crossing() usual$part$ END) || $part$),
-- A crossing on an edge is that of its nearer end. Where both a control point and an object say it, the object does.
crossing AS MATERIALIZED (
    SELECT DISTINCT ON (edge_id, at_start) edge_id, at_start, node_id, m.width AS along, across,
        CASE WHEN at_start THEN line ELSE ST_Reverse(line) END AS line
    FROM marked m JOIN written_edge e USING (edge_id),
        LATERAL (SELECT ST_Length(e.geom) AS length, ST_LineLocatePoint(e.geom, m.geom) AS share) p,
        LATERAL (SELECT share < 0.5 AS at_start, e.width + (e.width_end - e.width) * share AS across,
            CASE WHEN share < 0.5 THEN share ELSE 1 - share END * length AS away) s,
        LATERAL (SELECT CASE WHEN at_start THEN from_node ELSE to_node END AS node_id,
            roadway_offset - across / 2 AS on_right, roadway_offset + across / 2 AS on_left,
            1 / tan(radians(angle)) AS slope) b,
        LATERAL (SELECT ST_SetSRID(ST_MakeLine(place ORDER BY aside), %2$s) AS line
            FROM (VALUES (on_right), (on_left)) v(aside), LATERAL (SELECT streetgen._place_on(
                ST_Force2D(e.geom)::bytea, greatest(least(share * length + aside * slope, length), 0), aside)
                ::geometry AS place) o) l
    WHERE away <= (SELECT value::float8 FROM %1$I.setting WHERE name = 'control_distance')
        AND (SELECT count(*) FROM sidewalk_beside b WHERE b.edge_id = e.edge_id) = 2
    ORDER BY edge_id, at_start, turn, away)$part$
    ELSE $part$,
crossing AS (SELECT NULL::bigint AS edge_id, NULL::boolean AS at_start, NULL::bigint AS node_id, NULL::float8 AS along,
    NULL::float8 AS across, NULL::geometry AS line WHERE false)$part$ END $$;
COMMENT ON FUNCTION streetgen._export_crossings(text[]) IS
    'Query crossing of writers over a model that computes these subjects, after sidewalk_beside: where people on foot '
    'cross an edge with sidewalks on both sides, within setting control_distance of its start or its end, one at each: '
    'its node, its width along the edge, that of the roadway, and its line, from the right to the left of those who '
    'leave the node. Objects of type crossing come before control points of junctions.';
