-- Drawings of sidewalks, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalk', $part$
    SELECT k.level * 10, 'sidewalk', false, w.surface, w.sidewalk_id FROM %1$I.sidewalk w
        JOIN %1$I.kerb k USING (edge_id, side, part), size WHERE pixel < 3$part$) $$;
COMMENT ON FUNCTION streetgen._sidewalk_drawn() IS 'What streetgen.svg draws of sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalk', 'ground', 'sidewalk', NULL::text) $$;
COMMENT ON FUNCTION streetgen._sidewalk_legend() IS 'What the styles of sidewalks mean.';
