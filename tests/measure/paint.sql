-- Whether paint lies where something says so: psql -v model=NAME -f tests/measure/paint.sql Prints model, arrows, those
-- on lanes without a turn, of these those on streets of importance 5 and 6, and those that do not come to signals;
-- lanes of streets where lane_markings is no, and the square metres painted there.
\pset format unaligned
\pset tuples_only on
\pset fieldsep ' | '
SELECT coalesce(bool_or(attname = 'lane_markings'), false) AS has_column FROM pg_attribute
    WHERE attrelid = (:'model' || '.axis')::regclass \gset
\if :has_column
CREATE TEMPORARY VIEW bare AS SELECT axis_id FROM :"model".axis WHERE lane_markings = 'no';
\else
CREATE TEMPORARY VIEW bare AS SELECT axis_id FROM :"model".axis WHERE false;
\endif
CREATE TEMPORARY VIEW signalled AS SELECT DISTINCT node_id FROM :"model".marking WHERE kind = 'stop' AND node_id IN (
    SELECT CASE WHEN v.at_start THEN e.from_node ELSE e.to_node END
    FROM :"model".edge e JOIN :"model".control_point c ON c.axis_id = e.axis_id AND c.kind = 'signals'
        AND c.abscissa BETWEEN e.start_abscissa AND e.end_abscissa CROSS JOIN (VALUES (true), (false)) v(at_start));
SELECT :'model', count(*), count(*) FILTER (WHERE l.turn IS NULL),
    count(*) FILTER (WHERE l.turn IS NULL AND u.importance IN (5, 6)),
    count(*) FILTER (WHERE l.turn IS NULL AND m.node_id NOT IN (SELECT node_id FROM signalled)),
    (SELECT count(*) FROM bare JOIN :"model".edge USING (axis_id) JOIN :"model".lane USING (edge_id)),
    (SELECT round(coalesce(sum(ST_Area(surface)), 0)) FROM (
        SELECT surface FROM bare JOIN :"model".edge USING (axis_id) JOIN :"model".lane_separator s USING (edge_id)
        UNION ALL SELECT m.surface FROM bare JOIN :"model".edge USING (axis_id)
            JOIN :"model".marking m USING (edge_id)) p)
FROM :"model".marking m JOIN :"model".lane l USING (edge_id, lane_position) JOIN :"model".edge e USING (edge_id)
    JOIN :"model".axis_used u USING (axis_id)
WHERE m.kind = 'arrow';
