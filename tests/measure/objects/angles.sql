-- The streets under generated crossings in Neukölln against the angles that are mapped, which are those of the street, at crossings of streets with a name.
SELECT '| neukoelln, mapped angle within 8 m of a crossing at a named street | ' || count(*) || ' | median difference of the direction of the street, degrees | ' || round((percentile_cont(0.5) WITHIN GROUP (ORDER BY off))::numeric, 1)
    || ' | within 10 degrees | ' || round(avg((off <= 10)::integer), 2) || ' |'
FROM (SELECT DISTINCT ON (c.id) least(turn, 180 - turn) AS off
    FROM neukoelln_crossing c JOIN neukoelln.street_object o ON o.type = 'crossing' AND ST_DWithin(o.geom, c.geom, 8)
        CROSS JOIN LATERAL (SELECT abs(c.angle - o.angle - 180 * floor((c.angle - o.angle) / 180)) AS turn) t
    WHERE c.angle IS NOT NULL AND EXISTS (SELECT FROM neukoelln_street s WHERE ST_DWithin(s.geom, c.geom, 3))
    ORDER BY c.id, ST_Distance(o.geom, c.geom)) a;
