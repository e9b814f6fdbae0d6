-- Triggers on axes, by which overrides, routes and objects follow edits of axes.

CREATE OR REPLACE FUNCTION streetgen._axis_follower() RETURNS TABLE(relation name, follower name)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('axis_follower');
END $$;
COMMENT ON FUNCTION streetgen._axis_follower() IS
    'The tables that every model has and whose rows stay with their axes, from functions _ROOM_axis_follower, each '
    'with the function of a model that moves these rows.';

CREATE OR REPLACE FUNCTION streetgen._follow_axes(model name, trigger_name text, relations name[], followers name[],
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
                'changed', followed.changed,
                'filled', (SELECT string_agg(format('EXISTS (SELECT FROM %I)', relation), ' OR ')
                    FROM unnest(relations) relation),
                'calls', (
                    SELECT string_agg(streetgen._fill_template(streetgen._part('follower_call'), jsonb_build_object(
                        'relation', quote_ident(relation), 'follower', quote_ident(follower))), '' ORDER BY n)
                    FROM unnest(relations, followers) WITH ORDINALITY u(relation, follower, n)))),
            format('%I()', followed.name), 'After an edit of axes: ' || purpose, 'VOLATILE SECURITY DEFINER');
        PERFORM streetgen._make_statement_triggers(model, 'axis', trigger_name, ARRAY[followed.event],
            followed.name || '()', 'before', 'after', 'After an edit: ' || purpose);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._follow_axes(name, text, name[], name[], text) IS
    'Makes the triggers on the axes of a model that call functions of the model after each edit, each unless its table '
    'is empty. A function gets the changed axes with their lines before and after, NULL where there was or is none.';
