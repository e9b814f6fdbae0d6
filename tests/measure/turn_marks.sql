-- Whether turn marks of lanes hold at the junction ahead, from what the source states and from where arms lie: psql -v model=NAME -f tests/measure/turn_marks.sql
-- Nothing of it is read from the marks that lanes got, or from the angles of interconnections. A word of a lane is followed along the movements of that lane,
-- over nodes of two edges and over nodes no arm of which answers it. Where an arm answers, the lane must lead into an arm of the word's sector.
-- Prints model, words of lanes, those that are served, unserved, that the source replaces farther on, that no arm answers,
-- that end with the network, and ways whose list fits no lanes, and those of them that the report of the import names. With -v named=1 it prints each word that is not served.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
\if :{?named} \else \set named 0 \endif
-- Degrees to the left: an arm between clear_from and clear_to surely answers, one between least and most may. The sectors of words overlap, as their use does.
CREATE TEMPORARY TABLE sector (word text, clear_from float8, clear_to float8, least float8, most float8);
INSERT INTO sector VALUES ('sharp_left', 110, 170, 75, 180), ('left', 50, 130, 15, 165), ('slight_left', 15, 60, 2, 90), ('through', -25, 25, -55, 55),
    ('slight_right', -60, -15, -90, -2), ('right', -130, -50, -165, -15), ('sharp_right', -170, -110, -180, -75);
CREATE TEMPORARY TABLE degree AS SELECT node_id, count(*) AS degree
    FROM (SELECT from_node AS node_id FROM :"model".edge UNION ALL SELECT to_node FROM :"model".edge) e GROUP BY node_id;
-- Lanes as traffic drives on them; where they come from and go to, and how they lie there: over the 15 metres next to the node.
CREATE TEMPORARY TABLE driven AS
    SELECT l.lane_id, v.along, l.edge_id, e.axis_id, CASE WHEN v.along THEN e.to_node ELSE e.from_node END AS goes_to,
        degrees(ST_Azimuth(ST_LineInterpolatePoint(d.geom, greatest(0, 1 - 15 / d.long)), ST_EndPoint(d.geom))) AS heads,
        degrees(ST_Azimuth(ST_StartPoint(d.geom), ST_LineInterpolatePoint(d.geom, least(1, 15 / d.long)))) AS leaves,
        row_number() OVER (PARTITION BY l.edge_id, v.along ORDER BY CASE WHEN v.along THEN l.lane_position ELSE -l.lane_position END) AS number,
        count(*) OVER (PARTITION BY l.edge_id, v.along) AS lanes
    FROM :"model".lane l JOIN :"model".edge e USING (edge_id) CROSS JOIN (VALUES (true), (false)) v(along)
        CROSS JOIN LATERAL (SELECT g AS geom, greatest(ST_Length(g), 0.1) AS long FROM (SELECT CASE WHEN v.along THEN e.geom ELSE ST_Reverse(e.geom) END AS g) t) d
    WHERE l.along_axis = v.along AND NOT l.both_ways AND l.kind IN ('general', 'bus', 'carpool');
CREATE INDEX ON driven (lane_id, along);
CREATE TEMPORARY TABLE path AS
    SELECT i.lane_in, i.along_in, i.lane_out, i.along_out, i.node_id, i.plausible, i.reason IN ('restriction', 'u_turn', 'ring', 'not_drivable') AS barred,
        (a.heads - b.leaves + 540)::numeric % 360 - 180 AS angle
    FROM :"model".interconnection i JOIN driven a ON (a.lane_id, a.along) = (i.lane_in, i.along_in) JOIN driven b ON (b.lane_id, b.along) = (i.lane_out, i.along_out)
    WHERE a.edge_id <> b.edge_id;
CREATE INDEX ON path (lane_in, along_in);
ANALYZE driven; ANALYZE path; ANALYZE degree; ANALYZE sector;
CREATE TEMPORARY TABLE listed AS
    SELECT a.axis_id, a.source_ref, d.along, string_to_array(CASE WHEN d.along THEN a.turn_forward ELSE a.turn_backward END, '|') AS list, max(d.lanes) AS lanes,
        EXISTS (SELECT FROM :"model".unread_tag u WHERE u.source_ref = a.source_ref AND u.tag ~ '^turn:lanes') AS named
    FROM :"model".axis a JOIN driven d USING (axis_id) WHERE CASE WHEN d.along THEN a.turn_forward ELSE a.turn_backward END IS NOT NULL
    GROUP BY a.axis_id, a.source_ref, d.along, a.turn_forward, a.turn_backward;
