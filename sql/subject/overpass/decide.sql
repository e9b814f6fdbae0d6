-- The edit view of overpasses.

CREATE OR REPLACE FUNCTION streetgen._edit_overpass() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    taken_back boolean := TG_OP = 'DELETE';
    -- Those of the two axes that lie nearer to this crossing than to another one of theirs.
    known bigint[];
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse('0A000', 'an overpass cannot be drawn',
            hint => 'It stands where two axes cross without a node: draw these.');
    ELSIF TG_OP = 'UPDATE' THEN
        -- Whoever swaps them may say both.
        IF (NEW.axis_above, NEW.axis_below) = (OLD.axis_below, OLD.axis_above) THEN
            NEW.axis_below := OLD.axis_below;
        END IF;
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{axis_above,clearance,by_hand}',
            'The other axis as axis_above swaps them.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := 'overpass ' || OLD.overpass_id;
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA,
        format('SELECT unnest(ARRAY[%s, %s])', OLD.axis_above, OLD.axis_below));
    SELECT coalesce(array_agg(overpass_override_id ORDER BY overpass_override_id), '{}') FROM overpass_override o
    WHERE (axis_above, axis_below) IN ((OLD.axis_above, OLD.axis_below), (OLD.axis_below, OLD.axis_above))
        AND ST_DWithin(o.geom, OLD.geom, 20)
        AND NOT EXISTS (SELECT FROM overpass_editing e WHERE (e.axis_above, e.axis_below) IN ((OLD.axis_above,
            OLD.axis_below), (OLD.axis_below, OLD.axis_above))
            AND ST_Distance(e.geom, o.geom) < ST_Distance(OLD.geom, o.geom)) INTO known;
    IF NOT taken_back THEN
        taken_back := NEW.clearance IS NULL AND NEW.axis_above IS NOT DISTINCT FROM OLD.axis_above
            OR OLD.by_hand AND NOT NEW.by_hand;
    END IF;
    IF taken_back THEN
        DELETE FROM overpass_override WHERE overpass_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    IF NEW.axis_above IS NULL OR NEW.axis_above NOT IN (OLD.axis_above, OLD.axis_below) THEN
        PERFORM streetgen._refuse('22023',
            format('axis %s does not pass at %s', coalesce(NEW.axis_above::text, 'NULL'), subject),
            hint => format('Axes %s and %s cross there.', OLD.axis_above, OLD.axis_below));
    END IF;
    PERFORM streetgen._check_edit_number('the clearance of ' || subject, NEW.clearance, 0, 100, 'm',
        'Delete the row to take back what was decided by hand.');
    NEW.axis_below := OLD.axis_above + OLD.axis_below - NEW.axis_above;
    DELETE FROM overpass_override WHERE overpass_override_id = ANY (known[2:]);
    IF known = '{}' THEN
        INSERT INTO overpass_override (geom, axis_above, axis_below, clearance)
            VALUES (OLD.geom, NEW.axis_above, NEW.axis_below, NEW.clearance);
    ELSE
        UPDATE overpass_override SET axis_above = NEW.axis_above, axis_below = NEW.axis_below, clearance = NEW.clearance
            WHERE overpass_override_id = known[1];
    END IF;
    NEW.by_hand := true;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_overpass() IS
    'Trigger of overpass_editing: writes overpass_override. An axis that does not cross there, or a clearance beyond 0 '
    'to 100 m: 22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._overpass_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('overpass_editing', 'Edit layer: type which axis passes over, or the clearance; DELETE takes back what was '
        'decided by hand',
        ARRAY['key', 'axis that passes over: the other one swaps them', 'axis below; type axis_above to swap',
            'from roadway to roadway, metres; NULL takes back what was decided',
            'decided by hand; false takes it back', 'the crossing'],
        $sql$SELECT o.overpass_id, a.axis_id AS axis_above, b.axis_id AS axis_below, o.clearance,
            o.method = 'by_hand' AS by_hand, o.geom
        FROM {model}.overpass o JOIN {model}.edge a ON a.edge_id = o.edge_above
            JOIN {model}.edge b ON b.edge_id = o.edge_below$sql$, 'overpass') $$;
COMMENT ON FUNCTION streetgen._overpass_edit_view() IS 'The views in which overpasses are edited.';

CREATE OR REPLACE FUNCTION streetgen._overpass_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('overpass_override'::name, 'node', '{axis_above,axis_below}'::name[], '20', '{}'::jsonb, true, 6,
        'ROW(o.geom::bytea, o.axis_above, o.axis_below, o.clearance)') $$;
COMMENT ON FUNCTION streetgen._overpass_decision() IS
    'The anchors of decisions about overpasses, and which of their columns follow the axes.';
