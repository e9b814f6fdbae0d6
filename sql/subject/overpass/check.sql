-- Rules of check_model for overpasses.

CREATE OR REPLACE FUNCTION streetgen._check_overpass(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    FOR finding IN
    SELECT 'warning', 'overpass override without its crossing', 'overpass_override', o.overpass_override_id,
        o.clearance, o.geom FROM overpass_override o
        WHERE NOT EXISTS (SELECT FROM overpass p JOIN edge a ON a.edge_id = p.edge_above
            JOIN edge b ON b.edge_id = p.edge_below
            WHERE (a.axis_id, b.axis_id) = (o.axis_above, o.axis_below) AND p.method = 'by_hand'
                AND ST_DWithin(p.geom, o.geom, 20))
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_overpass(name) IS
    'The rows of streetgen.check_model for overpasses.';

CREATE OR REPLACE FUNCTION streetgen._overpass_summary()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (19, 'overpass', $part$
    (SELECT 'overpasses by ' || method, count(*), NULL FROM %1$I.overpass GROUP BY method ORDER BY method)$part$) $$;
COMMENT ON FUNCTION streetgen._overpass_summary() IS 'What streetgen.summary counts of overpasses.';

CREATE OR REPLACE FUNCTION streetgen._overpass_marked_by_hand() RETURNS TABLE(relation name, edges text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('overpass'::name, 'e.edge_id IN (($1).edge_above, ($1).edge_below)') $$;
COMMENT ON FUNCTION streetgen._overpass_marked_by_hand() IS
    'The edges that a change of overpasses by hand leaves stale.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('overpass override without its crossing',
        'the two axes do not cross within 20 m of it, or a younger override is nearer',
        'move or delete the override');
