-- Axes of which it was not kept what their source said: those of older builds, and those that somebody put there.

CREATE OR REPLACE FUNCTION streetgen._source_hash(width float8, width_end float8, roadway_offset float8,
    lane_count integer, direction text, speed float8, importance integer, name text, level integer, kind text,
    radius float8, lanes_forward integer, lanes_backward integer, lanes_both integer, kind_forward text,
    kind_backward text, lane_width_forward text, lane_width_backward text, turn_forward text, turn_backward text,
    change_forward text, change_backward text, sidewalk_left float8, sidewalk_right float8, flow float8,
    roundabout_tag text, ref text, access text, parking_left text, parking_right text, lane_markings text,
    sidewalk_apart text, paved text, sidewalk_paved_left text, sidewalk_paved_right text,
    cycle_paved_left text, cycle_paved_right text, strips_left text, strips_right text, height_limit float8)
    RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    -- What came later is the seed of the hash, so that it stays the same where a source says nothing of it.
    RETURN hash_record_extended(ROW(width, width_end, lane_count, coalesce(direction, 'both'), speed, importance, name,
            coalesce(level, 0), kind, radius, lanes_forward, lanes_backward, kind_forward, kind_backward,
            lane_width_forward, lane_width_backward, turn_forward, turn_backward),
        coalesce(lanes_both, 0) + coalesce(hashtextextended(roundabout_tag, 1), 0)
            # CASE WHEN coalesce(sidewalk_left, sidewalk_right) IS NULL THEN 0
                ELSE hash_record_extended(ROW(sidewalk_left, sidewalk_right), 0) END
            # CASE WHEN flow IS NULL THEN 0 ELSE hashfloat8extended(flow, 1) END
            # CASE WHEN coalesce(roadway_offset, 0) = 0 THEN 0 ELSE hashfloat8extended(roadway_offset, 2) END
            # CASE WHEN coalesce(change_forward, change_backward) IS NULL THEN 0
                ELSE hash_record_extended(ROW(change_forward, change_backward), 3) END
            # CASE WHEN ref IS NULL THEN 0 ELSE hashtextextended(ref, 5) END
            # CASE WHEN access IS NULL THEN 0 ELSE hashtextextended(access, 6) END
            # CASE WHEN coalesce(parking_left, parking_right) IS NULL THEN 0
                ELSE hash_record_extended(ROW(parking_left, parking_right), 9) END
            # CASE WHEN lane_markings IS NULL THEN 0 ELSE hashtextextended(lane_markings, 10) END
            # CASE WHEN sidewalk_apart IS NULL THEN 0 ELSE hashtextextended(sidewalk_apart, 11) END
            # CASE WHEN num_nonnulls(paved, sidewalk_paved_left, sidewalk_paved_right, cycle_paved_left,
                    cycle_paved_right) = 0 THEN 0
                ELSE hash_record_extended(ROW(paved, sidewalk_paved_left, sidewalk_paved_right,
                    cycle_paved_left, cycle_paved_right), 12) END
            # CASE WHEN coalesce(strips_left, strips_right) IS NULL THEN 0
                ELSE hash_record_extended(ROW(strips_left, strips_right), 13) END
            # CASE WHEN height_limit IS NULL THEN 0 ELSE hashfloat8extended(height_limit, 14) END
            -- A length of 0 hashes as none.
            # CASE WHEN 0 IN (radius, sidewalk_left, sidewalk_right, roadway_offset, lanes_both)
                THEN hash_record_extended(ROW(radius = 0, sidewalk_left = 0, sidewalk_right = 0, roadway_offset = 0,
                    lanes_both = 0), 7) ELSE 0 END);
COMMENT ON FUNCTION streetgen._source_hash(float8, float8, float8, integer, text, float8, integer, text, integer,
    text, float8, integer, integer, integer, text, text, text, text, text, text, text, text, float8, float8, float8,
    text, text, text, text, text, text, text, text, text, text, text, text, text, text, float8) IS
    'The hash of the values that a source gives an axis, in the order of streetgen._axis_input: column source_hash of '
    'the axis as it was delivered.';

CREATE OR REPLACE FUNCTION streetgen._axis_hash(a anyelement) RETURNS bigint
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._source_hash(
        CASE WHEN a.width_by_hand THEN a.source_width ELSE a.width END,
        CASE WHEN a.width_by_hand THEN a.source_width_end ELSE a.width_end END, a.roadway_offset, a.lane_count,
        a.direction, a.speed, a.importance, a.name, a.level, a.kind, a.radius, a.lanes_forward, a.lanes_backward,
        a.lanes_both, a.kind_forward, a.kind_backward, a.lane_width_forward, a.lane_width_backward, a.turn_forward,
        a.turn_backward, a.change_forward, a.change_backward, a.sidewalk_left, a.sidewalk_right, a.flow,
        a.roundabout_tag, a.ref, a.access, a.parking_left, a.parking_right, a.lane_markings,
        a.sidewalk_apart, a.paved, a.sidewalk_paved_left, a.sidewalk_paved_right, a.cycle_paved_left,
        a.cycle_paved_right, a.strips_left, a.strips_right, a.height_limit) $$;
