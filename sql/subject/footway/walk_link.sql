-- The network of what people walk on, computed when it is asked for.

CREATE OR REPLACE FUNCTION streetgen._walked_by_wheelchair(kind text, said text, width float8, kerb_from text,
    kerb_to text, incline float8) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN said IS NOT NULL THEN said
        WHEN kind = 'steps' OR width < 0.8 OR 'raised' IN (kerb_from, kerb_to) OR abs(incline) > 12 THEN 'no'
        WHEN width < 1.2 OR 'rolled' IN (kerb_from, kerb_to) OR abs(incline) > 6 THEN 'limited' END;
COMMENT ON FUNCTION streetgen._walked_by_wheelchair(text, text, float8, text, text, float8) IS
    'Whether a wheelchair gets along a walk: yes, limited or no, as is said of it; else no on steps, over raised '
    'kerbs, where it is narrower than 0.8 m or steeper than 12 %, and limited over rolled kerbs, under 1.2 m or beyond '
    '6 %. NULL: nothing speaks against it.';

CREATE OR REPLACE FUNCTION streetgen._walk_surroundings(model name, extent geometry) RETURNS geometry
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT ST_Expand(ST_SetSRID(ST_Extent(geom)::geometry, ST_SRID(extent)), 50) FROM (
        SELECT extent AS geom UNION ALL SELECT geom FROM footway WHERE geom && extent
        UNION ALL SELECT ST_Expand(geom, 50) FROM street_area WHERE geom && ST_Expand(extent, 20)
        UNION ALL SELECT geom FROM edge WHERE geom && ST_Expand(extent, 50)) g);
END $$;
COMMENT ON FUNCTION streetgen._walk_surroundings(name, geometry) IS
    'The box of all whose lines decide where those that touch an extent meet others; NULL: all of the model.';

