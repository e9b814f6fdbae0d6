-- argument radius: radius of the axis' own, metres; NULL: none
-- argument radius_by_importance: metres by importance, as setting radius_by_importance; empty: turning_radius
-- argument mode: law of turning_radius: paper or setra
-- argument minimal: the least radius that turning_radius gives, metres
-- argument maximal: the greatest radius that turning_radius gives, metres
-- see turning_radius
SELECT streetgen.wanted_radius(NULL, 3, 50, 7, '{"1": 8, "2": 6.25, "4": 3}', 'paper') AS by_importance,
    round(streetgen.wanted_radius(NULL, 3, 50, 7, '', 'paper')::numeric, 2) AS by_speed_and_width;
