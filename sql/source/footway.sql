-- Lines of classes that are no roadway: they become footways.

CREATE OR REPLACE FUNCTION streetgen._footway_input() RETURNS TABLE(name text, type text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ SELECT word, CASE word WHEN 'incline' THEN 'float8' ELSE 'text' END
        FROM unnest('{role,marking,surface,incline,climb,wheelchair,tactile_paving,foot}'::text[]) word $$;
COMMENT ON FUNCTION streetgen._footway_input() IS
    'The columns that a footway has of a source and an axis has not, with their types.';

CREATE OR REPLACE FUNCTION streetgen._part_footways(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    CREATE TEMPORARY TABLE _import_footway ON COMMIT DROP AS
        SELECT p.source_ref, p.source_geom, NULL::geometry AS cleaned, p.class AS kind,
            CASE WHEN p.role IN ('sidewalk', 'crossing') THEN p.role END AS role, p.marking, p.surface, p.incline,
            p.climb, p.wheelchair, p.tactile_paving, p.foot, p.width, coalesce(p.level, 0) AS level, p.name, c.use
        FROM pg_temp._import_part p JOIN pg_temp._import_class c ON c.class = p.class AND c.use <> 'roadway';
    DELETE FROM pg_temp._import_part p USING pg_temp._import_class c WHERE c.class = p.class AND c.use <> 'roadway';
    DELETE FROM pg_temp._import i USING pg_temp._import_class c WHERE c.class = i.class AND c.use <> 'roadway';
    RETURN QUERY SELECT 'no roadway, and nothing is made of it', f.kind, count(*),
        array_agg(f.source_ref ORDER BY f.source_ref) FROM pg_temp._import_footway f
        WHERE f.use <> ALL (streetgen._footway_uses()) GROUP BY f.kind ORDER BY f.kind;
    DELETE FROM pg_temp._import_footway f WHERE f.use <> ALL (streetgen._footway_uses());
    ALTER TABLE pg_temp._import_footway DROP COLUMN use;
END $$;
COMMENT ON FUNCTION streetgen._part_footways(name) IS
    'Parts the lines of the import whose class is no roadway from those that become axes.';

CREATE OR REPLACE FUNCTION streetgen._deliver_parted(model name, relation name, source text,
    among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF relation = 'footway' THEN
        ALTER TABLE pg_temp._import_footway RENAME TO _import_part;
    ELSE
        ALTER TABLE pg_temp._import_rail_track RENAME TO _import_part;
    END IF;
    RETURN QUERY SELECT * FROM streetgen._deliver_if_any(model, relation, source, among);
END $$;
COMMENT ON FUNCTION streetgen._deliver_parted(name, name, text, text[]) IS
    'Brings the footways or the tracks of a source, or those among some source_refs, up to date with the lines that '
    'were parted from its axes; reports what is by hand.';

CREATE OR REPLACE FUNCTION streetgen._tell_moved_kerbs(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'footway' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT 'a sidewalk mapped within the estimated kerb, which gives way', a.kind, count(*),
                array_agg(a.source_ref ORDER BY a.source_ref)
            FROM axis_used u JOIN axis a USING (axis_id) WHERE u.width_moved > 0 GROUP BY a.kind ORDER BY a.kind;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._tell_moved_kerbs(name) IS
    'Tells the axes of a model whose estimated kerbs give way to sidewalks mapped within them, by class.';

CREATE OR REPLACE FUNCTION streetgen._import_osm_kerbs(model name, control regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- Tables written by an older flex file have no kerbs.
    IF NOT EXISTS (SELECT FROM pg_attribute WHERE attrelid = control AND attname = 'kerb' AND NOT attisdropped) THEN
        RETURN;
    END IF;
    PERFORM streetgen._take_points('_import_kerb', format('SELECT geom, '
        'streetgen._osm_kerb(kerb, kerb_height) AS kerb, node_id::text AS source_ref FROM %s WHERE class = ''kerb''',
        control));
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS SELECT k.source_ref,
        streetgen._transformed('kerb ' || k.label, ST_Force2D(k.geom::geometry), m.srid) AS source_geom,
        NULL::geometry AS cleaned, k.kerb FROM pg_temp._import_kerb k, streetgen.model m WHERE m.name = model;
    DROP TABLE pg_temp._import_kerb;
    RETURN QUERY WITH unknown AS (DELETE FROM pg_temp._import_part p WHERE kerb IS NULL RETURNING source_ref)
        SELECT 'kerb of which nothing is said, left out', 'kerb', count(*), array_agg(source_ref ORDER BY source_ref)
        FROM unknown HAVING count(*) > 0;
    RETURN QUERY WITH aside AS (DELETE FROM pg_temp._import_part p WHERE NOT EXISTS (
            SELECT FROM footway f WHERE ST_DWithin(f.geom, p.source_geom, 0.5)) RETURNING source_ref)
        SELECT 'kerb on no footway, left out', 'kerb', count(*), array_agg(source_ref ORDER BY source_ref)
        FROM aside HAVING count(*) > 0;
    RETURN QUERY SELECT 'kerbs on footways', kerb, count(*), NULL::text[] FROM pg_temp._import_part GROUP BY kerb
        ORDER BY kerb;
    RETURN QUERY SELECT * FROM streetgen._deliver_if_any(model, 'footway_kerb', control::text);
END $$;
COMMENT ON FUNCTION streetgen._import_osm_kerbs(name, regclass) IS
    'Takes the kerbs of an OSM table of nodes that lie on footways of the model; those that say nothing, or lie on '
    'none, are reported. Importing again follows the table.';
