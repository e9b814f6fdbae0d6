-- Spatial references that streets can be built in: projected, in metres, true to scale.

CREATE OR REPLACE FUNCTION streetgen._check_srid(srid integer) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    reference record;
    utm constant text := 'Use a projection in metres that keeps its scale, such as the UTM zone of the place (EPSG 32600 + zone north, 32700 + zone south; Paris is 32631) or the national one (France 2154).';
BEGIN
    SELECT srtext, proj4text INTO reference FROM spatial_ref_sys s WHERE s.srid = _check_srid.srid;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'SRID % is unknown', coalesce(srid::text, 'NULL') USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.srtext LIKE 'GEOG%' OR reference.srtext LIKE 'GEOC%' OR reference.proj4text ~ '\+proj=(longlat|geocent)' THEN
        RAISE EXCEPTION 'SRID % is not projected: its units are degrees', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text !~ '\+units=m( |$)' THEN
        RAISE EXCEPTION 'SRID % is not in metres', srid USING ERRCODE = '22023', HINT = utm;
    ELSIF reference.proj4text ~ '\+proj=(merc|webmerc|eqc|mill|cea)( |$)' THEN
        RAISE EXCEPTION 'SRID % does not keep its scale: a 7 m street would be built 4.6 m wide in Paris', srid USING ERRCODE = '22023', HINT = utm;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_srid(integer) IS 'Raises 22023 for spatial references that are unknown, geographic, not in metres or more than 1 % off in scale.';

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
    FOR place IN EXECUTE format($sql$
WITH line AS MATERIALIZED (SELECT label, geom, Box3D(geom) AS box FROM (%s) l),
rim AS (SELECT min(ST_XMin(box)) AS west, max(ST_XMax(box)) AS east, min(ST_YMin(box)) AS south, max(ST_YMax(box)) AS north FROM line)
SELECT label, ST_Force2D(v.point) AS point FROM line, rim, LATERAL (VALUES (ST_StartPoint(geom)), (ST_EndPoint(geom))) v(point)
WHERE (ST_XMin(box) = west OR ST_XMax(box) = rim.east OR ST_YMin(box) = south OR ST_YMax(box) = rim.north)
    AND ST_X(v.point) BETWEEN -1e12 AND 1e12 AND ST_Y(v.point) BETWEEN -1e12 AND 1e12 $sql$, lines)
    LOOP
        way_out := CASE WHEN ST_X(place.point) BETWEEN -180 AND 180 AND ST_Y(place.point) BETWEEN -90 AND 90
            THEN format('They look like degrees: ST_Transform(ST_SetSRID(geom, 4326), %s) makes metres of them.', ST_SRID(place.point)) END;
        BEGIN
            centre := ST_Transform(place.point, 4326);
            east := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 100, 0), 4326)::geography);
            north := ST_Distance(centre::geography, ST_Transform(ST_Translate(place.point, 0, 100), 4326)::geography);
        EXCEPTION WHEN internal_error THEN
            RAISE EXCEPTION '%, %, lies where SRID % is not defined', place.label, ST_AsText(place.point, 0), ST_SRID(place.point) USING ERRCODE = '22023',
                DETAIL = SQLERRM, HINT = coalesce(way_out, 'Mend its coordinates, or make the model in the reference that they are in.');
        END;
        IF NOT (east BETWEEN 99 AND 101 AND north BETWEEN 99 AND 101) THEN
            RAISE EXCEPTION 'the scale of SRID % is more than 1 %% off at %, %', ST_SRID(place.point), place.label, ST_AsText(place.point, 0) USING ERRCODE = '22023',
                DETAIL = format('100 m of map are %s m east and %s m north on the ground.', round(east::numeric, 1), round(north::numeric, 1)),
                HINT = coalesce(way_out, format('Make the model in the UTM zone of this place: EPSG:%s.', CASE WHEN ST_Y(centre) < 0 THEN 32700 ELSE 32600 END + least(60, floor((ST_X(centre) + 180) / 6)::integer + 1)));
        END IF;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_scale(text) IS 'Raises 22023, naming the place, the scale and the UTM zone, or that its coordinates look like degrees, where the projection of lines, given as a query of label and geom, is more than 1 % off in scale or not defined.';
