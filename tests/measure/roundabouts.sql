-- The roundabouts of a model that are found, held against the tags of its source, which are hidden: psql -v model=M -f tests/measure/roundabouts.sql
-- The rings come from the axes and settings alone, so that no streets need be there. A hit agrees in centre within 5 m and in radius within 25 %.
-- With -v guess=TABLE also the rings (geom) that another program guesses, as netconvert; with -v sheet=FILE a picture of each false hit and each miss.
-- Prints recall and precision of both halves (by the id in the source, and by place) at setting roundabout_accept; with -v curve=FILE also the curves, as CSV.
\set ON_ERROR_STOP on
\set QUIET on
\pset footer off
BEGIN;
SELECT streetgen.set(:'model', 'roundabout_tags', 'false') \gset
CREATE TEMP TABLE truth ON COMMIT DROP AS
SELECT g.number, way, geom, c.centre, radius FROM (
    SELECT number, ST_Collect(geom) AS geom, min(substring(source_ref FROM '\d+')::bigint) AS way
    FROM (SELECT ST_Force2D(geom) AS geom, source_ref, ST_ClusterDBSCAN(ST_Force2D(geom), 0.5, 1) OVER (ORDER BY axis_id) AS number
        FROM :"model".axis WHERE roundabout_tag IS NOT NULL) t GROUP BY number) g,
    LATERAL (SELECT ST_Centroid(ST_ConvexHull(geom)) AS centre) c,
    LATERAL (SELECT avg(ST_Distance(c.centre, p.geom)) AS radius FROM ST_DumpPoints(ST_Segmentize(geom, 1)) p) r;
CREATE TEMP TABLE ring ON COMMIT DROP AS
SELECT r.number, geom::geometry AS geom, centre::geometry AS centre, radius, streetgen.roundabout_shape(on_circle, compactness) AS shape,
    (SELECT streetgen.roundabout_name(array_agg(a.name), (SELECT array_agg(pattern) FROM :"model".roundabout_pattern)) FROM unnest(edge_axes) x JOIN :"model".axis a ON a.axis_id = x) AS name,
    streetgen.roundabout_network(one_way, against, arm_nodes, single_arm, inside) AS network, streetgen.roundabout_network(0, 0, arm_nodes, single_arm, inside) AS network_two_way
FROM (SELECT array_agg(axis_id ORDER BY axis_id) AS ids, array_agg(ST_Force2D(geom)::bytea ORDER BY axis_id) AS lines, array_agg(level ORDER BY axis_id) AS levels,
        array_agg(CASE direction WHEN 'direct' THEN 1 WHEN 'reverse' THEN -1 ELSE 0 END ORDER BY axis_id) AS one_ways, array_agg(on_ring ORDER BY axis_id) AS tagged, array_agg(width ORDER BY axis_id) AS widths, array_agg(width_end ORDER BY axis_id) AS widths_end,
        array_agg(roadway_offset ORDER BY axis_id) AS offsets, array_agg(importance ORDER BY axis_id) AS importances, array_agg(lanes_forward + lanes_both ORDER BY axis_id) AS forward, array_agg(lanes_backward + lanes_both ORDER BY axis_id) AS backward FROM :"model".axis_used) u,
    (SELECT jsonb_object_agg(s.name, value) AS v FROM :"model".setting s) s,
    streetgen._network_rings(ids, lines, levels, one_ways, tagged, widths, widths_end, offsets, importances, forward, backward, (v ->> 'tolerance')::float8, (v ->> 'roundabout_radius_least')::float8, (v ->> 'roundabout_radius_greatest')::float8,
        (v ->> 'roundabout_shape_least')::float8, v ->> 'crossing' = 'split',
        streetgen._driving_side(:'model') = 'right',
        ARRAY(SELECT ROW (axis_id, abscissa, kind, direction)::streetgen.street_control
            FROM :"model".control_point WHERE axis_id IS NOT NULL ORDER BY control_point_id),
        (v ->> 'control_distance')::float8, (v ->> 'queue_length')::float8) r;
