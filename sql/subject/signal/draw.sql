-- Drawings of signals, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._signal_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (60, 'signal', $part$
    SELECT 905, 'signal head', false, ST_Buffer(geom, 0.6, 4), lane_id FROM %1$I.signal_head, size
        WHERE pixel < 0.5$part$) $$;
COMMENT ON FUNCTION streetgen._signal_drawn() IS 'What streetgen.svg draws of signals.';

CREATE OR REPLACE FUNCTION streetgen._signal_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'signal head', 'ground', 'signal', 'signal') $$;
COMMENT ON FUNCTION streetgen._signal_legend() IS 'What the styles of signals mean.';
