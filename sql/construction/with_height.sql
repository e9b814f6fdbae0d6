-- Heights of an axis, given to what lies beside it.

-- Height for a line or point computed in the plane: that of the nearest place of its axis.
CREATE OR REPLACE FUNCTION streetgen._with_height(place geometry, axis geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN count(*) = 1 THEN (array_agg(point))[1] ELSE ST_MakeLine(point ORDER BY path) END
    FROM (SELECT d.path, ST_SetSRID(ST_MakePoint(ST_X(d.geom), ST_Y(d.geom),
                   ST_Z(ST_LineInterpolatePoint(axis, ST_LineLocatePoint(ST_Force2D(axis), d.geom)))), ST_SRID(axis))
                       AS point
          FROM ST_DumpPoints(place) d) p
    $$;
COMMENT ON FUNCTION streetgen._with_height(geometry, geometry) IS
    'A POINT or LINESTRING of the plane with the heights of the nearest places of an axis.';
