-- A run that was kept as what moves in a picture.

CREATE OR REPLACE FUNCTION streetgen._shown_as_svg(keys float8[], shown boolean[], seconds float8) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN count(*) > 1 OR bool_and(k > 0) THEN format('<animate attributeName="visibility" '
            'calcMode="discrete" dur="%ss" repeatCount="indefinite" values="%s" keyTimes="%s"/>', seconds,
            CASE WHEN min(k) > 0 THEN 'hidden;' ELSE '' END
                || string_agg(CASE WHEN s THEN 'visible' ELSE 'hidden' END, ';' ORDER BY k),
            CASE WHEN min(k) > 0 THEN '0;' ELSE '' END || string_agg(k::text, ';' ORDER BY k)) ELSE '' END
        FROM unnest(keys, shown) u(k, s) WHERE k < 1 $$;
COMMENT ON FUNCTION streetgen._shown_as_svg(float8[], boolean[], float8) IS
    'The part of SVG by which something is shown, or not, from parts of a duration on; before the first it is not.';

CREATE OR REPLACE FUNCTION streetgen._moved_as_svg(kind text, more text, keys float8[], places text[], seconds float8)
    RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT format('<animateTransform attributeName="transform" type="%s"%s dur="%ss" repeatCount="indefinite" '
            'values="%s" keyTimes="%s"/>', kind, more, seconds,
            concat_ws(';', CASE WHEN keys[1] > 0 THEN places[1] END, array_to_string(places, ';'),
                CASE WHEN keys[last] < 1 THEN places[last] END),
            concat_ws(';', CASE WHEN keys[1] > 0 THEN 0 END, array_to_string(keys, ';'),
                CASE WHEN keys[last] < 1 THEN 1 END))
        FROM cardinality(keys) last $$;
COMMENT ON FUNCTION streetgen._moved_as_svg(text, text, float8[], text[], float8) IS
    'The part of SVG by which something goes from place to place at parts of a duration, and stands before and after.';

CREATE OR REPLACE FUNCTION streetgen._moments(model name, run text)
    RETURNS TABLE(t float8, n bigint, key float8, next_key float8, seconds float8)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 600 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY SELECT m.t, row_number() OVER w, k.key, coalesce(lead(k.key) OVER w, 1), m.long
        FROM (SELECT s.t, min(s.t) OVER () AS first, max(s.t) OVER () - min(s.t) OVER () AS long
            FROM simulated s WHERE s.run = _moments.run GROUP BY s.t) m,
            LATERAL (SELECT round((coalesce((m.t - m.first) / nullif(m.long, 0), 0))::numeric, 5)::float8 AS key) k
        WINDOW w AS (ORDER BY m.t);
END $$;
COMMENT ON FUNCTION streetgen._moments(name, text) IS
    'The times of a run that was kept, in order. n: its number from 1. key and next_key: this time and the next one '
    'as parts of the whole, 0 to 1. seconds: how long the whole is.';

CREATE OR REPLACE FUNCTION streetgen._animated_cars(model name, box geometry, run text, pace float8)
    RETURNS SETOF streetgen.animated_shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    near constant geometry := ST_Expand(box, 30);
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH moment AS MATERIALIZED (SELECT * FROM streetgen._moments(model, run)),
    state AS (
        SELECT s.car_id, s.kind, s.length, s.width, m.n, m.key, m.next_key, coalesce(g.level, 0) AS level,
            greatest(1, m.seconds) / pace AS seconds,
            ST_X(s.geom) - ST_XMin(box) AS x, ST_YMax(box) - ST_Y(s.geom) AS y,
            -s.heading - 360 * sum(round((-s.heading + s.before) / 360)) OVER (PARTITION BY s.car_id ORDER BY s.t)
                AS turned
        FROM (SELECT *, coalesce(lag(heading) OVER (PARTITION BY car_id ORDER BY t), heading) AS before
                FROM simulated WHERE run = _animated_cars.run AND car_id IS NOT NULL AND geom && near) s
            JOIN moment m USING (t) LEFT JOIN streetgen._link_grounds(model) g USING (link_id)),
    -- On each level it is a shape of its own, up to where it is next.
    part AS (
        SELECT *, n - row_number() OVER (PARTITION BY car_id, level ORDER BY n) AS part,
            CASE WHEN lead(n) OVER w = n + 1 THEN ARRAY[lead(x) OVER w, lead(y) OVER w, lead(turned) OVER w] END
                AS next,
            (x, y, turned) IS NOT DISTINCT FROM (lag(x) OVER w, lag(y) OVER w, lag(turned) OVER w)
                AND (x, y, turned) IS NOT DISTINCT FROM (lead(x) OVER w, lead(y) OVER w, lead(turned) OVER w)
                AND lag(level) OVER w = level AND lead(level) OVER w = level
                AND lag(n) OVER w = n - 1 AND lead(n) OVER w = n + 1 AS stands
        FROM state WINDOW w AS (PARTITION BY car_id ORDER BY n)),
    place AS (
        SELECT p.car_id, p.kind, p.level, p.part, p.length, p.width, p.seconds, u.key, u.x, u.y, u.turned, p.next_key
        FROM (SELECT *, lead(n) OVER (PARTITION BY car_id, level, part ORDER BY n) IS NULL AS ends FROM part) p,
            LATERAL (SELECT p.key, p.x, p.y, p.turned WHERE NOT p.stands
                UNION ALL SELECT p.next_key, p.next[1], p.next[2], p.next[3] WHERE p.ends AND p.next IS NOT NULL)
            u(key, x, y, turned)),
    whole AS (
        SELECT car_id, kind, level, length, width, seconds, array_agg(key ORDER BY key) AS keys,
            array_agg(concat(round(x::numeric, 2), ' ', round(y::numeric, 2)) ORDER BY key) AS places,
            array_agg(round(turned::numeric, 1)::text ORDER BY key) AS turns, min(key) AS first,
            max(next_key) AS last
        FROM place GROUP BY car_id, kind, level, part, length, width, seconds)
    SELECT 'car', w.kind, w.level, w.car_id, format('<path d="%s" transform="translate(%s) rotate(%s)"%s>%s%s%s</path>',
        ST_AsSVG(streetgen._car_ground(w.length, w.width), 1, 2), w.places[1], w.turns[1],
        CASE WHEN w.first > 0 THEN ' visibility="hidden"' ELSE '' END,
        streetgen._shown_as_svg(ARRAY[w.first, w.last], '{true,false}', w.seconds),
        streetgen._moved_as_svg('translate', '', w.keys, w.places, w.seconds),
        streetgen._moved_as_svg('rotate', ' additive="sum"', w.keys, w.turns, w.seconds))
    FROM whole w;
