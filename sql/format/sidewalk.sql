-- Sidewalks and crossings as the formats of simulators have them: beside the lanes of edges, and at the ends of edges.

CREATE OR REPLACE FUNCTION streetgen._room_beside_lanes(model name) RETURNS TABLE(edge_id bigint, room float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT edge_id, (e.width - sum(l.width)) / 2 FROM lane l JOIN edge e USING (edge_id)
        WHERE l.kind <> 'merging' GROUP BY edge_id, e.width HAVING sum(l.width) < e.width - 0.01;
END $$;
COMMENT ON FUNCTION streetgen._room_beside_lanes(name) IS
    'Edges whose lanes do not reach the kerbs, and the width in metres that each kerb is away from '
    'them where the edge begins. It changes along an edge as the width of that does.';

CREATE OR REPLACE FUNCTION streetgen._sidewalks_beside(model name, options jsonb, lines boolean)
    RETURNS TABLE(edge_id bigint, side text, width float8, lane_id bigint, along_axis boolean, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY SELECT edge_id, side, s.width, o.lane_id, (side = 'right') = h.right_hand, CASE WHEN lines THEN
        coalesce(round.line, streetgen.offset_line(o.geom,
            outwards * ((o.width + s.width) / 2 + coalesce(b.room, 0)))) END
    FROM (SELECT edge_id, side, max(width) AS width, sum(ST_Area(surface)) AS area,
                CASE side WHEN 'left' THEN 1 ELSE -1 END AS outwards FROM sidewalk
            WHERE node_id IS NULL AND side IN ('left', 'right')
                AND edge_id IN (SELECT streetgen._written_edges(model, options))
            GROUP BY edge_id, side) s
        CROSS JOIN LATERAL (SELECT lane_id, lane_position, width, geom FROM lane l WHERE l.edge_id = s.edge_id
            AND start_abscissa IS NULL AND end_abscissa IS NULL ORDER BY outwards * lane_position LIMIT 1) o
        LEFT JOIN streetgen._room_beside_lanes(model) b USING (edge_id)
        CROSS JOIN (SELECT value <> 'left' AS right_hand FROM setting WHERE name = 'driving_side') h
        -- It goes round merging lanes beyond that lane, and along the lane from one to the next. A merging lane has its
        -- middle as far from its own border as from the lane inside.
        CROSS JOIN LATERAL (
            WITH merging AS (
                SELECT m.lane_position, i.width AS inner_width, i.geom AS inner_line, m.geom,
                    ST_LineLocatePoint(o.geom, ST_StartPoint(m.geom)) AS since,
                    ST_LineLocatePoint(o.geom, ST_EndPoint(m.geom)) AS until
                FROM lane m JOIN lane i ON i.edge_id = m.edge_id
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
                        ST_Y(foot) + (ST_Y(p.geom) - ST_Y(foot)) * further) ORDER BY p.path), ST_SRID(o.geom)) AS beyond
                    FROM ST_DumpPoints(ST_LineSubstring(m.geom, greatest((share - since) / (until - since), 0),
                            least((next - since) / (until - since), 1))) p,
                        ST_ClosestPoint(inner_line, p.geom) foot,
                        LATERAL (SELECT 2 - (inner_width - s.width) / 2 / ST_Distance(foot, p.geom) AS further) f) l
            WHERE lines AND next > share AND EXISTS (SELECT FROM merging)) round
    -- One that lies along less than half of its edge is none of its lanes.
    WHERE s.width > 0 AND area >= s.width * ST_Length(o.geom) / 2;
END $$;
COMMENT ON FUNCTION streetgen._sidewalks_beside(name, jsonb, boolean) IS
    'The sidewalks along edges that are lanes in a file. Each has its side and width, and the lane beside it. '
    'along_axis is the direction of traffic that has it at its kerb. line lies along the axis, and is there where '
    'lines is true. A model that computes no sidewalks has none.';

CREATE OR REPLACE FUNCTION streetgen._marked_crossings(model name)
    RETURNS TABLE(edge_id bigint, turn integer, width float8, angle float8, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' = ANY (subjects) THEN
        RETURN QUERY SELECT e.edge_id, 1, c.width, c.angle, o.geom
            FROM pedestrian_crossing c JOIN street_object o ON o.street_object_id = c.street_object_id
                JOIN object_edge e ON e.street_object_id = c.street_object_id;
    END IF;
    IF 'junction' = ANY (subjects) THEN
        RETURN QUERY SELECT j.edge_id, 2, usual.width, usual.angle, j.geom
            FROM junction_crossing j, streetgen._usual_crossing() usual;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._marked_crossings(name) IS
    'The crossings that a model knows: objects of type crossing (turn 1), and control points of junctions (2).';

CREATE OR REPLACE FUNCTION streetgen._crossings_at_ends(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, at_start boolean, node_id bigint, along float8, across float8, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- A crossing on an edge is that of its nearer end. Where both a control point and an object say it, the object
    -- does.
    RETURN QUERY SELECT DISTINCT ON (edge_id, at_start) edge_id, at_start, node_id, m.width, across,
        CASE WHEN at_start THEN line ELSE ST_Reverse(line) END
    FROM streetgen._marked_crossings(model) m JOIN edge e USING (edge_id),
        LATERAL (SELECT ST_Length(e.geom) AS length, ST_LineLocatePoint(e.geom, m.geom) AS share) p,
        LATERAL (SELECT share < 0.5 AS at_start, e.width + (e.width_end - e.width) * share AS across,
            CASE WHEN share < 0.5 THEN share ELSE 1 - share END * length AS away) s,
        LATERAL (SELECT CASE WHEN at_start THEN from_node ELSE to_node END AS node_id,
            roadway_offset - across / 2 AS on_right, roadway_offset + across / 2 AS on_left,
            1 / tan(radians(angle)) AS slope) b,
        LATERAL (SELECT ST_SetSRID(ST_MakeLine(place ORDER BY aside), ST_SRID(e.geom)) AS line
            FROM (VALUES (on_right), (on_left)) v(aside), LATERAL (SELECT streetgen._place_on(
                ST_Force2D(e.geom)::bytea, greatest(least(share * length + aside * slope, length), 0), aside)
                ::geometry AS place) o) l
    WHERE away <= (SELECT value::float8 FROM setting WHERE name = 'control_distance')
        AND edge_id IN (SELECT streetgen._edges_taken(model, options))
    ORDER BY edge_id, at_start, turn, away;
END $$;
COMMENT ON FUNCTION streetgen._crossings_at_ends(name, jsonb) IS
    'Where people on foot cross an edge within setting control_distance of its start or its end, one at each: its '
    'node, its width along the edge, that of the roadway, and its line, from the right to the left of those who leave '
    'the node. Objects of type crossing come before control points of junctions. Edges inside places have them too.';
