\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Two streets come to a third from opposite sides, 6 m apart: the line between both intersections lies askew.
DO $$ BEGIN PERFORM streetgen.create_model('staggered', 2154), streetgen.create_model('scratch', 2154); END $$;
CREATE FUNCTION pg_temp.line(variadic at float8[]) RETURNS geometry LANGUAGE sql AS $$
    SELECT ST_SetSRID(ST_MakeLine(ARRAY(SELECT ST_MakePoint(650000 + at[2 * i - 1], 6860000 + at[2 * i])
        FROM generate_series(1, cardinality(at) / 2) i)), 2154) $$;
INSERT INTO staggered.axis (axis_id, geom, width) VALUES (1, pg_temp.line(-80, 0, 0, 0), 7),
    (2, pg_temp.line(0, 0, 6, 0), 7), (3, pg_temp.line(6, 0, 90, 0), 7), (4, pg_temp.line(0, 0, 0, -80), 7),
    (5, pg_temp.line(6, 80, 6, 0), 7);
CREATE FUNCTION pg_temp.edited(what text, edit text) RETURNS TABLE(said text, holds boolean) LANGUAGE plpgsql AS $$
BEGIN
    EXECUTE edit;
    RETURN QUERY SELECT what || ': as from scratch', test.followed('staggered', 'scratch');
END $$;
-- Metres to the east from the line's end on the north kerb to that on the south kerb.
CREATE FUNCTION pg_temp.askew() RETURNS numeric LANGUAGE sql AS $$
    SELECT DISTINCT round((ST_X(p[2]) - ST_X(p[1]))::numeric, 2)
    FROM staggered.section_limit JOIN staggered.edge USING (edge_id),
        LATERAL (SELECT array_agg(geom ORDER BY ST_Y(geom) DESC) AS p FROM ST_DumpPoints(border_line)) d
    WHERE axis_id = 2 $$;
CREATE FUNCTION pg_temp.tightest() RETURNS numeric LANGUAGE sql AS $$
    SELECT round(min(ST_Distance(a, b) * ST_Distance(b, c) * ST_Distance(a, c)
        / nullif(4 * ST_Area(ST_MakePolygon(ST_MakeLine(ARRAY[a, b, c, a]))), 0))::numeric, 1)
    FROM (SELECT geom, generate_series(0, 2) AS k FROM staggered.interconnection WHERE plausible AND abs(angle) > 45) q,
        LATERAL (SELECT ST_LineInterpolatePoint(geom, k / 4.0) AS a, ST_LineInterpolatePoint(geom, (k + 1) / 4.0) AS b,
            ST_LineInterpolatePoint(geom, (k + 2) / 4.0) AS c) p $$;
CREATE FUNCTION pg_temp.tiled() RETURNS boolean LANGUAGE sql AS $$
    SELECT bool_and(ST_IsValid(surface) AND ST_NumGeometries(surface) = 1)
        AND abs(sum(ST_Area(surface)) - ST_Area(ST_Union(surface))) < 1e-6
    FROM (SELECT surface FROM staggered.intersection UNION ALL SELECT surface FROM staggered.section) s
    WHERE NOT ST_IsEmpty(surface) $$;
SELECT 'both of its ends lie towards the street on the other side', pg_temp.askew() = 5.4;
SELECT 'both intersections part there, and tile', pg_temp.tiled();
SELECT 'each turn has a radius of 2 m', pg_temp.tightest() >= 2;
SELECT 'lanes go from one intersection to the other on it',
    count(*) = 2 AND max(ST_Distance(l.geom, border_line)) < 0.01
    AND bool_and((ST_X(ST_StartPoint(l.geom)) > 650003) = (ST_Y(ST_StartPoint(l.geom)) < 6860000))
FROM staggered.lane l JOIN staggered.edge USING (edge_id) JOIN staggered.section_limit USING (edge_id)
WHERE axis_id = 2 AND which = 'start';
SELECT 'no way is lost', count(DISTINCT (i.edge_id, o.edge_id)) = 12 FROM staggered.interconnection
    JOIN staggered.lane i ON i.lane_id = lane_in JOIN staggered.lane o ON o.lane_id = lane_out WHERE plausible;
SELECT * FROM pg_temp.edited('both streets on the other sides',
    $$UPDATE staggered.axis SET geom = pg_temp.line(axis_id * 6 - 24, 0, axis_id * 6 - 24,
        CASE axis_id WHEN 4 THEN 80 ELSE -80 END) WHERE axis_id IN (4, 5)$$);
SELECT 'it lies askew the other way', pg_temp.askew() = -5.4 AND pg_temp.tiled();
SELECT * FROM pg_temp.edited('both streets on one side',
    $$UPDATE staggered.axis SET geom = pg_temp.line(0, 0, 0, -80) WHERE axis_id = 4$$);
SELECT 'it lies square', pg_temp.askew() = 0;
SELECT * FROM pg_temp.edited('on two sides again',
    $$UPDATE staggered.axis SET geom = pg_temp.line(6, 80, 6, 0) WHERE axis_id = 5$$);
SELECT 'it lies askew again', pg_temp.askew() = 5.4 AND pg_temp.tiled();
SELECT * FROM pg_temp.edited('streets farther apart', $$UPDATE staggered.axis
    SET geom = CASE axis_id WHEN 2 THEN pg_temp.line(0, 0, 20, 0) WHEN 3 THEN pg_temp.line(20, 0, 90, 0)
        ELSE pg_temp.line(20, 80, 20, 0) END WHERE axis_id IN (2, 3, 5)$$);
SELECT 'it lies square where there is room', pg_temp.askew() = 0
    AND (SELECT bool_and(s.method = 'crossed_limits') FROM staggered.section_limit s JOIN staggered.edge USING (edge_id)
        WHERE axis_id = 2);
