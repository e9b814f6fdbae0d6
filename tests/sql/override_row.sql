\set ECHO none
\ir shared/truths.sql
-- A row of a table of decisions is checked as the same edit through its view is. Tables, views and columns come from the catalogue.
\set subjects all
\o /dev/null
\ir ../../data/quarter.sql
\ir shared/by_hand.sql
\o
CREATE TABLE public.decision AS SELECT t.oid::regclass::text AS relation, first_value(a.attname) OVER (PARTITION BY t.oid ORDER BY a.attnum) AS key, v.oid::regclass::text AS view,
    (SELECT k.attname FROM pg_attribute k WHERE k.attrelid = v.oid AND k.attnum = 1) AS view_key, a.attname, a.atttypid::regtype::text AS type,
    EXISTS (SELECT FROM pg_attribute w WHERE (w.attrelid, w.attname, w.atttypid) = (v.oid, a.attname, a.atttypid)) AND a.attname <> 'geom' AS shown, EXISTS (SELECT FROM pg_attribute w WHERE (w.attrelid, w.attname) = (v.oid, 'by_hand')) AS marked
  FROM pg_class t JOIN pg_attribute a ON a.attrelid = t.oid AND a.attnum > 0 AND NOT attisdropped
    LEFT JOIN pg_class v ON v.relnamespace = t.relnamespace AND v.relkind = 'v' AND v.relname = CASE t.relname WHEN 'road_override' THEN 'road_arc_editing' ELSE replace(t.relname, '_override', '_editing') END
  WHERE t.relnamespace = 'quarter'::regnamespace AND t.relkind = 'r' AND t.relname LIKE '%\_override';
CREATE TABLE public.odd (type text, value text);
INSERT INTO public.odd VALUES ('double precision', '''NaN'''), ('double precision', '''-Infinity'''), ('double precision', '-1e9'), ('double precision', '1e9'), ('integer', '-70'), ('integer', '2000000000'), ('text', '''no such'''), ('text', ''''''),
  ('geometry', '''SRID=2154;POINT(NaN 1)'''), ('geometry', '''SRID=2154;POINT(1e15 1)'''), ('geometry', '''SRID=32631;POINT(1 1)'''), ('geometry', '''SRID=2154;POINT EMPTY'''), ('geometry', '''SRID=2154;LINESTRING(0 0,1 1)'''), ('double precision[]', '''{NaN}'''), ('double precision[]', '''{}'''), ('double precision[]', '''{NULL}''');
-- A view shows the place of what it edits, a table the place by which it is found: geom is tried at the table alone.
CREATE TABLE public.tried AS SELECT relation, attname, value, to_jsonb(test.refusal(format('UPDATE %s SET %I = %s WHERE %4$I = (SELECT min(%4$I) FROM %1$s)', relation, attname, value, key))) AS direct,
    to_jsonb(test.refusal(format('INSERT INTO %s (%s) SELECT %s FROM %1$s LIMIT 1', relation, columns, array_to_string(array_replace(columns_array, quote_ident(attname), value), ', ')))) AS put,
    CASE WHEN shown THEN to_jsonb(test.refusal(format('UPDATE %s SET %I = %s WHERE %4$I = (SELECT min(%4$I) FROM %1$s%5$s)', view, attname, value, view_key, CASE WHEN marked THEN ' WHERE by_hand' END))) END AS viewed
  FROM public.decision JOIN public.odd USING (type)
    JOIN (SELECT relation, array_agg(quote_ident(attname)) AS columns_array, string_agg(quote_ident(attname), ', ') AS columns FROM public.decision WHERE attname <> key GROUP BY relation) c USING (relation);
SELECT format('the view of %s tells what it refuses', relation), count(*) > 0 AND bool_and(viewed ->> 'state' IN ('22023', '23514', '23502', '0A000', 'none')) FROM public.tried WHERE viewed IS NOT NULL GROUP BY relation ORDER BY relation;
SELECT format('what the view of %s refuses the table refuses', relation), bool_and(direct ->> 'state' IN ('22023', '23514', '23502')) FROM public.tried WHERE viewed ->> 'state' IN ('22023', '23514', '23502') GROUP BY relation ORDER BY relation;
SELECT format('the table refuses of %s what is no number or place', relation), bool_and(direct ->> 'state' IN ('22023', '23514')) FROM public.tried
  WHERE value ~ 'NaN|Infinity|NULL|POINT|-1e9|-70|no such' GROUP BY relation ORDER BY relation;
SELECT format('a row that is put is refused as one that is changed: %s', relation), bool_and(put ->> 'state' = direct ->> 'state' AND (put ->> 'said' = direct ->> 'said' OR put ->> 'said' LIKE '% of the new %')) FROM public.tried WHERE direct ->> 'state' <> 'none' GROUP BY relation ORDER BY relation;
SELECT format('and names row, value and way out: %s', relation), bool_and(direct ->> 'said' LIKE format('the %s of %s %% cannot be %%', attname, replace(split_part(relation, '.', 2), '_', ' ')) AND direct ->> 'detail' LIKE 'Expected %' AND direct ->> 'hint' <> '')
  FROM public.tried WHERE direct ->> 'state' = '23514' GROUP BY relation ORDER BY relation;
SELECT format('a row of %s is deleted at its table', relation), test.state(format('DELETE FROM %s', relation)) = 'none' FROM (SELECT DISTINCT relation FROM public.decision) d ORDER BY relation;
SELECT 'then nothing is by hand', count(*) FILTER (WHERE method = 'by_hand') = 0 FROM quarter.section_limit;
