-- The settings of ramps.

CREATE OR REPLACE FUNCTION streetgen._ramp_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    ('ramp_tangent', '15', 'm', 'a ramp runs so far towards the lane that it joins before it bends into it', 0, 1000,
        NULL::text[]),
    ('merging_length', '60', 'm', 'a merging lane keeps its width so far, then it tapers; 0: no merging lanes', 0, 1000,
        NULL) $$;
COMMENT ON FUNCTION streetgen._ramp_setting() IS 'The settings of ramps, with their defaults and ranges.';
