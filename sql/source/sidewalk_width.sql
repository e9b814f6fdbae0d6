-- Widths of sidewalks from a table of their own, such as a survey of accessibility.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_width_query(source regclass, mapping jsonb) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    word text;
    named text;
    odd constant text := coalesce(mapping ->> 'odd_side', 'left');
    sides jsonb := jsonb_build_object('left', mapping -> 'left', 'right', mapping -> 'right');
BEGIN
    FOR word, named IN SELECT * FROM jsonb_each_text(mapping) LOOP
        IF word NOT IN ('source_ref', 'left', 'right', 'odd', 'even', 'odd_side') THEN
            RAISE EXCEPTION 'the mapping names "%"', word USING ERRCODE = '22023',
                HINT = 'Its words are source_ref, left, right, odd, even and odd_side.';
        ELSIF word = 'odd_side' AND named NOT IN ('left', 'right') THEN
            RAISE EXCEPTION 'odd_side is "%", expected left or right', named USING ERRCODE = '22023',
                HINT = 'It is the side of the odd house numbers, seen along the axes.';
        ELSIF word <> 'odd_side' THEN
            PERFORM streetgen._source_column(source, named);
        END IF;
    END LOOP;
    IF mapping ?| '{odd,even}' THEN
        IF mapping ?| '{left,right}' THEN
            RAISE EXCEPTION 'the mapping names both left or right and odd or even' USING ERRCODE = '22023',
                HINT = 'Name the sides in one of the two ways.';
        END IF;
        sides := jsonb_build_object(odd, mapping -> 'odd',
            CASE odd WHEN 'left' THEN 'right' ELSE 'left' END, mapping -> 'even');
    END IF;
    IF mapping ->> 'source_ref' IS NULL OR coalesce(sides ->> 'left', sides ->> 'right') IS NULL THEN
        RAISE EXCEPTION 'the mapping lacks source_ref or both sides' USING ERRCODE = '22023',
            HINT = 'For example {"source_ref": "id_arc", "odd": "width_odd", "even": "width_even"}.';
    END IF;
    RETURN (SELECT string_agg(format('SELECT %I::text AS source_ref, %L AS side, %I::text AS said FROM %s',
        streetgen._source_column(source, mapping ->> 'source_ref'), side, streetgen._source_column(source, name),
        source), ' UNION ALL ')
        FROM jsonb_each_text(sides) s(side, name) WHERE name IS NOT NULL);
END $$;
COMMENT ON FUNCTION streetgen._sidewalk_width_query(regclass, jsonb) IS
    'The query of a table of widths by a checked mapping: source_ref, side (left or right) and what is said.';

