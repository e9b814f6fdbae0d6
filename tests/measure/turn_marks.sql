-- Whether turn marks of lanes hold at the junction ahead, for one model: psql -v model=NAME -f tests/measure/turn_marks.sql
-- prints model, marks, those that hold, are lost on their way, lead elsewhere although a way answers them, are answered by no way, are replaced by
-- others that the source states before a way answers them, and lanes that lead elsewhere than they are marked although they could. A mark that no way of a junction answers is followed to the next one. With -v named=1 it names
-- those that do not hold.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
\if :{?named} \else \set named 0 \endif
-- Directions that a mark may mean, degrees to the left.
CREATE TEMPORARY TABLE meaning (mark text, least float8, most float8);
INSERT INTO meaning VALUES ('sharp_left', 60, 180), ('left', 15, 165), ('slight_left', -15, 85), ('through', -50, 50), ('slight_right', -85, 15), ('right', -165, -15),
    ('sharp_right', -180, -60);
-- Each edge as traffic drives on it, with what its source marks and what lies on its lanes.
CREATE TEMPORARY TABLE driven AS
    SELECT e.edge_id, e.axis_id, along, CASE WHEN along THEN e.from_node ELSE e.to_node END AS comes_from, CASE WHEN along THEN e.to_node ELSE e.from_node END AS goes_to,
        CASE WHEN along THEN a.turn_forward ELSE a.turn_backward END AS stated, marks
    FROM :"model".edge e JOIN :"model".axis a USING (axis_id) CROSS JOIN (VALUES (true), (false)) v(along)
        JOIN LATERAL (SELECT array_agg(coalesce(turn, '') ORDER BY CASE WHEN along THEN lane_position ELSE -lane_position END) AS marks FROM :"model".lane l
            WHERE l.edge_id = e.edge_id AND l.along_axis = along AND NOT l.both_ways AND l.kind IN ('general', 'bus', 'carpool')) l ON marks IS NOT NULL;
CREATE INDEX ON driven (comes_from);
CREATE TEMPORARY TABLE degree AS SELECT node_id, count(*) AS degree FROM (SELECT from_node AS node_id FROM :"model".edge UNION ALL SELECT to_node FROM :"model".edge) e GROUP BY node_id;
ANALYZE driven; ANALYZE degree;
CREATE TEMPORARY TABLE passing AS
    SELECT i.lane_in, i.along_in, l.edge_id, string_to_array(l.turn, ';') AS marks, i.node_id, i.angle, i.plausible, i.reason, o.edge_id AS edge_out, i.along_out
    FROM :"model".interconnection i JOIN :"model".lane l ON l.lane_id = i.lane_in JOIN :"model".lane o ON o.lane_id = i.lane_out
    WHERE NOT l.both_ways AND l.kind IN ('general', 'bus', 'carpool') AND l.turn IS NOT NULL;
CREATE INDEX ON passing (edge_id, node_id);
-- Marks on their way: from the edge on which a source states them, and they fit its lanes, over nodes of two edges and over nodes at which no way answers them.
CREATE TEMPORARY TABLE walk AS
    SELECT DISTINCT d.edge_id AS stated_on, d.along AS stated_along, 0 AS step, d.edge_id, d.along, d.goes_to, d.marks, m.mark, ''::text AS what
    FROM driven d, LATERAL unnest(string_to_array(stated, '|')) lane, LATERAL unnest(string_to_array(lane, ';')) m(mark)
    WHERE cardinality(string_to_array(stated, '|')) = cardinality(marks) AND m.mark IN (SELECT mark FROM meaning);
