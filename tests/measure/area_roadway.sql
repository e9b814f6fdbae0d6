-- Roadway against areas of kind roadway in street_area of a model: psql -v model=MODEL
-- Printed by kind of axis: axes, those of which 0.3 or more lies within areas, those whose kerbs are those of areas;
-- and of the second m2 of areas and of roadway, and shared ground by ground of both (agreement), which is also printed
-- of the third (consistency). A point within 20 m of an axis belongs to its nearest axis, and counts where this one
-- lies within areas.
SET search_path = :"model", public;
CREATE TEMPORARY TABLE street AS
    SELECT axis_id, coalesce(kind, '-') AS kind, by_area, level, ST_Force2D(geom) AS line FROM axis_used
    JOIN (SELECT axis_id, kind FROM axis) a USING (axis_id);
CREATE TEMPORARY TABLE site AS
    SELECT DISTINCT ON (place) place, axis_id FROM (SELECT axis_id,
        ST_SnapToGrid((ST_DumpPoints(ST_Segmentize(line, 1))).geom, 0.001) AS place FROM street) p
    ORDER BY place, axis_id;
CREATE INDEX ON site USING gist (place);
CREATE TEMPORARY TABLE cell AS
    SELECT axis_id, kind, by_area, level, line, ST_Union(geom) AS geom
    FROM (SELECT (ST_Dump(ST_VoronoiPolygons(ST_Collect(place)))).geom FROM site) v
        JOIN site ON ST_Contains(geom, place) JOIN street USING (axis_id) GROUP BY axis_id, kind, by_area, level, line;
CREATE TEMPORARY TABLE measured AS
    SELECT c.kind, c.by_area, coalesce(ST_Length(l.within), 0) >= 0.3 * ST_Length(c.line) AS surveyed,
        coalesce(ST_Area(d.ground), 0) AS drawn, coalesce(ST_Area(r.ground), 0) AS made,
        coalesce(ST_Area(ST_Intersection(d.ground, r.ground)), 0) AS shared
    FROM cell c, LATERAL (SELECT ST_Union(ST_MakeValid(a.geom)) AS drawn FROM street_area a
            WHERE a.kind = 'roadway' AND a.level = c.level AND a.geom && ST_Expand(c.line, 20)) u,
        LATERAL (SELECT ST_Intersection(c.line, u.drawn) AS within) l,
        LATERAL (SELECT ST_Intersection(c.geom, ST_Buffer(l.within, 20, 'endcap=flat')) AS geom) n,
        LATERAL (SELECT ST_Intersection(u.drawn, n.geom) AS ground) d,
        LATERAL (SELECT ST_Intersection(ST_Union(s.surface), n.geom) AS ground
            FROM roadway s WHERE s.level = c.level AND s.surface && n.geom) r;
SELECT coalesce(kind, 'all') AS kind, count(*) AS axes, count(*) FILTER (WHERE surveyed) AS surveyed,
    count(*) FILTER (WHERE by_area) AS by_area, round((sum(drawn) FILTER (WHERE surveyed))::numeric) AS drawn,
    round((sum(made) FILTER (WHERE surveyed))::numeric) AS made, round((sum(shared) FILTER (WHERE surveyed)
        / nullif(sum(drawn + made - shared) FILTER (WHERE surveyed), 0))::numeric, 3) AS agreement,
    round((sum(shared) FILTER (WHERE by_area)
        / nullif(sum(drawn + made - shared) FILTER (WHERE by_area), 0))::numeric, 3) AS consistency
FROM measured GROUP BY ROLLUP (kind) ORDER BY kind IS NULL, sum(drawn) DESC;
