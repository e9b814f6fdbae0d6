-- The tables of axes and of their classes. The patterns are those of streetgen._lane_list_pattern and
-- streetgen._parking_pattern.

CREATE TABLE :"model".axis_class (
    class text PRIMARY KEY,
    taken boolean NOT NULL, width float8 CHECK (width BETWEEN 0.001 AND 200),
    speed float8 CHECK (speed BETWEEN 0 AND 400), importance integer CHECK (importance BETWEEN 1 AND 99),
    highway_role text CHECK (highway_role IN ('highway', 'fast_road', 'highway_link', 'link')),
    walked_along boolean NOT NULL DEFAULT true, crossed_on_foot boolean NOT NULL DEFAULT true,
    lanes_by_width boolean NOT NULL DEFAULT true,
    lanes_one_way integer CHECK (lanes_one_way BETWEEN 1 AND 15),
    width_one_way float8 CHECK (width_one_way BETWEEN 0.001 AND 200),
    lanes_each_way integer CHECK (lanes_each_way BETWEEN 1 AND 15),
    parking_left float8 NOT NULL DEFAULT 0 CHECK (parking_left BETWEEN 0 AND 10),
    parking_right float8 NOT NULL DEFAULT 0 CHECK (parking_right BETWEEN 0 AND 10),
    use text NOT NULL DEFAULT 'roadway' CHECK (use IN ('roadway', 'cycle', 'walk', 'steps', 'rail', 'none')));
INSERT INTO :"model".axis_class SELECT * FROM streetgen._default_axis_class();
ALTER TABLE :"model".axis_class ADD COLUMN IF NOT EXISTS lanes_one_way_by text
    CHECK (lanes_one_way_by IN ('hand', 'import'));
COMMENT ON TABLE :"model".axis_class IS
    'Classes of a source: whether importers take them, what axes of the class have where the source is silent (width '
    'm, speed km/h, importance 1 highest), and what the class means for ramps, people on foot and lanes';
COMMENT ON COLUMN :"model".axis_class.class IS 'class of the source, as in axis.kind';
COMMENT ON COLUMN :"model".axis_class.taken IS 'do importers take it, as column use says';
COMMENT ON COLUMN :"model".axis_class.use IS
    'what lines of the class are: roadway: importers make axes of them; walk, cycle or steps: they make footways; '
    'rail: they make tracks; none: nothing';
COMMENT ON CONSTRAINT axis_class_use_check ON :"model".axis_class IS
    'roadway, cycle, walk, steps, rail or none. Write roadway to have streets made of the lines.';
COMMENT ON COLUMN :"model".axis_class.width IS 'width kerb to kerb where neither width nor lanes are known, metres';
COMMENT ON CONSTRAINT axis_class_width_check ON :"model".axis_class IS
    '0.001 to 200 m. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis_class.speed IS 'speed where unknown, km/h';
COMMENT ON CONSTRAINT axis_class_speed_check ON :"model".axis_class IS
    '0 to 400 km/h. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis_class.importance IS 'importance where unknown, 1 the highest';
COMMENT ON CONSTRAINT axis_class_importance_check ON :"model".axis_class IS
    '1 to 99, 1 the highest. Leave it empty for setting importance_default.';
COMMENT ON COLUMN :"model".axis_class.highway_role IS
    'what the class is at ramps: highway; fast_road, a highway where its speed is 60 km/h or more or unknown; '
    'highway_link, the link of a highway; link, that of another road; NULL: nothing';
COMMENT ON CONSTRAINT axis_class_highway_role_check ON :"model".axis_class IS
    'highway, fast_road, highway_link or link. Leave it empty where the class is nothing at ramps.';
COMMENT ON COLUMN :"model".axis_class.walked_along IS 'do people walk along it; else its sidewalks are not estimated';
COMMENT ON COLUMN :"model".axis_class.crossed_on_foot IS
    'do people cross it; else no rule that names no class places a crossing on it';
COMMENT ON COLUMN :"model".axis_class.lanes_by_width IS
    'does the width tell the lanes; else it is one lane however wide, as a runway is';
COMMENT ON COLUMN :"model".axis_class.lanes_one_way IS
    'lanes of a one-way street of which none are stated, at most as many as its width holds; roundabouts have two '
    'at most, and a class without a number has what its width holds';
