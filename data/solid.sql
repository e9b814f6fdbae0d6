-- The streets of a model in three dimensions, as its files of glTF have them, seen from the south, from above at 35 degrees, as SVG; light
-- comes from the west. Variables: model, extent (xmin, ymin, xmax, ymax as JSON), steep (kerbs are drawn so many times as high), width (pixels).
\ir colours.sql
CREATE FUNCTION pg_temp.paint(model text) RETURNS TABLE (level integer, surface geometry) LANGUAGE plpgsql AS $$ BEGIN
    RETURN QUERY EXECUTE format('SELECT e.level, s.surface::geometry FROM %1$I.lane_separator s JOIN %1$I.edge e USING (edge_id) UNION ALL SELECT e.level, m.surface FROM %1$I.marking m JOIN %1$I.edge e USING (edge_id)', model); END $$;
WITH corner AS (
    SELECT format('%s %s %s', layer, id, t.path[1]) AS id, layer AS kind, k, ST_X(p) AS x, ST_Y(p) AS y, ST_Z(p) * :steep AS z
    FROM streetgen._street_mesh(:'model', json_build_object('extent', :'extent'::json, 'level', NULL, 'tolerance', 0.05)::jsonb) m, ST_Dump(mesh) t, generate_series(1, 3) k, ST_PointN(ST_ExteriorRing(t.geom), k) p),
box AS (SELECT (e ->> 0)::float8 AS x, (e ->> 3)::float8 AS y, (e ->> 2)::float8 - (e ->> 0)::float8 AS w, (e ->> 3)::float8 - (e ->> 1)::float8 AS h FROM (SELECT :'extent'::json AS e) e),
frame AS (SELECT *, :width / w AS scale FROM box),
triangle AS (
    SELECT c.id, kind, avg(c.y) AS far, string_agg(format('%s,%s', ((c.x - f.x) * scale)::numeric(9, 1), (((f.y - c.y) * sind(35) - c.z * cosd(35)) * scale)::numeric(9, 1)), ' ' ORDER BY k) AS points,
        array_agg(c.x ORDER BY k) AS a, array_agg(c.y ORDER BY k) AS b, array_agg(c.z ORDER BY k) AS c
    FROM corner c, frame f GROUP BY c.id, kind),
normal AS (
    SELECT *, (b[2] - b[1]) * (c[3] - c[1]) - (c[2] - c[1]) * (b[3] - b[1]) AS nx, (c[2] - c[1]) * (a[3] - a[1]) - (a[2] - a[1]) * (c[3] - c[1]) AS ny,
        (a[2] - a[1]) * (b[3] - b[1]) - (b[2] - b[1]) * (a[3] - a[1]) AS nz FROM triangle),
lit AS (
    SELECT *, 0.35 + 0.65 * greatest(0, (-0.5 * nx - 0.35 * ny + 0.8 * nz) / sqrt(nx * nx + ny * ny + nz * nz)) AS light
    FROM normal WHERE nz > 0 OR ny < 0),
face AS (
    SELECT CASE kind WHEN 'section' THEN 0 WHEN 'intersection' THEN 0 ELSE 2 END AS turn, far, format('<polygon points="%1$s" fill="rgb(%2$s)" stroke="rgb(%2$s)"/>', points, rgb) AS text
    FROM lit, LATERAL (SELECT string_agg(least(255, (light * get_byte(c, n))::int)::text, ',' ORDER BY n) AS rgb
        FROM decode(substr(pg_temp.colour(kind, theme => 'street'), 2), 'hex') c, generate_series(0, 2) n) l
    UNION ALL
    SELECT 1, 0, format('<path d="%s" fill="%s" stroke="none"/>', ST_AsSVG(ST_Affine(ST_Force2D(surface), scale, 0, 0, scale * sind(35), -f.x * scale, -f.y * scale * sind(35)), 0, 1),
        pg_temp.colour('marking', theme => 'street'))
    FROM pg_temp.paint(:'model'), frame f WHERE surface && ST_MakeEnvelope(f.x, f.y - f.h, f.x + f.w, f.y, ST_SRID(surface)) AND NOT ST_IsEmpty(surface))
SELECT format(E'<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s" viewBox="0 0 %1$s %2$s">\n<rect width="100%%" height="100%%" fill="%4$s"/>\n<g stroke-width="0.5" stroke-linejoin="round">%3$s</g>\n</svg>',
    :width, ceil(h * scale * sind(35)), (SELECT string_agg(text, E'\n' ORDER BY turn, far DESC, text) FROM face), pg_temp.colour('block', 'strip', 'street')) FROM frame;
