-- Objects of a delivery: placed at axes, merged with those that are there, and settled.

CREATE OR REPLACE FUNCTION streetgen._place_import(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _import_row ON COMMIT DROP AS
    WITH placed AS (
        SELECT o.*, a.line, a.width, a.width_end, a.roadway_offset, b.borders, p.abscissa, p.side AS at_side,
            p.axis_offset AS axis_aside, p.border_offset
        FROM pg_temp._import_object o LEFT JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end,
                roadway_offset FROM axis_used OFFSET 0) a USING (axis_id)
            LEFT JOIN streetgen._axis_borders(model, NULL) b USING (axis_id)
            LEFT JOIN LATERAL streetgen._located(a.line, a.width, a.width_end, a.roadway_offset, b.borders, o.geom) p
                ON axis_id IS NOT NULL),
    stood AS (
        SELECT p.*, CASE WHEN axis_id IS NULL THEN 'absolute' WHEN border_offset > 0 THEN 'border' ELSE 'axis' END
                AS placement,
            CASE WHEN border_offset > 0 THEN at_side END AS side,
            CASE WHEN border_offset > 0 THEN border_offset ELSE axis_aside END AS axis_offset,
            CASE WHEN orientation IS NULL AND axis_id IS NOT NULL THEN 'axis' ELSE 'absolute' END AS orientation_kind
        FROM placed p)
    SELECT type, CASE WHEN axis_id IS NULL THEN geom ELSE streetgen._object_geometry(line, width, width_end,
            roadway_offset, borders, abscissa, NULL, side, axis_offset) END AS geom,
        streetgen._object_angle(line, abscissa, NULL, coalesce(orientation::float8, 0), orientation_kind) AS angle,
        placement, axis_id, abscissa, side, axis_offset, coalesce(orientation::float8, 0) AS orientation,
        orientation_kind, 'import'::text AS placed_by, source_ref, label, source_hash,
        CASE WHEN axis_id IS NULL THEN 'absolute' ELSE 'relative' END AS method
    FROM stood;
END $$;
COMMENT ON FUNCTION streetgen._place_import(name) IS
    'Makes the rows of street_object that the objects of the import become at the axes that were found for them.';

