-- The driving side that an import settles, where a model leaves it open.

CREATE OR REPLACE FUNCTION streetgen._settle_driving_side(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
DECLARE
    found text;
    country text;
BEGIN
    IF streetgen._setting_text(model, 'driving_side') <> 'auto' THEN
        RETURN;
    END IF;
    found := streetgen._found_driving_side(model);
    IF found IS NULL THEN
        country := streetgen._left_hand_country_of(model);
    END IF;
    IF found IS NOT NULL OR country IS NOT NULL THEN
        PERFORM streetgen.set(model, 'driving_side', coalesce(found, 'left'));
    END IF;
    RETURN QUERY SELECT format('driving side %s, by %s', d.side, d.evidence), NULL::text,
        CASE d.side WHEN 'left' THEN d.count_left ELSE d.count_right END, NULL::text[]
        FROM streetgen.driving_side(model) d WHERE d.side IS NOT NULL;
    RETURN QUERY SELECT format('driving side left, as in %s; setting driving_side changes it', country), NULL::text,
        NULL::bigint, NULL::text[] WHERE country IS NOT NULL;
END $$;
COMMENT ON FUNCTION streetgen._settle_driving_side(name) IS
    'Sets driving_side, where it is auto, to what all evidence says, and where it says nothing to left in countries '
    'that drive on the left; reports which.';
