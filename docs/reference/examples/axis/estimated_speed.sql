-- argument speed_by_importance: km/h by importance, as setting speed_by_importance
-- argument speed_per_width: km/h for each metre of width, where the importance is NULL
-- see wanted_radius
SELECT streetgen.estimated_speed(3, 7, '{"1": 90, "3": 50}', 6) AS by_importance, streetgen.estimated_speed(NULL, 7, '{"1": 90, "3": 50}', 6) AS by_width;
