-- A design is added to a model and taken away.

CREATE OR REPLACE FUNCTION streetgen.create_design(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
DECLARE
    registered streetgen.model;
    before oid[];
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_owner(model);
    SELECT * INTO registered FROM streetgen.model m WHERE m.name = model;
    IF registered.dimension <> 3 THEN
        RAISE EXCEPTION 'model "%" is flat, and a design needs heights', model USING ERRCODE = '22023',
            HINT = 'streetgen.create_model(…, dimension => 3) makes a model that keeps heights.';
    ELSIF streetgen._has_design(model) THEN
        RAISE EXCEPTION 'model "%" has a design', model USING ERRCODE = '55000',
            HINT = format('SELECT streetgen.drop_design(%L) removes it.', model);
    END IF;
    before := streetgen._relations(model);
    PERFORM streetgen._make_tables(model, '{table}', '{design}');
    INSERT INTO design_standard (speed, radius, radius_normal, clothoid, grade, crest, sag, stopping) SELECT *
        FROM streetgen._default_design_standard();
    INSERT INTO design_class (network, speed, width, carriageways, lane_count, roadway_width, median_width, taper,
        importance) SELECT * FROM streetgen._default_design_class();
    INSERT INTO zone_class (class, cost, passage) VALUES ('water', 0, 'bridge'), ('forest', 3, 'free'), ('building', 0,
        'forbidden');
    PERFORM streetgen._make_design_edit_views(model), streetgen._give_to_owner(model, before);
    PERFORM streetgen._grant_like_axes(model, ARRAY(
        SELECT oid FROM unnest(streetgen._relations(model)) oid WHERE oid <> ALL (before)));
    PERFORM streetgen._grant_design_views(model);
END $$;
COMMENT ON FUNCTION streetgen.create_design(name) IS
    'Adds the tables of a design to a model of dimension 3: terrain, zones, standards, nodes, links, and what is made '
    'of them, each with a view to edit it by hand (…_editing). Classes of zones water (bridge), forest and building '
    '(forbidden), the standards of the Portuguese norm and three classes of roads stand in them. A flat model: 22023; '
    'one with a design: 55000; not the owner of the model: 42501.';

CREATE OR REPLACE FUNCTION streetgen.drop_design(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
        SET client_min_messages = warning
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._require_design(model);
    EXECUTE (SELECT format('DROP VIEW IF EXISTS %s', string_agg(format('%I.%I', model, relation || '_editing'), ', '))
        FROM streetgen._design_table());
    EXECUTE (SELECT format('DROP TABLE %s', string_agg(format('%I.%I', model, relation), ', '))
        FROM streetgen.template WHERE room = 'design');
    EXECUTE format('DROP FUNCTION IF EXISTS %I._edit_design()', model);
END $$;
COMMENT ON FUNCTION streetgen.drop_design(name) IS
    'Removes the tables of a design with all in them; axes that were designed stay. No design: 55000; something of '
    'others that builds on the tables: 2BP01; not the owner of the model: 42501.';
