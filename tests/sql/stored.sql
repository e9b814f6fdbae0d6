\set ECHO none
\ir shared/truths.sql
-- Geometries are written as PostGIS stores them: byte by byte what it makes of the same EWKB.  (name, holds)
SELECT streetgen.create_model('flat', 32631), streetgen.create_model('high', 2154, 3) \g /dev/null
-- About the origin, with a bend, a crossing, a loop so small that one surface holds its hole, and a street too short for its limits.
CREATE TABLE public.source AS SELECT * FROM (VALUES
    (1, 'LINESTRING(-120.1 -80.3, 0 0)', 7, 4), (2, 'LINESTRING(0 0, 97.7 13.1, 130.3 71.9)', 7, 4), (3, 'LINESTRING(0 0, 3.3 101.7)', 9, 3),
    (4, 'LINESTRING(0 0, 12.7 -91.3)', 6, 5), (5, 'LINESTRING(3.3 101.7, 9.1 109.9)', 9, 3), (6, 'LINESTRING(9.1 109.9, 80.3 120.7)', 12, 2), (7, 'LINESTRING(9.1 109.9, -60.1 151.3)', 12, 2),
    (8, 'LINESTRING(200.1 0.3, 260.1 0.3)', 12, NULL), (9, 'LINESTRING(260.1 0.3, 263.1 -2.7, 266.1 0.3, 263.1 3.3, 260.1 0.3)', 2, NULL)) v(axis_id, line, width, importance);
INSERT INTO flat.axis (axis_id, geom, width, importance, radius) SELECT axis_id, ST_GeomFromText(line, 32631), width, importance, 8 FROM source;
INSERT INTO high.axis (axis_id, geom, width, importance, lanes_forward)
    SELECT axis_id, ST_Translate(ST_Force3DZ(ST_GeomFromText(line, 2154), axis_id / 7.0 - 0.5), 650000, 6860000), width, importance, 2 FROM source;
SELECT streetgen.generate(m) FROM unnest(ARRAY['flat', 'high']::name[]) m \g /dev/null

CREATE TABLE public.geometry_of (model name, relation name, attribute name, geom geometry, as_stored boolean);
SELECT format('INSERT INTO geometry_of SELECT %1$L, %2$L, %3$L, %3$I, record_image_eq(ROW(%3$I), ROW(%3$I::bytea::geometry)) FROM %1$I.%2$I WHERE %3$I IS NOT NULL', nspname, relname, attname)
    FROM pg_attribute JOIN pg_class c ON c.oid = attrelid JOIN pg_namespace n ON n.oid = relnamespace
    WHERE nspname IN ('flat', 'high') AND relname = ANY (streetgen._computed_tables('flat')) AND atttypid = 'geometry'::regtype AND relkind = 'r' \gexec
SELECT format('%s.%s of model %s is as PostGIS stores it', relation, attribute, model), bool_and(as_stored) FROM geometry_of GROUP BY relation, attribute, model ORDER BY model, relation COLLATE "C", attribute COLLATE "C";
SELECT format('there are %s', kind), count > 0 FROM (
    SELECT count(*) FILTER (WHERE ST_NPoints(geom) = 2) AS "lines of two points", count(*) FILTER (WHERE GeometryType(geom) = 'LINESTRING' AND ST_NPoints(geom) > 2 AND ST_Zmflag(geom) = 2) AS "bent lines with heights",
           count(*) FILTER (WHERE GeometryType(geom) = 'POINT' AND ST_Zmflag(geom) = 2) AS "points with heights", count(*) FILTER (WHERE GeometryType(geom) = 'MULTIPOLYGON' AND ST_IsEmpty(geom)) AS "empty surfaces",
           count(*) FILTER (WHERE GeometryType(geom) = 'MULTIPOLYGON' AND ST_NRings(geom) > ST_NumGeometries(geom)) AS "surfaces with a hole", count(*) FILTER (WHERE ST_NumGeometries(geom) > 1) AS "surfaces of several parts"
    FROM geometry_of) c, LATERAL (SELECT key AS kind, value::bigint AS count FROM jsonb_each_text(to_jsonb(c))) k;
SELECT 'every geometry that a run writes is looked at', count(DISTINCT (relation, attribute)) >= 16 FROM geometry_of;
