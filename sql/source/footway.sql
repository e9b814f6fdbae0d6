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
END $$;
COMMENT ON FUNCTION streetgen._part_footways(name) IS
    'Parts the lines of the import whose class is no roadway from those that become axes.';

CREATE OR REPLACE FUNCTION streetgen._deliver_footways(model name, source text, among text[] DEFAULT NULL)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT EXISTS (SELECT FROM pg_temp._import_footway) AND NOT EXISTS (SELECT FROM delivered d
        WHERE d.relation = 'footway' AND d.source = origin) THEN
        DROP TABLE pg_temp._import_footway;
        RETURN;
    END IF;
    ALTER TABLE pg_temp._import_footway DROP COLUMN use;
    ALTER TABLE pg_temp._import_footway RENAME TO _import_part;
    RETURN QUERY SELECT * FROM streetgen._deliver_rows(model, 'footway', source, among);
END $$;
COMMENT ON FUNCTION streetgen._deliver_footways(name, text, text[]) IS
    'Brings the footways of a source, or those among some source_refs, up to date with the lines that were parted from '
    'its axes; reports what is by hand.';
