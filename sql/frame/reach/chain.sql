-- Chains: rows that are functions of something longer than the reach. Each chain that a run touches is locked by a key.

CREATE OR REPLACE FUNCTION streetgen._chain() RETURNS TABLE(relation name, touched text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('chain');
END $$;
COMMENT ON FUNCTION streetgen._chain() IS
    'The kinds of chains, from functions _ROOM_chain. relation: the computed table that has a row for each chain. '
    'touched: a query of axis_id and '
    'chain, the id of each chain that a run may change, split, join or take away when it changes edges: touched has '
    'their edge_id, and of each the axis_id that it is looked up for; axes, an array, those that change; written, an '
    'array, all whose rows it writes; {model} is the schema. The query sees a model before the run. A chain after the '
    'run is made of new rows and of pieces of chains at these edges.';

CREATE OR REPLACE FUNCTION streetgen._chain_key(relation name, chain bigint) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    BEGIN ATOMIC SELECT 4096 + (hashtextextended(relation::text, chain) & 536870911)::integer; END;
COMMENT ON FUNCTION streetgen._chain_key(name, bigint) IS
    'The key (4096 to 536875007) that locks a chain, by the table and the id of its row.';

CREATE OR REPLACE FUNCTION streetgen._all_chains() RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    BEGIN ATOMIC SELECT 4095; END;
COMMENT ON FUNCTION streetgen._all_chains() IS
    'The key of all chains of a model: whoever locks some of them shares it, whoever locks too many holds it alone.';

CREATE OR REPLACE FUNCTION streetgen._has_chains(model name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT EXISTS (SELECT FROM streetgen._chain() c
        WHERE c.relation = ANY (streetgen._computed_tables(model))) $$;
COMMENT ON FUNCTION streetgen._has_chains(name) IS 'Does a model compute rows that are functions of whole chains?';

CREATE OR REPLACE FUNCTION streetgen._make_chain_keys(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._compose_function(model,
        '_chain_keys(axes bigint[], written bigint[], touching bigint[], edges bigint[])',
        'TABLE(axis_id bigint, key integer)', streetgen._fill_template(streetgen._part('chain_keys'), (
            SELECT jsonb_build_object('chains', coalesce(string_agg(format('SELECT t.axis_id, '
                'streetgen._chain_key(%L, t.chain) FROM (%s) t', c.relation, streetgen._fill_template(c.touched,
                jsonb_build_object('model', quote_ident(model)))), ' UNION ALL '), 'SELECT 0::bigint, 0 WHERE false'))
            FROM streetgen._chain() c WHERE c.relation = ANY (streetgen._computed_tables(model)))),
        '_chain_keys(bigint[], bigint[], bigint[], bigint[])',
        'The keys of all chains that a run may change: the axes that change, all whose rows it writes, and two lists '
        'side by side, the edges that it changes and for which axis each is looked up; that axis beside each key',
        'STABLE STRICT ROWS 100 SET jit = off SET enable_seqscan = off SET plan_cache_mode = force_generic_plan');
END $$;
COMMENT ON FUNCTION streetgen._make_chain_keys(name) IS
    'Makes the function of a model that tells which chains a run touches.';

CREATE OR REPLACE FUNCTION streetgen._axes_at_chains(model name, axes bigint[], chains integer[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    touching bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF streetgen._all_chains() = ANY (chains) THEN
        touching := axes;
    ELSIF chains <> '{}' THEN
        WITH street AS MATERIALIZED (
            SELECT axis_id, edge_id, from_node, to_node FROM edge WHERE axis_id = ANY (axes)),
        -- With what meets them, since that may go on from them.
        at_node AS (
            SELECT DISTINCT s.axis_id, e.edge_id FROM street s JOIN edge e ON e.from_node IN (s.from_node, s.to_node)
            UNION SELECT s.axis_id, e.edge_id FROM street s JOIN edge e ON e.to_node IN (s.from_node, s.to_node)),
        touched AS (SELECT array_agg(axis_id) AS axes, array_agg(edge_id) AS edges FROM at_node)
        SELECT ARRAY(SELECT DISTINCT k.axis_id FROM touched t,
            _chain_keys(_axes_at_chains.axes, _axes_at_chains.axes, t.axes, t.edges) k
            WHERE key = ANY (chains)) INTO touching;
    END IF;
    RETURN touching;
END $$;
COMMENT ON FUNCTION streetgen._axes_at_chains(name, bigint[], integer[]) IS
    'Those of the axes that touch a chain of which the key is given.';