-- The words of each lane on which its own source states them, on the last edge of its way.
CREATE TEMPORARY TABLE word AS
    SELECT d.lane_id, d.along, d.axis_id, d.edge_id, t.source_ref, w.word FROM listed t JOIN driven d USING (axis_id, along)
        CROSS JOIN LATERAL unnest(string_to_array(t.list[d.number], ';')) w(word)
    WHERE cardinality(t.list) = d.lanes AND w.word IN (SELECT word FROM sector)
        AND NOT EXISTS (SELECT FROM driven n WHERE (n.axis_id, n.along) = (d.axis_id, d.along) AND n.edge_id <> d.edge_id
            AND EXISTS (SELECT FROM path p WHERE (p.lane_in, p.along_in, p.lane_out, p.along_out) = (d.lane_id, d.along, n.lane_id, n.along) AND p.plausible));
CREATE TEMPORARY TABLE walk AS
    WITH RECURSIVE on_way AS (
        SELECT w.lane_id AS start, w.along AS start_along, w.word, w.lane_id, w.along FROM word w
        UNION
        SELECT o.start, o.start_along, o.word, p.lane_out, p.along_out
        FROM on_way o JOIN sector s USING (word) JOIN driven d ON (d.lane_id, d.along) = (o.lane_id, o.along) JOIN degree g ON g.node_id = d.goes_to
            JOIN path p ON (p.lane_in, p.along_in) = (o.lane_id, o.along) AND p.plausible
        WHERE (g.degree = 2 OR p.angle BETWEEN -55 AND 55 AND NOT EXISTS (SELECT FROM path q
            WHERE (q.lane_in, q.along_in) = (o.lane_id, o.along) AND NOT q.barred AND (q.angle BETWEEN s.clear_from AND s.clear_to
                OR q.plausible AND q.angle BETWEEN s.least AND s.most))))
    SELECT o.*, d.edge_id, d.goes_to, g.degree, CASE WHEN NOT EXISTS (SELECT FROM path q WHERE (q.lane_in, q.along_in) = (o.lane_id, o.along)) THEN 'end'
        WHEN g.degree = 2 THEN 'on'
        WHEN EXISTS (SELECT FROM path q WHERE (q.lane_in, q.along_in) = (o.lane_id, o.along) AND q.plausible AND q.angle BETWEEN s.least AND s.most) THEN 'served'
        WHEN EXISTS (SELECT FROM path q WHERE (q.lane_in, q.along_in) = (o.lane_id, o.along) AND NOT q.barred AND q.angle BETWEEN s.clear_from AND s.clear_to)
            THEN 'unserved' ELSE 'on' END AS what
    FROM on_way o JOIN sector s USING (word) JOIN driven d ON (d.lane_id, d.along) = (o.lane_id, o.along) JOIN degree g ON g.node_id = d.goes_to;
-- The best of what a word meets on the ways of its lane.
CREATE TEMPORARY TABLE fate AS
    SELECT DISTINCT ON (w.lane_id, w.along, w.word) w.*, k.edge_id AS at_edge, k.goes_to, k.lane_id AS at_lane, k.along AS at_along, k.what
    FROM word w JOIN walk k ON (k.start, k.start_along, k.word) = (w.lane_id, w.along, w.word)
    ORDER BY w.lane_id, w.along, w.word, array_position('{served,unserved,end,on}', k.what), k.degree DESC, k.goes_to;
UPDATE fate f SET what = 'replaced' WHERE what = 'on' AND EXISTS (SELECT FROM walk k JOIN driven d USING (lane_id, along) JOIN listed t ON (t.axis_id, t.along) = (d.axis_id, d.along)
    WHERE (k.start, k.start_along, k.word) = (f.lane_id, f.along, f.word) AND d.axis_id <> f.axis_id AND f.word <> ALL (string_to_array(coalesce(t.list[d.number], ''), ';')));
SELECT :'model', count(*), count(*) FILTER (WHERE what = 'served'), count(*) FILTER (WHERE what = 'unserved'), count(*) FILTER (WHERE what = 'replaced'), count(*) FILTER (WHERE what = 'on'), count(*) FILTER (WHERE what = 'end'), (SELECT count(*) FROM listed WHERE cardinality(list) <> lanes),
    (SELECT count(*) FROM listed WHERE cardinality(list) <> lanes AND named) FROM fate;
\if :named
SELECT f.what, f.word, f.source_ref, f.lane_id, f.at_lane, f.goes_to, (SELECT array_to_string(list, '|') FROM listed t WHERE (t.axis_id, t.along) = (f.axis_id, f.along)) AS list,
    (SELECT string_agg(DISTINCT round(q.angle) || CASE WHEN q.plausible THEN '+' WHEN q.barred THEN '-' ELSE '' END, ' ') FROM path q
        WHERE (q.lane_in, q.along_in) = (f.at_lane, f.at_along)) FROM fate f WHERE what <> 'served' ORDER BY what, source_ref, word;
\endif
