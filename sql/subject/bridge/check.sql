-- Rules of check_model for bridges.

CREATE OR REPLACE FUNCTION streetgen._check_bridge(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'notice', 'bridge ends at a node above what it crosses, m', 'bridge', b.bridge_id, d.apart, o.geom
        FROM bridge b JOIN overpass o ON o.edge_above = b.edge_id JOIN edge e ON e.edge_id = b.edge_id
            JOIN edge c ON c.edge_id = o.edge_below, LATERAL (SELECT min(ST_Distance(v.place, c.geom)) AS apart
                FROM (VALUES (0, ST_StartPoint(e.geom)), (ST_Length2D(e.geom), ST_EndPoint(e.geom))) v(at, place)
                WHERE v.at BETWEEN b.start_abscissa AND b.end_abscissa) d
        WHERE b.method = 'overpass' AND d.apart < greatest(c.width, c.width_end) / 2
            AND o.abscissa_above BETWEEN b.start_abscissa AND b.end_abscissa
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_bridge(name) IS
    'The rows of streetgen.check_model for bridges.';

CREATE OR REPLACE FUNCTION streetgen._bridge_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (24, 'bridge', $part$
    (SELECT kind || 's, ' || method, count(*), NULL FROM (SELECT 'bridge' AS kind, method FROM %1$I.bridge
        UNION ALL SELECT 'tunnel', method FROM %1$I.tunnel) b GROUP BY 1 ORDER BY 1)$part$),
    (25, 'bridge', $part$
    (SELECT kind || 's, length', round(sum(length)::numeric, 1), 'm' FROM (
        SELECT 'bridge' AS kind, end_abscissa - start_abscissa AS length FROM %1$I.bridge
        UNION ALL SELECT 'tunnel', end_abscissa - start_abscissa FROM %1$I.tunnel) b GROUP BY kind
        ORDER BY kind)$part$) $$;
COMMENT ON FUNCTION streetgen._bridge_summary() IS 'What streetgen.summary counts of bridges and tunnels.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('bridge ends at a node above what it crosses, m',
        'the edge that passes over ends within the width of the road below',
        'join the pieces of the axis above, or move the node');
