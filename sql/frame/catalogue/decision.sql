-- Decisions by hand: a room lists its tables of them, and says where each is anchored in the network.

CREATE OR REPLACE FUNCTION streetgen._decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('decision');
END $$;
COMMENT ON FUNCTION streetgen._decision() IS
    'The tables of decisions by hand, from functions _ROOM_decision. anchor: along (a place along an axis: axis_id, '
    'abscissa, geom), vertex (the same, and it goes with the vertex of the axis that lies there; abscissa may lack), '
    'end (an end of an axis: axis_id, which, geom), beside (a place beside an axis, up to 100 m off, which stays: '
    'axis_id, abscissa, geom), node (a node between two axes; geom), route (a node between two axes, or two nodes and '
    'axes between: to_geom, via_axes, via_geom) or ground (a place on the ground, and the axis beside it where axes '
    'names one). axes: the columns that name axes, except via_axes. reach: an axis within this distance lies at the '
    'place, as SQL over the row, metres; {tolerance} is the setting. '
    'follows: columns with their new values, as SQL, where the decision follows its axis: o is the row, n its '
    'streetgen.placed_decision or node_decision, and of an end e.which the end now. hashed: does input_hash tell of an '
    'edit? Where it does not, axes are marked as stale while streets do not follow. hash: what input_hash takes of a '
    'row, as SQL over o, in the order of hash_place, which stays: another hash is that of another axis. NULL: nothing, '
    'or axis_used says it otherwise.';

CREATE OR REPLACE FUNCTION streetgen._decisions_of(model name)
    RETURNS TABLE(n bigint, relation name, anchor text, axes name[], reach text, follows jsonb,
        hash_place integer, hash text, key name, attributes name[])
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
    SELECT d.n, d.relation, d.anchor, d.axes, d.reach, d.follows, d.hash_place, d.hash,
        d.relation || '_id', a.attributes
    FROM streetgen._decision() WITH ORDINALITY d(relation, anchor, axes, reach, follows, hashed,
            hash_place, hash, n)
        JOIN pg_class c ON c.relname = d.relation AND c.relnamespace = quote_ident(model)::regnamespace
        CROSS JOIN LATERAL (SELECT array_agg(attname) AS attributes FROM pg_attribute
            WHERE attrelid = c.oid AND attnum > 0 AND NOT attisdropped) a $$;
COMMENT ON FUNCTION streetgen._decisions_of(name) IS
    'The tables of decisions that a model has, in the order in which their rows are locked, with the key and the '
    'columns of each.';

CREATE OR REPLACE FUNCTION streetgen._is_hashed(relation name) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT bool_and(hashed) FROM streetgen._decision() d WHERE d.relation = _is_hashed.relation $$;
COMMENT ON FUNCTION streetgen._is_hashed(name) IS
    'Does input_hash tell of an edit of a table of decisions? Where it does not, an edit marks axes as stale while '
    'streetgen.live is off.';
