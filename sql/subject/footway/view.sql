-- The ground of footways, beside the roadway and the sidewalks.

CREATE OR REPLACE FUNCTION streetgen._make_footway_views(model name) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'footway' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    EXECUTE streetgen._fill_template(streetgen._part('footway_surface'), jsonb_build_object('srid', (SELECT m.srid
        FROM streetgen.model m WHERE m.name = model)));
    COMMENT ON VIEW footway_surface IS
        'The ground of each footway beside the roadway, the sidewalks and the footways that come before it: cycle '
        'tracks, then walks, then steps, and of these the older one. Computed when it is asked for; a footway whose '
        'ground is that of others, but for 0.01 m2, has no row';
    COMMENT ON COLUMN footway_surface.footway_id IS 'the footway';
    COMMENT ON COLUMN footway_surface.use IS 'walk, cycle or steps, as axis_class.use of its kind';
    COMMENT ON COLUMN footway_surface.level IS 'its level';
    COMMENT ON COLUMN footway_surface.width IS
        'its width, or that of its class, or setting mapped_sidewalk_minimal, metres';
    COMMENT ON COLUMN footway_surface.geom IS 'its middle';
    COMMENT ON COLUMN footway_surface.surface IS 'its ground';
END $$;
COMMENT ON FUNCTION streetgen._make_footway_views(name) IS
    'Makes view footway_surface of a model, where it computes footways.';

CREATE OR REPLACE FUNCTION streetgen._footway_view() RETURNS TABLE(name name, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES ('footway_surface'::name, 'footway') $$;
COMMENT ON FUNCTION streetgen._footway_view() IS 'The view of footways, and the subject whose tables it reads.';
