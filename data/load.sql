-- data/streetgen load imports the rows that it read, in one transaction. Variables: model, srid, subjects, drawn_up_to, again, crossing, driving_side, mapping, take, read, source, objects, attribution, file, warning, dry_run.
-- The model that was there goes only together with the coming of the one that replaces it; what was read stays in the file.
BEGIN;
SELECT FROM streetgen.model, streetgen.drop_model(name) WHERE name = :'model' AND NOT :again \g /dev/null
SELECT streetgen.create_model(:'model', :srid, subjects => string_to_array(nullif(:'subjects', ''), ',')) WHERE NOT :again \g /dev/null
SELECT streetgen.set(:'model', 'driving_side', :'driving_side') WHERE :'driving_side' <> '' \g /dev/null
SELECT streetgen.set(:'model', 'crossing', :'crossing') WHERE :'crossing' <> '' \g /dev/null
-- Words of the owner's own stay.
SELECT streetgen.set(:'model', 'attribution', :'attribution') FROM streetgen.setting(:'model') s WHERE s.name = 'attribution' AND s.value = '' AND :'attribution' <> '' \g /dev/null
CREATE TEMPORARY TABLE load_report ON COMMIT DROP AS SELECT row_number() OVER () AS line, r.* FROM :take r;
-- A picture of few axes shows streets as they are seen, unless somebody said what is computed. A new model computes what was said already.
SELECT streetgen._switch_on(:'model', CASE WHEN :'subjects' <> '' THEN string_to_array(:'subjects', ',') ELSE '{drawn}' END)
    FROM :"model".axis HAVING CASE WHEN :'subjects' <> '' THEN :again ELSE NOT :again AND count(*) <= :drawn_up_to END \g /dev/null
CREATE TEMPORARY TABLE object_report (LIKE load_report) ON COMMIT DROP;
SELECT :'objects' <> '' AND 'object' = ANY (streetgen._subjects(:'model')) AS takes_objects \gset
\if :takes_objects
INSERT INTO object_report SELECT (SELECT max(line) FROM load_report) + row_number() OVER (), r.*
    FROM streetgen.import_osm_objects(:'model', :'objects') r;
\endif
SELECT what, class, count, array_to_string(source_refs[:most] || CASE WHEN cardinality(source_refs) > most THEN '…' END, ', ') AS source_refs
    FROM (TABLE load_report UNION ALL TABLE object_report) r, (SELECT CASE WHEN :dry_run THEN 1000000 ELSE 5 END AS most) m ORDER BY line;
-- What somebody is to settle, geometry by its length.
SELECT EXISTS (SELECT FROM (TABLE load_report UNION ALL TABLE object_report) r WHERE what = 'in conflict') AS in_conflict \gset
\if :in_conflict
SELECT source_ref, coalesce(axis_id::text, relation || ' ' || row_id) AS axis_id, column_name, by_hand, source_old, source_new, stands FROM (
    SELECT source_ref, axis_id, relation, row_id, column_name, stands, shown[1] AS by_hand, shown[2] AS source_old, shown[3] AS source_new
    FROM :"model".import_conflict, LATERAL (SELECT array_agg(CASE WHEN column_name LIKE '%geom' THEN round(ST_Length(v::geometry)::numeric, 1) || ' m' ELSE left(v, 60) END ORDER BY n) AS shown
        FROM unnest(ARRAY[by_hand, source_old, source_new]) WITH ORDINALITY u(v, n)) s) c
ORDER BY source_ref, axis_id, column_name LIMIT CASE WHEN :dry_run THEN NULL ELSE 20 END;
\endif
-- The last words where less than half of the rows became axes: why, the most frequent reasons first, and what to do.
WITH row AS (SELECT count(*) AS rows, (SELECT coalesce(sum(count), 0) FROM load_report WHERE what IN ('taken',
    'taken as footway', 'taken as track')) AS taken FROM :source),
reason AS (SELECT row_number() OVER (ORDER BY count DESC, line) AS turn, * FROM load_report WHERE what LIKE 'not taken: %' OR what LIKE '%, left out')
SELECT format('warning: %s of the %s rows of %s were taken', taken, rows, :'file') FROM row WHERE 2 * taken < rows
UNION ALL SELECT words FROM row, (
    SELECT turn, format('  %s %s%s', count, what, ' "' || class || '"') AS words FROM reason WHERE turn <= 5
    UNION ALL SELECT 6, format('  and %s for %s other reasons', sum(count), count(*)) FROM reason WHERE turn > 5 HAVING count(*) > 0
    UNION ALL SELECT 7, format('  where letters of a class are wrong, set SHAPE_ENCODING to the encoding of the file; a class that is new INSERT into %I.axis_class, then load --again', :'model')
        WHERE EXISTS (SELECT FROM reason WHERE what = 'not taken: unknown class')
    UNION ALL SELECT 8, format('  UPDATE %I.axis_class SET taken = true for the classes that are wanted, then load --again', :'model') WHERE EXISTS (SELECT FROM reason WHERE what = 'not taken: class')) w
WHERE 2 * taken < rows \g (format=unaligned tuples_only=on) :warning
\if :dry_run
ROLLBACK;
DROP TABLE :read;
\else
DROP TABLE :read;
COMMIT;
\endif