END $$;
COMMENT ON FUNCTION streetgen._animated_cars(name, geometry, text, float8) IS
    'The cars of a run that come through a box, each on each level on which it drives.';

CREATE OR REPLACE FUNCTION streetgen._animated_densities(model name, box geometry, run text, pace float8)
    RETURNS SETOF streetgen.animated_shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH state AS (
        SELECT s.link_id, s.metres, s.geom, m.key, m.next_key, greatest(1, m.seconds) / pace AS seconds, s.kind,
            s.kind IS DISTINCT FROM lag(s.kind) OVER w AS begins, s.kind IS DISTINCT FROM lead(s.kind) OVER w AS ends
        FROM (SELECT link_id, metres, geom, t, streetgen._density_kind(density) AS kind FROM simulated
                WHERE run = _animated_densities.run AND car_id IS NULL AND geom && box) s
            JOIN streetgen._moments(model, run) m USING (t)
        WINDOW w AS (PARTITION BY s.link_id, s.metres ORDER BY s.t)),
    cell AS (
        SELECT s.link_id, s.metres, s.kind, s.seconds, (array_agg(s.geom))[1] AS geom, min(c.key) AS first,
            array_agg(c.key ORDER BY c.key) AS keys, array_agg(c.shown ORDER BY c.key) AS shown
        FROM state s, LATERAL (SELECT s.key, true WHERE s.begins UNION ALL SELECT s.next_key, false WHERE s.ends)
            c(key, shown)
        WHERE s.kind <> '' GROUP BY s.link_id, s.metres, s.kind, s.seconds)
    SELECT 'density', c.kind, g.level, c.link_id, format('<path d="%s"%s>%s</path>',
        ST_AsSVG(ST_Translate(ST_Buffer(ST_Force2D(c.geom), g.width / 2, 'endcap=flat'), -ST_XMin(box), -ST_YMax(box)),
            1, 1), CASE WHEN c.first > 0 THEN ' visibility="hidden"' ELSE '' END,
        streetgen._shown_as_svg(c.keys, c.shown, c.seconds))
    FROM cell c JOIN streetgen._link_grounds(model) g USING (link_id);
END $$;
COMMENT ON FUNCTION streetgen._animated_densities(name, geometry, text, float8) IS
    'The cells of a run in a box, each once for each kind of density that it has.';

CREATE OR REPLACE FUNCTION streetgen._simulation_animated(model name, box geometry, layers text[], run text,
    pace float8) RETURNS SETOF streetgen.animated_shape
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog
    AS $$
BEGIN
    PERFORM streetgen._require_run(model, run);
    RETURN QUERY SELECT a.layer, a.kind, streetgen._level_in_picture(a.level, layers), a.id, a.element
        FROM (SELECT * FROM streetgen._animated_cars(model, box, run, pace)
            UNION ALL SELECT * FROM streetgen._animated_densities(model, box, run, pace)) a
        WHERE a.layer = ANY (layers);
END $$;
COMMENT ON FUNCTION streetgen._simulation_animated(name, geometry, text[], text, float8) IS
    'What moves of a run in a box: car and density, pace times as fast.';
