\set ECHO none
\ir shared/truths.sql
\ir shared/content.sql
-- Clusters of axes, and a model computed by them.  Each SELECT is one truth: (name, holds).
\o /dev/null
SELECT streetgen.create_model('whole', 2154), streetgen.create_model('parts', 2154), streetgen.create_model('empty', 2154);
CREATE SCHEMA source;
CREATE TABLE source.axis AS
    SELECT 1 + i AS axis_id, ST_SetSRID(ST_MakeLine(ST_Point(650000 + 90 * (i / 2 % 9), 6860000 + 70 * (i / 18)), ST_Point(650000 + 90 * (i / 2 % 9 + (i + 1) % 2), 6860000 + 70 * (i / 18 + i % 2))), 2154) AS geom,
           4 + i % 7 AS width, 1 + i % 4 AS importance FROM generate_series(0, 143) i;
SET streetgen.live = off;
INSERT INTO whole.axis (axis_id, geom, width, importance) SELECT * FROM source.axis;
INSERT INTO parts.axis (axis_id, geom, width, importance) SELECT * FROM source.axis;
RESET streetgen.live;
SELECT streetgen.generate('whole');
\o

SELECT 'every axis is in one cluster', count(*) = 144 AND count(DISTINCT axis_id) = 144 AND min(cluster) = 1 AND max(cluster) = 5 FROM streetgen.cluster('parts', 5);
SELECT 'clusters are of equal size', bool_and(many BETWEEN 28 AND 29) FROM (SELECT count(*) AS many FROM streetgen.cluster('parts', 5) GROUP BY cluster) c;
SELECT 'their hulls share no ground', max(ST_Area(ST_Intersection(a.hull, b.hull))) < 1e-6 FROM (
    SELECT cluster, ST_ConvexHull(ST_Collect(ST_Centroid(geom))) AS hull FROM streetgen.cluster('parts', 7) JOIN parts.axis USING (axis_id) GROUP BY cluster) a
    JOIN (SELECT cluster, ST_ConvexHull(ST_Collect(ST_Centroid(geom))) AS hull FROM streetgen.cluster('parts', 7) JOIN parts.axis USING (axis_id) GROUP BY cluster) b ON a.cluster < b.cluster;
SELECT 'the same axes give the same clusters', NOT EXISTS (SELECT streetgen.cluster('parts', 6) EXCEPT SELECT streetgen.cluster('whole', 6));
SELECT 'one cluster is all, and a cluster an axis the most', (SELECT count(*) = 144 AND max(cluster) = 1 FROM streetgen.cluster('parts', 1)) AND (SELECT count(DISTINCT cluster) = 144 FROM streetgen.cluster('parts', 144));
SELECT 'no axes: no rows', count(*) = 0 FROM streetgen.cluster('empty', 1);
SELECT 'k beyond the axes: 22023', test.state($$SELECT streetgen.cluster('parts', 145)$$) = '22023' AND test.said($$SELECT streetgen.cluster('parts', 145)$$) = 'model "parts" cannot be parted in 145 clusters';
SELECT 'k under 1: 22023', test.state($$SELECT streetgen.cluster('parts', 0)$$) = '22023';
SELECT 'k NULL: 22004', test.state($$SELECT streetgen.cluster('parts', NULL)$$) = '22004';
SELECT 'cluster of an unknown model: 3F000', test.state($$SELECT streetgen.cluster('nowhere', 2)$$) = '3F000';
SELECT 'points of unequal arrays: 2202E', test.state($$SELECT streetgen._clusters('{1,2}', '{1}', 1)$$) = '2202E';
SELECT 'a point that is not finite: 22023', test.state($$SELECT streetgen._clusters('{1,NaN}', '{1,2}', 1)$$) = '22023';

