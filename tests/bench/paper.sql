-- What the papers' experiments compute: axes of model `timed`, about the 6th arrondissement where they lie in Paris, else about their middle. Made before it is.
SET check_function_bodies = off;
CREATE FUNCTION bench.middle() RETURNS geometry LANGUAGE sql STABLE AS $$
    SELECT CASE WHEN count(*) FILTER (WHERE ST_DWithin(geom, sixth, 500)) > 0 THEN sixth ELSE ST_Centroid(ST_Extent(geom)::geometry(Polygon)) END
    FROM timed.axis, LATERAL (SELECT ST_Transform('SRID=4326;POINT(2.3327 48.8494)'::geometry, ST_SRID(geom)) AS sixth) s GROUP BY sixth
$$;
CREATE FUNCTION bench.street() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM timed.axis ORDER BY geom <-> ST_SetSRID(bench.middle(), ST_SRID(geom)), axis_id LIMIT 1 $$;
CREATE FUNCTION bench.within(distance float8) RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM timed.axis WHERE ST_DWithin(geom, ST_SetSRID(bench.middle(), ST_SRID(geom)), distance) $$;
CREATE FUNCTION bench.block() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT bench.within(100) $$;
-- A circle of the 2.15 km2 of the 6th.
CREATE FUNCTION bench.arrondissement() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT bench.within(827) $$;
CREATE FUNCTION bench.quarter() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$
    SELECT axis_id FROM (SELECT axis_id, ntile(4) OVER (ORDER BY geom <-> ST_SetSRID(bench.middle(), ST_SRID(geom)), axis_id) AS part FROM timed.axis) a WHERE part = 1
$$;
CREATE FUNCTION bench.whole() RETURNS SETOF bigint LANGUAGE sql STABLE AS $$ SELECT axis_id FROM timed.axis $$;
