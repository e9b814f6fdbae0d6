-- OpenDRIVE: objects beside roads, each at its station.

CREATE OR REPLACE FUNCTION streetgen._opendrive_object_kind() RETURNS TABLE(type text, kind text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ VALUES ('crossing', 'crosswalk'), ('pole', 'pole'), ('lamp', 'streetLamp'), ('bollard', 'pole'),
        ('sign', 'pole'), ('traffic_light', 'pole'), ('arrow', 'roadMark'), ('tree', 'tree'), ('hedge', 'vegetation'),
        ('barrier', 'barrier'), ('bench', 'obstacle'), ('kiosk', 'building'), ('bus_stop', 'obstacle'),
        ('tram_stop', 'obstacle'), ('platform', 'obstacle'),
        ('parking_bay', 'parkingSpace'), ('manhole', 'patch'), ('runway_light', 'pole'),
        ('traffic_calming', 'patch'), ('traffic_island', 'trafficIsland') $$;
COMMENT ON FUNCTION streetgen._opendrive_object_kind() IS
    'The type that objects have in OpenDRIVE, by their type or the nearest one above it that stands here.';

-- Corners count from a place, along east and north.
CREATE OR REPLACE FUNCTION streetgen._opendrive_outline(ground geometry, x float8, y float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT '<outline id="0" closed="true" outer="true">' || string_agg('<cornerLocal u="'
        || round((ST_X(p.geom) - x)::numeric, 4) || '" v="' || round((ST_Y(p.geom) - y)::numeric, 4)
        || '" z="0" height="0"/>', '' ORDER BY p.path[1]) || '</outline>'
    FROM ST_ExteriorRing(ST_ForcePolygonCCW(ground)) ring, ST_DumpPoints(ring) p WHERE p.path[1] < ST_NPoints(ring) $$;
COMMENT ON FUNCTION streetgen._opendrive_outline(geometry, float8, float8) IS
    'The ground of an object (POLYGON) as an outline about a place x, y.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_objects(model name)
    RETURNS TABLE(street_object_id bigint, type text, angle float8, geom geometry, edge_id bigint, kind text,
        size float8, drawn boolean, surface geometry, subtype text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY WITH object_kind AS MATERIALIZED (
        SELECT t.type, t.size, coalesce((
            WITH RECURSIVE above AS (
                SELECT t.type, t.parent, 0 AS steps
                UNION ALL SELECT p.type, p.parent, a.steps + 1 FROM above a JOIN object_type p ON p.type = a.parent
                WHERE a.steps < 100)
            SELECT k.kind FROM above a JOIN streetgen._opendrive_object_kind() k ON k.type = a.type
                ORDER BY a.steps LIMIT 1),
            'none') AS kind
        FROM object_type t)
    SELECT o.street_object_id, o.type, o.angle, o.geom, e.edge_id, k.kind, k.size,
        c.street_object_id IS NOT NULL OR b.street_object_id IS NOT NULL,
        CASE WHEN c.street_object_id IS NOT NULL THEN c.surface ELSE b.surface END,
        CASE WHEN c.painted_as IN ('zebra', 'ladder') THEN 'zebra' WHEN c.painted_as = 'no' THEN 'virtual'
            WHEN c.painted_as IS NOT NULL THEN 'pedestrian' END
    FROM street_object o JOIN object_kind k ON k.type = o.type
        LEFT JOIN object_edge e ON e.street_object_id = o.street_object_id
        LEFT JOIN pedestrian_crossing c ON c.street_object_id = o.street_object_id
        LEFT JOIN parking_bay b ON b.street_object_id = o.street_object_id;
END $$;
COMMENT ON FUNCTION streetgen._opendrive_objects(name) IS
    'The objects of a model with their edge, the kind that their type has in OpenDRIVE, and the surface of those that '
    'are drawn, crossings and bays; of crossings the subtype by their paint; none of a model that computes no objects.';