CREATE TEMP TABLE known ON COMMIT DROP AS
SELECT known, r.number, r.centre, r.radius, hit, floor(ST_X(r.centre))::bigint % 2 AS half,
    streetgen.roundabout_score(shape, CASE WHEN known ~ 'names|neither' THEN 0.5 ELSE name END, CASE WHEN known ~ 'one-way|neither' THEN network_two_way ELSE network END, weights) AS score
FROM ring r, unnest(ARRAY['all', 'no names', 'no one-way', 'neither']) known,
    (SELECT ARRAY[max(value) FILTER (WHERE name ~ 'shape'), max(value) FILTER (WHERE name ~ 'name$'), max(value) FILTER (WHERE name ~ 'network')]::float8[] AS weights
        FROM :"model".setting WHERE name LIKE 'roundabout_weight%') w,
    LATERAL (SELECT (SELECT t.number FROM truth t WHERE ST_DWithin(t.centre, r.centre, 5) AND abs(t.radius - r.radius) <= 0.25 * t.radius
        ORDER BY ST_Distance(t.centre, r.centre) LIMIT 1) AS hit) h;
\if :{?guess}
INSERT INTO known SELECT 'netconvert', -g.number, c.centre, r.radius, (SELECT t.number FROM truth t WHERE ST_DWithin(t.centre, c.centre, 5) AND abs(t.radius - r.radius) <= 0.25 * t.radius
    ORDER BY ST_Distance(t.centre, c.centre) LIMIT 1), floor(ST_X(c.centre))::bigint % 2, 1
FROM (SELECT number, ST_Collect(geom) AS geom FROM (SELECT geom, ST_ClusterDBSCAN(geom, 0.5, 1) OVER (ORDER BY geom) AS number FROM :guess) t GROUP BY number) g,
    LATERAL (SELECT ST_Centroid(ST_ConvexHull(geom)) AS centre) c,
    LATERAL (SELECT avg(ST_Distance(c.centre, p.geom)) AS radius FROM ST_DumpPoints(ST_Segmentize(geom, 1)) p) r;
\endif
CREATE TEMP TABLE curve ON COMMIT DROP AS
SELECT k.known, h.half, threshold, found, (SELECT count(*) FROM truth WHERE way % 2 = h.half) AS rings, wrong
FROM (SELECT DISTINCT known FROM known) k, generate_series(0, 1) h(half), (SELECT n::numeric / 100 AS threshold FROM generate_series(30, 95) n) t,
    LATERAL (SELECT count(DISTINCT hit) AS found FROM known n JOIN truth ON truth.number = hit WHERE n.known = k.known AND way % 2 = h.half AND score >= threshold) f,
    LATERAL (SELECT count(*) AS wrong FROM known n WHERE n.known = k.known AND hit IS NULL AND n.half = h.half AND score >= threshold) w;
SELECT known, CASE half WHEN 0 THEN 'even' ELSE 'odd' END AS half, rings, found, wrong, round(found::numeric / nullif(rings, 0), 3) AS recall, round(found::numeric / nullif(found + wrong, 0), 3) AS precision
FROM curve WHERE threshold = (SELECT value::numeric FROM :"model".setting WHERE name = 'roundabout_accept') ORDER BY array_position('{all,no names,no one-way,neither,netconvert}', known), half;
SELECT ST_X(centre)::bigint AS x, ST_Y(centre)::bigint AS y, round(radius) AS radius, round(score::numeric, 2) AS score
FROM known WHERE known = 'all' AND hit IS NULL AND score >= (SELECT value::numeric FROM :"model".setting WHERE name = 'roundabout_accept') ORDER BY score DESC, x LIMIT 20;
\if :{?curve}
COPY (SELECT known, half, threshold, round(found::numeric / nullif(rings, 0), 3) AS recall, round(found::numeric / nullif(found + wrong, 0), 3) AS precision FROM curve ORDER BY 1, 2, 3) TO STDOUT (FORMAT csv, HEADER) \g :curve
\endif
\if :{?sheet}
\ir roundabout_sheet.sql
\endif
ROLLBACK;