COMMENT ON CONSTRAINT axis_class_lanes_one_way_check ON :"model".axis_class IS
    '1 to 15 lanes. Leave it empty to have as many as the width holds.';
COMMENT ON COLUMN :"model".axis_class.lanes_one_way_by IS
    'who put lanes_one_way and width_one_way: hand, or import, which learned them and leaves those by hand; NULL: a '
    'new model has them';
COMMENT ON CONSTRAINT axis_class_lanes_one_way_by_check ON :"model".axis_class IS
    'hand or import. Leave it empty for an import to learn lanes_one_way where that is the number of a new model.';
COMMENT ON COLUMN :"model".axis_class.width_one_way IS
    'width of a one-way street where neither width nor lanes are known, metres; NULL: that of lanes_one_way, else '
    'width';
COMMENT ON CONSTRAINT axis_class_width_one_way_check ON :"model".axis_class IS
    '0.001 to 200 m. Leave it empty for lanes_one_way by the setting lane_width.';
COMMENT ON COLUMN :"model".axis_class.lanes_each_way IS
    'lanes of each direction of a two-way street of which none are stated, at most as many as its width holds; NULL: '
    'these';
COMMENT ON CONSTRAINT axis_class_lanes_each_way_check ON :"model".axis_class IS
    '1 to 15 lanes. Leave it empty to have as many as the width holds.';
COMMENT ON COLUMN :"model".axis_class.parking_left IS
    'width of the parking lane on the left where neither width nor lanes are known, metres, which is beside the usual '
    'width; 0: none. A one-way street has it on the left of its traffic, another on the left of the axis';
COMMENT ON CONSTRAINT axis_class_parking_left_check ON :"model".axis_class IS
    '0 to 10 m. Write 0 where no parking lane is.';
COMMENT ON COLUMN :"model".axis_class.parking_right IS 'the same on the right, metres';
COMMENT ON CONSTRAINT axis_class_parking_right_check ON :"model".axis_class IS
    '0 to 10 m. Write 0 where no parking lane is.';

