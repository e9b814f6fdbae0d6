-- The one statement, footways: those along the kerbs of written edges, and what sidewalks get of them.

CREATE OR REPLACE FUNCTION streetgen._footway_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (36, 'sidewalk_source', 'footway', 'sidewalk_source_id', 'edge_id, side, part', 'sidewalk_source', 1) $$;
COMMENT ON FUNCTION streetgen._footway_computed_table() IS 'The computed table of footways.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_sources(edges bytea[], edge_levels integer[], footways bytea[],
    footway_levels integer[], side_edges integer[], lefts boolean[], kerbs_at_start float8[], kerbs_at_end float8[],
    reach float8)
    RETURNS TABLE(side integer, footway integer, start_abscissa float8, end_abscissa float8, distance float8,
        places float8[], distances float8[])
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 100 AS 'MODULE_PATHNAME', 'streetgen_sidewalk_sources';
COMMENT ON FUNCTION streetgen._sidewalk_sources(bytea[], integer[], bytea[], integer[], integer[], boolean[],
    float8[], float8[], float8) IS
    'The stretches of sides of edges along which footways run, no farther from the kerb than the reach, metres. '
    'edges, footways: LINESTRING, EWKB. side_edges: the number of the edge of each side, from 1; lefts: is it on the '
    'left; kerbs_at_start, kerbs_at_end: from the edge to the kerb, metres. Numbers count from 1; abscissas along the '
    'edge, metres; distance: from the kerb, the median, metres. places, distances: the abscissas between which the '
    'footway runs straight, within 0.5 m, and its distances there; empty where it keeps its distance. Lists of '
    'different length: 2202E; NULL in one: 22004; bad geometry or number: 22023.';

CREATE OR REPLACE FUNCTION streetgen._mapped_width(distance float8, stated float8, minimal float8, maximal float8)
    RETURNS float8
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN CASE WHEN stated IS NULL THEN greatest(minimal, least(maximal, 2 * distance), distance + minimal / 2)
        -- One that lies beyond its own width has ground before it that leads to it.
        WHEN distance > stated THEN distance + stated / 2 ELSE stated END;
COMMENT ON FUNCTION streetgen._mapped_width(float8, float8, float8, float8) IS
    'The width of a sidewalk that a footway maps, metres, from its distance to the kerb, its own width (NULL: unknown) '
    'and settings mapped_sidewalk_minimal and _maximal.';

CREATE OR REPLACE FUNCTION streetgen._footway_places(places jsonb) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'footway'
        THEN jsonb_build_object('sidewalks_mapped', 'LEFT JOIN mapped_sidewalk p ON p.mapped_number = e.number '
                'LEFT JOIN beside_track track ON track_number = e.number',
            'mapped_left', 'p.mapped_left', 'mapped_right', 'p.mapped_right',
            'usual_left', streetgen._fill_template(streetgen._part('sidewalk_before_track'), '{"side": "left"}'),
            'usual_right', streetgen._fill_template(streetgen._part('sidewalk_before_track'), '{"side": "right"}'),
            'sidewalk_course', streetgen._fill_template(streetgen._part('sidewalk_course'),
                places || jsonb_build_object('sources', streetgen._fill_template(streetgen._part(
                    CASE places ->> 'run' WHEN 'part' THEN 'standing_sources' ELSE 'new_sources' END), places))),
            'widest_course', format(', (SELECT max(widest) FROM %s.sidewalk_source), (SELECT max(widest) '
                'FROM found_source)', places ->> 'model'))
        ELSE jsonb_build_object('sidewalks_mapped', '', 'mapped_left', 'NULL::float8', 'mapped_right', 'NULL::float8',
            'usual_left', 'u.sidewalk_left', 'usual_right', 'u.sidewalk_right',
            'sidewalk_course', 'SELECT ARRAY[]::integer[] AS course_kerbs, ARRAY[]::float8[] AS shares, '
                'ARRAY[]::float8[] AS course_widths', 'widest_course', '') END $$;
COMMENT ON FUNCTION streetgen._footway_places(jsonb) IS
    'The places of the one statement where edges get the widths of sidewalks that footways map, and kerbs the courses '
    'of these widths.';

CREATE OR REPLACE FUNCTION streetgen._footway_kerbs_beside(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'footway' THEN streetgen._part('kerbs_beside') END $$;
COMMENT ON FUNCTION streetgen._footway_kerbs_beside(jsonb) IS
    'The expression of view axis_used that says how far the kerbs of an axis lie from it at most, left and right, '
    'where sidewalks are mapped beside it.';

CREATE OR REPLACE FUNCTION streetgen._upsert_footway(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('mapped_sidewalk'), places
            || jsonb_build_object('footways', streetgen._fill_template(streetgen._part(CASE WHEN places ->> 'run'
                IN ('whole', 'empty') THEN 'all_footways' ELSE 'footways_near' END), places),
                'bays_stand', streetgen._bays_stand(ARRAY(
                    SELECT jsonb_array_elements_text(places -> 'subjects')), (places ->> 'model') || '.'))),
        streetgen._upsert_rows(places, 'sidewalk_source',
            columns => 'edge_id, side, part, footway_id, start_abscissa, end_abscissa, distance, width, places, '
                'widths, widest',
            rows => streetgen._part('sidewalk_source_rows'), there => $part$
            SELECT s.sidewalk_source_id FROM new_edge e, LATERAL (SELECT sidewalk_source_id FROM
                {model}.sidewalk_source s WHERE s.edge_id = e.edge_id {by_key}) s WHERE NOT e.fresh$part$)) $$;
COMMENT ON FUNCTION streetgen._upsert_footway(jsonb) IS
    'Part of the one statement: the footways along new_edge, and mapped_sidewalk, the widths that they give its sides.';

CREATE OR REPLACE FUNCTION streetgen._footway_told_others(model name, computed text[]) RETURNS boolean
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT true $$;
COMMENT ON FUNCTION streetgen._footway_told_others(name, text[]) IS
    'Sidewalks of a model were computed from its footways before these were switched off: it is computed anew.';
