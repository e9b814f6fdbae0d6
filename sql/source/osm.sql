CREATE OR REPLACE FUNCTION streetgen._osm_sidewalk(of_side text, of_way text, width text, side text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE
        WHEN coalesce(of_side, of_way) IN ('no', 'none') THEN 0
        WHEN of_side IS NULL AND of_way IN ('left', 'right') AND of_way <> side THEN 0
        ELSE streetgen._within(streetgen._metres(width), 0, 50) END;
COMMENT ON FUNCTION streetgen._osm_sidewalk(text, text, text, text) IS
    'Width in metres of the sidewalk on one side (left or right) of a way, from what its tags say of this side, of '
    'the way and of the width; 0: none; NULL: unknown.';

CREATE OR REPLACE FUNCTION streetgen._means_sidewalk(VARIADIC words text[]) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_remove(words, NULL) <@ '{both,left,right,yes,no,none,separate,shared,lane,crossing,mapped}' $$;
COMMENT ON FUNCTION streetgen._means_sidewalk(text[]) IS
    'Do all words, of tag sidewalk and those of its sides, say something of sidewalks? NULL says nothing.';

CREATE OR REPLACE FUNCTION streetgen._osm_layer(tags jsonb) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN tags ->> 'layer' ~ '^[-+]?0?(\d|10)$' THEN (tags ->> 'layer')::integer END;
COMMENT ON FUNCTION streetgen._osm_layer(jsonb) IS
    'The number from -10 to 10 that tag layer of a way says; NULL where it says none.';

CREATE OR REPLACE FUNCTION streetgen._osm_structure(tags jsonb) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN coalesce(tags ->> 'bridge', 'no') <> 'no' THEN 1
        -- One walks and drives through a house on the ground.
        WHEN coalesce(tags ->> 'tunnel', 'no') NOT IN ('no', 'building_passage') THEN -1 ELSE 0 END;
COMMENT ON FUNCTION streetgen._osm_structure(jsonb) IS
    'The level that tags bridge and tunnel of a way say: 1 of a bridge, -1 of a tunnel, else 0.';

CREATE OR REPLACE FUNCTION streetgen._osm_level(tags jsonb) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(nullif(streetgen._osm_layer(tags), 0), streetgen._osm_structure(tags));
COMMENT ON FUNCTION streetgen._osm_level(jsonb) IS
    'The level of a way: its layer; on layer 0 or none that of a bridge or tunnel.';

CREATE OR REPLACE FUNCTION streetgen._osm_off_street(tags jsonb) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(tags ->> 'indoor', 'no') <> 'no' OR tags ->> 'location' IN ('indoor', 'underground')
        OR coalesce(tags ->> 'level', '0') !~ '^\s*0\s*$';
COMMENT ON FUNCTION streetgen._osm_off_street(jsonb) IS
    'Does a way lie within a building, or on another floor than that of the street?';

CREATE OR REPLACE FUNCTION streetgen._osm_walk_role(tags jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN 'crossing' IN (tags ->> 'footway', tags ->> 'cycleway', tags ->> 'path') THEN 'crossing'
        ELSE tags ->> 'footway' END;
COMMENT ON FUNCTION streetgen._osm_walk_role(jsonb) IS
    'The role of what is walked or cycled on: crossing by tags footway, cycleway or path, else what footway says.';

CREATE OR REPLACE FUNCTION streetgen._unread_walk_tags(tags jsonb) RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT array_agg(key) FROM (SELECT key FROM (VALUES
        ('footway', '{sidewalk,crossing,traffic_island,island,access_aisle,link,connection,alley,passage,platform,'
            'sidepath,yes,no}'::text[]),
        ('indoor', '{yes,no,room,area,corridor,wall,door,level,column}'),
        ('location', '{indoor,outdoor,underground,overground,surface,roof,bridge,kiosk}'),
        ('path', '{crossing,sidewalk,link,connection,mtb,desire,yes,no}'),
        ('tactile_paving', '{yes,no,incorrect,partial,contrasted,primitive}'),
        ('wheelchair', '{yes,designated,limited,bad,no,impassable}')) v(key, words)
        WHERE tags ->> key <> ALL (words)
    UNION ALL SELECT 'foot' WHERE tags ->> 'foot' <> 'unknown' AND streetgen._osm_foot(tags ->> 'foot', NULL) IS NULL
    UNION ALL SELECT 'incline' WHERE tags ->> 'incline' NOT IN ('up', 'down', 'yes', 'no', 'steep')
        AND streetgen._osm_incline(tags ->> 'incline') IS NULL
    UNION ALL SELECT 'level' WHERE tags ->> 'level' !~ '^[-+\d.;, ]+$'
    UNION ALL SELECT 'crossing' WHERE streetgen._osm_walk_role(tags) = 'crossing' AND tags ->> 'crossing' <> 'no'
        AND streetgen._osm_crossing(tags ->> 'crossing') IS NULL
    UNION ALL SELECT 'crossing:markings' WHERE streetgen._osm_walk_role(tags) = 'crossing'
        AND tags ? 'crossing:markings' AND streetgen._osm_marking(tags ->> 'crossing:markings') IS NULL) unread $$;
COMMENT ON FUNCTION streetgen._unread_walk_tags(jsonb) IS
    'The tags of what is walked or cycled on whose words mean nothing; NULL: none.';

CREATE OR REPLACE FUNCTION streetgen._osm_table(suffix text, prefix text, schemas name[]) RETURNS regclass
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT c.oid FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace
    WHERE c.relname = prefix || suffix AND n.nspname = ANY (schemas) OR n.nspname || '.' || c.relname = prefix || suffix
    ORDER BY array_position(schemas, n.nspname) LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._osm_table(text, text, name[]) IS
    'The table PREFIX followed by the suffix, in the first of the schemas that has it or in the schema that the '
    'prefix names; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._osm_column_tags() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT ARRAY['lanes', 'lanes:forward', 'lanes:backward', 'lanes:both_ways', 'lanes:reversible', 'width',
        'oneway', 'junction', 'layer', 'bridge', 'tunnel', 'maxspeed', 'turn:lanes', 'turn:lanes:forward',
        'turn:lanes:backward', 'width:lanes', 'width:lanes:forward', 'width:lanes:backward', 'bus:lanes',
        'bus:lanes:forward', 'bus:lanes:backward', 'psv:lanes', 'psv:lanes:forward', 'psv:lanes:backward', 'lanes:bus',
        'lanes:psv', 'lanes:bus:forward', 'lanes:bus:backward', 'busway', 'busway:left', 'busway:right', 'busway:both',
        'cycleway', 'cycleway:left', 'cycleway:right', 'cycleway:both', 'cycleway:left:oneway',
        'cycleway:right:oneway', 'parking:left', 'parking:right', 'parking:both', 'parking:lane:left',
        'parking:lane:right', 'parking:lane:both', 'sidewalk', 'sidewalk:left', 'sidewalk:right', 'sidewalk:both',
        'sidewalk:left:width', 'sidewalk:right:width', 'sidewalk:both:width', 'placement', 'placement:forward',
        'placement:backward', 'change:lanes', 'change:lanes:forward', 'change:lanes:backward'] $$;
COMMENT ON FUNCTION streetgen._osm_column_tags() IS
    'The tags that tables of older flex files have columns for, named as the tags are with _ in place of :.';

CREATE OR REPLACE FUNCTION streetgen._take_osm_lines(source regclass) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    present constant name[] := ARRAY(SELECT attname FROM pg_attribute WHERE attrelid = source AND attnum > 0
        AND NOT attisdropped);
    tags constant text := CASE WHEN 'tags' = ANY (present)
        THEN 'CASE jsonb_typeof(tags::jsonb) WHEN ''object'' THEN jsonb_strip_nulls(tags::jsonb) ELSE ''{}'' END'
        ELSE format('jsonb_strip_nulls(jsonb_object(ARRAY[%s]::text[]))', (
            SELECT string_agg(format('%L, %I', tag, name), ', ') FROM unnest(streetgen._osm_column_tags()) tag,
            LATERAL (SELECT replace(tag, ':', '_') AS name) c WHERE name = ANY (present))) END;
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE _import_line ON COMMIT DROP AS SELECT geom, way_id, class::text, '
        'name::text, %s AS ref, %s AS tags, %s AS lacks_nodes FROM %s', CASE WHEN 'ref' = ANY (present) THEN 'ref::text'
        ELSE 'NULL::text' END, tags, CASE WHEN 'nodes' = ANY (present) THEN 'nodes > ST_NPoints(geom)' ELSE 'false' END,
        source);
