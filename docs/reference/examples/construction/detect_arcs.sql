-- argument line: LINESTRING in metres, such as an axis or a kerb
-- argument radius_least: metres
-- argument radius_greatest: metres
-- argument tolerance: metres by which a point may leave its arc
-- argument turn_least: degrees that an arc turns at least
-- see roundabout_candidates
SELECT ST_AsText(centre, 2) AS centre, round(radius::numeric, 2) AS radius, support
FROM streetgen.detect_arcs('LINESTRING(0 0, 30 0, 35 1.34, 38.66 5, 40 10, 40 40)');
-- drawing
WITH given AS (SELECT 'LINESTRING(0 0, 30 0, 35 1.34, 38.66 5, 40 10, 40 40)'::geometry AS line)
SELECT line, 'axis', 'line' FROM given
UNION ALL SELECT centre, 'point', 'centre' FROM given, streetgen.detect_arcs(line)
UNION ALL SELECT arc, 'result', NULL FROM given, streetgen.detect_arcs(line)
