-- Carriageways of one street: an estimated width gives way to the room that there is.

CREATE OR REPLACE FUNCTION streetgen._take_carriageways(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET jit = off SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
BEGIN
    PERFORM streetgen._use_model(model);
    ANALYZE pg_temp._import_line (class), pg_temp._import_meaning (class);
    CREATE TEMPORARY TABLE _import_carriageway ON COMMIT DROP AS
    SELECT row_number() OVER () AS number, l.way_id, l.class, coalesce(l.name, '') AS name, m.level,
        m.direction <> 'both' AS one_way,
        CASE m.direction WHEN 'reverse' THEN ST_Reverse(g.geom) ELSE g.geom END AS geom, length,
        CASE WHEN m.direction <> 'both' AND length < 1.2 * ST_Distance(ST_StartPoint(g.geom), ST_EndPoint(g.geom))
            THEN ST_Azimuth(ST_StartPoint(g.geom), ST_EndPoint(g.geom))
                + CASE m.direction WHEN 'reverse' THEN pi() ELSE 0 END END AS heading,
        num_nonnulls(m.width, m.lane_width_forward, m.lane_width_backward) = 0 AS estimated,
        m.direction <> 'both' AND EXISTS (SELECT FROM jsonb_object_keys(l.tags) key WHERE key ~ 'lanes') AS counted,
        n.lanes, k.kerbside,
        coalesce(m.width, least(200, streetgen.estimated_width(n.lanes::integer, CASE WHEN m.direction <> 'both'
            THEN coalesce(c.width_one_way, c.lanes_one_way * s.lane, c.width) ELSE c.width END, s.lane, s.usual)
            + k.kerbside)) AS width
    FROM pg_temp._import_line l
        JOIN pg_temp._import_meaning m ON m.tags = l.tags AND m.class IS NOT DISTINCT FROM l.class
        JOIN axis_class c ON c.class = l.class AND c.taken AND c.use = 'roadway' AND c.lanes_by_width,
        (SELECT (max(value) FILTER (WHERE name = 'lane_width'))::float8 AS lane,
            (max(value) FILTER (WHERE name = 'width_default'))::float8 AS usual,
            (max(value) FILTER (WHERE name = 'cycle_lane_width'))::float8 AS cycle,
            (max(value) FILTER (WHERE name = 'parking_lane_width'))::float8 AS parking FROM setting) s,
        LATERAL (SELECT coalesce(m.lane_count, nullif(coalesce(streetgen.driving_lanes(m.kind_forward),
            m.lanes_forward, 0) + coalesce(streetgen.driving_lanes(m.kind_backward), m.lanes_backward, 0)
            + coalesce(m.lanes_both, 0), 0)) AS lanes) n,
        LATERAL (SELECT streetgen._kerbside_width(m.kind_forward, m.lane_width_forward, s.lane, s.cycle, s.parking)
            + streetgen._kerbside_width(m.kind_backward, m.lane_width_backward, s.lane, s.cycle, s.parking)
            AS kerbside) k,
        LATERAL (SELECT CASE WHEN GeometryType(l.geom) = 'LINESTRING' THEN ST_Force2D(
            CASE ST_SRID(l.geom) WHEN srid THEN l.geom ELSE ST_Transform(l.geom, srid) END) END AS geom OFFSET 0) g,
        LATERAL (SELECT ST_Length(g.geom) AS length OFFSET 0) o
    WHERE m.roundabout_tag IS NULL AND length > 1;
    CREATE INDEX ON pg_temp._import_carriageway USING gist (geom) WHERE one_way;
    ANALYZE pg_temp._import_carriageway;
END $$;
COMMENT ON FUNCTION streetgen._take_carriageways(name) IS
    'Copies the lines of an import of OpenStreetMap, roundabouts apart, with the width that they become, to where '
    'their room is looked for. One-way lines run with the traffic; estimated: no width is stated; counted: lanes are; '
    'heading: where a straight one leads, hardly longer than from end to end. kerbside is what of the width lanes of '
    'the kerbs take.';

CREATE OR REPLACE FUNCTION streetgen._room_beside(median float8)
    RETURNS TABLE(way_id text, room float8)
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
-- Wider than 20 m no carriageway is estimated: those farther apart have room.
WITH near AS MATERIALIZED (
    SELECT a.number, a.geom, a.length, a.width, b.geom AS other, b.length AS other_length, b.width AS other_width,
        ST_Distance(a.geom, b.geom) AS apart
    FROM pg_temp._import_carriageway a, LATERAL (
        SELECT * FROM pg_temp._import_carriageway b WHERE b.one_way AND b.geom && ST_Expand(a.geom, 20) OFFSET 0) b
    WHERE a.one_way AND b.name = a.name AND b.level = a.level AND b.number <> a.number
        -- Most are the next line of the same carriageway.
        AND (cos(b.heading - a.heading) > 0) IS NOT TRUE),
pair AS (
    SELECT * FROM (
        SELECT *, min(apart) OVER own AS least, max(other_width) OVER own AS widest FROM near WHERE apart <= 20
        WINDOW own AS (PARTITION BY number)) n
    WHERE least - median < (width + widest) / 2),
-- A line once, with all that run beside it.
line AS MATERIALIZED (
    SELECT number, length, ceil(length / 10)::integer AS many, (array_agg(geom))[1] AS geom, array_agg(other) AS others,
        array_agg(other_length) AS lengths, array_agg(other_width) AS widths
    FROM pair GROUP BY number, length),
-- The other one goes on there, and runs the other way.
across AS (
    SELECT l.number, l.length, p.share, o.width AS other_width, ST_Distance(p.here, o.geom) AS apart
    FROM line l, LATERAL (
            SELECT share, ST_LineInterpolatePoint(l.geom, share) AS here
            FROM generate_series(1, l.many) nth, LATERAL (SELECT (nth - 0.5::float8) / l.many AS share) s OFFSET 0) p,
        LATERAL (SELECT ST_Expand(p.here, 20) AS box OFFSET 0) x,
        LATERAL unnest(l.others, l.lengths, l.widths) o(geom, length, width),
        LATERAL (SELECT ST_LineLocatePoint(o.geom, p.here) AS there, least(1, 1 / l.length) AS step,
            least(1, 1 / o.length) AS other_step WHERE o.geom && x.box AND ST_DWithin(o.geom, p.here, 20) OFFSET 0) t
    WHERE there > 0 AND there < 1 AND cos(ST_Angle(
            ST_LineInterpolatePoint(l.geom, greatest(0, share - step)),
            ST_LineInterpolatePoint(l.geom, least(1, share + step)),
            ST_LineInterpolatePoint(o.geom, greatest(0, there - other_step)),
            ST_LineInterpolatePoint(o.geom, least(1, there + other_step)))) < -0.9),
nearest AS (SELECT DISTINCT ON (number, share) * FROM across ORDER BY number, share, apart),
measured AS (
    SELECT number, percentile_cont(ARRAY[0.1, 0.75]) WITHIN GROUP (ORDER BY apart) AS apart,
        max(other_width) AS other_width
    FROM nearest GROUP BY number, length HAVING 2 * count(*) >= ceil(length / 10)),
-- Two lines that part or meet lie near each other at one end alone.
spacing AS (SELECT number, apart[1] AS spacing, other_width FROM measured WHERE apart[2] <= 1.5 * apart[1])
SELECT c.way_id::text, greatest(2.5, floor(10 * (s.spacing - median)) / 10)
FROM pg_temp._import_carriageway c JOIN spacing s USING (number)
WHERE (c.width + s.other_width) / 2 > s.spacing - median
$$;
COMMENT ON FUNCTION streetgen._room_beside(float8) IS
    'Of the one-way lines of an import beside which lines of the same name run the other way, nearer than both are '
    'wide: what their spacing leaves beside a median of a width in metres.';

CREATE OR REPLACE FUNCTION streetgen._room_where_streets_part(lane_width float8)
    RETURNS TABLE(way_id text, room float8)
    LANGUAGE sql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
WITH line_end AS MATERIALIZED (
    SELECT c.number, c.way_id, c.class, c.level, c.one_way, c.width, c.kerbside, e.leaves,
        NOT c.counted AND c.length <= 100 AS short, ST_AsBinary(e.place) AS place
    FROM pg_temp._import_carriageway c,
        LATERAL (VALUES (true, ST_StartPoint(c.geom)), (false, ST_EndPoint(c.geom))) e(leaves, place)),
parting AS (
    SELECT place, max(width - kerbside) FILTER (WHERE NOT one_way) AS width FROM line_end GROUP BY place
    HAVING count(*) = 3 AND count(*) FILTER (WHERE one_way AND leaves) = 1
        AND count(*) FILTER (WHERE one_way AND NOT leaves) = 1 AND min(class) = max(class) AND min(level) = max(level))
SELECT e.way_id::text, greatest(lane_width, min(p.width) / 2) + e.kerbside FROM line_end e JOIN parting p USING (place)
WHERE e.one_way AND e.short GROUP BY e.number, e.way_id, e.kerbside
$$;
COMMENT ON FUNCTION streetgen._room_where_streets_part(float8) IS
    'Of the one-way lines of an import up to 100 m long that state no lanes and into which a two-way street of their '
    'class parts, as about the island before a roundabout: what one direction of that street has, at least a lane of a '
    'width in metres, and the lanes of the kerbs.';

CREATE OR REPLACE FUNCTION streetgen._settle_carriageways(model name)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._take_carriageways(model);
    CREATE TEMPORARY TABLE _import_room ON COMMIT DROP AS
    SELECT c.way_id, c.class, c.estimated, min(l.room) AS room, bool_or(r.beside) AS beside,
        bool_or(NOT r.beside) AND min(l.room) - max(c.kerbside)
            < 2 * streetgen._narrowest_of_several(max(s.lane_width)) AS one_lane
    FROM (SELECT streetgen._setting_number(model, 'lane_width') AS lane_width,
            streetgen._setting_number(model, 'lane_width_minimal') AS narrowest,
            streetgen._setting_number(model, 'median_width_minimal') AS median) s,
        LATERAL (SELECT *, true AS beside FROM streetgen._room_beside(s.median)
            UNION ALL SELECT *, false FROM streetgen._room_where_streets_part(s.lane_width)) r
        JOIN pg_temp._import_carriageway c ON c.way_id::text = r.way_id,
        LATERAL (SELECT greatest(r.room, CASE WHEN c.counted THEN c.lanes * s.narrowest + c.kerbside END) AS room) l
    WHERE l.room < c.width GROUP BY c.way_id, c.class, c.estimated;
    DROP TABLE pg_temp._import_carriageway;
    RETURN QUERY SELECT CASE WHEN NOT r.estimated THEN 'stated width of a carriageway is more than its spacing'
            WHEN r.beside THEN 'carriageway as wide as its spacing leaves room for'
            ELSE 'carriageway where a street parts, as wide as one direction of it' END,
        r.class, count(*), array_agg(r.way_id::text ORDER BY r.way_id)
        FROM pg_temp._import_room r WHERE r.estimated OR r.beside GROUP BY 1, 2 ORDER BY 1, 2;
    DELETE FROM pg_temp._import_room r WHERE NOT r.estimated;
END $$;
COMMENT ON FUNCTION streetgen._settle_carriageways(name) IS
    'Finds the one-way lines of an import that are wider than the room that they have: table _import_room gives those '
    'whose width is estimated another one, and one_lane those in which estimated lanes have room for one. Tells '
    'of each class how many there are, and of those that state a width.';

CREATE OR REPLACE FUNCTION streetgen._with_one_lane(kinds text) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE
    RETURN regexp_replace(kinds, '(general\|)+general', 'general');
COMMENT ON FUNCTION streetgen._with_one_lane(text) IS
    'A list of kinds of lanes in which general lanes side by side are one.';
