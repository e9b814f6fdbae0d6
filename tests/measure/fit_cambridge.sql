-- Cambridge: centrelines of the city, and the borders of its roadway.
CREATE TABLE cambridge_kerb AS SELECT ST_Boundary(ST_Transform(geom, 32619)) AS geom FROM cambridge_basemap_roads;
CREATE TABLE cambridge_axis AS
SELECT row_number() OVER (ORDER BY c.fid, d.path) AS id, street, ST_Transform(d.geom, 32619) AS geom
FROM cambridge_trans_centerlines c, ST_Dump(c.geom) d;
SELECT streetgen.create_model('cambridge', 32619, subjects => '{kerb,sidewalk,fit}', driving_side => 'right');
SELECT streetgen.import_axes('cambridge', 'cambridge_axis', '{"geom": "geom", "name": "street", "source_ref": "id"}');
SELECT streetgen.generate('cambridge');
