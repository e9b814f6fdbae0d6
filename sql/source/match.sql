-- The same street in two data sets: which lines of a table go along which axes.

CREATE OR REPLACE FUNCTION streetgen._take_matched(model name, source regclass, mapping jsonb) RETURNS void
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    PERFORM streetgen._use_model(model), streetgen._take_points('_match_row', streetgen._point_query('the source',
        '{geom,source_ref,name}', '{geom,source_ref}', source, mapping));
    SELECT label, has INTO bad FROM (
        SELECT label, CASE WHEN source_ref IS NULL THEN 'no source_ref'
            WHEN ST_IsEmpty(geom) THEN NULL
            WHEN GeometryType(geom) !~ '^(MULTI)?(LINESTRING|CURVE)M?$|^(CIRCULARSTRING|COMPOUNDCURVE)M?$'
                THEN format('a %s as geom', GeometryType(geom))
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN NOT (ST_Length(ST_Force2D(geom)) < 'Infinity') THEN 'a vertex that is not finite' END AS has
        FROM pg_temp._match_row WHERE geom IS NOT NULL) r WHERE has IS NOT NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, bad.has USING ERRCODE = '22023',
            HINT = 'Map geom to a column of lines with a known SRID, and source_ref to one that is never NULL.';
    END IF;
    CREATE TEMPORARY TABLE _match_part ON COMMIT DROP AS
        SELECT r.source_ref, r.name, d.geom, sum(ST_Length(d.geom)) OVER (PARTITION BY r.source_ref) AS length
        FROM (SELECT source_ref, name, streetgen._transformed('row ' || label, ST_CurveToLine(ST_Force2D(geom)),
                (SELECT m.srid FROM streetgen.model m WHERE m.name = model)) AS geom
            FROM pg_temp._match_row WHERE NOT ST_IsEmpty(geom)) r, ST_Dump(r.geom) d
        WHERE ST_Length(d.geom) > 0;
    DROP TABLE pg_temp._match_row;
    ANALYZE pg_temp._match_part;
END $$;
COMMENT ON FUNCTION streetgen._take_matched(name, regclass, jsonb) IS
    'Makes a temporary table of the lines of a source by a mapping, in the reference of a model, a row each, with the '
    'length of all that share the source_ref. A bad row: 22023.';

CREATE OR REPLACE FUNCTION streetgen.match_axes(model name, source regclass, mapping jsonb,
    distance float8 DEFAULT 10)
    RETURNS TABLE(axis_id bigint, source_ref text, shared float8, alike float8, score float8)
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    folding text;
    weight float8;
    least_score float8;
BEGIN
    PERFORM streetgen._use_model(model);
    PERFORM streetgen._require_reader(model), streetgen._check_given('source', source::text, 'mapping', mapping::text,
        'distance', distance::text);
    IF NOT (distance >= 0.1 AND distance <= 100) THEN
        RAISE EXCEPTION 'distance is %, out of range', distance USING ERRCODE = '22023',
            HINT = 'Axes are dilated by 0.1 to 100 m.';
    END IF;
    folding := streetgen._setting_text(model, 'match_names');
    weight := streetgen._setting_number(model, 'match_weight_name');
    least_score := streetgen._setting_number(model, 'match_least');
    PERFORM streetgen._take_matched(model, source, mapping);
    RETURN QUERY
    WITH beside AS MATERIALIZED (
        SELECT a.axis_id, p.source_ref, a.name, p.name AS other,
            streetgen.common_ground(ST_Force2D(a.geom), p.geom, distance) AS shared,
            streetgen.common_ground(p.geom, ST_Force2D(a.geom), distance) * ST_Length(p.geom) / p.length AS of_row
        FROM pg_temp._match_part p JOIN axis a ON ST_DWithin(a.geom, p.geom, 2 * distance)),
    -- The ground counts that is shared of the shorter one: data sets cut streets in pieces of their own.
    pair AS (
        SELECT axis_id, source_ref, least(sum(shared), 1) AS shared,
            greatest(least(sum(shared), 1), sum(of_row)) AS ground,
            max(streetgen._name_likeness(name, other, folding, 'match_names')) AS alike
        FROM beside WHERE shared > 0 GROUP BY axis_id, source_ref),
    scored AS (
        SELECT axis_id, source_ref, shared, alike,
            coalesce((1 - weight) * ground + weight * alike, ground) AS score FROM pair)
    SELECT axis_id, source_ref, shared, alike, score FROM scored WHERE score >= least_score
        ORDER BY axis_id, score DESC, shared DESC, source_ref;
    DROP TABLE pg_temp._match_part;
END $$;
COMMENT ON FUNCTION streetgen.match_axes(name, regclass, jsonb, float8) IS
    'The lines of a table that go along the axes of a model, the best of each axis first: to move speeds, widths or '
    'names from one data set to another. mapping: geom, source_ref, name -> source column (string) or {"value": '
    'constant}, geom and source_ref being columns of that name where it is silent; SQL is never evaluated. shared: the '
    'share, 0 to 1, of the axis''s ground that the row has beside it, both dilated by distance (metres), as '
    'streetgen.common_ground has it; lines that share a source_ref count as one. alike: how alike the names are, 0 to '
    '1, as setting match_names says; NULL where one is not known. score: shared, or the share of the row where that is '
    'greater, with alike weighted by match_weight_name; what lies below match_least is left out. Any reader may call '
    'it. A bad row or mapping: 22023; a missing column: 42703; an extension that match_names asks for and that is '
    'missing: 0A000. StreetGen paper, 3.1.';
