-- Areas of OpenStreetMap: which are of the street, and of what kind.

CREATE OR REPLACE FUNCTION streetgen._osm_area_class(tags jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN tags ? 'area:highway' THEN tags ->> 'area:highway'
        WHEN 'platform' IN (tags ->> 'highway', tags ->> 'railway', tags ->> 'public_transport') THEN 'platform'
        WHEN tags ->> 'amenity' = 'parking' THEN 'parking'
        WHEN tags ? 'highway' THEN tags ->> 'highway' WHEN tags ->> 'place' = 'square' THEN 'square' END;
COMMENT ON FUNCTION streetgen._osm_area_class(jsonb) IS
    'The word that says what an area of OpenStreetMap is: that of area:highway, platform, parking, that of highway, or '
    'square.';

CREATE OR REPLACE FUNCTION streetgen._osm_area_kind(class text, use text, tags jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN class IN ('pedestrian', 'square') THEN 'square' WHEN class = 'parking' THEN 'parking_area'
        WHEN class = 'platform' THEN 'platform' WHEN use = 'walk' AND tags ->> 'footway' = 'sidewalk' THEN 'sidewalk'
        WHEN use IN ('roadway', 'cycle', 'walk', 'steps') THEN use END;
COMMENT ON FUNCTION streetgen._osm_area_kind(text, text, jsonb) IS
    'The kind of an area of OpenStreetMap by its class, axis_class.use of that, and its tags; NULL: none is known.';

CREATE OR REPLACE FUNCTION streetgen._osm_area_left_out(tags jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN streetgen._osm_off_street(tags) THEN 'area within a building or on another floor, left out'
        WHEN tags ->> 'parking' IN ('underground', 'multi-storey', 'rooftop', 'sheds', 'carports', 'garage_boxes')
            THEN 'car park within a building, left out'
        WHEN tags ->> 'parking' IN ('street_side', 'lane', 'on_kerb', 'half_on_kerb', 'shoulder', 'layby')
            THEN 'bays of a street, left out as an area' END;
COMMENT ON FUNCTION streetgen._osm_area_left_out(jsonb) IS
    'Why an area of OpenStreetMap is left out whatever its kind; NULL: it is not.';

CREATE OR REPLACE FUNCTION streetgen._import_osm_areas(model name, areas regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- An older flex file writes no such table.
    IF areas IS NULL THEN
        RETURN;
    END IF;
    PERFORM streetgen._take_points('_import_tagged', format('SELECT geom, name, tags, '
        'coalesce(way_id::text, ''relation/'' || relation_id) AS source_ref FROM %s', areas));
    CREATE TEMPORARY TABLE _import_area ON COMMIT DROP AS
        SELECT a.geom, a.name, a.source_ref, a.label, k.class,
            streetgen._osm_area_kind(k.class, c.use, a.tags) AS kind,
            streetgen._osm_area_left_out(a.tags) AS left_out, streetgen._osm_level(a.tags)::text AS level,
            a.tags ->> 'surface' AS surface, streetgen._osm_foot(a.tags ->> 'foot', a.tags ->> 'access') AS foot
        FROM pg_temp._import_tagged a, LATERAL (SELECT streetgen._osm_area_class(a.tags) AS class) k
            LEFT JOIN axis_class c ON c.class = k.class;
    DROP TABLE pg_temp._import_tagged;
    RETURN QUERY WITH unused AS (DELETE FROM pg_temp._import_area a WHERE left_out IS NOT NULL OR kind IS NULL
            RETURNING coalesce(left_out, 'area of no kind that is known, left out') AS reason, class, source_ref)
        SELECT reason, class, count(*), array_agg(source_ref ORDER BY source_ref) FROM unused
        GROUP BY reason, class ORDER BY reason, class;
    RETURN QUERY SELECT * FROM streetgen._deliver_areas(model, areas::text);
END $$;
COMMENT ON FUNCTION streetgen._import_osm_areas(name, regclass) IS
    'Takes the areas of an OSM table; those within buildings, bays of streets and those of no known kind are reported. '
    'Importing again follows the table. NULL leaves all as it was.';