CREATE TABLE :"model".axis (
    axis_id bigint GENERATED BY DEFAULT AS IDENTITY PRIMARY KEY,
    geom geometry(LineString:z, :srid) NOT NULL CONSTRAINT geom_is_a_finite_line CHECK (NOT ST_IsEmpty(geom)
        AND ST_XMin(geom) BETWEEN -1e12 AND 1e12 AND ST_XMax(geom) BETWEEN -1e12 AND 1e12
        AND ST_YMin(geom) BETWEEN -1e12 AND 1e12 AND ST_YMax(geom) BETWEEN -1e12 AND 1e12
        AND ST_ZMin(geom) BETWEEN -1e12 AND 1e12 AND ST_ZMax(geom) BETWEEN -1e12 AND 1e12
        AND ST_3DLength(geom) < 'Infinity' AND ST_IsValid(geom)
        AND (ST_XMin(geom) < ST_XMax(geom) OR ST_YMin(geom) < ST_YMax(geom))),
    width float8 CHECK (width BETWEEN 0.001 AND 200), width_end float8 CHECK (width_end BETWEEN 0.001 AND 200),
    roadway_offset float8 CHECK (roadway_offset BETWEEN -100 AND 100),
    lane_count integer CHECK (lane_count BETWEEN 1 AND 30),
    direction text NOT NULL DEFAULT 'both' CHECK (direction IN ('both', 'direct', 'reverse')),
    speed float8 CHECK (speed BETWEEN 0.001 AND 400), importance integer CHECK (importance BETWEEN 1 AND 99),
    name text, level integer NOT NULL DEFAULT 0 CHECK (level BETWEEN -50 AND 50), kind text,
    radius float8 CHECK (radius BETWEEN 0 AND 200), lanes_forward integer CHECK (lanes_forward BETWEEN 0 AND 30),
    lanes_backward integer CHECK (lanes_backward BETWEEN 0 AND 30),
    lanes_both integer CHECK (lanes_both BETWEEN 0 AND 30),
    sidewalk_left float8 CHECK (sidewalk_left BETWEEN 0 AND 50),
    sidewalk_right float8 CHECK (sidewalk_right BETWEEN 0 AND 50), flow float8 CHECK (flow BETWEEN 0 AND 1000000),
    kind_forward text
        CHECK (kind_forward ~
            '^(general|bus|carpool|cycle|parking|closed)(\|(general|bus|carpool|cycle|parking|closed)){0,39}$'),
    kind_backward text
        CHECK (kind_backward ~
            '^(general|bus|carpool|cycle|parking|closed)(\|(general|bus|carpool|cycle|parking|closed)){0,39}$'),
    lane_width_forward text
        CHECK (lane_width_forward ~ '^((\d{1,2}(\.\d{1,6})?)?)(\|((\d{1,2}(\.\d{1,6})?)?)){0,39}$'),
    lane_width_backward text
        CHECK (lane_width_backward ~ '^((\d{1,2}(\.\d{1,6})?)?)(\|((\d{1,2}(\.\d{1,6})?)?)){0,39}$'),
    turn_forward text CHECK (turn_forward ~
        '^((reverse|sharp_left|left|slight_left|merge_to_left|through|merge_to_right|slight_right|right|'
        'sharp_right|none)?(;(reverse|sharp_left|left|slight_left|merge_to_left|through|merge_to_right|'
        'slight_right|right|sharp_right|none)){0,9})(\|((reverse|sharp_left|left|slight_left|merge_to_left|through|'
        'merge_to_right|slight_right|right|sharp_right|none)?(;(reverse|sharp_left|left|slight_left|merge_to_left|'
        'through|merge_to_right|slight_right|right|sharp_right|none)){0,9})){0,39}$'),
    turn_backward text CHECK (turn_backward ~
        '^((reverse|sharp_left|left|slight_left|merge_to_left|through|merge_to_right|slight_right|right|'
        'sharp_right|none)?(;(reverse|sharp_left|left|slight_left|merge_to_left|through|merge_to_right|'
        'slight_right|right|sharp_right|none)){0,9})(\|((reverse|sharp_left|left|slight_left|merge_to_left|through|'
        'merge_to_right|slight_right|right|sharp_right|none)?(;(reverse|sharp_left|left|slight_left|merge_to_left|'
        'through|merge_to_right|slight_right|right|sharp_right|none)){0,9})){0,39}$'),
    change_forward text CHECK (change_forward ~
        '^((yes|no|not_left|not_right|only_left|only_right)?)(\|((yes|no|not_left|not_right|only_left|only_right)?'
        ')){0,39}$'),
    change_backward text CHECK (change_backward ~
        '^((yes|no|not_left|not_right|only_left|only_right)?)(\|((yes|no|not_left|not_right|only_left|only_right)?'
        ')){0,39}$'),
    roundabout_tag text, source text, source_ref text, source_geom geometry, source_hash bigint,
    width_by_hand boolean NOT NULL DEFAULT false, source_width float8, source_width_end float8,
    UNIQUE (source, source_ref));
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS ref text;
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS access text CONSTRAINT axis_access_check
    CHECK (string_to_array(access, '|') <@ '{no,bus,carpool,cycle,private,destination,customers,delivery,""}'::text[]
        AND access !~ '[|].*[|]' AND access NOT IN ('', '|'));
COMMENT ON COLUMN :"model".axis.access IS
    'who may drive: no (nobody), bus, carpool or cycle (they alone), private, destination, customers or delivery (no '
    'way through); two words parted by |, either empty: along geom and against it; NULL: all';
COMMENT ON CONSTRAINT axis_access_check ON :"model".axis IS
    'no, bus, carpool, cycle, private, destination, customers or delivery, or two of these parted by |. Leave it '
    'empty where all may drive.';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS parking_left text CONSTRAINT axis_parking_left_check
        CHECK (parking_left ~ '^(no|(lane|street_side|half_on_kerb|on_kerb)'
            '(\|(parallel|diagonal|perpendicular)?(\|([1-9](\.\d{1,6})?)?(\|\d{0,4})?)?)?)$'),
    ADD COLUMN IF NOT EXISTS parking_right text CONSTRAINT axis_parking_right_check
        CHECK (parking_right ~ '^(no|(lane|street_side|half_on_kerb|on_kerb)'
            '(\|(parallel|diagonal|perpendicular)?(\|([1-9](\.\d{1,6})?)?(\|\d{0,4})?)?)?)$');
COMMENT ON COLUMN :"model".axis.parking_left IS
    'how cars stand on the left of geom: no, or street_side (between roadway and sidewalk), half_on_kerb or on_kerb, '
    'with what is known parted by |: parallel, diagonal or perpendicular, depth in metres, number of cars, such as '
    'on_kerb|parallel|2.2|8; lane|||8: of a parking lane; NULL: nothing is said';
