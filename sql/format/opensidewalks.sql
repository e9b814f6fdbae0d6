-- OpenSidewalks: the network on foot as a graph in GeoJSON, with nodes, kerbs and edges.

CREATE OR REPLACE FUNCTION streetgen._opensidewalks_surface(said text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said IN ('asphalt', 'concrete', 'gravel', 'grass', 'paved', 'paving_stones', 'unpaved', 'dirt',
            'grass_paver') THEN said
        WHEN said LIKE 'concrete:%' THEN 'concrete' WHEN said IN ('fine_gravel', 'pebblestone') THEN 'gravel'
        WHEN said IN ('sett', 'cobblestone', 'unhewn_cobblestone', 'bricks', 'brick') THEN 'paving_stones'
        WHEN said IN ('metal', 'wood') THEN 'paved' WHEN said IN ('earth', 'mud') THEN 'dirt'
        WHEN said IN ('ground', 'compacted', 'sand', 'woodchips', 'rock') THEN 'unpaved' END;
COMMENT ON FUNCTION streetgen._opensidewalks_surface(text) IS
    'The surface of OpenSidewalks that a word of OpenStreetMap is; NULL: none of them.';

CREATE OR REPLACE FUNCTION streetgen._opensidewalks_highway(kind text, class text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN kind = 'steps' THEN 'steps' WHEN kind <> 'street' THEN 'footway'
        WHEN class ~ '^(trunk|primary|secondary|tertiary)(_link)?$' THEN replace(class, '_link', '')
        WHEN class IN ('residential', 'service', 'living_street') THEN class ELSE 'unclassified' END;
COMMENT ON FUNCTION streetgen._opensidewalks_highway(text, text) IS
    'The word highway of an edge of OpenSidewalks: of a kind of link, and of the class of a street.';

CREATE OR REPLACE FUNCTION streetgen._between_kerbs(model name, of_level integer, crossing geometry, OUT low float8,
    OUT high float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT min(share), max(share) INTO low, high
    FROM (SELECT ST_Intersection(crossing, surface) AS part FROM (
            SELECT s.surface FROM section s JOIN edge e USING (edge_id)
                WHERE s.surface && crossing AND e.level = of_level
            UNION ALL SELECT i.surface FROM intersection i WHERE i.surface && crossing AND i.level = of_level) s
            WHERE ST_Intersects(crossing, surface)) p, ST_DumpPoints(part) d,
        LATERAL (SELECT ST_LineLocatePoint(crossing, d.geom) AS share) l;
END $$;
COMMENT ON FUNCTION streetgen._between_kerbs(name, integer, geometry) IS
    'The shares of a crossing (LINESTRING) at which the roadway of a level begins and ends; NULL: it lies on none.';

CREATE OR REPLACE FUNCTION streetgen._opensidewalks_edges(model name, options jsonb)
    RETURNS TABLE(id text, from_id text, to_id text, from_kerb text, to_kerb text, tactile_paving text, edge jsonb,
        geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    box constant geometry := ST_MakeEnvelope((options -> 'extent' ->> 0)::float8, (options -> 'extent' ->> 1)::float8,
        (options -> 'extent' ->> 2)::float8, (options -> 'extent' ->> 3)::float8, srid);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH link AS MATERIALIZED (SELECT * FROM streetgen.walk_links(model, box)),
    -- A crossing goes from kerb to kerb, and short ways lead to it from the walks beside.
    cut AS MATERIALIZED (
        SELECT l.*, CASE WHEN k.low * metres > 0.1 THEN k.low ELSE 0 END AS low,
            CASE WHEN (1 - k.high) * metres > 0.1 THEN k.high ELSE 1 END AS high
        FROM link l LEFT JOIN LATERAL (SELECT * FROM streetgen._between_kerbs(model, l.level, l.geom) b
            WHERE l.kind = 'crossing' AND b.high > b.low) k ON true),
    piece AS (
        SELECT c.*, p.*, from_node::text AS first, to_node::text AS last, walk_link_id::text AS key
        FROM cut c, LATERAL (VALUES (1, 0::float8, low), (2, low, high), (3, high, 1::float8)) p(part, share, until)
        WHERE until > share)
    SELECT CASE part WHEN 2 THEN key ELSE key || '_' || part END,
        CASE WHEN share = 0 THEN first WHEN share = low THEN key || '_from' ELSE key || '_to' END,
        CASE WHEN until = 1 THEN last WHEN until = low THEN key || '_from' ELSE key || '_to' END,
        CASE WHEN part = 2 AND share > 0 THEN coalesce(kerb_from, '') END,
        CASE WHEN part = 2 AND until < 1 THEN coalesce(kerb_to, '') END, l.tactile_paving,
        jsonb_strip_nulls(jsonb_build_object(
            'highway', streetgen._opensidewalks_highway(l.kind, a.kind),
            'footway', CASE WHEN l.kind = 'sidewalk' THEN 'sidewalk' WHEN l.kind = 'crossing' AND part = 2
                THEN 'crossing' END,
            'crossing:markings', CASE WHEN l.kind = 'crossing' AND part = 2 THEN l.marking END,
            'climb', CASE WHEN l.kind = 'steps' THEN l.climb END, 'ext:foot', l.foot,
            'width', CASE WHEN l.width <= 500 THEN round(l.width::numeric, 2) END,
            'incline', round((l.incline / 100)::numeric, 3),
            'length', round(least(metres * (until - share), 5000)::numeric, 2),
            'surface', streetgen._opensidewalks_surface(l.surface), 'name', coalesce(f.name, CASE WHEN l.kind = 'street'
                THEN a.name END), 'ext:wheelchair', l.wheelchair, 'ext:level', nullif(l.level, 0))),
        ST_LineSubstring(l.geom, share, until)
    FROM piece l LEFT JOIN edge e USING (edge_id) LEFT JOIN axis a USING (axis_id)
        LEFT JOIN footway f USING (footway_id);
END $$;
COMMENT ON FUNCTION streetgen._opensidewalks_edges(name, jsonb) IS
    'The edges of OpenSidewalks of a model, each with the ids of its nodes and its properties: the links of walk_link, '
    'crossings cut at their kerbs. from_kerb, to_kerb: what is known of the kerb at this node, empty for nothing; '
    'NULL: there is none.';

CREATE OR REPLACE FUNCTION streetgen.export_opensidewalks(model name, options jsonb DEFAULT '{}')
    RETURNS TABLE(ordinality bigint, line text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET search_path = pg_catalog, public SET work_mem = '4MB'
    AS $$
DECLARE
    known constant jsonb := streetgen._begin_export(model, 'opensidewalks', 'footway', options);
BEGIN
    RETURN QUERY WITH edge AS MATERIALIZED (SELECT * FROM streetgen._opensidewalks_edges(model, known)),
    node AS (
        SELECT node_id, max(kerb) AS kerb, max(tactile) AS tactile, (array_agg(place))[1] AS place
        FROM edge, LATERAL (VALUES (from_id, from_kerb, ST_StartPoint(geom)), (to_id, to_kerb,
            ST_EndPoint(geom))) v(node_id, kerb, place),
            LATERAL (SELECT CASE WHEN kerb IS NOT NULL AND tactile_paving IN ('yes', 'no')
                THEN tactile_paving END AS tactile) t
        GROUP BY node_id),
    feature AS (
        SELECT 1 AS rank, node_id AS id, jsonb_strip_nulls(jsonb_build_object('_id', node_id, 'barrier', CASE
                WHEN kerb IS NOT NULL THEN 'kerb' END, 'kerb', CASE kerb WHEN '' THEN NULL WHEN 'no' THEN 'flush'
                ELSE kerb END, 'tactile_paving', tactile)) AS properties, place AS geom
        FROM node
        UNION ALL SELECT 2, id, edge || jsonb_build_object('_id', id, '_u_id', from_id, '_v_id', to_id), geom
        FROM edge),
    row AS (
        SELECT row_number() OVER (ORDER BY rank, id COLLATE "C") AS n, count(*) OVER () AS rows,
            jsonb_build_object('type', 'Feature', 'geometry', ST_AsGeoJSON(ST_Transform(geom, 4326), 9)::jsonb,
                'properties', properties)::text AS text
        FROM feature)
    SELECT 0::bigint, '{"type": "FeatureCollection", "$schema": '
        '"https://sidewalks.washington.edu/opensidewalks/0.2/schema.json", "features": ['
    UNION ALL SELECT n, text || CASE WHEN n < rows THEN ',' ELSE '' END FROM row
    UNION ALL SELECT (SELECT count(*) FROM feature) + 1, ']}'
    ORDER BY 1;
END $$;
COMMENT ON FUNCTION streetgen.export_opensidewalks(name, jsonb) IS
    'A file of OpenSidewalks (schema 0.2), GeoJSON in WGS 84, a feature a line: nodes, with kerbs where crossings '
    'begin and end, and edges with the ids of both nodes. Links of walk_link are edges: sidewalks, steps, footways and '
    'streets as they are; a crossing goes from kerb to kerb, and short footways lead to it. Needs subject footway '
    '(55000). An option that is unknown or out of its range, or an extent without a street: 22023.';
