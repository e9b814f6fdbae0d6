-- Kerbs, blocks and sidewalks of one model against oracles of PostGIS, a row per table: psql -v model=NAME -v share=1 -f tests/measure/ground.sql
-- share: of the sides of surfaces whose places are told, at random.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SET client_min_messages = warning;
CREATE TEMPORARY TABLE roadway AS SELECT level, ST_Union(surface, 1e-5) AS geom FROM :"model".roadway GROUP BY level;
-- A place on each metre of the sides of surfaces: it is on the border where no surface of the level lies 20 micrometres beyond; a crack between
-- two surfaces may be half as wide.
SELECT setseed(0.5) \g /dev/null
CREATE TEMPORARY TABLE place AS
SELECT level, geom, metres / :share AS metres, ST_Translate(geom, 2e-5 * (ST_Y(b) - ST_Y(a)) / length, -2e-5 * (ST_X(b) - ST_X(a)) / length) AS beyond
FROM (SELECT level, a, b, ST_Length(side) AS length, ST_Length(side) / n AS metres, ST_LineInterpolatePoint(side, (k - 0.5) / n) AS geom
    FROM (SELECT level, (ST_DumpSegments(ST_ForcePolygonCCW(surface))).geom AS side FROM :"model".roadway) s,
        LATERAL (SELECT ST_StartPoint(side) AS a, ST_EndPoint(side) AS b, ceil(ST_Length(side))::integer AS n) e, generate_series(1, n) k
    WHERE ST_Length(side) > 0.001 AND random() < :share) p;
CREATE TEMPORARY TABLE told AS
SELECT metres, EXISTS (SELECT FROM :"model".roadway r WHERE r.level = p.level AND r.surface && p.beyond AND ST_Intersects(r.surface, p.beyond)) AS covered,
    (SELECT count(*) FROM :"model".kerb k WHERE k.level = p.level AND k.geom && ST_Expand(p.geom, 2e-6) AND ST_DWithin(k.geom, p.geom, 1e-6)) AS kerbs
FROM place p;
SELECT 'kerbs | ' || :'model', (SELECT count(*) FROM :"model".kerb), round((SELECT sum(ST_Length(geom)) FROM :"model".kerb)::numeric, 3),
    round(sum(metres) FILTER (WHERE NOT covered)::numeric, 3), round(coalesce(sum(metres) FILTER (WHERE NOT covered AND kerbs = 0), 0)::numeric, 4),
    round(coalesce(sum(metres) FILTER (WHERE NOT covered AND kerbs > 1), 0)::numeric, 4),
    round(coalesce(sum(metres) FILTER (WHERE covered AND kerbs > 0), 0)::numeric, 4) || ' |'
FROM told;

CREATE TEMPORARY TABLE ground AS SELECT value::integer AS level FROM :"model".setting WHERE name = 'ground_level';
CREATE TEMPORARY TABLE face AS
SELECT row_number() OVER () AS face, (d).geom FROM (SELECT ST_Dump(ST_Polygonize(geom)) AS d FROM (
    SELECT ST_UnaryUnion(ST_Collect(ST_Force2D(e.geom))) AS geom FROM :"model".edge e, ground g WHERE e.level = g.level) n) p;
CREATE INDEX ON face USING gist (geom);
CREATE TEMPORARY TABLE road AS SELECT ST_Subdivide(r.geom, 256) AS geom FROM roadway r, ground g WHERE r.level = g.level;
CREATE INDEX ON road USING gist (geom);
ANALYZE face, road;
-- The grid of GEOS breaks on some rings of a city that touch themselves; then without one.
CREATE FUNCTION pg_temp.off(a geometry, b geometry) RETURNS float8 LANGUAGE plpgsql AS $$ BEGIN
    RETURN ST_Area(ST_SymDifference(a, b, 1e-5));
