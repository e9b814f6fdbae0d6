-- The lanes that tags of a way of OpenStreetMap state.

CREATE OR REPLACE FUNCTION streetgen._osm_lanes(keys text[], words text[], driving_side text, lane_width float8,
    cycle_lane_width float8, parking_lane_width float8, roadway_width float8, usual_lanes integer,
    two_way_width float8, narrowest_of_several float8, diagonal_depth float8, perpendicular_depth float8)
    RETURNS TABLE(direction text, lane_count integer, lanes_forward integer, lanes_backward integer,
        lanes_both integer, kind_forward text, kind_backward text, lane_width_forward text, lane_width_backward text,
        turn_forward text, turn_backward text, change_forward text, change_backward text, roadway_offset float8,
        access text, parking_left text, parking_right text, strips_left text, strips_right text, unread_tags text[],
        unread_reasons text[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 1 COST 100 AS 'MODULE_PATHNAME', 'streetgen_osm_lanes';
COMMENT ON FUNCTION streetgen._osm_lanes(text[], text[], text, float8, float8, float8, float8, integer, float8,
    float8, float8, float8) IS
    'The lanes of a way, who may drive there, how cars stand on its sides, and what lies between its kerbs and '
    'sidewalks, as columns of axis, by the keys and words of its tags (highway is its class), where one drives on a '
    'side and lanes have these widths, metres; roadway_width 0 is unknown. usual_lanes: of a street of that '
    'width that says none. two_way_width: on less, beside the lanes of the kerbs, both directions share one lane. '
    'narrowest_of_several: as wide is each of several lanes that a width alone makes, at least. '
    'diagonal_depth, perpendicular_depth: of cars that stand so, from the kerb. Tags that were not read so come '
    'with their reasons.';

CREATE OR REPLACE FUNCTION streetgen._osm_tag_use() RETURNS TABLE(of text, tag text, becomes text)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE ROWS 40 AS 'MODULE_PATHNAME', 'streetgen_osm_tag_use';
COMMENT ON FUNCTION streetgen._osm_tag_use() IS
    'What becomes of each tag of ways that importers look at: of lanes, or of ways; alternatives of a key stand in '
    'brackets.';
