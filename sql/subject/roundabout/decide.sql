-- The edit view of roundabouts: a list to work through, the least certain ring first.

CREATE OR REPLACE FUNCTION streetgen._edit_roundabout() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    decided boolean;
    known bigint[];
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse('0A000', 'a roundabout cannot be drawn',
            hint => 'It stands where axes close a ring: draw these.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{confirmed}',
            'The ring follows its axes.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
        decided := NEW.confirmed;
    END IF;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, format('SELECT axis_id FROM %I.edge JOIN %1$I.roundabout_edge r '
        'USING (edge_id) WHERE r.roundabout_id = %s', TG_TABLE_SCHEMA, OLD.roundabout_id));
    SELECT coalesce(array_agg(roundabout_override_id ORDER BY roundabout_override_id), '{}')
        FROM roundabout_override WHERE geom && OLD.geom AND ST_Covers(ST_ConvexHull(OLD.geom), geom) INTO known;
    DELETE FROM roundabout_override WHERE roundabout_override_id = ANY (CASE WHEN decided IS NULL THEN known ELSE
        known[2:] END);
    IF decided IS NULL THEN
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    ELSIF known = '{}' THEN
        INSERT INTO roundabout_override (geom, confirmed) VALUES
            (ST_PointOnSurface(ST_MakeValid(ST_MakePolygon(OLD.geom))), decided);
    ELSE
        UPDATE roundabout_override SET confirmed = decided WHERE roundabout_override_id = known[1];
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_roundabout() IS
    'Trigger of roundabout_editing: writes roundabout_override at a place within the ring; confirmed NULL, or DELETE, '
    'takes it back. INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('roundabout_editing', 'Edit layer: confirm that a ring is a roundabout, or that it is none; the least certain '
        'come first; DELETE takes back what was decided by hand',
        ARRAY['key', 'is it a roundabout; NULL: as its score says', 'ring, mini, double or peanut', 'radius, metres',
            'score, 0 to 1', 'how far its score is from setting roundabout_accept', 'does traffic go round',
            'the ring'],
        $sql$SELECT r.roundabout_id, r.confirmed, r.kind, r.radius, r.score,
            abs(r.score - (SELECT value::float8 FROM {model}.setting WHERE name = 'roundabout_accept')) AS nearness,
            r.accepted, r.geom
        FROM {model}.roundabout r ORDER BY nearness, r.roundabout_id$sql$, 'roundabout') $$;
COMMENT ON FUNCTION streetgen._roundabout_edit_view() IS 'The views in which roundabouts are edited.';

CREATE OR REPLACE FUNCTION streetgen._roundabout_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('roundabout_override'::name, 'ground', '{}'::name[], '0', '{}'::jsonb, false, NULL::integer, NULL::text) $$;
COMMENT ON FUNCTION streetgen._roundabout_decision() IS
    'The anchors of decisions about roundabouts, and which of their columns follow the axes.';
