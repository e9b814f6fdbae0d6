-- Ramps of the model of variable model, which computes them: psql -v model=NAME -v places= -f tests/measure/ramps.sql prints what tests/measure/ramps says.
SELECT set_config('search_path', quote_ident(:'model') || ', ' || current_setting('search_path'), false) \g /dev/null
\pset fieldsep ' | '
SELECT :'places' = 't' AS by_place \gset
\if :by_place
SELECT '| ' || :'model', r.kind, a.source_ref, format('%s, %s, %s', lanes_before, lanes_ramp, lanes_after), lanes_missing, lanes_merging, round(r.length), CASE WHEN cut THEN 'yes' ELSE '' END,
    (SELECT count(*) FROM (SELECT edge_id FROM _merging_run(ARRAY[h.axis_id]) m WHERE EXISTS (SELECT FROM lane l WHERE l.edge_id = m.edge_id AND l.kind = 'merging')) m),
    format('%s, %s |', round(ST_X(r.geom)), round(ST_Y(r.geom)))
FROM ramp r JOIN edge e USING (edge_id) JOIN axis a USING (axis_id) JOIN edge h ON h.edge_id = CASE r.kind WHEN 'on' THEN edge_after ELSE edge_before END
WHERE lanes_missing > 0 ORDER BY ST_X(r.geom);
\else
-- From the piece a b to the piece c d, degrees in (-180, 180].
CREATE FUNCTION pg_temp.turned(a geometry, b geometry, c geometry, d geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT degrees(atan2(sin(t), cos(t))) FROM (SELECT ST_Azimuth(c, d) - ST_Azimuth(a, b) AS t) s $$;
-- The turn by which a path misses to begin as its lane ends: the chords of an arc that touches the lane begin with half a turn of theirs.
CREATE FUNCTION pg_temp.jump(lane geometry, path geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT least(abs(t), abs(t - coalesce(n, 0) / 2)) FROM (
        SELECT pg_temp.turned(ST_PointN(lane, -2), ST_PointN(lane, -1), ST_PointN(path, 1), ST_PointN(path, 2)) AS t,
            pg_temp.turned(ST_PointN(path, 1), ST_PointN(path, 2), ST_PointN(path, 2), ST_PointN(path, 3)) AS n) c $$;
CREATE TEMPORARY TABLE path AS
SELECT p.interconnection_id, p.geom, u.speed,
    greatest(pg_temp.jump(line_in, p.geom), pg_temp.jump(ST_Reverse(line_out), ST_Reverse(p.geom))) AS jump
FROM ramp_path p JOIN interconnection c USING (interconnection_id) JOIN ramp r USING (ramp_id) JOIN edge e ON e.edge_id = r.edge_id JOIN axis_used u USING (axis_id)
    JOIN lane i ON i.lane_id = p.lane_in JOIN lane o ON o.lane_id = p.lane_out,
    LATERAL (SELECT CASE WHEN along_in THEN i.geom ELSE ST_Reverse(i.geom) END AS line_in, CASE WHEN along_out THEN o.geom ELSE ST_Reverse(o.geom) END AS line_out) l
-- Traffic that turns back is on no ramp. A lane whose limits crossed has no roadway: there the path across the junction counts.
WHERE abs(c.angle) < 90 AND NOT EXISTS (SELECT FROM section s WHERE s.edge_id IN (i.edge_id, o.edge_id) AND s.method = 'crossed_limits');
-- The least radius that a path has between its chords, against that of the link's speed by a friction of 0.35.
CREATE TEMPORARY TABLE bend AS
SELECT interconnection_id, min((ST_Distance(a, b) + ST_Distance(b, c)) / 2 / nullif(radians(abs(pg_temp.turned(a, b, b, c))), 0)) AS radius
FROM (SELECT interconnection_id, lag(d.geom) OVER w AS a, d.geom AS b, lead(d.geom) OVER w AS c FROM path p, ST_DumpPoints(p.geom) d WINDOW w AS (PARTITION BY interconnection_id ORDER BY d.path)) v
GROUP BY interconnection_id;
-- By the numbers that the source states, whatever turns its lanes are marked for.
CREATE TEMPORARY TABLE stated AS
SELECT CASE r.kind WHEN 'on' THEN b.lane_count + l.lane_count - n.lane_count ELSE n.lane_count + l.lane_count - b.lane_count END AS lacking
FROM ramp r JOIN edge eb ON eb.edge_id = edge_before JOIN axis b ON b.axis_id = eb.axis_id JOIN edge el ON el.edge_id = r.edge_id JOIN axis l ON l.axis_id = el.axis_id
    JOIN edge en ON en.edge_id = edge_after JOIN axis n ON n.axis_id = en.axis_id;
SELECT '| ' || :'model', count(*), (SELECT count(*) FROM stated WHERE lacking > 0), sum(lanes_missing), sum(lanes_merging), count(*) FILTER (WHERE cut), count(*) FILTER (WHERE auxiliary),
    count(*) FILTER (WHERE short_link), (SELECT count(*) FROM path), (SELECT count(*) FROM path WHERE jump > 0.1), (SELECT round(max(jump)::numeric, 3) FROM path),
    (SELECT round(100.0 * count(*) FILTER (WHERE radius IS NULL OR radius >= 0.98 * (speed / 3.6) ^ 2 / (0.35 * 9.81)) / nullif(count(*), 0), 1) FROM path JOIN bend USING (interconnection_id)) || ' |'
FROM ramp r;
\endif