COMMENT ON CONSTRAINT axis_parking_left_check ON :"model".axis IS
    'no, or street_side, half_on_kerb, on_kerb or lane, with orientation, depth and number of cars parted by |. Leave '
    'it empty where nothing is said.';
COMMENT ON COLUMN :"model".axis.parking_right IS 'the same on the right of geom';
COMMENT ON CONSTRAINT axis_parking_right_check ON :"model".axis IS
    'as parking_left. Leave it empty where nothing is said.';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS strips_left text CONSTRAINT axis_strips_left_check
        CHECK (strips_left ~ '^((verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?'
            '(\|(verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?){0,4})$'),
    ADD COLUMN IF NOT EXISTS strips_right text CONSTRAINT axis_strips_right_check
        CHECK (strips_right ~ '^((verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?'
            '(\|(verge|buffer|(two_way_)?cycle_track)( (0\.[1-9]\d{0,5}|([1-9]|1\d)(\.\d{1,6})?))?){0,4})$');
COMMENT ON COLUMN :"model".axis.strips_left IS
    'what lies between kerb and sidewalk on the left of geom, from the kerb outwards, parted by |: verge, buffer, '
    'cycle_track or two_way_cycle_track, each with its width in metres or without one, such as '
    'verge 1.5|cycle_track 2; sidewalk_left does not count it; NULL: nothing is said';
COMMENT ON CONSTRAINT axis_strips_left_check ON :"model".axis IS
    'up to five strips parted by |, such as verge 1.5|cycle_track: verge, buffer, cycle_track or two_way_cycle_track, '
    'each alone or with a width below 20 m. Leave it empty where nothing is said.';
COMMENT ON COLUMN :"model".axis.strips_right IS 'the same on the right of geom';
COMMENT ON CONSTRAINT axis_strips_right_check ON :"model".axis IS
    'as strips_left. Leave it empty where nothing is said.';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS lane_markings text CONSTRAINT axis_lane_markings_check
    CHECK (lane_markings IN ('yes', 'no'));
COMMENT ON COLUMN :"model".axis.lane_markings IS
    'yes or no: is anything painted on its lanes; no: neither lines between lanes nor lines to wait at nor arrows; '
    'NULL: as yes';
COMMENT ON CONSTRAINT axis_lane_markings_check ON :"model".axis IS
    'yes or no. Leave it empty where nothing is said: lanes are painted then.';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS sidewalk_apart text CONSTRAINT axis_sidewalk_apart_check
    CHECK (sidewalk_apart IN ('left', 'right', 'both'));
COMMENT ON COLUMN :"model".axis.sidewalk_apart IS
    'left, right or both sides of geom whose sidewalk is a line of table footway; with subject footway such a side '
    'has the sidewalk of its footways alone, by setting mapped_sidewalk_missing; NULL: nothing is said';
COMMENT ON CONSTRAINT axis_sidewalk_apart_check ON :"model".axis IS
    'left, right or both. Leave it empty where nothing is said.';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS paved text, ADD COLUMN IF NOT EXISTS sidewalk_paved_left text,
    ADD COLUMN IF NOT EXISTS sidewalk_paved_right text, ADD COLUMN IF NOT EXISTS cycle_paved_left text,
    ADD COLUMN IF NOT EXISTS cycle_paved_right text;
COMMENT ON COLUMN :"model".axis.paved IS
    'what the roadway is paved with, in the words of the source, such as asphalt, sett or paving_stones; NULL: unknown';
COMMENT ON COLUMN :"model".axis.sidewalk_paved_left IS
    'the same of the sidewalk on the left of geom; where a footway maps it, what the footway says comes first';
COMMENT ON COLUMN :"model".axis.sidewalk_paved_right IS 'the same on the right of geom';
COMMENT ON COLUMN :"model".axis.cycle_paved_left IS
    'the same of cycle lanes on the left of geom; NULL: as the roadway';
COMMENT ON COLUMN :"model".axis.cycle_paved_right IS 'the same on the right of geom';
ALTER TABLE :"model".axis ADD COLUMN IF NOT EXISTS height_limit float8 CONSTRAINT axis_height_limit_check
    CHECK (height_limit BETWEEN 1 AND 30);
COMMENT ON COLUMN :"model".axis.height_limit IS
    'height of the highest vehicles that may pass, as a sign says, metres; NULL: no sign is known';
