-- Turn restrictions of OpenStreetMap, to those of a model.

CREATE OR REPLACE FUNCTION streetgen._take_restrictions(source regclass) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Tables written by an older flex file lack them.
    excepted constant text := coalesce((SELECT attname FROM pg_attribute WHERE attrelid = source
        AND attname = 'excepted' AND NOT attisdropped), 'NULL::text');
    held_for constant text := coalesce((SELECT attname FROM pg_attribute WHERE attrelid = source
        AND attname = 'held_for' AND NOT attisdropped), 'NULL::text');
    via_ways constant text := coalesce((SELECT attname FROM pg_attribute WHERE attrelid = source
        AND attname = 'via_ways' AND NOT attisdropped), $q$CASE WHEN via_way THEN '0' END$q$);
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE _import_relation ON COMMIT DROP AS SELECT relation_id, from_way, to_way, '
        'restriction, geom, %s AS excepted, %s AS held_for, %s AS via_ways FROM %s', excepted, held_for, via_ways,
        source);
END $$;
COMMENT ON FUNCTION streetgen._take_restrictions(regclass) IS
    'Copies the turn restrictions of an OSM table to where the import reads them; none of NULL.';

CREATE OR REPLACE FUNCTION streetgen._import_restrictions(model name, line regclass, restriction regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    ways constant text COLLATE "default" := line::text;
    relations constant text := restriction::text;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._take_restrictions(restriction);
    IF restriction IS NULL THEN
        RETURN QUERY SELECT 'no table of turn restrictions, those of the model stay', NULL::text, 0::bigint,
            NULL::text[];
        RETURN;
    END IF;
    CREATE TEMPORARY TABLE _import_restriction ON COMMIT DROP AS
    SELECT relation_id::text AS relation, concat_ws('/', relation_id, from_way, to_way) AS source_ref,
        restriction AS class, a.axis_id AS from_axis, b.axis_id AS to_axis,
        substring(restriction FROM '^(no|only)_') AS kind,
        CASE substring(restriction FROM '^(?:no|only)_(.*)$') WHEN 'left_turn' THEN 'left' WHEN 'right_turn'
            THEN 'right' WHEN 'straight_on' THEN 'through' WHEN 'u_turn' THEN 'u_turn' END AS turn,
        CASE WHEN v.axes IS NULL THEN ST_Transform(ST_Force2D(ST_GeometryN(ST_CollectionExtract(r.geom, 1), 1)),
                (SELECT m.srid FROM streetgen.model m WHERE m.name = model))
            WHEN v.follow THEN ST_ClosestPoint(v.lines[1], ST_Force2D(a.geom)) END AS geom,
        CASE WHEN v.follow THEN v.axes END AS via_axes,
        CASE WHEN v.follow THEN (SELECT ST_Multi(ST_Collect(ST_LineInterpolatePoint(line, 0.5) ORDER BY i))
            FROM unnest(v.lines) WITH ORDINALITY l(line, i)) END AS via_geom,
        CASE WHEN v.follow THEN ST_ClosestPoint(v.lines[cardinality(v.lines)], ST_Force2D(b.geom)) END AS to_geom,
        CASE WHEN of = 'conditional' THEN 'at times only'
            WHEN of NOT IN ('', 'hours') OR restriction IS NULL AND of IS NULL THEN 'not for all traffic'
            WHEN restriction IS NULL THEN 'without a word on its turn'
            WHEN restriction !~ '^(no|only)_(left_turn|right_turn|straight_on|u_turn)$|^no_(entry|exit)$'
                THEN 'not understood'
            WHEN from_way IS NULL OR to_way IS NULL THEN 'without the way that it leads from or to'
            WHEN via_ways = '0' THEN 'via ways that its table does not name (import the table anew)'
            WHEN v.axes IS NULL AND ST_IsEmpty(ST_CollectionExtract(r.geom, 1)) THEN 'without a place'
            WHEN a.axis_id IS NULL OR b.axis_id IS NULL OR array_position(v.axes, NULL) IS NOT NULL
                THEN 'of ways that are no axes'
            WHEN NOT v.follow THEN 'via ways that do not follow each other' END AS left_out,
        except_kinds, other_words, of = 'hours' AS at_hours,
        further
    FROM pg_temp._import_relation r CROSS JOIN LATERAL (SELECT split_part(held_for, ',', 1) AS of,
            (string_to_array(held_for, ','))[2:] AS further) k
        LEFT JOIN axis a ON (a.source, a.source_ref) = (ways, from_way::text)
        LEFT JOIN axis b ON (b.source, b.source_ref) = (ways, to_way::text)
    CROSS JOIN LATERAL (
        -- A relation may have its members from the last to the first.
        SELECT w.axes, w.lines, f.follow FROM (VALUES (1), (-1)) o(along) CROSS JOIN LATERAL (
            SELECT array_agg(c.axis_id ORDER BY along * i) AS axes,
                array_agg(ST_Force2D(c.geom) ORDER BY along * i) AS lines
            FROM unnest(string_to_array(via_ways, ',')) WITH ORDINALITY u(way, i)
                LEFT JOIN axis c ON (c.source, c.source_ref) = (ways, way)) w
            CROSS JOIN LATERAL (
            SELECT bool_and(ST_DWithin(line, before, t.value) AND ST_DWithin(line, next, t.value)) AS follow
            FROM (SELECT 3 * streetgen._tolerance(model) AS value) t CROSS JOIN (
                SELECT line, lag(line, 1, ST_Force2D(a.geom)) OVER (ORDER BY i) AS before,
                    lead(line, 1, ST_Force2D(b.geom)) OVER (ORDER BY i) AS next
                FROM unnest(w.lines) WITH ORDINALITY l(line, i)) c) f
        ORDER BY f.follow IS NOT TRUE, o.along DESC LIMIT 1) v
    CROSS JOIN LATERAL (
        -- Traffic that the model tells from others, and what it does not.
        SELECT string_agg(DISTINCT kind, '|') AS except_kinds,
            string_agg(DISTINCT left(btrim(word), 40), ', ') FILTER (WHERE kind IS NULL) AS other_words
        FROM regexp_split_to_table(lower(excepted), '[;,]') word
        CROSS JOIN LATERAL (SELECT CASE btrim(word) WHEN 'psv' THEN 'bus' WHEN 'bus' THEN 'bus'
            WHEN 'bicycle' THEN 'cycle' WHEN 'hov' THEN 'carpool' END AS kind) k
        WHERE btrim(word) NOT IN ('', 'no', 'none')) excepted;
    RETURN QUERY SELECT 'turn restriction ' || v.left_out || ', left out', r.class, count(*),
        array_agg(DISTINCT r.relation) FROM pg_temp._import_restriction r, LATERAL (
            SELECT r.left_out UNION ALL
            SELECT CASE traffic WHEN 'conditional' THEN 'at times only' ELSE 'not for all traffic' END
            FROM unnest(r.further) traffic) v(left_out)
        WHERE v.left_out IS NOT NULL GROUP BY v.left_out, r.class ORDER BY 1, 2;
    DELETE FROM pg_temp._import_restriction r WHERE r.left_out IS NOT NULL;
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS
        SELECT DISTINCT ON (r.source_ref) r.source_ref, r.geom AS source_geom, NULL::geometry AS cleaned, r.from_axis,
            r.to_axis, r.kind, r.turn, r.except_kinds, r.via_axes, r.via_geom, r.to_geom
        FROM pg_temp._import_restriction r ORDER BY r.source_ref;
    RETURN QUERY SELECT * FROM streetgen._deliver_rows(model, 'turn_restriction', relations);
    RETURN QUERY SELECT format('turn restriction with an exception for %s, taken for these too', r.other_words),
        r.class, count(*), array_agg(DISTINCT r.relation) FROM pg_temp._import_restriction r
        WHERE r.other_words IS NOT NULL GROUP BY r.other_words, r.class ORDER BY r.other_words, r.class;
    RETURN QUERY SELECT 'turn restriction at hours of a day, taken for all times', r.class, count(*),
        array_agg(DISTINCT r.relation) FROM pg_temp._import_restriction r WHERE r.at_hours GROUP BY r.class
        ORDER BY r.class;
    RETURN QUERY SELECT CASE WHEN via THEN 'turn restrictions via ways, obeyed where these lie in a junction'
            ELSE 'turn restrictions' END, r.class, count(*), NULL::text[]
        FROM (SELECT *, via_axes IS NOT NULL AS via FROM pg_temp._import_restriction) r
        GROUP BY via, r.class ORDER BY via, r.class;
    DROP TABLE pg_temp._import_restriction, pg_temp._import_relation;
END $$;
COMMENT ON FUNCTION streetgen._import_restrictions(name, regclass, regclass) IS
    'Takes the turn restrictions of an OSM table between ways that are axes, at a node or via such ways; importing '
    'again follows the table. Those for some traffic only, of unknown wording, without a way, of ways that are no axes '
    'or via ways that do not follow each other are left out and reported. What one excepts is read where the '
    'model knows such traffic (psv, bus, bicycle, hov), else reported. A NULL table leaves all as it was.';
