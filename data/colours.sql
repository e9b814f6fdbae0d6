-- pg_temp.colour: the colour that streetgen.symbol_rule gives a layer, for drawings that are no map.
CREATE FUNCTION pg_temp.colour(layer text, kind text DEFAULT '', theme text DEFAULT 'construction') RETURNS text LANGUAGE plpgsql AS $$
#variable_conflict use_column
DECLARE
    colour text;
BEGIN
    SELECT coalesce(fill, line) INTO STRICT colour FROM streetgen.symbol_rule r
    WHERE (r.theme, r.layer, r.kind) = (colour.theme, colour.layer, colour.kind) AND marker IS NULL ORDER BY from_scale, place DESC LIMIT 1;
    RETURN colour;
END $$;
