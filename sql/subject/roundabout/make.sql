-- A roundabout in place of a crossing, drawn as axes that one edits.

CREATE OR REPLACE FUNCTION streetgen._arms_of_ring(model name, node bigint, radius float8)
    RETURNS TABLE(axis_id bigint, low float8, high float8, place geometry, returns boolean, lanes integer,
        importance integer, level integer, kind text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 4 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH leg AS (
        -- Each end of an edge at the node, led away from it.
        SELECT e.axis_id, away, e.from_node = e.to_node AS is_loop, e.importance, e.level, a.kind,
            e.start_abscissa / l.metres AS s, e.end_abscissa / l.metres AS e, ST_Force2D(a.geom) AS line,
            CASE WHEN away THEN e.lanes_backward ELSE e.lanes_forward END AS lanes
        FROM edge e JOIN axis a USING (axis_id), LATERAL (SELECT ST_Length2D(a.geom) AS metres) l,
            unnest(ARRAY[true, false]) away
        WHERE CASE WHEN away THEN e.from_node ELSE e.to_node END = node),
    led AS (
        SELECT g.*, CASE WHEN away THEN p.piece ELSE ST_Reverse(p.piece) END AS piece
        FROM leg g, LATERAL (SELECT ST_LineSubstring(g.line, g.s, least(g.e, 1)) AS piece) p),
    met AS (
        SELECT l.*, ST_Intersection(l.piece, c.circle) AS met
        FROM led l, (SELECT ST_ExteriorRing(ST_Buffer(ST_Force2D(n.geom), radius, 64)) AS circle FROM node n
            WHERE n.node_id = node) c)
    SELECT m.axis_id, CASE WHEN away THEN s ELSE e - t * (e - s) END, CASE WHEN away THEN s + t * (e - s) ELSE e END,
        ST_LineInterpolatePoint(piece, t), ST_NumGeometries(met) > CASE WHEN is_loop THEN 2 ELSE 1 END, m.lanes,
        m.importance, m.level, m.kind
    FROM met m, LATERAL (SELECT min(ST_LineLocatePoint(piece, d.geom)) AS t FROM ST_DumpPoints(met) d) u;
END $$;
COMMENT ON FUNCTION streetgen._arms_of_ring(name, bigint, float8) IS
    'The arms of a ring of so many metres about a node: the part of each axis that the ring takes in (fractions of its '
    'length, NULL where it ends within), where it leaves the ring, whether it returns into it, and lanes that lead to '
    'the node, importance, level and class.';

CREATE OR REPLACE FUNCTION streetgen._refuse_ring(model name, node bigint, radius float8) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    lowest constant float8 := streetgen._setting_number(model, 'roundabout_radius_least');
    highest constant float8 := streetgen._setting_number(model, 'roundabout_radius_greatest');
    arms integer;
    short bigint;
    bent bigint;
    other bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT EXISTS (SELECT FROM node n WHERE n.node_id = _refuse_ring.node) THEN
        PERFORM streetgen._refuse('22023', format('model "%s" has no node %s', model, node),
            hint => format('SELECT node_id, geom FROM %I.node lists them.', model));
    ELSIF NOT radius BETWEEN lowest AND highest THEN
        PERFORM streetgen._refuse('22023', format('radius is %s m, expected %s to %s', radius, lowest, highest),
            hint => 'Settings roundabout_radius_least and roundabout_radius_greatest bound it.');
    END IF;
    SELECT count(*), min(r.axis_id) FILTER (WHERE low IS NULL OR high IS NULL),
            min(r.axis_id) FILTER (WHERE returns) INTO arms, short, bent
        FROM streetgen._arms_of_ring(model, node, radius) r;
    SELECT e.axis_id INTO other FROM edge e JOIN node n ON n.node_id = node
        WHERE node NOT IN (e.from_node, e.to_node) AND ST_DWithin(e.geom, n.geom, radius) AND e.level IN (
            SELECT a.level FROM edge a WHERE node IN (a.from_node, a.to_node))
        ORDER BY ST_Distance(e.geom, n.geom) LIMIT 1;
    IF arms < 3 THEN
        PERFORM streetgen._refuse('22023', format('node %s has %s arms, expected three and more', node, arms),
            hint => 'A roundabout replaces a crossing.');
    ELSIF coalesce(short, bent, other) IS NOT NULL THEN
        PERFORM streetgen._refuse('22023', format('a ring of %s m about node %s has no room', radius, node),
            detail => CASE WHEN short IS NOT NULL THEN format('Axis %s has its end or its next node within.', short)
                WHEN bent IS NOT NULL THEN format('Axis %s bends back into it.', bent)
                ELSE format('Axis %s passes within.', other) END,
            hint => 'Take a smaller radius.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._refuse_ring(name, bigint, float8) IS
    'Raises 22023 where no ring of so many metres can replace a node.';

CREATE OR REPLACE FUNCTION streetgen._ring_in_place(model name, node bigint, radius float8)
    RETURNS TABLE(ring geometry, axes bigint[], pieces geometry[], lanes integer, importance integer, level integer,
        kind text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    turns constant integer := CASE streetgen._driving_side(model) WHEN 'left' THEN 1 ELSE -1 END;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    WITH arm AS MATERIALIZED (
        SELECT a.* FROM streetgen._arms_of_ring(_ring_in_place.model, _ring_in_place.node, _ring_in_place.radius) a),
    -- Round the node at steps of 7.5 degrees, with a vertex where each arm meets it, from one of these on.
    centre AS (SELECT n.geom FROM node n WHERE n.node_id = _ring_in_place.node),
    mouth AS (
        SELECT a.place AS geom, degrees(ST_Azimuth(c.geom, a.place)) AS azimuth FROM arm a, centre c),
    vertex AS (
        SELECT azimuth, geom FROM mouth
        UNION ALL SELECT v.azimuth, ST_Translate(ST_Force2D(c.geom), _ring_in_place.radius * sin(radians(v.azimuth)),
            _ring_in_place.radius * cos(radians(v.azimuth)))
        FROM centre c, (SELECT 7.5 * n AS azimuth FROM generate_series(0, 47) n) v
        WHERE NOT EXISTS (SELECT FROM mouth m WHERE abs(m.azimuth - v.azimuth) < 4
            OR abs(m.azimuth - v.azimuth) > 356)),
    turned AS (
        SELECT v.geom, v.azimuth - m.first + CASE WHEN v.azimuth < m.first THEN 360 ELSE 0 END AS turn
        FROM vertex v, (SELECT min(azimuth) AS first FROM mouth) m),
    drawn AS (SELECT ST_MakeLine(geom ORDER BY turn > 0, turns * turn) AS line FROM turned),
    closed AS (
        SELECT CASE ST_CoordDim(c.geom) WHEN 3 THEN ST_Force3DZ(l.line, ST_Z(c.geom)) ELSE l.line END AS line
        FROM (SELECT ST_AddPoint(line, ST_StartPoint(line)) AS line FROM drawn) l, centre c),
    -- What lies beyond the last part that the ring takes in comes as one of no length.
    part AS (SELECT axis_id, low, high FROM arm UNION ALL SELECT DISTINCT axis_id, 1, 1 FROM arm),
    rest AS (
        SELECT axis_id, coalesce(max(high) OVER before, 0) AS low, low AS high FROM part
        WINDOW before AS (PARTITION BY axis_id ORDER BY low, high
            ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING)),
    piece AS (
        SELECT axis_id, low, ST_LineSubstring(a.geom, low, high) AS geom FROM rest JOIN axis a USING (axis_id)
        WHERE (high - low) * ST_Length2D(a.geom) > 1e-6),
    cut AS (SELECT axis_id, ST_Collect(geom ORDER BY low) AS geom FROM piece GROUP BY axis_id)
    SELECT (SELECT line FROM closed), (SELECT array_agg(axis_id ORDER BY axis_id) FROM cut),
        (SELECT array_agg(geom ORDER BY axis_id) FROM cut),
        (SELECT least(greatest(max(lanes), 1), 2) FROM arm), a.importance, a.level, a.kind
    FROM arm a ORDER BY a.importance, a.axis_id LIMIT 1;
END $$;
COMMENT ON FUNCTION streetgen._ring_in_place(name, bigint, float8) IS
    'A ring so many metres from a node, drawn as traffic goes round, with a vertex at each arm; the axes of its arms '
    'and what lies beyond the ring of each (MULTILINESTRING); lanes, importance, level and class of the ring.';

CREATE OR REPLACE FUNCTION streetgen.make_roundabout(model name, node bigint, radius float8) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    made record;
    ring_axis bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_axis_editor(model);
    PERFORM streetgen._check_given('node', node::text, 'radius', radius::text);
    PERFORM streetgen._lock_axes(model,
        format('SELECT axis_id FROM %I.edge WHERE %s IN (from_node, to_node)', model, node));
    PERFORM streetgen._refuse_ring(model, node, radius);
    SELECT * INTO made FROM streetgen._ring_in_place(model, node, radius);
    PERFORM streetgen._cut_axes(model, made.axes, made.pieces);
    INSERT INTO axis (geom, width, lane_count, direction, importance, level, kind, roundabout_tag)
        VALUES (made.ring, made.lanes * streetgen._setting_number(model, 'lane_width')
                + streetgen._setting_number(model, 'roundabout_widening'), made.lanes, 'direct', made.importance,
            made.level, made.kind, 'roundabout')
        RETURNING axis_id INTO ring_axis;
    RETURN ring_axis;
END $$;
COMMENT ON FUNCTION streetgen.make_roundabout(name, bigint, float8) IS
    'Makes a roundabout of a crossing: a ring so many metres from a node, in place of what its axes have within; '
    'returns the axis of the ring. All are axes to be edited, and the streets follow. Traffic goes round by the '
    'driving side. The ring has as many lanes as lead to the node on one arm, two at most, and is wider than they by '
    'setting roundabout_widening; class, importance and level are those of the most important arm. An unknown model: '
    '3F000; no such node, under three arms, a radius beyond the settings, or another street within: 22023; who may '
    'not edit the model: 42501.';
