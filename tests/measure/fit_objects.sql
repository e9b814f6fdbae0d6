-- Objects at the kerbs of a model, in and out of its roadway by 0.4 to 1.2 m and on its border, about 2,000:
-- psql -v model=MODEL -v points=TABLE.
CREATE TABLE :points AS
SELECT row_number() OVER () AS id, 'object' AS kind, relation, ST_Translate(place, cos(turn) * reach, sin(turn) * reach)
    AS geom
FROM (SELECT edge_id, ST_Force2D(k.geom) AS kerb, step * (n + 0.5) / ST_Length2D(k.geom) AS share,
        n + k.kerb_id AS number
    FROM :model.kerb k, (SELECT sum(ST_Length2D(geom)) / 2000 AS step FROM :model.kerb WHERE node_id IS NULL) t,
        generate_series(0, floor(ST_Length2D(k.geom) / step)::integer) n
    WHERE node_id IS NULL AND side IN ('left', 'right') AND step * (n + 0.5) < ST_Length2D(k.geom)) k
    JOIN :model.edge e USING (edge_id),
    LATERAL (SELECT ST_LineInterpolatePoint(kerb, share) AS place) p,
    LATERAL (SELECT ST_ClosestPoint(ST_Force2D(e.geom), place) AS foot) f,
    LATERAL (SELECT atan2(ST_Y(place) - ST_Y(foot), ST_X(place) - ST_X(foot)) AS turn) t,
    LATERAL (SELECT ('{in,out,border}'::text[])[1 + number % 3] AS relation) r,
    LATERAL (SELECT CASE relation WHEN 'in' THEN -1 WHEN 'out' THEN 1 ELSE 0 END * (0.4 + 0.8 * (number % 7) / 6)
        AS reach) o;
