-- Zones from a user's own table.

CREATE OR REPLACE FUNCTION streetgen._zone_ground(geom geometry, srid integer, width float8) RETURNS geometry
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    flat constant geometry := ST_Force2D(ST_CurveToLine(geom));
    ground geometry;
BEGIN
    ground := ST_Transform(flat, srid);
    RETURN ST_Multi(ST_CollectionExtract(ST_MakeValid(CASE ST_Dimension(ground) WHEN 2 THEN ground
        ELSE ST_Buffer(ground, width / 2, 'endcap=flat') END), 3));
EXCEPTION WHEN internal_error THEN
    RAISE EXCEPTION 'the % of a zone, of SRID %, makes no ground of SRID %', GeometryType(geom), ST_SRID(geom), srid
        USING ERRCODE = '22023', DETAIL = SQLERRM,
        HINT = 'Mend its coordinates or its SRID, or make a polygon of it.';
END $$;
COMMENT ON FUNCTION streetgen._zone_ground(geometry, integer, float8) IS
    'What a zone covers, in another reference: a line or point width metres wide. 22023 where it makes no polygon.';

CREATE OR REPLACE FUNCTION streetgen._add_zones(model name) RETURNS bigint
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    wrong record;
    added bigint;
BEGIN
    PERFORM streetgen._use_model(model);
    SELECT count(*) > 0 AS any, min(z.class) AS class INTO wrong FROM pg_temp._zone z
        WHERE NOT EXISTS (SELECT FROM zone_class c WHERE c.class = z.class);
    IF wrong.any THEN
        RAISE EXCEPTION 'a zone has class "%", which stands in no row of zone_class', coalesce(wrong.class, 'NULL')
            USING ERRCODE = '22023', HINT = format('INSERT INTO %I.zone_class (class, cost, passage) VALUES (…).',
                model);
    END IF;
    INSERT INTO zone (class, geom) SELECT class, geom FROM pg_temp._zone WHERE NOT ST_IsEmpty(geom);
    GET DIAGNOSTICS added = ROW_COUNT;
    RETURN added;
END $$;
COMMENT ON FUNCTION streetgen._add_zones(name) IS
    'Adds the zones of table _zone to a model and counts them; a class that stands in no row of zone_class: 22023.';

CREATE OR REPLACE FUNCTION streetgen.import_zones(model name, source regclass, mapping jsonb) RETURNS bigint
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    target_srid constant integer := (SELECT m.srid FROM streetgen.model m WHERE m.name = model);
    wrong record;
    class_of text;
    geom_of text;
    width_of text;
    added bigint;
BEGIN
    PERFORM streetgen._require_owner(model),
        streetgen._check_given('source', source::text, 'mapping', mapping::text), streetgen._require_design(model);
    SELECT key INTO wrong FROM jsonb_object_keys(mapping) key WHERE key NOT IN ('class', 'geom', 'width');
    IF FOUND OR NOT mapping ? 'class' THEN
        RAISE EXCEPTION 'the mapping of zones is %', mapping USING ERRCODE = '22023',
            HINT = 'For example {"class": {"value": "water"}, "geom": "geom", "width": 8}: class is a column or a '
                'value, width the breadth of zones that are lines.';
    END IF;
    geom_of := streetgen._source_column(source, coalesce(mapping ->> 'geom', 'geom'));
    class_of := CASE WHEN jsonb_typeof(mapping -> 'class') = 'string'
        THEN format('%I::text', streetgen._source_column(source, mapping ->> 'class'))
        ELSE quote_literal(mapping -> 'class' ->> 'value') END;
    width_of := coalesce((mapping ->> 'width')::float8, 5)::text;
    EXECUTE format('CREATE TEMPORARY TABLE _zone ON COMMIT DROP AS SELECT %s AS class,
        streetgen._zone_ground(%I, %s, %L) AS geom FROM %s WHERE NOT ST_IsEmpty(%2$I)', class_of, geom_of, target_srid,
        width_of, source);
    added := streetgen._add_zones(model);
    DROP TABLE pg_temp._zone;
    RETURN added;
END $$;
COMMENT ON FUNCTION streetgen.import_zones(name, regclass, jsonb) IS
    'Adds the rows of a table to the zones of a model; returns how many. mapping: class -> column (a string) or '
    '{"value": class}; geom -> column; width: breadth of zones that are lines, metres (5). A class that stands in no '
    'row of zone_class, another mapping, a geometry that '
    'makes no ground: 22023; a column that is not there: 42703; a model without a design: 55000; '
    'not its owner: 42501.';
