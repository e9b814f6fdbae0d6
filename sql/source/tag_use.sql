-- What becomes of each tag and column that importers of known sources look at.

CREATE OR REPLACE FUNCTION streetgen.tag_use() RETURNS TABLE(source text, tag text, becomes text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 100 SET search_path = pg_catalog
    AS $$
    SELECT 'OpenStreetMap, lanes', u.* FROM streetgen._osm_tag_use() u
    UNION ALL VALUES
    ('OpenStreetMap, ways', 'width:carriageway, width, est_width',
        'The width of the roadway from kerb to kerb: the first of them that is a length.'),
    ('OpenStreetMap, ways', 'maxspeed[|:forward|:backward|:lanes], zone:maxspeed, source:maxspeed', 'The speed.'),
    ('OpenStreetMap, ways', 'layer',
        'The level. A bridge on layer 0 or none is on level 1, a tunnel on level -1; where they contradict it, it '
        'stands, and the way is named.'),
    ('OpenStreetMap, ways', 'bridge', 'Level 1 where layer says 0 or none.'),
    ('OpenStreetMap, ways', 'tunnel', 'Level -1 where layer says 0 or none; building_passage is on the ground.'),
    ('OpenStreetMap, ways', 'name', 'The name of the street.'),
    ('OpenStreetMap, ways', 'ref', 'The number of the route.'),
    ('OpenStreetMap, ways', 'area', 'A way with value yes is no street.'),
    ('OpenStreetMap, ways', 'aeroway', 'The class, where there is no highway.'),
    ('OpenStreetMap, ways', 'sidewalk[|:left|:right|:both]', 'Whether there are sidewalks.'),
    ('OpenStreetMap, ways', 'sidewalk[:left|:right|:both]:width', 'The widths of the sidewalks.')
    UNION ALL SELECT 'BD TOPO', array_to_string(columns, ', '), becomes FROM streetgen._bdtopo_column() $$;
COMMENT ON FUNCTION streetgen.tag_use() IS
    'What becomes of each tag of OpenStreetMap and each column of BD TOPO that importers look at; alternatives of a '
    'key stand in brackets.';
