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
            WHEN GeometryType(geom) NOT IN ('POINT', 'POINTM') THEN format('a %s as geom', GeometryType(geom))
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN NOT (ST_X(geom) BETWEEN -1e12 AND 1e12 AND ST_Y(geom) BETWEEN -1e12 AND 1e12)
                THEN 'a coordinate that is not finite' END AS has,
        'The kinds are signals, stop, yield, mini_roundabout and pedestrian_crossing; a direction is direct, reverse, '
        'both or NULL; geom is a point with a known SRID.' AS hint
        INTO bad FROM pg_temp._import_control_point
        WHERE geom IS NOT NULL AND NOT ST_IsEmpty(geom) AND NOT coalesce(
            kind IN ('signals', 'stop', 'yield', 'mini_roundabout', 'pedestrian_crossing')
            AND (direction IN ('direct', 'reverse', 'both')) IS NOT FALSE AND GeometryType(geom) IN ('POINT', 'POINTM')
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
    'Raises 22023 for the first control point of the import of an unknown kind or direction, or without a sound place, '
    'and for a source_ref that comes twice.';

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
    RETURN QUERY SELECT 'control point off all axes, ' || CASE WHEN only_on_axes THEN 'left out' ELSE 'kept' END,
        c.kind, count(*), array_agg(c.label ORDER BY c.label) FROM pg_temp._import_control_point c
        WHERE c.axis_id IS NULL GROUP BY c.kind ORDER BY c.kind;
    DELETE FROM pg_temp._import_control_point c WHERE c.axis_id IS NULL AND only_on_axes;
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS
        SELECT c.source_ref, c.geom AS source_geom, NULL::geometry AS cleaned, c.kind, c.direction,
            c.axis_id
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
    'are left out, or kept without an axis; both are reported. Bad rows: 22023, and the model as it was.';

CREATE OR REPLACE FUNCTION streetgen.import_control_points(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    PERFORM streetgen._pause();
    RETURN QUERY SELECT * FROM streetgen._import_control_points(model, source::text,
        streetgen._point_query('control_point', '{geom,kind,direction,source_ref}', '{geom,kind}', source,
            mapping), only_on_axes => false);
    RETURN QUERY SELECT 'generate is due', NULL::text, streetgen._stale_axes(model), NULL::text[]
        WHERE streetgen._stale_axes(model) > 0;
END $$;
COMMENT ON FUNCTION streetgen.import_control_points(name, regclass, jsonb) IS
    'Imports a table of points as control points. mapping: geom, kind, direction, source_ref -> source column (string) '
    'or {"value": constant}; SQL is never evaluated. kind: signals, stop, yield, mini_roundabout or '
    'pedestrian_crossing; direction: direct (along the axis), reverse or both, NULL where unknown. With a '
    'source_ref, importing again follows the '
    'source. Reports counts by kind, and points off all axes, which are kept and change nothing. A missing column: '
    '42703; a bad row or mapping: 22023; then the model stays as it was. Needs the rights of the owner (42501).';

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

CREATE OR REPLACE FUNCTION streetgen._import_osm_controls(model name, control regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Tables written by an older flex file lack it.
    lights constant text := coalesce((SELECT attname FROM pg_attribute WHERE attrelid = control
        AND attname = 'lights' AND NOT attisdropped), 'NULL::boolean');
BEGIN
    IF control IS NULL THEN
        RETURN QUERY SELECT 'no table of control points, those of the model stay', NULL::text, 0::bigint, NULL::text[];
        RETURN;
    END IF;
    PERFORM streetgen._take_points('_import_node', format('SELECT node_id::text AS source_ref, class FROM %s',
        control));
    RETURN QUERY SELECT 'wider place of a street, not made', n.class, count(*),
        array_agg(n.source_ref ORDER BY n.source_ref) FROM pg_temp._import_node n
        WHERE n.class IN ('turning_circle', 'turning_loop', 'passing_place') GROUP BY n.class ORDER BY n.class;
    DROP TABLE pg_temp._import_node;
    -- A crossing with lights is two: a crossing, and signals for both ways. So are signals with a crossing.
    RETURN QUERY SELECT * FROM streetgen._import_control_points(model, control::text, format('SELECT geom, kind, '
        'streetgen._osm_direction(coalesce(traffic_signals_direction, direction)) AS direction, '
        'node_id::text AS source_ref FROM (SELECT *, streetgen._osm_control(class) AS kind FROM %1$s) c '
        'WHERE kind IS NOT NULL UNION ALL SELECT geom, ''signals'', '
        'streetgen._osm_direction(traffic_signals_direction), node_id || ''/lights'' FROM %1$s WHERE %2$s '
        'AND class = ''crossing'' UNION ALL SELECT geom, ''pedestrian_crossing'', NULL, node_id || ''/crossing'' '
        'FROM %1$s WHERE %2$s AND class = ''traffic_signals''', control, lights), only_on_axes => true);
END $$;
COMMENT ON FUNCTION streetgen._import_osm_controls(name, regclass) IS
    'Takes the signals, signs and crossings of an OSM table of nodes that lie on axes, of a crossing with lights the '
    'signals too, and of signals with a crossing the crossing; importing again follows the table. Turning circles and '
    'passing places are reported. A NULL table leaves all as it was.';
