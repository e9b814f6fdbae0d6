-- Crossings of rules beside others of the same street: psql -v model=NAME -f tests/measure/objects/crossed_twice.sql
-- Columns: model; crossings of rules; those with one that others placed within 20 m along the same edge.
SELECT :'model' AS model, count(*) AS by_rule, count(*) FILTER (WHERE EXISTS (
    SELECT FROM :"model".street_object other JOIN :"model".object_edge USING (street_object_id)
    WHERE other.type = 'crossing' AND other.placed_by <> 'rule' AND object_edge.edge_id = e.edge_id
        AND abs(other.abscissa - o.abscissa) < 20)) AS twice
FROM :"model".street_object o JOIN :"model".object_edge e USING (street_object_id)
WHERE o.type = 'crossing' AND o.placed_by = 'rule';
