-- The radius that corners have here, learnt from those that arcs of observed kerbs answer.

CREATE OR REPLACE FUNCTION streetgen._radius_samples(model name) RETURNS SETOF streetgen.radius_sample
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    model_name constant name := model;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH answered AS MATERIALIZED (SELECT * FROM streetgen._observed_corners(model_name, NULL))
    SELECT c.corner_id, c.radius, rank() OVER (PARTITION BY c.corner_id ORDER BY u.importance, u.width DESC) = 1,
        u.width, u.speed, u.importance, u.lane_count, a.kind
    FROM answered c JOIN axis_used u ON u.axis_id IN (c.axis_a, c.axis_b) JOIN axis a USING (axis_id);
END $$;
COMMENT ON FUNCTION streetgen._radius_samples(name) IS
    'The axes of each corner that an observed arc answers, with its radius (metres) and what a function of setting '
    'radius_function takes. major: as setting radius_rule has it; of two alike both are.';

CREATE OR REPLACE FUNCTION streetgen._radius_features(kinds text[], width float8, speed float8, importance integer,
    lane_count integer, kind text) RETURNS float8[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN ARRAY[width, speed, importance, lane_count, coalesce(array_position(kinds, kind), 0)];
COMMENT ON FUNCTION streetgen._radius_features(text[], float8, float8, integer, integer, text) IS
    'What streetgen.forest_value takes of an axis: a kind is its place among those that samples had, others are 0.';

CREATE OR REPLACE FUNCTION streetgen._radius_forest(samples streetgen.radius_sample[], OUT kinds text[],
    OUT forest float8[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    WITH sample AS MATERIALIZED (
        -- A corner of two that are alike counts once.
        SELECT DISTINCT ON (corner_id) *, row_number() OVER () AS n FROM unnest(samples) WHERE major
        ORDER BY corner_id, speed, lane_count, kind COLLATE "C"),
    kind AS (
        SELECT coalesce(array_agg(kind ORDER BY mean, kind COLLATE "C"), '{}') AS kinds FROM (
            SELECT kind, avg(observed) AS mean FROM sample WHERE kind IS NOT NULL GROUP BY kind) k)
    SELECT k.kinds, streetgen._grow_forest(ARRAY(SELECT v FROM sample, unnest(streetgen._radius_features(k.kinds,
        width, speed, importance, lane_count, kind)) WITH ORDINALITY f(v, place) ORDER BY n, place),
        ARRAY(SELECT observed FROM sample ORDER BY n))
    FROM kind k $$;
COMMENT ON FUNCTION streetgen._radius_forest(streetgen.radius_sample[]) IS
    'The forest that grows of the major axes of corners, and the kinds that these have, in the order of their radii, '
    'as streetgen._radius_features takes them.';

CREATE OR REPLACE FUNCTION streetgen._tried_radii(samples streetgen.radius_sample[], rule text, round integer)
    RETURNS TABLE(corner_id bigint, fold bigint, observed float8, by_forest float8, by_constant float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1000 SET search_path = pg_catalog
    AS $$
    WITH sample AS MATERIALIZED (
        SELECT s AS sample, s.*, dense_rank() OVER (ORDER BY hashint8extended(corner_id, round), corner_id) % 5 AS fold
        FROM unnest(samples) s),
    grown AS MATERIALIZED (
        SELECT f.fold, m.median, g.* FROM generate_series(0, 4) f(fold), LATERAL (
            SELECT array_agg(sample) AS others FROM sample WHERE fold <> f.fold) o, LATERAL (
            SELECT percentile_disc(0.5) WITHIN GROUP (ORDER BY observed) AS median
            FROM (SELECT DISTINCT ON (corner_id) observed FROM unnest(o.others)) c) m,
            LATERAL streetgen._radius_forest(o.others) g)
    SELECT corner_id, fold, observed, CASE rule WHEN 'max' THEN max(value) WHEN 'mean' THEN avg(value)
        WHEN 'major' THEN min(value) FILTER (WHERE major) ELSE min(value) END, median
    FROM sample JOIN grown USING (fold), LATERAL streetgen.forest_value(forest, streetgen._radius_features(kinds,
        width, speed, importance, lane_count, kind)) value
    GROUP BY corner_id, fold, observed, median ORDER BY corner_id $$;
COMMENT ON FUNCTION streetgen._tried_radii(streetgen.radius_sample[], text, integer) IS
    'The radius of each corner of some samples, and what a forest and the median of the other four fifths of the '
    'corners say of it, the forest by setting radius_rule: five-fold cross-validation. Each round deals the corners '
    'otherwise.';

CREATE OR REPLACE FUNCTION streetgen._write_radius_function(model name, samples streetgen.radius_sample[]) RETURNS text
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    written constant text := format('%I.trained_radius', model);
    grown record;
BEGIN
    SELECT quote_literal(g.forest) AS forest, quote_literal(g.kinds) AS kinds INTO grown
        FROM streetgen._radius_forest(samples) g;
    -- A kind is what an editor writes: no quotes in the text of the function would hold it.
    EXECUTE streetgen._part_in('trained_radius', model, jsonb_build_object('function', written,
        'body', quote_literal(streetgen._part_in('trained_radius_body', model, to_jsonb(grown)))));
    EXECUTE format('ALTER FUNCTION %1$s(float8, float8, integer, integer, text) OWNER TO %2$s', written,
        (SELECT nspowner::regrole FROM pg_namespace WHERE nspname = model));
    RETURN written;
END $$;
COMMENT ON FUNCTION streetgen._write_radius_function(name, streetgen.radius_sample[]) IS
    'Writes what samples tell as function trained_radius of a model, which its owner owns, and gives its name.';

CREATE OR REPLACE FUNCTION streetgen.train_radius(model name)
    RETURNS TABLE(function text, corners bigint, mean_error float8, median_error float8, mean_error_constant float8,
        median_error_constant float8)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    least constant integer := 10;
    answered bigint;
    samples streetgen.radius_sample[];
    written text;
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._require_subject(model, 'fit');
    SELECT count(DISTINCT s.corner_id), array_agg(s) INTO answered, samples FROM streetgen._radius_samples(model) s;
    IF answered < least THEN
        RAISE EXCEPTION 'arcs of observed kerbs answer % corners, at least % are needed', answered, least
            USING ERRCODE = '22023', HINT = 'streetgen.observe kerbs as lines or areas, and fit widths before.';
    END IF;
    written := streetgen._write_radius_function(model, samples);
    RETURN QUERY SELECT written, answered, avg(abs(by_forest - observed)),
        percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(by_forest - observed)), avg(abs(by_constant - observed)),
        percentile_cont(0.5) WITHIN GROUP (ORDER BY abs(by_constant - observed))
    FROM streetgen._tried_radii(samples, (SELECT s.value FROM streetgen.setting(model) s
        WHERE s.name = 'radius_rule'), 1);
END $$;
COMMENT ON FUNCTION streetgen.train_radius(name) IS
    'Learns the radius of corners from those that arcs of observed kerbs answer, and writes it as function '
    'trained_radius of the model, which setting radius_function may name; no street changes before. An arc that turns '
    'by 45 to 135 degrees answers a corner where its middle lies within 3 m of the arc of the corner and both turn the '
    'same way. What is learnt is a regression forest of width, speed, importance, lane count and kind of the major '
    'street of a corner, as setting radius_rule has it: with that rule the function says most. Where these tell '
    'nothing it is one radius, the median. The function is immutable and holds the forest: it stays when observations '
    'go, in a dump too, and goes with the model. Gives a row: the name of the function, how many corners it is learnt '
    'from, and mean and median of the error (metres) of a forest by the rule of the model, and of a constant, the '
    'median, both of four fifths of the corners and asked for the others. StreetGen paper, section 3.1. Fewer than 10 '
    'corners: 22023; without the subject: 55000; needs the rights of the owner (42501).';
