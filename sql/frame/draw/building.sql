-- Buildings are read from a table or view of the user's that setting building_table names.

CREATE OR REPLACE FUNCTION streetgen._relation_named(name text) RETURNS regclass
    LANGUAGE plpgsql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN to_regclass(name);
EXCEPTION WHEN syntax_error_or_access_rule_violation OR feature_not_supported OR data_exception THEN
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._relation_named(text) IS
    'The table or view of that name, with its schema unless in public; NULL where there is none.';

CREATE OR REPLACE FUNCTION streetgen._polygon_column(relation regclass, OUT name name, OUT srid integer)
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT attname, postgis_typmod_srid(atttypmod) FROM pg_attribute
        WHERE attrelid = relation AND attnum > 0 AND NOT attisdropped AND atttypid = 'geometry'::regtype
            AND postgis_typmod_type(atttypmod) ~* '^(multi|curve)?polygon|^multisurface|^geometry'
        ORDER BY attnum LIMIT 1 $$;
COMMENT ON FUNCTION streetgen._polygon_column(regclass) IS
    'The first column of a table or view that can hold polygons, and the SRID that it is declared with, 0 where none.';

CREATE OR REPLACE FUNCTION streetgen._checked_building_table(model name, value text) RETURNS text
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    relation constant regclass := streetgen._relation_named(value);
    stored text;
    wrong text;
BEGIN
    PERFORM streetgen._use_model(model);
    -- Streets are computed also while the table is gone.
    SELECT s.value FROM setting s WHERE s.name = 'building_table' INTO stored;
    IF _checked_building_table.value = 'none' OR _checked_building_table.value = stored THEN
        RETURN _checked_building_table.value;
    END IF;
    wrong := CASE WHEN relation IS NULL THEN 'There is no such table or view.'
        WHEN NOT EXISTS (SELECT FROM pg_class WHERE oid = relation AND relkind IN ('r', 'p', 'v', 'm', 'f')
            AND relpersistence <> 't') THEN 'It is no table or view that stays.'
        WHEN (streetgen._polygon_column(relation)).name IS NULL THEN 'It has no column of polygons.' END;
    IF wrong IS NOT NULL THEN
        RAISE EXCEPTION 'setting "building_table" of model "%" cannot be %', model,
            quote_literal(_checked_building_table.value) USING ERRCODE = '22023', DETAIL = wrong,
            HINT = 'Expected none, or a table or view with a geometry column of polygons, such as town.building.';
    END IF;
    RETURN (SELECT format('%I.%I', nspname, relname) FROM pg_class c JOIN pg_namespace n ON n.oid = relnamespace
        WHERE c.oid = relation);
END $$;
COMMENT ON FUNCTION streetgen._checked_building_table(name, text) IS
    'The table of buildings with its schema; one that is not there or has no polygons: 22023.';

CREATE OR REPLACE FUNCTION streetgen._runs_code_of_others(relation regclass) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$
    WITH RECURSIVE part AS (SELECT relation::oid AS oid
        UNION SELECT inhrelid FROM part JOIN pg_inherits ON inhparent = part.oid)
    SELECT bool_or(NOT pg_has_role(relowner, current_user, 'MEMBER')
        AND (relkind NOT IN ('r', 'p', 'm') OR relrowsecurity OR (SELECT rolsuper FROM pg_roles
                WHERE rolname = current_user)
            -- These are computed while the query is planned.
            OR EXISTS (SELECT FROM pg_index WHERE indrelid = c.oid AND num_nonnulls(indexprs, indpred) > 0)
            OR EXISTS (SELECT FROM pg_partitioned_table WHERE partrelid = c.oid AND partexprs IS NOT NULL)
            OR EXISTS (SELECT FROM pg_statistic_ext WHERE stxrelid = c.oid AND stxexprs IS NOT NULL)
            OR EXISTS (SELECT FROM pg_constraint WHERE conrelid = c.oid AND contype = 'c' AND c.oid <> relation)))
    FROM part JOIN pg_class c USING (oid) $$;
COMMENT ON FUNCTION streetgen._runs_code_of_others(regclass) IS
    'Could reading a relation, or a part of it, run functions that its owner chose, with rights that the owner does '
    'not have? A view does, a policy of rows, and expressions of an index, of statistics, of a partition or its '
    'constraint. A superuser trusts no table of others.';

