-- Rules of check_model for sidewalks.

CREATE OR REPLACE FUNCTION streetgen._check_sidewalk(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'error', 'invalid surface', 'sidewalk', sidewalk_id, ST_Area(surface), surface FROM sidewalk
        WHERE NOT streetgen._surely_valid(surface::bytea) AND NOT ST_IsValid(surface)
    UNION ALL
    SELECT 'error', 'sidewalk without its kerb', 'sidewalk', s.sidewalk_id, ST_Area(s.surface), s.surface
        FROM sidewalk s WHERE NOT EXISTS (SELECT FROM kerb k
            WHERE (k.edge_id, k.side, k.part) = (s.edge_id, s.side, s.part)
                AND ST_DWithin(k.geom, coalesce(s.strip, s.surface), 0.001))
    UNION ALL
    SELECT 'notice', 'sidewalk beside a kerb of a median, splitter or island, m2', 'sidewalk', s.sidewalk_id,
            ST_Area(s.surface), s.surface
        FROM sidewalk s JOIN kerb k USING (edge_id, side, part)
        WHERE k.beside <> 'outer' AND ST_Area(s.surface) >= 1
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_sidewalk(name) IS
    'The rows of streetgen.check_model for sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalk', $part$
    SELECT 'sidewalks', round(coalesce(sum(ST_Area(surface)), 0)::numeric, 1), 'm2' FROM %1$I.sidewalk$part$) $$;
COMMENT ON FUNCTION streetgen._sidewalk_summary() IS 'What streetgen.summary counts of sidewalks.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('sidewalk without its kerb', 'the sidewalk is a leftover, or touches its kerb nowhere', '`generate`'),
    ('sidewalk beside a kerb of a median, splitter or island, m2',
        'a width that is stated, by hand or led about a corner makes a sidewalk where no city lies beside the street',
        'type 0 m in `sidewalk_editing` if nobody walks there; leave it where people cross in two steps');
