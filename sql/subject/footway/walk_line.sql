-- The lines on which people walk: behind kerbs, along mapped lines, across streets, on roadways without a sidewalk.

CREATE OR REPLACE FUNCTION streetgen._built_walks(kerbs bytea[], offsets float8[], leads_on boolean[],
    mapped integer[], mapped_from float8[], mapped_to float8[], arrives integer[], leaves integer[],
    arm_streets integer[], streets bytea[], srid integer)
    RETURNS TABLE(kerb integer, arm integer, loose_start boolean, loose_end boolean, geom geometry)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 50000 AS 'MODULE_PATHNAME', 'streetgen_built_walks';
COMMENT ON FUNCTION streetgen._built_walks(bytea[], float8[], boolean[], integer[], float8[], float8[], integer[],
    integer[], integer[], bytea[], integer) IS
    'The walks (LINESTRING) behind kerbs (LINESTRING, EWKB) and across the ends of streets. offsets: from each kerb to '
    'the middle of its walk, metres, 0 for none; leads_on: of a corner or a dead end. mapped: the kerb of each stretch '
    'whose walk a source maps, from and to in metres along it, ascending. arrives, leaves: the kerbs that end and '
    'start at each arm; arm_streets: the line of streets along which one walks there. Numbers count from 1, 0 is none. '
    'A row has the kerb or the arm, and which ends are to be joined to a mapped walk. Lists of different length: '
    '2202E; NULL in one: 22004; bad geometry or number: 22023.';

CREATE OR REPLACE FUNCTION streetgen._walk_network(lines bytea[], levels integer[], mapped boolean[],
    reach_start float8[], reach_end float8[], excess_start float8[], excess_end float8[], srid integer)
    RETURNS TABLE(line integer, part integer, parts integer, walk_link_id bigint, from_node bigint, to_node bigint,
        geom geometry)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 50000 AS 'MODULE_PATHNAME', 'streetgen_walk_network';
COMMENT ON FUNCTION streetgen._walk_network(bytea[], integer[], boolean[], float8[], float8[], float8[], float8[],
    integer) IS
    'The links (LINESTRING) between nodes of lines on which people walk (LINESTRING, EWKB). Lines meet at vertices '
    'that they share, and where they cross on one level and one of them is not mapped. A loose end is led on to the '
    'nearest line within its reach, else its excess beyond the last node goes; metres. line: the number of the line, '
    'from 1; part: the number along it, of so many. Ids of nodes are of their place, those of links of their shape. '
    'Lists of different length: 2202E; NULL in one: 22004; bad geometry or number: 22023.';

CREATE OR REPLACE FUNCTION streetgen._walk_edges(model name, around geometry)
    RETURNS TABLE(edge_id bigint, from_node bigint, to_node bigint, level integer, geom geometry, width float8,
        walked_along boolean, crossed_on_foot boolean, street boolean)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT edge_id, from_node, to_node, e.level, e.geom, e.width, walked,
            coalesce(c.crossed_on_foot, true), walked
                AND streetgen._walk_width(e.sidewalk_left, a.strips_left, u.settings) = 0
                AND streetgen._walk_width(e.sidewalk_right, a.strips_right, u.settings) = 0
                AND a.sidewalk_apart IS NULL AND 'outer' IN (e.beside_left, e.beside_right)
                AND NOT EXISTS (SELECT FROM sidewalk_source s WHERE s.edge_id = e.edge_id)
        FROM edge e JOIN axis a USING (axis_id) LEFT JOIN axis_class c ON c.class = a.kind, setting_used u,
            LATERAL (SELECT coalesce(c.walked_along, true) AS walked) w
        WHERE around IS NULL OR e.geom && around;
END $$;
COMMENT ON FUNCTION streetgen._walk_edges(name, geometry) IS
    'The edges of a model whose box meets that around; NULL: all. walked_along, crossed_on_foot: as its class says; '
    'street: people walk on the roadway, since it has no sidewalk, is not said to have one apart, and leads not across '
    'a median.';

CREATE OR REPLACE FUNCTION streetgen._walked_on(use text, foot text) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN foot IS DISTINCT FROM 'no' AND (use IS DISTINCT FROM 'cycle' OR foot IS NOT NULL);
COMMENT ON FUNCTION streetgen._walked_on(text, text) IS
    'Whether people walk on a footway by the use of its class and by who may: on a cycle track where that is said.';

