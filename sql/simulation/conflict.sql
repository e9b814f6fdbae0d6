-- Movements that need the same ground, and who gives way.

CREATE OR REPLACE FUNCTION streetgen._link_conflict_rows(network bytea)
    RETURNS TABLE(link bigint, other bigint, precedence text, starts float8, ends float8, other_starts float8,
        other_ends float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_link_conflict_rows';
COMMENT ON FUNCTION streetgen._link_conflict_rows(bytea) IS
    'The conflicts of a network, as streetgen.link_conflicts has them. Bytes that are no network: 22023.';

CREATE OR REPLACE FUNCTION streetgen._links_of_junctions(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
DECLARE
    junctions bigint[];
    nodes bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT array_agg(DISTINCT k.junction_id) FILTER (WHERE k.junction_id IS NOT NULL), array_agg(DISTINCT k.from_node)
        INTO junctions, nodes FROM link k
        WHERE k.kind = 'movement' AND k.lane_in = ANY (streetgen._lanes_of_links(model, links))
            AND k.link_id = ANY (links);
    RETURN ARRAY(SELECT k.link_id FROM link k WHERE k.kind = 'movement'
        AND k.lane_in = ANY (ARRAY(SELECT i.lane_in FROM interconnection i WHERE i.node_id = ANY (nodes)
            UNION SELECT m.lane_in FROM streetgen._lanes_over_junctions(model, '{}', junctions) m))
        AND (k.junction_id = ANY (junctions) OR k.junction_id IS NULL AND k.from_node = ANY (nodes)));
END $$;
COMMENT ON FUNCTION streetgen._links_of_junctions(name, bigint[]) IS
    'All movements of the junctions, or nodes, that some movements cross.';

CREATE OR REPLACE FUNCTION streetgen.link_conflicts(model name, links bigint[] DEFAULT NULL)
    RETURNS TABLE(link bigint, other bigint, precedence text, starts float8, ends float8, other_starts float8,
        other_ends float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._require_subject(model, 'interconnection');
    RETURN QUERY SELECT c.* FROM streetgen._link_conflict_rows(CASE WHEN links IS NULL
            THEN streetgen._network_of_links(model)
            ELSE streetgen._network_near_links(model, streetgen._links_of_junctions(model, links)) END) c
        WHERE links IS NULL OR c.link = ANY (links);
END $$;
COMMENT ON FUNCTION streetgen.link_conflicts(name, bigint[]) IS
    'Movements of one junction that need the same ground, each pair twice: of some movements, or of all where links is '
    'NULL; a link that is no movement has none. From starts to ends a car of usual size (5 by 1.8 m) stands on that '
    'ground: metres along link, from where its front comes there to where its rear has left; that may lie beyond its '
    'end, where two merge. precedence, of link: goes_first, gives_way, by_signal (they never have green together) or '
    'by_arrival (nobody has the right, or rights would go round in a circle). With signals, who is protected goes '
    'before who is permitted, and of two permitted ones as signal_movement.precedence says. Else signs decide, then '
    'the importance of streets; who turns across gives way to who comes towards, and who comes from the left to who '
    'comes from the right. A model without subject interconnection: 55000; an unknown model: 3F000; not a reader of '
    'the model: 42501. Wilkie, Sewall and Lin, section 4.3.1.';
