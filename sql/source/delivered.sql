-- The last words of sources on each row, beside the rows as they are, and the conflicts that wait for somebody.

CREATE OR REPLACE FUNCTION streetgen._delivered_columns(relation text) RETURNS text[]
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE relation WHEN 'axis' THEN ARRAY(SELECT name FROM streetgen._axis_input())
        WHEN 'control_point' THEN '{kind,direction,marking,kerb,refuge}'
        WHEN 'turn_restriction' THEN '{from_axis,to_axis,kind,turn,except_kinds,via_axes,via_geom,to_geom}'
        WHEN 'footway' THEN '{kind,width,level,name}'::text[] || ARRAY(SELECT i.name FROM streetgen._footway_input() i)
        WHEN 'footway_kerb' THEN '{kerb}'
        WHEN 'rail_track' THEN '{kind,gauge,tracks,level,name}'
        WHEN 'street_area' THEN '{kind,level,name,surface,foot}'
        WHEN 'street_object' THEN '{type,orientation}' END || '{geom}' $$;
COMMENT ON FUNCTION streetgen._delivered_columns(text) IS
    'The columns of a table of a model that a delivery may fill: axis, control_point, turn_restriction, footway, '
    'footway_kerb, rail_track, street_area or street_object.';

CREATE OR REPLACE FUNCTION streetgen._row_json(relation regclass, alias text, columns text[] DEFAULT NULL) RETURNS text
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT format('to_jsonb((SELECT r FROM (SELECT %s) r))', string_agg(format(CASE atttypid
            WHEN 'geometry'::regtype THEN '%1$I.%2$I::text AS %2$I' ELSE '%1$I.%2$I' END, alias, attname), ', '
            ORDER BY attnum))
        FROM pg_attribute WHERE attrelid = relation AND attnum > 0 AND NOT attisdropped
            AND (columns IS NULL OR attname = ANY (columns)) $$;
COMMENT ON FUNCTION streetgen._row_json(regclass, text, text[]) IS
    'SQL that gives a row, or some columns of it, as jsonb with geometries as EWKB: those of PostGIS lose digits.';

CREATE OR REPLACE FUNCTION streetgen._make_source_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE VIEW import_conflict WITH (security_invoker = true) AS
    SELECT CASE relation WHEN 'axis' THEN row_id END AS axis_id, column_name, by_hand, source_old, source_new, stands,
        relation, row_id, source, source_ref FROM open_conflict;
    COMMENT ON VIEW import_conflict IS
        'Columns that both somebody by hand and a delivery of the source changed, until one is settled: the column '
        'gets the other value (not of an object), or streetgen.settle_conflict says whose holds';
    COMMENT ON COLUMN import_conflict.axis_id IS 'the axis; NULL: a row of another table';
    COMMENT ON COLUMN import_conflict.column_name IS 'its column; *: the whole row, deleted by hand or by the source';
    COMMENT ON COLUMN import_conflict.by_hand IS
        'the value by hand; geometry as EWKB; NULL: empty, or of *: deleted by hand';
    COMMENT ON COLUMN import_conflict.source_old IS
        'what the source said when that was edited; of *: what it said otherwise';
    COMMENT ON COLUMN import_conflict.source_new IS
        'what the source says now; NULL: nothing, or of *: deleted by the source';
    COMMENT ON COLUMN import_conflict.stands IS 'hand or source: whose value the row has, by setting delivery_wins';
    COMMENT ON COLUMN import_conflict.relation IS
        'the table of the row: axis, control_point, turn_restriction, footway, footway_kerb, rail_track, '
        'street_area or street_object';
    COMMENT ON COLUMN import_conflict.row_id IS 'the key of the row';
    COMMENT ON COLUMN import_conflict.source IS 'the source, as in that table';
    COMMENT ON COLUMN import_conflict.source_ref IS 'its identity in the source';
END $$;
COMMENT ON FUNCTION streetgen._make_source_views(name) IS 'Makes view import_conflict of a model.';

