-- The kind of junction that a place is: by rules, as the paper has it, or by a function of the user.

CREATE OR REPLACE FUNCTION streetgen.junction_kind(arms streetgen.junction_arm[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE
        WHEN count(*) > 1 AND bool_or(a.control = 'signals') THEN 'signals'
        WHEN bool_or(a.on_ring) OR bool_or(a.control = 'mini_roundabout') THEN 'roundabout'
        WHEN count(*) <= 1 THEN 'end'
        WHEN count(*) = 2 THEN 'continuation'
        WHEN bool_or(p.part = 'link') AND bool_or(p.part = 'highway') THEN 'ramp'
        WHEN bool_and(coalesce(a.highway_role IN ('highway', 'highway_link', 'link'), false)) THEN 'ramp'
        -- Without classes: fast one-way streets that meet at acute angles.
        WHEN bool_and(a.kind IS NULL) AND count(*) = 3 AND bool_and(a.lanes_in = 0 OR a.lanes_out = 0)
            AND max(a.speed) >= 80 AND streetgen._least_angle(array_agg(a.azimuth)) <= 30 THEN 'ramp'
        WHEN bool_or(a.control = 'stop') THEN 'stop'
        -- No paths cross: traffic comes by one arm, or leaves by one, or a street parts into its carriageways.
        WHEN count(*) FILTER (WHERE p.comes) = 1 OR count(*) = 3 AND count(*) FILTER (WHERE p.comes AND p.leaves) = 1
            AND count(*) FILTER (WHERE p.comes) = 2 AND count(*) FILTER (WHERE p.leaves) = 2
            AND streetgen._least_angle(array_agg(a.azimuth) FILTER (WHERE NOT (p.comes AND p.leaves))) < 90
            THEN 'fork'
        WHEN count(*) FILTER (WHERE p.leaves) = 1 THEN 'merge'
        WHEN bool_or(a.control = 'yield') OR min(p.coming) <> max(p.coming) OR min(a.importance) <= 3 THEN 'priority'
        ELSE 'right_before_left' END
    FROM unnest(arms) a CROSS JOIN LATERAL (SELECT streetgen._ramp_part(a.kind, a.highway_role, a.speed) AS part,
        CASE WHEN a.lanes_in IS DISTINCT FROM 0 THEN a.importance END AS coming,
        a.lanes_in IS DISTINCT FROM 0 AS comes, a.lanes_out IS DISTINCT FROM 0 AS leaves) p $$;
COMMENT ON FUNCTION streetgen.junction_kind(streetgen.junction_arm[]) IS
    'The kind of a junction from its arms, the first that holds of: signals, roundabout (an arm on a ring, or a '
    'mini-roundabout), end (one arm), continuation (two arms), ramp (by the roles of classes: a link at a '
    'highway or at a fast_road of 60 km/h and more, or highways and links alone; where '
    'no class is known three one-way arms, one of 80 km/h or more, two of them within 30 degrees), stop, fork (traffic '
    'comes by one arm, or a street parts into its carriageways), merge (traffic leaves by one arm), priority (a '
    'yield sign, traffic that comes by arms of different importance, or an arm of importance 3 or better), '
    'right_before_left. No arms: end. An argument '
    'that is NULL is unknown, and gives end; an arm may leave out all that is unknown.';

CREATE OR REPLACE FUNCTION streetgen._least_angle(azimuths float8[]) RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT min(degrees(acos(greatest(-1, least(1, cos(radians(a - b)))))))
    FROM unnest(azimuths) WITH ORDINALITY u(a, i), unnest(azimuths) WITH ORDINALITY v(b, j) WHERE i < j $$;
COMMENT ON FUNCTION streetgen._least_angle(float8[]) IS
    'The least angle between two of some azimuths, degrees; NULL where there are not two.';

CREATE OR REPLACE FUNCTION streetgen._classified(model name, classifier text, junction bigint,
    arms streetgen.junction_arm[]) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    called constant text := streetgen._called_function(model, 'classifier', classifier);
    kind text;
BEGIN
    BEGIN
        EXECUTE format('SELECT %s($1)', called) INTO kind USING arms;
    EXCEPTION WHEN OTHERS THEN
        PERFORM streetgen._refuse(SQLSTATE, format('classifier %s fails at junction %s: %s', called, junction, SQLERRM),
            hint => 'Mend the function, or set classifier to streetgen.junction_kind.');
    END;
    IF kind IS NULL OR kind NOT IN ('ramp', 'fork', 'merge', 'signals', 'stop', 'priority', 'right_before_left',
        'roundabout', 'continuation', 'end') THEN
        PERFORM streetgen._refuse('22023',
            format('classifier %s gives "%s" for junction %s', called, coalesce(kind, 'NULL'), junction),
            hint => 'The kinds are ramp, fork, merge, signals, stop, priority, right_before_left, '
                'roundabout, continuation and end.');
    END IF;
    RETURN kind;
END $$;
COMMENT ON FUNCTION streetgen._classified(name, text, bigint, streetgen.junction_arm[]) IS
    'The kind of a junction by a function of the user, as _called_function has it. One that gives another word: '
    '22023; what the function raises comes with its SQLSTATE, naming function and junction.';

CREATE OR REPLACE FUNCTION streetgen._paper_kind(arms streetgen.junction_arm[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    SELECT CASE WHEN bool_or(a.on_ring) THEN 'roundabout' WHEN count(*) <= 1 THEN 'end'
        WHEN count(*) = 2 THEN 'continuation'
        WHEN bool_or(a.highway_role IN ('highway', 'fast_road', 'highway_link')) THEN 'ramp' ELSE 'signals' END
    FROM unnest(arms) a $$;
COMMENT ON FUNCTION streetgen._paper_kind(streetgen.junction_arm[]) IS
    'The kind of a junction as Wilkie, Sewall and Lin have it: a ramp where a highway takes part, else signals.';
