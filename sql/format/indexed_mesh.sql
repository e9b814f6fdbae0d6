-- Meshes of streets as lists of numbers and texts, which CityJSON and Wavefront write.

CREATE OR REPLACE FUNCTION streetgen._indexed_mesh(surfaces bytea[], levels integer[], wanted boolean[],
    raised float8[], lines bytea[], axes bytea[], axis_levels integer[], axis_widths float8[], tolerance float8,
    x float8, y float8, z float8, digits integer, decimals boolean)
    RETURNS TABLE(places text[], texture text[], normals text[], numbers integer[], kerbs boolean[],
        triangles integer[], corners integer[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1 AS 'MODULE_PATHNAME', 'streetgen_indexed_mesh';
COMMENT ON FUNCTION streetgen._indexed_mesh(bytea[], integer[], boolean[], float8[], bytea[], bytea[], integer[],
    float8[], float8, float8, float8, float8, integer, boolean) IS
    'The meshes that streetgen._road_mesh makes of its arguments as lists, without repetitions: places from an origin '
    'x, y, z, texture coordinates and normals as texts, decimal or in whole steps divided by commas. Meshes are those '
    'of surfaces (numbers from 1), some of their kerbs, with their count of triangles. corners are nine numbers a '
    'triangle: place, texture and normal of each corner, from 1.';

CREATE OR REPLACE FUNCTION streetgen._indexed_blocks(model name, layers text[], options jsonb, x float8, y float8,
    z float8, digits integer, decimals boolean)
    RETURNS TABLE(cell integer, places text[], texture text[], normals text[], triangles integer[], corners integer[],
        materials integer[], ids bigint[], edge_ids bigint[], node_ids bigint[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
DECLARE
    part record;
    names constant text[] := streetgen._mesh_names(model);
    kerb_material constant integer := array_position(names, 'kerb') - 1;
BEGIN
    FOR part IN SELECT * FROM streetgen._mesh_cells(model, options) c ORDER BY c.cell LOOP
        RETURN QUERY SELECT part.cell, i.places, i.texture, i.normals, i.triangles, i.corners, m.materials, m.ids,
                m.edge_ids, m.node_ids
            FROM streetgen._mesh_heights(model, part.about) a,
                streetgen._mesh_laid(model, part.edges, part.nodes, layers, names, options,
                    streetgen._mesh_lift(a.axes, options)) l,
                streetgen._indexed_mesh(l.surfaces, l.levels, l.wanted, l.raised, l.lines, a.axes, a.axis_levels,
                    a.axis_widths, (options ->> 'tolerance')::float8, x, y, z, digits, decimals) i,
                -- A mesh has what its surface has.
                LATERAL (SELECT array_agg(CASE WHEN kerb THEN kerb_material ELSE l.materials[n] END ORDER BY o)
                        AS materials, array_agg(l.ids[n] ORDER BY o) AS ids,
                    array_agg(l.edge_ids[n] ORDER BY o) AS edge_ids, array_agg(l.node_ids[n] ORDER BY o) AS node_ids
                    FROM unnest(i.numbers, i.kerbs) WITH ORDINALITY u(n, kerb, o)) m;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._indexed_blocks(name, text[], jsonb, float8, float8, float8, integer, boolean) IS
    'The streets that options take as lists of streetgen._indexed_mesh, square by square, with material, id, edge and '
    'node of each mesh.';
