-- Areas that win over what comes before them, by setting area_wins: those of roadway move kerbs.

CREATE OR REPLACE FUNCTION streetgen._checked_area_wins(model name, value text) RETURNS text
    LANGUAGE sql STABLE PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._believed_setting(model, 'area_wins', array_to_string(kinds, ','),
            kinds <@ streetgen._area_kinds(), format('Expected kinds of areas parted by commas, such as '
            'roadway,square, of %s; an empty text: none.', array_to_string(streetgen._area_kinds(), ', ')))
        FROM (SELECT ARRAY(SELECT trim(kind) FROM string_to_table(value, ',') kind) AS kinds) k $$;
COMMENT ON FUNCTION streetgen._checked_area_wins(name, text) IS
    'A value of setting area_wins, without blanks; one that names no kind of area: 22023.';

CREATE OR REPLACE FUNCTION streetgen._area_wins(model name, kind text) RETURNS boolean
    LANGUAGE sql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog
    AS $$ SELECT 'footway' = ANY (streetgen._subjects(model))
        AND kind = ANY (string_to_array(streetgen._setting_text(model, 'area_wins'), ',')) $$;
COMMENT ON FUNCTION streetgen._area_wins(name, text) IS
    'Whether areas of a kind win over what comes before them, in a model with subject footway, by setting area_wins.';

CREATE OR REPLACE FUNCTION streetgen._kerbs_by_area(axis bytea, areas bytea[]) RETURNS float8[]
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 AS 'MODULE_PATHNAME', 'streetgen_kerbs_by_area';
COMMENT ON FUNCTION streetgen._kerbs_by_area(bytea, bytea[]) IS
    'The width kerb to kerb of a roadway and the offset of its middle from its axis (LINESTRING), metres, left '
    'positive, by the areas (MULTIPOLYGON) about the axis, all EWKB: by the middle one of all places along it that lie '
    'within areas. NULL: areas do not tell. A bad geometry: 22023; NULL among the areas: 22004.';

CREATE OR REPLACE FUNCTION streetgen._area_beside(area geometry, axis geometry) RETURNS geometry
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog, public
    AS $$ SELECT ST_Multi(ST_CollectionExtract(ST_ClipByBox2D(area, Box2D(ST_Expand(axis, 32))), 3)) $$;
COMMENT ON FUNCTION streetgen._area_beside(geometry, geometry) IS
    'The part of an area in the box 32 m about an axis, beyond which no area says anything of its kerbs and surfaces: '
    'the area of a whole town costs each of its axes no more than their own streets.';

CREATE OR REPLACE FUNCTION streetgen._footway_surveyed(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'footway' THEN streetgen._fill_template(
        streetgen._part('surveyed_roadway'), jsonb_build_object(
            'areas_beside', streetgen._part('areas_beside'))) END $$;
COMMENT ON FUNCTION streetgen._footway_surveyed(jsonb) IS
    'The value of view axis_used that says the kerbs of an axis by areas of roadway.';

CREATE OR REPLACE FUNCTION streetgen._footway_area_used(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'footway' THEN streetgen._fill_template(
        streetgen._part('area_used'), jsonb_build_object(
            'areas_beside', streetgen._part('areas_beside'))) END $$;
COMMENT ON FUNCTION streetgen._footway_area_used(jsonb) IS
    'The value of view axis_used that is the areas of roadway about an axis whose kerbs they say.';

CREATE OR REPLACE FUNCTION streetgen._axes_of_street_area(model name, areas jsonb[]) RETURNS bigint[]
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE SET search_path = pg_catalog, public
    AS $$
BEGIN
    PERFORM streetgen._use_model(model);
    IF NOT streetgen._area_wins(model, 'roadway') THEN
        RETURN '{}';
    END IF;
    -- GeoJSON rounds. Its text is read once, and not for each axis.
    RETURN ARRAY(SELECT DISTINCT a.axis_id FROM unnest(areas) changed, LATERAL (
            SELECT ST_SetSRID(ST_GeomFromGeoJSON(changed ->> 'geom'), m.srid) AS geom FROM streetgen.model m
            WHERE m.name = model OFFSET 0) g, LATERAL (
            SELECT axis_id, level FROM axis a WHERE a.geom && ST_Expand(g.geom, 32.01)
                AND ST_DWithin(a.geom, g.geom, 32.01) OFFSET 0) a
        WHERE changed ->> 'kind' = 'roadway' AND (changed ->> 'level')::integer = a.level);
END $$;
COMMENT ON FUNCTION streetgen._axes_of_street_area(name, jsonb[]) IS
    'The axes beside which areas of roadway lie or lay, where these move kerbs: a run for these moves them.';
