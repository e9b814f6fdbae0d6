-- Walks along edges of SUMO, and the corners at which they meet.

CREATE OR REPLACE FUNCTION streetgen._edges_within_junctions(model name) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' <> ALL (streetgen._subjects(model)) THEN
        RETURN '{}';
    END IF;
    RETURN ARRAY(SELECT edge_id FROM junction_edge EXCEPT SELECT r.edge_id FROM streetgen._ring_edges(model) r);
END $$;
COMMENT ON FUNCTION streetgen._edges_within_junctions(name) IS
    'The edges between nodes of one junction that belong to no ring; none of a model that computes no junctions.';

CREATE OR REPLACE FUNCTION streetgen._sumo_walks(model name, options jsonb, lines boolean)
    RETURNS TABLE(edge_id bigint, side text, width float8, lane_id bigint, along_axis boolean, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
DECLARE
    inside constant bigint[] := streetgen._edges_within_junctions(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH sidewalk AS MATERIALIZED (SELECT * FROM streetgen._sidewalks_beside(model, options, lines)),
    -- Two who meet have room at the border of the roadway.
    bare AS (
        SELECT e.edge_id, v.side, outwards, 1.3::float8 AS width, (v.side = 'right') = right_hand AS along_axis
        FROM edge e JOIN axis a USING (axis_id) LEFT JOIN axis_class c ON c.class = a.kind
            CROSS JOIN LATERAL (VALUES ('left', 1, e.beside_left), ('right', -1, e.beside_right))
                v(side, outwards, beside)
            CROSS JOIN (SELECT value <> 'left' AS right_hand FROM setting WHERE name = 'driving_side') h
        WHERE coalesce(c.walked_along, true) AND (v.beside = 'outer' OR e.edge_id = ANY (inside))
            AND e.edge_id IN (SELECT streetgen._written_edges(model, options))
            AND NOT EXISTS (SELECT FROM sidewalk s WHERE s.edge_id = e.edge_id AND s.side = v.side))
    SELECT * FROM sidewalk
    UNION ALL SELECT w.edge_id, w.side, w.width, o.lane_id, w.along_axis, CASE WHEN lines THEN streetgen.offset_line(
        o.geom, outwards * ((o.width - w.width) / 2 + coalesce(b.room, 0))) END
    FROM bare w CROSS JOIN LATERAL (SELECT lane_id, l.width, geom FROM lane l WHERE l.edge_id = w.edge_id
            AND start_abscissa IS NULL AND end_abscissa IS NULL ORDER BY outwards * lane_position LIMIT 1) o
        LEFT JOIN streetgen._room_beside_lanes(model) b USING (edge_id);
END $$;
COMMENT ON FUNCTION streetgen._sumo_walks(name, jsonb, boolean) IS
    'Where people walk along the edges of a file of SUMO: sidewalks as streetgen._sidewalks_beside has them, and a '
    'strip on the roadway where a street that is walked along has none, but not beside a median. A model that computes '
    'no sidewalks has none.';

CREATE OR REPLACE FUNCTION streetgen._sumo_refuges(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, at_start boolean, from_place bigint, to_place bigint, width float8, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    inside constant bigint[] := streetgen._edges_within_junctions(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH place AS MATERIALIZED (SELECT node_id, place_id FROM streetgen._places(model, options)),
    -- A crossing that begins or ends beside a median.
    half AS MATERIALIZED (
        SELECT c.edge_id, c.at_start, p.place_id, c.along, inner_end
        FROM streetgen._crossings_at_ends(model, options) c JOIN place p USING (node_id) JOIN edge e USING (edge_id),
            LATERAL (SELECT (beside_right = 'median') = at_start AS at_first, CASE WHEN (beside_right = 'median')
                = at_start THEN ST_StartPoint(line) ELSE ST_EndPoint(line) END AS inner_end) i
        WHERE (beside_left = 'median') <> (beside_right = 'median')
            AND edge_id <> ALL (inside) AND edge_id NOT IN (SELECT streetgen._edges_inside(options))),
    facing AS (
        SELECT DISTINCT ON (least(a.place_id, b.place_id), greatest(a.place_id, b.place_id)) a.edge_id, a.at_start,
            a.place_id AS from_place, b.place_id AS to_place, least(a.along, b.along) AS width,
            ST_MakeLine(a.inner_end, b.inner_end) AS line
        FROM half a JOIN half b ON ST_DWithin(a.inner_end, b.inner_end, 20) AND a.place_id < b.place_id
        ORDER BY least(a.place_id, b.place_id), greatest(a.place_id, b.place_id),
            ST_Distance(a.inner_end, b.inner_end), a.edge_id, b.edge_id)
    SELECT f.edge_id, f.at_start, f.from_place, f.to_place, f.width, f.line FROM facing f
    -- A street between both is walked along.
    WHERE NOT EXISTS (SELECT FROM edge e JOIN place s ON s.node_id = e.from_node JOIN place t ON t.node_id = e.to_node
        WHERE (s.place_id, t.place_id) IN ((from_place, to_place), (to_place, from_place)));
END $$;
COMMENT ON FUNCTION streetgen._sumo_refuges(name, jsonb) IS
    'Where people wait on a median, between crossings of its two carriageways that lie within 20 m of each other: an '
    'edge of one of them and its end, both places, the width of the crossings and the line from one to the other.';

CREATE OR REPLACE FUNCTION streetgen._sumo_arms(model name, options jsonb)
    RETURNS TABLE(place_id bigint, edge_id bigint, at_start boolean, limit_abscissa float8, azimuth float8,
        arms bigint, mouth bigint, mouths bigint, turn bigint, walk_ends boolean)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH place AS MATERIALIZED (
        SELECT node_id, place_id, ST_Centroid(ST_Collect(geom) OVER (PARTITION BY place_id)) AS middle
        FROM streetgen._places(model, options) JOIN node USING (node_id)),
    walk AS MATERIALIZED (SELECT edge_id, side FROM streetgen._sumo_walks(model, options, false)),
    arm AS MATERIALIZED (
        SELECT p.place_id, e.edge_id, at_start, l.abscissa, degrees(ST_Azimuth(p.middle, ahead)) AS azimuth,
            EXISTS (SELECT FROM walk w WHERE (w.edge_id, w.side) = (e.edge_id, CASE WHEN at_start THEN 'left'
                ELSE 'right' END)) AS on_left,
            EXISTS (SELECT FROM walk w WHERE (w.edge_id, w.side) = (e.edge_id, CASE WHEN at_start THEN 'right'
                ELSE 'left' END)) AS on_right
        FROM edge e CROSS JOIN (VALUES (true), (false)) v(at_start)
            JOIN place p ON p.node_id = CASE WHEN at_start THEN e.from_node ELSE e.to_node END
            JOIN section_limit l ON l.edge_id = e.edge_id AND l.which = CASE WHEN at_start THEN 'start' ELSE 'end' END
            -- Limits may lie on the node.
            CROSS JOIN LATERAL ST_LineInterpolatePoint(e.geom, least(greatest((l.abscissa
                + CASE WHEN at_start THEN 1 ELSE -1 END) / ST_Length(e.geom), 0), 1)) ahead
        WHERE e.edge_id IN (SELECT streetgen._written_edges(model, options))
        UNION ALL SELECT p.place_id, NULL, starts, NULL, degrees(ST_Azimuth(p.middle,
            ST_LineInterpolatePoint(r.line, 0.5))), true, true
        FROM streetgen._sumo_refuges(model, options) r CROSS JOIN (VALUES (true), (false)) v(starts)
            JOIN (SELECT DISTINCT place_id, middle FROM place) p ON p.place_id = CASE WHEN starts THEN from_place
                ELSE to_place END),
    -- Arms are counted clockwise, as seen from the middle: the corner before one is on its left.
    turned AS (
        SELECT *, count(*) OVER (PARTITION BY place_id) AS arms, row_number() OVER w AS turn,
            coalesce(lag(on_right) OVER w, last_value(on_right) OVER f) AS left_of_it,
            coalesce(lead(on_left) OVER w, first_value(on_left) OVER f) AS right_of_it
        FROM arm WINDOW w AS (PARTITION BY place_id ORDER BY azimuth, edge_id, at_start),
            f AS (w ROWS BETWEEN UNBOUNDED PRECEDING AND UNBOUNDED FOLLOWING)),
    counted AS (
        SELECT *, count(*) FILTER (WHERE on_left OR left_of_it) OVER (PARTITION BY place_id ORDER BY turn) AS mouth,
            count(*) FILTER (WHERE on_left OR left_of_it) OVER (PARTITION BY place_id) AS mouths
        FROM turned)
    SELECT place_id, edge_id, at_start, abscissa, azimuth, arms, CASE mouth WHEN 0 THEN mouths ELSE mouth END, mouths,
        turn + CASE mouth WHEN 0 THEN arms ELSE 0 END, on_left AND on_right AND NOT (left_of_it AND right_of_it)
    FROM counted WHERE mouths > 0 AND edge_id IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._sumo_arms(name, jsonb) IS
    'The arms of the places of a file of SUMO at which people walk. limit_abscissa is where their lanes end, azimuth '
    'whither they lead, degrees; a place has so many arms. Arms between two corners at which people walk are one mouth '
    'of so many, and are counted clockwise by turn. walk_ends: people walk on both sides of the arm, and not on both '
    'beyond.';
