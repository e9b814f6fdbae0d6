-- The roadway of a model as triangles.

CREATE OR REPLACE FUNCTION streetgen._road_mesh(surfaces bytea[], levels integer[], wanted boolean[], raised float8[],
    lines bytea[], axes bytea[], axis_levels integer[], tolerance float8, srid integer)
    RETURNS TABLE(number integer, kerb boolean, mesh bytea, normals real[], texture real[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1000 AS 'MODULE_PATHNAME', 'streetgen_road_mesh';
COMMENT ON FUNCTION streetgen._road_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[], float8,
    integer) IS
    'The mesh (TIN Z as EWKB) of each surface (MULTIPOLYGON, EWKB) that is wanted, by its number from 1, with normals '
    'and texture coordinates of the corners. A surface may be raised, metres: then its kerbs beside lower ones are a '
    'mesh of their own. The others give their vertices on common borders. lines (EWKB): those that texture coordinates '
    'are counted along. axes (EWKB): those that give the heights, of their levels; none: 0.';

CREATE OR REPLACE FUNCTION streetgen._height_query(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT format(CASE WHEN 'height' = ANY (streetgen._subjects(model)) THEN $q$
    SELECT edge_id, level, p.geom FROM %1$I.profile p JOIN %1$I.edge USING (edge_id)
    WHERE p.geom && ST_Expand($3, 200)$q$ ELSE $q$
    SELECT e.edge_id, e.level, ST_SetPoint(ST_SetPoint(e.geom, 0, f.geom), -1, t.geom) AS geom FROM %1$I.edge e
        JOIN %1$I.node f ON f.node_id = e.from_node JOIN %1$I.node t ON t.node_id = e.to_node
    WHERE $4 = 3 AND e.geom && ST_Expand($3, 200)$q$ END, model) $$;
COMMENT ON FUNCTION streetgen._height_query(name) IS
    'The query of the lines that say how high the roadway of a model lies: its profiles where it computes them, else '
    'its axes where it has heights. $3: the extent, $4: the dimension of the model.';

CREATE OR REPLACE FUNCTION streetgen._roadway_query(model name) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT format($q$SELECT edge_id, NULL::bigint AS node_id, s.level, surface, geom AS line
        FROM %1$I.section s JOIN %1$I.edge USING (edge_id)
    UNION ALL SELECT NULL, node_id, level, surface, ST_MakeLine(geom, ST_Translate(geom, 1, 0))
        FROM %1$I.intersection JOIN %1$I.node USING (node_id)$q$, model) $$;
COMMENT ON FUNCTION streetgen._roadway_query(name) IS
    'The query of the surfaces of the roadway of a model, each with the line that its texture coordinates are counted '
    'along: the edge of a section, a line to the east from the node of an intersection.';

CREATE OR REPLACE FUNCTION streetgen.road_mesh(model name, extent geometry DEFAULT NULL,
    tolerance float8 DEFAULT 0.05) RETURNS TABLE(edge_id bigint, node_id bigint, level integer, geom geometry,
    normals real[], texture real[])
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    about geometry;
    ground text;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._check_given('tolerance', tolerance::text),
        streetgen._check_extent(model, extent);
    IF tolerance NOT BETWEEN 0.001 AND 10 THEN
        RAISE EXCEPTION 'tolerance is %, expected 0.001 to 10', tolerance USING ERRCODE = '22023',
            HINT = 'Metres of height; the default is 0.05.';
    END IF;
    SELECT srid, dimension INTO place FROM streetgen.model m WHERE m.name = model;
    extent := ST_SetSRID(extent, place.srid);
    ground := format('(%s) g', streetgen._roadway_query(model));
    -- Neighbours tell which vertices they have on common borders.
    EXECUTE 'SELECT ST_SetSRID(ST_Expand(ST_Extent(surface), 0.01)::geometry, $2) FROM ' || ground ||
        ' WHERE $1 IS NULL OR ST_Intersects(surface, $1)' INTO about USING extent, place.srid;
    RETURN QUERY EXECUTE format($sql$
WITH member AS MATERIALIZED (
    SELECT row_number() OVER (ORDER BY g.edge_id, g.node_id) AS number, g.*,
        $1 IS NULL OR ST_Intersects(surface, $1) AS wanted
    FROM %2$s WHERE surface && $3 AND NOT ST_IsEmpty(surface)),
-- A surface has an axis of its own, and no street is wider than 200 m. Edges have one height where they meet.
height AS MATERIALIZED (%3$s)
SELECT m.edge_id, m.node_id, m.level, t.mesh::geometry, t.normals, t.texture
FROM (SELECT array_agg(surface::bytea ORDER BY number) AS surfaces, array_agg(level ORDER BY number) AS levels,
        array_agg(wanted ORDER BY number) AS wanted, array_agg(0.0::float8) AS raised,
        array_agg(line::bytea ORDER BY number) AS lines FROM member) s,
    (SELECT coalesce(array_agg(geom::bytea ORDER BY edge_id), '{}') AS axes,
        coalesce(array_agg(level ORDER BY edge_id), '{}') AS axis_levels FROM height) h,
    streetgen._road_mesh(surfaces, levels, s.wanted, raised, lines, axes, axis_levels, $2, $5) t
    JOIN member m USING (number)
ORDER BY m.edge_id, m.node_id
$sql$, model, ground, streetgen._height_query(model)) USING extent, tolerance, about, place.dimension, place.srid;
END $$;
COMMENT ON FUNCTION streetgen.road_mesh(name, geometry, float8) IS
    'The roadway of a model, or of what of it meets an extent (geometry in the model''s SRID; NULL: all), as '
    'triangles: a row for each section (edge_id) and each intersection (node_id) whose surface is not empty, with its '
    'level and its mesh, a TIN Z in the SRID of the model. Triangles are counter-clockwise seen from above and tile '
    'the surface. Surfaces of one level meet in the same vertices, also of meshes of different extents. Heights are '
    'those of the nearest profile of the level where the model computes subject height, else of the nearest axis where '
    'it has dimension 3, else 0; edges that meet at a node have '
    'its height there. normals has a unit vector (x, y, z) of each corner of each triangle in the order of the TIN, '
    'nine numbers a triangle: that of the roadway along the nearest axis, level across it, so neighbours agree. '
    'texture has two numbers of each corner, six a triangle: metres along the edge and to its left, on intersections '
    'metres east and north of the node. The mesh leaves the heights of the axes by at most the tolerance, 0.001 to '
    '10 m, and those along borders but where the nearest axis is another one. An extent of another SRID, or with coordinates that are'
    ' not finite, and a bad tolerance: 22023.';
