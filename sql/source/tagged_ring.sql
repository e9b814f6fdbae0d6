-- Rings that no source names, where an import names others.

CREATE OR REPLACE FUNCTION streetgen._settle_untagged_rings(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE ROWS 1 SET search_path = pg_catalog, public
    AS $$
DECLARE
    named bigint;
BEGIN
    IF streetgen._setting_text(model, 'roundabout_untagged') <> 'auto' THEN
        RETURN;
    END IF;
    SELECT count(*) INTO named FROM pg_temp._import i WHERE streetgen._names_ring(i.roundabout_tag);
    IF named > 0 THEN
        PERFORM streetgen.set(model, 'roundabout_untagged', 'offered');
        RETURN QUERY SELECT 'part of a roundabout by a tag; other rings are offered (setting roundabout_untagged)',
            NULL::text, named, NULL::text[];
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._settle_untagged_rings(name) IS
    'Sets roundabout_untagged, where it is auto and an import names rings, to offered; reports it.';
