-- Parts of the network of links: what some links touch.

CREATE OR REPLACE FUNCTION streetgen._lanes_over_junctions(model name, movements bigint[], junctions bigint[])
    RETURNS TABLE(lane_in bigint, lane_out bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'junction' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT m.lane_in, m.lane_out FROM junction_movement m
            WHERE m.junction_movement_id = ANY (movements) OR m.junction_id = ANY (junctions);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._lanes_over_junctions(name, bigint[], bigint[]) IS
    'The lanes of some movements across junctions of several nodes, and of all movements across some of these; none of '
    'a model that computes no junctions.';

CREATE OR REPLACE FUNCTION streetgen._lanes_of_links(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT l >> 2 FROM unnest(links) l WHERE l & 2 = 0
        UNION SELECT unnest(ARRAY[i.lane_in, i.lane_out]) FROM interconnection i
            WHERE i.interconnection_id = ANY (ARRAY(SELECT l >> 2 FROM unnest(links) l WHERE l & 3 = 2))
        UNION SELECT unnest(ARRAY[m.lane_in, m.lane_out]) FROM streetgen._lanes_over_junctions(model, ARRAY(
            SELECT l >> 2 FROM unnest(links) l WHERE l & 3 = 3), '{}') m);
END $$;
COMMENT ON FUNCTION streetgen._lanes_of_links(name, bigint[]) IS
    'The lanes that some links are, or that they join.';

CREATE OR REPLACE FUNCTION streetgen._links_there(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
DECLARE
    lanes bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    lanes := streetgen._lanes_of_links(model, links);
    RETURN ARRAY(SELECT k.link_id FROM link k WHERE k.kind = 'lane' AND k.lane_id = ANY (lanes)
        UNION ALL SELECT k.link_id FROM link k WHERE k.kind = 'movement' AND k.lane_in = ANY (lanes));
END $$;
COMMENT ON FUNCTION streetgen._links_there(name, bigint[]) IS
    'The links of a model on the lanes of some links and on the movements from these: of the links given, those that '
    'are there are among them.';

CREATE OR REPLACE FUNCTION streetgen._lanes_near_links(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    own bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    own := streetgen._lanes_of_links(model, links);
    RETURN ARRAY(SELECT unnest(own)
        UNION SELECT k.lane_out FROM link k WHERE k.kind = 'movement' AND k.lane_in = ANY (own)
        UNION SELECT k.lane_in FROM link k WHERE k.kind = 'movement' AND k.lane_out = ANY (own));
END $$;
COMMENT ON FUNCTION streetgen._lanes_near_links(name, bigint[]) IS
    'The lanes of some links, and the lanes that movements join with these: what their courses depend on.';

CREATE OR REPLACE FUNCTION streetgen._lanes_near_turns(model name, links bigint[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
DECLARE
    lanes bigint[] := streetgen._lanes_of_links(model, links);
BEGIN
    FOR ring IN 1 .. 3 LOOP
        lanes := streetgen._lanes_near_links(model, ARRAY(SELECT 4 * lane FROM unnest(lanes) lane));
    END LOOP;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._lanes_near_turns(name, bigint[]) IS
    'The lanes of some links and those within three movements: what tells which way leads straight on where two turn '
    'nearly the same, since courses of short lanes depend on those beyond.';

CREATE OR REPLACE FUNCTION streetgen._network_near_links(model name, links bigint[]) RETURNS bytea
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$ SELECT streetgen._network_of_lanes(model, streetgen._lanes_near_links(model, links)) $$;
COMMENT ON FUNCTION streetgen._network_near_links(name, bigint[]) IS
    'The network of some links and those that these touch. Its statements are planned once a session.';
