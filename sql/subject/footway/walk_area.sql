-- Walks over squares and platforms, between the places where other walks come to them.

CREATE OR REPLACE FUNCTION streetgen._walks_over_area(area bytea, x float8[], y float8[], from_places integer[],
    to_places integer[], metres float8[], detour float8, srid integer)
    RETURNS TABLE(from_place integer, to_place integer, geom geometry)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 10 AS 'MODULE_PATHNAME', 'streetgen_walks_over_area';
COMMENT ON FUNCTION streetgen._walks_over_area(bytea, float8[], float8[], integer[], integer[], float8[], float8,
    integer) IS
    'The shortest walks (LINESTRING) over an area (EWKB, exterior rings counter-clockwise) between places, where '
    'walks that are there, and shorter ones, lead round by over detour times as far and over 5 m. Places count from 1; '
    'from_places, to_places, metres: the walks that are there. Lists of different length: 2202E; NULL in one: 22004; '
    'bad geometry or number: 22023.';

CREATE OR REPLACE FUNCTION streetgen._walked_areas(model name, around geometry)
    RETURNS TABLE(street_area_id bigint, part integer, level integer, surface text, foot text, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    -- A roadway parts an area; along the border a walk may run 0.2 m beside it.
    RETURN QUERY SELECT street_area_id, coalesce(d.path[1], 1), a.level, a.surface, a.foot, ST_Multi(
            ST_ForcePolygonCCW(ST_Buffer(ST_SimplifyPreserveTopology(d.geom, 0.1), 0.2, 'join=mitre')))
        FROM street_area a, LATERAL (SELECT ST_Union(r.surface, 0.0001) AS driven FROM roadway r
                WHERE r.surface && a.geom AND r.level = a.level) r,
            LATERAL (SELECT ST_CollectionExtract(ST_MakeValid(a.geom), 3) AS drawn) g,
            LATERAL ST_Dump(CASE WHEN driven IS NULL THEN drawn
                ELSE ST_CollectionExtract(ST_Difference(drawn, driven, 0.0001), 3) END) d
        WHERE a.kind IN ('square', 'walk', 'platform') AND a.foot IS DISTINCT FROM 'no'
            AND (around IS NULL OR a.geom && around) AND ST_Area(d.geom) > 1;
END $$;
COMMENT ON FUNCTION streetgen._walked_areas(name, geometry) IS
    'The parts beside roadways of the areas of a model over which people walk as they like: squares, walks and '
    'platforms. Their box meets that around; NULL: all.';

CREATE OR REPLACE FUNCTION streetgen._area_entry(walk geometry, area_id bigint, area geometry, beside geometry)
    RETURNS TABLE(street_area_id bigint, excess float8, geom geometry)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
    SELECT area_id, 0.5::float8, ST_MakeLine(ST_Translate(place, -0.3 * x, -0.3 * y), ahead)
    FROM (SELECT geom FROM ST_Dump(ST_Intersection(walk, beside)) WHERE ST_Length(geom) >= 20
            ORDER BY ST_Length(geom) DESC, ST_XMin(geom), ST_YMin(geom) LIMIT 1) along,
        LATERAL (SELECT ST_LineInterpolatePoint(geom, 0.5) AS place, ST_Azimuth(ST_LineInterpolatePoint(geom, 0.49),
            ST_LineInterpolatePoint(geom, 0.51)) AS azimuth) m,
        (VALUES (90), (-90)) side(turn), LATERAL (SELECT sind(degrees(azimuth) + turn) AS x,
            cosd(degrees(azimuth) + turn) AS y, ST_Distance(place, area) + 1 AS far) d,
        LATERAL (SELECT ST_Translate(place, far * x, far * y) AS ahead) a
    WHERE ST_Intersects(area, ahead) ORDER BY turn LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._area_entry(geometry, bigint, geometry, geometry) IS
    'Where one steps from a walk (LINESTRING) into an area along which it leads for 20 m and more, on the ground '
    'beside it: a line across the walk, square to it, in the middle of that stretch. excess: metres before the walk.';

CREATE OR REPLACE FUNCTION streetgen._area_walks(model name, around geometry, nodes bigint[], levels integer[],
    places geometry[], from_nodes bigint[], to_nodes bigint[], metres float8[])
    RETURNS TABLE(walk_link_id bigint, from_node bigint, to_node bigint, level integer, surface text, foot text,
        geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    near constant float8 := streetgen._setting_number(model, 'walk_join_distance');
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    RETURN QUERY WITH area AS MATERIALIZED (SELECT * FROM streetgen._walked_areas(model, around)),
    node AS MATERIALIZED (SELECT * FROM unnest(nodes, levels, places) n(node, level, place)),
    met AS MATERIALIZED (
        SELECT a.street_area_id, a.part, n.node, n.place, ST_ClosestPoint(a.geom, n.place) AS foot,
            row_number() OVER (PARTITION BY a.street_area_id, a.part ORDER BY n.node)::integer AS number
        FROM area a JOIN node n ON n.level = a.level AND ST_DWithin(a.geom, n.place, near)),
    there AS MATERIALIZED (
        SELECT street_area_id, part, array_agg(f.number ORDER BY l.n) AS from_places,
            array_agg(t.number ORDER BY l.n) AS to_places, array_agg(l.metres ORDER BY l.n) AS metres
        FROM unnest(from_nodes, to_nodes, metres) WITH ORDINALITY l(from_node, to_node, metres, n)
            JOIN met f ON f.node = l.from_node JOIN met t USING (street_area_id, part)
        WHERE t.node = l.to_node GROUP BY street_area_id, part),
    missed AS MATERIALIZED (
        SELECT street_area_id, part, a.level, a.surface, a.foot, w.from_place, w.to_place, w.geom
        FROM area a JOIN (SELECT street_area_id, part, array_agg(ST_X(foot) ORDER BY number) AS x,
                array_agg(ST_Y(foot) ORDER BY number) AS y FROM met GROUP BY street_area_id, part
                HAVING count(*) > 1) m USING (street_area_id, part)
            LEFT JOIN there h USING (street_area_id, part),
            LATERAL streetgen._walks_over_area(a.geom::bytea, x, y, coalesce(from_places, '{}'),
                coalesce(to_places, '{}'), coalesce(h.metres, '{}'), 1.25, srid) w)
    SELECT DISTINCT ON (k.key) k.key, f.node, t.node, w.level, w.surface, w.foot, l.geom
    FROM missed w JOIN met f ON (f.street_area_id, f.part, f.number) = (w.street_area_id, w.part, from_place)
        JOIN met t ON (t.street_area_id, t.part, t.number) = (w.street_area_id, w.part, to_place),
        LATERAL (SELECT ST_RemoveRepeatedPoints(ST_AddPoint(ST_AddPoint(w.geom, f.place, 0), t.place)) AS geom) l,
        LATERAL (SELECT hash_record_extended(ROW(l.geom::bytea), 0) & 9223372036854775807 AS key) k
    WHERE f.node <> t.node ORDER BY k.key, w.street_area_id;
END $$;
COMMENT ON FUNCTION streetgen._area_walks(name, geometry, bigint[], integer[], geometry[], bigint[], bigint[],
    float8[]) IS
    'The walks over squares and platforms of a model between nodes of its network within setting walk_join_distance of '
    'them: levels and places are those of the nodes. from_nodes, to_nodes, metres: the links that are there, beside '
    'which a walk that saves less than a fifth of the way, or 5 m, is none.';
