-- argument line: LINESTRING in metres
-- argument other: LINESTRING in metres
-- argument distance: metres by which both are dilated
-- see match_axes
SELECT round(streetgen.common_ground('LINESTRING(0 0, 40 0)', 'LINESTRING(60 4, 10 4)')::numeric, 2) AS beside,
    round(streetgen.common_ground('LINESTRING(0 0, 40 0)', 'LINESTRING(20 -30, 20 30)')::numeric, 2) AS across;