SELECT 'before a plan there is no progress', clusters = 0 AND axes = 0 AND time_left IS NULL FROM streetgen.progress('parts');
SELECT 'without a plan there is nothing to compute', count(*) = 0 FROM streetgen.generate_cluster('parts');
SELECT 'a plan of an empty model has no clusters', streetgen.plan_clusters('empty') = 0;
SELECT 'a plan of less than one cluster: 22023', test.state($$SELECT streetgen.plan_clusters('parts', 0)$$) = '22023' AND test.state($$SELECT streetgen.plan_clusters('parts', 2, 0)$$) = '22023';
SELECT 'a plan has a cluster a session at least', streetgen.plan_clusters('empty', NULL, 3) = 0 AND streetgen.plan_clusters('whole', NULL, 3) = 3;
SELECT 'a run is planned', streetgen.plan_clusters('parts', 6) = 6;
SELECT 'the first cluster asked for is computed', cluster = 3 AND axes = 24 AND ended = 1 AND clusters = 6 AND axes_per_second > 0 AND time_left > '0' FROM streetgen.generate_cluster('parts', 3);
SELECT 'its axes have streets, others not', bool_and((axis_id IN (SELECT axis_id FROM parts.edge)) = (axis_id = ANY (c.axes))) FROM parts.axis, parts.cluster c WHERE cluster_id = 3;
SELECT 'progress tells it', clusters = 6 AND ended = 1 AND sessions = 0 AND axes = 144 AND axes_ended = 24 FROM streetgen.progress('parts');
BEGIN;
SET LOCAL streetgen.places = 600;
UPDATE parts.axis SET width = 11 WHERE axis_id = 70;
SELECT 'an edit that holds districts computes no cluster', sessions = 0 AND EXISTS (SELECT FROM pg_locks WHERE pid = pg_backend_pid() AND locktype = 'advisory' AND mode = 'ExclusiveLock' AND objid::bigint BETWEEN 2147483649 AND 4294967294)
FROM streetgen.progress('parts');
ROLLBACK;
SELECT 'a run goes on where it was', streetgen.plan_clusters('parts', 2) = 5;
SELECT streetgen.generate_cluster('parts') \g /dev/null
-- What comes by while a run is under way.
UPDATE parts.axis SET width = 11 WHERE axis_id IN (7, 70);
UPDATE parts.axis SET width = 4 + (axis_id - 1) % 7 WHERE axis_id IN (7, 70);
SET streetgen.live = off;
INSERT INTO parts.axis (axis_id, geom, width) VALUES (500, 'SRID=2154;LINESTRING(650000 6860000, 649900 6859950)', 6);
INSERT INTO whole.axis (axis_id, geom, width) VALUES (500, 'SRID=2154;LINESTRING(650000 6860000, 649900 6859950)', 6);
RESET streetgen.live;
SELECT 'a plan that goes on takes axes that came', streetgen.plan_clusters('parts') = 5;
SELECT 'as one more cluster', axes = '{500}' FROM parts.cluster WHERE cluster_id = 7;
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT 'the last cluster ends the run', ended = 7 AND time_left = '0' FROM streetgen.generate_cluster('parts');
SELECT 'after it there is none', count(*) = 0 FROM streetgen.generate_cluster('parts');
SELECT streetgen.generate('whole') \g /dev/null
SELECT 'the model is as one run makes it', test.same('parts', 'whole') AND NOT EXISTS (SELECT FROM streetgen.check_model('parts') WHERE severity = 'error');
SELECT 'and a run over all finds nothing to do', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('parts');
SELECT 'a run that has ended is planned anew', streetgen.plan_clusters('parts', 4) = 4;
SELECT streetgen.set('parts', 'dead_end', 'round'), streetgen.set('whole', 'dead_end', 'round') \g /dev/null
SELECT 'settings that changed since: 55000', test.state($$SELECT streetgen.generate_cluster('parts')$$) = '55000';
SELECT 'a plan with them begins anew', streetgen.plan_clusters('parts', 4) = 4;
DELETE FROM parts.axis WHERE axis_id = 9;
DELETE FROM whole.axis WHERE axis_id = 9;
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate_cluster('parts') \g /dev/null
SELECT streetgen.generate('whole') \g /dev/null
SELECT 'clusters take new settings as one run does', test.same('parts', 'whole') AND (SELECT count(DISTINCT setting_hash) = 1 FROM parts.edge);
BEGIN ISOLATION LEVEL REPEATABLE READ;
SELECT 'above read committed: 0A000', test.state($$SELECT streetgen.generate_cluster('parts')$$) = '0A000';
ROLLBACK;
SELECT 'the plan is known with hulls to draw', bool_and(ST_Dimension(hull) = 2) AND count(*) = 4 FROM parts.cluster;
