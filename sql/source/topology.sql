-- The edges of a PostGIS topology as axes.

CREATE OR REPLACE FUNCTION streetgen._check_topology() RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT EXISTS (SELECT FROM pg_extension WHERE extname = 'postgis_topology') THEN
        RAISE EXCEPTION 'extension postgis_topology is not installed' USING ERRCODE = '0A000',
            HINT = 'CREATE EXTENSION postgis_topology installs it.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_topology() IS 'Raises 0A000 where the extension postgis_topology is missing.';

CREATE OR REPLACE FUNCTION streetgen.import_topology(model name, topology name, level integer DEFAULT 0)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    near text[];
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('topology', topology, 'level', level::text),
        streetgen._check_topology();
    IF NOT EXISTS (SELECT FROM topology.topology t WHERE t.name = import_topology.topology) THEN
        RAISE EXCEPTION 'topology "%" does not exist', topology USING ERRCODE = '3F000',
            HINT = 'SELECT name FROM topology.topology lists them.';
    END IF;
    -- A network is clean already: every vertex stays.
    RETURN QUERY SELECT * FROM streetgen._import(model, format('%I.edge_data', topology), format($sql$
SELECT geom, %s AS level, edge_id::text AS source_ref, edge_id::text AS label, NULL::text AS left_out,
    NULL::text[] AS unread
FROM %I.edge_data$sql$, level, topology), clean => false);
    EXECUTE format('SELECT array_agg(n.node_id::text ORDER BY n.node_id) FROM %1$I.node n WHERE EXISTS (SELECT FROM '
        '%1$I.edge_data e WHERE n.node_id NOT IN (e.start_node, e.end_node) AND ST_DWithin(n.geom, e.geom, $1))',
        topology) INTO near USING streetgen._tolerance(model);
    RETURN QUERY SELECT 'node within the tolerance of an edge that does not end there, generate joins them', NULL::text,
        cardinality(near)::bigint, near WHERE near <> '{}';
END $$;
COMMENT ON FUNCTION streetgen.import_topology(name, name, integer) IS
    'Imports the edges of a PostGIS topology as axes of the given level, uncleaned; generate makes its nodes (a '
    'setting tolerance of 0.001 keeps them all apart). Importing again follows the topology by edge_id. Reports as '
    'import_axes. An unknown topology: 3F000; no postgis_topology: 0A000.';
