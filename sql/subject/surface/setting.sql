-- The settings of the roadway.

CREATE OR REPLACE FUNCTION streetgen._surface_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 26 SET search_path = pg_catalog
    AS $$ VALUES
    ('max_arc_distance', '60', 'm', 'an arc centre farther from its node gets the minimal radius', 1, 1000,
        NULL::text[]),
    ('radius_minimal', '0.15', 'm', 'radius of a kerb stone, for arcs that lie too far away', 0.01, 5, NULL),
    ('radius_rule', 'min', NULL, 'radius of a corner from those of its two axes: min, max, mean, or major: that of the '
        'more important axis, of equal ones the wider one, of two alike the lesser', NULL, NULL,
        ARRAY['min', 'max', 'mean', 'major']),
    ('short_axis', 'reduce', NULL,
        'an axis too short for the wanted radius: reduce (the radius, and follow only where none fits) or follow '
        '(the next axis in its direction first)', NULL, NULL, ARRAY['reduce', 'follow']),
    ('corner_length', '15', 'm',
        'the arc of a corner ends no farther than this from the crossing of its kerbs, whatever radius is wanted, '
        'and two arcs on one kerb share it; NULL: however far, as the paper has it', 1, 1000, NULL),
    ('corner_area', '50', 'm2',
        'nor does it close more ground than this between the kerbs, nor do all corners of a node together, those of '
        '75 degrees and more apart; NULL: however much', 0.1, 100000, NULL),
    ('limit_distance', '25', 'm',
        'where kerbs part slowly, and farther than this from a node, both sections begin about here, parted by one '
        'line; NULL: where the corner ends, as the paper has it', 1, 1000, NULL),
    ('follow_length', '10', 'm',
        'a corner between nearly parallel kerbs, or one that follows its streets, closes the ground between no '
        'farther than this from the crossing of the kerbs; NULL: however far, as the paper has it', 0, 1000, NULL),
    ('follow_area', '20', 'm2', 'nor does such a corner close more ground than this; NULL: however much', 0, 100000,
        NULL),
    ('median_width_minimal', '0.5', 'm',
        'such a corner becomes the nose of a median where the ground between the kerbs is this wide', 0.02, 100,
        NULL),
    ('median_width_maximal', '20', 'm',
        'ground between the two carriageways of one street is a median where they lie no farther apart, kerb to kerb; '
        'wider ground is a block; 0: none', 0, 100, NULL),
    ('island_area', '1000', 'm2',
        'in a face smaller than this between axes of one level, all within the reach of each of its nodes, ground '
        'with room for a disc of 1 m stays: its corners become noses where their arcs would leave none, or close over '
        '15 % of the ground between the kerbs. The middle of two dual carriageways that cross is roadway; 0: neither, '
        'as the paper has it', 0, 100000, NULL),
    ('island_area_minimal', '3.5', 'm2',
        'ground under this area that roadway encloses on a level is roadway; max_hole_area counts where it is greater',
        0, 100, NULL),
    ('island_nose_radius', '0.75', 'm', 'radius of those noses', 0.05, 15, NULL),
    ('kerb_radius_minimal', '0.5', 'm',
        'kinks of kerbs of more than 30 degrees become arcs of this radius, where no limit lies and a radius of 0 is '
        'not wanted; NULL or 0: none', 0, 15, NULL),
    ('radius_by_importance', '{"1": 8, "2": 6.25, "3": 6.25, "4": 3}', 'm',
        'wanted radius by importance; an entry holds up to the next one, the first also before itself; null: no arc; '
        'empty: turning_radius', NULL, NULL, NULL),
    ('turning_mode', 'paper', NULL, 'law of turning_radius: paper or setra', NULL, NULL, ARRAY['paper', 'setra']),
    ('turning_radius_minimal', '0.15', 'm', 'turning_radius gives no less', 0, 3, NULL),
    ('turning_radius_maximal', '15', 'm', 'turning_radius gives no more', 3, 200, NULL),
    ('radius_function', NULL, NULL,
        'wanted radius of an axis, before radius_by_importance and turning_radius: an immutable function '
        '(width float8, speed float8, importance integer, lane_count integer, kind text) returning float8, with its '
            'schema; '
        'NULL: none', NULL, NULL, NULL),
    ('transition_length', NULL, 'm', 'length of a change of width; NULL: by taper_ratio', 0, 200, NULL),
    ('taper_ratio', '{"0": 10, "70": 20, "90": 30, "110": 40}', NULL,
        'metres along the street for each metre that a kerb moves sideways at a change of width, by speed in km/h; '
        'an entry holds up to the next one', NULL, NULL, NULL),
    ('transition_kind', 'symmetric', NULL,
        'kerbs that change linearly at a change of width, seen along the axis of the smaller axis_id: symmetric, '
        'left or right', NULL, NULL, ARRAY['symmetric', 'left', 'right']),
    ('dead_end', 'flat', NULL, 'end of a dead end: flat or round', NULL, NULL, ARRAY['flat', 'round']),
    ('max_hole_area', '0.5', 'm2',
        'holes under this area, or under island_area_minimal where that is greater, are filled; those of junctions and '
        'of areas of the street by this alone', 0, 100, NULL),
    ('slit_width', '0.2', 'm',
        'ground between two streets of one level that run beside each other no farther apart than this is roadway; '
        '0: none', 0, 2, NULL),
    ('overlaps_maximal', '30', NULL,
        'where more surfaces come into a square of 10 m the first of them by rank owns each place', 1, 1000, NULL) $$;
COMMENT ON FUNCTION streetgen._surface_setting() IS 'The settings of the roadway, with their defaults and ranges.';
