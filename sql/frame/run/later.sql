-- Subjects that follow the one statement: their rows may be longer than the reach.

CREATE OR REPLACE FUNCTION streetgen._later_subjects() RETURNS text[]
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT '{block,junction,signal,bridge,object}'::text[] $$;
COMMENT ON FUNCTION streetgen._later_subjects() IS
    'The subjects that no part of the one statement writes: statements of their own follow it.';

CREATE OR REPLACE FUNCTION streetgen._update_later(model name, axes bigint[], blocks bigint[] DEFAULT NULL,
    edges bigint[] DEFAULT NULL)
    RETURNS TABLE(relation text, inserted bigint, updated bigint, deleted bigint, unchanged bigint, fallbacks bigint)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE ROWS 5 SET search_path = pg_catalog, public SET streetgen.computes = 'on'
    AS $$
DECLARE
    touched bigint[];
BEGIN
    PERFORM streetgen._use_model(model);
    IF axes IS NULL THEN
        RETURN QUERY SELECT * FROM streetgen._renew_all_blocks(model);
    ELSE
        RETURN QUERY SELECT * FROM _renew_blocks(blocks, axes);
    END IF;
    RETURN QUERY SELECT * FROM streetgen._update_bridges(model, axes, edges);
    RETURN QUERY SELECT * FROM streetgen._update_objects(model, axes);
    IF 'junction' <> ALL (streetgen._subjects(model)) THEN
        RETURN;
    END IF;
    IF axes IS NOT NULL THEN
        SELECT ARRAY(SELECT from_node FROM edge WHERE axis_id = ANY (axes) UNION SELECT to_node FROM edge
            WHERE axis_id = ANY (axes)) INTO touched;
    END IF;
    RETURN QUERY SELECT * FROM _update_junctions(touched);
END $$;
COMMENT ON FUNCTION streetgen._update_later(name, bigint[], bigint[], bigint[]) IS
    'After the one statement wrote rows of axes (NULL: of all): brings the subjects up to date that it does not write; '
    'a row per table. blocks: those that the statement changed, 0 for what lies in no block. edges: those whose '
    'bridges the axes could change before.';
