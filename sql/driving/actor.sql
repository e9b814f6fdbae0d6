-- Actors are placed by rules: cars on lanes, people on sidewalks.

CREATE OR REPLACE FUNCTION streetgen._chance(who bigint, number bigint, seed bigint) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    RETURN (hashint8extended(number, hashint8extended(who, seed)) & 1048575) / 1048576.0;
COMMENT ON FUNCTION streetgen._chance(bigint, bigint, bigint) IS
    'A number from 0 to below 1 that depends on its arguments alone.';

CREATE OR REPLACE FUNCTION streetgen._safe_speeds(links bigint[], fronts float8[], lengths float8[], ends float8[],
    wanted float8[]) RETURNS float8[]
    LANGUAGE plpgsql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
DECLARE
    -- The numbers of the Intelligent Driver Model: 2 m and 1.6 s, and 2 sqrt(0.73 * 1.67) m/s2 by which speeds differ.
    least_gap constant float8 := 2;
    time_gap constant float8 := 1.6;
    nearing constant float8 := 2.2;
    speeds float8[] := '{}';
    gap float8;
    ahead float8;
    slower float8;
BEGIN
    FOR i IN 1 .. cardinality(links) LOOP
        IF links[i] = links[i - 1] THEN
            gap := greatest(0, fronts[i - 1] - lengths[i - 1] - fronts[i] - least_gap);
            ahead := speeds[i - 1];
        ELSE
            gap := greatest(0, ends[i] - fronts[i]);
            ahead := 0;
        END IF;
        slower := (nearing * time_gap - ahead) / 2;
        speeds[i] := least(wanted[i], gap / time_gap, sqrt(slower ^ 2 + nearing * gap) - slower);
    END LOOP;
    RETURN speeds;
END $$;
COMMENT ON FUNCTION streetgen._safe_speeds(bigint[], float8[], float8[], float8[], float8[]) IS
    'Speeds (m/s) of cars, those of one link together and the foremost first, at which none brakes for the next one, '
    'nor the foremost for the end of its link, by the Intelligent Driver Model: its gap is 2 m + v T + v dv / '
    '(2 sqrt(ab)) at least. At most those wanted.';

