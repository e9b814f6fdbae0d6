-- A point each metre along the borders of areas, or along lines, of a table (psql -v survey=TABLE -v points=TABLE): the
-- odd ones judge. Borders of the extract (psql -v frame=EXTENT) are none.
CREATE TABLE :points AS
SELECT row_number() OVER () AS id, k % 2 = 1 AS judges, ST_LineInterpolatePoint(line, k / steps) AS geom
FROM (SELECT (ST_Dump(CASE ST_Dimension(geom) WHEN 2 THEN ST_Boundary(geom) ELSE geom END)).geom AS line
        FROM :survey) l,
    LATERAL (SELECT ceil(ST_Length(line)) AS steps) s, LATERAL generate_series(0, steps::integer - 1) k
WHERE NOT ST_DWithin(ST_LineInterpolatePoint(line, k / steps), ST_Boundary(:frame), 0.05);
CREATE INDEX ON :points USING gist (geom);
