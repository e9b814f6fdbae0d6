-- Chains: rows that are functions of something longer than the reach. Each chain that a run touches is locked by a key.

CREATE OR REPLACE FUNCTION streetgen._chain() RETURNS TABLE(relation name, touched text, at_end boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $f$ VALUES
    ('block'::name, 'SELECT axis_id, block_id AS chain FROM {model}._touched_blocks(axes)', false),
    -- All that is off the ground is one chain: few edits touch it, and what is lifted has no end that is known before.
    ('profile', $q$
        SELECT e.axis_id, 0::bigint AS chain FROM {model}.edge e JOIN {model}.profile p USING (edge_id)
            WHERE e.axis_id = ANY (axes) AND p.method <> 'ground'
        UNION SELECT e.axis_id, 0 FROM {model}.edge e JOIN {model}.overpass o ON o.edge_above = e.edge_id
            WHERE e.axis_id = ANY (axes)
        UNION SELECT e.axis_id, 0 FROM {model}.edge e JOIN {model}.overpass o ON o.edge_below = e.edge_id
            WHERE e.axis_id = ANY (axes)
        UNION SELECT axis_id, 0 FROM {model}.height_override WHERE axis_id = ANY (axes)
        UNION SELECT a.axis_id, 0 FROM {model}.axis a JOIN {model}.axis b ON ST_Crosses(a.geom, b.geom)
            WHERE a.axis_id = ANY (axes) AND a.level <> b.level$q$, true),
    ('road'::name, $q$
        SELECT a.axis_id, r.road_id AS chain FROM {model}.edge a, LATERAL (
            SELECT edge_id FROM {model}.edge e WHERE e.from_node IN (a.from_node, a.to_node)
            UNION ALL SELECT edge_id FROM {model}.edge e WHERE e.to_node IN (a.from_node, a.to_node) OFFSET 0) e,
            LATERAL (SELECT road_id FROM {model}.road_edge r WHERE r.edge_id = e.edge_id OFFSET 0) r
        WHERE a.axis_id = ANY (axes)$q$, true),
    ('junction'::name, $q$
        SELECT a.axis_id, j.junction_id AS chain FROM {model}.edge a, LATERAL (
            SELECT junction_id FROM {model}.junction_node j
            WHERE j.node_id IN (a.from_node, a.to_node) OFFSET 0) j
        WHERE a.axis_id = ANY (axes)$q$, false) $f$;
COMMENT ON FUNCTION streetgen._chain() IS
    'The kinds of chains. relation: the computed table that has a row for each chain. touched: a query of axis_id and '
    'chain, the id of each chain that a run may change, split, join or take away when it writes rows of that axis; '
    '{model} is the schema, axes an array of the axes. The query sees a model before the run. So it names each chain '
    'at the edges of the axes, at the nodes of these edges, and at the place of an axis that has no edge yet. A chain '
    'after the run is then made of new rows and of pieces of the chains named. at_end: a first run by clusters leaves '
    'the table to its end, since its part of the one statement reads nothing but new_node, new_edge, setting, '
    'found_overpass and tables in a run for all of a model.';

CREATE OR REPLACE FUNCTION streetgen._chain_key(relation name, chain bigint) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    BEGIN ATOMIC SELECT 4096 + (hashtextextended(relation::text, chain) & 1073741823)::integer; END;
COMMENT ON FUNCTION streetgen._chain_key(name, bigint) IS
    'The key (4096 to 1073745919) that locks a chain, by the table and the id of its row.';

CREATE OR REPLACE FUNCTION streetgen._all_chains() RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT 4095; END;
COMMENT ON FUNCTION streetgen._all_chains() IS
    'The key of all chains of a model: whoever locks single chains shares it, whoever locks too many holds it alone.';

CREATE OR REPLACE FUNCTION streetgen._has_chains(model name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT EXISTS (SELECT FROM streetgen._chain() c
        WHERE c.relation = ANY (streetgen._computed_tables(model))) $$;
COMMENT ON FUNCTION streetgen._has_chains(name) IS 'Does a model compute rows that are functions of whole chains?';

CREATE OR REPLACE FUNCTION streetgen._subjects_at_end() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(DISTINCT t.subject) FROM streetgen._chain() c
        JOIN streetgen._computed_table() t USING (relation) WHERE c.at_end $$;
COMMENT ON FUNCTION streetgen._subjects_at_end() IS
    'The subjects whose tables a first run by clusters leaves to its end.';

CREATE OR REPLACE FUNCTION streetgen._make_chain_keys(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE OR REPLACE FUNCTION %1$I._chain_keys(axes bigint[]) RETURNS TABLE(axis_id bigint, key integer)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path FROM CURRENT SET jit = off
    SET plan_cache_mode = force_generic_plan
    AS $body$
#variable_conflict use_column
BEGIN
    RETURN QUERY %2$s;
END $body$ $sql$, model, (SELECT coalesce(string_agg(format('SELECT t.axis_id, streetgen._chain_key(%L, t.chain)
        FROM (%s) t', c.relation, streetgen._fill_template(c.touched, jsonb_build_object('model', quote_ident(model)))),
        ' UNION ALL '), 'SELECT 0::bigint, 0 WHERE false')
    FROM streetgen._chain() c WHERE c.relation = ANY (streetgen._computed_tables(model))));
    PERFORM streetgen._own_function(model, '_chain_keys(bigint[])',
        'The keys of all chains that a run for the axes may change, beside the axis that touches each');
END $$;
COMMENT ON FUNCTION streetgen._make_chain_keys(name) IS
    'Makes the function of a model that tells which chains a run touches.';

CREATE OR REPLACE FUNCTION streetgen._places_of(cells integer[], chains integer[], OUT alone integer[],
    OUT shared integer[])
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    -- More keys than these are not worth their locks.
    SELECT CASE WHEN many_cells THEN ARRAY[-1] ELSE cells END
            || CASE WHEN many_chains THEN ARRAY[streetgen._all_chains()] ELSE chains END,
        CASE WHEN many_cells THEN '{}' ELSE ARRAY[-1] END
            || CASE WHEN many_chains OR chains = '{}' THEN '{}' ELSE ARRAY[streetgen._all_chains()] END
    FROM (SELECT cardinality(cells) > 64 AS many_cells, cardinality(chains) > 128 AS many_chains) m $$;
COMMENT ON FUNCTION streetgen._places_of(integer[], integer[]) IS
    'The keys that lock cells and chains, for oneself and shared: above 64 cells one key of all cells, above 128 '
    'chains one key of all chains.';

CREATE OR REPLACE FUNCTION streetgen._axes_at_chains(model name, axes bigint[], chains integer[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    touching bigint[] := '{}';
BEGIN
    IF chains <> '{}' THEN
        EXECUTE format('SELECT ARRAY(SELECT DISTINCT axis_id FROM %I._chain_keys($1)
            WHERE key = ANY ($2) OR streetgen._all_chains() = ANY ($2))', model) INTO touching USING axes, chains;
    END IF;
    RETURN touching;
END $$;
COMMENT ON FUNCTION streetgen._axes_at_chains(name, bigint[], integer[]) IS
    'Those of the axes that touch a chain of which the key is given.';

CREATE OR REPLACE FUNCTION streetgen._fill_chains(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    SET streetgen.computes = 'on'
    AS $$
DECLARE
    places jsonb := streetgen._upsert_places(model, 'whole');
    subject text;
    parts text[];
    part text;
    chained boolean := false;
BEGIN
    parts := ARRAY[streetgen._fill_template($part$
setting AS MATERIALIZED (SELECT jsonb_object_agg(name, value) AS v FROM {model}.setting),
new_node AS MATERIALIZED (SELECT *, false AS fresh FROM {model}.node),
new_edge AS MATERIALIZED (SELECT *, false AS fresh FROM {model}.edge),
left_node AS (SELECT node_id FROM new_node WHERE false),
old_edge AS (SELECT *, true AS written FROM new_edge WHERE false),
written_axis AS (SELECT axis_id FROM new_edge WHERE false)$part$, places)];
    IF 'overpass' = ANY (streetgen._subjects(model)) THEN
        parts := parts || streetgen._fill_template($part$
found_overpass AS MATERIALIZED (
    SELECT o.*, e.level < 0 AS sinks FROM {model}.overpass o JOIN {model}.edge e ON e.edge_id = o.edge_below)$part$,
            places);
    END IF;
    IF 'ramp' = ANY (streetgen._subjects(model)) THEN
        parts := parts || streetgen._fill_template('new_ramp AS MATERIALIZED (SELECT * FROM {model}.ramp)', places);
    END IF;
    FOR subject IN SELECT jsonb_array_elements_text(places -> 'subjects') LOOP
        CONTINUE WHEN subject <> ALL (streetgen._subjects_at_end());
        EXECUTE format('SELECT streetgen.%I($1)', '_upsert_' || subject) INTO part USING places;
        parts := parts || part;
        chained := true;
    END LOOP;
    IF chained THEN
        EXECUTE 'WITH RECURSIVE ' || array_to_string(parts, ',') || ' SELECT';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._fill_chains(name) IS
    'Computes what is a function of whole chains from the nodes and edges of a model, for who is alone in it, at the '
    'end of a first run by clusters.';
