-- Pedestrian crossings for SUMO: each at the node of its end of an edge, where it lies in the model.

CREATE OR REPLACE FUNCTION streetgen._sumo_crossings(subjects text[]) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE SET search_path = pg_catalog
    AS $$ SELECT streetgen._export_crossings(subjects) || $part$,
signalled AS MATERIALIZED ($part$ || CASE WHEN 'signal' = ANY (subjects) THEN $part$
    SELECT DISTINCT place_id, controller_id FROM place JOIN %1$I.controller ON controller_id = junction_id
    WHERE kind = 'signals' AND cycle > 0$part$
    ELSE 'SELECT NULL::bigint AS place_id, NULL::bigint AS controller_id WHERE false' END || $part$),
-- Crossings have the first signals of a controller.
crossed AS MATERIALIZED (
    SELECT c.*, controller_id, CASE WHEN controller_id IS NOT NULL THEN row_number() OVER (
        PARTITION BY controller_id ORDER BY edge_id, at_start) - 1 END AS number
    FROM (SELECT c.edge_id, c.at_start, c.along, c.across, c.line, p.place_id,
            array_agg(s.name ORDER BY s.name COLLATE "C") AS names
        FROM crossing c JOIN place p USING (node_id) JOIN sumo_edge s ON s.edge_id = c.edge_id AND lane_count > 0
            AND CASE WHEN s.along_axis = c.at_start THEN since = 0 ELSE until = 1 END
        GROUP BY c.edge_id, c.at_start, c.along, c.across, c.line, p.place_id) c
        LEFT JOIN signalled USING (place_id))$part$ $$;
COMMENT ON FUNCTION streetgen._sumo_crossings(text[]) IS
    'Query of the files of SUMO over a model that computes these subjects, after sumo_edge: crossed, the crossings '
    'with their place, the names of their edges, and their controller with the number of their signal from 0 where '
    'they have one.';
