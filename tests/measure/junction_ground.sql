-- Ground at junctions of the model of variable model, as a road engineer looks at it.
-- Run as psql -v model=NAME -f tests/measure/junction_ground.sql.
-- Switches subjects kerb and interconnection on. Table `place` has the places afterwards, by measure.
SET client_min_messages = warning;
SELECT FROM unnest('{kerb,interconnection}'::text[]) s, streetgen.switch_subject(:'model', s, true) \g /dev/null
CREATE TEMPORARY TABLE place (measure text, id bigint, value float8, geom geometry);
CREATE TEMPORARY TABLE node_edge AS
SELECT node_id, edge_id, level, ST_Force2D(geom) AS geom, greatest(width, width_end) / 2 + abs(roadway_offset) AS half
FROM :"model".edge, LATERAL (VALUES (from_node), (to_node)) n(node_id);
CREATE INDEX ON node_edge (node_id);
CREATE INDEX ON node_edge USING gist (geom);
ANALYZE node_edge;
CREATE TEMPORARY TABLE junction AS
SELECT node_id, level, surface FROM :"model".intersection
WHERE NOT ST_IsEmpty(surface) AND (SELECT count(*) FROM node_edge e WHERE e.node_id = intersection.node_id) > 2;

-- Beyond buffers of the streets of its level and of those that meet there, whatever their level.
-- The rest of it is ground that no lane's path needs, either.
CREATE TEMPORARY TABLE beyond AS
SELECT node_id, level, ST_Difference(surface, (SELECT ST_Union(ST_Buffer(e.geom, half + 0.01)) FROM (
    SELECT DISTINCT edge_id, geom, half FROM node_edge e
    WHERE (e.level = j.level OR e.node_id = j.node_id) AND ST_DWithin(e.geom, surface, half)) e)) AS ground
FROM junction j;
INSERT INTO place SELECT 'beyond', node_id, ST_Area(ground), ground FROM beyond WHERE ST_Area(ground) > 50;
INSERT INTO place
SELECT 'needless', id, ST_Area(rest), rest
FROM place, LATERAL (
    SELECT coalesce(ST_Difference(geom, ST_Union(ST_Buffer(ST_Force2D(path), half + 0.5))), geom) AS rest
    FROM (SELECT c.geom AS path, greatest(i.width, o.width) / 2 AS half
        FROM :"model".interconnection c
        JOIN :"model".lane i ON i.lane_id = lane_in JOIN :"model".lane o ON o.lane_id = lane_out
        WHERE c.node_id = place.id AND plausible) p) r
WHERE measure = 'beyond';

-- Kinks of kerbs over 60 degrees. Where the roadway goes on on another level there is no kerb.
-- Corners at ends of limits are meant: those of dead ends.
CREATE TEMPORARY TABLE outline AS
SELECT row_number() OVER () AS outline_id, ST_Simplify(geom, 0.03) AS geom, ST_IsClosed(geom) AS closed
FROM (SELECT level, (ST_Dump(ST_LineMerge(ST_Collect(ST_Force2D(geom))))).geom
    FROM :"model".kerb WHERE method <> 'level_change' GROUP BY level) merged;
CREATE TEMPORARY TABLE corner_of_kerb AS
SELECT outline_id, ordinality, p, lag(p) OVER along AS before, lead(p) OVER along AS after
FROM (SELECT outline_id, (d).geom AS p, (d).path[1] AS ordinality FROM outline,
    LATERAL ST_DumpPoints(CASE WHEN closed THEN ST_AddPoint(geom, ST_PointN(geom, 2)) ELSE geom END) d) v
WINDOW along AS (PARTITION BY outline_id ORDER BY ordinality);
CREATE TEMPORARY TABLE limit_end AS SELECT (ST_DumpPoints(border_line)).geom FROM :"model".section_limit;
CREATE INDEX ON limit_end USING gist (geom);
ANALYZE limit_end;
INSERT INTO place
SELECT 'kink', outline_id, turn, p
FROM corner_of_kerb,
    LATERAL (SELECT degrees(ST_Azimuth(p, after) - ST_Azimuth(before, p)) AS d) a,
    LATERAL (SELECT abs(d - 360 * round(d / 360)) AS turn) t
WHERE turn > 60 AND least(ST_Distance(before, p), ST_Distance(p, after)) > 0.2
    AND NOT EXISTS (SELECT FROM limit_end l WHERE ST_DWithin(l.geom, p, 0.1));
