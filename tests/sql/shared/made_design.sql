-- A model with a design of two roads that cross in hills; of the other functions here it needs made_terrain.sql.
CREATE FUNCTION test.make_design(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen.create_model(model, srid => 2154, dimension => 3), streetgen.create_design(model);
    EXECUTE format($f$
        INSERT INTO %1$I.terrain_tile (geom, heights) SELECT ST_MakeEnvelope(900000 + 3000 * i, 6450000, 903000 + 3000 * i, 6453000, 2154), test.tile(900000 + 3000 * i, 6453000, 50, 60, '400 + 40 * sin(x / 600.0) * cos(y / 800.0)') FROM generate_series(0, 1) i;
        INSERT INTO %1$I.design_node (design_node_id, name, kind, importance, geom, by_hand) VALUES (1, 'A', 'city', 200000, 'SRID=2154;POINT(900500 6451000)', true), (2, 'B', 'city', 90000, 'SRID=2154;POINT(905500 6451500)', true),
            (3, 'C', 'village', 900, 'SRID=2154;POINT(902500 6452700)', true), (4, 'D', 'village', 700, 'SRID=2154;POINT(903500 6450300)', true);
        INSERT INTO %1$I.design_link (design_link_id, node_a, node_b, network, by_hand) VALUES (1, 1, 2, 'secondary', true), (2, 3, 4, 'rural', true) $f$, model);
END $$;
