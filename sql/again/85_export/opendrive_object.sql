-- OpenDRIVE: objects beside roads, each at its station.

CREATE OR REPLACE FUNCTION streetgen._opendrive_object_kind() RETURNS TABLE(type text, kind text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 15 SET search_path = pg_catalog
    AS $$ VALUES ('crossing', 'crosswalk'), ('pole', 'pole'), ('lamp', 'streetLamp'), ('bollard', 'pole'),
        ('sign', 'pole'), ('traffic_light', 'pole'), ('arrow', 'roadMark'), ('tree', 'tree'), ('hedge', 'vegetation'),
        ('barrier', 'barrier'), ('bench', 'obstacle'), ('kiosk', 'building'), ('bus_stop', 'obstacle'),
        ('parking_bay', 'parkingSpace'), ('manhole', 'patch'), ('runway_light', 'pole') $$;
COMMENT ON FUNCTION streetgen._opendrive_object_kind() IS
    'The type that objects have in OpenDRIVE, by their type or the nearest one above it that stands here.';

-- Corners count from the place of the object, along east and north.
CREATE OR REPLACE FUNCTION streetgen._opendrive_outline(ground geometry, x float8, y float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT '<outlines><outline id="0" closed="true" outer="true">' || string_agg('<cornerLocal u="'
        || round((ST_X(p.geom) - x)::numeric, 4) || '" v="' || round((ST_Y(p.geom) - y)::numeric, 4)
        || '" z="0" height="0"/>', '' ORDER BY p.path[1]) || '</outline></outlines>'
    FROM ST_ExteriorRing(ST_ForcePolygonCCW(ground)) ring, ST_DumpPoints(ring) p WHERE p.path[1] < ST_NPoints(ring) $$;
COMMENT ON FUNCTION streetgen._opendrive_outline(geometry, float8, float8) IS
    'The ground of an object (POLYGON) as an outline about its place x, y.';

CREATE OR REPLACE FUNCTION streetgen._opendrive_objects(computed boolean) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN NOT computed THEN $part$,
object_text AS (SELECT NULL::bigint AS road_id, NULL::text AS text WHERE false)$part$
    ELSE $part$,
object_kind AS MATERIALIZED (
    SELECT t.type, t.size, coalesce((
        WITH RECURSIVE above AS (
            SELECT t.type, t.parent, 0 AS steps
            UNION ALL SELECT p.type, p.parent, steps + 1 FROM above a JOIN %1$I.object_type p ON p.type = a.parent
            WHERE steps < 100)
        SELECT k.kind FROM above JOIN streetgen._opendrive_object_kind() k USING (type) ORDER BY steps LIMIT 1),
        'none') AS kind
    FROM %1$I.object_type t),
road_of_edge AS MATERIALIZED (SELECT edge_id, min(road_id) AS road_id FROM drawn GROUP BY edge_id),
-- An object of an edge that is no road here, and one that no axis places, goes to the nearest street.
standing AS MATERIALIZED (
    SELECT o.street_object_id, o.type, o.angle, o.geom, r.road_id, e.from_node, e.to_node,
        ST_X(place) AS x, ST_Y(place) AS y
    FROM %1$I.street_object o LEFT JOIN %1$I.object_edge g USING (street_object_id)
        LEFT JOIN road_of_edge w ON w.edge_id = g.edge_id,
        LATERAL (SELECT CASE WHEN w.edge_id IS NOT NULL THEN w.edge_id
            WHEN g.edge_id IS NULL OR $1 ->> 'junctions' = 'group'
                    OR g.edge_id IN (SELECT edge_id FROM written_edge) THEN (
                SELECT e.edge_id FROM %1$I.edge e WHERE ST_DWithin(e.geom, o.geom, 50)
                    AND e.edge_id IN (SELECT edge_id FROM road_of_edge)
                ORDER BY ST_Distance(e.geom, o.geom), e.edge_id LIMIT 1) END AS edge_id) n
        JOIN written_edge e ON e.edge_id = n.edge_id JOIN road_of_edge r ON r.edge_id = n.edge_id,
        LATERAL (SELECT CASE WHEN ST_Dimension(o.geom) = 0 THEN o.geom
            ELSE ST_LineInterpolatePoint(o.geom, 0.5) END AS place) c),
own_station AS MATERIALIZED (
    SELECT s.*, p.* FROM standing s JOIN drawn d USING (road_id), streetgen._chain_station(d.s, d.x, d.y, d.heading,
        d.length, d.curvature, d.curvature_end, s.x, s.y) p),
-- Beyond the end of its road it stands at a road across the node, where that is nearer.
stationed AS MATERIALIZED (
    SELECT o.street_object_id, o.type, o.angle, o.geom, o.x, o.y, coalesce(c.road_id, o.road_id) AS road_id,
        coalesce(c.station, o.station) AS station, coalesce(c.aside, o.aside) AS aside,
        coalesce(c.direction, o.direction) AS direction, coalesce(c.beyond, o.beyond) AS beyond
    FROM own_station o LEFT JOIN LATERAL (
        SELECT c.road_id, p.* FROM connecting c, streetgen._chain_station(c.s, c.x, c.y, c.heading, c.length,
            c.curvature, c.curvature_end, o.x, o.y) p
        WHERE abs(o.beyond) > 0.01 AND c.node_id IN (o.from_node, o.to_node) AND abs(p.beyond) <= 0.01
            AND abs(p.aside) <= sqrt(o.aside ^ 2 + o.beyond ^ 2)
        ORDER BY abs(p.aside), c.road_id LIMIT 1) c ON true),
grounded AS (
    SELECT s.*, k.kind, k.size, CASE
        WHEN ST_Dimension(geom) = 1 THEN ST_Buffer(geom, k.size / 2, 'endcap=flat join=mitre mitre_limit=2')
        WHEN c.street_object_id IS NOT NULL THEN c.surface WHEN b.street_object_id IS NOT NULL THEN b.surface
        -- What lies beside no road says by its corners where it is.
        WHEN abs(beyond) > 0.01 THEN ST_Buffer(geom, k.size / 2, 'quad_segs=2') END AS ground
    FROM stationed s JOIN object_kind k USING (type)
        LEFT JOIN %1$I.pedestrian_crossing c USING (street_object_id)
        LEFT JOIN %1$I.parking_bay b USING (street_object_id)),
object_text AS MATERIALIZED (
    SELECT road_id, '<objects>' || string_agg(streetgen._opendrive_open(xmlelement(name object, xmlattributes(
            street_object_id AS id, streetgen._xml_text(type) AS name, kind AS type,
            streetgen._decimal(station, 4) AS s, streetgen._decimal(aside, 4) AS t,
            0 AS "zOffset", 'none' AS orientation, streetgen._decimal(CASE
                WHEN outlined THEN -direction ELSE pi() / 2 - radians(coalesce(angle, 0)) - direction END, 6) AS hdg,
            CASE WHEN kind = 'tree' AND NOT outlined THEN size / 2 END AS radius,
            CASE WHEN kind <> 'tree' AND NOT outlined THEN size END AS length,
            CASE WHEN kind <> 'tree' AND NOT outlined THEN size END AS width)))
        || CASE WHEN outlined THEN streetgen._opendrive_outline(ground, x, y) ELSE '' END
        || CASE WHEN kind = 'parkingSpace' THEN '<parkingSpace access="all"/>' ELSE '' END
        || '</object>', '' ORDER BY street_object_id) || '</objects>' AS text
    FROM grounded, LATERAL (SELECT ST_GeometryType(ground) IS NOT DISTINCT FROM 'ST_Polygon' AS outlined) o
    GROUP BY road_id)$part$ END $$;
COMMENT ON FUNCTION streetgen._opendrive_objects(boolean) IS
    'Query object_text of a file of OpenDRIVE, after streetgen._opendrive_roads(): the element objects of each road; '
    'nothing of a model that computes none.';
