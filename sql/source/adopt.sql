-- Axes of which it was not kept what their source said: those of older builds, and those that somebody put there.

CREATE OR REPLACE FUNCTION streetgen._source_hash(alias text, relation text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    -- What came later is the seed of the hash, so that it stays the same where a source says nothing of it.
    AS $$ SELECT format(
        'hash_record_extended(ROW(%2$s, %3$s, %1$s.lane_count, coalesce(%1$s.direction, ''both''), %1$s.speed,
            %1$s.importance, %1$s.name, coalesce(%1$s.level, 0), %4$s, %1$s.radius, %1$s.lanes_forward,
            %1$s.lanes_backward, %1$s.kind_forward, %1$s.kind_backward, %1$s.lane_width_forward,
            %1$s.lane_width_backward, %1$s.turn_forward, %1$s.turn_backward),
            coalesce(%1$s.lanes_both, 0) + coalesce(hashtextextended(%1$s.roundabout_tag, 1), 0)
            # CASE WHEN coalesce(%1$s.sidewalk_left, %1$s.sidewalk_right) IS NULL THEN 0
                ELSE hash_record_extended(ROW(%1$s.sidewalk_left, %1$s.sidewalk_right), 0) END
            # CASE WHEN %1$s.flow IS NULL THEN 0 ELSE hashfloat8extended(%1$s.flow, 1) END
            # CASE WHEN coalesce(%1$s.roadway_offset, 0) = 0 THEN 0
                ELSE hashfloat8extended(%1$s.roadway_offset, 2) END
            # CASE WHEN coalesce(%1$s.change_forward, %1$s.change_backward) IS NULL THEN 0
                ELSE hash_record_extended(ROW(%1$s.change_forward, %1$s.change_backward), 3) END)', alias,
        CASE relation WHEN 'axis' THEN format('CASE WHEN %1$s.width_by_hand THEN %1$s.source_width ELSE %1$s.width END',
            alias) ELSE alias || '.width' END,
        CASE relation WHEN 'axis' THEN format('CASE WHEN %1$s.width_by_hand THEN %1$s.source_width_end ELSE '
            '%1$s.width_end END', alias) ELSE alias || '.width_end' END,
        alias || CASE relation WHEN 'axis' THEN '.kind' ELSE '.class' END) $$;
COMMENT ON FUNCTION streetgen._source_hash(text, text) IS
    'SQL of the hash of the values of a row of axis, or of _import: column source_hash of an axis as it was delivered.';

CREATE OR REPLACE FUNCTION streetgen._adopt_axes(model name, source text, clean boolean, among text[] DEFAULT NULL)
    RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    adopted bigint;
BEGIN
    EXECUTE format($sql$
WITH unknown AS MATERIALIZED (
    SELECT a.*, %2$s AS hash FROM %1$I.axis a WHERE a.source = $1 AND a.source_ref IS NOT NULL %4$s
        AND NOT EXISTS (SELECT FROM %1$I.delivered d WHERE (d.relation, d.source, d.source_ref)
            = ('axis', $1, a.source_ref))),
-- A piece that was cut off by hand goes with the axis that it was cut off.
piece AS (
    SELECT a.axis_id FROM unknown a JOIN %1$I.delivered w ON w.relation = 'axis' AND w.source = $1
        AND w.source_geom::bytea = a.source_geom::bytea AND streetgen._is_piece(a.source_ref, w.source_ref)
    UNION ALL SELECT a.axis_id FROM unknown a JOIN unknown w ON w.source_geom::bytea = a.source_geom::bytea
        AND streetgen._is_piece(a.source_ref, w.source_ref)),
whole AS (SELECT a.*, p.said, p.hash AS hash_now FROM unknown a LEFT JOIN pg_temp._import_said p USING (source_ref)
    WHERE p.source_ref IS NOT NULL OR a.axis_id NOT IN (SELECT axis_id FROM piece)),
setting AS (SELECT jsonb_object_agg(name, value) AS v FROM %1$I.setting),
cleaned AS (
    SELECT unnest(ids) AS axis_id, unnest(streetgen._clean_network(lines, '{}', (v ->> 'tolerance')::float8,
        (v ->> 'clean_epsilon')::float8, (v ->> 'clean_r_min')::float8))::geometry AS cleaned
    FROM (SELECT array_agg(axis_id) AS ids, array_agg(source_geom::bytea) AS lines FROM whole
        WHERE GeometryType(source_geom) = 'LINESTRING' AND ST_SRID(source_geom) = ST_SRID(geom)
            AND ST_NDims(source_geom) = ST_NDims(geom) AND $3 HAVING count(*) > 0) l, setting)
INSERT INTO %1$I.delivered (relation, source, source_ref, row_id, said, source_geom, cleaned)
SELECT 'axis', $1, a.source_ref, a.axis_id, jsonb_strip_nulls(CASE
        -- Nobody edited it since, or its source says what it said, or what stands there.
        WHEN a.hash = a.source_hash THEN %3$s || CASE WHEN a.width_by_hand THEN jsonb_build_object('width',
            a.source_width, 'width_end', a.source_width_end) ELSE '{}' END
        WHEN a.hash_now = a.source_hash OR jsonb_strip_nulls(%3$s || a.said) = jsonb_strip_nulls(%3$s)
            THEN '{"level": 0, "direction": "both"}' || a.said END), a.source_geom,
    c.cleaned
FROM whole a LEFT JOIN cleaned c USING (axis_id) $sql$, model, streetgen._source_hash('a', 'axis'),
        streetgen._row_json(format('%I.axis', model)::regclass, 'a',
            array_remove(streetgen._delivered_columns('axis'), 'geom')),
        CASE WHEN among IS NOT NULL THEN 'AND a.source_ref = ANY ($2)' END) USING source, among, clean;
    GET DIAGNOSTICS adopted = ROW_COUNT;
    IF adopted > 0 OR (SELECT reltuples < 0 FROM pg_class WHERE oid = format('%I.delivered', model)::regclass) THEN
        EXECUTE format('ANALYZE %I.delivered (relation, source, source_ref)', model);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._adopt_axes(name, text, boolean, text[]) IS
    'Finds what a source said last of axes of which it was not kept, all of it or some source_refs: by source_hash '
    'and by cleaning source_geom again where it was cleaned. Where that does not tell, it stays unknown.';
