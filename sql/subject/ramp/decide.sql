-- The edit view of ramps.

CREATE OR REPLACE FUNCTION streetgen._ramp_stretch(model name, ramp bigint, OUT axis_id bigint, OUT low float8,
    OUT high float8, OUT place float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT e.axis_id, CASE WHEN s THEN start_abscissa ELSE middle END, CASE WHEN s THEN middle ELSE end_abscissa END,
        CASE WHEN s THEN start_abscissa + step ELSE end_abscissa - step END
    FROM ramp r JOIN edge e USING (edge_id), LATERAL (SELECT e.from_node = r.node_id AS s,
        (start_abscissa + end_abscissa) / 2 AS middle, least(5, (end_abscissa - start_abscissa) / 4) AS step) v
    WHERE r.ramp_id = ramp INTO axis_id, low, high, place;
END $$;
COMMENT ON FUNCTION streetgen._ramp_stretch(name, bigint) IS
    'The half of a link by which overrides name its ramp: the axis, from and to which abscissa, m, and a place '
    'between, up to 5 m from the ramp; NULL where the ramp is gone.';

CREATE OR REPLACE FUNCTION streetgen._edit_ramp() RETURNS trigger
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    subject text;
    half record;
    known bigint[];
    decided record;
BEGIN
    PERFORM streetgen._require_its_build(TG_TABLE_SCHEMA), streetgen._use_model(TG_TABLE_SCHEMA);
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'A ramp is where a link meets a highway: draw these.');
    ELSIF TG_OP = 'UPDATE' THEN
        NEW := streetgen._edited_row(TG_RELID, OLD, NEW, '{tangent,length,by_hand}',
            'A ramp moves with its link.');
        IF NEW IS NOT DISTINCT FROM OLD THEN
            RETURN NEW;
        END IF;
    END IF;
    subject := format('ramp %s of axis %s', OLD.ramp_id, OLD.axis_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, 'SELECT ' || OLD.axis_id);
    half := streetgen._ramp_stretch(TG_TABLE_SCHEMA, OLD.ramp_id);
    IF half.axis_id IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject),
            detail => 'No link meets a highway there any more.', hint => 'Refresh the layer.');
    END IF;
    SELECT coalesce(array_agg(ramp_override_id ORDER BY ramp_override_id), '{}') FROM ramp_override
        WHERE axis_id = half.axis_id AND abscissa BETWEEN half.low AND half.high INTO known;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        DELETE FROM ramp_override WHERE ramp_override_id = ANY (known);
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    PERFORM streetgen._check_edit_number('the tangent of ' || subject, NEW.tangent, 0, 1000, 'm',
        'Leave it empty for setting ramp_tangent.'),
        streetgen._check_edit_number('the length of ' || subject, NEW.length, 0, 1000, 'm',
        '0 for no merging lane; leave it empty for setting merging_length.');
    -- Values that are not typed stay as they were decided; of several rows the younger one holds.
    SELECT CASE WHEN (NEW.tangent IS DISTINCT FROM OLD.tangent) THEN NEW.tangent ELSE (array_agg(tangent
        ORDER BY ramp_override_id DESC)
            FILTER (WHERE tangent IS NOT NULL))[1] END AS tangent,
        CASE WHEN (NEW.length IS DISTINCT FROM OLD.length) THEN NEW.length ELSE (array_agg(length
            ORDER BY ramp_override_id DESC)
            FILTER (WHERE length IS NOT NULL))[1] END AS length
    FROM ramp_override WHERE ramp_override_id = ANY (known) INTO decided;
    IF NEW.by_hand AND NOT OLD.by_hand AND num_nonnulls(decided.tangent, decided.length) = 0 THEN
        PERFORM streetgen._refuse('22023', format('nothing is decided by hand of %s', subject),
            hint => 'Type tangent or length, and by_hand follows.');
    END IF;
    NEW.by_hand := num_nonnulls(decided.tangent, decided.length) > 0;
    IF NOT NEW.by_hand THEN
        DELETE FROM ramp_override WHERE ramp_override_id = ANY (known);
    ELSIF known = '{}' THEN
        INSERT INTO ramp_override (axis_id, abscissa, tangent, length) VALUES (half.axis_id, half.place,
            decided.tangent, decided.length);
    ELSE
        UPDATE ramp_override SET tangent = decided.tangent, length = decided.length
            WHERE ramp_override_id = ANY (known);
    END IF;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_ramp() IS
    'Trigger of ramp_editing: writes ramp_override. A tangent or length beyond 0 to 1000 m, or a ramp that is gone: '
    '22023; INSERT: 0A000.';

CREATE OR REPLACE FUNCTION streetgen._ramp_edit_view()
    RETURNS TABLE(name text, description text, columns text[], query text, subject text)
    LANGUAGE sql STABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('ramp_editing', 'Edit layer: type the tangent of a ramp or the length of its merging lanes; DELETE takes back '
        'what was decided by hand',
        ARRAY['key', 'the link', 'on or off the highway',
            'metres before and behind the bend into its lane; NULL takes it back',
            'metres that merging lanes keep their width, as typed or computed; 0: none; NULL takes it back',
            'decided by hand; false takes it back', 'its node'],
        streetgen._part('ramp_editing'), 'ramp') $$;
COMMENT ON FUNCTION streetgen._ramp_edit_view() IS 'The views in which ramps are edited.';

CREATE OR REPLACE FUNCTION streetgen._ramp_decision()
    RETURNS TABLE(relation name, anchor text, axes name[], reach text, follows jsonb, hashed boolean,
        hash_place integer, hash text)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    ('ramp_override'::name, 'along', '{axis_id}'::name[], '{tolerance}', '{}'::jsonb, true, 10,
        'ROW(o.abscissa, o.tangent, o.length)') $$;
COMMENT ON FUNCTION streetgen._ramp_decision() IS
    'The anchors of decisions about ramps, and which of their columns follow the axes.';
