-- Bridges and tunnels after a run: they read the overpasses and the sections that the one statement wrote.

CREATE OR REPLACE FUNCTION streetgen._bridge_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (57, 'bridge', 'bridge', 'bridge_id', 'edge_id, start_abscissa', 'bridge', 1),
    (58, 'tunnel', 'bridge', 'tunnel_id', 'edge_id, start_abscissa', 'tunnel', 1) $$;
COMMENT ON FUNCTION streetgen._bridge_computed_table() IS 'The computed tables of bridges and tunnels.';

CREATE OR REPLACE FUNCTION streetgen._heading_at(line geometry, abscissa float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Azimuth(ST_LineInterpolatePoint(line, greatest(0, (abscissa - 0.5) / length)),
        ST_LineInterpolatePoint(line, least(1, (abscissa + 0.5) / length)))
    FROM (SELECT nullif(ST_Length2D(line), 0) AS length) l $$;
COMMENT ON FUNCTION streetgen._heading_at(geometry, float8) IS
    'The direction of a line (radians clockwise from north) over the metre about an abscissa; NULL where it turns '
    'back on itself there.';

CREATE OR REPLACE FUNCTION streetgen._deck_half(width_above float8, width_below float8, angle float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- Three metres beyond the roadway below for what stands beside it. Flatter crossings count as of 12 degrees.
    SELECT ((width_below / 2 + 3) + width_above / 2 * abs(cos(a))) / greatest(abs(sin(a)), 0.2)
    FROM (SELECT coalesce(angle, pi() / 2) AS a) v $$;
COMMENT ON FUNCTION streetgen._deck_half(float8, float8, float8) IS
    'Metres from a crossing to the end of the deck there: of the widths of both roads (m) and the angle between them '
    '(radians; NULL: a right one).';

CREATE OR REPLACE FUNCTION streetgen._stretch_surface(section geometry, line geometry, low float8, high float8,
    width float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_IsEmpty(section) OR low > 0 OR high < length THEN ST_Multi(ST_Buffer(ST_Force2D(
        ST_LineSubstring(line, greatest(0, low / length), least(1, high / length))), width / 2,
        'endcap=flat join=mitre')) ELSE section END
    FROM (SELECT ST_Length2D(line) AS length) l $$;
COMMENT ON FUNCTION streetgen._stretch_surface(geometry, geometry, float8, float8, float8) IS
    'The roadway of an edge between two abscissas of its line (MULTIPOLYGON): of all of it its section, else a strip '
    'of the width. Where it crosses an edge of its level, the ground is in one of the two sections alone.';

CREATE OR REPLACE FUNCTION streetgen._make_bridge_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'bridge' <> ALL (streetgen._subjects(model)) THEN
        PERFORM streetgen._drop_own_functions(model, '{_renew_bridges,_crossing_edges}');
        RETURN;
    END IF;
    CREATE OR REPLACE FUNCTION _crossing_edges(axes bigint[]) RETURNS bigint[]
        LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path FROM CURRENT SET jit = off
        AS $body$
    BEGIN
        RETURN ARRAY(
            WITH own AS MATERIALIZED (SELECT edge_id FROM edge WHERE axis_id = ANY (axes))
            SELECT edge_id FROM own
            UNION SELECT o.edge_above FROM own e JOIN overpass o ON o.edge_below = e.edge_id
            UNION SELECT o.edge_below FROM own e JOIN overpass o ON o.edge_above = e.edge_id);
    END $body$;
    CREATE OR REPLACE FUNCTION _renew_bridges(edges bigint[])
        RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks
            bigint)
        LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 2 SET search_path FROM CURRENT SET jit = off
        AS $body$
    #variable_conflict use_column
    BEGIN
        RETURN QUERY WITH region AS MATERIALIZED (
            SELECT edge_id FROM edge WHERE edges IS NULL UNION ALL SELECT DISTINCT unnest(edges)),
        deck AS (
            SELECT a.edge_id, unnest(range_agg(numrange(greatest(0, o.abscissa_above - h.half)::numeric,
                least(ST_Length2D(a.geom), o.abscissa_above + h.half)::numeric))) AS part
            FROM region r JOIN edge a USING (edge_id) JOIN overpass o ON o.edge_above = a.edge_id
                JOIN edge b ON b.edge_id = o.edge_below, LATERAL (SELECT streetgen._deck_half(
                    greatest(a.width, a.width_end), greatest(b.width, b.width_end),
                    streetgen._heading_at(a.geom, o.abscissa_above) - streetgen._heading_at(b.geom, o.abscissa_below))
                    AS half) h
            WHERE a.level = 0 AND b.level >= 0 GROUP BY a.edge_id),
        stretch AS (
            SELECT CASE WHEN e.level > 0 THEN 'bridge' ELSE 'tunnel' END AS kind, e.edge_id, 0::float8 AS low,
                ST_Length2D(e.geom) AS high, CASE a.source WHEN 'design' THEN 'design' ELSE 'stated' END AS method
            FROM region r JOIN edge e USING (edge_id) JOIN axis a USING (axis_id) WHERE e.level <> 0
            UNION ALL SELECT 'bridge', edge_id, lower(part)::float8, upper(part)::float8, 'overpass' FROM deck
                WHERE upper(part) > lower(part)),
        new AS MATERIALIZED (
            SELECT s.kind, s.edge_id, s.low AS start_abscissa, s.high AS end_abscissa, s.method,
                streetgen._stretch_surface(c.surface, e.geom, s.low, s.high, greatest(e.width, e.width_end)) AS surface
            FROM stretch s JOIN edge e USING (edge_id) JOIN section c USING (edge_id)),
        there AS MATERIALIZED (
            SELECT 'bridge' AS kind, bridge_id AS key, edge_id, start_abscissa, end_abscissa, method, surface
            FROM bridge JOIN region USING (edge_id)
            UNION ALL SELECT 'tunnel', tunnel_id, edge_id, start_abscissa, end_abscissa, method, surface
            FROM tunnel JOIN region USING (edge_id)),
        compared AS MATERIALIZED (
            SELECT n.*, o.edge_id IS NULL AS fresh, (o.end_abscissa, o.method, o.surface::bytea) IS DISTINCT FROM
                (n.end_abscissa, n.method, n.surface::bytea) AS changed
            FROM new n LEFT JOIN there o USING (kind, edge_id, start_abscissa)),
        gone AS MATERIALIZED (
            SELECT o.kind, o.key FROM there o WHERE NOT EXISTS (SELECT FROM new n
                WHERE (n.kind, n.edge_id, n.start_abscissa) = (o.kind, o.edge_id, o.start_abscissa))),
        no_bridge AS (DELETE FROM bridge b USING gone g WHERE g.kind = 'bridge' AND b.bridge_id = g.key),
        no_tunnel AS (DELETE FROM tunnel t USING gone g WHERE g.kind = 'tunnel' AND t.tunnel_id = g.key),
        put_bridge AS (
            INSERT INTO bridge (edge_id, start_abscissa, end_abscissa, surface, method)
            SELECT edge_id, start_abscissa, end_abscissa, surface, method FROM compared
            WHERE changed AND kind = 'bridge' ORDER BY edge_id, start_abscissa
            ON CONFLICT (edge_id, start_abscissa) DO UPDATE SET (end_abscissa, surface, method)
                = ROW (excluded.end_abscissa, excluded.surface, excluded.method)),
        put_tunnel AS (
            INSERT INTO tunnel (edge_id, start_abscissa, end_abscissa, surface, method)
            SELECT edge_id, start_abscissa, end_abscissa, surface, method FROM compared
            WHERE changed AND kind = 'tunnel' ORDER BY edge_id, start_abscissa
            ON CONFLICT (edge_id, start_abscissa) DO UPDATE SET (end_abscissa, surface, method)
                = ROW (excluded.end_abscissa, excluded.surface, excluded.method))
        SELECT k, count(*) FILTER (WHERE c.fresh), count(*) FILTER (WHERE c.changed AND NOT c.fresh),
            (SELECT count(*) FROM gone g WHERE g.kind = k), count(*) FILTER (WHERE NOT c.changed), 0::bigint
        FROM unnest('{bridge,tunnel}'::text[]) k LEFT JOIN compared c ON c.kind = k GROUP BY k ORDER BY k;
    END $body$;
    PERFORM streetgen._own_function(model, '_crossing_edges(bigint[])',
        'The edges of axes, and those that cross them without a node'),
        streetgen._own_function(model, '_renew_bridges(bigint[])',
        'Brings the bridges and tunnels of edges (NULL: of all) up to date with the rows of the model; a row per '
        'table');
END $$;
COMMENT ON FUNCTION streetgen._make_bridge_functions(name) IS
    'Makes the functions of a model that bring its bridges and tunnels up to date, or drops them where it computes '
    'none.';

CREATE OR REPLACE FUNCTION streetgen._note_bridge(model name, axes bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    edges bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NOT NULL THEN
        SELECT _crossing_edges(axes) INTO edges;
    END IF;
    RETURN edges;
END $$;
COMMENT ON FUNCTION streetgen._note_bridge(name, bigint[]) IS
    'The edges whose bridges a run for axes may change, as the model is now.';

CREATE OR REPLACE FUNCTION streetgen._update_bridge(model name, axes bigint[], moved streetgen.moved_row[],
    noted bigint[])
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 2 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT * FROM _renew_bridges(CASE WHEN axes IS NOT NULL
        THEN noted || streetgen._note_bridge(model, axes) END);
END $$;
COMMENT ON FUNCTION streetgen._update_bridge(name, bigint[], streetgen.moved_row[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings bridges and tunnels up to date; noted: the '
    'edges at the axes before.';
