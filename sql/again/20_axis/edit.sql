-- Edits of the axes themselves: axis_editing, node_editing, edge_editing.

CREATE OR REPLACE FUNCTION streetgen._tolerance(model name) RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    tolerance float8;
BEGIN
    EXECUTE format($sql$SELECT value::float8 FROM %I.setting WHERE name = 'tolerance'$sql$, model) INTO tolerance;
    RETURN tolerance;
END $$;
COMMENT ON FUNCTION streetgen._tolerance(name) IS 'Setting tolerance of a model, metres.';

CREATE OR REPLACE FUNCTION streetgen._edit_axis() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    written bigint := 0;
    way_out text;
BEGIN
    IF TG_OP = 'DELETE' THEN
        EXECUTE format('DELETE FROM %I.axis WHERE axis_id = $1', TG_TABLE_SCHEMA) USING OLD.axis_id;
        RETURN OLD;
    END IF;
    IF TG_OP = 'UPDATE' AND NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    END IF;
    NEW.direction := coalesce(NEW.direction, 'both');
    NEW.level := coalesce(NEW.level, 0);
    IF TG_OP = 'INSERT' AND NEW.axis_id IS NULL THEN
        EXECUTE format('INSERT INTO %I.axis (geom, width, lane_count, direction, speed, importance, name, level) '
            'VALUES ($1, $2, $3, $4, $5, $6, $7, $8) RETURNING axis_id', TG_TABLE_SCHEMA)
            INTO NEW.axis_id USING NEW.geom, NEW.width, NEW.lane_count, NEW.direction, NEW.speed, NEW.importance,
                NEW.name, NEW.level;
    ELSIF TG_OP = 'INSERT' THEN
        EXECUTE format('SELECT count(*) FROM %I.axis WHERE axis_id = $1', TG_TABLE_SCHEMA) INTO written
            USING NEW.axis_id;
        IF written > 0 THEN
            PERFORM streetgen._refuse('23505', format('the new axis cannot be axis %s', NEW.axis_id),
                detail => 'Another axis has this number.', hint => 'Leave axis_id empty: it is numbered by itself.',
                schema => TG_TABLE_SCHEMA, relation => 'axis', attribute => 'axis_id');
        END IF;
        EXECUTE format('INSERT INTO %I.axis (axis_id, geom, width, lane_count, direction, speed, importance, name, '
            'level) VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9)', TG_TABLE_SCHEMA)
            USING NEW.axis_id, NEW.geom, NEW.width, NEW.lane_count, NEW.direction, NEW.speed, NEW.importance, NEW.name,
                NEW.level;
    ELSE
        -- What this edit leaves alone another session may be changing. A loop: what is refused does not show the
        -- statement whole.
        FOR written IN EXECUTE format('UPDATE %I.axis a SET %s WHERE axis_id = ($2).axis_id RETURNING 1',
            TG_TABLE_SCHEMA,
            (SELECT string_agg(format('%1$I = CASE WHEN ($1).%1$I IS DISTINCT FROM ($2).%1$I THEN ($1).%1$I ELSE '
                'a.%1$I END', attname), ', ') FROM pg_attribute WHERE attrelid = TG_RELID AND attnum > 0))
            USING NEW, OLD LOOP
        END LOOP;
        IF written = 0 THEN
            PERFORM streetgen._refuse('22023', format('axis %s is gone', OLD.axis_id),
                detail => 'Another session deleted it.', hint => 'Refresh the layer.');
        END IF;
    END IF;
    RETURN NEW;
EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
    GET STACKED DIAGNOSTICS way_out = PG_EXCEPTION_HINT;
    PERFORM streetgen._refuse_wait(TG_TABLE_SCHEMA, CASE SQLSTATE WHEN '55P03' THEN way_out END);
    RAISE;
END $$;
COMMENT ON FUNCTION streetgen._edit_axis() IS
    'Trigger of axis_editing: writes the axis. What the table does not take is refused by it (23514, 23502); an axis '
    'that another session deleted: 22023; one that another session holds longer than lock_timeout: 55P03, naming who.';

