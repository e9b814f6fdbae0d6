-- Crossings far apart, whose kerbs are observed with noise: psql -v crossings=COUNT -v seed=NUMBER.
SELECT setseed(:seed) \g /dev/null
SELECT streetgen.create_model('known', 2154, subjects => '{fit}', driving_side => 'right'), streetgen.set('known', 'crossing', 'split') \g /dev/null
CREATE TABLE crossing AS SELECT n, ST_SetSRID(ST_MakePoint(600000 + 200 * (n % 100), 6800000 + 200 * (n / 100)), 2154) AS place, 6.2832 * random() AS heading,
    radians(75 + 30 * random()) AS turn, 5 + 6 * random() AS width_a, 5 + 6 * random() AS width_b, 3 + 9 * random() AS radius FROM generate_series(1, :crossings) n;
INSERT INTO known.axis (geom, width, radius)
SELECT ST_MakeLine(ST_Translate(place, -60 * cos(h), -60 * sin(h)), ST_Translate(place, 60 * cos(h), 60 * sin(h))), width, radius
FROM crossing, LATERAL (VALUES (heading, width_a), (heading + turn, width_b)) v(h, width) ORDER BY n, h;
SELECT streetgen.generate('known') \g /dev/null
-- Two numbers of one distance from the middle are normal by Box and Muller.
CREATE TABLE survey AS SELECT of_ring AS id, ST_MakeLine(ST_Translate(d.geom, off * cos(way), off * sin(way)) ORDER BY d.path) AS geom
FROM (SELECT row_number() OVER () AS of_ring, ST_Boundary(ground.geom) AS ring FROM (SELECT (ST_Dump(ST_Union(surface))).geom
        FROM (SELECT surface FROM known.section UNION ALL SELECT surface FROM known.intersection) s) ground) r,
    LATERAL ST_DumpPoints(ST_LineInterpolatePoints(ring, 0.5 / ST_Length(ring), true)) d,
    LATERAL (SELECT 0.05 * sqrt(-2 * ln(1 - random())) AS off, 6.2832 * random() AS way WHERE d.path IS NOT NULL) noise
GROUP BY of_ring;
SELECT streetgen.set('known', 'fit_arc_tolerance', '0.2') FROM streetgen.observe('known', 'survey', '{"source_ref": "id"}') LIMIT 1 \g /dev/null
CREATE TABLE judged AS SELECT c.radius, o.radius AS observed FROM known.corner c LEFT JOIN streetgen._observed_corners('known', NULL) o USING (corner_id)
WHERE c.arc IS NOT NULL AND ST_Length(c.arc) / c.radius BETWEEN radians(45) AND radians(135);
SELECT format('%s corners, found %s, median error of radii %s %%, 90 of 100 within %s %%', count(*), round(avg((observed IS NOT NULL)::integer), 4), round(100 * percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(observed / radius - 1))::numeric, 2),
    round(100 * percentile_cont(0.9) WITHIN GROUP (ORDER BY abs(observed / radius - 1))::numeric, 2)) AS figures FROM judged \gset
\warn :figures
SELECT CASE WHEN holds THEN 't' ELSE 'f' END, name FROM (SELECT count(*) >= 4 * :crossings * 0.99 AS corners, avg((observed IS NOT NULL)::integer) >= 0.95 AS found,
    percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(observed / radius - 1)) <= 0.05 AS near FROM judged) j,
    LATERAL (VALUES (corners, 'corners turn by 45 to 135 degrees'), (found, 'arcs of 95 of 100 noisy kerbs are found'), (near, 'half of their radii are within 5 %')) v(holds, name);
