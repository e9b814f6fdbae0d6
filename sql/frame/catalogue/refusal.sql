-- Refusals: an edit that cannot be is told what is wrong and what to do, and of a row of input what it may hold.
-- Constraints of its table hold too, but give neither value nor way out.

CREATE OR REPLACE FUNCTION streetgen._refuse(state text, message text, detail text DEFAULT NULL,
    hint text DEFAULT NULL, schema text DEFAULT NULL, relation text DEFAULT NULL, attribute text DEFAULT NULL,
    rule text DEFAULT NULL) RETURNS void
    LANGUAGE c VOLATILE PARALLEL SAFE AS 'MODULE_PATHNAME', 'streetgen_refuse';
COMMENT ON FUNCTION streetgen._refuse(text, text, text, text, text, text, text, text) IS
    'Raises an error with the SQLSTATE given, as RAISE does with the same words, but without CONTEXT: a refusal says '
    'what is wrong and what to do, and a GIS shows all of it. NULL leaves a field out. A state that is no '
    'SQLSTATE: 22023.';

CREATE OR REPLACE FUNCTION streetgen._input_rule(input regclass, attribute name)
    RETURNS TABLE(expected text, way_out text)
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ SELECT said[1], said[2]
        FROM pg_attribute JOIN pg_constraint c ON conrelid = attrelid AND conkey = ARRAY[attnum],
            regexp_match(obj_description(c.oid, 'pg_constraint'), '^(.*?)\. (.*)$') said
        WHERE attrelid = input AND attname = attribute AND contype = 'c' AND said IS NOT NULL
        ORDER BY conname LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._input_rule(regclass, name) IS
    'What the constraint on a column of an input table asks for, in words, and the way out: the first sentence of its '
    'comment, and the rest.';

CREATE OR REPLACE FUNCTION streetgen._conditions(input regclass)
    RETURNS TABLE(attribute name, condition text, sqlstate text, name name)
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
    SELECT attname, c.* FROM pg_attribute a CROSS JOIN LATERAL (
        SELECT format('%I IS NOT NULL', attname), '23502', NULL::name WHERE attnotnull
        UNION ALL SELECT pg_get_expr(conbin, conrelid), '23514', conname FROM pg_constraint WHERE conrelid = input
            AND contype = 'c' AND conkey = ARRAY[attnum]) c
    WHERE attrelid = input AND attnum > 0 AND NOT attisdropped ORDER BY attnum, 3
    $$;
COMMENT ON FUNCTION streetgen._conditions(regclass) IS
    'What holds for each column of a table: NOT NULL and the constraints that name it alone, as SQL, with the '
    'SQLSTATE of a row that breaks it.';

CREATE OR REPLACE FUNCTION streetgen._refuse_row() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    broken record;
    rule record;
    key text;
    value text;
    holds boolean;
BEGIN
    FOR broken IN SELECT c.*, atttypid, attidentity, (SELECT k.attname FROM pg_attribute k WHERE k.attrelid = TG_RELID
        AND k.attnum = 1) AS key
        FROM streetgen._conditions(TG_RELID) c JOIN pg_attribute ON attrelid = TG_RELID AND attname = attribute
        -- The place comes first: columns that are left out follow from it.
        ORDER BY atttypid <> 'geometry'::regtype, attnum
    LOOP
        EXECUTE format('SELECT %s, %I::text, %s FROM (SELECT ($1).*) r', broken.condition, broken.key,
            format(CASE broken.atttypid WHEN 'geometry'::regtype THEN 'left(ST_AsText(%I), 80)' WHEN 'text'::regtype
                THEN 'to_json(%I)::text' ELSE '%I::text' END, broken.attribute)) INTO holds, key, value USING NEW;
        IF holds IS FALSE THEN
            SELECT * INTO rule FROM streetgen._input_rule(TG_RELID, broken.attribute);
            PERFORM streetgen._refuse(broken.sqlstate,
                format('the %s of %s cannot be %s', broken.attribute, concat_ws(' ', CASE TG_OP WHEN 'INSERT'
                    THEN 'the new' END, replace(TG_TABLE_NAME, '_', ' '), key), coalesce(value, 'NULL')),
                detail => format('Expected %s.', coalesce(rule.expected, CASE broken.atttypid WHEN 'geometry'::regtype
                    THEN 'a place, every coordinate a number within 1e12' ELSE 'a value' END)),
                hint => coalesce(rule.way_out, CASE WHEN broken.attidentity <> ''
                    THEN 'Leave it out: it is numbered by itself.' ELSE 'Fill it, or undo the edit.' END),
                schema => TG_TABLE_SCHEMA, relation => TG_TABLE_NAME, attribute => broken.attribute,
                rule => broken.name);
        END IF;
    END LOOP;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._refuse_row() IS
    'Trigger of input tables, for rows that a constraint would refuse: names row, column and value, what is expected '
    'and the way out, with the SQLSTATE of the constraint (23514, 23502). A constraint that is no longer there '
    'refuses nothing.';

CREATE OR REPLACE FUNCTION streetgen._make_refusals(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    ruled record;
    former record;
BEGIN
    -- Models of older builds have a trigger a column.
    FOR former IN SELECT tgname AS name, tgrelid::regclass AS input FROM pg_trigger JOIN pg_class c ON c.oid = tgrelid
        WHERE relnamespace = quote_ident(model)::regnamespace AND tgname <> 'refuse'
            AND tgfoid = 'streetgen._refuse_row()'::regprocedure
    LOOP
        EXECUTE format('DROP TRIGGER %I ON %s', former.name, former.input);
    END LOOP;
    FOR ruled IN
        SELECT c.oid::regclass AS input, string_agg(DISTINCT quote_ident(attribute), ', ') AS attributes,
            string_agg(regexp_replace(condition, format('\m%s\M', attribute), format('NEW.%I', attribute), 'g'),
            ' AND ' ORDER BY attribute, condition) AS condition
        FROM (SELECT oid, relname FROM pg_class WHERE relnamespace = quote_ident(model)::regnamespace
            AND relname = ANY (streetgen._edited_tables(model) || 'axis_class'::name) OFFSET 0) c
        CROSS JOIN LATERAL streetgen._conditions(c.oid)
        -- Columns that others added keep to their constraints: a trigger would bar them from being dropped or altered.
        JOIN streetgen.template ON relation = relname AND attribute = ANY (attributes) GROUP BY c.oid
    LOOP
        -- The condition is read with the row; the function is called for a row that breaks it.
        EXECUTE format('CREATE OR REPLACE TRIGGER refuse BEFORE INSERT OR UPDATE OF %s ON %s FOR EACH ROW WHEN ((%s) '
            'IS FALSE) EXECUTE FUNCTION streetgen._refuse_row()', ruled.attributes, ruled.input, ruled.condition);
        EXECUTE format('COMMENT ON TRIGGER refuse ON %s IS %L', ruled.input,
            'Says what a column may hold, before its constraint refuses the row');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_refusals(name) IS
    'Makes the triggers on the input tables of a model that say what is wrong with a row and what to do.';
