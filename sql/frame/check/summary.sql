CREATE OR REPLACE FUNCTION streetgen._summary_part() RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'network', $part$
    SELECT 'axes', count(*)::numeric, NULL::text FROM %1$I.axis$part$),
    (2, 'network', $part$
    SELECT 'axes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.axis$part$),
    (3, 'network', $part$
    SELECT 'nodes', count(*), NULL FROM %1$I.node$part$),
    (4, 'network', $part$
    SELECT 'edges', count(*), NULL FROM %1$I.edge$part$),
    (5, 'network', $part$
    (SELECT 'edges with estimated ' || what, count(*), NULL FROM %1$I.edge, unnest(estimated) what
        GROUP BY what ORDER BY what)$part$),
    (6, 'surface', $part$
    (SELECT 'sections, ' || method, count(*), NULL FROM %1$I.section GROUP BY method ORDER BY method)$part$),
    (7, 'surface', $part$
    (SELECT 'intersections, ' || method, count(*), NULL FROM %1$I.intersection GROUP BY method ORDER BY method)$part$),
    (8, 'surface', $part$
    (SELECT 'corners, ' || method, count(*), NULL FROM %1$I.corner GROUP BY method ORDER BY method)$part$),
    (9, 'lane', $part$
    (SELECT 'lanes, ' || kind, count(*), NULL FROM %1$I.lane GROUP BY kind ORDER BY kind)$part$),
    (10, 'lane', $part$
    SELECT 'lanes, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.lane$part$),
    (11, 'lane', $part$
    SELECT 'lanes that say where they turn', count(*), NULL FROM %1$I.lane WHERE turn IS NOT NULL$part$),
    (12, 'lane', $part$
    (SELECT 'lanes, ' || method, count(*), NULL FROM %1$I.lane WHERE method <> 'hypothesis' GROUP BY method
        ORDER BY method)$part$),
    (13, 'lane', $part$
    (SELECT 'lane separators, ' || kind, count(*), NULL FROM %1$I.lane_separator GROUP BY kind ORDER BY kind)$part$),
    (14, 'lane', $part$
    (SELECT 'markings, ' || kind, count(*), NULL FROM %1$I.marking GROUP BY kind ORDER BY kind)$part$),
    (15, 'surface', $part$
    SELECT 'roadway', round((coalesce((SELECT sum(ST_Area(surface)) FROM %1$I.section), 0)
    + coalesce((SELECT sum(ST_Area(surface)) FROM %1$I.intersection), 0))::numeric, 1), 'm2'$part$),
    (16, 'surface', $part$
    SELECT 'contested', round((coalesce((SELECT sum(contested_area) FROM %1$I.section), 0)
    + coalesce((SELECT sum(contested_area) FROM %1$I.intersection), 0))::numeric, 1), 'm2'$part$),
    (17, 'interconnection', $part$
    (SELECT 'interconnections, ' || CASE WHEN plausible THEN 'plausible by ' ELSE 'not plausible by ' END || reason,
    count(*), NULL FROM %1$I.interconnection GROUP BY plausible, reason ORDER BY plausible DESC, reason)$part$),
    (18, 'kerb', $part$
    SELECT 'kerbs, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km' FROM %1$I.kerb$part$),
    (20, 'block', $part$
    (SELECT 'blocks, ' || kind, count(*), NULL FROM %1$I.block GROUP BY kind ORDER BY kind)$part$),
    (21, 'block', $part$
    SELECT 'blocks, ground', round((coalesce(sum(ST_Area(surface)), 0) / 1e6)::numeric, 6), 'km2'
        FROM %1$I.block$part$),
    (22, 'block', $part$
    (SELECT 'blocks, ' || method, count(*), NULL FROM %1$I.block WHERE method <> 'hypothesis' GROUP BY method
        ORDER BY method)$part$),
    (30, 'alignment', $part$
    (SELECT 'roads' || CASE WHEN closed THEN ', closed' ELSE '' END, count(*), NULL FROM %1$I.road GROUP BY closed
    ORDER BY closed)$part$),
    (31, 'alignment', $part$
    SELECT 'roads, length', round((coalesce(sum(length), 0) / 1000)::numeric, 3), 'km' FROM %1$I.road$part$),
    (35, 'sidewalk', $part$
    SELECT 'sidewalks', round(coalesce(sum(ST_Area(surface)), 0)::numeric, 1), 'm2' FROM %1$I.sidewalk$part$),
    (19, 'overpass', $part$
    (SELECT 'overpasses by ' || method, count(*), NULL FROM %1$I.overpass GROUP BY method ORDER BY method)$part$),
    (24, 'bridge', $part$
    (SELECT kind || 's, ' || method, count(*), NULL FROM (SELECT 'bridge' AS kind, method FROM %1$I.bridge
        UNION ALL SELECT 'tunnel', method FROM %1$I.tunnel) b GROUP BY 1 ORDER BY 1)$part$),
    (25, 'bridge', $part$
    (SELECT kind || 's, length', round(sum(length)::numeric, 1), 'm' FROM (
        SELECT 'bridge' AS kind, end_abscissa - start_abscissa AS length FROM %1$I.bridge
        UNION ALL SELECT 'tunnel', end_abscissa - start_abscissa FROM %1$I.tunnel) b GROUP BY kind
        ORDER BY kind)$part$),
    (30, 'roundabout', $part$
    (SELECT 'roundabouts, ' || CASE WHEN accepted THEN kind ELSE 'not accepted' END, count(*), NULL FROM %1$I.roundabout
        GROUP BY 1 ORDER BY 1)$part$),
    (23, 'height', $part$
    (SELECT 'profiles, ' || method, count(*), NULL FROM %1$I.profile GROUP BY method ORDER BY method)$part$),
    (70, 'object', $part$
    (SELECT 'objects, ' || type, count(*), NULL FROM %1$I.street_object GROUP BY type ORDER BY type)$part$),
    (71, 'object', $part$
    (SELECT 'objects, ' || method, count(*), NULL FROM %1$I.street_object GROUP BY method ORDER BY method)$part$),
    (40, 'junction', $part$
    (SELECT 'junctions, ' || kind, count(*), NULL FROM %1$I.junction GROUP BY kind ORDER BY kind)$part$),
    (41, 'junction', $part$
    SELECT 'junctions of several nodes', count(*), NULL FROM %1$I.junction WHERE method = 'grouped'$part$),
    (42, 'junction', $part$
    (SELECT 'edges in junctions, ' || role, count(*), NULL FROM %1$I.junction_edge GROUP BY role ORDER BY role)$part$),
    (43, 'junction', $part$
    SELECT 'paths across junctions, plausible', count(*), NULL FROM %1$I.junction_movement WHERE plausible$part$),
    (45, 'ramp', $part$
    (SELECT 'ramps, ' || kind, count(*), NULL FROM %1$I.ramp GROUP BY kind ORDER BY kind)$part$),
    (44, 'signal', $part$
    (SELECT 'controllers, ' || method, count(*), NULL FROM %1$I.controller GROUP BY method ORDER BY method)$part$),
    (99, 'network', $part$
    (SELECT 'reports, ' || issue, count(*), NULL FROM %1$I.report GROUP BY issue ORDER BY issue)$part$) $$;
COMMENT ON FUNCTION streetgen._summary_part() IS
    'What streetgen.summary counts, query by query, over a model %1$I: the first of a row names a thing, then come its '
    'amount and unit. subject: the query stands only in models that compute it.';

CREATE OR REPLACE FUNCTION streetgen.summary(model name) RETURNS TABLE(subject text, amount numeric, unit text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_reader(model);
    RETURN QUERY EXECUTE (SELECT format(string_agg(query, E'\nUNION ALL ' ORDER BY place), model)
        FROM (SELECT p.place, p.query FROM streetgen._summary_part() p
                WHERE p.subject = ANY (streetgen._subjects(model))
            UNION ALL SELECT 1000, streetgen._design_summary() WHERE streetgen._has_design(model)) p);
END $$;
COMMENT ON FUNCTION streetgen.summary(name) IS
    'How much there is in a model, and how it came about. An unknown model: 3F000.';
