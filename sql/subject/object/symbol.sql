-- The drawing of objects.
CREATE OR REPLACE FUNCTION streetgen._object_symbol(place geometry, angle float8, symbol text, size float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT CASE WHEN ST_Dimension(place) = 1 THEN ST_Buffer(place, size / 2, 'endcap=flat')
        WHEN symbol IN ('circle', 'tree') THEN ST_Buffer(place, size / 2)
        ELSE ST_SetSRID(ST_Translate(ST_Rotate(ST_Scale(CASE symbol
                WHEN 'rectangle' THEN 'POLYGON((-1 -0.4,1 -0.4,1 0.4,-1 0.4,-1 -0.4))'
                WHEN 'square' THEN 'POLYGON((-1 -1,1 -1,1 1,-1 1,-1 -1))'
                WHEN 'triangle' THEN 'POLYGON((-0.9 -0.7,0.9 -0.7,0 1,-0.9 -0.7))'
                WHEN 'arrow' THEN 'POLYGON((-0.15 -1,0.15 -1,0.15 0.2,0.5 0.2,0 1,-0.5 0.2,-0.15 0.2,-0.15 -1))'
                WHEN 'star' THEN 'POLYGON((0 1,0.25 0.25,1 0,0.25 -0.25,0 -1,-0.25 -0.25,-1 0,-0.25 0.25,0 1))'
                ELSE 'POLYGON((0 1,1 0,0 -1,-1 0,0 1))' END::geometry, size / 2, size / 2), -radians(angle)),
            ST_X(place), ST_Y(place)), ST_SRID(place)) END $$;
COMMENT ON FUNCTION streetgen._object_symbol(geometry, float8, text, float8) IS
    'The symbol of an object of a size (m), turned to its angle (degrees clockwise from the north); a stretch as '
    'wide as its size.';
