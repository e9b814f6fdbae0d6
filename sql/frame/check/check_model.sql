-- Quick answers of the core: most of what is checked is sound, and only the rest is worth PostGIS' own judgement.
CREATE OR REPLACE FUNCTION streetgen._surely_valid(surface bytea) RETURNS boolean
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_surely_valid';
COMMENT ON FUNCTION streetgen._surely_valid(bytea) IS
    'Is a MULTIPOLYGON (EWKB) one ring that keeps clear of itself? One that is not may be valid.';

CREATE OR REPLACE FUNCTION streetgen._share_ground(a bytea, b bytea) RETURNS boolean
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_share_ground';
COMMENT ON FUNCTION streetgen._share_ground(bytea, bytea) IS
    'Do two MULTIPOLYGONs (EWKB) share ground deeper than a micrometre? True also of what the core does not take.';

CREATE OR REPLACE FUNCTION streetgen._lies_on(line bytea, surface bytea) RETURNS boolean
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_lies_on';
COMMENT ON FUNCTION streetgen._lies_on(bytea, bytea) IS
    'Does a line (EWKB) surely lie on a MULTIPOLYGON, within a micrometre?';

CREATE OR REPLACE FUNCTION streetgen._lies_on(line bytea, surface bytea, a bytea, b bytea) RETURNS boolean
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 50 AS 'MODULE_PATHNAME', 'streetgen_lies_on';
COMMENT ON FUNCTION streetgen._lies_on(bytea, bytea, bytea, bytea) IS
    'Does a line (EWKB) surely lie on one or another of three MULTIPOLYGONs, within a micrometre?';

CREATE OR REPLACE FUNCTION streetgen._tell_check(subject text, step integer, steps integer) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM set_config('application_name', format('streetgen: check, %s, step %s of %s', subject, step, steps), true);
    -- A check that is over at once tells nothing.
    IF clock_timestamp() > statement_timestamp() + interval '1 second' THEN
        RAISE NOTICE 'check: %, step % of %', subject, step, steps;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._tell_check(text, integer, integer) IS
    'Says how far a check is, in pg_stat_activity and, after a second, to the client.';

CREATE OR REPLACE FUNCTION streetgen.check_model(model name)
    RETURNS TABLE(severity text, rule text, relation text, id bigint, measure float8, geom geometry)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    -- Whatever happens, the name of the session comes back.
    SET application_name = 'streetgen: check'
    AS $$
DECLARE
    subjects text[];
    subject text;
BEGIN
    PERFORM streetgen._require_reader(model);
    subjects := ARRAY(SELECT s FROM unnest(streetgen._rooms_of(model)) WITH ORDINALITY u(s, n)
        WHERE to_regprocedure(format('streetgen._check_%s(name)', s)) IS NOT NULL ORDER BY n);
    FOREACH subject IN ARRAY subjects LOOP
        PERFORM streetgen._tell_check(subject, array_position(subjects, subject), cardinality(subjects));
        -- Each of these functions has a loop, so that a query that fails is not shown whole.
        RETURN QUERY EXECUTE format('SELECT * FROM streetgen._check_%s($1)', subject) USING model;
    END LOOP;
EXCEPTION WHEN internal_error THEN
    -- PostGIS' name for an overlay that was interrupted. The interrupt still waits, and is taken before RAISE: the call
    -- ends as 57014.
    RAISE;
END $$;
COMMENT ON FUNCTION streetgen.check_model(name) IS
    'A row for everything broken (error), stale (warning) or noteworthy (notice) in a model. No row of severity '
    'error: the model is sound. measure is in the unit that the rule names (m, m2), else a number or 0. An unknown '
    'model: 3F000; a call that is cancelled: 57014.';
