-- Pieces of statements of importers, by name: streetgen._part gives each.

--{follower
#variable_conflict use_column
DECLARE
    former text[] := ARRAY[]::text[];
    way_out text;
BEGIN
    IF TG_OP = 'TRUNCATE' THEN
        EXECUTE format({no_rows}, TG_RELID::regclass);
        former := ARRAY(SELECT source_ref FROM {model}.axis WHERE source = {source}
            UNION SELECT source_ref FROM {model}.delivered WHERE source = {source} AND relation = 'axis');
    ELSIF TG_OP = 'INSERT' THEN
        CREATE TEMPORARY TABLE _import ON COMMIT DROP AS SELECT {rows} FROM new_row n;
    ELSIF TG_OP = 'DELETE' THEN
        CREATE TEMPORARY TABLE _import ON COMMIT DROP AS SELECT {rows} FROM old_row o WHERE false;
        former := ARRAY(SELECT {refs} FROM old_row o);
    ELSIF EXISTS (SELECT FROM new_row n
        WHERE NOT EXISTS (SELECT FROM old_row o WHERE ROW({was})::text = ROW({is_now})::text))
        OR EXISTS (SELECT FROM old_row o
            WHERE NOT EXISTS (SELECT FROM new_row n WHERE ROW({was})::text = ROW({is_now})::text)) THEN
        CREATE TEMPORARY TABLE _import ON COMMIT DROP AS SELECT {rows} FROM new_row n
            WHERE NOT EXISTS (SELECT FROM old_row o WHERE ROW({was})::text = ROW({is_now})::text);
        former := ARRAY(SELECT {refs} FROM old_row o
            WHERE NOT EXISTS (SELECT FROM new_row n WHERE ROW({was})::text = ROW({is_now})::text));
    ELSE
        RETURN NULL;
    END IF;
    PERFORM streetgen._import_change({name}, {source}, former);
    RETURN NULL;
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    GET STACKED DIAGNOSTICS way_out = PG_EXCEPTION_HINT;
    PERFORM streetgen._refuse_wait({name}, CASE SQLSTATE WHEN '55P03' THEN way_out END);
    RAISE;
END
