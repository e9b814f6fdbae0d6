-- Edges of SUMO: lane groups and sidewalks, cut where a lane merges and where a loop comes back.

CREATE OR REPLACE FUNCTION streetgen._sumo_edges(model name, options jsonb, lines boolean, parted boolean)
    RETURNS TABLE(name text, lane_group_id bigint, edge_id bigint, along_axis boolean, comes_from text, goes_to text,
        since float8, until float8, lanes bigint[], lane_count integer, geom geometry, walk integer,
        walk_width float8, walk_line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
DECLARE
    wanted bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF parted THEN
        wanted := ARRAY(SELECT edge_id FROM edge e JOIN streetgen._places(model, options) f ON f.node_id = e.from_node
                JOIN streetgen._places(model, options) t ON t.node_id = e.to_node WHERE f.place_id = t.place_id
            UNION SELECT edge_id FROM lane WHERE kind = 'merging'
            UNION SELECT edge_id FROM streetgen._lanes_in_middle(model));
    END IF;
    RETURN QUERY WITH place AS MATERIALIZED (SELECT * FROM streetgen._places(model, options)),
    written_edge AS MATERIALIZED (
        SELECT edge_id, from_node, to_node FROM edge
        WHERE (wanted IS NULL OR edge_id = ANY (wanted))
            AND edge_id IN (SELECT streetgen._written_edges(model, options))),
    beside AS MATERIALIZED (
        SELECT edge_id, along_axis, lane_id, width, CASE WHEN along_axis THEN line ELSE ST_Reverse(line) END AS line
        FROM streetgen._sumo_walks(model, options, lines)),
    -- A sidewalk is a lane of the edge at whose kerb it lies; beside no lane of its direction it is an edge by itself.
    grouped AS MATERIALIZED (
        SELECT g.lane_group_id, g.edge_id, g.along_axis, g.from_node, g.to_node, g.lanes, g.lane_count,
            CASE WHEN lines THEN g.geom END AS geom, streetgen._lane_group_text(g.edge_id, g.along_axis, number)
                AS text,
            (w.lane_id IS NOT NULL)::integer AS walk, w.width AS walk_width, w.line AS walk_line
        FROM lane_group g LEFT JOIN beside w
            ON (w.edge_id, w.along_axis, w.lane_id) = (g.edge_id, g.along_axis, g.lanes[1])
        WHERE (wanted IS NULL OR g.edge_id = ANY (wanted)) AND g.edge_id IN (SELECT edge_id FROM written_edge)),
    carried AS (
        SELECT * FROM grouped
        UNION ALL SELECT 2 * lane_id, w.edge_id, w.along_axis, CASE WHEN w.along_axis THEN from_node ELSE to_node END,
            CASE WHEN w.along_axis THEN to_node ELSE from_node END, '{}', 0, w.line,
            streetgen._lane_group_text(w.edge_id, w.along_axis, 1) || '.walk', 1, w.width, w.line
        FROM beside w JOIN written_edge e USING (edge_id)
        WHERE NOT EXISTS (SELECT FROM grouped g
            WHERE (g.edge_id, g.along_axis, g.lanes[1]) = (w.edge_id, w.along_axis, w.lane_id)))
    SELECT r.edge_id::text || CASE WHEN at_start THEN '.refuge' ELSE '.refuge.end' END, 0, r.edge_id, true,
        from_place::text, to_place::text, 0, 1, '{}', 0, r.line, 1, r.width, r.line
    FROM streetgen._sumo_refuges(model, options) r WHERE wanted IS NULL
    UNION ALL SELECT v.name, g.lane_group_id, g.edge_id, g.along_axis, v.comes_from, v.goes_to, v.since, v.until,
        v.lanes, v.lane_count, g.geom, g.walk, g.walk_width, g.walk_line
    FROM (SELECT c.*, f.place_id AS from_place, t.place_id AS to_place, f.place_id = t.place_id AS loop,
            c.edge_id IN (SELECT edge_id FROM lane WHERE kind = 'merging'
                UNION ALL SELECT edge_id FROM streetgen._lanes_in_middle(model)) AS merges
        FROM carried c JOIN place f ON f.node_id = from_node JOIN place t ON t.node_id = to_node) g,
    LATERAL (
        -- netconvert knows no edge that comes back to its node: a loop is two, with a node in the middle.
        SELECT CASE k WHEN 1 THEN text ELSE text || '.end' END AS name,
            CASE k WHEN 1 THEN from_place::text ELSE 'middle.' || text END AS comes_from,
            CASE WHEN k = 1 AND loop THEN 'middle.' || text ELSE to_place::text END AS goes_to,
            CASE k WHEN 1 THEN 0.0 ELSE 0.5 END::float8 AS since,
            CASE WHEN k = 1 AND loop THEN 0.5 ELSE 1 END::float8 AS until, lanes, lane_count
        -- Written so that the planner counts one part a lane group.
        FROM (VALUES (1), (2)) part(k) WHERE CASE k WHEN 1 THEN NOT merges ELSE loop AND NOT merges END
        UNION ALL
        SELECT p.name, p.comes_from, p.goes_to, p.since, p.until, p.lanes, p.lane_count
        FROM streetgen._sumo_parts(model, g.edge_id, g.along_axis, g.lanes, g.text, from_place, to_place) p
        WHERE merges) v;
END $$;
COMMENT ON FUNCTION streetgen._sumo_edges(name, jsonb, boolean, boolean) IS
    'The edges of files of SUMO, which lane groups and walks of a model are. Each has the nodes that traffic comes '
    'from and goes to. It begins and ends at shares of the length of its group, and walk counts its sidewalks (0 or '
    '1). geom, of the whole group, and walk_line are there where lines is true, and with parted only the edges in '
    'parts.';

CREATE OR REPLACE FUNCTION streetgen._sumo_parts(model name, edge bigint, along boolean, group_lanes bigint[],
    group_text text, from_place bigint, to_place bigint)
    RETURNS TABLE(name text, comes_from text, goes_to text, since float8, until float8, lanes bigint[],
        lane_count integer)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- Lanes of a group are ordered from the kerb on. Traffic of each direction uses the half of a lane in the middle
    -- that lies before it, and no car reaches back into the other half.
    RETURN QUERY WITH middle AS (
        SELECT m.lane_id, least(0.5 + 7.5 / greatest(x.end_abscissa - x.start_abscissa, 1), 0.75) AS since
        FROM streetgen._lanes_in_middle(model, edge) m JOIN lane_extent x USING (lane_id)),
    merging AS (
        SELECT m.lane_id, m.lane_position, CASE WHEN along THEN s ELSE 1 - t END AS since,
            CASE WHEN along THEN t ELSE 1 - s END AS until, (m.side = 'right') = (along = (
                SELECT value IS DISTINCT FROM 'left' FROM setting WHERE name = 'driving_side')) AS at_kerb
        FROM lane m JOIN lane_extent x ON x.lane_id = group_lanes[1],
            -- A lane that begins or ends within a decimetre of the end of its group parts nothing there.
            LATERAL (SELECT x.end_abscissa - x.start_abscissa AS length) g,
            LATERAL (VALUES (round((m.start_abscissa - x.start_abscissa)::numeric, 3)::float8,
                round((m.end_abscissa - x.start_abscissa)::numeric, 3)::float8)) v(low, high),
            LATERAL (SELECT
                CASE WHEN low > length - 0.1 THEN 1 WHEN low >= 0.1 THEN low / length ELSE 0 END AS s,
                CASE WHEN high < 0.1 THEN 0 WHEN high <= length - 0.1 THEN high / length ELSE 1 END AS t) e
        WHERE m.edge_id = edge AND m.along_axis = along AND m.kind = 'merging' AND x.end_abscissa
            > x.start_abscissa AND (m.start_abscissa IS NOT NULL OR m.end_abscissa IS NOT NULL)),
    cut AS (
        SELECT share, row_number() OVER (ORDER BY share) AS k, count(*) OVER () - 1 AS parts,
            lead(share) OVER (ORDER BY share) AS until
        FROM (SELECT 0.0::float8 AS share UNION SELECT 1
            UNION SELECT 0.5 WHERE from_place = to_place UNION SELECT since FROM middle
            UNION SELECT since FROM merging UNION SELECT until FROM merging) s),
    named AS (
        SELECT *, group_text || CASE k WHEN 1 THEN '' WHEN parts THEN '.end' ELSE '.' || k END AS name,
            'middle.' || group_text || CASE WHEN parts > 2 THEN '.' || k ELSE '' END AS next
        FROM cut WHERE until IS NOT NULL)
    SELECT name, coalesce(lag(next) OVER w, from_place::text), CASE k WHEN parts THEN to_place::text ELSE next END,
        share, until, ARRAY(SELECT lane_id FROM merging m WHERE at_kerb AND m.since <= n.share AND m.until >= n.until
            ORDER BY lane_position * CASE WHEN along THEN -1 ELSE 1 END)
        || own_lanes || ARRAY(SELECT lane_id FROM merging m WHERE NOT at_kerb AND m.since <= n.share
            AND m.until >= n.until ORDER BY lane_position * CASE WHEN along THEN -1 ELSE 1 END),
        (cardinality(own_lanes)
            + (SELECT count(*) FROM merging m WHERE m.since <= n.share AND m.until >= n.until))::integer
    FROM named n CROSS JOIN LATERAL (SELECT ARRAY(SELECT lane_id FROM unnest(group_lanes) WITH ORDINALITY g(lane_id, i)
            WHERE NOT EXISTS (SELECT FROM middle m WHERE m.lane_id = g.lane_id AND m.since > n.share)
            ORDER BY i) AS own_lanes) g
    WINDOW w AS (ORDER BY k);
END $$;
COMMENT ON FUNCTION streetgen._sumo_parts(name, bigint, boolean, bigint[], text, bigint, bigint) IS
    'The parts of a lane group beside which lanes merge or that has a lane in the middle, for SUMO: a merging lane '
    'begins or ends between two parts, and nobody goes on from its end; a lane in the middle begins past half way, so '
    'that the two directions never meet on it.';
