-- The terms of a ring's score, each from 0 to 1, and the score of all three.

CREATE OR REPLACE FUNCTION streetgen.roundabout_shape(on_circle float8, compactness float8) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN 0.3 * least(greatest(on_circle, 0), 1) + 0.7 * least(greatest((compactness - 0.8) / 0.1, 0), 1);
COMMENT ON FUNCTION streetgen.roundabout_shape(float8, float8) IS
    'How round a ring is, 0 to 1: three tenths of the share of the ring on its circle (within a tenth of its radius), '
    'and seven tenths of its compactness (area against the circle of the same length, Polsby and Popper), 0 up to '
    '0.8, all from 0.9 on. A square has 0.79, so that corners of blocks count nothing; an oval twice as long as wide '
    'has 0.84, an octagon 0.95. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.roundabout_network(one_way float8, against float8, arm_nodes integer,
    single_arm float8, inside integer) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN least(greatest(0.75 + 0.25 * one_way - against - 2 * one_way * greatest(1 - one_way - against, 0), 0), 1)
        * (0.2 * least(greatest(arm_nodes, 0), 3) + 0.4 * least(greatest(arm_nodes - 3, 0), 3) / 3)
        * (0.6 + 0.4 * least(greatest(single_arm, 0), 1)) * CASE WHEN inside > 0 THEN 0.7 ELSE 1 END;
COMMENT ON FUNCTION streetgen.roundabout_network(float8, float8, integer, float8, integer) IS
    'How much the network about a ring is that of a roundabout, 0 to 1. One-way traffic all round (one_way, the share '
    'of the ring) raises it by up to a quarter; such traffic on a part of the ring, or the other way (against), lowers '
    'it. Nodes with arms (arm_nodes) count up to six, the first three more; nodes with more than one arm '
    '(1 - single_arm, a share) and what lies inside (a number) lower it. NULL for NULL.';

CREATE OR REPLACE FUNCTION streetgen.roundabout_name(names text[], patterns text[], folding text DEFAULT 'plain')
    RETURNS float8
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    -- Nobody calls a place so at greater length.
    longest constant integer := 200;
    named constant text[] := ARRAY(SELECT left(n, longest) FROM unnest(names) n WHERE n <> '');
    matching bigint;
BEGIN
    IF named = '{}' THEN
        RETURN 0.5;
    END IF;
    SELECT count(*) INTO matching FROM unnest(named) n WHERE CASE folding WHEN 'plain' THEN n ~* ANY (patterns)
        ELSE EXISTS (SELECT FROM unnest(patterns) p WHERE streetgen._names_roundabout(n, p, folding)) END;
    RETURN CASE WHEN matching > 0.4 * cardinality(named) THEN 1
        WHEN cardinality(named) = cardinality(names) AND named[1] = ALL (named) THEN 0.7
        ELSE 0.5 * (SELECT max(times) FROM (SELECT count(*) AS times FROM unnest(named) n GROUP BY n) t)
            / cardinality(names) END;
END $$;
COMMENT ON FUNCTION streetgen.roundabout_name(text[], text[], text) IS
    'How much the names of a ring''s edges are those of a roundabout, 0 to 1: 1 where a pattern (regular expression, '
    'upper and lower case alike) fits over 0.4 of the names, as the paper has it; 0.7 where all edges share one name; '
    '0.5 where none has one; else half of the share of the most frequent name. folding: plain, unaccent (accents are '
    'left out) or fuzzy (words nearly alike count too); an extension that this needs and that is missing: 0A000 with '
    'the line that makes it. Of a name the first 200 letters count. A pattern that is no regular expression: 2201B. '
    'NULL for NULL. StreetGen paper, 2.8.';

CREATE OR REPLACE FUNCTION streetgen._names_roundabout(given text, pattern text, folding text) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    folded text;
BEGIN
    IF given ~* pattern OR folding = 'plain' THEN
        RETURN given ~* pattern;
    END IF;
    folded := streetgen._without_accents(given, 'roundabout_names');
    IF folded ~* pattern OR folding = 'unaccent' THEN
        RETURN folded ~* pattern;
    END IF;
    RETURN streetgen._trigrams_alike('word_similarity', regexp_replace(pattern, '\\[a-zA-Z]|[^[:alpha:] ]', '', 'g'),
        folded, 'roundabout_names') > 0.6;
END $$;
COMMENT ON FUNCTION streetgen._names_roundabout(text, text, text) IS
    'Does a pattern fit a name, with accents folded or words nearly alike as folding says?';

CREATE OR REPLACE FUNCTION streetgen.roundabout_score(shape float8, name float8, network float8, weights float8[])
    RETURNS float8
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    IF cardinality(weights) <> 3 OR NOT (0 <= ALL (weights)) OR 'Infinity' = ANY (weights) OR 'NaN' = ANY (weights)
        OR NOT (weights[1] + weights[2] + weights[3] > 0) THEN
        RAISE EXCEPTION 'weights are %, expected three of 0 and more, not all 0', weights USING ERRCODE = '22023',
            HINT = 'Settings roundabout_weight_shape, roundabout_weight_name and roundabout_weight_network are those '
                'of a model.';
    END IF;
    RETURN (weights[1] * shape + weights[2] * name + weights[3] * network) / (weights[1] + weights[2] + weights[3]);
END $$;
COMMENT ON FUNCTION streetgen.roundabout_score(float8, float8, float8, float8[]) IS
    'The score of a ring from its three terms, each 0 to 1: their mean with the weights of shape, name and network. '
    'Setting roundabout_score names another function of this signature in its place. Weights that are not three of 0 '
    'and more, or are all 0: 22023. NULL for NULL. StreetGen paper, 2.8, which combines terms and gives no weights.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_score(model name, given text, shape float8, name float8,
    network float8, weights float8[], centre geometry) RETURNS float8
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    score float8;
    called text;
BEGIN
    IF given = 'streetgen.roundabout_score' THEN
        RETURN streetgen.roundabout_score(shape, name, network, weights);
    END IF;
    called := streetgen._called_function(model, 'roundabout_score', given);
    BEGIN
        EXECUTE format('SELECT %s($1, $2, $3, $4)', called) INTO score USING shape, name, network, weights;
    EXCEPTION WHEN data_exception OR raise_exception OR syntax_error_or_access_rule_violation THEN
        PERFORM streetgen._refuse(SQLSTATE, format('score function %s failed: %s', given, SQLERRM),
            detail => format('At the ring about %s.', ST_AsText(centre, 1)),
            hint => 'Mend the function, or set roundabout_score to streetgen.roundabout_score.');
    END;
    IF (score BETWEEN 0 AND 1) IS NOT TRUE THEN
        PERFORM streetgen._refuse('22023',
            format('score function %s gave %s, expected 0 to 1', given, coalesce(score::text, 'NULL')),
            detail => format('At the ring about %s.', ST_AsText(centre, 1)),
            hint => 'Mend the function, or set roundabout_score to streetgen.roundabout_score.');
    END IF;
    RETURN score;
END $$;
COMMENT ON FUNCTION streetgen._roundabout_score(name, text, float8, float8, float8, float8[], geometry) IS
    'The score of a ring by the function that setting roundabout_score names; centre is for messages. One that may '
    'not be called, as _called_function has it; a result beyond 0 to 1: 22023; what it raises, with the place.';
