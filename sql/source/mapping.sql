-- Columns of a user's own table as columns of axes.

CREATE OR REPLACE FUNCTION streetgen._axis_input()
    RETURNS TABLE(name text, type text, read_as text, low float8, high float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 40 SET search_path = pg_catalog
    AS $$ VALUES ('width', 'float8', 'metres', 0::float8, 200::float8), ('width_end', 'float8', 'metres', 0, 200),
        ('roadway_offset', 'float8', 'metres', -100, 100), ('lane_count', 'integer', 'count', 0, 30),
        ('direction', 'text', 'direction', NULL, NULL), ('speed', 'float8', 'kmh', 0, 400),
        ('importance', 'integer', 'count', 0, 99), ('name', 'text', 'text', NULL, NULL),
        ('level', 'integer', 'count', -50, 50), ('kind', 'text', 'text', NULL, NULL),
        ('radius', 'float8', 'metres', 0, 200), ('lanes_forward', 'integer', 'count', 0, 30),
        ('lanes_backward', 'integer', 'count', 0, 30), ('lanes_both', 'integer', 'count', 0, 30),
        ('kind_forward', 'text', 'kind', NULL, NULL), ('kind_backward', 'text', 'kind', NULL, NULL),
        ('lane_width_forward', 'text', 'width', NULL, NULL), ('lane_width_backward', 'text', 'width', NULL, NULL),
        ('turn_forward', 'text', 'turn', NULL, NULL), ('turn_backward', 'text', 'turn', NULL, NULL),
        ('change_forward', 'text', 'change', NULL, NULL), ('change_backward', 'text', 'change', NULL, NULL),
        ('sidewalk_left', 'float8', 'metres', 0, 50), ('sidewalk_right', 'float8', 'metres', 0, 50),
        ('flow', 'float8', 'number', 0, 1000000), ('roundabout_tag', 'text', 'text', NULL, NULL),
        ('ref', 'text', 'text', NULL, NULL), ('access', 'text', 'text', NULL, NULL),
        ('parking_left', 'text', 'parking', NULL, NULL), ('parking_right', 'text', 'parking', NULL, NULL),
        ('strips_left', 'text', 'strips', NULL, NULL), ('strips_right', 'text', 'strips', NULL, NULL),
        ('lane_markings', 'text', 'yes_or_no', NULL, NULL), ('sidewalk_apart', 'text', 'sides', NULL, NULL),
        ('paved', 'text', 'text', NULL, NULL), ('sidewalk_paved_left', 'text', 'text', NULL, NULL),
        ('sidewalk_paved_right', 'text', 'text', NULL, NULL), ('cycle_paved_left', 'text', 'text', NULL, NULL),
        ('cycle_paved_right', 'text', 'text', NULL, NULL), ('height_limit', 'float8', 'metres', 1, 30) $$;
COMMENT ON FUNCTION streetgen._axis_input() IS
    'The columns of axis that a source may fill besides geom, how their texts are read, and the bounds of numbers.';

CREATE OR REPLACE FUNCTION streetgen._taken_value(name text, alias text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE name WHEN 'kind' THEN format('%s.class', alias) WHEN 'direction'
        THEN format('coalesce(%s.direction, ''both'')', alias) WHEN 'level' THEN format('coalesce(%s.level, 0)', alias)
        ELSE format('%s.%I', alias, name) END $$;
COMMENT ON FUNCTION streetgen._taken_value(text, text) IS
    'SQL of what a column of axis gets from a row of the import.';

CREATE OR REPLACE FUNCTION streetgen._read_number(said text, read_as text, unit text, low float8, high float8)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN streetgen._within(CASE read_as WHEN 'metres' THEN streetgen._metres(said, coalesce(unit, 'm'))
        WHEN 'kmh' THEN streetgen._kmh(said, coalesce(unit, 'km/h'))
        WHEN 'count' THEN CASE WHEN said ~ '^\s*[-+]?\d+([.,]0*)?\s*$' THEN streetgen._number(said) END
        ELSE streetgen._number(said) END, low, high);
COMMENT ON FUNCTION streetgen._read_number(text, text, text, float8, float8) IS
    'A text of a source as a number within its bounds, read as metres, kmh, count (a whole number) or number; NULL '
    'where it is none.';

CREATE OR REPLACE FUNCTION streetgen._read_word(said text, read_as text, unit text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN btrim(said) = '' THEN NULL
        WHEN read_as = 'text' THEN said
        WHEN read_as = 'width' THEN streetgen._metres_by_lane(said, coalesce(unit, 'm'))
        WHEN read_as = 'parking' THEN substring(btrim(said) FROM streetgen._parking_pattern())
        WHEN read_as = 'strips' THEN substring(btrim(said) FROM streetgen._strips_pattern())
        WHEN read_as = 'yes_or_no' THEN CASE WHEN lower(btrim(said)) IN ('yes', 'true', 't', '1') THEN 'yes'
            WHEN lower(btrim(said)) IN ('no', 'false', 'f', '0') THEN 'no' END
        WHEN read_as = 'sides' THEN CASE WHEN lower(btrim(said)) IN ('left', 'right', 'both')
            THEN lower(btrim(said)) END
        WHEN read_as <> 'direction' THEN CASE WHEN streetgen.is_lane_list(btrim(said), read_as) THEN btrim(said) END
        WHEN lower(btrim(said)) IN ('both', '0') THEN 'both'
        WHEN lower(btrim(said)) IN ('direct', '1') THEN 'direct'
        WHEN lower(btrim(said)) IN ('reverse', '-1') THEN 'reverse' END;
COMMENT ON FUNCTION streetgen._read_word(text, text, text) IS
    'A text of a source as a column of axis holds it, read as text, direction, parking, strips, yes_or_no, sides or a '
    'list of lanes; NULL where it is none.';

CREATE OR REPLACE FUNCTION streetgen._expected(read_as text, low float8, high float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE read_as WHEN 'metres' THEN format('a length from %s to %s m', low, high)
        WHEN 'kmh' THEN format('a speed from %s to %s km/h', low, high)
        WHEN 'count' THEN format('a whole number from %s to %s', low, high)
        WHEN 'number' THEN format('a number from %s to %s', low, high)
        WHEN 'direction' THEN 'both, direct or reverse (0, 1 or -1)'
        WHEN 'yes_or_no' THEN 'yes or no (true or false, 1 or 0)'
        WHEN 'sides' THEN 'left, right or both'
        WHEN 'parking' THEN 'no, or a place such as on_kerb|parallel|2.2|8'
        WHEN 'strips' THEN 'strips such as verge 1.5|cycle_track 2'
        WHEN 'kind' THEN 'a list such as general|bus, an entry a lane'
        WHEN 'width' THEN 'a list such as 3.5|3, an entry a lane'
        WHEN 'turn' THEN 'a list such as left;through|right, an entry a lane'
        WHEN 'change' THEN 'a list such as yes|not_left, an entry a lane' ELSE 'a text' END $$;
COMMENT ON FUNCTION streetgen._expected(text, float8, float8) IS 'What a value of a source must be, in words.';

CREATE OR REPLACE FUNCTION streetgen._source_column(source regclass, wanted text) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    there constant text[] := ARRAY(SELECT attname::text FROM pg_attribute WHERE attrelid = source AND attnum > 0
        AND NOT attisdropped ORDER BY attnum);
    found constant text[] := ARRAY(SELECT name FROM unnest(there) name
        WHERE lower(name) = lower(wanted) ORDER BY name);
BEGIN
    IF wanted = ANY (there) THEN
        RETURN wanted;
    ELSIF cardinality(found) > 1 THEN
        RAISE EXCEPTION 'table % has several columns "%"', source, wanted USING ERRCODE = '22023',
            HINT = 'Name one of them as it is written: ' || array_to_string(found, ', ') || '.';
    ELSIF found = '{}' THEN
        RAISE EXCEPTION 'table % has no column "%"', source, wanted USING ERRCODE = '42703',
            HINT = 'It has ' || array_to_string(there, ', ') || '.';
    END IF;
    RETURN found[1];
END $$;
COMMENT ON FUNCTION streetgen._source_column(regclass, text) IS
    'The column of a table of this name, else the one of this name in other cases. None: 42703; several: 22023.';

CREATE OR REPLACE FUNCTION streetgen._mapping_entries(source regclass, mapping jsonb) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    entries jsonb := '{}';
    target text;
    entry jsonb;
    odd text;
BEGIN
    IF jsonb_typeof(mapping) <> 'object' THEN
        RAISE EXCEPTION 'the mapping is a %, expected an object', jsonb_typeof(mapping) USING ERRCODE = '22023',
            HINT = 'For example {"geom": "the_geom", "width": "largeur", "level": {"value": 0}}.';
    END IF;
    FOR target, entry IN SELECT * FROM jsonb_each('{"geom": "geom"}' || mapping)
        WHERE jsonb_typeof(value) <> 'null' LOOP
        IF target NOT IN (SELECT name FROM streetgen._axis_input() UNION ALL VALUES ('geom'), ('source_ref')) THEN
            RAISE EXCEPTION 'the mapping names "%", which is no column of axis to fill', target
                USING ERRCODE = '22023', HINT = 'geom, ' || (SELECT string_agg(name, ', ')
                    FROM streetgen._axis_input()) || ' or source_ref';
        END IF;
        IF jsonb_typeof(entry) = 'string' THEN
            entry := jsonb_build_object('column', entry);
        ELSIF jsonb_typeof(entry) <> 'object' OR NOT (CASE WHEN entry ? 'value' THEN target <> 'geom'
            ELSE coalesce(jsonb_typeof(entry -> 'column') = 'string', false) END) THEN
            RAISE EXCEPTION 'the mapping of "%" is %, expected a column name or {"value": …}', target, entry
                USING ERRCODE = '22023',
                HINT = 'Or {"column": …, "unit": …, "values": {…}}. SQL is never evaluated.';
        END IF;
        SELECT key INTO odd FROM jsonb_object_keys(entry) key WHERE CASE key WHEN 'value' THEN entry ? 'column'
            WHEN 'column' THEN false WHEN 'unit' THEN target IN ('geom', 'source_ref')
            WHEN 'values' THEN target IN ('geom', 'source_ref') OR entry ? 'value' ELSE true END LIMIT 1;
        IF FOUND THEN
            RAISE EXCEPTION 'the mapping of "%" is %, in which "%" has no place', target, entry, odd
                USING ERRCODE = '22023', HINT = 'A "column" may have a "unit" and a list of "values", '
                    'a "value" may have a "unit".';
        ELSIF entry ? 'column' THEN
            entry := entry || jsonb_build_object('column', streetgen._source_column(source, entry ->> 'column'));
        END IF;
        entries := entries || jsonb_build_object(target, entry);
    END LOOP;
    IF NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = source AND attname = entries #>> '{geom,column}'
        AND atttypid = 'geometry'::regtype) THEN
        RAISE EXCEPTION 'column "%" of % is no geometry', entries #>> '{geom,column}', source
            USING ERRCODE = '22023', HINT = 'Map "geom" to the column that holds the lines.';
    END IF;
    RETURN entries;
END $$;
COMMENT ON FUNCTION streetgen._mapping_entries(regclass, jsonb) IS
    'A mapping as {"column": …} for each target, with a column that the source has, or {"value": …}; geom is '
    'column geom where the mapping does not mention it. Another one: 22023; a missing column: 42703.';

CREATE OR REPLACE FUNCTION streetgen._check_mapped_values(target text, read_as text, low float8, high float8,
    entry jsonb) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    unit constant text := entry ->> 'unit';
    odd jsonb;
BEGIN
    IF unit IS NOT NULL AND (CASE read_as WHEN 'kmh' THEN streetgen._kmh('1', unit)
        WHEN 'metres' THEN streetgen._metres('1', unit) WHEN 'width' THEN streetgen._metres('1', unit) END) IS NULL
        THEN
        RAISE EXCEPTION 'the mapping gives "%" the unit "%"', target, unit USING ERRCODE = '22023',
            HINT = CASE WHEN read_as = 'kmh' THEN 'Speeds are in km/h, mph, kn or m/s.'
                WHEN read_as IN ('metres', 'width') THEN 'Lengths are in m, dm, cm, ft, us-ft, yd or in.'
                ELSE 'Lengths and speeds alone have units.' END;
    ELSIF entry ? 'values' AND (jsonb_typeof(entry -> 'values') <> 'object' OR entry -> 'values' = '{}') THEN
        RAISE EXCEPTION 'the values of "%" are %, expected an object', target, entry -> 'values'
            USING ERRCODE = '22023',
            HINT = 'For example {"column": "ONEWAY", "values": {"FT": 1, "TF": -1, "B": 0}}.';
    END IF;
    SELECT value INTO odd
        FROM (SELECT entry -> 'value' AS value UNION ALL SELECT jsonb_path_query(entry, '$.values.*')) v
        WHERE btrim(value #>> '{}') <> '' AND CASE WHEN low IS NULL
            THEN streetgen._read_word(value #>> '{}', read_as, unit) IS NULL
            ELSE streetgen._read_number(value #>> '{}', read_as, unit, low, high) IS NULL END LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'the mapping gives "%" the value %, expected %', target, odd,
            streetgen._expected(read_as, low, high) USING ERRCODE = '22023', HINT = 'null is unknown.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_mapped_values(text, text, float8, float8, jsonb) IS
    'Raises 22023 where the unit or a value that a mapping gives a column of axis does not fit it.';

CREATE OR REPLACE FUNCTION streetgen._mapped(source regclass, mapping jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    entries constant jsonb := streetgen._mapping_entries(source, mapping);
    target record;
    entry jsonb;
    said text;
    meant text;
    label text := '''number '' || row_number() OVER ()';
    expressions text[] := ARRAY[format('%I AS geom', entries #>> '{geom,column}')];
    unread text[] := '{}';
BEGIN
    -- No import changes a column that the mapping does not mention.
    FOR target IN SELECT * FROM streetgen._axis_input() i WHERE entries ? i.name LOOP
        entry := entries -> target.name;
        PERFORM streetgen._check_mapped_values(target.name, target.read_as, target.low, target.high, entry);
        said := CASE WHEN entry ? 'value' THEN quote_nullable(entry ->> 'value')
            WHEN entry ? 'values' THEN format('%L::jsonb ->> btrim(%I::text)', entry -> 'values', entry ->> 'column')
            ELSE format('%I::text', entry ->> 'column') END;
        meant := CASE WHEN target.low IS NULL
            THEN format('streetgen._read_word(%s, %L, %L)', said, target.read_as, entry ->> 'unit')
            ELSE format('streetgen._read_number(%s, %L, %L, %L, %L)::%s', said, target.read_as, entry ->> 'unit',
                target.low, target.high, target.type) END;
        expressions := expressions || format('%s AS %I', meant, CASE target.name WHEN 'kind' THEN 'class'
            ELSE target.name END);
        IF entry ? 'values' THEN
            unread := unread || format('CASE WHEN btrim(%1$I::text) <> '''' AND NOT %2$L::jsonb ? btrim(%1$I::text) '
                'THEN %3$L || left(btrim(%1$I::text), 40) || ''"'' END', entry ->> 'column', entry -> 'values',
                target.name || ' "');
        ELSIF entry ? 'column' AND target.read_as = 'direction' THEN
            unread := unread || format('CASE WHEN btrim(%1$I::text) <> '''' AND %2$s IS NULL '
                'THEN %3$L || left(btrim(%1$I::text), 40) || ''"'' END', entry ->> 'column', meant, 'direction "');
        ELSIF entry ? 'column' AND target.read_as <> 'text' THEN
            unread := unread || format('CASE WHEN btrim(%I::text) <> '''' AND %s IS NULL THEN %L END',
                entry ->> 'column', meant, target.name);
        END IF;
    END LOOP;
    IF entries #> '{source_ref,column}' IS NULL THEN
        -- A row without a source_ref is known by its place.
        expressions := expressions || format('%L::text AS source_ref', entries #>> '{source_ref,value}');
    ELSE
        expressions := expressions || format('%I::text AS source_ref', entries #>> '{source_ref,column}');
        label := format('coalesce(%I::text, %s)', entries #>> '{source_ref,column}', label);
    END IF;
    RETURN format('%s, %s AS label, NULL::text AS left_out, array_remove(ARRAY[%s]::text[], NULL) AS unread',
        array_to_string(expressions, ', '), label, array_to_string(unread, ', '));
END $$;
COMMENT ON FUNCTION streetgen._mapped(regclass, jsonb) IS
    'The columns of the import from those of a source, as SQL, by a checked mapping; a value that means nothing is '
    'NULL and unread.';
