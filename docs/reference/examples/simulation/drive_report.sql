-- argument samples: table or view of the log
-- argument mapping: object of column names
-- see drive_summary, simulate
SELECT t, round(lane_offset::numeric, 2) AS lane_offset, round(speed) AS speed, leader, round(gap) AS gap,
    round(time_to_collision::numeric, 1) AS time_to_collision
FROM streetgen.drive_report('town', 'drive_log') WHERE actor = 'driver';
-- drawing
SELECT surface, 'section', NULL FROM town.roadway
    UNION ALL SELECT ST_Buffer(geom, 1.5), 'result', coalesce(round(gap) || ' m', '')
        FROM streetgen.drive_report('town', 'drive_log')
