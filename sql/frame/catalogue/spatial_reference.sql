-- Spatial references that streets can be built in: projected, in metres, true to scale.

CREATE OR REPLACE FUNCTION streetgen._is_mirrored(srid integer) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- Degrees.
    step constant float8 := 1e-5;
    place geometry;
    here geometry;
    east geometry;
    north geometry;
BEGIN
    -- About the middle of the projection, off the poles.
    SELECT ST_SetSRID(ST_MakePoint(coalesce(6 * zone - 183, longitude, 0),
            least(greatest(coalesce(latitude, 0), -80), 80)), 4326) INTO place
        FROM (SELECT substring(proj4text, '\+zone=(\d+)')::float8 AS zone,
            substring(proj4text, '\+lon_0=(-?[\d.]+)')::float8 AS longitude,
            substring(proj4text, '\+lat_0=(-?[\d.]+)')::float8 AS latitude
            FROM spatial_ref_sys s WHERE s.srid = _is_mirrored.srid) p;
    here := ST_Transform(place, srid);
    east := ST_Transform(ST_Translate(place, step, 0), srid);
    north := ST_Transform(ST_Translate(place, 0, step), srid);
    RETURN (ST_X(east) - ST_X(here)) * (ST_Y(north) - ST_Y(here))
        < (ST_Y(east) - ST_Y(here)) * (ST_X(north) - ST_X(here));
EXCEPTION WHEN internal_error THEN
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._is_mirrored(integer) IS
    'Whether north lies to the right of who looks east along a map of that spatial reference, as where its axes point '
    'south and west; one that is turned is not mirrored. NULL where the projection is not defined in its middle.';

CREATE OR REPLACE FUNCTION streetgen._unmirrored(srid integer) RETURNS integer
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    -- The few of the same projection first: to look whether one is mirrored takes 20 ms.
    WITH same AS MATERIALIZED (
        SELECT u.srid FROM spatial_ref_sys m JOIN spatial_ref_sys u
            ON regexp_replace(u.proj4text, ' \+(axis|towgs84)=\S+', '', 'g')
                = regexp_replace(m.proj4text, ' \+(axis|towgs84)=\S+', '', 'g')
        WHERE m.srid = _unmirrored.srid)
    SELECT s.srid FROM same s WHERE NOT streetgen._is_mirrored(s.srid) ORDER BY s.srid LIMIT 1
    $$;
COMMENT ON FUNCTION streetgen._unmirrored(integer) IS
    'The spatial reference of the same projection whose axes point east and north; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._check_srid(srid integer) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    reference record;
    utm constant text := 'Use a projection in metres that keeps its scale, such as the UTM zone of the place (EPSG '
        '32600 + zone north, 32700 + zone south; Paris is 32631) or the national one (France 2154).';
BEGIN
    SELECT srtext, proj4text INTO reference FROM spatial_ref_sys s WHERE s.srid = _check_srid.srid;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'SRID % is unknown', coalesce(srid::text, 'NULL') USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.srtext LIKE 'GEOG%' OR reference.srtext LIKE 'GEOC%'
        OR reference.proj4text ~ '\+proj=(longlat|geocent)' THEN
        RAISE EXCEPTION 'SRID % is not projected: its units are degrees', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text !~ '\+units=m( |$)' THEN
        RAISE EXCEPTION 'SRID % is not in metres', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text ~ '\+proj=(merc|webmerc|eqc|mill|cea)( |$)' THEN
        RAISE EXCEPTION 'SRID % does not keep its scale: a 7 m street would be built 4.6 m wide in Paris', srid
            USING ERRCODE = '22023', HINT = utm;
    ELSIF streetgen._is_mirrored(srid) THEN
        RAISE EXCEPTION 'SRID % is mirrored, as its axes point south and west: left and right would change places',
            srid USING ERRCODE = '22023', HINT = coalesce('Use EPSG:' || streetgen._unmirrored(srid) || ', the same '
                'projection with axes that point east and north.', utm);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_srid(integer) IS
    'Raises 22023 for spatial references that are unknown, geographic, not in metres, more than 1 % off in scale or '
    'mirrored.';

