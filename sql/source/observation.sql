-- Observations of streets from a table of points, lines or areas, by a mapping.

CREATE OR REPLACE FUNCTION streetgen._check_observations() RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
    number constant text := '^\d{1,12}(\.\d+)?([eE][-+]?\d{1,2})?$';
BEGIN
    SELECT label, has INTO bad FROM (
        SELECT label, CASE
            WHEN kind <> ALL ('{kerb,sidewalk_back,marking,object,width}') THEN format('kind "%s"', kind)
            WHEN confidence !~ number OR confidence::float8 NOT BETWEEN 0 AND 1
                THEN format('confidence "%s"', confidence)
            WHEN weight !~ number OR weight::float8 NOT BETWEEN 0.001 AND 1000000 THEN format('weight "%s"', weight)
            WHEN relation <> ALL ('{in,out,border}') THEN format('relation "%s"', relation)
            WHEN kind = 'object' AND relation IS NULL THEN 'an object without a relation'
            WHEN kind = 'width' AND GeometryType(geom) NOT LIKE '%LINESTRING'
                THEN format('a %s as width', GeometryType(geom))
            WHEN kind = 'width' AND ST_Length(geom) = 0 THEN 'a width without length'
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN NOT (ST_XMin(geom) >= -1e12 AND ST_XMax(geom) <= 1e12 AND ST_YMin(geom) >= -1e12
                AND ST_YMax(geom) <= 1e12) THEN 'a coordinate that is not finite' END AS has
        FROM pg_temp._import_observation WHERE geom IS NOT NULL AND NOT ST_IsEmpty(geom)) o
    WHERE has IS NOT NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, bad.has USING ERRCODE = '22023',
            HINT = 'kind is kerb, sidewalk_back, marking, object or width; confidence 0 to 1; weight 0.001 to 1000000; '
                'relation in, out or border, of each object; a width is a line across; geom has a known SRID.';
    END IF;
    SELECT source_ref AS label INTO bad FROM pg_temp._import_observation WHERE source_ref IS NOT NULL
        GROUP BY source_ref HAVING count(*) > 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source_ref "%" stands in more than one row', bad.label USING ERRCODE = '22023',
            HINT = 'Map source_ref to a column of distinct values, or leave it out.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_observations() IS
    'Raises 22023 for the first observation of the import of an unknown kind or relation, with a bad number or place, '
    'and for a source_ref that comes twice.';

CREATE OR REPLACE FUNCTION streetgen._write_observations(model name, source text) RETURNS void
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public SET streetgen.live = 'off'
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
BEGIN
    PERFORM streetgen._use_model(model);
    DELETE FROM observation o WHERE o.source = origin AND NOT EXISTS (SELECT FROM pg_temp._observed i
        WHERE i.source_ref = o.source_ref);
    INSERT INTO observation (kind, geom, confidence, weight, relation, source, source_ref)
        SELECT i.kind, i.geom, i.confidence, i.weight, i.relation, origin, i.source_ref
        FROM pg_temp._observed i ORDER BY i.source_ref, i.geom
        ON CONFLICT (source, source_ref) DO UPDATE SET (kind, geom, confidence, weight, relation)
            = ROW (excluded.kind, excluded.geom, excluded.confidence, excluded.weight, excluded.relation);
END $$;
COMMENT ON FUNCTION streetgen._write_observations(name, text) IS
    'Writes the observations of a source that were read, and takes away those that are gone. Distances do not follow '
    'each of these statements: who calls it brings them up to date once.';

CREATE OR REPLACE FUNCTION streetgen._observe(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    origin constant text COLLATE "default" := source;
    model_name constant name := model;
    places geometry[];
BEGIN
    PERFORM streetgen._use_model(model), streetgen._check_observations();
    RETURN QUERY SELECT 'observation without geometry, left out', i.kind, count(*), (array_agg(i.label))[:1000]
        FROM pg_temp._import_observation i WHERE i.geom IS NULL OR ST_IsEmpty(i.geom) GROUP BY i.kind ORDER BY i.kind;
    CREATE TEMPORARY TABLE _observed ON COMMIT DROP AS
        SELECT coalesce(i.kind, 'kerb') AS kind, streetgen._transformed('observation ' || i.label,
                ST_Force2D(i.geom), m.srid) AS geom, coalesce(i.confidence::float8, 1) AS confidence,
            coalesce(i.weight::float8, 1) AS weight, i.relation, i.source_ref
        FROM pg_temp._import_observation i, streetgen.model m
        WHERE m.name = model_name AND i.geom IS NOT NULL AND NOT ST_IsEmpty(i.geom);
    DROP TABLE pg_temp._import_observation;
    places := ARRAY(SELECT o.geom FROM observation o WHERE o.source = origin
        UNION ALL SELECT i.geom FROM pg_temp._observed i);
    PERFORM streetgen._write_observations(model, origin), streetgen._update_distances(model, places);
    RETURN QUERY SELECT 'observations', i.kind, count(*), NULL::text[] FROM pg_temp._observed i
        GROUP BY i.kind ORDER BY i.kind;
    DROP TABLE pg_temp._observed;
END $$;
COMMENT ON FUNCTION streetgen._observe(name, text) IS
    'Brings the observations of a source up to date with those that were read, and reports them.';

CREATE OR REPLACE FUNCTION streetgen.observe(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    PERFORM streetgen._require_subject(model, 'fit'), streetgen._take_points('_import_observation',
        streetgen._point_query('observation', '{geom,kind,confidence,weight,relation,source_ref}', '{geom}', source,
            mapping));
    RETURN QUERY SELECT * FROM streetgen._observe(model, source::text);
END $$;
COMMENT ON FUNCTION streetgen.observe(name, regclass, jsonb) IS
    'Takes a table of points, lines or areas as observations of streets, for streetgen.fit. mapping: geom, kind, '
    'confidence, weight, relation, source_ref -> source column (string) or {"value": constant}; SQL is never '
    'evaluated. kind: kerb (the default), sidewalk_back, marking, object (then relation: in, out or border) or width '
    '(a line across); confidence 0 to 1, by default 1; weight by default 1. Observing a table again follows it: rows '
    'with a source_ref keep their ids, others are replaced, and those that are gone go. A row that is to stay gets an '
    'empty source. Reports counts by kind. A missing column: 42703; a bad row or mapping: 22023, and the model stays '
    'as it was; a model without subject fit: 55000. Needs the rights of the owner (42501).';
