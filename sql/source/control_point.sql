-- Control points from a table of points: of OpenStreetMap, or of anybody's layer by a mapping.

CREATE OR REPLACE FUNCTION streetgen._check_control_points() RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    SELECT label, CASE WHEN kind IS NULL THEN 'no kind'
            WHEN kind NOT IN ('signals', 'stop', 'yield', 'mini_roundabout', 'pedestrian_crossing')
                THEN format('kind "%s"', kind)
            WHEN direction NOT IN ('direct', 'reverse', 'both') THEN format('direction "%s"', direction)
            WHEN marking !~ streetgen._crossing_marking_pattern() THEN format('marking "%s"', marking)
            WHEN kerb !~ streetgen._crossing_kerb_pattern() THEN format('kerb "%s"', kerb)
            WHEN refuge NOT IN ('yes', 'no') THEN format('refuge "%s"', refuge)
            WHEN GeometryType(geom) NOT IN ('POINT', 'POINTM') THEN format('a %s as geom', GeometryType(geom))
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN NOT (ST_X(geom) BETWEEN -1e12 AND 1e12 AND ST_Y(geom) BETWEEN -1e12 AND 1e12)
                THEN 'a coordinate that is not finite' END AS has,
        'The kinds are signals, stop, yield, mini_roundabout and pedestrian_crossing; a direction is direct, reverse, '
        'both or NULL; a marking is zebra, ladder, lines, dashes, dots, surface, yes, no or NULL; a kerb is raised, '
        'lowered, rolled, flush, no or NULL; a refuge is yes, no or NULL; geom is a point with a known SRID.' AS hint
        INTO bad FROM pg_temp._import_control_point
        WHERE geom IS NOT NULL AND NOT ST_IsEmpty(geom) AND NOT coalesce(
            kind IN ('signals', 'stop', 'yield', 'mini_roundabout', 'pedestrian_crossing')
            AND (direction IN ('direct', 'reverse', 'both')) IS NOT FALSE
            AND (marking ~ streetgen._crossing_marking_pattern()) IS NOT FALSE
            AND (kerb ~ streetgen._crossing_kerb_pattern()) IS NOT FALSE
            AND (refuge IN ('yes', 'no')) IS NOT FALSE
            AND GeometryType(geom) IN ('POINT', 'POINTM')
            AND ST_SRID(geom) IN (SELECT srid FROM spatial_ref_sys)
            AND ST_X(geom) BETWEEN -1e12 AND 1e12 AND ST_Y(geom) BETWEEN -1e12 AND 1e12, false) LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, bad.has USING ERRCODE = '22023', HINT = bad.hint;
    END IF;
    SELECT source_ref AS label INTO bad FROM pg_temp._import_control_point WHERE source_ref IS NOT NULL
        GROUP BY source_ref HAVING count(*) > 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source_ref "%" stands in more than one row', bad.label USING ERRCODE = '22023',
            HINT = 'Map source_ref to a column of distinct values.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_control_points() IS
    'Raises 22023 for the first control point of the import of an unknown kind, direction, marking, kerb or '
    'refuge, or without a sound place, and for a source_ref that comes twice.';

CREATE OR REPLACE FUNCTION streetgen._crossing_off_axis() RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN 0.5::float8;
COMMENT ON FUNCTION streetgen._crossing_off_axis() IS
    'A node of OpenStreetMap farther from an axis than this, metres, is no crossing of it: importers move no axis so '
    'far.';

