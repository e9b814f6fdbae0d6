\set ECHO none
\ir shared/truths.sql
-- Each statement of each function fits the tables and functions that it names, also where no test runs it.  Each SELECT is one truth: (name, holds).
CREATE EXTENSION plpgsql_check;
CREATE EXTENSION postgis_topology;
SELECT streetgen.create_model('town', 2154, 3, ARRAY(SELECT subject FROM streetgen._subject())), streetgen.create_design('town') \g /dev/null
CREATE FUNCTION test.broken(model name) RETURNS bigint LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT axis_id FROM edge WHERE edge_number = 1);
END $$;
-- The check does not run streetgen._use_model: functions that call it get the path of this session.
DO $$
DECLARE
    f regprocedure;
BEGIN
    FOR f IN SELECT oid FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace AND prosrc ~ 'PERFORM streetgen\._use_model' LOOP
        EXECUTE format('ALTER FUNCTION %s RESET search_path', f);
    END LOOP;
END $$;
SET search_path = town, public, pg_temp;
CREATE TEMPORARY TABLE fault AS
SELECT f.oid::regprocedure AS function, c.lineno, c.message FROM pg_proc f JOIN pg_language l ON l.oid = prolang
    LEFT JOIN LATERAL (SELECT tgrelid, tgoldtable, tgnewtable, (SELECT count(DISTINCT tgrelid) FROM pg_trigger WHERE tgfoid = f.oid) AS tables FROM pg_trigger WHERE tgfoid = f.oid ORDER BY num_nulls(tgoldtable, tgnewtable), tgrelid LIMIT 1) t ON true
    CROSS JOIN LATERAL public.plpgsql_check_function_tb(f.oid, coalesce(tgrelid, 0), fatal_errors => false, other_warnings => false, extra_warnings => false,
        performance_warnings => false, oldtable => tgoldtable, newtable => tgnewtable) c
WHERE lanname = 'plpgsql' AND (pronamespace IN ('streetgen'::regnamespace, 'town'::regnamespace) OR f.proname = 'broken')
    AND (prorettype <> 'trigger'::regtype OR tgrelid IS NOT NULL) AND c.level = 'error'
    -- Out of its sight are records of an unknown row, tables made on the way, and what a trigger is given at another event or on another table.
    AND c.sqlstate <> '55000' AND c.message !~ '^record "|"pg_temp\.|^cached plan' AND NOT (tgrelid IS NOT NULL AND (tables > 1 OR c.sqlstate = '42P01' AND tgoldtable IS NULL <> (tgnewtable IS NULL)))
    -- A newer PostGIS has the one, and QGIS makes the other.
    AND c.message !~ 'postgis_srs|public.layer_styles';
RESET search_path;
SELECT 'hundreds of functions are looked at' AS name, count(*) > 300 AS holds FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace
    AND prolang = (SELECT oid FROM pg_language WHERE lanname = 'plpgsql');
SELECT 'a column that is not there is found', count(*) = 1 FROM fault WHERE function = 'test.broken(name)'::regprocedure AND message ~ 'edge_number';
SELECT 'every statement fits what it names', count(*) = 0 FROM fault WHERE function <> 'test.broken(name)'::regprocedure;
SELECT 'no function drops by a name that another schema may have', count(*) = 0 FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace AND prosrc ~ '_use_model'
  AND regexp_replace(regexp_replace(prosrc, '--[^\n]*', '', 'g'), '''[^'']*''', '', 'g') ~ '\mDROP (FUNCTION|TABLE|INDEX|VIEW|TRIGGER|SEQUENCE) (?!(IF EXISTS )?pg_temp)';
-- streetgen._use_model sets search_path, which a worker may not.
WITH RECURSIVE own AS (SELECT oid, proname, regexp_replace(regexp_replace(regexp_replace(prosrc, '--[^\n]*', '', 'g'), '''[^'']*''', '', 'g'), '\$[a-z]+\$.*?\$[a-z]+\$', '', 'g') AS source, proparallel FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace),
  used(oid) AS (SELECT oid FROM own WHERE proname = '_use_model' UNION SELECT c.oid FROM used JOIN own t USING (oid) JOIN own c ON c.source ~ format('streetgen\.%s\(', t.proname))
SELECT 'no function that uses a model runs in a worker', count(*) > 150 AND count(*) FILTER (WHERE proparallel <> 'u') = 0 FROM used JOIN own USING (oid);
SELECT format('%s, line %s: %s', function, lineno, message), false FROM fault WHERE function <> 'test.broken(name)'::regprocedure ORDER BY 1;
