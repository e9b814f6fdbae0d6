-- Pieces of statements about the reach of an edit, by name: streetgen._part gives each.

--{chain_keys
#variable_conflict use_column
BEGIN
    RETURN QUERY WITH touched AS MATERIALIZED (
        SELECT axis_id, edge_id FROM unnest(touching, edges) t(axis_id, edge_id))
    {chains};
END
