-- The settings of nodes, edges and reports.

CREATE OR REPLACE FUNCTION streetgen._network_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES
    ('tolerance', '0.5', 'm', 'ends and vertices this near to each other are one node', 0.001, 10, NULL::text[]),
    ('crossing', 'over', NULL, 'axes of one level that cross without a vertex: over (no node) or split', NULL, NULL,
        ARRAY['over', 'split']),
    ('smoothing', 'none', NULL,
        'line of an edge: none (the polyline of its axis) or arcs (straight pieces and arcs that touch them)', NULL,
        NULL, ARRAY['none', 'arcs']),
    ('smoothing_shift', '0.5', 'm', 'such a line leaves the points of the axis by at most this', 0.001, 100, NULL),
    ('ring_shift', '1', 'm',
        'round a roundabout by its tag, edges are arcs of one circle that leave none of their points by more, or '
        'smooth curves that leave none of their chords by more; 0: neither',
        0, 10, NULL),
    ('smoothing_tolerance', '0.01', 'm', 'chords of such a line leave its arcs by at most this', 0.0001, 1, NULL) $$;
COMMENT ON FUNCTION streetgen._network_setting() IS
    'The settings of nodes, edges and reports, with their defaults and ranges.';