END $$;
COMMENT ON FUNCTION streetgen._take_osm_lines(regclass) IS
    'Copies the lines of an OSM table to where import_osm reads them, each with its tags; none where they are NULL or '
    'no object. A table of an older flex file has a column for each tag in place of tags.';

CREATE OR REPLACE FUNCTION streetgen._leave_out_areas(areas regclass)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._take_points('_import_round', 'SELECT way_id::text AS source_ref FROM '
        || coalesce(areas::text, '(VALUES (NULL)) none(way_id)'));
    RETURN QUERY WITH area AS (DELETE FROM pg_temp._import_line WHERE tags ->> 'area' = 'yes'
            RETURNING class, way_id::text AS source_ref)
        SELECT 'area, and so no street', class, count(*), array_agg(source_ref ORDER BY source_ref) FROM area a
        WHERE NOT EXISTS (SELECT FROM pg_temp._import_round r WHERE r.source_ref = a.source_ref)
        GROUP BY class ORDER BY class;
    DROP TABLE pg_temp._import_round;
END $$;
COMMENT ON FUNCTION streetgen._leave_out_areas(regclass) IS
    'Leaves out the lines of OpenStreetMap that go round an area, and tells by class those that are not among the '
    'areas of a table, which are told with these. NULL: there is no such table.';