CREATE OR REPLACE FUNCTION streetgen._adopt_objects(model name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    UPDATE street_object o SET by_hand = CASE WHEN r.source_hash IS DISTINCT FROM o.source_hash
            THEN '{type,orientation,geom}'::text[] ELSE array_remove(ARRAY[CASE WHEN o.type <> r.type THEN 'type' END,
                CASE WHEN (o.orientation, o.orientation_kind) <> (r.orientation, r.orientation_kind)
                    THEN 'orientation' END,
                CASE WHEN NOT ST_DWithin(o.geom, r.geom, 0.01) THEN 'geom' END], NULL) END
    FROM street_object s LEFT JOIN pg_temp._import_row r USING (source_ref)
    WHERE o.street_object_id = s.street_object_id AND s.source = origin AND s.source_ref IS NOT NULL
        AND NOT EXISTS (SELECT FROM delivered d WHERE (d.relation, d.source, d.source_ref)
            = ('street_object', origin, s.source_ref));
END $$;
COMMENT ON FUNCTION streetgen._adopt_objects(name, text) IS
    'Finds what is by hand of objects of an older build: what differs from their source, or where that says another '
    'thing by now, all of it.';

CREATE OR REPLACE FUNCTION streetgen._write_merged_objects(model name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    -- An object that is not by hand follows its source, also to the axis of another name.
    WITH taken AS (
        SELECT id, array_agg(column_name) AS columns FROM pg_temp._import_merge
        WHERE fate IN ('taken', 'alike') OR fate = 'in conflict' AND wins = 'source' GROUP BY id),
    merged AS (
        SELECT o.street_object_id, ARRAY(SELECT c FROM unnest(o.by_hand) c WHERE t.id IS NULL OR c <> ALL (t.columns))
            AS by_hand, o AS stood, r AS said
        FROM pg_temp._import_row r
            JOIN street_object o ON o.source = origin AND o.source_ref = r.source_ref
            LEFT JOIN taken t ON t.id = o.street_object_id
        WHERE t.id IS NOT NULL OR o.source_hash IS DISTINCT FROM r.source_hash),
    now AS (
        SELECT m.street_object_id, m.by_hand, (m.said).source_hash,
            CASE WHEN 'type' = ANY (m.by_hand) THEN (m.stood).type ELSE (m.said).type END AS type, turned.*, placed.*
        FROM merged m CROSS JOIN LATERAL (
            SELECT (m.stood).orientation, (m.stood).orientation_kind WHERE 'orientation' = ANY (m.by_hand)
            UNION ALL SELECT (m.said).orientation, (m.said).orientation_kind
            WHERE 'orientation' <> ALL (m.by_hand)) turned
        CROSS JOIN LATERAL (
            SELECT (m.stood).geom, (m.stood).placement, (m.stood).axis_id, (m.stood).abscissa, (m.stood).abscissa_end,
                (m.stood).side, (m.stood).axis_offset, (m.stood).method WHERE 'geom' = ANY (m.by_hand)
            UNION ALL SELECT (m.said).geom, (m.said).placement, (m.said).axis_id, (m.said).abscissa, NULL,
                (m.said).side, (m.said).axis_offset, (m.said).method WHERE 'geom' <> ALL (m.by_hand)) placed)
    UPDATE street_object o SET (type, geom, angle, placement, axis_id, abscissa, abscissa_end, side, axis_offset,
            orientation, orientation_kind, source_hash, method, by_hand) = (n.type, n.geom, streetgen._object_angle(
            ST_Force2D(a.geom), n.abscissa, n.abscissa_end, n.orientation, n.orientation_kind), n.placement, n.axis_id,
            n.abscissa, n.abscissa_end, n.side, n.axis_offset, n.orientation, n.orientation_kind, n.source_hash,
            n.method, n.by_hand)
    FROM now n LEFT JOIN axis a ON a.axis_id = n.axis_id WHERE o.street_object_id = n.street_object_id;
END $$;
COMMENT ON FUNCTION streetgen._write_merged_objects(name, text, text) IS
    'Writes the objects that the source changed: what is not by hand as the source has it, of the rest what the '
    'comparison found to be taken, or where the source wins also what is in conflict.';

CREATE OR REPLACE FUNCTION streetgen._insert_object(model name, said jsonb, off_street boolean) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET streetgen.computes = 'off'
    AS $$
DECLARE
    place constant geometry := said ->> 'geom';
    row_id bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    IF off_street AND streetgen._snapped_axis(model, place) IS NULL THEN
        INSERT INTO street_object (type, geom, placement, orientation, orientation_kind)
            VALUES (said ->> 'type', place, 'absolute', coalesce((said ->> 'orientation')::float8, 0), 'absolute')
            RETURNING street_object_id INTO row_id;
    ELSE
        -- Its view of edits finds the street at which it stands.
        INSERT INTO street_object_editing (type, geom, orientation, orientation_kind)
            VALUES (said ->> 'type', place, (said ->> 'orientation')::float8,
                CASE WHEN said ->> 'orientation' IS NULL THEN 'axis' ELSE 'absolute' END)
            RETURNING street_object_id INTO row_id;
    END IF;
    UPDATE street_object SET source = said ->> 'source', source_ref = said ->> 'source_ref', placed_by = 'import'
        WHERE street_object_id = row_id;
    RETURN row_id;
END $$;
COMMENT ON FUNCTION streetgen._insert_object(name, jsonb, boolean) IS
    'Inserts an object as its source delivered it, at the nearest axis, and returns its key. off_street: where there '
    'is no axis it stays where it lies, also what only a street can place, which is refused else (22023).';

CREATE OR REPLACE FUNCTION streetgen._settle_object(model name, object bigint, column_name text, holds text,
    conflict record) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'off'
    AS $$
DECLARE
    value constant text := CASE holds WHEN 'hand' THEN conflict.by_hand ELSE conflict.source_new END;
BEGIN
    PERFORM streetgen._use_model(model);
    IF holds = 'hand' AND (SELECT column_name = ANY (by_hand) FROM street_object WHERE street_object_id = object) THEN
        -- The object stands, or was edited once more since.
        RETURN;
    ELSIF column_name = 'type' THEN
        UPDATE street_object SET type = value WHERE street_object_id = object;
    ELSIF column_name = 'orientation' THEN
        UPDATE street_object SET orientation = coalesce(split_part(value, ' ', 1)::float8, 0),
            orientation_kind = CASE WHEN value IS NULL OR value LIKE '% axis' THEN 'axis' ELSE 'absolute' END
            WHERE street_object_id = object;
    ELSIF ST_Dimension(value::geometry) > 0 THEN
        RAISE EXCEPTION 'object % was a stretch by hand', object USING ERRCODE = '22023',
            HINT = 'Give it abscissa and abscissa_end again, or let hold what the source says.';
    ELSE
        -- The view of edits puts it at the nearest axis; it shows no stretches.
        UPDATE street_object SET abscissa_end = NULL, geom = ST_StartPoint(geom)
            WHERE street_object_id = object AND abscissa_end IS NOT NULL;
        UPDATE street_object_editing SET geom = value::geometry WHERE street_object_id = object;
    END IF;
    UPDATE street_object SET by_hand = array_remove(by_hand, column_name)
        || CASE holds WHEN 'hand' THEN ARRAY[column_name] END WHERE street_object_id = object;
END $$;
COMMENT ON FUNCTION streetgen._settle_object(name, bigint, text, text, record) IS
    'Ends a conflict about a column of an object: it gets the value of the source, and is by hand no more, or that by '
    'hand, unless it was edited since. A place is one at the nearest axis. A stretch that the source replaced: 22023.';
