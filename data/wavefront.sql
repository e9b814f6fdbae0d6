-- data/streetgen export writes the mesh of a model into an .obj file. Variable: model.
CREATE TEMPORARY TABLE corner AS
SELECT CASE WHEN edge_id IS NULL THEN 'intersection_' || node_id ELSE 'section_' || edge_id END AS object, t.path[1] AS triangle, k,
    ST_X(p) AS x, ST_Y(p) AS y, ST_Z(p) AS z
FROM streetgen.road_mesh(:'model') m, ST_Dump(geom) t, generate_series(1, 3) k, ST_PointN(ST_ExteriorRing(t.geom), k) p;
CREATE TEMPORARY TABLE origin AS SELECT floor(min(x)) AS x, floor(min(y)) AS y, floor(min(z)) AS z FROM corner;
CREATE TEMPORARY TABLE numbered AS SELECT object, triangle, k, c.x - o.x AS x, c.y - o.y AS y, c.z - o.z AS z, dense_rank() OVER (ORDER BY c.x, c.y, c.z) AS vertex FROM corner c, origin o;
SELECT format(E'# Road mesh of model %s by StreetGen %s\n# SRID %s, metres, x to the east, y to the north, z up\n# origin %s %s %s, to be added to each vertex',
    translate(name, E'\n\r', '  '), streetgen.version(), srid, x, y, z) FROM streetgen.model, origin WHERE name = :'model';
SELECT format('v %s %s %s', x::numeric(20, 6), y::numeric(20, 6), z::numeric(20, 6)) FROM (SELECT DISTINCT ON (vertex) * FROM numbered ORDER BY vertex) v ORDER BY vertex;
SELECT CASE WHEN lag(object) OVER (ORDER BY object, triangle) IS DISTINCT FROM object THEN format(E'o %s\n', object) ELSE '' END || format('f %s', string_agg(vertex::text, ' ' ORDER BY k))
FROM numbered GROUP BY object, triangle ORDER BY object, triangle;
