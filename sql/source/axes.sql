-- From any line table to axes: the mapping, the cleaning, the upsert that follows the source.

CREATE OR REPLACE FUNCTION streetgen._leave_out_others(whole boolean)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    CREATE TEMPORARY TABLE _import_other ON COMMIT DROP AS SELECT i.ctid AS id, i.label, GeometryType(i.geom) AS type
        FROM pg_temp._import i
        WHERE GeometryType(i.geom) NOT IN ('LINESTRING', 'MULTILINESTRING', 'LINESTRINGM', 'MULTILINESTRINGM');
    IF whole AND (SELECT count(*) FROM pg_temp._import_other) = (SELECT count(*) FROM pg_temp._import) THEN
        SELECT o.label, o.type INTO bad FROM pg_temp._import_other o ORDER BY o.label LIMIT 1;
        IF FOUND THEN
            RAISE EXCEPTION 'source row % is a %, expected a line', bad.label, bad.type USING ERRCODE = '22023',
                HINT = 'Streets are drawn along their middle: take the table, or the layer of the file, that has '
                    'lines.';
        END IF;
    END IF;
    -- GDAL makes a MULTIPOINT of each point.
    RETURN QUERY SELECT 'no line but a ' || t.type || ', left out', NULL::text, count(*),
        array_agg(o.label ORDER BY o.label)
        FROM pg_temp._import_other o, LATERAL (SELECT replace(o.type, 'MULTI', '') AS type) t
        GROUP BY t.type ORDER BY t.type;
    DELETE FROM pg_temp._import i USING pg_temp._import_other o WHERE i.ctid = o.id;
    DROP TABLE pg_temp._import_other;
END $$;
COMMENT ON FUNCTION streetgen._leave_out_others(boolean) IS
    'Leaves out rows of the import that are no lines, and reports them; a whole table without a line: 22023.';

CREATE OR REPLACE FUNCTION streetgen._take_rows(model name, whole boolean, any_class boolean)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
DECLARE
    target_srid integer := (SELECT srid FROM streetgen.model m WHERE m.name = model);
    flat boolean := (SELECT dimension = 2 FROM streetgen.model m WHERE m.name = model);
    mentioned text;
    silent text;
    lines_of constant text := 'SELECT ''source row '' || label AS label, source_geom AS geom FROM pg_temp._import_part';
    bad record;
