-- The one statement, heights along edges.

CREATE OR REPLACE FUNCTION streetgen._height_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (56, 'profile', 'height', 'edge_id', NULL, 'edge', 1) $$;
COMMENT ON FUNCTION streetgen._height_computed_table() IS 'The computed table of heights.';

CREATE OR REPLACE FUNCTION streetgen._upsert_height(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('height'),
        places),
    streetgen._upsert_rows(places, 'profile', columns => 'geom, grade_max, method, tied_from, tied_to', rows => $part$
        SELECT row_number() OVER (ORDER BY edge_id)::integer AS number, edge_id, line::geometry AS geom, grade_max,
            method, tied_from, tied_to
        FROM $part$ || CASE WHEN places ->> 'run' IN ('whole', 'empty') THEN $part$
            setting, streetgen._solved_profile((SELECT list FROM profile_edges), (SELECT list FROM profile_lifts),
                (SELECT list FROM profile_heights), (v ->> 'bridge_level_length')::float8, (v ->> 'plateau')::float8,
                {srid})$part$
        ELSE $part$
            streetgen._renewed_profile('{model_name}', (SELECT list FROM profile_edges),
                (SELECT list FROM profile_lifts), (SELECT list FROM profile_heights),
                (SELECT list FROM profile_gone), ARRAY(SELECT axis_id FROM written_axis))$part$ END)) $$;
COMMENT ON FUNCTION streetgen._upsert_height(jsonb) IS
    'Part of the one statement: the heights along new_edge, and along all edges that these lift or no longer lift.';
