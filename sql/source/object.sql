-- What stands at streets from a table of points: of OpenStreetMap, or of anybody's layer by a mapping.

CREATE OR REPLACE FUNCTION streetgen._check_objects(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT label, has INTO bad FROM (
        SELECT label, CASE WHEN type IS NULL THEN 'no type'
            WHEN NOT EXISTS (SELECT FROM object_type t WHERE t.type = o.type) THEN format('type "%s"', type)
            WHEN GeometryType(geom) NOT IN ('POINT', 'POINTM') THEN format('a %s as geom', GeometryType(geom))
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN NOT (ST_X(geom) BETWEEN -1e12 AND 1e12 AND ST_Y(geom) BETWEEN -1e12 AND 1e12)
                THEN 'a coordinate that is not finite'
            WHEN orientation IS NOT NULL AND NOT (orientation ~ '^-?\d{1,3}(\.\d+)?$'
                AND orientation::numeric BETWEEN -360 AND 360) THEN format('orientation "%s"', orientation) END AS has
        FROM pg_temp._import_object o WHERE geom IS NOT NULL AND NOT ST_IsEmpty(geom)) o
        WHERE has IS NOT NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, bad.has USING ERRCODE = '22023',
            HINT = format('type is one of %I.object_type; geom is a point with a known SRID; orientation is in '
                'degrees, -360 to 360.', model);
    END IF;
    SELECT source_ref AS label INTO bad FROM pg_temp._import_object WHERE source_ref IS NOT NULL
        GROUP BY source_ref HAVING count(*) > 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source_ref "%" stands in more than one row', bad.label USING ERRCODE = '22023',
            HINT = 'Map source_ref to a column of distinct values.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_objects(name) IS
    'Raises 22023 for the first object of the import of an unknown type, with a bad orientation or without a sound '
    'place, and for a source_ref that comes twice.';

CREATE OR REPLACE FUNCTION streetgen._import_objects(model name, source text, query text, crossings_on_axes boolean)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    touched bigint[];
    folding text;
    snap float8;
BEGIN
    PERFORM streetgen._use_model(model);
    folding := streetgen._setting_text(model, 'object_names');
    snap := streetgen._setting_number(model, 'object_snap');
    PERFORM streetgen._take_points('_import_object', query);
    PERFORM streetgen._check_objects(model);
    RETURN QUERY SELECT 'object without geometry, left out', o.type, count(*), array_agg(o.label)
        FROM pg_temp._import_object o WHERE o.geom IS NULL OR ST_IsEmpty(o.geom) GROUP BY o.type;
    DELETE FROM pg_temp._import_object o WHERE o.geom IS NULL OR ST_IsEmpty(o.geom);
    ALTER TABLE pg_temp._import_object ALTER COLUMN geom TYPE geometry, ADD axis_id bigint, ADD source_hash bigint;
    UPDATE pg_temp._import_object o SET geom = streetgen._transformed(
        'object ' || o.label, ST_Force2D(o.geom), m.srid),
        source_hash = hash_record_extended(ROW(o.type, o.geom::bytea, o.orientation, o.name), 0)
        FROM streetgen.model m WHERE m.name = model;
    -- The nearest axis; one of its own name counts as half as far, and one of a name nearly alike as that much nearer.
    UPDATE pg_temp._import_object o SET axis_id = (SELECT a.axis_id FROM axis a WHERE ST_DWithin(a.geom, o.geom, snap)
        ORDER BY ST_Distance(a.geom, o.geom) * (1 - 0.5 * coalesce(
            streetgen._name_likeness(a.name, o.name, folding, 'object_names'), 0)), a.axis_id LIMIT 1);
    IF crossings_on_axes THEN
        RETURN QUERY WITH elsewhere AS (
            DELETE FROM pg_temp._import_object o WHERE o.type = ANY (_types_below('crossing')) AND NOT EXISTS (
                SELECT FROM axis a WHERE ST_DWithin(a.geom, o.geom, streetgen._crossing_off_axis()))
            RETURNING o.label, o.type)
            SELECT 'crossing on no axis, left out', e.type, count(*), (array_agg(e.label ORDER BY e.label))[:1000]
            FROM elsewhere e GROUP BY e.type ORDER BY e.type;
    END IF;
    RETURN QUERY SELECT 'object off all axes, kept where it lies', o.type, count(*), (array_agg(o.label ORDER BY
        o.label))[:1000] FROM pg_temp._import_object o WHERE o.axis_id IS NULL GROUP BY o.type ORDER BY o.type;
    PERFORM streetgen._place_import(model);
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS SELECT r.source_ref, o.geom AS source_geom,
        NULL::geometry AS cleaned, r.type, o.orientation::float8, r.source_hash
        FROM pg_temp._import_row r JOIN pg_temp._import_object o USING (source_ref);
    RETURN QUERY SELECT * FROM streetgen._deliver_rows(model, 'street_object', source);
    INSERT INTO street_object (type, geom, angle, placement, axis_id, abscissa, side, axis_offset, orientation,
            orientation_kind, placed_by, source_hash, method, source)
        SELECT type, geom, angle, placement, axis_id, abscissa, side, axis_offset, orientation, orientation_kind,
            placed_by, source_hash, method, origin
        FROM pg_temp._import_row WHERE source_ref IS NULL ORDER BY label;
    DROP TABLE pg_temp._import_row;
    -- A new crossing leads where the footway does that lies on it.
    INSERT INTO pedestrian_crossing (street_object_id, angle)
        SELECT o.street_object_id, coalesce(w.angle, (streetgen._usual_crossing()).angle)
        FROM (SELECT * FROM street_object WHERE source = origin AND type = ANY (_types_below('crossing'))) o
            LEFT JOIN axis a ON a.axis_id = o.axis_id AND o.method = 'relative'
            LEFT JOIN footway f ON f.role = 'crossing' AND f.footway_id = _footway_over(o.geom, a.level)
            LEFT JOIN LATERAL (SELECT streetgen._way_across(ST_Force2D(a.geom), o.abscissa, ST_Force2D(f.geom)) AS angle
                WHERE f.footway_id IS NOT NULL) w ON true
        WHERE NOT EXISTS (SELECT FROM pedestrian_crossing c WHERE c.street_object_id = o.street_object_id);
    INSERT INTO parking_bay (street_object_id) SELECT o.street_object_id FROM street_object o
        WHERE o.source = origin AND o.type = ANY (_types_below('parking_bay')) ON CONFLICT DO NOTHING;
    SELECT array_agg(DISTINCT o.axis_id) INTO touched FROM street_object o WHERE o.source = origin;
    -- Many streets are brought up to date with all at less cost.
    PERFORM streetgen._find_control_points(model, source), streetgen._update_object(model, CASE
            WHEN cardinality(touched) < (SELECT count(*) FROM axis) / 4.0 THEN touched END),
        -- Also where a crossing is gone.
        streetgen._settle_lane(model, NULL);
    RETURN QUERY SELECT 'object nearer to another one than distance_least, kept', o.type, count(*),
        (array_agg(coalesce(o.source_ref, 'object ' || o.street_object_id) ORDER BY o.source_ref,
            o.street_object_id))[:1000]
        FROM streetgen._crowding_objects(model) o WHERE o.source = origin GROUP BY o.type
        ORDER BY o.type;
    RETURN QUERY SELECT 'objects', o.type, count(*), NULL::text[] FROM pg_temp._import_object o GROUP BY o.type
        ORDER BY o.type;
    DROP TABLE pg_temp._import_object;
END $$;
COMMENT ON FUNCTION streetgen._import_objects(name, text, text, boolean) IS
    'Upserts the objects of a prepared query by source and source_ref, each at the nearest axis within object_snap, '
    'and reports how many; those off all axes stay where they lie and are listed (the first thousand), and so are '
    'those nearer to another object than distance_least of their type. crossings_on_axes: a crossing on no axis is '
    'left out and listed. What is by hand stays as in axes. Bad rows: 22023, and the model as it was.';

CREATE OR REPLACE FUNCTION streetgen.import_objects(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    PERFORM streetgen._require_subject(model, 'object');
    RETURN QUERY SELECT * FROM streetgen._import_objects(model, source::text, streetgen._point_query('street_object',
        '{geom,type,orientation,name,source_ref}', '{geom,type}', source, mapping), crossings_on_axes => false);
END $$;
COMMENT ON FUNCTION streetgen.import_objects(name, regclass, jsonb) IS
    'Imports a table of points as objects of subject object. mapping: geom, type, orientation (degrees clockwise from '
    'the north), name (of the street), source_ref -> source column (string) or {"value": constant}; SQL is never '
    'evaluated. Each stands at the nearest axis within setting object_snap, where one of the same name counts as half '
    'as far: on the roadway from the axis, beside it from the border. Where setting object_names is fuzzy, an axis of '
    'a similar name counts as nearer by half of the similarity of pg_trgm. Crossings, traffic lights and signs point '
    'to the control point of their kind within a metre, each to one of its own, and move with it. With a source_ref, '
    'importing again follows the source; what is by hand stays as setting delivery_wins says, deleted objects too. '
    'Reports counts by type, objects off all axes, which stay where they lie, and objects nearer to another one than '
    'distance_least of their type. An extension that is asked for and missing: 0A000. A missing column: 42703; a bad '
    'row or mapping: 22023; a model without the subject: 55000; then the model stays as it was. Needs the rights of '
    'the owner (42501).';

CREATE OR REPLACE FUNCTION streetgen.import_osm_objects(model name, prefix text DEFAULT 'osm',
    schemas name[] DEFAULT current_schemas(true))
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    points regclass;
    others text;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('prefix', prefix, 'schemas', schemas::text);
    PERFORM streetgen._require_subject(model, 'object');
    points := streetgen._osm_table('_object', prefix, schemas);
    IF points IS NULL THEN
        SELECT string_agg(format('"%s"', left(c.relname, -7)), ', ' ORDER BY c.relname) INTO others FROM pg_class c
            JOIN pg_namespace n ON n.oid = c.relnamespace
        WHERE c.relname LIKE '%\_object' AND n.nspname = ANY (schemas)
            AND 2 = (SELECT count(*) FROM pg_attribute a WHERE a.attrelid = c.oid
                AND a.attname IN ('class', 'node_id'));
        RAISE EXCEPTION 'there is no table "%"', prefix || '_object' USING ERRCODE = '42P01',
            HINT = coalesce('Prefixes that have one: ' || others || '.',
                'Load the file again with data/osm2pgsql_flex.lua of this build, which makes it.');
    END IF;
    RETURN QUERY SELECT * FROM streetgen._import_objects(model, points::text, format($sql$
SELECT geom, CASE class WHEN 'street_lamp' THEN 'lamp' WHEN 'traffic_signals' THEN 'traffic_light'
        WHEN 'stop' THEN 'sign' WHEN 'give_way' THEN 'sign' ELSE class::text END AS type,
    CASE WHEN direction ~ '^\d{1,3}(\.\d+)?$' AND direction::numeric <= 360 THEN direction END AS orientation,
    NULL::text AS name, node_id::text AS source_ref FROM %s$sql$, points),
        crossings_on_axes => true);
END $$;
COMMENT ON FUNCTION streetgen.import_osm_objects(name, text, name[]) IS
    'Imports lamps, trees, benches, bollards, stops and platforms, crossings, signals, signs and what slows traffic '
    'of an OSM file, from the table '
    'PREFIX_object that data/osm2pgsql_flex.lua writes, found in the schemas of search_path or named with its schema '
    '(gis.osm), as streetgen.import_objects: crossings, signals and signs '
    'point to the control point that streetgen.import_osm made of their node. A crossing on no axis is one of another '
    'way, such as a cycle track, and is left out and listed. No such table: 42P01; a model '
    'without the subject: 55000. Needs the rights of the owner (42501).';
