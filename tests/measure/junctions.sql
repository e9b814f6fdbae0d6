-- Junctions of the model of variable model, which computes them: psql -v model=NAME -f tests/measure/junctions.sql prints a row, as tests/measure/junctions does.
SET client_min_messages = error;
CREATE FUNCTION pg_temp.circumradius(a geometry, b geometry, c geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT ST_Distance(a, b) * ST_Distance(b, c) * ST_Distance(c, a) / nullif(4 * ST_Area(ST_MakePolygon(ST_MakeLine(ARRAY[a, b, c, a]))), 0) $$;
CREATE FUNCTION pg_temp.turned(a geometry, b geometry, c geometry, d geometry) RETURNS float8 LANGUAGE sql IMMUTABLE AS $$
    SELECT degrees(acos(greatest(-1, least(1, cos(ST_Azimuth(a, b) - ST_Azimuth(c, d)))))) $$;
CREATE TEMPORARY TABLE across AS
SELECT m.*, CASE WHEN along_in THEN i.geom ELSE ST_Reverse(i.geom) END AS line_in, CASE WHEN along_out THEN o.geom ELSE ST_Reverse(o.geom) END AS line_out
FROM :"model".junction_movement m JOIN :"model".lane i ON i.lane_id = lane_in JOIN :"model".lane o ON o.lane_id = lane_out WHERE m.plausible;
CREATE TEMPORARY TABLE path AS
SELECT a.*, ST_Length(a.geom) AS length, ST_Difference(a.geom, ST_Buffer(j.surface, 0.01, 2)) AS beyond,
    greatest(pg_temp.turned(ST_PointN(line_in, -2), ST_PointN(line_in, -1), ST_PointN(a.geom, 1), ST_PointN(a.geom, 2)),
        pg_temp.turned(ST_PointN(a.geom, -2), ST_PointN(a.geom, -1), ST_PointN(line_out, 1), ST_PointN(line_out, 2))) AS jump,
    (SELECT min(pg_temp.circumradius(ST_LineInterpolatePoint(a.geom, t), ST_LineInterpolatePoint(a.geom, t + 0.25), ST_LineInterpolatePoint(a.geom, t + 0.5)))
        FROM unnest(ARRAY[0, 0.25, 0.5]) t) AS radius
FROM across a JOIN :"model".junction j USING (junction_id);
-- Off the junction a path may lie on ground that other streets hold, on the levels of the streets that meet in it.
CREATE TEMPORARY TABLE off AS
SELECT p.junction_movement_id, ST_Length(p.beyond) AS beyond, CASE WHEN ST_Length(p.beyond) < 0.01 THEN 0 ELSE ST_Length(ST_Difference(p.beyond, ST_Buffer(g.ground, 0.01, 2))) END AS off
FROM path p CROSS JOIN LATERAL (
    SELECT array_agg(DISTINCT e.level) AS levels FROM :"model".junction_node n JOIN :"model".edge e ON n.node_id IN (e.from_node, e.to_node) WHERE n.junction_id = p.junction_id) i CROSS JOIN LATERAL (
    SELECT coalesce(ST_Union(surface), ST_GeomFromText('POLYGON EMPTY', ST_SRID(p.geom))) AS ground FROM (
        SELECT surface FROM :"model".section s WHERE s.level = ANY (i.levels) AND s.surface && p.beyond UNION ALL SELECT surface FROM :"model".intersection o WHERE o.level = ANY (i.levels) AND o.surface && p.beyond
        UNION ALL SELECT surface FROM :"model".junction j WHERE j.junction_id = p.junction_id) s) g;
CREATE TEMPORARY TABLE grouped AS
SELECT junction_id, count(*) AS nodes FROM :"model".junction_node GROUP BY junction_id HAVING count(*) > 1;
SELECT set_config('search_path', quote_ident(:'model') || ', ' || current_setting('search_path'), false) \g /dev/null
-- Kinds with control points and classes of links, and without them.
CREATE FUNCTION pg_temp.kinds() RETURNS TABLE(node_id bigint, kind text) LANGUAGE sql AS $$
    SELECT n.node_id, j.kind FROM junction j JOIN junction_node n USING (junction_id) WHERE j.kind NOT IN ('end', 'continuation') $$;
CREATE TEMPORARY TABLE known AS SELECT * FROM pg_temp.kinds();
CREATE TEMPORARY TABLE beside AS
SELECT count(*) AS places, count(*) FILTER (WHERE abs(back.metres - p.metres) > 1e-6 OR back.lane_id <> p.lane_id) AS lost
FROM (SELECT l.lane_id, ST_Length(l.geom) * g / 7.0 AS metres, v.side FROM (SELECT * FROM lane ORDER BY hashint8(lane_id) LIMIT 100) l, generate_series(0, 7) g, (VALUES ('left'), ('right')) v(side)) p,
    LATERAL streetgen.lane_beside(:'model', p.lane_id, p.metres, p.side) there,
    LATERAL streetgen.lane_beside(:'model', there.lane_id, there.metres, CASE p.side WHEN 'left' THEN 'right' ELSE 'left' END) back;
CREATE TEMPORARY TABLE overlapping AS
SELECT count(*) AS rows FROM lane_adjacency a JOIN lane_adjacency b ON (a.lane_a, a.side) = (b.lane_a, b.side) AND a.lane_adjacency_id < b.lane_adjacency_id
    AND a.start_abscissa < b.end_abscissa - 1e-6 AND b.start_abscissa < a.end_abscissa - 1e-6;
CREATE TEMPORARY TABLE figure AS
SELECT (SELECT count(*) FROM junction) AS junctions, (SELECT count(*) FROM grouped) AS grouped, (SELECT coalesce(max(nodes), 0) FROM grouped) AS most,
    (SELECT count(*) FROM streetgen.check_model(:'model') WHERE rule = 'node of degree three and more without a junction') AS without_one,
    (SELECT count(*) FROM grouped JOIN junction j USING (junction_id) WHERE ST_NumGeometries(j.surface) > 1) AS in_parts,
    (SELECT count(*) FROM control_point) AS points, (SELECT count(*) FROM control_point p WHERE EXISTS (SELECT FROM edge e WHERE e.axis_id = p.axis_id AND p.abscissa BETWEEN e.start_abscissa - 1e-6 AND e.end_abscissa + 1e-6)) AS placed,
    (SELECT count(*) FROM path) AS paths, (SELECT count(*) FILTER (WHERE jump > 1) FROM path) AS jumps, (SELECT 100 * sum(o.off) / nullif(sum(length), 0) FROM path JOIN off o USING (junction_movement_id)) AS off, (SELECT 100 * sum(o.beyond) / nullif(sum(length), 0) FROM path JOIN off o USING (junction_movement_id)) AS beyond,
    (SELECT 100.0 * count(*) FILTER (WHERE radius < 3) / nullif(count(*) FILTER (WHERE abs(angle) > 20), 0) FROM path WHERE abs(angle) > 20) AS tight,
    (SELECT lost || ' of ' || places FROM beside) AS lost, (SELECT rows FROM overlapping) AS overlapping;
-- All that the source says is taken back in the end.
BEGIN;
SET LOCAL streetgen.live = 'off';
DELETE FROM control_point;
UPDATE axis SET kind = NULL WHERE kind LIKE '%\_link';
SET LOCAL streetgen.live = '';
SELECT count(*) FROM streetgen.generate(:'model') \g /dev/null
CREATE TEMPORARY TABLE guessed ON COMMIT DROP AS SELECT * FROM pg_temp.kinds();
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SELECT '| ' || :'model', junctions, grouped, most, without_one, in_parts, placed || ' of ' || points, paths, jumps, round(off::numeric, 3), round(beyond::numeric, 3), round(tight, 1), lost, overlapping,
    (SELECT string_agg(format('%s %s/%s', w.kind, round(100.0 * hits / nullif(guesses, 0)), round(100.0 * hits / nullif(there, 0))), ', ' ORDER BY w.kind) FROM (
        SELECT k.kind, count(*) FILTER (WHERE g.kind = k.kind) AS hits, count(*) AS there, (SELECT count(*) FROM guessed o JOIN known USING (node_id) WHERE o.kind = k.kind) AS guesses
        FROM known k JOIN guessed g USING (node_id) GROUP BY k.kind) w) || ' |'
FROM figure;
ROLLBACK;
