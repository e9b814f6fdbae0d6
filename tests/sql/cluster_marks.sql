\set ECHO none
\ir shared/truths.sql
-- Turn marks that come from afar, where a first run computes cluster by cluster.  Each SELECT is one truth: (name, holds).
SET streetgen.live = off;

-- Pieces of 60 m in a row, the first with marks: alone, and with a street to the right at each node, which does not answer a turn to the left.
CREATE FUNCTION pg_temp.line(VARIADIC c float8[]) RETURNS geometry LANGUAGE sql AS $$
  SELECT ST_SetSRID(ST_MakeLine(array_agg(ST_Point(650000 + c[i], 6860000 + c[i + 1]) ORDER BY i)), 2154) FROM generate_series(1, array_length(c, 1), 2) i $$;
CREATE FUNCTION pg_temp.streets(model name) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  PERFORM streetgen.create_model(model, 2154, driving_side => 'right');
  EXECUTE format($q$INSERT INTO %I.axis (axis_id, geom, width, direction, lane_count, turn_forward)
    SELECT i, pg_temp.line(60 * i, 0, 60 * i + 60, 0), 6, 'direct', 2, CASE i WHEN 1 THEN 'left|through' END FROM generate_series(1, 45) i
    UNION ALL SELECT 100 + i, pg_temp.line(60 * i, 300, 60 * i + 60, 300), 6, 'direct', 2, CASE i WHEN 1 THEN 'left|through' END FROM generate_series(1, 16) i
    UNION ALL SELECT 200 + i, pg_temp.line(60 * i, 300, 60 * i, 250), 5, 'both', NULL, NULL FROM generate_series(2, 16) i
    UNION ALL SELECT 300 + i, pg_temp.line(2760 - 1740 * i, 300 * i, 2760 - 1740 * i, 300 * i + 80), 6, 'both', NULL, NULL FROM generate_series(0, 1) i$q$, model);
END $$;
SELECT pg_temp.streets(m) FROM unnest('{parts,whole}'::name[]) m \g /dev/null
SELECT count(*) FROM streetgen.generate('whole') \g /dev/null
CREATE FUNCTION pg_temp.marks(model name) RETURNS TABLE(axis_id bigint, marks text) LANGUAGE plpgsql AS $$
BEGIN
  RETURN QUERY EXECUTE format('SELECT axis_id, string_agg(coalesce(turn, ''''), ''|'' ORDER BY lane_position) FROM %1$I.lane JOIN %1$I.edge USING (edge_id) WHERE axis_id < 200 GROUP BY axis_id', model);
END $$;
SELECT 'marks hold along the row', marks = 'left|through' FROM pg_temp.marks('whole') WHERE axis_id = 45;
SELECT 'and over streets that do not answer them', split_part(marks, '|', 1) = 'left' FROM pg_temp.marks('whole') WHERE axis_id = 116;
SELECT streetgen.plan_clusters('parts', 24), streetgen._defer_keys('parts') \g /dev/null
SELECT 'clusters part the rows', count(*) > 2 FROM (SELECT cluster FROM streetgen.cluster('parts', 24) WHERE axis_id BETWEEN 101 AND 116 GROUP BY cluster) c;
-- From the far ends on.
SELECT streetgen.generate_cluster('parts', cluster) FROM (SELECT cluster, max(axis_id) FILTER (WHERE axis_id < 200) AS last FROM streetgen.cluster('parts', 24) GROUP BY cluster ORDER BY last DESC NULLS LAST) c \g /dev/null
SELECT 'clusters mark as one statement does' || coalesce((SELECT ': ' || string_agg(concat_ws(' ', axis_id, p.marks, 'instead of', w.marks), ', ' ORDER BY axis_id) FROM pg_temp.marks('parts') p JOIN pg_temp.marks('whole') w USING (axis_id) WHERE p.marks <> w.marks), ''),
  NOT EXISTS (SELECT FROM pg_temp.marks('parts') p FULL JOIN pg_temp.marks('whole') w USING (axis_id) WHERE p.marks IS DISTINCT FROM w.marks);
SELECT streetgen.finish_clusters('parts') \g /dev/null
SELECT 'and leave nothing to be computed', sum(inserted + updated + deleted) = 0 FROM streetgen.generate('parts');

-- A street that parts about an island and joins again, thirty times: each way that marks may take is gone once.
SELECT streetgen.create_model('islands', 2154, driving_side => 'right') \g /dev/null
INSERT INTO islands.axis (axis_id, geom, width, direction, lane_count, turn_forward)
  SELECT 10 * i + n, pg_temp.line(VARIADIC c), 6, CASE n WHEN 0 THEN 'both' ELSE 'direct' END, 2, CASE WHEN i = 1 AND n = 0 THEN 'left|through' END FROM generate_series(1, 30) i,
    LATERAL (VALUES (0, ARRAY[100 * i, 0, 100 * i + 40, 0]), (1, ARRAY[100 * i + 40, 0, 100 * i + 70, 4, 100 * i + 100, 0]), (2, ARRAY[100 * i + 100, 0, 100 * i + 70, -4, 100 * i + 40, 0])) v(n, c);
SET statement_timeout = '30s';
SELECT 'thirty islands in a row are gone along once', cardinality(streetgen._lane_axes_from_afar('islands', ARRAY[300])) > 60;
RESET statement_timeout;
