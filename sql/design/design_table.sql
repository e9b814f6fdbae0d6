-- The list of the tables of a design, its rows by hand, and the rows that stand in it at first.

CREATE OR REPLACE FUNCTION streetgen._design_table()
    RETURNS TABLE(place integer, relation name, computed boolean, of_link boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$ VALUES (1, 'terrain_tile'::name, false, false), (2, 'zone_class', false, false), (3, 'zone', false, false),
        (4, 'design_standard', false, false), (5, 'design_class', false, false), (6, 'design_node', true, false),
        (7, 'design_link', true, false), (8, 'design_vertex', true, true), (9, 'alignment_element', true, true),
        (10, 'grade_point', true, true), (11, 'design_crossing', true, true), (12, 'structure', true, true) $$;
COMMENT ON FUNCTION streetgen._design_table() IS
    'The tables of a design that are edited, in their order. computed: streetgen.design writes the table; of_link: its '
    'rows belong to a link.';

CREATE OR REPLACE FUNCTION streetgen._rows_by_hand(model name)
    RETURNS TABLE(relation text, id bigint, design_link_id bigint, geom geometry)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 100 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY
    SELECT 'design_vertex', design_vertex_id, design_link_id, geom FROM design_vertex WHERE by_hand
    UNION ALL
    SELECT 'alignment_element', alignment_element_id, design_link_id, start FROM alignment_element WHERE by_hand
    UNION ALL SELECT 'grade_point', grade_point_id, design_link_id, geom FROM grade_point WHERE by_hand
    UNION ALL SELECT 'design_crossing', design_crossing_id, design_link_id, geom FROM design_crossing WHERE by_hand
    UNION ALL SELECT 'structure', structure_id, design_link_id, geom FROM structure WHERE by_hand;
END $$;
COMMENT ON FUNCTION streetgen._rows_by_hand(name) IS 'The rows by hand of the links of a design.';

CREATE OR REPLACE FUNCTION streetgen._links_by_hand(model name) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT design_link_id FROM streetgen._rows_by_hand(model)
        UNION SELECT other_link_id FROM design_crossing WHERE by_hand);
END $$;
COMMENT ON FUNCTION streetgen._links_by_hand(name) IS
    'The links of a design that have rows by hand; a crossing is of both its links.';

CREATE OR REPLACE FUNCTION streetgen._require_design(model name) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_model(model);
    IF NOT streetgen._has_design(model) THEN
        PERFORM streetgen._refuse('55000', format('model "%s" has no design', model),
            hint => format('SELECT streetgen.create_design(%L) makes its tables.', model));
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_design(name) IS
    'Raises 3F000 when the model does not exist, 55000 when it has no tables of a design.';

CREATE OR REPLACE FUNCTION streetgen._default_design_standard()
    RETURNS TABLE(speed float8, radius float8, radius_normal float8, clothoid float8, grade float8, crest float8,
        sag float8, stopping float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$ VALUES
    (30::float8, 30::float8, 60::float8, 20::float8, 0.1::float8, 800::float8, 500::float8, 30::float8),
    (40, 55, 110, 35, 0.08, 1500, 800, 40), (50, 85, 180, 50, 0.08, 1500, 1200, 60),
    (60, 130, 250, 70, 0.07, 2000, 1600, 80), (70, 180, 350, 90, 0.065, 3000, 2500, 100),
    (80, 240, 450, 120, 0.06, 5000, 3500, 120), (90, 320, 550, 150, 0.055, 7000, 4500, 150),
    (100, 420, 700, 180, 0.05, 9000, 5500, 180), (110, 560, 850, 210, 0.045, 11500, 6250, 215),
    (120, 700, 1000, 250, 0.04, 14000, 7000, 250), (130, 900, 1200, 300, 0.035, 17000, 8500, 290),
    (140, 1200, 1400, 400, 0.03, 20000, 10000, 330) $$;
COMMENT ON FUNCTION streetgen._default_design_standard() IS
    'Values by base speed of the Portuguese norm JAE P3/94; rows between those of the norm are interpolated.';

CREATE OR REPLACE FUNCTION streetgen._default_design_class()
    RETURNS TABLE(network text, speed float8, width float8, carriageways integer, lane_count integer,
        roadway_width float8, median_width float8, taper float8, importance integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES ('highway', 120::float8, 40::float8, 2, 2, 10.5::float8, 8::float8, 200::float8, 1),
    ('secondary', 80, 16, 1, 2, 9, 0, 0, 2), ('rural', 60, 12, 1, 2, 7, 0, 0, 3) $$;
COMMENT ON FUNCTION streetgen._default_design_class() IS 'What the roads of the three networks are, until changed.';
