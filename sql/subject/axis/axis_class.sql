-- Classes of roads: who walks along them, which are highways or links, their usual widths, lanes and speeds.

CREATE OR REPLACE FUNCTION streetgen._default_axis_class()
    RETURNS TABLE(class text, taken boolean, width float8, speed float8, importance integer, highway_role text,
        walked_along boolean, crossed_on_foot boolean, lanes_by_width boolean, lanes_one_way integer,
        width_one_way float8, lanes_each_way integer, parking_left float8, parking_right float8)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    ('motorway', true, 10.5::float8, 110::float8, 1, 'highway', false, false, true, 2, 7.5::float8, NULL::integer,
        0::float8, 0::float8),
    ('motorway_link', true, 6, 70, 2, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0),
    ('trunk', true, 9, 90, 1, 'fast_road', true, true, true, 2, NULL, NULL, 0, 0),
    ('trunk_link', true, 6, 60, 2, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0),
    ('primary', true, 9, 50, 2, NULL, true, true, true, 2, NULL, NULL, 0, 0),
    ('primary_link', true, 5, 50, 3, 'link', true, true, true, 1, NULL, NULL, 0, 0),
    ('secondary', true, 8, 50, 3, NULL, true, true, true, 2, NULL, NULL, 0, 0),
    ('secondary_link', true, 5, 50, 3, 'link', true, true, true, 1, NULL, NULL, 0, 0),
    ('tertiary', true, 7, 50, 4, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('tertiary_link', true, 5, 50, 4, 'link', true, true, true, 1, NULL, NULL, 0, 0),
    ('residential', true, 6, 30, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('living_street', true, 5, 20, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('unclassified', true, 6, 50, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('busway', true, 7, 50, 4, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('service', true, 4, 20, 6, NULL, true, false, true, 1, NULL, NULL, 0, 0),
    ('road', true, 6, 50, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('runway', true, 40, 100, 1, NULL, false, false, false, NULL, NULL, NULL, 0, 0),
    ('taxiway', true, 20, 30, 2, NULL, false, false, false, NULL, NULL, NULL, 0, 0),
    ('highway', true, 10.5, 90, 1, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('major', true, 8, 50, 3, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('minor', true, 6, 30, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('Type autoroutier', true, 10.5, 110, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0),
    ('Autoroute', true, 10.5, 130, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0),
    ('Quasi-autoroute', true, 10.5, 110, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0),
    ('Bretelle', true, 5, 50, 3, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0),
    ('Route à 2 chaussées', true, 7, 70, 2, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('Route à 1 chaussée', true, 6, 50, NULL, NULL, true, true, true, 1, NULL, NULL, 0, 0),
    ('Rond-point', true, 7, 30, NULL, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('Route empierrée', true, 4, 30, 6, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('Chemin', false, 3, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('track', false, 3, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('pedestrian', false, 5, 5, 6, NULL, true, true, true, NULL, NULL, NULL, 0, 0),
    ('footway', false, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('path', false, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('cycleway', false, 2, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('steps', false, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('Sentier', false, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('Escalier', false, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('Piste cyclable', false, 2, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0),
    ('Bac ou liaison maritime', false, NULL, NULL, NULL, NULL, true, true, true, NULL, NULL, NULL, 0, 0)
    $$;
COMMENT ON FUNCTION streetgen._default_axis_class() IS
    'The classes of OSM, BD TOPO and Lille''s lines that a new model knows, and what each means.';

CREATE OR REPLACE FUNCTION streetgen._class_by_hand() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    NEW.lanes_one_way_by := 'hand';
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._class_by_hand() IS
    'Trigger of axis_class, for an update of the lanes or the width of one-way streets that says no other author: they '
    'are by hand.';
