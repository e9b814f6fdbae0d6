-- The edit view of ramps.

CREATE OR REPLACE FUNCTION streetgen._ramp_stretch(model name, ramp bigint, OUT axis_id bigint, OUT low float8,
    OUT high float8, OUT place float8)
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    EXECUTE format($sql$
SELECT e.axis_id, CASE WHEN s THEN start_abscissa ELSE middle END, CASE WHEN s THEN middle ELSE end_abscissa END,
    CASE WHEN s THEN start_abscissa + step ELSE end_abscissa - step END
FROM %1$I.ramp r JOIN %1$I.edge e USING (edge_id), LATERAL (SELECT e.from_node = r.node_id AS s,
    (start_abscissa + end_abscissa) / 2 AS middle, least(5, (end_abscissa - start_abscissa) / 4) AS step) v
WHERE r.ramp_id = $1
$sql$, model) INTO axis_id, low, high, place USING ramp;
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
    IF TG_OP = 'INSERT' THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, TG_OP, 'A ramp is where a link meets a highway: draw these.');
    ELSIF TG_OP = 'UPDATE' AND NEW IS NOT DISTINCT FROM OLD THEN
        RETURN NEW;
    ELSIF TG_OP = 'UPDATE' AND (NEW.ramp_id, NEW.axis_id, NEW.kind) IS DISTINCT FROM (OLD.ramp_id, OLD.axis_id,
        OLD.kind) THEN
        PERFORM streetgen._refuse_edit(TG_TABLE_NAME, 'a change of its key, axis_id or kind',
            'Only tangent, length and by_hand can be changed.');
    END IF;
    subject := format('ramp %s of axis %s', OLD.ramp_id, OLD.axis_id);
    PERFORM streetgen._lock_axes(TG_TABLE_SCHEMA, 'SELECT ' || OLD.axis_id);
    half := streetgen._ramp_stretch(TG_TABLE_SCHEMA, OLD.ramp_id);
    IF half.axis_id IS NULL THEN
        PERFORM streetgen._refuse('22023', format('%s is gone', subject),
            detail => 'No link meets a highway there any more.', hint => 'Refresh the layer.');
    END IF;
    EXECUTE format('SELECT coalesce(array_agg(ramp_override_id ORDER BY ramp_override_id), ''{}'') '
        'FROM %I.ramp_override WHERE axis_id = $1 AND abscissa BETWEEN $2 AND $3', TG_TABLE_SCHEMA) INTO known
        USING half.axis_id, half.low, half.high;
    IF TG_OP = 'DELETE' OR OLD.by_hand AND NEW.by_hand IS NOT TRUE THEN
        EXECUTE format('DELETE FROM %I.ramp_override WHERE ramp_override_id = ANY ($1)', TG_TABLE_SCHEMA) USING known;
        RETURN CASE WHEN TG_OP = 'UPDATE' THEN NEW WHEN known <> '{}' THEN OLD END;
    END IF;
    PERFORM streetgen._check_edit_number('the tangent of ' || subject, NEW.tangent, 0, 1000, 'm',
        'Leave it empty for setting ramp_tangent.'),
        streetgen._check_edit_number('the length of ' || subject, NEW.length, 0, 1000, 'm',
        '0 for no merging lane; leave it empty for setting merging_length.');
    -- What is not typed stays as it was decided; of several rows the younger one holds.
    EXECUTE format($sql$
SELECT CASE WHEN $2 THEN $3 ELSE (array_agg(tangent ORDER BY ramp_override_id DESC)
        FILTER (WHERE tangent IS NOT NULL))[1] END AS tangent,
    CASE WHEN $4 THEN $5 ELSE (array_agg(length ORDER BY ramp_override_id DESC)
        FILTER (WHERE length IS NOT NULL))[1] END AS length
FROM %I.ramp_override WHERE ramp_override_id = ANY ($1)$sql$, TG_TABLE_SCHEMA) INTO decided USING known,
        NEW.tangent IS DISTINCT FROM OLD.tangent, NEW.tangent, NEW.length IS DISTINCT FROM OLD.length, NEW.length;
    NEW.by_hand := num_nonnulls(decided.tangent, decided.length) > 0;
    IF NOT NEW.by_hand THEN
        EXECUTE format('DELETE FROM %I.ramp_override WHERE ramp_override_id = ANY ($1)', TG_TABLE_SCHEMA) USING known;
    ELSIF known = '{}' THEN
        EXECUTE format('INSERT INTO %I.ramp_override (axis_id, abscissa, tangent, length) VALUES ($1, $2, $3, $4)',
            TG_TABLE_SCHEMA) USING half.axis_id, half.place, decided.tangent, decided.length;
    ELSE
        EXECUTE format('UPDATE %I.ramp_override SET tangent = $2, length = $3 WHERE ramp_override_id = ANY ($1)',
            TG_TABLE_SCHEMA) USING known, decided.tangent, decided.length;
    END IF;
    NEW.geom := OLD.geom;
    RETURN NEW;
END $$;
COMMENT ON FUNCTION streetgen._edit_ramp() IS
    'Trigger of ramp_editing: writes ramp_override. A tangent or length beyond 0 to 1000 m, or a ramp that is gone: '
    '22023; INSERT: 0A000.';
