-- Classes of roads: who walks along them, which are highways or links, their usual widths, lanes and speeds.

CREATE OR REPLACE FUNCTION streetgen._default_axis_class()
    RETURNS TABLE(class text, taken boolean, width float8, speed float8, importance integer, highway_role text,
        walked_along boolean, crossed_on_foot boolean, lanes_by_width boolean, lanes_one_way integer,
        width_one_way float8, lanes_each_way integer, parking_left float8, parking_right float8, use text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ VALUES
    ('motorway', true, 10.5::float8, 110::float8, 1, 'highway', false, false, true, 2, 7.5::float8, NULL::integer,
        0::float8, 0::float8, 'roadway'),
    ('motorway_link', true, 6, 70, 2, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0, 'roadway'),
    ('trunk', true, 9, 90, 1, 'fast_road', true, true, true, 2, NULL, NULL, 0, 0, 'roadway'),
    ('trunk_link', true, 6, 60, 2, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0, 'roadway'),
    ('primary', true, 9, 50, 2, NULL, true, true, true, 2, NULL, NULL, 0, 0, 'roadway'),
    ('primary_link', true, 5, 50, 3, 'link', true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('secondary', true, 8, 50, 3, NULL, true, true, true, 2, NULL, NULL, 0, 0, 'roadway'),
    ('secondary_link', true, 5, 50, 3, 'link', true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('tertiary', true, 7, 50, 4, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('tertiary_link', true, 5, 50, 4, 'link', true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('residential', true, 6, 30, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('living_street', true, 5, 20, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('unclassified', true, 6, 50, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('busway', true, 7, 50, 4, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('service', true, 4, 20, 6, NULL, true, false, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('road', true, 6, 50, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('runway', true, 40, 100, 1, NULL, false, false, false, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('taxiway', true, 20, 30, 2, NULL, false, false, false, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('highway', true, 10.5, 90, 1, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('major', true, 8, 50, 3, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('minor', true, 6, 30, 5, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('Type autoroutier', true, 10.5, 110, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Autoroute', true, 10.5, 130, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Quasi-autoroute', true, 10.5, 110, 1, 'highway', false, false, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Bretelle', true, 5, 50, 3, 'highway_link', false, false, true, 1, 4.5, NULL, 0, 0, 'roadway'),
    ('Route à 2 chaussées', true, 7, 70, 2, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Route à 1 chaussée', true, 6, 50, NULL, NULL, true, true, true, 1, NULL, NULL, 0, 0, 'roadway'),
    ('Rond-point', true, 7, 30, NULL, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Route empierrée', true, 4, 30, 6, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('Chemin', false, 3, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('track', false, 3, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'roadway'),
    ('pedestrian', true, 5, 5, 6, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'walk'),
    ('footway', true, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'walk'),
    ('path', true, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'walk'),
    ('cycleway', true, 2, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'cycle'),
    ('steps', true, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'steps'),
    ('Sentier', true, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'walk'),
    ('Escalier', true, 2, 5, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'steps'),
    ('Piste cyclable', true, 2, 20, 6, NULL, true, false, true, NULL, NULL, NULL, 0, 0, 'cycle'),
    ('tram', true, NULL, 50, NULL, NULL, false, true, true, NULL, NULL, NULL, 0, 0, 'rail'),
    ('light_rail', true, NULL, 80, NULL, NULL, false, true, true, NULL, NULL, NULL, 0, 0, 'rail'),
    ('Tramway', true, NULL, 50, NULL, NULL, false, true, true, NULL, NULL, NULL, 0, 0, 'rail'),
    ('Bac ou liaison maritime', false, NULL, NULL, NULL, NULL, true, true, true, NULL, NULL, NULL, 0, 0, 'none')
    $$;
COMMENT ON FUNCTION streetgen._default_axis_class() IS
    'The classes of OSM, BD TOPO and Lille''s lines that a new model knows, and what each means.';

CREATE OR REPLACE FUNCTION streetgen._footway_uses() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN ARRAY['cycle', 'walk', 'steps'];
COMMENT ON FUNCTION streetgen._footway_uses() IS
    'The uses of classes whose lines are footways, in the order in which these take ground from each other.';

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
