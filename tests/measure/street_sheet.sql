-- Ten junctions and ten streets that nobody chose, of three extracts: psql -f tests/measure/street_sheet.sql
-- The first four of the Marais and three each of Sophia Antipolis and Manhattan, in order of md5(place).  Places are
-- nodes where three streets of importance 5 and better meet, one of them of 4 and better, and the middles of such edges
-- of over 60 m.  Columns: kind; model; east and north, metres.
WITH town(model, first) AS (VALUES ('marais', 4), ('sophia', 3), ('manhattan', 3)),
edge AS (
    SELECT 'marais' AS model, from_node, to_node, importance, geom FROM marais.edge
    UNION ALL SELECT 'sophia', from_node, to_node, importance, geom FROM sophia.edge
    UNION ALL SELECT 'manhattan', from_node, to_node, importance, geom FROM manhattan.edge),
arm AS (
    SELECT model, importance, ST_StartPoint(geom) AS place FROM edge
    UNION ALL SELECT model, importance, ST_EndPoint(geom) FROM edge),
place AS (
    SELECT 'junction' AS kind, model, place FROM arm WHERE importance <= 5
    GROUP BY model, place HAVING count(*) >= 3 AND min(importance) <= 4
    UNION ALL SELECT 'street', model, ST_LineInterpolatePoint(geom, 0.5) FROM edge
    WHERE importance <= 5 AND ST_Length(geom) > 60),
named AS (SELECT kind, model, round(ST_X(place)) AS east, round(ST_Y(place)) AS north FROM place)
SELECT kind, model, east, north FROM (
    SELECT *, row_number() OVER (PARTITION BY kind, model ORDER BY md5(concat_ws(' ', east, north))) AS turn
    FROM named) n
    JOIN town USING (model)
WHERE turn <= first ORDER BY kind, first DESC, model, turn;
