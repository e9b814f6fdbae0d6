-- Buses stand at a stop on a parking lane, which then is their bay, or else on the lane beside the kerb.

CREATE OR REPLACE FUNCTION streetgen._zigzag(middle geometry, width float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Multi(ST_Buffer(ST_MakeLine(streetgen._place_on(middle::bytea, length * k / strokes,
            CASE k % 2 WHEN 0 THEN aside ELSE -aside END)::geometry ORDER BY k), 0.06, 'endcap=flat join=mitre'))
    FROM (SELECT ST_Length2D(middle) AS length, greatest(2, round(ST_Length2D(middle) / 2))::integer AS strokes,
            greatest(0, width / 2 - 0.3) AS aside) l, generate_series(0, strokes) k $$;
COMMENT ON FUNCTION streetgen._zigzag(geometry, float8) IS
    'The paint (MULTIPOLYGON) of a zigzag line along a middle (LINESTRING), on ground of a width (m): strokes of 12 cm '
    'that end 30 cm before its borders and each take about 2 m of the middle.';

CREATE OR REPLACE FUNCTION streetgen._make_object_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT '{object,lane}' <@ streetgen._subjects(model) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._part_in('bus_stop_box', model);
    COMMENT ON VIEW bus_stop_box IS
        'Where a bus stands at each stop, on the outermost lane of its side that is general, for buses or for parking; '
        'of models with subject lane. It ends 1 m beyond the stop, or 1 m before a crossing, and is as long as setting '
        'bus_stop_length, but for crossings and the ends of the lane. Computed when it is asked for. A stop has no row '
        'where less than 5 m of lane are left, or no lane';
    COMMENT ON COLUMN bus_stop_box.street_object_id IS 'the stop: an object of type bus_stop, or of one below it';
    COMMENT ON COLUMN bus_stop_box.edge_id IS 'its edge';
    COMMENT ON COLUMN bus_stop_box.lane_id IS 'the lane';
    COMMENT ON COLUMN bus_stop_box.level IS 'the level of the edge';
    COMMENT ON COLUMN bus_stop_box.kind IS
        'bay: buses stand on a parking lane, beside those who drive; mark: on a lane that others drive on';
    COMMENT ON COLUMN bus_stop_box.width IS 'the width of the lane, metres';
    COMMENT ON COLUMN bus_stop_box.surface IS 'its ground';
    COMMENT ON COLUMN bus_stop_box.paint IS 'its paint: a zigzag line 12 cm wide, from one end to the other';
END $$;
COMMENT ON FUNCTION streetgen._make_object_views(name) IS
    'Makes view bus_stop_box of a model, where it computes objects and lanes.';

CREATE OR REPLACE FUNCTION streetgen._object_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ SELECT 'bus_stop_box'::name, subject FROM unnest('{lane,object}'::text[]) subject $$;
COMMENT ON FUNCTION streetgen._object_view() IS 'The view of bus stops, and the subjects whose tables it reads.';
