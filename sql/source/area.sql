-- Areas of the street, as squares, car parks and platforms, of anybody's layer by a mapping.

CREATE OR REPLACE FUNCTION streetgen._polygons_of(geom geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Multi(ST_Force2D(CASE ST_Dimension(flat) WHEN 2 THEN flat
            ELSE CASE WHEN ST_IsClosed(flat) AND ST_NPoints(flat) > 3 THEN ST_MakePolygon(flat) END END))
        FROM ST_CurveToLine(geom) flat WHERE NOT ST_IsEmpty(geom) $$;
COMMENT ON FUNCTION streetgen._polygons_of(geometry) IS
    'An area, or what a closed line goes round, as MULTIPOLYGON without heights; NULL: empty, or a line that is open.';

CREATE OR REPLACE FUNCTION streetgen._check_areas() RETURNS void
    LANGUAGE plpgsql STABLE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
DECLARE
    bad record;
BEGIN
    SELECT label, has INTO bad FROM (
        SELECT label, CASE WHEN source_ref IS NULL THEN 'no source_ref' WHEN kind IS NULL THEN 'no kind'
            WHEN kind <> ALL (streetgen._area_kinds()) THEN format('kind "%s"', kind)
            WHEN level !~ '^[-+]?\d{1,2}$' OR level::integer NOT BETWEEN -50 AND 50 THEN format('level "%s"', level)
            WHEN foot !~ '^(yes|designated|permissive|destination|private|no)$' THEN format('foot "%s"', foot)
            WHEN ST_SRID(geom) NOT IN (SELECT srid FROM spatial_ref_sys) THEN format('SRID %s', ST_SRID(geom))
            WHEN GeometryType(geom) !~ '^((MULTI|CURVE)?POLYGON|MULTISURFACE|LINESTRING|COMPOUNDCURVE)$' THEN
                format('a %s as geom', GeometryType(geom))
            WHEN NOT (ST_XMin(geom) >= -1e12 AND ST_XMax(geom) <= 1e12 AND ST_YMin(geom) >= -1e12
                AND ST_YMax(geom) <= 1e12) THEN 'a coordinate that is not finite' END AS has
        FROM pg_temp._import_area) a WHERE has IS NOT NULL LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source row % has %', bad.label, bad.has USING ERRCODE = '22023',
            HINT = format('kind is one of %s; level is an integer, -50 to 50; foot is yes, designated, permissive, '
                'destination, private, no or NULL; geom is an area with a known SRID, or one line about it; '
                'source_ref is a column of distinct values.', array_to_string(streetgen._area_kinds(), ', '));
    END IF;
    SELECT source_ref AS label INTO bad FROM pg_temp._import_area GROUP BY source_ref HAVING count(*) > 1 LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'source_ref "%" stands in more than one row', bad.label USING ERRCODE = '22023',
            HINT = 'Map source_ref to a column of distinct values.';
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._check_areas() IS
    'Raises 22023 for the first area of the import of an unknown kind, with a bad level or place or without a '
    'source_ref, and for a source_ref that comes twice.';

CREATE OR REPLACE FUNCTION streetgen._deliver_areas(model name, source text)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
DECLARE
    wins constant boolean := streetgen._area_wins(model, 'roadway');
BEGIN
    PERFORM streetgen._use_model(model), streetgen._check_areas();
    CREATE TEMPORARY TABLE _import_part ON COMMIT DROP AS SELECT a.source_ref, streetgen._transformed(
            'area ' || a.label, streetgen._polygons_of(a.geom), m.srid) AS source_geom, NULL::geometry AS cleaned,
        a.kind, coalesce(a.level::integer, 0) AS level, a.name, a.surface, a.foot
        FROM pg_temp._import_area a, streetgen.model m WHERE m.name = model;
    DROP TABLE pg_temp._import_area;
    RETURN QUERY WITH open AS (DELETE FROM pg_temp._import_part p WHERE source_geom IS NULL RETURNING kind, source_ref)
        SELECT 'area without a closed ring, left out', kind, count(*), array_agg(source_ref ORDER BY source_ref)
        FROM open GROUP BY kind ORDER BY kind;
    RETURN QUERY SELECT 'area that crosses itself, mended where it is used', kind, count(*),
        array_agg(source_ref ORDER BY source_ref) FROM pg_temp._import_part WHERE NOT ST_IsValid(source_geom)
        GROUP BY kind ORDER BY kind;
    RETURN QUERY SELECT CASE WHEN unused THEN 'areas of which nothing is made: roadway follows the axes'
            ELSE 'areas' END, kind, count(*), CASE WHEN unused THEN array_agg(source_ref ORDER BY source_ref) END
        FROM pg_temp._import_part, LATERAL (SELECT kind = 'roadway' AND NOT wins AS unused) u
        GROUP BY kind, unused ORDER BY kind;
    RETURN QUERY SELECT * FROM streetgen._deliver_if_any(model, 'street_area', source);
    IF wins THEN
        RETURN QUERY SELECT 'streets with the kerbs of areas', a.kind, count(*), NULL::text[]
            FROM axis_used u JOIN axis a USING (axis_id) WHERE u.by_area GROUP BY a.kind ORDER BY a.kind;
    END IF;
END $$;
COMMENT ON FUNCTION streetgen._deliver_areas(name, text) IS
    'Brings the areas of a source up to date with those that were read; reports them, what is by hand, and where areas '
    'move kerbs how many streets have theirs.';

CREATE OR REPLACE FUNCTION streetgen.import_areas(model name, source regclass, mapping jsonb)
    RETURNS TABLE(what text, class text, count bigint, source_refs text[])
    LANGUAGE plpgsql VOLATILE PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._require_owner(model), streetgen._check_given('source', source::text, 'mapping', mapping::text);
    PERFORM streetgen._pause(), streetgen._take_points('_import_area', streetgen._point_query('street_area',
        '{geom,kind,level,name,surface,foot,source_ref}', '{geom,kind}', source, mapping));
    RETURN QUERY SELECT * FROM streetgen._deliver_areas(model, source::text);
END $$;
COMMENT ON FUNCTION streetgen.import_areas(name, regclass, jsonb) IS
    'Imports a table of areas, such as squares, car parks and platforms. mapping: geom, kind, level, name, surface, '
    'foot, source_ref -> source column (string) or {"value": constant}; SQL is never evaluated. kind: roadway, cycle, '
    'sidewalk, walk, steps, square, parking_area or platform; geom: areas, or closed lines about them. Importing again '
    'follows the source; what is by hand stays as setting delivery_wins says. Reports counts by kind, areas that cross '
    'themselves, and rings that are open. A missing column: 42703; a bad row or mapping: 22023; then the model stays '
    'as it was. Needs the rights of the owner (42501).';
