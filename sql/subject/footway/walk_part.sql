-- The parts of the network on foot, and what of it nothing joins to the largest one.

CREATE OR REPLACE FUNCTION streetgen._walk_parts(from_nodes bigint[], to_nodes bigint[])
    RETURNS TABLE(number integer, part integer)
    LANGUAGE c IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 50000 AS 'MODULE_PATHNAME', 'streetgen_walk_parts';
COMMENT ON FUNCTION streetgen._walk_parts(bigint[], bigint[]) IS
    'The part of a network that each link belongs to, named by the number of its first link; links by their nodes, '
    'numbered from 1. Lists of different length: 2202E; NULL in one: 22004.';

CREATE OR REPLACE FUNCTION streetgen._walks_apart(model name) RETURNS SETOF streetgen.finding
    LANGUAGE plpgsql STABLE STRICT PARALLEL UNSAFE ROWS 10 SET jit = off SET search_path = pg_catalog, public
    AS $$
#variable_conflict use_column
BEGIN
    PERFORM streetgen._use_model(model);
    RETURN QUERY WITH link AS MATERIALIZED (
        SELECT row_number() OVER (ORDER BY walk_link_id) AS number, l.* FROM walk_link l),
    in_part AS MATERIALIZED (
        SELECT p.part, l.*, sum(metres) OVER (PARTITION BY part) AS part_metres
        FROM streetgen._walk_parts(ARRAY(SELECT from_node FROM link ORDER BY number),
            ARRAY(SELECT to_node FROM link ORDER BY number)) p JOIN link l USING (number)),
    largest AS MATERIALIZED (SELECT part FROM in_part ORDER BY part_metres DESC, part LIMIT 1)
    SELECT 'notice', 'walks that nothing joins to the others, m', 'walk_link', min(walk_link_id), min(part_metres),
        ST_Collect(geom ORDER BY walk_link_id)
    FROM in_part WHERE part <> (SELECT part FROM largest) GROUP BY part
    UNION ALL SELECT 'notice', 'sidewalk that nobody reaches on foot, m', 'edge', edge_id, sum(metres),
        ST_Collect(geom ORDER BY walk_link_id)
    FROM in_part WHERE part <> (SELECT part FROM largest) AND side IN ('left', 'right') GROUP BY edge_id, side;
END $$;
COMMENT ON FUNCTION streetgen._walks_apart(name) IS
    'Rows of streetgen.check_model: the parts of the network on foot but the largest, and the sides of streets there.';