CREATE OR REPLACE FUNCTION streetgen._walk_barriers(model name, around geometry)
    RETURNS TABLE(footway_id bigint, type text, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'object' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT f.footway_id, o.type, o.geom FROM street_object o JOIN object_type t ON t.type = o.type,
            LATERAL (SELECT * FROM footway f WHERE f.geom && ST_Expand(o.geom, 0.5) OFFSET 0) f
            WHERE t.category = 'protection' AND (around IS NULL OR o.geom && around)
                AND ST_DWithin(o.geom, f.geom, 0.5);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._walk_barriers(name, geometry) IS
    'Objects of category protection on footways within a box, NULL: all: bollards, barriers, guard rails.';

CREATE OR REPLACE FUNCTION streetgen.walk_links(model name, extent geometry DEFAULT NULL)
    RETURNS TABLE(walk_link_id bigint, kind text, from_node bigint, to_node bigint, level integer, metres float8,
        width float8, kerb_from text, kerb_to text, marking text, surface text, incline float8, climb text,
        tactile_paving text, wheelchair text, foot text, barriers text[], footway_id bigint, edge_id bigint,
        side text, street_object_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 10000 SET jit = off SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    around geometry;
    least_width float8;
    areas boolean;
BEGIN
    PERFORM streetgen._require_reader(model), streetgen._require_subject(model, 'footway'),
        streetgen._use_model(model);
    IF extent IS NOT NULL AND ST_SRID(extent) <> srid THEN
        RAISE EXCEPTION 'the extent has SRID %, the model %', ST_SRID(extent), srid USING ERRCODE = '22023',
            HINT = format('ST_Transform(extent, %s) brings it there.', srid);
    END IF;
    around := streetgen._walk_surroundings(model, extent);
    areas := EXISTS (SELECT FROM street_area a WHERE around IS NULL OR a.geom && around);
    least_width := streetgen._setting_number(model, 'mapped_sidewalk_minimal');
    RETURN QUERY WITH line AS MATERIALIZED (SELECT * FROM streetgen._walk_lines(model, around)),
    crossing AS MATERIALIZED (SELECT * FROM streetgen._known_crossings(model, around)),
    barrier AS MATERIALIZED (SELECT * FROM streetgen._walk_barriers(model, around)),
    network AS MATERIALIZED (
        SELECT n.*, l.kind AS of_kind, l.level, l.width, l.footway_id, l.edge_id, l.side, l.street_object_id
        FROM streetgen._walk_network(ARRAY(SELECT geom::bytea FROM line ORDER BY number),
                ARRAY(SELECT level FROM line ORDER BY number), ARRAY(SELECT mapped FROM line ORDER BY number),
                ARRAY(SELECT reach_start FROM line ORDER BY number), ARRAY(SELECT reach_end FROM line ORDER BY number),
                ARRAY(SELECT excess_start FROM line ORDER BY number),
                ARRAY(SELECT excess_end FROM line ORDER BY number), srid) n
            JOIN line l ON l.number = n.line),
    -- A node of several levels is one of each.
    node AS MATERIALIZED (
        SELECT DISTINCT ON (node_id, level) node_id, level, place FROM network, LATERAL (VALUES (from_node,
            ST_StartPoint(geom)), (to_node, ST_EndPoint(geom))) v(node_id, place)
        WHERE areas ORDER BY node_id, level),
    over_area AS MATERIALIZED (
        SELECT * FROM streetgen._area_walks(model, around, ARRAY(SELECT node_id FROM node ORDER BY node_id, level),
            ARRAY(SELECT level FROM node ORDER BY node_id, level),
            ARRAY(SELECT place FROM node ORDER BY node_id, level),
            ARRAY(SELECT from_node FROM network ORDER BY walk_link_id),
            ARRAY(SELECT to_node FROM network ORDER BY walk_link_id),
            ARRAY(SELECT ST_Length(geom) FROM network ORDER BY walk_link_id)) a
        WHERE areas),
    -- Nobody enters an area over which no walk leads.
    link AS MATERIALIZED (SELECT * FROM network n WHERE (extent IS NULL OR n.geom && extent)
        AND (of_kind <> 'square' OR EXISTS (SELECT FROM over_area a WHERE n.to_node IN (a.from_node, a.to_node)))),
    -- A walk of a source that leads over a roadway with sidewalks crosses it.
    over_street AS MATERIALIZED (
        SELECT DISTINCT ON (l.line, l.part) l.line, l.part, e.crosses, c.width, c.marking, c.street_object_id,
            CASE WHEN to_right THEN c.kerb_left ELSE c.kerb_right END AS kerb_from,
            CASE WHEN to_right THEN c.kerb_right ELSE c.kerb_left END AS kerb_to
        FROM link l, LATERAL (SELECT e.edge_id, e.sidewalk_left + e.sidewalk_right > 0 AND ST_Crosses(e.geom, l.geom)
                    AS crosses, ST_Length(e.geom) * ST_LineLocatePoint(e.geom, ST_ClosestPoint(e.geom, l.geom))
                    AS abscissa,
                    (streetgen._locate_on(ST_Force2D(e.geom)::bytea, ST_StartPoint(l.geom)::bytea))[2]
                        > (streetgen._locate_on(ST_Force2D(e.geom)::bytea, ST_EndPoint(l.geom)::bytea))[2] AS to_right
                FROM edge e WHERE e.geom && ST_Expand(l.geom, 0.5) AND e.level = l.level
                    AND ST_DWithin(e.geom, l.geom, 0.5) OFFSET 0) e
            LEFT JOIN crossing c ON c.edge_id = e.edge_id AND abs(c.abscissa - e.abscissa) <= 5
        WHERE of_kind IN ('walk', 'crossing') ORDER BY l.line, l.part, crosses DESC,
            c.street_object_id IS DISTINCT FROM l.street_object_id, abs(c.abscissa - e.abscissa)),
    barred AS MATERIALIZED (
        SELECT l.line, l.part, array_agg(DISTINCT b.type ORDER BY b.type) AS barriers
        FROM barrier b JOIN link l USING (footway_id) WHERE ST_DWithin(b.geom, l.geom, 0.5) GROUP BY l.line, l.part)
    SELECT walk_link_id, k.kind, from_node, to_node, l.level, ST_Length(l.geom),
        coalesce(c.width, l.width, CASE WHEN k.kind NOT IN ('crossing', 'square')
            THEN least_width END), kerbs.kerb_from,
        kerbs.kerb_to, c.marking, f.surface, f.incline, f.climb, f.tactile_paving,
        streetgen._walked_by_wheelchair(k.kind, f.wheelchair, f.width, kerbs.kerb_from, kerbs.kerb_to, f.incline),
        f.foot, b.barriers, l.footway_id, l.edge_id, l.side, c.street_object_id, l.geom
    FROM link l LEFT JOIN footway f USING (footway_id) LEFT JOIN over_street o USING (line, part)
        LEFT JOIN barred b USING (line, part),
        LATERAL (SELECT CASE WHEN of_kind = 'walk' AND crosses THEN 'crossing' ELSE of_kind END AS kind) k
        LEFT JOIN LATERAL (SELECT o.* WHERE k.kind = 'crossing') c ON true,
        LATERAL (SELECT CASE WHEN l.part = 1 THEN c.kerb_from END AS kerb_from,
            CASE WHEN l.part = parts THEN c.kerb_to END AS kerb_to) kerbs
    UNION ALL SELECT walk_link_id, 'square', from_node, to_node, level, ST_Length(geom), NULL, NULL, NULL, NULL,
        surface, NULL, NULL, NULL, NULL, foot, NULL, NULL, NULL, NULL, NULL, geom FROM over_area
        WHERE extent IS NULL OR geom && extent;
END $$;
COMMENT ON FUNCTION streetgen.walk_links(name, geometry) IS
    'The links of what people walk on in a model, as view walk_link has them; of an extent those whose box meets it, '
    'NULL: all.';
