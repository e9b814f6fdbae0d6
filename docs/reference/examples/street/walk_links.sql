-- argument extent: a box, or any geometry whose box is meant, in the SRID of the model; NULL: all
-- see switch_subject
SELECT kind, count(*), round(sum(metres)) AS metres FROM streetgen.walk_links('walked', ST_MakeEnvelope(650080, 6859980, 650120, 6860020, 2154))
GROUP BY kind ORDER BY kind;
-- drawing
WITH box AS (SELECT ST_MakeEnvelope(650060, 6859950, 650140, 6860030, 2154) AS geom), link AS (SELECT l.* FROM box, streetgen.walk_links('walked', box.geom) l)
SELECT ST_Intersection(s.surface, box.geom), 'section', NULL FROM walked.roadway s, box WHERE s.surface && box.geom
    UNION ALL SELECT ST_Intersection(l.geom, box.geom), 'result', CASE WHEN kind = 'sidewalk' AND metres > 20 THEN kind END FROM link l, box
    UNION ALL SELECT DISTINCT place, 'point', NULL FROM link l, box, LATERAL (VALUES (ST_StartPoint(l.geom)), (ST_EndPoint(l.geom))) v(place) WHERE place && box.geom
