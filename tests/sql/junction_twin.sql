\set ECHO none
\ir shared/truths.sql
-- Twins of real junctions, drawn by hand: how many junctions of several nodes there are, and how many nodes each has. A row an axis: place, line about
-- the middle of the place, width, lanes, direction, importance, name.
DO $$ BEGIN PERFORM streetgen.create_model('twin', 2154, subjects => '{junction,kerb}'); END $$;
CREATE TABLE place(name, x, junctions, nodes) AS VALUES ('northgate', 0, 1, '{5}'::bigint[]), ('kingsway', 1, 1, '{6}'), ('perth', 2, 1, '{6}'), ('quad', 3, 1, '{4}'), ('aurora', 4, 1, '{2}'),
    ('seattle', 5, 1, '{3}'), ('arizona', 6, 2, '{2,2}');
CREATE TABLE drawn(place, line, width, lanes, direction, importance, name, level) AS VALUES
    -- Two carriageways cross two, which are one street before the crossing.
    ('northgate', 'LINESTRING(-200 0, -6 0, 6 0, 200 0)', 7, 2, 'direct', 2, 'avenue', 0), ('northgate', 'LINESTRING(200 18, 6 18, -6 18, -200 18)', 7, 2, 'direct', 2, 'avenue', 0),
    ('northgate', 'LINESTRING(0 -200, 0 -9)', 7, 2, 'both', 3, 'gate', 0), ('northgate', 'LINESTRING(0 -9, 6 0, 6 18, 6 200)', 3.5, 1, 'direct', 3, 'gate', 0),
    ('northgate', 'LINESTRING(-6 200, -6 18, -6 0, 0 -9)', 3.5, 1, 'direct', 3, 'gate', 0),
    -- A street crosses two carriageways, with a slip lane into each of them and out of it.
    ('kingsway', 'LINESTRING(-200 0, -30 0, 0 0, 200 0)', 7, 2, 'direct', 2, 'kingsway', 0), ('kingsway', 'LINESTRING(200 14, 0 14, -30 14, -200 14)', 7, 2, 'direct', 2, 'kingsway', 0),
    ('kingsway', 'LINESTRING(0 -200, 0 -30, 0 0, 0 14, 0 44, 0 200)', 7, 2, 'both', 3, 'street', 0), ('kingsway', 'LINESTRING(-30 0, -16 -4, -4 -16, 0 -30)', 4, 1, 'direct', 3, NULL, 0),
    ('kingsway', 'LINESTRING(0 44, -4 30, -16 18, -30 14)', 4, 1, 'direct', 3, NULL, 0),
    -- A slip lane of short axes, whose joints lie in the junction too.
    ('perth', 'LINESTRING(-200 0, -25 0, 0 0, 200 0)', 7, 2, 'both', 2, 'road', 0), ('perth', 'LINESTRING(0 -200, 0 -25, 0 0, 0 200)', 7, 2, 'both', 2, 'street', 0),
    ('perth', 'LINESTRING(-25 0, -18 -2)', 4, 1, 'direct', 3, NULL, 0), ('perth', 'LINESTRING(-18 -2, -10 -6)', 4, 1, 'direct', 3, NULL, 0),
    ('perth', 'LINESTRING(-10 -6, -3 -15)', 4, 1, 'direct', 3, NULL, 0), ('perth', 'LINESTRING(-3 -15, 0 -25)', 4, 1, 'direct', 3, NULL, 0),
    -- Two dual carriageways cross.
    ('quad', 'LINESTRING(-200 0, -7 0, 7 0, 200 0)', 7, 2, 'direct', 2, 'avenue', 0), ('quad', 'LINESTRING(200 14, 7 14, -7 14, -200 14)', 7, 2, 'direct', 2, 'avenue', 0),
    ('quad', 'LINESTRING(7 -200, 7 0, 7 14, 7 200)', 7, 2, 'direct', 2, 'boulevard', 0), ('quad', 'LINESTRING(-7 200, -7 14, -7 0, -7 -200)', 7, 2, 'direct', 2, 'boulevard', 0),
    -- A street parts about an island and joins again; a side street ends on one half, just before that.
    ('aurora', 'LINESTRING(-200 0, -40 0)', 7, 2, 'both', 3, 'aurora', 0), ('aurora', 'LINESTRING(40 0, 200 0)', 7, 2, 'both', 3, 'aurora', 0),
    ('aurora', 'LINESTRING(-40 0, -25 -6, 25 -6, 34 -2.4, 40 0)', 3.5, 1, 'direct', 3, 'aurora', 0), ('aurora', 'LINESTRING(40 0, 25 6, -25 6, -40 0)', 3.5, 1, 'direct', 3, 'aurora', 0),
    ('aurora', 'LINESTRING(34 -2.4, 34 -200)', 6, 2, 'both', 4, 'side', 0),
    -- Three wide streets enclose a triangle smaller than their widths.
    ('seattle', 'LINESTRING(-200 0, 0 0, 16 0, 200 0)', 14, 4, 'both', 3, 'pine', 0), ('seattle', 'LINESTRING(-100 -173, 0 0, 8 14, 100 173)', 14, 4, 'both', 3, 'broad', 0),
    ('seattle', 'LINESTRING(116 -173, 16 0, 8 14, -84 173)', 14, 4, 'both', 3, 'denny', 0),
    -- A diamond interchange: frontage roads cross two carriageways below a highway.
    ('arizona', 'LINESTRING(-200 0, -50 0, 50 0, 200 0)', 7, 2, 'direct', 3, 'bell road', 0), ('arizona', 'LINESTRING(200 14, 50 14, -50 14, -200 14)', 7, 2, 'direct', 3, 'bell road', 0),
    ('arizona', 'LINESTRING(-50 200, -50 14, -50 0, -50 -200)', 7, 2, 'direct', 3, 'frontage', 0), ('arizona', 'LINESTRING(50 -200, 50 0, 50 14, 50 200)', 7, 2, 'direct', 3, 'frontage', 0),
    ('arizona', 'LINESTRING(-10 300, -10 -300)', 10.5, 3, 'direct', 1, 'highway', 1), ('arizona', 'LINESTRING(10 -300, 10 300)', 10.5, 3, 'direct', 1, 'highway', 1);
