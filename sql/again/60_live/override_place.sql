-- Where an override lies beside an axis.

CREATE OR REPLACE FUNCTION streetgen._remap_part_of_axis(relation text, line geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT CASE relation WHEN 'transition_override' THEN ST_Collect(ST_StartPoint(line), ST_EndPoint(line))
        ELSE line END $$;
COMMENT ON FUNCTION streetgen._remap_part_of_axis(text, geometry) IS
    'What of an axis the override of a relation lies at: its ends for a transition, else all of it.';

CREATE OR REPLACE FUNCTION streetgen._remap_lies_beside(line geometry, place geometry) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT at > 0 AND at < 1 FROM (SELECT ST_LineLocatePoint(line, place) AS at) l $$;
COMMENT ON FUNCTION streetgen._remap_lies_beside(geometry, geometry) IS
    'Whether a place lies beside a line and not beyond its ends.';

CREATE OR REPLACE FUNCTION streetgen._remap_comes_by(relation text, before geometry, after geometry, place geometry,
    reach float8) RETURNS boolean
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT ST_DWithin(streetgen._remap_part_of_axis(relation, before), place, reach) IS NOT TRUE
        OR relation IN ('lane_override', 'section_limit_override', 'kerb_point_override', 'sidewalk_override',
            'control_point', 'junction_override', 'controller_override', 'road_override', 'height_override')
            AND streetgen._remap_lies_beside(after, place) AND NOT streetgen._remap_lies_beside(before, place)
    $$;
COMMENT ON FUNCTION streetgen._remap_comes_by(text, geometry, geometry, geometry, float8) IS
    'Whether an axis that lies at the place of an override did not before (NULL: was not there), or ended beside it.';
