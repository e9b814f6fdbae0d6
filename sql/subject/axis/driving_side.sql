-- The side of the road that one drives on, told by the network: one-way rings and one-way pairs.

CREATE OR REPLACE FUNCTION streetgen._driving_side(model name) RETURNS text
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$
BEGIN
    RETURN CASE streetgen._setting_text(model, 'driving_side') WHEN 'left' THEN 'left' ELSE 'right' END;
END $$;
COMMENT ON FUNCTION streetgen._driving_side(name) IS
    'The side of the road that a model drives on, left or right; auto is right until an importer finds another.';

CREATE OR REPLACE FUNCTION streetgen._turning(line geometry) RETURNS float8
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
    SELECT coalesce(sum(CASE WHEN turn > pi() THEN turn - 2 * pi() WHEN turn < -pi() THEN turn + 2 * pi()
        ELSE turn END), 0)
    FROM (SELECT lag(heading) OVER (ORDER BY path) - heading AS turn
          FROM (SELECT path, ST_Azimuth(lag(geom) OVER (ORDER BY path), geom) AS heading
                FROM ST_DumpPoints(line)) h WHERE heading IS NOT NULL) t $$;
COMMENT ON FUNCTION streetgen._turning(geometry) IS
    'How far a LINESTRING turns from its start to its end, radians; to the left is positive.';

CREATE OR REPLACE FUNCTION streetgen._one_way_rings(model name, OUT rings_right bigint, OUT rings_left bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH RECURSIVE bent AS MATERIALIZED (
        SELECT axis_id, geom, sign(turning) AS sense, ST_StartPoint(geom) AS tail, ST_EndPoint(geom) AS tip,
            ST_Length(geom) AS metres
        FROM (SELECT axis_id, geom, streetgen._turning(geom) AS turning
              FROM (SELECT axis_id, CASE direction WHEN 'reverse' THEN ST_Reverse(ST_Force2D(geom))
                        ELSE ST_Force2D(geom) END AS geom
                    FROM axis_used WHERE direction <> 'both' AND ST_NPoints(geom) > 2 AND ST_Length(geom) < 400) a) t
        WHERE abs(turning) > radians(20)),
    walk AS (
        SELECT axis_id AS first, ARRAY[axis_id] AS axes, geom AS line, sense, tail, tip, metres FROM bent
        UNION ALL
        SELECT w.first, w.axes || b.axis_id, ST_MakeLine(w.line, b.geom), w.sense, w.tail, b.tip, w.metres + b.metres
        FROM walk w JOIN bent b ON b.tail = w.tip AND b.sense = w.sense
        -- A ring is walked from the smallest of its axes alone.
        WHERE NOT w.tip = w.tail AND b.axis_id > w.first AND b.axis_id <> ALL (w.axes) AND w.metres + b.metres < 400
            AND cardinality(w.axes) < 12),
    ring AS (
        SELECT sense FROM walk WHERE tip = tail AND ST_NPoints(line) > 3
            -- Rounder than a square.
            AND abs(ST_Area(ST_MakePolygon(line))) > 0.8 * metres ^ 2 / (4 * pi()))
    SELECT count(*) FILTER (WHERE sense > 0), count(*) FILTER (WHERE sense < 0)
        INTO rings_right, rings_left FROM ring;
END $$;
COMMENT ON FUNCTION streetgen._one_way_rings(name) IS
    'One-way rings of a model, round and under 400 m about, of one axis or several: those that turn to the left are '
    'of right-hand traffic.';

CREATE OR REPLACE FUNCTION streetgen._one_way_pairs(model name, OUT pairs_right bigint, OUT pairs_left bigint)
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET jit = off
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    WITH way AS (
        SELECT axis_id, name, level, ST_LineInterpolatePoint(line, 0.5) AS middle, ST_Azimuth(
            ST_LineInterpolatePoint(line, 0.45), ST_LineInterpolatePoint(line, 0.55)) AS heading
        FROM (SELECT axis_id, name, level, CASE direction WHEN 'reverse' THEN ST_Reverse(ST_Force2D(geom))
                  ELSE ST_Force2D(geom) END AS line
              FROM axis WHERE direction <> 'both' AND name <> '' AND ST_Length(geom) > 20) a)
    -- The way back lies to the left of who drives on the right.
    SELECT count(*) FILTER (WHERE across < 0), count(*) FILTER (WHERE across > 0) INTO pairs_right, pairs_left
    FROM way w, LATERAL (
        SELECT sin(ST_Azimuth(w.middle, foot) - w.heading) AS across, cos(streetgen._heading(b.geom, foot)
            + CASE b.direction WHEN 'reverse' THEN pi() ELSE 0 END - w.heading) AS along
        FROM axis b, LATERAL (SELECT ST_ClosestPoint(ST_Force2D(b.geom), w.middle) AS foot) f
        WHERE b.direction <> 'both' AND b.name = w.name AND b.level = w.level AND b.axis_id <> w.axis_id
            AND ST_DWithin(b.geom, w.middle, 40) AND ST_Distance(foot, w.middle) > 2
        ORDER BY ST_Distance(foot, w.middle) LIMIT 1) b
    WHERE along < -0.9 AND abs(across) > 0.9;
END $$;
COMMENT ON FUNCTION streetgen._one_way_pairs(name) IS
    'One-way axes of a model beside the nearest one-way axis of the same name within 40 m, where it runs the other '
    'way: of right-hand traffic where it lies to the left.';

CREATE OR REPLACE FUNCTION streetgen.driving_side(model name)
    RETURNS TABLE(evidence text, count_right bigint, count_left bigint, side text)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    fewest constant integer := 3;
    clear constant float8 := 0.8;
BEGIN
    PERFORM streetgen._require_reader(model);
    RETURN QUERY
        SELECT e.evidence, e.count_right, e.count_left,
            CASE WHEN e.count_right + e.count_left >= fewest THEN
                CASE WHEN e.count_right >= clear * (e.count_right + e.count_left) THEN 'right'
                     WHEN e.count_left >= clear * (e.count_right + e.count_left) THEN 'left' ELSE 'contradicts' END END
        FROM (SELECT 'one-way rings', rings_right, rings_left FROM streetgen._one_way_rings(model)
              UNION ALL SELECT 'one-way pairs', pairs_right, pairs_left FROM streetgen._one_way_pairs(model))
            e(evidence, count_right, count_left);
END $$;
COMMENT ON FUNCTION streetgen.driving_side(name) IS
    'What the one-way axes of a model say of the side that one drives on, a row for each kind of evidence. One-way '
    'rings are round and under 400 m about; one-way pairs are axes of one name, within 40 m, that run against each '
    'other. side: right or left where at least three of a kind say so, and four fifths of them; contradicts where '
    'there are three and no such share; NULL: too few. An unknown model: 3F000.';

CREATE OR REPLACE FUNCTION streetgen._found_driving_side(model name) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN min(side) = max(side) THEN nullif(min(side), 'contradicts') END
        FROM streetgen.driving_side(model) $$;
COMMENT ON FUNCTION streetgen._found_driving_side(name) IS
    'The side that all evidence agrees on, left or right; NULL: none, or the evidence contradicts.';
