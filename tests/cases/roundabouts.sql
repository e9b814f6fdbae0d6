-- Awkward rings side by side, a model of its own: which are roundabouts?  data/gallery draws them
SELECT streetgen.create_model('roundabouts', 2154, subjects => '{interconnection,roundabout}', driving_side => 'right') \gset
SELECT streetgen.live('roundabouts', false) \gset
CREATE FUNCTION pg_temp.at(x float8, y float8) RETURNS geometry LANGUAGE sql AS $$ SELECT ST_SetSRID(ST_MakePoint(650000 + x, 6860000 + y), 2154) $$;
-- An arc about a centre, degrees counter-clockwise; the radius grows to radius_end.
CREATE FUNCTION pg_temp.arc(x float8, y float8, radius float8, start float8, stop float8, radius_end float8 DEFAULT NULL) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(pg_temp.at(x + r * cos(radians(a)), y + r * sin(radians(a))) ORDER BY i) FROM generate_series(0, 24) i,
    LATERAL (SELECT start + (stop - start) * i / 24 AS a, radius + (coalesce(radius_end, radius) - radius) * i / 24 AS r) p $$;
CREATE FUNCTION pg_temp.circle(x float8, y float8, radius float8) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_AddPoint(ST_RemovePoint(g, ST_NPoints(g) - 1), ST_StartPoint(g)) FROM pg_temp.arc(x, y, radius, 0, 360) g $$;
CREATE FUNCTION pg_temp.street(VARIADIC xy float8[]) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_MakeLine(pg_temp.at(xy[2 * i - 1], xy[2 * i]) ORDER BY i) FROM generate_series(1, cardinality(xy) / 2) i $$;
CREATE FUNCTION pg_temp.arms(x float8, y float8, radius float8, VARIADIC angles float8[]) RETURNS SETOF geometry LANGUAGE sql AS $$
  SELECT pg_temp.street(x + radius * cos(radians(a)), y + radius * sin(radians(a)), x + (radius + 35) * cos(radians(a)), y + (radius + 35) * sin(radians(a))) FROM unnest(angles) a $$;
INSERT INTO roundabouts.axis (name, width, lane_count, geom)
-- Roundabouts: a ring, a tiny one, a painted one, a double one with a street between its halves, a peanut.
SELECT 'ring', 7, 2, pg_temp.circle(0, 0, 16) UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(0, 0, 16, 0, 90, 180, 270)
UNION ALL SELECT 'tiny', 5, 2, pg_temp.circle(150, 0, 4) UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(150, 0, 4, 0, 90, 180, 270)
UNION ALL SELECT 'painted', 6.5, 2, pg_temp.circle(600, 0, 3.1) UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(600, 0, 3.1, 0, 90, 180, 270)
UNION ALL SELECT 'double', 7, 2, pg_temp.arc(290, 0, 15, 30, 330) UNION ALL SELECT 'double', 7, 2, pg_temp.arc(316, 0, 15, 210, 510)
UNION ALL SELECT 'double', 7, 2, pg_temp.street(290 + 15 * cos(radians(30)), -7.5, 290 + 15 * cos(radians(30)), 7.5)
UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(290, 0, 15, 90, 180, 270) UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(316, 0, 15, 0, 90, 270)
UNION ALL SELECT 'peanut', 7, 2, ST_MakeLine(ARRAY[pg_temp.arc(440, 0, 14, 45, 315), pg_temp.arc(470, 0, 14, 225, 495), pg_temp.at(440 + 14 * cos(radians(45)), 14 * sin(radians(45)))])
UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(440, 0, 14, 90, 180, 270) UNION ALL SELECT 'arm', 6, 2, pg_temp.arms(470, 0, 14, 0, 90, 270)
-- None of them: a square with a garden, a spiral, an oval racetrack, a hairpin, a turning circle, a loop of a cloverleaf.
UNION ALL SELECT 'square', 6, 2, pg_temp.street(-20, -170, 25, -170, 25, -125, -20, -125, -20, -170)
UNION ALL SELECT 'street', 6, 2, pg_temp.street(-60, -170, -20, -170) UNION ALL SELECT 'street', 6, 2, pg_temp.street(25, -170, 60, -170)
UNION ALL SELECT 'street', 6, 2, pg_temp.street(25, -125, 60, -125) UNION ALL SELECT 'street', 6, 2, pg_temp.street(-20, -125, -20, -90)
UNION ALL SELECT 'spiral', 5, 2, pg_temp.arc(150, -150, 30, 0, 720, 6)
UNION ALL SELECT 'racetrack', 10, 2, ST_MakeLine(ARRAY[pg_temp.arc(280, -150, 18, 90, 270), pg_temp.arc(340, -150, 18, -90, 90), pg_temp.at(280, -132)])
UNION ALL SELECT 'street', 6, 2, pg_temp.street(310, -168, 310, -200)
UNION ALL SELECT 'hairpin', 7, 2, ST_MakeLine(ARRAY[pg_temp.street(400, -140, 440, -140), pg_temp.arc(440, -152, 12, 90, -90), pg_temp.street(400, -164, 380, -164)])
UNION ALL SELECT 'street', 6, 2, pg_temp.street(400, -140, 400, -164)
UNION ALL SELECT 'turning circle', 6, 2, pg_temp.circle(520, -150, 9) UNION ALL SELECT 'dead end', 6, 2, pg_temp.street(520, -141, 520, -80)
UNION ALL SELECT 'motorway', 10, 3, pg_temp.street(-60, -300, 0, -300, 60, -300) UNION ALL SELECT 'motorway', 10, 3, pg_temp.street(0, -360, 0, -260)
UNION ALL SELECT 'loop', 5, 1, ST_MakeLine(ARRAY[pg_temp.at(0, -330), pg_temp.arc(25, -325, 20, 195, 435), pg_temp.at(45, -300)]);
UPDATE roundabouts.axis SET direction = 'direct' WHERE name IN ('loop', 'motorway');
UPDATE roundabouts.axis SET level = 1 WHERE name = 'motorway' AND ST_XMin(geom) = ST_XMax(geom);
SELECT FROM streetgen.generate('roundabouts');
SELECT streetgen.live('roundabouts', true) \gset
SELECT axis.name, roundabout.kind, round(roundabout.radius::numeric, 1) AS radius, round(score::numeric, 2) AS score, round(term_shape::numeric, 2) AS shape, round(term_name::numeric, 2) AS names,
  round(term_network::numeric, 2) AS network, accepted
FROM roundabouts.roundabout JOIN roundabouts.edge USING (edge_id) JOIN roundabouts.axis USING (axis_id) ORDER BY score DESC;
