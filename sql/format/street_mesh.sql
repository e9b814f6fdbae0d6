-- What the writers of formats in three dimensions share: the surfaces of a model as triangles, part by part.

CREATE OR REPLACE FUNCTION streetgen._mesh_kind()
    RETURNS TABLE(number integer, kind text, raised float8, roughness float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (0, 'section', 0::float8, 0.9::float8), (1, 'intersection', 0, 0.9), (2, 'sidewalk', 0.15, 0.8),
    (3, 'kerb', NULL, 0.7), (4, 'marking', 0.005, 0.5) $$;
COMMENT ON FUNCTION streetgen._mesh_kind() IS
    'The kinds of what a mesh of streets consists of, each a layer of symbol_rule: number from 0, what it is raised '
    'above the roadway, metres (of paint, beyond twice the tolerance), and its roughness. A kerb closes the step '
    'between a sidewalk and the roadway.';

CREATE OR REPLACE FUNCTION streetgen._mesh_cells(model name, options jsonb)
    RETURNS TABLE(cell integer, edges bigint[], nodes bigint[], about geometry)
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
    SELECT row_number() OVER (ORDER BY x, y)::integer, coalesce(array_agg(edge_id ORDER BY edge_id)
            FILTER (WHERE edge_id IS NOT NULL), '{}'), coalesce(array_agg(node_id ORDER BY node_id)
            FILTER (WHERE node_id IS NOT NULL), '{}'), ST_SetSRID(ST_Extent(geom)::geometry, ST_SRID(min(place)))
    FROM member, LATERAL (SELECT floor(ST_X(place) / 500) AS x, floor(ST_Y(place) / 500) AS y) c
    GROUP BY x, y ORDER BY x, y;
END $$;
COMMENT ON FUNCTION streetgen._mesh_cells(name, jsonb) IS
    'The edges that options take, with their nodes, by squares of 500 m: what is meshed at once. about is the box of '
    'their lines.';

CREATE OR REPLACE FUNCTION streetgen._mesh_ground(model name, edges bigint[], nodes bigint[], boxes geometry[],
    levels integer[])
    RETURNS TABLE(kind text, id bigint, part integer, edge_id bigint, node_id bigint, level integer, surface geometry,
        line geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'section', 2 * e.edge_id, 0, e.edge_id, NULL::bigint, s.level, s.surface, e.geom
        FROM section s JOIN edge e ON e.edge_id = s.edge_id
        WHERE s.edge_id IN (SELECT unnest(edges) UNION SELECT near.edge_id FROM unnest(boxes, levels) b(box, box_level),
            LATERAL (SELECT n.edge_id FROM section n WHERE n.surface && box AND n.level = box_level OFFSET 0) near);
    RETURN QUERY SELECT 'intersection', 2 * n.node_id + 1, 0, NULL::bigint, n.node_id, i.level, i.surface,
            ST_MakeLine(n.geom, ST_Translate(n.geom, 1, 0))
        FROM intersection i JOIN node n ON n.node_id = i.node_id
        WHERE i.node_id IN (SELECT unnest(nodes) UNION SELECT near.node_id FROM unnest(boxes, levels) b(box, box_level),
            LATERAL (SELECT m.node_id FROM intersection m WHERE m.surface && box
                AND m.level = box_level OFFSET 0) near);
    IF 'sidewalk' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'sidewalk', s.sidewalk_id, s.part, s.edge_id, s.node_id, k.level,
                coalesce(s.strip, s.surface), e.geom
            FROM sidewalk s JOIN edge e ON e.edge_id = s.edge_id
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
    'nodes, and those that meet the boxes, each of a level. Each is of a node or, without one, of an edge; line is '
    'what texture is counted along.';

CREATE OR REPLACE FUNCTION streetgen._mesh_laid(model name, edges bigint[], nodes bigint[])
    RETURNS TABLE(surfaces bytea[], levels integer[], wanted boolean[], raised float8[], lines bytea[],
        kinds integer[], ids bigint[], edge_ids bigint[], node_ids bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    RETURN QUERY WITH own AS MATERIALIZED (
        SELECT * FROM streetgen._mesh_ground(model, edges, nodes, NULL, NULL) WHERE NOT ST_IsEmpty(surface)),
    -- Neighbours tell which vertices they have on common borders.
    member AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY kind, id, part) AS number, g.*, k.raised, k.number AS kind_number
        FROM (SELECT *, true AS wanted FROM own
            UNION ALL SELECT DISTINCT ON (g.kind, g.id) g.*, false
            FROM (SELECT array_agg(ST_Expand(surface, 0.01)) AS boxes, array_agg(level) AS levels FROM own) o,
                streetgen._mesh_ground(model, NULL, NULL, boxes, levels) g
            WHERE NOT ST_IsEmpty(g.surface) AND (g.kind, g.id) NOT IN (SELECT kind, id FROM own)) g
        JOIN streetgen._mesh_kind() k USING (kind))
    SELECT array_agg(surface::bytea ORDER BY number), array_agg(level ORDER BY number),
        array_agg(m.wanted ORDER BY number), array_agg(m.raised ORDER BY number),
        array_agg(line::bytea ORDER BY number), array_agg(kind_number ORDER BY number), array_agg(id ORDER BY number),
        array_agg(CASE WHEN node_id IS NULL THEN edge_id END ORDER BY number), array_agg(node_id ORDER BY number)
    FROM member m;
END $$;
COMMENT ON FUNCTION streetgen._mesh_laid(name, bigint[], bigint[]) IS
    'The surfaces of edges and nodes (wanted) and those beside them as arguments of streetgen._road_mesh, by number '
    'from 1: with their kinds, the ids that these give them, and the edge or the node that each is of.';

CREATE OR REPLACE FUNCTION streetgen._street_mesh(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, node_id bigint, kind text, id bigint, mesh geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    cell record;
BEGIN
    SELECT srid, dimension INTO place FROM streetgen.model m WHERE m.name = model;
    FOR cell IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY SELECT l.edge_ids[t.number], l.node_ids[t.number],
                CASE WHEN t.kerb THEN 'kerb' ELSE k.kind END, l.ids[t.number], t.mesh::geometry
            FROM streetgen._mesh_kind() k, streetgen._mesh_laid(model, cell.edges, cell.nodes) l,
                streetgen._mesh_heights(model, cell.about) a,
                streetgen._road_mesh(l.surfaces, l.levels, l.wanted, l.raised, l.lines, a.axes, a.axis_levels,
                    a.axis_widths, (options ->> 'tolerance')::float8, place.srid) t
            WHERE k.number = l.kinds[t.number];
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._street_mesh(name, jsonb) IS
    'The ground of the streets that options take as triangles: a row for each surface of an edge or a node, by the id '
    'that its kind gives it, and one for its kerbs, each a TIN Z. Neighbours share vertices.';