CREATE OR REPLACE FUNCTION streetgen._rim(lines text) RETURNS TABLE(label text, point geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 8 SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN QUERY EXECUTE format($sql$SELECT label::text, ST_Force2D(point) FROM (SELECT label, geom,
            ST_XMin(box) = min(ST_XMin(box)) OVER () OR ST_XMax(box) = max(ST_XMax(box)) OVER ()
            OR ST_YMin(box) = min(ST_YMin(box)) OVER () OR ST_YMax(box) = max(ST_YMax(box)) OVER () AS outermost
        FROM (SELECT label, geom, Box3D(geom) AS box FROM (%s) l OFFSET 0) b) o, LATERAL (VALUES (ST_StartPoint(geom)),
        (ST_EndPoint(geom))) v(point) WHERE outermost AND abs(ST_X(point)) <= 1e12 AND abs(ST_Y(point)) <= 1e12 $sql$,
        lines);
END $$;
COMMENT ON FUNCTION streetgen._rim(text) IS
    'The ends of the outermost of some lines, which are given as a query of label and geom: what grows towards the '
    'rim of a reference is greatest there.';

CREATE OR REPLACE FUNCTION streetgen._way_from_degrees(place geometry) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_X(place) BETWEEN -180 AND 180 AND ST_Y(place) BETWEEN -90 AND 90
        THEN format('They look like degrees: ST_Transform(ST_SetSRID(geom, 4326), %s) makes metres of them.',
            ST_SRID(place)) END
    $$;
COMMENT ON FUNCTION streetgen._way_from_degrees(geometry) IS
    'What to do with coordinates that can be a longitude and a latitude, though their reference is metric; NULL for '
    'others.';

CREATE OR REPLACE FUNCTION streetgen._way_to_zone(place geometry) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT format('Make the model in the UTM zone of this place: EPSG:%s.', CASE WHEN ST_Y(place) < 0 THEN 32700
        ELSE 32600 END
        + least(60, floor((ST_X(place) + 180) / 6)::integer + 1))
    $$;
COMMENT ON FUNCTION streetgen._way_to_zone(geometry) IS 'Names the UTM zone of a place in longitude and latitude.';

CREATE OR REPLACE FUNCTION streetgen._check_scale(lines text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    place record;
    centre geometry;
    -- Metres of ground for 100 m of map.
    east float8;
    north float8;
    way_out text;
BEGIN
    -- A scale grows or shrinks towards the rim: the ends of the lines that touch it are looked at.
    FOR place IN SELECT * FROM streetgen._rim(lines) LOOP
        way_out := streetgen._way_from_degrees(place.point);
        BEGIN
            centre := ST_Transform(place.point, 4326);
            east := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 100, 0), 4326)::geography);
            north := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 0, 100), 4326)::geography);
        EXCEPTION WHEN internal_error THEN
            PERFORM streetgen._refuse('22023',
                format('%s, %s, lies where SRID %s is not defined', place.label, ST_AsText(place.point, 0),
                    ST_SRID(place.point)), detail => SQLERRM,
                hint => coalesce(way_out,
                    'Mend its coordinates, or make the model in the reference that they are in.'));
        END;
        IF NOT (east BETWEEN 99 AND 101 AND north BETWEEN 99 AND 101) THEN
            PERFORM streetgen._refuse('22023',
                format('the scale of SRID %s is more than 1 %% off at %s, %s', ST_SRID(place.point), place.label,
                    ST_AsText(place.point, 0)),
                detail => format('100 m of map are %s m east and %s m north on the ground.', round(east::numeric, 1),
                    round(north::numeric, 1)), hint => coalesce(way_out, streetgen._way_to_zone(centre)));
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_scale(text) IS
    'Raises 22023, naming the place, the scale and the UTM zone, or that its coordinates look like degrees, where the '
    'projection of lines, given as a query of label and geom, is more than 1 % off in scale or not defined.';

