CREATE OR REPLACE FUNCTION streetgen._osm_metres(value text) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE
        WHEN value ~ '^\s*\d+(\.\d+)?\s*m?\s*$' THEN substring(value FROM '\d+(?:\.\d+)?')::float8
        WHEN value ~ '^\s*\d+(\.\d+)?\s*(ft|'')\s*$' THEN substring(value FROM '\d+(?:\.\d+)?')::float8 * 0.3048
        WHEN value ~ '^\s*\d+''\s*\d+(\.\d+)?"\s*$' THEN substring(value FROM '^\s*(\d+)')::float8 * 0.3048 + substring(value FROM '''\s*(\d+(?:\.\d+)?)')::float8 * 0.0254
    END $$;
COMMENT ON FUNCTION streetgen._osm_metres(text) IS 'An OSM length in metres: 7, 7.5 m, 23 ft, 12''6"; NULL where it is no length.';

CREATE OR REPLACE FUNCTION streetgen._osm_speed(value text) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE
        WHEN value ~ '^\s*\d+(\.\d+)?\s*(km/h|kph)?\s*$' THEN substring(value FROM '\d+(?:\.\d+)?')::float8
        WHEN value ~ '^\s*\d+(\.\d+)?\s*mph\s*$' THEN substring(value FROM '\d+(?:\.\d+)?')::float8 * 1.609344
        WHEN value ~ ':urban$' THEN 50 WHEN value ~ ':rural$' THEN 80 WHEN value ~ ':motorway$' THEN 120 WHEN value ~ '(:living_street|^walk)$' THEN 10
    END $$;
COMMENT ON FUNCTION streetgen._osm_speed(text) IS 'An OSM maxspeed in km/h: 50, 30 mph, FR:urban; NULL where it is no speed.';

CREATE OR REPLACE FUNCTION streetgen._osm_count(value text) RETURNS integer
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN value ~ '^\s*\d{1,2}(\.0+)?\s*$' THEN substring(value FROM '\d+')::integer END $$;
COMMENT ON FUNCTION streetgen._osm_count(text) IS 'An OSM number of lanes; NULL where it is none.';

CREATE OR REPLACE FUNCTION streetgen.import_osm(model name, prefix text DEFAULT 'osm', schemas name[] DEFAULT current_schemas(true))
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    source regclass := (
        SELECT c.oid FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace
        WHERE c.relname = prefix || '_line' AND n.nspname = ANY (schemas) OR n.nspname || '.' || c.relname = prefix || '_line'
        ORDER BY array_position(schemas, n.nspname) LIMIT 1);
BEGIN
    IF source IS NULL THEN
        RAISE EXCEPTION 'there is no table %', quote_ident(prefix || '_line') USING ERRCODE = '42P01',
            HINT = 'osm2pgsql -O flex -S data/osm2pgsql_flex.lua makes it; a schema that is not in search_path stands before the prefix: ''gis.osm''.';
    END IF;
    PERFORM streetgen._take_classes(model);
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, format($sql$
SELECT geom, CASE WHEN metres <= 200 THEN metres END AS width, NULL::float8 AS width_end, coalesce(lanes_both, lanes_sum) AS lane_count,
       CASE WHEN oneway IN ('yes', 'true', '1') THEN 'direct' WHEN oneway IN ('-1', 'reverse') THEN 'reverse' WHEN oneway IN ('no', 'false', '0') THEN 'both'
            WHEN junction IN ('roundabout', 'circular') OR class IN ('motorway', 'motorway_link') THEN 'direct' ELSE 'both' END AS direction,
       CASE WHEN kmh <= 400 THEN kmh END AS speed, NULL::integer AS importance, name,
       coalesce(CASE WHEN layer ~ '^[-+]?\d{1,2}$' THEN greatest(-50, least(50, layer::integer)) END,
                CASE WHEN coalesce(bridge, 'no') <> 'no' THEN 1 WHEN coalesce(tunnel, 'no') <> 'no' THEN -1 ELSE 0 END) AS level,
       class, NULL::float8 AS radius, way_id::text AS source_ref, NULL::text AS left_out,
       array_remove(ARRAY[CASE WHEN width IS NOT NULL AND (metres <= 200) IS NOT TRUE THEN 'width' END,
                          CASE WHEN lanes IS NOT NULL AND lanes_both IS NULL OR coalesce(lanes_forward, lanes_backward) IS NOT NULL AND coalesce(lanes_both, lanes_sum) IS NULL THEN 'lane_count' END,
                          CASE WHEN maxspeed NOT IN ('none', 'signals', 'variable') AND (kmh <= 400) IS NOT TRUE THEN 'speed' END,
                          CASE WHEN oneway NOT IN ('yes', 'true', '1', '-1', 'reverse', 'no', 'false', '0', 'reversible', 'alternating') THEN 'direction' END,
                          CASE WHEN layer !~ '^[-+]?\d{1,2}$' THEN 'level' END], NULL) AS unread
FROM %s, streetgen._osm_metres(width) metres, streetgen._osm_speed(maxspeed) kmh,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS lanes_both FROM streetgen._osm_count(lanes) n) b,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS lanes_sum FROM (SELECT streetgen._osm_count(lanes_forward) + streetgen._osm_count(lanes_backward) AS n) m) s$sql$, source));
END $$;
COMMENT ON FUNCTION streetgen.import_osm(name, text, name[]) IS 'Imports the table PREFIX_line that osm2pgsql writes with data/osm2pgsql_flex.lua, found in the schemas of search_path or named with its schema (gis.osm): lanes, width, oneway (also -1), roundabouts, layer, bridge, tunnel, maxspeed (also mph), name, class. A tag that means nothing (width abc, or over 200 m) is unknown, and reported by way.';
