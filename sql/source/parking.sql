-- Cars that stand at streets of a source, and the rule that makes bays of that.

CREATE OR REPLACE FUNCTION streetgen._knows_source(model name, source text) RETURNS boolean
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN EXISTS (SELECT FROM axis a WHERE a.source = origin);
END $$;
COMMENT ON FUNCTION streetgen._knows_source(name, text) IS 'Has a model axes of a source?';

CREATE OR REPLACE FUNCTION streetgen._tell_parking(model name, source text, first boolean)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 4 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT 'sides of streets where cars stand beside the roadway, or none may', p.place, count(*),
            NULL::text[]
        FROM axis a, unnest(ARRAY[parking_left, parking_right]) said, split_part(said, '|', 1) p(place)
        WHERE a.source = origin AND p.place <> 'lane' GROUP BY p.place ORDER BY p.place;
    IF NOT first OR to_regclass('placement_rule') IS NULL OR 'object' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    -- A later import leaves a rule that somebody deleted since.
    RETURN QUERY WITH parked AS (
        SELECT count(*) AS axes FROM axis a WHERE a.source = origin AND (concat(kind_forward, '|', kind_backward)
            ~ 'parking' OR parking_left <> 'no' OR parking_right <> 'no')),
    rule AS (
        INSERT INTO placement_rule (type, along) SELECT 'parking_bay', 'lane' FROM parked
        WHERE axes > 0 AND NOT EXISTS (SELECT FROM placement_rule WHERE along = 'lane')
        RETURNING rule_id)
    SELECT format('rule %s makes parking bays where the source says that cars stand', rule_id), NULL::text, axes,
        NULL::text[] FROM rule, parked;
END $$;
COMMENT ON FUNCTION streetgen._tell_parking(name, text, boolean) IS
    'Tells how cars stand at the streets of a source, off their lanes. The first import gives a model that places '
    'objects the rule that makes bays of parking lanes and of places beside the roadway, unless it has one.';
