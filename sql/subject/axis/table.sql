-- The tables of axes and of their classes: what each column means, and what may be typed there.

CREATE OR REPLACE FUNCTION streetgen._axis_column()
    RETURNS TABLE(relation name, attribute name, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 80 SET search_path = pg_catalog
    AS $$ VALUES
    ('axis_class'::name, 'class'::name, 'class of the source, as in axis.kind'),
    ('axis_class', 'taken', 'do importers take it as an axis'),
    ('axis_class', 'width', 'width kerb to kerb where neither width nor lanes are known, metres'),
    ('axis_class', 'speed', 'speed where unknown, km/h'),
    ('axis_class', 'importance', 'importance where unknown, 1 the highest'),
    ('axis_class', 'highway_role', 'what the class is at ramps: highway; fast_road, a highway where its speed is 60 '
        'km/h or more or unknown; highway_link, the link of a highway; link, that of another road; NULL: nothing'),
    ('axis_class', 'walked_along', 'do people walk along it; else its sidewalks are not estimated'),
    ('axis_class', 'crossed_on_foot', 'do people cross it; else no rule that names no class places a crossing on it'),
    ('axis_class', 'lanes_by_width', 'does the width tell the lanes; else it is one lane however wide, as a runway is'),
    ('axis', 'axis_id', 'key'),
    ('axis', 'geom', 'the axis of the road; direction speaks of its direction'),
    ('axis', 'width', 'width kerb to kerb at the start, metres; NULL: estimated. Put by hand, or without a source, '
        'it is believed; of a source up to setting max_width_per_lane for each lane of lane_count, else estimated; '
        'NULL over one put by hand: that of the source'),
    ('axis', 'width_end', 'width kerb to kerb at the end, metres, reached linearly; NULL: as at the start. Believed '
        'as width is'),
    ('axis', 'roadway_offset', 'metres from the axis to the middle of the roadway, left of geom positive; at most half '
        'of the width, as far as leaves the axis on the roadway; NULL: 0'),
    ('axis', 'lane_count', 'number of general and bus lanes of both directions; NULL: estimated'),
    ('axis', 'direction', 'traffic flows in both directions, direct (that of geom) or reverse'),
    ('axis', 'speed', 'speed of the traffic, km/h; NULL: estimated'),
    ('axis', 'importance', 'importance, 1 the highest; NULL: that of the class'),
    ('axis', 'name', 'name of the street'),
    ('axis', 'level', 'level above the ground, for bridges and tunnels'),
    ('axis', 'kind', 'class of the source, see axis_class'),
    ('axis', 'radius', 'wanted radius of its corners, metres, 0: none; NULL: from importance or speed'),
    ('axis', 'lanes_forward', 'general and bus lanes along geom; NULL or 0: from lane_count'),
    ('axis', 'lanes_backward', 'general and bus lanes against geom; NULL or 0: from lane_count'),
    ('axis', 'lanes_both', 'general lanes in the middle that both directions use, of a two-way street; NULL or 0: '
        'from lane_count and width'),
    ('axis', 'flow', 'vehicles an hour, of both directions; NULL: unknown'),
    ('axis', 'sidewalk_left', 'width of the sidewalk on the left of geom, metres; 0: none; NULL: estimated, by setting '
        'sidewalk_by_importance; none on the island of a roundabout by roundabout_tag'),
    ('axis', 'sidewalk_right', 'the same on the right of geom'),
    ('axis', 'kind_forward',
        'kinds of all lanes along geom, such as general|bus|cycle|parking, from left to right; NULL: general lanes '
        'only'),
    ('axis', 'kind_backward', 'the same against geom, from left to right in driving direction'),
    ('axis', 'lane_width_forward',
        'widths of the lanes along geom, such as 3.5||1.5, metres; empty or 0: an equal share of what the others '
        'leave; cycle and parking lanes may be left out'),
    ('axis', 'lane_width_backward', 'the same against geom'),
    ('axis', 'turn_forward',
        'movements of the lanes along geom, as OSM''s turn:lanes: left|through;right; cycle and parking lanes may be '
        'left out'),
    ('axis', 'turn_backward', 'the same against geom, from left to right in driving direction'),
    ('axis', 'change_forward', 'where one may leave the lanes along geom, as OSM''s change:lanes: yes|not_right|no; '
        'cycle and parking lanes may be left out; NULL or empty: as the lines between lanes say'),
    ('axis', 'change_backward', 'the same against geom, from left to right in driving direction'),
    ('axis', 'roundabout_tag',
        'what the source says of a roundabout: roundabout or circular (OpenStreetMap, one way round along geom), '
        'Rond-point (BD TOPO); it counts where setting roundabout_tags is true'),
    ('axis', 'source', 'table or prefix that it was imported from'),
    ('axis', 'source_ref', 'its identity in the source'),
    ('axis', 'source_geom', 'its line as the source has it, before cleaning'),
    ('axis', 'width_by_hand',
        'were width and width_end put by hand, by an update that no importer made? They are believed then, and '
        'imports keep them; false gives those of the source back'),
    ('axis', 'source_width', 'width of the source where one was put by hand, metres'),
    ('axis', 'source_width_end', 'width_end of the source where widths were put by hand, metres'),
    ('axis', 'source_hash',
        'hash of its values as the source has them: an import that finds line and values as before leaves what was '
        'edited by hand'),
    ('control_point', 'control_point_id', 'key'),
    ('control_point', 'geom', 'where it stands, on or beside an axis'),
    ('control_point', 'kind', 'signals, stop, yield, mini_roundabout or pedestrian_crossing'),
    ('control_point', 'direction', 'the traffic that it speaks to: direct (along the axis), reverse or both; NULL: '
        'that of a one-way street, else that towards the nearer junction, and all that comes to a node it lies on'),
    ('control_point', 'axis_id', 'the axis; filled with the nearest where left out; NULL: it stands off all axes'),
    ('control_point', 'abscissa', 'its place along the axis, metres; filled'),
    ('control_point', 'axis_distance', 'how far it stands from the axis, metres; filled'),
    ('control_point', 'source', 'table that it was imported from'),
    ('control_point', 'source_ref', 'its identity in the source'),
    ('setting_used', 'settings', 'name of each to its value'),
    ('setting_used', 'setting_hash', 'their hash'),
    ('axis_used', 'axis_id', 'the axis'),
    ('axis_used', 'geom', 'the axis of the road'),
    ('axis_used', 'level', 'level of the axis'),
    ('axis_used', 'width', 'width kerb to kerb at the start, metres'),
    ('axis_used', 'width_end', 'width kerb to kerb at the end, metres'),
    ('axis_used', 'roadway_offset', 'metres from the axis to the middle of the roadway, left positive'),
    ('axis_used', 'lane_count', 'number of general and bus lanes of both directions'),
    ('axis_used', 'lanes_forward', 'general and bus lanes along the axis'),
    ('axis_used', 'lanes_backward', 'general and bus lanes against the axis'),
    ('axis_used', 'lanes_both', 'lanes that both directions use'),
    ('axis_used', 'direction', 'direction of the traffic'),
    ('axis_used', 'kind_forward', 'kinds of the lanes along the axis, NULL: all general'),
    ('axis_used', 'kind_backward', 'kinds of the lanes against the axis, NULL: all general'),
    ('axis_used', 'lane_width_forward', 'widths of the lanes along the axis, metres'),
    ('axis_used', 'lane_width_backward', 'widths of the lanes against the axis, metres'),
    ('axis_used', 'turn_forward', 'movements of the lanes along the axis'),
    ('axis_used', 'turn_backward', 'movements of the lanes against the axis'),
    ('axis_used', 'speed', 'speed of the traffic, km/h'),
    ('axis_used', 'importance', 'importance, 1 the highest'),
    ('axis_used', 'radius', 'wanted radius of its corners, metres, 0: none'),
    ('axis_used', 'estimated', 'which of these values are estimated'),
    ('axis_used', 'input_hash', 'hash of the axis and the values used'),
    ('axis_used', 'sidewalk_left', 'width of the sidewalk on the left, metres; 0: none'),
    ('axis_used', 'sidewalk_right', 'width of the sidewalk on the right, metres; 0: none'),
    ('axis_used', 'setting_hash', 'hash of the settings') $$;
COMMENT ON FUNCTION streetgen._axis_column() IS 'The columns of axes, and what each is.';

CREATE OR REPLACE FUNCTION streetgen._axis_input_rule()
    RETURNS TABLE(relation name, attribute name, expected text, way_out text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 32 SET search_path = pg_catalog
    AS $$ VALUES
    ('axis'::name, 'geom'::name, 'a line through two different places, every coordinate a number within 1e12',
        'Draw it again, or undo the edit.'),
    ('axis', 'width', '0.001 to 200 m', 'Leave it empty to have it estimated.'),
    ('axis', 'width_end', '0.001 to 200 m', 'Leave it empty where the width stays the same.'),
    ('axis', 'roadway_offset', '-100 to 100 m', 'Leave it empty where the axis runs along the middle.'),
    ('axis', 'lane_count', '1 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'direction', 'both, direct (that of the line) or reverse', 'Leave it out for both.'),
    ('axis', 'speed', '0.001 to 400 km/h', 'Leave it empty to have it estimated.'),
    ('axis', 'importance', '1 to 99, 1 the highest', 'Leave it empty to take that of the class.'),
    ('axis', 'level', '-50 to 50', 'Leave it out for 0, the ground.'),
    ('axis', 'radius', '0 to 200 m', 'Leave it empty to have it estimated, 0 for no arc.'),
    ('axis', 'lanes_forward', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'lanes_backward', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'lanes_both', '0 to 30', 'Leave it empty to have it estimated.'),
    ('axis', 'flow', '0 to 1000000 vehicles an hour', 'Leave it empty where it is unknown.'),
    ('axis', 'sidewalk_left', '0 to 50 m, 0 for none', 'Leave it empty to have it estimated.'),
    ('axis', 'sidewalk_right', '0 to 50 m, 0 for none', 'Leave it empty to have it estimated.'),
    ('axis', 'kind_forward', 'kinds of lanes such as general|bus',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'kind_backward', 'kinds of lanes such as general|bus',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'lane_width_forward', 'widths in metres such as 3.5||3',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'lane_width_backward', 'widths in metres such as 3.5||3',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'turn_forward', 'turns such as left|through;right',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'turn_backward', 'turns such as left|through;right',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'change_forward', 'words such as yes|not_right|no',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'change_backward', 'words such as yes|not_right|no',
        'Leave it empty where nothing is known of single lanes.'),
    ('axis', 'roundabout_tag', 'roundabout, circular or Rond-point',
        'Leave it empty where the source says nothing of a roundabout.'),
    ('axis_class', 'width', '0.001 to 200 m', 'Leave it empty to have it estimated.'),
    ('axis_class', 'speed', '0 to 400 km/h', 'Leave it empty to have it estimated.'),
    ('axis_class', 'importance', '1 to 99, 1 the highest', 'Leave it empty for setting importance_default.'),
    ('axis_class', 'highway_role', 'highway, fast_road, highway_link or link',
        'Leave it empty where the class is nothing at ramps.'),
    ('control_point', 'kind', 'signals, stop, yield, mini_roundabout or pedestrian_crossing', 'Say what stands there.'),
    ('control_point', 'abscissa', '0 m or more along the axis', 'Leave it empty: it follows from the place.'),
    ('control_point', 'axis_distance', '0 m or more from the axis', 'Leave it empty: it follows from the place.'),
    ('control_point', 'direction', 'direct, reverse or both', 'Leave it empty where it is unknown.') $$;
COMMENT ON FUNCTION streetgen._axis_input_rule() IS 'What may be typed into tables of axes, and the way out.';

CREATE OR REPLACE FUNCTION streetgen._add_roundabout_tag(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    ALTER TABLE axis ADD IF NOT EXISTS roundabout_tag text;
    IF NOT EXISTS (SELECT FROM pg_constraint WHERE conrelid = 'axis'::regclass
        AND conname = 'axis_roundabout_tag_check') THEN
        -- A word that an older build took stays.
        ALTER TABLE axis ADD CONSTRAINT axis_roundabout_tag_check
            CHECK (roundabout_tag IN ('roundabout', 'circular', 'Rond-point')) NOT VALID;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._add_roundabout_tag(name) IS
    'Adds the word of the source for a roundabout, and which words it may be, where a model was made before.';
