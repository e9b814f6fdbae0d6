-- Sidewalks of blocks, and what they leave.
CREATE OR REPLACE FUNCTION streetgen._make_sidewalk_block_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE VIEW %1$I.sidewalk_block WITH (security_invoker = true) AS
SELECT s.sidewalk_id, CASE
    -- A kerb that others contest may lie in a block that its edge is not about, or in none.
    WHEN k.method IN ('contested', 'level_change') THEN (SELECT b.block_id FROM %1$I.block b,
        ST_PointOnSurface(s.surface) place WHERE b.surface && place AND ST_Intersects(b.surface, place) LIMIT 1)
    ELSE (SELECT b.block_id FROM %1$I.block_edge b WHERE b.edge_id = s.edge_id
        AND b.side = CASE WHEN s.side IN ('right', 'corner_at_end') THEN 'right' ELSE 'left' END
        -- Past a crossing without a node another block may lie beside the edge.
        ORDER BY abs((b.start_abscissa + b.end_abscissa) / 2 - at.abscissa) - (b.end_abscissa - b.start_abscissa) / 2
        LIMIT 1) END AS block_id
FROM %1$I.sidewalk s JOIN %1$I.edge e USING (edge_id) JOIN %1$I.kerb k USING (edge_id, side, part),
    LATERAL (SELECT ST_Length(e.geom) * CASE WHEN s.side IN ('start', 'corner_at_start') THEN 0
        WHEN s.side IN ('end', 'corner_at_end') THEN 1
        ELSE ST_LineLocatePoint(e.geom, ST_LineInterpolatePoint(k.geom, 0.5)) END AS abscissa) at
WHERE e.level = (SELECT value::integer FROM %1$I.setting WHERE name = 'ground_level');
COMMENT ON VIEW %1$I.sidewalk_block IS 'The block that each sidewalk of the ground lies on';
CREATE OR REPLACE VIEW %1$I.block_interior WITH (security_invoker = true) AS
SELECT b.block_id, ST_Multi(ST_CollectionExtract(coalesce(ST_Difference(b.surface, (SELECT ST_Union(s.surface)
    FROM %1$I.sidewalk s JOIN %1$I.edge e USING (edge_id)
    WHERE s.surface && b.surface AND ST_Intersects(s.surface, b.surface)
        AND e.level = (SELECT value::integer FROM %1$I.setting WHERE name = 'ground_level'))), b.surface), 3))
    ::geometry(MultiPolygon, %2$s) AS geom
FROM %1$I.block b;
COMMENT ON VIEW %1$I.block_interior IS
    'The ground of each block behind its sidewalks, computed when it is asked for'
$sql$, model, (SELECT m.srid FROM streetgen.model m WHERE m.name = model));
END $$;
COMMENT ON FUNCTION streetgen._make_sidewalk_block_view(name) IS
    'Makes the views sidewalk_block and block_interior of a model that computes blocks and sidewalks.';
