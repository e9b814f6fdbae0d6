-- The sidewalk that goes on where a drive comes to a street.

CREATE OR REPLACE FUNCTION streetgen._make_sidewalk_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'sidewalk' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._part_in('crossover', model);
    COMMENT ON VIEW crossover IS
        'Where a drive, of a class that rules of crossings leave out (axis_class.crossed_on_foot), comes to one '
        'street with a sidewalk on both sides of its mouth: the sidewalk goes on there, and the kerb is lowered. Its '
        'ground lies on the roadway of the drive. Computed when it is asked for';
    COMMENT ON COLUMN crossover.crossover_id IS 'key: of the edge, and of its end at the street';
    COMMENT ON COLUMN crossover.edge_id IS 'edge of the drive';
    COMMENT ON COLUMN crossover.node_id IS 'node at which it comes to the street';
    COMMENT ON COLUMN crossover.level IS 'its level';
    COMMENT ON COLUMN crossover.kerb IS 'lowered, along kerb_line';
    COMMENT ON COLUMN crossover.kerb_line IS 'the kerb of the street, which goes on there';
    COMMENT ON COLUMN crossover.width IS 'the lesser width of the sidewalks on both sides of the mouth, metres';
    COMMENT ON COLUMN crossover.place IS 'the node';
    COMMENT ON COLUMN crossover.surface IS 'its ground';
END $$;
COMMENT ON FUNCTION streetgen._make_sidewalk_views(name) IS
    'Makes view crossover of a model, where it computes sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('crossover'::name, 'sidewalk') $$;
COMMENT ON FUNCTION streetgen._sidewalk_view() IS 'The view of sidewalks, and the subject whose tables it reads.';
