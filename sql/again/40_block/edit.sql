-- Edits of blocks: block_editing.

CREATE OR REPLACE FUNCTION streetgen._edit_block() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    known bigint[];
BEGIN
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'Blocks come from the streets about them: draw an axis.');
    ELSIF TG_OP = 'UPDATE' AND (NEW.block_id, NEW.geom) IS DISTINCT FROM (OLD.block_id, OLD.geom) THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, 'a change of its key or geom',
            'Only kind and by_hand can be changed; the ground follows the streets about it.');
    END IF;
    EXECUTE format('SELECT ARRAY(SELECT block_override_id FROM %I.block_override WHERE geom && $1
        AND ST_Intersects(geom, $1) ORDER BY block_override_id DESC)', TG_TABLE_SCHEMA) INTO known USING OLD.geom;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        EXECUTE format('DELETE FROM %I.block_override WHERE block_override_id = ANY ($1)', TG_TABLE_SCHEMA)
            USING known;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    ELSIF NEW.kind IS NOT DISTINCT FROM OLD.kind AND OLD.by_hand THEN
        RETURN NEW;
    ELSIF ST_IsEmpty(OLD.geom) THEN
        PERFORM streetgen._refuse('22023', format('block %s has no ground', OLD.block_id),
            detail => 'It is roadway all over.', hint => 'Only ground has a kind: make a street beside it narrower.');
    ELSIF NEW.kind IS NULL OR NEW.kind NOT IN ('block', 'island', 'strip') THEN
        PERFORM streetgen._refuse('22023',
            format('the kind of block %s cannot be %s', OLD.block_id, coalesce(quote_literal(NEW.kind), 'NULL')),
            hint => 'It is block, island or strip; by_hand false has it computed.');
    END IF;
    IF known = '{}' THEN
        EXECUTE format('INSERT INTO %I.block_override (geom, kind) VALUES (ST_PointOnSurface($1), $2)',
            TG_TABLE_SCHEMA) USING OLD.geom, NEW.kind;
    ELSE
        EXECUTE format('UPDATE %I.block_override SET kind = $2 WHERE block_override_id = $1', TG_TABLE_SCHEMA)
            USING known[1], NEW.kind;
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_block() IS
    'Trigger of block_editing: writes block_override, at a place within the block. A kind other than block, island or '
    'strip, or one for a block without ground: 22023; INSERT, another key or geometry: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._axes_at_blocks(model name, overrides jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    axes bigint[] := '{}';
BEGIN
    IF 'block' = ANY (streetgen._subjects(model)) THEN
        EXECUTE format($sql$
SELECT ARRAY(SELECT DISTINCT e.axis_id FROM unnest($1) o, LATERAL (
        SELECT ST_SetSRID(ST_GeomFromGeoJSON(o ->> 'geom'), m.srid) AS geom FROM streetgen.model m WHERE m.name = $2) p
    JOIN %1$I.block b ON b.surface && p.geom AND ST_Intersects(b.surface, p.geom)
    JOIN %1$I.block_edge s ON s.block_id = b.block_id AND s.ordinality = 1 JOIN %1$I.edge e USING (edge_id))
$sql$, model) INTO axes USING overrides, model;
    END IF;
    RETURN axes;
END $$;
COMMENT ON FUNCTION streetgen._axes_at_blocks(name, jsonb[]) IS
    'An axis at each block that holds the place of a row of block_override: a run for it renews the block.';