INSERT INTO twin.axis (geom, width, lane_count, direction, importance, name, level)
    SELECT ST_Translate(ST_GeomFromText(line, 2154), 650000 + 1000 * x, 6860000), width, lanes, direction, importance, d.name, level FROM drawn d JOIN place p ON p.name = d.place;
-- The junctions of several nodes of each place.
CREATE VIEW grouped AS SELECT p.name, p.x, j.junction_id, j.surface, count(*) AS nodes FROM place p JOIN twin.junction j ON ST_X(j.geom) BETWEEN 649500 + 1000 * x AND 650500 + 1000 * x
    JOIN twin.junction_node USING (junction_id) GROUP BY 1, 2, 3, 4 HAVING count(*) > 1;
SELECT name || ': its junctions and the nodes of each', (SELECT count(*) = p.junctions AND array_agg(nodes) = p.nodes FROM grouped g WHERE g.name = p.name) FROM place p ORDER BY x;
SELECT name || ': each has one surface', (SELECT bool_and(ST_NumGeometries(surface) = 1 AND ST_IsValid(surface)) FROM grouped g WHERE g.name = p.name) FROM place p ORDER BY x;
SELECT name || ': no arc of a kerb lies inside', NOT EXISTS (SELECT FROM grouped g JOIN twin.junction_node USING (junction_id) JOIN twin.kerb k USING (node_id)
    WHERE g.name = p.name AND ST_Length(ST_Intersection(k.geom, ST_Buffer(g.surface, -0.01))) > 0.01) FROM place p ORDER BY x;
SELECT name || ': no street is left without its way across', NOT EXISTS (SELECT FROM streetgen.check_model('twin') c WHERE c.severity <> 'notice'
    AND ST_X(ST_Centroid(c.geom)) BETWEEN 649500 + 1000 * x AND 650500 + 1000 * x) FROM place p ORDER BY x;
