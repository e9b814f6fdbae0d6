-- Triggers on axes, by which overrides and objects follow edits of axes.

CREATE OR REPLACE FUNCTION streetgen._follow_axes(model name, trigger_name text, relation name, follower name,
    purpose text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    followed record;
BEGIN
    FOR followed IN SELECT format('%s_%s', trigger_name, event) AS name, f.* FROM (VALUES
        ('insert', 'SELECT axis_id, NULL::geometry AS was, geom AS now FROM after'),
        ('update', 'SELECT axis_id, b.geom AS was, a.geom AS now FROM before b FULL JOIN after a USING (axis_id) '
            'WHERE b.geom IS DISTINCT FROM a.geom'),
        ('delete', 'SELECT axis_id, geom AS was, NULL::geometry AS now FROM before')) f(event, changed)
    LOOP
        PERFORM streetgen._compose_function(model, format('%I()', followed.name), 'trigger',
            streetgen._fill_template(streetgen._part('follow_axes'), jsonb_build_object(
                'relation', quote_ident(relation), 'follower', quote_ident(follower), 'changed', followed.changed)),
            format('%I()', followed.name), 'After an edit of axes: ' || purpose, 'VOLATILE SECURITY DEFINER');
        PERFORM streetgen._make_statement_triggers(model, 'axis', trigger_name, ARRAY[followed.event],
            followed.name || '()', 'before', 'after', 'After an edit: ' || purpose);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._follow_axes(name, text, name, name, text) IS
    'Makes the triggers on the axes of a model that call a function of the model after each edit, unless a table is '
    'empty. The function gets the changed axes with their lines before and after, NULL where there was or is none.';
