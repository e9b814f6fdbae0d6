-- Rings that a source tags and that close, and what became of them: psql -v model=M -f tests/measure/tagged_rings.sql, of a model with subject roundabout.
-- A ring is the outside of the faces between tagged edges of a level. It is found where each edge of it lies on an accepted row; a two-way street is turned
-- where an untagged axis that its source drove both ways lies on an accepted row.
\set ON_ERROR_STOP on
\set QUIET on
\pset footer off
SET client_min_messages = warning;
BEGIN;
CREATE TEMP TABLE tagged ON COMMIT DROP AS
SELECT e.edge_id, e.level, e.geom FROM :"model".edge e JOIN :"model".axis a USING (axis_id) WHERE a.roundabout_tag IN ('roundabout', 'circular');
CREATE TEMP TABLE closed ON COMMIT DROP AS
SELECT level, ST_ExteriorRing(ground) AS outside, ST_Buffer(ST_ExteriorRing(ground), 0.01) AS along, ST_Area(ground) AS area, (ST_MinimumBoundingRadius(ground)).radius FROM (
  SELECT level, (ST_Dump(ST_Union(face))).geom AS ground FROM (
    SELECT level, (ST_Dump(ST_Polygonize(geom))).geom AS face FROM (SELECT level, (ST_Dump(ST_Union(geom))).geom FROM tagged GROUP BY level) n GROUP BY level) f GROUP BY level) g;
CREATE TEMP TABLE met ON COMMIT DROP AS
SELECT c.*, NOT EXISTS (SELECT FROM tagged t WHERE t.level = c.level AND t.geom && c.along AND ST_CoveredBy(ST_LineInterpolatePoint(t.geom, 0.5), c.along)
  AND NOT EXISTS (SELECT FROM :"model".roundabout_edge e JOIN :"model".roundabout r USING (roundabout_id) WHERE e.edge_id = t.edge_id AND r.accepted)) AS found FROM closed c;
SELECT count(*) AS tagged_and_closed, count(*) FILTER (WHERE found) AS found, count(*) FILTER (WHERE NOT found
  AND radius > (SELECT value::float8 FROM :"model".setting WHERE name = 'roundabout_radius_greatest')) AS wider_than_setting FROM met;
SELECT level, ST_AsText(ST_PointN(outside, 1), 0) AS not_found, round(area) AS m2, round(radius::numeric, 1) AS radius FROM met WHERE NOT found ORDER BY radius;
SELECT count(DISTINCT axis_id) AS turned FROM :"model".roundabout r JOIN :"model".roundabout_edge USING (roundabout_id) JOIN :"model".edge e ON e.edge_id = roundabout_edge.edge_id
  JOIN :"model".axis a USING (axis_id) WHERE accepted AND a.direction = 'both' AND a.roundabout_tag IS NULL;
COMMIT;
