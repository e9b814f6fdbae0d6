CREATE OR REPLACE FUNCTION streetgen.summary(model name) RETURNS TABLE(subject text, amount numeric, unit text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_reader(model);
    RETURN QUERY EXECUTE format($sql$
SELECT 'axes', count(*)::numeric, NULL::text FROM %1$I.axis
UNION ALL SELECT 'axes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.axis
UNION ALL SELECT 'nodes', count(*), NULL FROM %1$I.node
UNION ALL SELECT 'edges', count(*), NULL FROM %1$I.edge
UNION ALL (SELECT 'edges with estimated ' || what, count(*), NULL FROM %1$I.edge, unnest(estimated) what GROUP BY what
    ORDER BY what)
UNION ALL (SELECT 'sections, ' || method, count(*), NULL FROM %1$I.section GROUP BY method ORDER BY method)
UNION ALL (SELECT 'intersections, ' || method, count(*), NULL FROM %1$I.intersection GROUP BY method ORDER BY method)
UNION ALL (SELECT 'corners, ' || method, count(*), NULL FROM %1$I.corner GROUP BY method ORDER BY method)
UNION ALL (SELECT 'lanes, ' || kind, count(*), NULL FROM %1$I.lane GROUP BY kind ORDER BY kind)
UNION ALL SELECT 'lanes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.lane
UNION ALL SELECT 'lanes that say where they turn', count(*), NULL FROM %1$I.lane WHERE turn IS NOT NULL
UNION ALL (SELECT 'lanes, ' || method, count(*), NULL FROM %1$I.lane WHERE method <> 'hypothesis' GROUP BY method
    ORDER BY method)
UNION ALL (SELECT 'lane separators, ' || kind, count(*), NULL FROM %1$I.lane_separator GROUP BY kind ORDER BY kind)
UNION ALL (SELECT 'markings, ' || kind, count(*), NULL FROM %1$I.marking GROUP BY kind ORDER BY kind)
UNION ALL SELECT 'roadway',
    round((coalesce((SELECT sum(ST_Area(surface)) FROM %1$I.section), 0) + coalesce((SELECT sum(ST_Area(surface))
    FROM %1$I.intersection), 0))::numeric, 1), 'm2'
UNION ALL SELECT 'contested',
    round((coalesce((SELECT sum(contested_area) FROM %1$I.section), 0) + coalesce((SELECT sum(contested_area)
    FROM %1$I.intersection), 0))::numeric, 1), 'm2'
UNION ALL (SELECT 'interconnections, ' || CASE WHEN plausible THEN 'plausible by ' ELSE 'not plausible by '
    END || reason, count(*), NULL FROM %1$I.interconnection GROUP BY plausible, reason ORDER BY plausible DESC, reason)
UNION ALL (SELECT 'reports, ' || issue, count(*), NULL FROM %1$I.report GROUP BY issue ORDER BY issue)
$sql$, model);
END $$;
COMMENT ON FUNCTION streetgen.summary(name) IS
    'How much there is in a model, and how it came about. An unknown model: 3F000.';
