-- Cars and densities in pictures: those of table car, or of a run that was kept.

CREATE OR REPLACE FUNCTION streetgen._car_frames(network bytea, cars streetgen.traffic_car[])
    RETURNS TABLE(car_id bigint, x float8, y float8, heading float8)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 1000 AS 'MODULE_PATHNAME', 'streetgen_car_frames';
COMMENT ON FUNCTION streetgen._car_frames(bytea, streetgen.traffic_car[]) IS
    'How cars on a network stand: the place of the front, and the direction from the rear to it, radians '
    'counter-clockwise from east.';

CREATE OR REPLACE FUNCTION streetgen._car_ground(length float8, width float8) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    -- One sees by the pane where the front is.
    AS $$ SELECT ST_MakePolygon(ST_ExteriorRing(ST_MakeEnvelope(-length, -width / 2, 0, width / 2)),
        ARRAY[ST_ExteriorRing(ST_MakeEnvelope(-pane - 0.14 * least(length, 5), -0.4 * width, -pane, 0.4 * width))])
        FROM (SELECT CASE WHEN length > 6 THEN 0.3 ELSE 0.26 * length END AS pane) p $$;
COMMENT ON FUNCTION streetgen._car_ground(float8, float8) IS
    'A car from above whose front is at the origin and which heads east: a rectangle with the windscreen left out.';

CREATE OR REPLACE FUNCTION streetgen._standing_car(front geometry, heading float8, length float8, width float8)
    RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_SetSRID(ST_Affine(streetgen._car_ground(length, width), cosd(heading), -sind(heading),
        sind(heading), cosd(heading), ST_X(front), ST_Y(front)), ST_SRID(front)) $$;
COMMENT ON FUNCTION streetgen._standing_car(geometry, float8, float8, float8) IS
    'A car from above, by the place of its front and its heading, degrees counter-clockwise from east.';

