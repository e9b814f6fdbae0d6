-- Links: lanes in one direction and movements, each with one key, as traffic goes along them.

CREATE OR REPLACE FUNCTION streetgen._make_simulation_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subjects constant text[] := streetgen._subjects(model);
    junctions constant boolean := 'junction' = ANY (subjects);
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'interconnection' <> ALL (subjects) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._fill_template(streetgen._part('link'), jsonb_build_object(
        'inside', CASE WHEN junctions THEN streetgen._part('link_inside') ELSE 'false' END,
        'junction_ahead', CASE WHEN junctions THEN streetgen._part('link_junction_ahead') ELSE 'NULL::bigint' END,
        'movement', streetgen._part(CASE WHEN junctions THEN 'link_of_movement' ELSE 'link_of_interconnection' END)));
    COMMENT ON VIEW link IS
        'What traffic goes along: each lane in each of its directions, but for lanes inside junctions and those that '
        'nobody drives on, and each movement from lane to lane that connects';
    COMMENT ON COLUMN link.link_id IS
        'key, kept as long as that of its row: four times lane_id, and 1 along the axis; four times '
        'interconnection_id, and 2; four times junction_movement_id, and 3';
    COMMENT ON COLUMN link.kind IS 'lane or movement';
    COMMENT ON COLUMN link.lane_id IS 'the lane; NULL of a movement';
    COMMENT ON COLUMN link.along_axis IS 'does its traffic run along the axis? NULL of a movement';
    COMMENT ON COLUMN link.interconnection_id IS 'of a movement at a node: its row of interconnection';
    COMMENT ON COLUMN link.junction_movement_id IS
        'of a movement across a junction of several nodes: its row of junction_movement';
    COMMENT ON COLUMN link.lane_in IS 'of a movement: the lane that it comes from';
    COMMENT ON COLUMN link.along_in IS 'does one drive along the axis of lane_in?';
    COMMENT ON COLUMN link.lane_out IS 'of a movement: the lane that it leads to';
    COMMENT ON COLUMN link.along_out IS 'does one drive along the axis of lane_out?';
    COMMENT ON COLUMN link.comes_from IS 'of a movement: the link that it comes from';
    COMMENT ON COLUMN link.leads_to IS 'of a movement: the link that it leads to';
    COMMENT ON COLUMN link.length IS 'of geom, metres; 0 of a movement between lanes that touch';
    COMMENT ON COLUMN link.width IS 'of the lane, of a movement that of the lane that it leads to, metres';
    COMMENT ON COLUMN link.speed IS 'that is allowed, km/h; of a movement the lower one of its lanes';
    COMMENT ON COLUMN link.class IS 'kind of the axis; of a movement that of the street that it leads to';
    COMMENT ON COLUMN link.traffic IS 'who alone may drive there, by kinds of lanes such as bus|cycle; NULL: all';
    COMMENT ON COLUMN link.from_node IS 'the node where it begins; of a movement where lane_in ends';
    COMMENT ON COLUMN link.to_node IS 'the node where it ends; of a movement where lane_out begins';
    COMMENT ON COLUMN link.junction_id IS
        'the junction that a movement crosses, or that a lane leads to; NULL: none, or the model computes none';
    COMMENT ON COLUMN link.geom IS
        'its line, in the direction of its traffic; of lanes that touch a line of two equal points';
    IF streetgen._has_traffic(model) THEN
        EXECUTE streetgen._part('car_place');
        COMMENT ON VIEW car_place IS 'Where the front of each car is; one whose lane is gone has no row';
        COMMENT ON COLUMN car_place.car_id IS 'the car';
        COMMENT ON COLUMN car_place.link_id IS 'the link';
        COMMENT ON COLUMN car_place.metres IS 'along the link, in the direction of its traffic';
        COMMENT ON COLUMN car_place.geom IS 'POINT on the line of the link';
        EXECUTE streetgen._part('event_place');
        COMMENT ON VIEW event_place IS 'Where the place of each event is; one on no lane has no row';
        COMMENT ON COLUMN event_place.traffic_event_id IS 'the event';
        COMMENT ON COLUMN event_place.link_id IS 'the link';
        COMMENT ON COLUMN event_place.metres IS 'along the link, in the direction of its traffic';
        COMMENT ON COLUMN event_place.geom IS 'POINT on the line of the link';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._make_simulation_views(name) IS
    'Makes the views of links of a model with interconnections, and that of cars where it has traffic, again and '
    'again.';

CREATE OR REPLACE FUNCTION streetgen._simulation_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 8 SET search_path = pg_catalog
    AS $$ SELECT view, subject FROM unnest('{car_editing,car_place,event_place,link}'::name[]) view,
        unnest('{interconnection,junction}'::text[]) subject $$;
COMMENT ON FUNCTION streetgen._simulation_view() IS 'Views of the room, and the subjects whose tables they read.';
