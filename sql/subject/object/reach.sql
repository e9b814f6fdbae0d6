-- How far a change reaches by objects that give way to each other.

CREATE OR REPLACE FUNCTION streetgen._object_reach(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- Each stands so far behind its border at most that rules say.
    RETURN (SELECT coalesce(max(metres), 0) FROM object_distance)
        + (SELECT 2 * coalesce(greatest(max(axis_offset), 0), 0) FROM placement_rule
            WHERE active AND along IN ('border', 'corner'));
END $$;
COMMENT ON FUNCTION streetgen._object_reach(name) IS
    'How far a change of an axis reaches by the distances that objects of rules keep, metres.';
