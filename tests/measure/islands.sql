-- Estimated sidewalks on islands and along service ways of one model: psql -v model=NAME -f tests/measure/islands.sql
-- Axes, tags and roadway alone tell islands. A face of the edges of a level is one where its source tags a ring all
-- about it, or where roadway leaves it less than 300 m2 and traffic runs one-way along a side of it.
-- Columns: model; islands of tagged rings, those with 1 m2 of sidewalk, m2 of it; the same of small islands; the same
-- of service ways that no footway maps and whose sidewalk nobody states, where a metre of kerb with one counts.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SET client_min_messages = warning;
CREATE TEMPORARY TABLE street AS
SELECT edge_id, e.level, ST_Force2D(e.geom) AS geom, coalesce(a.roundabout_tag IN ('roundabout', 'circular'), false)
        AS tagged, e.lanes_both = 0 AND (e.lanes_forward = 0) <> (e.lanes_backward = 0) AS one_way
FROM :"model".edge e JOIN :"model".axis a USING (axis_id);
CREATE INDEX ON street USING gist (geom);
ANALYZE street;
CREATE TEMPORARY TABLE island AS
SELECT face_id, level, tagged, CASE WHEN tagged THEN face ELSE ground END AS ground
FROM (SELECT row_number() OVER () AS face_id, level, face FROM (
        SELECT level, (ST_Dump(ST_Polygonize(geom))).geom AS face FROM street GROUP BY level) f) f,
    LATERAL (SELECT bool_and(tagged) AS tagged, bool_or(one_way) AS one_way FROM street s
        WHERE s.level = f.level AND s.geom && face AND ST_CoveredBy(s.geom, ST_Buffer(ST_Boundary(face), 0.01))) s,
    LATERAL (SELECT ST_Difference(face, coalesce((SELECT ST_Union(r.surface) FROM :"model".roadway r
        WHERE r.level = f.level AND r.surface && face), ST_GeomFromText('POLYGON EMPTY', ST_SRID(face)))) AS ground) g
WHERE ST_Area(face) < 20000 AND (s.tagged OR s.one_way AND ST_Area(ground) < 300);
CREATE INDEX ON island USING gist (ground);
CREATE TEMPORARY TABLE walked AS
SELECT i.*, (SELECT coalesce(sum(ST_Area(ST_Intersection(s.surface, i.ground))), 0)
    FROM :"model".sidewalk s JOIN :"model".edge e USING (edge_id)
    WHERE s.surface && i.ground AND e.level = i.level AND s.method <> 'by_hand' AND 'sidewalk_' ||
        CASE WHEN s.side IN ('left', 'corner_at_start') THEN 'left' ELSE 'right' END = ANY (e.estimated)
        AND NOT EXISTS (SELECT FROM :"model".sidewalk_source f WHERE f.edge_id = s.edge_id)) AS m2 FROM island i;
CREATE TEMPORARY TABLE service AS
SELECT s.sidewalk_id, ST_Length(k.geom) AS metres, s.surface
FROM :"model".edge e JOIN :"model".axis a USING (axis_id) JOIN :"model".kerb k USING (edge_id)
    LEFT JOIN :"model".sidewalk s ON (s.edge_id, s.side, s.part) = (k.edge_id, k.side, k.part)
        AND s.method <> 'by_hand' AND ST_Area(s.surface) > 0.01
WHERE a.kind ~ '^service|^track' AND k.side IN ('left', 'right') AND k.node_id IS NULL
    AND CASE k.side WHEN 'left' THEN a.sidewalk_left ELSE a.sidewalk_right END IS NULL
    AND NOT EXISTS (SELECT FROM :"model".sidewalk_source f WHERE (f.edge_id, f.side) = (k.edge_id, k.side))
    AND NOT EXISTS (SELECT FROM :"model".sidewalk_override o WHERE (o.axis_id, o.side) = (a.axis_id, k.side));
SELECT :'model', count(*) FILTER (WHERE tagged), count(*) FILTER (WHERE tagged AND m2 > 1),
    round(coalesce(sum(m2) FILTER (WHERE tagged), 0)::numeric, 1), count(*) FILTER (WHERE NOT tagged),
    count(*) FILTER (WHERE NOT tagged AND m2 > 1), round(coalesce(sum(m2) FILTER (WHERE NOT tagged), 0)::numeric, 1),
    (SELECT round(coalesce(sum(metres), 0)::numeric) FROM service),
    (SELECT round(coalesce(sum(metres), 0)::numeric) FROM service WHERE sidewalk_id IS NOT NULL AND metres > 1),
    (SELECT round(coalesce(sum(ST_Area(surface)), 0)::numeric, 1) FROM service)
FROM walked;
