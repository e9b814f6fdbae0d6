-- Rules of check_model for people on foot, and rules of actors.

CREATE OR REPLACE FUNCTION streetgen._check_driving(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
DECLARE
    finding streetgen.finding;
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'interconnection' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    FOR finding IN SELECT 'warning', 'walker without its place', 'walker', w.walker_id, 0, NULL::geometry
        FROM walker w LEFT JOIN walker_place p USING (walker_id) WHERE p.walker_id IS NULL
    UNION ALL SELECT 'notice', 'rule of actors without its streets', 'actor_rule', r, 0, NULL
        FROM streetgen._idle_actor_rules(model) r
    LOOP
        RETURN NEXT finding;
    END LOOP;
END $$;
COMMENT ON FUNCTION streetgen._check_driving(name) IS
    'What check_model finds of people on foot, and of rules of actors.';

INSERT INTO streetgen.check_rule (rule, meaning, hint) VALUES
    ('walker without its place', 'the street, or its sidewalk on that side, is not there: view walker_place lacks it',
        'move the walker to a street with a sidewalk, or delete it'),
    ('rule of actors without its streets', 'no street has the class, or no lane the kind, that it names',
        'write a kind of table axis or of table lane, or delete the rule');
