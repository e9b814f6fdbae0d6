-- Where lines, arrows and signal heads lie beside crossings, by surfaces alone: psql -v model=MODEL -f tests/measure/lines.sql
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
DROP TABLE painted, crossed;