-- A kink where surfaces meet of which no street leads into another: two streets lie too near each other there.
CREATE TEMPORARY TABLE surface AS
SELECT level, surface, ARRAY[from_node, to_node] AS nodes
FROM :"model".section JOIN :"model".edge USING (edge_id, level)
UNION ALL SELECT level, surface, ARRAY(SELECT DISTINCT o.node_id FROM node_edge e JOIN node_edge o USING (edge_id)
    WHERE e.node_id = i.node_id) FROM :"model".intersection i;
CREATE INDEX ON surface USING gist (surface);
ANALYZE surface;
INSERT INTO place
SELECT 'kink of strangers', id, value, geom FROM place k
WHERE measure = 'kink' AND EXISTS (SELECT FROM surface a JOIN surface b ON NOT a.nodes && b.nodes
    WHERE ST_DWithin(a.surface, k.geom, 0.02) AND ST_DWithin(b.surface, k.geom, 0.02));

-- Steps of kerbs, which jump aside by over 0.3 m within less than twice as much, and go on as before.
-- Both kerbs are straight for 3 m, and at most 10 degrees apart; up to four short sides lie between.
CREATE TEMPORARY TABLE kerb_side AS
SELECT outline_id, p, after, ST_Distance(p, after) AS size, ST_Azimuth(p, after) AS azimuth,
    row_number() OVER (PARTITION BY outline_id ORDER BY ordinality) AS ordinality
FROM corner_of_kerb WHERE ST_Distance(p, after) > 0;
CREATE INDEX ON kerb_side (outline_id, ordinality);
ANALYZE kerb_side;
INSERT INTO place
SELECT 'step', outline_id, abs(aside), ST_MakeLine(a.after, b.p)
FROM kerb_side a JOIN kerb_side b USING (outline_id),
    LATERAL (SELECT ST_X(b.p) - ST_X(a.after) AS east, ST_Y(b.p) - ST_Y(a.after) AS north) d,
    LATERAL (SELECT east * cos(a.azimuth) - north * sin(a.azimuth) AS aside,
        east * sin(a.azimuth) + north * cos(a.azimuth) AS along) s
WHERE b.ordinality BETWEEN a.ordinality + 2 AND a.ordinality + 5 AND least(a.size, b.size) > 3
    AND cos(a.azimuth - b.azimuth) > cos(radians(10)) AND abs(aside) > 0.3
    AND along BETWEEN -0.3 AND 2 * abs(aside)
    AND NOT EXISTS (SELECT FROM kerb_side c WHERE c.outline_id = a.outline_id
        AND c.ordinality > a.ordinality AND c.ordinality < b.ordinality AND c.size > 3);

-- Ends of surfaces that lie behind a limit, on the section.
CREATE TEMPORARY TABLE behind AS
SELECT l.edge_id, which, ST_Intersection(surface, ST_Buffer(ST_LineSubstring(e.geom, first, last),
    least(width, width_end) / 2 - 0.02, 'endcap=flat')) AS ground
FROM :"model".section_limit l JOIN :"model".edge e USING (edge_id)
JOIN junction j ON j.node_id = CASE which WHEN 'start' THEN from_node ELSE to_node END AND j.level = e.level,
    LATERAL (SELECT ST_Length(e.geom) AS size, CASE which WHEN 'start' THEN 0.02 ELSE -4 END AS off) s,
    LATERAL (SELECT greatest((abscissa + off) / size, 0) AS first, least((abscissa + off + 3.98) / size, 1) AS last) f
WHERE l.method <> 'crossed_limits' AND last > first;
INSERT INTO place SELECT 'behind', edge_id, ST_Area(ground), ground FROM behind WHERE ST_Area(ground) > 0.02;

\pset tuples_only on
\pset format unaligned
\pset fieldsep ' | '
SELECT '| ' || :'model', (SELECT count(*) FROM junction),
    count(*) FILTER (WHERE measure = 'beyond'),
    count(*) FILTER (WHERE measure = 'beyond' AND value > 100),
    count(*) FILTER (WHERE measure = 'needless' AND value > 50),
    count(*) FILTER (WHERE measure = 'needless' AND value > 100),
    count(*) FILTER (WHERE measure = 'behind'),
    (SELECT count(*) FROM :"model".intersection WHERE method = 'robust_fallback'),
    count(*) FILTER (WHERE measure = 'kink'),
    count(*) FILTER (WHERE measure = 'kink of strangers'),
    round((count(*) FILTER (WHERE measure = 'kink')
        / (SELECT sum(ST_Length(geom)) / 1000 FROM outline))::numeric, 3),
    count(*) FILTER (WHERE measure = 'step') || ' |'
FROM place;
