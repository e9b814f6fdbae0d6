-- Objects of a delivery: placed at axes, merged with those that are there, and settled.

CREATE OR REPLACE FUNCTION streetgen._place_import(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
CREATE TEMPORARY TABLE _import_row ON COMMIT DROP AS
WITH placed AS (
    SELECT o.*, a.line, a.width, a.width_end, a.roadway_offset, b.borders, p.abscissa, p.side AS at_side,
        p.axis_offset AS axis_aside, p.border_offset
    FROM pg_temp._import_object o LEFT JOIN (SELECT axis_id, ST_Force2D(geom) AS line, width, width_end,
            roadway_offset FROM %1$I.axis_used OFFSET 0) a USING (axis_id)
        LEFT JOIN streetgen._axis_borders(%1$L, NULL) b USING (axis_id)
        LEFT JOIN LATERAL streetgen._located(a.line, a.width, a.width_end, a.roadway_offset, b.borders, o.geom) p
            ON axis_id IS NOT NULL),
stood AS (
    SELECT p.*, CASE WHEN axis_id IS NULL THEN 'absolute' WHEN border_offset > 0 THEN 'border' ELSE 'axis' END
            AS placement,
        CASE WHEN border_offset > 0 THEN at_side END AS side,
        CASE WHEN border_offset > 0 THEN border_offset ELSE axis_aside END AS axis_offset,
        CASE WHEN orientation IS NULL AND axis_id IS NOT NULL THEN 'axis' ELSE 'absolute' END AS orientation_kind
    FROM placed p)
SELECT type, CASE WHEN axis_id IS NULL THEN geom ELSE streetgen._object_geometry(line, width, width_end, roadway_offset,
        borders, abscissa, NULL, side, axis_offset) END AS geom,
    streetgen._object_angle(line, abscissa, NULL, coalesce(orientation::float8, 0), orientation_kind) AS angle,
    placement, axis_id, abscissa, side, axis_offset, coalesce(orientation::float8, 0) AS orientation, orientation_kind,
    'import'::text AS placed_by, source_ref, label, source_hash,
    CASE WHEN axis_id IS NULL THEN 'absolute' ELSE 'relative' END AS method
FROM stood $sql$, model);
END $$;
COMMENT ON FUNCTION streetgen._place_import(name) IS
    'Makes the rows of street_object that the objects of the import become at the axes that were found for them.';

