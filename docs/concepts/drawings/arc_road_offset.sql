-- A road and the same shape to either side of it: figure 8 of Wilkie, Sewall and Lin.
-- drawing
WITH given AS (SELECT streetgen.arc_road('LINESTRING(0 0, 60 0, 84 40, 130 34, 168 62)', 34) AS road)
SELECT streetgen.arc_road_offset(road, d), 'result', CASE WHEN d > 0 THEN 'd' ELSE '-d' END FROM given, unnest(ARRAY[5, -5]::float8[]) d
UNION ALL SELECT road, 'kerb', NULL FROM given
UNION ALL SELECT ST_MakeLine(ST_Translate(p.geom, 5 * -p.rightward[1], 5 * -p.rightward[2]), ST_Translate(p.geom, 5 * p.rightward[1], 5 * p.rightward[2])), 'helper', NULL
    FROM given, generate_series(0, 170, 10) metres, streetgen.arc_road_point(road, metres) p
