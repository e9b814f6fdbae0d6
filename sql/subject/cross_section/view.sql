-- The cross-section of each edge, from its lanes, kerbs, sidewalks, bays and crossings, as far as a model has these.

CREATE OR REPLACE FUNCTION streetgen._border_places(borders float8[]) RETURNS SETOF float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$
    SELECT borders[i] FROM generate_series(1, cardinality(borders), 3) i
    -- A border that crosses the axis goes on on its other side.
    UNION ALL SELECT borders[i] + (borders[i + 3] - borders[i]) * borders[i + b] / (borders[i + b] - borders[i + 3 + b])
    FROM generate_series(1, cardinality(borders) - 3, 3) i, (VALUES (1), (2)) border(b)
    WHERE borders[i + b] * borders[i + 3 + b] < 0 $$;
COMMENT ON FUNCTION streetgen._border_places(float8[]) IS
    'Metres along an edge at which borders of its section or of a lane bend, or cross the axis.';

CREATE OR REPLACE FUNCTION streetgen._kerb_extent(method text, kerb geometry, edge geometry, from_limit float8,
    to_limit float8, medians float8[], OUT low float8, OUT high float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN whole THEN greatest(from_limit, (SELECT max(m) FROM unnest(medians) m WHERE m <= (a + b) / 2))
            ELSE greatest(from_limit, least(a, b)) END,
        CASE WHEN whole THEN least(to_limit, (SELECT min(m) FROM unnest(medians) m WHERE m > (a + b) / 2))
            ELSE least(to_limit, greatest(a, b)) END
    FROM (SELECT method NOT IN ('contested', 'level_change') AS whole) m, ST_Length(edge) length, LATERAL (
        SELECT length * ST_LineLocatePoint(edge, ST_StartPoint(kerb)) AS a,
            length * ST_LineLocatePoint(edge, ST_EndPoint(kerb)) AS b) ends $$;
COMMENT ON FUNCTION streetgen._kerb_extent(text, geometry, geometry, float8, float8, float8[]) IS
    'Where the kerb of a section begins and ends, metres along its edge: from limit to limit, but for what other '
    'surfaces take of it, and cut at medians, as columns median_left and median_right of edge say for its side.';

CREATE OR REPLACE FUNCTION streetgen._crossing_mouth(abscissa float8, width float8, angle float8, border float8,
    OUT low float8, OUT high float8)
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT middle - width / 2, middle + width / 2 FROM (SELECT abscissa + border * cotd(angle) AS middle) m $$;
COMMENT ON FUNCTION streetgen._crossing_mouth(float8, float8, float8, float8) IS
    'Where a crossing meets a border that lies so many metres to the left of the axis, metres along it.';

CREATE OR REPLACE FUNCTION streetgen._cross_section_sidewalk(subjects text[], at_end boolean) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN 'sidewalk' <> ALL (subjects) THEN '0'
        WHEN 'footway' <> ALL (subjects) THEN streetgen._fill_template(streetgen._part('cross_section_sidewalk'),
            '{"or_changing": "", "at": "b.middle", "border": "(b.border + b.border_end) / 2", "widest": "w.width"}')
        ELSE streetgen._fill_template(streetgen._part('cross_section_sidewalk'), jsonb_build_object(
            'or_changing', streetgen._part('cross_section_changing'),
            'at', CASE WHEN at_end THEN 's.high - least(0.05, (s.high - s.low) / 10)'
                ELSE 's.low + least(0.05, (s.high - s.low) / 10)' END,
            'border', CASE WHEN at_end THEN 'b.border_end' ELSE 'b.border' END,
            'widest', streetgen._part('cross_section_widest'))) END $$;
COMMENT ON FUNCTION streetgen._cross_section_sidewalk(text[], boolean) IS
    'The expression of view cross_section that tells how wide the sidewalk is where a stretch begins, or where it '
    'ends; of a model without footways the same at both.';

CREATE OR REPLACE FUNCTION streetgen._make_cross_section_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
    with_lanes constant boolean := 'lane' = ANY (subjects);
    with_kerbs constant boolean := 'kerb' = ANY (subjects);
    with_objects constant boolean := 'object' = ANY (subjects);
    with_footways constant boolean := 'footway' = ANY (subjects);
    lanes text := streetgen._part(CASE WHEN 'lane' = ANY (subjects) THEN 'cross_section_lanes'
        ELSE 'cross_section_without_lanes' END);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'rail' = ANY (subjects) THEN
        lanes := streetgen._fill_template(streetgen._part('cross_section_tracks'), jsonb_build_object('lanes', lanes));
    END IF;
    EXECUTE streetgen._fill_template(streetgen._part('cross_section'), jsonb_build_object(
        'places', concat(CASE WHEN with_lanes THEN streetgen._part('cross_section_lane_places') END,
            CASE WHEN 'rail' = ANY (subjects) THEN streetgen._part('cross_section_track_places') END,
            CASE WHEN with_kerbs THEN streetgen._part('cross_section_kerb_places') END,
            CASE WHEN with_kerbs AND with_objects THEN streetgen._part('cross_section_flush_places') END,
            CASE WHEN with_objects THEN streetgen._part('cross_section_bay_places') END,
            CASE WHEN with_footways THEN streetgen._part('cross_section_changing_places') END),
        'lanes', lanes,
        'kerbs', CASE WHEN with_kerbs THEN streetgen._fill_template(streetgen._part('cross_section_kerbs'),
                jsonb_build_object('flush',
                    CASE WHEN with_objects THEN streetgen._part('cross_section_flush') ELSE 'NULL' END,
                    'paved', CASE WHEN with_footways THEN streetgen._part('cross_section_paved')
                        ELSE 'NULL::float8' END,
                    'sidewalk', streetgen._cross_section_sidewalk(subjects, at_end => false),
                    'sidewalk_end', streetgen._cross_section_sidewalk(subjects, at_end => true)))
            ELSE streetgen._part('cross_section_without_kerbs') END,
        'bays', streetgen._part(CASE WHEN with_objects THEN 'cross_section_bays'
            ELSE 'cross_section_without_bays' END)));
    COMMENT ON VIEW cross_section
        IS 'What lies across each street, piece by piece outwards from its axis, between the limits of its sections: '
        'lanes, shoulder, bay, gutter, kerb, furnishing strip or verge, sidewalk, and the ground behind. A row is a '
        'piece of '
        'one side on a stretch along which the same pieces lie side by side';
    COMMENT ON COLUMN cross_section.edge_id IS 'the edge';
    COMMENT ON COLUMN cross_section.axis_id IS 'its axis';
    COMMENT ON COLUMN cross_section.start_abscissa IS 'where the stretch begins, metres along the axis';
    COMMENT ON COLUMN cross_section.end_abscissa IS 'where it ends, metres along the axis';
    COMMENT ON COLUMN cross_section.side IS
        'left or right of the axis, in its direction; a lane on both has a piece on each';
    COMMENT ON COLUMN cross_section."order" IS 'number from 1 at the axis, outwards';
    COMMENT ON COLUMN cross_section.kind IS
        'kind of a lane, as lane.kind; rail: what a track takes of a lane; shoulder: roadway that lanes leave; bay, '
        'gutter, kerb, furnishing, verge '
        '(before a mapped sidewalk that lies farther from the kerb than it is wide, or as axis.strips_left says), '
        'buffer, cycle_track, sidewalk; behind '
        'these outer, median, splitter or island, as kerb.beside, or roadway of another street. roadway alone: '
        'the model computes no lanes';
    COMMENT ON COLUMN cross_section.kerb IS
        'standing; at a crossing as this says, lowered, rolled, or else flush; flush and of no width before a bay '
        'behind it, where another one stands if the bay lies beside the roadway; none, at a border to roadway, of no '
        'width. NULL: it is no kerb';
    COMMENT ON COLUMN cross_section.lane_id IS 'the lane; NULL: it is none';
    COMMENT ON COLUMN cross_section.offset_from IS
        'metres from the axis to where the piece begins, at the start of the stretch';
    COMMENT ON COLUMN cross_section.offset_to IS 'metres to where it ends there; NULL: it goes on';
    COMMENT ON COLUMN cross_section.offset_from_end IS 'metres to where it begins, at the end of the stretch';
    COMMENT ON COLUMN cross_section.offset_to_end IS 'metres to where it ends there; NULL: it goes on';
    COMMENT ON COLUMN cross_section.paved IS
        'what a lane, shoulder, gutter, cycle track, sidewalk or the furnishing strip before it is paved with, as in '
        'view paving; NULL: unknown, or another piece';
END $$;
COMMENT ON FUNCTION streetgen._make_cross_section_views(name) IS
    'Makes the view cross_section of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._cross_section_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 7 SET search_path = pg_catalog
    AS $$ SELECT 'cross_section'::name, subject
        FROM unnest('{lane,rail,kerb,sidewalk,footway,object}'::text[]) subject
    -- The view of cross-sections reads that of pavings.
    UNION ALL VALUES ('paving', 'footway') $$;
COMMENT ON FUNCTION streetgen._cross_section_view() IS
    'The view of cross-sections and the one of pavings that it reads, and the subjects whose tables they read.';
