-- The one statement, interconnections: pairs of lanes as computed or as decided by hand.

CREATE OR REPLACE FUNCTION streetgen._interconnection_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (10, 'interconnection', 'interconnection', 'interconnection_id', 'lane_in, lane_out, along_in, along_out',
        'interconnection', 1) $$;
COMMENT ON FUNCTION streetgen._interconnection_computed_table() IS 'The computed table of paths from lane to lane.';

CREATE OR REPLACE FUNCTION streetgen._computed_interconnection(streets bigint, nodes bigint[], lanes bigint[])
    RETURNS TABLE(number integer, node_id bigint, lane_in bigint, lane_out bigint, along_in boolean, along_out boolean,
        turn text, angle float8,
        plausible boolean, reason text, traffic text, control geometry, geom geometry)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME',
        'streetgen_computed_interconnection';
COMMENT ON FUNCTION streetgen._computed_interconnection(bigint, bigint[], bigint[]) IS
    'The pairs of lanes of streets computed in this statement, and the paths between them.';

CREATE OR REPLACE FUNCTION streetgen._upsert_interconnection(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('interconnection'), places),
    streetgen._upsert_rows(places, 'interconnection',
        columns => 'node_id, lane_in, lane_out, along_in, along_out, turn, angle, plausible, reason, traffic, '
            'connecting, control, geom, method', rows => streetgen._part('interconnection_rows'),
        there => 'SELECT interconnection_id FROM left_interconnection'),
    streetgen._fill_template(streetgen._part('left_interconnection'), places)) $$;
COMMENT ON FUNCTION streetgen._upsert_interconnection(jsonb) IS
    'Part of the one statement: the interconnections of new_lane, with what interconnection_override decides.';

CREATE OR REPLACE FUNCTION streetgen._interconnection_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$restrictions => (
            SELECT array_agg(ROW (from_axis, to_axis, ST_X(geom), ST_Y(geom), kind, turn,
                except_kinds)::streetgen.street_restriction ORDER BY turn_restriction_id)
            FROM {model}.turn_restriction WHERE via_axes IS NULL AND ({whole} OR from_axis = ANY ($2)))$part$,
        places) $$;
COMMENT ON FUNCTION streetgen._interconnection_arguments(jsonb) IS
    'Part of the one statement: what the core gets of interconnections.';
