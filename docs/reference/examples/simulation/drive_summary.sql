-- argument samples: table or view of the log
-- argument mapping: object of column names
-- argument stretch: metres along an axis
-- argument names: streets
-- see drive_report
SELECT actor, name, sample_count, seconds, round(mean_speed::numeric, 1) AS mean_speed, round(least_gap) AS least_gap
FROM streetgen.drive_summary('town', 'drive_log');
