-- Movements of model :model whose own path bends so that the bound inside has a radius under 2 m, by their id in files of Lanelet2: those that nobody can draw wider.
WITH vertex AS (
    SELECT interconnection_id, lane_in, path[1] AS nth, p.geom AS place, lag(p.geom) OVER way AS before, lead(p.geom) OVER way AS behind
    FROM :"model".interconnection i, ST_DumpPoints(i.geom) p WHERE connecting WINDOW way AS (PARTITION BY interconnection_id ORDER BY path[1])),
radius AS (
    SELECT interconnection_id, min(CASE WHEN area > 1e-9 THEN ST_Distance(before, place) * ST_Distance(place, behind) * ST_Distance(before, behind) / (4 * area) END) - min(width) / 2 AS inside
    FROM vertex JOIN :"model".lane ON lane_id = lane_in,
        LATERAL (SELECT abs((ST_X(place) - ST_X(before)) * (ST_Y(behind) - ST_Y(before)) - (ST_Y(place) - ST_Y(before)) * (ST_X(behind) - ST_X(before))) / 2 AS area) a
    WHERE before IS NOT NULL AND behind IS NOT NULL GROUP BY interconnection_id)
SELECT streetgen._file_id('interconnection', interconnection_id) FROM radius WHERE inside < 2;
