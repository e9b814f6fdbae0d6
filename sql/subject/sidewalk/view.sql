-- The sidewalk that goes on where a drive comes to a street, and the strips between sidewalks and kerbs.

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
    EXECUTE streetgen._part_in('side_strip', model, jsonb_build_object(
        'bays', streetgen._bays_stand(streetgen._subjects(model), '')));
    COMMENT ON VIEW side_strip IS
        'Verges, buffers and cycle tracks between kerbs and sidewalks, as axis.strips_left and strips_right say. Each '
        'is a part of the ground of its sidewalk, along the kerb of a street; at corners there is none. Computed when '
        'it is asked for';
    COMMENT ON COLUMN side_strip.side_strip_id IS 'key: of the sidewalk, and the number of the strip';
    COMMENT ON COLUMN side_strip.sidewalk_id IS 'the sidewalk on whose ground it lies';
    COMMENT ON COLUMN side_strip.edge_id IS 'the edge';
    COMMENT ON COLUMN side_strip.side IS 'left or right of the axis';
    COMMENT ON COLUMN side_strip."order" IS 'number from 1 at the kerb, outwards';
    COMMENT ON COLUMN side_strip.kind IS 'verge, buffer or cycle_track';
    COMMENT ON COLUMN side_strip.level IS 'its level';
    COMMENT ON COLUMN side_strip.paved IS
        'what a cycle track is paved with, as axis.cycle_paved_left or _right; NULL: unknown, or another strip';
    COMMENT ON COLUMN side_strip.surface IS 'its ground';
END $$;
COMMENT ON FUNCTION streetgen._make_sidewalk_views(name) IS
    'Makes views crossover and side_strip of a model, where it computes sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 3 SET search_path = pg_catalog
    AS $$ VALUES ('crossover'::name, 'sidewalk'), ('side_strip', 'sidewalk'), ('side_strip', 'object') $$;
COMMENT ON FUNCTION streetgen._sidewalk_view() IS 'The views of sidewalks, and the subjects whose tables they read.';
