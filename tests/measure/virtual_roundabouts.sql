-- The roundabouts of a virtual city that are found, whose rings are known: psql -v seed=1 -f tests/measure/virtual_roundabouts.sql
-- Names are hidden, and each vertex lies up to half a metre off. Makes model city and removes it; prints as roundabouts.sql does.
\set ON_ERROR_STOP on
\set QUIET on
SELECT FROM streetgen.create_virtual_city('city', 2154, 650000, 6860000, 4000, 4000, :seed, '{"roundabouts": 0.5}');
UPDATE city.axis SET roundabout_tag = CASE WHEN name LIKE 'Roundabout %' AND ST_IsClosed(geom) THEN 'roundabout' END, name = NULL,
    -- One place stays one place.
    geom = (SELECT ST_SetSRID(ST_MakeLine(ST_MakePoint(ST_X(p.geom) + 0.5 * r * cos(a), ST_Y(p.geom) + 0.5 * r * sin(a)) ORDER BY p.path[1]), ST_SRID(axis.geom))
        FROM ST_DumpPoints(axis.geom) p, LATERAL (SELECT abs(hashtext(ST_AsText(p.geom, 3))) % 1000 / 1000.0 AS r, abs(hashtext(ST_AsText(p.geom, 3) || 'a')) % 360 * pi() / 180 AS a) n);
\set model city
\ir roundabouts.sql
SELECT FROM streetgen.drop_model('city');
