-- Edit views: what a plain GIS user writes to. Each shows what is there and turns an edit into a change of axes or
-- overrides.

CREATE OR REPLACE FUNCTION streetgen._edit_view(model name, srid integer)
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN QUERY EXECUTE format('SELECT v.name, v.description, v.columns, streetgen._fill_template(v.query, $1), '
        'v.subject FROM (%s) v', streetgen._rows_of_rooms('edit_view'))
        USING jsonb_build_object('model', quote_ident(model), 'name', quote_literal(model), 'srid', srid);
END $$;
COMMENT ON FUNCTION streetgen._edit_view(name, integer) IS
    'The edit views of a model, from functions _ROOM_edit_view: their comments, those of their columns, and their '
    'queries, in which {model} is the schema, {name} its name as text and {srid} the reference.';

CREATE OR REPLACE FUNCTION streetgen._direction_from(line geometry, which text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- Bound when made, and thus inlined.
    BEGIN ATOMIC
        SELECT pi() / 2 - CASE which WHEN 'start'
            THEN ST_Azimuth(ST_StartPoint(line), ST_LineInterpolatePoint(line, 1 / greatest(ST_Length2D(line), 1)))
                                     ELSE ST_Azimuth(ST_EndPoint(line),
                                         ST_LineInterpolatePoint(line, 1 - 1 / greatest(ST_Length2D(line), 1))) END;
    END;
COMMENT ON FUNCTION streetgen._direction_from(geometry, text) IS
    'Direction in which a line leaves its start or end, over 1 m: radians counter-clockwise from the east.';

CREATE OR REPLACE FUNCTION streetgen._on_side(place geometry, node geometry, of_a float8, of_b float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Distance(place, node) <= 0.001
        OR to_place - 2 * pi() * floor(to_place / (2 * pi())) <= to_b - 2 * pi() * floor(to_b / (2 * pi()))
    FROM (SELECT pi() / 2 - ST_Azimuth(node, place) - of_a AS to_place, of_b - of_a AS to_b) t
    $$;
COMMENT ON FUNCTION streetgen._on_side(geometry, geometry, float8, float8) IS
    'Whether a place lies at a node, within 1 mm, or beside it counter-clockwise from one direction to the other '
    '(radians).';

CREATE OR REPLACE FUNCTION streetgen._make_edit_view(model name, view name, query text, description text,
    columns text[], called text, purpose text) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- By its registry the view hangs on the extension: both go together.
    EXECUTE format('CREATE OR REPLACE VIEW %1$s WITH (security_invoker = true) AS SELECT * FROM (%2$s) v '
        'WHERE EXISTS (SELECT FROM streetgen.model); COMMENT ON VIEW %1$s IS %3$L; CREATE OR REPLACE TRIGGER edit '
        'INSTEAD OF INSERT OR UPDATE OR DELETE ON %1$s FOR EACH ROW EXECUTE FUNCTION %4$s(); '
        'COMMENT ON TRIGGER edit ON %1$s IS %5$L', format('%I.%I', model, view), query, description, called, purpose);
    EXECUTE (SELECT string_agg(format('COMMENT ON COLUMN %I.%I.%I IS %L', model, view, attname, columns[attnum]), '; ')
        FROM pg_attribute WHERE attrelid = format('%I.%I', model, view)::regclass AND attnum > 0);
END $$;
COMMENT ON FUNCTION streetgen._make_edit_view(name, name, text, text, text[], text, text) IS
    'Makes a view that is edited, again and again: its query, its comment and those of its columns, and the function '
    'that its trigger calls, with what that is for.';

CREATE OR REPLACE FUNCTION streetgen._make_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._make_edit_view(model, v.name::name, v.query, v.description, v.columns,
            format('streetgen.%I', '_edit_' || replace(v.name, '_editing', '')),
            'Turns an edit into a change of axes or overrides')
        FROM streetgen.model m, streetgen._edit_view(m.name, m.srid) v, unnest(streetgen._subjects(model)) computed
        WHERE m.name = model AND v.subject = computed;
END $$;
COMMENT ON FUNCTION streetgen._make_edit_views(name) IS
    'Makes the edit views of a model and their triggers, again and again.';

CREATE OR REPLACE FUNCTION streetgen._grant_views(model name, views name[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    held record;
BEGIN
    FOR held IN SELECT CASE grantee WHEN 0 THEN 'PUBLIC' ELSE grantee::regrole::text END AS role,
            string_agg(DISTINCT privilege_type, ', ') AS privileges
        FROM pg_class c, aclexplode(c.relacl) WHERE c.oid = format('%I.axis', model)::regclass
            AND grantee <> c.relowner AND privilege_type IN ('SELECT', 'INSERT', 'UPDATE', 'DELETE') GROUP BY grantee
    LOOP
        EXECUTE (SELECT string_agg(format('GRANT %s ON %I.%I TO %s', held.privileges, model, view, held.role), '; ')
            FROM unnest(views) view);
        EXECUTE format('GRANT SELECT ON %1$I.edit_log, %1$I.override_place TO %2$s', model, held.role);
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._grant_views(name, name[]) IS
    'Who may read or write the axes of a model may do so with these views, and read its log.';

CREATE OR REPLACE FUNCTION streetgen._grant_edit_views(model name) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._grant_views(model, ARRAY(SELECT name FROM streetgen._edit_view('m', 0)
        WHERE subject = ANY (streetgen._subjects(model)))::name[]) $$;
COMMENT ON FUNCTION streetgen._grant_edit_views(name) IS
    'Who may read or write the axes of a model may do so with its edit views.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_number(subject text, value float8, minimum float8, maximum float8,
    unit text, way_out text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF NOT value BETWEEN minimum AND maximum THEN
        PERFORM streetgen._refuse('22023', format('%s cannot be %s', subject, value),
            detail => concat_ws(' ', 'Expected', minimum, 'to', maximum, unit) || '.', hint => way_out);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_number(text, float8, float8, float8, text, text) IS
    'Raises 22023 for a value of an edit beyond its range, or NaN; NULL passes.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_word(subject text, value text, input regclass, attribute name)
    RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    words constant text[] := ARRAY(SELECT w[1] FROM pg_constraint c JOIN pg_attribute a ON attrelid = conrelid
            AND conkey = ARRAY[attnum], regexp_matches(pg_get_expr(conbin, conrelid), '''([^'']*)''::text', 'g') w
        WHERE conrelid = input AND contype = 'c' AND attname = attribute);
BEGIN
    -- The comment of the constraint is for people.
    IF words <> '{}' AND value <> ALL (words) THEN
        PERFORM streetgen._refuse('23514', format('the %s of %s cannot be %s', attribute, subject, to_json(value)),
            detail => format('Expected %s.', (SELECT r.expected FROM streetgen._input_rule(input, attribute) r)),
            hint => 'NULL takes back what was decided by hand.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_word(text, text, regclass, name) IS
    'Raises 23514 for a word of an edit that is none of those that a column of an override table takes, naming the row '
    'of the view; NULL passes.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_geometry(subject text, geom geometry) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF geom IS NULL OR ST_IsEmpty(geom) THEN
        PERFORM streetgen._refuse('22023', format('%s has no place', subject),
            detail => 'Its geometry is NULL or empty.', hint => 'Draw it again, or undo the edit.');
    ELSIF EXISTS (SELECT FROM ST_DumpPoints(geom) p
                  WHERE NOT (ST_X(p.geom) BETWEEN -1e12 AND 1e12 AND ST_Y(p.geom) BETWEEN -1e12 AND 1e12
                      AND coalesce(ST_Z(p.geom) BETWEEN -1e12 AND 1e12, true))) THEN
        PERFORM streetgen._refuse('22023', format('%s has a coordinate that is no place', subject),
            detail => 'A coordinate is NaN, infinite or beyond 1e12.', hint => 'Draw it again, or undo the edit.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_geometry(text, geometry) IS
    'Raises 22023 for a geometry of an edit that is NULL, empty or not finite.';

CREATE OR REPLACE FUNCTION streetgen._check_edit_line(subject text, line geometry, tolerance float8) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._check_edit_geometry(subject, line);
    IF ST_Length2D(line) <= tolerance OR NOT EXISTS (SELECT FROM ST_DumpPoints(line) p
        WHERE NOT ST_DWithin(p.geom, ST_StartPoint(line), tolerance)) THEN
        PERFORM streetgen._refuse('22023', format('%s would collapse to a point', subject),
            detail => format('It would stay within the tolerance of %s m.', tolerance),
            hint => 'Put its points farther apart, or delete the axis.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_edit_line(text, geometry, float8) IS
    'Raises 22023 for a line of an edit that is NULL, empty, not finite or within the tolerance of its start.';

CREATE OR REPLACE FUNCTION streetgen._refuse_edit(relation name, operation text, way_out text) RETURNS void
    LANGUAGE plpgsql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._refuse('0A000', format('%s of %s is not possible', operation, relation),
        detail => 'Its rows are computed from axes and overrides.', hint => way_out);
END $$;
COMMENT ON FUNCTION streetgen._refuse_edit(name, text, text) IS
    'Raises 0A000 for an edit that means nothing, with the way to go instead.';

CREATE OR REPLACE FUNCTION streetgen._edited_row(view regclass, former anyelement, edited anyelement, editable name[],
    way_out text DEFAULT NULL) RETURNS anyelement
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns constant name[] := ARRAY(SELECT attname FROM pg_attribute WHERE attrelid = view AND attnum > 0
        ORDER BY attnum);
    key text;
    fixed text;
    emptied boolean;
BEGIN
    EXECUTE format('SELECT ($1).%I::text, concat_ws('', '', %s), %s', columns[1],
        (SELECT string_agg(format('CASE WHEN ($1).%1$I IS DISTINCT FROM ($2).%1$I THEN %1$L END', c), ', ')
            FROM unnest(columns) c WHERE c <> ALL (editable)),
        CASE WHEN 'by_hand' = ANY (editable) THEN '($2).by_hand IS NULL' ELSE 'false' END)
        INTO key, fixed, emptied USING former, edited;
    IF fixed <> '' THEN
        PERFORM streetgen._refuse('0A000', format('the %s of %s %s cannot be changed', fixed,
                (SELECT replace(replace(relname, '_editing', ''), '_', ' ') FROM pg_class WHERE oid = view), key),
            detail => 'It is a key, or computed.',
            hint => concat_ws(' ', 'Only', nullif(array_to_string(editable[:cardinality(editable) - 1], ', '), '')
                    || ' and',
                editable[cardinality(editable)], 'can be changed.', way_out));
    END IF;
    -- An empty by_hand means that nothing is decided.
    RETURN CASE WHEN emptied THEN jsonb_populate_record(edited, '{"by_hand": false}') ELSE edited END;
END $$;
COMMENT ON FUNCTION streetgen._edited_row(regclass, anyelement, anyelement, name[], text) IS
    'The row of an edit view as an UPDATE wants it, by_hand NULL as false. A change of the key or of what is computed: '
    '0A000, naming row and columns, those that can be changed, and the way out.';

CREATE OR REPLACE FUNCTION streetgen._edit_axis_of(model name, subject text, edge bigint) RETURNS record
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT e.*, ST_Force2D(a.geom) AS axis FROM edge e JOIN axis a USING (axis_id) WHERE edge_id = edge INTO place;
    IF place.edge_id IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s lies on an axis that is gone', subject),
            detail => format('Edge %s has no axis any more.', edge),
            hint => format('Refresh the layer; if it is still there, SELECT * FROM streetgen.generate(%L).', model));
    END IF;
    RETURN place;
END $$;
COMMENT ON FUNCTION streetgen._edit_axis_of(name, text, bigint) IS
    'The edge of what is edited, with the line of its axis; 22023 where the axis is gone.';
