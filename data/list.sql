-- The models of the database, for data/streetgen list: a query for each, read as one.
SELECT coalesce(string_agg(format($$SELECT %1$L AS model, %2$s AS srid, axes, CASE WHEN axes > 0 THEN format('%%s,%%s,%%s,%%s', floor(ST_XMin(box)), floor(ST_YMin(box)), ceil(ST_XMax(box)), ceil(ST_YMax(box))) END AS extent,
        CASE WHEN axes = 0 THEN 'no axes' WHEN stale = 0 THEN 'fresh' WHEN NOT EXISTS (SELECT FROM %1$I.edge) THEN 'not generated' ELSE stale || ' axes are stale' END AS streets
    FROM (SELECT count(*) AS axes, ST_Extent(geom) AS box FROM %1$I.axis) a, streetgen._stale_axes(%1$L) AS stale$$, name, srid), ' UNION ALL ') || ' ORDER BY model',
    $$SELECT 'none yet: data/streetgen sample makes one, data/streetgen load FILE MODEL SRID another' AS model$$)
FROM streetgen.model WHERE to_regclass(format('%I.axis', name)) IS NOT NULL \gexec
