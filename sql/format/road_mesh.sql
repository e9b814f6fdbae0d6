-- The roadway of a model as triangles.

CREATE OR REPLACE FUNCTION streetgen._road_mesh(surfaces bytea[], levels integer[], wanted boolean[], raised float8[],
    lines bytea[], axes bytea[], axis_levels integer[], axis_widths float8[], tolerance float8, srid integer)
    RETURNS TABLE(number integer, kerb boolean, mesh bytea, normals real[], texture real[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1000 AS 'MODULE_PATHNAME', 'streetgen_road_mesh';
COMMENT ON FUNCTION streetgen._road_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[], float8[],
    float8, integer) IS
    'The mesh (TIN Z as EWKB) of each surface (MULTIPOLYGON, EWKB) that is wanted, by its number from 1, with normals '
    'and texture coordinates of the corners. A surface may be raised, metres: then its kerbs beside lower ones are a '
    'mesh of their own. The others give their vertices on common borders. lines (EWKB): those that texture coordinates '
    'are counted along. axes (EWKB): those that give the heights, of their levels, in roadways so wide (m); '
    'none: 0.';

CREATE OR REPLACE FUNCTION streetgen._height_axes(model name, edges bigint[], lines geometry[])
    RETURNS TABLE(axes bytea[], axis_levels integer[], axis_widths float8[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
        WITH known AS MATERIALIZED (
            SELECT edge_id, line, e.level, greatest(e.width, e.width_end) + 2 * abs(e.roadway_offset) AS width,
                from_node, to_node
            FROM unnest(edges, lines) g(edge_id, line) JOIN edge e USING (edge_id)),
        -- Within an intersection of another level an arm says how high that one lies: both meet at its limit.
        arm AS (
            SELECT edge_id, i.level, k.width, share, CASE which WHEN 'start' THEN ST_LineSubstring(line, 0, share)
                ELSE ST_LineSubstring(line, share, 1) END AS line
            FROM known k JOIN section_limit l USING (edge_id) JOIN intersection i ON i.level <> k.level
                    AND i.node_id = CASE which WHEN 'start' THEN from_node ELSE to_node END,
                LATERAL (SELECT abscissa / ST_Length2D(line) AS share, 0.01 / ST_Length2D(line) AS least) s
            WHERE share BETWEEN least AND 1 - least)
        SELECT coalesce(array_agg(a.line::bytea ORDER BY edge_id, a.level, a.place), '{}'),
            coalesce(array_agg(a.level ORDER BY edge_id, a.level, a.place), '{}'),
            coalesce(array_agg(a.width ORDER BY edge_id, a.level, a.place), '{}')
        FROM (SELECT edge_id, level, width, 0::float8 AS place, line FROM known
            UNION ALL SELECT edge_id, level, width, share, line FROM arm) a;
END $$;
COMMENT ON FUNCTION streetgen._height_axes(name, bigint[], geometry[]) IS
    'Lines of edges (LINESTRING Z) as arguments of streetgen._road_mesh, with the parts of them that lie in '
    'intersections of other levels, which say the height there.';

CREATE OR REPLACE FUNCTION streetgen._mesh_heights(model name, about geometry)
    RETURNS TABLE(axes bytea[], axis_levels integer[], axis_widths float8[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A surface has an axis of its own, and no street is wider than 200 m. Edges have one height where they meet.
    IF 'height' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT h.* FROM (SELECT array_agg(p.edge_id ORDER BY p.edge_id) AS edges,
                    array_agg(p.geom ORDER BY p.edge_id) AS lines
                FROM profile p WHERE p.geom && ST_Expand(about, 200)) p,
            streetgen._height_axes(model, p.edges, p.lines) h;
    ELSE
        RETURN QUERY SELECT h.* FROM (SELECT array_agg(e.edge_id ORDER BY e.edge_id) AS edges, array_agg(ST_SetPoint(
                    ST_SetPoint(e.geom, 0, f.geom), -1, t.geom) ORDER BY e.edge_id) AS lines
                FROM edge e JOIN node f ON f.node_id = e.from_node JOIN node t ON t.node_id = e.to_node
                WHERE (SELECT m.dimension = 3 FROM streetgen.model m WHERE m.name = model)
                    AND e.geom && ST_Expand(about, 200)) p,
            streetgen._height_axes(model, p.edges, p.lines) h;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._mesh_heights(name, geometry) IS
    'The lines that say how high the roadway of a model lies about an extent, as arguments of streetgen._road_mesh: '
    'its profiles where it computes them, else its axes where it has heights.';

CREATE OR REPLACE FUNCTION streetgen.road_mesh(model name, extent geometry DEFAULT NULL,
    tolerance float8 DEFAULT 0.05) RETURNS TABLE(edge_id bigint, node_id bigint, level integer, geom geometry,
    normals real[], texture real[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    SET plan_cache_mode = force_custom_plan
    AS $$
#variable_conflict use_column
DECLARE
    model_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    about geometry;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('tolerance', tolerance::text),
        streetgen._check_extent(model, extent);
    IF tolerance NOT BETWEEN 0.001 AND 10 THEN
        RAISE EXCEPTION 'tolerance is %, expected 0.001 to 10', tolerance USING ERRCODE = '22023',
            HINT = 'Metres of height; the default is 0.05.';
    END IF;
    -- Faces have no plan: their box stands for them.
    extent := ST_SetSRID(CASE WHEN ST_IsEmpty(extent) OR ST_GeometryType(extent) IN ('ST_Triangle', 'ST_Tin',
        'ST_PolyhedralSurface') THEN ST_Envelope(extent) ELSE ST_MakeValid(ST_CurveToLine(ST_Force2D(extent))) END,
        model_srid);
    -- Neighbours tell which vertices they have on common borders.
    SELECT ST_SetSRID(ST_Expand(ST_Extent(surface), 0.01)::geometry, model_srid) INTO about
        FROM (SELECT surface FROM section UNION ALL SELECT surface FROM intersection) g
        WHERE extent IS NULL OR ST_Intersects(surface, extent);
    RETURN QUERY WITH member AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY g.edge_id, g.node_id) AS number, g.*,
            extent IS NULL OR ST_Intersects(surface, extent) AS wanted
        FROM (SELECT edge_id, NULL::bigint AS node_id, s.level, surface, geom AS line
            FROM section s JOIN edge USING (edge_id)
            UNION ALL SELECT NULL, node_id, level, surface, ST_MakeLine(geom, ST_Translate(geom, 1, 0))
            FROM intersection JOIN node USING (node_id)) g
        WHERE surface && about AND NOT ST_IsEmpty(surface))
    SELECT m.edge_id, m.node_id, m.level, t.mesh::geometry, t.normals, t.texture
    FROM (SELECT array_agg(surface::bytea ORDER BY number) AS surfaces, array_agg(level ORDER BY number) AS levels,
            array_agg(wanted ORDER BY number) AS wanted, array_agg(0.0::float8) AS raised,
            array_agg(line::bytea ORDER BY number) AS lines FROM member) s, streetgen._mesh_heights(model, about) h,
        streetgen._road_mesh(surfaces, levels, s.wanted, raised, lines, axes, axis_levels, axis_widths, tolerance,
            model_srid) t
        JOIN member m USING (number)
    ORDER BY m.edge_id, m.node_id;
END $$;
COMMENT ON FUNCTION streetgen.road_mesh(name, geometry, float8) IS
    'The roadway of a model, or of what of it meets an extent (geometry in the model''s SRID; NULL: all), as '
    'triangles: a row for each section (edge_id) and each intersection (node_id) whose surface is not empty, with its '
    'level and its mesh, a TIN Z in the SRID of the model. Triangles are counter-clockwise seen from above and tile '
    'the surface. Surfaces of one level meet in the same vertices, also of meshes of different extents. Heights are '
    'those of profiles of the level where the model computes subject height, else of axes where it has dimension 3, '
    'else 0: of the road in whose roadway a place lies, of several the nearest one; edges that meet at a node have '
    'its height there. normals has a unit vector (x, y, z) of each corner of each triangle in the order of the TIN, '
    'nine numbers a triangle: that of the roadway along the nearest axis, level across it, so neighbours agree. '
    'texture has two numbers of each corner, six a triangle: metres along the edge and to its left, on intersections '
    'metres east and north of the node. The mesh leaves the heights of the axes by at most the tolerance, 0.001 to '
    '10 m, and those along borders but where the nearest axis is another one. An extent of another SRID, or with '
    'coordinates that are'
    ' not finite, and a bad tolerance: 22023.';
