-- Axes are cut into pieces, as somebody splits a line.

CREATE OR REPLACE FUNCTION streetgen._cut_axes(model name, axes bigint[], pieces geometry[]) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    columns text;
BEGIN
    PERFORM streetgen._use_model(model);
    -- As where somebody splits a line: the first piece stays the axis of its source, others are its pieces.
    SELECT string_agg(quote_ident(attname), ', ' ORDER BY attnum) INTO columns FROM pg_attribute
        WHERE attrelid = 'axis'::regclass AND attnum > 0 AND NOT attisdropped AND attgenerated = ''
            AND attname <> ALL ('{axis_id,geom,width,width_end,source_ref}');
    EXECUTE 'WITH piece AS MATERIALIZED (SELECT cut, n, line, w.* FROM unnest($1, $2) p(cut, lines) '
        'JOIN axis ON axis_id = cut, generate_series(1, ST_NumGeometries(lines)) n, ST_GeometryN(lines, n) line, '
        'streetgen._widths_of_piece(geom, line, width, width_end) w), first AS (UPDATE axis SET geom = line, '
        'width = start, width_end = p.end FROM piece p WHERE axis_id = cut AND n = 1) '
        'INSERT INTO axis (geom, width, width_end, ' || columns || ') SELECT line, start, p.end, ' || columns
        || ' FROM piece p JOIN axis ON axis_id = cut WHERE n > 1 ORDER BY cut, n' USING axes, pieces;
END $$;
COMMENT ON FUNCTION streetgen._cut_axes(name, bigint[], geometry[]) IS
    'Gives axes the first of their pieces (MULTILINESTRING) and makes new ones, with the same values, of the others; '
    'widths are those that the axis has where a piece starts and ends.';

CREATE OR REPLACE FUNCTION streetgen._widths_of_piece(axis geometry, piece geometry, width float8, width_end float8,
    OUT start float8, OUT "end" float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT coalesce(width + (width_end - width) * ST_LineLocatePoint(axis, ST_StartPoint(piece)), width),
        width + (width_end - width) * ST_LineLocatePoint(axis, ST_EndPoint(piece)) $$;
COMMENT ON FUNCTION streetgen._widths_of_piece(geometry, geometry, float8, float8) IS
    'Widths, metres, that an axis has at both ends of a piece of it; "end" is NULL where the width does not change.';

CREATE OR REPLACE FUNCTION streetgen._at_junctions(model name, axes bigint[])
    RETURNS TABLE(axis_id bigint, pieces geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    of_axes constant bigint[] := axes;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH street AS (
        -- What is no street, as it lies on another axis or is too short, stays with the piece before it.
        SELECT e.axis_id, e.start_abscissa, row_number() OVER street = 1 AS first,
            lead(e.start_abscissa) OVER street AS next, ST_Length2D(a.geom) AS length, a.geom
        FROM edge e JOIN axis a USING (axis_id)
        -- A ring is one road all round.
        WHERE (of_axes IS NULL OR a.axis_id = ANY (of_axes)) AND NOT ST_IsClosed(a.geom)
        WINDOW street AS (PARTITION BY e.axis_id ORDER BY e.start_abscissa)),
    part AS (
        SELECT axis_id, start_abscissa, geom, CASE WHEN first THEN 0 ELSE start_abscissa / length END AS low,
            coalesce(next / length, 1) AS high
        FROM street)
    SELECT p.axis_id, ST_Collect(ST_LineSubstring(p.geom, least(p.low, 1), least(p.high, 1))
        ORDER BY p.start_abscissa) FROM part p GROUP BY p.axis_id HAVING count(*) > 1;
END $$;
COMMENT ON FUNCTION streetgen._at_junctions(name, bigint[]) IS
    'Axes (NULL: all) that pass nodes, and their pieces between these (MULTILINESTRING along the axis).';

CREATE OR REPLACE FUNCTION streetgen.cut_at_junctions(model name, axes bigint[] DEFAULT NULL) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    of_axes constant bigint[] := axes;
    passing bigint[];
    parts geometry[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._require_axis_editor(model),
        streetgen._require_axes(model, of_axes);
    PERFORM streetgen._lock_axes(model,
        format('SELECT axis_id FROM %I.axis WHERE %L::bigint[] IS NULL OR axis_id = ANY (%2$L)', model, of_axes));
    SELECT array_agg(c.axis_id ORDER BY c.axis_id), array_agg(c.pieces ORDER BY c.axis_id)
        FROM streetgen._at_junctions(model, of_axes) c INTO passing, parts;
    PERFORM streetgen._cut_axes(model, passing, parts);
    RETURN coalesce(cardinality(passing), 0);
END $$;
COMMENT ON FUNCTION streetgen.cut_at_junctions(name, bigint[]) IS
    'Cuts axes (NULL: all) at the nodes that they pass, so that each piece between two junctions may have a width of '
    'its own, and gives how many it cut. It is an edit by hand: the streets follow, and stay as they were; decisions '
    'by hand stay where they are, and a delivery of the source brings all pieces what it changed. Rings stay whole. An '
    'axis that is none: 22023; an unknown model: 3F000; who may not edit the model: 42501.';