CREATE OR REPLACE FUNCTION streetgen._import_control_points(model name, source text, query text, only_on_axes boolean)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._take_points('_import_control_point', query);
    PERFORM streetgen._check_control_points();
    RETURN QUERY SELECT 'control point without geometry, left out', c.kind, count(*), array_agg(c.label)
        FROM pg_temp._import_control_point c WHERE c.geom IS NULL OR ST_IsEmpty(c.geom) GROUP BY c.kind;
    DELETE FROM pg_temp._import_control_point c WHERE c.geom IS NULL OR ST_IsEmpty(c.geom);
    ALTER TABLE pg_temp._import_control_point ALTER COLUMN geom TYPE geometry, ADD axis_id bigint;
    UPDATE pg_temp._import_control_point c SET geom = streetgen._transformed(
        'control point ' || c.label, ST_Force2D(c.geom), m.srid) FROM streetgen.model m WHERE m.name = model;
    UPDATE pg_temp._import_control_point c SET axis_id = streetgen._axis_beside(model, c.geom);
    -- A crossing of a source of streets is a vertex of what is crossed: off all axes that is another way, such as a
    -- cycle track beside the street.
    UPDATE pg_temp._import_control_point c SET axis_id = NULL FROM axis a
        WHERE only_on_axes AND a.axis_id = c.axis_id AND NOT ST_DWithin(a.geom, c.geom, streetgen._crossing_off_axis())
            AND (c.kind = 'pedestrian_crossing' OR c.source_ref LIKE '%/lights');
    RETURN QUERY SELECT 'control point off all axes, ' || CASE WHEN only_on_axes THEN 'left out' ELSE 'kept' END,
        c.kind, count(*), array_agg(c.label ORDER BY c.label) FROM pg_temp._import_control_point c
        WHERE c.axis_id IS NULL GROUP BY c.kind ORDER BY c.kind;
    DELETE FROM pg_temp._import_control_point c WHERE c.axis_id IS NULL AND only_on_axes;
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS
        SELECT c.source_ref, c.geom AS source_geom, NULL::geometry AS cleaned, c.kind, c.direction,
            c.marking, c.kerb, c.refuge, c.axis_id
        FROM pg_temp._import_control_point c ORDER BY c.source_ref, c.label;
    RETURN QUERY SELECT * FROM streetgen._deliver_rows(model, 'control_point', source);
    -- Of what did not change the axis may be another one.
    UPDATE control_point p SET axis_id = c.axis_id FROM pg_temp._import_control_point c
        WHERE p.source = origin AND p.source_ref = c.source_ref
            AND p.geom::bytea = c.geom::bytea AND p.axis_id IS DISTINCT FROM c.axis_id
            AND NOT EXISTS (SELECT FROM axis a WHERE a.axis_id = p.axis_id);
    RETURN QUERY SELECT 'control points', c.kind, count(*), NULL::text[] FROM pg_temp._import_control_point c
        GROUP BY c.kind ORDER BY c.kind;
    DROP TABLE pg_temp._import_control_point;
END $$;
COMMENT ON FUNCTION streetgen._import_control_points(name, text, text, boolean) IS
    'Upserts the control points of a prepared query by source and source_ref, and reports how many. Those off all axes '
    'are left out (only_on_axes: also crossings over 0.5 m off theirs), or kept without an axis; both are reported. '
    'Bad rows: 22023, and the model as it was.';