COMMENT ON FUNCTION streetgen._axis_hash(anyelement) IS
    'The hash of the values of a row of axis: its source_hash where nobody edited it since.';

CREATE OR REPLACE FUNCTION streetgen._axis_values(a anyelement) RETURNS jsonb
    LANGUAGE sql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT to_jsonb((SELECT r FROM (SELECT
        a.width, a.width_end, a.roadway_offset, a.lane_count, a.direction, a.speed, a.importance, a.name, a.level,
        a.kind, a.radius, a.lanes_forward, a.lanes_backward, a.lanes_both, a.kind_forward, a.kind_backward,
        a.lane_width_forward, a.lane_width_backward, a.turn_forward, a.turn_backward, a.change_forward,
        a.change_backward, a.sidewalk_left, a.sidewalk_right, a.flow, a.roundabout_tag, a.ref,
        a.access, a.parking_left, a.parking_right, a.lane_markings, a.sidewalk_apart, a.paved,
        a.sidewalk_paved_left, a.sidewalk_paved_right, a.cycle_paved_left, a.cycle_paved_right, a.strips_left,
        a.strips_right, a.height_limit) r)) $$;
COMMENT ON FUNCTION streetgen._axis_values(anyelement) IS
    'What a row of axis has in the columns that a source may fill besides geom: those of streetgen._axis_input.';

CREATE OR REPLACE FUNCTION streetgen._adopt_axes(model name, source text, clean boolean, among text[] DEFAULT NULL)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    wanted constant text[] COLLATE "default" := among;
    adopted bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    WITH unknown AS MATERIALIZED (
        SELECT a.*, streetgen._axis_hash(a) AS hash, streetgen._axis_values(a) AS there FROM axis a
        WHERE a.source = origin AND a.source_ref IS NOT NULL
            AND (wanted IS NULL OR a.source_ref = ANY (wanted)) AND NOT EXISTS (SELECT FROM delivered d
                WHERE (d.relation, d.source, d.source_ref) = ('axis', a.source, a.source_ref))),
    -- A piece that was cut off by hand goes with the axis that it was cut off.
    piece AS (
        SELECT a.axis_id FROM unknown a JOIN delivered w ON w.relation = 'axis' AND w.source = origin
            AND w.source_geom::bytea = a.source_geom::bytea AND streetgen._is_piece(a.source_ref, w.source_ref)
        UNION ALL SELECT a.axis_id FROM unknown a JOIN unknown w ON w.source_geom::bytea = a.source_geom::bytea
            AND streetgen._is_piece(a.source_ref, w.source_ref)),
    whole AS (
        SELECT a.*, p.said, p.hash AS hash_now FROM unknown a LEFT JOIN pg_temp._import_said p USING (source_ref)
        WHERE p.source_ref IS NOT NULL OR a.axis_id NOT IN (SELECT axis_id FROM piece)),
    cleaning AS (SELECT jsonb_object_agg(name, value) AS v FROM setting),
    cleaned AS (
        SELECT unnest(ids) AS axis_id, unnest(streetgen._clean_network(lines, '{}', (v ->> 'tolerance')::float8,
            (v ->> 'clean_epsilon')::float8, (v ->> 'clean_r_min')::float8))::geometry AS cleaned
        FROM (SELECT array_agg(axis_id) AS ids, array_agg(source_geom::bytea) AS lines FROM whole
            WHERE GeometryType(source_geom) = 'LINESTRING' AND ST_SRID(source_geom) = ST_SRID(geom)
                AND ST_NDims(source_geom) = ST_NDims(geom) AND clean HAVING count(*) > 0) l, cleaning)
    INSERT INTO delivered (relation, source, source_ref, row_id, said, source_geom, cleaned)
    SELECT 'axis', origin, a.source_ref, a.axis_id, jsonb_strip_nulls(CASE
            -- Nobody edited it since, or its source says what it said, or what stands there.
            WHEN a.hash = a.source_hash THEN a.there || CASE WHEN a.width_by_hand THEN jsonb_build_object('width',
                a.source_width, 'width_end', a.source_width_end) ELSE '{}' END
            WHEN a.hash_now = a.source_hash OR jsonb_strip_nulls(a.there || a.said) = jsonb_strip_nulls(a.there)
                THEN '{"level": 0, "direction": "both"}' || a.said END), a.source_geom, c.cleaned
    FROM whole a LEFT JOIN cleaned c USING (axis_id);
    GET DIAGNOSTICS adopted = ROW_COUNT;
    IF adopted > 0 OR (SELECT reltuples < 0 FROM pg_class WHERE oid = format('%I.delivered', model)::regclass) THEN
        ANALYZE delivered (relation, source, source_ref);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._adopt_axes(name, text, boolean, text[]) IS
    'Finds what a source said last of axes of which it was not kept, all of it or some source_refs: by source_hash '
    'and by cleaning source_geom again where it was cleaned. Where that does not tell, it stays unknown.';
