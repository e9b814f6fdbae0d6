-- The tables of a design: a model that has them designs its roads on terrain.

CREATE OR REPLACE FUNCTION streetgen._design_table()
    RETURNS TABLE(place integer, relation name, computed boolean, of_link text, definition text, description text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 12 SET search_path = pg_catalog
    AS $$ VALUES
    (1, 'terrain_tile'::name, false, NULL, 'geom geometry(Polygon, %2$s) NOT NULL, heights bytea NOT NULL,
        content text GENERATED ALWAYS AS (md5(heights)) STORED',
        'Heights of the ground: tiles of one raster'),
    (2, 'zone_class', false, NULL, 'class text NOT NULL UNIQUE,
        cost float8 NOT NULL DEFAULT 0 CHECK (cost BETWEEN 0 AND 1e9),
        passage text NOT NULL DEFAULT ''free'' CHECK (passage IN (''free'', ''bridge'', ''forbidden''))',
        'Classes of zones: what a road pays for crossing them, and how it may'),
    (3, 'zone', false, NULL, 'class text NOT NULL REFERENCES %1$I.zone_class (class) ON UPDATE CASCADE,
        geom geometry(MultiPolygon, %2$s) NOT NULL,
        content text GENERATED ALWAYS AS (md5(ST_AsEWKB(geom))) STORED',
        'Ground that roads pay for, bridge or keep out of'),
    (4, 'design_standard', false, NULL, 'speed float8 NOT NULL UNIQUE CHECK (speed BETWEEN 10 AND 200),
        radius float8 NOT NULL CHECK (radius BETWEEN 5 AND 10000),
        radius_normal float8 NOT NULL CHECK (radius_normal BETWEEN 5 AND 10000),
        clothoid float8 NOT NULL CHECK (clothoid BETWEEN 0 AND 10000),
        grade float8 NOT NULL CHECK (grade BETWEEN 0.001 AND 0.5),
        crest float8 NOT NULL CHECK (crest BETWEEN 10 AND 1e6), sag float8 NOT NULL CHECK (sag BETWEEN 10 AND 1e6),
        stopping float8 NOT NULL CHECK (stopping BETWEEN 1 AND 1000)',
        'What a base speed asks of a road, a row a speed: the Portuguese norm until other rows stand here'),
    (5, 'design_class', false, NULL, 'network text NOT NULL UNIQUE
            CHECK (network IN (''highway'', ''secondary'', ''rural'')),
        speed float8 NOT NULL CHECK (speed BETWEEN 10 AND 200), width float8 NOT NULL CHECK (width BETWEEN 3 AND 200),
        carriageways integer NOT NULL CHECK (carriageways IN (1, 2)),
        lane_count integer NOT NULL CHECK (lane_count BETWEEN 1 AND 12),
        roadway_width float8 NOT NULL CHECK (roadway_width BETWEEN 2 AND 100),
        median_width float8 NOT NULL DEFAULT 0 CHECK (median_width BETWEEN 0 AND 100),
        taper float8 NOT NULL DEFAULT 0 CHECK (taper BETWEEN 0 AND 10000),
        importance integer NOT NULL CHECK (importance BETWEEN 1 AND 99)',
        'What the roads of a network are built as'),
    (6, 'design_node', true, NULL, 'name text, kind text NOT NULL
            CHECK (kind IN (''city'', ''town'', ''village'', ''interchange'')),
        importance float8 NOT NULL DEFAULT 0 CHECK (importance BETWEEN 0 AND 1e10),
        geom geometry(Point, %2$s) NOT NULL',
        'Towns that roads link, and interchanges where links of a network cross'),
    (7, 'design_link', true, NULL, 'node_a bigint NOT NULL REFERENCES %1$I.design_node ON DELETE CASCADE,
        node_b bigint NOT NULL REFERENCES %1$I.design_node ON DELETE CASCADE,
        network text NOT NULL CHECK (network IN (''highway'', ''secondary'', ''rural'')),
        length float8, utilisation float8, benefit float8, cost float8, method text,
        geom geometry(LineStringZ, %2$s), town_a bigint, town_b bigint, CHECK (node_a <> node_b)',
        'Roads between two nodes'),
    (8, 'design_vertex', true, 'design_link_id', 'design_link_id bigint NOT NULL
            REFERENCES %1$I.design_link ON DELETE CASCADE,
        ordinality float8 NOT NULL, geom geometry(Point, %2$s) NOT NULL,
        radius float8 CHECK (radius BETWEEN 0 AND 1e6), clothoid_in float8 CHECK (clothoid_in BETWEEN 0 AND 1e6),
        clothoid_out float8 CHECK (clothoid_out BETWEEN 0 AND 1e6),
        straight_in boolean NOT NULL DEFAULT false, straight_out boolean NOT NULL DEFAULT false',
        'Vertices of the straight alignments of links'),
    (9, 'alignment_element', true, 'design_link_id', 'design_link_id bigint NOT NULL
            REFERENCES %1$I.design_link ON DELETE CASCADE,
        ordinality integer NOT NULL, kind text NOT NULL CHECK (kind IN (''line'', ''clothoid'', ''arc'')),
        abscissa float8 NOT NULL, start geometry(Point, %2$s) NOT NULL, heading float8 NOT NULL,
        length float8 NOT NULL CHECK (length >= 0), curvature_start float8 NOT NULL, curvature_end float8 NOT NULL',
        'Straight lines, clothoids and arcs of links'),
    (10, 'grade_point', true, 'design_link_id', 'design_link_id bigint NOT NULL
            REFERENCES %1$I.design_link ON DELETE CASCADE,
        abscissa float8 NOT NULL CHECK (abscissa >= 0), height float8 NOT NULL CHECK (height BETWEEN -1e5 AND 1e5),
        radius float8 CHECK (radius BETWEEN 0 AND 1e7), geom geometry(PointZ, %2$s)',
        'Where straight grades of links meet, with the parabolas that round them'),
    (11, 'design_crossing', true, 'design_link_id', 'design_link_id bigint NOT NULL
            REFERENCES %1$I.design_link ON DELETE CASCADE,
        other_link_id bigint NOT NULL REFERENCES %1$I.design_link ON DELETE CASCADE,
        abscissa float8 NOT NULL, other_abscissa float8 NOT NULL,
        kind text NOT NULL CHECK (kind IN (''over'', ''under'', ''level'')), geom geometry(Point, %2$s) NOT NULL',
        'Where links of two networks cross'),
    (12, 'structure', true, 'design_link_id', 'design_link_id bigint NOT NULL
            REFERENCES %1$I.design_link ON DELETE CASCADE,
        kind text NOT NULL CHECK (kind IN (''bridge'', ''tunnel'')), start_abscissa float8 NOT NULL,
        end_abscissa float8 NOT NULL, geom geometry(LineStringZ, %2$s), CHECK (end_abscissa > start_abscissa)',
        'Bridges and tunnels of links') $$;
COMMENT ON FUNCTION streetgen._design_table() IS
    'The tables of a design in their order. computed: streetgen.design writes the table; of_link: the column by which '
    'its rows belong to a link; definition: its columns in model %1$I of SRID %2$s.';

CREATE OR REPLACE FUNCTION streetgen._rows_by_hand() RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT string_agg(format('SELECT %1$L::name AS relation, %2$I AS id, design_link_id, %3$s AS geom
        FROM %%1$I.%1$I WHERE by_hand', relation, relation || '_id', CASE relation
            WHEN 'alignment_element' THEN 'start' ELSE 'geom' END), ' UNION ALL ' ORDER BY place)
        || ' UNION ALL SELECT ''design_crossing'', design_crossing_id, other_link_id, geom
            FROM %1$I.design_crossing WHERE by_hand'
        FROM streetgen._design_table() WHERE of_link IS NOT NULL $$;
COMMENT ON FUNCTION streetgen._rows_by_hand() IS
    'Query of the rows by hand of links of model %1$I: relation, id, design_link_id and geom; a crossing is of both '
    'its links.';

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