CREATE OR REPLACE FUNCTION streetgen._lock_axes(model name, axes text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    -- A statement about no row: its trigger enters with the rights of the owner.
    EXECUTE format('UPDATE %I.axis SET geom = geom WHERE false', model);
    BEGIN
        EXECUTE format('SELECT FROM %I.axis WHERE axis_id IN (%s) ORDER BY axis_id FOR UPDATE', model, axes);
    EXCEPTION WHEN lock_not_available OR deadlock_detected THEN
        PERFORM streetgen._refuse_place(model);
    END;
END $$;
COMMENT ON FUNCTION streetgen._lock_axes(name, text) IS
    'Locks axes, given as a query of axis_id, before what an edit goes by is read, so that of two editors of one '
    'thing the second sees the first: the model first, as every edit. A lock_timeout that ends: 55P03, naming who '
    'holds some.';

CREATE OR REPLACE FUNCTION streetgen._with_vertex(line geometry, abscissas float8[], place geometry, tolerance float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH vertex AS (
        SELECT i, geom, sum(step) OVER (ORDER BY i) AS abscissa
        FROM (SELECT path[1] AS i, geom, coalesce(ST_Distance(geom, lag(geom) OVER (ORDER BY path)), 0) AS step
            FROM ST_DumpPoints(line)) s)
    SELECT ST_SetSRID(ST_MakeLine(geom ORDER BY abscissa, i), ST_SRID(line)) FROM (
        SELECT abscissa, i, geom FROM vertex v WHERE NOT EXISTS (SELECT FROM unnest(abscissas) a
            WHERE abs(a - v.abscissa) <= tolerance)
        UNION ALL SELECT a, 0, place FROM unnest(abscissas) a) p
    $$;
COMMENT ON FUNCTION streetgen._with_vertex(geometry, float8[], geometry, float8) IS
    'A line whose vertices within the tolerance of some abscissas (metres) lie at a place instead; where there is '
    'none, one is put in.';

CREATE OR REPLACE FUNCTION streetgen._edit_node() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axes bigint[];
    lines geometry[];
    tolerance constant float8 := streetgen._tolerance(TG_TABLE_SCHEMA);
BEGIN
    IF TG_OP <> 'UPDATE' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Nodes lie where axes meet or end: draw or delete axes in axis_editing.');
    ELSIF NEW.node_id IS DISTINCT FROM OLD.node_id THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, 'a change of the key',
            'Only the place of a node can be changed.');
    ELSIF NEW.geom IS NOT DISTINCT FROM OLD.geom THEN
        RETURN NEW;
    END IF;
    PERFORM streetgen._check_edit_geometry('node ' || OLD.node_id, NEW.geom);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %I.edge WHERE from_node = %s OR to_node = %2$s', TG_TABLE_SCHEMA, OLD.node_id));
    EXECUTE format($sql$
SELECT array_agg(axis_id ORDER BY axis_id), array_agg(streetgen._with_vertex(geom, abscissas, $2, $3) ORDER BY axis_id)
FROM %1$I.axis JOIN (
    SELECT axis_id, array_agg(DISTINCT abscissa) AS abscissas
    FROM (SELECT axis_id, start_abscissa AS abscissa FROM %1$I.edge WHERE from_node = $1
        UNION ALL SELECT axis_id, end_abscissa FROM %1$I.edge WHERE to_node = $1) e GROUP BY axis_id) a
        USING (axis_id) $sql$,
        TG_TABLE_SCHEMA) INTO axes, lines USING OLD.node_id, NEW.geom, tolerance;
    IF axes IS NULL THEN
        PERFORM streetgen._refuse('22023', format('node %s is gone', OLD.node_id),
            detail => 'No axis meets there any more.', hint => 'Refresh the layer.');
    END IF;
    PERFORM streetgen._check_edit_line(format('axis %s, with node %s moved there,', axis, OLD.node_id), line,
        tolerance) FROM unnest(axes, lines) a(axis, line);
    EXECUTE format('UPDATE %I.axis SET geom = line FROM unnest($1, $2) a(axis, line) WHERE axis_id = axis',
        TG_TABLE_SCHEMA) USING axes, lines;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_node() IS
    'Trigger of node_editing: moves the vertices of all axes at the node, in one statement. A move that would make an '
    'axis collapse: 22023; INSERT and DELETE: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._with_piece(line geometry, from_abscissa float8, to_abscissa float8,
    piece geometry, tolerance float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    WITH vertex AS (
        SELECT i, geom, sum(step) OVER (ORDER BY i) AS abscissa
        FROM (SELECT path[1] AS i, geom, coalesce(ST_Distance(geom, lag(geom) OVER (ORDER BY path)), 0) AS step
            FROM ST_DumpPoints(line)) s)
    SELECT ST_SetSRID(ST_MakeLine(geom ORDER BY part, i), ST_SRID(line)) FROM (
        SELECT 1 AS part, i, geom FROM vertex WHERE abscissa < from_abscissa - tolerance
        UNION ALL SELECT 2, path[1], geom FROM ST_DumpPoints(piece)
        UNION ALL SELECT 3, i, geom FROM vertex WHERE abscissa > to_abscissa + tolerance) p
    $$;
COMMENT ON FUNCTION streetgen._with_piece(geometry, float8, float8, geometry, float8) IS
    'A line with the piece between two abscissas (metres) drawn anew.';

CREATE OR REPLACE FUNCTION streetgen._edit_edge() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    edge record;
    line geometry;
    tolerance constant float8 := streetgen._tolerance(TG_TABLE_SCHEMA);
    subject text;
BEGIN
    IF TG_OP <> 'UPDATE' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Edges are pieces of axes: draw, split or delete axes in axis_editing.');
    ELSIF (NEW.edge_id, NEW.axis_id) IS DISTINCT FROM (OLD.edge_id, OLD.axis_id) THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, 'a change of edge_id or axis_id',
            'Only the line of an edge can be changed.');
    ELSIF NEW.geom IS NOT DISTINCT FROM OLD.geom THEN
        RETURN NEW;
    END IF;
    subject := 'edge ' || OLD.edge_id;
    PERFORM streetgen._check_edit_line(subject, NEW.geom, tolerance);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('VALUES (%s)', OLD.axis_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    EXECUTE format('SELECT streetgen._with_piece(geom, $2, $3, $4, $5) FROM %I.axis WHERE axis_id = $1',
        TG_TABLE_SCHEMA) INTO line
        USING edge.axis_id, edge.start_abscissa, edge.end_abscissa, NEW.geom, tolerance;
    EXECUTE format('UPDATE %I.axis SET geom = $2 WHERE axis_id = $1', TG_TABLE_SCHEMA) USING edge.axis_id, line;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_edge() IS
    'Trigger of edge_editing: that piece of the axis is replaced. A line that collapses: 22023; INSERT and DELETE: '
    '0A000.';
