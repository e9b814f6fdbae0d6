CREATE OR REPLACE FUNCTION streetgen._osm_count(value text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN value ~ '^\s*\d{1,2}(\.0+)?\s*$' THEN substring(value FROM '\d+')::integer END;
COMMENT ON FUNCTION streetgen._osm_count(text) IS 'An OSM number of lanes; NULL where it is none.';

CREATE OR REPLACE FUNCTION streetgen._osm_length(list text) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN cardinality(string_to_array(list, '|'));
COMMENT ON FUNCTION streetgen._osm_length(text) IS 'How many lanes a :lanes tag of OSM speaks of.';

CREATE OR REPLACE FUNCTION streetgen._osm_list(list text, kind text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT text FROM (SELECT CASE kind WHEN 'turn' THEN replace(lower(list), ' ', '')
        WHEN 'change' THEN replace(lower(list), ' ', '')
        ELSE streetgen._metres_by_lane(list) END AS text) t
        WHERE streetgen.is_lane_list(text, kind) $$;
COMMENT ON FUNCTION streetgen._osm_list(text, text) IS
    'An OSM :lanes tag as a list of axis, NULL where it means nothing. kind: turn, change or width.';

CREATE OR REPLACE FUNCTION streetgen._osm_kerb(of_side text, of_both text, of_way text, against text, direction text,
    side text, driving_side text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE
        WHEN coalesce(of_side, of_both) = 'lane' THEN CASE against WHEN '-1' THEN 'opposite' ELSE 'lane' END
        WHEN coalesce(of_side, of_both) = 'opposite_lane' THEN 'opposite'
        WHEN of_way = 'lane' AND (direction = 'both' OR (direction = 'direct') = (side = driving_side)) THEN 'lane'
        WHEN of_way = 'opposite_lane' AND direction <> 'both' AND (direction = 'direct') <> (side = driving_side)
            THEN 'opposite' END;
COMMENT ON FUNCTION streetgen._osm_kerb(text, text, text, text, text, text, text) IS
    'What the tags of one kind (cycleway, busway) say of the left or right kerb of a way: lane, opposite (against the '
    'direction of the street) or NULL.';

CREATE OR REPLACE FUNCTION streetgen._osm_sidewalk(of_side text, of_way text, width text, side text) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE
        WHEN coalesce(of_side, of_way) IN ('no', 'none') THEN 0
        WHEN of_side IS NULL AND of_way IN ('left', 'right') AND of_way <> side THEN 0
        ELSE streetgen._within(streetgen._metres(width), 0, 50) END;
COMMENT ON FUNCTION streetgen._osm_sidewalk(text, text, text, text) IS
    'Width in metres of the sidewalk on one side (left or right) of a way, from what its tags say of this side, of '
    'the way and of the width; 0: none; NULL: unknown.';

CREATE OR REPLACE FUNCTION streetgen._osm_roadway_offset(placement text, lanes_before integer, lanes_along integer,
    lanes_total integer, lane_width float8) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN lane BETWEEN 1 AND lanes_along AND lanes_total <= 30
        THEN (lanes_before + lane - CASE split_part(placement, ':', 1) WHEN 'left_of' THEN 1 WHEN 'middle_of' THEN 0.5
            ELSE 0 END - lanes_total / 2.0) * lane_width END
    FROM (SELECT CASE WHEN placement ~ '^(left_of|middle_of|right_of):\d{1,2}$'
        THEN split_part(placement, ':', 2)::integer END AS lane) l $$;
COMMENT ON FUNCTION streetgen._osm_roadway_offset(text, integer, integer, integer, float8) IS
    'How far to the left of its way, seen along the lanes that a placement tag of OSM counts, the middle of all lanes '
    'lies, metres: left_of, middle_of or right_of the lane of a number, from 1 to lanes_along, with so many lanes '
    'before them on the left. NULL where the tag says nothing of the kind.';

CREATE OR REPLACE FUNCTION streetgen._osm_beside(kerb text, way text, direction text, near text, far text)
    RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN coalesce(CASE
        WHEN direction = 'both' THEN kerb = 'near' AND near = 'lane'
        WHEN direction = way THEN CASE kerb WHEN 'near' THEN near ELSE far END = 'lane'
        ELSE kerb = 'near' AND near = 'opposite' END, false);
COMMENT ON FUNCTION streetgen._osm_beside(text, text, text, text, text) IS
    'Does a lane of a way (direct or reverse) of a street run at its near or far kerb, near and far seen by who '
    'drives that way.';

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
    tags constant text := CASE WHEN 'tags' = ANY (present) THEN 'tags::jsonb'
        ELSE format('jsonb_strip_nulls(jsonb_build_object(%s))', (SELECT string_agg(format('%L, %I', tag, name), ', ')
            FROM unnest(streetgen._osm_column_tags()) tag, LATERAL (SELECT replace(tag, ':', '_') AS name) c
            WHERE name = ANY (present))) END;
BEGIN
    EXECUTE format('CREATE TEMPORARY TABLE _import_line ON COMMIT DROP AS
        SELECT *, %s, ROW(class, tags)::text COLLATE "C" AS wording
        FROM (SELECT geom, way_id, class::text, name::text, %s AS ref, %s AS tags FROM %s) l',
        (SELECT string_agg(format('tags ->> %L AS %I', tag, replace(tag, ':', '_')), ', ')
            FROM unnest(streetgen._osm_column_tags()) tag),
        CASE WHEN 'ref' = ANY (present) THEN 'ref::text' ELSE 'NULL::text' END, tags, source);
END $$;
COMMENT ON FUNCTION streetgen._take_osm_lines(regclass) IS
    'Copies the lines of an OSM table to where import_osm reads them, each with its tags and their wording. A table '
    'of an older flex file has a column for each tag in place of tags.';

CREATE OR REPLACE FUNCTION streetgen._osm_rows(driving_side text, lane_width float8)
    RETURNS TABLE(geom geometry, name text, ref text, source_ref text, label text, width float8, roadway_offset float8,
        lane_count integer, direction text, roundabout_tag text, speed float8, level integer, class text,
        lanes_forward integer, lanes_backward integer, lanes_both integer, kind_forward text, kind_backward text,
        lane_width_forward text, lane_width_backward text, turn_forward text, turn_backward text, change_forward text,
        change_backward text, sidewalk_left float8, sidewalk_right float8, unread text[], left_out text)
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
-- A city's ways have few wordings of tags, and each is read once.
WITH meaning AS MATERIALIZED (
SELECT wording, metres AS width,
    coalesce(offset_forward, -offset_backward) AS roadway_offset,
    coalesce(lanes_total, lanes_sum) AS lane_count,
    CASE WHEN tagged AND NOT stated THEN 'both' ELSE direction END AS direction,
    CASE WHEN tagged AND direction <> 'both' THEN junction END AS roundabout_tag,
       kmh AS speed,
       coalesce(CASE WHEN layer ~ '^[-+]?\d{1,2}$' THEN greatest(-50, least(50, layer::integer)) END,
                CASE WHEN coalesce(bridge, 'no') <> 'no' THEN 1 WHEN coalesce(tunnel, 'no') <> 'no' THEN -1
                    ELSE 0 END) AS level,
       class, stated_forward AS lanes_forward, stated_backward AS lanes_backward,
           nullif(centre, 0) AS lanes_both,
       streetgen.lane_kinds(coalesce(stated_forward, usual_forward), buses_forward, bus_forward
           OR streetgen._osm_beside('near', 'direct', direction, bus_near, bus_far), driving_side,
           streetgen._osm_beside('near', 'direct', direction, cycle_near, cycle_far),
               streetgen._osm_beside('far', 'direct', direction, cycle_near, cycle_far),
           streetgen._osm_beside('near', 'direct', direction, parking_near, parking_far),
               streetgen._osm_beside('far', 'direct', direction, parking_near, parking_far)) AS kind_forward,
       streetgen.lane_kinds(coalesce(stated_backward, usual_backward), buses_backward, bus_backward
           OR streetgen._osm_beside('near', 'reverse', direction, bus_far, bus_near), driving_side,
           streetgen._osm_beside('near', 'reverse', direction, cycle_far, cycle_near),
               streetgen._osm_beside('far', 'reverse', direction, cycle_far, cycle_near),
           streetgen._osm_beside('near', 'reverse', direction, parking_far, parking_near),
               streetgen._osm_beside('far', 'reverse', direction, parking_far, parking_near)) AS kind_backward,
       lane_width_forward, lane_width_backward, turn_forward, turn_backward,
       streetgen._osm_list(coalesce(change_lanes_forward, CASE direction WHEN 'direct' THEN change_lanes END), 'change')
           AS change_forward,
       streetgen._osm_list(coalesce(change_lanes_backward, CASE direction WHEN 'reverse' THEN change_lanes END),
           'change') AS change_backward,
       streetgen._osm_sidewalk(walk_left, sidewalk, said_walk_left, 'left') AS sidewalk_left,
       streetgen._osm_sidewalk(walk_right, sidewalk, said_walk_right, 'right') AS sidewalk_right,
       array_remove(ARRAY[CASE WHEN width_unread THEN 'width' END,
                          CASE WHEN lanes IS NOT NULL AND lanes_total IS NULL
                              OR coalesce(lanes_forward, lanes_backward) IS NOT NULL
                              AND coalesce(lanes_total, lanes_sum) IS NULL
                               OR coalesce(lanes_both_ways, lanes_reversible) IS NOT NULL AND centre IS NULL
                                   THEN 'lane_count' END,
                          CASE WHEN speed_unread THEN 'speed' END,
                          CASE WHEN oneway NOT IN ('yes', 'true', '1', '-1', 'reverse', 'no', 'false', '0',
                              'reversible', 'alternating') THEN 'direction' END,
                          CASE WHEN layer !~ '^[-+]?\d{1,2}$' THEN 'level' END,
                          CASE WHEN direction = 'both' AND turn_lanes IS NOT NULL OR said_turn_forward IS NOT NULL
                              AND turn_forward IS NULL OR said_turn_backward IS NOT NULL AND turn_backward IS NULL
                              THEN 'turn' END,
                          CASE WHEN said_width_forward IS NOT NULL AND lane_width_forward IS NULL
                              OR said_width_backward IS NOT NULL AND lane_width_backward IS NULL
                              THEN 'lane_width' END,
                          CASE WHEN said_walk_left IS NOT NULL
                              AND streetgen._within(streetgen._metres(said_walk_left), 0, 50) IS NULL
                              OR said_walk_right IS NOT NULL
                              AND streetgen._within(streetgen._metres(said_walk_right), 0, 50) IS NULL
                              THEN 'sidewalk width' END,
                          CASE WHEN coalesce(placement_forward, placement_backward, placement) NOT IN ('transition')
                              AND coalesce(offset_forward, offset_backward) IS NULL THEN 'placement' END],
                              NULL) AS unread
FROM (SELECT DISTINCT ON (wording) * FROM pg_temp._import_line ORDER BY wording) tagged,
     streetgen._osm_width(tags) across(metres, width_unread), streetgen._osm_speed(tags) pace(kmh, speed_unread),
     LATERAL (SELECT CASE WHEN oneway IN ('yes', 'true', '1') THEN 'direct' WHEN oneway IN ('-1', 'reverse')
         THEN 'reverse' WHEN oneway IN ('no', 'false', '0') THEN 'both'
                          WHEN junction IN ('roundabout', 'circular') OR class IN ('motorway', 'motorway_link')
                              THEN 'direct' ELSE 'both' END AS direction,
         -- A direction that the tag of a roundabout alone implies is left to that tag.
         junction IN ('roundabout', 'circular') AS tagged,
         coalesce(oneway IN ('yes', 'true', '1', '-1', 'reverse', 'no', 'false', '0'), false) AS stated) d,
     LATERAL (SELECT coalesce(sidewalk_left, sidewalk_both) AS walk_left,
         coalesce(sidewalk_right, sidewalk_both) AS walk_right,
         coalesce(sidewalk_left_width, sidewalk_both_width) AS said_walk_left,
         coalesce(sidewalk_right_width, sidewalk_both_width) AS said_walk_right) walk,
     -- Lanes that both directions use, in the middle.
     LATERAL (SELECT CASE WHEN direction = 'both' AND n BETWEEN 0 AND 6 THEN n END AS centre
              FROM (SELECT CASE WHEN lanes_both_ways IS NULL THEN 0 ELSE streetgen._osm_count(lanes_both_ways) END
                         + CASE WHEN lanes_reversible IS NULL THEN 0 ELSE streetgen._osm_count(lanes_reversible)
                             END AS n) m) c,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS lanes_total FROM streetgen._osm_count(lanes) n) b,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS counted_forward
         FROM streetgen._osm_count(lanes_forward) n) f,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS counted_backward
         FROM streetgen._osm_count(lanes_backward) n) w,
     LATERAL (SELECT CASE WHEN n BETWEEN 1 AND 30 THEN n END AS lanes_sum
         FROM (SELECT streetgen._osm_count(lanes_forward) + streetgen._osm_count(lanes_backward) + coalesce(centre,
         0) AS n) m) s,
     -- A tag without a direction speaks of that of a one-way street.
     LATERAL (SELECT coalesce(turn_lanes_forward, CASE direction WHEN 'direct'
         THEN turn_lanes END) AS said_turn_forward, coalesce(turn_lanes_backward, CASE direction WHEN 'reverse'
         THEN turn_lanes END) AS said_turn_backward,
                     coalesce(width_lanes_forward, CASE direction WHEN 'direct'
                         THEN width_lanes END) AS said_width_forward, coalesce(width_lanes_backward, CASE direction
                         WHEN 'reverse' THEN width_lanes END) AS said_width_backward,
                     coalesce(bus_lanes_forward, psv_lanes_forward, CASE direction WHEN 'direct'
                         THEN coalesce(bus_lanes, psv_lanes) END) AS buses_forward,
                     coalesce(bus_lanes_backward, psv_lanes_backward, CASE direction WHEN 'reverse'
                         THEN coalesce(bus_lanes, psv_lanes) END) AS buses_backward,
                     coalesce(lanes_bus_forward, CASE direction WHEN 'direct' THEN coalesce(lanes_bus, lanes_psv) END,
                         '0') ~ '^[1-9]' AS bus_forward,
                     coalesce(lanes_bus_backward, CASE direction WHEN 'reverse'
                         THEN coalesce(lanes_bus, lanes_psv) END, '0') ~ '^[1-9]' AS bus_backward) said,
     LATERAL (SELECT streetgen._osm_list(said_turn_forward, 'turn') AS turn_forward,
         streetgen._osm_list(said_turn_backward, 'turn') AS turn_backward,
                     streetgen._osm_list(said_width_forward, 'width') AS lane_width_forward,
                         streetgen._osm_list(said_width_backward, 'width') AS lane_width_backward) list,
     LATERAL (SELECT coalesce(counted_forward, CASE direction WHEN 'direct' THEN lanes_total WHEN 'both'
         THEN nullif(greatest(lanes_total - coalesce(centre, 0) - counted_backward, 0), 0) END,
                              streetgen._osm_length(turn_forward)) AS stated_forward,
                     coalesce(counted_backward, CASE direction WHEN 'reverse' THEN lanes_total WHEN 'both'
                         THEN nullif(greatest(lanes_total - coalesce(centre, 0) - counted_forward, 0), 0) END,
                              streetgen._osm_length(turn_backward)) AS stated_backward) n,
     LATERAL (SELECT streetgen._osm_kerb(cycleway_near, cycleway_both, cycleway, cycleway_near_oneway, direction, near,
             near) AS cycle_near,
         streetgen._osm_kerb(cycleway_far, cycleway_both, cycleway, cycleway_far_oneway, direction, far,
             near) AS cycle_far,
         streetgen._osm_kerb(busway_near, busway_both, busway, NULL, direction, near, near) AS bus_near,
         streetgen._osm_kerb(busway_far, busway_both, busway, NULL, direction, far, near) AS bus_far,
         CASE WHEN coalesce(parked_near, parking_both) = 'lane'
             OR coalesce(parking_lane_near, parking_lane_both) IN ('parallel', 'diagonal', 'perpendicular', 'marked')
             THEN 'lane' END AS parking_near,
         CASE WHEN coalesce(parked_far, parking_both) = 'lane'
             OR coalesce(parking_lane_far, parking_lane_both) IN ('parallel', 'diagonal', 'perpendicular', 'marked')
             THEN 'lane' END AS parking_far
         FROM (SELECT 'right' AS near, 'left' AS far, cycleway_right AS cycleway_near, cycleway_left AS cycleway_far,
                 cycleway_right_oneway AS cycleway_near_oneway, cycleway_left_oneway AS cycleway_far_oneway,
                 busway_right AS busway_near, busway_left AS busway_far, parking_right AS parked_near,
                 parking_left AS parked_far, parking_lane_right AS parking_lane_near,
                 parking_lane_left AS parking_lane_far WHERE driving_side = 'right'
             UNION ALL SELECT 'left', 'right', cycleway_left, cycleway_right, cycleway_left_oneway,
                 cycleway_right_oneway, busway_left, busway_right, parking_left, parking_right, parking_lane_left,
                 parking_lane_right WHERE driving_side = 'left') side) kerb,
     -- One lane in all, unless buses have one of their own, is of both directions.
     LATERAL (SELECT CASE WHEN direction <> 'both' OR bus_forward OR bus_backward
         OR coalesce(bus_near, bus_far) IS NOT NULL THEN 1 ELSE 0 END AS fewest,
                     lanes_total - coalesce(centre, 0) AS of_one) o,
     LATERAL (SELECT CASE direction WHEN 'both' THEN CASE WHEN of_one <= 1 THEN fewest
         ELSE coalesce((of_one + 1) / 2, 1) END WHEN 'direct' THEN 1 ELSE 0 END AS usual_forward,
                     CASE direction WHEN 'both' THEN CASE WHEN of_one <= 1 THEN fewest ELSE coalesce(of_one / 2, 1)
                         END WHEN 'reverse' THEN 1 ELSE 0 END AS usual_backward) u,
     -- Where the line lies among the lanes; lanes of the other direction lie beyond the side where one drives.
     LATERAL (SELECT coalesce(stated_forward, usual_forward) AS ahead, coalesce(stated_backward,
         usual_backward) AS back,
         coalesce(centre, 0) AS shared) k,
     LATERAL (SELECT coalesce(metres / nullif(ahead + back + shared, 0),
         lane_width) AS lane_each) i,
     LATERAL (SELECT streetgen._osm_roadway_offset(coalesce(placement_forward, CASE direction WHEN 'direct'
             THEN placement END), CASE driving_side WHEN 'right' THEN back + shared ELSE 0 END, ahead,
                 ahead + back + shared,
             lane_each) AS offset_forward,
         streetgen._osm_roadway_offset(coalesce(placement_backward, CASE direction WHEN 'reverse'
             THEN placement END), CASE driving_side WHEN 'right' THEN ahead + shared ELSE 0 END, back,
                 ahead + back + shared,
             lane_each) AS offset_backward) placed)
