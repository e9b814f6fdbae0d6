-- Streets on a roundabout are called by these patterns, until somebody says otherwise.

CREATE OR REPLACE FUNCTION streetgen._default_roundabout_pattern() RETURNS TABLE(pattern text, language text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 16 SET search_path = pg_catalog
    AS $$ VALUES ('\mplace\M', 'fr'), ('\mpl\M', 'fr'), ('\mrpt\M', 'fr'), ('\mrond[- ]?point\M', 'fr'),
        ('\mgiratoire\M', 'fr'), ('\mroundabout\M', 'en'), ('\mcircus\M', 'en'), ('\mkreisel\M', 'de'),
        ('\mkreisverkehr\M', 'de'), ('\mrotunda\M', 'pt'), ('\mpra[cç]a\M', 'pt'), ('\mglorieta\M', 'es'),
        ('\mrotonda\M', 'es'), ('\mrotatoria\M', 'it'), ('\mrondo\M', 'pl'), ('\mrotonde\M', 'nl') $$;
COMMENT ON FUNCTION streetgen._default_roundabout_pattern() IS
    'The patterns of a new model''s table roundabout_pattern, by language.';
