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
