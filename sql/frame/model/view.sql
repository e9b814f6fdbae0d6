-- Views of a model, by which rooms show several tables at once.

CREATE OR REPLACE FUNCTION streetgen._subject_view() RETURNS TABLE(name name, subject text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('view');
END $$;
COMMENT ON FUNCTION streetgen._subject_view() IS
    'The views of a model that read tables of a subject, from functions _ROOM_view, and go with it; one that '
    'can do without the subject is made again.';

CREATE OR REPLACE FUNCTION streetgen._make_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._call_rooms('_make_%s_views', model,
        '{frame,axis}'::text[] || streetgen._subjects(model) || '{cross_section,source}'::text[]
            || streetgen._traffic_rooms());
END $$;
COMMENT ON FUNCTION streetgen._make_views(name) IS
    'Makes the views of a model, again and again: those of the frame, of axes, of its subjects, of '
    'cross-sections, of what sources delivered, of links and of scenes.';
