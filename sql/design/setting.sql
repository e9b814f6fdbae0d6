-- The settings of designs.

CREATE OR REPLACE FUNCTION streetgen._design_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 17 SET search_path = pg_catalog
    AS $$ VALUES
    ('link_factor', '27.5', 'km', 'of a design: what a utilisation of 1 (thousands of people squared per km2) and a km '
        'saved are worth, in km of road', 0, 1000000, NULL::text[]),
    ('benefit', 'paper', NULL, 'trips that a link of a design is judged by: those between its ends (paper) or all '
        'that use it (network)', NULL, NULL, ARRAY['paper', 'network']),
    ('curve_radius', 'least', NULL, 'radius of the curves of designed roads where it fits: the least or the normal one '
        'of their standard, or the largest that fits', NULL, NULL, ARRAY['least', 'normal', 'largest']),
    ('fill_cost', '5', 'per m3', 'cost of a fill', 0, 1000000, NULL),
    ('cut_cost', '6', 'per m3', 'cost of a cut', 0, 1000000, NULL),
    ('land_cost', '2', 'per m2', 'cost of the land that a road and its slopes take', 0, 1000000, NULL),
    ('pavement_cost', '60', 'per m2', 'cost of a road surface, over its formation', 0, 1000000, NULL),
    ('bridge_cost', '1000', 'per m2', 'cost of a bridge, over the formation', 0, 1000000, NULL),
    ('tunnel_cost', '2000', 'per m2', 'cost of a tunnel, over the formation', 0, 1000000, NULL),
    ('use_cost', '100', 'per m', 'cost of the use of a road, by its length', 0.01, 1000000000, NULL),
    ('utilisation_cost', '0', 'per m', 'cost of the use of a road by its length, for each unit of the utilisation of '
        'its link', 0, 1000000000, NULL),
    ('climb_cost', '300', 'per m', 'cost of the use of a road, by what it climbs and descends', 0, 1000000000, NULL),
    ('side_slope', '1.5', NULL, 'run of the slope of a cut or fill for a rise of 1', 0.1, 20, NULL),
    ('fill_greatest', '20', 'm', 'a designed road that lies higher over the ground is a bridge', 0, 1000, NULL),
    ('cut_greatest', '25', 'm', 'a designed road that lies deeper in the ground is a tunnel', 0, 1000, NULL),
    ('design_axis_length', '1000', 'm', 'about every so many metres a designed road is cut into axes', 50, 100000,
        NULL),
    ('design_live', 'off', NULL, 'roads follow an edit of terrain, zones, nodes or links at once: off or on', NULL,
        NULL, ARRAY['off', 'on']) $$;
COMMENT ON FUNCTION streetgen._design_setting() IS 'The settings of designs, with their defaults and ranges.';
