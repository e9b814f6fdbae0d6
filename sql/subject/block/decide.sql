-- Edits of blocks: block_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_block() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'Blocks come from the streets about them: draw an axis.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{kind,by_hand}',
            'The ground follows the streets about it.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    SELECT ARRAY(SELECT block_override_id FROM block_override WHERE geom && OLD.geom
        AND ST_Intersects(geom, OLD.geom) ORDER BY block_override_id DESC) INTO known;
    IF TG_OP = 'DELETE' OR NEW.kind IS NULL OR OLD.by_hand AND NOT NEW.by_hand THEN
        DELETE FROM block_override WHERE block_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    ELSIF NEW.kind IS NOT DISTINCT FROM OLD.kind AND OLD.by_hand THEN
        RETURN NEW;
    ELSIF ST_IsEmpty(OLD.geom) THEN
        PERFORM streetgen._refuse('22023', format('block %s has no ground', OLD.block_id),
            detail => 'It is roadway all over.', hint => 'Only ground has a kind: make a street beside it narrower.');
    END IF;
    PERFORM streetgen._check_edit_word('block ' || OLD.block_id, NEW.kind,
        format('%I.block_override', TG_TABLE_SCHEMA), 'kind');
    IF known = '{}' THEN
        INSERT INTO block_override (geom, kind) VALUES (ST_PointOnSurface(OLD.geom), NEW.kind);
    ELSE
        UPDATE block_override SET kind = NEW.kind WHERE block_override_id = known[1];
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_block() IS
    'Trigger of block_editing: writes block_override, at a place within the block. A kind other than block, island or '
    'strip: 23514; one for a block without ground: 22023; INSERT, another key or geometry: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._axes_of_block_override(model name, overrides jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axes bigint[] := '{}';
BEGIN
    PERFORM streetgen._use_model(model);
    IF 'block' = ANY (streetgen._subjects(model)) THEN
        SELECT ARRAY(SELECT DISTINCT e.axis_id FROM unnest(overrides) o, LATERAL (
                SELECT ST_SetSRID(ST_GeomFromGeoJSON(o ->> 'geom'), m.srid) AS geom FROM streetgen.model m
                    WHERE m.name = model) p
            JOIN block b ON b.surface && p.geom AND ST_Intersects(b.surface, p.geom)
            JOIN block_edge s ON s.block_id = b.block_id AND s.ordinality = 1 JOIN edge e USING (edge_id)) INTO axes;
    END IF;
    RETURN axes;
END $$;
COMMENT ON FUNCTION streetgen._axes_of_block_override(name, jsonb[]) IS
    'An axis at each block that holds the place of a row of block_override: a run for it renews the block.';

CREATE OR REPLACE FUNCTION streetgen._block_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('block_editing', 'Edit layer: say what kind of block a piece of ground is; DELETE takes back what was decided by '
        'hand',
        ARRAY['key', 'block, island or strip; NULL takes it back', 'decided by hand; false takes it back',
            'the ground'],
        $sql$SELECT b.block_id, b.kind, EXISTS (SELECT FROM {model}.block_override o WHERE o.geom && b.surface
                AND ST_Intersects(o.geom, b.surface)) AS by_hand, b.surface AS geom
            FROM {model}.block b$sql$, 'block') $$;
COMMENT ON FUNCTION streetgen._block_edit_view() IS 'The views in which blocks are edited.';

CREATE OR REPLACE FUNCTION streetgen._block_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('block_override'::name, 'ground', '{}'::name[], '0', '{}'::jsonb, true, NULL::integer, NULL::text) $$;
COMMENT ON FUNCTION streetgen._block_decision() IS
    'The anchors of decisions about blocks, and which of their columns follow the axes.';