BEGIN
    -- Without the source's type modifier: heights come and go below.
    ALTER TABLE pg_temp._import ALTER COLUMN geom TYPE geometry;
    -- A source changes no column that it does not mention.
    SELECT string_agg(format('%s AS %I', streetgen._taken_value(name, 'i'), name), ', ') FILTER (WHERE there),
        string_agg(format('ADD %I %s', name, type), ', ') FILTER (WHERE NOT there) INTO mentioned, silent
        FROM (SELECT c.name, c.type, EXISTS (SELECT FROM pg_attribute WHERE attrelid = 'pg_temp._import'::regclass
            AND attname = CASE c.name WHEN 'kind' THEN 'class' ELSE c.name END) AS there
        FROM streetgen._axis_input() c) m;
    -- Footways and tracks have more.
    silent := concat_ws(', ', silent, (SELECT string_agg(format('ADD %I %s', name, type), ', ')
        FROM (SELECT * FROM streetgen._footway_input() UNION ALL SELECT * FROM streetgen._track_input()) i
        WHERE name NOT IN (SELECT attname FROM pg_attribute
            WHERE attrelid = 'pg_temp._import'::regclass)));
    IF silent <> '' THEN
        EXECUTE 'ALTER TABLE pg_temp._import ' || replace(silent, 'ADD kind text', 'ADD class text');
    END IF;
    RETURN QUERY SELECT i.left_out || ', left out', NULL::text, count(*), NULL::text[] FROM pg_temp._import i
        WHERE i.left_out IS NOT NULL GROUP BY 1 ORDER BY 1;
    DELETE FROM pg_temp._import i WHERE i.left_out IS NOT NULL;
    CREATE TEMPORARY TABLE _import_shapeless ON COMMIT DROP AS SELECT i.source_ref, i.label FROM pg_temp._import i
        WHERE i.geom IS NULL OR ST_IsEmpty(i.geom);
    RETURN QUERY SELECT 'row without geometry, left out', NULL::text, count(*), array_agg(s.label ORDER BY s.label)
        FROM pg_temp._import_shapeless s HAVING count(*) > 0;
    DELETE FROM pg_temp._import i WHERE i.geom IS NULL OR ST_IsEmpty(i.geom);
    SELECT i.label, ST_SRID(i.geom) AS srid INTO bad FROM pg_temp._import i WHERE ST_SRID(i.geom) NOT IN (SELECT srid
        FROM spatial_ref_sys) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, CASE bad.srid WHEN 0 THEN 'no SRID'
            ELSE 'SRID ' || bad.srid || ', which is not known' END
            USING ERRCODE = '22023', HINT = 'ST_SetSRID or UpdateGeometrySRID gives it one.';
    END IF;
    RETURN QUERY SELECT * FROM streetgen._take_lines(model);
    RETURN QUERY SELECT * FROM streetgen._leave_out_others(whole);
    IF flat THEN
        UPDATE pg_temp._import i SET geom = ST_Force2D(i.geom) WHERE ST_NDims(i.geom) > 2;
    ELSE
        RETURN QUERY SELECT * FROM streetgen._mend_heights();
    END IF;
    -- A box leaves NaN out, a length does not: NaN is greater than infinity.
    SELECT i.label INTO bad FROM pg_temp._import i, Box3D(i.geom) AS box
        WHERE NOT (ST_3DLength(i.geom) < 'Infinity' AND least(ST_XMin(box), ST_YMin(box), ST_ZMin(box)) >= -1e12
            AND greatest(ST_XMax(box), ST_YMax(box), ST_ZMax(box)) <= 1e12) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has a vertex that is not finite', bad.label USING ERRCODE = '22023',
            HINT = 'Mend the vertex in the source.';
    END IF;

    RETURN QUERY SELECT CASE WHEN c.taken AND c.use = ANY (streetgen._footway_uses()) THEN 'taken as footway'
        WHEN c.taken AND c.use = 'rail' THEN 'taken as track'
        WHEN coalesce(c.taken, any_class OR i.class IS NULL) THEN 'taken' WHEN c.class IS NULL
        THEN 'not taken: unknown class' ELSE 'not taken: class' END,
        i.class, count(*), CASE WHEN NOT any_class AND i.class IS NOT NULL AND max(c.class) IS NULL
            THEN array_agg(i.label ORDER BY i.label) END
        FROM pg_temp._import i LEFT JOIN pg_temp._import_class c ON c.class = i.class
            GROUP BY 1, 2 ORDER BY 1 DESC, 3 DESC;
    RETURN QUERY SELECT format('unknown class, %s m wide where neither width nor lanes are stated',
            streetgen._setting_number(model, 'width_default')), i.class, count(*), array_agg(i.label ORDER BY i.label)
        FROM pg_temp._import i WHERE any_class AND i.class NOT IN (SELECT c.class FROM pg_temp._import_class c)
        GROUP BY i.class ORDER BY 3 DESC, 2;
    DELETE FROM pg_temp._import i USING pg_temp._import j LEFT JOIN pg_temp._import_class c ON c.class = j.class
        WHERE i.ctid = j.ctid AND NOT coalesce(c.taken, any_class OR j.class IS NULL);

    RETURN QUERY SELECT v.name || ' of zero, taken as unknown', NULL::text, count(*), array_agg(i.label
        ORDER BY i.label) FROM pg_temp._import i,
        LATERAL (VALUES ('width', i.width), ('width_end', i.width_end), ('speed', i.speed),
            ('lane_count', i.lane_count), ('importance', i.importance)) v(name, value)
        WHERE v.value < 0.001 GROUP BY v.name ORDER BY v.name;
    UPDATE pg_temp._import SET width = streetgen._within(width, 0.001, 200),
        width_end = streetgen._within(width_end, 0.001, 200), speed = streetgen._within(speed, 0.001, 400),
        lane_count = nullif(lane_count, 0), importance = nullif(importance, 0)
        WHERE least(width, width_end, speed, lane_count, importance) < 0.001;
    UPDATE pg_temp._import i SET access = CASE r.means WHEN '?' THEN NULL ELSE r.means END,
        unread = CASE r.means WHEN '?' THEN i.unread || 'access'::text ELSE i.unread END
        FROM (SELECT said, streetgen._read_access(said) AS means
            FROM (SELECT DISTINCT access AS said FROM pg_temp._import WHERE access IS NOT NULL) a) r
        WHERE i.access = r.said AND r.means IS DISTINCT FROM r.said;
    RETURN QUERY SELECT u.name || ' not understood, taken as unknown', NULL::text, count(*), array_agg(i.label
        ORDER BY i.label)
        FROM pg_temp._import i, unnest(i.unread) u(name) GROUP BY u.name ORDER BY u.name;

    -- One row a part, in the model's reference, of the model's dimension.
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS
        SELECT i.*, CASE WHEN flat THEN ST_Force2D(d.geom) ELSE ST_Force3DZ(d.geom) END AS source_geom,
            NULL::geometry AS cleaned, (d.path)[1] AS nth,
            streetgen._source_hash(i.width, i.width_end, i.roadway_offset, i.lane_count, i.direction, i.speed,
                i.importance, i.name, i.level, i.class, i.radius, i.lanes_forward, i.lanes_backward,
                i.lanes_both, i.kind_forward, i.kind_backward, i.lane_width_forward,
                i.lane_width_backward, i.turn_forward, i.turn_backward, i.change_forward,
                i.change_backward, i.sidewalk_left, i.sidewalk_right, i.flow,
                i.roundabout_tag, i.ref, i.access, i.parking_left, i.parking_right, i.lane_markings,
                i.sidewalk_apart, i.paved, i.sidewalk_paved_left, i.sidewalk_paved_right, i.cycle_paved_left,
                i.cycle_paved_right, i.strips_left, i.strips_right, i.height_limit) AS hash
        FROM pg_temp._import i, ST_Dump(CASE ST_SRID(i.geom) WHEN target_srid THEN i.geom
            ELSE streetgen._transformed('source row ' || i.label, i.geom, target_srid) END) d;
    UPDATE pg_temp._import_part SET source_ref = source_ref || '/' || nth WHERE ST_NumGeometries(geom) > 1;
    RETURN QUERY SELECT 'line without length, left out', NULL::text, count(*), array_agg(p.source_ref
        ORDER BY p.source_ref) FROM pg_temp._import_part p WHERE NOT ST_Length(p.source_geom) > 0 HAVING count(*) > 0;
    DELETE FROM pg_temp._import_part p WHERE NOT ST_Length(p.source_geom) > 0;
    ANALYZE pg_temp._import_part (source_ref, source_geom);
    -- Widths of sidewalks of a table of their own stay where the source says none.
    EXECUTE format('CREATE TEMPORARY VIEW _import_said AS SELECT i.*, '
        'coalesce(to_jsonb((SELECT r FROM (SELECT %s) r)), ''{}'') - ARRAY[CASE WHEN sidewalk_left IS NULL '
        'THEN ''sidewalk_left'' END, CASE WHEN sidewalk_right IS NULL '
        'THEN ''sidewalk_right'' END] AS said FROM pg_temp._import_part i', mentioned);
    PERFORM streetgen._check_scale(lines), streetgen._check_length(model, lines)
        FROM (VALUES (lines_of)) v(lines);
    SELECT m.* INTO bad FROM
        streetgen._misplaced(lines_of) m;
    IF FOUND THEN
        RAISE EXCEPTION '%', bad.remark USING ERRCODE = '22023', HINT = bad.way_out;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._take_rows(name, boolean, boolean) IS
    'From the rows of the import, those of a whole table or a few, to its parts: a line each, in the reference and '
    'dimension of the model, of classes that are taken, and where any class is, also of those that the model does not '
    'know; reports what it left out. Bad rows: 22023.';

