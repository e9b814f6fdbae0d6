-- Cambridge in pieces of 20 m along its streets: of one in two kerbs and backs of sidewalks are observed, the others
-- judge sidewalks: table cambridge_observed_walk, and table cambridge_judge of their ground.
CREATE TABLE cambridge_walk AS
SELECT ST_Subdivide(ST_MakeValid(ST_Transform(geom, 32619)), 64) AS geom FROM cambridge_basemap_sidewalks;
CREATE INDEX ON cambridge_walk USING gist (geom);
CREATE TABLE cambridge_ground AS
SELECT ST_Subdivide(ST_MakeValid(ST_Transform(geom, 32619)), 64) AS geom FROM cambridge_basemap_roads;
CREATE INDEX ON cambridge_ground USING gist (geom);
CREATE TABLE cambridge_piece AS
SELECT row_number() OVER () AS id, k % 2 = 1 AS judges,
    ST_LineSubstring(geom, k * 20 / metres, least(1, (k + 1) * 20 / metres)) AS geom
FROM (SELECT ST_Force2D(geom) AS geom, ST_Length2D(geom) AS metres FROM cambridge.axis WHERE level = 0) a,
    generate_series(0, ceil(metres / 20)::integer - 1) k;
CREATE INDEX ON cambridge_piece USING gist (geom);
CREATE TABLE cambridge_border AS
SELECT row_number() OVER () AS id, kind, p.geom FROM (
    SELECT 'kerb' AS kind, geom FROM cambridge_point
    UNION ALL
    -- The border of a sidewalk at a roadway is its kerb; its other border is its back.
    SELECT 'sidewalk_back', ST_LineInterpolatePoint(line, k / steps) AS geom
    FROM (SELECT (ST_Dump(ST_Boundary(ST_Transform(geom, 32619)))).geom AS line FROM cambridge_basemap_sidewalks) l,
        LATERAL (SELECT ceil(ST_Length(line)) AS steps) s, generate_series(0, steps::integer - 1) k) p
WHERE kind = 'kerb' OR NOT EXISTS (SELECT FROM cambridge_ground g WHERE ST_DWithin(g.geom, p.geom, 0.8));
CREATE INDEX ON cambridge_border USING gist (geom);
CREATE TABLE cambridge_observed_walk AS
SELECT b.* FROM cambridge_border b, LATERAL (SELECT judges, geom FROM cambridge_piece p
    WHERE ST_DWithin(p.geom, b.geom, 20) ORDER BY p.geom <-> b.geom LIMIT 1) p
WHERE NOT judges;
CREATE TABLE cambridge_judge AS
SELECT ST_Difference(ST_Buffer(p.geom, 15, 'endcap=flat'), coalesce((
    SELECT ST_Union(ST_Buffer(o.geom, 15, 'endcap=flat'))
    FROM cambridge_piece o WHERE NOT o.judges AND ST_DWithin(o.geom, p.geom, 30)), 'POLYGON EMPTY')) AS geom
FROM cambridge_piece p WHERE p.judges;