CREATE OR REPLACE FUNCTION streetgen._transformed(geom geometry, srid integer) RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    RETURN ST_Transform(geom, srid);
EXCEPTION WHEN internal_error OR data_exception THEN
    RETURN NULL;
END $$;
COMMENT ON FUNCTION streetgen._transformed(geometry, integer) IS
    'A geometry in another reference; NULL where it lies outside of a projection, or a reference is none.';

CREATE OR REPLACE FUNCTION streetgen._buildings(relation regclass, box geometry) RETURNS SETOF geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    srid constant integer := ST_SRID(box);
    lost bigint := 0;
    polygon record;
    building geometry;
BEGIN
    -- An index serves where the column is declared with a reference.
    SELECT c.srid, format('SELECT %1$I FROM %2$s WHERE %1$I IS NOT NULL AND ($1 IS NULL OR %1$I && $1)', c.name,
        relation) AS query FROM streetgen._polygon_column(relation) c INTO polygon;
    FOR building IN EXECUTE polygon.query
        USING CASE polygon.srid WHEN 0 THEN NULL WHEN srid THEN box ELSE streetgen._transformed(box, polygon.srid) END
    LOOP
        building := CASE WHEN ST_SRID(building) IN (0, srid) THEN ST_SetSRID(building, srid)
            ELSE streetgen._transformed(building, srid) END;
        IF building IS NULL THEN
            lost := lost + 1;
        ELSIF building && box AND ST_Dimension(building) = 2 THEN
            RETURN NEXT ST_CurveToLine(building);
        END IF;
    END LOOP;
    IF lost > 0 THEN
        RAISE WARNING '% rows of table % are not drawn: their place cannot be told in SRID %', lost, relation, srid
            USING HINT = 'ST_SRID and ST_Extent of its geometry show what is outside of its projection.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._buildings(regclass, geometry) IS
    'The polygons of a table or view in a box, in the SRID of the box, read with the rights of the caller; a warning '
    'counts those that cannot be transformed.';

CREATE OR REPLACE FUNCTION streetgen._building_table(model name) RETURNS regclass
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    named text;
    relation regclass;
    wrong text;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value FROM setting WHERE name = 'building_table' AND value <> 'none' INTO named;
    IF named IS NULL THEN
        RETURN NULL;
    END IF;
    relation := streetgen._relation_named(named);
    wrong := CASE WHEN relation IS NULL THEN 'it is not there'
        WHEN (streetgen._polygon_column(relation)).name IS NULL THEN 'it has no column of polygons'
        WHEN NOT has_table_privilege(relation, 'SELECT')
            OR NOT has_schema_privilege((SELECT relnamespace FROM pg_class WHERE oid = relation), 'USAGE')
            THEN format('role %I may not read it', current_user)
        WHEN streetgen._runs_code_of_others(relation)
            THEN format('its functions would run with the rights of role %I', current_user) END;
    IF wrong IS NOT NULL THEN
        RAISE WARNING 'buildings of model "%" are not drawn: table %, which setting "building_table" names: %', model,
            named, wrong USING HINT = format('SELECT streetgen.set(%L, ''building_table'', ''none'') draws without '
                'buildings. A superuser reads those of another role after SET ROLE; for others a plain table or '
                'materialized view without expressions can stand for it.', model);
        RETURN NULL;
    END IF;
    RETURN relation;
END $$;
COMMENT ON FUNCTION streetgen._building_table(name) IS
    'The table or view of buildings of a model; NULL where it names none, and with a warning where the caller cannot '
    'read it.';

CREATE OR REPLACE FUNCTION streetgen._frame_drawn(model name, box geometry, layers text[])
    RETURNS SETOF streetgen.shape
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 1000 SET search_path = pg_catalog, public
    AS $$
DECLARE
    relation constant regclass := CASE WHEN 'building' = ANY (layers) THEN streetgen._building_table(model) END;
    ground_level integer;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT value FROM setting WHERE name = 'ground_level' INTO ground_level;
    RETURN QUERY SELECT 'building', '', ground_level, b, row_number() OVER (ORDER BY b)
        FROM streetgen._buildings(relation, box) b;
END $$;
COMMENT ON FUNCTION streetgen._frame_drawn(name, geometry, text[]) IS
    'What can be drawn of no subject in a box: building, of the table that setting building_table names.';