CREATE OR REPLACE FUNCTION streetgen._write_axes(model name, source text, clean boolean DEFAULT true)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    number bigint;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._drop_unchanged(model, 'axis', source),
        streetgen._bring_back(model, 'axis', source), streetgen._forget_gone(model, 'axis', source);
    IF clean THEN
        number := streetgen._clean_parts(model, source);
    END IF;
    PERFORM streetgen._merge_delivery(model, 'axis', source);
    -- A column that a mapping does not mention is at its default.
    WITH written AS (
        INSERT INTO axis (geom, width, width_end, roadway_offset, lane_count, direction, speed, importance, name, level,
            kind, radius, lanes_forward, lanes_backward, lanes_both, kind_forward, kind_backward, lane_width_forward,
            lane_width_backward, turn_forward, turn_backward, change_forward, change_backward, sidewalk_left,
            sidewalk_right, flow, roundabout_tag, ref, access, parking_left, parking_right, lane_markings,
            sidewalk_apart, paved, sidewalk_paved_left, sidewalk_paved_right, cycle_paved_left, cycle_paved_right,
            strips_left, strips_right, height_limit, source, source_ref, source_geom, source_hash)
        SELECT coalesce(cleaned, source_geom), width, width_end, roadway_offset, lane_count, coalesce(direction,
            'both'), speed, importance, name, coalesce(level, 0), class, radius, lanes_forward, lanes_backward,
            lanes_both, kind_forward, kind_backward, lane_width_forward, lane_width_backward, turn_forward,
            turn_backward, change_forward, change_backward, sidewalk_left, sidewalk_right, flow, roundabout_tag, ref,
            access, parking_left, parking_right, lane_markings, sidewalk_apart, paved, sidewalk_paved_left,
            sidewalk_paved_right, cycle_paved_left, cycle_paved_right, strips_left, strips_right, height_limit, origin,
            source_ref, source_geom, hash
        FROM pg_temp._import_part p WHERE NOT EXISTS (SELECT FROM delivered d
            WHERE (d.relation, d.source, d.source_ref) = ('axis', origin, p.source_ref))
        ORDER BY p.source_ref RETURNING axis_id, source_ref)
    INSERT INTO delivered (relation, source, source_ref, row_id, said, source_geom, cleaned)
        SELECT 'axis', origin, s.source_ref, w.axis_id,
            jsonb_strip_nulls('{"level": 0, "direction": "both"}' || s.said), s.source_geom, s.cleaned
        FROM written w JOIN pg_temp._import_said s USING (source_ref);
    RETURN QUERY SELECT 'new or changed', NULL::text, count(*), NULL::text[] FROM pg_temp._import_part;
    RETURN QUERY SELECT 'cleaned, original in source_geom', NULL::text, number, NULL::text[] WHERE number > 0;
