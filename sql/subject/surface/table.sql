-- The columns of the roadway.

CREATE OR REPLACE FUNCTION streetgen._surface_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 66 SET search_path = pg_catalog
    AS $$ VALUES
    ('transition_override'::name, 'transition_override_id'::name, 'key'),
    ('transition_override', 'axis_id', 'the axis'),
    ('transition_override', 'which', 'its start or end, where the width changes'),
    ('transition_override', 'kind',
        'kerbs that change linearly, seen along this axis: symmetric, left or right; NULL: setting transition_kind'),
    ('transition_override', 'length', 'length of the change, metres; NULL: setting transition_length'),
    ('transition_override', 'geom', 'its place: that end of the axis; filled where left out'),
    ('section_limit', 'section_limit_id', 'key'),
    ('section_limit', 'edge_id', 'the edge'),
    ('section_limit', 'which', 'start or end of the edge'),
    ('section_limit', 'wanted_abscissa', 'where the intersection, or a user, wants the limit, metres along the edge'),
    ('section_limit', 'abscissa', 'where it is, metres along the edge'),
    ('section_limit', 'geom', 'its point on the edge'),
    ('section_limit', 'border_line', 'from the left kerb to the right kerb, shared by section and intersection'),
    ('section_limit', 'method',
        'hypothesis; crossed_limits: it would cross the other limit, and both lie where they meet; by_hand'),
    ('section', 'edge_id', 'key: the edge'),
    ('section', 'level', 'level of the edge'),
    ('section', 'surface', 'roadway; empty where the limits of the edge crossed'),
    ('section', 'method', 'hypothesis; contested: ground went to other surfaces; crowded: it comes where more '
        'surfaces than overlaps_maximal share ground by rank; robust_fallback: a union of simple pieces, where its '
        'ring would not be simple; crossed_limits: empty, its limits crossed'),
    ('section', 'contested_area', 'area left to other surfaces, square metres'),
    ('section', 'borders', 'where the borders of the roadway run, from node to node: of each place metres along the '
        'edge, and metres from the axis to the left and to the right border; corners left out. NULL: the roadway is '
        'as wide as the axis says'),
    ('corner', 'corner_id', 'key'),
    ('corner', 'node_id', 'the node'),
    ('corner', 'edge_a', 'first edge'),
    ('corner', 'end_a', 'the end of the first edge that touches the node'),
    ('corner', 'edge_b', 'second edge, the next counter-clockwise'),
    ('corner', 'end_b', 'the end of the second edge that touches the node'),
    ('corner', 'centre', 'centre of the arc; NULL without an arc'),
    ('corner', 'radius_wanted', 'radius that the axes want, metres'),
    ('corner', 'radius', 'radius used, metres; 0 without an arc'),
    ('corner', 'arc', 'arc of the kerb, from the border of a to the border of b'),
    ('corner', 'method', 'hypothesis: the wanted radius; radius_reduced: the largest that fits the axes; followed: '
        'an axis is too short, the arc touches the next one in its direction; nose: the end of a median or of a '
        'traffic island, see follow_length and island_area; radius_minimal: its centre lay beyond '
        'max_arc_distance; no_arc: none fits; transition: the width changes instead; by_hand'),
    ('intersection', 'node_id', 'key: the node'),
    ('intersection', 'level', 'level of most of its edges'),
    ('intersection', 'surface', 'roadway'),
    ('intersection', 'method',
        'hypothesis; contested: ground went to other surfaces; crowded: it comes where more surfaces than '
        'overlaps_maximal share ground by rank; robust_fallback: a union of simple pieces, where its ring would not '
        'be simple; transition: a change of width'),
    ('intersection', 'contested_area', 'area left to other surfaces, square metres'),
    ('section_limit_override', 'section_limit_override_id', 'key'),
    ('section_limit_override', 'axis_id', 'the axis'),
    ('section_limit_override', 'abscissa', 'where the limit is put, metres along the axis'),
    ('section_limit_override', 'which', 'the limit at the start or the end of the edge on which the abscissa lies'),
    ('section_limit_override', 'geom', 'its place: that of the axis at the abscissa; filled where left out'),
    ('corner_override', 'corner_override_id', 'key'),
    ('corner_override', 'geom',
        'place of the node, within three tolerances of it; where axes that go on beyond the node make two such '
        'corners: on the side of the one that is meant, at the node itself both'),
    ('corner_override', 'axis_a', 'axis of the first edge'),
    ('corner_override', 'axis_b', 'axis of the next edge counter-clockwise'),
    ('corner_override', 'radius', 'radius, metres; 0: no arc'),
    ('kerb_point_override', 'kerb_point_override_id', 'key'),
    ('kerb_point_override', 'axis_id', 'the axis'),
    ('kerb_point_override', 'geom', 'the place on the kerb'),
    ('kerb_point_override', 'abscissa', 'its place along the axis, metres; filled where left out'),
    ('kerb_point_override', 'width',
        'width kerb to kerb that it says, metres: twice its distance from the axis; filled where left out'),
    ('roadway', 'roadway_id', 'unique and kept as long as the edge or node: twice edge_id, or twice node_id and one'),
    ('roadway', 'part', 'section or intersection'),
    ('roadway', 'edge_id', 'the edge of a section'),
    ('roadway', 'node_id', 'the node of an intersection'),
    ('roadway', 'axis_id', 'axis of the edge, or of the first edge of the node'),
    ('roadway', 'name', 'name of the axis'),
    ('roadway', 'kind', 'kind of the axis'),
    ('roadway', 'importance', 'importance of the edge, 1 the highest'),
    ('roadway', 'level', 'level of the surface'),
    ('roadway', 'width', 'width of the edge kerb to kerb, metres: of a section at its start, of an intersection at '
        'its node'),
    ('roadway', 'lane_count', 'general and bus lanes of the edge'),
    ('roadway', 'surface', 'roadway, never empty'),
    ('intersection_group', 'node_id', 'the node of the intersection'),
    ('intersection_group', 'level', 'level of the intersection'),
    ('intersection_group', 'group_id', 'the smallest node of the intersection and its neighbours') $$;
COMMENT ON FUNCTION streetgen._surface_column() IS 'The columns of the roadway, and what each is.';