CREATE OR REPLACE FUNCTION streetgen._mapped_walks(model name, around geometry)
    RETURNS TABLE(footway_id bigint, kind text, level integer, width float8, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT footway_id, CASE WHEN f.role IS NOT NULL THEN f.role
            WHEN f.kind = 'elevator' THEN 'elevator' WHEN c.use = 'steps' THEN 'steps' ELSE 'walk' END, level,
            coalesce(f.width, c.width), ST_Force2D(f.geom)
        FROM footway f LEFT JOIN axis_class c ON c.class = f.kind
        WHERE streetgen._walked_on(c.use, f.foot) AND (around IS NULL OR f.geom && around);
END $$;
COMMENT ON FUNCTION streetgen._mapped_walks(name, geometry) IS
    'The footways of a model on which people may walk, as walks: sidewalk, crossing, elevator, steps or walk. Their '
    'box meets that around; NULL: all.';

CREATE OR REPLACE FUNCTION streetgen._walked_kerbs(model name, around geometry)
    RETURNS TABLE(number integer, edge_id bigint, node_id bigint, side text, part integer, level integer,
        kerb geometry, width float8, offset_to_walk float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 50000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- People walk in the middle of what bays, verges and cycle tracks leave of a strip.
    RETURN QUERY SELECT row_number() OVER (ORDER BY k.edge_id, k.side, k.part)::integer, k.edge_id, k.node_id, k.side,
            k.part, k.level, k.geom, CASE WHEN wanted THEN w.room END,
            CASE WHEN wanted THEN s.width - w.room / 2 ELSE 0 END
        FROM kerb k LEFT JOIN sidewalk s USING (edge_id, side, part) JOIN edge e ON e.edge_id = k.edge_id
            JOIN axis a USING (axis_id), setting_used u,
            LATERAL (SELECT CASE k.side WHEN 'left' THEN a.strips_left WHEN 'right' THEN a.strips_right END
                AS said) t,
            LATERAL (SELECT CASE WHEN s.strip IS NULL THEN streetgen._walk_width(s.width, t.said, u.settings)
                ELSE greatest(streetgen._walk_width(least(s.width, ST_Area(s.surface) / ST_Length(k.geom)), t.said,
                    u.settings), 0.5) END AS room) w,
            -- A strip that others hold for the most part is none.
            LATERAL (SELECT coalesce(streetgen._walk_width(s.width, t.said, u.settings) > 0
                AND ST_Area(s.surface) >= 0.25 * s.width * ST_Length(k.geom)
                OR k.node_id IS NOT NULL AND ST_Area(s.surface) > 0, false) AS wanted) d
        WHERE (around IS NULL OR k.geom && around) AND k.method <> 'level_change';
END $$;
COMMENT ON FUNCTION streetgen._walked_kerbs(name, geometry) IS
    'The kerbs of a model whose box meets that around, numbered from 1: the width that people have to walk behind each '
    'and how far the middle of that lies behind the kerb, metres; 0: nobody walks there. NULL: all.';

CREATE OR REPLACE FUNCTION streetgen._known_crossings(model name, around geometry)
    RETURNS TABLE(street_object_id bigint, edge_id bigint, abscissa float8, width float8, angle float8,
        marking text, kerb_left text, kerb_right text, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    with_object bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' = ANY (streetgen._subjects(model)) THEN
        with_object := ARRAY(SELECT p.control_point_id FROM control_point p JOIN street_object o
            ON o.type = 'crossing' AND ST_DWithin(o.geom, p.geom, 5) WHERE p.kind = 'pedestrian_crossing');
        RETURN QUERY SELECT street_object_id, edge_id, ST_Length(e.geom) * ST_LineLocatePoint(e.geom, o.geom), c.width,
                c.angle, coalesce(c.painted_as, c.marking), c.kerb_left, c.kerb_right, o.geom
            FROM pedestrian_crossing c JOIN street_object o USING (street_object_id)
                JOIN object_edge USING (street_object_id) JOIN edge e USING (edge_id)
                LEFT JOIN footway f ON o.rule_id = -1 AND f.footway_id = c.footway_id
                LEFT JOIN axis_class k ON k.class = f.kind
            WHERE streetgen._walked_on(k.use, f.foot) AND (around IS NULL OR o.geom && around);
    END IF;
    RETURN QUERY SELECT NULL::bigint, e.edge_id, abscissa - start_abscissa, NULL::float8, 90::float8, p.marking,
            p.kerb, p.kerb, p.geom
        FROM control_point p, LATERAL (SELECT edge_id, start_abscissa FROM edge e
            WHERE e.axis_id = p.axis_id AND p.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
            ORDER BY e.start_abscissa LIMIT 1) e
        WHERE p.kind = 'pedestrian_crossing' AND (around IS NULL OR p.geom && around)
            AND p.control_point_id NOT IN (SELECT unnest(with_object));
END $$;
COMMENT ON FUNCTION streetgen._known_crossings(name, geometry) IS
    'The pedestrian crossings of a model within a box, NULL: all: objects, and control points where none stands. '
    'abscissa: metres along the edge.';

CREATE OR REPLACE FUNCTION streetgen._across_roadway(model name, place geometry, level integer) RETURNS float8
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    of_level constant integer := level;
BEGIN
    PERFORM streetgen._use_model(model);
    -- To the kerb, and across the widest sidewalk behind it.
    RETURN coalesce((SELECT max(e.width / 2 + abs(e.roadway_offset)
            + greatest(e.sidewalk_left, e.sidewalk_right)) FROM edge e WHERE e.geom && ST_Expand(place, 20)
        AND e.level = of_level AND ST_DWithin(e.geom, place, greatest(e.width, e.width_end) / 2
            + abs(e.roadway_offset))), 0);
END $$;
COMMENT ON FUNCTION streetgen._across_roadway(name, geometry, integer) IS
    'How far from a place on a roadway the sidewalks beside that end at most, metres; 0: the place lies beside '
    'roadways. A walk that ends there is cut off or led on so far.';

CREATE OR REPLACE FUNCTION streetgen._walk_lines(model name, around geometry)
    RETURNS TABLE(number bigint, kind text, level integer, width float8, mapped boolean, reach_start float8,
        reach_end float8, excess_start float8, excess_end float8, footway_id bigint, edge_id bigint, side text,
        street_object_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    far constant float8 := streetgen._setting_number(model, 'mapped_sidewalk_distance');
    near constant float8 := streetgen._setting_number(model, 'walk_join_distance');
    of_arm constant float8 := streetgen._setting_number(model, 'crossing_of_arm');
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH walk_edge AS MATERIALIZED (SELECT * FROM streetgen._walk_edges(model, around)),
    mapped_walk AS MATERIALIZED (SELECT * FROM streetgen._mapped_walks(model, around)),
    walk_kerb AS MATERIALIZED (SELECT * FROM streetgen._walked_kerbs(model, around)),
    over_edge AS MATERIALIZED (
        SELECT e.edge_id, ST_Length(e.geom) * ST_LineLocatePoint(e.geom, ST_ClosestPoint(e.geom, w.geom))
            AS abscissa
        FROM mapped_walk w, LATERAL (SELECT e.edge_id, e.geom FROM edge e WHERE e.geom && ST_Expand(w.geom, 0.5)
                AND e.level = w.level OFFSET 0) e
        WHERE CASE w.kind WHEN 'crossing' THEN ST_DWithin(e.geom, w.geom, 0.5) ELSE ST_Crosses(e.geom, w.geom) END),
    known_crossing AS MATERIALIZED (SELECT c.*, e.level FROM streetgen._known_crossings(model, around) c
        JOIN walk_edge e USING (edge_id) WHERE e.walked_along),
    mapped_stretch AS MATERIALIZED (
        SELECT k.number, least(a, b) AS low, greatest(a, b) AS high
        FROM walk_kerb k JOIN sidewalk_source s USING (edge_id, side) JOIN walk_edge e USING (edge_id),
            LATERAL (SELECT ST_Length(e.geom) AS metres, ST_Length(k.kerb) AS whole) l,
            LATERAL (SELECT whole * ST_LineLocatePoint(k.kerb, ST_LineInterpolatePoint(e.geom,
                    least(s.start_abscissa / metres, 1))) AS a, whole * ST_LineLocatePoint(k.kerb,
                    ST_LineInterpolatePoint(e.geom, least(s.end_abscissa / metres, 1))) AS b) ab
        WHERE k.node_id IS NULL),
    sides AS MATERIALIZED (
        SELECT edge_id, (array_agg(number ORDER BY part) FILTER (WHERE side = 'left'))[1] AS left_first,
            (array_agg(number ORDER BY part DESC) FILTER (WHERE side = 'left'))[1] AS left_last,
            (array_agg(number ORDER BY part) FILTER (WHERE side = 'right'))[1] AS right_first,
            (array_agg(number ORDER BY part DESC) FILTER (WHERE side = 'right'))[1] AS right_last,
            coalesce(bool_or(offset_to_walk > 0) FILTER (WHERE side = 'left')
                AND bool_or(offset_to_walk > 0) FILTER (WHERE side = 'right'), false) AS both_walked
        FROM walk_kerb WHERE node_id IS NULL AND side IN ('left', 'right') GROUP BY edge_id),
    edge_end AS MATERIALIZED (
        SELECT e.*, at_start, CASE WHEN at_start THEN from_node ELSE to_node END AS node_id,
            CASE WHEN at_start THEN right_last ELSE left_last END AS arrives,
            CASE WHEN at_start THEN left_first ELSE right_first END AS leaves,
            coalesce(both_walked, false) AS both_walked
        FROM (SELECT * FROM walk_edge e WHERE e.walked_along) e LEFT JOIN sides USING (edge_id),
            (VALUES (true), (false)) v(at_start)),
    at_node AS MATERIALIZED (
        SELECT node_id, count(*) AS arms, count(*) FILTER (WHERE crossed_on_foot) AS crossed,
            count(*) FILTER (WHERE street) AS streets
        FROM (SELECT *, from_node AS node_id FROM walk_edge UNION ALL SELECT *, to_node FROM walk_edge) e
        GROUP BY node_id),
    -- People keep to their side where a street goes on, and at mouths of ways that nobody crosses for.
    arm AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY edge_id, at_start)::integer AS number, e.*
        FROM (SELECT e.*, ST_Length(e.geom) * ST_LineLocatePoint(e.geom, coalesce(ST_EndPoint(a.kerb),
                    ST_StartPoint(l.kerb))) AS abscissa
                FROM edge_end e JOIN at_node n USING (node_id) LEFT JOIN walk_kerb a ON a.number = e.arrives
                    LEFT JOIN walk_kerb l ON l.number = e.leaves
                WHERE arms > 1 AND (NOT both_walked OR crossed > 2 OR NOT crossed_on_foot AND arms > 2)) e
        -- A street that is walked along is entered from the walks at its end in any case.
        WHERE e.street OR NOT EXISTS (SELECT FROM over_edge o WHERE o.edge_id = e.edge_id
                AND abs(o.abscissa - e.abscissa) <= of_arm)
            AND NOT EXISTS (SELECT FROM known_crossing o WHERE o.edge_id = e.edge_id
                AND abs(o.abscissa - e.abscissa) <= of_arm)),
    arm_street AS MATERIALIZED (
        SELECT number, row_number() OVER (ORDER BY number)::integer AS place, geom FROM arm WHERE street),
    built AS MATERIALIZED (
        SELECT * FROM streetgen._built_walks(ARRAY(SELECT ST_Force2D(kerb)::bytea FROM walk_kerb ORDER BY number),
            ARRAY(SELECT offset_to_walk FROM walk_kerb ORDER BY number),
            ARRAY(SELECT node_id IS NOT NULL OR side IN ('start', 'end') FROM walk_kerb ORDER BY number),
            ARRAY(SELECT number FROM mapped_stretch ORDER BY number, low, high),
            ARRAY(SELECT low FROM mapped_stretch ORDER BY number, low, high),
            ARRAY(SELECT high FROM mapped_stretch ORDER BY number, low, high),
            ARRAY(SELECT coalesce(arrives, 0) FROM arm ORDER BY number),
            ARRAY(SELECT coalesce(leaves, 0) FROM arm ORDER BY number),
            ARRAY(SELECT coalesce(s.place, 0) FROM arm LEFT JOIN arm_street s USING (number) ORDER BY number),
            ARRAY(SELECT ST_Force2D(geom)::bytea FROM arm_street ORDER BY number), srid)),
    walk AS MATERIALIZED (
        SELECT 1 AS turn, footway_id AS id, kind, level, width, true AS mapped,
            greatest(reach, to_start) AS reach_start, greatest(reach, to_end) AS reach_end,
            CASE WHEN way THEN to_start WHEN to_start = 0 THEN near ELSE 0 END AS excess_start,
            CASE WHEN way THEN to_end WHEN to_end = 0 THEN near ELSE 0 END AS excess_end,
            footway_id, NULL::bigint AS edge_id, NULL::text AS side, NULL::bigint AS street_object_id, geom
        FROM mapped_walk,
            LATERAL (SELECT kind NOT IN ('crossing', 'sidewalk') AS way) w,
            LATERAL (SELECT CASE WHEN way THEN near ELSE far END AS reach) r,
            streetgen._across_roadway(model, ST_StartPoint(geom), level) to_start,
            streetgen._across_roadway(model, ST_EndPoint(geom), level) to_end
        UNION ALL SELECT 2, k.number, 'sidewalk', k.level, k.width, false, CASE WHEN b.loose_start THEN far ELSE 0 END,
            CASE WHEN b.loose_end THEN far ELSE 0 END, 0, 0, NULL, k.edge_id, k.side, NULL, b.geom
        FROM built b JOIN walk_kerb k ON k.number = b.kerb
        UNION ALL SELECT 3, a.number, 'crossing', a.level, NULL, false, CASE WHEN b.loose_start THEN far ELSE 0 END,
            CASE WHEN b.loose_end THEN far ELSE 0 END, 0, 0, NULL, a.edge_id, NULL, NULL, b.geom
        FROM built b JOIN arm a ON a.number = b.arm
        UNION ALL SELECT 4, row_number() OVER (ORDER BY c.edge_id, c.abscissa, c.street_object_id), 'crossing', c.level,
            c.width, false, far, far, 0, 0, NULL, c.edge_id, NULL, c.street_object_id, l.line
        FROM known_crossing c JOIN edge e USING (edge_id),
            LATERAL (SELECT ST_Length(e.geom) AS metres) m,
            LATERAL (SELECT (e.width + (e.width_end - e.width) * c.abscissa / metres) / 2 AS half,
                1 / tan(radians(c.angle)) AS slope) h,
            LATERAL (SELECT ST_SetSRID(ST_MakeLine(place ORDER BY aside), srid) AS line
                FROM (VALUES (e.roadway_offset - half), (e.roadway_offset + half)) v(aside), LATERAL (
                    SELECT streetgen._place_on(ST_Force2D(e.geom)::bytea, greatest(least(c.abscissa + aside * slope,
                        metres), 0), aside)::geometry AS place) o) l
        WHERE NOT e.edge_id IN (SELECT edge_id FROM walk_edge WHERE street) AND NOT EXISTS (SELECT FROM over_edge o
            WHERE o.edge_id = c.edge_id AND abs(o.abscissa - c.abscissa) <= 5)
        -- One that comes to streets with sidewalks ends at those, on this side or across.
        UNION ALL SELECT 5, edge_id, 'street', level, width, false,
            CASE WHEN at_street_from THEN near + streetgen._across_roadway(model, ST_StartPoint(geom), level)
                ELSE 0 END,
            CASE WHEN at_street_to THEN near + streetgen._across_roadway(model, ST_EndPoint(geom), level) ELSE 0 END,
            CASE WHEN at_street_from THEN far + of_arm ELSE 0 END,
            CASE WHEN at_street_to THEN far + of_arm ELSE 0 END, NULL, edge_id, NULL, NULL, geom
        FROM walk_edge JOIN at_node f ON f.node_id = from_node JOIN at_node t ON t.node_id = to_node,
            LATERAL (SELECT f.streets = 1 AND f.arms > 1 AS at_street_from, t.streets = 1 AND t.arms > 1
                AS at_street_to) a
        -- One within a junction, without kerbs, joins streets that are walked along or is none.
        WHERE street AND (f.streets + t.streets > 2 OR edge_id IN (SELECT edge_id FROM sides))),
    line AS (
        SELECT * FROM walk
        UNION ALL SELECT 6, e.street_area_id, 'square', w.level, NULL, false, 0, 0, e.excess, 0, NULL, NULL, NULL, NULL,
            e.geom
        FROM (SELECT *, ST_Buffer(geom, near) AS beside FROM streetgen._walked_areas(model, around) OFFSET 0) a
            JOIN walk w ON w.kind = 'sidewalk' AND w.level = a.level AND w.geom && a.beside
                AND ST_Intersects(w.geom, a.beside),
            streetgen._area_entry(w.geom, a.street_area_id, a.geom, a.beside) e)
    SELECT row_number() OVER (ORDER BY turn, id, ST_Length(geom)), kind, level, width, mapped, reach_start, reach_end,
        excess_start, excess_end, footway_id, edge_id, side, street_object_id, geom FROM line;
END $$;
COMMENT ON FUNCTION streetgen._walk_lines(name, geometry) IS
    'The lines on which people walk in a model, near a box; NULL: all. kind: sidewalk, crossing, walk, steps, '
    'elevator, square or street. reach and excess as streetgen._walk_network takes them.';
