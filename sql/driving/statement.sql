-- Parts of the query of a log of drives, by name: streetgen._part gives each.

--{drive_log
SELECT array_agg(l.t) AS times, array_agg(l.actor) AS actors, array_agg(l.number) AS numbers, array_agg(l.x) AS x,
    array_agg(l.y) AS y, array_agg(l.z) AS z, array_agg(l.speed) AS speeds, array_agg(l.length) AS lengths
FROM (SELECT s.*, (dense_rank() OVER (ORDER BY s.actor))::integer - 1 AS number
    FROM (SELECT coalesce({time}, 'NaN')::float8 AS t, {actor}::text AS actor, coalesce({x}, 'NaN')::float8 AS x,
            coalesce({y}, 'NaN')::float8 AS y, coalesce({z}, 'NaN')::float8 AS z,
            coalesce({speed}, 'NaN')::float8 AS speed, coalesce(nullif({length}, 'NaN'), 5)::float8 AS length
        FROM {samples} log) s
    ORDER BY s.t, s.actor, s.x, s.y, s.z, s.speed) l

--{walker_crossing
CREATE OR REPLACE VIEW walker_place WITH (security_invoker = true) AS
SELECT w.walker_id, ST_LineInterpolatePoint(k.line, least(1, w.across / ST_Length(k.line))) AS geom
FROM walker w JOIN edge e ON e.axis_id = w.axis_id AND w.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
    JOIN section s USING (edge_id)
    CROSS JOIN LATERAL (SELECT streetgen._walked_part(e.geom, w.abscissa - e.start_abscissa, true, s.surface) AS a,
        streetgen._walked_part(e.geom, w.abscissa - e.start_abscissa, false, s.surface) AS b) p
    CROSS JOIN LATERAL (SELECT ST_MakeLine(ST_EndPoint(p.a), ST_EndPoint(p.b)) AS line) k
WHERE w.side = 'crossing' AND ST_Length(k.line) > 0

--{walker_beside
SELECT w.walker_id, ST_LineInterpolatePoint(p.line, 0.5)
FROM walker w JOIN edge e ON e.axis_id = w.axis_id AND w.abscissa BETWEEN e.start_abscissa AND e.end_abscissa
    CROSS JOIN LATERAL (SELECT streetgen._walked_part(e.geom, w.abscissa - e.start_abscissa, w.side = 'left', s.surface)
            AS line FROM sidewalk s WHERE s.edge_id = e.edge_id AND s.side = w.side ORDER BY s.part LIMIT 1) p
WHERE w.side <> 'crossing' AND p.line IS NOT NULL
