-- The edges of model :model with a lane from which nobody drives on: nothing connects there, or only lanes between crossed limits from which nothing does.
WITH direction AS (
    SELECT l.lane_id, l.edge_id, along, EXISTS (SELECT FROM :"model".section s WHERE s.edge_id = l.edge_id
        AND s.method = 'crossed_limits') AS crossed
    FROM :"model".lane l, (VALUES (true), (false)) v(along)
    WHERE (l.both_ways OR l.along_axis = along) AND kind NOT IN ('parking', 'closed')),
way AS (SELECT * FROM :"model".interconnection WHERE connecting),
dead AS (
    SELECT * FROM direction d WHERE NOT EXISTS (SELECT FROM way w WHERE (w.lane_in, w.along_in) = (d.lane_id, d.along)))
SELECT DISTINCT edge_id FROM direction d
WHERE NOT EXISTS (SELECT FROM way w LEFT JOIN dead o ON crossed AND (o.lane_id, o.along) = (w.lane_out, w.along_out)
    WHERE (w.lane_in, w.along_in) = (d.lane_id, d.along) AND o.lane_id IS NULL);
