-- Columns of a user's own table as columns of axes.

CREATE OR REPLACE FUNCTION streetgen._axis_input() RETURNS TABLE(name text, type text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 27 SET search_path = pg_catalog
    AS $$ VALUES ('width', 'float8'), ('width_end', 'float8'), ('roadway_offset', 'float8'), ('lane_count', 'integer'),
        ('direction', 'text'), ('speed', 'float8'), ('importance', 'integer'), ('name', 'text'), ('level', 'integer'),
        ('kind', 'text'), ('radius', 'float8'), ('lanes_forward', 'integer'), ('lanes_backward', 'integer'),
        ('lanes_both', 'integer'), ('kind_forward', 'text'), ('kind_backward', 'text'), ('lane_width_forward', 'text'),
        ('lane_width_backward', 'text'), ('turn_forward', 'text'), ('turn_backward', 'text'),
        ('change_forward', 'text'), ('change_backward', 'text'), ('sidewalk_left', 'float8'),
        ('sidewalk_right', 'float8'), ('flow', 'float8'), ('roundabout_tag', 'text'), ('ref', 'text') $$;
COMMENT ON FUNCTION streetgen._axis_input() IS 'The columns of axis that a source may fill besides geom.';

CREATE OR REPLACE FUNCTION streetgen._taken_value(name text, alias text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE name WHEN 'kind' THEN format('%s.class', alias) WHEN 'direction'
        THEN format('coalesce(%s.direction, ''both'')', alias) WHEN 'level' THEN format('coalesce(%s.level, 0)', alias)
        ELSE format('%s.%I', alias, name) END $$;
COMMENT ON FUNCTION streetgen._taken_value(text, text) IS
    'SQL of what a column of axis gets from a row of the import.';

CREATE OR REPLACE FUNCTION streetgen._refuse_number(label text, value text, column_name text, target text)
    RETURNS float8
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RAISE EXCEPTION 'source row % has "%" in column "%", expected a % for %', label, value, column_name,
        CASE WHEN target IN ('lane_count', 'importance', 'level', 'lanes_forward', 'lanes_backward', 'lanes_both')
            THEN 'whole number' ELSE 'number' END, target USING ERRCODE = '22023',
        HINT = 'Map a column of numbers, or import from a view that converts it; NULL is unknown.';
END $$;
COMMENT ON FUNCTION streetgen._refuse_number(text, text, text, text) IS
    'Raises 22023 for a value of a source row that is no number, for a column of axis that takes one.';

CREATE OR REPLACE FUNCTION streetgen._mapped(source regclass, mapping jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target record;
    entry jsonb;
    column_name text;
    -- What both float8 and, rounded, integer take without an error; NaN and infinity are named later by their row.
    number_pattern constant text := '^\s*([-+]?(\d{1,15}(\.\d*)?|\.\d+)(e[-+]?\d{1,2})?|nan|[-+]?inf(inity)?)\s*$';
    whole_pattern constant text := '^\s*[-+]?\d{1,9}(\.0*)?\s*$';
    pattern text;
    label text;
    expression text;
    expressions text[] := '{}';
BEGIN
    IF jsonb_typeof(mapping) <> 'object' THEN
        RAISE EXCEPTION 'the mapping is a %, expected an object', jsonb_typeof(mapping) USING ERRCODE = '22023',
            HINT = 'For example {"geom": "the_geom", "width": "largeur", "level": {"value": 0}}.';
    END IF;
    SELECT key INTO column_name FROM jsonb_object_keys(mapping) key
        WHERE key NOT IN (SELECT name FROM streetgen._axis_input() UNION ALL VALUES ('geom'), ('source_ref')) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'the mapping names "%", which is no column of axis to fill', column_name
            USING ERRCODE = '22023', HINT = 'geom, ' || (SELECT string_agg(name, ', ') FROM streetgen._axis_input())
                || ' or source_ref';
    END IF;
    -- A row without a source_ref is known by its place.
    label := CASE WHEN jsonb_typeof(mapping -> 'source_ref') = 'string'
        THEN format('coalesce(%I::text, ''number '' || row_number() OVER ())', mapping ->> 'source_ref')
        ELSE '''number '' || row_number() OVER ()' END;
    FOR target IN SELECT 'geom' AS name, 'geometry' AS type UNION ALL SELECT * FROM streetgen._axis_input()
        UNION ALL VALUES ('source_ref', 'text')
    LOOP
        entry := mapping -> target.name;
        IF target.name = 'geom' AND entry IS NULL THEN entry := '"geom"'; END IF;
        IF entry IS NULL OR jsonb_typeof(entry) = 'null' THEN
            -- No import changes a column that the mapping does not mention.
            IF target.name = 'source_ref' THEN expressions := expressions || 'NULL::text AS source_ref'::text; END IF;
            CONTINUE;
        END IF;
        pattern := CASE target.type WHEN 'float8' THEN number_pattern WHEN 'integer' THEN whole_pattern END;
        IF jsonb_typeof(entry) = 'object' AND entry ? 'value' AND target.name <> 'geom' THEN
            IF entry ->> 'value' !~* pattern THEN
                RAISE EXCEPTION 'the mapping gives "%" the value %, expected a number', target.name, entry -> 'value'
                    USING ERRCODE = '22023',
                    HINT = CASE target.type WHEN 'integer' THEN 'A whole number' ELSE 'A number'
                        END || ', or null for unknown.';
            END IF;
            expressions := expressions || format(CASE target.type WHEN 'integer' THEN '%L::float8::%s AS %I'
                ELSE '%L::%s AS %I' END, entry ->> 'value', target.type, CASE target.name WHEN 'kind' THEN 'class'
                ELSE target.name END);
            CONTINUE;
        ELSIF jsonb_typeof(entry) <> 'string' THEN
            RAISE EXCEPTION 'the mapping of "%" is %, expected a column name or {"value": …}', target.name, entry
                USING ERRCODE = '22023', HINT = 'SQL is never evaluated.';
        END IF;
        column_name := entry #>> '{}';
        IF NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = source AND attname = column_name AND attnum > 0
            AND NOT attisdropped) THEN
            RAISE EXCEPTION 'table % has no column "%"', source, column_name USING ERRCODE = '42703',
                HINT = 'It has ' || (SELECT string_agg(attname, ', ') FROM pg_attribute WHERE attrelid = source
                    AND attnum > 0 AND NOT attisdropped) || '.';
        END IF;
        IF target.type = 'geometry' AND NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = source
            AND attname = column_name AND atttypid = 'geometry'::regtype) THEN
            RAISE EXCEPTION 'column "%" of % is no geometry', column_name, source USING ERRCODE = '22023',
                HINT = 'Map "geom" to the column that holds the lines.';
        END IF;
        expression := format(CASE target.type WHEN 'geometry' THEN '%I' WHEN 'text' THEN '%I::text' WHEN 'integer'
            THEN '%I::text::float8::integer' ELSE '%I::text::float8' END, column_name);
        IF pattern IS NOT NULL THEN
            expression := format('CASE WHEN %1$I::text !~* %2$L THEN streetgen._refuse_number(%3$s, %1$I::text, '
                '%1$L, %4$L)::%5$s ELSE %6$s END',
                column_name, pattern, label, target.name, target.type, expression);
        END IF;
        expressions := expressions || format('%s AS %I', expression, CASE target.name WHEN 'kind' THEN 'class'
            ELSE target.name END);
    END LOOP;
    RETURN array_to_string(expressions,
        ', ') || ', ' || label || ' AS label, NULL::text AS left_out, NULL::text[] AS unread';
END $$;
COMMENT ON FUNCTION streetgen._mapped(regclass, jsonb) IS
    'The columns of the import from those of a source, as SQL, by a checked mapping; a number that is none is refused '
    'when it is read.';
