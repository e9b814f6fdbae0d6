-- The settings of deliveries.

CREATE OR REPLACE FUNCTION streetgen._source_setting()
    RETURNS TABLE(name text, value text, unit text, description text, minimum float8, maximum float8, choice text[])
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ VALUES
    ('clean_epsilon', '0.3', 'm', 'importers remove points nearer to each other', 0, 10, NULL::text[]),
    ('clean_r_min', '3', 'm', 'importers remove points that turn more sharply than this radius', 0, 100, NULL),
    ('class_lines_minimal', '50', NULL,
        'from so many one-way lines of a class with stated lanes on, an import takes the number of most for the others',
        1, 1000000, NULL),
    ('curve_tolerance', '0.01', 'm', 'importers make chords of curves, which leave them by at most this', 0.0001, 1,
        NULL),
    ('delivery_wins', 'hand', NULL,
        'where both somebody by hand and a new delivery of the source changed a column, this holds until view '
        'import_conflict is settled: hand or source', NULL, NULL, ARRAY['hand', 'source']),
    ('match_names', 'plain', NULL,
        'how match_axes compares names of streets: plain (alike but for capital letters), unaccent (but for accents '
        'too) or fuzzy (by the similarity of pg_trgm)', NULL, NULL, ARRAY['plain', 'unaccent', 'fuzzy']),
    ('match_weight_name', '0.4', NULL, 'weight of the names in the score of match_axes; the rest is that of the ground',
        0, 1, NULL),
    ('match_least', '0.7', NULL, 'match_axes gives what has this score and more', 0, 1, NULL) $$;
COMMENT ON FUNCTION streetgen._source_setting() IS 'The settings of deliveries, with their defaults and ranges.';

CREATE OR REPLACE FUNCTION streetgen._source_setting_beside() RETURNS TABLE(name text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 5 SET search_path = pg_catalog
    AS $$ VALUES ('delivery_wins'), ('class_lines_minimal'), ('match_names'), ('match_weight_name'), ('match_least') $$;
COMMENT ON FUNCTION streetgen._source_setting_beside() IS 'The settings of deliveries that streets do not depend on.';
