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

CREATE OR REPLACE FUNCTION streetgen._input_rule(input regclass, attribute name, broken name DEFAULT NULL)
    RETURNS TABLE(expected text, way_out text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ SELECT said[1], said[2]
        FROM pg_attribute JOIN pg_constraint c ON conrelid = attrelid AND (conkey = ARRAY[attnum] OR conname = broken),
            regexp_match(obj_description(c.oid, 'pg_constraint'), '^(.*?)\. (.*)$') said
        WHERE attrelid = input AND attname = attribute AND contype = 'c' AND said IS NOT NULL
        ORDER BY conname = broken DESC NULLS LAST, conname LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._input_rule(regclass, name, name) IS
    'What the constraint on a column of an input table asks for, in words, and the way out: the first sentence of its '
    'comment, and the rest. broken: the constraint, NULL: the first on that column alone.';

CREATE OR REPLACE FUNCTION streetgen._conditions(input regclass)
    RETURNS TABLE(attribute name, condition text, sqlstate text, name name, attributes name[])
    LANGUAGE sql STABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
    SELECT attname, c.* FROM pg_attribute a CROSS JOIN LATERAL (
        SELECT format('%I IS NOT NULL', attname), '23502', NULL::name, ARRAY[attname] WHERE attnotnull
        UNION ALL SELECT pg_get_expr(conbin, conrelid), '23514', conname, ARRAY(SELECT k.attname FROM pg_attribute k
                WHERE k.attrelid = conrelid AND k.attnum = ANY (conkey) ORDER BY k.attnum)
            FROM pg_constraint k WHERE conrelid = input AND contype = 'c' AND (conkey = ARRAY[attnum]
                OR attnum = (SELECT max(n) FROM unnest(conkey) n) AND obj_description(k.oid, 'pg_constraint') <> '')) c
    WHERE attrelid = input AND attnum > 0 AND NOT attisdropped ORDER BY attnum, 3
    $$;
COMMENT ON FUNCTION streetgen._conditions(regclass) IS
    'What holds for each column of a table: NOT NULL, the constraints that name it alone, and those of several '
    'columns that have a comment, for the last of them; as SQL, with the SQLSTATE of a row that breaks it and the '
    'columns that it reads.';

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
    FOR broken IN SELECT c.*, atttypid, attidentity, (SELECT string_agg(format('nullif(%I::text, %L)', k.attname, ''),
            ', ' ORDER BY k.attnum) FROM pg_attribute k JOIN pg_index ON indrelid = k.attrelid AND indisprimary
                AND k.attnum = ANY (indkey) WHERE k.attrelid = TG_RELID) AS key
        FROM streetgen._conditions(TG_RELID) c JOIN pg_attribute ON attrelid = TG_RELID AND attname = attribute
        -- The place comes first: columns that are left out follow from it.
        ORDER BY atttypid <> 'geometry'::regtype, attnum, cardinality(c.attributes)
    LOOP
        EXECUTE format('SELECT %s, concat_ws('' '', %s), %s FROM (SELECT ($1).*) r', broken.condition,
            coalesce(broken.key, 'NULL'),
            format(CASE broken.atttypid WHEN 'geometry'::regtype THEN 'left(ST_AsText(%I), 80)' WHEN 'text'::regtype
                THEN 'to_json(%I)::text' ELSE '%I::text' END, broken.attribute)) INTO holds, key, value USING NEW;
        IF holds IS FALSE THEN
            SELECT * INTO rule FROM streetgen._input_rule(TG_RELID, broken.attribute, broken.name);
            PERFORM streetgen._refuse(broken.sqlstate,
                format('the %s of %s cannot be %s', broken.attribute, concat_ws(' ', CASE TG_OP WHEN 'INSERT'
                    THEN 'the new' END, replace(TG_TABLE_NAME, '_', ' '), nullif(key, '')), coalesce(value, 'NULL')),
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

CREATE OR REPLACE FUNCTION streetgen._of_new_row(condition text, attributes name[]) RETURNS text
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    attribute name;
BEGIN
    FOREACH attribute IN ARRAY attributes LOOP
        condition := regexp_replace(condition, format('\m%s\M', attribute), format('NEW.%I', attribute), 'g');
    END LOOP;
    RETURN condition;
END $$;
COMMENT ON FUNCTION streetgen._of_new_row(text, name[]) IS
    'A condition over columns of a table as the WHEN of a trigger has it.';

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
        SELECT c.oid::regclass AS input, (SELECT string_agg(DISTINCT quote_ident(a), ', ')
                FROM string_to_table(string_agg(array_to_string(n.attributes, ','), ','), ',') a) AS attributes,
            string_agg(streetgen._of_new_row(condition, n.attributes), ' AND ' ORDER BY attribute, condition)
                AS condition
        FROM (SELECT oid, relname FROM pg_class WHERE relnamespace = quote_ident(model)::regnamespace
            AND relname = ANY (streetgen._edited_tables(model) || '{axis_class,symbol_rule}'::name[]
                || ARRAY(SELECT w.relation FROM streetgen._written() w WHERE w.privilege = 'INSERT')) OFFSET 0) c
        CROSS JOIN LATERAL streetgen._conditions(c.oid) n
        -- Columns that others added keep to their constraints: a trigger would bar them from being dropped or altered.
        JOIN streetgen.template t ON relation = relname AND n.attributes <@ t.attributes GROUP BY c.oid
    LOOP
        -- The condition is read with the row; the function is called for a row that breaks it.
        EXECUTE format('CREATE OR REPLACE TRIGGER refuse BEFORE INSERT OR UPDATE OF %s ON %s FOR EACH ROW WHEN ((%s) '
            'IS FALSE) EXECUTE FUNCTION streetgen._refuse_row(); COMMENT ON TRIGGER refuse ON %2$s IS %4$L',
            ruled.attributes, ruled.input, ruled.condition,
            'Says what a column may hold, before its constraint refuses the row');
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._make_refusals(name) IS
    'Makes the triggers on the input tables of a model, and on others where editors may insert, that say what is wrong '
    'with a row and what to do.';
