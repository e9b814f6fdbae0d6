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

CREATE OR REPLACE FUNCTION streetgen._osm_table(suffix text, prefix text, schemas name[]) RETURNS regclass
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT c.oid FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace
    WHERE c.relname = prefix || suffix AND n.nspname = ANY (schemas) OR n.nspname || '.' || c.relname = prefix || suffix
    ORDER BY array_position(schemas, n.nspname) LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._osm_table(text, text, name[]) IS 'The table PREFIX followed by the suffix, in the first of the schemas that has it or in the schema that the prefix names; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._import_restrictions(model name, line regclass, restriction regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    IF restriction IS NULL THEN
        RETURN QUERY SELECT 'no table of turn restrictions, those of the model stay', NULL::text, 0::bigint, NULL::text[];
        RETURN;
    END IF;
    EXECUTE format($sql$
CREATE TEMPORARY TABLE _import_restriction ON COMMIT DROP AS
SELECT relation_id::text AS relation, concat_ws('/', relation_id, from_way, to_way) AS source_ref, restriction AS class,
       a.axis_id AS from_axis, b.axis_id AS to_axis, substring(restriction FROM '^(no|only)_') AS kind,
       CASE substring(restriction FROM '^(?:no|only)_(.*)$') WHEN 'left_turn' THEN 'left' WHEN 'right_turn' THEN 'right' WHEN 'straight_on' THEN 'through' WHEN 'u_turn' THEN 'u_turn' END AS turn,
       ST_Transform(ST_Force2D(ST_GeometryN(ST_CollectionExtract(r.geom, 1), 1)), (SELECT srid FROM streetgen.model WHERE name = %4$L)) AS geom,
       CASE WHEN restriction IS NULL THEN 'not for all traffic'
            WHEN restriction !~ '^(no|only)_(left_turn|right_turn|straight_on|u_turn)$|^no_(entry|exit)$' THEN 'not understood'
            WHEN via_way THEN 'via a way' WHEN ST_IsEmpty(ST_CollectionExtract(r.geom, 1)) THEN 'without a place'
            WHEN a.axis_id IS NULL OR b.axis_id IS NULL THEN 'of ways that are no axes' END AS left_out
FROM %1$s r LEFT JOIN %2$I.axis a ON (a.source, a.source_ref) = (%3$L, from_way::text) LEFT JOIN %2$I.axis b ON (b.source, b.source_ref) = (%3$L, to_way::text)
$sql$, restriction, model, line::text, model);
    RETURN QUERY SELECT 'turn restriction ' || r.left_out || ', left out', r.class, count(*), array_agg(DISTINCT r.relation) FROM _import_restriction r
        WHERE r.left_out IS NOT NULL GROUP BY r.left_out, r.class ORDER BY 1, 2;
    DELETE FROM _import_restriction r WHERE r.left_out IS NOT NULL;
    EXECUTE format('DELETE FROM %I.turn_restriction t WHERE source = %L AND NOT EXISTS (SELECT FROM _import_restriction r WHERE r.source_ref = t.source_ref)', model, restriction::text);
    EXECUTE format($sql$
INSERT INTO %I.turn_restriction AS t (from_axis, to_axis, geom, kind, turn, source, source_ref)
SELECT DISTINCT ON (source_ref) from_axis, to_axis, geom, kind, turn, %L, source_ref FROM _import_restriction ORDER BY source_ref
ON CONFLICT (source, source_ref) DO UPDATE SET from_axis = excluded.from_axis, to_axis = excluded.to_axis, geom = excluded.geom, kind = excluded.kind, turn = excluded.turn
WHERE (t.from_axis, t.to_axis, t.geom::bytea, t.kind, t.turn) IS DISTINCT FROM (excluded.from_axis, excluded.to_axis, excluded.geom::bytea, excluded.kind, excluded.turn)
$sql$, model, restriction::text);
    RETURN QUERY SELECT 'turn restrictions', r.class, count(*), NULL::text[] FROM _import_restriction r GROUP BY r.class ORDER BY r.class;
    DROP TABLE _import_restriction;
END $$;
COMMENT ON FUNCTION streetgen._import_restrictions(name, regclass, regclass) IS 'Takes the turn restrictions of an OSM table between ways that are axes, at a node; importing again follows the table. Those via a way, for some traffic only, of unknown wording or of ways that are no axes are left out and reported. A NULL table leaves all as it was.';

CREATE OR REPLACE FUNCTION streetgen.import_osm(model name, prefix text DEFAULT 'osm', schemas name[] DEFAULT current_schemas(true))
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    source regclass := streetgen._osm_table('_line', prefix, schemas);
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
    RETURN QUERY SELECT * FROM streetgen._import_restrictions(model, source, streetgen._osm_table('_restriction', prefix, schemas));
END $$;
COMMENT ON FUNCTION streetgen.import_osm(name, text, name[]) IS 'Imports the table PREFIX_line that osm2pgsql writes with data/osm2pgsql_flex.lua, found in the schemas of search_path or named with its schema (gis.osm): lanes, width, oneway (also -1), roundabouts, layer, bridge, tunnel, maxspeed (also mph), name, class; and the turn restrictions of PREFIX_restriction. A tag that means nothing (width abc, or over 200 m) is unknown, and reported by way.';
