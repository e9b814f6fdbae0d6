-- Heights of roads of a model with subject height: psql -v model=MODEL
-- Printed: km of stated bridges without heights of their own, but for ten metres at each end and those under 30 m that
-- cross nothing, and how much of them lies under half a metre over the ground, %; crossings of one axis in turn, nearer
-- than its clearance by its usual grade, and those between which it dips by over half a metre; crossings whose
-- clearance does not hold; km off the ground, and how much of that is steeper than usual, %; vertices off the ground,
-- those where a car rises or sinks at over 0.5 m/s2, and kinks of over a degree, %.
SET search_path = :"model", public;
CREATE TEMPORARY TABLE road AS
    SELECT e.edge_id, e.axis_id, e.level, e.from_node, e.to_node, e.speed, ST_Length(p.geom::geometry) AS metres,
        p.geom, ST_Length2D(e.geom) AS length, e.geom AS line,
        CASE WHEN ST_NDims(e.geom) = 2 THEN ST_Force3D(e.geom) ELSE e.geom END AS ground,
        ST_NDims(e.geom) = 2 OR ST_ZMin(e.geom) = 0 AND ST_ZMax(e.geom) = 0 AS bare,
        (SELECT g.grade::float8 FROM setting s, jsonb_each_text(s.value::jsonb) g(speed, grade)
            WHERE s.name = 'grade_maximal' ORDER BY g.speed::float8 > e.speed, CASE WHEN g.speed::float8 > e.speed
                THEN g.speed::float8 ELSE -g.speed::float8 END LIMIT 1) / 200 AS usual
    FROM edge e JOIN profile p USING (edge_id);
CREATE INDEX ON road (from_node); CREATE INDEX ON road (to_node); CREATE INDEX ON road (axis_id);
CREATE TEMPORARY TABLE height AS
    SELECT r.edge_id, r.speed, r.usual, d.path[1] AS n, ST_Z(d.geom) AS z,
        r.length * ST_LineLocatePoint(ST_Force2D(r.line), ST_Force2D(d.geom)) AS at
    FROM road r, ST_DumpPoints(r.geom) d;
CREATE TEMPORARY TABLE bend AS
    SELECT *, (z - lag(z) OVER w) / nullif(at - lag(at) OVER w, 0) AS before,
        (lead(z) OVER w - z) / nullif(lead(at) OVER w - at, 0) AS after, at - lag(at) OVER w AS gone,
        lead(at) OVER w - at AS coming,
        greatest(abs(z), abs(lag(z) OVER w), abs(lead(z) OVER w)) > 0.01 AS off
    FROM height WINDOW w AS (PARTITION BY edge_id ORDER BY n);
WITH bridge_part AS (
    SELECT r.*, CASE WHEN EXISTS (SELECT FROM edge o WHERE r.from_node IN (o.from_node, o.to_node) AND o.level <= 0)
            THEN 10 ELSE 0 END AS low, length - CASE WHEN EXISTS (SELECT FROM edge o WHERE r.to_node
            IN (o.from_node, o.to_node) AND o.level <= 0) THEN 10 ELSE 0 END AS high
    FROM road r WHERE level > 0 AND bare AND (length >= 30 OR EXISTS (SELECT FROM overpass o
        WHERE o.edge_above = r.edge_id))),
place AS (
    SELECT edge_id, ST_Z(ST_LineInterpolatePoint(geom, at / length)) AS z
    FROM bridge_part, generate_series(ceil(low)::integer, floor(high)::integer) at WHERE high > low),
crossing AS (
    SELECT r.axis_id, e.start_abscissa + o.abscissa_above AS at, o.clearance, r.usual,
        ST_Z(ST_LineInterpolatePoint(r.geom, least(1, o.abscissa_above / r.length))) AS z
    FROM overpass o JOIN road r ON r.edge_id = o.edge_above JOIN edge e ON e.edge_id = r.edge_id),
in_turn AS (
    SELECT *, lead(at) OVER w AS next_at, lead(z) OVER w AS next_z FROM crossing
    WINDOW w AS (PARTITION BY axis_id ORDER BY at)),
near AS (
    SELECT i.*, least(z, next_z) - least(z, next_z, (SELECT min(h.z) FROM edge e JOIN height h USING (edge_id)
        WHERE e.axis_id = i.axis_id AND e.start_abscissa + h.at BETWEEN i.at AND next_at)) AS dip
    FROM in_turn i WHERE next_at - at BETWEEN 0.1 AND clearance / usual)
SELECT (SELECT round(count(*) / 1000.0, 2) FROM place) AS bridge_km,
    (SELECT round(100.0 * count(*) FILTER (WHERE z < 0.499) / nullif(count(*), 0), 1) FROM place) AS low_per_cent,
    (SELECT count(*) FROM near) AS near_crossings, (SELECT count(*) FILTER (WHERE dip > 0.5) FROM near) AS dips,
    (SELECT count(*) FROM streetgen.check_model(:'model') WHERE rule = 'clearance not kept, m') AS clearances_lost,
    (SELECT round((sum(coming) / 1000)::numeric, 2) FROM bend WHERE off AND coming IS NOT NULL) AS off_km,
    (SELECT round((100 * sum(coming) FILTER (WHERE abs(after) > usual + 0.0005) / sum(coming))::numeric, 1) FROM bend
        WHERE off AND coming IS NOT NULL) AS steep_per_cent,
    (SELECT count(*) FROM bend WHERE off) AS vertices,
    (SELECT round(100.0 * count(*) FILTER (WHERE abs(after - before) / ((gone + coming) / 2) * (speed / 3.6) ^ 2 > 0.55)
        / nullif(count(*), 0), 1) FROM bend WHERE off AND abs(after - before) > 0.001) AS bumpy_per_cent,
    (SELECT round(100.0 * count(*) FILTER (WHERE abs(after - before) > 0.0175) / nullif(count(*), 0), 1) FROM bend
        WHERE off AND before IS NOT NULL AND after IS NOT NULL) AS kinks_per_cent;
