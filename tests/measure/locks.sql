-- Whom one open edit of the model of variable model stops: what tests/measure/locks says. Variables turns, others and connection are as it gives them.
\pset fieldsep ' | '
SET client_min_messages = error;
CREATE EXTENSION IF NOT EXISTS dblink;
SELECT format('CREATE TEMPORARY TABLE measured AS SELECT %1$L::name AS model, %2$s AS turns, %3$s AS others, value::float8 + 2 * streetgen._change_reach(%1$L) AS off FROM %1$I.setting WHERE name = ''cell_size''',
  :'model', :turns, :others) \gexec
SELECT format('CREATE TEMPORARY TABLE line AS SELECT axis_id, geom FROM %I.axis', :'model') \gexec
CREATE TEMPORARY TABLE asked (axis_id bigint, edit text, in_common integer[], alone integer[], shared integer[]);
CREATE TEMPORARY TABLE tried (axis_id bigint, skipped bigint, refused bigint, refused_in_common bigint);

-- The keys of an edit, without running it: of a width, and of a vertex that moves by a metre.
DO $$
DECLARE
  m constant name := (SELECT model FROM measured);
  a bigint;
  moves boolean;
  reach record;
BEGIN
  FOR a, moves IN SELECT axis_id, v FROM line, (VALUES (false), (true)) k(v) ORDER BY 1, 2 LOOP
    BEGIN
      IF moves THEN
        PERFORM set_config('streetgen.live', 'off', true);
        EXECUTE format('UPDATE %I.axis SET geom = ST_SetPoint(geom, 0, ST_Translate(ST_StartPoint(geom), 0.6, 0.8)) WHERE axis_id = $1', m) USING a;
      END IF;
      reach := streetgen._reach_of(m, ARRAY[a]);
      RAISE SQLSTATE 'SG001';
    EXCEPTION WHEN SQLSTATE 'SG001' THEN NULL;
    END;
    INSERT INTO asked SELECT a, CASE WHEN moves THEN 'vertex' ELSE 'width' END, reach.chains, p.alone, p.shared FROM streetgen._places_of(m, reach.cells, reach.districts, reach.chains) p;
  END LOOP;
END $$;

CREATE TEMPORARY TABLE wanted AS SELECT axis_id, edit, key, true AS alone FROM asked, unnest(alone) key UNION ALL SELECT axis_id, edit, key, false FROM asked, unnest(shared) key;
CREATE TEMPORARY TABLE far AS SELECT a.axis_id AS a, b.axis_id AS b FROM measured, line a JOIN line b ON a.axis_id < b.axis_id WHERE NOT ST_DWithin(a.geom, b.geom, off);
CREATE INDEX ON wanted (edit, key);
CREATE UNIQUE INDEX ON far (a, b);
ANALYZE wanted, far;
CREATE TEMPORARY TABLE met AS
  SELECT w.edit, w.axis_id AS a, o.axis_id AS b, bool_or(w.key BETWEEN 4095 AND 536875007) AS by_chain, bool_or(w.key BETWEEN 536875008 AND 805310463) AS by_axis
  FROM wanted w JOIN wanted o ON (o.edit, o.key) = (w.edit, w.key) AND w.axis_id < o.axis_id AND (w.alone OR o.alone) JOIN far ON (far.a, far.b) = (w.axis_id, o.axis_id) GROUP BY 1, 2, 3;

SELECT FROM dblink_connect('idle', :'connection');
-- Some of these edits are left open, each in turn, and others are tried beside.
DO $$
DECLARE
  m measured;
  a asked;
  b record;
  left_out bigint[];
  stopped boolean;
  result tried;
BEGIN
  SELECT * INTO m FROM measured;
  FOR a IN SELECT * FROM asked WHERE edit = 'width' ORDER BY md5(axis_id::text) LIMIT m.turns LOOP
    result := ROW(a.axis_id, 0, 0, 0);
    PERFORM dblink_exec('idle', 'BEGIN'), dblink_exec('idle', format('UPDATE %I.axis SET width = coalesce(width, 5) + 1 WHERE axis_id = %s', m.model, a.axis_id));
    PERFORM set_config('lock_timeout', '150ms', true);
    BEGIN
      left_out := ARRAY(SELECT axis_id FROM line EXCEPT SELECT unnest(requested) FROM streetgen._lock_places_beside(m.model, NULL));
      RAISE SQLSTATE 'SG001';
    EXCEPTION WHEN SQLSTATE 'SG001' THEN NULL;
    END;
    result.skipped := (SELECT count(*) FROM asked o JOIN far ON (far.a, far.b) = (least(a.axis_id, o.axis_id), greatest(a.axis_id, o.axis_id))
      WHERE o.edit = 'width' AND o.axis_id = ANY (left_out) AND NOT o.in_common && a.in_common);
    FOR b IN SELECT o.axis_id, o.in_common && a.in_common AS in_common FROM asked o JOIN far ON (far.a, far.b) = (least(a.axis_id, o.axis_id), greatest(a.axis_id, o.axis_id))
      WHERE o.edit = 'width' ORDER BY md5(a.axis_id::text || o.axis_id) LIMIT m.others LOOP
      BEGIN
        EXECUTE format('UPDATE %I.axis SET width = coalesce(width, 5) + 1 WHERE axis_id = %s', m.model, b.axis_id);
        RAISE SQLSTATE 'SG001';
      EXCEPTION WHEN SQLSTATE 'SG001' THEN stopped := false;
        WHEN lock_not_available THEN stopped := true;
      END;
      result.refused := result.refused + (stopped AND NOT b.in_common)::integer;
      result.refused_in_common := result.refused_in_common + (stopped AND b.in_common)::integer;
    END LOOP;
    PERFORM dblink_exec('idle', 'ROLLBACK');
    INSERT INTO tried SELECT result.*;
  END LOOP;
END $$;

SELECT '| ' || (SELECT model FROM measured), edit, (SELECT round(off) FROM measured), count(*), percentile_disc(0.5) WITHIN GROUP (ORDER BY cardinality(alone)), max(cardinality(alone)), (SELECT count(*) FROM far),
  (SELECT count(*) FROM met WHERE met.edit = asked.edit), (SELECT count(*) FROM met WHERE met.edit = asked.edit AND by_chain), (SELECT count(*) FROM met WHERE met.edit = asked.edit AND by_axis AND NOT by_chain),
  (SELECT count(*) FROM met WHERE met.edit = asked.edit AND NOT by_axis AND NOT by_chain),
  CASE edit WHEN 'width' THEN (SELECT concat_ws(' | ', count(*), sum(skipped), sum(refused), sum(refused_in_common)) FROM tried) ELSE '| | |' END || ' |'
FROM asked GROUP BY edit ORDER BY edit DESC;
