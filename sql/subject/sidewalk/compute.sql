-- The one statement, sidewalks: behind the kerbs that moved, and behind those that these come near.

CREATE OR REPLACE FUNCTION streetgen._sidewalk_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (35, 'sidewalk', 'sidewalk', 'sidewalk_id', 'edge_id, side, part', 'sidewalk', 1) $$;
COMMENT ON FUNCTION streetgen._sidewalk_computed_table() IS 'The computed table of sidewalks.';

CREATE OR REPLACE FUNCTION streetgen._sidewalks(kerbs bytea[], levels integer[], widths float8[], across boolean[],
    ends boolean[], by_hand boolean[], wanted boolean[], course_kerbs integer[], course_shares float8[],
    course_widths float8[], transition float8, srid integer)
    RETURNS TABLE(number integer, width float8, surface geometry, method text)
    LANGUAGE c IMMUTABLE PARALLEL SAFE COST 10000 ROWS 1000 AS 'MODULE_PATHNAME', 'streetgen_sidewalks';
COMMENT ON FUNCTION streetgen._sidewalks(bytea[], integer[], float8[], boolean[], boolean[], boolean[], boolean[],
    integer[], float8[], float8[], float8, integer) IS
    'The sidewalks (MULTIPOLYGON) behind the kerbs (LINESTRING, EWKB) that are wanted, by their numbers from 1. '
    'widths: metres, 0 for none, NULL for a kerb that leads from the width before it to that after it. across: of a '
    'dead end, or beside no city: there a sidewalk leads on where both sides have one. ends: the '
    'roadway goes on there. course_: where the width changes along kerbs that have one, the numbers of these, the '
    'shares of their length, ascending, and the widths. transition: metres of kerb that a change of width takes. '
    'Lists of different length: 2202E. NULL lists: no row.';

CREATE OR REPLACE FUNCTION streetgen._sidewalk_places(places jsonb) RETURNS jsonb
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT jsonb_build_object('sidewalks_by_hand',
        streetgen._fill_template(streetgen._part('sidewalks_by_hand'), places)) $$;
COMMENT ON FUNCTION streetgen._sidewalk_places(jsonb) IS
    'The place of the one statement where edges get the widths of sidewalks by hand.';

-- What is known of the kerbs of a query with the columns of table kerb and `wanted`, as the core asks for it.
CREATE OR REPLACE FUNCTION streetgen._sidewalk_kerbs(kerbs text, edges text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('sidewalk_kerbs'), jsonb_build_object('kerbs', kerbs,
        'edges', edges, 'model', '{model}')) $$;
COMMENT ON FUNCTION streetgen._sidewalk_kerbs(text, text) IS
    'A query of kerbs with the widths of their sidewalks, from queries of kerbs and of their edges.';

-- Along kerbs without a width of their own a width leads from one to the other, however many there are. What is found
-- goes on as an array: no row count that the planner guesses grows from look to look.
CREATE OR REPLACE FUNCTION streetgen._kerbs_near(name text, places text, known text) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('kerbs_near'), jsonb_build_object('name', name,
        'places', places, 'known', known, 'model', '{model}')) $$;
COMMENT ON FUNCTION streetgen._kerbs_near(text, text, text) IS
    'A query of the kerbs of a model before a run that lie as near to places (a query of geom) as two sidewalks reach, '
    'and of those that these lead on to, but for those known before (an array): kerbs, and known with them. Their '
    'rows have its name with _row.';

-- The kerbs of an edit.
CREATE OR REPLACE FUNCTION streetgen._sidewalk_kerbs_of_part(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('sidewalk_kerbs_of_part') || concat_ws(',',
    streetgen._kerbs_near('near_kerb', 'SELECT geom FROM moved_kerb', 'ARRAY(SELECT kerb_id FROM former_kerb)'),
    streetgen._kerbs_near('rival_kerb', 'SELECT geom FROM near_kerb_row', '(SELECT known FROM near_kerb)'),
    -- The ground of a rival depends on the strips beside it. Each such strip depends on the kerbs about it.
    streetgen._kerbs_near('beside_kerb', 'SELECT geom FROM rival_kerb_row', '(SELECT known FROM rival_kerb)'),
    streetgen._kerbs_near('outer_kerb', 'SELECT geom FROM beside_kerb_row', '(SELECT known FROM beside_kerb)'))
    || streetgen._part('standing_kerb') || streetgen._sidewalk_kerbs('SELECT * FROM standing_kerb',
        streetgen._part('standing_edges'))
    || ')', places) $$;
COMMENT ON FUNCTION streetgen._sidewalk_kerbs_of_part(jsonb) IS
    'Part of the one statement in a run for some axes: sidewalk_kerb, the kerbs near what the run moved; wanted: their '
    'sidewalks may be others.';

CREATE OR REPLACE FUNCTION streetgen._upsert_sidewalk(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', CASE places ->> 'run' WHEN 'part' THEN streetgen._sidewalk_kerbs_of_part(places)
        ELSE streetgen._fill_template(E'\nsidewalk_kerb AS MATERIALIZED (' || streetgen._sidewalk_kerbs(
            'SELECT edge_id, node_id, level, side, part, geom, method, beside, true AS wanted FROM new_kerb',
            'SELECT edge_id, axis_id, geom, start_abscissa, end_abscissa, sidewalk_left, sidewalk_right, '
                'estimated FROM new_edge')
            || ')', places) END,
    streetgen._upsert_rows(places, 'sidewalk',
        columns => 'edge_id, node_id, side, part, width, surface, method, strip',
        rows => streetgen._fill_template(streetgen._part('sidewalk_rows'), places
            || streetgen._sidewalk_holes((places ->> 'model') || '.', ARRAY(SELECT jsonb_array_elements_text(
                places -> 'subjects')), places ->> 'run' = 'part')),
        there => CASE places ->> 'run' WHEN 'part' THEN $part$
        SELECT s.sidewalk_id FROM (SELECT edge_id, side, part FROM former_kerb
                UNION SELECT edge_id, side, part FROM sidewalk_kerb WHERE wanted) k,
            LATERAL (SELECT sidewalk_id FROM {model}.sidewalk s
                WHERE (s.edge_id, s.side, s.part) = (k.edge_id, k.side, k.part) OFFSET 0) s$part$
            ELSE 'SELECT sidewalk_id FROM {model}.sidewalk' END)) $$;
COMMENT ON FUNCTION streetgen._upsert_sidewalk(jsonb) IS
    'Part of the one statement: sidewalks behind new_kerb, and behind kerbs near those that moved.';