CREATE OR REPLACE FUNCTION streetgen._write_merged_objects(model name, source text, wins text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- What nobody edited follows its source whole, also to the axis of another name.
    EXECUTE format($sql$
WITH taken AS (
    SELECT id, bool_or(column_name = 'type') AS type, bool_or(column_name = 'geom') AS place,
        bool_or(column_name = 'orientation') AS turn
    FROM pg_temp._import_merge WHERE fate = 'taken' OR fate = 'in conflict' AND $2 = 'source' GROUP BY id),
now AS (
    SELECT o.street_object_id, o.abscissa_end, r.source_hash, o.placed_by = 'import' OR t.place AS place, CASE WHEN
            o.placed_by = 'import' OR t.type THEN r.type ELSE o.type END AS type,
        CASE WHEN o.placed_by = 'import' OR t.turn THEN r.orientation ELSE o.orientation END AS orientation,
        CASE WHEN o.placed_by = 'import' OR t.turn THEN r.orientation_kind ELSE o.orientation_kind END AS kind,
        o AS stood, r AS said
    FROM pg_temp._import_row r JOIN %1$I.street_object o ON o.source = $1 AND o.source_ref = r.source_ref
        LEFT JOIN taken t ON t.id = o.street_object_id
    WHERE t.id IS NOT NULL OR o.placed_by = 'import' AND o.source_hash IS DISTINCT FROM r.source_hash),
placed AS (
    SELECT n.street_object_id, n.type, n.orientation, n.kind, n.source_hash, p.*, n.abscissa_end,
        CASE WHEN n.place AND (n.orientation, n.kind, n.type) = ((n.said).orientation, (n.said).orientation_kind,
            (n.said).type) THEN 'import' ELSE 'user' END AS placed_by
    FROM now n CROSS JOIN LATERAL (
        SELECT (n.said).geom, (n.said).placement, (n.said).axis_id, (n.said).abscissa, (n.said).side,
            (n.said).axis_offset, (n.said).method WHERE n.place
        UNION ALL SELECT (n.stood).geom, (n.stood).placement, (n.stood).axis_id, (n.stood).abscissa, (n.stood).side,
            (n.stood).axis_offset, (n.stood).method WHERE n.place IS NOT TRUE) p)
UPDATE %1$I.street_object o SET (type, geom, angle, placement, axis_id, abscissa, abscissa_end, side, axis_offset,
        orientation, orientation_kind, source_hash, method, placed_by) = (p.type, p.geom, streetgen._object_angle(
        ST_Force2D(a.geom), p.abscissa, CASE p.placed_by WHEN 'user' THEN p.abscissa_end END, p.orientation, p.kind),
        p.placement, p.axis_id, p.abscissa, CASE p.placed_by WHEN 'user' THEN p.abscissa_end END, p.side,
        p.axis_offset, p.orientation, p.kind, p.source_hash, p.method, p.placed_by)
FROM placed p LEFT JOIN %1$I.axis a ON a.axis_id = p.axis_id WHERE o.street_object_id = p.street_object_id $sql$,
        model) USING source, wins;
END $$;
COMMENT ON FUNCTION streetgen._write_merged_objects(name, text, text) IS
    'Writes the objects that the comparison found to be taken: those that nobody edited as their source has them, of '
    'others the columns that are taken, or where the source wins also those in conflict.';

CREATE OR REPLACE FUNCTION streetgen._insert_object(model name, said jsonb) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET streetgen.computes = 'off'
    AS $$
DECLARE
    row_id bigint;
BEGIN
    -- Its view of edits finds the street at which it stands.
    EXECUTE format('INSERT INTO %I.street_object_editing (type, geom, orientation, orientation_kind) VALUES ($1 ->> '
        '''type'', ($1 ->> ''geom'')::geometry, ($1 ->> ''orientation'')::float8, CASE WHEN $1 ->> ''orientation'' '
        'IS NULL THEN ''axis'' ELSE ''absolute'' END) RETURNING street_object_id', model) INTO row_id USING said;
    EXECUTE format('UPDATE %I.street_object SET source = $2, source_ref = $3, placed_by = ''import''
        WHERE street_object_id = $1', model) USING row_id, said ->> 'source', said ->> 'source_ref';
    RETURN row_id;
END $$;
COMMENT ON FUNCTION streetgen._insert_object(name, jsonb) IS
    'Inserts an object as its source delivered it, at the nearest axis, and returns its key.';

CREATE OR REPLACE FUNCTION streetgen._give_object(model name, object bigint, column_name text, value text)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'off'
    AS $$
BEGIN
    EXECUTE format('UPDATE %I.street_object_editing SET ', model) || CASE column_name WHEN 'type' THEN 'type = $2'
        WHEN 'geom' THEN 'geom = $2::geometry' ELSE 'orientation = coalesce($2::float8, 0), orientation_kind = '
        'CASE WHEN $2 IS NULL THEN ''axis'' ELSE ''absolute'' END' END || ' WHERE street_object_id = $1'
        USING object, value;
    -- With the last of what was by hand it follows its source again.
    EXECUTE format($sql$
UPDATE %1$I.street_object o SET placed_by = 'import' FROM %1$I.delivered d
WHERE o.street_object_id = $1 AND (d.relation, d.source, d.source_ref) = ('street_object', o.source, o.source_ref)
    AND $2 = 'geom' AND $3::geometry::bytea = d.source_geom::bytea AND o.type = d.said ->> 'type'
    AND (o.orientation, o.orientation_kind) = (coalesce((d.said ->> 'orientation')::float8, 0),
        CASE WHEN d.said ->> 'orientation' IS NULL THEN 'axis' ELSE 'absolute' END) $sql$, model)
        USING object, column_name, value;
END $$;
COMMENT ON FUNCTION streetgen._give_object(name, bigint, text, text) IS
    'Gives a column of an object a value, as import_conflict shows it; a place is one at the nearest axis.';
