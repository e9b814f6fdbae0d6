-- The papers' experiments: axes of model `timed`, about the 6th arrondissement where they lie in Paris, else about their middle. Made before it is.
SET check_function_bodies = off;
CREATE FUNCTION bench.middle() RETURNS geometry LANGUAGE sql STABLE AS $$
    SELECT CASE WHEN count(*) FILTER (WHERE ST_DWithin(geom, sixth, 500)) > 0 THEN sixth ELSE ST_SetSRID(ST_Centroid(ST_Extent(geom)::geometry(Polygon)), ST_SRID(sixth)) END
    FROM timed.axis, (SELECT ST_Transform('SRID=4326;POINT(2.3327 48.8494)'::geometry, srid) AS sixth FROM streetgen.model WHERE name = 'timed') s GROUP BY sixth
$$;
-- From the middle outwards. It is asked for once, not for each axis.
CREATE FUNCTION bench.outwards() RETURNS TABLE(axis_id bigint, metres float8) LANGUAGE sql STABLE AS $$
    WITH middle AS MATERIALIZED (SELECT bench.middle() AS place) SELECT axis_id, ST_Distance(geom, place) FROM timed.axis, middle ORDER BY 2, 1
$$;
CREATE FUNCTION bench.street() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM bench.outwards() LIMIT 1 $$;
CREATE FUNCTION bench.block() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM bench.outwards() WHERE metres <= 100 $$;
-- A circle of the 2.15 km2 of the 6th.
CREATE FUNCTION bench.arrondissement() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM bench.outwards() WHERE metres <= 827 $$;
CREATE FUNCTION bench.quarter() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$
    SELECT axis_id FROM (SELECT axis_id, ntile(4) OVER (ORDER BY metres, axis_id) AS part FROM bench.outwards()) a WHERE part = 1
$$;
CREATE FUNCTION bench.whole() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM timed.axis $$;