CREATE OR REPLACE FUNCTION streetgen._take_sidewalk_widths(source regclass, mapping jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    twin text;
BEGIN
    EXECUTE 'CREATE TEMPORARY TABLE _sidewalk_width ON COMMIT DROP AS SELECT s.*, NULL::text AS fate, '
        'streetgen._metres(said) AS width FROM ('
        || streetgen._sidewalk_width_query(source, mapping) || ') s WHERE said IS NOT NULL';
    SELECT source_ref INTO twin FROM pg_temp._sidewalk_width GROUP BY source_ref, side
        HAVING count(*) > 1 ORDER BY 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'table % has several rows with source_ref %', source, coalesce(quote_literal(twin), 'NULL')
            USING ERRCODE = '22023', HINT = 'Leave one row for each axis, or import from a view that does.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._take_sidewalk_widths(regclass, jsonb) IS
    'Copies the widths of a table, by a checked mapping, to where the import reads them: a row for each side that it '
    'speaks of. Several rows of one source_ref: 22023.';

CREATE OR REPLACE FUNCTION streetgen.import_sidewalk_widths(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    wins text;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_model(model),
        streetgen._check_given('source', source::text, 'mapping', mapping::text),
        streetgen._take_sidewalk_widths(source, mapping);
    wins := streetgen._delivery_wins(model);
    WITH bound AS (SELECT max(value::float8) FILTER (WHERE name = 'sidewalk_width_minimal') AS low,
        max(value::float8) FILTER (WHERE name = 'sidewalk_width_maximal') AS high FROM setting)
    UPDATE pg_temp._sidewalk_width w SET fate = CASE
        WHEN width IS NULL OR width < 0 THEN 'no width, left out'
        WHEN NOT EXISTS (SELECT FROM axis a WHERE split_part(a.source_ref, '/', 1) = w.source_ref)
            THEN 'no axis of this source_ref, left out'
        WHEN width > 0 AND width < low THEN 'narrower than sidewalk_width_minimal, left out'
        WHEN width > high THEN 'wider than sidewalk_width_maximal, left out'
        WHEN width = 0 THEN 'of zero: no sidewalk' ELSE 'taken' END FROM bound;
    -- As any delivery: what is by hand stays where this table says as before, or where setting delivery_wins is hand.
    WITH side AS MATERIALIZED (
        SELECT a.axis_id, a.source, a.source_ref, 'sidewalk_' || w.side AS name, w.width AS wanted,
            d.said IS NOT NULL AS known,
            CASE w.side WHEN 'left' THEN a.sidewalk_left ELSE a.sidewalk_right END AS there,
            (d.said ->> ('sidewalk_' || w.side))::float8 AS before
        FROM pg_temp._sidewalk_width w JOIN axis a ON split_part(a.source_ref, '/', 1) = w.source_ref
        LEFT JOIN delivered d ON (d.relation, d.source, d.source_ref) = ('axis', a.source, a.source_ref)
        WHERE w.fate IN ('taken', 'of zero: no sidewalk')),
    judged AS MATERIALIZED (
        SELECT *, known AND there IS DISTINCT FROM before AND there IS DISTINCT FROM wanted AS by_hand FROM side),
    conflict AS (
        INSERT INTO open_conflict (relation, row_id, column_name, source, source_ref, by_hand, source_old, source_new,
            stands)
        SELECT 'axis', axis_id, name, source, source_ref, there, before, wanted, wins FROM judged
        WHERE by_hand AND before IS DISTINCT FROM wanted
        ON CONFLICT (relation, row_id, column_name) DO UPDATE SET source_new = excluded.source_new),
    noted AS (
        UPDATE delivered d SET said = d.said || s.said
        FROM (SELECT source, source_ref, jsonb_object_agg(name, wanted) AS said FROM judged
            GROUP BY source, source_ref) s
        WHERE (d.relation, d.source, d.source_ref) = ('axis', s.source, s.source_ref))
    UPDATE axis a SET sidewalk_left = coalesce(w.on_left, a.sidewalk_left),
        sidewalk_right = coalesce(w.on_right, a.sidewalk_right)
    FROM (SELECT axis_id, max(wanted) FILTER (WHERE name = 'sidewalk_left') AS on_left,
            max(wanted) FILTER (WHERE name = 'sidewalk_right') AS on_right
        FROM judged WHERE by_hand IS NOT TRUE OR wins = 'source' AND before IS DISTINCT FROM wanted
        GROUP BY axis_id) w
    WHERE a.axis_id = w.axis_id AND (a.sidewalk_left, a.sidewalk_right)
        IS DISTINCT FROM (coalesce(w.on_left, a.sidewalk_left), coalesce(w.on_right, a.sidewalk_right));
    RETURN QUERY SELECT 'in conflict', column_name, count(*), array_agg(source_ref ORDER BY source_ref)
        FROM open_conflict WHERE relation = 'axis' AND column_name LIKE 'sidewalk%'
        GROUP BY column_name ORDER BY column_name;
    RETURN QUERY SELECT w.fate, w.side, pg_catalog.count(*), CASE WHEN w.fate LIKE '%left out'
        THEN array_agg(w.source_ref ORDER BY w.source_ref) END
        FROM pg_temp._sidewalk_width w GROUP BY w.fate, w.side ORDER BY w.fate DESC, w.side;
    DROP TABLE pg_temp._sidewalk_width;
END $$;
COMMENT ON FUNCTION streetgen.import_sidewalk_widths(name, regclass, jsonb) IS
    'Fills axis.sidewalk_left and sidewalk_right from a table of widths (metres), by source_ref, also of the parts of '
    'a line (12/1, 12/2). mapping: source_ref, and left and right or odd and even (the sides of the house numbers), '
    'each a column of the table; odd_side: left or right, where the odd numbers stand along the axis, left if not '
    'said. A width that is NULL changes nothing, 0 is no sidewalk. Each other width is taken or reported by '
    'source_ref: below setting sidewalk_width_minimal, above sidewalk_width_maximal, no number, or of no axis. class '
    'is the side. A width by hand stays '
    'where this table says as before; where it says another, setting delivery_wins decides and view import_conflict '
    'shows it. Several rows of one source_ref, a bad mapping: 22023; no such column: 42703; no such model: 3F000.';
