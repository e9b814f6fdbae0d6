-- This says what each column of overpasses and heights means.
CREATE OR REPLACE FUNCTION streetgen._overpass_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 20 SET search_path = pg_catalog
    AS $$ VALUES
    ('overpass_override'::name, 'overpass_override_id'::name, 'key'),
    ('overpass_override', 'geom', 'place of the crossing, within 20 m of it'),
    ('overpass_override', 'axis_above', 'axis that passes over'),
    ('overpass_override', 'axis_below', 'axis below'),
    ('overpass_override', 'clearance', 'from roadway to roadway, metres; NULL: setting clearance'),
    ('overpass', 'overpass_id', 'key; kept while the two edges cross so often, the same one above'),
    ('overpass', 'edge_above', 'the edge that passes over'),
    ('overpass', 'abscissa_above', 'where it does, metres along the edge'),
    ('overpass', 'edge_below', 'the edge below'),
    ('overpass', 'abscissa_below', 'where it passes below, metres along the edge'),
    ('overpass', 'ordinality', 'number from 1 of the crossings of the two edges, along the one above'),
    ('overpass', 'geom', 'the crossing'),
    ('overpass', 'clearance', 'wanted from roadway to roadway, metres'),
    ('overpass', 'method', 'how it is known who is above: by_hand, level (the levels differ), importance (of one '
        'level, the more important axis is above) or order (of one level and importance, the longer axis is, '
        'else the greater axis_id, and of one axis what is nearer to its middle)'),
    ('height_override', 'height_override_id', 'key'),
    ('height_override', 'axis_id', 'the axis'),
    ('height_override', 'abscissa', 'the place, metres along the axis'),
    ('height_override', 'height', 'the road lies at least so high there, metres'),
    ('height_override', 'geom', 'its place: that of the axis at the abscissa; filled where left out'),
    ('profile', 'edge_id', 'the edge'),
    ('profile', 'geom', 'the line of the edge with the heights of the roadway, metres, and further points where its '
        'grade changes'),
    ('profile', 'grade_max', 'greatest rise for each metre along it: setting grade_maximal, more where its ground is '
        'steeper'),
    ('profile', 'method', 'how it came about: ground (as the ground), lifted (somewhere above it) or sunk (somewhere '
        'below it)'),
    ('profile', 'tied_from', 'are the heights of all edges at the node where it begins found together? They are where '
        'one of them left the ground there in any step, wherever it lies in the end'),
    ('profile', 'tied_to', 'the same at the node where it ends') $$;
COMMENT ON FUNCTION streetgen._overpass_column() IS 'The columns of overpasses and heights, and what each is.';