CREATE OR REPLACE FUNCTION streetgen._ruled_cars(model name, seed bigint, free_ground geometry)
    RETURNS TABLE(axis_id bigint, abscissa float8, lane_position integer, along_axis boolean, speed float8,
        length float8, width float8, kind text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    cars record;
BEGIN
    PERFORM streetgen._use_model(model);
    WITH lane_rule AS (
        SELECT k.link_id, k.length AS ends, k.geom, k.speed / 3.6 * r.speed_share AS wanted, r.actor_rule_id,
            coalesce(r.density / 1000, 1 / nullif(r.headway * k.speed / 3.6 * r.speed_share, 0), 0) AS density,
            max(r.length) OVER w AS longest
        FROM link k JOIN lane l USING (lane_id) CROSS JOIN LATERAL (
            SELECT DISTINCT ON (r.kind) r.* FROM actor_rule r
            WHERE r.kind <> 'walker' AND coalesce(r.class = k.class, r.class IS NULL)
                AND coalesce(r.lane_kind = l.kind, r.lane_kind IS NULL)
                AND (k.traffic IS NULL OR r.kind = ANY (string_to_array(k.traffic, '|')))
            ORDER BY r.kind, r.lane_kind IS NULL, r.class IS NULL, r.actor_rule_id DESC) r
        WHERE k.kind = 'lane' AND NOT l.both_ways AND k.length > 0 WINDOW w AS (PARTITION BY k.link_id)),
    shared AS (
        SELECT r.*, sum(r.density) OVER (PARTITION BY r.link_id) AS whole,
            sum(r.density) OVER (PARTITION BY r.link_id ORDER BY r.actor_rule_id) AS upto
        FROM lane_rule r WHERE r.density > 0),
    -- A part of a car that is left over comes by a chance. Each car has a stretch of its own, with 2 m beside it.
    counted AS (
        SELECT s.link_id, s.ends, s.geom, s.whole, least(floor(s.ends / (max(s.longest) + 2)),
            floor(s.ends * s.whole + streetgen._chance(s.link_id, 0, seed)))::integer AS cars
        FROM shared s GROUP BY s.link_id, s.ends, s.geom, s.whole),
    chosen AS (
        SELECT c.link_id, c.ends, c.geom, r.wanted, r.actor_rule_id, a.length, a.width, a.kind,
            c.ends * (i - 1) / c.cars + a.length + 1 + (c.ends / c.cars - a.length - 2)
                * streetgen._chance(c.link_id, 2 * i, seed) AS front
        FROM counted c CROSS JOIN LATERAL generate_series(1, c.cars) i
            CROSS JOIN LATERAL (SELECT s.wanted, s.actor_rule_id FROM shared s WHERE s.link_id = c.link_id
                AND s.upto > c.whole * streetgen._chance(c.link_id, 2 * i + 1, seed) ORDER BY s.upto LIMIT 1) r
            JOIN actor_rule a USING (actor_rule_id)),
    kept AS (
        SELECT * FROM chosen WHERE free_ground IS NULL
            OR NOT ST_Intersects(free_ground, ST_LineInterpolatePoint(chosen.geom, front / ends)))
    SELECT array_agg(link_id) AS links, array_agg(front) AS fronts, array_agg(k.length) AS lengths,
            array_agg(ends) AS ends, array_agg(wanted) AS wanted, array_agg(k.width) AS widths,
            array_agg(k.kind) AS kinds
        INTO cars FROM (SELECT * FROM kept ORDER BY link_id, front DESC) k;
    RETURN QUERY SELECT e.axis_id, e.start_abscissa + streetgen._measure_at(m.on_lane, m.on_axis,
            CASE WHEN k.along_axis THEN c.front ELSE k.length - c.front END), l.lane_position, k.along_axis,
            c.speed * 3.6, c.length, c.width, c.kind
        FROM unnest(cars.links, cars.fronts, cars.lengths, cars.widths, cars.kinds, streetgen._safe_speeds(cars.links,
                cars.fronts, cars.lengths, cars.ends, cars.wanted)) c(link_id, front, length, width, kind, speed)
            JOIN link k USING (link_id) JOIN lane l USING (lane_id) JOIN edge e USING (edge_id)
            JOIN lane_extent x USING (lane_id)
            CROSS JOIN LATERAL streetgen._lane_measures(ST_Force2D(e.geom)::bytea, l.geom::bytea, x.widest,
                x.start_abscissa - e.start_abscissa, x.end_abscissa - e.start_abscissa) m
        ORDER BY c.link_id, c.front;
END $$;
COMMENT ON FUNCTION streetgen._ruled_cars(name, bigint, geometry) IS
    'The cars that rules place on the lanes of a model, none with its front on free_ground.';

CREATE OR REPLACE FUNCTION streetgen._ruled_walkers(model name, seed bigint)
    RETURNS TABLE(axis_id bigint, abscissa float8, side text, along boolean, speed float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    RETURN QUERY SELECT e.axis_id, e.start_abscissa + (e.end_abscissa - e.start_abscissa) * streetgen._chance(s.who,
            3 * i, seed), s.side, streetgen._chance(s.who, 3 * i + 1, seed) < 0.5,
            4.8 * r.speed_share * (0.8 + 0.4 * streetgen._chance(s.who, 3 * i + 2, seed))
        FROM (SELECT DISTINCT w.edge_id, w.side, 2 * w.edge_id + (w.side = 'left')::integer AS who FROM sidewalk w
                WHERE w.side IN ('left', 'right') AND NOT ST_IsEmpty(w.surface)) s
            JOIN edge e USING (edge_id) JOIN axis a USING (axis_id)
            CROSS JOIN LATERAL (SELECT r.* FROM actor_rule r WHERE r.kind = 'walker' AND r.lane_kind IS NULL
                AND coalesce(r.class = a.kind, r.class IS NULL)
                ORDER BY r.class IS NULL, r.actor_rule_id DESC LIMIT 1) r
            CROSS JOIN LATERAL generate_series(1, floor((e.end_abscissa - e.start_abscissa)
                * coalesce(r.density / 1000, 1 / nullif(r.headway * 4.8 / 3.6 * r.speed_share, 0), 0)
                + streetgen._chance(s.who, 0, seed))::integer) i
        ORDER BY e.axis_id, s.edge_id, s.side, i;
END $$;
COMMENT ON FUNCTION streetgen._ruled_walkers(name, bigint) IS
    'The people that rules place along the sidewalks of a model; none of a model without these.';

CREATE OR REPLACE FUNCTION streetgen._idle_actor_rules(model name) RETURNS SETOF bigint
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT r.actor_rule_id FROM actor_rule r
        WHERE r.class IS NOT NULL AND NOT EXISTS (SELECT FROM axis a WHERE a.kind = r.class)
            OR r.lane_kind IS NOT NULL AND NOT EXISTS (SELECT FROM lane l WHERE l.kind = r.lane_kind)
        ORDER BY r.actor_rule_id;
END $$;
COMMENT ON FUNCTION streetgen._idle_actor_rules(name) IS
    'The rules that name a class of streets, or a kind of lanes, of which a model has none.';

CREATE OR REPLACE FUNCTION streetgen.place_actors(model name, seed bigint DEFAULT 1, start geometry DEFAULT NULL,
    free float8 DEFAULT 50) RETURNS TABLE(kind text, placed bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    free_ground geometry;
    idle bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model), streetgen._check_given('seed', seed::text, 'free', free::text),
        streetgen._require_traffic(model), streetgen._require_subject(model, 'interconnection');
    IF NOT free BETWEEN 0 AND 1e6 THEN
        RAISE EXCEPTION 'free is %, expected 0 to 1,000,000 metres', free USING ERRCODE = '22023',
            HINT = 'No actor is placed so near to start.';
    END IF;
    IF ST_GeometryType(start) <> 'ST_Point' OR ST_IsEmpty(start) THEN
        RAISE EXCEPTION 'start is %, expected a point', left(ST_AsText(start), 60) USING ERRCODE = '22023',
            HINT = 'NULL: there is none.';
    END IF;
    free_ground := (SELECT ST_Buffer(streetgen._transformed('start', ST_Force2D(start), m.srid), free)
        FROM streetgen.model m WHERE m.name = model);
    idle := ARRAY(SELECT streetgen._idle_actor_rules(model));
    IF idle <> '{}' THEN
        RAISE WARNING 'rows % of table actor_rule fit no street', array_to_string(idle, ', ')
            USING HINT = 'A class is a kind of table axis, a lane_kind one of table lane.';
    END IF;
    -- Actors are placed by one call at a time. Keys begin anew, so that the same seed gives the same rows.
    LOCK TABLE car, walker IN SHARE ROW EXCLUSIVE MODE;
    DELETE FROM car;
    DELETE FROM walker;
    ALTER SEQUENCE car_car_id_seq RESTART;
    ALTER SEQUENCE walker_walker_id_seq RESTART;
    INSERT INTO car (axis_id, abscissa, lane_position, along_axis, speed, length, width, kind)
        SELECT * FROM streetgen._ruled_cars(model, seed, free_ground);
    INSERT INTO walker (axis_id, abscissa, side, along, speed) SELECT * FROM streetgen._ruled_walkers(model, seed);
    DELETE FROM walker w WHERE NOT EXISTS (SELECT FROM walker_place p WHERE p.walker_id = w.walker_id
        AND (free_ground IS NULL OR NOT ST_Intersects(free_ground, p.geom)));
    RETURN QUERY SELECT c.kind, count(*) FROM car c GROUP BY c.kind
        UNION ALL SELECT 'walker', count(*) FROM walker ORDER BY 1;
END $$;
COMMENT ON FUNCTION streetgen.place_actors(name, bigint, geometry, float8) IS
    'Places actors on the streets of a model as table actor_rule says, in place of those in tables car and walker, and '
    'gives how many these are. Each car drives as fast as its rule says, and at most so that it need not brake for the '
    'next one (2 m, 1.6 s, and what both speeds differ), or at the end of its lane. Lanes for both directions stay '
    'empty, and each keeps to lanes where it may drive. People are on the sidewalks of a model with subject sidewalk. '
    'start: a point, such as the place of the driver of a simulator; nobody is placed nearer than free metres to it. '
    'The same seed places the same actors. A free out of 0 to 1,000 km, a start that is no point: 22023; NULL for seed '
    'or free: 22004; a model without traffic or without subject interconnection: 55000; not the owner of the model: '
    '42501; an unknown model: 3F000. Campos, section 3.4.';
