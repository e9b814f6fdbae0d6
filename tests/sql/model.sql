-- Models: what create_model refuses and makes, settings, rights. Each test is a row (name, holds).
CREATE FUNCTION pg_temp.sqlstate_of(statement text) RETURNS text LANGUAGE plpgsql AS $$
BEGIN EXECUTE statement; RETURN '00000'; EXCEPTION WHEN OTHERS THEN RETURN SQLSTATE; END $$;

SELECT 'create_model', pg_temp.sqlstate_of($$SELECT streetgen.create_model('town', 2154)$$) = '00000';
SELECT 'an existing schema is 42P06', pg_temp.sqlstate_of($$SELECT streetgen.create_model('town', 2154)$$) = '42P06';
SELECT 'unfit SRID ' || srid || ' is 22023', pg_temp.sqlstate_of(format('SELECT streetgen.create_model(%L, %s)', 'other', srid)) = '22023' FROM unnest(ARRAY[4326, 3857, 2263, 0, 999999]) srid;
SELECT 'dimension 4 is 22023', pg_temp.sqlstate_of($$SELECT streetgen.create_model('other', 2154, 4)$$) = '22023';
SELECT 'what was refused left nothing', NOT EXISTS (SELECT FROM pg_namespace WHERE nspname = 'other');
SELECT 'the registry knows the model', srid = 2154 AND dimension = 2 FROM streetgen.model WHERE name = 'town';
SELECT 'every relation of a model has a comment: ' || coalesce(string_agg(relname, ', '), 'all'), count(*) = 0
    FROM pg_class c WHERE relnamespace = 'town'::regnamespace AND relkind IN ('r', 'v') AND obj_description(c.oid, 'pg_class') IS NULL;
SELECT 'a setting out of range is 22023: ' || value, pg_temp.sqlstate_of(format('SELECT streetgen.set(%L, %L, %L)', 'town', name, value)) = '22023'
    FROM (VALUES ('tolerance', 'NaN'), ('tolerance', '-1'), ('tolerance', 'x'), ('crossing', 'maybe'), ('radius_by_importance', '[1]'), ('radius_by_importance', '{"1": "NaN"}'), ('no such', '1')) s(name, value);
SELECT 'a setting within its range is set', pg_temp.sqlstate_of($$SELECT streetgen.set('town', 'tolerance', '0.25')$$) = '00000';
SELECT 'and read back', value = '0.25' FROM streetgen.setting('town') WHERE name = 'tolerance';
SELECT 'a NaN width of an axis is refused', pg_temp.sqlstate_of($$INSERT INTO town.axis (geom, width) VALUES ('SRID=2154;LINESTRING(0 0,1 1)', 'NaN')$$) = '23514';
SELECT 'axis refuses ' || what, pg_temp.sqlstate_of(format('INSERT INTO town.axis (geom) VALUES (%s)', expression)) IN ('23514', '22023', '23502') FROM (VALUES
    ('an empty line', $$'SRID=2154;LINESTRING EMPTY'$$), ('NULL', 'NULL'), ('another SRID', $$'SRID=32631;LINESTRING(0 0,1 1)'$$), ('a polygon', $$'SRID=2154;POLYGON((0 0,1 0,1 1,0 0))'$$),
    ('no length', $$'SRID=2154;LINESTRING(3 3,3 3)'$$), ('a NaN vertex', $$ST_SetSRID(ST_MakeLine(ARRAY[ST_MakePoint(0, 0), ST_MakePoint('NaN', 0), ST_MakePoint(5, 5)]), 2154)$$)) s(what, expression);
SELECT 'a model that is not there is 3F000', pg_temp.sqlstate_of($$SELECT streetgen.generate('nowhere')$$) = '3F000';
CREATE ROLE streetgen_stranger;
GRANT streetgen_stranger TO CURRENT_USER;
SET ROLE streetgen_stranger;
SELECT 'generate is the owner''s: 42501', pg_temp.sqlstate_of($$SELECT streetgen.generate('town')$$) = '42501';
SELECT 'the registry is not written by others', pg_temp.sqlstate_of($$INSERT INTO streetgen.model VALUES ('x', 2154, 2, '0')$$) = '42501';
RESET ROLE;
SELECT 'grant reader', pg_temp.sqlstate_of($$SELECT streetgen.grant('town', 'streetgen_stranger', 'reader')$$) = '00000';
SET ROLE streetgen_stranger;
SELECT 'a reader reads', pg_temp.sqlstate_of('SELECT count(*) FROM town.axis') = '00000';
SELECT 'a reader does not write', pg_temp.sqlstate_of('DELETE FROM town.axis') = '42501';
RESET ROLE;
SELECT 'drop_model', pg_temp.sqlstate_of($$SELECT streetgen.drop_model('town')$$) = '00000';
SELECT 'the registry forgets a dropped model', NOT EXISTS (SELECT FROM streetgen.model WHERE name = 'town');
DROP ROLE streetgen_stranger;
