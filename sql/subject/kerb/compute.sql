-- The one statement, kerbs: the border of what is affected, and of what lies beside ground that changed.

CREATE OR REPLACE FUNCTION streetgen._kerb_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (11, 'kerb', 'kerb', 'kerb_id', 'edge_id, side, part', 'kerb', 1) $$;
COMMENT ON FUNCTION streetgen._kerb_computed_table() IS 'The computed table of kerbs.';

CREATE OR REPLACE FUNCTION streetgen._computed_kerb(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, edge_id bigint, node_id bigint, level integer, side text, part integer, geom geometry,
        curve geometry, surface geometry, method text, beside text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_kerb';
COMMENT ON FUNCTION streetgen._computed_kerb(bigint, bigint[], bigint[]) IS
    'The kerbs of streets computed in this statement: of sections, where node_id is NULL, and of intersections.';

CREATE OR REPLACE FUNCTION streetgen._upsert_neighbour(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('neighbour'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_neighbour(jsonb) IS
    'Part of the one statement: the surfaces near what is written that stay, as an array of street_neighbour.';

CREATE OR REPLACE FUNCTION streetgen._upsert_kerb(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('kerb'), places),
    streetgen._upsert_rows(places, 'kerb',
        columns => 'edge_id, node_id, level, side, part, geom, curve, surface, method, beside',
        read => places -> 'subjects' ? 'sidewalk', rows => $part$
        SELECT number, edge_id, node_id, level, side, part, geom, curve, surface, method, beside
        FROM streetgen._computed_kerb((SELECT streets FROM computed), (SELECT ids FROM node_ids),
            (SELECT ids FROM kerb_edge_ids))$part$,
        there => streetgen._part('kerb_there'))) $$;
COMMENT ON FUNCTION streetgen._upsert_kerb(jsonb) IS 'Part of the one statement: kerbs at new_edge and new_node.';

CREATE OR REPLACE FUNCTION streetgen._kerb_arguments(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ 
    -- A first run has no neighbours yet, a whole one none.
    SELECT 'neighbours => ' || CASE WHEN places -> 'subjects' ? 'kerb' AND places ->> 'run' = 'part'
        THEN streetgen._upsert_neighbour(places) ELSE 'NULL' END $$;
COMMENT ON FUNCTION streetgen._kerb_arguments(jsonb) IS
    'Part of the one statement: what the core gets of kerbs: surfaces near what is written that stay.';

CREATE OR REPLACE FUNCTION streetgen._kerb_there(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'kerb' THEN streetgen._fill_template(
        E'\nnew_kerb AS MATERIALIZED (SELECT * FROM {model}.kerb)', places) END $$;
COMMENT ON FUNCTION streetgen._kerb_there(jsonb) IS
    'Part of the statement that ends a first run by clusters: new_kerb, the kerbs there; NULL in a model without.';
