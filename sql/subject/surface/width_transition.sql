-- Decisions by hand about a change of width.

CREATE OR REPLACE FUNCTION streetgen.set_transition(model name, node bigint, kind text DEFAULT NULL,
    length float8 DEFAULT NULL) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    ends record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('node', node::text);
    PERFORM streetgen._lock_axes(model, format('SELECT axis_id FROM %I.edge WHERE from_node = %L OR to_node = %2$L',
        model, node));
    -- A node may get another id, an end of an axis stays: the override is kept there.
    SELECT array_agg(axis_id ORDER BY axis_id, which DESC) AS axis_id, array_agg(which ORDER BY axis_id, which DESC)
        AS which
    FROM (SELECT axis_id, 'start' AS which FROM edge WHERE from_node = node
        UNION ALL SELECT axis_id, 'end' FROM edge WHERE to_node = node) e INTO ends;
    IF ends.axis_id IS NULL THEN
        RAISE EXCEPTION 'model "%" has no node %', model, node USING ERRCODE = '22023',
            HINT = 'Nodes get another id where they come anew: look it up by its place.';
    ELSIF cardinality(ends.axis_id) <> 2 THEN
        RAISE EXCEPTION 'node % of model "%" joins % edges, expected 2', node, model, cardinality(ends.axis_id)
            USING ERRCODE = '22023',
            HINT = 'A width changes where one axis goes on as another.';
    END IF;
    DELETE FROM transition_override o USING unnest(ends.axis_id, ends.which) e(axis_id, which)
        WHERE (o.axis_id, o.which) = (e.axis_id, e.which);
    IF kind IS NOT NULL OR length IS NOT NULL THEN
        INSERT INTO transition_override (axis_id, which, kind, length) VALUES (ends.axis_id[1], ends.which[1], kind,
            length);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen.set_transition(name, bigint, text, float8) IS
    'Sets how the width changes at a node of two edges: kind (symmetric; left or right, seen along the axis of the '
    'smaller axis_id) and length (metres), NULL: that of the settings; both NULL: no override. Kept in '
    'transition_override by axis and end, so that it survives generate, a move of the node and new node ids; the '
    'streets follow as after any edit. Another node: 22023; a kind or length out of range: 23514.';
