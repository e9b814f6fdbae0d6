-- Rows of a design by hand: a view of each table turns an edit into a row by hand, and the road follows.

CREATE OR REPLACE FUNCTION streetgen._design_columns(model name, relation name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(attname ORDER BY attnum) FROM pg_attribute
        WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0 AND NOT attisdropped
            AND attgenerated = '' $$;
COMMENT ON FUNCTION streetgen._design_columns(name, name) IS 'The columns of a table of a design that are written.';

CREATE OR REPLACE FUNCTION streetgen._place_column(model name, relation name) RETURNS name
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT attname FROM pg_attribute JOIN pg_type t ON t.oid = atttypid
        WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0 AND NOT attisdropped
            AND typname = 'geometry' $$;
COMMENT ON FUNCTION streetgen._place_column(name, name) IS
    'The column of places of a table of a design; NULL: it has none.';

CREATE OR REPLACE FUNCTION streetgen._editable_columns(model name, relation name) RETURNS name[]
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(c ORDER BY nth)
        FROM unnest(streetgen._design_columns(model, relation)) WITH ORDINALITY u(c, nth)
        WHERE c <> relation || '_id' AND c <> ALL (CASE relation
            WHEN 'design_link' THEN '{length,utilisation,benefit,cost,method,geom,town_a,town_b}'
            WHEN 'design_crossing' THEN '{abscissa,other_abscissa,geom}' WHEN 'grade_point' THEN '{geom}'
            WHEN 'structure' THEN '{geom}' ELSE '{}' END::name[]) $$;
COMMENT ON FUNCTION streetgen._editable_columns(name, name) IS
    'The columns of a table of a design that an edit may change: neither its key nor what is computed anew of a row '
    'by hand too.';

CREATE OR REPLACE FUNCTION streetgen._edit_default(model name, relation name, is_now jsonb) RETURNS jsonb
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    drawn boolean := false;
BEGIN
    PERFORM streetgen._use_model(model);
    IF relation = 'design_vertex' THEN
        SELECT EXISTS (SELECT FROM design_vertex WHERE design_link_id = ((is_now ->> 'design_link_id')::bigint)
            AND NOT rejected) INTO drawn;
    END IF;
    RETURN CASE WHEN drawn THEN jsonb_build_object('straight_in', coalesce((is_now ->> 'straight_in')::boolean, true),
            'straight_out', coalesce((is_now ->> 'straight_out')::boolean, true))
        WHEN relation = 'design_crossing' THEN '{"abscissa": -1, "other_abscissa": -1}' ELSE '{}' END;
END $$;
COMMENT ON FUNCTION streetgen._edit_default(name, name, jsonb) IS
    'What a row that is put in has where nothing is said: a vertex among others has straight sides, as they have; a '
    'crossing waits until its links are found to cross.';

CREATE OR REPLACE FUNCTION streetgen._refuse_value(model name, relation name, broken name, missing name, is_now jsonb,
    state text, message text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    subject constant text := concat_ws(' ', replace(relation, '_', ' '), is_now ->> (relation || '_id'));
    rule record;
BEGIN
    SELECT string_agg(attname, ', ' ORDER BY k.nth) AS columns, string_agg(coalesce(is_now ->> attname, 'NULL'), ', '
            ORDER BY k.nth) AS given, max(pg_get_expr(conbin, conrelid)) AS condition,
            bool_or(contype IN ('p', 'u')) AS taken, max(confrelid::regclass::text) AS other
        INTO rule FROM pg_constraint c, unnest(conkey) WITH ORDINALITY k(attnum, nth)
        JOIN pg_attribute a ON a.attnum = k.attnum
        WHERE conrelid = format('%I.%I', model, relation)::regclass AND a.attrelid = conrelid AND conname = broken;
    IF rule.columns IS NULL AND coalesce(missing, '') = '' THEN
        PERFORM streetgen._refuse(state, message);
    END IF;
    PERFORM streetgen._refuse(state,
        format('the %s of %s cannot be %s', coalesce(rule.columns, missing), subject, coalesce(rule.given, 'NULL')),
        detail => CASE WHEN rule.columns IS NULL THEN 'A value is needed.'
            WHEN rule.taken THEN format('Another row of %s has it.', relation)
            WHEN rule.condition IS NULL THEN format('There is no such row of %s.', rule.other)
            ELSE format('Expected: %s.', regexp_replace(regexp_replace(regexp_replace(rule.condition,
                '::(double precision|text|numeric)', '', 'g'), '= ANY \(ARRAY(\[.*\])\)', 'one of \1'),
                '[()]', '', 'g'))
            END, hint => 'Write another value, or leave the row as it is.', schema => model, relation => relation,
        attribute => coalesce(rule.columns, missing), rule => broken);
END $$;
COMMENT ON FUNCTION streetgen._refuse_value(name, name, name, name, jsonb, text, text) IS
    'Raises what a constraint of a table of a design refuses, with row, value, what is expected and the way out.';

CREATE OR REPLACE FUNCTION streetgen._check_ends(model name, relation name, is_now jsonb) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    first constant float8 := coalesce(is_now ->> 'start_abscissa', is_now ->> 'abscissa');
    last constant float8 := coalesce(is_now ->> 'end_abscissa', is_now ->> 'abscissa');
    length float8;
BEGIN
    PERFORM streetgen._use_model(model);
    IF relation NOT IN ('structure', 'grade_point') OR is_now @> '{"rejected": true}' OR is_now IS NULL THEN
        RETURN;
    END IF;
    SELECT max(e.abscissa + e.length) FROM alignment_element e
        WHERE design_link_id = (is_now ->> 'design_link_id')::bigint AND NOT rejected INTO length;
    -- A link without a road tells nothing yet.
    IF length IS NOT NULL AND NOT (first >= 0 AND last <= length + 0.001) THEN
        PERFORM streetgen._refuse('22023',
            format('the %s of link %s lies at %s m, and the link is %s m long', replace(relation, '_', ' '),
                is_now ->> 'design_link_id', concat_ws(' to ', first, nullif(last, first)), round(length::numeric, 3)),
            hint => format('Abscissas count from the first node of the link: expected 0 to %s.', floor(length)));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_ends(name, name, jsonb) IS
    'Raises 22023 for a structure or grade point of an edit that lies before or beyond its link.';

CREATE OR REPLACE FUNCTION streetgen._check_parabola(model name, relation name, point bigint) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    cut record;
BEGIN
    PERFORM streetgen._use_model(model);
    IF relation <> 'grade_point' THEN
        RETURN;
    END IF;
    SELECT p.radius, g.design_link_id, g.radius AS wish INTO cut FROM grade_point g,
        LATERAL streetgen._link_grade_points(model, g.design_link_id) p
        WHERE g.grade_point_id = point AND g.by_hand AND p.grade_point_id = point AND p.radius < g.radius - 0.001;
    IF cut IS NOT NULL THEN
        PERFORM streetgen._refuse('22023',
            format('the radius of grade point %s of link %s cannot be %s', point, cut.design_link_id, cut.wish),
            detail => format('There is room for a radius of %s m between the points beside it.', floor(cut.radius)),
            hint => 'Make the radius smaller, or move the points apart; NULL takes what there is room for.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_parabola(name, name, bigint) IS
    'Raises 22023 for an edit of a grade point whose radius has no room between those beside it.';

CREATE OR REPLACE FUNCTION streetgen._refuse_computed(model name, relation name, is_now jsonb) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    editable constant name[] := streetgen._editable_columns(model, relation);
    computed text;
BEGIN
    SELECT string_agg(c, ', ') FROM unnest(streetgen._design_columns(model, relation)) c
        WHERE c <> ALL (editable) AND c <> relation || '_id' AND is_now ->> c IS NOT NULL
            AND (relation, c) <> ('design_crossing', 'geom') INTO computed;
    IF computed IS NOT NULL THEN
        PERFORM streetgen._refuse('0A000',
            format('the %s of a new %s cannot be given', computed, replace(relation, '_', ' ')),
            detail => 'It is computed.', hint => format('Leave it empty; %s can be given.',
                array_to_string(editable, ', ')), schema => model, relation => relation, attribute => computed);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._refuse_computed(name, name, jsonb) IS
    'Raises 0A000 for a new row of a design that gives what is computed. The place of a crossing says which is meant.';

CREATE OR REPLACE FUNCTION streetgen._make_design_edit_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- With the rights of the owner of the model: an editor writes rows by hand, the rest follows.
    CREATE OR REPLACE FUNCTION _edit_design() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    DECLARE
        relation constant name := replace(TG_TABLE_NAME, '_editing', '');
        key constant name := relation || '_id';
        place constant name := streetgen._place_column(TG_TABLE_SCHEMA, relation);
        drawn geometry;
        broken name;
        missing name;
        at_table name;
        is_now jsonb;
        was jsonb;
        given name[];
        new_key bigint;
        became record;
    BEGIN
        IF TG_TABLE_SCHEMA <> current_schema() THEN
            PERFORM streetgen._require_model(TG_TABLE_SCHEMA);
        END IF;
        -- A place that is none is told before it is read as JSON.
        IF TG_OP <> 'DELETE' AND place IS NOT NULL THEN
            EXECUTE format('SELECT ($1).%I', place) INTO drawn USING NEW;
            PERFORM streetgen._check_edit_geometry(format('the %s of the %s', place, replace(relation, '_', ' ')),
                drawn)
                WHERE drawn IS NOT NULL;
        END IF;
        IF TG_OP = 'UPDATE' THEN
            NEW := streetgen._edited_row(TG_RELID, OLD, NEW, streetgen._editable_columns(TG_TABLE_SCHEMA, relation));
            IF NEW IS NOT DISTINCT FROM OLD THEN
                RETURN NEW;
            END IF;
        END IF;
        is_now := CASE WHEN TG_OP <> 'DELETE' THEN to_jsonb(NEW) END;
        was := CASE WHEN TG_OP <> 'INSERT' THEN to_jsonb(OLD) END;
        IF TG_OP = 'INSERT' THEN
            PERFORM streetgen._refuse_computed(TG_TABLE_SCHEMA, relation, is_now);
            NEW := jsonb_populate_record(NEW, streetgen._edit_default(TG_TABLE_SCHEMA, relation, is_now));
            is_now := to_jsonb(NEW);
        END IF;
        PERFORM streetgen._begin_design_edit(TG_TABLE_SCHEMA, relation, was, is_now);
        IF TG_OP = 'INSERT' THEN
            given := ARRAY(SELECT c FROM unnest(streetgen._design_columns(TG_TABLE_SCHEMA, relation)) c
                WHERE is_now ->> c IS NOT NULL AND c <> 'by_hand');
            EXECUTE format('INSERT INTO %I.%I (%s) SELECT %s RETURNING %I', TG_TABLE_SCHEMA, relation,
                (SELECT string_agg(quote_ident(c), ', ') FROM unnest(ARRAY['by_hand'::name] || given) c),
                concat_ws(', ', 'true', (SELECT string_agg(format('($1).%I', c), ', ') FROM unnest(given) c)), key)
                INTO new_key USING NEW;
        ELSIF TG_OP = 'UPDATE' THEN
            EXECUTE format('UPDATE %I.%I SET %s WHERE %I = ($2).%I', TG_TABLE_SCHEMA, relation,
                (SELECT string_agg(CASE c WHEN 'by_hand' THEN 'by_hand = '
                        || (is_now @> '{"by_hand": true}' OR was @> '{"by_hand": false}')
                    WHEN 'rejected' THEN 'rejected = ' || (is_now @> '{"rejected": true}'
                        AND (is_now @> '{"by_hand": true}' OR was @> '{"by_hand": false}'))
                    -- The radius that a point had where it was computed was not chosen for another place.
                    WHEN 'radius' THEN CASE WHEN relation = 'grade_point' AND is_now -> 'radius' = was -> 'radius'
                        AND was @> '{"by_hand": false}' THEN 'radius = NULL' ELSE 'radius = ($1).radius' END
                    ELSE format('%1$I = ($1).%1$I', c) END, ', ')
                FROM unnest(streetgen._design_columns(TG_TABLE_SCHEMA, relation)) c
                WHERE c IN ('by_hand', 'rejected') OR is_now -> c IS DISTINCT FROM was -> c
                    OR relation = 'grade_point' AND c = 'radius'), key, key) USING NEW, OLD;
        ELSIF (SELECT t.computed FROM streetgen._design_table() t WHERE t.relation = replace(TG_TABLE_NAME, '_editing',
            ''))
        THEN
            EXECUTE format('UPDATE %I.%I SET rejected = true, by_hand = true WHERE %I = ($1).%I', TG_TABLE_SCHEMA,
                relation, key, key) USING OLD;
        ELSE
            EXECUTE format('DELETE FROM %I.%I WHERE %I = ($1).%I', TG_TABLE_SCHEMA, relation, key, key) USING OLD;
        END IF;
        PERFORM streetgen._follow_design(TG_TABLE_SCHEMA, relation, coalesce(is_now, was));
        PERFORM streetgen._check_ends(TG_TABLE_SCHEMA, relation, is_now);
        PERFORM streetgen._check_parabola(TG_TABLE_SCHEMA, relation, coalesce(new_key, (is_now ->> key)::bigint));
        IF TG_OP = 'INSERT' THEN
            -- INSERT … RETURNING gives the row as it became, and QGIS shows it.
            EXECUTE format('SELECT * FROM %I.%I WHERE %I = $1', TG_TABLE_SCHEMA, TG_TABLE_NAME, key)
                INTO became USING new_key;
            RETURN became;
        END IF;
        RETURN CASE WHEN TG_OP = 'DELETE' THEN OLD ELSE NEW END;
    EXCEPTION WHEN check_violation OR not_null_violation OR foreign_key_violation OR unique_violation THEN
        GET STACKED DIAGNOSTICS broken = CONSTRAINT_NAME, missing = COLUMN_NAME, at_table = TABLE_NAME;
        IF broken = '' AND SQLSTATE <> '23502' THEN
            RAISE;
        END IF;
        PERFORM streetgen._refuse_value(TG_TABLE_SCHEMA, at_table, broken, missing, is_now, SQLSTATE, SQLERRM);
    END $body$;
    PERFORM streetgen._own_function(model, '_edit_design()', 'Turns an edit of a design into rows by hand');
    PERFORM streetgen._make_edit_view(model, (relation || '_editing')::name,
            format('SELECT %s FROM %I.%I', string_agg(quote_ident(c), ', ' ORDER BY n), model, relation),
            obj_description(shown, 'pg_class') || ', to be edited by hand: an edited row stays, a deleted one is '
                'rejected, and by_hand false takes either back',
            array_agg(col_description(shown, attnum) ORDER BY n), format('%I._edit_design', model),
            'Turns an edit into a row by hand')
        FROM (SELECT relation, format('%I.%I', model, relation)::regclass AS shown FROM streetgen._design_table()) d
            CROSS JOIN LATERAL unnest(streetgen._design_columns(model, relation)) WITH ORDINALITY u(c, n)
            JOIN pg_attribute ON (attrelid, attname) = (shown, c) GROUP BY relation, shown;
END $$;
COMMENT ON FUNCTION streetgen._make_design_edit_views(name) IS
    'Makes the views to edit a design by hand, and their trigger, again and again.';

CREATE OR REPLACE FUNCTION streetgen._grant_design_views(model name) RETURNS void
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._grant_views(model, ARRAY(SELECT (relation || '_editing')::name
            FROM streetgen._design_table())) WHERE streetgen._has_design(model) $$;
COMMENT ON FUNCTION streetgen._grant_design_views(name) IS
    'Who may read or write the axes of a model may do so with the editing views of its design.';

CREATE OR REPLACE FUNCTION streetgen._check_element_bend(was jsonb, is_now jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    subject constant text := 'alignment element ' || coalesce(is_now ->> 'alignment_element_id', 'that is new');
    a constant float8 := is_now ->> 'curvature_start';
    b constant float8 := is_now ->> 'curvature_end';
    -- The turns to both sides count: they are two where the curvature changes its sign.
    turn constant float8 := CASE WHEN a * b < 0 THEN (a * a + b * b) / (abs(a) + abs(b)) ELSE abs(a + b) END / 2
        * (is_now ->> 'length')::float8;
    changed constant text[] := ARRAY(SELECT c FROM unnest('{curvature_start,curvature_end,length}'::text[]) c
        WHERE is_now -> c IS DISTINCT FROM coalesce(was, '{}') -> c);
BEGIN
    PERFORM streetgen._check_edit_number(format('the %s of %s', bend, subject), (is_now ->> bend)::float8, -0.2, 0.2,
        '1/m', 'No road bends by a radius under 5 m.') FROM unnest(changed) bend WHERE bend <> 'length';
    IF turn > 2 * pi() AND changed <> '{}' THEN
        PERFORM streetgen._refuse('22023', format('%s would turn by %s degrees', subject, round(degrees(turn))),
            detail => 'An element turns by 360 degrees at most.',
            hint => 'Make it shorter, or its curvature smaller.');
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_element_bend(jsonb, jsonb) IS
    'Raises 22023 for an edit of an alignment element to a radius under 5 m, or to a turn beyond 360 degrees: coils '
    'have more chords and crossings than can be computed.';

CREATE OR REPLACE FUNCTION streetgen._check_order(model name, relation name, was jsonb, is_now jsonb) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    subject constant text := concat_ws(' ', 'the ' || replace(relation, '_', ' '), is_now ->> (relation || '_id'));
    own_id constant bigint := was ->> (relation || '_id');
    at constant float8 := is_now ->> 'ordinality';
    abscissa constant float8 := is_now ->> 'abscissa';
    beside record;
BEGIN
    IF is_now @> '{"rejected": true}' OR is_now -> 'ordinality' IS NOT DISTINCT FROM was -> 'ordinality'
        AND is_now -> 'abscissa' IS NOT DISTINCT FROM was -> 'abscissa'
    THEN
        RETURN;
    END IF;
    PERFORM streetgen._check_edit_number('the ordinality of ' || subject, at, -1e6, 1e6, NULL,
        'It is the place in the order of the link.');
    EXECUTE format('SELECT bool_or(ordinality = $3) AS taken, max(%1$s) FILTER (WHERE ordinality < $3) AS low, '
            'min(%1$s) FILTER (WHERE ordinality > $3) AS high FROM %2$I.%3$I WHERE design_link_id = $1 '
            'AND NOT rejected AND %4$I IS DISTINCT FROM $2',
        CASE relation WHEN 'alignment_element' THEN 'abscissa' ELSE 'NULL::float8' END, model, relation,
        relation || '_id') INTO beside USING (is_now ->> 'design_link_id')::bigint, own_id, at;
    IF beside.taken THEN
        PERFORM streetgen._refuse('23505', format('the ordinality of %s cannot be %s', subject, at),
            detail => format('Another row of %s has it on link %s.', relation, is_now ->> 'design_link_id'),
            hint => 'Take a number between those of the rows before and after.', schema => model,
            relation => relation, attribute => 'ordinality');
    END IF;
    PERFORM streetgen._check_edit_number('the abscissa of ' || subject, abscissa, coalesce(beside.low, 0),
        coalesce(beside.high, 1e7), 'm', 'Elements follow each other along the link.');
END $$;
COMMENT ON FUNCTION streetgen._check_order(name, name, jsonb, jsonb) IS
    'Raises 22023 for a vertex or element of an edit whose number in the order of its link is none, or whose abscissa '
    'is not between those of its neighbours; 23505 where another row has the number.';

CREATE OR REPLACE FUNCTION streetgen._begin_design_edit(model name, relation name, was jsonb, is_now jsonb)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    link constant bigint := coalesce(was, is_now) ->> 'design_link_id';
    released constant boolean := is_now @> '{"by_hand": false}' AND was @> '{"by_hand": true}';
    at constant float8 := was ->> 'ordinality';
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_one_build();
    LOCK TABLE design_link IN SHARE ROW EXCLUSIVE MODE;
    IF relation IN ('design_vertex', 'alignment_element') THEN
        PERFORM streetgen._check_order(model, relation, was, is_now);
    END IF;
    IF relation = 'alignment_element' THEN
        PERFORM streetgen._check_element_bend(was, is_now);
    ELSIF relation <> 'design_vertex' THEN
        RETURN;
    ELSIF released THEN
        UPDATE design_vertex SET straight_out = false WHERE design_vertex_id = (SELECT design_vertex_id
            FROM design_vertex WHERE design_link_id = link AND NOT rejected AND ordinality < at
            ORDER BY ordinality DESC LIMIT 1);
        UPDATE design_vertex SET straight_in = false WHERE design_vertex_id = (SELECT design_vertex_id
            FROM design_vertex WHERE design_link_id = link AND NOT rejected AND ordinality > at
            ORDER BY ordinality LIMIT 1);
    ELSE
        -- An edit of one vertex of a path keeps the others, which the editor has seen.
        UPDATE design_vertex SET by_hand = true, straight_in = true, straight_out = true
            WHERE design_link_id = link AND NOT by_hand;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._begin_design_edit(name, name, jsonb, jsonb) IS
    'Before an edit of a design: other edits and runs wait. A curvature of a radius under 5 m, a turn beyond '
    '360 degrees, or a place out of order: 22023; a number that another row has: 23505. An edit of a vertex makes all '
    'vertices of its link vertices by hand with straight sides; one that is taken back leaves the sides to its '
    'neighbours to the search.';

CREATE OR REPLACE FUNCTION streetgen._with_crossed(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    crossed bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT array_agg(l) FROM (SELECT unnest(links) AS l
        UNION SELECT design_link_id FROM design_crossing WHERE other_link_id = ANY (links)
        UNION SELECT other_link_id FROM design_crossing WHERE design_link_id = ANY (links)) f INTO crossed;
    RETURN crossed;
END $$;
COMMENT ON FUNCTION streetgen._with_crossed(name, bigint[]) IS 'Links of a design, and those that they cross.';

CREATE OR REPLACE FUNCTION streetgen._follow_design(model name, relation name, edited jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    followed bigint[];
    barred text;
BEGIN
    PERFORM streetgen._use_model(model);
    IF EXISTS (SELECT FROM streetgen._design_table() t WHERE t.relation = _follow_design.relation
        AND t.of_link) THEN
        -- The links that it crossed before, and those that it crosses now.
        followed := streetgen._with_crossed(model, ARRAY[(edited ->> 'design_link_id')::bigint]);
        PERFORM FROM streetgen._run_stages(model, '{paths,horizontal,vertical}', followed);
        PERFORM FROM streetgen._run_stages(model, '{paths,horizontal,vertical,structures,axes}',
            streetgen._with_crossed(model, followed));
        SELECT method FROM design_link WHERE design_link_id = ((edited ->> 'design_link_id')::bigint)
            AND method LIKE 'no_path%' INTO barred;
        IF barred IS NOT NULL THEN
            PERFORM streetgen._refuse('22023',
                format('link %s of the design would have no way: %s', edited ->> 'design_link_id', barred),
                hint => 'Move the vertex elsewhere, or give it straight sides.');
        END IF;
    ELSIF streetgen._setting_text(model, 'design_live') = 'on' THEN
        PERFORM FROM streetgen._run_stages(model, NULL, NULL);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._follow_design(name, name, jsonb) IS
    'After an edit of a design: a row of a link carries the link, and those that cross it, to axes and streets; of '
    'other tables this waits for streetgen.design, or not with setting design_live. A link that would have no way: '
    '22023.';
