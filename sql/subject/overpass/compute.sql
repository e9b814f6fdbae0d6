-- The one statement, overpasses: those of every written edge. Axes that cross one of these are gathered with it.

CREATE OR REPLACE FUNCTION streetgen._overpass_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (55, 'overpass', 'overpass', 'overpass_id', 'edge_above, edge_below, ordinality', 'overpass', 1) $$;
COMMENT ON FUNCTION streetgen._overpass_computed_table() IS 'The computed table of overpasses.';

CREATE OR REPLACE FUNCTION streetgen._computed_overpass(streets bigint, edges bigint[])
    RETURNS TABLE(number integer, edge_above bigint, abscissa_above float8, edge_below bigint, abscissa_below float8,
        geom geometry, clearance float8, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 200 AS 'MODULE_PATHNAME', 'streetgen_computed_overpass';
COMMENT ON FUNCTION streetgen._computed_overpass(bigint, bigint[]) IS
    'The overpasses of streets computed in this statement; abscissas along the edge, m.';

CREATE OR REPLACE FUNCTION streetgen._upsert_overpass_override(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$(
            SELECT array_agg(ROW (axis_above, axis_below, ST_X(geom), ST_Y(geom),
                clearance)::streetgen.street_overpass ORDER BY overpass_override_id)
            FROM {model}.overpass_override WHERE {whole} OR axis_above = ANY ($2))$part$, places) $$;
COMMENT ON FUNCTION streetgen._upsert_overpass_override(jsonb) IS
    'Part of the one statement: what is decided by hand about overpasses, as an array of street_overpass.';

CREATE OR REPLACE FUNCTION streetgen._upsert_overpass(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('overpass'), places),
    streetgen._upsert_rows(places, 'overpass',
        columns => 'edge_above, abscissa_above, edge_below, abscissa_below, ordinality, geom, clearance, method',
        rows => $part$
        SELECT number, edge_above, abscissa_above, edge_below, abscissa_below,
            row_number() OVER (PARTITION BY edge_above, edge_below ORDER BY number)::integer AS ordinality,
            geom, clearance, method
        FROM found_overpass$part$,
        there => $part$
        SELECT o.overpass_id FROM new_edge e, LATERAL (SELECT overpass_id FROM {model}.overpass o
            WHERE o.edge_above = e.edge_id {by_key}) o WHERE NOT e.fresh
        UNION SELECT o.overpass_id FROM new_edge e, LATERAL (SELECT overpass_id FROM {model}.overpass o
            WHERE o.edge_below = e.edge_id {by_key}) o WHERE NOT e.fresh$part$)) $$;
COMMENT ON FUNCTION streetgen._upsert_overpass(jsonb) IS 'Part of the one statement: overpasses at new_edge.';

CREATE OR REPLACE FUNCTION streetgen._overpass_arguments(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ 
    SELECT 'overpasses => ' || CASE WHEN places -> 'subjects' ? 'overpass'
        THEN streetgen._upsert_overpass_override(places) ELSE 'NULL' END $$;
COMMENT ON FUNCTION streetgen._overpass_arguments(jsonb) IS
    'Part of the one statement: what the core gets of overpasses.';

CREATE OR REPLACE FUNCTION streetgen._overpass_there(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'overpass' THEN streetgen._fill_template($part$
found_overpass AS MATERIALIZED (
    SELECT o.*, e.level < 0 AS sinks FROM {model}.overpass o JOIN {model}.edge e ON e.edge_id = o.edge_below)$part$,
        places) END $$;
COMMENT ON FUNCTION streetgen._overpass_there(jsonb) IS
    'Part of the statement that ends a first run by clusters: found_overpass, the overpasses that are there; NULL in '
    'a model without.';
