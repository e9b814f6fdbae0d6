-- What a class of road means: who walks along it, whether it is a highway or a link, its usual width and speed.

CREATE OR REPLACE FUNCTION streetgen._default_axis_class()
    RETURNS TABLE(class text, taken boolean, width float8, speed float8, importance integer, highway_role text,
        walked_along boolean, crossed_on_foot boolean, lanes_by_width boolean)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    ('motorway', true, 10.5::float8, 110::float8, 1, 'highway', false, false, true),
    ('motorway_link', true, 6, 70, 2, 'highway_link', false, false, true),
    ('trunk', true, 9, 90, 1, 'fast_road', true, true, true),
    ('trunk_link', true, 6, 60, 2, 'highway_link', false, false, true),
    ('primary', true, 9, 50, 2, NULL, true, true, true),
    ('primary_link', true, 5, 50, 3, 'link', true, true, true),
    ('secondary', true, 8, 50, 3, NULL, true, true, true),
    ('secondary_link', true, 5, 50, 3, 'link', true, true, true),
    ('tertiary', true, 7, 50, 4, NULL, true, true, true),
    ('tertiary_link', true, 5, 50, 4, 'link', true, true, true),
    ('residential', true, 6, 30, 5, NULL, true, true, true),
    ('living_street', true, 5, 20, 5, NULL, true, true, true),
    ('unclassified', true, 6, 50, 5, NULL, true, true, true),
    ('busway', true, 7, 50, 4, NULL, true, true, true),
    ('service', true, 4, 20, 6, NULL, true, false, true),
    ('road', true, 6, 50, 5, NULL, true, true, true),
    ('runway', true, 40, 100, 1, NULL, false, false, false),
    ('taxiway', true, 20, 30, 2, NULL, false, false, false),
    ('highway', true, 10.5, 90, 1, NULL, true, true, true),
    ('major', true, 8, 50, 3, NULL, true, true, true),
    ('minor', true, 6, 30, 5, NULL, true, true, true),
    ('Type autoroutier', true, 10.5, 110, 1, 'highway', false, false, true),
    ('Autoroute', true, 10.5, 130, 1, 'highway', false, false, true),
    ('Quasi-autoroute', true, 10.5, 110, 1, 'highway', false, false, true),
    ('Bretelle', true, 5, 50, 3, 'highway_link', false, false, true),
    ('Route à 2 chaussées', true, 7, 70, 2, NULL, true, true, true),
    ('Route à 1 chaussée', true, 6, 50, NULL, NULL, true, true, true),
    ('Rond-point', true, 7, 30, NULL, NULL, true, true, true),
    ('Route empierrée', true, 4, 30, 6, NULL, true, true, true),
    ('Chemin', false, 3, 20, 6, NULL, true, false, true),
    ('track', false, 3, 20, 6, NULL, true, false, true),
    ('pedestrian', false, 5, 5, 6, NULL, true, true, true),
    ('footway', false, 2, 5, 6, NULL, true, false, true),
    ('path', false, 2, 5, 6, NULL, true, false, true),
    ('cycleway', false, 2, 20, 6, NULL, true, false, true),
    ('steps', false, 2, 5, 6, NULL, true, false, true),
    ('Sentier', false, 2, 5, 6, NULL, true, false, true),
    ('Escalier', false, 2, 5, 6, NULL, true, false, true),
    ('Piste cyclable', false, 2, 20, 6, NULL, true, false, true),
    ('Bac ou liaison maritime', false, NULL, NULL, NULL, NULL, true, true, true)
    $$;
COMMENT ON FUNCTION streetgen._default_axis_class() IS
    'The classes of OSM, BD TOPO and Lille''s lines that a new model knows, and what each means.';
