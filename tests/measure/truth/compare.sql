-- Intersection over union per class: psql -v place=MODEL -v believed=MODEL -v truth=TABLE -v shapes=TABLE -v lines=TABLE
-- Inside the truth's extent and within 20 m of an axis each point belongs to its nearest axis; ground of axes off the ground level, or covered,
-- as ways under a building are, is left out: no survey from above sees it.
CREATE INDEX ON :"truth" USING gist (geom);
CREATE TEMPORARY TABLE frame AS SELECT ST_SetSRID(ST_Extent(geom)::geometry, (SELECT srid FROM streetgen.model WHERE name = :'place')) AS box FROM :"truth";
CREATE TEMPORARY TABLE near AS
SELECT a.axis_id, coalesce(kind, '-') AS class, a.level = 0 AND NOT EXISTS (SELECT FROM :"lines" l WHERE l.way_id::text = a.source_ref AND l.tags ? 'tunnel') AS open_air, ST_Force2D(a.geom) AS geom, NOT 'width' = ANY (estimated) AS known
FROM :"place".axis a JOIN :"place".axis_used u USING (axis_id), frame WHERE a.geom && ST_Expand(box, 40);
CREATE TEMPORARY TABLE site AS
SELECT DISTINCT ON (place) place, axis_id FROM (
    SELECT axis_id, ST_SnapToGrid((ST_DumpPoints(ST_Segmentize(geom, 1))).geom, 0.001) AS place FROM near) p, frame WHERE place && ST_Expand(box, 40) ORDER BY place, axis_id;
CREATE INDEX ON site USING gist (place);
ANALYZE site;
CREATE TEMPORARY TABLE ground AS
SELECT axis_id, class, known, geom AS axis, ST_Intersection(ST_Intersection(ST_Union(cell), ST_Buffer(geom, 20)), box) AS cell
FROM (SELECT (ST_Dump(ST_VoronoiPolygons(ST_Collect(place)))).geom AS cell FROM site) v JOIN site ON ST_Contains(cell, place) JOIN near USING (axis_id), frame
WHERE open_air GROUP BY axis_id, class, known, geom, box;
CREATE TEMPORARY TABLE roadway AS
SELECT 'ours' AS maker, surface AS geom FROM :"place".section UNION ALL SELECT 'ours', surface FROM :"place".intersection
UNION ALL SELECT 'believed', surface AS geom FROM :"believed".section UNION ALL SELECT 'believed', surface FROM :"believed".intersection
UNION ALL SELECT 'netconvert', CASE kind WHEN 'lane' THEN ST_Buffer(line, coalesce(nullif(width, ''), '3.2')::float8 / 2, 'endcap=flat join=round') ELSE ST_MakeValid(ST_MakePolygon(ST_AddPoint(line, ST_StartPoint(line)))) END
FROM (SELECT kind, width, ST_GeomFromText(format('LINESTRING(%s)', translate(regexp_replace(shape, '(-?[\d.]+,-?[\d.]+),-?[\d.]+', '\1', 'g'), ', ', ' ,')), (SELECT ST_SRID(box) FROM frame)) AS line
      FROM :"shapes" WHERE kind = 'lane' AND shape LIKE '% %' OR shape LIKE '% % %') s;
CREATE INDEX ON roadway USING gist (geom);
ANALYZE roadway;
CREATE TEMPORARY TABLE measured AS
SELECT maker, axis_id, class, known, ST_Length(ST_Intersection(axis, box)) AS length, ST_Area(t) AS truth, ST_Area(o) AS made, ST_Area(ST_Intersection(t, o)) AS shared
FROM ground, frame, (SELECT DISTINCT maker FROM roadway) m
CROSS JOIN LATERAL (SELECT coalesce(ST_Union(ST_Intersection(geom, cell)), ST_GeomFromText('POLYGON EMPTY', ST_SRID(box))) AS t FROM :"truth" WHERE geom && cell) t
CROSS JOIN LATERAL (SELECT coalesce(ST_Intersection(ST_Union(geom), cell), ST_GeomFromText('POLYGON EMPTY', ST_SRID(box))) AS o FROM roadway r WHERE r.maker = m.maker AND geom && cell) o;
SELECT '| ' || :'place', coalesce(class, 'all'), count(DISTINCT axis_id), round((sum(length) FILTER (WHERE maker = 'ours') / 1000)::numeric, 1),
       round((100 * coalesce(sum(length) FILTER (WHERE known), 0) / sum(length))::numeric, 0), round((sum(truth) FILTER (WHERE maker = 'ours'))::numeric, 0),
       round((sum(shared) FILTER (WHERE maker = 'ours') / sum(truth + made - shared) FILTER (WHERE maker = 'ours'))::numeric, 3),
       round((sum(shared) FILTER (WHERE maker = 'believed') / sum(truth + made - shared) FILTER (WHERE maker = 'believed'))::numeric, 3),
       round((sum(shared) FILTER (WHERE maker = 'netconvert') / sum(truth + made - shared) FILTER (WHERE maker = 'netconvert'))::numeric, 3) || ' |'
FROM measured GROUP BY ROLLUP (class) ORDER BY class IS NULL, sum(truth) DESC;
