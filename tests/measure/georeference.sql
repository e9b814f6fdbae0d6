-- Metres between places by files and by PostGIS. Variables: model, origins (the rows of georeference.py).
CREATE TEMPORARY TABLE origin (file text, reference text, x float8, y float8, z float8, matrix float8[]);
\set load '\\copy origin FROM ' :'origins' ' NULL '''''
:load
CREATE TEMPORARY TABLE place AS SELECT o.*, srid, dx, dy, ST_SetSRID(ST_MakePoint(x + dx, y + dy), srid) AS there
  FROM streetgen.model m, origin o, (SELECT ST_XMax(b) - ST_XMin(b) AS wide, ST_YMax(b) - ST_YMin(b) AS high FROM streetgen._model_extent(:'model') b) s,
    LATERAL (SELECT CASE WHEN matrix IS NULL THEN wide ELSE 350 END * u AS dx, CASE WHEN matrix IS NULL THEN high ELSE 350 END * v AS dy FROM generate_series(0, 1) u, generate_series(0, 1) v) c WHERE m.name = :'model';
SELECT file, round(max(CASE WHEN matrix IS NULL THEN ST_Distance(ST_Transform(there, 4326)::geography, CASE WHEN reference ~ '^[0-9]+$' THEN ST_Transform(ST_SetSRID(ST_MakePoint(x + dx, y + dy), reference::integer), 4326)
      ELSE ST_Transform(ST_SetSRID(ST_MakePoint(CASE WHEN reference LIKE '%+k=1 +x_0=0 +y_0=0%' THEN dx ELSE x + dx END, CASE WHEN reference LIKE '%+k=1 +x_0=0 +y_0=0%' THEN dy ELSE y + dy END), 0), reference, 4326) END::geography)
    ELSE (SELECT ST_3DDistance(ST_SetSRID(ST_Force3D(ST_MakePoint(0, 0)), 4978), ST_SetSRID(ST_MakePoint(dx * matrix[1] + dy * matrix[5] + matrix[13] - ST_X(p), dx * matrix[2] + dy * matrix[6] + matrix[14] - ST_Y(p),
        dx * matrix[3] + dy * matrix[7] + matrix[15] - ST_Z(p)), 4978)) FROM ST_Transform(ST_Translate(ST_Force3D(there), 0, 0, z), 4978) p) END)::numeric, 4)
FROM place GROUP BY file ORDER BY file;
