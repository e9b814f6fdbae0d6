-- Checks and counts of footways and areas.

CREATE OR REPLACE FUNCTION streetgen._areas_amiss(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH area AS MATERIALIZED (SELECT street_area_id, kind, level, geom, ST_MakeValid(geom) AS ground,
        ST_IsValid(geom) AS sound FROM street_area)
    SELECT 'notice', 'area that crosses itself, m2', 'street_area', street_area_id, ST_Area(ground), geom::geometry
        FROM area WHERE NOT sound
    UNION ALL SELECT 'notice', 'areas of one kind that overlap, m2', 'street_area', a.street_area_id,
            ST_Area(g.shared), g.shared
        FROM area a JOIN area o ON o.geom && a.geom AND (o.kind, o.level) = (a.kind, a.level)
            AND o.street_area_id < a.street_area_id, LATERAL (SELECT ST_CollectionExtract(ST_Intersection(a.ground,
                o.ground), 3) AS shared) g WHERE ST_Area(g.shared) > 1
    UNION ALL SELECT 'notice', 'area without ground of its own, m2', 'street_area', street_area_id, ST_Area(ground),
            geom::geometry
        FROM area a WHERE kind <> 'roadway' AND NOT EXISTS (
            SELECT FROM area_surface s WHERE s.street_area_id = a.street_area_id)
    UNION ALL SELECT 'notice', 'area over a street, m', 'street_area', a.street_area_id, ST_Length(g.within),
            g.within
        FROM area a, LATERAL (SELECT ST_Collect(ST_Intersection(ST_Force2D(e.geom), a.ground)) AS within FROM edge e
            WHERE e.geom && a.geom AND e.level = a.level) g
        WHERE a.kind NOT IN ('roadway', 'parking_area') AND ST_Length(g.within) > 10
    UNION ALL SELECT 'notice', 'area of roadway along no street, m2', 'street_area', street_area_id, ST_Area(ground),
            geom::geometry
        FROM area a WHERE streetgen._area_wins(model, 'roadway') AND kind = 'roadway' AND NOT EXISTS (
            SELECT FROM edge e WHERE e.geom && a.ground AND e.level = a.level AND ST_Intersects(e.geom, a.ground))
    UNION ALL SELECT 'notice', 'stated width that is not that of areas, m', 'axis', axis_id, u.width - a.width,
            a.geom::geometry
        FROM axis_used u JOIN axis a USING (axis_id)
        WHERE streetgen._area_wins(model, 'roadway') AND u.by_area AND abs(u.width - a.width) > 0.5;
END $$;
COMMENT ON FUNCTION streetgen._areas_amiss(name) IS
    'Rows of streetgen.check_model: areas that cross themselves, overlap, lie over a street, have no ground, '
    'or move kerbs that are stated.';

CREATE OR REPLACE FUNCTION streetgen._check_footway(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'sidewalk source without its footway', 'sidewalk_source', s.sidewalk_source_id, s.width, e.geom
        FROM sidewalk_source s JOIN edge e USING (edge_id)
        WHERE NOT EXISTS (SELECT FROM footway f WHERE f.footway_id = s.footway_id)
    UNION ALL
    SELECT 'notice', 'sidewalk along no street, m', 'footway', f.footway_id, ST_Length(f.geom), f.geom FROM footway f
        WHERE f.role = 'sidewalk' AND NOT EXISTS (SELECT FROM sidewalk_source s WHERE s.footway_id = f.footway_id)
            AND ST_Length(f.geom) >= 10
    UNION ALL
    SELECT 'notice', 'sidewalk drawn along a part of its side, m', 'edge', e.edge_id, ST_Length(e.geom) - s.metres,
            e.geom
        FROM edge e JOIN (SELECT edge_id, sum(end_abscissa - start_abscissa) AS metres FROM sidewalk_source
            GROUP BY edge_id, side) s USING (edge_id)
        WHERE ST_Length(e.geom) - s.metres > greatest(50, 0.5 * ST_Length(e.geom))
    UNION ALL
    SELECT 'notice', 'kerb that gives way to a footway, m', 'axis', u.axis_id, u.width_moved, u.geom
        FROM axis_used u WHERE u.width_moved > 0
    UNION ALL
    SELECT 'notice', 'side whose sidewalk apart is not drawn, m', 'edge', e.edge_id, ST_Length(e.geom), e.geom
        FROM edge e JOIN axis a USING (axis_id), LATERAL (VALUES ('left', e.sidewalk_left),
            ('right', e.sidewalk_right)) v(side, width)
        WHERE a.sidewalk_apart IN (v.side, 'both') AND v.width = 0 AND ST_Length(e.geom) >= 10
    UNION ALL
    SELECT * FROM streetgen._areas_amiss(model)
    UNION ALL
    SELECT * FROM streetgen._walks_apart(model)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_footway(name) IS
    'The rows of streetgen.check_model for footways.';

CREATE OR REPLACE FUNCTION streetgen._footway_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'footway', 'SELECT ''footways'', round(coalesce(sum(ST_Length(geom)) / 1000, 0)::numeric, 3), ''km'' '
        'FROM %1$I.footway '
        'UNION ALL SELECT ''footways that are sidewalks'', count(DISTINCT footway_id), NULL FROM %1$I.sidewalk_source '
        'UNION ALL SELECT ''streets whose kerbs give way'', count(*), NULL FROM %1$I.axis_used WHERE width_moved > 0 '
        'UNION ALL SELECT ''areas of the street'', count(*), NULL FROM %1$I.street_area '
        'UNION ALL SELECT ''streets with the kerbs of areas'', count(*), NULL FROM %1$I.axis_used WHERE by_area') $$;
COMMENT ON FUNCTION streetgen._footway_summary() IS 'What streetgen.summary counts of footways.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('sidewalk source without its footway', 'the footway is gone, and its street was not computed since', '`generate`'),
    ('sidewalk along no street, m',
        'a footway of role sidewalk lies farther than setting mapped_sidewalk_distance from every kerb, within a '
        'roadway, or beside a median, a splitter or an island',
        'correct the `width` of the street, or the line; empty its `role` where it is a way of its own'),
    ('sidewalk drawn along a part of its side, m',
        'footways run along less than half of the side, and its sidewalk lies all along it',
        'draw the rest in `footway`, or type the width in `sidewalk_editing`'),
    ('kerb that gives way to a footway, m',
        'a sidewalk is drawn within the kerb of a street whose width is estimated, which is narrower by so much',
        'nothing, where the street is that narrow; else correct its `width`, which is believed, or the line'),
    ('walks that nothing joins to the others, m',
        'a part of the network on foot, `walk_link`, that no link joins to the largest part',
        'draw a way to the others in `footway`, or a crossing; raise setting walk_join_distance where ends lie near'),
    ('sidewalk that nobody reaches on foot, m',
        'the sidewalk of a side lies in a part of the network on foot that nothing joins to the largest part',
        'draw a crossing in `pedestrian_crossing_editing`, or a way to it in `footway`'),
    ('area that crosses itself, m2', 'the ring of an area in `street_area` crosses itself: ST_MakeValid mends it',
        'draw it anew'),
    ('areas of one kind that overlap, m2', 'two areas share ground, which is that of the older one',
        'draw their common border, or delete one'),
    ('area without ground of its own, m2',
        'roadway, sidewalks, and areas and footways that come before it leave an area nothing',
        'correct its `kind`, the `width` of the street, or delete it'),
    ('area over a street, m', 'the axis of a street leads through an area, whose ground its roadway parts',
        'nothing, where people drive over it; else delete the axis, or correct its `level`'),
    ('area of roadway along no street, m2',
        'no axis leads through an area of kind roadway, which by setting area_wins moves kerbs: it moves none',
        'draw the axis, or correct `level` or `kind` of the area'),
    ('stated width that is not that of areas, m',
        'areas of kind roadway have the kerbs of the street elsewhere, by setting area_wins; m: so much wider',
        'nothing, where the areas are right; else put the width by hand, which areas leave'),
    ('side whose sidewalk apart is not drawn, m',
        '`axis.sidewalk_apart` names the side, and no footway runs along it: it has no sidewalk',
        'draw the sidewalk in `footway`, or empty `axis.sidewalk_apart`');
