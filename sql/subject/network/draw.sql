-- Drawings of nodes, edges and reports, and what their styles mean.

CREATE OR REPLACE FUNCTION streetgen._network_drawn()
    RETURNS TABLE(place integer, subject text, query text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    -- Below the line in the middle of the street, which runs along it.
    (5, 'network', $part$
    SELECT 3 + level * 10, 'axis', true, geom, edge_id FROM %1$I.edge, size WHERE pixel < 3$part$),
    (10, 'network', $part$
    SELECT 903, 'report', false, ST_Buffer(geom, 2), axis_a FROM %1$I.report$part$) $$;
COMMENT ON FUNCTION streetgen._network_drawn() IS 'What streetgen.svg draws of nodes, edges and reports.';

CREATE OR REPLACE FUNCTION streetgen._network_legend()
    RETURNS TABLE(place integer, style text, form text, near text, far text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 2 SET search_path = pg_catalog
    AS $$ VALUES
    (7, 'axis', 'line', 'axis', 'axis'),
    (13, 'report', 'ground', 'report', 'report') $$;
COMMENT ON FUNCTION streetgen._network_legend() IS 'What the styles of nodes, edges and reports mean.';
