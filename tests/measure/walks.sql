-- The network on foot of a model against the lines of its source, by extension pgrouting:
-- psql -v model=NAME -v streets=true -f tests/measure/walks.sql
-- With streets people walk on all streets of the source too, as where it maps few sidewalks. Printed are the shares of
-- the largest part by length, of walk_link and of the source, percent; then of 1,000 pairs of nodes of the source,
-- 300 m apart or more: how many have a way on the source, how many of these none by walk_link, percentiles of the
-- length by walk_link as share of that on the source. The nearest node of walk_link
-- within 25 m stands for that of the source.
CREATE EXTENSION IF NOT EXISTS pgrouting;
CREATE TEMPORARY TABLE ours AS SELECT walk_link_id AS id, from_node AS source, to_node AS target, metres AS cost, geom
    FROM :"model".walk_link;
CREATE TEMPORARY TABLE line AS
SELECT row_number() OVER () AS number, * FROM (
    SELECT level, ST_Force2D(geom) AS geom FROM :"model".footway f LEFT JOIN :"model".axis_class c ON c.class = f.kind
        WHERE foot IS DISTINCT FROM 'no' AND (use IS DISTINCT FROM 'cycle' OR foot IS NOT NULL)
    UNION ALL SELECT level, ST_Force2D(geom) FROM :"model".axis a LEFT JOIN :"model".axis_class c ON c.class = a.kind
        WHERE :streets AND coalesce(walked_along, true)) l;
CREATE TEMPORARY TABLE drawn AS
SELECT row_number() OVER () AS id, from_node AS source, to_node AS target, ST_Length(geom) AS cost, geom
    FROM (SELECT array_agg(geom::bytea ORDER BY number) AS lines, array_agg(level ORDER BY number) AS levels,
        array_agg(true) AS mapped, array_agg(0::float8) AS none FROM line) l,
        streetgen._walk_network(lines, levels, mapped, none, none, none, none, (SELECT srid FROM streetgen.model
            WHERE name = :'model')) n;
CREATE TEMPORARY VIEW drawn_part AS
SELECT part, d.*, sum(cost) OVER (PARTITION BY part) AS metres
FROM drawn d JOIN streetgen._walk_parts(ARRAY(SELECT source FROM drawn ORDER BY id),
    ARRAY(SELECT target FROM drawn ORDER BY id)) p ON p.number = d.id;
SELECT round((100 * max(metres) / sum(cost))::numeric, 1) AS walk_link_in_one_part, (SELECT round((100 * max(metres)
        / sum(cost))::numeric, 1) FROM drawn_part) AS source_in_one_part, round((sum(cost) / 1000)::numeric, 1) AS km,
    (SELECT round((sum(cost) / 1000)::numeric, 1) FROM drawn) AS source_km
FROM (SELECT cost, sum(cost) OVER (PARTITION BY part) AS metres
    FROM (SELECT *, row_number() OVER (ORDER BY id) AS number FROM ours) o
        JOIN streetgen._walk_parts(ARRAY(SELECT source FROM ours ORDER BY id), ARRAY(SELECT target
            FROM ours ORDER BY id)) p USING (number)) o;
CREATE TEMPORARY TABLE our_node AS SELECT DISTINCT ON (node) node, v.geom
    FROM ours, LATERAL (VALUES (source, ST_StartPoint(ours.geom)), (target, ST_EndPoint(ours.geom))) v(node, geom);
CREATE INDEX ON our_node USING gist (geom);
CREATE TEMPORARY TABLE place AS
SELECT row_number() OVER (ORDER BY md5(p.node::text)) AS n, p.node, p.geom, o.node AS ours
FROM (SELECT DISTINCT ON (node) node, v.geom FROM drawn_part d, LATERAL (VALUES (source, ST_StartPoint(d.geom)),
            (target, ST_EndPoint(d.geom))) v(node, geom)
        WHERE metres = (SELECT max(metres) FROM drawn_part)) p,
    LATERAL (SELECT node, geom FROM our_node o ORDER BY o.geom <-> p.geom LIMIT 1) o
WHERE ST_DWithin(p.geom, o.geom, 25);
CREATE TEMPORARY TABLE pair AS
SELECT a.node AS source, b.node AS target, a.ours AS our_source, b.ours AS our_target
FROM (SELECT count(*) AS places FROM place) c, generate_series(0, 9999) i
    JOIN place a ON true JOIN place b ON true
WHERE a.n = 1 + 7919 * i % places AND b.n = 1 + (104729 * i + 31) % places AND ST_Distance(a.geom, b.geom) >= 300
ORDER BY i LIMIT 1000;
SELECT count(*) AS with_a_way, count(*) FILTER (WHERE o.agg_cost IS NULL) AS without_by_walk_link,
    percentile_cont(ARRAY[0.05, 0.5, 0.95, 1]) WITHIN GROUP (ORDER BY round((o.agg_cost / d.agg_cost)::numeric, 3))
        AS share_of_the_length
FROM pair p
    JOIN pgr_dijkstraCost('SELECT id, source, target, cost FROM drawn', 'SELECT DISTINCT source, target FROM pair',
        false) d
        ON (d.start_vid, d.end_vid) = (p.source, p.target)
    LEFT JOIN pgr_dijkstraCost('SELECT id, source, target, cost FROM ours', 'SELECT DISTINCT our_source AS source, '
        'our_target AS target FROM pair', false) o ON (o.start_vid, o.end_vid) = (our_source, our_target)
WHERE our_source <> our_target;
