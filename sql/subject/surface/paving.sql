-- The paving of the strips of each street.

CREATE OR REPLACE FUNCTION streetgen._make_paving_view(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    with_footways constant boolean := 'footway' = ANY (streetgen._subjects(model));
BEGIN
    PERFORM streetgen._use_model(model);
    EXECUTE streetgen._fill_template(streetgen._part('paving'), jsonb_build_object(
        'left', CASE WHEN with_footways THEN streetgen._fill_template(streetgen._part('paving_of_footway'),
            '{"side": "left"}') ELSE 'NULL::text' END,
        'right', CASE WHEN with_footways THEN streetgen._fill_template(streetgen._part('paving_of_footway'),
            '{"side": "right"}') ELSE 'NULL::text' END));
    COMMENT ON VIEW paving IS
        'What the strips of each street are paved with, in the words of the source; NULL: unknown';
    COMMENT ON COLUMN paving.edge_id IS 'the edge';
    COMMENT ON COLUMN paving.roadway IS 'its roadway, as axis.paved';
    COMMENT ON COLUMN paving.cycle_left IS 'its cycle lanes on the left, as axis.cycle_paved_left or the roadway';
    COMMENT ON COLUMN paving.cycle_right IS 'the same on the right';
    COMMENT ON COLUMN paving.sidewalk_left IS
        'its sidewalk on the left, as most of the footways that map it say, else as axis.sidewalk_paved_left';
    COMMENT ON COLUMN paving.sidewalk_right IS 'the same on the right';
END $$;
COMMENT ON FUNCTION streetgen._make_paving_view(name) IS 'Makes the view paving of a model, again and again.';

CREATE OR REPLACE FUNCTION streetgen._paving_kind(paved text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN paved ~ '^(sett|(unhewn_)?cobblestone|paving_stones|bricks?|stone)' THEN 'stone'
        WHEN paved ~ '^(unpaved|compacted|fine_gravel|gravel|pebblestone|ground|dirt|earth|sand|mud|grass|woodchips)'
        THEN 'unpaved' ELSE '' END;
COMMENT ON FUNCTION streetgen._paving_kind(text) IS
    'How ground that is paved so is drawn, a kind of streetgen.symbol_rule: stone, unpaved, or as any other.';