CREATE INDEX ON walk (step);
ANALYZE passing; ANALYZE walk;
CREATE FUNCTION pg_temp.go(steps integer) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    FOR k IN 0 .. steps LOOP
        UPDATE walk w SET what = CASE
            WHEN NOT EXISTS (SELECT FROM unnest(marks) l WHERE mark = ANY (string_to_array(l, ';'))) THEN CASE WHEN k = 0 THEN 'no lane' ELSE 'lost' END
            WHEN (SELECT degree FROM degree WHERE node_id = goes_to) < 3 THEN 'on'
            WHEN EXISTS (SELECT FROM passing p WHERE (p.edge_id, p.node_id, p.along_in) = (w.edge_id, w.goes_to, w.along) AND p.plausible AND w.mark = ANY (p.marks) AND p.angle BETWEEN least AND greatest_angle)
                THEN 'holds'
            WHEN EXISTS (SELECT FROM passing p WHERE (p.edge_id, p.node_id, p.along_in) = (w.edge_id, w.goes_to, w.along) AND p.angle BETWEEN least AND greatest_angle
                AND p.reason NOT IN ('restriction', 'u_turn', 'ring')) THEN 'elsewhere' ELSE 'on' END
        FROM (SELECT mark AS meant, least, most AS greatest_angle FROM meaning) m WHERE step = k AND meant = w.mark;
        INSERT INTO walk SELECT DISTINCT w.stated_on, w.stated_along, k + 1, n.edge_id, n.along, n.goes_to, n.marks, w.mark, ''
            FROM walk w JOIN passing p ON (p.edge_id, p.node_id, p.along_in) = (w.edge_id, w.goes_to, w.along) AND p.plausible AND w.mark = ANY (p.marks) AND p.edge_out <> p.edge_id
                JOIN driven n ON (n.edge_id, n.along) = (p.edge_out, p.along_out)
            WHERE w.step = k AND w.what = 'on'
                -- What the source says farther on replaces it.
                AND (n.stated IS NULL OR EXISTS (SELECT FROM unnest(n.marks) l WHERE w.mark = ANY (string_to_array(l, ';'))))
                AND NOT EXISTS (SELECT FROM walk o WHERE (o.stated_on, o.stated_along, o.mark, o.edge_id, o.along) = (w.stated_on, w.stated_along, w.mark, n.edge_id, n.along));
    END LOOP;
END $$;
SELECT pg_temp.go(8) \g /dev/null
-- Marks have no junction ahead where the network ends, and may be replaced by what the source says farther on.
UPDATE walk w SET what = CASE WHEN NOT EXISTS (SELECT FROM :"model".edge e WHERE w.goes_to IN (e.from_node, e.to_node) AND e.edge_id <> w.edge_id) THEN 'end'
        WHEN EXISTS (SELECT FROM passing p JOIN driven n ON (n.edge_id, n.along) = (p.edge_out, p.along_out) WHERE (p.edge_id, p.node_id, p.along_in) = (w.edge_id, w.goes_to, w.along)
            AND p.plausible AND w.mark = ANY (p.marks) AND n.stated IS NOT NULL AND NOT EXISTS (SELECT FROM unnest(n.marks) l WHERE w.mark = ANY (string_to_array(l, ';')))) THEN 'replaced'
        ELSE 'no way' END
    WHERE what = 'on' AND NOT EXISTS (SELECT FROM walk o WHERE (o.stated_on, o.stated_along, o.mark) = (w.stated_on, w.stated_along, w.mark) AND o.step > w.step);
-- A mark has one fate: the best of those that its ways meet.
CREATE TEMPORARY TABLE fate AS
    SELECT DISTINCT ON (stated_on, stated_along, mark) *, (SELECT max(o.step) FROM walk o WHERE (o.stated_on, o.stated_along, o.mark) = (w.stated_on, w.stated_along, w.mark)) AS steps
    FROM walk w WHERE what <> 'no lane'
    ORDER BY stated_on, stated_along, mark, array_position('{holds,elsewhere,lost,end,replaced,no way,on}', what), step DESC;
-- Lanes that lead another way than they are marked, and not for want of one.
CREATE TEMPORARY TABLE against AS
    SELECT DISTINCT p.edge_id, p.lane_in, p.node_id FROM passing p WHERE p.plausible AND p.reason <> 'only_way' AND marks && (SELECT array_agg(mark) FROM meaning)
        AND (SELECT degree FROM degree d WHERE d.node_id = p.node_id) > 2
        AND NOT EXISTS (SELECT FROM meaning m WHERE m.mark = ANY (p.marks) AND p.angle BETWEEN least AND most)
        AND EXISTS (SELECT FROM passing o JOIN meaning m ON m.mark = ANY (p.marks) AND o.angle BETWEEN least AND most WHERE (o.lane_in, o.node_id) = (p.lane_in, p.node_id)
            AND o.reason NOT IN ('restriction', 'u_turn', 'ring'));
SELECT :'model', count(*), count(*) FILTER (WHERE what = 'holds'), count(*) FILTER (WHERE what = 'lost'), count(*) FILTER (WHERE what = 'elsewhere'),
    count(*) FILTER (WHERE what IN ('no way', 'on')), count(*) FILTER (WHERE what = 'replaced'), (SELECT count(*) FROM against) FROM fate WHERE what <> 'end';
\if :named
SELECT what, mark, stated_on, edge_id, goes_to, array_to_string(marks, '|'), (SELECT string_agg(DISTINCT round(angle) || CASE WHEN plausible THEN '+' ELSE '' END, ' ') FROM passing p
    WHERE (p.edge_id, p.node_id, p.along_in) = (j.edge_id, j.goes_to, j.along)) FROM fate j WHERE what <> 'holds' ORDER BY what, edge_id, mark;
\endif
