-- Pedestrian crossings for SUMO: each at the node of its end of an edge, where it lies in the model.

CREATE OR REPLACE FUNCTION streetgen._sumo_crossings(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, at_start boolean, along float8, across float8, line geometry, place_id bigint,
        names text[], marked boolean, controller_id bigint, number bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    inside constant bigint[] := streetgen._edges_within_junctions(model);
    rings constant bigint[] := ARRAY(SELECT r.edge_id FROM streetgen._ring_edges(model) r);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH place AS MATERIALIZED (SELECT * FROM streetgen._places(model, options)),
    sumo_edge AS MATERIALIZED (SELECT * FROM streetgen._sumo_edges(model, options, false, false)),
    signalled AS MATERIALIZED (
        SELECT DISTINCT place_id, controller_id
        FROM place JOIN streetgen._signal_controllers(model) ON controller_id = junction_id
        WHERE kind = 'signals' AND cycle > 0),
    marked AS MATERIALIZED (SELECT * FROM streetgen._crossings_at_ends(model, options)),
    -- People cross without paint where lanes end.
    arm AS MATERIALIZED (
        SELECT a.*, m.edge_id IS NOT NULL AS marked, coalesce(m.along, usual.width) AS along, coalesce(m.line,
                CASE WHEN a.at_start THEN l.line ELSE ST_Reverse(l.line) END) AS line,
            a.edge_id = ANY (rings) AS ring, a.edge_id = ANY (inside) AS inside, e.importance,
            coalesce(c.crossed_on_foot, true) AS for_them, e.from_node = e.to_node AS loop
        FROM streetgen._sumo_arms(model, options) a JOIN edge e USING (edge_id) JOIN axis x USING (axis_id)
            LEFT JOIN axis_class c ON c.class = x.kind LEFT JOIN marked m USING (edge_id, at_start),
            streetgen._usual_crossing() usual,
            LATERAL (SELECT e.width + (e.width_end - e.width) * limit_abscissa / greatest(ST_Length(e.geom), 0.01)
                AS metres) w,
            LATERAL (SELECT ST_SetSRID(ST_MakeLine(place ORDER BY aside), ST_SRID(e.geom)) AS line
                FROM (VALUES (e.roadway_offset - metres / 2), (e.roadway_offset + metres / 2)) v(aside),
                    LATERAL (SELECT streetgen._place_on(ST_Force2D(e.geom)::bytea, limit_abscissa, aside)::geometry
                        AS place) o) l
        WHERE mouths > 1 OR arms = 1),
    -- People cross a street where several meet for which they do, the mouths of ways for which nobody crosses, and
    -- where the walk on one side ends.
    mouth AS MATERIALIZED (
        SELECT place_id, mouth, arms, (array_agg(edge_id ORDER BY turn))[1] AS edge_id,
            (array_agg(at_start ORDER BY turn))[1] AS at_start, array_agg(edge_id) AS edges,
            array_agg(at_start) AS starts, bool_or(marked) AS marked, bool_or(ring) AS ring, min(importance)
            AS importance, max(along) AS along, count(*) AS ways, place_id IN (SELECT place_id FROM signalled)
                OR bool_or(inside) AS seldom, bool_and(for_them) AS for_them,
            bool_or(loop AND at_start OR walk_ends) AS ends, CASE count(*) WHEN 1 THEN (array_agg(line))[1]
                ELSE ST_MakeLine(ST_StartPoint((array_agg(line ORDER BY turn DESC))[1]),
                    ST_EndPoint((array_agg(line ORDER BY turn))[1])) END AS line,
            -- Arms to all sides are no mouth.
            mod(((array_agg(azimuth ORDER BY turn DESC))[1] - (array_agg(azimuth ORDER BY turn))[1] + 360)::numeric,
                360) < 150 AS narrow
        FROM arm GROUP BY place_id, mouth, arms),
    wanted AS (
        SELECT *, NOT marked AND NOT ring AND narrow AND CASE WHEN arms = 1 THEN false WHEN arms = 2 THEN ends
            ELSE NOT for_them OR count(*) FILTER (WHERE for_them) OVER (PARTITION BY place_id) > 2 END AS unmarked
        FROM mouth),
    -- People cross without paint at signals and within junctions only where they get round no other way.
    crossing AS (
        SELECT * FROM (
            SELECT *, row_number() OVER (PARTITION BY place_id, marked, unmarked AND seldom
                    ORDER BY importance, edge_id, at_start) AS turn,
                count(*) FILTER (WHERE NOT unmarked AND NOT marked) OVER (PARTITION BY place_id) AS left_out
            FROM wanted) m
        -- One on a node of two streets is said of both.
        WHERE marked AND narrow AND (arms <> 2 OR turn = 1) OR unmarked AND (turn > 1 OR left_out > 0 OR NOT seldom))
    -- Crossings have the last signals of a controller, as netconvert has them: tools of SUMO forget what comes last.
    SELECT c.edge_id, c.at_start, c.along, ST_Length(c.line), c.line, c.place_id, c.names, marked, controller_id,
        CASE WHEN controller_id IS NOT NULL THEN row_number() OVER (
            PARTITION BY controller_id ORDER BY edge_id, at_start) - 1 END
    FROM (SELECT c.edge_id, c.at_start, c.along, c.line, c.place_id, marked,
            array_agg(s.name ORDER BY s.name COLLATE "C") AS names
        FROM crossing c CROSS JOIN LATERAL unnest(c.edges, c.starts) o(edge, begins)
            JOIN sumo_edge s ON s.edge_id = edge AND lane_count > 0
                AND CASE WHEN s.along_axis = begins THEN since = 0 ELSE until = 1 END
        GROUP BY c.edge_id, c.at_start, c.along, c.line, c.place_id, marked) c
        LEFT JOIN signalled USING (place_id);
END $$;
COMMENT ON FUNCTION streetgen._sumo_crossings(name, jsonb) IS
    'The crossings of edges at whose corners people walk for SUMO: marked ones, and where several streets meet one of '
    'each street without. They have their place, the names of their edges, and '
    'their controller where they have one, with the number of their signal from 0 after those of its connections.';
