-- Edits of the axes themselves: axis_editing, node_editing, edge_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_axis() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    written bigint := 0;
    way_out text;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'DELETE' THEN
        DELETE FROM axis WHERE axis_id = OLD.axis_id;
        RETURN OLD;
    END IF;
    IF TG_OP = 'UPDATE' AND NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    END IF;
    NEW.direction := coalesce(NEW.direction, 'both');
    NEW.level := coalesce(NEW.level, 0);
    IF TG_OP = 'INSERT' OR NEW.axis_id <> OLD.axis_id THEN
        SELECT count(*) FROM axis WHERE axis_id = NEW.axis_id INTO written;
        IF written > 0 THEN
            PERFORM streetgen._refuse('23505', format('%s cannot be axis %s',
                    CASE TG_OP WHEN 'INSERT' THEN 'the new axis' ELSE 'axis ' || OLD.axis_id END, NEW.axis_id),
                detail => 'Another axis has this number.', hint => CASE TG_OP
                    WHEN 'INSERT' THEN 'Leave axis_id empty: it is numbered by itself.' ELSE 'Leave it as it is.' END,
                schema => TG_TABLE_SCHEMA, relation => 'axis', attribute => 'axis_id');
        END IF;
    END IF;
    -- Loops: what is refused does not show the statement whole.
    IF TG_OP = 'INSERT' THEN
        FOR written IN EXECUTE (SELECT format('INSERT INTO %I.axis (%s) SELECT %s RETURNING axis_id', TG_TABLE_SCHEMA,
                string_agg(quote_ident(attname), ', ' ORDER BY attnum),
                string_agg(format('($1).%I', attname), ', ' ORDER BY attnum))
            FROM pg_attribute WHERE attrelid = TG_RELID AND attnum > 0
                AND (attname <> 'axis_id' OR NEW.axis_id IS NOT NULL)) USING NEW LOOP
            NEW.axis_id := written;
        END LOOP;
    ELSE
        -- Another session may be changing the columns that this edit leaves alone.
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

CREATE OR REPLACE FUNCTION streetgen._require_axis_editor(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_reader(model);
    IF NOT has_table_privilege(format('%I.axis', model), 'UPDATE') THEN
        PERFORM streetgen._refuse('42501', format('role "%s" may not edit model "%s"', current_user, model),
            hint => format('SELECT streetgen.grant(%L, %L, ''editor'') by its owner allows it.', model, current_user));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_axis_editor(name) IS
    'Raises what streetgen._require_reader raises, and 42501 where a role may not edit the axes.';

CREATE OR REPLACE FUNCTION streetgen._require_axes(model name, axes bigint[]) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    unknown bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT u INTO unknown FROM unnest(axes) u WHERE NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = u) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'there is no axis %', coalesce(unknown::text, 'NULL') USING ERRCODE = '22023',
            HINT = 'Leave axes out for all.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_axes(name, bigint[]) IS 'Raises 22023 for the first id that is no axis.';

CREATE OR REPLACE FUNCTION streetgen._lock_axes(model name, axes text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    -- A statement about no row: its trigger enters with the rights of the owner.
    UPDATE axis SET geom = geom WHERE false;
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
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP <> 'UPDATE' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Nodes lie where axes meet or end: draw or delete axes in axis_editing.');
    END IF;
    NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{geom}');
    IF NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    END IF;
    PERFORM streetgen._check_edit_geometry('node ' || OLD.node_id, NEW.geom);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT axis_id FROM %I.edge WHERE from_node = %s OR to_node = %2$s', TG_TABLE_SCHEMA, OLD.node_id));
    SELECT array_agg(axis_id ORDER BY axis_id), array_agg(streetgen._with_vertex(geom, abscissas, NEW.geom, tolerance)
        ORDER BY axis_id)
    FROM axis JOIN (
        SELECT axis_id, array_agg(DISTINCT abscissa) AS abscissas
        FROM (SELECT axis_id, start_abscissa AS abscissa FROM edge WHERE from_node = OLD.node_id
            UNION ALL SELECT axis_id, end_abscissa FROM edge WHERE to_node = OLD.node_id) e GROUP BY axis_id) a
            USING (axis_id) INTO axes, lines;
    IF axes IS NULL THEN
        PERFORM streetgen._refuse('22023', format('node %s is gone', OLD.node_id),
            detail => 'No axis meets there any more.', hint => 'Refresh the layer.');
    END IF;
    PERFORM streetgen._check_edit_line(format('axis %s, with node %s moved there,', axis, OLD.node_id), line,
        tolerance) FROM unnest(axes, lines) a(axis, line);
    UPDATE axis SET geom = line FROM unnest(axes, lines) a(axis, line) WHERE axis_id = axis;
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
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP <> 'UPDATE' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP,
            'Edges are pieces of axes: draw, split or delete axes in axis_editing.');
    END IF;
    NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{geom}');
    IF NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    END IF;
    subject := 'edge ' || OLD.edge_id;
    PERFORM streetgen._check_edit_line(subject, NEW.geom, tolerance);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('VALUES (%s)', OLD.axis_id));
    edge := streetgen._edit_axis_of(TG_TABLE_SCHEMA, subject, OLD.edge_id);
    SELECT streetgen._with_piece(geom, edge.start_abscissa, edge.end_abscissa, NEW.geom, tolerance) FROM axis
        WHERE axis_id = edge.axis_id INTO line;
    UPDATE axis SET geom = line WHERE axis_id = edge.axis_id;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_edge() IS
    'Trigger of edge_editing: that piece of the axis is replaced. A line that collapses: 22023; INSERT and DELETE: '
    '0A000.';

CREATE OR REPLACE FUNCTION streetgen._axis_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES
    ('axis_editing', 'Edit layer: draw, reshape, delete axes; width and lanes of a street',
        ARRAY['key; NULL for a new axis', 'the axis of the road', 'width kerb to kerb, metres; NULL: estimated',
            'number of lanes of both directions; NULL: estimated', 'both, direct or reverse',
              'km/h; NULL: estimated', 'importance, 1 the highest; NULL: that of the class', 'name of the street',
                  'level above the ground', 'number of the route',
            'general, bus and carpool lanes along the axis; NULL: from lane_count', 'the same against it',
            'general lanes in the middle that both directions use',
            'kinds of all lanes along the axis, such as general|bus, from left to right', 'the same against it',
            'widths of the lanes along the axis, such as 3.5||1.5, metres', 'the same against it',
            'turn marks of the lanes along the axis, such as left|through', 'the same against it',
            'who may change lanes along the axis, such as not_left|yes', 'the same against it',
            'is anything painted on its lanes: yes or no; NULL: as yes'],
        $sql$SELECT axis_id, geom, width, lane_count, direction, speed, importance, name, level, ref, lanes_forward,
            lanes_backward, lanes_both, kind_forward, kind_backward, lane_width_forward, lane_width_backward,
            turn_forward, turn_backward, change_forward, change_backward, lane_markings
            FROM {model}.axis$sql$, 'network'),
    ('node_editing', 'Edit layer: drag a node, and all axes that meet there follow',
        ARRAY['key', 'place'],
        $sql$SELECT node_id, geom FROM {model}.node$sql$, 'network'),
    ('edge_editing', 'Edit layer: redraw a piece of an axis between two nodes',
        ARRAY['key', 'the axis that it is a piece of', 'the piece; where its ends move, the axis follows'],
        $sql$SELECT edge_id, axis_id, geom FROM {model}.edge$sql$, 'network') $$;
COMMENT ON FUNCTION streetgen._axis_edit_view() IS 'The views in which axes are edited.';