CREATE OR REPLACE FUNCTION streetgen._density_kind(density float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN density < 1 THEN '' WHEN density < 15 THEN 'free' WHEN density < 30 THEN 'busy'
        WHEN density < 60 THEN 'dense' ELSE 'jam' END $$;
COMMENT ON FUNCTION streetgen._density_kind(float8) IS
    'How dense traffic is, of cars a kilometre of lane: nothing below 1, free below 15, busy below 30, dense below 60, '
    'else jam. A lane carries most at 26 to 38, and a jam has 143.';

CREATE OR REPLACE FUNCTION streetgen._link_grounds(model name)
    RETURNS TABLE(link_id bigint, level integer, width float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT k.link_id, e.level, k.width
        FROM link k JOIN lane l ON l.lane_id = coalesce(k.lane_id, k.lane_out) JOIN edge e USING (edge_id);
END $$;
COMMENT ON FUNCTION streetgen._link_grounds(name) IS
    'The level of each link, of a movement that of the lane that it leads to, and its width, metres.';

CREATE OR REPLACE FUNCTION streetgen._require_run(model name, run text) RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    kept record;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_traffic(model);
    -- One build kept the whole run.
    SELECT s.car_id, s.heading INTO kept FROM simulated s WHERE s.run = _require_run.run LIMIT 1;
    IF NOT FOUND THEN
        RAISE EXCEPTION 'model "%" kept no run "%"', model, run USING ERRCODE = '22023',
            HINT = coalesce((SELECT 'It has ' || string_agg(DISTINCT quote_literal(s.run), ', ') || '.'
                FROM simulated s), format('SELECT streetgen.keep_simulation(%L, %L) keeps one.', model, run));
    ELSIF kept.car_id IS NOT NULL AND kept.heading IS NULL THEN
        RAISE EXCEPTION 'run "%" of model "%" does not tell how its cars stand', run, model USING ERRCODE = '22023',
            DETAIL = 'An older build kept it.',
            HINT = format('SELECT streetgen.keep_simulation(%L, %L) keeps it anew.', model, run);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._require_run(name, text) IS
    'Raises 22023 for a run that a model did not keep, or that an older build kept without the heading of its cars, '
    'and 55000 where it has no traffic.';

CREATE OR REPLACE FUNCTION streetgen._shapes_of_cars(model name, box geometry) RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    near constant geometry := ST_Expand(box, 100);
    cars streetgen.traffic_car[];
BEGIN
    PERFORM streetgen._use_model(model);
    cars := ARRAY(SELECT (c.car_id, p.link_id, p.metres, c.speed, c.length, c.width, c.kind,
            c.route)::streetgen.traffic_car FROM car c JOIN car_place p USING (car_id) WHERE p.geom && near);
    IF cardinality(cars) > 0 THEN
        RETURN QUERY SELECT 'car', c.kind, g.level, ST_SetSRID(streetgen._standing_car(ST_MakePoint(f.x, f.y),
                degrees(f.heading), c.length, c.width), ST_SRID(box)), f.car_id
            -- Of many cars all links cost less than those near them.
            FROM streetgen._car_frames(CASE WHEN cardinality(cars) < 100 THEN streetgen._network_of_lanes(model,
                    streetgen._lanes_near_links(model, ARRAY(SELECT DISTINCT u.link_id FROM unnest(cars) u)))
                    ELSE streetgen._network_of_links(model) END, cars) f
                JOIN car c USING (car_id) JOIN unnest(cars) u USING (car_id)
                JOIN streetgen._link_grounds(model) g USING (link_id);
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._shapes_of_cars(name, geometry) IS 'The cars of table car in a box.';

CREATE OR REPLACE FUNCTION streetgen._shapes_of_run(model name, box geometry, run text, at float8)
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    near constant geometry := ST_Expand(box, 100);
    moment float8;
BEGIN
    PERFORM streetgen._use_model(model);
    moment := (SELECT max(s.t) FROM simulated s WHERE s.run = _shapes_of_run.run AND s.t <= at);
    RETURN QUERY SELECT 'car', s.kind, coalesce(g.level, 0),
            streetgen._standing_car(s.geom, s.heading, s.length, s.width), s.car_id
        FROM simulated s LEFT JOIN streetgen._link_grounds(model) g USING (link_id)
        WHERE s.run = _shapes_of_run.run AND s.t = moment AND s.car_id IS NOT NULL AND s.geom && near
        UNION ALL SELECT 'density', streetgen._density_kind(s.density), g.level,
            ST_Buffer(ST_Force2D(s.geom), g.width / 2, 'endcap=flat'), s.link_id
        FROM simulated s JOIN streetgen._link_grounds(model) g USING (link_id)
        WHERE s.run = _shapes_of_run.run AND s.t = moment AND s.density >= 1 AND s.geom && near;
END $$;
COMMENT ON FUNCTION streetgen._shapes_of_run(name, geometry, text, float8) IS
    'The cars, or the densities, of a run in a box at seconds at: its last state until then.';

CREATE OR REPLACE FUNCTION streetgen._level_in_picture(level integer, layers text[]) RETURNS integer
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN 'street' <> ALL (layers) THEN level END $$;
COMMENT ON FUNCTION streetgen._level_in_picture(integer, text[]) IS
    'The level of traffic in a picture of some layers; NULL, above all, where streets are lines.';

CREATE OR REPLACE FUNCTION streetgen._simulation_moving(model name, box geometry, layers text[], run text, at float8)
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog
    AS $$
BEGIN
    IF run IS NOT NULL THEN
        PERFORM streetgen._require_run(model, run);
        RETURN QUERY SELECT s.layer, s.kind, streetgen._level_in_picture(s.level, layers), s.geom, s.id
            FROM streetgen._shapes_of_run(model, box, run, at) s
            WHERE s.layer = 'car' AND 'car' = ANY (layers) OR s.layer = 'density' AND 'density' = ANY (layers);
    ELSIF 'car' = ANY (layers) AND streetgen._has_traffic(model)
        AND 'interconnection' = ANY (streetgen._subjects(model)) THEN
        RETURN QUERY SELECT s.layer, s.kind, streetgen._level_in_picture(s.level, layers), s.geom, s.id
            FROM streetgen._shapes_of_cars(model, box) s;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._simulation_moving(name, geometry, text[], text, float8) IS
    'What can be drawn of traffic in a box: car and density of a run at a time, or car of table car.';

-- From afar a car is a dot, and where streets are lines it lies above them.
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit, meaning)
SELECT theme, 'car', kind, from_scale, to_scale, place, fill, coalesce(rim, fill), width, 'pixel', meaning
FROM (VALUES ('street', '#1c4e80', '#b91c1c', '#15803d', '#ffffff'),
        ('dark', '#f6c453', '#ff8a7a', '#7bd88f', '#14171c'), ('print', '#000000', '#000000', '#000000', '#ffffff'),
        ('construction', '#1d4ed8', '#b91c1c', '#15803d', '#ffffff')) c(theme, car, bus, cycle, rim_near),
    LATERAL (VALUES ('', car, 'car'), ('bus', bus, 'bus'), ('cycle', cycle, 'bicycle')) k(kind, fill, meaning),
    LATERAL (VALUES (0::float8, 1500::float8, 8, rim_near, 0.5), (1500, 5000, 8, NULL, 1.2),
        (5000, 'Infinity', 920, NULL, 2)) s(from_scale, to_scale, place, rim, width);
INSERT INTO streetgen.symbol_rule (theme, layer, kind, from_scale, to_scale, place, fill, line, width, unit, meaning)
SELECT theme, 'density', kind, from_scale, to_scale, place + turn, hue, hue, width, 'pixel', meaning
FROM (VALUES (0.1, 'free', 'up to 15 cars a kilometre of lane', '#6aa84f', '#d9d9d9'),
        (0.2, 'busy', '15 to 30 cars a kilometre of lane', '#f2c14e', '#a6a6a6'),
        (0.3, 'dense', '30 to 60 cars a kilometre of lane', '#e4572e', '#666666'),
        (0.4, 'jam', 'over 60 cars a kilometre of lane', '#7b1e3b', '#000000')) d(turn, kind, meaning, colour, grey),
    unnest('{street,dark,print,construction}'::text[]) theme,
    LATERAL (SELECT CASE theme WHEN 'print' THEN grey ELSE colour END AS hue) f,
    (VALUES (0::float8, 5000::float8, 7.5, 0.5), (5000, 'Infinity', 919, 1.2)) s(from_scale, to_scale, place, width);
