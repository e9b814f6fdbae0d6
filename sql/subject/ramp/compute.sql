-- The one statement, ramps: axes that may be part of one go into the core, which tells ramps and their merging lanes.

CREATE OR REPLACE FUNCTION streetgen._ramp_computed_table()
    RETURNS TABLE(place integer, relation name, subject text, key text, identity text, gone_with name,
        gone_each integer)
    LANGUAGE sql IMMUTABLE PARALLEL SAFE ROWS 1 SET search_path = pg_catalog
    AS $$ VALUES
    (12, 'ramp', 'ramp', 'ramp_id', 'node_id', 'ramp', 1) $$;
COMMENT ON FUNCTION streetgen._ramp_computed_table() IS 'The computed table of ramps.';

CREATE OR REPLACE FUNCTION streetgen._computed_ramp(streets bigint, nodes bigint[], edges bigint[])
    RETURNS TABLE(number integer, node_id bigint, edge_id bigint, edge_before bigint, edge_after bigint, kind text,
        side text, lanes_before integer, lanes_ramp integer, lanes_after integer, lanes_missing integer,
        lanes_merging integer, length float8, taper float8, tangent float8, auxiliary boolean, cut boolean,
        short_link boolean, geom geometry, method text)
    LANGUAGE c VOLATILE STRICT PARALLEL UNSAFE COST 1000 ROWS 20 AS 'MODULE_PATHNAME', 'streetgen_computed_ramp';
COMMENT ON FUNCTION streetgen._computed_ramp(bigint, bigint[], bigint[]) IS
    'The ramps of streets computed in this statement; columns as of table ramp.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ramp_axis(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template(streetgen._part('ramp_axis'), places) $$;
COMMENT ON FUNCTION streetgen._upsert_ramp_axis(jsonb) IS
    'Part of the one statement: the axes used that may be part of a ramp, as an array of street_ramp_axis.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ramp_override(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._fill_template($part$(
            SELECT array_agg(ROW (axis_id, abscissa, tangent, length)::streetgen.street_ramp ORDER BY ramp_override_id)
            FROM {model}.ramp_override WHERE {whole} OR axis_id = ANY ($2))$part$, places) $$;
COMMENT ON FUNCTION streetgen._upsert_ramp_override(jsonb) IS
    'Part of the one statement: what is decided by hand about ramps, as an array of street_ramp.';

CREATE OR REPLACE FUNCTION streetgen._upsert_ramp(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT concat_ws(',', streetgen._fill_template(streetgen._part('ramp'), places),
    streetgen._upsert_rows(places, 'ramp',
        columns => 'node_id, edge_id, edge_before, edge_after, kind, side, lanes_before, lanes_ramp, lanes_after, '
            'lanes_missing, lanes_merging, length, taper, tangent, auxiliary, cut, short_link, geom, method',
        rows => $part$
        SELECT * FROM streetgen._computed_ramp((SELECT streets FROM computed), (SELECT ids FROM node_ids),
            (SELECT ids FROM ramp_edge_ids))$part$,
        there => $part$
        SELECT r.ramp_id FROM new_node n, LATERAL (SELECT ramp_id FROM {model}.ramp r
            WHERE r.node_id = n.node_id {by_key}) r WHERE n.affected AND NOT n.fresh$part$, read => true)) $$;
COMMENT ON FUNCTION streetgen._upsert_ramp(jsonb) IS 'Part of the one statement: ramps at new_node.';

CREATE OR REPLACE FUNCTION streetgen._ramp_arguments(places jsonb) RETURNS text
    LANGUAGE sql STABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ 
    SELECT CASE WHEN places -> 'subjects' ? 'ramp' THEN concat_ws(', ', 'ramp_axes => '
        || streetgen._upsert_ramp_axis(places), 'ramps => ' || streetgen._upsert_ramp_override(places))
        ELSE 'ramp_axes => NULL, ramps => NULL' END $$;
COMMENT ON FUNCTION streetgen._ramp_arguments(jsonb) IS
    'Part of the one statement: what the core gets of ramps.';

CREATE OR REPLACE FUNCTION streetgen._ramp_there(places jsonb) RETURNS text
    LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT CASE WHEN places -> 'subjects' ? 'ramp' THEN streetgen._fill_template($part$
new_ramp AS MATERIALIZED (SELECT * FROM {model}.ramp)$part$, places) END $$;
COMMENT ON FUNCTION streetgen._ramp_there(jsonb) IS
    'Part of the statement that ends a first run by clusters: new_ramp, the ramps that are there; NULL in a model '
    'without.';
