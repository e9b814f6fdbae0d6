-- What the writers of formats in three dimensions share: the surfaces of a model as triangles, part by part.

CREATE OR REPLACE FUNCTION streetgen._mesh_kind()
    RETURNS TABLE(number integer, kind text, raised float8, color float8[], roughness float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    (0, 'section', 0::float8, '{0.13,0.13,0.14}'::float8[], 0.9::float8),
    (1, 'intersection', 0, '{0.16,0.16,0.17}', 0.9),
    (2, 'sidewalk', 0.15, '{0.45,0.43,0.40}', 0.8),
    (3, 'kerb', NULL, '{0.60,0.60,0.58}', 0.7),
    (4, 'marking', 0.005, '{0.85,0.85,0.82}', 0.5) $$;
COMMENT ON FUNCTION streetgen._mesh_kind() IS
    'The kinds of what a mesh of streets consists of: number from 0, what it is raised above the roadway, metres (of '
    'paint, beyond twice the tolerance), its colour (linear red, green and blue, 0 to 1) and its roughness. A kerb '
    'closes the step between a sidewalk and the roadway.';

CREATE OR REPLACE FUNCTION streetgen._mesh_surfaces(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format($q$
ground AS NOT MATERIALIZED (
    SELECT CASE WHEN node_id IS NULL THEN 'section' ELSE 'intersection' END AS kind,
        CASE WHEN node_id IS NULL THEN 2 * edge_id ELSE 2 * node_id + 1 END AS id, 0 AS part,
        edge_id, node_id, level, surface, line
    FROM (%2$s) r
    UNION ALL %3$s),
paint AS NOT MATERIALIZED (%4$s)$q$, model, streetgen._roadway_query(model),
        format(CASE WHEN 'sidewalk' = ANY (subjects) THEN 'SELECT ''sidewalk'', sidewalk_id, part, edge_id, '
                's.node_id, k.level, s.surface, e.geom FROM %1$I.sidewalk s JOIN %1$I.edge e USING (edge_id) '
                'JOIN %1$I.kerb k USING (edge_id, side, part)'
            ELSE 'SELECT NULL, 0, 0, NULL, NULL, 0, NULL, NULL WHERE false' END, model),
        format(CASE WHEN 'lane' = ANY (subjects) THEN 'SELECT 2 * lane_separator_id AS id, edge_id, level, s.surface, '
                'e.geom AS line FROM %1$I.lane_separator s JOIN %1$I.edge e USING (edge_id) UNION ALL '
                'SELECT 2 * marking_id + 1, edge_id, level, m.surface, e.geom '
                'FROM %1$I.marking m JOIN %1$I.edge e USING (edge_id)'
            ELSE 'SELECT 0::bigint AS id, 0::bigint AS edge_id, 0 AS level, NULL::geometry AS surface, '
                'NULL::geometry AS line WHERE false' END, model))
    FROM streetgen._subjects(model) subjects $$;
COMMENT ON FUNCTION streetgen._mesh_surfaces(name) IS
    'Queries of the surfaces of a model that are written in three dimensions: ground, the roadway and the sidewalks, '
    'each of a node or, without one, of an edge; paint, lines between lanes and markings. line is what texture is '
    'counted along.';

CREATE OR REPLACE FUNCTION streetgen._mesh_cells(model name, options jsonb)
    RETURNS TABLE(cell integer, edges bigint[], nodes bigint[], about geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._export_query(model, options, $sql$,
member AS (
    SELECT edge_id, NULL::bigint AS node_id, ST_StartPoint(geom) AS place, geom FROM written_edge
    UNION ALL SELECT NULL, node_id, geom, geom FROM %1$I.node
    WHERE node_id IN (SELECT from_node FROM written_edge UNION SELECT to_node FROM written_edge))
SELECT row_number() OVER (ORDER BY x, y)::integer, coalesce(array_agg(edge_id ORDER BY edge_id)
        FILTER (WHERE edge_id IS NOT NULL), '{}'), coalesce(array_agg(node_id ORDER BY node_id)
        FILTER (WHERE node_id IS NOT NULL), '{}'), ST_SetSRID(ST_Extent(geom)::geometry, ST_SRID(min(place)))
FROM member, LATERAL (SELECT floor(ST_X(place) / 500) AS x, floor(ST_Y(place) / 500) AS y) c
GROUP BY x, y ORDER BY x, y$sql$) USING options;
END $$;
COMMENT ON FUNCTION streetgen._mesh_cells(name, jsonb) IS
    'The edges that options take, with their nodes, by squares of 500 m: what is meshed at once. about is the box of '
    'their lines.';

CREATE OR REPLACE FUNCTION streetgen._mesh_input(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT 'WITH ' || streetgen._mesh_surfaces(model) || format($q$,
own AS MATERIALIZED (
    SELECT * FROM ground WHERE edge_id = ANY ($1) AND node_id IS NULL AND NOT ST_IsEmpty(surface)
    UNION ALL SELECT * FROM ground WHERE node_id = ANY ($2) AND NOT ST_IsEmpty(surface)),
-- Neighbours tell which vertices they have on common borders.
member AS MATERIALIZED (
    SELECT row_number() OVER (ORDER BY kind, id, part) AS number, g.*, raised, k.number AS kind_number
    FROM (SELECT *, true AS wanted FROM own
        UNION ALL SELECT DISTINCT ON (g.kind, g.id) g.*, false FROM own o, LATERAL (
            SELECT * FROM ground WHERE surface && ST_Expand(o.surface, 0.01) AND level = o.level OFFSET 0) g
        WHERE NOT ST_IsEmpty(g.surface) AND (g.kind, g.id) NOT IN (SELECT kind, id FROM own)) g
    JOIN streetgen._mesh_kind() k USING (kind)),
height AS MATERIALIZED (%s),
axes AS (SELECT coalesce(array_agg(geom::bytea ORDER BY edge_id), '{}') AS axes,
    coalesce(array_agg(level ORDER BY edge_id), '{}') AS axis_levels FROM height),
laid AS (SELECT array_agg(surface::bytea ORDER BY number) AS surfaces, array_agg(level ORDER BY number) AS levels,
    array_agg(wanted ORDER BY number) AS wanted, array_agg(raised ORDER BY number) AS raised,
    array_agg(line::bytea ORDER BY number) AS lines, array_agg(kind_number ORDER BY number) AS kinds FROM member)$q$,
    streetgen._height_query(model)) $$;
COMMENT ON FUNCTION streetgen._mesh_input(name) IS
    'Queries that mesh the streets of a cell begin with: member, its surfaces (wanted) and those beside them; laid and '
    'axes, the arguments of streetgen._road_mesh. $1: the edges, $2: the nodes, $3: the box of their lines, $4: the '
    'dimension of the model.';

CREATE OR REPLACE FUNCTION streetgen._street_mesh(model name, options jsonb)
    RETURNS TABLE(edge_id bigint, node_id bigint, kind text, id bigint, mesh geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    cell record;
    query constant text := streetgen._mesh_input(model) || $q$
SELECT CASE WHEN m.node_id IS NULL THEN m.edge_id END, m.node_id, CASE WHEN t.kerb THEN 'kerb' ELSE kind END,
    id, t.mesh::geometry
FROM laid l, axes a, streetgen._road_mesh(surfaces, levels, l.wanted, l.raised, lines, axes, axis_levels, $5, $6) t
    JOIN member m USING (number)$q$;
BEGIN
    SELECT srid, dimension INTO place FROM streetgen.model m WHERE m.name = model;
    FOR cell IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY EXECUTE query
            USING cell.edges, cell.nodes, cell.about, place.dimension, (options ->> 'tolerance')::float8, place.srid;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._street_mesh(name, jsonb) IS
    'The ground of the streets that options take as triangles: a row for each surface of an edge or a node, by the id '
    'that its kind gives it, and one for its kerbs, each a TIN Z. Neighbours share vertices.';
