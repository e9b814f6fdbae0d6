-- What a model of a virtual city must hold: what check_model finds beyond notices, axes that cross without a node, square metres
-- of surface on the ground that lie twice for each metre of their borders, holes of a square millimetre to a square metre, metres of axis off the surfaces, and
-- pieces of the network.
CREATE FUNCTION test.city(model name, OUT axes bigint, OUT broken text, OUT crossings bigint, OUT overlap float8, OUT slits bigint, OUT outside float8, OUT pieces bigint) LANGUAGE plpgsql AS $$
BEGIN
    SELECT string_agg(DISTINCT rule, ', ') FILTER (WHERE severity <> 'notice'), count(*) FILTER (WHERE rule = 'crossing') INTO broken, crossings FROM streetgen.check_model(model);
    EXECUTE format($sql$
WITH surface AS MATERIALIZED (SELECT surface FROM %1$I.section JOIN %1$I.edge e USING (edge_id) WHERE e.level = 0 UNION ALL SELECT surface FROM %1$I.intersection),
ground AS MATERIALIZED (SELECT ST_UnaryUnion(ST_Collect(surface)) AS geom FROM surface)
SELECT (SELECT count(*) FROM %1$I.axis), (SELECT sum(ST_Area(surface)) / sum(ST_Perimeter(surface)) FROM surface) - ST_Area(geom) / (SELECT sum(ST_Perimeter(surface)) FROM surface),
       (SELECT count(*) FROM ST_Dump(ST_CollectionExtract(geom, 3)) part, ST_DumpRings(part.geom) ring WHERE ring.path[1] > 0 AND ST_Area(ring.geom) BETWEEN 1e-6 AND 1),
       (SELECT ST_Length(ST_Difference(ST_Collect(a.geom), ST_Buffer(g.geom, 1e-6))) FROM %1$I.axis a, ground g WHERE a.level = 0 GROUP BY g.geom),
       (SELECT cardinality(ST_ClusterIntersecting(a.geom)) FROM %1$I.axis a) FROM ground $sql$, model) INTO axes, overlap, slits, outside, pieces;
END $$;