END $$;
COMMENT ON FUNCTION streetgen._write_axes(name, text, boolean) IS
    'Brings the axes of a source up to date with the parts of the import that are new or changed, cleaned if asked to; '
    'reports how many.';

CREATE OR REPLACE FUNCTION streetgen._look_at_axes(model name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
    written bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT array_agg(a.axis_id) INTO written FROM axis a WHERE a.source = origin
        AND (a.source_ref IS NULL OR a.source_ref IN (SELECT p.source_ref FROM pg_temp._import_part p));
    PERFORM streetgen._tell_unbelieved(model, written);
    ANALYZE axis, delivered (relation, source, source_ref);
END $$;
COMMENT ON FUNCTION streetgen._look_at_axes(name, text) IS
    'Tells which widths of the axes that an import wrote are not believed, and counts the tables for the planner.';

CREATE OR REPLACE FUNCTION streetgen._import(model name, source text, query text, clean boolean DEFAULT true,
    shapeless_stay boolean DEFAULT false, any_class boolean DEFAULT false)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
DECLARE
    changed bigint;
    staying text[];
    parted boolean;
BEGIN
    PERFORM streetgen._check_settings(model);
    -- An error within it shows the name of a view, and not all of the query.
    EXECUTE format('CREATE TEMPORARY VIEW _import_query AS %s', query);
    CREATE TEMPORARY TABLE _import ON COMMIT DROP AS SELECT * FROM pg_temp._import_query;
    DROP VIEW pg_temp._import_query;
    RETURN QUERY SELECT * FROM streetgen._take_rows(model, whole => true, any_class => any_class);
    RETURN QUERY SELECT * FROM streetgen._number_twins(model, source);
    PERFORM streetgen._part_tracks();
    RETURN QUERY SELECT * FROM streetgen._part_footways(model);
    PERFORM streetgen._adopt_axes(model, source, clean);
    IF EXISTS (SELECT FROM pg_temp._import_part WHERE source_ref IS NOT NULL) THEN
        staying := CASE WHEN shapeless_stay THEN streetgen._staying_axes(model, source) END;
        RETURN QUERY SELECT 'came without geometry, stays as it was', NULL::text, cardinality(staying)::bigint, staying
            WHERE staying IS NOT NULL;
        RETURN QUERY SELECT * FROM streetgen._drop_vanished(model, 'axis', source, staying => staying);
        RETURN QUERY SELECT * FROM streetgen._drop_nameless(model, source);
    END IF;
    RETURN QUERY SELECT * FROM streetgen._write_axes(model, source, clean);
    RETURN QUERY SELECT * FROM streetgen._tell_by_hand(model, 'axis', source);
    PERFORM streetgen._look_at_axes(model, source);
    RETURN QUERY SELECT * FROM streetgen._settle_class_lanes(model);
    RETURN QUERY SELECT * FROM streetgen._tell_usual_widths(model);
    RETURN QUERY SELECT * FROM streetgen._tell_narrow_between_kerbs(model);
    RETURN QUERY SELECT * FROM streetgen._suspects(model, source);
    RETURN QUERY SELECT * FROM streetgen._settle_driving_side(model);
    RETURN QUERY SELECT * FROM streetgen._settle_untagged_rings(model);
    changed := (SELECT count(*) FROM pg_temp._import_part);
    DROP VIEW pg_temp._import_said;
    DROP TABLE pg_temp._import, pg_temp._import_shapeless, pg_temp._import_part, pg_temp._import_class;
    RETURN QUERY SELECT * FROM streetgen._deliver_parted(model, 'footway', source);
    parted := FOUND;
    RETURN QUERY SELECT * FROM streetgen._deliver_parted(model, 'rail_track', source);
    IF (parted OR FOUND) AND changed = 0 THEN
        changed := streetgen._stale_axes(model);
    END IF;
    RETURN QUERY SELECT * FROM streetgen._tell_moved_kerbs(model);
    RETURN QUERY SELECT 'generate is due', NULL::text, changed, NULL::text[] WHERE changed > 0;
END $$;
COMMENT ON FUNCTION streetgen._import(name, text, text, boolean, boolean, boolean) IS
    'Upserts the rows of a prepared query into axis, by source and source_ref, and cleans them if asked to; reports '
    'what it did. label names a row, left_out says why it is not wanted, unread names its values that mean nothing. An '
    'axis whose row comes without geometry goes, or stays. Rows of a class that the model does not know are left out, '
    'or any class is taken. Bad rows: 22023, and the model as it was.';

CREATE OR REPLACE FUNCTION streetgen._copy_classes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    CREATE TEMPORARY TABLE _import_class ON COMMIT DROP AS SELECT class, taken, width, speed, lanes_by_width,
        lanes_one_way, use
        FROM axis_class;
END $$;
COMMENT ON FUNCTION streetgen._copy_classes(name) IS
    'Copies the classes of a model to where the rows of the import are taken.';

CREATE OR REPLACE FUNCTION streetgen._take_classes(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model);
    PERFORM streetgen._pause();
    PERFORM streetgen._copy_classes(model);
END $$;
COMMENT ON FUNCTION streetgen._take_classes(name) IS
    'Begins the import of this transaction: the streets wait for generate, the classes of the model are copied.';

CREATE OR REPLACE FUNCTION streetgen.import_axes(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    query text;
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    query := format('SELECT %s FROM %s', streetgen._mapped(source, mapping), source);
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, query, any_class => true);
END $$;
COMMENT ON FUNCTION streetgen.import_axes(name, regclass, jsonb) IS
    'Imports a line table. mapping: model column -> source column (string, whatever its case), {"value": constant}, '
    'or {"column": name, "unit": of texts without one, "values": {text: value}}; SQL is never evaluated. With a '
    'source_ref, importing again follows the source: new, changed, vanished. Rows that share one are told apart by a '
    'number, such as 12#2, which each keeps with its line. Reports counts by class, what was not '
    'believed, values that mean nothing or are out of range, which are unknown then, and rows without geometry (NULL '
    'or empty), which are left out. A missing column: 42703; bad lines or a bad mapping: '
    '22023; then the model stays as it was.';