CREATE OR REPLACE FUNCTION streetgen._area_of_use(srid integer, OUT west float8, OUT south float8, OUT east float8,
    OUT north float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    zone text[];
BEGIN
    -- PostGIS asks the database of PROJ from 3.4 on.
    IF to_regprocedure('postgis_srs(text, text)') IS NOT NULL THEN
        EXECUTE 'SELECT ST_X(point_sw), ST_Y(point_sw), ST_X(point_ne), ST_Y(point_ne) FROM spatial_ref_sys s, '
            'postgis_srs(s.auth_name, s.auth_srid::text)
            WHERE s.srid = $1' INTO west, south, east, north USING srid;
    END IF;
    IF west IS NULL THEN
        zone := (SELECT regexp_match(proj4text, '\+proj=utm \+zone=(\d+)( \+south)?') FROM spatial_ref_sys s
            WHERE s.srid = _area_of_use.srid);
        SELECT a.* INTO west, south, east, north FROM (
            SELECT 6 * zone[1]::float8 - 186, CASE WHEN zone[2] IS NULL THEN 0 ELSE -80 END, 6 * zone[1]::float8 - 180,
                CASE WHEN zone[2] IS NULL THEN 84 ELSE 0 END
            WHERE zone IS NOT NULL
            -- National references whose scale holds far beyond their country: Lambert-93, British grid, Lambert 2008,
            -- LAEA of Europe.
            UNION ALL SELECT n.west, n.south, n.east, n.north
                FROM (VALUES (2154, -9.86, 41.15, 10.38, 51.56), (27700, -9, 49.75, 2.01, 61.01),
                (3812, 2.5, 49.5, 6.4, 51.51), (3035, -35.58, 24.6, 44.83, 84.73)) n(srid, west, south, east, north)
                    WHERE n.srid = _area_of_use.srid) a;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._area_of_use(integer) IS
    'The area that a spatial reference is made for, in degrees of longitude and latitude: of every reference that '
    'PROJ knows from PostGIS 3.4 on, before of UTM zones and some national ones. NULL where it is not known; east '
    'before west: across the antimeridian.';

CREATE OR REPLACE FUNCTION streetgen._outside(place geometry) RETURNS float8
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_Distance(ST_SetSRID(ST_MakePoint(longitude, latitude), 4326)::geography,
        ST_SetSRID(ST_MakePoint(least(greatest(longitude, west), east), least(greatest(latitude, south), north)),
            4326)::geography)
    FROM (SELECT west, CASE WHEN east < west THEN east + 360 ELSE east END AS east, south, north
        FROM streetgen._area_of_use(ST_SRID(place))) a,
    LATERAL (SELECT ST_Transform(place, 4326) AS at, (west + east) / 2 AS middle) t,
    -- Round the earth to where the area lies.
    LATERAL (SELECT middle + (ST_X(at) - middle) - 360 * round((ST_X(at) - middle) / 360) AS longitude,
        ST_Y(at) AS latitude) l
    $$;
COMMENT ON FUNCTION streetgen._outside(geometry) IS
    'How many metres a place lies outside the area that its spatial reference is made for; NULL where that is not '
    'known.';

CREATE OR REPLACE FUNCTION streetgen._misplaced(lines text)
    RETURNS TABLE(label text, place geometry, metres float8, remark text, way_out text)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    -- So far outside no model is meant; so near to the origin of the reference a sketch is, wherever that lies.
    far constant float8 := 100000;
    short record;
BEGIN
    -- Streets shorter than a metre are degrees.
    EXECUTE format('SELECT (array_agg(l.label::text ORDER BY l.label))[1] AS label, '
        '(array_agg(ST_Force2D(ST_StartPoint(l.geom)) ORDER BY l.label))[1] AS place
        FROM (%s) l HAVING avg(ST_Length(l.geom)) < 1', lines) INTO short;
    IF streetgen._way_from_degrees(short.place) IS NOT NULL THEN
        RETURN QUERY SELECT short.label, short.place, 0::float8, format('%s, %s, is shorter than a metre', short.label,
            ST_AsText(short.place, 4)),
            streetgen._way_from_degrees(short.place);
        RETURN;
    END IF;
    RETURN QUERY SELECT f.label, f.point, f.metres,
        format('%s, %s, lies %s km outside the area that SRID %s is made for', f.label, ST_AsText(f.point, 0),
            round(f.metres / 1000), ST_SRID(f.point)), coalesce(streetgen._way_from_degrees(f.point),
                streetgen._way_to_zone(ST_Transform(f.point, 4326)))
        FROM (SELECT r.label, r.point, streetgen._outside(r.point) AS metres FROM streetgen._rim(lines) r
              WHERE greatest(abs(ST_X(r.point)), abs(ST_Y(r.point))) > far ORDER BY 3 DESC NULLS LAST, 1 LIMIT 1) f
        WHERE f.metres > far;
EXCEPTION WHEN internal_error THEN
    -- The projection is not defined here: _check_scale says so.
    RETURN;
END $$;
COMMENT ON FUNCTION streetgen._misplaced(text) IS
    'The line, of some given as a query of label and geom, that looks most as if its coordinates belonged to another '
    'spatial reference: the first where they are shorter than a metre, in the mean, and lie where degrees would, else '
    'the one farthest outside the area of use, if over 100 km. A sketch within 100 km of the origin of the reference '
    'is none. No row where all look right.';

CREATE OR REPLACE FUNCTION streetgen._check_length(model name, lines text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    long record;
BEGIN
    EXECUTE format($sql$SELECT l.label, ST_Length(l.geom) AS length, s.value AS maximal FROM (%s) l, %I.setting s
        WHERE s.name = 'axis_length_maximal' AND ST_Length(l.geom) > s.value::float8 ORDER BY 2 DESC, 1 LIMIT 1$sql$,
            lines, model) INTO long;
    IF long.label IS NOT NULL THEN
        PERFORM streetgen._refuse('22023',
            format('%s is %s km long, over setting axis_length_maximal', long.label, round(long.length::numeric / 1000,
                1)), detail => format('The setting allows %s m.', long.maximal),
            hint => format('Mend its coordinates or cut it, or SELECT streetgen.set(%L, ''axis_length_maximal'', %L).',
                model, ceil(long.length)::bigint));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_length(name, text) IS
    'Raises 22023 for the longest of some lines, given as a query of label and geom, that is over setting '
    'axis_length_maximal of a model.';

CREATE OR REPLACE FUNCTION streetgen._warn_misplaced(lines text) RETURNS void
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    misplaced record;
BEGIN
    SELECT * INTO misplaced FROM streetgen._misplaced(lines);
    IF FOUND THEN
        RAISE WARNING '%', misplaced.remark USING HINT = misplaced.way_out;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._warn_misplaced(text) IS
    'A warning where some lines, given as a query of label and geom, are misplaced, about the first: for who types '
    'them.';

CREATE OR REPLACE FUNCTION streetgen._transformed(what text, geom geometry, srid integer) RETURNS geometry
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN ST_Transform(geom, srid);
EXCEPTION WHEN internal_error THEN
    PERFORM streetgen._refuse('22023', format('%s cannot be transformed from SRID %s to %s', what, ST_SRID(geom), srid),
        detail => SQLERRM, hint => 'Mend its coordinates or its SRID.');
END $$;
COMMENT ON FUNCTION streetgen._transformed(text, geometry, integer) IS
    'A geometry in another reference; 22023 saying what it is where the projection is not defined.';

CREATE OR REPLACE FUNCTION streetgen._check_extent(model name, extent geometry) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    expected constant integer := (SELECT srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    IF ST_SRID(extent) NOT IN (0, expected) THEN
        RAISE EXCEPTION 'the extent has SRID %, the model %', ST_SRID(extent), expected
            USING ERRCODE = '22023', HINT = 'ST_Transform makes it one of the model.';
    ELSIF EXISTS (SELECT FROM ST_DumpPoints(extent) p WHERE ST_X(geom) NOT BETWEEN -1e12 AND 1e12
        OR ST_Y(geom) NOT BETWEEN -1e12 AND 1e12) THEN
        RAISE EXCEPTION 'the extent has a coordinate that is not finite, or beyond 1e12 m'
            USING ERRCODE = '22023', HINT = 'ST_MakeEnvelope(xmin, ymin, xmax, ymax, srid) makes one of numbers.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_extent(name, geometry) IS
    'Raises 22023 for an extent of another SRID than the model, or without finite coordinates. NULL passes.';
