-- Edits by hand of every column, and what a delivery may do with them: an oracle of plain comparisons.

-- The axes of a model with all that a source may fill.
CREATE FUNCTION test.axes(model name) RETURNS TABLE (axis_id bigint, ref text, by_hand boolean, said jsonb) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE format('SELECT axis_id, source_ref, width_by_hand, (to_jsonb(a) - ''{axis_id,source,source_ref,source_geom,source_hash,width_by_hand,source_width,source_width_end,geom}''::text[])
    || jsonb_build_object(''geom'', geom::text) FROM %I.axis a', model);
END $$;

-- Random edits by hand: of one column, a moved vertex, a split as QGIS does it, a deletion.
CREATE FUNCTION test.edit_by_hand(model name, edits integer) RETURNS void LANGUAGE plpgsql AS $$
DECLARE
  columns constant text[] := ARRAY['width', 'width_end', 'roadway_offset', 'lane_count', 'direction', 'speed', 'importance', 'name', 'level', 'kind', 'radius', 'lanes_forward', 'lanes_backward', 'lanes_both',
    'kind_forward', 'kind_backward', 'lane_width_forward', 'lane_width_backward', 'turn_forward', 'turn_backward', 'change_forward', 'change_backward', 'sidewalk_left', 'sidewalk_right', 'flow', 'roundabout_tag', 'access', 'ref', 'parking_left', 'parking_right', 'lane_markings', 'sidewalk_apart', 'paved', 'sidewalk_paved_left', 'sidewalk_paved_right', 'cycle_paved_left', 'cycle_paved_right', 'strips_left', 'strips_right', 'height_limit', 'geom'];
  axis record;
  name text;
  value text;
BEGIN
  FOR nth IN 1 .. edits LOOP
    EXECUTE format('SELECT axis_id, source_ref, geom FROM %I.axis ORDER BY axis_id OFFSET (SELECT floor(random() * count(*)) FROM %1$I.axis) LIMIT 1', model) INTO axis;
    IF nth % 15 = 1 AND axis.source_ref !~ '_' THEN
      EXECUTE format('INSERT INTO %1$I.axis (geom, source, source_ref, source_geom, source_hash, %2$s) SELECT ST_LineSubstring(geom, 0.4, 1), source, source_ref || ''_1'', source_geom, source_hash, %2$s
        FROM %1$I.axis WHERE axis_id = $1 ON CONFLICT DO NOTHING', model, array_to_string(array_remove(columns, 'geom'), ', ')) USING axis.axis_id;
      EXECUTE format('UPDATE %I.axis SET geom = ST_LineSubstring(geom, 0, 0.4) WHERE axis_id = $1', model) USING axis.axis_id;
    ELSIF nth % 15 = 2 THEN
      EXECUTE format('DELETE FROM %I.axis WHERE axis_id = $1', model) USING axis.axis_id;
    ELSE
      -- Each column comes in its turn.
      name := columns[1 + nth % cardinality(columns)];
      value := CASE WHEN random() < 0.1 AND name NOT IN ('width', 'width_end', 'direction', 'level', 'geom') THEN NULL
        WHEN name IN ('lane_count', 'lanes_forward', 'lanes_backward', 'importance') THEN (1 + floor(4 * random()))::text
        WHEN name IN ('level', 'lanes_both') THEN floor(2 * random())::text
        WHEN name = 'direction' THEN (ARRAY['both', 'direct', 'reverse'])[1 + floor(3 * random())::integer]
        WHEN name = 'geom' THEN ST_SetPoint(axis.geom, ST_NPoints(axis.geom) / 2, ST_Translate(ST_PointN(axis.geom, ST_NPoints(axis.geom) / 2 + 1), 1 + random(), 2))::text
        WHEN name = 'name' THEN 'by hand ' || nth WHEN name = 'kind' THEN 'secondary' WHEN name = 'roundabout_tag' THEN 'circular' WHEN name = 'ref' THEN 'D ' || nth WHEN name = 'access' THEN 'bus' WHEN name = 'lane_markings' THEN (ARRAY['no', 'yes'])[1 + floor(2 * random())::integer] WHEN name = 'sidewalk_apart' THEN (ARRAY['left', 'right', 'both'])[1 + floor(3 * random())::integer] WHEN name LIKE 'strips%' THEN (ARRAY['verge', 'cycle_track 2.2'])[1 + floor(2 * random())::integer] WHEN name ~ 'paved' THEN (ARRAY['sett', 'asphalt'])[1 + floor(2 * random())::integer] WHEN name LIKE 'parking%' THEN (ARRAY['no', 'on_kerb', 'street_side|diagonal'])[1 + floor(3 * random())::integer]
        WHEN name LIKE 'kind%' THEN 'general|bus' WHEN name LIKE 'turn%' THEN 'left|through' WHEN name LIKE 'change%' THEN 'yes|no'
        WHEN name LIKE 'lane_width%' THEN '3.25|3' ELSE round((2 + 5 * random())::numeric, 2)::text END;
      EXECUTE format('UPDATE %I.axis SET %I = %L WHERE axis_id = $1', model, name, value) USING axis.axis_id;
    END IF;
  END LOOP;
END $$;

-- What must be after a delivery: before it (was), by hand (hand), as the source has it now (will), each as test.axes. The line of a row that was cut by hand stays whoever wins,
-- and such a row does not come back beside its pieces: these conflicts are kept.
CREATE FUNCTION test.expected(was regclass, hand regclass, will regclass, wins text) RETURNS TABLE (axis_id bigint, ref text, said jsonb, conflicts text[], kept text[]) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE format($q$
  WITH was AS (TABLE %1$s), hand AS (TABLE %2$s), will AS (TABLE %3$s),
  -- Each row by hand with the row of the source that it came from, itself or cut off it.
  row AS (SELECT h.*, w.ref AS of, w.said AS old, n.said AS new, count(*) OVER (PARTITION BY w.ref) > 1 OR h.ref <> w.ref AS cut FROM hand h LEFT JOIN was w ON w.ref = regexp_replace(h.ref, '_1$', '') LEFT JOIN will n ON n.ref = w.ref),
  edited AS (SELECT of, bool_or(said <> old OR by_hand) AS edited FROM row GROUP BY of),
  merged AS (SELECT r.*, array_agg(k ORDER BY k) FILTER (WHERE clash) AS clashes, array_agg(k) FILTER (WHERE clash AND cut AND k = 'geom') AS kept,
    jsonb_object_agg(k, CASE WHEN old -> k = new -> k OR clash AND ($1 = 'hand' OR cut AND k = 'geom') THEN r.said -> k ELSE new -> k END) AS result
    FROM row r, jsonb_object_keys(r.said) k, LATERAL (SELECT old -> k <> new -> k AND r.said -> k <> new -> k AND (r.said -> k <> old -> k OR k IN ('width', 'width_end') AND r.by_hand) AS clash) c
    WHERE new IS NOT NULL GROUP BY r.axis_id, r.ref, r.by_hand, r.said, r.of, r.old, r.new, r.cut)
  SELECT axis_id, ref, result, coalesce(clashes, '{}'), coalesce(kept, '{}') FROM merged
  -- Rows that the source deleted: what was edited stays, or is told.
  UNION ALL SELECT r.axis_id, r.ref, CASE $1 WHEN 'hand' THEN r.said END, '{*}', '{}' FROM row r JOIN edited e USING (of) WHERE new IS NULL AND e.edited
  -- Rows that were deleted by hand come back where the source changed them and wins.
  UNION ALL SELECT w.axis_id, w.ref, CASE WHEN $1 = 'source' AND NOT cut THEN n.said END, '{*}', CASE WHEN cut THEN '{*}' ELSE '{}' END::text[] FROM was w JOIN will n USING (ref),
    LATERAL (SELECT EXISTS (SELECT FROM hand h WHERE h.ref = w.ref || '_1') AS cut) c WHERE n.said <> w.said AND NOT EXISTS (SELECT FROM hand h WHERE h.ref = w.ref)
  UNION ALL SELECT NULL, n.ref, n.said, '{}', '{}' FROM will n WHERE NOT EXISTS (SELECT FROM was w WHERE w.ref = n.ref)
  $q$, was, hand, will) USING wins;
END $$;

-- Where a model is not so: rows, values and conflicts.
CREATE FUNCTION test.amiss(model name, expected regclass) RETURNS SETOF text LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE format($q$
  SELECT concat_ws(' ', 'row', coalesce(a.ref, e.ref), a.axis_id, e.axis_id, (SELECT string_agg(concat_ws(' ', k, a.said ->> k, 'instead of', e.said ->> k), ', ') FROM jsonb_object_keys(e.said) k WHERE a.said -> k IS DISTINCT FROM e.said -> k))
  FROM test.axes(%1$L) a FULL JOIN (SELECT * FROM %2$s WHERE said IS NOT NULL) e ON a.ref = e.ref AND (e.axis_id IS NULL OR e.axis_id = a.axis_id)
  WHERE a.said IS DISTINCT FROM e.said
  UNION ALL SELECT concat_ws(' ', 'conflict', coalesce(c.axis_id, e.axis_id), c.column_name, 'instead of', e.column_name)
  FROM %1$I.import_conflict c FULL JOIN (SELECT axis_id, unnest(conflicts) AS column_name FROM %2$s) e USING (axis_id, column_name) WHERE c.axis_id IS NULL OR e.axis_id IS NULL
  $q$, model, expected);
END $$;