COMMENT ON CONSTRAINT axis_height_limit_check ON :"model".axis IS
    '1 to 30 m. Leave it empty where no sign is known.';
CREATE INDEX axis_geom ON :"model".axis USING gist (geom);
CREATE INDEX axis_width ON :"model".axis (width);
CREATE INDEX axis_roadway_offset ON :"model".axis (roadway_offset) WHERE roadway_offset <> 0;
COMMENT ON TABLE :"model".axis IS
    'Input: road axes. Only geom is obligatory. width, width_end, radius in metres (width kerb to kerb), speed km/h, '
    'importance 1 highest, direction along the line; sidewalks in metres; what is known of single lanes stands in '
    'lists with |, from left to right in driving direction; source_geom is the line before cleaning';
COMMENT ON COLUMN :"model".axis.axis_id IS 'key';
COMMENT ON COLUMN :"model".axis.geom IS 'the axis of the road; direction speaks of its direction';
COMMENT ON CONSTRAINT geom_is_a_finite_line ON :"model".axis IS
    'a line through two different places, every coordinate a number within 1e12. Draw it again, or undo the edit.';
COMMENT ON COLUMN :"model".axis.width IS
    'width kerb to kerb at the start, metres; NULL: estimated. Put by hand, or without a source, it is believed; of '
    'a source up to setting max_width_per_lane for each lane of lane_count, else estimated; NULL over one put by '
    'hand: that of the source';
COMMENT ON CONSTRAINT axis_width_check ON :"model".axis IS '0.001 to 200 m. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.width_end IS
    'width kerb to kerb at the end, metres, reached linearly; NULL: as at the start. Believed as width is';
COMMENT ON CONSTRAINT axis_width_end_check ON :"model".axis IS
    '0.001 to 200 m. Leave it empty where the width stays the same.';
COMMENT ON COLUMN :"model".axis.roadway_offset IS
    'metres from the axis to the middle of the roadway, left of geom positive; at most half of the width, as far as '
    'leaves the axis on the roadway; NULL: 0';
COMMENT ON CONSTRAINT axis_roadway_offset_check ON :"model".axis IS
    '-100 to 100 m. Leave it empty where the axis runs along the middle.';
COMMENT ON COLUMN :"model".axis.lane_count IS
    'number of general, bus and carpool lanes of both directions; NULL: estimated';
COMMENT ON CONSTRAINT axis_lane_count_check ON :"model".axis IS '1 to 30. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.direction IS 'traffic flows in both directions, direct (that of geom) or reverse';
COMMENT ON CONSTRAINT axis_direction_check ON :"model".axis IS
    'both, direct (that of the line) or reverse. Leave it out for both.';
COMMENT ON COLUMN :"model".axis.speed IS 'speed of the traffic, km/h; NULL: estimated';
COMMENT ON CONSTRAINT axis_speed_check ON :"model".axis IS '0.001 to 400 km/h. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.importance IS 'importance, 1 the highest; NULL: that of the class';
COMMENT ON CONSTRAINT axis_importance_check ON :"model".axis IS
    '1 to 99, 1 the highest. Leave it empty to take that of the class.';
COMMENT ON COLUMN :"model".axis.name IS 'name of the street';
COMMENT ON COLUMN :"model".axis.ref IS 'number of the route, such as D 906; several with ; between';
COMMENT ON COLUMN :"model".axis.level IS 'level above the ground, for bridges and tunnels';
COMMENT ON CONSTRAINT axis_level_check ON :"model".axis IS '-50 to 50. Leave it out for 0, the ground.';
COMMENT ON COLUMN :"model".axis.kind IS 'class of the source, see axis_class';
COMMENT ON COLUMN :"model".axis.radius IS
    'wanted radius of its corners, metres, 0: none; NULL: from importance or speed';
COMMENT ON CONSTRAINT axis_radius_check ON :"model".axis IS
    '0 to 200 m. Leave it empty to have it estimated, 0 for no arc.';
COMMENT ON COLUMN :"model".axis.lanes_forward IS
    'general, bus and carpool lanes along geom; NULL or 0: from lane_count';
COMMENT ON CONSTRAINT axis_lanes_forward_check ON :"model".axis IS '0 to 30. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.lanes_backward IS
    'general, bus and carpool lanes against geom; NULL or 0: from lane_count';
