-- Lines of classes of use rail, and streets with rails in them: they become tracks.

CREATE OR REPLACE FUNCTION streetgen._track_input() RETURNS TABLE(name text, type text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 4 SET search_path = pg_catalog
    AS $$ VALUES ('gauge', 'integer'), ('tracks', 'integer'), ('rails', 'text'), ('rails_embedded', 'boolean') $$;
COMMENT ON FUNCTION streetgen._track_input() IS
    'The columns that a track has of a source and an axis has not, with their types. rails: class of the track that '
    'lies in a street; rails_embedded: it may be mapped apart too.';

CREATE OR REPLACE FUNCTION streetgen._osm_rails(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said IN ('tram', 'light_rail') THEN said END;
COMMENT ON FUNCTION streetgen._osm_rails(text) IS
    'The class of the track that tag railway or embedded_rails of a street says; NULL where it says none.';

CREATE OR REPLACE FUNCTION streetgen._osm_gauge(said text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    -- The first of several gauges is that of the trams.
    AS $$ SELECT CASE WHEN gauge BETWEEN 300 AND 3000 THEN gauge END
        FROM (SELECT substring(said FROM '^\s*(\d{3,4})(?!\d)')::integer AS gauge) g $$;
COMMENT ON FUNCTION streetgen._osm_gauge(text) IS
    'Millimetres from rail to rail, 300 to 3000, of tag gauge; NULL where it says none.';

CREATE OR REPLACE FUNCTION streetgen._osm_tracks(said text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said ~ '^[1-4]$' THEN said::integer END;
COMMENT ON FUNCTION streetgen._osm_tracks(text) IS 'The number from 1 to 4 of tag tracks; NULL where it says none.';

CREATE OR REPLACE FUNCTION streetgen._part_tracks() RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    CREATE TEMPORARY TABLE _import_rail_track ON COMMIT DROP AS
        SELECT p.source_ref, p.source_geom, NULL::geometry AS cleaned, CASE c.use WHEN 'rail' THEN p.class
                ELSE p.rails END AS kind, p.gauge, coalesce(p.tracks, 1) AS tracks, coalesce(p.level, 0) AS level,
            p.name, c.use IS DISTINCT FROM 'rail' AND coalesce(p.rails_embedded, false) AS embedded
        FROM pg_temp._import_part p LEFT JOIN pg_temp._import_class c ON c.class = p.class
        WHERE c.use = 'rail' OR p.rails IS NOT NULL;
    DELETE FROM pg_temp._import_part p USING pg_temp._import_class c WHERE c.class = p.class AND c.use = 'rail';
    DELETE FROM pg_temp._import i USING pg_temp._import_class c WHERE c.class = i.class AND c.use = 'rail';
    -- Tracks mostly are lines of their own, and the street says that they lie in it.
    DELETE FROM pg_temp._import_rail_track t WHERE t.embedded AND (
        SELECT ST_Length(ST_Intersection(t.source_geom, ST_Union(ST_Buffer(o.source_geom, 12))))
        FROM pg_temp._import_rail_track o WHERE NOT o.embedded AND o.level = t.level
            AND o.source_geom && ST_Expand(t.source_geom, 12)) > ST_Length(t.source_geom) / 2;
    ALTER TABLE pg_temp._import_rail_track DROP COLUMN embedded;
END $$;
COMMENT ON FUNCTION streetgen._part_tracks() IS
    'Parts the lines of the import whose class is rail from those that become axes, and gives each street with rails '
    'in it a track along its line, where none is mapped beside it.';
