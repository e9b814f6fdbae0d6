-- Estimated sidewalks on medians of one model: psql -v model=NAME -f tests/measure/medians.sql
-- Medians are found by axes, names and widths alone. One looks to both sides from places 5 m apart along one-way
-- edges. Ground is a median where the first edge of the level there has the same name, runs one-way the other way,
-- and is no farther than 20 m, kerb to kerb.
-- Columns: model; places that look on a median; those with a sidewalk on it; square metres of these, by 5 m of each
-- place and half of both sides.
SET client_min_messages = warning;
CREATE TEMPORARY TABLE one AS
SELECT edge_id, e.level, ST_Force2D(e.geom) AS geom, e.width, a.name,
    CASE WHEN e.lanes_both > 0 OR e.lanes_forward > 0 AND e.lanes_backward > 0 THEN 0
        WHEN e.lanes_forward > 0 THEN 1 WHEN e.lanes_backward > 0 THEN -1 ELSE 0 END AS way
FROM :"model".edge e JOIN :"model".axis a USING (axis_id);
CREATE INDEX ON one USING gist (geom);
ANALYZE one;
CREATE FUNCTION pg_temp.azimuth(line geometry, share float8, step float8) RETURNS float8 LANGUAGE sql AS $$
SELECT ST_Azimuth(ST_LineInterpolatePoint(line, greatest(0, share - step)),
    ST_LineInterpolatePoint(line, least(1, share + step))) $$;
CREATE TEMPORARY TABLE look AS
SELECT edge_id, level, name, width, way, azimuth, place, ST_MakeLine(place, ST_Translate(place,
    40 * sin(azimuth - side * pi() / 2), 40 * cos(azimuth - side * pi() / 2))) AS ray
FROM (SELECT o.*, ST_LineInterpolatePoint(geom, share) AS place, pg_temp.azimuth(geom, share, 0.25 / size) AS azimuth
    FROM one o, LATERAL (SELECT ST_Length(geom) AS size) l, generate_series(0, floor(size / 5)::integer - 1) k,
        LATERAL (SELECT least(1, (k + 0.5) * 5 / size) AS share) s
    WHERE way <> 0) p, (VALUES (1), (-1)) s(side);
CREATE TEMPORARY TABLE median AS
SELECT l.edge_id, l.level, ST_MakeLine(place, ST_LineInterpolatePoint(ray, away / 40)) AS across
FROM look l, LATERAL (
    SELECT o.*, ST_Distance(place, met) AS away,
        pg_temp.azimuth(o.geom, ST_LineLocatePoint(o.geom, met), 0.001) AS other_azimuth
    FROM one o, LATERAL (SELECT ST_ClosestPoint(ST_Intersection(o.geom, ray), place) AS met) i
    WHERE o.geom && ray AND ST_Intersects(o.geom, ray) AND o.edge_id <> l.edge_id AND o.level = l.level
    ORDER BY away LIMIT 1) o
WHERE o.way <> 0 AND o.name = l.name AND o.way * l.way * cos(azimuth - other_azimuth) < -cos(radians(30))
    AND away - (l.width + o.width) / 2 BETWEEN 0 AND 20;
SELECT :'model' AS model, count(*) AS places, count(*) FILTER (WHERE metres > 0.05) AS with_sidewalk,
    round((2.5 * coalesce(sum(metres), 0))::numeric, 1) AS m2
FROM median m, LATERAL (
    SELECT coalesce(sum(ST_Length(ST_Intersection(s.surface, m.across))), 0) AS metres
    FROM :"model".sidewalk s JOIN :"model".edge e USING (edge_id)
    WHERE s.surface && m.across AND e.level = m.level AND s.method <> 'by_hand') s;
