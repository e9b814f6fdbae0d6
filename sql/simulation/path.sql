-- The ways ahead of a place.

CREATE OR REPLACE FUNCTION streetgen._free_path(network bytea, link bigint, metres float8, horizon float8,
    route bigint[])
    RETURNS TABLE(link_id bigint, starts float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_free_path';
COMMENT ON FUNCTION streetgen._free_path(bytea, bigint, float8, float8, bigint[]) IS
    'The links ahead of a place, and how far ahead each begins, metres. A route that has the link comes first, as '
    'far as the network has its links without a break; then and else they go straight on. An unknown link, a place '
    'off it, a gap in the route, a horizon below 0 or beyond 1,000 km: 22023.';

CREATE OR REPLACE FUNCTION streetgen._straight_ahead(model name, lane bigint, horizon float8) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
DECLARE
    lanes bigint[] := '{}';
    way float8 := 0;
    at_end bigint := lane;
    onward record;
BEGIN
    PERFORM streetgen._use_model(model);
    WHILE way < horizon LOOP
        SELECT m.leads_to, (SELECT ST_Length(l.geom) FROM lane l WHERE l.lane_id = m.lane_out) AS length
        INTO onward FROM link m
            CROSS JOIN LATERAL (SELECT ST_Azimuth(ST_StartPoint(m.geom), ST_PointN(m.geom, 2))
                - ST_Azimuth(ST_PointN(m.geom, -2), ST_EndPoint(m.geom)) AS turn) t
        WHERE m.kind = 'movement' AND m.lane_in = at_end >> 2 AND m.along_in = (at_end & 1 = 1)
        ORDER BY cos(t.turn) DESC NULLS FIRST, m.link_id LIMIT 1;
        EXIT WHEN NOT FOUND OR onward.leads_to = ANY (lanes);
        at_end := onward.leads_to;
        lanes := lanes || at_end;
        way := way + onward.length;
    END LOOP;
    RETURN lanes;
END $$;
COMMENT ON FUNCTION streetgen._straight_ahead(name, bigint, float8) IS
    'The lanes, by their links, that follow one as far as horizon metres, by movements whose lines turn least. Where '
    'two turn nearly the same, courses may go on by the other one.';

CREATE OR REPLACE FUNCTION streetgen._route_ahead(model name, link bigint, horizon float8, route bigint[])
    RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    SET plan_cache_mode = force_generic_plan
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN ARRAY(SELECT r.link FROM (
            SELECT u.link, u.number, sum(CASE WHEN u.number > 1 THEN coalesce(ST_Length(l.geom), 0) ELSE 0 END)
                OVER (ORDER BY u.number) - coalesce(ST_Length(l.geom), 0) AS begins
            FROM unnest(route[array_position(route, _route_ahead.link):]) WITH ORDINALITY u(link, number)
                LEFT JOIN lane l ON u.link & 2 = 0 AND l.lane_id = u.link >> 2) r
        WHERE r.begins <= horizon ORDER BY r.number);
END $$;
COMMENT ON FUNCTION streetgen._route_ahead(name, bigint, float8, bigint[]) IS
    'The links of a route from one of them on, those that begin within horizon metres of its end at the latest; none '
    'of a route without it.';

CREATE OR REPLACE FUNCTION streetgen._path_ahead(model name, link bigint, place float8, horizon float8,
    route bigint[])
    RETURNS TABLE(ordinality integer, link_id bigint, starts float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
    path bigint[];
    begins float8[];
    farthest bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    known := link || streetgen._route_ahead(model, link, horizon, route);
    LOOP
        SELECT array_agg(p.link_id ORDER BY p.ordinality), array_agg(p.starts ORDER BY p.ordinality) INTO path, begins
            FROM streetgen._free_path(streetgen._network_of_lanes(model, streetgen._lanes_near_turns(model, known)),
                link, place, horizon, route) WITH ORDINALITY p;
        farthest := path[cardinality(path)];
        -- The network ends behind links that it does not know whole.
        EXIT WHEN farthest = ANY (known);
        known := known || farthest || CASE WHEN farthest & 2 = 0 THEN
            streetgen._straight_ahead(model, farthest, horizon - begins[cardinality(begins)]) END;
    END LOOP;
    RETURN QUERY SELECT p.number::integer, p.link, p.begin FROM unnest(path, begins)
        WITH ORDINALITY p(link, begin, number);
END $$;
COMMENT ON FUNCTION streetgen._path_ahead(name, bigint, float8, float8, bigint[]) IS
    'What streetgen.free_path gives, from a network that grows along the path.';

CREATE OR REPLACE FUNCTION streetgen._free_path_of(model name, link bigint, place float8, horizon float8,
    route bigint[])
    RETURNS TABLE(ordinality integer, link_id bigint, starts float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog, public
    AS $$
DECLARE
    gone bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('link', link::text, 'metres', place::text,
        'horizon', horizon::text, 'route', route::text), streetgen._require_subject(model, 'interconnection');
    gone := (SELECT min(r) FROM unnest(route) r WHERE r <> ALL (streetgen._links_there(model, route)));
    IF gone IS NOT NULL THEN
        RAISE EXCEPTION 'there is no link % of the route', gone USING ERRCODE = '22023',
            HINT = 'Function route finds one.';
    END IF;
    RETURN QUERY SELECT p.* FROM streetgen._path_ahead(model, link, place, horizon, route) p;
END $$;
COMMENT ON FUNCTION streetgen._free_path_of(name, bigint, float8, float8, bigint[]) IS
    'What streetgen.free_path gives.';

-- An argument and a column may have one name in LANGUAGE sql alone.
CREATE OR REPLACE FUNCTION streetgen.free_path(model name, link bigint, metres float8 DEFAULT 0,
    horizon float8 DEFAULT 1000, route bigint[] DEFAULT '{}')
    RETURNS TABLE(ordinality integer, link_id bigint, starts float8)
    LANGUAGE sql STABLE PARALLEL UNSAFE ROWS 20 SET search_path = pg_catalog
    AS $$ SELECT * FROM streetgen._free_path_of($1, $2, $3, $4, $5) $$;
COMMENT ON FUNCTION streetgen.free_path(name, bigint, float8, float8, bigint[]) IS
    'The links ahead of a place of a link, as far as horizon metres. A route that has the link comes first; then and '
    'else they go straight on. Straight on is the movement that turns least, of equal ones that of the smallest key. '
    'The path ends where the route goes on beside: who follows it changes lanes before. The first one is link; '
    'starts: how far ahead each begins, metres, below 0 of the first. An unknown link, a place off it, a route with a '
    'gap, NaN, a horizon below 0 or beyond 1,000 km: 22023; NULL: 22004; a model without subject interconnection: '
    '55000; an unknown model: 3F000; not a reader of the model: 42501. Wilkie, Sewall and Lin, section 3.1.1.';
