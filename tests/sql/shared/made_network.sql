-- A model with a design of four cities whose highways cross, and a village, in hills; of the other functions here it needs made_terrain.sql.
CREATE FUNCTION test.make_network(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, srid => 2154, dimension => 3), streetgen.create_design(model);
    EXECUTE format($f$
        INSERT INTO %1$I.terrain_tile (geom, heights) SELECT ST_MakeEnvelope(900000 + 3000 * i, 6450000, 903000 + 3000 * i, 6453000, 2154), test.tile(900000 + 3000 * i, 6453000, 50, 60, '400 + 20 * sin(x / 600.0) * cos(y / 800.0)') FROM generate_series(0, 1) i;
        INSERT INTO %1$I.design_node (name, kind, importance, geom, by_hand) VALUES ('A', 'city', 200000, 'SRID=2154;POINT(900500 6450400)', true), ('B', 'city', 150000, 'SRID=2154;POINT(905500 6452500)', true),
            ('C', 'city', 120000, 'SRID=2154;POINT(900600 6452600)', true), ('D', 'city', 90000, 'SRID=2154;POINT(905300 6450500)', true), ('E', 'village', 700, 'SRID=2154;POINT(903000 6450300)', true) $f$, model);
END $$;
