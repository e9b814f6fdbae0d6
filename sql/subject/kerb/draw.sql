-- Drawings of kerbs, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._kerb_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (12, 'kerb', $part$
    SELECT 0.5 + level * 10, 'kerb', false, surface, kerb_id FROM %1$I.kerb, size WHERE pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._kerb_drawn() IS 'What streetgen.svg draws of kerbs.';

CREATE OR REPLACE FUNCTION streetgen._kerb_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (20, 'kerb', 'ground', 'kerb stones', 'kerb stones') $$;
COMMENT ON FUNCTION streetgen._kerb_legend() IS 'What the styles of kerbs mean.';