SELECT geom, name, ref, way_id::text, way_id::text, meaning.width, meaning.roadway_offset, meaning.lane_count,
    meaning.direction, meaning.roundabout_tag, meaning.speed, meaning.level, meaning.class, meaning.lanes_forward,
    meaning.lanes_backward, meaning.lanes_both, meaning.kind_forward, meaning.kind_backward,
    meaning.lane_width_forward, meaning.lane_width_backward, meaning.turn_forward, meaning.turn_backward,
    meaning.change_forward, meaning.change_backward, meaning.sidewalk_left, meaning.sidewalk_right, meaning.unread,
    NULL
FROM pg_temp._import_line JOIN meaning USING (wording)
$$;
COMMENT ON FUNCTION streetgen._osm_rows(text, float8) IS
    'The rows of the import that the lines of an OSM table become, where one drives on a side, left or right, and '
    'lanes of unknown width have this one, metres.';

CREATE OR REPLACE FUNCTION streetgen.import_osm(model name, prefix text DEFAULT 'osm',
    schemas name[] DEFAULT current_schemas(true))
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    source regclass := streetgen._osm_table('_line', prefix, schemas);
    driving_side text;
    lane_width float8;
BEGIN
    PERFORM streetgen._take_classes(model), streetgen._check_given('prefix', prefix, 'schemas', schemas::text);
    IF source IS NULL THEN
        RAISE EXCEPTION 'there is no table %', quote_ident(prefix || '_line') USING ERRCODE = '42P01',
            HINT = 'osm2pgsql -O flex -S data/osm2pgsql_flex.lua makes it; a schema that is not in search_path '
                'stands before the prefix: ''gis.osm''.';
    END IF;
    driving_side := streetgen._driving_side(model);
    lane_width := streetgen._setting_number(model, 'lane_width');
    PERFORM streetgen._take_osm_lines(source);
    RETURN QUERY SELECT * FROM streetgen._import(model, source::text,
        format('SELECT * FROM streetgen._osm_rows(%L, %L)', driving_side, lane_width));
    IF streetgen._driving_side(model) <> driving_side THEN
        -- The tags of kerbs mean other lanes where one drives on the other side.
        PERFORM streetgen._take_classes(model);
        PERFORM FROM streetgen._import(model, source::text,
            format('SELECT * FROM streetgen._osm_rows(%L, %L)', streetgen._driving_side(model), lane_width));
    END IF;
    DROP TABLE pg_temp._import_line;
    RETURN QUERY SELECT * FROM streetgen._import_restrictions(model, source,
        streetgen._osm_table('_restriction', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_osm_controls(model, streetgen._osm_table('_control', prefix, schemas));
    RETURN QUERY SELECT * FROM streetgen._import_routes(model, source, streetgen._osm_table('_route', prefix, schemas));
END $$;
COMMENT ON FUNCTION streetgen.import_osm(name, text, name[]) IS
    'Imports the table PREFIX_line that osm2pgsql writes with data/osm2pgsql_flex.lua, found in the schemas of '
    'search_path or named with its schema (gis.osm): lanes (lanes:both_ways and lanes:reversible: in the middle, for '
    'both directions), width, oneway (also -1), roundabouts, layer, bridge, tunnel, maxspeed (also mph), name, ref, '
    'class; turn:lanes, width:lanes, bus lanes, cycle and parking lanes on the roadway, of each direction; sidewalk '
    'and sidewalk:left, :right and :both with their :width; and the turn '
    'restrictions of PREFIX_restriction, the signals, signs and crossings of PREFIX_control and the routes of '
    'PREFIX_route. A tag that means '
    'nothing (width abc, or over 200 m) is unknown, and reported '
    'by way.';