EXCEPTION WHEN internal_error THEN RETURN ST_Area(ST_SymDifference(a, b)); END $$;
CREATE TEMPORARY TABLE bare AS
SELECT face, geom, coalesce(ST_Difference(geom, (SELECT ST_Union(r.geom, 1e-5) FROM road r WHERE r.geom && f.geom), 1e-5), geom) AS ground FROM face f;
CREATE TEMPORARY TABLE block_face AS
SELECT b.block_id, b.surface, (SELECT f.face FROM face f WHERE f.geom && b.place AND ST_Intersects(f.geom, b.place) LIMIT 1) AS face
FROM (SELECT block_id, surface, ST_PointOnSurface(surface) AS place FROM :"model".block WHERE NOT ST_IsEmpty(surface) AND method <> 'axis_bound') b;
WITH off AS (
    SELECT f.face, ST_Area(f.ground) AS area, pg_temp.off(f.ground, b.surface) AS off
    FROM bare f JOIN (SELECT face, ST_Collect(surface) AS surface FROM (SELECT face, (ST_Dump(surface)).geom AS surface FROM block_face) s GROUP BY face) b USING (face))
SELECT 'blocks | ' || :'model', (SELECT count(*) FROM :"model".block), (SELECT count(*) FROM face),
    (SELECT count(*) FROM :"model".block WHERE method = 'axis_bound'), round(max(off)::numeric, 4),
    (SELECT count(*) FROM off WHERE off > 0.1), round((100 * sum(off) / nullif(sum(area), 0))::numeric, 6) || ' |'
FROM off;

CREATE TEMPORARY TABLE strip AS SELECT w.sidewalk_id, w.edge_id, w.side, w.part, w.width, w.method, w.surface, k.level, k.geom AS kerb
FROM :"model".sidewalk w JOIN :"model".kerb k USING (edge_id, side, part);
CREATE INDEX ON strip USING gist (surface);
ANALYZE strip;
-- The width in the middle of straight kerbs: across the strip there, where it has one and nothing contests it. Changes of width lie within
-- sidewalk_transition of the ends.
CREATE TEMPORARY TABLE straight AS
SELECT sidewalk_id, width, ST_Length(ST_Intersection(surface, ST_MakeLine(middle, ST_Translate(middle, -60 * dy, 60 * dx)))) AS measured
FROM (SELECT s.*, ST_LineInterpolatePoint(kerb, 0.5) AS middle, (ST_X(b) - ST_X(a)) / ST_Distance(a, b) AS dx, (ST_Y(b) - ST_Y(a)) / ST_Distance(a, b) AS dy
    FROM strip s, LATERAL (SELECT ST_StartPoint(kerb) AS a, ST_EndPoint(kerb) AS b) e
    WHERE side IN ('left', 'right') AND method <> 'contested' AND ST_NPoints(kerb) = 2 AND ST_Length(kerb) > 20) m;
SELECT 'sidewalks | ' || :'model', (SELECT count(*) FROM strip), round((SELECT sum(ST_Area(surface)) FROM strip)::numeric, 0),
    (SELECT count(*) FROM strip WHERE NOT ST_IsValid(surface)),
    (SELECT count(*) FROM strip WHERE ST_Distance(surface, kerb) > 0.001),
    (SELECT round(coalesce(sum(ST_Area(ST_Intersection(s.surface, r.geom))), 0)::numeric, 4) FROM strip s JOIN road r ON r.geom && s.surface AND s.level = (SELECT level FROM ground)),
    (SELECT round((100 * coalesce(sum(ST_Area(ST_Intersection(a.surface, b.surface))), 0) / nullif((SELECT sum(ST_Area(surface)) FROM strip), 0))::numeric, 6)
        FROM strip a JOIN strip b ON a.surface && b.surface AND a.level = b.level AND a.sidewalk_id < b.sidewalk_id),
    (SELECT round(coalesce(sum(ST_Area(ST_Difference(s.surface, b.surface))), 0)::numeric, 4) FROM strip s JOIN :"model".sidewalk_block USING (sidewalk_id) JOIN :"model".block b USING (block_id)
        WHERE NOT ST_Contains(b.surface, s.surface)),
    (SELECT count(*) FROM straight), (SELECT count(*) FROM straight WHERE abs(measured - width) > 0.01) || ' |';