CREATE OR REPLACE FUNCTION streetgen._make_source_functions(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation name;
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE OR REPLACE FUNCTION _settle_conflicts() RETURNS trigger
        LANGUAGE plpgsql VOLATILE SECURITY DEFINER SET search_path FROM CURRENT
        AS $body$
    #variable_conflict use_column
    DECLARE
        gone bigint[];
        said jsonb;
    BEGIN
        IF TG_OP = 'TRUNCATE' THEN
            DELETE FROM open_conflict WHERE relation = TG_TABLE_NAME;
            DELETE FROM delivered WHERE relation = TG_TABLE_NAME;
            DELETE FROM axis_route WHERE TG_TABLE_NAME = 'axis';
            RETURN NULL;
        ELSIF NOT EXISTS (SELECT FROM open_conflict) THEN
            RETURN NULL;
        ELSIF TG_OP = 'DELETE' THEN
            IF TG_TABLE_NAME = 'axis' THEN
                gone := ARRAY(SELECT axis_id FROM before);
            ELSIF TG_TABLE_NAME = 'control_point' THEN
                gone := ARRAY(SELECT control_point_id FROM before);
            ELSIF TG_TABLE_NAME = 'turn_restriction' THEN
                gone := ARRAY(SELECT turn_restriction_id FROM before);
            ELSIF TG_TABLE_NAME = 'footway' THEN
                gone := ARRAY(SELECT footway_id FROM before);
            ELSIF TG_TABLE_NAME = 'footway_kerb' THEN
                gone := ARRAY(SELECT footway_kerb_id FROM before);
            ELSIF TG_TABLE_NAME = 'street_area' THEN
                gone := ARRAY(SELECT street_area_id FROM before);
            ELSIF TG_TABLE_NAME = 'rail_track' THEN
                gone := ARRAY(SELECT rail_track_id FROM before);
            ELSE
                gone := ARRAY(SELECT street_object_id FROM before);
            END IF;
            DELETE FROM open_conflict WHERE relation = TG_TABLE_NAME AND row_id = ANY (gone);
            RETURN NULL;
        ELSIF TG_TABLE_NAME = 'axis' THEN
            said := (SELECT jsonb_object_agg(axis_id, streetgen._axis_values(a)
                || jsonb_build_object('geom', a.geom::text)) FROM axis a
                WHERE axis_id IN (SELECT axis_id FROM after)
                    AND axis_id IN (SELECT row_id FROM open_conflict WHERE relation = 'axis'));
        ELSIF TG_TABLE_NAME = 'control_point' THEN
            said := (SELECT jsonb_object_agg(control_point_id, to_jsonb(a) || jsonb_build_object('geom', geom::text))
                FROM after a);
        ELSIF TG_TABLE_NAME = 'footway' THEN
            said := (SELECT jsonb_object_agg(footway_id, to_jsonb(a) || jsonb_build_object('geom', geom::text))
                FROM after a);
        ELSIF TG_TABLE_NAME = 'rail_track' THEN
            said := (SELECT jsonb_object_agg(rail_track_id, to_jsonb(a) || jsonb_build_object('geom', geom::text))
                FROM after a);
        ELSIF TG_TABLE_NAME = 'footway_kerb' THEN
            said := (SELECT jsonb_object_agg(footway_kerb_id, jsonb_build_object('kerb', kerb, 'geom', geom::text))
                FROM after);
        ELSIF TG_TABLE_NAME = 'street_area' THEN
            said := (SELECT jsonb_object_agg(street_area_id, to_jsonb(a) || jsonb_build_object('geom', geom::text))
                FROM after a);
        ELSE
            said := (SELECT jsonb_object_agg(turn_restriction_id, jsonb_build_object('from_axis', from_axis, 'to_axis',
                to_axis, 'kind', kind, 'turn', turn, 'except_kinds', except_kinds, 'via_axes', via_axes, 'via_geom',
                via_geom::text, 'to_geom', to_geom::text, 'geom', geom::text)) FROM after);
        END IF;
        WITH now AS (SELECT row_id, column_name, said -> row_id::text ->> column_name AS value FROM open_conflict
            WHERE relation = TG_TABLE_NAME AND said ? row_id::text AND column_name <> '*'),
        settled AS (DELETE FROM open_conflict c USING now n
            WHERE c.relation = TG_TABLE_NAME AND (c.row_id, c.column_name) = (n.row_id, n.column_name)
                AND n.value IS NOT DISTINCT FROM CASE c.stands WHEN 'hand' THEN c.source_new ELSE c.by_hand END)
        UPDATE open_conflict c SET by_hand = n.value, stands = 'hand' FROM now n
            WHERE c.relation = TG_TABLE_NAME AND (c.row_id, c.column_name) = (n.row_id, n.column_name)
                AND n.value IS DISTINCT FROM c.by_hand AND n.value IS DISTINCT FROM c.source_new;
        RETURN NULL;
    END $body$;
    PERFORM streetgen._own_function(model, '_settle_conflicts()',
        'After an edit: conflicts with a delivery that it settles end');
    FOREACH relation IN ARRAY '{axis,control_point,turn_restriction,footway,footway_kerb,'
        'rail_track,street_area,street_object}'::name[] LOOP
        CONTINUE WHEN to_regclass(format('%I.%I', model, relation)) IS NULL;
        -- Streets that change write their objects: of these streetgen.settle_conflict alone says whose holds.
        PERFORM streetgen._make_statement_triggers(model, relation, 'settle', CASE relation WHEN 'street_object'
            THEN '{delete,truncate}'::text[] ELSE '{update,delete,truncate}' END, '_settle_conflicts()', 'before',
            'after', 'After an edit: conflicts with a delivery that it settles end');
    END LOOP;
    PERFORM streetgen._make_route_follower(model);
END $$;
COMMENT ON FUNCTION streetgen._make_source_functions(name) IS
    'Makes the triggers of a model by which an edit that gives a column the other value of a conflict settles it, and '
    'those by which routes follow axes.';

CREATE OR REPLACE FUNCTION streetgen._row_delivered(model name, relation name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('SELECT %3$s FROM %1$I.%2$I m WHERE m.source = d.source AND m.source_ref = d.source_ref',
        model, relation, CASE relation WHEN 'street_object' THEN (
            -- An object that nobody moved stands where its axis has it.
            SELECT string_agg(CASE attname WHEN 'geom' THEN 'CASE WHEN ''geom'' = ANY (m.by_hand) THEN m.geom ELSE '
                    'coalesce(d.source_geom, m.geom) END AS geom'
                    ELSE 'm.' || quote_ident(attname) END, ', ' ORDER BY attnum)
            FROM pg_attribute WHERE attrelid = format('%I.%I', model, relation)::regclass AND attnum > 0
                AND NOT attisdropped) ELSE 'm.*' END) $$;
COMMENT ON FUNCTION streetgen._row_delivered(name, name) IS
    'SQL of the row of a model that stands for a row d of delivered.';

CREATE OR REPLACE FUNCTION streetgen._rows_delivered(model name, relation name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._row_delivered(model, relation) || CASE relation WHEN 'axis' THEN format(
        -- Pieces that were cut off it by hand.
        ' UNION ALL SELECT m.* FROM %1$I.axis m WHERE m.geom && ST_Expand(d.source_geom, 100) AND m.source = d.source
            AND m.source_geom::bytea = d.source_geom::bytea AND streetgen._is_piece(m.source_ref, d.source_ref)
            AND NOT EXISTS (SELECT FROM %1$I.delivered o WHERE o.source = m.source AND o.source_ref = m.source_ref
                AND o.relation = ''axis'')', model) ELSE '' END $$;
COMMENT ON FUNCTION streetgen._rows_delivered(name, name) IS
    'SQL of the rows of a model that stand for a row d of delivered: the row itself, and pieces cut off it by hand.';

CREATE OR REPLACE FUNCTION streetgen._values_there(model name, relation name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._row_json(format('%I.%I', model, relation)::regclass, 't',
            array_remove(streetgen._delivered_columns(relation), 'geom'))
        || CASE relation WHEN 'street_object' THEN ' || jsonb_build_object(''type'', CASE WHEN ''type'' = ANY '
            '(t.by_hand) THEN to_jsonb(t.type) ELSE d.said -> ''type'' END, ''orientation'', CASE WHEN '
            '''orientation'' <> ALL (t.by_hand) THEN d.said -> ''orientation'' WHEN t.orientation_kind = ''axis'' '
            'THEN to_jsonb(t.orientation || '' from the axis'') ELSE to_jsonb(t.orientation) END)' ELSE '' END
        -- An emptied width is estimated until the source says another: it is not by hand.
        || CASE relation WHEN 'axis' THEN ' || CASE WHEN t.width IS NULL AND NOT t.width_by_hand THEN '
            'jsonb_build_object(''width'', d.said -> ''width'', ''width_end'', coalesce(to_jsonb(t.width_end), '
            'd.said -> ''width_end'')) ELSE ''{}'' END' ELSE '' END $$;
COMMENT ON FUNCTION streetgen._values_there(name, name) IS
    'SQL of what a row t has, but for its geometry, to be compared with what a row d of delivered said.';

CREATE OR REPLACE FUNCTION streetgen._is_piece(source_ref text, of_ref text) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT source_ref IS NULL OR starts_with(source_ref, of_ref || '_') $$;
COMMENT ON FUNCTION streetgen._is_piece(text, text) IS
    'May an axis with this source_ref be a piece of one of that, as clients name what they cut off: none, or 12_1 '
    'of 12?';
