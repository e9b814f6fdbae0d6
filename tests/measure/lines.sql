-- Where lines, arrows and signal heads lie beside crossings and before kerbs, by surfaces alone: psql -v model=MODEL -f tests/measure/lines.sql
-- Needs object. A crossing of an arm lies on the last 15 m of its lane, and nearer to this end of it than to the other.
SET search_path = :"model", public;
SET client_min_messages = warning;
CREATE TEMP TABLE painted AS
    SELECT m.*, w.way, ST_Length(w.way) AS size, e.axis_id, e.level, EXISTS (SELECT FROM edge r JOIN axis a USING (axis_id)
        WHERE m.node_id IN (r.from_node, r.to_node) AND a.roundabout_tag IN ('roundabout', 'circular')) AS at_ring
    FROM marking m JOIN edge e USING (edge_id) JOIN lane l USING (edge_id, lane_position),
        LATERAL (SELECT CASE WHEN m.along_axis THEN l.geom ELSE ST_Reverse(l.geom) END AS way) w
    WHERE NOT ST_IsEmpty(m.surface) AND ST_Length(l.geom) > 0.1;
CREATE TEMP TABLE crossed AS
    SELECT p.marking_id, c.street_object_id, ST_LineLocatePoint(p.way, ST_ClosestPoint(x.part, ST_StartPoint(p.way))) * p.size AS near,
        ST_LineLocatePoint(p.way, ST_ClosestPoint(x.part, ST_EndPoint(p.way))) * p.size AS far
    FROM painted p JOIN pedestrian_crossing c ON c.surface && p.way JOIN street_object o USING (street_object_id),
        LATERAL (SELECT ST_Intersection(p.way, c.surface) AS part) x
    WHERE o.axis_id = p.axis_id AND NOT ST_IsEmpty(x.part);
SELECT count(*) FILTER (WHERE kind <> 'arrow') AS lines, count(*) FILTER (WHERE kind <> 'arrow' AND met) AS with_crossing,
    count(*) FILTER (WHERE kind <> 'arrow' AND NOT (at_ring AND kind = 'yield') AND on_it) AS on_crossing,
    count(*) FILTER (WHERE kind <> 'arrow' AND NOT (at_ring AND kind = 'yield') AND beyond AND NOT on_it) AS beyond_crossing,
    count(*) FILTER (WHERE kind = 'arrow') AS arrows, count(*) FILTER (WHERE kind = 'arrow' AND on_it) AS under_stripes
FROM (SELECT p.*, EXISTS (SELECT FROM pedestrian_crossing c WHERE c.surface && p.surface
            AND ST_Area(ST_Intersection(c.surface, p.surface)) > 0.01) AS on_it,
        EXISTS (SELECT FROM crossed c WHERE c.marking_id = p.marking_id AND c.far > p.size - 15 AND c.near > p.size - c.far) AS met,
        EXISTS (SELECT FROM crossed c WHERE c.marking_id = p.marking_id AND c.far > p.size - 15 AND c.near > p.size - c.far
            AND c.near < ST_LineLocatePoint(p.way, ST_LineInterpolatePoint(p.geom, 0.5)) * p.size) AS beyond FROM painted p) q;
SELECT to_regclass('signal_head') IS NOT NULL AS with_signals \gset
\if :with_signals
SELECT count(*) AS heads, count(*) FILTER (WHERE EXISTS (SELECT FROM painted p WHERE p.kind = 'stop' AND p.edge_id = l.edge_id
    AND p.lane_position = l.lane_position AND p.along_axis = h.along_axis AND ST_Distance(h.geom, p.geom) > 0.3)) AS off_their_line
FROM signal_head h JOIN lane l USING (lane_id);
\endif
-- Lines that no crossing moved: how many lie over 6 m from the roadway of the street crossed, as axes and widths give it, and how many of these
-- where no other arm takes ground of the lane within 1 m ahead. A street crossed turns off by 30 to 150 degrees; of forks, all arms ahead count.
CREATE TEMP TABLE arm AS
    SELECT e.edge_id, l.node_id, l.starts, degrees(ST_Azimuth(ST_StartPoint(way), ST_LineInterpolatePoint(way, least(1, 10 / ST_Length(way))))) AS bearing,
        ST_Union(ST_Buffer(way, greatest(0.01, e.width / 2 + l.leftwards * e.roadway_offset), 'endcap=flat side=left'),
            ST_Buffer(way, greatest(0.01, e.width / 2 - l.leftwards * e.roadway_offset), 'endcap=flat side=right')) AS ground
    FROM edge e, LATERAL (VALUES (e.from_node, e.geom, true, 1), (e.to_node, ST_Reverse(e.geom), false, -1)) l(node_id, geom, starts, leftwards),
        LATERAL (SELECT ST_LineSubstring(ST_Force2D(l.geom), 0, least(1, 80 / ST_Length(l.geom))) AS way) w
    WHERE ST_Length(e.geom) > 0.1 AND l.node_id IN (SELECT node_id FROM painted);
CREATE INDEX ON arm (node_id);
WITH waits AS (
    SELECT coalesce(q.crossed, q.ahead) AS metres, q.shared FROM painted p JOIN lane l USING (edge_id, lane_position)
        JOIN arm own ON own.edge_id = p.edge_id AND own.node_id = p.node_id AND own.starts <> p.along_axis,
        LATERAL (SELECT ST_LineInterpolatePoint(p.geom, 0.5) AS middle, ST_Azimuth(ST_StartPoint(p.geom), ST_EndPoint(p.geom))
            + CASE WHEN p.along_axis THEN -pi() / 2 ELSE pi() / 2 END AS heads) h,
        LATERAL (SELECT ST_Buffer(ST_MakeLine(middle, ST_Translate(middle, 1.25 * sin(heads), 1.25 * cos(heads))), l.width / 2, 'endcap=flat') AS front) f,
        LATERAL (SELECT min(ST_Distance(p.geom, o.ground)) FILTER (WHERE turn BETWEEN 30 AND 150) AS crossed,
            min(ST_Distance(p.geom, o.ground)) FILTER (WHERE turn < 150) AS ahead, bool_or(ST_Area(ST_Intersection(o.ground, front)) > 0.01) AS shared
            FROM arm o, LATERAL (SELECT abs((o.bearing - own.bearing + 540)::numeric % 360 - 180) AS turn) t
            WHERE o.node_id = p.node_id AND (o.edge_id, o.starts) <> (own.edge_id, own.starts)) q
    WHERE p.kind <> 'arrow' AND p.free_geom IS NULL)
SELECT count(*) AS lines_without_crossing, count(*) FILTER (WHERE metres > 6) AS over_6_m, count(*) FILTER (WHERE metres > 6 AND NOT shared) AS where_nothing_shares,
    round(percentile_cont(0.5) WITHIN GROUP (ORDER BY metres)::numeric, 2) AS median, (SELECT count(*) FROM painted p WHERE kind <> 'arrow' AND NOT ST_Covers((
        SELECT ST_Buffer(ST_Union(surface), 0.01) FROM roadway r WHERE r.level = p.level AND r.surface && p.surface), p.surface)) AS off_roadway
FROM waits;
DROP TABLE painted, crossed, arm;