CREATE OR REPLACE FUNCTION streetgen.import_control_points(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    PERFORM streetgen._pause();
    RETURN QUERY SELECT * FROM streetgen._import_control_points(model, source::text,
        streetgen._point_query('control_point', '{geom,kind,direction,marking,kerb,refuge,source_ref}', '{geom,kind}',
            source, mapping), only_on_axes => false);
    RETURN QUERY SELECT 'generate is due', NULL::text, streetgen._stale_axes(model), NULL::text[]
        WHERE streetgen._stale_axes(model) > 0;
END $$;
COMMENT ON FUNCTION streetgen.import_control_points(name, regclass, jsonb) IS
    'Imports a table of points as control points. mapping: geom, kind, direction, marking, kerb, refuge, '
    'source_ref -> source column (string) or {"value": constant}; SQL is never evaluated. kind: signals, stop, yield, '
    'mini_roundabout or pedestrian_crossing; direction: direct (along the axis), reverse or both, NULL where unknown; '
    'marking, kerb and refuge: how a crossing is painted, the kerbs at its ends, and whether a refuge stands in its '
    'middle, as these columns have it. With a '
    'source_ref, importing again follows the source. Reports counts by kind, and points off all axes, which are kept '
    'and change nothing. A missing column: 42703; a bad row or mapping: 22023; then the model stays as it was. Needs '
    'the rights of the owner (42501).';

CREATE OR REPLACE FUNCTION streetgen._osm_control(class text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE class WHEN 'traffic_signals' THEN 'signals' WHEN 'stop' THEN 'stop' WHEN 'give_way' THEN 'yield'
        WHEN 'mini_roundabout' THEN 'mini_roundabout' WHEN 'crossing' THEN 'pedestrian_crossing' END;
COMMENT ON FUNCTION streetgen._osm_control(text) IS
    'The kind of control point that an OSM node of a class is; NULL where it is none.';

CREATE OR REPLACE FUNCTION streetgen._osm_direction(direction text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE direction WHEN 'forward' THEN 'direct' WHEN 'backward' THEN 'reverse' WHEN 'both' THEN 'both' END;
COMMENT ON FUNCTION streetgen._osm_direction(text) IS
    'The way along the axis that an OSM direction of a node speaks of; NULL: unknown.';

CREATE OR REPLACE FUNCTION streetgen._osm_marking(markings text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT means FROM (
        SELECT n, CASE split_part(word, ':', 1) WHEN 'zebra' THEN 'zebra' WHEN 'ladder' THEN 'ladder'
                WHEN 'lines' THEN 'lines' WHEN 'dashes' THEN 'dashes' WHEN 'dots' THEN 'dots'
                WHEN 'surface' THEN 'surface' WHEN 'rainbow' THEN 'surface' WHEN 'skewed' THEN 'zebra'
                WHEN 'yes' THEN 'yes' WHEN 'no' THEN 'no' WHEN 'pictograms' THEN 'no' END AS means
        FROM unnest(string_to_array(replace(markings, ' ', ''), ';')) WITH ORDINALITY w(word, n)) w
    WHERE means IS NOT NULL ORDER BY n LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._osm_marking(text) IS
    'The marking of a crossing that a value of crossing:markings means: zebra:double, ladder:skewed and the like are a '
    'zebra, a ladder and so on, rainbow is surface, and pictograms leave no stripes. Of several values the first that '
    'is known; NULL: none is.';

CREATE OR REPLACE FUNCTION streetgen._osm_crossing(crossing text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT means FROM (
        SELECT n, CASE WHEN word IN ('zebra', 'tiger') THEN 'zebra' WHEN word IN ('unmarked', 'informal') THEN 'no'
                WHEN word IN ('marked', 'uncontrolled', 'traffic_signals', 'yes', 'island', 'pelican', 'puffin',
                    'toucan', 'pegasus', 'controlled') THEN 'yes' END AS means
        FROM unnest(string_to_array(replace(crossing, ' ', ''), ';')) WITH ORDINALITY w(word, n)) w
    WHERE means IS NOT NULL ORDER BY n LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._osm_crossing(text) IS
    'The marking of a crossing that a value of crossing means: unmarked and informal ones have none, others are '
    'painted somehow. Of several values the first that is known; NULL: none is.';

CREATE OR REPLACE FUNCTION streetgen._osm_kerb(kerb text, height text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT coalesce((
        SELECT CASE word WHEN 'regular' THEN 'raised' WHEN 'none' THEN 'no' ELSE word END
        FROM unnest(string_to_array(replace(kerb, ' ', ''), ';')) WITH ORDINALITY w(word, n)
        WHERE word IN ('raised', 'regular', 'lowered', 'rolled', 'flush', 'no', 'none') ORDER BY n LIMIT 1),
        CASE WHEN metres < 0.01 THEN 'flush' WHEN metres <= 0.03 THEN 'lowered' WHEN metres > 0.03 THEN 'raised' END)
    FROM streetgen._metres(height) metres $$;
COMMENT ON FUNCTION streetgen._osm_kerb(text, text) IS
    'The kerb that kerb means, else kerb:height (m, or with a unit): flush under 1 cm, lowered up to 3 cm, else '
    'raised. NULL: neither says it.';

CREATE OR REPLACE FUNCTION streetgen._import_osm_controls(model name, control regclass, ways regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Tables written by an older flex file lack these.
    there constant text[] := ARRAY(SELECT attname::text FROM pg_attribute WHERE attrelid = control AND attnum > 0
        AND NOT attisdropped);
    lights constant text := CASE WHEN 'lights' = ANY (there) THEN 'lights' ELSE 'NULL::boolean' END;
    crossing constant text := CASE WHEN 'crossing' = ANY (there) THEN 'crossing' ELSE 'NULL::text' END;
    markings constant text := CASE WHEN 'markings' = ANY (there) THEN 'markings' ELSE 'NULL::text' END;
    kerb constant text := CASE WHEN 'kerb' = ANY (there) THEN 'streetgen._osm_kerb(kerb, kerb_height)'
        ELSE 'NULL' END;
    refuge constant text := CASE WHEN 'island' = ANY (there)
        THEN 'CASE WHEN island IN (''yes'', ''no'') THEN island END' ELSE 'NULL' END;
    -- A stop for all who come binds them where it stands on their junction, and no others on its way.
    all_arms constant text := CASE WHEN 'stop' = ANY (there) THEN format(
        'CASE WHEN c.stop = ''all'' AND 1 < (SELECT count(*) FROM %I.axis a WHERE ST_DWithin(a.geom, '
        'ST_Transform(c.geom, ST_SRID(a.geom)), streetgen._crossing_off_axis())) THEN ''both'' END', model)
        ELSE 'NULL' END;
    marking constant text := format('coalesce(nullif(way.painted, ''yes''), streetgen._osm_marking(%s), way.painted, '
        'way.kind_of, streetgen._osm_crossing(%s))', markings, crossing);
    -- The word of the way on which people cross comes before that of the node.
    crossed constant text := CASE WHEN ways IS NULL THEN '(SELECT NULL::text AS painted, NULL::text AS kind_of) way'
        ELSE format('LATERAL (SELECT min(streetgen._osm_marking(w.markings)) AS painted, '
            'min(streetgen._osm_crossing(w.crossing)) AS kind_of FROM %s w WHERE ST_Intersects(w.geom, c.geom)) way',
            ways) END;
BEGIN
    IF control IS NULL THEN
        RETURN QUERY SELECT 'no table of control points, those of the model stay', NULL::text, 0::bigint, NULL::text[];
        RETURN;
    END IF;
    PERFORM streetgen._take_points('_import_node', format('SELECT node_id::text AS source_ref, class, %s AS crossing, '
        '%s AS markings, %s AS kerb, %s FROM %s', crossing, markings, CASE WHEN 'kerb' = ANY (there)
            THEN 'coalesce(kerb, kerb_height)' ELSE 'NULL::text' END, kerb || '::text AS kerb_is', control));
    RETURN QUERY SELECT 'wider place of a street, not made', n.class, count(*),
        array_agg(n.source_ref ORDER BY n.source_ref) FROM pg_temp._import_node n
        WHERE n.class IN ('turning_circle', 'turning_loop', 'passing_place') GROUP BY n.class ORDER BY n.class;
    RETURN QUERY SELECT v.tag || ' not understood, taken as unknown', v.said, count(*),
            array_agg(n.source_ref ORDER BY n.source_ref)
        FROM pg_temp._import_node n, LATERAL (VALUES ('crossing:markings', n.markings,
            streetgen._osm_marking(n.markings)), ('crossing', n.crossing, streetgen._osm_crossing(n.crossing)),
            ('kerb', nullif(n.kerb, 'yes'), n.kerb_is))
            v(tag, said, means)
        WHERE v.said IS NOT NULL AND v.means IS NULL GROUP BY v.tag, v.said ORDER BY v.tag, v.said;
    DROP TABLE pg_temp._import_node;
    -- A crossing with lights is two: a crossing, and signals for both ways. So are signals with a crossing.
    RETURN QUERY SELECT * FROM streetgen._import_control_points(model, control::text, format(
        'SELECT geom, kind, coalesce(streetgen._osm_direction(coalesce(traffic_signals_direction, direction)), '
            '%7$s) AS direction, '
        'CASE kind WHEN ''pedestrian_crossing'' THEN %3$s END AS marking, '
        'CASE kind WHEN ''pedestrian_crossing'' THEN %5$s END AS kerb, '
        'CASE kind WHEN ''pedestrian_crossing'' THEN %6$s END AS refuge, '
        'node_id::text AS source_ref FROM (SELECT *, streetgen._osm_control(class) AS kind FROM %1$s) c, '
        '%4$s WHERE kind IS NOT NULL UNION ALL SELECT geom, ''signals'', '
        'streetgen._osm_direction(traffic_signals_direction), NULL, NULL, NULL, node_id || ''/lights'' FROM %1$s '
        'WHERE %2$s AND class = ''crossing'' UNION ALL SELECT geom, ''pedestrian_crossing'', NULL, %3$s, %5$s, %6$s, '
        'node_id || ''/crossing'' FROM %1$s c, %4$s WHERE %2$s AND class = ''traffic_signals''',
        control, lights, marking, crossed, kerb, refuge, all_arms), only_on_axes => true);
END $$;
COMMENT ON FUNCTION streetgen._import_osm_controls(name, regclass, regclass) IS
    'Takes the signals, signs and crossings of an OSM table of nodes that lie on axes, of a crossing with lights the '
    'signals too, and of signals with a crossing the crossing. How it is painted says the way on which people cross, '
    'else the node; importing again follows the tables. Turning circles, passing places, and values of crossing, '
    'crossing:markings and kerb that are not known are reported. A NULL table of nodes leaves all as it was.';