CREATE OR REPLACE FUNCTION streetgen._read_osm_tags(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    driving_side constant text := streetgen._driving_side(model);
    lane_width constant float8 := streetgen._setting_number(model, 'lane_width');
    cycle_lane_width constant float8 := streetgen._setting_number(model, 'cycle_lane_width');
    parking_lane_width constant float8 := streetgen._setting_number(model, 'parking_lane_width');
    diagonal_depth constant float8 := streetgen._setting_number(model, 'parking_depth_diagonal');
    perpendicular_depth constant float8 := streetgen._setting_number(model, 'parking_depth_perpendicular');
    two_way_width constant float8 := streetgen._setting_number(model, 'two_way_width_minimal');
    width_default constant float8 := streetgen._setting_number(model, 'width_default');
BEGIN
    -- A city's ways have few wordings of tags, and each is read once.
    CREATE TEMPORARY TABLE _import_meaning ON COMMIT DROP AS
    SELECT class, tags, metres AS width, lanes.roadway_offset, lanes.lane_count,
        -- A direction that the tag of a roundabout alone implies is left to that tag.
        CASE WHEN ring AND NOT stated THEN 'both' ELSE lanes.direction END AS direction,
        CASE WHEN ring AND lanes.direction <> 'both' THEN tags ->> 'junction' END AS roundabout_tag, kmh AS speed,
        streetgen._osm_level(tags) AS level,
        lanes.lanes_forward, lanes.lanes_backward, lanes.lanes_both, lanes.kind_forward, lanes.kind_backward,
        lanes.lane_width_forward, lanes.lane_width_backward, lanes.turn_forward, lanes.turn_backward,
        lanes.change_forward, lanes.change_backward, lanes.access, lanes.parking_left, lanes.parking_right,
        lanes.strips_left, lanes.strips_right, height_limit,
        CASE WHEN tags ->> 'lane_markings' IN ('yes', 'no') THEN tags ->> 'lane_markings' END AS lane_markings,
        CASE WHEN apart_left AND apart_right THEN 'both' WHEN apart_left THEN 'left' WHEN apart_right THEN 'right' END
            AS sidewalk_apart,
        streetgen._osm_sidewalk(walk_left, tags ->> 'sidewalk', said_walk_left, 'left') AS sidewalk_left,
        streetgen._osm_sidewalk(walk_right, tags ->> 'sidewalk', said_walk_right, 'right') AS sidewalk_right,
        array_remove(ARRAY[CASE WHEN width_unread THEN 'width' END, CASE WHEN speed_unread THEN 'speed' END,
            CASE WHEN limit_unread THEN 'height limit' END,
            CASE WHEN tags ? 'layer' AND streetgen._osm_layer(tags) IS NULL THEN 'level' END,
            CASE WHEN tags ->> 'lane_markings' NOT IN ('yes', 'no') THEN 'lane_markings' END,
            CASE WHEN tags ? 'railway' AND streetgen._osm_rails(tags ->> 'railway') IS NULL THEN 'railway' END,
            CASE WHEN tags ? 'embedded_rails' AND streetgen._osm_rails(tags ->> 'embedded_rails') IS NULL
                THEN 'embedded_rails' END,
            CASE WHEN tags ? 'gauge' AND streetgen._osm_gauge(tags ->> 'gauge') IS NULL THEN 'gauge' END,
            CASE WHEN tags ? 'tracks' AND streetgen._osm_tracks(tags ->> 'tracks') IS NULL THEN 'tracks' END,
            CASE WHEN NOT streetgen._means_sidewalk(tags ->> 'sidewalk', walk_left, walk_right) THEN 'sidewalk' END,
            CASE WHEN said_walk_left IS NOT NULL
                AND streetgen._within(streetgen._metres(said_walk_left), 0, 50) IS NULL
                OR said_walk_right IS NOT NULL
                AND streetgen._within(streetgen._metres(said_walk_right), 0, 50) IS NULL
                THEN 'sidewalk width' END], NULL) || streetgen._unread_walk_tags(tags) AS unread,
        lanes.unread_tags, lanes.unread_reasons
    FROM (SELECT DISTINCT class, tags FROM pg_temp._import_line) tagged
    LEFT JOIN (SELECT c.class, c.width AS class_width, c.speed AS class_speed, c.lanes_by_width,
        c.lanes_one_way
        FROM pg_temp._import_class c) usual USING (class),
    streetgen._osm_width(tags) across(metres, width_unread), streetgen._osm_speed(tags) pace(kmh, speed_unread),
    streetgen._osm_height_limit(tags ->> 'maxheight') sign(height_limit, limit_unread),
    -- Lanes of a street that says none.
    LATERAL (SELECT CASE WHEN lanes_by_width THEN least(CASE WHEN tags ->> 'oneway' IN ('yes', 'true', '1', '-1',
            'reverse') THEN lanes_one_way END, streetgen.estimated_lane_count(coalesce(nullif(metres, 0), class_width,
            width_default), coalesce(kmh, class_speed), lane_width)) ELSE 1 END AS usual_lanes) u,
    LATERAL (SELECT array_agg(key) AS keys, array_agg(value) AS words
        FROM jsonb_each_text(tags || jsonb_build_object('highway', coalesce(class, '')))) said,
    LATERAL streetgen._osm_lanes(keys, words, driving_side, lane_width, cycle_lane_width, parking_lane_width,
        coalesce(metres, 0), coalesce(usual_lanes, 1), two_way_width,
        streetgen._narrowest_of_several(lane_width), diagonal_depth, perpendicular_depth) lanes,
    LATERAL (SELECT tags ->> 'junction' IN ('roundabout', 'circular') AS ring, coalesce(tags ->> 'oneway'
        IN ('yes', 'true', '1', '-1', 'reverse', 'no', 'false', '0'), false) AS stated) way,
    LATERAL (SELECT coalesce(tags ->> 'sidewalk:left', tags ->> 'sidewalk:both') AS walk_left,
        coalesce(tags ->> 'sidewalk:right', tags ->> 'sidewalk:both') AS walk_right,
        coalesce(tags ->> 'sidewalk:left:width', tags ->> 'sidewalk:both:width', tags ->> 'sidewalk:width')
            AS said_walk_left,
        coalesce(tags ->> 'sidewalk:right:width', tags ->> 'sidewalk:both:width', tags ->> 'sidewalk:width')
            AS said_walk_right) walk,
    LATERAL (SELECT coalesce(walk_left, tags ->> 'sidewalk') = 'separate' AS apart_left,
        coalesce(walk_right, tags ->> 'sidewalk') = 'separate' AS apart_right) apart;
END $$;
COMMENT ON FUNCTION streetgen._read_osm_tags(name) IS
    'Reads each wording of tags of the lines that were copied once, where one drives as in this model.';

CREATE OR REPLACE FUNCTION streetgen._settle_osm_classes(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog
    AS $$
BEGIN
    CREATE TEMPORARY TABLE _import ON COMMIT DROP AS
        SELECT l.class, m.direction, m.roundabout_tag, m.lane_count, m.lanes_forward, m.lanes_backward, m.kind_forward,
            m.kind_backward
        FROM pg_temp._import_line l
            JOIN pg_temp._import_meaning m ON m.tags = l.tags AND m.class IS NOT DISTINCT FROM l.class;
    RETURN QUERY SELECT * FROM streetgen._settle_class_lanes(model);
    IF FOUND THEN
        DROP TABLE pg_temp._import_meaning, pg_temp._import_class;
        PERFORM streetgen._copy_classes(model), streetgen._read_osm_tags(model);
    END IF;
    DROP TABLE pg_temp._import;
END $$;
COMMENT ON FUNCTION streetgen._settle_osm_classes(name) IS
    'Gives classes the lanes that most of their lines state, as streetgen._settle_class_lanes does, and reads the tags '
    'once more where some got others: a lane at a kerb stands beside as many as the class has.';

CREATE OR REPLACE FUNCTION streetgen._osm_rows()
    RETURNS TABLE(geom geometry, name text, ref text, source_ref text, label text, width float8, roadway_offset float8,
        lane_count integer, direction text, roundabout_tag text, speed float8, level integer, class text,
        lanes_forward integer, lanes_backward integer, lanes_both integer, kind_forward text, kind_backward text,
        lane_width_forward text, lane_width_backward text, turn_forward text, turn_backward text, change_forward text,
        change_backward text, sidewalk_left float8, sidewalk_right float8, unread text[], left_out text, access text,
        parking_left text, parking_right text, lane_markings text, sidewalk_apart text, role text, marking text,
        surface text, incline float8, climb text, wheelchair text, tactile_paving text, foot text, gauge integer,
        tracks integer, rails text, rails_embedded boolean, paved text, sidewalk_paved_left text,
        sidewalk_paved_right text, cycle_paved_left text, cycle_paved_right text, strips_left text, strips_right text,
        height_limit float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
SELECT geom, name, ref, way_id::text, way_id::text, coalesce(m.width, r.room), m.roadway_offset, m.lane_count,
    m.direction, m.roundabout_tag, m.speed, m.level, l.class, m.lanes_forward, m.lanes_backward, m.lanes_both,
    CASE WHEN r.one_lane THEN streetgen._with_one_lane(m.kind_forward) ELSE m.kind_forward END,
    CASE WHEN r.one_lane THEN streetgen._with_one_lane(m.kind_backward) ELSE m.kind_backward END,
    m.lane_width_forward, m.lane_width_backward, m.turn_forward, m.turn_backward, m.change_forward, m.change_backward,
    m.sidewalk_left, m.sidewalk_right, m.unread,
    CASE WHEN c.use <> 'roadway' AND streetgen._osm_off_street(l.tags) THEN 'within a building or on another floor' END,
    m.access, m.parking_left, m.parking_right,
    m.lane_markings, m.sidewalk_apart, w.role, CASE w.role WHEN 'crossing' THEN coalesce(
        streetgen._osm_marking(l.tags ->> 'crossing:markings'), streetgen._osm_crossing(l.tags ->> 'crossing')) END,
    l.tags ->> 'surface', streetgen._osm_incline(l.tags ->> 'incline'), streetgen._osm_climb(l.tags ->> 'incline'),
    streetgen._osm_wheelchair(l.tags ->> 'wheelchair'), CASE WHEN l.tags ->> 'tactile_paving'
        IN ('yes', 'no', 'incorrect') THEN l.tags ->> 'tactile_paving' END,
    streetgen._osm_foot(l.tags ->> 'foot', l.tags ->> 'access'), streetgen._osm_gauge(l.tags ->> 'gauge'),
    streetgen._osm_tracks(l.tags ->> 'tracks'), coalesce(t.rails, t.embedded), t.rails IS NULL, l.tags ->> 'surface',
    coalesce(l.tags ->> 'sidewalk:left:surface', s.sidewalks),
    coalesce(l.tags ->> 'sidewalk:right:surface', s.sidewalks),
    coalesce(l.tags ->> 'cycleway:left:surface', s.cycle_lanes),
    coalesce(l.tags ->> 'cycleway:right:surface', s.cycle_lanes), m.strips_left, m.strips_right, m.height_limit
FROM pg_temp._import_line l JOIN pg_temp._import_meaning m ON m.tags = l.tags AND m.class IS NOT DISTINCT FROM l.class
    LEFT JOIN pg_temp._import_room r USING (way_id) LEFT JOIN pg_temp._import_class c ON c.class = l.class,
    LATERAL (SELECT streetgen._osm_walk_role(l.tags) AS role) w,
    LATERAL (SELECT streetgen._osm_rails(l.tags ->> 'railway') AS rails,
        streetgen._osm_rails(l.tags ->> 'embedded_rails') AS embedded) t,
    LATERAL (SELECT coalesce(l.tags ->> 'sidewalk:both:surface', l.tags ->> 'sidewalk:surface') AS sidewalks,
        coalesce(l.tags ->> 'cycleway:both:surface', l.tags ->> 'cycleway:surface') AS cycle_lanes) s
$$;
COMMENT ON FUNCTION streetgen._osm_rows() IS
    'The rows of the import that the lines of an OSM table become, with what their tags mean.';

CREATE OR REPLACE FUNCTION streetgen._tell_osm_lines(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT w.what, NULL::text, count(*), array_agg(a.source_ref ORDER BY a.source_ref)
        FROM pg_temp._import_line l JOIN axis a ON (a.source, a.source_ref) = (origin, l.way_id::text),
        LATERAL (VALUES
            ('fewer vertices than nodes: the file lacks some, or two are at one place', l.lacks_nodes),
            ('bridge on a layer below 0, or tunnel above: the layer stands',
                streetgen._osm_layer(l.tags) * streetgen._osm_structure(l.tags) < 0)) w(what, told)
        WHERE w.told GROUP BY w.what ORDER BY w.what;
END $$;
COMMENT ON FUNCTION streetgen._tell_osm_lines(name, text) IS
    'What an import tells of its ways: those of which the file lacks nodes, and those whose tags contradict each other '
    'about their level.';

CREATE OR REPLACE FUNCTION streetgen.import_osm(model name, prefix text DEFAULT 'osm',
    schemas name[] DEFAULT current_schemas(true))
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    source regclass := streetgen._osm_table('_line', prefix, schemas);
    driving_side text;
    first boolean;
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('prefix', prefix, 'schemas', schemas::text);
    IF source IS NULL THEN
        RAISE EXCEPTION 'there is no table %', quote_ident(prefix || '_line') USING ERRCODE = '42P01',
            HINT = 'osm2pgsql -O flex -S data/osm2pgsql_flex.lua makes it; a schema that is not in search_path '
                'stands before the prefix: ''gis.osm''.';
    END IF;
    driving_side := streetgen._driving_side(model);
    first := NOT streetgen._knows_source(model, source::text);
    PERFORM streetgen._take_osm_lines(source);
    RETURN QUERY SELECT * FROM streetgen._leave_out_areas(streetgen._osm_table('_area', prefix, schemas));
    PERFORM streetgen._read_osm_tags(model);
    RETURN QUERY SELECT * FROM streetgen._settle_osm_classes(model);
    RETURN QUERY SELECT * FROM streetgen._settle_carriageways(model);
    -- A way of which a file lacks all nodes but one has not gone.
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text, 'SELECT * FROM streetgen._osm_rows()',
        shapeless_stay => true);
    IF streetgen._driving_side(model) <> driving_side THEN
        -- The tags of kerbs mean other lanes where one drives on the other side.
        DROP TABLE pg_temp._import_meaning;
        PERFORM streetgen._take_classes(model), streetgen._read_osm_tags(model);
        PERFORM FROM streetgen._import(model, source::text, 'SELECT * FROM streetgen._osm_rows()',
            shapeless_stay => true);
    END IF;
    CREATE TEMPORARY TABLE _import_unread ON COMMIT DROP AS
        SELECT l.way_id::text AS source_ref, u.tag, coalesce(m.tags ->> u.tag, m.class) AS value, u.reason
        FROM pg_temp._import_meaning m JOIN pg_temp._import_line l
            ON l.tags = m.tags AND l.class IS NOT DISTINCT FROM m.class,
            unnest(m.unread_tags, m.unread_reasons) u(tag, reason);
    RETURN QUERY SELECT * FROM streetgen._tell_unread_lanes(model, source::text);
    RETURN QUERY SELECT * FROM streetgen._tell_osm_lines(model, source::text);
    DROP TABLE pg_temp._import_line, pg_temp._import_meaning, pg_temp._import_room, pg_temp._import_unread;
    RETURN QUERY SELECT * FROM streetgen._tell_parking(model, source::text, first);
    RETURN QUERY SELECT * FROM streetgen._import_restrictions(model, source,
        streetgen._osm_table('_restriction', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_osm_controls(model,
        streetgen._osm_table('_control', prefix, schemas), streetgen._osm_table('_crossing_way', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_osm_kerbs(model, streetgen._osm_table('_control', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_osm_areas(model, streetgen._osm_table('_area', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_routes(model, source, streetgen._osm_table('_route', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._tell_misspelt(model, streetgen._osm_table('_misspelt', prefix, schemas));
END $$;
COMMENT ON FUNCTION streetgen.import_osm(name, text, name[]) IS
    'Imports the table PREFIX_line that osm2pgsql writes with data/osm2pgsql_flex.lua, found in the schemas of '
    'search_path or named with its schema (gis.osm): width, direction, who may drive, level, speed, name, number of '
    'the route, class, sidewalks, how cars stand beside the roadway, and the lanes of each direction with their kinds, '
    'widths, turns and changes; and the turn restrictions of PREFIX_restriction and the signals, signs and crossings '
    'of PREFIX_control, the areas of PREFIX_area and the routes of PREFIX_route. A tag that means nothing is '
    'unknown, and reported by way; tags of lanes that were not made, and the misspelt tags of PREFIX_misspelt, stand '
    'in table unread_tag, each with its reason. streetgen.tag_use() tells what becomes of each.';