COMMENT ON CONSTRAINT axis_lanes_backward_check ON :"model".axis IS '0 to 30. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.lanes_both IS
    'general lanes in the middle that both directions use, of a two-way street; NULL or 0: from lane_count and width';
COMMENT ON CONSTRAINT axis_lanes_both_check ON :"model".axis IS '0 to 30. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.sidewalk_left IS
    'width of the sidewalk on the left of geom, metres; 0: none; NULL: estimated, by setting sidewalk_by_importance; '
    'none on medians, splitters and islands';
COMMENT ON CONSTRAINT axis_sidewalk_left_check ON :"model".axis IS
    '0 to 50 m, 0 for none. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.sidewalk_right IS 'the same on the right of geom';
COMMENT ON CONSTRAINT axis_sidewalk_right_check ON :"model".axis IS
    '0 to 50 m, 0 for none. Leave it empty to have it estimated.';
COMMENT ON COLUMN :"model".axis.flow IS 'vehicles an hour, of both directions; NULL: unknown';
COMMENT ON CONSTRAINT axis_flow_check ON :"model".axis IS
    '0 to 1000000 vehicles an hour. Leave it empty where it is unknown.';
COMMENT ON COLUMN :"model".axis.kind_forward IS
    'kinds of all lanes along geom, such as general|bus|carpool|cycle|parking, from left to right; NULL: all general';
COMMENT ON CONSTRAINT axis_kind_forward_check ON :"model".axis IS
    'kinds of lanes such as general|bus. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.kind_backward IS 'the same against geom, from left to right in driving direction';
COMMENT ON CONSTRAINT axis_kind_backward_check ON :"model".axis IS
    'kinds of lanes such as general|bus. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.lane_width_forward IS
    'widths of the lanes along geom, such as 3.5||1.5, metres; empty or 0: an equal share of what the others leave; '
    'cycle and parking lanes may be left out';
COMMENT ON CONSTRAINT axis_lane_width_forward_check ON :"model".axis IS
    'widths in metres such as 3.5||3. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.lane_width_backward IS 'the same against geom';
COMMENT ON CONSTRAINT axis_lane_width_backward_check ON :"model".axis IS
    'widths in metres such as 3.5||3. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.turn_forward IS
    'movements of the lanes along geom, as OSM''s turn:lanes: left|through;right; cycle and parking lanes may be '
    'left out';
COMMENT ON CONSTRAINT axis_turn_forward_check ON :"model".axis IS
    'turns such as left|through;right. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.turn_backward IS 'the same against geom, from left to right in driving direction';
COMMENT ON CONSTRAINT axis_turn_backward_check ON :"model".axis IS
    'turns such as left|through;right. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.change_forward IS
    'where one may leave the lanes along geom, as OSM''s change:lanes: yes|not_right|no; cycle and parking lanes may '
    'be left out; NULL or empty: as the lines between lanes say';
COMMENT ON CONSTRAINT axis_change_forward_check ON :"model".axis IS
    'words such as yes|not_right|no. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.change_backward IS 'the same against geom, from left to right in driving direction';
COMMENT ON CONSTRAINT axis_change_backward_check ON :"model".axis IS
    'words such as yes|not_right|no. Leave it empty where nothing is known of single lanes.';
COMMENT ON COLUMN :"model".axis.roundabout_tag IS
    'what the source says of a roundabout: roundabout or circular (OpenStreetMap, one way round along geom), '
    'Rond-point (BD TOPO); it counts where setting roundabout_tags is true';
COMMENT ON COLUMN :"model".axis.source IS 'table or prefix that it was imported from';
COMMENT ON COLUMN :"model".axis.source_ref IS 'its identity in the source';
COMMENT ON COLUMN :"model".axis.source_geom IS 'its line as the source has it, before cleaning';
COMMENT ON COLUMN :"model".axis.source_hash IS
    'hash of its values as the source has them: an import that finds line and values as before leaves what was '
    'edited by hand';
COMMENT ON COLUMN :"model".axis.width_by_hand IS
    'were width and width_end put by hand, by an update that no importer made? They are believed then, and imports '
    'keep them; false gives those of the source back';
COMMENT ON COLUMN :"model".axis.source_width IS 'width of the source where one was put by hand, metres';
COMMENT ON COLUMN :"model".axis.source_width_end IS 'width_end of the source where widths were put by hand, metres';
