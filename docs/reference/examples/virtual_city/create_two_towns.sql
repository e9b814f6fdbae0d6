-- argument options: an object of options: driving_side, and what two_towns_option lists
-- see two_towns_option, create_virtual_city, generate
SELECT streetgen.create_two_towns('two', 2154, 650000, 6860000, 7, '{"driving_side": "left", "distance": 3000}') > 0 AS has_axes;
SELECT kind, count(*), round(sum(ST_Length(geom)) / 1000) AS km FROM two.axis GROUP BY kind ORDER BY kind;
-- drawing
SELECT t.geom::geometry, CASE WHEN kind IN ('motorway', 'motorway_link') THEN 'result' ELSE 'kerb' END, NULL FROM streetgen._two_towns(2154, 650000, 6860000, 7, false, '{}', '{}') t
