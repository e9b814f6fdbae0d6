-- What the writers of formats in three dimensions share: the surfaces of a model as triangles, part by part.

CREATE OR REPLACE FUNCTION streetgen._mesh_layer()
    RETURNS TABLE(layer text, covers boolean, raised float8, roughness float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 14 SET search_path = pg_catalog
    AS $$ VALUES
    ('block', false, 0.13::float8, 1::float8), ('section', false, 0, 0.9), ('intersection', false, 0, 0.9),
    ('sidewalk', false, 0.15, 0.8), ('kerb', NULL, NULL, 0.7),
    ('side_strip', true, 0.152, 0.9), ('bay', true, 0.152, 0.9), ('lane', true, 0.002, 0.9),
    ('lane_separator', true, 0.005, 0.5), ('marking', true, 0.005, 0.5), ('rim_marking', true, 0.005, 0.5),
    ('crossing', true, 0.005, 0.5), ('bus_stop_box', true, 0.006, 0.5), ('refuge', true, 0.006, 0.8),
    ('object', NULL, NULL, 0.8) $$;
COMMENT ON FUNCTION streetgen._mesh_layer() IS
    'What a mesh of streets consists of, each a layer of symbol_rule: ground, or what covers ground (paint); what it '
    'is raised above the roadway, metres; and its roughness. Where streets have heights, covers lie higher by twice '
    'the tolerance. A kerb closes the step between raised ground and the roadway, and objects stand on it.';

CREATE OR REPLACE FUNCTION streetgen._mesh_material(model name)
    RETURNS TABLE(number integer, layer text, kind text, name text, fill text, roughness float8)
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE ROWS 30 SET search_path = pg_catalog
    -- Scale 1 has the colours that one sees from near.
    AS $$ SELECT row_number() OVER (ORDER BY l.layer, kind)::integer - 1, l.layer, k.kind,
            concat_ws('_', l.layer, nullif(k.kind, '')), k.fill, l.roughness
        FROM streetgen._mesh_layer() l, LATERAL (SELECT DISTINCT ON (kind) kind, fill FROM (
            SELECT s.kind, s.fill, s.symbol FROM streetgen._symbols(model, 'street', 1) s
                WHERE s.layer = l.layer AND s.marker IS NULL AND s.fill IS NOT NULL
            UNION ALL SELECT '', NULL, -1) f ORDER BY kind, symbol DESC) k $$;
COMMENT ON FUNCTION streetgen._mesh_material(name) IS
    'The materials of a mesh of streets, numbered from 0: a layer, or a kind of it that theme street draws by itself '
    '(an empty kind: all others), its name in files, its colour (NULL: no rule gives one) and its roughness.';

CREATE OR REPLACE FUNCTION streetgen._mesh_names(model name) RETURNS text[]
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(name ORDER BY number) FROM streetgen._mesh_material(model) $$;
COMMENT ON FUNCTION streetgen._mesh_names(name) IS 'The names of all materials of a mesh of streets, in their order.';

CREATE OR REPLACE FUNCTION streetgen._mesh_cells(model name, options jsonb)
    RETURNS TABLE(cell integer, east integer, north integer, edges bigint[], nodes bigint[], about geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH written_edge AS MATERIALIZED (SELECT * FROM edge
        WHERE edge_id IN (SELECT streetgen._written_edges(model, options))),
    member AS (
        SELECT edge_id, NULL::bigint AS node_id, ST_StartPoint(geom) AS place, geom FROM written_edge
        UNION ALL SELECT NULL, node_id, geom, geom FROM node
        WHERE node_id IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge))
    SELECT row_number() OVER (ORDER BY x, y)::integer, x, y, coalesce(array_agg(edge_id ORDER BY edge_id)
            FILTER (WHERE edge_id IS NOT NULL), '{}'), coalesce(array_agg(node_id ORDER BY node_id)
            FILTER (WHERE node_id IS NOT NULL), '{}'), ST_SetSRID(ST_Extent(geom)::geometry, ST_SRID(min(place)))
    FROM member, LATERAL (SELECT floor(ST_X(place) / 500)::integer AS x, floor(ST_Y(place) / 500)::integer AS y) c
    GROUP BY x, y ORDER BY x, y;
END $$;
COMMENT ON FUNCTION streetgen._mesh_cells(name, jsonb) IS
    'The edges that options take, with their nodes, by squares of 500 m: what is meshed at once. east and north '
    'number the squares from the origin of the SRID; about is the box of the lines.';

CREATE OR REPLACE FUNCTION streetgen._mesh_ground(model name, edges bigint[], nodes bigint[], boxes geometry[],
    levels integer[])
    RETURNS TABLE(layer text, kind text, id bigint, part integer, edge_id bigint, node_id bigint, level integer,
        surface geometry, line geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'section', streetgen._paving_kind(p.roadway), 2 * e.edge_id, 0, e.edge_id, NULL::bigint,
            s.level, s.surface, e.geom
        FROM section s JOIN edge e ON e.edge_id = s.edge_id JOIN paving p ON p.edge_id = s.edge_id
        WHERE s.edge_id IN (SELECT unnest(edges) UNION SELECT near.edge_id FROM unnest(boxes, levels) b(box, box_level),
            LATERAL (SELECT n.edge_id FROM section n WHERE n.surface && box AND n.level = box_level OFFSET 0) near);
    -- An intersection looks as its streets do, where all of these are paved alike.
    RETURN QUERY SELECT 'intersection', (SELECT CASE WHEN min(k) = max(k) THEN min(k) ELSE '' END
                FROM (SELECT streetgen._paving_kind(p.roadway) FROM paving p JOIN edge e ON e.edge_id = p.edge_id
                    WHERE n.node_id IN (e.from_node, e.to_node)) a(k)), 2 * n.node_id + 1, 0, NULL::bigint, n.node_id,
            i.level, i.surface, ST_MakeLine(n.geom, ST_Translate(n.geom, 1, 0))
        FROM intersection i JOIN node n ON n.node_id = i.node_id
        WHERE i.node_id IN (SELECT unnest(nodes) UNION SELECT near.node_id FROM unnest(boxes, levels) b(box, box_level),
            LATERAL (SELECT m.node_id FROM intersection m WHERE m.surface && box
                AND m.level = box_level OFFSET 0) near);
    IF 'sidewalk' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'sidewalk', streetgen._paving_kind(CASE s.side WHEN 'left' THEN p.sidewalk_left
                WHEN 'right' THEN p.sidewalk_right
                ELSE CASE p.sidewalk_left WHEN p.sidewalk_right THEN p.sidewalk_left END END),
                s.sidewalk_id, s.part, s.edge_id, s.node_id, k.level, coalesce(s.strip, s.surface), e.geom
            FROM sidewalk s JOIN edge e ON e.edge_id = s.edge_id JOIN paving p ON p.edge_id = s.edge_id
                JOIN kerb k ON (k.edge_id, k.side, k.part) = (s.edge_id, s.side, s.part)
            WHERE s.sidewalk_id IN (
                SELECT o.sidewalk_id FROM sidewalk o WHERE o.edge_id = ANY (edges) AND o.node_id IS NULL
                UNION SELECT o.sidewalk_id FROM sidewalk o WHERE o.node_id = ANY (nodes)
                UNION SELECT near.sidewalk_id FROM unnest(boxes, levels) b(box, box_level), LATERAL (
                    SELECT o.sidewalk_id FROM sidewalk o JOIN kerb q ON (q.edge_id, q.side, q.part)
                        = (o.edge_id, o.side, o.part) WHERE o.surface && box AND q.level = box_level OFFSET 0) near);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mesh_ground(name, bigint[], bigint[], geometry[], integer[]) IS
    'The surfaces of the ground, roadway and sidewalks, that are written in three dimensions: those of edges and of '
    'nodes, and those that meet the boxes, each of a level. layer and kind are those of symbol_rule. Each is of a node '
    'or, without one, of an edge; line is what texture is counted along.';

CREATE OR REPLACE FUNCTION streetgen._mesh_blocks(model name, edges bigint[], options jsonb)
    RETURNS TABLE(kind text, id bigint, edge_id bigint, level integer, surface geometry, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'block' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT b.kind, b.block_id, o.edge_id, e.level, b.surface, e.geom
            FROM (SELECT a.block_id, min(a.edge_id) AS edge_id FROM block_edge a
                WHERE a.block_id IN (SELECT n.block_id FROM block_edge n WHERE n.edge_id = ANY (edges))
                    AND a.edge_id IN (SELECT streetgen._written_edges(model, options)) GROUP BY a.block_id) o
                JOIN block b ON b.block_id = o.block_id JOIN edge e ON e.edge_id = o.edge_id
            WHERE o.edge_id = ANY (edges);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mesh_blocks(name, bigint[], jsonb) IS
    'The blocks beside edges, each with the smallest edge beside it that options take, where that is one of these; '
    'none of a model that computes no blocks.';

CREATE OR REPLACE FUNCTION streetgen._mesh_covers(model name, edges bigint[])
    RETURNS TABLE(layer text, kind text, id bigint, edge_id bigint, level integer, surface geometry, line geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'lane' = ANY (subjects) THEN
        RETURN QUERY SELECT 'lane', l.kind, l.lane_id, l.edge_id, e.level, l.surface, e.geom
            FROM lane l JOIN edge e ON e.edge_id = l.edge_id
            WHERE l.edge_id = ANY (edges) AND l.kind IN ('bus', 'carpool', 'cycle');
        RETURN QUERY SELECT 'lane_separator', s.kind, s.lane_separator_id, s.edge_id, e.level, s.surface, e.geom
            FROM lane_separator s JOIN edge e ON e.edge_id = s.edge_id WHERE s.edge_id = ANY (edges);
        RETURN QUERY SELECT 'marking', m.kind, m.marking_id, m.edge_id, e.level, m.surface, e.geom
            FROM marking m JOIN edge e ON e.edge_id = m.edge_id WHERE m.edge_id = ANY (edges);
    END IF;
    IF 'junction' = ANY (subjects) THEN
        RETURN QUERY SELECT 'rim_marking', m.kind, m.marking_id, m.edge_id, e.level, m.surface::geometry, e.geom
            FROM rim_marking m JOIN edge e ON e.edge_id = m.edge_id WHERE m.edge_id = ANY (edges);
    END IF;
    IF 'sidewalk' = ANY (subjects) THEN
        RETURN QUERY SELECT 'side_strip', s.kind, s.side_strip_id, s.edge_id, s.level, s.surface::geometry, e.geom
            FROM side_strip s JOIN edge e ON e.edge_id = s.edge_id WHERE s.edge_id = ANY (edges);
    END IF;
    IF 'object' = ANY (subjects) THEN
        RETURN QUERY SELECT v.layer, v.kind, o.street_object_id, e.edge_id, e.level, v.surface, e.geom
            FROM object_edge o JOIN edge e ON e.edge_id = o.edge_id
                LEFT JOIN pedestrian_crossing c ON c.street_object_id = o.street_object_id
                LEFT JOIN parking_bay b ON b.street_object_id = o.street_object_id,
                LATERAL (VALUES ('crossing', c.painted_as, c.stripes::geometry), ('refuge', '', c.island::geometry),
                    ('bay', '', b.surface::geometry)) v(layer, kind, surface)
            WHERE o.edge_id = ANY (edges) AND v.surface IS NOT NULL;
        IF to_regclass('bus_stop_box') IS NOT NULL THEN
            RETURN QUERY SELECT 'bus_stop_box', b.kind, b.street_object_id, b.edge_id, b.level, b.paint::geometry,
                    e.geom
                FROM bus_stop_box b JOIN edge e ON e.edge_id = b.edge_id WHERE b.edge_id = ANY (edges);
        END IF;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mesh_covers(name, bigint[]) IS
    'What lies on the ground of edges: lanes that have a colour, lines between lanes, markings, strips of sidewalks, '
    'crossings, refuges, bays and boxes of bus stops, as far as the model computes them. layer and kind are those of '
    'symbol_rule.';

CREATE OR REPLACE FUNCTION streetgen._mesh_laid(model name, edges bigint[], nodes bigint[], layers text[],
    names text[], options jsonb, lift float8)
    RETURNS TABLE(surfaces bytea[], levels integer[], wanted boolean[], raised float8[], lines bytea[],
        materials integer[], ids bigint[], edge_ids bigint[], node_ids bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
#variable_conflict use_column
BEGIN
    RETURN QUERY WITH own AS MATERIALIZED (
        SELECT * FROM streetgen._mesh_ground(model, edges, nodes, NULL, NULL) WHERE NOT ST_IsEmpty(surface)),
    -- Neighbours tell which vertices they have on common borders.
    member AS MATERIALIZED (
        SELECT *, true AS wanted FROM own
        UNION ALL (SELECT DISTINCT ON (g.layer, g.id) g.*, false
            FROM (SELECT array_agg(ST_Expand(surface, 0.01)) AS boxes, array_agg(level) AS levels FROM own) o,
                streetgen._mesh_ground(model, NULL, NULL, boxes, levels) g
            WHERE NOT ST_IsEmpty(g.surface) AND (g.layer, g.id) NOT IN (SELECT layer, id FROM own))
        UNION ALL SELECT 'block', kind, id, 0, edge_id, NULL, level, surface, line, true
        FROM streetgen._mesh_blocks(model, edges, options)
        WHERE 'block' = ANY (layers) AND NOT ST_IsEmpty(surface)
        UNION ALL SELECT layer, kind, id, 0, edge_id, NULL, level, surface, line, true
        FROM streetgen._mesh_covers(model, edges) WHERE layer = ANY (layers) AND NOT ST_IsEmpty(surface)),
    numbered AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY layer, id, part, kind) AS number, m.*,
            coalesce(array_position(names, layer || '_' || kind), array_position(names, layer)) - 1 AS material
        FROM member m)
    SELECT array_agg(ST_Multi(surface)::bytea ORDER BY number), array_agg(level ORDER BY number),
        array_agg(wanted ORDER BY number),
        array_agg(l.raised + CASE WHEN covers THEN lift ELSE 0 END ORDER BY number),
        array_agg(line::bytea ORDER BY number), array_agg(material ORDER BY number), array_agg(id ORDER BY number),
        array_agg(CASE WHEN node_id IS NULL THEN edge_id END ORDER BY number), array_agg(node_id ORDER BY number)
    FROM numbered JOIN streetgen._mesh_layer() l USING (layer);
END $$;
COMMENT ON FUNCTION streetgen._mesh_laid(name, bigint[], bigint[], text[], text[], jsonb, float8) IS
    'The surfaces of edges and nodes (wanted) and those beside them as arguments of streetgen._road_mesh, by number '
    'from 1: with their materials, the ids that their layers give them, and the edge or the node that each is of. Of '
    'blocks and covers, the layers that are named. names are those of all materials. Covers are lifted, metres.';

CREATE OR REPLACE FUNCTION streetgen._mesh_lift(axes bytea[], options jsonb) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN cardinality(axes) > 0 THEN 2 * (options ->> 'tolerance')::float8 ELSE 0 END;
COMMENT ON FUNCTION streetgen._mesh_lift(bytea[], jsonb) IS
    'How far covers are lifted, metres: where axes give heights, a cover leaves these by the tolerance, and so does '
    'the roadway below.';

CREATE OR REPLACE FUNCTION streetgen._street_mesh(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, node_id bigint, layer text, kind text, id bigint, mesh geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    names constant text[] := streetgen._mesh_names(model);
    cell record;
BEGIN
    FOR cell IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY SELECT l.edge_ids[t.number], l.node_ids[t.number],
                CASE WHEN t.kerb THEN 'kerb' ELSE k.layer END, CASE WHEN t.kerb THEN '' ELSE k.kind END,
                l.ids[t.number], t.mesh::geometry
            FROM streetgen._mesh_laid(model, cell.edges, cell.nodes, '{}', names, options, 0) l
                CROSS JOIN streetgen._mesh_heights(model, cell.about) a CROSS JOIN LATERAL
                streetgen._road_mesh(l.surfaces, l.levels, l.wanted, l.raised, l.lines, a.axes, a.axis_levels,
                    a.axis_widths, (options ->> 'tolerance')::float8, srid) t
                JOIN streetgen._mesh_material(model) k ON k.number = l.materials[t.number];
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._street_mesh(name, jsonb) IS
    'The ground of the streets that options take as triangles, without covers and blocks: a row for each surface of an '
    'edge or a node, by the id that its layer gives it, and one for its kerbs, each a TIN Z. Neighbours share '
    'vertices.';
