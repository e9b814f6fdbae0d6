-- Rules of check_model for kerbs.

CREATE OR REPLACE FUNCTION streetgen._check_kerb(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'kerb does not end where another one begins', 'kerb', k.kerb_id, 0, ST_EndPoint(k.geom)
        -- OFFSET: each looks up what lies at its end; a join by level would pair all with all.
        FROM kerb k WHERE NOT EXISTS (SELECT FROM kerb n WHERE n.level = k.level
            AND n.geom && ST_Expand(ST_EndPoint(k.geom), 1e-5)
            AND ST_DWithin(ST_StartPoint(n.geom), ST_EndPoint(k.geom), 1e-5) OFFSET 0)
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_kerb(name) IS
    'The rows of streetgen.check_model for kerbs.';

CREATE OR REPLACE FUNCTION streetgen._kerb_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (18, 'kerb', $part$
    SELECT 'kerbs, length', round((coalesce(sum(ST_Length(geom)), 0) / 1000)::numeric, 3), 'km'
        FROM %1$I.kerb$part$) $$;
COMMENT ON FUNCTION streetgen._kerb_summary() IS 'What streetgen.summary counts of kerbs.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('kerb does not end where another one begins',
        'the border of the roadway has a gap, so that blocks beside it lack ground',
        'generate the axes beside it again, and report the place');
