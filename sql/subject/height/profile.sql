-- Heights of roads: of a whole model, and of what a change touches.

CREATE OR REPLACE FUNCTION streetgen._by_speed(entries jsonb, speed float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT value::float8 FROM jsonb_each_text(entries) ORDER BY key::float8 > speed, CASE
        WHEN key::float8 > speed THEN key::float8 ELSE -key::float8 END LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._by_speed(jsonb, float8) IS
    'What a speed (km/h) has by an object of speed to number: the entry at or before it, before the first the first.';

CREATE OR REPLACE FUNCTION streetgen._height_along(line geometry, abscissa float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Z(ST_LineInterpolatePoint(line, least(1, greatest(0, abscissa / ST_Length2D(line))))) $$;
COMMENT ON FUNCTION streetgen._height_along(geometry, float8) IS
    'The height (m) of a LINESTRING Z at an abscissa, metres along it in the plane.';

CREATE OR REPLACE FUNCTION streetgen._profiles(lines bytea[], from_nodes bigint[], to_nodes bigint[], grades float8[],
    radii float8[], grades_greatest float8[], rises float8[], ends_from boolean[], ends_to boolean[],
    above integer[], at_above float8[], below integer[], at_below float8[], clearances float8[],
    sinks boolean[], by_hand integer[], at_hand float8[], heights float8[], level_length float8,
    plateau float8, srid integer)
    RETURNS TABLE(number integer, line bytea, grade_max float8, method text, tied_from boolean, tied_to boolean)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1000 AS 'MODULE_PATHNAME', 'streetgen_profiles';
COMMENT ON FUNCTION streetgen._profiles(bytea[], bigint[], bigint[], float8[], float8[], float8[], float8[],
    boolean[], boolean[], integer[], float8[], integer[], float8[], float8[], boolean[], integer[], float8[],
    float8[], float8, float8, integer) IS
    'The height (LINESTRING Z, EWKB) of each line, its greatest grade, how it came about (ground, lifted or sunk), and '
    'at which of its nodes all lines are solved together. '
    'radii: of vertical arcs, m. rises: over the ground, m, of bridges (tunnels: negative; 0: neither), which end at a '
    'node or are led on. level_length: that of bridges that may stay level, m. plateau: so many times the way on which '
    'a road comes down. above and below: numbers, from 1, of the lines that cross there, with metres along '
    'them. by_hand: numbers of lines that lie at least so high there. Arrays of one thing have one length (2202E); a '
    'NULL in one: 22004; a number of no line: 22023.';

CREATE OR REPLACE FUNCTION streetgen._solved_profile(edges streetgen.profile_edge[], lifts streetgen.profile_lift[],
    heights streetgen.profile_height[], level_length float8, plateau float8, srid integer)
    RETURNS SETOF streetgen.solved_profile
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
-- Where not all clearances can be kept the order tells which ones are: by lines, since keys tell who came first.
WITH edge AS MATERIALIZED (
    SELECT row_number() OVER (ORDER BY e.line, e.edge_id)::integer AS number, e.* FROM unnest(edges) e),
lift AS MATERIALIZED (
    SELECT a.number AS above, l.abscissa_above, b.number AS below, l.abscissa_below, l.clearance, l.sinks,
        row_number() OVER (ORDER BY a.number, l.abscissa_above, b.number) AS turn
    FROM unnest(lifts) l JOIN edge a ON a.edge_id = l.edge_above JOIN edge b ON b.edge_id = l.edge_below),
by_hand AS MATERIALIZED (SELECT e.number, h.abscissa, h.height FROM unnest(heights) h JOIN edge e USING (edge_id))
SELECT e.edge_id, p.line, p.grade_max, p.method, p.tied_from, p.tied_to
FROM (SELECT array_agg(line ORDER BY number) AS lines, array_agg(from_node ORDER BY number) AS from_nodes,
        array_agg(to_node ORDER BY number) AS to_nodes, array_agg(grade ORDER BY number) AS grades,
        -- A car rises and sinks at no more than half a metre a second squared.
        array_agg((speed / 3.6) ^ 2 / 0.5 ORDER BY number) AS radii,
        array_agg(grade_greatest ORDER BY number) AS grades_greatest, array_agg(rise ORDER BY number) AS rises,
        array_agg(ends_from ORDER BY number) AS ends_from, array_agg(ends_to ORDER BY number) AS ends_to FROM edge) g,
    (SELECT coalesce(array_agg(above ORDER BY turn), '{}') AS above,
        coalesce(array_agg(abscissa_above ORDER BY turn), '{}') AS at_above,
        coalesce(array_agg(below ORDER BY turn), '{}') AS below,
        coalesce(array_agg(abscissa_below ORDER BY turn), '{}') AS at_below,
        coalesce(array_agg(clearance ORDER BY turn), '{}') AS clearances,
        coalesce(array_agg(sinks ORDER BY turn), '{}') AS sinks FROM lift) t,
    (SELECT coalesce(array_agg(number ORDER BY number, abscissa, height), '{}') AS numbers,
        coalesce(array_agg(abscissa ORDER BY number, abscissa, height), '{}') AS at,
        coalesce(array_agg(height ORDER BY number, abscissa, height), '{}') AS heights FROM by_hand) h,
    streetgen._profiles(lines, from_nodes, to_nodes, grades, radii, grades_greatest, rises, g.ends_from, g.ends_to,
        above, at_above, below, at_below, clearances, t.sinks, h.numbers, h.at, h.heights, level_length, plateau, srid)
        p JOIN edge e USING (number) $$;
COMMENT ON FUNCTION streetgen._solved_profile(streetgen.profile_edge[], streetgen.profile_lift[],
    streetgen.profile_height[], float8, float8, integer) IS
    'The heights along edges, with all that lifts and sinks them.';

CREATE OR REPLACE FUNCTION streetgen._renewed_profile(model name, edges streetgen.profile_edge[],
    lifts streetgen.profile_lift[], heights streetgen.profile_height[], gone bigint[], axes bigint[])
    RETURNS SETOF streetgen.solved_profile
    -- STABLE: it sees the model before the statement that calls it.
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    region streetgen.profile_edge[] := edges;
    crossings streetgen.profile_lift[] := lifts;
    by_hand streetgen.profile_height[] := heights;
    known bigint[] := ARRAY(SELECT e.edge_id FROM unnest(edges) e) || gone;
    rules record;
    asked bigint[];
    solved streetgen.solved_profile[];
    tied bigint[] := '{}';
    ends bigint[];
    more bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT m.srid, m.dimension INTO place FROM streetgen.model m WHERE m.name = model;
    SELECT (v ->> 'grade_usual')::jsonb AS usual, (v ->> 'grade_maximal')::jsonb AS greatest,
        (v ->> 'bridge_rise')::float8 AS bridge_rise,
        (v ->> 'bridge_level_length')::float8 AS level_length, (v ->> 'plateau')::float8 AS plateau
        FROM (SELECT jsonb_object_agg(name, value) AS v FROM setting) s INTO rules;
    -- A node without a height has the nearest one, before and after: no axis that lies farther off changes it. An edge
    -- lies no farther from its axis than the reach.
    IF place.dimension = 3 THEN
        WITH line AS MATERIALIZED (SELECT geom FROM (SELECT geom FROM axis WHERE axis_id = ANY (axes)
                UNION ALL SELECT geom FROM edge WHERE axis_id = ANY (axes)) l
            WHERE streetgen._known_height(ST_ZMin(geom)) IS NOT NULL OR streetgen._known_height(ST_ZMax(geom)) IS NOT
                NULL),
        hole AS MATERIALIZED (SELECT n.node_id, n.geom, r.reach, min(ST_Distance(n.geom, l.geom)) AS apart
            FROM (SELECT value::float8 AS reach FROM setting WHERE name = 'reach') r CROSS JOIN line l
                JOIN node n ON ST_DWithin(n.geom, l.geom, 500 + reach)
            WHERE ST_Z(n.geom) NOT BETWEEN -500 AND 10000 GROUP BY n.node_id, r.reach)
        SELECT ARRAY(SELECT e.edge_id FROM hole h, streetgen._nearest_height(model, h.geom) v, edge e
            WHERE apart <= coalesce(v.distance, 500) + reach AND (e.from_node = h.node_id OR e.to_node = h.node_id)
            EXCEPT SELECT unnest(known)) INTO more;
    END IF;
    -- The region is closed: no crossing and no tied node, before or after, leads from it to others. Then its edges
    -- have the heights that they have among all, and the others keep theirs (include/streetgen/profile.hpp).
    LOOP
        IF more <> '{}' THEN
            ends := ARRAY(SELECT streetgen._bridge_ends(model, ARRAY(SELECT unnest(ARRAY[from_node, to_node]) FROM edge
                WHERE edge_id = ANY (more) AND streetgen._off_ground(level, geom) <> 0)));
            SELECT region || ARRAY(SELECT ROW (e.edge_id, e.from_node, e.to_node,
                    streetgen._ground_of(model, e.geom, f.geom, t.geom)::bytea,
                    streetgen._by_speed(rules.usual, e.speed) / 100,
                    streetgen._by_speed(rules.greatest, e.speed) / 100, e.speed, rules.bridge_rise * off_ground,
                    e.from_node = ANY (ends), e.to_node = ANY (ends))::streetgen.profile_edge
                FROM edge e JOIN node f ON f.node_id = e.from_node JOIN node t ON t.node_id = e.to_node,
                    LATERAL (SELECT streetgen._off_ground(e.level, e.geom) AS off_ground) o
                WHERE e.edge_id = ANY (more)),
                crossings || ARRAY(SELECT ROW (o.edge_above, o.abscissa_above, o.edge_below, o.abscissa_below,
                    o.clearance,
                    b.level < 0)::streetgen.profile_lift
                FROM overpass o JOIN edge b ON b.edge_id = o.edge_below
                WHERE (o.edge_above = ANY (more) OR o.edge_below = ANY (more))
                    AND NOT ARRAY[o.edge_above, o.edge_below] && known),
                by_hand || ARRAY(SELECT h FROM edge e, LATERAL streetgen._heights_by_hand(model, e.edge_id, e.axis_id,
                    e.start_abscissa, e.end_abscissa, ST_Length2D(e.geom)) h WHERE e.edge_id = ANY (more))
                        INTO region, crossings, by_hand;
            known := known || more;
            -- Edges that were known before were asked for their neighbours before.
            asked := CASE WHEN asked IS NULL THEN known ELSE more END;
            solved := NULL;
        END IF;
        asked := coalesce(asked, known);
        WITH near AS MATERIALIZED (SELECT array_agg(from_node) || array_agg(to_node) AS nodes FROM (
            SELECT from_node, to_node FROM unnest(region) WHERE asked = known
            UNION ALL SELECT from_node, to_node FROM edge WHERE edge_id = ANY (asked)) e)
        SELECT ARRAY(
            SELECT unnest(ARRAY[edge_above, edge_below]) FROM unnest(crossings)
            UNION SELECT edge_above FROM overpass WHERE edge_below = ANY (asked)
            UNION SELECT edge_below FROM overpass WHERE edge_above = ANY (asked)
            UNION SELECT edge_id FROM edge e JOIN profile p USING (edge_id)
                WHERE from_node = ANY ((SELECT nodes FROM near)::bigint[]) AND (tied_from OR from_node = ANY (tied))
            UNION SELECT edge_id FROM edge e JOIN profile p USING (edge_id)
                WHERE to_node = ANY ((SELECT nodes FROM near)::bigint[]) AND (tied_to OR to_node = ANY (tied))
            EXCEPT SELECT unnest(known)) INTO more;
        IF more = '{}' THEN
            EXIT WHEN solved IS NOT NULL;
            solved := ARRAY(SELECT s FROM streetgen._solved_profile(region, crossings, by_hand,
                rules.level_length, rules.plateau, place.srid) s);
            tied := ARRAY(SELECT v.node FROM unnest(solved) s JOIN unnest(region) e USING (edge_id),
                LATERAL (VALUES (e.from_node, s.tied_from), (e.to_node, s.tied_to)) v(node, is_tied) WHERE v.is_tied);
            EXIT WHEN tied = '{}';
            asked := known;
        END IF;
    END LOOP;
    RETURN QUERY SELECT * FROM unnest(solved);
END $$;
COMMENT ON FUNCTION streetgen._renewed_profile(name, streetgen.profile_edge[], streetgen.profile_lift[],
    streetgen.profile_height[], bigint[], bigint[]) IS
    'The heights along all edges that a change can move: edges, lifts and heights by hand as they are written, gone '
    'the edges that go, axes those whose rows are written; the others, and their crossings, as the model has them.';
