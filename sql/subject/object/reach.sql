-- How far a change reaches by objects that give way to each other.

CREATE OR REPLACE FUNCTION streetgen._object_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Things of one kind keep a metre, and each stands so far from its border or axis at most as rules say, or as a
    -- function of the user may.
    RETURN greatest((SELECT max(metres) FROM object_distance), 1)
        + 2 * greatest((SELECT max(abs(axis_offset)) FROM placement_rule WHERE active), (SELECT 200 FROM setting
            WHERE name = 'placement_function' AND value <> 'none'), 0);
END $$;
COMMENT ON FUNCTION streetgen._object_reach(name) IS
    'How far a change of an axis reaches by the distances that objects of rules keep, metres.';
