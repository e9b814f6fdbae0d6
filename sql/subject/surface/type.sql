-- Decisions about the roadway and its former surfaces, as the core takes them.

CREATE TYPE streetgen.street_transition AS (axis_id bigint, which text, kind text, length float8);
COMMENT ON TYPE streetgen.street_transition IS
    'The change of width at one end of an axis, instead of the settings transition_kind and transition_length.';
COMMENT ON COLUMN streetgen.street_transition.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.street_transition.which IS 'which end: start or end';
COMMENT ON COLUMN streetgen.street_transition.kind IS 'symmetric, left or right';
COMMENT ON COLUMN streetgen.street_transition.length IS 'm';

CREATE TYPE streetgen.street_limit AS (axis_id bigint, abscissa float8, which text);
COMMENT ON TYPE streetgen.street_limit IS 'Where the intersection at one end of an edge ends, by hand.';
COMMENT ON COLUMN streetgen.street_limit.axis_id IS 'the axis of the edge';
COMMENT ON COLUMN streetgen.street_limit.abscissa IS 'the place, m along the axis';
COMMENT ON COLUMN streetgen.street_limit.which IS 'which end of the edge: start or end';

CREATE TYPE streetgen.street_corner AS (axis_a bigint, axis_b bigint, x float8, y float8, radius float8);
COMMENT ON TYPE streetgen.street_corner IS
    'The radius of a corner by hand, counter-clockwise from one axis to the next at a node.';
COMMENT ON COLUMN streetgen.street_corner.axis_a IS 'the axis it begins at';
COMMENT ON COLUMN streetgen.street_corner.axis_b IS 'the axis it ends at';
COMMENT ON COLUMN streetgen.street_corner.x IS 'abscissa of a place near the node, in the plane';
COMMENT ON COLUMN streetgen.street_corner.y IS 'its ordinate';
COMMENT ON COLUMN streetgen.street_corner.radius IS 'm';

CREATE TYPE streetgen.former_edge AS (
    axis_id bigint, start_abscissa float8, end_abscissa float8, geom bytea, wanted_start float8, start float8,
        border_start bytea, wanted_end float8, "end" float8, border_end bytea, surface bytea,
        contested boolean, level integer, borders bytea, beside_left text, beside_right text,
        median_left bytea, median_right bytea
);
COMMENT ON TYPE streetgen.former_edge IS 'An edge as it was before a change, with its section limits and its section.';
COMMENT ON COLUMN streetgen.former_edge.axis_id IS 'the axis';
COMMENT ON COLUMN streetgen.former_edge.start_abscissa IS 'where it began, m along its axis';
COMMENT ON COLUMN streetgen.former_edge.end_abscissa IS 'where it ended, m along its axis';
COMMENT ON COLUMN streetgen.former_edge.geom IS 'LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.wanted_start IS 'limit wanted at its start, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.start IS 'limit at its start, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.border_start IS 'border line there, LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.wanted_end IS 'limit wanted at its end, m along the edge';
COMMENT ON COLUMN streetgen.former_edge."end" IS 'limit at its end, m along the edge';
COMMENT ON COLUMN streetgen.former_edge.border_end IS 'border line there, LINESTRING, EWKB';
COMMENT ON COLUMN streetgen.former_edge.surface IS 'its section, MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.former_edge.contested IS 'did part of the section''s ground belong to another surface?';
COMMENT ON COLUMN streetgen.former_edge.level IS 'level of the section';
COMMENT ON COLUMN streetgen.former_edge.borders IS
    'numbers of column borders of the section, each as float8send writes it; empty: there were none';
COMMENT ON COLUMN streetgen.former_edge.beside_left IS 'what lay beside it on its left, as in table edge';
COMMENT ON COLUMN streetgen.former_edge.beside_right IS 'what lay beside it on its right';
COMMENT ON COLUMN streetgen.former_edge.median_left IS
    'numbers of column median_left of the edge, each as float8send writes it';
COMMENT ON COLUMN streetgen.former_edge.median_right IS 'the same on its right';

CREATE TYPE streetgen.former_node AS (x float8, y float8, surface bytea, contested boolean, level integer);
COMMENT ON TYPE streetgen.former_node IS 'A node as it was before a change, with its intersection.';
COMMENT ON COLUMN streetgen.former_node.x IS 'abscissa in the plane';
COMMENT ON COLUMN streetgen.former_node.y IS 'ordinate in the plane';
COMMENT ON COLUMN streetgen.former_node.surface IS 'its intersection, MULTIPOLYGON, EWKB';
COMMENT ON COLUMN streetgen.former_node.level IS 'level of the intersection';
COMMENT ON COLUMN streetgen.former_node.contested IS
    'did part of the intersection''s ground belong to another surface?';
