-- The mesh of a model seen from the south, from above at 25 degrees, as SVG; light comes from the west. Variables: model, extent
-- (geometry of the model, or NULL), steep (heights are drawn so many times as great), width (pixels).
\ir colours.sql
WITH corner AS (
    SELECT format('%s %s %s', edge_id, node_id, t.path[1]) AS id, level, edge_id IS NULL AS at_node, k, ST_X(p) AS x, ST_Y(p) AS y, ST_Z(p) * :steep AS z
    FROM streetgen.road_mesh(:'model', :extent) m, ST_Dump(geom) t, generate_series(1, 3) k, ST_PointN(ST_ExteriorRing(t.geom), k) p),
seen AS (SELECT *, y * sind(25) + z * cosd(25) AS up FROM corner),
frame AS (SELECT min(x) AS x, max(up) AS up, max(x) - min(x) AS w, max(up) - min(up) AS h FROM seen),
triangle AS (
    SELECT id, level, at_node, avg(y) AS far, string_agg(format('%s,%s', ((s.x - f.x) * :width / w)::numeric(9, 2), ((f.up - s.up) * :width / w)::numeric(9, 2)), ' ' ORDER BY k) AS points,
        (array_agg(s.x ORDER BY k)) AS a, (array_agg(s.y ORDER BY k)) AS b, (array_agg(s.z ORDER BY k)) AS c
    FROM seen s, frame f GROUP BY id, level, at_node),
normal AS (
    SELECT *, (b[2] - b[1]) * (c[3] - c[1]) - (c[2] - c[1]) * (b[3] - b[1]) AS nx, (c[2] - c[1]) * (a[3] - a[1]) - (a[2] - a[1]) * (c[3] - c[1]) AS ny,
        (a[2] - a[1]) * (b[3] - b[1]) - (b[2] - b[1]) * (a[3] - a[1]) AS nz FROM triangle),
lit AS (SELECT *, greatest(0, least(1, (-0.6 * nx + 0.1 * ny + 0.8 * nz) / sqrt(nx * nx + ny * ny + nz * nz))) AS light FROM normal)
SELECT format(E'<svg xmlns="http://www.w3.org/2000/svg" width="%s" height="%s" viewBox="-10 -10 %s %s">\n<rect x="-10" y="-10" width="100%%" height="100%%" fill="%s"/>\n'
    '<g stroke="%s" stroke-width="0.25" stroke-linejoin="round">%s</g>\n</svg>', :width + 20, ceil(h * :width / w) + 20, :width + 20, ceil(h * :width / w) + 20,
    pg_temp.colour('ground'), pg_temp.colour('limit'),
    (SELECT string_agg(format('<polygon points="%s" fill="rgb(%s)"/>', points, rgb), E'\n' ORDER BY level, far DESC)
        FROM (SELECT *, CASE WHEN at_node THEN 'intersection' ELSE 'section' END AS layer FROM lit) l, LATERAL (
            SELECT string_agg(round((0.45 + 0.65 * light) * get_byte(c, n))::text, ',' ORDER BY n) AS rgb
            FROM decode(substr(pg_temp.colour(layer), 2), 'hex') c, generate_series(0, 2) n) shade))
FROM frame;
