-- Counts of all that is in a model.

CREATE OR REPLACE FUNCTION streetgen._summary_part()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE plpgsql STABLE PARALLEL SAFE ROWS 40 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE streetgen._rows_of_rooms('summary');
END $$;
COMMENT ON FUNCTION streetgen._summary_part() IS
    'What streetgen.summary counts, query by query, over a model %1$I, from functions _ROOM_summary: the first of a '
    'row names a thing, then come its amount and unit. subject: the query stands only in models that compute it.';

CREATE OR REPLACE FUNCTION streetgen.summary(model name) RETURNS TABLE(subject text, amount numeric, unit text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_reader(model);
    RETURN QUERY EXECUTE (SELECT format(string_agg(query, E'\nUNION ALL ' ORDER BY place), model)
        FROM streetgen._summary_part() p WHERE p.subject = ANY (streetgen._rooms_of(model)));
END $$;
COMMENT ON FUNCTION streetgen.summary(name) IS
    'How much there is in a model, and how it came about. An unknown model: 3F000.';
