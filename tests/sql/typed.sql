\set ECHO none
\ir shared/truths.sql
-- Each statement of each function fits the tables and functions that it names, also where no test runs it.  Each SELECT is one truth: (name, holds).
CREATE EXTENSION plpgsql_check;
CREATE EXTENSION postgis_topology;
SELECT streetgen.create_model('town', 2154, 3, ARRAY(SELECT subject FROM streetgen._subject())), streetgen.create_design('town'), streetgen.create_traffic('town') \g /dev/null
CREATE FUNCTION test.broken(model name) RETURNS bigint LANGUAGE plpgsql AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN (SELECT axis_id FROM edge WHERE edge_number = 1);
END $$;
CREATE TEMPORARY TABLE had AS SELECT proconfig, prosrc FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace;
CREATE FUNCTION test.broken() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
    PERFORM FROM edge WHERE axis_id = NEW.axis_id AND edge_number = 1;
    RETURN NEW;
END $$;
CREATE TRIGGER broken BEFORE INSERT ON town.axis FOR EACH ROW EXECUTE FUNCTION test.broken();
CREATE TRIGGER broken BEFORE INSERT ON town.edge FOR EACH ROW EXECUTE FUNCTION test.broken();
CREATE FUNCTION test.broken_after() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
    IF TG_OP = 'INSERT' THEN
        PERFORM FROM now WHERE edge_number = 1;
    END IF;
    RETURN NULL;
END $$;
CREATE TRIGGER broken_insert AFTER INSERT ON town.axis REFERENCING NEW TABLE AS now FOR EACH STATEMENT EXECUTE FUNCTION test.broken_after();
CREATE TRIGGER broken_delete AFTER DELETE ON town.axis REFERENCING OLD TABLE AS before FOR EACH STATEMENT EXECUTE FUNCTION test.broken_after();
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
-- A function of triggers is looked at with each table and event that it serves.  A fault is one that all have that see the rows: a line about rows
-- before or after is not seen by an event without them.
CREATE TEMPORARY TABLE looked AS
SELECT f.oid, tgrelid, tgoldtable, tgnewtable, row_number() OVER () AS use FROM pg_proc f JOIN pg_language l ON l.oid = prolang
    LEFT JOIN LATERAL (SELECT DISTINCT tgrelid, tgoldtable, tgnewtable FROM pg_trigger WHERE tgfoid = f.oid) t ON true
WHERE lanname = 'plpgsql' AND (pronamespace IN ('streetgen'::regnamespace, 'town'::regnamespace) OR f.proname LIKE 'broken%') AND (prorettype <> 'trigger'::regtype OR tgrelid IS NOT NULL);
CREATE TEMPORARY TABLE found AS
SELECT l.oid, use, c.lineno, c.sqlstate, c.message, c.sqlstate = '42P01' AND substring(c.message, '"([^"]*)"') IN (SELECT unnest(ARRAY[o.tgoldtable, o.tgnewtable]) FROM looked o WHERE o.oid = l.oid) AS blind
FROM looked l CROSS JOIN LATERAL public.plpgsql_check_function_tb(l.oid, coalesce(tgrelid, 0), fatal_errors => false, other_warnings => false, extra_warnings => false,
        performance_warnings => false, oldtable => tgoldtable, newtable => tgnewtable) c
WHERE c.level = 'error'
    -- Out of its sight are records of an unknown row and tables made on the way.
    AND c.sqlstate <> '55000' AND c.message !~ '^record "|"pg_temp\.|^cached plan'
    -- A newer PostGIS has the one, and QGIS makes the other.
    AND c.message !~ 'postgis_srs|public.layer_styles';
CREATE TEMPORARY TABLE fault AS
SELECT oid::regprocedure AS function, lineno, min(message) AS message FROM found f WHERE NOT blind
GROUP BY oid, lineno, sqlstate HAVING count(DISTINCT use) + (SELECT count(DISTINCT use) FROM found b WHERE b.blind AND (b.oid, b.lineno) = (f.oid, f.lineno)) >= (SELECT count(*) FROM looked l WHERE l.oid = f.oid);
RESET search_path;
SELECT 'hundreds of functions are looked at' AS name, count(*) > 300 AS holds FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace
    AND prolang = (SELECT oid FROM pg_language WHERE lanname = 'plpgsql');
SELECT 'a column that is not there is found', count(DISTINCT function) = 3 FROM fault WHERE function::text ~ 'test\.broken' AND message ~ 'edge_number';
SELECT 'every statement fits what it names', count(*) = 0 FROM fault WHERE function::text !~ 'test\.broken';
SELECT 'no function drops by a name that another schema may have', count(*) = 0 FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace AND prosrc ~ '_use_model'
  AND regexp_replace(regexp_replace(prosrc, '--[^\n]*', '', 'g'), '''[^'']*''', '', 'g') ~ '\mDROP (FUNCTION|TABLE|INDEX|VIEW|TRIGGER|SEQUENCE) (?!(IF EXISTS )?pg_temp)';
SELECT 'what uses a model sets its own path, and uses it once and first', count(*) > 150 AND count(*) FILTER (WHERE path IS NULL OR path !~ '^search_path="?pg_catalog' OR uses <> 1 OR before ~ ';') = 0
FROM (SELECT (SELECT c FROM unnest(proconfig) c WHERE c LIKE 'search_path=%') AS path, (SELECT count(*) FROM regexp_matches(source, '_use_model\(', 'g')) AS uses, substring(source, '\mBEGIN\M(.*?)streetgen\._use_model\(') AS before
  FROM (SELECT proconfig, regexp_replace(prosrc, '--[^\n]*', '', 'g') AS source FROM had) s WHERE source ~ 'PERFORM streetgen\._use_model') f;
-- streetgen._use_model sets search_path, which a worker may not.
WITH RECURSIVE own AS (SELECT oid, proname, regexp_replace(regexp_replace(regexp_replace(prosrc, '--[^\n]*', '', 'g'), '''[^'']*''', '', 'g'), '\$[a-z]+\$.*?\$[a-z]+\$', '', 'g') AS source, proparallel FROM pg_proc WHERE pronamespace = 'streetgen'::regnamespace),
  used(oid) AS (SELECT oid FROM own WHERE proname = '_use_model' UNION SELECT c.oid FROM used JOIN own t USING (oid) JOIN own c ON c.source ~ format('streetgen\.%s\(', t.proname))
SELECT 'no function that uses a model runs in a worker', count(*) > 150 AND count(*) FILTER (WHERE proparallel <> 'u') = 0 FROM used JOIN own USING (oid);
SELECT format('%s, line %s: %s', function, lineno, message), false FROM fault WHERE function::text !~ 'test\.broken' ORDER BY 1;
