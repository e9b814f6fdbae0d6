-- Parts of the one statement and of those that follow it, by name: streetgen._part gives each.

--{overpass
-- An edge that crosses a written one may be of an axis that is not written: as it is there.
crossing_edge AS MATERIALIZED (
    SELECT number, edge_id FROM new_edge
    UNION ALL SELECT c.number, e.edge_id
    FROM computed_edge c, LATERAL (SELECT edge_id FROM {model}.edge e
        WHERE (e.axis_id, e.start_abscissa, e.end_abscissa) = (c.axis_id, c.start_abscissa, c.end_abscissa) {by_key}) e
    WHERE NOT {whole} AND c.number NOT IN (SELECT number FROM written_edge)),
crossing_edge_ids AS MATERIALIZED (SELECT streetgen._ids(number, edge_id) AS ids FROM crossing_edge),
found_overpass AS MATERIALIZED (
    SELECT o.*, b.level < 0 AS sinks
    FROM streetgen._computed_overpass((SELECT streets FROM computed), (SELECT ids FROM crossing_edge_ids)) o
        JOIN crossing_edge c ON c.edge_id = o.edge_below JOIN computed_edge b ON b.number = c.number
    WHERE {whole} OR o.edge_above IN (SELECT edge_id FROM new_edge)
        OR o.edge_below IN (SELECT edge_id FROM new_edge))
